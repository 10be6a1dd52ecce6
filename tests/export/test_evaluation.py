"""The parts of evaluation: what is scored, what it costs, and what each method does."""

import numpy as np
import pytest
import torch

from deciwatch import checkpoint, manifest
from deciwatch.errors import UserError
from deciwatch.evaluation import calibration
from deciwatch.evaluation.classical import every_frame, interpolated
from deciwatch.evaluation.costs import Cost, estimator_flops
from deciwatch.evaluation.counted_nets import (
    from_checkpoint,
    from_models,
    without_denoise,
    without_recover,
)
from deciwatch.evaluation.one_euro import one_euro
from deciwatch.evaluation.pair_file import from_arrays
from deciwatch.evaluation.plan import make_plan
from deciwatch.evaluation.recovered import recovered
from deciwatch.evaluation.run_methods import run_method, scored_frames
from deciwatch.evaluation.scoring import GROUPS, score
from deciwatch.flops import evaluate
from deciwatch.nets.smoothnet import WINDOW, SmoothNet, smooth_values
from deciwatch.normalise import Samples
from deciwatch.paths import FIXTURES, MODELS
from deciwatch.runner import recover_window
from deciwatch.skeleton import mid_hip
from made_up_pairs import LENGTHS, pair_arrays

SMALL = FIXTURES / "models"


def pair_file(**changes):
    return from_arrays(pair_arrays() | changes, "made-up.npz")


def test_every_landmark_is_in_one_group():
    assert sorted(np.concatenate(list(GROUPS.values())).tolist()) == list(range(33))


def test_scores_by_hand():
    arrays = pair_arrays(noise=0.0)
    file = from_arrays(arrays, "x.npz")
    poses = {name: truth.copy() for name, truth in file.truths.items()}
    poses["3d"][4, :, 2] += 0.010  # a step of 10 mm that lasts for one frame
    poses["2d"] += 0.07 * np.ptp(arrays["gt_2d"], axis=1).max(axis=1)[:, None, None] * [1, 0]
    scored = np.zeros(165, bool)
    scored[[2, 3, 4, 5, 99, 100, 101, 102]] = True
    got = score(file, poses, scored)
    assert got["mpjpe_mm"] == pytest.approx(10 / 8, rel=1e-4)
    assert got["groups"]["feet"] == pytest.approx(10 / 8, rel=1e-4)
    # Frames 3 and 4 alone have both neighbours: 100 and 101 are of different sequences.
    assert got["accel_mm"] == pytest.approx((10 + 20) / 2, rel=1e-3)
    assert got["pa_mpjpe_mm"] < 0.01
    assert (got["pck_20"], got["pck_10"], got["pck_05"]) == (1, 1, 0)


def test_scored_are_frames_that_every_interval_reaches():
    lost = (0, *range(20, 75), 130)
    file = from_arrays(pair_arrays(lost=lost), "x.npz")
    scored = scored_frames(file, [0, 1], [1, 10])
    # At N = 10, frame 10 is the first sample with somebody, and the gap from 10 to 80 is too long.
    assert np.flatnonzero(scored[:101]).tolist() == [10, *range(80, 101)]
    assert scored[101:].sum() == LENGTHS[1] - 1 and not scored[130]
    with pytest.raises(UserError, match="no frame"):
        scored_frames(from_arrays(pair_arrays(lost=tuple(range(164))), "x.npz"), [0], [10])


def test_costs_count_every_watched_frame_and_window():
    file, nets = pair_file(), from_models(SMALL, 3)
    _, cost = run_method(file, [0, 1], recovered({"3d": nets}), 10, 10)
    # 101 frames: 11 watched in one window. 64 frames: 0 to 60 and 63, 8 watched in one window.
    assert (cost.frames, cost.watched) == (165, 19)
    entry = manifest.read(SMALL)["pairs"]["3d"]
    by_hand = sum(
        evaluate(entry[kind]["flops"], *place)
        for kind in ("denoise", "recover")
        for place in ((11, 101), (8, 64))
    )
    assert cost.flops == by_hand
    figures = Cost(frames=165, watched=19, flops=by_hand, seconds=0.33).figures(10**9, 20.0)
    assert figures["flops_per_frame"] == pytest.approx(10**9 * 19 / 165 + by_hand / 165)
    assert figures["ms_per_frame"] == pytest.approx(20 * 19 / 165 + 2.0)
    assert Cost(1, 1).figures(None, None) == {"flops_per_frame": None, "ms_per_frame": None}
    assert estimator_flops("mediapipe-heavy") > estimator_flops("mediapipe-lite")
    assert estimator_flops("mediapipe-gigantic") is None and estimator_flops("heavy") is None


@pytest.mark.parametrize("dims", [3, 2])
def test_flops_of_a_checkpoint_are_those_of_its_graphs(dims):
    counted = from_checkpoint(checkpoint.default_path(dims), dims)
    shipped = from_models(MODELS, dims)
    for place in ((2, 11), (11, 101)):
        assert counted.flops(*place) == shipped.flops(*place)
        assert without_recover(counted).flops(*place) < counted.flops(*place)


def test_one_window_is_what_the_runner_makes_of_it():
    file, nets = pair_file(), from_models(SMALL, 3)
    poses, _ = run_method(file, [0], recovered({"3d": nets}), 10, 10)
    sequence = file.sequence(0)
    watched = np.arange(0, 101, 10)
    samples = Samples(
        sequence.estimates["3d"][watched],
        sequence.estimates["2d"][watched],
        sequence.scores[watched],
    )
    expected = recover_window(nets.nets, samples, sequence.times[watched], sequence.times).poses
    np.testing.assert_allclose(poses["3d"][:101], expected - mid_hip(expected), atol=1e-5)
    assert np.isnan(poses["3d"][101:]).all() and list(poses) == ["3d"]


def test_batches_give_what_single_windows_give(rounded_checkpoint):
    batched, single = from_checkpoint(rounded_checkpoint(2), 2), from_models(MODELS, 2)
    assert batched.batch > 1 and single.batch == 1
    both = [
        run_method(pair_file(), [0, 1], recovered({"2d": x}), 2, 10)[0] for x in (batched, single)
    ]
    assert np.isfinite(both[0]["2d"]).all()
    np.testing.assert_allclose(both[0]["2d"], both[1]["2d"], atol=0.05)


def test_each_net_can_be_left_out():
    file, nets = pair_file(), from_models(SMALL, 3)
    watched = np.arange(0, 101, 10)
    raw, _ = run_method(file, [0], recovered({"3d": without_denoise(nets)}), 10, 10)
    # This RecoverNet gives the samples back that it is given.
    estimates = file.estimates["3d"][watched]
    np.testing.assert_allclose(raw["3d"][watched], estimates - mid_hip(estimates), atol=1e-4)
    both = without_recover(without_denoise(nets))
    straight = pair_arrays(lost=())
    straight["pred"] = (np.arange(165)[:, None, None] * straight["pred"][:1]).astype(np.float32)
    line, _ = run_method(from_arrays(straight, "x.npz"), [0], recovered({"3d": both}), 10, 10)
    expected = straight["pred"][:101]
    np.testing.assert_allclose(line["3d"][:101], expected - mid_hip(expected), atol=1e-3)


def test_interpolation_bridges_short_gaps_only():
    file = from_arrays(pair_arrays(lost=(10, *range(40, 90))), "x.npz")
    sequence = file.sequence(0)
    plan = make_plan(sequence, 10)
    poses = interpolated("linear")(sequence, plan).poses["2d"]
    np.testing.assert_allclose(
        poses[10], (sequence.estimates["2d"][0] + sequence.estimates["2d"][20]) / 2, atol=1e-3
    )
    finite = np.isfinite(poses).all(axis=(1, 2))
    np.testing.assert_array_equal(finite, plan.covered())
    assert np.flatnonzero(~finite).tolist() == list(range(31, 90))
    own = every_frame(sequence, make_plan(sequence, 1)).poses["3d"]
    np.testing.assert_array_equal(own, sequence.estimates["3d"])


@pytest.mark.parametrize("dims", [3, 2])
def test_calibration_undoes_an_affine_map_of_each_joint(dims):
    rng = np.random.default_rng(1)
    estimates = rng.normal(size=(50, 5, dims)).astype(np.float32)
    # In 2D maps act within each frame's box, so that they hold for a person of any size anywhere.
    low, high = estimates.min(axis=1, keepdims=True), estimates.max(axis=1, keepdims=True)
    middle, size = (low + high) / 2, np.maximum((high - low).max(axis=-1, keepdims=True), 1)
    origin, unit = (0, 0.5) if dims == 3 else (middle, size)
    maps = rng.normal(size=(5, dims, dims))
    truth = (
        np.einsum("kij,fkj->fki", maps, (estimates - origin) / unit) * unit + origin + 0.1 * unit
    )
    fitted = calibration.fit(estimates, truth.astype(np.float32))
    estimates[3] = np.nan
    got = calibration.apply(fitted, estimates)
    assert np.isnan(got[3]).all()
    np.testing.assert_allclose(np.delete(got, 3, 0), np.delete(truth, 3, 0), atol=1e-4)


def test_one_euro_by_hand():
    values, times = np.array([[0.0], [1.0], [1.0]]), np.array([0.0, 0.5, 1.0])
    # α = 1 / (1 + 1 / (2π·fc·Δt)); with beta 0 the cutoff is always min_cutoff = 1 Hz.
    alpha = 1 / (1 + 1 / np.pi)
    got = one_euro(values, times, 1.0, 0.0)[:, 0]
    np.testing.assert_allclose(got, [0, alpha, alpha + alpha * (1 - alpha)])
    # Speed after the second value: α·(1 − 0)/0.5, which raises the cutoff.
    fast = 1 / (1 + 1 / (np.pi * (1 + 3 * alpha * 2)))
    both = one_euro(values, times, np.array([[1.0], [1.0]]), np.array([[0.0], [3.0]]))
    np.testing.assert_allclose(both[1, :, 0], [alpha, fast])


def test_smoothnet_fills_gaps_and_averages_windows():
    torch.manual_seed(0)
    net = SmoothNet().eval()
    frames = np.delete(np.arange(5, 95), [10, 11, 40])
    values = np.stack([frames * 2.0, np.full(len(frames), 7.0)], axis=1)
    # Untrained, it gives back what it gets.
    np.testing.assert_allclose(smooth_values(net, values, frames), values, atol=1e-4)
    torch.nn.init.normal_(net.decode.weight)
    assert np.abs(smooth_values(net, values, frames) - values).max() > 0.01
    few = smooth_values(net, values[:3], frames[:3])
    assert few.shape == (3, 2) and np.isfinite(few).all()
    weights = sum(w.numel() for name, w in net.named_parameters() if name.endswith("weight"))
    assert net.flops(3) == 2 * 3 * weights and WINDOW == 32

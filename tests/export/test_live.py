"""ForecastNet, what it is trained on, and the simulation of live playback."""

import json

import numpy as np
import pytest
import torch

from deciwatch import checkpoint
from deciwatch.__main__ import main
from deciwatch.data.batch import Batch
from deciwatch.data.hidden_future import hide_future
from deciwatch.evaluation.pair_file import Sequence
from deciwatch.fixture_parity import standing_person
from deciwatch.forecast_trainer import ForecastTrainer
from deciwatch.live.easing import EASE_SECONDS, eased_share
from deciwatch.live.methods import Live, every_frame_now, hold, linear
from deciwatch.live.stretches import Stretch, shown_poses
from deciwatch.nets.bones import bone_lengths
from deciwatch.nets.forecast import ForecastConfig, ForecastNet
from deciwatch.nets.pair import Pair, PairConfig
from deciwatch.normalise import frame_of, to_net
from deciwatch.paths import MODELS
from deciwatch.trainer import Recipe
from made_up_pairs import pair_arrays, write_pairs

CONFIG = PairConfig(dims=3, width=16, blocks=1, recover="samples", inputs=("3d", "2d", "scores"))


def net(config: PairConfig = CONFIG) -> ForecastNet:
    torch.manual_seed(3)
    return ForecastNet(ForecastConfig(config, width=16, blocks=1)).eval()


def walker(windows: int = 4, samples: int = 5) -> Batch:
    """A made-up person walking, with true samples ten time units apart and frames between them."""
    times = np.arange(samples) * 10.0
    frames = np.sort(np.concatenate([times[:-1] + at for at in (2.0, 5.0, 8.0)]))
    begins = np.arange(windows)[:, None] * 0.37
    poses = np.stack([standing_person(frames / 30 + begin) for begin in begins[:, 0]])
    clean = np.stack([standing_person(times / 30 + begin) for begin in begins[:, 0]])
    flat = clean[..., :2] * 300 + 400
    blocks = [clean.reshape(windows, samples, -1) / 0.5, to_net(flat, *frame_of(flat))]
    blocks.append(np.ones((windows, samples, 33)))
    return Batch(
        sampled=np.concatenate(blocks, axis=-1).astype(np.float32),
        clean=(clean.reshape(windows, samples, -1) / 0.5).astype(np.float32),
        poses=(poses.reshape(windows, len(frames), -1) / 0.5).astype(np.float32),
        sample_times=np.repeat(times[None], windows, 0).astype(np.float32),
        frame_times=np.repeat(frames[None], windows, 0).astype(np.float32),
        unit=np.full(windows, 0.5, np.float32),
    )


def test_an_untrained_net_holds_the_last_clean_pose():
    batch = walker()
    sampled, times = torch.from_numpy(batch.sampled), torch.from_numpy(batch.sample_times)
    clean, poses = net()(sampled, times, times[:, -1:] + torch.tensor([[0.0, 3.0, 40.0]]))
    assert poses.shape == (4, 3, 99)
    assert torch.allclose(poses, clean[:, -1:].expand(-1, 3, -1), atol=1e-5)


def test_a_trained_net_looks_ahead_keeps_bones_and_knows_no_absolute_time():
    ours = net()
    torch.nn.init.normal_(ours.decode.weight, std=0.1)
    batch = walker()
    sampled, times = torch.from_numpy(batch.sampled), torch.from_numpy(batch.sample_times)
    ahead = times[:, -1:] + torch.tensor([[1.0, 6.0, 12.0]])
    clean, poses = ours(sampled, times, ahead)
    assert (poses[:, 1] - poses[:, 0]).abs().max() > 0.01
    lengths = bone_lengths(clean[:, -1:]).expand(-1, 3, -1)
    assert torch.allclose(bone_lengths(poses)[lengths > 0.05], lengths[lengths > 0.05], atol=1e-3)
    later = ours(sampled, times + 500, ahead + 500)[1]
    assert torch.allclose(later, poses, atol=1e-3)


def test_the_future_is_hidden_and_2d_is_framed_by_what_is_left():
    rng = np.random.default_rng(0)
    pixels = rng.uniform(0, 1000, size=(2, 6, 33, 2)) + np.arange(6)[:, None, None] * 200
    frames = rng.uniform(0, 1000, size=(2, 15, 33, 2))
    times = np.repeat(np.arange(6)[None] * 10.0, 2, 0)
    at = np.repeat(np.linspace(1, 49, 15)[None], 2, 0)
    whole = frame_of(pixels)
    batch = Batch(
        sampled=to_net(pixels, *whole),
        clean=to_net(pixels, *whole),
        poses=to_net(frames, *whole),
        sample_times=times,
        frame_times=at,
        unit=whole[1].reshape(-1),
    )
    future = hide_future(batch, 3, ("2d",))
    alone = frame_of(pixels[:, :3])
    np.testing.assert_allclose(future.sampled, to_net(pixels[:, :3], *alone), atol=1e-5)
    np.testing.assert_allclose(future.clean, to_net(pixels[:, 2:3], *alone)[:, 0], atol=1e-5)
    assert (future.frame_times > 20).all()
    assert future.frame_times.max() <= 20 + 15
    places = np.searchsorted(at[0], future.frame_times[0])
    np.testing.assert_allclose(future.poses, to_net(frames[:, places], *alone), atol=1e-4)
    assert set(np.unique(future.weight)) == {0.5, 1.0}


def test_training_lowers_the_loss_and_first_leaves_denoisenet_alone():
    pair = Pair(CONFIG)
    recipe = Recipe(steps=60, rate=4e-3, denoise_first=0.5)
    config = ForecastConfig(CONFIG, width=16, blocks=1, dropout=0.0)
    run = ForecastTrainer(config, recipe, lambda rng: walker(), pair)
    losses = [run.step() for _ in range(25)]
    given = pair.denoise.state_dict()
    assert all(torch.equal(given[k], v) for k, v in run.pair.denoise.state_dict().items())
    losses += [run.step() for _ in range(35)]
    assert any(not torch.equal(given[k], v) for k, v in run.pair.denoise.state_dict().items())
    assert sum(losses[-10:]) < 0.8 * sum(losses[:10])


def test_what_is_shown_passes_over_without_a_jump():
    first = Stretch(0, 0, np.zeros((30, 1, 3)))
    second = Stretch(8, 10, np.ones((30, 1, 3)))
    shown = shown_poses(50, (1, 3), 30.0, [first, second])[:, 0, 0]
    assert np.isnan(shown[38:]).all()
    assert (shown[:10] == 0).all()
    np.testing.assert_allclose(shown[10:14], 1 - eased_share((np.arange(4) + 0.5) / 30))
    assert shown[20] == pytest.approx(1, abs=1e-3)
    assert eased_share(np.array([0.0, EASE_SECONDS])) == pytest.approx([1, np.exp(-1)])


def test_answers_come_late():
    rng = np.random.default_rng(1)
    poses = rng.normal(size=(41, 33, 3))
    seen = np.ones(41, bool)
    seen[20] = False
    live = Live(Sequence(np.arange(41) / 30, {"3d": poses}, None, seen), 10, 3)
    held = hold(live)[0]["3d"]
    assert np.isnan(held[:3]).all()
    assert (held[3:13] == poses[0]).all()
    # Nobody was seen in frame 20.
    assert (held[13:33] == poses[10]).all()
    straight = linear(live)[0]["3d"]
    np.testing.assert_allclose(straight[15], poses[10] + (poses[10] - poses[0]) * 0.5)
    assert (every_frame_now(live)[0]["3d"][7] == poses[4]).all()
    assert live.windows() == [[0], [0, 10], [0, 10, 30], [0, 10, 30, 40]]


def test_evaluate_live_scores_every_method_on_the_same_frames(capsys, tmp_path):
    pairs = write_pairs(tmp_path / "pairs.npz", pair_arrays(lost=()))
    options = ["--live", "--pairs", pairs, "--every", "5,10", "--late", "2", "--json"]
    assert main(["evaluate", *options]) == 0
    rows = json.loads(capsys.readouterr().out)["rows"]
    methods = {row["method"] for row in rows}
    assert methods >= {"every_frame", "every_frame_now", "hold", "linear", "smooth", "now"}
    assert {row["late"] for row in rows} == {0, 2}
    for late in (0, 2):
        assert len({row["frames"] for row in rows if row["late"] == late}) == 1
    delays = {(r["method"], r["interval"]): r["delay_frames"] for r in rows if r["late"] == 2}
    assert delays["smooth", 10] == 12
    assert delays["now", 10] == delays["hold", 10] == 0
    assert main(["evaluate", "--live"]) == 2
    assert "--pairs" in capsys.readouterr().err


@pytest.mark.parametrize("dims", [2, 3])
def test_the_shipped_forecast_fits_the_shipped_pair(dims):
    _, content = checkpoint.load_forecast(checkpoint.forecast_path(dims), dims)
    assert content["training"]["pair"] == checkpoint.digest(checkpoint.default_path(dims))
    entry = json.loads((MODELS / "manifest.json").read_text())["pairs"][f"{dims}d"]
    assert entry["forecast"]["bytes"] == (MODELS / entry["forecast"]["file"]).stat().st_size


def test_a_forecast_of_another_pair_is_refused(capsys, tmp_path):
    other = Pair(PairConfig(dims=3, width=16, blocks=1))
    path = tmp_path / "other.pt"
    checkpoint.save(path, other.config, other.state_dict(), {})
    given = str(checkpoint.forecast_path(3))
    options = ["--checkpoint", str(path), "--forecast", given, "--out", str(tmp_path)]
    assert main(["export", *options]) == 2
    assert "another pair" in capsys.readouterr().err
    assert not list(tmp_path.glob("*.onnx"))

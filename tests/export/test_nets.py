"""Shapes, determinism and first values of the two nets."""

import pytest
import torch
from scipy.interpolate import CubicSpline

from deciwatch.nets.blocks import feed_forward_width, head_count
from deciwatch.nets.bones import bone_lengths
from deciwatch.nets.facing import facing, turn
from deciwatch.nets.pair import Pair, PairConfig
from deciwatch.nets.preliminary import KINDS, preliminary_matrix, preliminary_recovery
from deciwatch.nets.recover_samples import neighbours

SMALL = PairConfig(dims=2, width=16, blocks=2)
SAMPLES = {dims: PairConfig(dims=dims, width=16, blocks=2, recover="samples") for dims in (2, 3)}
EVERY = ("3d", "2d", "scores")


def pair(config: PairConfig = SMALL, trained: bool = True) -> Pair:
    torch.manual_seed(3)
    net = Pair(config).eval()
    if trained:
        for weight in net.parameters():
            torch.nn.init.normal_(weight, std=0.2)
    return net


def inputs(samples: int, frames: int, values: int = 66):
    generator = torch.Generator().manual_seed(samples * 1000 + frames)
    sampled = torch.randn(2, samples, values, generator=generator)
    frame_times = torch.arange(frames, dtype=torch.float32).expand(2, -1)
    sample_times = torch.linspace(0, max(frames - 1, 0), samples).expand(2, -1)
    return sampled, sample_times, frame_times


@pytest.mark.parametrize("recover", ["frames", "samples"])
@pytest.mark.parametrize(("dims", "kinds"), [(2, ()), (3, ()), (3, EVERY)])
@pytest.mark.parametrize(("samples", "frames"), [(1, 1), (2, 2), (2, 21), (11, 101), (12, 230)])
@torch.no_grad()
def test_shapes_and_finite_values(recover, dims, kinds, samples, frames):
    config = PairConfig(dims=dims, width=16, blocks=1, inputs=kinds, recover=recover)
    net = pair(config)
    sampled, sample_times, frame_times = inputs(samples, frames, config.channels)
    clean, features = net.denoise(sampled, sample_times)
    poses = net.recover(clean, features, sample_times, frame_times)
    assert clean.shape == (2, samples, 33 * dims)
    assert features.shape == (2, samples, 16)
    assert poses.shape == (2, frames, 33 * dims)
    assert poses.isfinite().all()


@torch.no_grad()
def test_the_same_input_gives_the_same_output():
    first, second = (pair()(*inputs(4, 31)) for _ in range(2))
    assert all(torch.equal(a, b) for a, b in zip(first, second, strict=True))


@pytest.mark.parametrize("kind", KINDS)
@torch.no_grad()
def test_an_untrained_pair_interpolates(kind):
    net = pair(PairConfig(dims=2, width=16, blocks=2, preliminary=kind), trained=False)
    sampled, sample_times, frame_times = inputs(4, 31)
    clean, poses = net(sampled, sample_times, frame_times)
    assert torch.equal(clean, sampled)
    matrix = preliminary_matrix(sample_times, frame_times, kind)
    torch.testing.assert_close(poses, matrix @ sampled)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("times", [[0.0], [0, 10], [0, 10, 20, 30], [0, 3, 11, 12, 40]])
def test_preliminary_rows_sum_to_one_and_samples_are_kept(kind, times):
    sample_times = torch.tensor([times], dtype=torch.float32)
    frame_times = torch.linspace(0, times[-1], 57)[None]
    matrix = preliminary_matrix(sample_times, frame_times, kind)
    assert matrix.shape == (1, 57, len(times))
    torch.testing.assert_close(matrix.sum(-1), torch.ones(1, 57))
    at_samples = preliminary_matrix(sample_times, sample_times, kind)
    torch.testing.assert_close(at_samples[0], torch.eye(len(times)))


@pytest.mark.parametrize("kind", KINDS)
def test_preliminary_gives_constant_velocity_back(kind):
    sample_times = torch.tensor([[0.0, 3.0, 11.0, 12.0, 40.0]])
    frame_times = torch.linspace(0, 40, 81)[None]
    motion = torch.stack([sample_times * 2 - 5, sample_times * -0.3], dim=-1)
    expected = torch.stack([frame_times * 2 - 5, frame_times * -0.3], dim=-1)
    recovered = preliminary_recovery(motion, sample_times, frame_times, kind)
    torch.testing.assert_close(recovered, expected, atol=1e-4, rtol=0)


def test_cubic_follows_a_parabola_between_inner_samples():
    sample_times = torch.arange(6, dtype=torch.float32)[None] * 4
    frame_times = torch.linspace(4, 16, 49)[None]
    recovered = preliminary_recovery(
        sample_times[..., None] ** 2, sample_times, frame_times, "cubic"
    )
    torch.testing.assert_close(recovered[..., 0], frame_times**2, atol=1e-3, rtol=0)


def test_spline_is_nearer_to_the_cubic_spline_also_at_uneven_times():
    sample_times = torch.tensor([[0.0, 4, 9, 12, 17, 20, 26, 30]])
    frame_times = torch.linspace(9, 20, 89)[None]  # the ends are treated otherwise
    motion = torch.sin(sample_times * 0.25)
    spline = torch.from_numpy(CubicSpline(sample_times[0], motion[0])(frame_times[0])).float()

    def off(kind):
        got = preliminary_recovery(motion[..., None], sample_times, frame_times, kind)
        return (got[0, :, 0] - spline).abs().max()

    assert off("spline") < 0.6 * off("cubic")


def test_spline_follows_a_parabola_to_the_ends():
    sample_times = torch.tensor([[0.0, 4, 8, 12, 16]])
    frame_times = torch.linspace(0, 16, 65)[None]
    motion = sample_times[..., None] ** 2
    recovered = preliminary_recovery(motion, sample_times, frame_times, "spline")
    torch.testing.assert_close(recovered[..., 0], frame_times**2, atol=1e-3, rtol=0)


def test_times_beyond_the_samples_hold_the_nearest():
    matrix = preliminary_matrix(torch.tensor([[0.0, 5.0]]), torch.tensor([[-3.0, 9.0]]), "cubic")
    torch.testing.assert_close(matrix[0], torch.eye(2))


@torch.no_grad()
def test_only_differences_of_times_matter():
    net = pair()
    sampled, sample_times, frame_times = inputs(4, 31)
    for ours, moved in zip(
        net(sampled, sample_times, frame_times),
        net(sampled, sample_times + 64, frame_times + 64),
        strict=True,
    ):
        torch.testing.assert_close(ours, moved, atol=1e-4, rtol=1e-4)


@torch.no_grad()
def test_samples_may_be_missing_anywhere_inside():
    net = pair()
    sampled, sample_times, frame_times = inputs(6, 51)
    kept = torch.tensor([0, 2, 3, 5])
    clean, poses = net(sampled[:, kept], sample_times[:, kept], frame_times)
    assert clean.shape == (2, 4, 66) and poses.shape == (2, 51, 66)
    # The tokens are a set in time: another order of windows in the batch changes nothing.
    _, flipped = net(sampled[:, kept].flip(0), sample_times[:, kept], frame_times)
    torch.testing.assert_close(flipped.flip(0), poses, atol=1e-5, rtol=1e-5)


def test_wrong_shapes_are_refused():
    net = pair()
    sampled, sample_times, _ = inputs(4, 31)
    with pytest.raises(AssertionError):
        net.denoise(sampled[..., :60], sample_times)


def test_configurations_that_no_pair_can_have_are_refused():
    for wrong in ({"inputs": ("2d", "3d")}, {"inputs": ("3d", "3d")}, {"recover": "gaps"}):
        with pytest.raises(ValueError):
            PairConfig(dims=3, **wrong)
    assert PairConfig(dims=2, inputs=["2d", "scores"]).channels == 99


def test_widths_of_blocks_are_those_of_the_nets_trained_before():
    # Checkpoints that name no feed-forward width have C = 64 and 256 of it, with four heads.
    assert (feed_forward_width(64), head_count(64)) == (256, 4)
    assert (feed_forward_width(256), head_count(256)) == (512, 8)


@torch.no_grad()
def test_without_denoising_the_samples_stay_as_they_are():
    net = pair(PairConfig(dims=3, width=16, blocks=1, recover="samples", denoise=False))
    sampled, sample_times, frame_times = inputs(4, 31, 99)
    clean, poses = net(sampled, sample_times, frame_times)
    assert torch.equal(clean, sampled)
    torch.testing.assert_close(poses[:, [0, 10, 20, 30]], sampled, atol=1e-5, rtol=1e-5)


@torch.no_grad()
def test_frames_find_the_samples_around_them():
    sample_times = torch.tensor([[0.0, 3.0, 11.0, 12.0]])
    frame_times = torch.tensor([[-2.0, 0.0, 1.5, 3.0, 9.0, 11.5, 12.0, 20.0]])
    left, right, u, gap = neighbours(sample_times, frame_times)
    assert left[0].argmax(dim=-1).tolist() == [0, 0, 0, 1, 1, 2, 3, 3]
    assert (left.sum(dim=-1) == 1).all()
    assert right[0].sum(dim=-1).tolist() == [1, 1, 1, 1, 1, 1, 0, 0]
    assert u[0, :, 0].tolist() == [0, 0, 0.5, 0, 0.75, 0.5, 0, 0]
    assert gap[0, :6, 0].tolist() == [3, 3, 3, 8, 8, 1]


@torch.no_grad()
def test_an_untrained_samples_net_in_2d_is_the_preliminary_recovery():
    net = pair(SAMPLES[2], trained=False)
    sampled, sample_times, frame_times = inputs(5, 41)
    expected = preliminary_recovery(sampled, sample_times, frame_times, "cubic")
    assert torch.equal(net(sampled, sample_times, frame_times)[1], expected)


@pytest.mark.parametrize("dims", [2, 3])
@torch.no_grad()
def test_corrections_vanish_at_the_samples_and_shrink_with_the_gap(dims):
    net = pair(SAMPLES[dims]).recover
    clean, sample_times, _ = inputs(6, 51, 33 * dims)
    features = torch.randn(2, 6, 16)
    at_samples = net(clean, features, sample_times, sample_times)
    torch.testing.assert_close(at_samples, clean, atol=1e-5, rtol=1e-5)
    if dims == 2:
        # The same motion ten times as fast: tokens change little, corrections by about ten.
        sizes = []
        for share in (1.0, 0.01):
            middle = (sample_times[:, :1] + share * 5) + 0 * sample_times[:, :1]
            start = preliminary_recovery(clean, share * sample_times, middle, "cubic")
            sizes.append((net(clean, features, share * sample_times, middle) - start).abs().max())
        assert sizes[0] > 0 and sizes[1] < 0.3 * sizes[0]


@torch.no_grad()
def test_every_frame_is_answered_by_itself():
    net = pair(SAMPLES[3])
    sampled, sample_times, frame_times = inputs(6, 51, 99)
    whole = net(sampled, sample_times, frame_times)[1]
    some = torch.tensor([3, 17, 20, 44])
    torch.testing.assert_close(net(sampled, sample_times, frame_times[:, some])[1], whole[:, some])


@torch.no_grad()
def test_what_the_samples_net_learns_holds_for_every_view():
    net = pair(SAMPLES[3]).recover
    clean, sample_times, frame_times = inputs(5, 41, 99)
    features = torch.randn(2, 5, 16)
    poses = net(clean, features, sample_times, frame_times)
    direction = torch.tensor([0.6, 0.8]).expand(2, 1, 2)
    turned = net(turn(clean, direction), features, sample_times, frame_times)
    torch.testing.assert_close(turned, turn(poses, direction), atol=1e-4, rtol=1e-4)
    towards = facing(turn(clean, facing(clean)))
    torch.testing.assert_close(towards, torch.tensor([1.0, 0.0]).expand(2, 5, 2))
    torch.testing.assert_close(turn(turn(clean, direction), direction, back=True), clean)


@torch.no_grad()
def test_bones_keep_their_lengths_between_samples():
    net = pair(SAMPLES[3])
    pose = torch.randn(1, 1, 99)
    pose[..., 69:72], pose[..., 72:75] = torch.tensor([0.2, 0, 0]), torch.tensor([-0.2, 0, 0])
    angles = torch.tensor([0.0, 1.0, 2.0, 3.0])
    directions = torch.stack([angles.cos(), angles.sin()], dim=-1)[None]
    spinning = turn(pose.expand(1, 4, 99), directions)
    times = torch.arange(4.0)[None] * 10
    poses = net.recover(spinning, torch.randn(1, 4, 16), times, torch.linspace(0, 30, 31)[None])
    expected = bone_lengths(pose).expand(1, 31, -1)
    torch.testing.assert_close(bone_lengths(poses), expected, atol=1e-4, rtol=1e-4)
    straight = preliminary_recovery(spinning, times, torch.linspace(0, 30, 31)[None], "cubic")
    assert (bone_lengths(straight) - expected).abs().max() > 0.02

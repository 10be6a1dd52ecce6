"""Shapes, determinism and first values of the two nets."""

import pytest
import torch

from deciwatch.nets.pair import Pair, PairConfig
from deciwatch.nets.preliminary import KINDS, preliminary_matrix, preliminary_recovery

SMALL = PairConfig(dims=2, width=16, blocks=2)


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


@pytest.mark.parametrize("dims", [2, 3])
@pytest.mark.parametrize(("samples", "frames"), [(1, 1), (2, 2), (2, 21), (11, 101), (12, 230)])
@torch.no_grad()
def test_shapes_and_finite_values(dims, samples, frames):
    net = pair(PairConfig(dims=dims, width=16, blocks=1))
    sampled, sample_times, frame_times = inputs(samples, frames, 33 * dims)
    clean, features = net.denoise(sampled, sample_times)
    poses = net.recover(clean, features, sample_times, frame_times)
    assert clean.shape == sampled.shape
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

"""Fixed windows that no training sees, and how a pair does on them."""

from dataclasses import dataclass, field

import numpy as np
import torch

from deciwatch.data.batch import Batch
from deciwatch.data.batches import Estimator, build
from deciwatch.errors import UserError
from deciwatch.interpolate import interpolate
from deciwatch.motion.motions import Motions
from deciwatch.nets.pair import Pair

INTERVAL, WINDOW, SEED = 10, 10, 7
FEWEST = 2  # intervals of the shortest windows
STRIDE, MOST = 20, 8  # frames between windows of a sequence; windows of one


@dataclass(frozen=True)
class Validation:
    """Batches of windows at N = 10 and Q to 10, and what straight lines and others get on them.

    Errors are mm and mm/frame² in 3D, px in 2D, by "position" and "accel".
    """

    dims: int
    batches: list[Batch]
    baselines: dict[str, dict[str, float]] = field(default_factory=dict)

    @property
    def unit(self) -> str:
        """Of the errors."""
        return "mm" if self.dims == 3 else "px"

    @torch.no_grad()
    def of(self, pair: Pair) -> dict[str, float]:
        """Errors of a pair; leaves it in evaluation mode."""
        pair.eval()
        return errors([_recovered(pair, batch) for batch in self.batches], self.batches, self.dims)


def recorded_validation(
    motions: Motions, inputs: tuple[str, ...], estimator: Estimator
) -> Validation:
    """Recorded motion at 30 frames a second, seeded cameras, made-up estimates.

    A few windows of every sequence, shorter where it is short, so that no recording decides alone.
    """
    rng = np.random.default_rng(SEED)
    batches = []
    for intervals in range(FEWEST, WINDOW + 1):
        frames = np.arange(INTERVAL * intervals + 1)
        world = [
            motions.sequence(index)[first + frames]
            for index, length in enumerate(motions.length)
            if min((length - 1) // INTERVAL, WINDOW) == intervals
            for first in _firsts(int(length) - len(frames))
        ]
        if not world:
            continue
        times = np.broadcast_to(frames.astype(float), (len(world), len(frames)))
        watched = np.arange(intervals + 1) * INTERVAL
        batches.append(build(rng, np.stack(world), times, watched, inputs, estimator))
    if not batches:
        raise UserError(
            f"No recording for validation has {FEWEST * INTERVAL + 1} frames; give more by --data."
        )
    return with_lines(inputs[0], batches)


def _firsts(room: int) -> np.ndarray:
    """First frames of at most MOST windows at least STRIDE apart, where `room` are left over."""
    return np.linspace(0, room, min(MOST, 1 + room // STRIDE)).astype(int)


def with_lines(own: str, batches: list[Batch], **baselines: dict[str, float]) -> Validation:
    """A validation of `own`, "3d" or "2d", with straight lines among its baselines."""
    dims = 3 if own == "3d" else 2
    lines = [_linear(batch) for batch in batches]
    return Validation(dims, batches, {"linear": errors(lines, batches, dims)} | baselines)


def errors(poses: list[np.ndarray], batches: list[Batch], dims: int) -> dict[str, float]:
    """Mean joint error and acceleration error of poses [B, T, K·D] of each batch."""
    off = [
        (got - batch.poses).reshape(*got.shape[:2], -1, dims)
        * (batch.unit[:, None, None, None] * (1000 if dims == 3 else 1))
        for got, batch in zip(poses, batches, strict=True)
    ]
    accel = [each[:, :-2] - 2 * each[:, 1:-1] + each[:, 2:] for each in off]
    return {"position": _mean_length(off), "accel": _mean_length(accel)}


def _mean_length(vectors: list[np.ndarray]) -> float:
    return float(np.concatenate([np.linalg.norm(x, axis=-1).ravel() for x in vectors]).mean())


def _linear(batch: Batch) -> np.ndarray:
    own = batch.sampled[..., : batch.clean.shape[-1]]
    windows = zip(batch.sample_times, own, batch.frame_times, strict=True)
    return np.stack([interpolate(times, poses, at, "linear") for times, poses, at in windows])


def _recovered(pair: Pair, batch: Batch) -> np.ndarray:
    inputs = [torch.from_numpy(x) for x in (batch.sampled, batch.sample_times, batch.frame_times)]
    parts = [pair(*part)[1] for part in zip(*(x.split(32) for x in inputs), strict=True)]
    return torch.cat(parts).numpy()

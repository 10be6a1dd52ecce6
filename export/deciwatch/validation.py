"""A fixed set of noisy windows of the validation split, and how a pair does on it."""

from functools import cache
from pathlib import Path

import numpy as np
import torch

from deciwatch.data.batches import Batch, build
from deciwatch.data.noise import NOMINAL
from deciwatch.data.windows import slices
from deciwatch.interpolate import interpolate
from deciwatch.motion.load import load_motions
from deciwatch.motion.motions import Motions
from deciwatch.nets.pair import Pair

INTERVAL, WINDOW, STRIDE, SEED = 10, 10, 20, 7


def validation_batch(motions: Motions, dims: int) -> Batch:
    """Windows at N = Q = 10 and 30 frames a second, seeded cameras and nominal noise."""
    frames = np.arange(INTERVAL * WINDOW + 1)
    world = np.stack(
        [
            motions.sequence(index)[first + frames]
            for index, first in slices(motions, INTERVAL, WINDOW, STRIDE)
        ]
    )
    times = np.broadcast_to(frames.astype(float), (len(world), len(frames)))
    rng = np.random.default_rng(SEED)
    return build(rng, world, times, np.arange(WINDOW + 1) * INTERVAL, dims, NOMINAL)


@cache
def cached_batch(directory: Path, dims: int) -> Batch:
    """The validation batch of a data folder, made once."""
    return validation_batch(load_motions(directory, "val"), dims)


def errors(poses: np.ndarray, batch: Batch, dims: int) -> dict[str, float]:
    """Mean joint error and acceleration error of poses [B, T, K·D]: mm and mm/frame², or px."""
    unit = batch.unit[:, None, None, None] * (1000 if dims == 3 else 1)
    shape = (*poses.shape[:2], -1, dims)
    off = (poses - batch.poses).reshape(shape) * unit
    accel = off[:, :-2] - 2 * off[:, 1:-1] + off[:, 2:]
    return {
        "position": float(np.linalg.norm(off, axis=-1).mean()),
        "accel": float(np.linalg.norm(accel, axis=-1).mean()),
    }


def linear_errors(batch: Batch, dims: int) -> dict[str, float]:
    """The same of straight lines between the noisy samples: what the nets have to beat."""
    poses = [
        interpolate(times, values, at, "linear")
        for times, values, at in zip(
            batch.sample_times, batch.sampled, batch.frame_times, strict=True
        )
    ]
    return errors(np.stack(poses), batch, dims)


@torch.no_grad()
def pair_errors(pair: Pair, batch: Batch, dims: int) -> dict[str, float]:
    """The same of a pair; leaves it in evaluation mode."""
    pair.eval()
    inputs = [torch.from_numpy(x) for x in (batch.sampled, batch.sample_times, batch.frame_times)]
    parts = [pair(*part)[1] for part in zip(*(x.split(32) for x in inputs), strict=True)]
    return errors(torch.cat(parts).numpy(), batch, dims)

"""Training windows with the future hidden: what ForecastNet gets, and what it is asked for."""

from dataclasses import dataclass

import numpy as np

from deciwatch.data.batch import Batch
from deciwatch.nets.pair import INPUTS
from deciwatch.skeleton import KEYPOINTS

FEWEST = 2  # samples that are left
# An estimate is late by some frames: with a small N the future that is asked for is many gaps long.
LEAST_AHEAD = 8.0  # time units
AHEAD = 1.5  # gaps
LATER = 0.5  # weight of frames beyond the next gap


@dataclass(frozen=True)
class Future:
    """Samples so far and frames to come, in net values and time units.

    sampled: [B, S, I]. sample_times: [B, S]. clean: [B, K·D] truth of the last sample. poses:
    [B, T, K·D] truth at frame_times [B, T], after the last sample. weight: [B, T], 0 for frames
    that nobody will ask for.
    """

    sampled: np.ndarray
    sample_times: np.ndarray
    clean: np.ndarray
    poses: np.ndarray
    frame_times: np.ndarray
    weight: np.ndarray


def hide_future(batch: Batch, kept: int, inputs: tuple[str, ...]) -> Future:
    """The first `kept` samples of every window, and the scored frames after them."""
    times = batch.sample_times[:, :kept]
    last = times[:, -1:]
    gap = batch.sample_times[:, kept : kept + 1] - last
    ahead = batch.frame_times - last
    reach = np.maximum(AHEAD * gap, LEAST_AHEAD)
    weight = np.where(ahead <= gap, 1.0, LATER) * ((ahead > 0) & (ahead <= reach))
    used = weight.any(axis=0)
    sampled, origin, unit = reframed(batch.sampled[:, :kept], inputs)
    clean, poses = batch.clean[:, kept - 1], batch.poses[:, used]
    if inputs[0] == "2d":
        clean = (clean - origin) / unit[:, None]
        poses = (poses - origin[:, None]) / unit[:, None, None]
    return Future(
        sampled,
        times,
        clean.astype(np.float32),
        poses.astype(np.float32),
        batch.frame_times[:, used],
        weight[:, used].astype(np.float32),
    )


def reframed(
    sampled: np.ndarray, inputs: tuple[str, ...]
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """`sampled` [B, S, I] with its 2D in the frame of these samples alone.

    Also that frame in the old net values: origin [B, K·2] and unit [B]; for 3D 0 and 1.
    """
    parts, start = [], 0
    origin, unit = np.zeros((len(sampled), KEYPOINTS * 2)), np.ones(len(sampled))
    for name in inputs:
        block = sampled[..., start : start + KEYPOINTS * INPUTS[name]]
        start += block.shape[-1]
        if name == "2d":
            points = block.reshape(*block.shape[:2], KEYPOINTS, 2)
            low, high = points.min(axis=2), points.max(axis=2)
            # Where the input was left out (all zeros) there is nothing to put right.
            size = (high - low).max(axis=-1).mean(axis=1)
            unit = np.where(size > 0, size, 1.0)
            origin = np.tile(((low + high) / 2).mean(axis=1), KEYPOINTS)
            block = (block - origin[:, None]) / unit[:, None, None]
        parts.append(block)
    return np.concatenate(parts, axis=-1).astype(np.float32), origin, unit

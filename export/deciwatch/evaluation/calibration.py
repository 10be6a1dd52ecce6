"""The best affine map of each joint from estimates to truth.

A correction that removes mere differences of joint definition, so that these do not count as
denoising. 3D: metres about the mid-hip. 2D: relative to the box of each frame's own estimate.
"""

import numpy as np

from deciwatch.normalise import frame_of, from_net, to_net

ROUNDS = 20
NEAREST = 1e-3  # net units; nearer frames weigh no more


def _local(poses: np.ndarray) -> tuple[np.ndarray, tuple[np.ndarray, np.ndarray]]:
    """Poses [F, K, D] in each frame's own units [F, K, D], and origin and unit to come back."""
    frame = frame_of(poses[:, None])
    return to_net(poses[:, None], *frame).reshape(poses.shape), frame


def _with_one(values: np.ndarray) -> np.ndarray:
    return np.concatenate([values, np.ones_like(values[..., :1])], axis=-1).astype(np.float64)


def fit(estimates: np.ndarray, truth: np.ndarray) -> np.ndarray:
    """The maps with the least MPJPE over frames, [F, K, D] each, all finite → [K, D, D + 1].

    Least squares, reweighted until the sum of distances is least (I. Weiszfeld's method): plain
    least squares follows the frames in which left and right are swapped, and made MPJPE worse.
    """
    local, frame = _local(estimates)
    target = to_net(truth[:, None], *frame).reshape(truth.shape).astype(np.float64)
    columns = _with_one(local)
    maps = [_least_distance(columns[:, k], target[:, k]) for k in range(truth.shape[1])]
    return np.stack(maps).astype(np.float32)


def _least_distance(columns: np.ndarray, target: np.ndarray) -> np.ndarray:
    """The matrix [D, D + 1] that brings columns [F, D + 1] nearest to target [F, D]."""
    weights = np.ones((len(target), 1))
    for _ in range(ROUNDS):
        matrix = np.linalg.lstsq(weights * columns, weights * target)[0]
        distance = np.linalg.norm(columns @ matrix - target, axis=1, keepdims=True)
        weights = 1 / np.sqrt(np.maximum(distance, NEAREST))
    return matrix.T


def apply(maps: np.ndarray, estimates: np.ndarray) -> np.ndarray:
    """Estimates [T, K, D] through maps [K, D, D + 1] → [T, K, D]; NaN stays NaN."""
    poses = np.full_like(estimates, np.nan)
    seen = np.isfinite(estimates).all(axis=(1, 2))
    if seen.any():
        local, frame = _local(estimates[seen])
        mapped = np.einsum("kij,tkj->tki", maps, _with_one(local))
        flat = mapped.reshape(len(mapped), 1, -1)
        poses[seen] = from_net(flat, *frame)[:, 0]
    return poses

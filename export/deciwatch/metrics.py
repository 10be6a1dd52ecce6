"""How far poses are from the truth: MPJPE, Accel, PCK (the paper's evaluation metrics)."""

import numpy as np


def mpjpe(poses: np.ndarray, truth: np.ndarray) -> float:
    """Mean distance of joints, [..., K, D]; in the poses' unit (give mm for mm, px for px)."""
    return float(np.linalg.norm(poses - truth, axis=-1).mean())


def accel(poses: np.ndarray, truth: np.ndarray) -> float:
    """Mean length of the difference of accelerations, [..., T, K, D], T ≥ 3; unit/frame².

    The acceleration at frame t is p[t−1] − 2·p[t] + p[t+1]; the first and last frame have none.
    """
    if poses.shape[-3] < 3:
        raise ValueError(f"acceleration needs three frames, got {poses.shape[-3]}")
    off = poses - truth
    second = off[..., :-2, :, :] - 2 * off[..., 1:-1, :, :] + off[..., 2:, :, :]
    return float(np.linalg.norm(second, axis=-1).mean())


def box_size(truth: np.ndarray) -> np.ndarray:
    """Larger side of each frame's box over its keypoints, [..., K, 2] → [...] pixels."""
    return np.ptp(truth, axis=-2).max(axis=-1)


def pck(poses: np.ndarray, truth: np.ndarray, alpha: float) -> float:
    """Share of keypoints within alpha × the truth's box size of that frame, [..., K, 2]; 0 to 1."""
    distance = np.linalg.norm(poses - truth, axis=-1)
    return float((distance <= alpha * box_size(truth)[..., None]).mean())

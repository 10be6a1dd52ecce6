"""How far poses are from the truth: MPJPE, PA-MPJPE, Accel, PCK (the paper's metrics)."""

import numpy as np


def distances(poses: np.ndarray, truth: np.ndarray) -> np.ndarray:
    """Distance of each joint, [..., K, D] → [..., K], in the poses' unit."""
    return np.linalg.norm(poses - truth, axis=-1)


def mpjpe(poses: np.ndarray, truth: np.ndarray) -> float:
    """Mean distance of joints, [..., K, D]; in the poses' unit (give mm for mm, px for px)."""
    return float(distances(poses, truth).mean())


def bends(poses: np.ndarray, truth: np.ndarray) -> np.ndarray:
    """Length of the difference of accelerations, [..., T, K, D] → [..., T − 2, K], unit/frame².

    The acceleration at frame t is p[t−1] − 2·p[t] + p[t+1]; the first and last frame have none.
    """
    off = poses - truth
    second = off[..., :-2, :, :] - 2 * off[..., 1:-1, :, :] + off[..., 2:, :, :]
    return np.linalg.norm(second, axis=-1)


def accel(poses: np.ndarray, truth: np.ndarray) -> float:
    """Mean length of the difference of accelerations, [..., T, K, D], T ≥ 3; unit/frame²."""
    if poses.shape[-3] < 3:
        raise ValueError(f"acceleration needs three frames, got {poses.shape[-3]}")
    return float(bends(poses, truth).mean())


def procrustes(poses: np.ndarray, truth: np.ndarray) -> np.ndarray:
    """Each pose moved, turned (not mirrored) and scaled to fit the truth best, [..., K, D].

    Least squares, in closed form: S. Umeyama, "Least-squares estimation of transformation
    parameters between two point patterns", TPAMI 1991, https://doi.org/10.1109/34.88573.
    """
    poses, truth = np.asarray(poses, np.float64), np.asarray(truth, np.float64)
    middle, true_middle = (x.mean(axis=-2, keepdims=True) for x in (poses, truth))
    centred, target = poses - middle, truth - true_middle
    left, sizes, right = np.linalg.svd(np.swapaxes(target, -1, -2) @ centred)
    signs = np.ones_like(sizes)
    signs[..., -1] = np.sign(np.linalg.det(left @ right))
    rotation = left * signs[..., None, :] @ right
    spread = np.maximum((centred**2).sum(axis=(-1, -2)), 1e-12)
    scale = ((sizes * signs).sum(axis=-1) / spread)[..., None, None]
    return scale * centred @ np.swapaxes(rotation, -1, -2) + true_middle


def pa_mpjpe(poses: np.ndarray, truth: np.ndarray) -> float:
    """Mean distance of joints after `procrustes`, [..., K, D]; in the truth's unit."""
    return mpjpe(procrustes(poses, truth), truth)


def box_size(truth: np.ndarray) -> np.ndarray:
    """Larger side of each frame's box over its keypoints, [..., K, 2] → [...] pixels."""
    return np.ptp(truth, axis=-2).max(axis=-1)


def pck(
    poses: np.ndarray, truth: np.ndarray, alpha: float, size: np.ndarray | None = None
) -> float:
    """Share of keypoints within alpha × `size` of the truth, [..., K, 2]; 0 to 1.

    `size` [...] pixels is the larger side of each frame's box, by default the box over the truth.
    """
    reach = alpha * (box_size(truth) if size is None else size)
    return float((distances(poses, truth) <= reach[..., None]).mean())

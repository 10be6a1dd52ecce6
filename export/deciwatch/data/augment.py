"""Changes to the motion itself: mirror image, body size."""

import numpy as np

from deciwatch.skeleton import MIRROR

SCALES = (0.85, 1.15)
SPEEDS = (0.6, 1.6)


def mirror(poses: np.ndarray) -> np.ndarray:
    """Mirror image of world landmarks [..., 33, 3]: x → −x and left becomes right."""
    return poses[..., MIRROR, :] * np.array([-1, 1, 1], dtype=poses.dtype)


def augment(rng: np.random.Generator, poses: np.ndarray) -> np.ndarray:
    """Mirror half of the windows [B, T, 33, 3] and scale every body by SCALES."""
    flipped = rng.random(len(poses)) < 0.5
    poses = np.where(flipped[:, None, None, None], mirror(poses), poses)
    scale = rng.uniform(*SCALES, size=(len(poses), 1, 1, 1)).astype(np.float32)
    return poses * scale


def draw_speeds(rng: np.random.Generator, count: int) -> np.ndarray:
    """Speed factors [count], log-uniform over SPEEDS."""
    return np.exp(rng.uniform(*np.log(SPEEDS), size=count))

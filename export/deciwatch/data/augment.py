"""Changes to the motion itself: mirror image, body size, another's legs."""

import numpy as np

from deciwatch.rotations import about
from deciwatch.skeleton import LEFT_HIP, LEGS, MIRROR, RIGHT_HIP, mid_hip

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


def graft(rng: np.random.Generator, poses: np.ndarray) -> np.ndarray:
    """Give half of the windows [B, T, 33, 3] the legs of another one, turned to fit their hips.

    What arms do says little of what legs do, and the recordings hold few of all combinations.
    """
    donors = poses[rng.permutation(len(poses))]
    angle = _hips_yaw(donors) - _hips_yaw(poses)
    legs = np.einsum("bij,btkj->btki", about("y", angle), (donors - mid_hip(donors))[:, :, LEGS])
    grafted = poses.copy()
    grafted[:, :, LEGS] = legs + mid_hip(poses)
    chosen = rng.random(len(poses)) < 0.5
    return np.where(chosen[:, None, None, None], grafted, poses)


def _hips_yaw(poses: np.ndarray) -> np.ndarray:
    """Angle about y of the line of the hips, mean over a window's frames: [B, T, 33, 3] → [B]."""
    across = (poses[:, :, LEFT_HIP] - poses[:, :, RIGHT_HIP]).mean(axis=1)
    return np.arctan2(across[:, 2], across[:, 0])


def draw_speeds(rng: np.random.Generator, count: int) -> np.ndarray:
    """Speed factors [count], log-uniform over SPEEDS."""
    return np.exp(rng.uniform(*np.log(SPEEDS), size=count))

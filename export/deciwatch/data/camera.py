"""A random camera for each window.

Camera axes: x right, y up, z towards the camera. Pixels: origin top left, y down.
"""

from dataclasses import dataclass

import numpy as np

from deciwatch.rotations import euler
from deciwatch.skeleton import mid_hip

NEAREST = 1.0  # metres; nobody comes closer to the lens than this
FOCAL = 1000.0  # pixels, for a frame of 1280 × 720
CENTRE = (640.0, 360.0)


@dataclass(frozen=True)
class Views:
    """Cameras of B windows of T frames.

    rotation: [B, T, 3, 3] world to camera axes. target: [B, T, 3] world metres, the point that
    lands in the picture's centre. distance: [B, T] metres from the lens to the target.
    """

    rotation: np.ndarray
    target: np.ndarray
    distance: np.ndarray

    def to_camera(self, poses: np.ndarray) -> np.ndarray:
        """World landmarks [B, T, 33, 3] → camera axes, relative to the target, metres."""
        return np.einsum("btij,btkj->btki", self.rotation, poses - self.target[:, :, None])

    def poses3d(self, poses: np.ndarray) -> np.ndarray:
        """World landmarks → 3D poses: camera axes, relative to each frame's mid-hip, metres."""
        turned = np.einsum("btij,btkj->btki", self.rotation, poses - mid_hip(poses))
        return turned.astype(np.float32)

    def poses2d(self, poses: np.ndarray) -> np.ndarray:
        """World landmarks → pixels [B, T, 33, 2]."""
        x, y, z = np.moveaxis(self.to_camera(poses), -1, 0)
        depth = self.distance[:, :, None] - z
        pixels = [CENTRE[0] + FOCAL * x / depth, CENTRE[1] - FOCAL * y / depth]
        return np.stack(pixels, axis=-1).astype(np.float32)


def draw_views(
    rng: np.random.Generator, poses: np.ndarray, times: np.ndarray | None = None
) -> Views:
    """Cameras for world landmarks [B, T, 33, 3]: any yaw, 2 to 7 m away, some slowly moving.

    times: [B, T] ascending, in any unit; even where not given.
    """
    batch, frames = poses.shape[:2]
    progress = np.linspace(0.0, 1.0, frames)[None]
    if times is not None:
        span = np.maximum(times[:, -1:] - times[:, :1], 1e-9)
        progress = (times - times[:, :1]) / span

    def per_window(low: float, high: float) -> np.ndarray:
        return rng.uniform(low, high, size=(batch, 1))

    moving = (rng.random((batch, 1)) < 0.3).astype(float)
    follows = (rng.random((batch, 1)) < 0.3).astype(float)
    yaw = per_window(-np.pi, np.pi) + moving * per_window(-0.5, 0.5) * progress
    pitch = np.radians(per_window(-8, 20)) + 0.0 * progress
    roll = np.radians(3) * rng.standard_normal((batch, 1)) + 0.0 * progress
    distance = np.exp(per_window(np.log(2.0), np.log(7.0)))
    distance = distance * (1 + moving * per_window(-0.2, 0.2) * progress)
    hips = mid_hip(poses)[:, :, 0]
    middle = hips.mean(axis=1, keepdims=True)
    # A camera that follows does it along a straight line, not with every step of the person.
    path = hips[:, :1] + (hips[:, -1:] - hips[:, :1]) * progress[..., None]
    target = np.where(follows[..., None] > 0, path, middle)
    framing = rng.uniform(-0.3, 0.3, size=(batch, 1, 3))
    rotation = euler(np.stack([roll, pitch, -yaw], axis=-1), "zxy")
    views = Views(rotation, target + framing, distance)
    closest = (distance - views.to_camera(poses)[..., 2].max(axis=-1)).min(axis=1, keepdims=True)
    return Views(rotation, views.target, distance + np.maximum(NEAREST - closest, 0.0))

"""A camera for a clip: where it stands in every frame, and what it sees.

World axes in metres, y up, floor at 0. Camera axes: x right, y up, z towards the camera.
"""

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter1d

from deciwatch.rotations import euler

SIZES = ((288, 384), (384, 288), (320, 320), (384, 384), (256, 416))
SMALLEST = 0.45  # of the picture's height: a person who would be smaller is followed
BODY = 1.7
LOWEST = 0.15  # metres above the floor
NEAREST = 0.7  # metres from the lens to any landmark


@dataclass(frozen=True)
class Camera:
    """rotation [F, 3, 3] world to camera axes, position [F, 3] world; the rest in pixels."""

    rotation: np.ndarray
    position: np.ndarray
    width: int
    height: int
    focal: float

    @property
    def field_of_view(self) -> float:
        """Vertical, degrees."""
        return float(np.degrees(2 * np.arctan(self.height / 2 / self.focal)))

    def to_camera(self, points: np.ndarray) -> np.ndarray:
        """World points [F, K, 3] → camera axes, from the lens; z is negative before it."""
        return np.einsum("fij,fkj->fki", self.rotation, points - self.position[:, None])

    def project(self, points: np.ndarray) -> np.ndarray:
        """World points [F, K, 3] → pixels [F, K, 2], origin top left."""
        x, y, z = np.moveaxis(self.to_camera(points), -1, 0)
        middle = (self.width / 2, self.height / 2)
        pixels = (middle[0] + self.focal * x / -z, middle[1] - self.focal * y / -z)
        return np.stack(pixels, axis=-1)

    def matrices(self) -> np.ndarray:
        """Camera to world, [F, 4, 4]."""
        matrix = np.broadcast_to(np.eye(4), (len(self.position), 4, 4)).copy()
        matrix[:, :3, :3] = self.rotation.transpose(0, 2, 1)
        matrix[:, :3, 3] = self.position
        return matrix


def draw_camera(rng: np.random.Generator, landmarks: np.ndarray) -> Camera:
    """A camera that sees the person of landmarks [F, 33, 3]: any side, 20° below to 35° above.

    It stands still, sways in a hand, goes round, or follows; one in eight cuts a part of the body.
    """
    frames = len(landmarks)
    width, height = SIZES[rng.integers(len(SIZES))]
    half = np.radians(np.exp(rng.uniform(np.log(24), np.log(66)))) / 2
    focal = height / 2 / np.tan(half)
    fill = rng.uniform(1.1, 1.5) if rng.random() < 1 / 8 else rng.uniform(0.68, 0.97)
    progress = np.linspace(-0.5, 0.5, frames)
    yaw = rng.uniform(-np.pi, np.pi) + (rng.random() < 0.4) * rng.uniform(-0.7, 0.7) * progress
    pitch = np.radians(rng.uniform(-8, 16) + (rng.random() < 0.25) * rng.uniform(0, 20))
    sway = rng.choice([0.0, 0.4, 1.2])
    angles = np.stack(
        [
            np.radians(2.0 * rng.standard_normal() + sway * _wander(rng, frames)),
            pitch + np.radians(sway * _wander(rng, frames)),
            -yaw + np.radians(sway * _wander(rng, frames)),
        ],
        axis=-1,
    )
    rotation = euler(angles, "zxy")
    centre = (landmarks.min(axis=1) + landmarks.max(axis=1)) / 2
    still = np.broadcast_to((centre.min(axis=0) + centre.max(axis=0)) / 2, centre.shape)
    spread = rng.uniform(8, 30)
    follow = gaussian_filter1d(centre, spread, axis=0, mode="nearest")
    limits = fill * np.array([width, height]) / 2 / focal
    farthest = BODY / (2 * np.tan(half) * SMALLEST)
    target, distance = still, _distance(rotation, still, landmarks, limits)
    if distance > farthest or rng.random() < 0.15:
        target, distance = follow, _distance(rotation, follow, landmarks, limits)
    distance = distance * (1 + (rng.random() < 0.2) * rng.uniform(0, 0.25) * (progress + 0.5))
    back = rotation[:, 2]
    position = target + back * np.reshape(distance, (-1, 1))
    position[:, 1] = np.maximum(position[:, 1], LOWEST)
    return Camera(rotation, position, width, height, float(focal))


def _wander(rng: np.random.Generator, frames: int) -> np.ndarray:
    """A smooth random course of unit variance, [F]."""
    course = gaussian_filter1d(rng.standard_normal(frames + 120), 12)[60 : 60 + frames]
    return course / 0.153


def _distance(
    rotation: np.ndarray, target: np.ndarray, landmarks: np.ndarray, limits: np.ndarray
) -> float:
    """Least distance from the target at which all landmarks lie within `limits` [2] of the axis.

    limits are tangents of the half angles to the right and upwards.
    """
    seen = np.einsum("fij,fkj->fki", rotation, landmarks - target[:, None])
    needed = np.abs(seen[..., :2]) / limits + seen[..., 2:]
    # A stray hand of one frame in fifty may leave the picture.
    least = np.quantile(needed.max(axis=(1, 2)), 0.98)
    return float(max(least, seen[..., 2].max() + NEAREST))

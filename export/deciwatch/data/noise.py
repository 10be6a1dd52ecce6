"""A first model of a pose estimator's errors, made up of parts and scaled window by window.

All sizes are metres on a body 1.7 m tall, root mean square length of the error vector of a joint
at severity 1. In 2D the same sizes are taken as fractions of the body's box.
"""

from dataclasses import dataclass

import numpy as np

from deciwatch.skeleton import (
    ARMS,
    HEAD,
    INDEX,
    KEYPOINTS,
    LEFT_ARM,
    LEFT_LEG,
    LEGS,
    MIRROR,
    RIGHT_ARM,
    RIGHT_LEG,
    TORSO,
    mid_hip,
)

BODY_HEIGHT = 1.7
_GROUPS = (HEAD, LEFT_ARM, RIGHT_ARM, LEFT_LEG, RIGHT_LEG, TORSO)
# Lengths of an error along x, y and depth; depth is about twice as hard to see.
_AXES = {3: np.array([1.0, 1.0, 2.0]) / np.sqrt(6.0), 2: np.ones(2) / np.sqrt(2.0)}


def _jitter_sizes() -> np.ndarray:
    """15 mm at the trunk to 45 mm at hands and feet, [33]."""
    sizes = np.full(KEYPOINTS, 0.025)
    sizes[TORSO] = 0.015
    for names, size in (
        (("elbow", "knee"), 0.030),
        (("wrist", "ankle"), 0.038),
        (("pinky", "index", "thumb", "heel", "foot_index"), 0.045),
    ):
        for name in names:
            sizes[[INDEX[f"left_{name}"], INDEX[f"right_{name}"]]] = size
    return sizes


JITTER = _jitter_sizes()


@dataclass(frozen=True)
class Noise:
    """How strong each part is; every number at severity 1."""

    jitter: float = 1.0  # × JITTER, anew at each sample
    bias: float = 0.020  # metres, constant through a window, half of it shared by a limb
    slow: float = 0.012  # metres, drifting with periods of half a second to four
    tilt: float = 3.0  # degrees, 3D only: the whole body leaning to or from the camera
    stretch: float = 0.03  # the whole body too large or small
    outlier_rate: float = 0.03  # of joint samples
    outlier: float = 0.150  # metres
    swap_rate: float = 0.015  # of samples: left and right exchanged, of the body, arms or legs
    # Severities are drawn per window and part, log-uniform in this range; (1, 1) is nominal.
    severity: tuple[float, float] = (0.1, 3.0)


NOMINAL = Noise(severity=(1.0, 1.0))
TRAINING = Noise()
NONE = Noise(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, (1.0, 1.0))


def body_unit(truth: np.ndarray) -> np.ndarray:
    """Size of one metre of noise, [B, 1, 1, 1]: 1 in 3D; in 2D the window's mean box over 1.7 m."""
    if truth.shape[-1] == 3:
        return np.ones((len(truth), 1, 1, 1))
    size = np.ptp(truth, axis=2).max(axis=-1).mean(axis=1)
    return size[:, None, None, None] / BODY_HEIGHT


def add_noise(
    rng: np.random.Generator, truth: np.ndarray, times: np.ndarray, noise: Noise = TRAINING
) -> np.ndarray:
    """Estimates for true poses [B, S, 33, D] at times [B, S] in seconds; same shape, float32.

    3D poses come back relative to their own, noisy, mid-hip, as an estimator gives them.
    """
    batch, samples, keypoints, dims = truth.shape
    axes = _AXES[dims]

    def severity(spread: float = 1.0) -> np.ndarray:
        low, high = np.log(noise.severity)
        return np.exp(spread * rng.uniform(low, high, size=(batch, 1, 1, 1)))

    def normal(*shape: int) -> np.ndarray:
        return rng.standard_normal(shape, dtype=np.float32)

    error = noise.jitter * severity() * JITTER[:, None] * axes * normal(*truth.shape)
    error += noise.bias * severity() * axes * _by_limb(normal, batch, dims)
    error += noise.slow * severity() * axes * _drift(rng, times, dims)
    far = rng.random((batch, samples, keypoints, 1)) < noise.outlier_rate * severity(0.7)
    error += far * noise.outlier * axes * normal(*truth.shape)
    unit = body_unit(truth)
    swapped = _swap(rng, truth, noise.swap_rate * severity(0.7)[:, :, 0, 0])
    estimate = _distort(rng, swapped, noise, severity()) + unit * error
    if dims == 3:
        estimate = estimate - mid_hip(estimate)
    return estimate.astype(np.float32)


def _by_limb(normal, batch: int, dims: int) -> np.ndarray:
    """Constant errors of unit variance, [B, 1, 33, D], half of it common to each limb."""
    own, shared = normal(batch, 1, KEYPOINTS, dims), np.empty((batch, 1, KEYPOINTS, dims))
    for group in _GROUPS:
        shared[:, :, group] = normal(batch, 1, 1, dims)
    return np.sqrt(0.5) * (own + shared)


def _drift(rng: np.random.Generator, times: np.ndarray, dims: int) -> np.ndarray:
    """Errors of unit variance that wander with time, [B, S, 33, D]: one sinusoid each."""
    shape = (len(times), 1, KEYPOINTS, dims)
    period = np.exp(rng.uniform(np.log(0.5), np.log(4.0), size=shape)).astype(np.float32)
    phase = rng.uniform(0, 2 * np.pi, size=shape).astype(np.float32)
    moment = times[:, :, None, None].astype(np.float32)
    return np.sqrt(2.0) * np.sin(2 * np.pi * moment / period + phase)


def _swap(rng: np.random.Generator, poses: np.ndarray, rate: np.ndarray) -> np.ndarray:
    """Exchange left and right labels in a share `rate` [B, 1] of the samples."""
    chosen = rng.random(poses.shape[:2]) < rate
    if not chosen.any():
        return poses
    poses = poses.copy()
    for window, sample in np.argwhere(chosen):
        part = (np.arange(KEYPOINTS), ARMS, LEGS)[rng.integers(3)]
        poses[window, sample, part] = poses[window, sample, MIRROR[part]]
    return poses


def _distort(
    rng: np.random.Generator, poses: np.ndarray, noise: Noise, severity: np.ndarray
) -> np.ndarray:
    """Tilt (3D) and stretch about each sample's mid-hip, the same through a window."""
    batch, dims = len(poses), poses.shape[-1]
    centre = mid_hip(poses)
    shape = (batch, 1, 1)
    stretch = 1 + noise.stretch * severity * rng.standard_normal((batch, 1, 1, 1))
    relative = (poses - centre) * stretch.clip(0.7, 1.3)
    angle = np.radians(noise.tilt) * severity[..., 0] * rng.standard_normal(shape)
    if dims == 3:
        x, y, z = np.moveaxis(relative, -1, 0)
        sine, cosine = np.sin(angle), np.cos(angle)
        relative = np.stack([x, cosine * y - sine * z, sine * y + cosine * z], axis=-1)
    return centre + relative

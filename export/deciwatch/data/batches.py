"""Training batches: windows of random length, interval, frame rate, camera and noise."""

from dataclasses import dataclass

import numpy as np

from deciwatch.data.augment import augment, draw_speeds
from deciwatch.data.camera import draw_views
from deciwatch.data.noise import TRAINING, Noise, add_noise
from deciwatch.data.windows import choose, resample
from deciwatch.motion.motions import Motions
from deciwatch.normalise import frame_of, to_net

TIME_UNIT = 1.0 / 30.0  # seconds; the nets' times count these
INTERVALS = (1, 20)  # range of N
WINDOWS = (1, 10)  # range of Q
FRAME_RATES = np.array([15.0, 20.0, 24.0, 25.0, 30.0, 50.0, 60.0])
LONGEST = 7.0  # seconds; few recordings are longer
MOST_WINDOWS = 64


@dataclass(frozen=True)
class Batch:
    """B windows in net values. Times are in units of TIME_UNIT from the window's first sample.

    sampled, clean: [B, S, K·D] estimate and truth. poses: [B, T, K·D] truth.
    sample_times: [B, S]. frame_times: [B, T]. unit: [B] size of 1 in metres or pixels.
    """

    sampled: np.ndarray
    clean: np.ndarray
    poses: np.ndarray
    sample_times: np.ndarray
    frame_times: np.ndarray
    unit: np.ndarray


def draw_lengths(rng: np.random.Generator) -> tuple[int, int]:
    """N and Q of a batch: half of them near the paper's N = 10, most with its Q = 10."""
    interval = int(rng.integers(8, 13) if rng.random() < 0.5 else rng.integers(1, 21))
    intervals = int(WINDOWS[1] if rng.random() < 0.6 else rng.integers(1, 11))
    return interval, intervals


def draw_frame_times(rng: np.random.Generator, batch: int, frames: int) -> np.ndarray:
    """Times [B, T] in units, at rates of 15 to 60 a second, one in ten a little uneven."""
    allowed = FRAME_RATES[
        np.minimum((frames - 1) / FRAME_RATES, LONGEST) == (frames - 1) / FRAME_RATES
    ]
    rates = rng.choice(allowed if len(allowed) else FRAME_RATES[-1:], size=batch)
    if 30.0 in allowed:
        rates = np.where(rng.random(batch) < 0.6, 30.0, rates)
    step = 30.0 / rates[:, None]
    times = step * np.arange(frames)
    uneven = rng.random((batch, 1)) < 0.1
    shift = uneven * step * rng.uniform(-0.3, 0.3, size=times.shape)
    shift[:, 0] = 0.0
    return times + shift


def keep_samples(rng: np.random.Generator, interval: int, intervals: int) -> np.ndarray:
    """Indices [S] of the watched frames; in three batches of ten some inner ones are missing."""
    watched = np.arange(intervals + 1) * interval
    if rng.random() < 0.3:
        kept = rng.random(len(watched)) >= rng.uniform(0.05, 0.3)
        kept[[0, -1]] = True
        watched = watched[kept]
    return watched


def build(
    rng: np.random.Generator,
    world: np.ndarray,
    times: np.ndarray,
    watched: np.ndarray,
    dims: int,
    noise: Noise,
) -> Batch:
    """A batch from world landmarks [B, T, 33, 3] at times [B, T] in units."""
    views = draw_views(rng, world)
    truth = views.poses3d(world) if dims == 3 else views.poses2d(world)
    sample_times = times[:, watched]
    estimate = add_noise(rng, truth[:, watched], sample_times * TIME_UNIT, noise)
    origin, unit = frame_of(estimate)
    poses = to_net(truth, origin, unit)
    return Batch(
        sampled=to_net(estimate, origin, unit),
        clean=poses[:, watched],
        poses=poses,
        sample_times=sample_times.astype(np.float32),
        frame_times=times.astype(np.float32),
        unit=unit.reshape(-1).astype(np.float32),
    )


def training_batch(
    rng: np.random.Generator,
    motions: Motions,
    dims: int,
    sparse: bool = False,
    budget: int = 1616,
    noise: Noise = TRAINING,
) -> Batch:
    """A batch of about `budget` frames in all: short windows come in greater numbers.

    `sparse` leaves out the frames that are not watched, so that T = S, and makes more windows.
    """
    interval, intervals = draw_lengths(rng)
    frames = interval * intervals + 1
    size = MOST_WINDOWS if sparse else int(np.clip(budget // frames, 8, MOST_WINDOWS))
    times = draw_frame_times(rng, size, frames)
    watched = keep_samples(rng, interval, intervals)
    if sparse:
        times, watched = times[:, watched], np.arange(len(watched))
    speed = draw_speeds(rng, size)
    recorded = motions.fps * TIME_UNIT
    sequence, first, span = choose(rng, motions, times[:, -1] * recorded * speed)
    places = first[:, None] + times * (span / times[:, -1])[:, None]
    world = augment(rng, resample(motions, sequence, places))
    return build(rng, world, times, watched, dims, noise)

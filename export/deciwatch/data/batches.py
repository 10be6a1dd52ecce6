"""Training batches: windows of random length, interval, frame rate, camera and noise."""

import numpy as np

from deciwatch.data.augment import augment, draw_speeds, graft
from deciwatch.data.batch import Batch, Windows, normalised
from deciwatch.data.camera import draw_views
from deciwatch.data.noise import TRAINING, Noise, add_noise
from deciwatch.data.places import few_places
from deciwatch.data.residuals import ResidualNoise
from deciwatch.data.windows import choose, resample
from deciwatch.motion.motions import Motions

TIME_UNIT = 1.0 / 30.0  # seconds; the nets' times count these
INTERVALS = (1, 20)  # range of N
WINDOWS = (1, 10)  # range of Q
FRAME_RATES = np.array([15.0, 20.0, 24.0, 25.0, 30.0, 50.0, 60.0])
LONGEST = 7.0  # seconds; few recordings are longer
MOST_WINDOWS = 64

# Made-up errors of one representation, or a fitted model of an estimator's.
Estimator = Noise | ResidualNoise


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
    inputs: tuple[str, ...],
    estimator: Estimator,
    scored: np.ndarray | None = None,
) -> Batch:
    """A batch from world landmarks [B, L, 33, 3] at times [B, L] in units, ascending.

    watched: the samples, [S] or [B, S] of the L. scored: the frames, [B, T] of them, else all.
    """
    views = draw_views(rng, world, times)
    watched = np.broadcast_to(watched, (len(world), watched.shape[-1]))
    sample_times = pick(times, watched)
    own = inputs[0]
    truth = {own: views.poses3d(world) if own == "3d" else views.poses2d(world)}
    clean = {own: pick(truth[own], watched)}
    if isinstance(estimator, Noise):
        estimates = {own: add_noise(rng, clean[own], sample_times * TIME_UNIT, estimator)}
    else:
        other = "2d" if own == "3d" else "3d"
        clean[other] = pick(views.poses2d(world) if own == "3d" else views.poses3d(world), watched)
        estimates = estimator.draw(rng, clean["3d"], clean["2d"], sample_times * TIME_UNIT)
    windows = Windows(
        estimates=estimates,
        clean=clean[own],
        poses=truth[own] if scored is None else pick(truth[own], scored),
        sample_times=sample_times,
        frame_times=times if scored is None else pick(times, scored),
    )
    return normalised(windows, inputs)


def pick(values: np.ndarray, places: np.ndarray) -> np.ndarray:
    """values [B, L, ...] at places [B, N] of the L → [B, N, ...]."""
    return values[np.arange(len(values))[:, None], places]


def training_batch(
    rng: np.random.Generator,
    motions: Motions,
    inputs: tuple[str, ...],
    sparse: bool = False,
    budget: int = 1616,
    estimator: Estimator = TRAINING,
    few: bool = False,
    grafted: bool = False,
) -> Batch:
    """A batch of about `budget` frames in all: short windows come in greater numbers.

    `sparse` leaves out the frames that are not watched, so that T = S, and makes more windows;
    `few` scores random frames of each gap, which nets with tokens for the samples need no more.
    `grafted` gives some people the legs of others.
    """
    interval, intervals = draw_lengths(rng)
    frames = interval * intervals + 1
    size = MOST_WINDOWS if sparse or few else int(np.clip(budget // frames, 8, MOST_WINDOWS))
    times = draw_frame_times(rng, size, frames)
    watched, scored = keep_samples(rng, interval, intervals), None
    if few:
        times, watched, scored = _among(times[:, watched], rng)
    elif sparse:
        times, watched = times[:, watched], np.arange(len(watched))
    speed = draw_speeds(rng, size)
    recorded = motions.fps * TIME_UNIT
    sequence, first, span = choose(rng, motions, times[:, -1] * recorded * speed)
    backwards = rng.random((size, 1)) < 0.5
    ahead = np.where(backwards, times[:, -1:] - times, times)
    places = first[:, None] + ahead * (span / times[:, -1])[:, None]
    world = resample(motions, sequence, places)
    world = augment(rng, graft(rng, world) if grafted else world)
    return build(rng, world, times, watched, inputs, estimator, scored)


def _among(
    sample_times: np.ndarray, rng: np.random.Generator
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Samples [B, S] and random times between them: all in order, places of both in that order."""
    together = np.concatenate([sample_times, few_places(rng, sample_times, whole=False)], axis=1)
    order = np.argsort(together, axis=1, kind="stable")
    ranks = np.argsort(order, axis=1)
    samples = sample_times.shape[1]
    return np.take_along_axis(together, order, 1), ranks[:, :samples], ranks[:, samples:]

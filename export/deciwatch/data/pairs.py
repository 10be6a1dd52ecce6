"""Training windows from sequences in camera axes, with a real estimator's poses or made-up ones."""

from functools import lru_cache

import numpy as np

from deciwatch.data.batch import Batch, Windows, normalised
from deciwatch.data.batches import MOST_WINDOWS, TIME_UNIT, draw_lengths
from deciwatch.data.pair_augment import augment_windows, disturb
from deciwatch.data.places import even_places, few_places, thin
from deciwatch.data.residuals import ResidualNoise
from deciwatch.data.training_pairs import Pairs
from deciwatch.data.windows import between_frames

REGULAR = 0.7  # share of windows whose samples are evenly spaced


def pair_batch(
    rng: np.random.Generator,
    pairs: Pairs,
    inputs: tuple[str, ...],
    few: bool,
    sparse: bool = False,
    budget: int = 1616,
    noise: ResidualNoise | None = None,
) -> Batch:
    """A batch of windows of any N and Q, augmented; of about `budget` frames where all count.

    The estimates are those of the pairs, or made from the truth by `noise`. With `few` the scored
    frames are some random ones of each gap; otherwise they are even and N · Q + 1. `sparse` scores
    the samples alone.
    """
    interval, intervals = draw_lengths(rng)
    size = MOST_WINDOWS
    if not few and not sparse:
        size = int(np.clip(budget // (interval * intervals + 1), 8, MOST_WINDOWS))
    rows = thin(rng, draw_rows(rng, pairs, interval, intervals, size))
    places = pairs.seen[rows].astype(float)
    if sparse:
        frames = places
    elif few:
        frames = few_places(rng, places, whole=True)
    else:
        frames = even_places(places, interval * intervals + 1)
    windows = augment_windows(rng, _cut(rng, pairs, inputs, rows, frames, noise))
    return disturb(rng, normalised(windows, inputs), inputs)


def draw_rows(
    rng: np.random.Generator, pairs: Pairs, interval: int, intervals: int, size: int
) -> np.ndarray:
    """Samples of `size` windows, as places [B, S] in `pairs.seen`, ascending and about N apart.

    Sequences are estimated at every few frames only, so that a window's samples are either even,
    at the nearest multiple of its sequence's stride, or uneven and N apart on average. A sequence
    with room for a window is drawn so often that in the long run every estimate is seen alike:
    were it as likely as it has room, a few long ones would be most of what is seen. Where no
    sequence has room for so many intervals there are fewer.
    """
    exact = np.maximum(interval / pairs.stride, 1.0)
    # Rounded up as often as it takes to be N apart on average.
    even = np.maximum(np.floor(exact + rng.random(len(exact))), 1.0)
    steps = np.stack([exact, even])
    while True:
        room = np.maximum(pairs.count - np.ceil(intervals * steps), 0.0)
        if intervals == 1 or room.all(axis=0).any() or room.any(axis=1).all():
            break
        intervals -= 1
    weight = _weights(pairs)
    kind = (rng.random(size) < REGULAR).astype(int)
    cumulative = np.cumsum(np.where(room > 0, weight, 0.0), axis=1)
    drawn = rng.random(size) * cumulative[kind, -1]
    sequence = (cumulative[kind] <= drawn[:, None]).sum(axis=1).clip(max=len(exact) - 1)
    begin = pairs.first[sequence] + np.floor(rng.random(size) * room[kind, sequence])
    offsets = np.rint(np.arange(intervals + 1) * steps[kind, sequence][:, None])
    return (begin[:, None] + offsets).astype(np.int64)


@lru_cache(maxsize=4)
def _weights(pairs: Pairs) -> np.ndarray:
    """Estimates of each sequence over the share of drawn lengths that it has room for, [n]."""
    rng = np.random.default_rng(0)
    drawn = np.array([draw_lengths(rng) for _ in range(500)])
    needed = drawn[:, 1] * np.ceil(drawn[:, 0] / pairs.stride[:, None])
    share = (pairs.count[:, None] > needed).mean(axis=1)
    # Sequences with room for hardly any window are not made up for.
    return pairs.count / np.maximum(share, 0.1)


def _cut(
    rng: np.random.Generator,
    pairs: Pairs,
    inputs: tuple[str, ...],
    rows: np.ndarray,
    frames: np.ndarray,
    noise: ResidualNoise | None,
) -> Windows:
    """The windows with samples at `rows` [B, S] of `seen`, scored at `frames` [B, T]."""
    sampled = pairs.seen[rows]
    sequence = np.searchsorted(pairs.start, sampled[:, 0], side="right") - 1
    first = pairs.start[sequence][:, None]
    last = first + pairs.length[sequence][:, None] - 1
    rate = (1 / (TIME_UNIT * pairs.fps[sequence]))[:, None]
    sample_times = (sampled - sampled[:, :1]) * rate
    if noise is None:
        estimates = {name: pairs.estimates[name][rows] for name in inputs}
    else:
        clean = (pairs.truth[name][sampled] for name in ("3d", "2d"))
        estimates = noise.draw(rng, *clean, sample_times * TIME_UNIT)
    truth = pairs.truth[inputs[0]]
    whole = frames.astype(np.int64)
    poses = truth[whole] if (whole == frames).all() else between_frames(truth, frames, first, last)
    return Windows(
        estimates=estimates,
        clean=truth[sampled],
        poses=poses,
        sample_times=sample_times,
        frame_times=(frames - sampled[:, :1]) * rate,
    )

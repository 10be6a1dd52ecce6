"""Ways to choose the watched frames of a sequence, all with as many looks as one frame in N takes.

The paper's schemes ("Impact of sampling strategies"): uniform, uniform in groups of two or three
neighbouring frames (U.-2, U.-3), half uniform and half random (U.-R.), random (R.).
"""

from collections.abc import Callable

import numpy as np

from deciwatch.sampling.watched import watched_frames

# (generator, frame_count T, N) → watched frames [W], ascending, the first and the last among them.
Scheme = Callable[[np.random.Generator, int, int], np.ndarray]


def uniform(rng: np.random.Generator, frame_count: int, every: int) -> np.ndarray:
    """One frame in N, as the page watches."""
    return watched_frames(frame_count, every)


def clustered(size: int) -> Scheme:
    """`size` neighbouring frames at a time, the groups as far apart as the budget allows."""

    def scheme(rng: np.random.Generator, frame_count: int, every: int) -> np.ndarray:
        budget = len(watched_frames(frame_count, every))
        groups = max(2, -(-budget // size))
        # The last frame is its group's last, so that the whole sequence lies between samples.
        sizes = np.diff(np.linspace(0, budget, groups + 1).round().astype(int))
        ends = frame_count - sizes[-1]
        starts = np.linspace(0, ends, groups).round().astype(int)
        frames = [start + np.arange(count) for start, count in zip(starts, sizes, strict=True)]
        return np.unique(np.concatenate(frames))

    return scheme


def random(rng: np.random.Generator, frame_count: int, every: int) -> np.ndarray:
    """The first, the last, and any frames between."""
    ends = np.unique([0, frame_count - 1])
    return _with_random(rng, ends, frame_count, len(watched_frames(frame_count, every)))


def half_random(rng: np.random.Generator, frame_count: int, every: int) -> np.ndarray:
    """One frame in 2 N, and as many again at random."""
    budget = len(watched_frames(frame_count, every))
    return _with_random(rng, watched_frames(frame_count, 2 * every), frame_count, budget)


SCHEMES: dict[str, Scheme] = {
    "uniform": uniform,
    "uniform_2": clustered(2),
    "uniform_3": clustered(3),
    "half_random": half_random,
    "random": random,
}
BY_CHANCE = ("half_random", "random")


def _with_random(
    rng: np.random.Generator, chosen: np.ndarray, frame_count: int, budget: int
) -> np.ndarray:
    others = np.setdiff1d(np.arange(frame_count), chosen)
    drawn = rng.choice(others, size=budget - len(chosen), replace=False)
    return np.sort(np.concatenate([chosen, drawn]))

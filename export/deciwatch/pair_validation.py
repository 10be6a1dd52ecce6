"""Validation on a pair file: windows of a real estimator's poses at N = 10."""

from collections import defaultdict

import numpy as np

from deciwatch.data.batch import Batch, Windows, normalised
from deciwatch.data.batches import TIME_UNIT
from deciwatch.data.training_pairs import Pairs
from deciwatch.errors import UserError
from deciwatch.validation import INTERVAL, WINDOW, Validation, with_lines

BEGIN_EVERY = 25  # frames from one window's begin to the next one's
NEAR = 2  # frames that a sample may lie off its place where its own frame has no estimate


def pair_validation(pairs: Pairs, inputs: tuple[str, ...], source: str) -> Validation:
    """Every window of a file, scored at all of its frames. `source` names the file in errors.

    A sequence that does not fill a window is one shorter window.

    In a sparse file a sample is the nearest estimate to its place; one that has none near, or in
    which nobody was seen, is left out, as it happens live.
    """
    grouped: dict[tuple[int, int], list[Windows]] = defaultdict(list)
    for index in range(len(pairs.start)):
        last = max(int(pairs.length[index]) - INTERVAL * WINDOW, 1)
        for begin in range(0, last, BEGIN_EVERY):
            rows = _samples(pairs, index, begin)
            if len(rows) > 1:
                window = _window(pairs, inputs, index, rows)
                grouped[window.clean.shape[1], window.poses.shape[1]].append(window)
    if not grouped:
        raise UserError(f"No sequence of {source} has two estimates {INTERVAL} frames apart.")
    batches = [_together(windows, inputs) for _, windows in sorted(grouped.items())]
    own = inputs[0]
    return with_lines(own, batches, every_frame=_every_frame(pairs, own))


def _samples(pairs: Pairs, index: int, begin: int) -> np.ndarray:
    """Places in `seen` of the window's samples, ascending."""
    wanted = pairs.start[index] + begin + np.arange(WINDOW + 1) * INTERVAL
    wanted = wanted[wanted < pairs.start[index] + pairs.length[index]]
    low = pairs.first[index]
    seen = pairs.seen[low : low + pairs.count[index]]
    if not len(seen):
        return seen
    off = np.abs(seen[None] - wanted[:, None])
    nearest = off.argmin(axis=1)
    return low + np.unique(nearest[off.min(axis=1) <= NEAR])


def _window(pairs: Pairs, inputs: tuple[str, ...], index: int, rows: np.ndarray) -> Windows:
    sampled = pairs.seen[rows]
    frames = np.arange(sampled[0], sampled[-1] + 1)
    rate = 1 / (TIME_UNIT * pairs.fps[index])
    truth = pairs.truth[inputs[0]]
    return Windows(
        estimates={name: pairs.estimates[name][rows][None] for name in inputs},
        clean=truth[sampled][None],
        poses=truth[frames][None],
        sample_times=(sampled - sampled[0])[None] * rate,
        frame_times=(frames - sampled[0])[None] * rate,
    )


def _together(windows: list[Windows], inputs: tuple[str, ...]) -> Batch:
    def stack(name: str) -> np.ndarray:
        return np.concatenate([getattr(window, name) for window in windows])

    return normalised(
        Windows(
            estimates={
                name: np.concatenate([window.estimates[name] for window in windows])
                for name in inputs
            },
            **{name: stack(name) for name in ("clean", "poses", "sample_times", "frame_times")},
        ),
        inputs,
    )


def _every_frame(pairs: Pairs, own: str) -> dict[str, float]:
    """Error of the estimates themselves; acceleration where three frames running have one."""
    factor = 1000 if own == "3d" else 1
    off = factor * (pairs.estimates[own] - pairs.truth[own][pairs.seen])
    found = {"position": float(np.linalg.norm(off, axis=-1).mean())}
    sequence = np.searchsorted(pairs.start, pairs.seen, side="right")
    running = np.flatnonzero(
        (pairs.seen[2:] - pairs.seen[:-2] == 2) & (sequence[2:] == sequence[:-2])
    )
    if len(running):
        accel = off[running] - 2 * off[running + 1] + off[running + 2]
        found["accel"] = float(np.linalg.norm(accel, axis=-1).mean())
    return found

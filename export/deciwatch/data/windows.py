"""Cutting windows out of recorded motion, at any frame rate and speed."""

import numpy as np

from deciwatch.motion.motions import Motions

# A window may start anywhere, so long sequences offer more starts. The cap keeps the few very long
# ones (minutes of climbing) from being most of what is seen.
MOST_STARTS = 240.0


def choose(rng: np.random.Generator, motions: Motions, spans: np.ndarray) -> tuple:
    """Draw a place for windows of `spans` [B] recorded frames.

    Returns (sequence [B], first [B], span [B]); first is a fractional frame within its sequence.
    A span longer than every sequence is cut to the longest, which slows that window down.
    """
    room = motions.length - 1.0
    spans = np.minimum(spans, room.max())
    starts = np.clip(room[None] - spans[:, None], -1.0, MOST_STARTS) + 1.0
    cumulative = np.cumsum(np.maximum(starts, 0.0), axis=1)
    drawn = rng.random(len(spans)) * cumulative[:, -1]
    sequence = (cumulative <= drawn[:, None]).sum(axis=1).clip(max=len(room) - 1)
    first = rng.random(len(spans)) * np.maximum(room[sequence] - spans, 0.0)
    return sequence, first, spans


def resample(motions: Motions, sequence: np.ndarray, frames: np.ndarray) -> np.ndarray:
    """Landmarks [B, T, 33, 3] at fractional `frames` [B, T] of sequences [B]."""
    first = motions.start[sequence][:, None]
    last = first + motions.length[sequence][:, None] - 1
    return between_frames(motions.landmarks, first + frames, first, last)


def between_frames(
    values: np.ndarray, frames: np.ndarray, first: np.ndarray, last: np.ndarray
) -> np.ndarray:
    """Values [F, K, D] at fractional `frames` [B, T], none taken outside first to last [B, 1].

    Catmull-Rom between the recorded frames: a linear blend would pull fast limbs towards chords.
    """
    frames = np.clip(frames, first, last)
    left = np.minimum(np.floor(frames).astype(np.int64), np.maximum(last - 1, first))
    u = (frames - left).astype(np.float32)[..., None, None]
    p0, p1, p2, p3 = (values[np.clip(left + offset, first, last)] for offset in (-1, 0, 1, 2))
    cubic = 2 * p0 - 5 * p1 + 4 * p2 - p3 + u * (3 * (p1 - p2) + p3 - p0)
    return p1 + 0.5 * u * (p2 - p0 + u * cubic)


def slices(motions: Motions, interval: int, intervals: int, stride: int | None = None) -> list:
    """(sequence, first frame) of windows of interval·intervals+1 frames, as the paper slices them.

    Neighbours share one frame (the last of one is the first of the next) unless `stride` says
    otherwise; what does not fill a window is left over.
    """
    step = stride or interval * intervals
    span = interval * intervals
    return [
        (index, first)
        for index, length in enumerate(motions.length)
        for first in range(0, int(length) - span, step)
    ]

"""Fixture of how a clip is sampled, cut and stitched, by this package's own sampling/.

The web's `sampling/` is a second implementation; the fixture holds the two together.
"""

import numpy as np

from deciwatch.sampling.segments import split_segments
from deciwatch.sampling.stitcher import Stitcher
from deciwatch.sampling.watched import watched_frames
from deciwatch.sampling.windows import cut_windows

# Frames, N, frames a second, least share of watched frames in which nobody is seen.
CASES = (
    (231, 10, 30.0, 0.0),
    (302, 10, 30.0, 0.3),
    (97, 20, 24.0, 0.2),
    (120, 1, 60.0, 0.6),
    (90, 3, 15.0, 0.4),
    (45, 7, 30.0, 0.8),
    (1, 10, 30.0, 0.0),
)
VALUES = 2


def stitching_cases(seed: int) -> dict:
    """Clips of T frames at `times`, some watched frames without anybody.

    Window w gives frame t the values [w, t + w / 2]; `stitched` is T·2 of them, null where no
    window reaches.
    """
    rng = np.random.default_rng(seed)
    return {"cases": [_case(rng, *case) for case in CASES]}


def _case(rng: np.random.Generator, frames: int, every: int, fps: float, missing: float) -> dict:
    times = np.round(np.arange(frames) / fps, 9)
    watched = watched_frames(frames, every)
    seen = watched[_present(rng, len(watched), missing)]
    windows = cut_windows(seen, times, every)
    stitcher = Stitcher(frames, (VALUES,))
    for number, window in enumerate(windows):
        at = np.arange(window.first_frame, window.last_frame + 1)
        stitcher.add(window, np.stack([np.full(len(at), number), at + number / 2], axis=1))
    stitched = np.round(stitcher.finish().astype(float).ravel(), 4)
    return {
        "every": every,
        "times": times.tolist(),
        "watched": watched.tolist(),
        "seen": seen.tolist(),
        "segments": split_segments(seen, times, every),
        "windows": [list(window) for window in windows],
        "stitched": [None if np.isnan(x) else x for x in stitched.tolist()],
    }


def _present(rng: np.random.Generator, count: int, missing: float) -> np.ndarray:
    """Which of `count` samples somebody is seen in, [count]; absences last a few samples."""
    present = np.ones(count, bool)
    while missing and (~present).mean() < missing:
        first = rng.integers(count)
        present[first : first + rng.integers(1, 6)] = False
    return present

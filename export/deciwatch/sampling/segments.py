"""Splitting samples where nobody was seen for too long; the same as `web/sampling/segments.ts`."""

from itertools import pairwise

import numpy as np

MAX_MISSING_SAMPLES = 2  # in a row, and then only over
MAX_GAP_SECONDS = 1.5
SHORT_GAP_SECONDS = 0.7  # bridged however many samples are missing


def split_segments(seen: np.ndarray, times: np.ndarray, every: int) -> list[tuple[int, int]]:
    """Ranges [start, end) of positions in `seen`, in order, none empty.

    seen: [W] frames with an estimate, ascending. times: [T] seconds of all frames. every: N.
    """
    if not len(seen):
        return []
    steps, gaps = np.diff(seen), np.diff(times[seen])
    # Rounded up, because a sequence's last sample may come after less than a whole interval.
    missing = -(-steps // every) - 1
    few = (missing <= MAX_MISSING_SAMPLES) & (gaps <= MAX_GAP_SECONDS)
    bridged = (missing == 0) | (gaps <= SHORT_GAP_SECONDS) | few
    cuts = [0, *(np.flatnonzero(~bridged) + 1).tolist(), len(seen)]
    return list(pairwise(cuts))

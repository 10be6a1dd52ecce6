"""Cutting samples into overlapping windows; the same as `web/sampling/windows.ts`."""

from typing import NamedTuple

import numpy as np

from deciwatch.sampling.segments import split_segments

WINDOW_INTERVALS = 10  # Q of a full window
WINDOW_STRIDE = 5  # intervals from one window's start to the next one's


class Window(NamedTuple):
    """What the nets take at once: `samples` samples from position `first` in the seen ones.

    first_frame and last_frame are those of its first and last sample; all frames between are
    recovered.
    """

    first: int
    samples: int
    first_frame: int
    last_frame: int

    @property
    def frames(self) -> int:
        """T of the window."""
        return self.last_frame - self.first_frame + 1


def cut_windows(
    seen: np.ndarray, times: np.ndarray, every: int, intervals: int = WINDOW_INTERVALS
) -> list[Window]:
    """Windows of up to `intervals` intervals, half overlapping, over every segment of `seen`.

    seen: [W] frames with an estimate, ascending. times: [T] seconds of all frames. every: N.
    A segment's last window is moved back to full length; a shorter segment is one window.
    """
    windows = []
    for start, end in split_segments(seen, times, every):
        last_start = max(start, end - 1 - intervals)
        stride = max(1, intervals * WINDOW_STRIDE // WINDOW_INTERVALS)
        for first in [*range(start, last_start, stride), last_start]:
            last = min(first + intervals, end - 1)
            windows.append(Window(first, last - first + 1, int(seen[first]), int(seen[last])))
    return windows

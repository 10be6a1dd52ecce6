"""Which frames the estimator looks at; the same as `web/sampling/watched.ts`."""

import numpy as np


def watched_frames(frame_count: int, every: int) -> np.ndarray:
    """Frames 0, N, 2N, … and always the last one, ascending, [W]; none of an empty sequence."""
    if every < 1:
        raise ValueError(f"one frame in {every} cannot be watched")
    if frame_count == 0:
        return np.zeros(0, np.int64)
    last = frame_count - 1
    return np.append(np.arange(0, last, every), last)

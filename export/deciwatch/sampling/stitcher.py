"""Joining the poses of overlapping windows; the same as `web/sampling/stitcher.ts`."""

import numpy as np

from deciwatch.sampling.windows import Window

# Weight of a window's own first and last frame, where inner frames have 1, 4, 9, … from the nearer
# end: it decides only where no other window covers the frame.
EDGE_WEIGHT = 1e-3


class Stitcher:
    """Each frame's pose is the mean over the windows that cover it.

    Windows weigh by the square of how far the frame is from their nearer end. `shape` is that of
    one pose.
    """

    def __init__(self, frame_count: int, shape: tuple[int, ...]) -> None:
        self._sums = np.zeros((frame_count, *shape))
        self._weights = np.zeros(frame_count)

    def add(self, window: Window, poses: np.ndarray) -> None:
        """Poses [T of the window, *shape]. Raises ValueError where they do not fit."""
        if poses.shape != (window.frames, *self._sums.shape[1:]):
            raise ValueError(f"poses of shape {poses.shape} do not fit {window}")
        index = np.arange(window.frames)
        weights = np.minimum(index, index[::-1]) ** 2 + EDGE_WEIGHT
        place = slice(window.first_frame, window.last_frame + 1)
        self._weights[place] += weights
        self._sums[place] += weights.reshape(-1, *[1] * (poses.ndim - 1)) * poses

    def finish(self) -> np.ndarray:
        """Poses [T, *shape], float32; NaN in frames that no window covers."""
        weights = self._weights.reshape(-1, *[1] * (self._sums.ndim - 1))
        covered = weights > 0
        poses = np.where(covered, self._sums, np.nan) / np.where(covered, weights, 1)
        return poses.astype(np.float32)

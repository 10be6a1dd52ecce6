"""Motions: many recorded sequences as landmarks, whatever files they came from."""

from dataclasses import dataclass

import numpy as np

FPS = 30.0


@dataclass(frozen=True)
class Motions:
    """Sequences laid end to end.

    landmarks: [F, 33, 3] metres, world axes, y up, floor at 0. start, length: [n] frames.
    """

    landmarks: np.ndarray
    start: np.ndarray
    length: np.ndarray
    names: tuple[str, ...]
    fps: float = FPS

    def sequence(self, index: int) -> np.ndarray:
        """Landmarks of one sequence, [length, 33, 3]."""
        return self.landmarks[self.start[index] : self.start[index] + self.length[index]]

"""What a method that watches one frame in N gets to see of a sequence."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from deciwatch.evaluation.pair_file import Sequence
from deciwatch.sampling.segments import split_segments
from deciwatch.sampling.watched import watched_frames
from deciwatch.sampling.windows import WINDOW_INTERVALS, Window, cut_windows


@dataclass(frozen=True)
class Plan:
    """The watched frames of one sequence of `frames` frames, and those with an estimate, ascending.

    every: N. intervals: Q of a full window. times: [T] seconds.
    """

    every: int
    intervals: int
    times: np.ndarray
    watched: np.ndarray
    seen: np.ndarray

    @cached_property
    def windows(self) -> list[Window]:
        """The windows that the nets run on."""
        return cut_windows(self.seen, self.times, self.every, self.intervals)

    @cached_property
    def segments(self) -> list[np.ndarray]:
        """The seen frames, split where nobody was seen for too long."""
        ranges = split_segments(self.seen, self.times, self.every)
        return [self.seen[start:end] for start, end in ranges]

    def covered(self) -> np.ndarray:
        """Frames that get a pose: those within a segment, [T]."""
        covered = np.zeros(len(self.times), bool)
        for frames in self.segments:
            covered[frames[0] : frames[-1] + 1] = True
        return covered


def make_plan(sequence: Sequence, every: int, intervals: int = WINDOW_INTERVALS) -> Plan:
    """One frame in `every` watched, the first and the last always."""
    watched = watched_frames(len(sequence.times), every)
    seen = watched[sequence.seen[watched]]
    return Plan(every, intervals, sequence.times, watched, seen)

"""Watching, cutting and stitching, by hand; the web's own are held to them by stitching.json."""

import numpy as np
import pytest

from deciwatch.sampling.segments import split_segments
from deciwatch.sampling.stitcher import Stitcher
from deciwatch.sampling.watched import watched_frames
from deciwatch.sampling.windows import Window, cut_windows

TIMES = np.arange(302) / 30


def spans(windows: list[Window]) -> list[tuple[int, int]]:
    return [(window.first_frame, window.last_frame) for window in windows]


def test_the_first_and_the_last_frame_are_always_watched():
    assert watched_frames(0, 10).tolist() == []
    assert watched_frames(1, 10).tolist() == [0]
    assert watched_frames(21, 10).tolist() == [0, 10, 20]
    assert watched_frames(23, 10).tolist() == [0, 10, 20, 22]
    assert watched_frames(4, 1).tolist() == [0, 1, 2, 3]


def test_windows_move_by_half_and_the_last_one_back():
    windows = cut_windows(watched_frames(231, 10), TIMES, 10)
    assert [window.first for window in windows] == [0, 5, 10, 13]
    assert spans(windows) == [(0, 100), (50, 150), (100, 200), (130, 230)]
    assert {window.samples for window in windows} == {11}
    assert spans(cut_windows(watched_frames(31, 10), TIMES, 10, intervals=1)) == [
        (0, 10),
        (10, 20),
        (20, 30),
    ]


def test_gaps_are_bridged_by_samples_or_seconds():
    assert split_segments(np.array([], int), TIMES, 10) == []
    seen = np.array([0, 10, 40, 80, 90])
    assert split_segments(seen, TIMES, 10) == [(0, 3), (3, 5)]
    assert spans(cut_windows(np.array([0, 20, 60]), TIMES, 20)) == [(0, 60)]
    assert spans(cut_windows(np.array([0, 20, 80]), TIMES, 20)) == [(0, 20), (80, 80)]
    # 21 frames are 0.7 s: with N = 1 that bridges 20 missing samples.
    assert split_segments(np.array([0, 1, 22]), TIMES, 1) == [(0, 3)]
    assert split_segments(np.array([0, 1, 23]), TIMES, 1) == [(0, 2), (2, 3)]
    # A short last interval counts as one.
    assert split_segments(np.array([280, 301]), TIMES, 10) == [(0, 2)]


def test_stitching_weighs_by_the_distance_from_the_windows_ends():
    stitcher = Stitcher(6, (1, 2))
    stitcher.add(Window(0, 2, 0, 3), np.zeros((4, 1, 2)))
    stitcher.add(Window(1, 2, 1, 4), np.ones((4, 1, 2)))
    # Frame 2 is 1 from both windows' nearer end; frame 1 is the second window's own first frame.
    expected = [0, 0.001 / 1.002, 0.5, 1.001 / 1.002, 1, np.nan]
    np.testing.assert_allclose(stitcher.finish()[:, 0, 1], expected, rtol=1e-5)
    with pytest.raises(ValueError, match="do not fit"):
        stitcher.add(Window(0, 2, 0, 3), np.zeros((3, 1, 2)))

"""Showing stretches of poses one after the other, as `web/engine/live/track.ts` does."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from deciwatch.live.easing import eased_share

# How long before the first frame that it is shown for a stretch has come, in frames.
ARRIVED = 0.5


@dataclass(frozen=True)
class Stretch:
    """Poses [n, K, D] at frames first, first + 1, …, which are shown from frame `shown` on."""

    first: int
    shown: int
    poses: np.ndarray


def shown_poses(frames: int, shape: tuple, fps: float, stretches: Iterable[Stretch]) -> np.ndarray:
    """What is on screen at every frame's time, [frames, K, D], NaN where nothing is.

    Each stretch replaces the one before from `shown` on, and what was on screen is eased into it.
    """
    out = np.full((frames, *shape), np.nan)
    for stretch in stretches:
        begin = max(stretch.shown, stretch.first)
        end = min(stretch.first + len(stretch.poses), frames)
        if begin >= end:
            continue
        poses = stretch.poses[begin - stretch.first : end - stretch.first]
        before = out[begin]
        if np.isfinite(before).all():
            # It came between this frame and the one before.
            share = eased_share((np.arange(end - begin) + ARRIVED) / fps)
            poses = poses + share[:, None, None] * (before - poses[0])
        out[begin:] = np.nan
        out[begin:end] = poses
    return out

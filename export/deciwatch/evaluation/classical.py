"""Classical interpolation of a sequence from its watched frames, and the estimates themselves."""

import numpy as np

from deciwatch.evaluation.method import Filled, Method
from deciwatch.evaluation.pair_file import Sequence
from deciwatch.evaluation.plan import Plan
from deciwatch.interpolate import interpolate


def every_frame(sequence: Sequence, plan: Plan) -> Filled:
    """The estimates themselves."""
    return Filled(dict(sequence.estimates))


def interpolated(kind: str) -> Method:
    """The method that interpolates by `kind`, one of deciwatch.interpolate.METHODS."""

    def fill(sequence: Sequence, plan: Plan) -> Filled:
        return Filled(
            {name: _filled(poses, plan, kind) for name, poses in sequence.estimates.items()}
        )

    return fill


def _filled(estimates: np.ndarray, plan: Plan, kind: str) -> np.ndarray:
    poses = np.full_like(estimates, np.nan)
    for seen in plan.segments:
        frames = np.arange(seen[0], seen[-1] + 1)
        values = estimates[seen].reshape(len(seen), -1)
        filled = interpolate(plan.times[seen], values, plan.times[frames], kind)
        poses[frames] = filled.reshape(len(frames), *estimates.shape[1:])
    return poses

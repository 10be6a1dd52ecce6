"""The methods that see every frame and smooth it: calibration, 1€, SmoothNet."""

from collections.abc import Callable

import numpy as np

from deciwatch.evaluation import calibration
from deciwatch.evaluation.method import Filled, Method
from deciwatch.evaluation.one_euro import one_euro
from deciwatch.evaluation.pair_file import Sequence
from deciwatch.evaluation.plan import Plan
from deciwatch.normalise import frame_of, from_net, to_net

# Net values [S, C] of seen frames, their frame numbers [S] and times [S] → values [S, C].
Smoother = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]


def smooth(estimates: np.ndarray, plan: Plan, smoother: Smoother) -> np.ndarray:
    """Estimates [T, K, D] smoothed segment by segment, NaN where nobody was seen."""
    poses = np.full_like(estimates, np.nan)
    for seen in plan.segments:
        frame = frame_of(estimates[seen])
        values = smoother(to_net(estimates[seen], *frame), seen, plan.times[seen])
        poses[seen] = from_net(values, *frame)
    return poses


def calibrated(maps: dict[str, np.ndarray]) -> Method:
    """Every frame through the maps of `deciwatch baselines`, by representation."""

    def fill(sequence: Sequence, plan: Plan) -> Filled:
        return Filled(
            {
                name: calibration.apply(maps[name], poses)
                for name, poses in sequence.estimates.items()
                if name in maps
            }
        )

    return fill


def one_euro_method(settings: dict[str, tuple[float, float]]) -> Method:
    """The 1€ filter with (min_cutoff, beta) by representation."""

    def smoother(min_cutoff: float, beta: float) -> Smoother:
        return lambda values, _, times: one_euro(values, times, min_cutoff, beta)

    def fill(sequence: Sequence, plan: Plan) -> Filled:
        return Filled(
            {
                name: smooth(sequence.estimates[name], plan, smoother(*settings[name]))
                for name in settings.keys() & sequence.estimates.keys()
            }
        )

    return fill


def smoothnet_method(nets: dict) -> Method:
    """A SmoothNet (deciwatch.nets.smoothnet) by representation, its windows averaged."""
    from deciwatch.nets.smoothnet import smooth_values, window_starts

    def smoother(net) -> Smoother:
        return lambda values, frames, _: smooth_values(net, values, frames)

    def fill(sequence: Sequence, plan: Plan) -> Filled:
        poses, flops = {}, 0
        windows = sum(len(window_starts(seen[-1] - seen[0] + 1)) for seen in plan.segments)
        for name in nets.keys() & sequence.estimates.keys():
            estimates = sequence.estimates[name]
            poses[name] = smooth(estimates, plan, smoother(nets[name]))
            flops += nets[name].flops(windows * estimates[0].size)
        return Filled(poses, flops)

    return fill

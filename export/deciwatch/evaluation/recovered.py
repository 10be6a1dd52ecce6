"""The nets as a method: window by window and stitched, as `web/recovery/recoverer.ts` runs them."""

from collections.abc import Iterator

import numpy as np

from deciwatch.data.batches import TIME_UNIT
from deciwatch.evaluation.counted_nets import CountedNets
from deciwatch.evaluation.method import Filled, Method
from deciwatch.evaluation.pair_file import Sequence
from deciwatch.evaluation.plan import Plan
from deciwatch.normalise import Samples, frame_of, from_net, sampled_values
from deciwatch.runner import Nets
from deciwatch.sampling.stitcher import Stitcher
from deciwatch.sampling.windows import Window
from deciwatch.skeleton import mid_hip


def recovered(pairs: dict[str, CountedNets]) -> Method:
    """Pairs of nets by representation, each on every window of a sequence."""

    def fill(sequence: Sequence, plan: Plan) -> Filled:
        poses = {name: _stitched(pair, sequence, plan) for name, pair in pairs.items()}
        flops = sum(
            pair.flops(window.samples, window.frames)
            for pair in pairs.values()
            for window in plan.windows
        )
        return Filled(poses, flops)

    return fill


def _stitched(pair: CountedNets, sequence: Sequence, plan: Plan) -> np.ndarray:
    estimates, scores = sequence.estimates, sequence.scores
    own = estimates[pair.nets.inputs[0]]
    stitcher = Stitcher(len(own), own.shape[1:])
    for windows in _batches(plan.windows, pair.batch):
        places = np.stack([plan.seen[x.first : x.first + x.samples] for x in windows])
        frames = np.stack([np.arange(x.first_frame, x.last_frame + 1) for x in windows])
        samples = Samples(
            poses_3d=estimates["3d"][places] if "3d" in estimates else None,
            poses_2d=estimates["2d"][places] if "2d" in estimates else None,
            scores=None if scores is None else scores[places],
        )
        poses = recover_windows(pair.nets, samples, plan.times[places], plan.times[frames])
        for window, values in zip(windows, poses, strict=True):
            stitcher.add(window, values)
    poses = stitcher.finish()
    # The nets move the hips by millimetres; 3D poses are relative to the mid-hip, exactly.
    return poses - mid_hip(poses) if pair.nets.dims == 3 else poses


def _batches(windows: list[Window], most: int) -> Iterator[list[Window]]:
    """Windows of the same S and T together, up to `most` at once."""
    alike: dict[tuple[int, int], list[Window]] = {}
    for window in windows:
        alike.setdefault((window.samples, window.frames), []).append(window)
    for group in alike.values():
        for first in range(0, len(group), most):
            yield group[first : first + most]


def recover_windows(
    nets: Nets, samples: Samples, sample_seconds: np.ndarray, seconds: np.ndarray
) -> np.ndarray:
    """B windows: samples taken at sample_seconds [B, S] → poses [B, T, K, D] at seconds [B, T]."""
    own = frame_of(samples.of(nets.inputs[0]))
    begin = sample_seconds[:, :1]
    times = [((at - begin) / TIME_UNIT).astype(np.float32) for at in (sample_seconds, seconds)]
    poses, _ = nets.run(sampled_values(samples, nets.inputs), *times)
    return from_net(poses, *own)

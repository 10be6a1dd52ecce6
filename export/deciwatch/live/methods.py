"""Ways of showing somebody live, with an estimator that takes `late` frames to answer.

Each gives poses [T, K, D] in the order of the frames that they are shown for, NaN where there are
none, by representation; and the delay in frames from a frame's capture to its pose on screen.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from deciwatch.data.batches import TIME_UNIT
from deciwatch.evaluation.baselines_file import Baselines
from deciwatch.evaluation.one_euro import one_euro
from deciwatch.evaluation.pair_file import Sequence
from deciwatch.live.stretches import Stretch, shown_poses
from deciwatch.normalise import Samples, frame_of, from_net, sampled_values
from deciwatch.runner import Nets
from deciwatch.sampling.segments import MAX_GAP_SECONDS, MAX_MISSING_SAMPLES, SHORT_GAP_SECONDS
from deciwatch.sampling.windows import WINDOW_INTERVALS
from deciwatch.skeleton import mid_hip

SPARE_SECONDS = 0.15  # looked ahead beyond the next answer, as the page does


@dataclass(frozen=True)
class Live:
    """A sequence as it comes: one frame in `every` watched, answers `late` frames after."""

    sequence: Sequence
    every: int
    late: int

    @property
    def frames(self) -> int:
        """T."""
        return len(self.sequence.times)

    @property
    def fps(self) -> float:
        """Frames a second."""
        return 1 / (self.sequence.times[1] - self.sequence.times[0])

    def seen(self) -> list[int]:
        """The watched frames in which somebody was seen."""
        watched = np.arange(0, self.frames, self.every)
        return [int(frame) for frame in watched if self.sequence.seen[frame]]

    def windows(self) -> list[list[int]]:
        """For each sample, those that it and the ones before it make a window of."""
        found, running = [], []
        for frame in self.seen():
            if running and not self._bridged(running[-1], frame):
                running = []
            running = [*running, frame][-WINDOW_INTERVALS - 1 :]
            found.append(running)
        return found

    def _bridged(self, left: int, right: int) -> bool:
        missing, gap = (right - left) // self.every - 1, (right - left) / self.fps
        few = missing <= MAX_MISSING_SAMPLES and gap <= MAX_GAP_SECONDS
        return missing == 0 or gap <= SHORT_GAP_SECONDS or few


Shown = tuple[dict[str, np.ndarray], int]
Method = Callable[[Live], Shown]


def smooth(nets: dict[str, Nets]) -> Method:
    """The newest interval, recovered once its second sample has been answered."""

    def show(live: Live) -> Shown:
        def stretches(name: str, own: Nets):
            for window in live.windows():
                if len(window) > 1:
                    frames = np.arange(window[-2], window[-1] + 1)
                    poses = _run(own, "recover", live, window, frames)
                    yield Stretch(window[-2], window[-2], poses)

        return _shown(live, nets, stretches), live.every + live.late

    return show


def now(nets: dict[str, Nets]) -> Method:
    """At once: what comes after the last sample that has been answered is foreseen."""

    def show(live: Live) -> Shown:
        span = live.every + 2 * live.late + round(SPARE_SECONDS * live.fps)

        def stretches(name: str, own: Nets):
            for window in live.windows():
                if len(window) > 1:
                    frames = np.arange(window[-1], window[-1] + span)
                    poses = _run(own, "forecast", live, window, frames)
                    yield Stretch(window[-1], window[-1] + live.late, poses)

        return _shown(live, nets, stretches), 0

    return show


def _shown(live: Live, nets: dict[str, Nets], stretches) -> dict[str, np.ndarray]:
    poses = {}
    for name, own in nets.items():
        shape = live.sequence.estimates[name].shape[1:]
        found = shown_poses(live.frames, shape, live.fps, stretches(name, own))
        poses[name] = found - mid_hip(found) if name == "3d" else found
    return poses


def _run(nets: Nets, which: str, live: Live, window: list[int], frames: np.ndarray) -> np.ndarray:
    estimates, scores = live.sequence.estimates, live.sequence.scores
    samples = Samples(
        estimates["3d"][window] if "3d" in estimates else None,
        estimates["2d"][window] if "2d" in estimates else None,
        None if scores is None else scores[window],
    )
    origin, unit = frame_of(samples.of(nets.inputs[0]))
    units = [
        ((np.asarray(at) - window[0]) / live.fps / TIME_UNIT).astype(np.float32)[None]
        for at in (window, frames)
    ]
    sampled = sampled_values(samples, nets.inputs)[None]
    if which == "forecast":
        poses = nets.forecast(sampled, *units)
    else:
        poses = nets.recover(*nets.denoise(sampled, units[0]), *units)
    return from_net(poses[0], origin, unit)


def hold(live: Live) -> Shown:
    """The last pose that has been answered."""
    return _from_answers(live, lambda poses, left, frame: poses[left[-1]]), 0


def linear(live: Live) -> Shown:
    """On from the last two poses that have been answered, in a straight line."""

    def at(poses: np.ndarray, left: list[int], frame: int) -> np.ndarray:
        if len(left) < 2:
            return poses[left[-1]]
        before, last = left[-2:]
        return poses[last] + (poses[last] - poses[before]) * (frame - last) / (last - before)

    return _from_answers(live, at), 0


def _from_answers(live: Live, at: Callable) -> dict[str, np.ndarray]:
    """`at(poses, watched frames that have been answered, frame)` at every frame's time."""
    seen = live.seen()
    shown = {}
    for name, poses in live.sequence.estimates.items():
        out = np.full(poses.shape, np.nan)
        for frame in range(live.frames):
            answered = [left for left in seen if left + live.late <= frame]
            if answered:
                out[frame] = at(poses, answered[-2:], frame)
        shown[name] = out
    return shown


def every_frame(live: Live) -> Shown:
    """The estimator on every frame, shown when it has answered: no device may keep up with it."""
    return dict(live.sequence.estimates), live.late


def every_frame_now(live: Live) -> Shown:
    """The same, taken for the pose of the moment in which it is shown."""
    return {name: _moved(poses, live.late) for name, poses in live.sequence.estimates.items()}, 0


def filtered(baselines: Baselines) -> Method:
    """The 1€ filter on every frame, taken for the pose of the moment in which it is shown."""

    def show(live: Live) -> Shown:
        shown = {}
        for name, poses in live.sequence.estimates.items():
            min_cutoff, beta = baselines.one_euro[name]
            seen = np.flatnonzero(live.sequence.seen)
            out = np.full(poses.shape, np.nan)
            if not len(seen):
                shown[name] = out
                continue
            flat = poses[seen].reshape(len(seen), -1).astype(float)
            values = one_euro(flat, live.sequence.times[seen], min_cutoff, beta)
            out[seen] = values.reshape(len(seen), *poses.shape[1:])
            shown[name] = _moved(out, live.late)
        return shown, 0

    return show


def _moved(poses: np.ndarray, late: int) -> np.ndarray:
    out = np.full(poses.shape, np.nan)
    out[late:] = poses[: len(poses) - late]
    return out

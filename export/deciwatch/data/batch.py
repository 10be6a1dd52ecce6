"""What a training step is given, and how it is made of poses."""

from dataclasses import dataclass

import numpy as np

from deciwatch.normalise import Samples, frame_of, sampled_values, to_net


@dataclass(frozen=True)
class Batch:
    """B windows in net values. Times are in time units from the window's first sample.

    sampled: [B, S, I] the estimates. clean: [B, S, K·D], poses: [B, T, K·D] truth of the samples
    and of the scored frames. sample_times: [B, S]. frame_times: [B, T]. unit: [B] size of 1 in
    metres or pixels.
    """

    sampled: np.ndarray
    clean: np.ndarray
    poses: np.ndarray
    sample_times: np.ndarray
    frame_times: np.ndarray
    unit: np.ndarray


@dataclass(frozen=True)
class Windows:
    """The same before it is normalised: metres, pixels, and times in time units.

    estimates: of each input "3d" [B, S, 33, 3], "2d" [B, S, 33, 2], "scores" [B, S, 33].
    clean: [B, S, 33, D], poses: [B, T, 33, D] truth. sample_times: [B, S]. frame_times: [B, T].
    """

    estimates: dict[str, np.ndarray]
    clean: np.ndarray
    poses: np.ndarray
    sample_times: np.ndarray
    frame_times: np.ndarray


def normalised(windows: Windows, inputs: tuple[str, ...]) -> Batch:
    """Windows as a batch for nets with these inputs, whose first is the truth's representation."""
    given = windows.estimates
    samples = Samples(given.get("3d"), given.get("2d"), given.get("scores"))
    origin, unit = frame_of(given[inputs[0]])
    return Batch(
        sampled=sampled_values(samples, inputs),
        clean=to_net(windows.clean, origin, unit),
        poses=to_net(windows.poses, origin, unit),
        sample_times=windows.sample_times.astype(np.float32),
        frame_times=windows.frame_times.astype(np.float32),
        unit=unit.reshape(-1).astype(np.float32),
    )

"""Changes to pairs that leave an estimate what the estimator would have said of the changed truth.

What the picture's scale and place would change is gone once 2D is normalised, so it is not drawn.
"""

from dataclasses import replace

import numpy as np

from deciwatch.data.batch import Batch, Windows
from deciwatch.nets.pair import INPUTS
from deciwatch.skeleton import KEYPOINTS, MIRROR

SPEEDS = (0.7, 1.5)
SIZES = (0.9, 1.1)
TURN = np.radians(12.0)
JITTER = 0.012  # net values: 6 mm in 3D, 1.2 % of the box in 2D; the most that is added
SCORE_NOISE = 0.1
ABSENT = 0.05  # share of windows that go without one of the further inputs


def augment_windows(rng: np.random.Generator, windows: Windows) -> Windows:
    """Mirror, reverse, speed, turn in the picture's plane and resize each window by itself."""
    size = len(windows.clean)
    windows = _mirror(windows, rng.random(size) < 0.5)
    windows = _reverse(windows, rng.random(size) < 0.5)
    windows = _turn_and_resize(windows, rng.uniform(-TURN, TURN, size), rng.uniform(*SIZES, size))
    speed = np.exp(rng.uniform(*np.log(SPEEDS), size=(size, 1)))
    return replace(
        windows,
        sample_times=windows.sample_times * speed,
        frame_times=windows.frame_times * speed,
    )


def _mapped(windows: Windows, change) -> Windows:
    """`change` done to every array of poses or scores: [B, L, 33, D] or [B, L, 33]."""
    return replace(
        windows,
        estimates={name: change(values) for name, values in windows.estimates.items()},
        clean=change(windows.clean),
        poses=change(windows.poses),
    )


def _mirror(windows: Windows, chosen: np.ndarray) -> Windows:
    def change(values: np.ndarray) -> np.ndarray:
        values = values.copy()
        other = values[chosen][:, :, MIRROR]
        if values.ndim == 4:
            other[..., 0] *= -1
        values[chosen] = other
        return values

    return _mapped(windows, change)


def _reverse(windows: Windows, chosen: np.ndarray) -> Windows:
    """Time backwards; every estimate was made from one image alone, so it stays as it is."""

    def change(values: np.ndarray) -> np.ndarray:
        values = values.copy()
        values[chosen] = values[chosen, ::-1]
        return values

    span = windows.sample_times[:, -1:]
    changed = _mapped(windows, change)
    for name in ("sample_times", "frame_times"):
        times = change(getattr(windows, name))
        times[chosen] = (span - times)[chosen]
        changed = replace(changed, **{name: times})
    return changed


def _turn_and_resize(windows: Windows, angle: np.ndarray, size: np.ndarray) -> Windows:
    """Turn 3D and 2D together, anticlockwise as seen; only 3D has a size of its own."""
    cosine, sine = (f(angle).astype(np.float32)[:, None, None] for f in (np.cos, np.sin))
    size = size.astype(np.float32)[:, None, None, None]

    def change(values: np.ndarray) -> np.ndarray:
        if values.ndim == 3:
            return values
        x, y = values[..., 0], values[..., 1]
        if values.shape[-1] == 2:  # y points down
            return np.stack([cosine * x + sine * y, cosine * y - sine * x], axis=-1)
        turned = [cosine * x - sine * y, sine * x + cosine * y, values[..., 2]]
        return np.stack(turned, axis=-1) * size

    return _mapped(windows, change)


def disturb(rng: np.random.Generator, batch: Batch, inputs: tuple[str, ...]) -> Batch:
    """Make the inputs less trustworthy: jitter, noisy scores, further inputs missing (zeros)."""
    size = len(batch.sampled)
    sampled, begin = batch.sampled.copy(), 0
    for place, name in enumerate(inputs):
        part = sampled[..., begin : begin + KEYPOINTS * INPUTS[name]]
        begin += part.shape[-1]
        most = SCORE_NOISE if name == "scores" else JITTER
        spread = (most * rng.random((size, 1, 1))).astype(np.float32)
        part += spread * rng.standard_normal(part.shape, dtype=np.float32)
        if name == "scores":
            np.clip(part, 0.0, 1.0, out=part)
        if place:
            part *= rng.random((size, 1, 1)) >= ABSENT
    return replace(batch, sampled=sampled)

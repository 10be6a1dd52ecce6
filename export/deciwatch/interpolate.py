"""Classical interpolation between samples: what DeciWatch is compared with."""

import numpy as np
from scipy.interpolate import interp1d

METHODS = ("nearest", "linear", "quadratic", "cubic")
_DEGREE = {"nearest": 0, "linear": 1, "quadratic": 2, "cubic": 3}
_BY_DEGREE = ("nearest", "linear", "quadratic", "cubic")


def interpolate(
    sample_times: np.ndarray, values: np.ndarray, times: np.ndarray, method: str
) -> np.ndarray:
    """Values [S, C] at ascending sample_times [S] → [T, C] at `times` [T].

    The methods are scipy.interpolate.interp1d's kinds: quadratic and cubic are splines through all
    samples, not-a-knot at the ends; nearest takes the earlier sample at a tie. With too few
    samples the highest degree that they allow is used; one sample is held. Times outside are
    clamped to the samples' span.
    """
    if method not in METHODS:
        raise ValueError(f"{method!r} is none of {METHODS}")
    count = len(sample_times)
    if count == 1:
        return np.repeat(values, len(times), axis=0)
    kind = _BY_DEGREE[min(_DEGREE[method], count - 1)]
    at = np.clip(times, sample_times[0], sample_times[-1])
    return interp1d(sample_times, values, kind=kind, axis=0, assume_sorted=True)(at)

"""Fixtures of normalisation, interpolation and metrics, by scipy or by plain loops.

Nothing here calls the package's own normalise, interpolate or metrics: a fixture made with the
code under test would share its mistakes.
"""

import numpy as np
from scipy.interpolate import interp1d
from scipy.spatial.distance import cdist

from deciwatch.live.easing import EASE_SECONDS


def _list(values: np.ndarray, digits: int = 9) -> list:
    return np.round(np.asarray(values, float), digits).tolist()


def normalise_cases(seed: int) -> dict:
    """Window boxes in 2D, pixels [S][K][2], and the constant scale in 3D."""
    rng = np.random.default_rng(seed)
    cases = []
    for samples, keypoints in ((1, 3), (2, 4), (4, 33)):
        pixels = np.round(rng.uniform(0, 900, size=(samples, keypoints, 2)), 3)
        centres, sizes = [], []
        for pose in pixels.tolist():
            (left, right), (top, bottom) = (
                (min(axis), max(axis)) for axis in zip(*pose, strict=True)
            )
            centres.append([(left + right) / 2, (top + bottom) / 2])
            sizes.append(max(right - left, bottom - top))
        centre, scale = np.mean(centres, axis=0), float(np.mean(sizes))
        case = {"samples": samples, "keypoints": keypoints, "pixels": _list(pixels.ravel())}
        case |= {"centre": _list(centre), "scale": scale}
        cases.append(case | {"normalised": _list(((pixels - centre) / scale).ravel())})
    metres = np.round(rng.normal(0, 0.4, size=12), 4)
    return {
        "windowBox": cases,
        "scale": {"metres": _list(metres), "scale": 0.5, "normalised": _list(metres / 0.5)},
    }


def interpolation_cases(seed: int) -> dict:
    """Samples [S][C] and scipy's interp1d of every kind that S allows, at query times."""
    rng = np.random.default_rng(seed)
    cases = []
    for name, times, step in (
        ("two", [0.0, 10.0], 1.0),
        ("three", [0.0, 10.0, 20.0], 2.0),
        ("four", [0.0, 3.0, 7.0, 12.0], 0.5),
        ("eleven", list(np.arange(11) / 3), 1 / 30),
        ("uneven", [0.0, 0.35, 0.61, 1.4, 1.45, 2.0, 3.3], 0.05),
    ):
        # Rounded first: at a tie of "nearest", a last digit that the file lacks would decide.
        times = np.round(times, 15)
        values = np.round(rng.normal(size=(len(times), 3)), 6)
        count = round((times[-1] - times[0]) / step) + 1
        queries = np.round(np.linspace(times[0], times[-1], count), 15)
        results = {}
        for kind, least in (("nearest", 1), ("linear", 2), ("quadratic", 3), ("cubic", 4)):
            if len(times) >= least:
                results[kind] = _list(interp1d(times, values, kind=kind, axis=0)(queries))
        case = {"name": name, "times": _list(times, 15), "values": _list(values)}
        cases.append(case | {"queries": _list(queries, 15), "results": results})
    return {"cases": cases}


def metric_cases(seed: int) -> dict:
    """MPJPE, Accel and PCK of random sequences [T][K][D], added up joint by joint."""
    rng = np.random.default_rng(seed)
    cases = []
    for frames, keypoints, dims in ((3, 2, 2), (6, 5, 2), (5, 4, 3), (9, 33, 3)):
        truth = np.round(rng.uniform(0, 500, size=(frames, keypoints, dims)), 3)
        poses = np.round(truth + rng.normal(0, 40, size=truth.shape), 3)
        distances = [
            [float(cdist([poses[t, k]], [truth[t, k]])[0, 0]) for k in range(keypoints)]
            for t in range(frames)
        ]
        bends = []
        for t in range(1, frames - 1):
            for k in range(keypoints):
                ours = poses[t - 1, k] - 2 * poses[t, k] + poses[t + 1, k]
                true = truth[t - 1, k] - 2 * truth[t, k] + truth[t + 1, k]
                bends.append(float(np.sqrt(sum((ours - true) ** 2))))
        case = {"frames": frames, "keypoints": keypoints, "dims": dims}
        case |= {"poses": _list(poses.ravel()), "truth": _list(truth.ravel())}
        case |= {"mpjpe": float(np.mean(distances)), "accel": float(np.mean(bends))}
        if dims == 2:
            sizes = [
                max(max(axis) - min(axis) for axis in zip(*pose, strict=True))
                for pose in truth.tolist()
            ]
            case["pck"] = {
                str(alpha): float(
                    np.mean(
                        [
                            d <= alpha * size
                            for row, size in zip(distances, sizes, strict=True)
                            for d in row
                        ]
                    )
                )
                for alpha in (0.05, 0.1, 0.2)
            }
        cases.append(case)
    return {"cases": cases}


def easing_cases() -> dict:
    """An exponential by its limit, (1 - x/n)^n."""
    ages = np.linspace(0.0, 8.0, 33) * EASE_SECONDS
    count = 1e9
    shares = (1 - ages / EASE_SECONDS / count) ** count
    return {"seconds": EASE_SECONDS, "ages": ages.tolist(), "shares": np.round(shares, 7).tolist()}

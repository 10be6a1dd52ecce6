"""Fixtures that hold the web's nets to torch's numbers, and its cost meter to the graphs."""

from pathlib import Path

import numpy as np
import torch

from deciwatch import checkpoint, manifest
from deciwatch.flops import GraphCounter
from deciwatch.nets.forecast import ForecastNet
from deciwatch.nets.pair import Pair
from deciwatch.normalise import Samples, sampled_values
from deciwatch.skeleton import INDEX, KEYPOINTS, LANDMARKS, mid_hip
from deciwatch.storage import round_weights

# N, Q, and which samples are missing; the last is on uneven times, and holds times of no sample.
CASES = (
    {"name": "N10-Q3", "interval": 10, "intervals": 3, "missing": ()},
    {"name": "N1-Q2", "interval": 1, "intervals": 2, "missing": ()},
    {"name": "N20-Q2", "interval": 20, "intervals": 2, "missing": ()},
    {"name": "N1-Q1", "interval": 1, "intervals": 1, "missing": ()},
    {"name": "uneven", "interval": 7, "intervals": 5, "missing": (2, 3), "uneven": True},
)
FLOPS_PLACES = ((2, 2), (2, 11), (4, 31), (6, 51), (11, 11), (11, 101), (11, 201), (7, 101))


def flat(values: np.ndarray) -> list[float]:
    """Numbers of float32 precision, short enough to read back to the same float32."""
    return [float(f"{value:.9g}") for value in np.asarray(values, np.float32).ravel()]


def standing_person(seconds: np.ndarray) -> np.ndarray:
    """A made-up person walking on the spot, [T, 33, 3] metres about the mid-hip, y up.

    Made by hand, so that fixtures hold no recorded motion.
    """
    height = {"nose": 0.62, "eye": 0.66, "ear": 0.64, "mouth": 0.58, "shoulder": 0.48}
    height |= {"elbow": 0.2, "wrist": 0.0, "pinky": -0.08, "index": -0.09, "thumb": -0.06}
    height |= {"hip": 0.0, "knee": -0.4, "ankle": -0.8, "heel": -0.84, "foot_index": -0.85}
    side = {"shoulder": 0.18, "elbow": 0.24, "wrist": 0.26, "pinky": 0.27, "index": 0.26}
    side |= {"thumb": 0.23, "eye": 0.03, "ear": 0.075, "mouth": 0.025, "nose": 0.0}
    poses = np.zeros((len(seconds), KEYPOINTS, 3))
    for name in LANDMARKS:
        part = next(part for part in height if part in name)
        sign = 1.0 if "left" in name else -1.0
        swing = max(0.0, 0.45 - height[part]) * 0.35 * (-1 if height[part] < 0.01 else 1)
        phase = np.sin(2 * np.pi * 0.9 * seconds) * sign
        poses[:, INDEX[name], 0] = sign * side.get(part, 0.1)
        poses[:, INDEX[name], 1] = height[part] + 0.1 * swing * phase**2
        poses[:, INDEX[name], 2] = swing * phase + (0.1 if part in ("nose", "mouth") else 0.0)
    return poses - mid_hip(poses)


def estimates(case: dict, rng: np.random.Generator) -> tuple[Samples, np.ndarray, np.ndarray]:
    """The samples of one of CASES, and when: of the S samples [S] and the T frames [T], time units.

    Every array has float32 precision. The person drifts through a picture of 1280 x 720.
    """
    frames = case["interval"] * case["intervals"] + 1
    times = np.arange(frames, dtype=np.float64)
    if case.get("uneven"):
        times = np.concatenate([[0.0], np.cumsum(rng.uniform(0.5, 1.9, size=frames - 1))])
    numbers = range(case["intervals"] + 1)
    watched = [i * case["interval"] for i in numbers if i not in case["missing"]]
    metres = standing_person(times[watched] / 30)
    pixels = np.array([640.0, 360.0]) + np.array([300.0, -300.0]) * metres[..., :2]
    pixels += 2.0 * times[watched, None, None]
    samples = Samples(
        poses_3d=(metres + rng.normal(0, 0.04, size=metres.shape)).astype(np.float32),
        poses_2d=(pixels + rng.normal(0, 6.0, size=pixels.shape)).astype(np.float32),
        scores=rng.uniform(0.2, 1.0, size=metres.shape[:2]).astype(np.float32),
    )
    return samples, times[watched].astype(np.float32), times.astype(np.float32)


def parity_cases(path: Path, dims: int, seed: int) -> dict:
    """Inputs and torch's outputs for CASES, in net values and time units, as flat arrays.

    The nets' weights are rounded as `deciwatch export` rounds them.
    """
    pair = round_weights(checkpoint.load_pair(path, dims)[0])
    forecast = checkpoint.load_forecast(checkpoint.forecast_path(dims), dims)[0]
    forecast = round_weights(forecast)
    cases = [
        _parity_case(pair, forecast, np.random.default_rng(seed + i), case)
        for i, case in enumerate(CASES)
    ]
    return {"dims": dims, "keypoints": KEYPOINTS, "width": pair.config.width, "cases": cases}


@torch.no_grad()
def _parity_case(pair: Pair, forecast: ForecastNet, rng: np.random.Generator, case: dict) -> dict:
    samples, *times = estimates(case, rng)
    sampled = torch.from_numpy(sampled_values(samples, pair.config.inputs))[None]
    sample_times, frame_times = (torch.from_numpy(at)[None] for at in times)
    clean, features = pair.denoise(sampled, sample_times)
    recovered = pair.recover(clean, features, sample_times, frame_times)
    arrays = {"sampled": sampled, "sampleTimes": sample_times, "frameTimes": frame_times}
    arrays |= {"clean": clean, "features": features, "poses": recovered}
    ahead = sample_times[:, -1:] + torch.tensor([[0.0, 0.5, 3.0, 11.5]])
    arrays |= {"aheadTimes": ahead, "forecast": forecast(sampled, sample_times, ahead)[1]}
    shapes = {name: list(array.shape) for name, array in arrays.items()}
    sizes = {"samples": sampled.shape[1], "frames": frame_times.shape[1]}
    return {"name": case["name"], **sizes, "shapes": shapes} | {
        name: flat(array.numpy()) for name, array in arrays.items()
    }


def flops_cases(folder: Path) -> dict:
    """FLOPs of each net at several S and T, counted in the graph and not by the polynomial."""
    counted = {}
    for name, pair in manifest.read(folder)["pairs"].items():
        counters = {
            kind: GraphCounter(folder / pair[kind]["file"])
            for kind in (*manifest.KINDS, manifest.FORECAST)
        }
        counted[name] = [
            {"samples": samples, "frames": frames}
            | {kind: counter.count(samples, frames) for kind, counter in counters.items()}
            for samples, frames in FLOPS_PLACES
        ]
    return {"pairs": counted}

"""A small pair file of a made-up walker, for the tests of evaluation."""

from pathlib import Path

import numpy as np

from deciwatch.fixture_parity import standing_person

LENGTHS = (101, 64)


def pair_arrays(seed: int = 0, noise: float = 0.04, lost: tuple[int, ...] = (7, 130)) -> dict:
    """Arrays of two sequences at 30 frames a second; nobody is seen in the frames `lost`."""
    rng = np.random.default_rng(seed)
    frames = sum(LENGTHS)
    gt = standing_person(np.arange(frames) / 30)
    gt_2d = np.array([640.0, 360.0]) + np.array([300.0, -300.0]) * gt[..., :2]
    arrays = {
        "gt": gt,
        "gt_2d": gt_2d,
        "pred": gt + rng.normal(0, noise, gt.shape),
        "pred_2d": gt_2d + rng.normal(0, 300 * noise, gt_2d.shape),
        "scores": rng.uniform(0.2, 1, gt.shape[:2]),
        "box": np.concatenate([gt_2d.min(axis=1), gt_2d.max(axis=1)], axis=1),
        "ms": np.full(frames, 20.0),
    }
    arrays = {name: array.astype(np.float32) for name, array in arrays.items()}
    for name in ("pred", "pred_2d", "scores"):
        arrays[name][list(lost)] = np.nan
    arrays |= {"start": np.array([0, LENGTHS[0]]), "length": np.array(LENGTHS)}
    return arrays | {"fps": np.array(30.0), "estimator": np.array("mediapipe-full")}


def write_pairs(path: Path, arrays: dict) -> str:
    """Write the arrays; returns the path as text, for a command line."""
    np.savez(path, **arrays)
    return str(path)

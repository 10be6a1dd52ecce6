"""The figures of one row: errors over the scored frames, in mm and pixels, and by joint group."""

import numpy as np

from deciwatch.evaluation.pair_file import PairFile
from deciwatch.metrics import bends, box_size, distances, pck, procrustes
from deciwatch.skeleton import INDEX, KEYPOINTS

MM = 1000.0
NEAR = {"pck_20": 0.2, "pck_10": 0.1, "pck_05": 0.05}  # of the box's larger side
FIGURES = ("mpjpe_mm", "pa_mpjpe_mm", "accel_mm", *NEAR, "mpjpe_px", "accel_px")
_PARTS = {
    "head": ("nose", "eye", "ear", "mouth"),
    "torso": ("shoulder", "hip"),
    "arms": ("elbow", "wrist"),
    "hands": ("pinky", "thumb"),
    "legs": ("knee", "ankle"),
    "feet": ("heel", "foot"),
}


def _group_of(name: str) -> str:
    if name in ("left_index", "right_index"):
        return "hands"
    return next(group for group, parts in _PARTS.items() if any(part in name for part in parts))


# Landmarks of each joint group; every landmark is in one.
GROUPS = {
    group: np.array([i for name, i in INDEX.items() if _group_of(name) == group])
    for group in _PARTS
}


def score(file: PairFile, poses: dict[str, np.ndarray], scored: np.ndarray) -> dict:
    """FIGURES (None where the file has no such truth) and `groups`, MPJPE in mm by joint group.

    poses: by representation, [F, K, D]. scored: [F], the frames to look at, where all are finite.
    Accel looks at those whose neighbours in the same sequence are scored too.
    """
    figures: dict = dict.fromkeys(FIGURES) | {"groups": {}}
    if "3d" in poses:
        figures |= _score_3d(poses["3d"], file.truths["3d"], scored, _middles(file, scored))
    if "2d" in poses:
        ours, truth = poses["2d"][scored], file.truths["2d"][scored]
        sides = box_size(truth) if file.box is None else _sides(file.box[scored], truth)
        figures["mpjpe_px"] = _mean(distances(ours, truth))
        figures["accel_px"] = _accel(poses["2d"], file.truths["2d"], _middles(file, scored))
        figures |= {name: pck(ours, truth, near, sides) for name, near in NEAR.items()}
    return figures


def _score_3d(
    poses: np.ndarray, truth: np.ndarray, scored: np.ndarray, middles: np.ndarray
) -> dict:
    off = distances(poses[scored], truth[scored]) * MM
    aligned = procrustes(poses[scored], truth[scored])
    figures = {"mpjpe_mm": _mean(off), "accel_mm": _accel(poses, truth, middles, MM)}
    figures["pa_mpjpe_mm"] = _mean(distances(aligned, truth[scored])) * MM
    if poses.shape[1] == KEYPOINTS:
        figures["groups"] = {name: _mean(off[:, joints]) for name, joints in GROUPS.items()}
    return figures


def _middles(file: PairFile, scored: np.ndarray) -> np.ndarray:
    """Scored frames with a scored frame of the same sequence before and after, ascending."""
    inside = np.zeros(len(scored), bool)
    for index in range(len(file.start)):
        place = file.place(index)
        inside[place.start + 1 : place.stop - 1] = True
    neighbours = np.zeros_like(inside)
    neighbours[1:-1] = scored[:-2] & scored[2:]
    return np.flatnonzero(inside & scored & neighbours)


def _accel(
    poses: np.ndarray, truth: np.ndarray, middles: np.ndarray, unit: float = 1.0
) -> float | None:
    if not len(middles):
        return None
    around = middles[:, None] + np.array([-1, 0, 1])
    return _mean(bends(poses[around], truth[around])) * unit


def _sides(box: np.ndarray, truth: np.ndarray) -> np.ndarray:
    """Larger side of boxes [F, 4] x0, y0, x1, y1 → [F]; that of the truth where there is no box."""
    sides = np.maximum(box[:, 2] - box[:, 0], box[:, 3] - box[:, 1])
    return np.where(np.isfinite(sides), sides, box_size(truth))


def _mean(values: np.ndarray) -> float:
    return float(np.mean(values, dtype=np.float64))

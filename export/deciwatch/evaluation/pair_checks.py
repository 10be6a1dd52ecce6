"""What is checked of a pair file's arrays before they are used; every error is one sentence."""

from pathlib import Path

import numpy as np

from deciwatch.errors import UserError

NEEDED = ("pred", "gt", "start", "length")
FLOATS = ("pred", "gt", "pred_2d", "gt_2d", "scores", "box", "ms")
KNOWN = (*NEEDED, *FLOATS[2:], "estimated", "fps", "estimator")


def check(arrays: dict[str, np.ndarray], path: Path) -> dict[str, np.ndarray]:
    """The arrays as numbers of the right kind: float32, int64, bool. Raises UserError."""
    for name in NEEDED:
        if name not in arrays:
            raise UserError(f"{path} has no array {name!r}; it needs {', '.join(NEEDED)}.")
    if ("pred_2d" in arrays) != ("gt_2d" in arrays):
        raise UserError(f"{path} has only one of pred_2d and gt_2d; give both or neither.")
    kinds = dict.fromkeys(FLOATS, np.float32) | {"start": np.int64, "length": np.int64}
    kinds |= {"estimated": bool, "fps": np.float64}
    checked = dict(arrays)
    for name in kinds.keys() & arrays.keys():
        if arrays[name].dtype.kind not in "fiub":
            raise UserError(
                f"{name} in {path} holds no numbers; give it as {kinds[name].__name__}."
            )
        checked[name] = arrays[name].astype(kinds[name])
    _shapes(checked, path)
    _sequences(checked, path)
    _values(checked, path)
    return checked


def _shapes(arrays: dict[str, np.ndarray], path: Path) -> None:
    pred = arrays["pred"]
    if pred.ndim != 3 or pred.shape[-1] not in (2, 3) or 0 in pred.shape:
        raise UserError(
            f"pred in {path} has the shape {list(pred.shape)}; give [F, K, 3] metres or [F, K, 2] "
            "pixels."
        )
    frames, keypoints, dims = pred.shape
    if dims == 2 and "pred_2d" in arrays:
        raise UserError(f"pred in {path} is 2D beside a pred_2d; leave one of them out.")
    wanted = {"gt": pred.shape, "scores": (frames, keypoints), "box": (frames, 4), "ms": (frames,)}
    wanted |= {"pred_2d": (frames, keypoints, 2), "gt_2d": (frames, keypoints, 2)}
    wanted |= {"estimated": (frames,)}
    for name in wanted.keys() & arrays.keys():
        if arrays[name].shape != wanted[name]:
            raise UserError(
                f"{name} in {path} has the shape {list(arrays[name].shape)} where pred asks for "
                f"{list(wanted[name])}; make them fit."
            )
    start, length = arrays["start"], arrays["length"]
    if start.ndim != 1 or start.shape != length.shape or not len(start):
        raise UserError(
            f"start {list(start.shape)} and length {list(length.shape)} in {path} must be one "
            "number for each sequence."
        )
    fps = arrays.get("fps")
    if fps is not None and fps.shape not in ((), (1,), start.shape):
        raise UserError(f"fps in {path} is neither one number nor one for each sequence.")


def _sequences(arrays: dict[str, np.ndarray], path: Path) -> None:
    frames, (start, length) = len(arrays["pred"]), (arrays["start"], arrays["length"])
    wrong = np.flatnonzero((start < 0) | (length < 1) | (start + length > frames))
    if len(wrong):
        i = wrong[0]
        raise UserError(
            f"Sequence {i} in {path} starts at frame {start[i]} and is {length[i]} long, which "
            f"does not lie within its {frames} frames; mend start and length."
        )
    order = np.argsort(start, kind="stable")
    if (start[order][1:] < (start + length)[order][:-1]).any():
        raise UserError(f"Sequences in {path} share frames; mend start and length.")
    fps = arrays.get("fps")
    if fps is not None and not (np.isfinite(fps) & (fps > 0)).all():
        raise UserError(f"fps in {path} is not above 0 everywhere; give frames per second.")


def _values(arrays: dict[str, np.ndarray], path: Path) -> None:
    for name, what in (("gt", "truth"), ("gt_2d", "truth"), ("pred", "estimate")):
        if name in arrays and not np.isfinite(arrays[name]).all(axis=(1, 2)).any():
            raise UserError(
                f"{name} in {path} has no frame with a finite {what} of all keypoints; there is "
                "nothing to score."
            )
    if arrays["pred"].shape[-1] == 3 and np.nanmedian(np.abs(arrays["gt"])) > 10:
        raise UserError(f"gt in {path} looks like millimetres; give 3D poses in metres.")

"""The pair file: an estimator's poses beside the true ones. See docs/pair-file.md."""

import zipfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from deciwatch.errors import UserError
from deciwatch.evaluation.pair_checks import KNOWN, check

DEFAULT_FPS = 30.0
HOW = "docs/pair-file.md says what it has to hold"


@dataclass(frozen=True)
class Sequence:
    """T frames of one sequence; views into the file's arrays.

    times: [T] seconds from its first frame. estimates: by representation, [T, K, D], NaN where
    there is none. scores: [T, K] 0 to 1, or None. seen: [T], whether somebody was seen.
    """

    times: np.ndarray
    estimates: dict[str, np.ndarray]
    scores: np.ndarray | None
    seen: np.ndarray


@dataclass(frozen=True)
class PairFile:
    """A whole file, F frames of n sequences end to end.

    estimates, truths: by representation ("3d" metres about the mid-hip, "2d" pixels), [F, K, D].
    seen: [F], every value of the estimate is finite. estimated: [F], the frames that were given to
    the estimator. scores: [F, K] 0 to 1, box: [F, 4] x0, y0, x1, y1 in pixels, ms: [F]
    milliseconds of the estimator; None where the file has none. fps: [n].
    """

    path: Path
    estimator: str
    estimates: dict[str, np.ndarray]
    truths: dict[str, np.ndarray]
    start: np.ndarray
    length: np.ndarray
    fps: np.ndarray
    seen: np.ndarray
    estimated: np.ndarray
    scores: np.ndarray | None = None
    box: np.ndarray | None = None
    ms: np.ndarray | None = None

    @property
    def keypoints(self) -> int:
        """K."""
        return next(iter(self.estimates.values())).shape[1]

    def place(self, index: int) -> slice:
        """Where sequence `index` lies in the F frames."""
        return slice(int(self.start[index]), int(self.start[index] + self.length[index]))

    def sequence(self, index: int) -> Sequence:
        """One sequence."""
        place = self.place(index)
        return Sequence(
            times=np.arange(self.length[index]) / self.fps[index],
            estimates={name: poses[place] for name, poses in self.estimates.items()},
            scores=None if self.scores is None else self.scores[place],
            seen=self.seen[place],
        )

    def dense(self) -> list[int]:
        """The sequences of which every frame was given to the estimator."""
        return [i for i in range(len(self.start)) if self.estimated[self.place(i)].all()]

    def sequences(self, indices: list[int]) -> Iterator[tuple[slice, Sequence]]:
        """Places and sequences of `indices`."""
        for index in indices:
            yield self.place(index), self.sequence(index)


def read_pair_file(path: Path) -> PairFile:
    """Read and check a pair file. Raises UserError, one sentence, for the first thing wrong."""
    path = Path(path)
    if not path.is_file():
        raise UserError(f"There is no pair file at {path}; {HOW}.")
    try:
        with np.load(path, allow_pickle=False) as file:
            arrays = {name: file[name] for name in KNOWN if name in file}
    except (ValueError, TypeError, OSError, EOFError, zipfile.BadZipFile) as error:
        raise UserError(f"{path} is not a whole .npz of plain arrays; {HOW}.") from error
    return from_arrays(arrays, path)


def from_arrays(arrays: dict[str, np.ndarray], path: Path) -> PairFile:
    """The pair file of these arrays; `path` names it in errors. Raises UserError."""
    arrays = check(arrays, path)
    own = f"{arrays['pred'].shape[-1]}d"
    estimates, truths = {own: arrays["pred"]}, {own: arrays["gt"]}
    if "pred_2d" in arrays:
        estimates["2d"], truths["2d"] = arrays["pred_2d"], arrays["gt_2d"]
    finite = [np.isfinite(poses).all(axis=(1, 2)) for poses in estimates.values()]
    scores = arrays.get("scores")
    if scores is not None:
        finite.append(np.isfinite(scores).all(axis=1))
    seen = np.logical_and.reduce(finite)
    return PairFile(
        path=path,
        estimator=str(arrays["estimator"]) if "estimator" in arrays else path.stem,
        estimates=estimates,
        truths=truths,
        start=arrays["start"],
        length=arrays["length"],
        fps=np.broadcast_to(arrays.get("fps", DEFAULT_FPS), arrays["start"].shape),
        seen=seen,
        estimated=arrays.get("estimated", np.ones(len(seen), bool)),
        scores=scores,
        box=arrays.get("box"),
        ms=arrays.get("ms"),
    )

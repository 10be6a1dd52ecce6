"""Pair files as training wants them: estimates of the frames that have one, all files as one."""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from deciwatch.errors import UserError
from deciwatch.evaluation.pair_file import PairFile, read_pair_file
from deciwatch.skeleton import KEYPOINTS


@dataclass(frozen=True, eq=False)
class Pairs:
    """Sequences laid end to end: the truth of all F frames, estimates of the E where one was made.

    truth: by "3d" [F, 33, 3] metres about the mid-hip in camera axes, by "2d" [F, 33, 2] pixels.
    estimates: by "3d" and "2d" the same of the E frames, by "scores" [E, 33], 0 to 1; all finite.
    Both lack what the file lacks. seen: [E] the frames that have an estimate, ascending.
    start, length: [n] frames. fps: [n].
    """

    truth: dict[str, np.ndarray]
    estimates: dict[str, np.ndarray]
    seen: np.ndarray
    start: np.ndarray
    length: np.ndarray
    fps: np.ndarray

    @cached_property
    def first(self) -> np.ndarray:
        """Place in `seen` of each sequence's first estimate, [n]."""
        return np.searchsorted(self.seen, self.start)

    @cached_property
    def count(self) -> np.ndarray:
        """Estimates of each sequence, [n]."""
        return np.searchsorted(self.seen, self.start + self.length) - self.first

    @cached_property
    def stride(self) -> np.ndarray:
        """Frames from one estimate to the next, the usual number of each sequence, [n]."""
        edges = zip(self.first, self.first + self.count, strict=True)
        gaps = [np.diff(self.seen[begin:end]) for begin, end in edges]
        return np.array([float(np.median(gap)) if len(gap) else 1.0 for gap in gaps])


def load_pairs(paths: list[Path], inputs: tuple[str, ...]) -> Pairs:
    """Pair files as one. Raises UserError where one is unfit for nets with these inputs."""
    return join([_compact(read_pair_file(path), inputs) for path in paths])


def _compact(file: PairFile, inputs: tuple[str, ...]) -> Pairs:
    """Keep estimates only of the frames that have one: most of a training file's have none."""
    given = dict(file.estimates) | ({} if file.scores is None else {"scores": file.scores})
    lacking = [name for name in inputs if name not in given]
    if lacking:
        raise UserError(f"{file.path} has no {' and no '.join(lacking)}; name other --inputs.")
    if file.keypoints != KEYPOINTS:
        raise UserError(
            f"{file.path} has {file.keypoints} keypoints, but nets are trained on {KEYPOINTS}."
        )
    order = np.argsort(file.start, kind="stable")
    owned = np.zeros(len(file.seen), bool)
    for index in order:
        owned[file.place(index)] = True
    truths = file.truths.values()
    if not all(np.isfinite(poses[owned]).all() for poses in truths):
        raise UserError(f"The truth in {file.path} has gaps; nets are trained on whole sequences.")
    seen = np.flatnonzero(file.seen & file.estimated & owned)
    if not len(seen):
        raise UserError(f"Nobody was seen in any frame of {file.path}; make it anew.")
    return Pairs(
        truth={name: poses.astype(np.float32) for name, poses in file.truths.items()},
        estimates={name: values[seen].astype(np.float32) for name, values in given.items()},
        seen=seen,
        start=file.start[order].astype(np.int64),
        length=file.length[order].astype(np.int64),
        fps=np.asarray(file.fps, float)[order],
    )


def join(parts: list[Pairs]) -> Pairs:
    """Several files as one; what one of them lacks, none has."""
    if len(parts) == 1:
        return parts[0]
    offsets = np.cumsum([0, *(len(next(iter(part.truth.values()))) for part in parts[:-1])])

    def together(name: str) -> dict[str, np.ndarray]:
        tables = [getattr(part, name) for part in parts]
        common = set.intersection(*(set(table) for table in tables))
        return {key: np.concatenate([table[key] for table in tables]) for key in sorted(common)}

    def moved(name: str) -> np.ndarray:
        pieces = zip(parts, offsets, strict=True)
        return np.concatenate([getattr(part, name) + offset for part, offset in pieces])

    return Pairs(
        truth=together("truth"),
        estimates=together("estimates"),
        seen=moved("seen"),
        start=moved("start"),
        length=np.concatenate([part.length for part in parts]),
        fps=np.concatenate([part.fps for part in parts]),
    )

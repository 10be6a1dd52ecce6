"""`deciwatch evaluate --pairs`: an estimator's own poses, and all that can be made of them."""

import argparse
from collections.abc import Iterable
from pathlib import Path

import numpy as np

from deciwatch.errors import UserError
from deciwatch.evaluation.available import available_methods
from deciwatch.evaluation.baselines_file import read_baselines
from deciwatch.evaluation.costs import estimator_flops, estimator_ms
from deciwatch.evaluation.counted_nets import CountedNets, from_checkpoint, from_models
from deciwatch.evaluation.method import METHODS, RECOVERED
from deciwatch.evaluation.options import intervals_of
from deciwatch.evaluation.pair_file import PairFile, read_pair_file
from deciwatch.evaluation.run_methods import rows_of, scored_frames
from deciwatch.evaluation.table import STDOUT, say, show

INTERVALS = (1, 3, 5, 7, 10, 15, 20)


def run(args: argparse.Namespace) -> int:
    """Score every file; print the table or write the JSON."""
    every = intervals_of(args.every, INTERVALS)
    wanted = _methods(args.methods)
    files = [read_pair_file(Path(path)) for path in args.pairs]
    _check_names(files)
    dense = [_dense(file) for file in files]
    scored = [scored_frames(file, own, every) for file, own in zip(files, dense, strict=True)]
    scored = _shared(files, scored)
    pairs = _nets(args, files) if set(wanted) & set(RECOVERED) else {}
    baselines = read_baselines(Path(args.baselines))

    def rows() -> Iterable[dict]:
        for file, own, frames in zip(files, dense, scored, strict=True):
            methods = available_methods(file, wanted, pairs, baselines, say)
            costs = estimator_flops(file.estimator), estimator_ms(file)
            yield from rows_of(file, own, methods, every, frames, costs, args.window)

    coverage = [_coverage(*each) for each in zip(files, dense, scored, strict=True)]
    if args.json != STDOUT:
        for line in coverage:
            print(
                f"{line['estimator']}: {line['scored']} of {line['frames']} frames in "
                f"{line['sequences']} sequences are scored, those to which every method gives a "
                "pose at every N"
            )
    show(rows(), [file.estimator for file in files], args.json, {"coverage": coverage})
    return 0


def _methods(given: str | None) -> tuple[str, ...]:
    if given is None:
        return METHODS
    wanted = tuple(name.strip() for name in given.split(","))
    for name in wanted:
        if name not in METHODS:
            raise UserError(f"--methods {name} is none of {', '.join(METHODS)}.")
    return tuple(name for name in METHODS if name in wanted)


def _check_names(files: list[PairFile]) -> None:
    """Rows are told apart by their estimator."""
    for i, file in enumerate(files):
        for other in files[:i]:
            if file.estimator == other.estimator:
                raise UserError(
                    f"{other.path} and {file.path} are both of {file.estimator}; score them one "
                    "by one."
                )


def _dense(file: PairFile) -> list[int]:
    """The sequences to score: watching every frame is what all else is compared with."""
    indices = file.dense()
    if not indices:
        raise UserError(
            f"No sequence in {file.path} was estimated at every frame; evaluation needs some."
        )
    if len(indices) < len(file.start):
        sparse = len(file.start) - len(indices)
        say(f"{sparse} sequences of {file.path} were not estimated at every frame: left out.")
    return indices


def _shared(files: list[PairFile], scored: list[np.ndarray]) -> list[np.ndarray]:
    """Files of the same truth are scored on the frames that all of them have, to be comparable."""
    return [
        np.logical_and.reduce(
            [theirs for other, theirs in zip(files, scored, strict=True) if _alike(file, other)]
        )
        for file in files
    ]


def _alike(file: PairFile, other: PairFile) -> bool:
    if file is other:
        return True
    return (
        file.truths.keys() == other.truths.keys()
        and np.array_equal(file.start, other.start)
        and np.array_equal(file.length, other.length)
        and all(
            np.array_equal(file.truths[x], other.truths[x], equal_nan=True) for x in file.truths
        )
    )


def _nets(args: argparse.Namespace, files: list[PairFile]) -> dict[str, CountedNets]:
    """The nets by representation: of checkpoints where any is named, else of a models folder."""
    checkpoints = {"3d": args.checkpoint_3d, "2d": args.checkpoint_2d}
    needed = [name for name in checkpoints if any(name in file.estimates for file in files)]
    if any(checkpoints.values()):
        return {
            name: from_checkpoint(Path(checkpoints[name]), int(name[0]))
            for name in needed
            if checkpoints[name]
        }
    return {name: from_models(Path(args.models), int(name[0])) for name in needed}


def _coverage(file: PairFile, indices: list[int], scored: np.ndarray) -> dict:
    frames = int(file.length[indices].sum())
    line = {"file": file.path.name, "estimator": file.estimator, "sequences": len(indices)}
    return line | {"frames": frames, "scored": int(scored.sum())}

"""A folder of the CMU database's own files, anyone's copy, as training data."""

import sys
from pathlib import Path

import numpy as np

from deciwatch.errors import UserError
from deciwatch.motion.motions import FPS, Motions
from deciwatch.motion.raw import landmarks, read_body

SHORTEST = 30  # frames at 30 a second


def split_of(subject: str) -> str:
    """The split of a subject: two in ten test, one in ten val; nobody is in two."""
    last = sum(subject.encode()) % 10
    return "test" if last in (0, 5) else "val" if last == 3 else "train"


def read_folder(directory: Path, split: str) -> Motions:
    """Every SUBJECT_TRIAL.bvh and .amc below a folder whose subject is in a split.

    Files that cannot be read are named on stderr and left out. Raises UserError if none is left.
    """
    paths = sorted(p for p in Path(directory).rglob("*") if p.suffix.lower() in (".bvh", ".amc"))
    if not paths:
        raise UserError(
            f"{directory} holds neither cmu30_*.npz nor .bvh or .amc files; point --data elsewhere."
        )
    kept: list[np.ndarray] = []
    names: list[str] = []
    for path in paths:
        if split_of(path.stem.split("_")[0]) != split:
            continue
        try:
            poses = landmarks(read_body(path), FPS)
        except UserError as error:
            print(f"left out: {error}", file=sys.stderr)
            continue
        if len(poses) >= SHORTEST:
            kept.append(poses)
            names.append(path.stem)
    if not kept:
        raise UserError(
            f"{directory} has no {split} recording of a second or more; add subjects to it."
        )
    lengths = np.array([len(poses) for poses in kept])
    stacked = np.concatenate(kept)
    stacked.setflags(write=False)
    return Motions(stacked, np.cumsum(lengths) - lengths, lengths, tuple(names))

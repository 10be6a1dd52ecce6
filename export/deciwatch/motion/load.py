"""Motions of a data folder: shards where it has them, else the CMU database's own files."""

from functools import lru_cache
from pathlib import Path

from deciwatch.motion.cmu import shard_motions
from deciwatch.motion.folder import read_folder
from deciwatch.motion.motions import Motions


@lru_cache(maxsize=4)
def load_motions(directory: Path, split: str) -> Motions:
    """Every sequence of a split; kept in memory, so its landmarks are read-only."""
    if any(Path(directory).glob("cmu30_*.npz")):
        return shard_motions(directory, split)
    return read_folder(directory, split)

"""The test pairs that the studies are scored on, and the frames of them that count."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from deciwatch.errors import UserError
from deciwatch.evaluation.pair_file import PairFile, read_pair_file
from deciwatch.evaluation.run_methods import scored_frames
from deciwatch.evaluation.score_pairs import INTERVALS


@dataclass(frozen=True)
class ScoredPairs:
    """A pair file, its sequences that were estimated at every frame, the frames [F] scored."""

    file: PairFile
    indices: list[int]
    scored: np.ndarray

    def about(self) -> dict:
        """What of it goes into a study's JSON."""
        return {
            "file": self.file.path.name,
            "estimator": self.file.estimator,
            "sequences": len(self.indices),
            "frames": int(self.scored.sum()),
        }


def read_scored_pairs(path: Path) -> ScoredPairs:
    """The file, with the frames that `deciwatch evaluate --pairs` scores. Raises UserError."""
    file = read_pair_file(path)
    indices = file.dense()
    if not indices or "3d" not in file.truths:
        raise UserError(f"{path} has no 3D poses estimated at every frame; the studies need some.")
    return ScoredPairs(file, indices, scored_frames(file, indices, list(INTERVALS)))

"""What a row costs for each frame: FLOPs and milliseconds, the estimator's share included."""

import json
from dataclasses import dataclass

import numpy as np

from deciwatch.evaluation.pair_file import PairFile
from deciwatch.paths import ESTIMATORS

PREFIX = "mediapipe-"


@dataclass
class Cost:
    """Sums over sequences: all frames, those watched, the method's own FLOPs and CPU seconds.

    CPU seconds, because they are the same on a busy machine.
    """

    frames: int = 0
    watched: int = 0
    flops: int = 0
    seconds: float = 0.0

    def figures(self, call_flops: int | None, call_ms: float | None) -> dict[str, float | None]:
        """Per frame, with the FLOPs and ms of one call of the estimator; None where unknown."""
        share = self.watched / self.frames
        flops = None if call_flops is None else call_flops * share + self.flops / self.frames
        own_ms = 1000 * self.seconds / self.frames
        ms = None if call_ms is None else call_ms * share + own_ms
        return {"flops_per_frame": flops, "ms_per_frame": ms}


def estimator_flops(name: str) -> int | None:
    """FLOPs of one call of an estimator that ships, such as "mediapipe-full"; None of others."""
    estimators = json.loads(ESTIMATORS.read_text())["estimators"]
    entry = estimators.get(name.removeprefix(PREFIX)) if name.startswith(PREFIX) else None
    return None if entry is None else entry["flops"]["perCall"]


def estimator_ms(file: PairFile) -> float | None:
    """Median milliseconds of one call, of the frames that were timed; None if none was."""
    if file.ms is None or not np.isfinite(file.ms).any():
        return None
    return float(np.nanmedian(file.ms))

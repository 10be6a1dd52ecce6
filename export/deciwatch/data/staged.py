"""Training windows of clips that were staged but not rendered: the estimates are made noise.

The truth of such clips is the rendered ones' in every respect (the same avatars' bodies, landmarks
and cameras), which recorded motion's is not, and there can be as many as memory holds.
"""

from pathlib import Path

import numpy as np

from deciwatch.data.batch import Batch
from deciwatch.data.pairs import pair_batch
from deciwatch.data.residuals import ResidualNoise
from deciwatch.data.training_pairs import Pairs
from deciwatch.errors import UserError


def load_staged(path: Path) -> Pairs:
    """The file that `deciwatch pairs --truth-only` writes: every frame may be a sample.

    Raises UserError if it is not one.
    """
    try:
        with np.load(path) as file:
            truth = {"3d": file["gt"], "2d": file["gt_2d"]}
            start, length = file["start"], file["length"]
            fps = np.full(len(start), float(file["fps"]))
    except (OSError, KeyError, ValueError) as error:
        raise UserError(
            f"{path} holds no staged clips ({error}); make it by `deciwatch pairs --truth-only`."
        ) from error
    return Pairs(truth, {}, np.arange(len(truth["3d"])), start, length, fps)


def staged_batch(
    rng: np.random.Generator,
    staged: Pairs,
    noise: ResidualNoise,
    inputs: tuple[str, ...],
    few: bool,
    sparse: bool = False,
    budget: int = 1616,
) -> Batch:
    """A batch as `pair_batch` makes them, with estimates drawn from `noise`."""
    return pair_batch(rng, staged, inputs, few, sparse, budget, noise)

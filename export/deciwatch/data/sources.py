"""Where a training run's batches come from: recorded motion, staged clips, pairs, by turns."""

from dataclasses import dataclass

import numpy as np

from deciwatch.data.batch import Batch
from deciwatch.data.batches import Estimator, training_batch
from deciwatch.data.noise import NONE
from deciwatch.data.pairs import pair_batch
from deciwatch.data.staged import staged_batch
from deciwatch.data.training_pairs import Pairs
from deciwatch.motion.motions import Motions


@dataclass(frozen=True)
class Sources:
    """Draws batches for nets with these inputs.

    few: score random frames of each gap alone (RecoverNets with tokens for the samples). pairs:
    what `share` of the batches are of. The others are staged clips, or recorded motion where there
    are none, as `estimator` sees them.
    """

    motions: Motions | None
    inputs: tuple[str, ...]
    estimator: Estimator
    few: bool = False
    pairs: Pairs | None = None
    share: float = 0.0
    staged: Pairs | None = None
    budget: int = 1616

    def __call__(self, rng: np.random.Generator, sparse: bool = False) -> Batch:
        """A batch; of the samples alone where `sparse`."""
        if self.pairs is not None and rng.random() < self.share:
            return pair_batch(rng, self.pairs, self.inputs, self.few, sparse, self.budget)
        if self.staged is not None:
            return staged_batch(
                rng, self.staged, self.estimator, self.inputs, self.few, sparse, self.budget
            )
        return training_batch(
            rng,
            self.motions,
            self.inputs,
            sparse,
            self.budget,
            self.estimator,
            few=self.few and not sparse,
            grafted=self.estimator is NONE,
        )

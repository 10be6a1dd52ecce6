"""What every way of filling in a sequence is: a function from its estimates to all its poses."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from deciwatch.evaluation.pair_file import Sequence
from deciwatch.evaluation.plan import Plan


class Filled(NamedTuple):
    """Poses by representation, [T, K, D], NaN where there is none, and the FLOPs that they took.

    FLOPs are those beside the estimator's; classical methods have next to none.
    """

    poses: dict[str, np.ndarray]
    flops: int = 0


Method = Callable[[Sequence, Plan], Filled]

EVERY_FRAME = ("every_frame", "every_frame_calibrated", "one_euro", "smoothnet")
CLASSICAL = ("nearest", "linear", "quadratic", "cubic")
RECOVERED = ("no_denoise", "no_recover", "deciwatch")
METHODS = (*EVERY_FRAME, *CLASSICAL, *RECOVERED)

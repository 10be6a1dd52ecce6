"""Running methods over a file's sequences and scoring them all on the same frames."""

import time
from collections.abc import Iterable

import numpy as np

from deciwatch.errors import UserError
from deciwatch.evaluation.costs import Cost
from deciwatch.evaluation.method import EVERY_FRAME, Method
from deciwatch.evaluation.pair_file import PairFile
from deciwatch.evaluation.plan import make_plan
from deciwatch.evaluation.scoring import score
from deciwatch.sampling.windows import WINDOW_INTERVALS


def scored_frames(file: PairFile, indices: list[int], intervals: list[int]) -> np.ndarray:
    """Frames, [F], with a truth and an estimate to which every method gives a pose at every N.

    Raises UserError where that leaves none.
    """
    finite = [np.isfinite(truth).all(axis=(1, 2)) for truth in file.truths.values()]
    usable = np.logical_and.reduce([file.seen, *finite])
    scored = np.zeros_like(usable)
    for place, sequence in file.sequences(indices):
        covered = [make_plan(sequence, every).covered() for every in intervals]
        scored[place] = usable[place] & np.logical_and.reduce(covered)
    if not scored.any():
        raise UserError(
            f"In {file.path} no frame has a truth and a pose at every interval; give longer "
            "sequences, or smaller intervals by --every."
        )
    return scored


def run_method(
    file: PairFile, indices: list[int], method: Method, every: int, intervals: int
) -> tuple[dict[str, np.ndarray], Cost]:
    """Poses by representation, [F, K, D], and the cost, of one method on the named sequences."""
    poses = {name: np.full_like(truth, np.nan) for name, truth in file.truths.items()}
    filled_in, cost = set(), Cost()
    for place, sequence in file.sequences(indices):
        plan = make_plan(sequence, every, intervals)
        begun = time.process_time()
        filled = method(sequence, plan)
        cost.seconds += time.process_time() - begun
        cost.frames += len(sequence.times)
        cost.watched += len(plan.watched)
        cost.flops += filled.flops
        for name, values in filled.poses.items():
            poses[name][place] = values
            filled_in.add(name)
    return {name: values for name, values in poses.items() if name in filled_in}, cost


def rows_of(
    file: PairFile,
    indices: list[int],
    methods: dict[str, Method],
    every: Iterable[int],
    scored: np.ndarray,
    call_costs: tuple[int | None, float | None],
    intervals: int = WINDOW_INTERVALS,
) -> Iterable[dict]:
    """One row for each method and interval; those that see every frame have one row, interval 1.

    call_costs: FLOPs and milliseconds of one call of the estimator, None where unknown.
    """
    for name, method in methods.items():
        for interval in [1] if name in EVERY_FRAME else every:
            poses, cost = run_method(file, indices, method, interval, intervals)
            row = {"method": name, "interval": interval, "estimator": file.estimator}
            row |= score(file, poses, scored) | cost.figures(*call_costs)
            yield row | {"frames": int(scored.sum())}

"""Fitting what DeciWatch is compared with: calibration, and the 1€ filter's settings."""

import itertools

import numpy as np

from deciwatch.errors import UserError
from deciwatch.evaluation import calibration
from deciwatch.evaluation.one_euro import one_euro
from deciwatch.evaluation.pair_file import PairFile
from deciwatch.evaluation.plan import make_plan
from deciwatch.metrics import distances
from deciwatch.normalise import frame_of, from_net, to_net

MIN_CUTOFFS = (0.5, 1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0)  # Hz
BETAS = (0.0, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0)  # Hz per net unit and second


def fit_calibration(files: list[PairFile]) -> dict[str, np.ndarray]:
    """Maps [K, D, D + 1] by representation, from every frame with an estimate and a truth."""
    maps = {}
    for name in files[0].truths:
        usable = [file.seen & np.isfinite(file.truths[name]).all(axis=(1, 2)) for file in files]
        estimates, truth = (
            np.concatenate([table[rows] for table, rows in zip(tables, usable, strict=True)])
            for tables in ([f.estimates[name] for f in files], [f.truths[name] for f in files])
        )
        maps[name] = calibration.fit(estimates, truth)
    return maps


def dense_segments(files: list[PairFile], name: str):
    """Seen frames' estimates and truths [S, K, D], frame numbers [S] and times [S], by segment.

    Only of sequences that were estimated at every frame. Raises UserError if there is none.
    """
    found = False
    for file in files:
        for place, sequence in file.sequences(file.dense()):
            truth = file.truths[name][place]
            for seen in make_plan(sequence, 1).segments:
                known = seen[np.isfinite(truth[seen]).all(axis=(1, 2))]
                if len(known):
                    found = True
                    estimates = sequence.estimates[name][known]
                    yield estimates, truth[known], known, sequence.times[known]
    if not found:
        names = " and ".join(str(file.path) for file in files)
        raise UserError(
            f"{names} have no sequence that was estimated at every frame; the filters need some."
        )


def tune_one_euro(files: list[PairFile], name: str) -> tuple[tuple[float, float], float]:
    """The (min_cutoff, beta) with the least MPJPE, and that MPJPE in metres or pixels."""
    grid = np.array(list(itertools.product(MIN_CUTOFFS, BETAS)))
    min_cutoff, beta = grid[:, :1], grid[:, 1:]
    total, count = np.zeros(len(grid)), 0
    for estimates, truth, _, times in dense_segments(files, name):
        frame = frame_of(estimates)
        filtered = one_euro(to_net(estimates, *frame), times, min_cutoff, beta)
        poses = from_net(filtered.transpose(1, 0, 2), *frame)
        total += distances(poses, truth).sum(axis=(1, 2))
        count += truth.shape[0] * truth.shape[1]
    best = int(total.argmin())
    return (float(grid[best, 0]), float(grid[best, 1])), float(total[best] / count)

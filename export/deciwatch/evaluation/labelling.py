"""`deciwatch evaluate --labelling`: true poses of one frame in N in, all others recovered.

The paper's "efficient labelling": somebody labels one frame in N by hand, the net does the rest.
"""

import argparse
from pathlib import Path

import numpy as np

from deciwatch.evaluation.classical import interpolated
from deciwatch.evaluation.counted_nets import from_checkpoint
from deciwatch.evaluation.method import CLASSICAL
from deciwatch.evaluation.options import intervals_of
from deciwatch.evaluation.pair_file import PairFile, from_arrays
from deciwatch.evaluation.recovered import recovered
from deciwatch.evaluation.run_methods import rows_of, scored_frames
from deciwatch.evaluation.table import show
from deciwatch.motion.load import load_motions
from deciwatch.motion.motions import Motions
from deciwatch.paths import CHECKPOINTS, data_directory
from deciwatch.skeleton import mid_hip

INTERVALS = (2, 5, 10, 15, 20)
LABELLER = "truth"


def run(args: argparse.Namespace) -> int:
    """Score the net and the interpolations on whole sequences of recorded motion."""
    every = intervals_of(args.every, INTERVALS)
    directory = data_directory(args.data)
    pair = from_checkpoint(Path(args.checkpoint or CHECKPOINTS / "label.pt"), 3)
    file = true_poses(load_motions(directory, args.split), directory)
    indices = file.dense()
    scored = scored_frames(file, indices, every)
    methods = {kind: interpolated(kind) for kind in CLASSICAL}
    methods["deciwatch"] = recovered({"3d": pair})
    # Nobody's FLOPs or milliseconds: the labels are there.
    rows = rows_of(file, indices, methods, every, scored, (0, 0.0), args.window)
    show(rows, [LABELLER], args.json, {"split": args.split, "frames": int(scored.sum())})
    return 0


def true_poses(motions: Motions, path: Path) -> PairFile:
    """Recorded motion as a pair file whose estimates are the truth, about the mid-hip."""
    poses = (motions.landmarks - mid_hip(motions.landmarks)).astype(np.float32)
    arrays = {"pred": poses, "gt": poses, "start": motions.start, "length": motions.length}
    arrays |= {"fps": np.array(motions.fps), "estimator": np.array(LABELLER)}
    return from_arrays({name: np.asarray(array) for name, array in arrays.items()}, path)

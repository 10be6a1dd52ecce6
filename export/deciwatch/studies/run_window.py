"""`deciwatch study window`: how many intervals the nets see at once."""

import argparse
from pathlib import Path

from deciwatch.evaluation.costs import estimator_flops, estimator_ms
from deciwatch.evaluation.counted_nets import from_models
from deciwatch.evaluation.recovered import recovered
from deciwatch.evaluation.run_methods import rows_of
from deciwatch.studies.document import rounded, write_document
from deciwatch.studies.scored_pairs import read_scored_pairs

INTERVAL = 10
WINDOWS = (1, 2, 3, 5, 10)
FIGURES = ("mpjpe_mm", "pa_mpjpe_mm", "accel_mm", "flops_per_frame", "ms_per_frame")


def run(args: argparse.Namespace) -> int:
    """Score the shipped 3D nets with every window and write the JSON."""
    test = read_scored_pairs(Path(args.test))
    method = recovered({"3d": from_models(Path(args.models), 3)})
    costs = estimator_flops(test.file.estimator), estimator_ms(test.file)
    rows = []
    for window in WINDOWS:
        (row,) = rows_of(
            test.file, test.indices, {"deciwatch": method}, [INTERVAL], test.scored, costs, window
        )
        rows.append(rounded({"window": window} | {key: row[key] for key in FIGURES}))
        print(f"Q = {window}: {row['mpjpe_mm']:.1f} mm", flush=True)
    write_document(Path(args.out), {"interval": INTERVAL, "test": test.about()}, rows)
    return 0

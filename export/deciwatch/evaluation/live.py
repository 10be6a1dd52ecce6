"""`deciwatch evaluate --live --pairs`: what is on screen live, against the truth of that moment."""

import argparse
import json
from collections.abc import Iterable
from pathlib import Path

import numpy as np

from deciwatch.atomic import write_text
from deciwatch.errors import UserError
from deciwatch.evaluation.baselines_file import read_baselines
from deciwatch.evaluation.options import intervals_of
from deciwatch.evaluation.pair_file import PairFile, read_pair_file
from deciwatch.evaluation.scoring import score
from deciwatch.evaluation.table import STDOUT, rounded
from deciwatch.live.methods import (
    Live,
    Method,
    every_frame,
    every_frame_now,
    filtered,
    hold,
    linear,
    now,
    smooth,
)
from deciwatch.runner import Nets, onnx_nets

INTERVALS = (5, 10, 20)
# These watch every frame, and do so once.
AT_EVERY_FRAME = ("every_frame", "every_frame_now", "one_euro")
COLUMNS = (("MPJPE mm", "mpjpe_mm"), ("PA mm", "pa_mpjpe_mm"), ("Accel mm", "accel_mm"))
COLUMNS += (("MPJPE px", "mpjpe_px"), ("Accel px", "accel_px"))


def run(args: argparse.Namespace) -> int:
    """Score every file; print the table or write the JSON."""
    if args.late < 0:
        raise UserError(f"--late {args.late} is before the look; give 0 or more frames.")
    every = intervals_of(args.every, INTERVALS)
    rows = []
    for path in args.pairs:
        file = read_pair_file(Path(path))
        for late in sorted({0, args.late}):
            rows += _rows(args, file, every, late)
    document = json.dumps({"rows": [rounded(row) for row in rows]}, indent=2) + "\n"
    if args.json == STDOUT:
        print(document, end="")
        return 0
    _print(rows)
    if args.json:
        write_text(Path(args.json), document)
    return 0


def _rows(args: argparse.Namespace, file: PairFile, every: list[int], late: int) -> Iterable[dict]:
    nets = {name: onnx_nets(Path(args.models), int(name[0])) for name in file.estimates}
    methods = _methods(nets, args)
    found = {}
    for name, method in methods.items():
        for interval in [1] if name in AT_EVERY_FRAME else every:
            found[name, interval] = _played(file, method, interval, late)
    # All on the same frames: those for which every method has a pose on screen.
    usable = [np.isfinite(truth).all(axis=(1, 2)) for truth in file.truths.values()]
    for poses, _ in found.values():
        usable += [np.isfinite(values).all(axis=(1, 2)) for values in poses.values()]
    scored = np.logical_and.reduce(usable)
    if not scored.any():
        raise UserError(f"In {file.path} no frame has a pose by every method; give longer clips.")
    for (name, interval), (poses, delay) in found.items():
        row = {"method": name, "interval": interval, "estimator": file.estimator, "late": late}
        row |= {"delay_frames": delay, "frames": int(scored.sum())}
        yield row | score(file, poses, scored) | {"flops_per_frame": None}


def _methods(nets: dict[str, Nets], args: argparse.Namespace) -> dict[str, Method]:
    methods: dict[str, Method] = {
        "every_frame": every_frame,
        "every_frame_now": every_frame_now,
    }
    baselines = read_baselines(Path(args.baselines))
    if set(nets) <= set(baselines.one_euro):
        methods["one_euro"] = filtered(baselines)
    methods |= {"hold": hold, "linear": linear, "smooth": smooth(nets)}
    if all(own.forecast for own in nets.values()):
        methods["now"] = now(nets)
    return methods


def _played(
    file: PairFile, method: Method, every: int, late: int
) -> tuple[dict[str, np.ndarray], int]:
    """Poses by representation, [F, K, D], NaN where nothing is shown, and the delay in frames."""
    poses = {name: np.full(truth.shape, np.nan) for name, truth in file.truths.items()}
    delay = 0
    for place, sequence in file.sequences(file.dense()):
        if len(sequence.times) < 2:
            continue
        shown, delay = method(Live(sequence, every, late))
        for name, values in shown.items():
            poses[name][place] = values
    return poses, delay


def _print(rows: list[dict]) -> None:
    print(f"{'estimator':15}  {'method':15}  {'N':>2}  {'late':>4}  {'delay':>5}", end="")
    print("".join(f"  {title:>8}" for title, _ in COLUMNS))
    for row in rows:
        print(
            f"{row['estimator']:15}  {row['method']:15}  {row['interval']:>2}  {row['late']:>4}  "
            f"{row['delay_frames']:>5}"
            + "".join(f"  {row[key]:8.1f}" for _, key in COLUMNS if row[key] is not None)
        )

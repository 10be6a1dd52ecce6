"""`deciwatch evaluate` without pairs: recorded motion, an estimator's noise added, in windows."""

import argparse
import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from deciwatch.atomic import write_text
from deciwatch.data.camera import draw_views
from deciwatch.data.noise import NOMINAL, NONE, add_noise
from deciwatch.data.noise_file import load_noise
from deciwatch.data.windows import slices
from deciwatch.errors import UserError
from deciwatch.evaluation.options import intervals_of
from deciwatch.evaluation.scoring import NEAR
from deciwatch.evaluation.table import STDOUT
from deciwatch.interpolate import METHODS, interpolate
from deciwatch.metrics import accel, mpjpe, pck
from deciwatch.motion.load import load_motions
from deciwatch.motion.motions import Motions
from deciwatch.normalise import Samples
from deciwatch.paths import CHECKPOINTS, data_directory
from deciwatch.runner import Nets, onnx_nets, recover_window, torch_nets

SEED = 11
INTERVAL = 10


def run(args: argparse.Namespace) -> int:
    """Print one row a method, and write them where --json says."""
    intervals = intervals_of(args.every, (INTERVAL,))
    if len(intervals) > 1:
        raise UserError(f"--every {args.every} needs --pairs or --labelling; give one interval.")
    every = intervals[0]
    directory = data_directory(args.data)
    if args.checkpoint:
        nets = torch_nets(Path(args.checkpoint), args.dims)
    else:
        nets = onnx_nets(Path(args.models), args.dims)
    motions = load_motions(directory, args.split)
    truths, estimates = _windows(motions, every, args.window, args.noise)
    truth = truths[f"{args.dims}d"]
    if not len(truth):
        raise UserError(f"No {args.split} sequence fills a window; lower --every or --window.")
    watched = np.arange(args.window + 1) * every
    rows = [
        {"method": name, "interval": 1 if name == "every_frame" else every}
        | _score(poses, truth, args.dims)
        for name, poses in _recovered(nets, estimates, watched, motions.fps)
    ]
    settings = {"dims": args.dims, "split": args.split, "noise": args.noise, "seed": SEED}
    settings |= {"interval": every, "window": args.window, "windows": len(truth)}
    document = json.dumps(settings | {"rows": rows}, indent=2) + "\n"
    if args.json == STDOUT:
        print(document, end="")
        return 0
    print(f"{len(truth)} windows of {truth.shape[1]} frames, {args.dims}D, noise {args.noise}")
    _print(rows)
    if args.json:
        write_text(Path(args.json), document)
    return 0


def _windows(
    motions: Motions, interval: int, intervals: int, noise: str
) -> tuple[dict[str, np.ndarray], dict[str, np.ndarray]]:
    """True poses [B, T, 33, D] of every window by "3d" and "2d", and estimates of them, seeded.

    Beside those two, the estimates have "scores" [B, T, 33].
    """
    frames = np.arange(interval * intervals + 1)
    places = slices(motions, interval, intervals)
    if not places:
        return {name: np.zeros((0, len(frames), 33, d)) for name, d in (("3d", 3), ("2d", 2))}, {}
    world = np.stack([motions.sequence(index)[first + frames] for index, first in places])
    rng = np.random.default_rng(SEED)
    views = draw_views(rng, world)
    truths = {"3d": views.poses3d(world), "2d": views.poses2d(world)}
    times = np.broadcast_to(frames / motions.fps, truths["3d"].shape[:2])
    if noise == "fitted":
        model = load_noise(CHECKPOINTS / "noise.npz")
        return truths, model.draw(rng, truths["3d"], truths["2d"], times, severity=(1.0, 1.0))
    made = NOMINAL if noise == "nominal" else NONE
    estimates = {name: add_noise(rng, poses, times, made) for name, poses in truths.items()}
    # Such noise says nothing of how sure it is.
    return truths, estimates | {"scores": np.ones(truths["3d"].shape[:3], np.float32)}


def _recovered(
    nets: Nets, estimates: dict[str, np.ndarray], watched: np.ndarray, fps: float
) -> Iterator[tuple[str, np.ndarray]]:
    """Each method's name and its poses [B, T, 33, D]; all but the first see `watched` alone."""
    own = estimates[f"{nets.dims}d"]
    batch, frames = own.shape[:2]
    seconds = np.arange(frames) / fps
    yield "every_frame", own
    for method in METHODS:
        # The windows have the same times, so one call serves them all.
        columns = own[:, watched].transpose(1, 0, 2, 3).reshape(len(watched), -1)
        filled = interpolate(seconds[watched], columns, seconds, method)
        yield method, filled.reshape(frames, batch, *own.shape[2:]).transpose(1, 0, 2, 3)
    seen = (estimates[name][:, watched] for name in ("3d", "2d", "scores"))
    windows = (Samples(*window) for window in zip(*seen, strict=True))
    yield (
        "deciwatch",
        np.stack([recover_window(nets, x, seconds[watched], seconds).poses for x in windows]),
    )


def _score(poses: np.ndarray, truth: np.ndarray, dims: int) -> dict[str, float]:
    """MPJPE and Accel in mm (3D), or in px with PCK (2D); Accel only of three frames or more."""
    unit, factor = ("mm", 1000.0) if dims == 3 else ("px", 1.0)
    score = {f"mpjpe_{unit}": mpjpe(poses, truth) * factor}
    if truth.shape[1] >= 3:
        score[f"accel_{unit}"] = accel(poses, truth) * factor
    if dims == 2:
        score |= {name: pck(poses, truth, near) for name, near in NEAR.items()}
    return {name: round(value, 4) for name, value in score.items()}


def _print(rows: list[dict]) -> None:
    names = list(rows[0])
    print("  ".join(f"{name:>12}" for name in names))
    for row in rows:
        cells = (f"{x:12.3f}" if isinstance(x, float) else f"{x:>12}" for x in row.values())
        print("  ".join(cells))

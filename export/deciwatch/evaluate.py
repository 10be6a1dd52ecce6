"""`deciwatch evaluate`: the nets against watching every frame and classical interpolation."""

import argparse
import json
from pathlib import Path

from deciwatch.paths import MODELS, data_directory

SEED = 11
NEAR = (0.05, 0.1, 0.2)  # of the box, for PCK


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("--data", metavar="DIR", help="motion folder (else $DECIWATCH_DATA)")
    parser.add_argument("--split", choices=("val", "test"), default="test")
    parser.add_argument("--dims", type=int, choices=(2, 3), default=3)
    parser.add_argument("--every", type=int, default=10, metavar="N", help="interval, 1 to 20")
    parser.add_argument("--window", type=int, default=10, metavar="Q", help="intervals, 1 to 10")
    parser.add_argument("--noise", choices=("nominal", "none"), default="nominal")
    source = parser.add_mutually_exclusive_group()
    source.add_argument("--models", metavar="DIR", default=str(MODELS), help="run what ships")
    source.add_argument("--checkpoint", metavar="FILE", help="run a checkpoint by torch instead")
    parser.add_argument("--json", metavar="FILE", help="also write the rows there")


def run(args: argparse.Namespace) -> int:
    """Print one row a method, and write them where --json says."""
    import numpy as np

    from deciwatch.atomic import write_text
    from deciwatch.data.batches import INTERVALS, WINDOWS
    from deciwatch.data.noise import NOMINAL, NONE
    from deciwatch.errors import UserError
    from deciwatch.motion.load import load_motions
    from deciwatch.runner import onnx_nets, torch_nets

    for option, value, (low, high) in (
        ("--every", args.every, INTERVALS),
        ("--window", args.window, WINDOWS),
    ):
        if not low <= value <= high:
            raise UserError(f"{option} {value} is out of range; the nets know {low} to {high}.")
    directory = data_directory(args.data)
    if args.checkpoint:
        nets = torch_nets(Path(args.checkpoint), args.dims)
    else:
        nets = onnx_nets(Path(args.models), args.dims)
    motions = load_motions(directory, args.split)
    noise = NOMINAL if args.noise == "nominal" else NONE
    truth, estimate = _windows(motions, args.every, args.window, args.dims, noise)
    if not len(truth):
        raise UserError(f"No {args.split} sequence fills a window; lower --every or --window.")
    watched = np.arange(args.window + 1) * args.every
    rows = [
        {"method": name, "interval": args.every if name != "every_frame" else 1}
        | _score(poses, truth, args.dims)
        for name, poses in _recovered(nets, estimate, watched, motions.fps)
    ]
    print(f"{len(truth)} windows of {truth.shape[1]} frames, {args.dims}D, noise {args.noise}")
    _print(rows)
    if args.json:
        settings = {"dims": args.dims, "split": args.split, "noise": args.noise, "seed": SEED}
        settings |= {"interval": args.every, "window": args.window, "windows": len(truth)}
        write_text(Path(args.json), json.dumps(settings | {"rows": rows}, indent=2) + "\n")
    return 0


def _windows(motions, interval: int, intervals: int, dims: int, noise) -> tuple:
    """True poses and estimates [B, T, 33, D] of every window: metres or pixels, seeded."""
    import numpy as np

    from deciwatch.data.camera import draw_views
    from deciwatch.data.noise import add_noise
    from deciwatch.data.windows import slices

    frames = np.arange(interval * intervals + 1)
    places = slices(motions, interval, intervals)
    if not places:
        return np.zeros((0, len(frames), 33, dims)), None
    world = np.stack([motions.sequence(index)[first + frames] for index, first in places])
    rng = np.random.default_rng(SEED)
    views = draw_views(rng, world)
    truth = views.poses3d(world) if dims == 3 else views.poses2d(world)
    times = np.broadcast_to(frames / motions.fps, truth.shape[:2])
    return truth, add_noise(rng, truth, times, noise)


def _recovered(nets, estimate, watched, fps: float):
    """Each method's name and its poses [B, T, 33, D]; all but the first see `watched` alone."""
    import numpy as np

    from deciwatch.interpolate import METHODS, interpolate
    from deciwatch.runner import recover_window

    batch, frames = estimate.shape[:2]
    seconds = np.arange(frames) / fps
    yield "every_frame", estimate
    for method in METHODS:
        # The windows have the same times, so one call serves them all.
        columns = estimate[:, watched].transpose(1, 0, 2, 3).reshape(len(watched), -1)
        filled = interpolate(seconds[watched], columns, seconds, method)
        yield method, filled.reshape(frames, batch, *estimate.shape[2:]).transpose(1, 0, 2, 3)
    recovered = [
        recover_window(nets, samples, seconds[watched], seconds) for samples in estimate[:, watched]
    ]
    yield "deciwatch", np.stack(recovered)


def _score(poses, truth, dims: int) -> dict[str, float]:
    """MPJPE and Accel in mm (3D), or in px with PCK (2D); Accel only of three frames or more."""
    from deciwatch.metrics import accel, mpjpe, pck

    unit, factor = ("mm", 1000.0) if dims == 3 else ("px", 1.0)
    score = {f"mpjpe_{unit}": mpjpe(poses, truth) * factor}
    if truth.shape[1] >= 3:
        score[f"accel_{unit}"] = accel(poses, truth) * factor
    if dims == 2:
        score |= {f"pck_{near}": pck(poses, truth, near) for near in NEAR}
    return {name: round(value, 4) for name, value in score.items()}


def _print(rows: list[dict]) -> None:
    names = list(rows[0])
    print("  ".join(f"{name:>12}" for name in names))
    for row in rows:
        cells = (f"{x:12.3f}" if isinstance(x, float) else f"{x:>12}" for x in row.values())
        print("  ".join(cells))

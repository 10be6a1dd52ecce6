"""`deciwatch train`: train a pair of nets on recorded motion with made-up estimator noise."""

import argparse
import json
import time
from functools import partial
from pathlib import Path

from deciwatch.errors import UserError
from deciwatch.paths import REPOSITORY, RUNS, data_directory

DATA = (
    "CMU Graphics Lab Motion Capture Database (mocap.cs.cmu.edu, NSF EIA-0196217), "
    "21.4 min at 30 fps, mirrored, resized, at other speeds; made-up estimator noise"
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("--data", metavar="DIR", help="motion folder (else $DECIWATCH_DATA)")
    parser.add_argument("--dims", type=int, choices=(2, 3), default=3)
    parser.add_argument("--name", help="folder under runs/ (default: the representation, e.g. 3d)")
    budget = parser.add_mutually_exclusive_group()
    budget.add_argument(
        "--minutes", type=float, default=45.0, help="time to train for (default 45)"
    )
    budget.add_argument("--steps", type=int, help="steps to train for, instead of minutes")
    parser.add_argument("--resume", action="store_true", help="go on from runs/NAME/last.pt")
    parser.add_argument("--start-from", metavar="FILE", help="begin with a checkpoint's weights")
    parser.add_argument("--width", type=int, default=64, help="C (default 64)")
    parser.add_argument("--blocks", type=int, default=5, help="M (default 5)")
    parser.add_argument("--preliminary", choices=("linear", "cubic"), default="cubic")
    parser.add_argument("--dropout", type=float, default=0.1)
    parser.add_argument("--lam", type=float, default=5.0, help="λ of equation 6 (default 5)")
    parser.add_argument("--rate", type=float, default=1.5e-3, help="highest learning rate")
    parser.add_argument(
        "--denoise-first",
        type=float,
        default=0.12,
        metavar="SHARE",
        help="share of the budget spent on DenoiseNet alone (default 0.12)",
    )
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threads", type=int, default=1, help="torch threads (default 1)")
    parser.add_argument("--every", type=float, default=2.0, help="minutes between checkpoints")


def run(args: argparse.Namespace) -> int:
    """Train until the budget is used up; checkpoints and the log go to runs/NAME/."""
    import torch

    from deciwatch.data.batches import training_batch
    from deciwatch.motion.load import load_motions
    from deciwatch.nets.pair import PairConfig
    from deciwatch.trainer import Recipe, Trainer
    from deciwatch.validation import cached_batch, linear_errors, pair_errors

    _check(args)
    directory = data_directory(args.data)
    torch.set_num_threads(args.threads)
    motions = load_motions(directory, "train")
    folder = RUNS / (args.name or f"{args.dims}d")
    config = PairConfig(args.dims, args.width, args.blocks, args.preliminary, args.dropout)
    minutes = None if args.steps else args.minutes
    recipe = Recipe(
        args.steps,
        minutes,
        rate=args.rate,
        lam=args.lam,
        seed=args.seed,
        denoise_first=args.denoise_first,
    )
    trainer = Trainer(config, recipe, partial(training_batch, motions=motions, dims=args.dims))
    before = trainer.start_from(Path(args.start_from)) if args.start_from else {}
    if args.resume:
        # What had been done before this run began, if it had started from a checkpoint.
        noted = trainer.resume(folder / "last.pt")
        before = {key: noted[key] - count for key, count in trainer.counts().items()}
    batch = cached_batch(directory, args.dims)
    linear = linear_errors(batch, args.dims)
    unit = "mm" if args.dims == 3 else "px"
    print(f"validation, linear: {linear['position']:.2f} {unit}, {linear['accel']:.2f}", flush=True)

    def note() -> None:
        ours = pair_errors(trainer.averaged, batch, args.dims)
        training = {
            "data": DATA,
            "commit": _commit(),
            **{key: round(n + before.get(key, 0), 2) for key, n in trainer.counts().items()},
            "seed": args.seed,
            "validation": {"unit": unit, "interval": 10, "window": 10}
            | {f"linear_{key}": round(value, 2) for key, value in linear.items()}
            | {f"deciwatch_{key}": round(value, 2) for key, value in ours.items()},
        }
        trainer.save(folder / "last.pt", training)
        line = {"step": trainer.done, "minutes": training["minutes"], "loss": round(recent, 4)}
        print(json.dumps(line | ours | {"rate": round(trainer.rate(), 6)}), flush=True)

    recent, saved = 0.0, time.monotonic()
    while trainer.progress < 1:
        value = trainer.step()
        recent = value if trainer.done < 2 else recent + 0.02 * (value - recent)
        if time.monotonic() - saved > args.every * 60:
            note()
            saved = time.monotonic()
    note()
    return 0


def _check(args: argparse.Namespace) -> None:
    """Raise UserError for numbers that no training can have."""
    for name in ("minutes", "steps", "width", "blocks", "threads", "rate", "every"):
        value = getattr(args, name)
        if value is not None and value <= 0:
            raise UserError(f"--{name} {value} makes no training; give a number above 0.")
    if args.width % 4:
        raise UserError(
            f"--width {args.width} does not divide by four heads; give a multiple of 4."
        )
    if not 0 <= args.dropout < 1:
        raise UserError(f"--dropout {args.dropout} is no share; give 0 or more and less than 1.")


def _commit() -> str | None:
    """The revision of the working tree, None outside git or before the first commit."""
    import subprocess

    got = subprocess.run(
        ["git", "rev-parse", "--verify", "-q", "HEAD"],
        cwd=REPOSITORY,
        capture_output=True,
        text=True,
        check=False,
    )
    return got.stdout.strip() or None

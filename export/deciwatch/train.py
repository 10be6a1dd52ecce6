"""`deciwatch train`: train a pair of nets on recorded motion, on pairs, or on both."""

import argparse
import json
import time
from pathlib import Path
from typing import TYPE_CHECKING

from deciwatch.errors import UserError
from deciwatch.paths import REPOSITORY, RUNS, data_directory
from deciwatch.train_options import add_arguments, check

__all__ = ["add_arguments", "run"]

if TYPE_CHECKING:
    from deciwatch.data.sources import Sources
    from deciwatch.nets.pair import PairConfig
    from deciwatch.trainer import Trainer
    from deciwatch.validation import Validation

DATA = (
    "CMU Graphics Lab Motion Capture Database (mocap.cs.cmu.edu, NSF EIA-0196217), "
    "21.4 min at 30 fps, mirrored, resized, at other speeds"
)


def run(args: argparse.Namespace) -> int:
    """Train until the budget is used up; the log goes to the terminal, nets to runs/NAME/.

    last.pt is what `--resume` goes on from, best.pt the averaged weights that validated best.
    """
    import torch

    from deciwatch.trainer import Recipe, Trainer

    check(args)
    torch.set_num_threads(args.threads)
    config = _config(args)
    sources, validations = _data(args, config)
    recipe = Recipe(
        args.steps,
        None if args.steps else args.minutes,
        rate=args.rate,
        decay=args.decay,
        lam=args.lam,
        seed=args.seed,
        denoise_first=args.denoise_first,
    )
    trainer = Trainer(config, recipe, sources)
    folder = RUNS / (args.name or f"{args.dims}d")
    before = trainer.start_from(Path(args.start_from)) if args.start_from else {}
    if args.resume:
        # What had been done before this run began, if it had started from a checkpoint.
        noted = trainer.resume(folder / "last.pt")
        before = {key: noted[key] - count for key, count in trainer.counts().items()}
    elif not args.start_from:
        # Where most of 2D errs little and some of it wildly, least squares follows the latter.
        if args.pairs and args.dims == 3:
            trainer.start_linearly()
        if args.recover_from:
            trainer.recover_from(Path(args.recover_from))
    for name, validation in validations.items():
        for method, found in validation.baselines.items():
            print(json.dumps({"validation": name, "method": method} | _rounded(found)), flush=True)

    recent, saved = 0.0, time.monotonic()
    while trainer.progress < 1:
        value = trainer.step()
        recent = value if trainer.done < 2 else recent + 0.02 * (value - recent)
        if time.monotonic() - saved > args.every * 60 or trainer.progress >= 1:
            _note(args, trainer, validations, folder, before, recent)
            saved = time.monotonic()
    return 0


def _config(args: argparse.Namespace) -> "PairConfig":
    """The nets asked for. Raises UserError for inputs that no pair has."""
    from deciwatch.nets.pair import PairConfig

    try:
        return PairConfig(
            args.dims,
            args.width,
            args.blocks,
            args.preliminary,
            args.dropout,
            inputs=tuple(args.inputs.split(",")) if args.inputs else (),
            recover=args.recover,
            feed_forward=args.feed_forward,
            denoise=args.noise != "none",
        )
    except ValueError as error:
        raise UserError(f"--inputs {args.inputs} is no input of these nets: {error}.") from error


def _data(
    args: argparse.Namespace, config: "PairConfig"
) -> tuple["Sources", dict[str, "Validation"]]:
    """Where batches come from, and the validations; the first of them chooses the best pair."""
    from deciwatch.data.noise import NOMINAL, NONE, TRAINING
    from deciwatch.data.noise_file import load_noise
    from deciwatch.data.sources import Sources
    from deciwatch.data.staged import load_staged
    from deciwatch.data.training_pairs import load_pairs
    from deciwatch.motion.load import load_motions
    from deciwatch.pair_validation import pair_validation
    from deciwatch.validation import recorded_validation

    kind = args.noise
    if kind == "fitted":
        training = checking = load_noise(Path(args.noise_model))
    else:
        training, checking = (TRAINING, NOMINAL) if kind == "made-up" else (NONE, NONE)
    if kind != "fitted" and len(config.inputs) > 1:
        raise UserError(f"--noise {kind} makes no further --inputs; leave them out, or fit noise.")
    directory = data_directory(args.data)
    pairs = load_pairs([Path(path) for path in args.pairs], config.inputs) if args.pairs else None
    if args.staged and kind != "fitted":
        raise UserError("--staged needs --noise fitted, which makes its estimates; add that.")
    sources = Sources(
        None if args.staged else load_motions(directory, "train"),
        config.inputs,
        training,
        few=config.recover == "samples",
        pairs=pairs,
        share=args.share_pairs,
        staged=load_staged(Path(args.staged)) if args.staged else None,
    )
    validations = {}
    if args.val_pairs:
        path = Path(args.val_pairs)
        seen = load_pairs([path], config.inputs)
        validations["pairs"] = pair_validation(seen, config.inputs, str(path))
    motions = load_motions(directory, "val")
    validations["recorded"] = recorded_validation(motions, config.inputs, checking)
    return sources, validations


def _note(
    args: argparse.Namespace,
    trainer: "Trainer",
    validations: dict[str, "Validation"],
    folder: Path,
    before: dict,
    recent: float,
) -> None:
    """Validate, print a line, write last.pt and, where it is the best yet, best.pt."""
    found = {name: each.of(trainer.averaged) for name, each in validations.items()}
    chosen, checked = next(iter(validations.items()))
    ours = found[chosen]
    training = {
        "data": _described(args),
        "commit": _commit(),
        **{key: round(n + before.get(key, 0), 2) for key, n in trainer.counts().items()},
        "seed": args.seed,
        "validation": {"unit": checked.unit, "interval": 10, "window": 10, "on": chosen}
        | {
            f"{method}_{key}": round(value, 2)
            for method, errors in (checked.baselines | {"deciwatch": ours}).items()
            for key, value in errors.items()
        },
    }
    if trainer.best is None or ours["position"] < trainer.best:
        trainer.best = ours["position"]
        trainer.share(folder / "best.pt", training)
    trainer.save(folder / "last.pt", training)
    line = {"step": trainer.done, "windows": trainer.windows, "minutes": training["minutes"]}
    line |= {"loss": round(recent, 4)}
    for name, errors in found.items():
        line |= {f"{name}_{key}": round(value, 2) for key, value in errors.items()}
    print(json.dumps(line | {"rate": round(trainer.rate(), 6)}), flush=True)


def _described(args: argparse.Namespace) -> str:
    """What the nets were trained on, for the manifest."""
    noises = {"none": "true samples", "fitted": "noise fitted to pairs"}
    words = f"{DATA}; {noises.get(args.noise, 'made-up estimator noise')}"
    if args.staged:
        words = f"{Path(args.staged).stem}; {words}"
    if args.pairs:
        names = ", ".join(Path(path).stem for path in args.pairs)
        words = f"pairs {names} ({args.share_pairs:.0%} of batches); {words}"
    return words


def _rounded(found: dict[str, float]) -> dict[str, float]:
    return {key: round(value, 2) for key, value in found.items()}


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

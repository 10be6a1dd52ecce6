"""`deciwatch train-forecast`: train the net that live playback looks ahead with."""

import argparse
import json
import time
from pathlib import Path
from typing import TYPE_CHECKING

from deciwatch.errors import UserError
from deciwatch.paths import CHECKPOINTS, RUNS

if TYPE_CHECKING:
    from deciwatch.forecast_trainer import ForecastTrainer
    from deciwatch.forecast_validation import ForecastValidation


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("--name", help="folder under runs/ (default: e.g. 3d-forecast)")
    parser.add_argument("--dims", type=int, choices=(2, 3), default=3)
    parser.add_argument(
        "--checkpoint", metavar="FILE", help="its pair (default: the committed one)"
    )
    parser.add_argument("--pairs", metavar="FILE", nargs="+", required=True)
    parser.add_argument(
        "--share-pairs", type=float, default=0.4, metavar="SHARE", help="of batches"
    )
    parser.add_argument("--staged", metavar="FILE", required=True, help="clips under fitted noise")
    parser.add_argument("--val-pairs", metavar="FILE", required=True, help="chooses the best net")
    parser.add_argument("--noise-model", metavar="FILE", default=str(CHECKPOINTS / "noise.npz"))
    parser.add_argument("--width", type=int, default=96)
    parser.add_argument("--blocks", type=int, default=2)
    parser.add_argument("--dropout", type=float, default=0.1)
    parser.add_argument("--rate", type=float, default=1e-3, help="highest learning rate")
    parser.add_argument("--decay", type=float, default=0.05)
    parser.add_argument("--minutes", type=float, default=20.0)
    parser.add_argument("--every", type=float, default=2.0, help="minutes between checkpoints")
    parser.add_argument(
        "--head-first",
        type=float,
        default=0.5,
        metavar="SHARE",
        help="of the budget in which its DenoiseNet stays its pair's (default 0.5)",
    )
    parser.add_argument("--start-from", metavar="FILE", help="begin with a checkpoint's weights")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--resume", action="store_true", help="go on from runs/NAME/last.pt")


def run(args: argparse.Namespace) -> int:
    """Train until the minutes are used up; the log goes to the terminal, nets to runs/NAME/."""
    import torch

    from deciwatch import checkpoint
    from deciwatch.data.noise_file import load_noise
    from deciwatch.data.sources import Sources
    from deciwatch.data.staged import load_staged
    from deciwatch.data.training_pairs import load_pairs
    from deciwatch.forecast_trainer import ForecastTrainer
    from deciwatch.forecast_validation import ForecastValidation
    from deciwatch.nets.forecast import ForecastConfig
    from deciwatch.pair_validation import pair_validation
    from deciwatch.trainer import Recipe

    if args.minutes <= 0 or args.every <= 0 or args.width % 4:
        raise UserError("Give --minutes and --every above 0, and a --width that divides by four.")
    torch.set_num_threads(1)
    path = Path(args.checkpoint or checkpoint.default_path(args.dims))
    pair, _ = checkpoint.load_pair(path, args.dims)
    inputs = pair.config.inputs
    sources = Sources(
        None,
        inputs,
        load_noise(Path(args.noise_model)),
        few=True,
        pairs=load_pairs([Path(each) for each in args.pairs], inputs),
        share=args.share_pairs,
        staged=load_staged(Path(args.staged)),
    )
    seen = load_pairs([Path(args.val_pairs)], inputs)
    validation = ForecastValidation(pair_validation(seen, inputs, args.val_pairs), pair)
    config = ForecastConfig(pair.config, args.width, args.blocks, 2 * args.width, args.dropout)
    recipe = Recipe(
        minutes=args.minutes,
        rate=args.rate,
        decay=args.decay,
        seed=args.seed,
        denoise_first=args.head_first,
    )
    trainer = ForecastTrainer(config, recipe, sources, pair)
    folder = RUNS / (args.name or f"{args.dims}d-forecast")
    if args.start_from:
        trainer.start_from(Path(args.start_from))
    if args.resume:
        trainer.resume(folder / "last.pt")
    print(json.dumps({"hidden": validation.baselines}), flush=True)
    saved = time.monotonic()
    while trainer.progress < 1:
        value = trainer.step()
        if time.monotonic() - saved > args.every * 60 or trainer.progress >= 1:
            _note(trainer, validation, folder, checkpoint.digest(path), value)
            saved = time.monotonic()
    return 0


def _note(
    trainer: "ForecastTrainer",
    validation: "ForecastValidation",
    folder: Path,
    pair: str,
    loss: float,
) -> None:
    """Validate, print a line, write last.pt and, where it is the best yet, best.pt."""
    found = validation.of(trainer.averaged)["position"]
    training = {
        "pair": pair,
        **{key: round(count, 2) for key, count in trainer.counts().items()},
        "validation": {"unit": validation.unit, "interval": 10}
        | {name: round(each["position"], 2) for name, each in validation.baselines.items()}
        | {"forecast": round(found, 2)},
    }
    if trainer.best is None or found < trainer.best:
        trainer.best = found
        trainer.share(folder / "best.pt", training)
    trainer.save(folder / "last.pt", training)
    line = {"step": trainer.done, "minutes": round(trainer.seconds / 60, 2), "loss": round(loss, 4)}
    print(json.dumps(line | {"position": round(found, 2)}), flush=True)

"""`deciwatch evaluate`: the nets against watching every frame and classical interpolation.

On pair files (--pairs), on true poses (--labelling), or on recorded motion with noise added.
"""

import argparse

from deciwatch.errors import UserError
from deciwatch.paths import BASELINES, MODELS


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    kind = parser.add_mutually_exclusive_group()
    kind.add_argument(
        "--pairs", metavar="FILE", nargs="+", help="score these pair files, see docs/pair-file.md"
    )
    kind.add_argument(
        "--labelling", action="store_true", help="recover recorded motion from true sparse poses"
    )
    parser.add_argument(
        "--live", action="store_true", help="with --pairs: as it is shown live, against its delay"
    )
    parser.add_argument(
        "--late",
        type=int,
        default=3,
        metavar="FRAMES",
        help="with --live: from a look to its answer (default 3, a tenth of a second)",
    )
    parser.add_argument(
        "--every",
        metavar="LIST",
        help="intervals, 1 to 20, such as 1,3,10 (default: 1,3,5,7,10,15,20 for pairs, "
        "2,5,10,15,20 for labelling, else 10)",
    )
    parser.add_argument("--window", type=int, default=10, metavar="Q", help="intervals, 1 to 10")
    parser.add_argument(
        "--json",
        metavar="FILE",
        nargs="?",
        const="-",
        help="also write the rows there; without FILE, print them as JSON and nothing else",
    )
    parser.add_argument("--models", metavar="DIR", default=str(MODELS), help="run what ships")
    parser.add_argument("--checkpoint", metavar="FILE", help="run a checkpoint by torch instead")
    pairs = parser.add_argument_group("with --pairs")
    pairs.add_argument("--methods", metavar="LIST", help="only these, such as linear,deciwatch")
    pairs.add_argument(
        "--checkpoint-3d", metavar="FILE", help="run checkpoints instead of --models"
    )
    pairs.add_argument("--checkpoint-2d", metavar="FILE")
    pairs.add_argument(
        "--baselines", metavar="FILE", default=str(BASELINES), help="from `deciwatch baselines`"
    )
    motion = parser.add_argument_group("without --pairs")
    motion.add_argument("--data", metavar="DIR", help="motion folder (else $DECIWATCH_DATA)")
    motion.add_argument("--split", choices=("val", "test"), default="test")
    motion.add_argument("--dims", type=int, choices=(2, 3), default=3)
    motion.add_argument("--noise", choices=("fitted", "nominal", "none"), default="fitted")


def run(args: argparse.Namespace) -> int:
    """Print one row a method and interval, and write them where --json says."""
    import torch

    from deciwatch.data.batches import WINDOWS

    low, high = WINDOWS
    if not low <= args.window <= high:
        raise UserError(f"--window {args.window} is out of range; the nets know {low} to {high}.")
    if args.pairs and args.checkpoint:
        raise UserError("With --pairs, name checkpoints by --checkpoint-3d and --checkpoint-2d.")
    if args.live and not args.pairs:
        raise UserError("--live plays pair files back; name them by --pairs.")
    torch.set_num_threads(1)
    if args.live:
        from deciwatch.evaluation import live as kind
    elif args.pairs:
        from deciwatch.evaluation import score_pairs as kind
    elif args.labelling:
        from deciwatch.evaluation import labelling as kind
    else:
        from deciwatch.evaluation import made_up as kind
    return kind.run(args)

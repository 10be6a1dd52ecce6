"""Options of `deciwatch train`."""

import argparse

from deciwatch.errors import UserError
from deciwatch.paths import CHECKPOINTS

NOISES = ("made-up", "fitted", "none")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("--name", help="folder under runs/ (default: the representation, e.g. 3d)")
    _add_data(parser.add_argument_group("data"))
    _add_nets(parser.add_argument_group("nets"))
    _add_schedule(parser.add_argument_group("schedule"))


def _add_data(group) -> None:
    group.add_argument("--data", metavar="DIR", help="motion folder (else $DECIWATCH_DATA)")
    group.add_argument("--pairs", metavar="FILE", nargs="+", help="pair files to train on too")
    group.add_argument(
        "--share-pairs", type=float, default=0.6, metavar="SHARE", help="of batches (default 0.6)"
    )
    group.add_argument(
        "--staged", metavar="FILE", help="train on these clips' truth instead of recorded motion"
    )
    group.add_argument("--val-pairs", metavar="FILE", help="pair file to choose the best pair by")
    group.add_argument(
        "--noise",
        choices=NOISES,
        help="errors of the estimates of recorded motion; none trains on true samples "
        "(default: made-up for --inputs of one kind, else fitted)",
    )
    group.add_argument(
        "--noise-model", metavar="FILE", default=str(CHECKPOINTS / "noise.npz"), help="for fitted"
    )


def _add_nets(group) -> None:
    group.add_argument("--dims", type=int, choices=(2, 3), default=3)
    group.add_argument("--inputs", help="of 3d, 2d and scores, its own first (e.g. 3d,2d,scores)")
    group.add_argument("--width", type=int, default=64, help="C (default 64)")
    group.add_argument("--blocks", type=int, default=5, help="M (default 5)")
    group.add_argument("--feed-forward", type=int, default=0, help="default: 4 C, at most 512")
    group.add_argument(
        "--recover",
        choices=("frames", "samples"),
        default="frames",
        help="what RecoverNet has tokens for (default frames, the paper's)",
    )
    group.add_argument("--preliminary", choices=("linear", "cubic", "spline"), default="cubic")
    group.add_argument("--dropout", type=float, default=0.1)


def _add_schedule(group) -> None:
    budget = group.add_mutually_exclusive_group()
    budget.add_argument("--minutes", type=float, default=45.0, help="to train for (default 45)")
    budget.add_argument("--steps", type=int, help="steps to train for, instead of minutes")
    group.add_argument("--resume", action="store_true", help="go on from runs/NAME/last.pt")
    group.add_argument("--start-from", metavar="FILE", help="begin with a checkpoint's weights")
    group.add_argument(
        "--recover-from", metavar="FILE", help="begin with the RecoverNet of a checkpoint"
    )
    group.add_argument("--lam", type=float, default=5.0, help="λ of equation 6 (default 5)")
    group.add_argument("--rate", type=float, default=1.5e-3, help="highest learning rate")
    group.add_argument("--decay", type=float, default=0.01, help="weight decay (default 0.01)")
    group.add_argument(
        "--denoise-first",
        type=float,
        default=0.12,
        metavar="SHARE",
        help="share of the budget spent on DenoiseNet alone (default 0.12)",
    )
    group.add_argument("--seed", type=int, default=1)
    group.add_argument("--threads", type=int, default=1, help="torch threads (default 1)")
    group.add_argument("--every", type=float, default=2.0, help="minutes between checkpoints")


def check(args: argparse.Namespace) -> None:
    """Settle what was left open; raise UserError for what no training can have."""
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
    if not 0 <= args.share_pairs <= 1:
        raise UserError(f"--share-pairs {args.share_pairs} is no share; give 0 to 1.")
    if args.noise is None:
        args.noise = "fitted" if "," in (args.inputs or "") else "made-up"
    if args.noise == "none" and (args.pairs or args.val_pairs):
        raise UserError("--noise none trains on true samples; leave --pairs and --val-pairs out.")

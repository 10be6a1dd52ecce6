"""`deciwatch study`: the paper's studies that are no plain evaluation, each into a JSON file."""

import argparse

from deciwatch.paths import CHECKPOINTS, MODELS, REPOSITORY, RUNS

PAIRS = RUNS / "pairs"
RESULTS = REPOSITORY / "docs" / "results"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """A subcommand for each study."""
    kinds = parser.add_subparsers(dest="study", required=True, metavar="STUDY")
    train = kinds.add_parser("train", help="nets made and trained otherwise, all on one budget")
    train.add_argument("--only", metavar="NAME,…", help="variants, or groups such as width")
    train.add_argument("--steps", type=int, default=1500, help="of each training (default 1500)")
    train.add_argument("--threads", type=int, default=1, help="torch threads (default 1)")
    train.add_argument(
        "--pairs", metavar="FILE", nargs="+", default=[str(PAIRS / "train-full.npz")]
    )
    train.add_argument(
        "--truth",
        metavar="FILE",
        default=str(PAIRS / "train-truth.npz"),
        help="of `deciwatch pairs --truth-only`",
    )
    train.add_argument("--noise-model", metavar="FILE", default=str(CHECKPOINTS / "noise.npz"))
    sampling = kinds.add_parser("sampling", help="uniform, clustered and random watched frames")
    window = kinds.add_parser("window", help="how many intervals the nets see at once")
    for each, name in ((train, "variants"), (sampling, "sampling"), (window, "window")):
        each.add_argument("--test", metavar="FILE", default=str(PAIRS / "test-full.npz"))
        each.add_argument("--out", metavar="FILE", default=str(RESULTS / f"{name}.json"))
    for each in (sampling, window):
        each.add_argument("--models", metavar="DIR", default=str(MODELS), help="what is studied")


def run(args: argparse.Namespace) -> int:
    """Run the study that is asked for."""
    import torch

    torch.set_num_threads(getattr(args, "threads", 1))
    if args.study == "train":
        from deciwatch.studies import train_variants as study
    elif args.study == "sampling":
        from deciwatch.studies import run_sampling as study
    else:
        from deciwatch.studies import run_window as study
    return study.run(args)

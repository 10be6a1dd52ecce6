"""`deciwatch baselines`: fit the methods that the nets are compared with."""

import argparse
from pathlib import Path

from deciwatch.paths import BASELINES


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument(
        "--pairs",
        metavar="FILE",
        nargs="+",
        required=True,
        help="training pairs: each estimator's calibration, and one SmoothNet from all",
    )
    parser.add_argument(
        "--val-pairs",
        metavar="FILE",
        nargs="+",
        required=True,
        help="validation pairs: the 1€ filter's settings",
    )
    parser.add_argument("--steps", type=int, default=1500, help="SmoothNet's (default 1500)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", metavar="FILE", default=str(BASELINES))


def run(args: argparse.Namespace) -> int:
    """Fit, train, say how each does on the validation pairs, and write the file."""
    import torch

    from deciwatch.errors import UserError
    from deciwatch.evaluation.baselines_file import Baselines, write_baselines
    from deciwatch.evaluation.fit_baselines import fit_calibration, tune_one_euro
    from deciwatch.evaluation.pair_file import read_pair_file
    from deciwatch.evaluation.train_smoothnet import smoothnet_error, train_smoothnet

    if args.steps < 1:
        raise UserError(f"--steps {args.steps} makes no training; give a number above 0.")
    torch.set_num_threads(1)
    training, validation = (
        [read_pair_file(Path(path)) for path in paths] for paths in (args.pairs, args.val_pairs)
    )
    shapes = {(file.keypoints, *file.truths) for file in (*training, *validation)}
    if len(shapes) > 1:
        raise UserError("The pair files differ in keypoints or in what they hold; give like ones.")
    fitted = Baselines()
    for estimator in {file.estimator: None for file in training}:
        own = [file for file in training if file.estimator == estimator]
        fitted.calibration[estimator] = fit_calibration(own)
    for name in training[0].truths:
        factor, unit = (1000, "mm") if name == "3d" else (1, "px")
        fitted.one_euro[name], filtered = tune_one_euro(validation, name)
        net = train_smoothnet(training, name, args.steps, args.seed)
        fitted.smoothnet[name] = {key: x.numpy() for key, x in net.state_dict().items()}
        errors = [smoothnet_error(None, validation, name), filtered]
        errors.append(smoothnet_error(net, validation, name))
        figures = zip(("every frame", "1€", "SmoothNet"), errors, strict=True)
        line = ", ".join(f"{label} {error * factor:.2f} {unit}" for label, error in figures)
        print(f"{name} validation: {line}; 1€ min_cutoff, beta {fitted.one_euro[name]}")
    write_baselines(Path(args.out), fitted)
    print(f"{args.out}: calibrations of {', '.join(sorted(fitted.calibration))}")
    return 0

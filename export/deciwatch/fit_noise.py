"""`deciwatch fit-noise`: fit the model of an estimator's errors that training makes noise with."""

import argparse
from pathlib import Path

from deciwatch.paths import CHECKPOINTS


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("--pairs", metavar="FILE", nargs="+", required=True, help="training pairs")
    parser.add_argument("--out", metavar="FILE", default=str(CHECKPOINTS / "noise.npz"))


def run(args: argparse.Namespace) -> int:
    """Fit, compare what the model makes with what it was fitted to, write."""
    import numpy as np

    from deciwatch.data.fit_residuals import fit
    from deciwatch.data.noise_file import save_noise
    from deciwatch.data.training_pairs import load_pairs

    pairs = load_pairs([Path(path) for path in args.pairs], ("3d", "2d", "scores"))
    model = fit(pairs)
    truth = {name: pairs.truth[name][pairs.seen][:, None] for name in ("3d", "2d")}
    made = model.draw(
        np.random.default_rng(1),
        truth["3d"],
        truth["2d"],
        np.zeros((len(pairs.seen), 1)),
        severity=(1.0, 1.0),
    )
    for name, unit, factor in (("3d", "mm", 1000), ("2d", "px", 1)):
        real, ours = (
            factor * np.linalg.norm(x - truth[name][:, 0], axis=-1).mean()
            for x in (pairs.estimates[name], made[name][:, 0])
        )
        print(f"{name}: {real:.1f} {unit} off in the pairs, {ours:.1f} {unit} by the model")
    shares = ", ".join(f"{share:.2%}" for share in model.swaps)
    print(f"left and right exchanged (all, arms, legs): {shares}")
    print(f"{model.share:.0%} of a sample's error lasts, for {model.seconds:.2f} s")
    size = save_noise(Path(args.out), model)
    print(f"{args.out}: {size / 1e3:.0f} kB")
    return 0

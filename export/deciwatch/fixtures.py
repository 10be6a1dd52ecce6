"""`deciwatch fixtures`: the numbers that the web tests check against, in tests/fixtures/."""

import argparse
import json
from pathlib import Path

from deciwatch.paths import FIXTURES, MODELS

SEED = 5


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("--checkpoint-3d", metavar="FILE", help="default: the committed one")
    parser.add_argument("--checkpoint-2d", metavar="FILE", help="default: the committed one")
    parser.add_argument("--models", metavar="DIR", default=str(MODELS), help="for the FLOPs")
    parser.add_argument("--out", metavar="DIR", default=str(FIXTURES))


def run(args: argparse.Namespace) -> int:
    """Write every fixture; each is computed without the code that it checks."""
    from deciwatch.atomic import write_text
    from deciwatch.checkpoint import default_path
    from deciwatch.fixture_numbers import interpolation_cases, metric_cases, normalise_cases
    from deciwatch.fixture_parity import flops_cases, parity_cases

    folder = Path(args.out)
    contents = {
        "normalise.json": normalise_cases(SEED),
        "interpolation.json": interpolation_cases(SEED),
        "metrics.json": metric_cases(SEED),
        "flops.json": flops_cases(Path(args.models)),
    }
    for dims, given in ((3, args.checkpoint_3d), (2, args.checkpoint_2d)):
        path = Path(given) if given else default_path(dims)
        contents[f"parity-{dims}d.json"] = parity_cases(path, dims, SEED)
    for name, content in contents.items():
        write_text(folder / name, json.dumps(content, separators=(",", ":")) + "\n")
        print(f"{folder / name}: {(folder / name).stat().st_size / 1000:.0f} kB")
    return 0

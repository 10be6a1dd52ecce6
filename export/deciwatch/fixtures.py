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
    from deciwatch.fixture_estimators import write_estimators
    from deciwatch.fixture_inputs import input_cases, write_models
    from deciwatch.fixture_numbers import (
        easing_cases,
        interpolation_cases,
        metric_cases,
        normalise_cases,
    )
    from deciwatch.fixture_parity import flops_cases, parity_cases
    from deciwatch.fixture_stitching import stitching_cases
    from deciwatch.official.fixture import write_official

    folder = Path(args.out)
    contents = {
        "normalise.json": normalise_cases(SEED),
        "interpolation.json": interpolation_cases(SEED),
        "metrics.json": metric_cases(SEED),
        "stitching.json": stitching_cases(SEED),
        "flops.json": flops_cases(Path(args.models)),
        "inputs.json": input_cases(SEED),
        "easing.json": easing_cases(),
    }
    for dims, given in ((3, args.checkpoint_3d), (2, args.checkpoint_2d)):
        path = Path(given) if given else default_path(dims)
        contents[f"parity-{dims}d.json"] = parity_cases(path, dims, SEED)
    # Nothing is written before all that can fail for the user has not.
    write_models(folder / "models", SEED)
    write_official(folder / "official", SEED)
    write_estimators(folder / "onnx-estimators")
    for name, content in contents.items():
        write_text(folder / name, json.dumps(content, separators=(",", ":")) + "\n")
        print(f"{folder / name}: {(folder / name).stat().st_size / 1000:.0f} kB")
    return 0

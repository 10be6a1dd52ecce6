"""`deciwatch study sampling`: which frames are watched, at the same number of looks."""

import argparse
from pathlib import Path

import numpy as np

from deciwatch.evaluation.classical import interpolated
from deciwatch.evaluation.counted_nets import from_models
from deciwatch.evaluation.method import Method
from deciwatch.evaluation.plan import Plan
from deciwatch.evaluation.recovered import recovered
from deciwatch.evaluation.scoring import score
from deciwatch.sampling.windows import WINDOW_INTERVALS
from deciwatch.studies.document import rounded, write_document
from deciwatch.studies.schemes import BY_CHANCE, SCHEMES
from deciwatch.studies.scored_pairs import ScoredPairs, read_scored_pairs

INTERVAL = 10
DRAWS = 3  # of a scheme that leaves something to chance


def run(args: argparse.Namespace) -> int:
    """Score every scheme on the frames that all of them give a pose to, and write the JSON."""
    test = read_scored_pairs(Path(args.test))
    methods: dict[str, Method] = {kind: interpolated(kind) for kind in ("linear", "cubic")}
    methods["deciwatch"] = recovered({"3d": from_models(Path(args.models), 3)})
    draws = {name: DRAWS if name in BY_CHANCE else 1 for name in SCHEMES}
    plans = {
        (name, draw): _plans(test, name, draw)
        for name, most in draws.items()
        for draw in range(most)
    }
    covered = np.logical_and.reduce([_covered(test, each) for each in plans.values()])
    scored = test.scored & covered
    rows = []
    for (name, draw), own in plans.items():
        watched = sum(len(plan.watched) for plan in own.values())
        for method, fill in methods.items():
            figures = score(test.file, {"3d": _filled(test, own, fill)}, scored)
            row = {"scheme": name, "draw": draw, "method": method, "watched": watched}
            row["longest_gap"] = int(
                max(np.diff(plan.watched).max(initial=0) for plan in own.values())
            )
            row |= {key: figures[key] for key in ("mpjpe_mm", "pa_mpjpe_mm", "accel_mm")}
            rows.append(rounded(row))
        print(f"{name}, draw {draw}: {rows[-1]['mpjpe_mm']:.1f} mm", flush=True)
    about = {"interval": INTERVAL, "test": test.about() | {"frames": int(scored.sum())}}
    write_document(Path(args.out), about, rows)
    return 0


def _plans(test: ScoredPairs, name: str, draw: int) -> dict[int, Plan]:
    """What each sequence's estimator gets to see; the same in every run."""
    return {index: _plan(test, index, name, draw) for index in test.indices}


def _plan(test: ScoredPairs, index: int, name: str, draw: int) -> Plan:
    sequence = test.file.sequence(index)
    rng = np.random.default_rng([draw, index])
    watched = SCHEMES[name](rng, len(sequence.times), INTERVAL)
    # A long gap that the scheme itself left is no sign that somebody went away.
    longest = int(np.diff(watched).max(initial=1))
    seen = watched[sequence.seen[watched]]
    return Plan(longest, WINDOW_INTERVALS, sequence.times, watched, seen)


def _covered(test: ScoredPairs, plans: dict[int, Plan]) -> np.ndarray:
    covered = np.zeros_like(test.scored)
    for index, plan in plans.items():
        covered[test.file.place(index)] = plan.covered()
    return covered


def _filled(test: ScoredPairs, plans: dict[int, Plan], method: Method) -> np.ndarray:
    """3D poses [F, K, 3] of the whole file."""
    poses = np.full_like(test.file.truths["3d"], np.nan)
    for index, plan in plans.items():
        poses[test.file.place(index)] = method(test.file.sequence(index), plan).poses["3d"]
    return poses

"""`deciwatch study train`: every variant from scratch on the same small budget, then scored."""

import argparse
import sys
from pathlib import Path

from deciwatch.checkpoint import default_path
from deciwatch.errors import UserError
from deciwatch.evaluation.counted_nets import CountedNets, from_checkpoint, without_recover
from deciwatch.evaluation.recovered import recovered
from deciwatch.evaluation.run_methods import rows_of
from deciwatch.paths import RUNS
from deciwatch.studies.document import add_row, read_document, rounded
from deciwatch.studies.scored_pairs import ScoredPairs, read_scored_pairs
from deciwatch.studies.training_data import Material, load_material
from deciwatch.studies.variants import Variant, base_settings, variants
from deciwatch.trainer import Recipe, Trainer

INTERVAL, WINDOW = 10, 10
FIGURES = ("mpjpe_mm", "pa_mpjpe_mm", "accel_mm")


def run(args: argparse.Namespace) -> int:
    """Train and score what OUT does not have yet; each entry is written as soon as it is known."""
    if args.steps < 1:
        raise UserError(f"--steps {args.steps} makes no training; give 1 or more.")
    base = base_settings(default_path(3))
    chosen = _chosen(variants(base), args.only)
    test = read_scored_pairs(Path(args.test))
    out = Path(args.out)
    about = {"base": base.as_dict(), "steps": args.steps, "interval": INTERVAL, "window": WINDOW}
    about |= {"pairs": [Path(path).name for path in args.pairs], "test": test.about()}
    material = None
    for variant in chosen:
        # Read anew each time, since another process may be at work on the same file.
        if variant.name in {row["name"] for row in read_document(out, about)}:
            _tell(f"{variant.name}: is in {out.name}")
            continue
        if material is None:
            material = load_material(
                [Path(path) for path in args.pairs], Path(args.truth), Path(args.noise_model)
            )
        row = _train_and_score(variant, args.steps, material, test)
        add_row(out, about, row)
        _tell(
            f"{variant.name}: {row['mpjpe_mm']:.1f} mm, {row['accel_mm']:.1f} mm/frame², "
            f"{row['minutes']:.1f} min"
        )
    return 0


def _chosen(every: list[Variant], only: str | None) -> list[Variant]:
    """Those of --only, by name or by group. Raises UserError for what is neither."""
    if only is None:
        return every
    wanted = {word.strip() for word in only.split(",")}
    known = [variant.name for variant in every]
    unknown = sorted(wanted - set(known) - {variant.group for variant in every})
    if unknown:
        raise UserError(f"--only {unknown[0]} is no variant; they are {', '.join(known)}.")
    return [variant for variant in every if wanted & {variant.name, variant.group}]


def _train_and_score(variant: Variant, steps: int, material: Material, test: ScoredPairs) -> dict:
    """The entry of a variant. Its nets stay in runs/studies/, for whoever wants to look."""
    settings = variant.settings
    recipe = Recipe(steps, lam=settings.lam, seed=settings.seed)
    trainer = Trainer(settings.config, recipe, material.sources(settings))
    _tell(f"{variant.name}: {steps} steps")
    trainer.start_linearly()
    while trainer.progress < 1:
        trainer.step()
    path = RUNS / "studies" / f"{variant.name}.pt"
    trainer.share(path, {"study": variant.name} | trainer.counts())
    nets = from_checkpoint(path, 3)
    row = {"name": variant.name, "group": variant.group, "differs": variant.differs}
    row |= {"seed": settings.seed} | trainer.counts()
    row["parameters"] = sum(weights.numel() for weights in trainer.averaged.parameters())
    row["flops_per_window"] = nets.flops(WINDOW + 1, INTERVAL * WINDOW + 1)
    return rounded(row | _scores(nets, test))


def _scores(nets: CountedNets, test: ScoredPairs) -> dict:
    """FIGURES of the pair, and under "no_recover" those of its W_PR alone."""
    methods = {
        "deciwatch": recovered({"3d": nets}),
        "no_recover": recovered({"3d": without_recover(nets)}),
    }
    rows = rows_of(test.file, test.indices, methods, [INTERVAL], test.scored, (None, None), WINDOW)
    found = {row["method"]: {name: row[name] for name in FIGURES} for row in rows}
    return found["deciwatch"] | {"no_recover": found["no_recover"]}


def _tell(line: str) -> None:
    print(line, file=sys.stderr, flush=True)

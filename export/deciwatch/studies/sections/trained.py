"""The groups of variants that were trained anew: one section for each."""

from collections.abc import Callable

from deciwatch.studies.labels import GREY, OURS
from deciwatch.studies.measured import Lacking, Measured
from deciwatch.studies.section import Content, Plot
from deciwatch.studies.words import MEGA, against, lowest, mm, number

# Group: its title, one of its values in a sentence, and, where values need words, those.
GROUPS: dict[str, tuple[str, str, dict]] = {
    "lam": ("λ of the loss", "λ = {}", {}),
    "width": ("Width C", "C = {}", {}),
    "blocks": ("Blocks M", "M = {}", {}),
    "recover": (
        "RecoverNet's tokens",
        "tokens for {}",
        {"samples": "the samples", "frames": "every frame"},
    ),
    "preliminary": ("W_PR", "a {} W_PR", {}),
    "inputs": ("Inputs", "the inputs {}", {}),
    "data": (
        "Training data",
        "training on {}",
        {"pairs": "real pairs", "noise": "the noise model", "both": "both"},
    ),
}
HEAD = ("MPJPE, mm", "Accel, mm/frame²", "without RecoverNet", "parameters", "MFLOP a window")


def group_section(group: str) -> Callable[[Measured], Content]:
    """The function that writes the section of one of GROUPS."""
    return lambda variants: _write(variants, group)


def _write(variants: Measured, group: str) -> Content:
    base = variants.one(name="base")
    own = variants.about["base"][group]
    members = [(own, base), *((row["differs"][group], row) for row in variants.where(group=group))]
    if len(members) < 2:
        raise Lacking(f"variants.json has nothing of the group {group} beside the base")
    members.sort(key=lambda member: _place(member[0]))
    title, template, words = GROUPS[group]
    named = [(_word(value, words), row) for value, row in members]
    rows = [
        (
            f"{name} (base)" if row is base else name,
            number(row["mpjpe_mm"]),
            number(row["accel_mm"]),
            f"{number(row['no_recover']['mpjpe_mm'])} / {number(row['no_recover']['accel_mm'])}",
            f"{row['parameters']:,}",
            number(row["flops_per_window"], 1, MEGA),
        )
        for name, row in named
    ]
    sentences = [_sentence(named, base, template, chance(variants)), *_seen(named)]
    names = [row[0] for row in rows]
    return Content(
        sentences, (title, *HEAD), rows, [_plot(group, names, [row for _, row in named])]
    )


def chance(variants: Measured) -> float | None:
    """How far MPJPE lies apart, in mm, between trainings that differ in their seed alone."""
    rows = variants.where(group="seed")
    if not rows:
        return None
    values = [row["mpjpe_mm"] for row in (variants.one(name="base"), *rows)]
    return max(values) - min(values)


def _sentence(
    named: list[tuple[str, dict]], base: dict, template: str, spread: float | None
) -> str:
    name, best = min(named, key=lambda member: member[1]["mpjpe_mm"])
    second = lowest([row for _, row in named if row is not best], "mpjpe_mm")
    smooth, _ = min(named, key=lambda member: member[1]["accel_mm"])
    what = template.format(name)
    if best is base:
        text = f"The base, {what}, has the lowest MPJPE, {mm(best['mpjpe_mm'])}, "
        text += f"{against(best['mpjpe_mm'], second['mpjpe_mm'])} the next"
        gap = second["mpjpe_mm"] - best["mpjpe_mm"]
    else:
        text = f"The base is not the best: {what} has the lowest MPJPE, {mm(best['mpjpe_mm'])}, "
        text += f"{against(best['mpjpe_mm'], base['mpjpe_mm'])} the base ({mm(base['mpjpe_mm'])})"
        gap = base["mpjpe_mm"] - best["mpjpe_mm"]
    if spread is not None and gap <= spread:
        text += f", which is no more than seeds alone do ({mm(spread)})"
    return f"{text}; Accel is lowest with {template.format(smooth)}."


def _seen(named: list[tuple[str, dict]]) -> list[str]:
    """The same steps are not the same number of windows where frames cost more."""
    windows = {name: row.get("windows") for name, row in named}
    counts = [count for count in windows.values() if count]
    if not counts or max(counts) < 1.2 * min(counts):
        return []
    parts = ", ".join(f"{name} {count:,}" for name, count in windows.items() if count)
    return [f"In the same steps they did not see the same number of windows: {parts}."]


def _place(value: object) -> tuple:
    """Numbers by size, inputs by their number, words as they come."""
    if isinstance(value, list):
        return (1, len(value))
    return (0, value) if isinstance(value, int | float) else (2,)


def _word(value: object, words: dict) -> str:
    if isinstance(value, list):
        return ", ".join(value)
    return f"{value:g}" if isinstance(value, float) else words.get(value, str(value))


def _plot(group: str, names: list[str], rows: list[dict]) -> Plot:
    def draw():
        from deciwatch.studies.charts.dots import DotPanel, Series, dot_chart

        panels = [
            DotPanel(
                title,
                [
                    Series("without RecoverNet", [row["no_recover"][key] for row in rows], GREY),
                    Series("the pair", [row[key] for row in rows], OURS, True),
                ],
            )
            for title, key in (("MPJPE, mm", "mpjpe_mm"), ("Accel, mm/frame²", "accel_mm"))
        ]
        return dot_chart(names, panels, left=0.05 + 0.0115 * max(map(len, names)))

    return Plot(f"variants-{group}", f"MPJPE and Accel. {GROUPS[group][0]}", draw)

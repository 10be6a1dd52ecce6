"""docs/results.md: its sections in order, and how one is laid out."""

from deciwatch.studies.labels import estimator
from deciwatch.studies.measured import COMMANDS, RUN, Lacking, Measured
from deciwatch.studies.section import Content, Plot, Section
from deciwatch.studies.sections import (
    ablation,
    costs,
    cross,
    estimators,
    glance,
    groups,
    labelling,
    live,
    ratio,
    sampling,
    trained,
    window,
)
from deciwatch.studies.words import listed, mm

SECTIONS = (
    Section("One frame in ten", "pairs", glance.write),
    Section("How many frames to watch", "pairs", ratio.write),
    Section("A heavy estimator seldom, or a light one always", "pairs", estimators.write),
    Section("What it costs", "pairs", costs.write),
    Section("Without DenoiseNet, without RecoverNet", "pairs", ablation.write),
    Section("Which joints gain", "pairs", groups.write),
    Section("Estimators that the nets never saw", "pairs", cross.write),
    Section("Window size", "window", window.write),
    Section("Which frames to watch", "sampling", sampling.write),
    Section("Live", "live", live.write),
    Section("Efficient labelling", "labelling", labelling.write),
)
VARIANTS = tuple(
    Section(title, "variants", trained.group_section(group))
    for group, (title, *_) in trained.GROUPS.items()
)
INTRODUCTION = f"""# Results

The paper's studies on our own data. This page is written by `{RUN} results` from
the JSON files in [`results/`](results): every number and every verdict follows from them. The
commands that measured them stand [at the end](#measuring-again).

MPJPE: mean distance of a joint from the truth. PA-MPJPE: the same after moving, turning and scaling
each pose to fit best. Accel: mean distance of accelerations. In all three, lower is better.
PCK@0.05: share of keypoints within 5 % of the box's longer side, higher is better. N: one frame in
N is watched. Errors are those of all frames, watched and recovered."""
ABOUT_VARIANTS = """## Trained anew

Each variant is the base with one thing changed, trained from scratch and scored at N = 10."""


def write_page(measured: dict[str, Measured], pictures: str) -> tuple[str, list[Plot]]:
    """The text and the plots that it shows; `pictures` is their folder as seen from the page."""
    blocks, plots = [INTRODUCTION, *_coverage(measured)], []
    for level, sections in (("##", SECTIONS), ("###", VARIANTS)):
        if sections is VARIANTS:
            blocks += [ABOUT_VARIANTS, *_about_variants(measured)]
        for section in sections:
            blocks.append(f"{level} {section.title}")
            try:
                if section.source not in measured:
                    raise Lacking(f"there is no {section.source}.json")
                content = section.write(measured[section.source])
            except Lacking as lacking:
                blocks.append(f"Not measured: {lacking}. `{COMMANDS[section.source]}` makes it.")
                continue
            blocks += _blocks(content, pictures, section.source)
            plots += content.plots
    commands = "\n".join([*COMMANDS.values(), f"{RUN} results"])
    blocks += ["## Measuring again", f"```sh\n{commands}\n```"]
    return "\n\n".join(blocks) + "\n", plots


def _blocks(content: Content, pictures: str, source: str) -> list[str]:
    command = " ".join(COMMANDS[source].split()[:5])
    images = [f"![{plot.shows}]({pictures}/{plot.name}.svg)" for plot in content.plots]
    table = [content.head, ("---",) * len(content.head), *content.rows]
    lines = [f"| {' | '.join(row)} |" for row in table]
    last = " ".join([*content.notes, f"Measured by `{command}`."])
    return [" ".join(content.sentences), *images, "\n".join(lines), last]


def _coverage(measured: dict[str, Measured]) -> list[str]:
    """What pairs.json was measured on."""
    lines = measured["pairs"].about.get("coverage") if "pairs" in measured else None
    if not lines:
        return []
    parts = [
        f"{line['scored']:,} of {line['frames']:,} frames in {line['sequences']} clips "
        f"({estimator(line['estimator'])})"
        for line in lines
    ]
    return [
        "Unless said otherwise, these are the test pairs: movements of people and avatars that no "
        "training saw, rendered at 30 frames a second and estimated by MediaPipe Pose. Scored are "
        f"{listed(parts)}: those to which every method gives a pose at every N."
    ]


def _about_variants(measured: dict[str, Measured]) -> list[str]:
    """How small the budget was, and how much chance alone does."""
    variants = measured.get("variants")
    if variants is None or not variants.where(name="base"):
        return []
    base = variants.one(name="base")
    text = (
        f"All have the same budget, {variants.about.get('steps'):,} steps (the base: "
        f"{base['windows']:,} windows), a small one, since the machine had two cores: these "
        "numbers rank choices, and are not those of the shipped nets."
    )
    spread = trained.chance(variants)
    if spread is not None:
        seeds = 1 + len(variants.where(group="seed"))
        text += f" The base with {seeds} seeds gives MPJPEs {mm(spread)} apart."
    return [text]

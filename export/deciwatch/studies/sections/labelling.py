"""Efficient labelling: true poses of one frame in N in, all others recovered."""

from deciwatch.studies.labels import CLASSICAL, COLOURS, IN_PROSE, METHODS
from deciwatch.studies.measured import Lacking, Measured
from deciwatch.studies.section import Content, Plot
from deciwatch.studies.words import against, listed, lowest, mm, number

SHOWN = ("linear", "quadratic", "cubic", "deciwatch")
HEAD = ("N", *(f"{METHODS[name]}: MPJPE / Accel" for name in SHOWN))
N = 10


def write(labelling: Measured) -> Content:
    """The section."""
    steps = sorted(labelling.values("interval", method="deciwatch"))
    if not steps:
        raise Lacking("labelling.json has no row of the method deciwatch")
    ours = {n: labelling.one(method="deciwatch", interval=n) for n in steps}
    best = {n: _best(labelling, n) for n in steps}
    shown = [name for name in SHOWN if labelling.where(method=name)]
    rows = []
    for n in steps:
        cells = [labelling.one(method=name, interval=n) for name in shown]
        rows.append(
            (str(n), *(f"{number(x['mpjpe_mm'])} / {number(x['accel_mm'])}" for x in cells))
        )
    head = (HEAD[0], *(f"{METHODS[name]}: MPJPE / Accel" for name in shown))
    split, frames = labelling.about.get("split"), labelling.about.get("frames")
    notes = [
        "Recorded motion (CMU) at its own 30 frames a second, the samples being the truth itself; "
        "a pair of nets trained for this alone."
    ]
    if split and frames:
        notes[0] = notes[0].replace("(CMU)", f"(CMU, {split} split, {frames:,} frames)")
    return Content(_sentences(ours, best), head, rows, [_plot(labelling, shown, steps)], notes)


def _best(labelling: Measured, n: int) -> dict:
    rows = [row for row in labelling.where(interval=n) if row["method"] in CLASSICAL]
    if not rows:
        raise Lacking(f"labelling.json has no interpolation at N = {n}")
    return lowest(rows, "mpjpe_mm")


def _sentences(ours: dict[int, dict], best: dict[int, dict]) -> list[str]:
    n = N if N in ours else max(ours)
    mine, theirs = ours[n]["mpjpe_mm"], best[n]["mpjpe_mm"]
    found = [
        f"From one true pose in {n}, DeciWatch recovers the others to {mm(mine)}, "
        f"{against(mine, theirs)} the best interpolation "
        f"({IN_PROSE[best[n]['method']]}, {mm(theirs)})."
    ]
    lost = [
        f"N = {n} ({mm(ours[n]['mpjpe_mm'])} against {mm(best[n]['mpjpe_mm'])})"
        for n in ours
        if ours[n]["mpjpe_mm"] >= best[n]["mpjpe_mm"]
    ]
    if lost:
        found.append(f"The best interpolation is as good or better at {listed(lost)}.")
    else:
        least = max(ours, key=lambda n: ours[n]["mpjpe_mm"] / best[n]["mpjpe_mm"])
        gap = against(ours[least]["mpjpe_mm"], best[least]["mpjpe_mm"])
        found.append(
            f"It is ahead at every N, least at N = {least} ({gap} the best interpolation)."
        )
    return found


def _plot(labelling: Measured, shown: list[str], steps: list[int]) -> Plot:
    def draw():
        from deciwatch.studies.charts.lines import Line, Panel, line_chart

        panels = []
        for title, key in (("MPJPE, mm", "mpjpe_mm"), ("Accel, mm/frame²", "accel_mm")):
            lines = []
            for name in shown:
                values = [labelling.one(method=name, interval=n)[key] for n in steps]
                lines.append(Line(METHODS[name], steps, values, COLOURS[name], name == "deciwatch"))
            panels.append(Panel(title, lines))
        return line_chart(panels, "N: one frame in N is labelled", steps)

    return Plot("labelling", "MPJPE and Accel against N from true samples", draw)

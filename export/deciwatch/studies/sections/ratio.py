"""How many frames to watch: MPJPE and Accel against N, and where MPJPE is lowest."""

from deciwatch.studies.labels import COLOURS, METHODS, estimator
from deciwatch.studies.measured import Measured
from deciwatch.studies.section import Content, Plot
from deciwatch.studies.sections.common import (
    at,
    best_classical,
    intervals,
    name_of,
    there,
    usual,
)
from deciwatch.studies.words import GIGA, against, listed, lowest, mm, number

DRAWN = ("deciwatch", "linear", "cubic")
LEVELS = ("every_frame", "every_frame_calibrated", "one_euro", "smoothnet")
HEAD = (
    "N",
    "DeciWatch: MPJPE, mm",
    "Accel, mm/frame²",
    "best interpolation: MPJPE, mm",
    "Accel, mm/frame²",
    "GFLOP a frame",
)


def write(pairs: Measured) -> Content:
    """The section."""
    name = usual(pairs)
    steps = intervals(pairs, name)
    ours = [at(pairs, "deciwatch", n, name) for n in steps]
    every = at(pairs, "every_frame", 1, name)
    best = [best_classical(pairs, n, name) for n in steps if n > 1]
    rows = [(str(1) + ", estimator alone", *_cells(every), "–", "–", _flops(every))]
    rivals = {row["interval"]: row for row in best}
    for row in ours:
        rival = rivals.get(row["interval"])
        others = (
            ("–", "–")
            if rival is None
            else (f"{_cells(rival)[0]} ({rival['method']})", _cells(rival)[1])
        )
        rows.append((str(row["interval"]), *_cells(row), *others, _flops(row)))
    return Content(_sentences(ours, every, rivals), HEAD, rows, [_plot(pairs, name, steps)])


def _cells(row: dict) -> tuple[str, str]:
    return number(row["mpjpe_mm"]), number(row["accel_mm"])


def _flops(row: dict) -> str:
    return number(row.get("flops_per_frame"), 3, GIGA)


def _sentences(ours: list[dict], every: dict, rivals: dict[int, dict]) -> list[str]:
    theirs = every["mpjpe_mm"]
    sweet = lowest(ours, "mpjpe_mm")
    found = [
        f"MPJPE is lowest at N = {sweet['interval']}, {mm(sweet['mpjpe_mm'])}, "
        f"{against(sweet['mpjpe_mm'], theirs)} the estimator on every frame ({mm(theirs)}); Accel "
        f"is lowest at N = {lowest(ours, 'accel_mm')['interval']}."
    ]
    below = [row["interval"] for row in ours if row["mpjpe_mm"] < theirs]
    if len(below) == len(ours):
        found.append(f"It is below the estimator's at every N up to {ours[-1]['interval']}.")
    elif below:
        above = listed([str(row["interval"]) for row in ours if row["interval"] not in below])
        found.append(
            f"It is below the estimator's at N = {listed([str(n) for n in below])}, "
            f"and not below it at N = {above}."
        )
    else:
        found.append("It is below the estimator's at no N.")
    return [*found, *_against_interpolation(ours, rivals)]


def _against_interpolation(ours: list[dict], rivals: dict[int, dict]) -> list[str]:
    compared = [(row, rivals[row["interval"]]) for row in ours if row["interval"] in rivals]
    lost = [
        f"N = {row['interval']} ({mm(row['mpjpe_mm'])} against {mm(rival['mpjpe_mm'])})"
        for row, rival in compared
        if row["mpjpe_mm"] >= rival["mpjpe_mm"]
    ]
    if lost:
        return [f"The best interpolation is as good or better at {listed(lost)}."]
    if not compared:
        return []
    row, rival = min(compared, key=lambda pair: pair[1]["mpjpe_mm"] / pair[0]["mpjpe_mm"])
    return [
        "It is ahead of the best interpolation at every N, least at "
        f"N = {row['interval']}: {against(row['mpjpe_mm'], rival['mpjpe_mm'])} {name_of(rival)}."
    ]


def _plot(pairs: Measured, name: str, steps: list[int]) -> Plot:
    def draw():
        from deciwatch.studies.charts.lines import Level, Line, Panel, line_chart

        def panel(title: str, key: str) -> Panel:
            lines = []
            for method in DRAWN:
                rows = sorted(pairs.where(method=method, estimator=name), key=_interval)
                if rows:
                    places, values = [row["interval"] for row in rows], [row[key] for row in rows]
                    label, colour = METHODS[method], COLOURS[method]
                    lines.append(Line(label, places, values, colour, method == "deciwatch"))
            levels = [
                Level(METHODS[row["method"]], row[key], COLOURS[row["method"]])
                for row in there(pairs, LEVELS, 1, name)
            ]
            return Panel(title, lines, levels, logarithmic=key == "accel_mm")

        panels = [panel("MPJPE, mm", "mpjpe_mm"), panel("Accel, mm/frame²", "accel_mm")]
        return line_chart(panels, "N: one frame in N is watched", steps)

    shows = f"MPJPE and Accel against N, MediaPipe {estimator(name)}"
    return Plot("ratio", shows, draw)


def _interval(row: dict) -> int:
    return row["interval"]

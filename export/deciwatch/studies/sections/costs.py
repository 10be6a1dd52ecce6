"""What a frame costs, and how little of it the nets take."""

from deciwatch.studies.labels import ESTIMATOR_COLOURS, GREY, estimator, in_order
from deciwatch.studies.measured import Lacking, Measured
from deciwatch.studies.section import Content, Plot
from deciwatch.studies.sections.common import N, at, intervals, usual
from deciwatch.studies.words import GIGA, MEGA, number, percent

HEAD = (
    "estimator",
    "every frame: GFLOP, ms",
    f"N = {N}: GFLOP, ms",
    "of which nets: MFLOP",
    "N = 20: GFLOP, ms",
)


def write(pairs: Measured) -> Content:
    """The section."""
    names = [
        name
        for name in in_order(pairs.values("estimator", method="deciwatch"))
        if at(pairs, "every_frame", 1, name).get("flops_per_frame") is not None
    ]
    if not names:
        raise Lacking(f"{pairs.name}.json has no FLOPs")
    rows = []
    for name in names:
        seldom = pairs.where(method="deciwatch", interval=20, estimator=name)
        rows.append(
            (
                estimator(name),
                _cost(at(pairs, "every_frame", 1, name)),
                _cost(at(pairs, "deciwatch", N, name)),
                number(_nets(pairs, name), 2, MEGA),
                _cost(seldom[0]) if seldom else "–",
            )
        )
    notes = [
        "FLOPs are 2 × multiply-accumulates, all frames counted, the 2D nets beside the 3D ones. "
        "Milliseconds: the estimator as it was timed while the pairs were made, the nets in "
        "onnxruntime on one CPU thread."
    ]
    return Content(_sentences(pairs, names), HEAD, rows, [_plot(pairs, names)], notes)


def _cost(row: dict) -> str:
    return f"{number(row['flops_per_frame'], 3, GIGA)}, {number(row.get('ms_per_frame'))}"


def _nets(pairs: Measured, name: str) -> float:
    """FLOPs of the nets per frame: an interpolation has those of the watched frames alone."""
    alone = at(pairs, "linear", N, name)["flops_per_frame"]
    return at(pairs, "deciwatch", N, name)["flops_per_frame"] - alone


def _sentences(pairs: Measured, names: list[str]) -> list[str]:
    name = usual(pairs) if usual(pairs) in names else names[0]
    every, ours = at(pairs, "every_frame", 1, name), at(pairs, "deciwatch", N, name)
    share = ours["flops_per_frame"] / every["flops_per_frame"]
    alone = f"{estimator(name)} on every frame"
    text = f"At N = {N} a frame costs {percent(share)} of the FLOPs of {alone}"
    if every.get("ms_per_frame") and ours.get("ms_per_frame"):
        text += f" and {percent(ours['ms_per_frame'] / every['ms_per_frame'])} of its milliseconds"
    nets = _nets(pairs, name)
    return [
        f"{text}; the nets take {nets / MEGA:.1f} MFLOP of it, "
        f"{percent(nets / ours['flops_per_frame'])}."
    ]


def _plot(pairs: Measured, names: list[str]) -> Plot:
    def draw():
        from deciwatch.studies.charts.lines import Line, Panel, line_chart

        lines = []
        for name in names:
            rows = [at(pairs, "every_frame", 1, name)]
            rows += [at(pairs, "deciwatch", n, name) for n in intervals(pairs, name) if n > 1]
            values = [row["flops_per_frame"] / GIGA for row in rows]
            colour = ESTIMATOR_COLOURS.get(estimator(name), GREY)
            lines.append(
                Line(estimator(name), [row["interval"] for row in rows], values, colour, True)
            )
        panel = Panel("GFLOP a frame, estimator and nets", lines, logarithmic=True)
        return line_chart([panel], "N: one frame in N is watched", intervals(pairs, names[0]))

    return Plot("costs", "FLOPs per frame against N of each estimator", draw)

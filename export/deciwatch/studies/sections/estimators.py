"""Accuracy against FLOPs: a heavy estimator watching seldom, a light one watching always."""

from deciwatch.studies.labels import ESTIMATOR_COLOURS, GREY, estimator, in_order
from deciwatch.studies.measured import Lacking, Measured
from deciwatch.studies.section import Content, Plot
from deciwatch.studies.sections.common import N, at, intervals, uneven_clips
from deciwatch.studies.words import GIGA, against, mm, number

HEAD = ("estimator", "watches", "MPJPE, mm", "Accel, mm/frame²", "GFLOP a frame", "ms a frame")
MARKED = (1, 5, N, 20)
HEAVY, LITE = "mediapipe-heavy", "mediapipe-lite"


def write(pairs: Measured) -> Content:
    """The section."""
    names = in_order(pairs.values("estimator", method="deciwatch"))
    light, seldom = at(pairs, "every_frame", 1, LITE), at(pairs, "deciwatch", N, HEAVY)
    rows = []
    for name in names:
        for row, watches in (
            (at(pairs, "every_frame", 1, name), "every frame"),
            (at(pairs, "deciwatch", N, name), f"1 in {N}, DeciWatch"),
        ):
            if row.get("flops_per_frame") is None:
                raise Lacking(f"{pairs.name}.json has no FLOPs of {name}")
            cells = number(row["mpjpe_mm"]), number(row["accel_mm"])
            costs = number(row["flops_per_frame"], 3, GIGA), number(row.get("ms_per_frame"))
            rows.append((estimator(name), watches, *cells, *costs))
    return Content(
        _sentences(light, seldom), HEAD, rows, [_plot(pairs, names)], uneven_clips(pairs, names)
    )


def _sentences(light: dict, seldom: dict) -> list[str]:
    error = against(seldom["mpjpe_mm"], light["mpjpe_mm"])
    cost = against(seldom["flops_per_frame"], light["flops_per_frame"])
    gained = [seldom[key] < light[key] for key in ("mpjpe_mm", "flops_per_frame")]
    verdict = {2: "it is both better and cheaper", 1: "so one is bought with the other"}
    return [
        f"MediaPipe heavy on one frame in {N} is at {mm(seldom['mpjpe_mm'])}, {error} lite on "
        f"every frame ({mm(light['mpjpe_mm'])}), for "
        f"{seldom['flops_per_frame'] / GIGA:.2f} GFLOP a frame, "
        f"{cost} lite's {light['flops_per_frame'] / GIGA:.2f}: "
        f"{verdict.get(sum(gained), 'it is neither better nor cheaper')}."
    ]


def _plot(pairs: Measured, names: list[str]) -> Plot:
    def draw():
        from deciwatch.studies.charts.lines import Line, Panel, line_chart

        lines = []
        for name in names:
            rows = [at(pairs, "deciwatch", n, name) for n in intervals(pairs, name)][::-1]
            colour = ESTIMATOR_COLOURS.get(estimator(name), GREY)
            marks = [str(row["interval"]) if row["interval"] in MARKED else "" for row in rows]
            lines.append(Line(f"DeciWatch, {estimator(name)}", *_places(rows), colour, True, marks))
            alone = [at(pairs, "every_frame", 1, name)]
            lines.append(Line(f"every frame, {estimator(name)}", *_places(alone), colour))
        panel = Panel("MPJPE, mm; the numbers are N", lines)
        return line_chart(
            [panel], "GFLOP a frame", [0.1, 0.2, 0.5, 1, 2, 5], logarithmic=True, height=3.6
        )

    return Plot("estimators", "MPJPE against FLOPs per frame of lite, full and heavy", draw)


def _places(rows: list[dict]) -> tuple[list[float], list[float]]:
    return [row["flops_per_frame"] / GIGA for row in rows], [row["mpjpe_mm"] for row in rows]

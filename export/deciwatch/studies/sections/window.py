"""Window size: how many intervals the nets see at once."""

from deciwatch.studies.labels import OURS
from deciwatch.studies.measured import Lacking, Measured
from deciwatch.studies.section import Content, Plot
from deciwatch.studies.words import GIGA, against, lowest, mm, number

HEAD = ("Q", "MPJPE, mm", "PA-MPJPE, mm", "Accel, mm/frame²", "GFLOP a frame")


def write(window: Measured) -> Content:
    """The section."""
    rows = sorted(window.rows, key=lambda row: row["window"])
    if len(rows) < 2:
        raise Lacking("window.json has fewer than two windows to compare")
    every = window.about.get("interval")
    best, smallest, largest = lowest(rows, "mpjpe_mm"), rows[0], rows[-1]
    worst = max(rows, key=lambda row: row["mpjpe_mm"])
    sentences = [
        f"At N = {every} a window of Q = {best['window']} has the lowest MPJPE, "
        f"{mm(best['mpjpe_mm'])}, and Q = {worst['window']} the highest, {mm(worst['mpjpe_mm'])}; "
        f"Q = {largest['window']} is {against(largest['mpjpe_mm'], smallest['mpjpe_mm'])} "
        f"Q = {smallest['window']} in MPJPE and "
        f"{against(largest['accel_mm'], smallest['accel_mm'])} it in Accel."
    ]
    table = [
        (
            str(row["window"]),
            number(row["mpjpe_mm"]),
            number(row.get("pa_mpjpe_mm")),
            number(row["accel_mm"]),
            number(row.get("flops_per_frame"), 3, GIGA),
        )
        for row in rows
    ]
    notes = ["The same nets at every Q; they were trained on any of 1 to 10. The page uses 10."]
    return Content(sentences, HEAD, table, [_plot(rows)], notes)


def _plot(rows: list[dict]) -> Plot:
    def draw():
        from deciwatch.studies.charts.lines import Line, Panel, line_chart

        sizes = [row["window"] for row in rows]
        panels = [
            Panel(title, [Line("DeciWatch", sizes, [row[key] for row in rows], OURS, True)])
            for title, key in (("MPJPE, mm", "mpjpe_mm"), ("Accel, mm/frame²", "accel_mm"))
        ]
        return line_chart(panels, "Q: intervals in a window", sizes)

    return Plot("window", "MPJPE and Accel against the window's size", draw)

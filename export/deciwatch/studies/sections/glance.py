"""Every method at N = 10: what is gained, and who is better still."""

from deciwatch.studies.labels import BLACK, CLASSICAL, METHODS, OURS, WATCH_ALL, estimator
from deciwatch.studies.measured import Measured
from deciwatch.studies.section import Content, Plot
from deciwatch.studies.sections.common import N, at, best_classical, name_of, there, usual
from deciwatch.studies.words import GIGA, against, listed, lowest, mm, number, percent, sentence

HEAD = (
    "method",
    "MPJPE, mm",
    "PA-MPJPE, mm",
    "Accel, mm/frame²",
    "2D, px",
    "PCK@0.05",
    "GFLOP a frame",
)
NOTE = (
    "All see MediaPipe's poses: calibrated, 1€ and SmoothNet those of every frame, the others "
    f"those of one frame in {N}. Calibrated: through the affine map of each joint that fits the "
    "training pairs best, so that a mere difference of what a joint is does not count as an error."
)


def write(pairs: Measured) -> Content:
    """The section."""
    name = usual(pairs)
    ours, every = at(pairs, "deciwatch", N, name), at(pairs, "every_frame", N, name)
    compared = there(pairs, (*WATCH_ALL, *CLASSICAL), N, name)
    rows = [*compared, ours]
    return Content(
        _sentences(pairs, name, ours, every, compared), HEAD, _table(rows), [_plot(rows)], [NOTE]
    )


def _sentences(
    pairs: Measured, name: str, ours: dict, every: dict, compared: list[dict]
) -> list[str]:
    mine, theirs = ours["mpjpe_mm"], every["mpjpe_mm"]
    found = [
        f"With MediaPipe {estimator(name)} watching one frame in {N}, DeciWatch's MPJPE is "
        f"{mm(mine)}, {against(mine, theirs)} that of the estimator on every frame ({mm(theirs)})."
    ]
    best = best_classical(pairs, N, name)
    rivals = there(pairs, ("every_frame_calibrated", "one_euro", "smoothnet"), N, name)
    parts = [
        f"{against(mine, best['mpjpe_mm'])} the best interpolation "
        f"({best['method']}, {best['mpjpe_mm']:.1f})"
    ]
    parts += [f"{against(mine, row['mpjpe_mm'])} {_with_figure(row)}" for row in rivals]
    found.append(f"It is {listed(parts)}.")
    found.append(
        f"Its Accel is {percent(ours['accel_mm'] / every['accel_mm'])} of the estimator's "
        f"({ours['accel_mm']:.1f} against {every['accel_mm']:.1f} mm/frame²)."
    )
    if ours.get("pck_05") is not None and every.get("pck_05") is not None:
        found.append(
            f"In the picture, {percent(ours['pck_05'])} of its keypoints lie within 5 % of the box "
            f"from the truth, {percent(every['pck_05'])} of the estimator's."
        )
    return [*found, _better(ours, compared)]


def _better(ours: dict, compared: list[dict]) -> str:
    """Who is ahead of DeciWatch, by either measure."""
    parts = []
    for key, what in (("mpjpe_mm", "MPJPE"), ("accel_mm", "Accel")):
        ahead = [row for row in compared if row[key] < ours[key]]
        if ahead:
            names = listed([_with_figure(row, key) for row in ahead])
            parts.append(f"by {what} it loses to {names}")
        else:
            best = _with_figure(lowest(compared, key), key)
            parts.append(f"by {what} nobody in the table is ahead of it; next is {best}")
    return sentence("; ".join(parts))


def _with_figure(row: dict, key: str = "mpjpe_mm") -> str:
    return f"{name_of(row)} ({row[key]:.1f})"


def _table(rows: list[dict]) -> list[tuple[str, ...]]:
    return [
        (
            METHODS[row["method"]],
            number(row["mpjpe_mm"]),
            number(row.get("pa_mpjpe_mm")),
            number(row["accel_mm"]),
            number(row.get("mpjpe_px")),
            number(row.get("pck_05"), 3),
            number(row.get("flops_per_frame"), 3, GIGA),
        )
        for row in rows
    ]


def _plot(rows: list[dict]) -> Plot:
    def draw():
        from deciwatch.studies.charts.dots import DotPanel, Series, dot_chart

        def panel(title: str, key: str) -> DotPanel:
            others = [None if row["method"] == "deciwatch" else row[key] for row in rows]
            own = [row[key] if row["method"] == "deciwatch" else None for row in rows]
            return DotPanel(
                title, [Series("", others, BLACK, True), Series("DeciWatch", own, OURS, True)]
            )

        names = [METHODS[row["method"]] for row in rows]
        panels = [panel("MPJPE, mm", "mpjpe_mm"), panel("Accel, mm/frame²", "accel_mm")]
        return dot_chart(names, panels, legend=False)

    return Plot(
        "glance", f"MPJPE and Accel of every method, those that skip frames at N = {N}", draw
    )

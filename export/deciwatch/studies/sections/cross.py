"""Other estimators than the one that the nets were trained on."""

from deciwatch.studies.labels import BLACK, GREY, OURS, TRAINED_ON, estimator, in_order
from deciwatch.studies.measured import Lacking, Measured
from deciwatch.studies.section import Content, Plot
from deciwatch.studies.sections.common import N, at, best_classical, there, uneven_clips
from deciwatch.studies.words import against, listed, mm, number, percent

HEAD = (
    "estimator",
    "every frame: MPJPE, mm",
    "calibrated",
    "best interpolation",
    "DeciWatch",
    "Accel: every frame → DeciWatch",
)


def write(pairs: Measured) -> Content:
    """The section."""
    names = in_order(pairs.values("estimator", method="deciwatch"))
    if TRAINED_ON not in names or len(names) < 2:
        raise Lacking(f"{pairs.name}.json has not {TRAINED_ON} and another estimator")
    every = {name: at(pairs, "every_frame", 1, name) for name in names}
    ours = {name: at(pairs, "deciwatch", N, name) for name in names}
    best = {name: best_classical(pairs, N, name) for name in names}
    rows = []
    for name in names:
        calibrated = there(pairs, ("every_frame_calibrated",), 1, name)
        rows.append(
            (
                estimator(name),
                number(every[name]["mpjpe_mm"]),
                number(calibrated[0]["mpjpe_mm"] if calibrated else None),
                f"{number(best[name]['mpjpe_mm'])} ({best[name]['method']})",
                number(ours[name]["mpjpe_mm"]),
                f"{number(every[name]['accel_mm'])} → {number(ours[name]['accel_mm'])}",
            )
        )
    return Content(
        _sentences(names, every, ours, best),
        HEAD,
        rows,
        [_plot(names, every, ours, best)],
        uneven_clips(pairs, names),
    )


def _sentences(
    names: list[str], every: dict[str, dict], ours: dict[str, dict], best: dict[str, dict]
) -> list[str]:
    def beside(name: str) -> str:
        gap = against(ours[name]["mpjpe_mm"], every[name]["mpjpe_mm"])
        return f"{mm(ours[name]['mpjpe_mm'])} on {estimator(name)}, {gap} it on every frame"

    def gain(name: str) -> float:
        return 1 - ours[name]["mpjpe_mm"] / every[name]["mpjpe_mm"]

    home, others = estimator(TRAINED_ON), [name for name in names if name != TRAINED_ON]
    found = [
        f"Trained on {home}, DeciWatch's MPJPE at N = {N} is {beside(TRAINED_ON)}; "
        f"it is {listed([beside(name) for name in others])}."
    ]
    if gain(TRAINED_ON) > 0:
        kept = [f"{percent(gain(x) / gain(TRAINED_ON))} on {estimator(x)}" for x in others]
        found.append(f"Of its relative gain on {home} it keeps {listed(kept)}.")
    lost = [estimator(name) for name in names if ours[name]["mpjpe_mm"] >= best[name]["mpjpe_mm"]]
    if lost:
        found.append(f"It is not ahead of the best interpolation on {listed(lost)}.")
    return found


def _plot(names: list[str], every: dict, ours: dict, best: dict) -> Plot:
    def draw():
        from deciwatch.studies.charts.dots import DotPanel, Series, dot_chart

        def values(of: dict) -> list[float]:
            return [of[name]["mpjpe_mm"] for name in names]

        series = [
            Series("every frame", values(every), BLACK, True),
            Series(f"best interpolation, N = {N}", values(best), GREY),
            Series(f"DeciWatch, N = {N}", values(ours), OURS, True),
        ]
        return dot_chart(
            [estimator(name) for name in names], [DotPanel("MPJPE, mm", series)], left=0.1
        )

    return Plot("cross", "MPJPE of each estimator, on every frame and with DeciWatch", draw)

"""Which joints gain and which do not."""

from deciwatch.studies.labels import BLACK, GREY, OURS
from deciwatch.studies.measured import Lacking, Measured
from deciwatch.studies.section import Content, Plot
from deciwatch.studies.sections.common import N, at, best_classical, usual
from deciwatch.studies.words import against, listed, number

HEAD = (
    "joints",
    "every frame: MPJPE, mm",
    "best interpolation",
    "DeciWatch",
    "against every frame",
)


def write(pairs: Measured) -> Content:
    """The section."""
    name = usual(pairs)
    ours, every = at(pairs, "deciwatch", N, name), at(pairs, "every_frame", 1, name)
    best = best_classical(pairs, N, name)
    tables = [row.get("groups") or {} for row in (every, best, ours)]
    groups = [group for group in tables[0] if all(group in table for table in tables)]
    if not groups:
        raise Lacking(f"{pairs.name}.json has no joint groups")
    rows = [
        (
            group,
            *(number(table[group]) for table in tables),
            against(tables[2][group], tables[0][group]),
        )
        for group in groups
    ]
    return Content(_sentences(groups, *tables), HEAD, rows, [_plot(groups, *tables)])


def _sentences(groups: list[str], every: dict, best: dict, ours: dict) -> list[str]:
    ranked = sorted(groups, key=lambda group: ours[group] / every[group])
    most, least = ranked[0], ranked[-1]
    found = [
        f"Beside the estimator on every frame DeciWatch does best for the {most} "
        f"({against(ours[most], every[most])}) and worst for the {least} "
        f"({against(ours[least], every[least])})."
    ]
    for rival, table in (("the estimator on every frame", every), ("the best interpolation", best)):
        lost = [group for group in groups if ours[group] >= table[group]]
        if lost:
            found.append(f"DeciWatch is no better than {rival} for the {listed(lost)}.")
    return found


def _plot(groups: list[str], every: dict, best: dict, ours: dict) -> Plot:
    def draw():
        from deciwatch.studies.charts.dots import DotPanel, Series, dot_chart

        series = [
            Series("every frame", [every[group] for group in groups], BLACK),
            Series(f"best interpolation, N = {N}", [best[group] for group in groups], GREY),
            Series(f"DeciWatch, N = {N}", [ours[group] for group in groups], OURS, True),
        ]
        return dot_chart(groups, [DotPanel("MPJPE, mm", series)], left=0.1)

    return Plot("groups", "MPJPE by joint group, on every frame and with DeciWatch", draw)

"""Dot plots: a row for each name, one or two panels side by side, a dot for each series."""

from dataclasses import dataclass

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from deciwatch.studies.charts.style import SMALL, new_figure

ROW, HEAD, FOOT = 0.3, 0.55, 0.3  # inches


@dataclass(frozen=True)
class Series:
    """A value for each row, None where there is none; `strong` ones have their values written."""

    label: str
    values: list[float | None]
    colour: str
    strong: bool = False


@dataclass(frozen=True)
class DotPanel:
    """What is shown over one x axis."""

    title: str
    series: list[Series]
    digits: int = 1


def dot_chart(
    names: list[str], panels: list[DotPanel], left: float = 0.28, legend: bool = True
) -> Figure:
    """Rows from top to bottom. `left`: the share of the width that the names take."""
    figure = new_figure(HEAD + ROW * (len(names) + 0.4) + FOOT)
    for place, panel in enumerate(panels):
        axes = figure.add_subplot(1, len(panels), place + 1)
        _draw(axes, panel, len(names))
        axes.set_yticks(range(len(names)), names if place == 0 else [""] * len(names))
    height = figure.get_figheight()
    figure.subplots_adjust(
        left=left, right=0.97, top=1 - HEAD / height, bottom=FOOT / height, wspace=0.12
    )
    if legend:
        figure.legend(
            *figure.axes[0].get_legend_handles_labels(),
            loc="upper left",
            bbox_to_anchor=(left - 0.015, 1.0),
            ncols=len(panels[0].series),
            frameon=False,
            fontsize=SMALL,
            handletextpad=0.1,
            columnspacing=1.2,
        )
    return figure


def _draw(axes: Axes, panel: DotPanel, count: int) -> None:
    axes.set_title(panel.title)
    axes.set_ylim(count - 0.4, -0.8)
    axes.tick_params(axis="y", length=0)
    for row in range(count):
        values = [each.values[row] for each in panel.series if each.values[row] is not None]
        if values:
            axes.plot([min(values), max(values)], [row, row], color="#BBBBBB", zorder=1)
    for series in panel.series:
        rows = [row for row, value in enumerate(series.values) if value is not None]
        values = [series.values[row] for row in rows]
        size = 46 if series.strong else 30
        axes.scatter(values, rows, size, color=series.colour, label=series.label, zorder=2)
        for row, value in zip(rows, values, strict=True) if series.strong else ():
            axes.annotate(
                f"{value:.{panel.digits}f}",
                (value, row),
                (0, 5),
                textcoords="offset points",
                ha="center",
                fontsize=SMALL,
                color=series.colour,
            )
    axes.margins(x=0.14)
    axes.locator_params(axis="x", nbins=5)

"""Line charts, one panel above the other, every line labelled at its right end."""

from dataclasses import dataclass, field

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from deciwatch.studies.charts.style import SMALL, WIDTH, apart, new_figure

PANEL = 2.2  # inches
LEFT, RIGHT = 0.62, 2.0  # inches beside the axes, the right one for the labels
LINE = 11.5  # points from one label to the next


@dataclass(frozen=True)
class Line:
    """Points x, y of one label; `strong` ones are drawn thicker. `marks` are words at points."""

    label: str
    x: list[float]
    y: list[float]
    colour: str
    strong: bool = False
    marks: list[str] | None = None


@dataclass(frozen=True)
class Level:
    """A horizontal line at y, of what does not depend on x."""

    label: str
    y: float
    colour: str


@dataclass(frozen=True)
class Panel:
    """What is shown over the same x axis."""

    title: str
    lines: list[Line]
    levels: list[Level] = field(default_factory=list)
    logarithmic: bool = False


def line_chart(
    panels: list[Panel],
    x_label: str,
    ticks: list[float],
    logarithmic: bool = False,
    height: float = PANEL,
) -> Figure:
    """The panels, `height` inches each, from top to bottom; `ticks` are named on the x axis."""
    figure = new_figure(height * len(panels) + 0.25)
    for row, panel in enumerate(panels):
        axes = figure.add_subplot(len(panels), 1, row + 1)
        _draw(axes, panel, ticks, logarithmic)
        if panel is panels[-1]:
            axes.set_xlabel(x_label)
    whole = figure.get_figheight()
    figure.subplots_adjust(
        left=LEFT / WIDTH,
        right=1 - RIGHT / WIDTH,
        top=1 - 0.3 / whole,
        bottom=0.5 / whole,
        hspace=0.3,
    )
    for axes, panel in zip(figure.axes, panels, strict=True):
        _label(axes, panel)
    return figure


def _draw(axes: Axes, panel: Panel, ticks: list[float], logarithmic: bool) -> None:
    axes.set_title(panel.title)
    for line in panel.lines:
        width, order = (2.4, 3) if line.strong else (1.3, 2)
        axes.plot(line.x, line.y, "o-", color=line.colour, linewidth=width, zorder=order)
        for x, y, word in zip(line.x, line.y, line.marks or [""] * len(line.x), strict=True):
            axes.annotate(word, (x, y), (0, 5), textcoords="offset points", ha="center", fontsize=8)
    for level in panel.levels:
        axes.axhline(level.y, color=level.colour, linewidth=1.3, linestyle=(0, (4, 2)), zorder=1)
    if logarithmic:
        axes.set_xscale("log")
    if panel.logarithmic:
        axes.set_yscale("log")
        axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axes.yaxis.set_minor_formatter(NullFormatter())
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.set_xticks([], minor=True)


def _label(axes: Axes, panel: Panel) -> None:
    """Names beside the ends of lines and levels, moved apart where they would touch."""
    named = [(line.label, line.x[-1], line.y[-1], line) for line in panel.lines]
    named += [(level.label, None, level.y, level) for level in panel.levels]
    to_axes = axes.transData + axes.transAxes.inverted()
    right = max((x for _, x, _, _ in named if x is not None), default=1.0)
    ends = [to_axes.transform((right if x is None else x, y)) for _, x, y, _ in named]
    height = axes.get_position().height * axes.figure.get_figheight() * 72
    places = apart([y for _, y in ends], LINE / height)
    for (label, x, _, drawn), (end, y), place in zip(named, ends, places, strict=True):
        begin = 1.0 if x is None else end
        axes.plot(
            [begin, 1.015, 1.03],
            [y, y, place],
            color=drawn.colour,
            linewidth=0.8,
            linestyle=":",
            transform=axes.transAxes,
            clip_on=False,
            scalex=False,
            scaley=False,
        )
        weight = "bold" if getattr(drawn, "strong", False) else "normal"
        axes.text(
            1.04,
            place,
            label,
            color=drawn.colour,
            fontsize=SMALL,
            fontweight=weight,
            transform=axes.transAxes,
            va="center",
        )

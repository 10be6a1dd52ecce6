"""How every plot looks: 640 px wide on white, so that it is read in light and in dark pages."""

import io
from contextlib import contextmanager
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from scipy.optimize import isotonic_regression

from deciwatch.atomic import write_bytes

WIDTH = 640 / 96  # inches of CSS
SMALL = 9.0  # points
RC = {
    "svg.hashsalt": "deciwatch",
    "svg.fonttype": "none",
    "font.family": "sans-serif",
    # As wide as one another, so that words fit where either is there.
    "font.sans-serif": ["DejaVu Sans", "Verdana"],
    "font.size": 10,
    "axes.labelsize": 10,
    "axes.titlesize": 10,
    "axes.titlelocation": "left",
    "xtick.labelsize": SMALL,
    "ytick.labelsize": SMALL,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": "#777777",
    "axes.grid": True,
    "grid.color": "#E4E4E4",
    "grid.linewidth": 0.8,
    "axes.axisbelow": True,
    "lines.markersize": 5,
    "figure.facecolor": "white",
    "savefig.facecolor": "white",
}


@contextmanager
def styled():
    """matplotlib with this look, and as it was again afterwards."""
    with mpl.rc_context():
        mpl.rcdefaults()
        mpl.rcParams.update(RC)
        yield


def new_figure(height: float) -> Figure:
    """A figure of WIDTH by `height` inches, without a window to it."""
    return Figure(figsize=(WIDTH, height))


def save_svg(figure: Figure, path: Path) -> None:
    """The same bytes for the same numbers: no date, no random ids."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="svg", metadata={"Date": None, "Creator": None})
    write_bytes(path, buffer.getvalue())


def apart(places: list[float], gap: float) -> np.ndarray:
    """The places moved as little as it takes to be `gap` apart, in the order given."""
    order = np.argsort(places, kind="stable")
    steps = gap * np.arange(len(places))
    moved = np.empty(len(places))
    moved[order] = isotonic_regression(np.asarray(places)[order] - steps).x + steps
    return moved

"""What a section of docs/results.md is made of."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from deciwatch.studies.measured import Measured

if TYPE_CHECKING:  # slow to import
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Plot:
    """A picture: its file's name without .svg, what it shows in words, and how it is drawn."""

    name: str
    shows: str
    draw: Callable[[], "Figure"]


@dataclass(frozen=True)
class Content:
    """Sentences that follow from the numbers, a plot, a table of `head` and `rows`, notes."""

    sentences: list[str]
    head: tuple[str, ...]
    rows: list[tuple[str, ...]]
    plots: list[Plot]
    notes: list[str] = field(default_factory=list)


@dataclass(frozen=True)
class Section:
    """A heading, the file it is made from, and the function that writes it.

    The function raises Lacking where the file has not what it needs.
    """

    title: str
    source: str
    write: Callable[[Measured], Content]

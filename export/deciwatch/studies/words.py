"""Numbers in prose. Every claim of docs/results.md is put together from these."""

from collections.abc import Sequence

LEVEL = 5e-4  # relative difference below which two numbers count as the same
GIGA, MEGA = 1e9, 1e6


def percent(share: float) -> str:
    """0.214 → "21 %", 0.0314 → "3.1 %"."""
    digits = 0 if abs(share) >= 0.0995 else 1
    return f"{100 * share:.{digits}f} %"


def against(ours: float, theirs: float) -> str:
    """How `ours` lies to `theirs`: "21 % below", "3.1 % above" or "level with"."""
    off = (ours - theirs) / theirs
    if abs(off) < LEVEL:
        return "level with"
    return f"{percent(abs(off))} {'below' if off < 0 else 'above'}"


def mm(value: float) -> str:
    """A length."""
    return f"{value:.1f} mm"


def listed(parts: Sequence[str], last: str = "and") -> str:
    """ "a", "a and b", "a, b and c"."""
    *head, tail = parts
    return f"{', '.join(head)} {last} {tail}" if head else tail


def sentence(text: str) -> str:
    """With a capital at its beginning and a full stop at its end."""
    return f"{text[0].upper()}{text[1:]}."


def number(value: float | None, digits: int = 1, unit: float = 1.0) -> str:
    """A cell of a table; a dash where nothing was measured."""
    return "–" if value is None else f"{value / unit:,.{digits}f}"


def lowest(rows: Sequence[dict], key: str) -> dict:
    """The row with the least of `key`."""
    return min(rows, key=lambda row: row[key])

"""The rows as text, each printed as soon as it is known, and as JSON."""

import json
import sys
from collections.abc import Iterable
from pathlib import Path

from deciwatch.atomic import write_text
from deciwatch.evaluation.scoring import GROUPS

MEGA = 1e6
# Heading, key in the row, digits after the point, divisor.
COLUMNS = (
    ("MPJPE mm", "mpjpe_mm", 1, 1),
    ("PA mm", "pa_mpjpe_mm", 1, 1),
    ("Accel mm", "accel_mm", 1, 1),
    ("PCK@.2", "pck_20", 3, 1),
    ("PCK@.1", "pck_10", 3, 1),
    ("PCK@.05", "pck_05", 3, 1),
    ("MPJPE px", "mpjpe_px", 2, 1),
    ("Accel px", "accel_px", 2, 1),
    ("MFLOPs", "flops_per_frame", 1, MEGA),
    ("ms", "ms_per_frame", 2, 1),
)
STDOUT = "-"


def say(sentence: str) -> None:
    """Tell the user something that is not a result."""
    print(sentence, file=sys.stderr, flush=True)


def rounded(row: dict) -> dict:
    """The row with numbers of sensible length, as it is written to JSON."""
    short = {key: round(x, 4) if isinstance(x, float) else x for key, x in row.items()}
    if short["flops_per_frame"] is not None:
        short["flops_per_frame"] = round(short["flops_per_frame"])
    return short | {"groups": {key: round(x, 4) for key, x in row["groups"].items()}}


def print_rows(rows: Iterable[dict], estimators: list[str]) -> list[dict]:
    """Print a line for each row as it comes, then MPJPE by joint group; returns the rows."""
    label = max(len("estimator"), *(len(name) for name in estimators))
    head = f"{'estimator':{label}}  {'method':22}  {'N':>2}"
    print(head + "".join(f"  {title:>8}" for title, *_ in COLUMNS))
    kept = []
    for row in rows:
        kept.append(row)
        print(_start(row, label) + "".join(_cell(row[key], *how) for _, key, *how in COLUMNS))
        sys.stdout.flush()
    if any(row["groups"] for row in kept):
        print(f"\nMPJPE mm by joint group\n{head}" + "".join(f"  {name:>8}" for name in GROUPS))
        for row in kept:
            cells = (_cell(row["groups"].get(name), 1, 1) for name in GROUPS)
            print(_start(row, label) + "".join(cells))
    return kept


def _start(row: dict, label: int) -> str:
    return f"{row['estimator']:{label}}  {row['method']:22}  {row['interval']:>2}"


def _cell(value: float | None, digits: int, divisor: float) -> str:
    return f"  {'-':>8}" if value is None else f"  {value / divisor:8.{digits}f}"


def show(rows: Iterable[dict], estimators: list[str], json_to: str | None, extra: dict) -> None:
    """Print the table, or, where json_to is STDOUT, the JSON alone; else write the JSON there."""
    if json_to == STDOUT:
        print(_document(rows, extra), end="")
        return
    kept = print_rows(rows, estimators)
    if json_to:
        write_text(Path(json_to), _document(kept, extra))


def _document(rows: Iterable[dict], extra: dict) -> str:
    return json.dumps(extra | {"rows": [rounded(row) for row in rows]}, indent=2) + "\n"

"""The JSON of a study: what it was measured on and how, and a row for each thing measured."""

import json
from pathlib import Path
from typing import Any

from deciwatch.atomic import write_text
from deciwatch.errors import UserError


def read_document(path: Path, about: dict) -> list[dict]:
    """The rows that are there already, none where there is no file.

    Raises UserError where the file is damaged or was measured otherwise than `about` says: rows of
    one file can be compared with one another.
    """
    if not path.is_file():
        return []
    try:
        content = json.loads(path.read_text())
        rows, there = content["rows"], {key: content[key] for key in about}
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise UserError(f"{path} is no file of a study ({error}); delete it.") from error
    for key, wanted in _plain(about).items():
        if there[key] != wanted:
            raise UserError(
                f"{path} was measured with other {key} than asked for now; name another file by "
                "--out, or delete it."
            )
    return rows


def add_row(path: Path, about: dict, row: dict) -> None:
    """Put a row, by its name, behind those that are there."""
    rows = [other for other in read_document(path, about) if other["name"] != row["name"]]
    write_document(path, about, [*rows, row])


def write_document(path: Path, about: dict, rows: list[dict]) -> None:
    """Write the whole file, atomically."""
    write_text(path, json.dumps(about | {"rows": rows}, indent=2, ensure_ascii=False) + "\n")


def rounded(value: Any) -> Any:
    """Floats to four digits after the point, also inside dicts and lists."""
    if isinstance(value, float):
        return round(value, 4)
    if isinstance(value, dict):
        return {key: rounded(each) for key, each in value.items()}
    return [rounded(each) for each in value] if isinstance(value, list) else value


def _plain(about: dict) -> dict:
    """As it comes back from JSON: tuples are lists."""
    return json.loads(json.dumps(about))

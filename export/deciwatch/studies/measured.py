"""The JSON files that `deciwatch results` reads, and looking things up in them."""

import json
from dataclasses import dataclass
from pathlib import Path

from deciwatch.errors import UserError

RUN = "python -m deciwatch"
PAIRS = " ".join(f"runs/pairs/test-{name}.npz" for name in ("full", "lite", "heavy"))
# File in docs/results/: the command that measures it.
COMMANDS = {
    "pairs": f"{RUN} evaluate --pairs {PAIRS} --json docs/results/pairs.json",
    "labelling": f"{RUN} evaluate --labelling --json docs/results/labelling.json",
    "live": f"{RUN} evaluate --live --pairs runs/pairs/test-full.npz --json docs/results/live.json",
    "variants": f"{RUN} study train --steps 1200",
    "sampling": f"{RUN} study sampling",
    "window": f"{RUN} study window",
}


class Lacking(Exception):
    """Something that a section needs was not measured; the message says what."""


@dataclass(frozen=True)
class Measured:
    """One file: its rows, and under other keys what they were measured on."""

    name: str
    rows: list[dict]
    about: dict

    def where(self, **keys) -> list[dict]:
        """The rows with these values, in the file's order."""
        return [row for row in self.rows if all(row.get(k) == v for k, v in keys.items())]

    def one(self, **keys) -> dict:
        """The first such row. Raises Lacking where there is none."""
        rows = self.where(**keys)
        if not rows:
            wanted = ", ".join(f"{key} {value}" for key, value in keys.items())
            raise Lacking(f"{self.name}.json has no row of {wanted}")
        return rows[0]

    def values(self, key: str, **keys) -> list:
        """The different values of `key` among the rows with these values, in order."""
        return list(dict.fromkeys(row[key] for row in self.where(**keys) if key in row))


def read_measured(folder: Path) -> dict[str, Measured]:
    """The files of COMMANDS that are there. Raises UserError where one is damaged."""
    found = {}
    for name, command in COMMANDS.items():
        path = folder / f"{name}.json"
        if not path.is_file():
            continue
        try:
            content = json.loads(path.read_text())
            rows = content.pop("rows")
            if not all(isinstance(row, dict) for row in rows):
                raise ValueError("a row is no object")
        except (ValueError, KeyError, TypeError, AttributeError) as error:
            raise UserError(f"{path} holds no rows ({error}); make it by `{command}`.") from error
        found[name] = Measured(name, rows, content)
    return found

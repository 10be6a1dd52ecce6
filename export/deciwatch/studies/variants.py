"""The trained variants: the shipped configuration, and what each of the others changes in it."""

from dataclasses import asdict, dataclass, fields, replace
from pathlib import Path
from typing import Any

from deciwatch import checkpoint
from deciwatch.loss import LAMBDA
from deciwatch.nets.pair import PairConfig

SEED = 1
# Every variant is the base with one of these set to another value; the base stands for its own.
VALUES: dict[str, tuple] = {
    "lam": (1.0, 2.0, 5.0, 10.0),  # λ of equation 6
    "width": (64, 128, 192),  # C
    "blocks": (1, 3, 5),  # M
    "recover": ("samples", "frames"),  # what RecoverNet has tokens for
    "preliminary": ("cubic", "linear"),  # W_PR
    "inputs": (("3d",), ("3d", "scores"), ("3d", "2d", "scores")),
    "data": ("pairs", "noise", "both"),  # see training_data.py
    "seed": (SEED, 2, 3),  # how much chance alone does
}
SIZE_UNLESS_SHIPPED = {"width": 128, "blocks": 3}
CONFIGURED = frozenset(field.name for field in fields(PairConfig))


@dataclass(frozen=True)
class Settings:
    """All that a training of this study may differ in."""

    config: PairConfig
    lam: float = LAMBDA
    data: str = "both"
    seed: int = SEED

    def get(self, key: str) -> Any:
        """The value of one of VALUES."""
        return getattr(self.config if key in CONFIGURED else self, key)

    def changed(self, key: str, value: Any) -> "Settings":
        """The same with one of VALUES set."""
        if key in CONFIGURED:
            return replace(self, config=replace(self.config, **{key: value}))
        return replace(self, **{key: value})

    def as_dict(self) -> dict:
        """Plain values, for JSON."""
        rest = {"lam": self.lam, "data": self.data, "seed": self.seed}
        return asdict(self.config) | {"inputs": list(self.config.inputs)} | rest


@dataclass(frozen=True)
class Variant:
    """One training. `differs` is empty for the base, else one key of VALUES (`group`) and value."""

    name: str
    group: str
    differs: dict[str, Any]
    settings: Settings


def base_settings(path: Path) -> Settings:
    """The shipped 3D pair's, if its checkpoint at `path` is one that takes every input."""
    everything = max(VALUES["inputs"], key=len)
    if path.is_file():
        shipped = checkpoint.load(path)["config"]
        if shipped.inputs == everything and shipped.recover == "samples":
            return Settings(shipped)
    return Settings(PairConfig(inputs=everything, recover="samples", **SIZE_UNLESS_SHIPPED))


def variants(base: Settings) -> list[Variant]:
    """The base and every other value of VALUES, in that order."""
    found = [Variant("base", "base", {}, base)]
    for key, values in VALUES.items():
        found += [
            Variant(f"{key}-{_word(value)}", key, {key: value}, base.changed(key, value))
            for value in values
            if value != base.get(key)
        ]
    return found


def _word(value: Any) -> str:
    """A value as part of a name."""
    if isinstance(value, tuple):
        return "-".join(value)
    return f"{value:g}" if isinstance(value, float) else str(value)

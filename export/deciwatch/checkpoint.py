"""Checkpoints: a pair's weights and configuration, and, while training, all it takes to go on."""

import hashlib
import io
from pathlib import Path
from typing import Any, TypeVar

import torch

from deciwatch.atomic import write_bytes
from deciwatch.errors import UserError
from deciwatch.nets.forecast import ForecastConfig, ForecastNet
from deciwatch.nets.pair import Pair, PairConfig
from deciwatch.paths import CHECKPOINTS

# What a checkpoint's nets are built from, and how such a file calls itself.
FORMATS: dict[type, str] = {
    PairConfig: "deciwatch-checkpoint/1",
    ForecastConfig: "deciwatch-forecast/1",
}
Config = PairConfig | ForecastConfig
Net = TypeVar("Net", Pair, ForecastNet)


def default_path(dims: int) -> Path:
    """The committed checkpoint of a representation."""
    return CHECKPOINTS / f"{dims}d.pt"


def forecast_path(dims: int) -> Path:
    """The committed checkpoint of a representation's ForecastNet."""
    return CHECKPOINTS / f"{dims}d-forecast.pt"


def save(
    path: Path, config: Config, weights: dict, training: dict, state: dict | None = None
) -> None:
    """Write a checkpoint atomically. `state` is the trainer's own and is left out when sharing."""
    content = {"format": FORMATS[type(config)], "config": config.as_dict(), "weights": weights}
    content |= {"training": training} | ({} if state is None else {"state": state})
    buffer = io.BytesIO()
    torch.save(content, buffer)
    write_bytes(Path(path), buffer.getvalue())


def load(path: Path, kind: type = PairConfig) -> dict[str, Any]:
    """Read a checkpoint: config (of `kind`), weights, training, perhaps state.

    Raises UserError if it is missing, damaged, or not one of ours. Only tensors and plain values
    are unpickled, so a foreign file cannot run code.
    """
    path = Path(path)
    if not path.is_file():
        raise UserError(f"There is no checkpoint at {path}; train one, or name it by --checkpoint.")
    try:
        content = torch.load(path, map_location="cpu", weights_only=True)
        if content["format"] != FORMATS[kind]:
            raise ValueError(f"its format is {content['format']!r}")
        content["config"] = kind(**content["config"])
        if not {"weights", "training"} <= content.keys():
            raise ValueError("parts of it are missing")
    except Exception as error:
        reason = " ".join(str(error).split())[:120]
        raise UserError(
            f"{path} is not a whole DeciWatch checkpoint ({reason}); train or fetch it again."
        ) from error
    return content


def load_pair(path: Path, dims: int | None = None) -> tuple[Pair, dict[str, Any]]:
    """The pair of a checkpoint, in evaluation mode, and the checkpoint.

    Raises UserError also where its weights do not fit its configuration or `dims` is another.
    """
    content = load(path)
    config: PairConfig = content["config"]
    if dims is not None and config.dims != dims:
        raise UserError(f"{path} holds a {config.dims}D pair; name a {dims}D one by --checkpoint.")
    return _with_weights(Pair(config), content, path), content


def load_forecast(path: Path, dims: int | None = None) -> tuple[ForecastNet, dict[str, Any]]:
    """The ForecastNet of a checkpoint, in evaluation mode, and the checkpoint.

    Raises UserError as `load_pair` does.
    """
    content = load(path, ForecastConfig)
    config: ForecastConfig = content["config"]
    if dims is not None and config.dims != dims:
        raise UserError(f"{path} holds a {config.dims}D ForecastNet; name a {dims}D one.")
    return _with_weights(ForecastNet(config), content, path), content


def _with_weights(net: Net, content: dict[str, Any], path: Path) -> Net:
    """`net` with a checkpoint's weights, in evaluation mode. Raises UserError where they misfit."""
    try:
        net.load_state_dict(content["weights"])
    except RuntimeError as error:
        raise UserError(
            f"The weights in {path} do not fit its own configuration; train or fetch it again."
        ) from error
    return net.eval()


def digest(path: Path) -> str:
    """What tells one pair's weights from another's: a hash of them, 16 hexadecimal digits."""
    weights = load(path)["weights"]
    found = hashlib.sha256()
    for name in sorted(weights):
        found.update(name.encode())
        found.update(weights[name].cpu().numpy().tobytes())
    return found.hexdigest()[:16]

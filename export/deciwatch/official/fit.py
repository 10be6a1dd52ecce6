"""The weights of a checkpoint against the nets that they are said to be of: names what differs."""

import re
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

import torch
from torch import Tensor

from deciwatch.errors import UserError
from deciwatch.official.config import OfficialConfig
from deciwatch.official.reference import Reference

PREFIX = "transformer."
_WIDTHS, _FORWARD = f"{PREFIX}encoder_embed.weight", f"{PREFIX}encoder.layers.0.linear1.weight"


def has_encoder_norm(given: dict[str, object]) -> bool:
    """Whether the encoder ends with a norm, as it does with pre-norm alone."""
    return any(key.startswith(f"{PREFIX}encoder.norm.") for key in given)


def fitting_weights(
    given: dict[str, object], config: OfficialConfig, path: Path
) -> dict[str, Tensor]:
    """The weights of `transformer`, float32, by their names in it, of what `read_state` gave.

    Raises UserError that names every key and shape which is not as `config` wants it. Where other
    sizes would fit the whole file it names those, and of the wrong shapes only the first.
    """
    keys, shapes = _faults(given, config)
    if keys or shapes:
        own = _own_sizes(given, config)
        if own and not any(_faults(given, own)):
            better = [word for word in own.shaping_options if word not in config.shaping_options]
            raise UserError(
                f"{path} wants {' '.join(better)}; with the options that were given "
                f"{'; '.join(keys + shapes[:1])}."
            )
        raise UserError(
            f"{path} is not a net of {' '.join(config.shaping_options)}: "
            f"{'; '.join(keys + shapes)}."
        )
    return {key.removeprefix(PREFIX): given[key].float() for key in _wanted(config)}


def _wanted(config: OfficialConfig) -> dict[str, list[int]]:
    """The shape of each key."""
    with torch.device("meta"):
        state = Reference(config).state_dict()
    return {PREFIX + key: list(weight.shape) for key, weight in state.items()}


def _faults(given: dict[str, object], config: OfficialConfig) -> tuple[list[str], list[str]]:
    """What is wrong with the keys, and with the weights of those that are there."""
    wanted = _wanted(config)
    keys = [f"{name} is missing" for name in _named(wanted.keys() - given.keys(), given)]
    keys += [f"{name} is not expected" for name in _named(given.keys() - wanted.keys(), wanted)]
    found = [(key, _fault(given[key], shape)) for key, shape in wanted.items() if key in given]
    return keys, [f"{key} {fault}" for key, fault in found if fault]


def _own_sizes(given: dict[str, object], config: OfficialConfig) -> OfficialConfig | None:
    """The configuration that a few of the weights speak for; None where they do not tell."""
    embed, forward = given.get(_WIDTHS), given.get(_FORWARD)
    layers = {
        f"{net}_layers": sum(
            bool(re.fullmatch(rf"{PREFIX}{net}\.layers\.\d+\.linear1\.weight", key))
            for key in given
        )
        for net in ("encoder", "decoder")
    }
    if not (isinstance(embed, Tensor) and isinstance(forward, Tensor) and all(layers.values())):
        return None
    if embed.ndim != 2 or forward.ndim != 2:
        return None
    # Heads and dimensions leave no trace in shapes: of one each, any sizes go together.
    sizes = {"hidden": embed.shape[0], "input_dim": embed.shape[1], "heads": 1, "dims": 1}
    sizes |= {"feed_forward": forward.shape[0], "pre_norm": has_encoder_norm(given)}
    return replace(config, **sizes, **layers) if embed.shape[0] % 2 == 0 else None


def _fault(weight: object, shape: list[int]) -> str | None:
    if not isinstance(weight, Tensor):
        return f"is of type {type(weight).__name__} instead of a tensor {shape}"
    if list(weight.shape) != shape:
        return f"is {list(weight.shape)} instead of {shape}"
    return None if weight.isfinite().all() else "has values that are not finite"


def _named(keys: Iterable[str], others: Iterable[str]) -> list[str]:
    """Names in order, a layer of which `others` has nothing as a whole."""
    names = {}
    for key in sorted(keys):
        layer = re.match(r".*\.layers\.\d+\.", key)
        whole = layer and not any(other.startswith(layer[0]) for other in others)
        names[f"{layer[0]}*" if whole else key] = True
    return list(names)

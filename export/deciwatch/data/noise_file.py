"""The fitted noise model as a file: export/checkpoints/noise.npz."""

import io
from dataclasses import fields
from pathlib import Path

import numpy as np

from deciwatch.atomic import write_bytes
from deciwatch.data.residuals import VALUES, ResidualNoise
from deciwatch.errors import UserError
from deciwatch.paths import CHECKPOINTS

DEFAULT = CHECKPOINTS / "noise.npz"
NAMES = tuple(field.name for field in fields(ResidualNoise))


def save_noise(path: Path, model: ResidualNoise) -> int:
    """Write a model atomically; returns its size in bytes."""
    buffer = io.BytesIO()
    np.savez_compressed(buffer, **{name: getattr(model, name) for name in NAMES})
    write_bytes(path, buffer.getvalue())
    return len(buffer.getvalue())


def load_noise(path: Path) -> ResidualNoise:
    """Read a model. Raises UserError if it is missing or damaged."""
    path = Path(path)
    if not path.is_file():
        raise UserError(f"There is no noise model at {path}; make one with `deciwatch fit-noise`.")
    try:
        with np.load(path, allow_pickle=False) as content:
            model = ResidualNoise(**{name: content[name] for name in NAMES})
        if model.bias.shape != (100, VALUES):
            raise ValueError(f"its bias is {model.bias.shape}")
    except Exception as error:
        reason = " ".join(str(error).split())[:100]
        raise UserError(
            f"{path} is not a whole noise model ({reason}); make it with `deciwatch fit-noise`."
        ) from error
    return model

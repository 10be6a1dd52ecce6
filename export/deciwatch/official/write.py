"""A checkpoint in the authors' format, for tests and fixtures."""

import io
from pathlib import Path

import torch

from deciwatch.atomic import write_bytes
from deciwatch.official.reference import Reference


def save(path: Path, reference: Reference, prefix: str = "transformer.") -> None:
    """Write a net as their trainer does; `prefix` is "module.transformer." from several GPUs."""
    weights = {prefix + key: weight for key, weight in reference.state_dict().items()}
    # Of the trainer's other entries only these two matter to a reader: it must step over them.
    content = {"epoch": 69, "state_dict": weights, "performance": None}
    buffer = io.BytesIO()
    torch.save(content, buffer)
    write_bytes(Path(path), buffer.getvalue())

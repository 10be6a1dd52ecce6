"""Opens a checkpoint of the authors' format without running anything that it holds."""

import re
from pathlib import Path

import numpy as np
import torch

from deciwatch.errors import UserError

# Their trainer keeps its scores, numpy numbers, beside the weights. Files name numpy's function by
# the module it lay in when they were written.
_SCALAR = np._core.multiarray.scalar
HARMLESS = [
    (_SCALAR, "numpy.core.multiarray.scalar"),
    (_SCALAR, "numpy._core.multiarray.scalar"),
    *(np.dtype, np.dtypes.Float64DType, np.dtypes.Float32DType),
]


def read_state(path: Path) -> dict[str, object]:
    """The state_dict of a checkpoint, or of a file that is nothing else, without "module.".

    Only tensors and plain values are unpickled, so that a file cannot run code. Raises UserError
    if the file cannot be read so.
    """
    if not path.is_file():
        raise UserError(f"There is no checkpoint at {path}; name the file that was downloaded.")
    try:
        with torch.serialization.safe_globals(HARMLESS):
            content = torch.load(path, map_location="cpu", weights_only=True)
    except Exception as error:
        named = re.search(r"GLOBAL ([\w.]+)", str(error))
        reason = f"it wants {named[1]}" if named else "it is damaged, or not of torch.save"
        raise UserError(
            f"{path} cannot be read as tensors and plain values alone ({reason}), and nothing else "
            f"is run here; where you trust it, load it with the torch that wrote it and save only "
            f"its state_dict."
        ) from error
    weights = content.get("state_dict", content) if isinstance(content, dict) else None
    if not isinstance(weights, dict) or not all(isinstance(key, str) for key in weights):
        raise UserError(f"{path} holds no state_dict; give a checkpoint of DeciWatch's authors.")
    return {key.removeprefix("module."): weight for key, weight in weights.items()}

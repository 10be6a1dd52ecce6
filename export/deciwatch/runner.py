"""One window through a pair of nets, from poses to poses: by onnxruntime, or by torch."""

from collections.abc import Callable
from pathlib import Path

import numpy as np

from deciwatch.data.batches import TIME_UNIT
from deciwatch.errors import UserError
from deciwatch.normalise import frame_of, from_net, to_net

# sampled [1, S, K·D], sample_times [1, S], frame_times [1, T] → poses [1, T, K·D]
Nets = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]


def recover_window(
    nets: Nets, sampled: np.ndarray, sample_seconds: np.ndarray, seconds: np.ndarray
) -> np.ndarray:
    """Poses [S, K, D] at sample_seconds [S] → [T, K, D] at `seconds` [T]; metres or pixels."""
    origin, unit = frame_of(sampled)
    begin = sample_seconds[0]
    times = [
        ((at - begin) / TIME_UNIT).astype(np.float32)[None] for at in (sample_seconds, seconds)
    ]
    values = nets(to_net(sampled, origin, unit)[None], *times)
    return from_net(values[0], origin, unit)


def onnx_nets(folder: Path, dims: int) -> Nets:
    """The nets of a models folder. Raises UserError where the manifest or a file is missing."""
    from deciwatch import manifest
    from deciwatch.onnx_export import session

    pairs = manifest.read(folder)["pairs"]
    name = f"{dims}d"
    if name not in pairs:
        raise UserError(f"{folder} has no {dims}D nets; run `deciwatch export --dims {dims}`.")
    try:
        denoise, recover = (
            session(folder / pairs[name][kind]["file"]) for kind in ("denoise", "recover")
        )
    except Exception as error:
        reason = " ".join(str(error).split())[:120]
        raise UserError(
            f"The {dims}D nets in {folder} do not load ({reason}); export them anew."
        ) from error

    def run(sampled: np.ndarray, sample_times: np.ndarray, frame_times: np.ndarray) -> np.ndarray:
        clean, features = denoise.run(None, {"sampled": sampled, "sample_times": sample_times})
        feeds = {"clean": clean, "features": features, "sample_times": sample_times}
        return recover.run(None, feeds | {"frame_times": frame_times})[0]

    return run


def torch_nets(path: Path, dims: int) -> Nets:
    """The nets of a checkpoint."""
    import torch

    from deciwatch.checkpoint import load_pair

    pair, _ = load_pair(path, dims)

    def run(*arrays: np.ndarray) -> np.ndarray:
        with torch.no_grad():
            return pair(*map(torch.from_numpy, arrays))[1].numpy()

    return run

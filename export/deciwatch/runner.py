"""One window through a pair of nets, from poses to poses: by onnxruntime, or by torch."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from deciwatch.data.batches import TIME_UNIT
from deciwatch.errors import UserError
from deciwatch.normalise import Samples, frame_of, from_net, sampled_values

if TYPE_CHECKING:  # torch is slow to import, and onnx_nets does without
    from deciwatch.nets.pair import Pair

# sampled [1, S, I], sample_times [1, S] → clean [1, S, K·D], features [1, S, C]
Denoise = Callable[[np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray]]
# clean, features, sample_times [1, S], frame_times [1, T] → poses [1, T, K·D]
Recover = Callable[[np.ndarray, np.ndarray, np.ndarray, np.ndarray], np.ndarray]
Forecast = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]


@dataclass(frozen=True)
class Nets:
    """A pair of nets in net values and time units: D, the names of its inputs, its two halves."""

    dims: int
    inputs: tuple[str, ...]
    denoise: Denoise
    recover: Recover
    # sampled, times [1, S], and [1, T] from the last sample on → poses [1, T, K·D]; it may lack
    forecast: Forecast | None = None

    def run(
        self, sampled: np.ndarray, sample_times: np.ndarray, frame_times: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """sampled [1, S, I], times [1, S] and [1, T] → poses [1, T, K·D], clean [1, S, K·D]."""
        clean, features = self.denoise(sampled, sample_times)
        return self.recover(clean, features, sample_times, frame_times), clean


class Recovered(NamedTuple):
    """In metres or pixels: poses [T, K, D] of a window's frames, clean [S, K, D] of its samples."""

    poses: np.ndarray
    clean: np.ndarray


def recover_window(
    nets: Nets, samples: Samples, sample_seconds: np.ndarray, seconds: np.ndarray
) -> Recovered:
    """The samples, taken at sample_seconds [S], → the poses at `seconds` [T].

    Raises UserError where `samples` lacks an input of the nets.
    """
    own = frame_of(samples.of(nets.inputs[0]))
    begin = sample_seconds[0]
    times = [
        ((at - begin) / TIME_UNIT).astype(np.float32)[None] for at in (sample_seconds, seconds)
    ]
    poses, clean = nets.run(sampled_values(samples, nets.inputs)[None], *times)
    return Recovered(from_net(poses[0], *own), from_net(clean[0], *own))


def onnx_nets(folder: Path, dims: int) -> Nets:
    """The nets of a models folder. Raises UserError where the manifest or a file is missing."""
    from deciwatch import manifest
    from deciwatch.onnx_export import FORECAST_NAMES, NAMES, session

    pairs = manifest.read(folder)["pairs"]
    name = f"{dims}d"
    if name not in pairs:
        raise UserError(f"{folder} has no {dims}D nets; run `deciwatch export --dims {dims}`.")
    try:
        inputs = tuple(pairs[name]["inputs"])
        graphs = {kind: session(folder / pairs[name][kind]["file"]) for kind in NAMES}
        if ahead := pairs[name].get(manifest.FORECAST):
            graphs[manifest.FORECAST] = session(folder / ahead["file"])
    except Exception as error:
        reason = " ".join(str(error).split())[:120]
        raise UserError(
            f"The {dims}D nets in {folder} do not load ({reason}); export them anew."
        ) from error

    def run(kind: str, *arrays: np.ndarray) -> list[np.ndarray]:
        names = (NAMES | {manifest.FORECAST: FORECAST_NAMES})[kind][0]
        return graphs[kind].run(None, dict(zip(names, arrays, strict=True)))

    return Nets(
        dims,
        inputs,
        denoise=lambda *arrays: tuple(run("denoise", *arrays)),
        recover=lambda *arrays: run("recover", *arrays)[0],
        forecast=(lambda *arrays: run(manifest.FORECAST, *arrays)[0])
        if manifest.FORECAST in graphs
        else None,
    )


def torch_nets(path: Path, dims: int) -> Nets:
    """The nets of a checkpoint."""
    from deciwatch.checkpoint import load_pair

    return nets_of(load_pair(path, dims)[0])


def nets_of(pair: "Pair") -> Nets:
    """The nets of a torch pair in evaluation mode; these take batches too."""
    import torch

    def denoise(*arrays: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        with torch.no_grad():
            clean, features = pair.denoise(*map(torch.from_numpy, arrays))
        return clean.numpy(), features.numpy()

    def recover(*arrays: np.ndarray) -> np.ndarray:
        with torch.no_grad():
            return pair.recover(*map(torch.from_numpy, arrays)).numpy()

    return Nets(pair.config.dims, pair.config.inputs, denoise, recover)

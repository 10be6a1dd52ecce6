"""Pairs of nets that know what a window costs, and the same with one of the two taken out."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import torch
from torch.utils.flop_counter import FlopCounterMode

from deciwatch import checkpoint, flops, manifest
from deciwatch.nets.pair import Pair, PairConfig
from deciwatch.nets.preliminary import preliminary_recovery
from deciwatch.runner import Nets, nets_of, onnx_nets
from deciwatch.skeleton import KEYPOINTS

BATCH = 64


@dataclass(frozen=True)
class CountedNets:
    """A pair, its kind of W_PR, and FLOPs of each net on a window of S samples and T frames.

    batch: windows that it takes at once; the graphs that the page runs take one.
    """

    nets: Nets
    preliminary: str
    batch: int
    denoise_flops: Callable[[int, int], int]
    recover_flops: Callable[[int, int], int]

    def flops(self, samples: int, frames: int) -> int:
        """FLOPs of the pair on one window."""
        return self.denoise_flops(samples, frames) + self.recover_flops(samples, frames)


def from_models(folder: Path, dims: int) -> CountedNets:
    """The nets of a models folder; FLOPs by its manifest. Raises UserError."""
    nets = onnx_nets(folder, dims)
    entry = manifest.read(folder)["pairs"][f"{dims}d"]

    def counter(kind: str) -> Callable[[int, int], int]:
        return lambda samples, frames: flops.evaluate(entry[kind]["flops"], samples, frames)

    kind = entry["recover"].get("preliminary", PairConfig().preliminary)
    return CountedNets(nets, kind, 1, counter("denoise"), counter("recover"))


def from_checkpoint(path: Path, dims: int) -> CountedNets:
    """The nets of a checkpoint, run by torch; FLOPs counted as they run. Raises UserError."""
    pair, _ = checkpoint.load_pair(path, dims)
    return CountedNets(
        nets_of(pair),
        pair.config.preliminary,
        BATCH,
        cache(lambda samples, frames: _denoise_flops(pair, samples)),
        cache(lambda samples, frames: _recover_flops(pair, samples, frames)),
    )


def without_denoise(pair: CountedNets) -> CountedNets:
    """The raw samples in place of the clean ones; RecoverNet still gets DenoiseNet's features."""
    denoise, values = pair.nets.denoise, KEYPOINTS * pair.nets.dims

    def raw(sampled: np.ndarray, times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return np.ascontiguousarray(sampled[..., :values]), denoise(sampled, times)[1]

    return replace(pair, nets=replace(pair.nets, denoise=raw))


def without_recover(pair: CountedNets) -> CountedNets:
    """The preliminary recovery alone, W_PR times the clean poses (the paper's equation 3)."""

    def preliminary(clean: Any, _: Any, sample_times: Any, frame_times: Any) -> np.ndarray:
        inputs = map(torch.from_numpy, (clean, sample_times, frame_times))
        return preliminary_recovery(*inputs, pair.preliminary).numpy()

    def count(samples: int, frames: int) -> int:
        clean = np.zeros((1, samples, KEYPOINTS * pair.nets.dims), np.float32)
        return _counted(lambda: preliminary(clean, None, *_times(samples, frames)))

    nets = replace(pair.nets, recover=preliminary)
    return replace(pair, nets=nets, recover_flops=cache(count))


def _times(samples: int, frames: int) -> tuple[np.ndarray, np.ndarray]:
    """sample_times [1, S] and frame_times [1, T] of an even window."""
    places = np.linspace(0, frames - 1, samples, dtype=np.float32)
    return places[None], np.arange(frames, dtype=np.float32)[None]


def _denoise_flops(pair: Pair, samples: int) -> int:
    sampled = torch.zeros(1, samples, pair.config.channels)
    times = torch.arange(samples, dtype=torch.float32)[None]
    return _counted(lambda: pair.denoise(sampled, times))


def _recover_flops(pair: Pair, samples: int, frames: int) -> int:
    clean = torch.zeros(1, samples, pair.config.values)
    features = torch.zeros(1, samples, pair.config.width)
    times = map(torch.from_numpy, _times(samples, frames))
    return _counted(lambda: pair.recover(clean, features, *times))


@torch.no_grad()
def _counted(run: Callable[[], object]) -> int:
    """2 × multiply-accumulates of the products in `run`; all else counts as nothing."""
    with FlopCounterMode(display=False) as counter:
        run()
    return counter.get_total_flops()

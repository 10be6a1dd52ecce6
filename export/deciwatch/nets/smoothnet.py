"""A net after SmoothNet: every coordinate's track through the same fully-connected layers.

A. Zeng et al., "SmoothNet: A Plug-and-Play Network for Refining Human Poses in Videos", ECCV 2022,
https://arxiv.org/abs/2112.13715. Here a track is first freed of its mean, and the net corrects it.
"""

import numpy as np
import torch
from torch import Tensor, nn

from deciwatch.interpolate import interpolate

WINDOW = 32  # frames
STRIDE = 8  # frames from one window to the next
WIDTH, HIDDEN, BLOCKS = 256, 64, 3
DROPOUT = 0.1
BATCH = 64  # windows at once


class ResidualBlock(nn.Module):
    """Two layers over time with a leaky ReLU after each: [..., WIDTH] → [..., WIDTH]."""

    def __init__(self) -> None:
        super().__init__()
        self.layers = nn.Sequential(
            nn.Linear(WIDTH, HIDDEN),
            nn.Dropout(DROPOUT),
            nn.LeakyReLU(0.1),
            nn.Linear(HIDDEN, WIDTH),
            nn.Dropout(DROPOUT),
            nn.LeakyReLU(0.1),
        )

    def forward(self, tracks: Tensor) -> Tensor:
        return tracks + self.layers(tracks)


class SmoothNet(nn.Module):
    """Tracks [..., WINDOW] of one coordinate each → [..., WINDOW], smoother."""

    def __init__(self) -> None:
        super().__init__()
        self.encode = nn.Sequential(nn.Linear(WINDOW, WIDTH), nn.LeakyReLU(0.1))
        self.blocks = nn.Sequential(*(ResidualBlock() for _ in range(BLOCKS)))
        self.decode = nn.Linear(WIDTH, WINDOW)
        nn.init.zeros_(self.decode.weight)
        nn.init.zeros_(self.decode.bias)

    def forward(self, tracks: Tensor) -> Tensor:
        torch._assert(tracks.shape[-1] == WINDOW, "tracks must be [..., 32]")
        moving = tracks - tracks.mean(dim=-1, keepdim=True)
        return tracks + self.decode(self.blocks(self.encode(moving)))

    def flops(self, tracks: int) -> int:
        """2 × multiply-accumulates for this many tracks."""
        weights = sum(layer.weight.numel() for layer in self.modules() if hasattr(layer, "weight"))
        return 2 * weights * tracks


def window_starts(frames: int) -> list[int]:
    """First frames of windows that cover `frames` frames, the last moved back to fit."""
    last = max(0, frames - WINDOW)
    return [*range(0, last, STRIDE), last]


@torch.no_grad()
def smooth_values(net: SmoothNet, values: np.ndarray, frames: np.ndarray) -> np.ndarray:
    """Values [S, C] at frames [S], ascending, smoothed, [S, C].

    Missing frames between are filled by straight lines, and what is shorter than a window by
    holding its last value; overlapping windows are averaged.
    """
    length = max(frames[-1] - frames[0] + 1, WINDOW)
    dense = interpolate(frames, values, frames[0] + np.arange(length), "linear")
    starts = window_starts(length)
    index = np.asarray(starts)[:, None] + np.arange(WINDOW)
    tracks = torch.from_numpy(dense.astype(np.float32))[index].transpose(1, 2)
    smoothed = torch.cat([net(part) for part in tracks.split(BATCH)]).transpose(1, 2).numpy()
    sums, counts = np.zeros_like(dense), np.zeros((length, 1))
    for start, part in zip(starts, smoothed, strict=True):
        sums[start : start + WINDOW] += part
        counts[start : start + WINDOW] += 1
    return (sums / counts)[frames - frames[0]]

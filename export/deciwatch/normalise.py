"""Poses to and from the numbers that the nets work on; re-implemented in TypeScript.

3D: metres divided by a constant. 2D: pixels relative to the window's box, which is the mean of its
samples' boxes, so that the person's path through the picture is kept. Scores: as they are.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from deciwatch.errors import UserError

SCALE_3D = 0.5  # metres


def window_box(samples: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Box of a window's samples [..., S, K, 2] in pixels.

    centre [..., 2]: mean over the samples of the middle of each one's box (min to max over its
    landmarks). scale [...]: mean over the samples of the larger side of that box, at least 1 px.
    """
    low, high = samples.min(axis=-2), samples.max(axis=-2)
    centre = ((low + high) / 2).mean(axis=-2)
    scale = (high - low).max(axis=-1).mean(axis=-1)
    return centre, np.maximum(scale, 1.0)


def frame_of(samples: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Origin [..., 1, 1, D] and unit [..., 1, 1, 1] of the window with samples [..., S, K, D]."""
    if samples.shape[-1] == 3:
        shape = (*samples.shape[:-3], 1, 1)
        return np.zeros((*shape, 3), np.float32), np.full((*shape, 1), SCALE_3D, np.float32)
    centre, scale = window_box(samples)
    return centre[..., None, None, :], scale[..., None, None, None]


def to_net(poses: np.ndarray, origin: np.ndarray, unit: np.ndarray) -> np.ndarray:
    """Poses [..., T, K, D] → net values [..., T, K·D], float32."""
    values = (poses - origin) / unit
    return values.reshape(*poses.shape[:-2], -1).astype(np.float32)


def from_net(values: np.ndarray, origin: np.ndarray, unit: np.ndarray) -> np.ndarray:
    """Net values [..., T, K·D] → poses [..., T, K, D], the inverse of to_net."""
    dims = origin.shape[-1]
    return values.reshape(*values.shape[:-1], -1, dims) * unit + origin


@dataclass(frozen=True)
class Samples:
    """The S samples of a window, or of a batch of windows; None for what the estimator lacks.

    poses_3d [..., S, K, 3] metres, poses_2d [..., S, K, 2] pixels, scores [..., S, K] 0 to 1. All
    are finite: a sample in which nobody was seen is left out.
    """

    poses_3d: np.ndarray | None = None
    poses_2d: np.ndarray | None = None
    scores: np.ndarray | None = None

    def of(self, name: str) -> np.ndarray:
        """The array of one input, "3d", "2d" or "scores". Raises UserError where there is none."""
        values = {"3d": self.poses_3d, "2d": self.poses_2d, "scores": self.scores}[name]
        if values is None:
            lacking = "scores" if name == "scores" else f"{name.upper()} poses"
            raise UserError(
                f"These nets take {lacking} as an input, which the estimates lack; "
                f"give them too, or use nets that were trained without."
            )
        return values


def sampled_values(samples: Samples, inputs: Sequence[str]) -> np.ndarray:
    """DenoiseNet's `sampled` [..., S, I], float32: the blocks that `inputs` names, side by side.

    For one window or for a batch [B, S, ...], so that training, evaluation and export build it by
    this one function. Each block has its own frame; that of the first is the frame of the poses
    that the nets give back: `frame_of(samples.of(inputs[0]))`.
    """
    blocks = []
    for name in inputs:
        values = samples.of(name)
        scaled = values if name == "scores" else to_net(values, *frame_of(values))
        blocks.append(scaled.astype(np.float32))
    return np.concatenate(blocks, axis=-1)

"""Where in time the scored frames of a window lie, and which of its samples are left out."""

import numpy as np

PER_GAP = 3


def few_places(rng: np.random.Generator, places: np.ndarray, whole: bool) -> np.ndarray:
    """PER_GAP random places in each gap between samples at `places` [B, S] → [B, T], ascending.

    A net with tokens for the samples answers each frame by itself, and at a sample with the clean
    pose, so these teach it as much as all frames do. `whole`: whole numbers where the samples'
    are, never a sample's unless nothing lies between.
    """
    left, right = places[:, :-1, None], places[:, 1:, None]
    share = rng.random((*left.shape[:2], PER_GAP))
    share.sort(axis=-1)
    if whole:
        inside = np.maximum(right - left - 1, 0)
        at = left + np.minimum(1 + np.floor(share * inside), right - left)
    else:
        at = left + share * (right - left)
    return at.reshape(len(places), -1)


def even_places(places: np.ndarray, frames: int) -> np.ndarray:
    """`frames` even places from the first to the last of `places` [B, S] → [B, frames]."""
    share = np.linspace(0.0, 1.0, frames)
    return places[:, :1] + (places[:, -1:] - places[:, :1]) * share


def thin(rng: np.random.Generator, samples: np.ndarray) -> np.ndarray:
    """In three batches of ten, leave out inner columns of [B, S]: others in every row."""
    inner = samples.shape[1] - 2
    if inner < 1 or rng.random() >= 0.3:
        return samples
    kept = inner - rng.binomial(inner, rng.uniform(0.05, 0.3))
    order = np.argsort(rng.random((len(samples), inner)), axis=1)[:, :kept]
    middle = np.take_along_axis(samples, 1 + np.sort(order, axis=1), axis=1)
    return np.concatenate([samples[:, :1], middle, samples[:, -1:]], axis=1)

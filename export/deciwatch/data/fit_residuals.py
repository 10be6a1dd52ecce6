"""Fits the model of `data/residuals.py` to pairs: sums, quantiles and eigenvectors, no training."""

from dataclasses import replace

import numpy as np

from deciwatch.data.noise import BODY_HEIGHT
from deciwatch.data.residuals import (
    PARTS,
    POSES,
    SPANS,
    VALUES,
    ResidualNoise,
    box_unit,
    joint_values,
    score_sizes,
    truth_values,
)
from deciwatch.data.training_pairs import Pairs
from deciwatch.skeleton import MIRROR

RIDGE = 10.0
LASTING_RANK, OWN_RANK = 24, 48
QUANTILES = (np.arange(64) + 0.5) / 64
CORRELATED = 0.5  # seconds within which a clip's errors are not counted as independent
CALIBRATIONS, SEED = 4, 1
LAGS = 30  # frames over which the correlation in time is looked at
SWAPPED = 0.6  # exchanged labels must fit this much better
APART = 0.15  # metres from left to right at least, else an exchange is not seen


def fit(pairs: Pairs) -> ResidualNoise:
    """The model of the estimator that made these pairs; they must hold 3D, 2D and scores."""
    truth_3d, truth_2d = pairs.truth["3d"][pairs.seen], pairs.truth["2d"][pairs.seen]
    estimates = {name: values.copy() for name, values in pairs.estimates.items()}
    swaps = _undo_swaps(estimates, truth_3d, truth_2d)
    values = joint_values(estimates, truth_3d, truth_2d)
    given = truth_values(truth_3d)
    bias = np.linalg.solve(given.T @ given + RIDGE * np.eye(given.shape[1]), given.T @ values)
    error = values - given @ bias
    logits = values[:, SPANS["scores"]]
    mean = logits.mean(axis=0)
    slopes = _slopes(error, logits - mean)
    error /= score_sizes(logits, slopes, mean)
    clip = np.searchsorted(pairs.start, pairs.seen, side="right") - 1
    _, clip, counts = np.unique(clip, return_inverse=True, return_counts=True)
    seconds = pairs.seen / pairs.fps[np.searchsorted(pairs.start, pairs.seen, side="right") - 1]
    means = _sums(error, clip) / counts[:, None]
    own = error - means[clip]
    scale = own.std(axis=0) + 1e-6
    own /= scale
    sizes = np.sqrt((own[:, POSES] ** 2).mean(axis=1)) + 1e-6
    usual = np.array([np.median(sizes[clip == index]) for index in range(len(counts))])
    relative = sizes / usual[clip]
    shape = np.sqrt((sizes**2).mean() / ((usual[clip] ** 2).mean() * (relative**2).mean()))
    own /= sizes[:, None]
    share, constant = _persistence(own, clip, seconds)
    independent = np.maximum(1.0, _spans(clip, seconds) / CORRELATED)
    noise_of_means = ((scale**2)[None] / np.minimum(independent, counts)[:, None]).mean(axis=0)
    between = np.cov(means.T, ddof=0)
    between[np.diag_indices(VALUES)] -= np.minimum(noise_of_means, 0.9 * np.diag(between))
    lasting, lasting_rest = _factors(between, LASTING_RANK)
    factors, rest = _factors(own.T @ own / len(own), OWN_RANK)
    model = ResidualNoise(
        *(
            np.asarray(x, np.float32)
            for x in (bias, lasting, lasting_rest, factors, rest, scale, slopes, mean)
        ),
        clip_sizes=np.quantile(usual, QUANTILES).astype(np.float32),
        sample_sizes=(shape * np.quantile(relative, QUANTILES)).astype(np.float32),
        share=np.float32(share),
        seconds=np.float32(constant),
        swaps=swaps.astype(np.float32),
    )
    for _ in range(CALIBRATIONS):
        model = _calibrated(model, pairs)
    return model


def _calibrated(model: ResidualNoise, pairs: Pairs) -> ResidualNoise:
    """The model with errors of the pairs' mean length, joint by joint.

    It has their variance already; but the real ones' tails are heavier than any of its parts, and
    what is mean in them is smaller than its Gaussians make it.
    """
    truth = {name: pairs.truth[name][pairs.seen][:, None] for name in ("3d", "2d")}
    rng, alone = np.random.default_rng(SEED), np.zeros((len(pairs.seen), 1))
    made = model.draw(rng, truth["3d"], truth["2d"], alone, severity=(1.0, 1.0))
    factors = np.ones(VALUES, np.float32)
    for name, unit in (("3d", 1.0), ("2d", box_unit(truth["2d"][:, 0]))):
        real, ours = (
            np.linalg.norm((x - truth[name][:, 0]) / unit, axis=-1).mean(axis=0)
            for x in (pairs.estimates[name], made[name][:, 0])
        )
        factors[SPANS[name]] = np.repeat(np.clip(real / ours, 0.5, 1.2), truth[name].shape[-1])
    return replace(
        model,
        lasting=model.lasting * factors,
        lasting_rest=model.lasting_rest * factors,
        own_scale=model.own_scale * factors,
    )


def _undo_swaps(
    estimates: dict[str, np.ndarray], truth_3d: np.ndarray, truth_2d: np.ndarray
) -> np.ndarray:
    """Exchange left and right again where it was exchanged, in place; the shares of PARTS, [3]."""
    shares = []
    for part in PARTS:
        pairwise = np.linalg.norm(truth_3d[:, part] - truth_3d[:, MIRROR[part]], axis=-1)
        off = [
            _distance(estimates, truth_3d, truth_2d, part, labels)
            for labels in (part, MIRROR[part])
        ]
        chosen = np.flatnonzero((off[1] < SWAPPED * off[0]) & (pairwise.mean(axis=1) > APART))
        for values in estimates.values():
            values[chosen[:, None], part] = values[chosen[:, None], MIRROR[part]]
        shares.append(len(chosen) / len(truth_3d))
    return np.array(shares)


def _distance(estimates, truth_3d, truth_2d, part, labels) -> np.ndarray:
    """Mean error of a part whose landmarks are taken from `labels`: 3D and 2D over their sizes."""
    in_space = np.linalg.norm(estimates["3d"][:, labels] - truth_3d[:, part], axis=-1).mean(axis=1)
    in_plane = np.linalg.norm(estimates["2d"][:, labels] - truth_2d[:, part], axis=-1).mean(axis=1)
    return in_space / BODY_HEIGHT + in_plane / np.maximum(
        np.ptp(truth_2d, axis=1).max(axis=-1), 1.0
    )


def _slopes(error: np.ndarray, unsure: np.ndarray) -> np.ndarray:
    """Slopes [2, 33] of the log size of each joint's 3D and 2D error in its score's logit."""
    unsure = np.clip(unsure, -4.0, 4.0)
    found = []
    for name, dims in (("3d", 3), ("2d", 2)):
        off = error[:, SPANS[name]].reshape(len(error), -1, dims)
        size = np.log(np.linalg.norm(off, axis=-1) + 1e-3)
        centred = unsure - unsure.mean(axis=0)
        slope = (centred * size).sum(axis=0) / ((centred**2).sum(axis=0) + 1e-6)
        found.append(np.clip(slope, -0.6, 0.1))
    return np.array(found)


def _sums(values: np.ndarray, groups: np.ndarray) -> np.ndarray:
    total = np.zeros((groups.max() + 1, values.shape[1]))
    np.add.at(total, groups, values)
    return total


def _spans(clip: np.ndarray, seconds: np.ndarray) -> np.ndarray:
    """Seconds from each clip's first to its last estimate."""
    edges = np.flatnonzero(np.diff(clip)) + 1
    begin, end = np.concatenate([[0], edges]), np.concatenate([edges, [len(clip)]]) - 1
    return seconds[end] - seconds[begin]


def _persistence(own: np.ndarray, clip: np.ndarray, seconds: np.ndarray) -> tuple[float, float]:
    """The share a and time constant τ of the correlation a·exp(−Δ/τ) of errors Δ seconds apart."""
    apart, alike, weight = [], [], []
    for lag in range(1, LAGS + 1):
        same = clip[lag:] == clip[:-lag]
        if same.sum() < 50:
            continue
        between = (seconds[lag:] - seconds[:-lag])[same]
        products = (own[lag:] * own[:-lag])[same][:, POSES].mean(axis=1)
        for low in np.arange(0.0, 1.0, 1 / 30):
            inside = (between > low) & (between <= low + 1 / 30)
            if inside.sum() >= 50 and products[inside].mean() > 0.02:
                apart.append(between[inside].mean())
                alike.append(np.log(products[inside].mean()))
                weight.append(np.sqrt(inside.sum()))
    if len(set(apart)) < 2:
        return 0.0, 0.1
    slope, begin = np.polyfit(apart, alike, 1, w=weight)
    return float(np.clip(np.exp(begin), 0.0, 1.0)), float(np.clip(-1 / min(slope, -0.3), 0.02, 3.0))


def _factors(covariance: np.ndarray, rank: int) -> tuple[np.ndarray, np.ndarray]:
    """Factors [rank, 198] and remaining deviations [198] of about this covariance."""
    size, vectors = np.linalg.eigh(covariance)
    factors = (np.sqrt(np.maximum(size[-rank:], 0.0)) * vectors[:, -rank:]).T
    rest = np.diag(covariance) - (factors**2).sum(axis=0)
    return factors, np.sqrt(np.maximum(rest, 0.0))

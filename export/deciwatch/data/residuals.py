"""A model of a real estimator's errors, fitted to pairs: it makes estimates for any motion.

What is modelled, all of it jointly over 3D, 2D and scores:
- a bias that depends on the true pose in camera axes, hence on joint and view (linear);
- an error that stays through a clip (Gaussian, low rank);
- an error of its own at each sample, part of which lasts for a while, whose size follows the
  joint's score and a heavy-tailed factor of the sample;
- left and right exchanged, of the whole body, the arms or the legs.

Values are those of `joint_values`: 3D over 0.5 m, 2D over the truth's box, scores as logits.
"""

from dataclasses import dataclass

import numpy as np
from scipy.special import expit

from deciwatch.normalise import SCALE_3D
from deciwatch.skeleton import ARMS, KEYPOINTS, LEGS, MIRROR, mid_hip

SPANS = {"3d": slice(0, 99), "2d": slice(99, 165), "scores": slice(165, 198)}
VALUES = 198
SURE = 0.002  # scores are kept this far from 0 and 1, so that they have logits
SEVERITY = (0.3, 1.5)
BIAS_SHARE = (0.6, 1.4)
POSES = slice(0, 165)
PARTS = (np.arange(KEYPOINTS), ARMS, LEGS)


@dataclass(frozen=True)
class ResidualNoise:
    """The fitted model; `data/fit_residuals.py` makes it.

    bias: [100, 198] from the truth's 3D values and 1. lasting: [R, 198] factors of the clip's
    error, own_scale [198] and own: [P, 198] of a sample's error, standardised; lasting_rest,
    own_rest: [198] what is independent of all else. by_score: [2, 33] slope of log size of the 3D
    and the 2D error in the joint's logit, around score_mean [33]. clip_sizes, sample_sizes:
    quantiles of the size factors. share, seconds: part of the sample's error that lasts, and its
    time constant. swaps: [3] share of samples in which PARTS are exchanged.
    """

    bias: np.ndarray
    lasting: np.ndarray
    lasting_rest: np.ndarray
    own: np.ndarray
    own_rest: np.ndarray
    own_scale: np.ndarray
    by_score: np.ndarray
    score_mean: np.ndarray
    clip_sizes: np.ndarray
    sample_sizes: np.ndarray
    share: np.ndarray
    seconds: np.ndarray
    swaps: np.ndarray

    def draw(
        self,
        rng: np.random.Generator,
        truth_3d: np.ndarray,
        truth_2d: np.ndarray,
        times: np.ndarray,
        severity: tuple[float, float] = SEVERITY,
    ) -> dict[str, np.ndarray]:
        """Estimates "3d", "2d" and "scores" of true poses [B, S, 33, 3] and [B, S, 33, 2] px.

        times: [B, S] seconds. Every window has a severity of its own, log-uniform.
        """
        batch, _ = times.shape
        size = np.exp(rng.uniform(*np.log(severity), size=(batch, 1, 1))).astype(np.float32)
        values = truth_values(truth_3d) @ self.bias
        if severity[0] < severity[1]:
            values[..., POSES] *= rng.uniform(*BIAS_SHARE, (batch, 1, 1))
        values += size * coloured(rng, (batch, 1), self.lasting, self.lasting_rest)
        values += size * self._own(rng, values, times)
        estimates = from_joint_values(values, truth_3d, truth_2d)
        exchange(rng, estimates, self.swaps * size[..., 0])
        return estimates

    def _own(self, rng: np.random.Generator, centre: np.ndarray, times: np.ndarray) -> np.ndarray:
        """The samples' own errors, [B, S, 198]."""
        batch, samples = times.shape
        fresh = coloured(rng, (batch, samples), self.own, self.own_rest)
        lasting = coloured(rng, (batch, samples), self.own, self.own_rest)
        kept = np.exp(-np.diff(times, axis=1) / self.seconds)[..., None].astype(np.float32)
        for k in range(1, samples):
            before, new = lasting[:, k - 1], lasting[:, k]
            lasting[:, k] = kept[:, k - 1] * before + np.sqrt(1 - kept[:, k - 1] ** 2) * new
        error = np.sqrt(self.share) * lasting + np.sqrt(1 - self.share) * fresh
        error *= rng.choice(self.clip_sizes, size=(batch, 1, 1))
        error *= rng.choice(self.sample_sizes, size=(batch, samples, 1))
        error *= self.own_scale
        logits = (centre + error)[..., SPANS["scores"]]
        return error * score_sizes(logits, self.by_score, self.score_mean)


def coloured(
    rng: np.random.Generator, shape: tuple[int, ...], factors: np.ndarray, rest: np.ndarray
) -> np.ndarray:
    """Gaussian values [*shape, 198] of covariance factorsᵀ·factors + diag(rest²)."""
    shared = rng.standard_normal((*shape, len(factors)), dtype=np.float32) @ factors
    return shared + rest * rng.standard_normal(shared.shape, dtype=np.float32)


def exchange(rng: np.random.Generator, estimates: dict[str, np.ndarray], rates: np.ndarray) -> None:
    """Exchange left and right of each of PARTS, in place, in shares `rates` [B, 3] of samples."""
    for part, rate in zip(PARTS, rates.T, strict=True):
        chosen = np.nonzero(rng.random(estimates["scores"].shape[:2]) < rate[:, None])
        for values in estimates.values():
            values[chosen[0][:, None], chosen[1][:, None], part] = values[
                chosen[0][:, None], chosen[1][:, None], MIRROR[part]
            ]


def score_sizes(logits: np.ndarray, by_score: np.ndarray, mean: np.ndarray) -> np.ndarray:
    """Size factors [..., 198] of the errors of joints with these score logits [..., 33]."""
    unsure = np.clip(logits - mean, -4.0, 4.0)
    parts = [
        np.repeat(np.exp(np.clip(slope * unsure, -2.0, 2.0)), dims, axis=-1)
        for slope, dims in zip(by_score, (3, 2), strict=True)
    ]
    return np.concatenate([*parts, np.ones_like(logits)], axis=-1).astype(np.float32)


def truth_values(truth_3d: np.ndarray) -> np.ndarray:
    """[..., 33, 3] metres → what the bias depends on, [..., 100]: net values and 1."""
    flat = truth_3d.reshape(*truth_3d.shape[:-2], -1) / SCALE_3D
    return np.concatenate([flat, np.ones_like(flat[..., :1])], axis=-1).astype(np.float32)


def box_unit(truth_2d: np.ndarray) -> np.ndarray:
    """Larger side of each pose's box, at least 1 px: [..., 33, 2] → [..., 1, 1]."""
    return np.maximum(np.ptp(truth_2d, axis=-2).max(axis=-1), 1.0)[..., None, None]


def joint_values(
    estimates: dict[str, np.ndarray], truth_3d: np.ndarray, truth_2d: np.ndarray
) -> np.ndarray:
    """Errors of estimates [..., 33, D] and the logits of their scores, side by side: [..., 198]."""
    off = [
        (estimates["3d"] - truth_3d) / SCALE_3D,
        (estimates["2d"] - truth_2d) / box_unit(truth_2d),
    ]
    scores = np.clip(estimates["scores"], SURE, 1 - SURE)
    parts = [x.reshape(*x.shape[:-2], -1) for x in off]
    return np.concatenate([*parts, np.log(scores / (1 - scores))], axis=-1).astype(np.float32)


def from_joint_values(
    values: np.ndarray, truth_3d: np.ndarray, truth_2d: np.ndarray
) -> dict[str, np.ndarray]:
    """The estimates of joint values [..., 198]; 3D about their own mid-hip. Inverse of that."""
    poses_3d = truth_3d + SCALE_3D * values[..., SPANS["3d"]].reshape(truth_3d.shape)
    poses_2d = truth_2d + box_unit(truth_2d) * values[..., SPANS["2d"]].reshape(truth_2d.shape)
    scores = expit(values[..., SPANS["scores"]])
    found = {"3d": poses_3d - mid_hip(poses_3d), "2d": poses_2d, "scores": scores}
    return {name: each.astype(np.float32) for name, each in found.items()}

"""Where DenoiseNet's training begins: the best linear correction of a sample by itself.

An estimator's errors depend on the whole pose, its outline in the picture and the scores, and a
large part of that dependence is linear. Gradient descent finds it slowly, by when the rest of the
net has learned the training clips by heart; least squares gives it at once.
"""

from collections.abc import Callable

import numpy as np
import torch

from deciwatch.data.batch import Batch
from deciwatch.nets.pair import Pair

BATCHES, SEED = 300, 5
RIDGE = 1e-4  # of each input's weight, per sample


@torch.no_grad()
def start_linearly(pair: Pair, make_batch: Callable[..., Batch]) -> None:
    """Set W of DenoiseNet's direct matrix and its offset to the ridge regression of the truth."""
    rng = np.random.default_rng(SEED)
    values, channels = pair.config.values, pair.config.channels
    products = np.zeros((channels + 1, channels + 1))
    targets = np.zeros((channels + 1, values))
    count = 0
    for _ in range(BATCHES):
        batch = make_batch(rng, sparse=True)
        sampled = batch.sampled.reshape(-1, channels).astype(float)
        wrong = batch.clean.reshape(-1, values) - sampled[:, :values]
        given = np.concatenate([sampled, np.ones((len(sampled), 1))], axis=1)
        products += given.T @ given
        targets += given.T @ wrong
        count += len(given)
    weights = np.linalg.solve(products + RIDGE * count * np.eye(channels + 1), targets)
    pair.denoise.skip.weight.copy_(torch.from_numpy(weights[:-1].T.astype(np.float32)))
    pair.denoise.decode.bias.copy_(torch.from_numpy(weights[-1].astype(np.float32)))

"""Training a ForecastNet, which begins with its pair's DenoiseNet."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import torch
from torch import Tensor

from deciwatch import checkpoint
from deciwatch.data.batch import Batch
from deciwatch.data.hidden_future import FEWEST, Future, hide_future
from deciwatch.nets.forecast import ForecastConfig, ForecastNet
from deciwatch.nets.pair import Pair
from deciwatch.trainer import Recipe, Trainer

CUTS = 2  # places at which one batch is cut
CLEAN_WEIGHT = 0.1  # of the last sample itself beside what comes after it


class ForecastTrainer(Trainer):
    """A Trainer whose nets are one ForecastNet.

    `recipe.denoise_first` is here the share of the budget in which DenoiseNet stays as it is.
    """

    def __init__(
        self,
        config: ForecastConfig,
        recipe: Recipe,
        make_batch: Callable[..., Batch],
        pair: Pair,
    ) -> None:
        super().__init__(config, recipe, make_batch)
        for net in (self.pair, self.averaged):
            net.denoise.load_state_dict(pair.denoise.state_dict())

    def _build(self) -> ForecastNet:
        return ForecastNet(self.config)

    def start_from(self, path: Path) -> dict:
        """Begin with the weights of a checkpoint; returns what it says of its training."""
        _, content = checkpoint.load_forecast(path)
        for net in (self.pair, self.averaged):
            net.load_state_dict(content["weights"])
        return content["training"]

    def _draw(self) -> tuple[Tensor, int]:
        self.pair.denoise.requires_grad_(self.progress >= self.recipe.denoise_first)
        batch = self.make_batch(self.rng)
        while batch.sampled.shape[1] <= FEWEST:
            batch = self.make_batch(self.rng)
        places = np.arange(FEWEST, batch.sampled.shape[1])
        cuts = self.rng.choice(places, size=min(CUTS, len(places)), replace=False)
        inputs = self.config.pair.inputs
        parts = [self._loss(hide_future(batch, int(kept), inputs)) for kept in cuts]
        return torch.stack(parts).mean(), len(batch.sampled) * len(parts)

    def _loss(self, future: Future) -> Tensor:
        arrays = (future.clean, future.poses, future.weight)
        clean_truth, truth, weight = map(torch.from_numpy, arrays)
        clean, got = forecast(self.pair, future)
        ahead = ((got - truth).abs().mean(dim=-1) * weight).sum() / weight.sum()
        return ahead + CLEAN_WEIGHT * (clean[:, -1] - clean_truth).abs().mean()


def forecast(net: ForecastNet, future: Future) -> tuple[Tensor, Tensor]:
    """clean [B, S, K·D] and poses [B, T, K·D] in net values."""
    arrays = (future.sampled, future.sample_times, future.frame_times)
    return net(*map(torch.from_numpy, arrays))

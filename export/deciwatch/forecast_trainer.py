"""Training a ForecastNet on top of a pair whose DenoiseNet stays as it is."""

from collections.abc import Callable

import numpy as np
import torch
from torch import Tensor

from deciwatch.data.batch import Batch
from deciwatch.data.hidden_future import FEWEST, Future, hide_future
from deciwatch.nets.forecast import ForecastConfig, ForecastNet
from deciwatch.nets.pair import Pair
from deciwatch.trainer import Recipe, Trainer

CUTS = 2  # places at which one batch is cut


class ForecastTrainer(Trainer):
    """A Trainer whose nets are one ForecastNet; the pair's DenoiseNet is given and not trained."""

    def __init__(
        self,
        config: ForecastConfig,
        recipe: Recipe,
        make_batch: Callable[..., Batch],
        pair: Pair,
    ) -> None:
        super().__init__(config, recipe, make_batch)
        self.given = pair.eval().requires_grad_(False)

    def _build(self) -> ForecastNet:
        return ForecastNet(self.config)

    def _draw(self) -> tuple[Tensor, int]:
        batch = self.make_batch(self.rng)
        while batch.sampled.shape[1] <= FEWEST:
            batch = self.make_batch(self.rng)
        places = np.arange(FEWEST, batch.sampled.shape[1])
        cuts = self.rng.choice(places, size=min(CUTS, len(places)), replace=False)
        inputs = self.given.config.inputs
        parts = [self._loss(hide_future(batch, int(kept), inputs)) for kept in cuts]
        return torch.stack(parts).mean(), len(batch.sampled) * len(parts)

    def _loss(self, future: Future) -> Tensor:
        truth, weight = torch.from_numpy(future.poses), torch.from_numpy(future.weight)
        got = forecast(self.given, self.pair, future)
        return ((got - truth).abs().mean(dim=-1) * weight).sum() / weight.sum()


def forecast(pair: Pair, net: ForecastNet, future: Future) -> Tensor:
    """Poses [B, T, K·D] in net values."""
    arrays = (future.sampled, future.sample_times, future.frame_times)
    sampled, sample_times, frame_times = map(torch.from_numpy, arrays)
    with torch.no_grad():
        clean, features = pair.denoise(sampled, sample_times)
    return net(clean, features, sample_times, frame_times)

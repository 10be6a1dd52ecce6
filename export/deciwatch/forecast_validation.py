"""How far off forecasts are until the next sample comes, on windows that no training sees."""

from collections.abc import Callable, Iterator

import numpy as np
import torch

from deciwatch.data.hidden_future import FEWEST, Future, hide_future, reframed
from deciwatch.forecast_trainer import forecast
from deciwatch.nets.forecast import ForecastNet
from deciwatch.nets.pair import Pair
from deciwatch.validation import Validation

MM = 1000.0


class ForecastValidation:
    """The windows of a validation, cut before their last sample and in the middle."""

    def __init__(self, validation: Validation, pair: Pair) -> None:
        self.pair, self.unit = pair.eval(), validation.unit
        self.parts = list(_cut(validation, pair))
        values = pair.config.values
        self.baselines = {
            "hold": self._errors(lambda future: _hold(future.sampled[..., :values], future)),
            "linear": self._errors(lambda future: _linear(future.sampled[..., :values], future)),
            "hold_clean": self._errors(lambda future: _hold(_clean(pair, future), future)),
        }

    @torch.no_grad()
    def of(self, net: ForecastNet) -> dict[str, float]:
        """Errors of a net; leaves it in evaluation mode."""
        net.eval()
        return self._errors(lambda future: forecast(net, future)[1].numpy())

    def _errors(self, method: Callable[[Future], np.ndarray]) -> dict[str, float]:
        total = count = 0.0
        for future, unit in self.parts:
            off = (method(future) - future.poses) * unit[:, None, None]
            distance = np.linalg.norm(
                off.reshape(*off.shape[:2], -1, self.pair.config.dims), axis=-1
            )
            inside = future.weight == 1.0
            total += distance[inside].sum()
            count += inside.sum() * distance.shape[-1]
        return {"position": float(total / count)}


def _cut(validation: Validation, pair: Pair) -> Iterator[tuple[Future, np.ndarray]]:
    """Futures, and millimetres or pixels of one net value, [B]."""
    inputs = pair.config.inputs
    for batch in validation.batches:
        samples = batch.sampled.shape[1]
        for kept in sorted({samples - 1, samples // 2}):
            if kept < FEWEST:
                continue
            future = hide_future(batch, kept, inputs)
            # 2D is in the frame of the samples that are left.
            size = 1.0 if inputs[0] == "3d" else _resized(batch.sampled, kept, inputs)
            yield future, batch.unit * size * (MM if inputs[0] == "3d" else 1.0)


def _resized(sampled: np.ndarray, kept: int, inputs: tuple[str, ...]) -> np.ndarray:
    return reframed(sampled[:, :kept], inputs)[2]


@torch.no_grad()
def _clean(pair: Pair, future: Future) -> np.ndarray:
    arrays = map(torch.from_numpy, (future.sampled, future.sample_times))
    return pair.denoise(*arrays)[0].numpy()


def _hold(samples: np.ndarray, future: Future) -> np.ndarray:
    return np.repeat(samples[:, -1:], future.frame_times.shape[1], axis=1)


def _linear(samples: np.ndarray, future: Future) -> np.ndarray:
    times = future.sample_times
    rate = (samples[:, -1] - samples[:, -2]) / (times[:, -1] - times[:, -2])[:, None]
    ahead = (future.frame_times - times[:, -1:])[..., None]
    return samples[:, -1:] + ahead * rate[:, None]

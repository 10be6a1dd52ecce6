"""One training run as an object: it can stop after any step and go on exactly from there."""

import copy
import json
import math
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import torch
from torch import Tensor, nn

from deciwatch import checkpoint
from deciwatch.data.batch import Batch
from deciwatch.errors import UserError
from deciwatch.linear_start import start_linearly
from deciwatch.loss import LAMBDA, loss, relative_loss
from deciwatch.nets.pair import Pair, PairConfig
from deciwatch.nets.preliminary import preliminary_recovery

WARMUP = 0.03  # share of the budget
LAST_RATE = 0.01  # share of the highest learning rate that is left at the end


@dataclass(frozen=True)
class Recipe:
    """How to train. Exactly one of steps and minutes is the budget that the schedule runs over."""

    steps: int | None = None
    minutes: float | None = None
    rate: float = 1.5e-3
    decay: float = 0.01
    clip: float = 1.0
    lam: float = LAMBDA
    average: float = 0.998
    seed: int = 1
    # Share of the budget spent on DenoiseNet alone, at a tenth of the cost of a step.
    denoise_first: float = 0.12


class Trainer:
    """AdamW with warm-up and cosine decay, clipped gradients, and averaged weights (EMA).

    `make_batch(rng, sparse=...)` draws a batch; the generator's state is part of a checkpoint.
    """

    def __init__(
        self, config: PairConfig, recipe: Recipe, make_batch: Callable[..., Batch]
    ) -> None:
        torch.manual_seed(recipe.seed)
        self.rng = np.random.default_rng(recipe.seed)
        self.config, self.recipe, self.make_batch = config, recipe, make_batch
        self.pair = self._build()
        self.averaged = copy.deepcopy(self.pair).eval().requires_grad_(False)
        self.optimiser = torch.optim.AdamW(
            self.pair.parameters(), lr=recipe.rate, weight_decay=recipe.decay
        )
        self.done, self.windows, self.seconds = 0, 0, 0.0
        self.best: float | None = None  # lowest validation error yet

    def _build(self) -> nn.Module:
        """The nets to train."""
        return Pair(self.config)

    @property
    def progress(self) -> float:
        """Share of the budget that is used up; 1 or more when the run is over."""
        if self.recipe.steps is not None:
            return self.done / self.recipe.steps
        return self.seconds / 60 / self.recipe.minutes

    def counts(self) -> dict[str, float]:
        """Steps, windows and minutes of this run so far."""
        return {"steps": self.done, "windows": self.windows, "minutes": self.seconds / 60}

    def rate(self) -> float:
        """Learning rate now."""
        progress = min(self.progress, 1.0)
        warm = min(1.0, (progress + 1e-4) / WARMUP)
        cosine = 0.5 * (1 + math.cos(math.pi * progress))
        return self.recipe.rate * warm * (LAST_RATE + (1 - LAST_RATE) * cosine)

    def step(self) -> float:
        """One batch; returns its loss. Raises FloatingPointError if that is not finite."""
        begun = time.monotonic()
        self.pair.train()
        for group in self.optimiser.param_groups:
            group["lr"] = self.rate()
        value, windows = self._draw()
        if not torch.isfinite(value):
            raise FloatingPointError(f"the loss of step {self.done} is not finite")
        self.optimiser.zero_grad()
        value.backward()
        torch.nn.utils.clip_grad_norm_(self.pair.parameters(), self.recipe.clip)
        self.optimiser.step()
        self._average()
        self.done += 1
        self.windows += windows
        self.seconds += time.monotonic() - begun
        return value.item()

    def _draw(self) -> tuple[Tensor, int]:
        """The loss of a new batch, and of how many windows that is."""
        sparse = self.config.denoise and self.progress < self.recipe.denoise_first
        batch = self.make_batch(self.rng, sparse=sparse)
        sampled, clean, poses, sample_times, frame_times = map(
            torch.from_numpy,
            (batch.sampled, batch.clean, batch.poses, batch.sample_times, batch.frame_times),
        )
        if sparse:
            value = (self.pair.denoise(sampled, sample_times)[0] - clean).abs().mean()
        elif not self.config.denoise:
            got_poses = self.pair(sampled, sample_times, frame_times)[1]
            kind = self.config.preliminary
            start = preliminary_recovery(clean, sample_times, frame_times, kind)
            value = relative_loss(got_poses, poses, start)
        else:
            got_clean, got_poses = self.pair(sampled, sample_times, frame_times)
            value = loss(got_poses, poses, got_clean, clean, self.recipe.lam)
        return value, len(poses)

    @torch.no_grad()
    def _average(self) -> None:
        # A young run's average would otherwise be mostly its untrained beginning.
        keep = min(self.recipe.average, (1 + self.done) / (10 + self.done))
        averages, lives = list(self.averaged.parameters()), list(self.pair.parameters())
        torch._foreach_lerp_(averages, lives, 1 - keep)

    def share(self, path: Path, training: dict) -> None:
        """Write the averaged weights alone, as `export` wants them."""
        checkpoint.save(path, self.config, self.averaged.state_dict(), training)

    def save(self, path: Path, training: dict) -> None:
        """Write everything that `resume` needs; the shared weights are the averaged ones."""
        state = {
            "live": self.pair.state_dict(),
            "optimiser": self.optimiser.state_dict(),
            "numpy": json.dumps(self.rng.bit_generator.state),
            "torch": torch.get_rng_state(),
            "counts": [self.done, self.windows, self.seconds],
            "best": self.best,
        }
        checkpoint.save(path, self.config, self.averaged.state_dict(), training, state)

    def resume(self, path: Path) -> dict:
        """Go on from a checkpoint that `save` wrote; returns what it says of its training.

        Raises UserError if it is not one.
        """
        content = checkpoint.load(path, type(self.config))
        state = content.get("state")
        if state is None or content["config"] != self.config:
            raise UserError(
                f"{path} is not a running training of the same nets; resume from runs/NAME/last.pt."
            )
        self.pair.load_state_dict(state["live"])
        self.averaged.load_state_dict(content["weights"])
        self.optimiser.load_state_dict(state["optimiser"])
        self.rng.bit_generator.state = json.loads(state["numpy"])
        torch.set_rng_state(state["torch"])
        self.done, self.windows, self.seconds = state["counts"]
        self.best = state.get("best")
        return content["training"]

    def start_linearly(self) -> None:
        """Begin with the best linear correction of these batches (`linear_start.py`)."""
        start_linearly(self.pair, self.make_batch)
        self.averaged.load_state_dict(self.pair.state_dict())

    def recover_from(self, path: Path) -> None:
        """Begin with the RecoverNet of a checkpoint, whose DenoiseNet may be any.

        Raises UserError if this pair's is made otherwise.
        """
        earlier, _ = checkpoint.load_pair(path)
        try:
            for net in (self.pair, self.averaged):
                net.recover.load_state_dict(earlier.recover.state_dict())
        except RuntimeError:
            raise UserError(
                f"{path} holds a RecoverNet of another make; give its --dims, --recover, --width, "
                f"--blocks and --feed-forward."
            ) from None
        adapt = getattr(earlier.recover, "adapt", None)
        if adapt is not None:  # what it made of the other DenoiseNet's features means nothing here
            for net in (self.pair, self.averaged):
                for weight in net.recover.adapt.parameters():
                    weight.data.zero_()

    def start_from(self, path: Path) -> dict:
        """Begin anew with the weights of a checkpoint; returns what it says of its training.

        Raises UserError if its nets are made otherwise.
        """
        earlier, content = checkpoint.load_pair(path)
        same = replace(earlier.config, dropout=self.config.dropout)
        if replace(same, preliminary=self.config.preliminary) != self.config:
            raise UserError(
                f"{path} holds nets of another make; start with its --dims, --inputs, --recover, "
                f"--width, --blocks and --feed-forward."
            )
        for net in (self.pair, self.averaged):
            net.load_state_dict(content["weights"])
        return content["training"]

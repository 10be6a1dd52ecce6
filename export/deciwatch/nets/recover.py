"""RecoverNet: clean sampled poses to a pose for every frame (the paper's equations 3 and 4)."""

import torch
from torch import Tensor, nn

from deciwatch.nets.blocks import DROPOUT, DecoderBlock, positions
from deciwatch.nets.preliminary import preliminary_recovery

KERNEL = 5  # frames that one pose token sees, the paper's temporal semantic pose encoder


class RecoverNet(nn.Module):
    """Transformer decoder over the T frames of a window.

    `values` is K·D, `width` C, `blocks` M. W_RD starts at zero, so an untrained net gives the
    preliminary recovery.
    """

    def __init__(
        self,
        values: int,
        width: int,
        blocks: int,
        dropout: float = DROPOUT,
        preliminary: str = "cubic",
        feed_forward: int | None = None,
    ) -> None:
        super().__init__()
        self.values, self.width, self.preliminary = values, width, preliminary
        self.encode = nn.Conv1d(values, width, KERNEL, padding=KERNEL // 2)
        self.dropout = nn.Dropout(dropout)
        self.blocks = nn.ModuleList(
            DecoderBlock(width, dropout, feed_forward) for _ in range(blocks)
        )
        self.norm = nn.LayerNorm(width)
        self.decode = nn.Linear(width, values)  # W_RD
        nn.init.zeros_(self.decode.weight)
        nn.init.zeros_(self.decode.bias)

    def forward(
        self, clean: Tensor, features: Tensor, sample_times: Tensor, frame_times: Tensor
    ) -> Tensor:
        """clean [B, S, K·D], features [B, S, C], sample_times [B, S], frame_times [B, T].

        Returns poses [B, T, K·D] in net values. Times are in time units; only differences matter.
        """
        torch._assert(clean.shape[-1] == self.values, "clean must be [B, S, K·D]")
        torch._assert(features.shape[-1] == self.width, "features must be [B, S, C]")
        origin = sample_times[:, :1]
        sample_times, frame_times = sample_times - origin, frame_times - origin
        start = preliminary_recovery(clean, sample_times, frame_times, self.preliminary)
        tokens = self.encode(start.transpose(1, 2)).transpose(1, 2)
        tokens = self.dropout(tokens + positions(frame_times, self.width))
        # The memory says when each sample was taken, as the queries say when each frame was.
        memory = features + positions(sample_times, self.width)
        for block in self.blocks:
            tokens = block(tokens, memory)
        return start + self.decode(self.norm(tokens))

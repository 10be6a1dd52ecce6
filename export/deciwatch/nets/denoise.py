"""DenoiseNet: the noisy sampled poses of a window to clean ones (the paper's equations 1 and 2)."""

import torch
from torch import Tensor, nn

from deciwatch.nets.blocks import DROPOUT, EncoderBlock, positions


class DenoiseNet(nn.Module):
    """Transformer encoder over the S sampled tokens alone.

    `values` is K·D, `width` C, `blocks` M. `channels` I ≥ K·D is the width of its input, of which
    the first K·D are the poses to be cleaned and the rest says more of them. W_DD starts at zero:
    an untrained net is the identity. With `corrects` false it stays so, for poses that are clean
    already (hand-made labels), and its features are no more than embedded samples.
    """

    def __init__(
        self,
        values: int,
        width: int,
        blocks: int,
        dropout: float = DROPOUT,
        channels: int | None = None,
        feed_forward: int | None = None,
        corrects: bool = True,
    ) -> None:
        super().__init__()
        self.values, self.width, self.channels = values, width, channels or values
        self.embed = nn.Linear(self.channels, width)  # W_DE
        self.dropout = nn.Dropout(dropout)
        self.blocks = nn.ModuleList(
            EncoderBlock(width, dropout, feed_forward) for _ in range(blocks if corrects else 0)
        )
        self.norm = nn.LayerNorm(width)
        self.corrects = corrects
        if not corrects:
            return
        self.decode = nn.Linear(width, values)  # W_DD
        # C features cannot say how each of K·D > C values is off; this one matrix can. Without it
        # a pair's denoising stopped at 51.8 mm of 54.1, with it the same training gave 46.5.
        self.skip = nn.Linear(self.channels, values, bias=False)
        for weight in (self.decode.weight, self.decode.bias, self.skip.weight):
            nn.init.zeros_(weight)

    def forward(self, sampled: Tensor, sample_times: Tensor) -> tuple[Tensor, Tensor]:
        """sampled [B, S, I] net values, sample_times [B, S] time units, ascending.

        Returns clean [B, S, K·D] and features [B, S, C]. Only differences of times matter.
        """
        torch._assert(sampled.shape[-1] == self.channels, "sampled must be [B, S, I]")
        torch._assert(sample_times.ndim == 2, "sample_times must be [B, S]")
        tokens = self.embed(sampled) + positions(sample_times - sample_times[:, :1], self.width)
        tokens = self.dropout(tokens)
        for block in self.blocks:
            tokens = block(tokens)
        features = self.norm(tokens)
        poses = sampled[..., : self.values]
        if not self.corrects:
            return poses, features
        return poses + self.skip(sampled) + self.decode(features), features

"""The authors' DenoiseNet on the S samples alone (the paper's equations 1 and 2)."""

import torch
from torch import Tensor, nn

from deciwatch.official.blocks import EncoderBlock, Stack, not_itself, positions
from deciwatch.official.config import OfficialConfig


class OfficialDenoiseNet(nn.Module):
    """Transformer encoder in which a sample attends to all samples but itself."""

    def __init__(self, config: OfficialConfig) -> None:
        super().__init__()
        self.values, self.width, self.last = config.input_dim, config.hidden, config.last_frame
        sizes = (config.hidden, config.heads, config.feed_forward, config.pre_norm)
        self.encoder_embed = nn.Linear(self.values, self.width)
        self.encoder = Stack(
            [EncoderBlock(*sizes) for _ in range(config.encoder_layers)],
            nn.LayerNorm(self.width) if config.pre_norm else nn.Identity(),
        )
        self.encoder_joints_embed = nn.Linear(self.width, self.values)

    def forward(self, sampled: Tensor, sample_times: Tensor) -> tuple[Tensor, Tensor]:
        """sampled [B, S, K·D] net values, sample_times [B, S] in frames, ascending.

        Returns clean [B, S, K·D] and features [B, S, C]. Only differences of times matter.
        """
        torch._assert(sampled.shape[-1] == self.values, "sampled must be [B, S, K·D]")
        torch._assert(sample_times.ndim == 2, "sample_times must be [B, S]")
        places = positions(sample_times - sample_times[:, :1], self.width, self.last)
        features = self.encoder(self.encoder_embed(sampled), places, not_itself(sample_times))
        return sampled + self.encoder_joints_embed(features), features

"""The authors' RecoverNet (the paper's equations 3 and 4, with W_PR linear)."""

import torch
from torch import Tensor, nn

from deciwatch.nets.preliminary import preliminary_recovery
from deciwatch.official.blocks import DecoderBlock, Stack, positions
from deciwatch.official.config import OfficialConfig

KERNEL = 5  # frames that one pose token sees


class OfficialRecoverNet(nn.Module):
    """Transformer decoder over the T frames, whose memory is the features of the S samples."""

    def __init__(self, config: OfficialConfig) -> None:
        super().__init__()
        self.values, self.width, self.last = config.input_dim, config.hidden, config.last_frame
        sizes = (config.hidden, config.heads, config.feed_forward, config.pre_norm)
        self.decoder_embed = nn.Conv1d(self.values, self.width, KERNEL, padding=KERNEL // 2)
        self.decoder = Stack(
            [DecoderBlock(*sizes) for _ in range(config.decoder_layers)],
            nn.LayerNorm(self.width),
        )
        self.decoder_joints_embed = nn.Linear(self.width, self.values)

    def forward(
        self, clean: Tensor, features: Tensor, sample_times: Tensor, frame_times: Tensor
    ) -> Tensor:
        """clean [B, S, K·D], features [B, S, C], sample_times [B, S], frame_times [B, T].

        Returns poses [B, T, K·D] in net values. Times are in frames; only differences matter.
        """
        torch._assert(clean.shape[-1] == self.values, "clean must be [B, S, K·D]")
        torch._assert(features.shape[-1] == self.width, "features must be [B, S, C]")
        origin = sample_times[:, :1]
        sample_times, frame_times = sample_times - origin, frame_times - origin
        start = preliminary_recovery(clean, sample_times, frame_times, "linear")
        tokens = self.decoder_embed(start.transpose(1, 2)).transpose(1, 2)
        places, memory_places = (
            positions(times, self.width, self.last) for times in (frame_times, sample_times)
        )
        return start + self.decoder_joints_embed(
            self.decoder(tokens, places, features, memory_places)
        )

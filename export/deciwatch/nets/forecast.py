"""ForecastNet: poses after the last sample, which live playback shows without waiting for the next.

Not the paper's, which always has the sample on either side of a frame. It has a DenoiseNet of its
own, which begins as its pair's and learns to do without what comes after the last sample.
"""

from dataclasses import asdict, dataclass

import torch
from torch import Tensor, nn

from deciwatch.nets.blocks import DROPOUT, EncoderBlock, positions
from deciwatch.nets.bones import bone_lengths, with_bone_lengths
from deciwatch.nets.denoise import DenoiseNet
from deciwatch.nets.facing import facing, turn
from deciwatch.nets.pair import PairConfig
from deciwatch.nets.recover_samples import POSITION_SIZE, USUAL_GAP, moved

# Share of the correction that the last sample itself gets, which DenoiseNet cleaned with samples on
# either side in mind, and time units after it in which the rest grows to two thirds of its size.
AT_ONCE = 0.2
GROWTH = 4.0
# Beyond this many time units the pose stays what it is by then: nobody foresees a whole second.
FURTHEST = 30.0
POWERS = 4
WAVES = 3


@dataclass(frozen=True)
class ForecastConfig:
    """What it takes to build it again: its pair's configuration, own width, blocks, dropout."""

    pair: PairConfig
    width: int = 96
    blocks: int = 2
    feed_forward: int = 192
    dropout: float = DROPOUT

    def __post_init__(self) -> None:
        if isinstance(self.pair, dict):  # as a checkpoint has it
            object.__setattr__(self, "pair", PairConfig(**self.pair))

    @property
    def dims(self) -> int:
        """D."""
        return self.pair.dims

    @property
    def values(self) -> int:
        """K·D."""
        return self.pair.values

    def as_dict(self) -> dict:
        """Plain values, for a checkpoint."""
        return asdict(self)


class ForecastNet(nn.Module):
    """Transformer encoder over the S samples, and a two-layer head for T frames after the last.

    The head's last layer starts at zero: an untrained net holds the last clean pose. In 3D the
    window is turned until the body faces one way in its last sample, and bones keep the lengths
    that they have there.
    """

    def __init__(self, config: ForecastConfig) -> None:
        super().__init__()
        self.config = config
        values, width, pair = config.values, config.width, config.pair
        self.solid = config.dims == 3
        self.denoise = DenoiseNet(
            values,
            pair.width,
            pair.blocks,
            config.dropout,
            pair.channels,
            pair.feed_forward or None,
            pair.denoise,
        )
        # Pose, the step from the sample before, and whether and how long ago that was.
        self.embed = nn.Linear(2 * values + 2, width)
        nn.init.normal_(self.embed.weight, std=0.1)
        self.adapt = nn.Linear(pair.width, width)
        nn.init.zeros_(self.adapt.weight)
        nn.init.zeros_(self.adapt.bias)
        self.dropout = nn.Dropout(config.dropout)
        self.blocks = nn.ModuleList(
            EncoderBlock(width, config.dropout, config.feed_forward) for _ in range(config.blocks)
        )
        self.norm = nn.LayerNorm(width)
        hidden = 2 * width
        self.from_token = nn.Linear(width, hidden)
        self.from_time = nn.Linear(POWERS + 2 * WAVES, hidden, bias=False)
        self.decode = nn.Linear(hidden, values)
        nn.init.zeros_(self.decode.weight)
        nn.init.zeros_(self.decode.bias)

    def forward(
        self, sampled: Tensor, sample_times: Tensor, frame_times: Tensor
    ) -> tuple[Tensor, Tensor]:
        """sampled [B, S, I], sample_times [B, S], frame_times [B, T].

        Returns clean [B, S, K·D], and poses [B, T, K·D] at times from the last sample's on, in net
        values. Times are in time units; only differences matter.
        """
        clean, features = self.denoise(sampled, sample_times)
        last = clean[:, -1:]
        direction = facing(last) if self.solid else None
        token = self._token(clean, features, sample_times, direction)
        ahead = (frame_times - sample_times[:, -1:]).unsqueeze(-1)
        ahead = torch.clamp(ahead, 0.0, FURTHEST)
        hidden = self.from_token(token) + self.from_time(moments(ahead))
        correction = self.decode(self.dropout(nn.functional.gelu(hidden)))
        if direction is not None:
            correction = turn(correction, direction, back=True)
        size = 1 - (1 - AT_ONCE) * torch.exp(-ahead / GROWTH)
        poses = last + size * correction
        return clean, with_bone_lengths(poses, bone_lengths(last)) if self.solid else poses

    def _token(
        self, clean: Tensor, features: Tensor, sample_times: Tensor, direction: Tensor | None
    ) -> Tensor:
        """[B, 1, C']: of the last sample, which has seen all others."""
        times = sample_times - sample_times[:, -1:]
        steps = times[:, 1:] - times[:, :-1]
        none = torch.zeros_like(times[:, :1])
        gaps = torch.cat([none + 1, steps], dim=1).unsqueeze(-1)
        present = torch.cat([none, torch.ones_like(steps)], dim=1).unsqueeze(-1)
        rates = (clean - moved(clean, -1)) * (USUAL_GAP / gaps)
        seen = [clean, rates]
        if direction is not None:
            seen = [turn(part, direction) for part in seen]
        about = [present, present * torch.log(gaps / USUAL_GAP)]
        tokens = self.embed(torch.cat([*seen, *about], dim=-1)) + self.adapt(features)
        place = positions(-times, self.config.width)
        tokens = self.dropout(tokens + POSITION_SIZE * place)
        for block in self.blocks:
            tokens = block(tokens)
        return self.norm(tokens[:, -1:])


def moments(ahead: Tensor) -> Tensor:
    """What the head is told of a time ahead, [B, T, 1] → [B, T, POWERS + 2·WAVES]."""
    share = ahead / USUAL_GAP
    root = torch.sqrt(share + 1e-6)
    waves = torch.arange(1, WAVES + 1, dtype=ahead.dtype, device=ahead.device)
    angles = share * waves * (torch.pi / 3)
    return torch.cat(
        [root, share, share * root, share * share / 3, torch.sin(angles), torch.cos(angles)],
        dim=-1,
    )

"""A RecoverNet that spends its tokens on the samples: the frames between two are painted by phase.

Not the paper's: its RecoverNet (nets/recover.py) has a token for every frame. Here there is one for
every gap between two samples, which sees the three samples on either side; each frame is answered
from its gap's token and its phase, so it costs a tenth and any time stamp can be asked for.
"""

import math

import torch
from torch import Tensor, nn

from deciwatch.nets.blocks import DROPOUT, EncoderBlock, positions
from deciwatch.nets.bones import bone_lengths, with_bone_lengths
from deciwatch.nets.facing import facing, turn
from deciwatch.nets.preliminary import preliminary_recovery

USUAL_GAP = 10.0  # time units between two samples at the paper's N = 10
SHORTEST = 2.0  # time units; in shorter gaps nothing is corrected, from twice that all of it
LONGEST = 2.0  # usual gaps; in longer ones the correction grows no further by itself
WAVES = 4
REACH = (-2, -1, 0, 1, 2)  # the gaps around its own that a token sees
# Positions as large as in the other nets would drown what tells one gap's motion from another's.
POSITION_SIZE = 0.1


class SampleRecoverNet(nn.Module):
    """Transformer encoder over the gaps between the S samples, and a two-layer head for T frames.

    `values` is K·D, `width` C, `blocks` M. The head's last layer starts at zero, so an untrained
    net gives the preliminary recovery. At the samples it always gives the clean poses themselves.
    In 3D (`solid`) every gap is turned until the body faces one way, so that what is learnt holds
    for every view, and bones keep their lengths.
    """

    def __init__(
        self,
        values: int,
        width: int,
        blocks: int,
        dropout: float = DROPOUT,
        preliminary: str = "cubic",
        feed_forward: int | None = None,
        solid: bool = True,
    ) -> None:
        super().__init__()
        self.values, self.width, self.preliminary = values, width, preliminary
        self.solid = solid
        hidden = 2 * width
        self.embed = nn.Linear(values * (1 + len(REACH)) + 2 * len(REACH), width)
        # A body's steps are small beside its pose; the token is to begin with both, and
        # DenoiseNet's features, which are longer than either, come in by degrees.
        nn.init.normal_(self.embed.weight, std=0.1)
        self.adapt = nn.Linear(2 * width, width)
        nn.init.zeros_(self.adapt.weight)
        nn.init.zeros_(self.adapt.bias)
        self.dropout = nn.Dropout(dropout)
        self.blocks = nn.ModuleList(
            EncoderBlock(width, dropout, feed_forward) for _ in range(blocks)
        )
        self.norm = nn.LayerNorm(width)
        self.from_token = nn.Linear(width, hidden)
        self.from_phase = nn.Linear(2 * WAVES + 1, hidden, bias=False)
        self.decode = nn.Linear(hidden, values)
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
        middle = (clean + moved(clean, 1)) / 2
        direction = facing(middle) if self.solid else None
        tokens = self._tokens(clean, middle, features, sample_times, direction)
        left, right, u, gap = neighbours(sample_times, frame_times)
        hidden = left @ self.from_token(tokens) + self.from_phase(phases(u))
        correction = self.decode(self.dropout(nn.functional.gelu(hidden)))
        if direction is not None:
            correction = turn(correction, left @ direction, back=True)
        poses = start + fading(u, gap) * correction
        if not self.solid:
            return poses
        lengths = bone_lengths(clean)
        before = left @ lengths
        return with_bone_lengths(poses, before + u * (right @ lengths - before))

    def _tokens(
        self,
        clean: Tensor,
        middle: Tensor,
        features: Tensor,
        sample_times: Tensor,
        direction: Tensor | None,
    ) -> Tensor:
        """[B, S, C]: of the gap after each sample; the last sample's is of no use to anybody."""
        gaps, inside = gaps_after(sample_times)
        rates = (moved(clean, 1) - clean) * (USUAL_GAP / gaps)
        seen, about = [middle], []
        for offset in REACH:
            present = moved(inside, offset, hold=False)
            seen.append(moved(rates, offset, hold=False))
            about += [present, present * torch.log(moved(gaps, offset) / USUAL_GAP)]
        if direction is not None:
            seen = [turn(part, direction) for part in seen]
        pair = torch.cat([features, moved(features, 1)], dim=-1)
        tokens = self.embed(torch.cat([*seen, *about], dim=-1)) + self.adapt(pair)
        tokens = self.dropout(tokens + POSITION_SIZE * positions(sample_times, self.width))
        for block in self.blocks:
            tokens = block(tokens)
        return self.norm(tokens)


def moved(values: Tensor, offset: int, hold: bool = True) -> Tensor:
    """[B, S, V] where each sample has the values of the one `offset` further on.

    Beyond the ends the last ones are held, or zeros are put in.
    """
    for _ in range(abs(offset)):
        first, last = values[:, :1], values[:, -1:]
        if not hold:
            first, last = torch.zeros_like(first), torch.zeros_like(last)
        parts = [values[:, 1:], last] if offset > 0 else [first, values[:, :-1]]
        values = torch.cat(parts, dim=1)
    return values


def gaps_after(sample_times: Tensor) -> tuple[Tensor, Tensor]:
    """Time from each sample to the next and whether there is one (1 or 0), [B, S, 1] each.

    The last sample's is given as one time unit, so that it can be divided by.
    """
    steps = sample_times[:, 1:] - sample_times[:, :-1]
    one = torch.ones_like(sample_times[:, :1])
    gaps = torch.cat([steps, one], dim=1).unsqueeze(-1)
    inside = torch.cat([torch.ones_like(steps), torch.zeros_like(one)], dim=1).unsqueeze(-1)
    return gaps, inside


def neighbours(sample_times: Tensor, frame_times: Tensor) -> tuple[Tensor, Tensor, Tensor, Tensor]:
    """Which samples lie around each frame: sample_times [B, S] ascending, frame_times [B, T].

    Returns left and right [B, T, S], rows of a single 1 (right: of none at and beyond the last
    sample), u [B, T, 1] the phase from 0 at the left to 1 at the right sample, and gap [B, T, 1]
    in time units. Comparisons and products only, which every runtime has for any S and T.
    """
    first, last = sample_times[:, :1], sample_times[:, -1:]
    times = torch.minimum(torch.maximum(frame_times, first), last).unsqueeze(-1)
    begun = (times >= sample_times.unsqueeze(1)).to(times.dtype)
    none = torch.zeros_like(begun[..., :1])
    left = begun - torch.cat([begun[..., 1:], none], dim=-1)
    right = torch.cat([none, left[..., :-1]], dim=-1)
    gap = left @ gaps_after(sample_times)[0]
    return left, right, (times - left @ sample_times.unsqueeze(-1)) / gap, gap


def phases(u: Tensor) -> Tensor:
    """What the head is told of the phase, [B, T, 1] → [B, T, 2·WAVES + 1]."""
    waves = math.pi * torch.arange(1, WAVES + 1, dtype=u.dtype, device=u.device)
    return torch.cat([torch.sin(u * waves), torch.cos(u * waves), u], dim=-1)


def fading(u: Tensor, gap: Tensor) -> Tensor:
    """Size that a correction may have, [B, T, 1]: none at the samples, little in short gaps."""
    relative = torch.clamp(gap / USUAL_GAP, max=LONGEST)
    # What there is to correct falls faster than the gap: at N = 2 it is a tenth of that at N = 10,
    # and by then what nets learn of it is the recording's noise: made to correct that, a pair was
    # 0.4 % further off.
    learnable = torch.clamp((gap - SHORTEST) / SHORTEST, 0.0, 1.0)
    size = relative * torch.sqrt(torch.clamp(relative, max=1.0)) * learnable
    # Flat at the samples, so that one gap goes over into the next without a kink.
    bump = 4 * u * (1 - u)
    return bump * bump * size

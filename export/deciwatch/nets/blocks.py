"""Transformer blocks, positions, and their parts; all batch first.

Attention is written out as two matrix products and a softmax, so that the exported graph holds
nothing but plain operators and its FLOPs can be counted from it.
"""

import math

import torch
from torch import Tensor, nn

HEADS = 4
HEAD_DEPTH = 32
MOST_FEED_FORWARD = 512
DROPOUT = 0.1
LONGEST_PERIOD = 1000.0


def head_count(width: int) -> int:
    """Attention heads: four, and more of HEAD_DEPTH where C is larger than they fill."""
    return max(HEADS, width // HEAD_DEPTH if width % HEAD_DEPTH == 0 else 0)


def feed_forward_width(width: int) -> int:
    """Hidden width of a feed-forward layer unless the configuration names one: 4 C, at most 512."""
    return min(4 * width, MOST_FEED_FORWARD)


def positions(times: Tensor, width: int) -> Tensor:
    """Sinusoids of continuous time: [B, L] in time units → [B, L, width].

    E_pos of the paper's equations 1 and 4, of the time rather than of the index, so that one net
    serves every interval and frame rate and samples may be missing.
    """
    count = width // 2
    step = math.log(LONGEST_PERIOD) / (count - 1)
    rates = torch.exp(torch.arange(count, dtype=times.dtype, device=times.device) * -step)
    angles = times.unsqueeze(-1) * rates
    return torch.cat([torch.sin(angles), torch.cos(angles)], dim=-1)


class Attention(nn.Module):
    """Multi-head attention: queries [B, L, C], memory [B, R, C] → [B, L, C]."""

    def __init__(self, width: int, dropout: float) -> None:
        super().__init__()
        self.heads = head_count(width)
        if width % self.heads:
            raise ValueError(f"width {width} is not a multiple of {self.heads} heads")
        self.depth = width // self.heads
        self.query = nn.Linear(width, width)
        self.key = nn.Linear(width, width)
        self.value = nn.Linear(width, width)
        self.out = nn.Linear(width, width)
        self.dropout = nn.Dropout(dropout)

    def _split(self, values: Tensor) -> Tensor:
        return values.unflatten(-1, (self.heads, self.depth)).transpose(1, 2)

    def forward(self, queries: Tensor, memory: Tensor) -> Tensor:
        query = self._split(self.query(queries)) * self.depth**-0.5
        key, value = self._split(self.key(memory)), self._split(self.value(memory))
        weights = torch.softmax(query @ key.transpose(-1, -2), dim=-1)
        mixed = (self.dropout(weights) @ value).transpose(1, 2).flatten(2)
        return self.out(mixed)


class FeedForward(nn.Sequential):
    """Two linear layers with a leaky ReLU between: [..., C] → [..., C]."""

    def __init__(self, width: int, dropout: float, hidden: int | None = None) -> None:
        hidden = hidden or feed_forward_width(width)
        super().__init__(
            nn.Linear(width, hidden),
            nn.LeakyReLU(0.1),
            nn.Dropout(dropout),
            nn.Linear(hidden, width),
        )


class EncoderBlock(nn.Module):
    """Pre-norm self-attention and feed-forward: [B, S, C] → [B, S, C]."""

    def __init__(self, width: int, dropout: float, feed_forward: int | None = None) -> None:
        super().__init__()
        self.norm_attention, self.norm_forward = nn.LayerNorm(width), nn.LayerNorm(width)
        self.attention = Attention(width, dropout)
        self.forward_layers = FeedForward(width, dropout, feed_forward)
        self.dropout = nn.Dropout(dropout)

    def forward(self, tokens: Tensor) -> Tensor:
        normal = self.norm_attention(tokens)
        tokens = tokens + self.dropout(self.attention(normal, normal))
        return tokens + self.dropout(self.forward_layers(self.norm_forward(tokens)))


class DecoderBlock(nn.Module):
    """Pre-norm self-attention over [B, T, C], cross-attention to [B, S, C], feed-forward."""

    def __init__(self, width: int, dropout: float, feed_forward: int | None = None) -> None:
        super().__init__()
        self.norm_attention, self.norm_cross = nn.LayerNorm(width), nn.LayerNorm(width)
        self.norm_forward = nn.LayerNorm(width)
        self.attention, self.cross = Attention(width, dropout), Attention(width, dropout)
        self.forward_layers = FeedForward(width, dropout, feed_forward)
        self.dropout = nn.Dropout(dropout)

    def forward(self, tokens: Tensor, memory: Tensor) -> Tensor:
        normal = self.norm_attention(tokens)
        tokens = tokens + self.dropout(self.attention(normal, normal))
        tokens = tokens + self.dropout(self.cross(self.norm_cross(tokens), memory))
        return tokens + self.dropout(self.forward_layers(self.norm_forward(tokens)))

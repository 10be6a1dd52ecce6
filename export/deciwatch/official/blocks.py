"""Transformer blocks as the authors' nets have them, batch first.

They differ from deciwatch.nets.blocks: positions are added to queries and keys of every attention
and never to values (as in DETR), the norms may come after, and heads and widths are free. Linear
layers and norms are named as in the authors' files. Attention is plain products, so that the
exported graph is countable.
"""

import math
from collections.abc import Callable

import torch
from torch import Tensor, nn
from torch.nn import functional

TEMPERATURE = 10000.0
SLOPE = 0.01  # of the leaky ReLU
# In place of -inf: its softmax weight is exactly 0, yet a sample that is alone still sees itself.
EXCLUDED = -1e9


def positions(times: Tensor, width: int, last: int) -> Tensor:
    """Sinusoids of the frame's index, [B, L] in frames from the window's first → [B, L, width].

    The window that was trained on, frames 0 to `last`, makes one turn of the slowest wave.
    """
    count = width // 2
    exponents = torch.arange(count, dtype=times.dtype, device=times.device) * (-2.0 / count)
    angles = (times * (2 * math.pi / (last + 1e-6))).unsqueeze(-1) * TEMPERATURE**exponents
    return torch.stack([torch.sin(angles), torch.cos(angles)], dim=-1).flatten(-2)


def not_itself(times: Tensor) -> Tensor:
    """Attention bias [B, 1, S, S] for times [B, S]: a sample does not attend to itself."""
    index = torch.cumsum(torch.ones_like(times), dim=1)
    return ((index.unsqueeze(1) == index.unsqueeze(2)).to(times.dtype) * EXCLUDED).unsqueeze(1)


class Attention(nn.Module):
    """Queries [B, L, C], keys and values [B, R, C], bias [B, 1, L, R] or none → [B, L, C]."""

    def __init__(self, width: int, heads: int) -> None:
        super().__init__()
        self.heads, self.depth = heads, width // heads
        self.query, self.key, self.value, self.out_proj = (
            nn.Linear(width, width) for _ in range(4)
        )

    def _split(self, values: Tensor) -> Tensor:
        return values.unflatten(-1, (self.heads, self.depth)).transpose(1, 2)

    def forward(
        self, queries: Tensor, keys: Tensor, values: Tensor, bias: Tensor | None = None
    ) -> Tensor:
        query = self._split(self.query(queries)) * self.depth**-0.5
        weights = query @ self._split(self.key(keys)).transpose(-1, -2)
        weights = torch.softmax(weights if bias is None else weights + bias, dim=-1)
        return self.out_proj((weights @ self._split(self.value(values))).transpose(1, 2).flatten(2))


class Block(nn.Module):
    """Self-attention, feed-forward, and the way in which each part is added and normalised."""

    def __init__(self, width: int, heads: int, feed_forward: int, pre_norm: bool) -> None:
        super().__init__()
        self.pre_norm = pre_norm
        self.self_attn = Attention(width, heads)
        self.linear1, self.linear2 = nn.Linear(width, feed_forward), nn.Linear(feed_forward, width)
        self.norm1, self.norm2 = nn.LayerNorm(width), nn.LayerNorm(width)

    def add(self, tokens: Tensor, part: Callable[[Tensor], Tensor], norm: nn.Module) -> Tensor:
        """Tokens with a part's output added to them."""
        return tokens + part(norm(tokens)) if self.pre_norm else norm(tokens + part(tokens))

    def attend(self, tokens: Tensor, places: Tensor, bias: Tensor | None) -> Tensor:
        """Self-attention of tokens [B, L, C] at places [B, L, C]."""
        return self.self_attn(tokens + places, tokens + places, tokens, bias)

    def think(self, tokens: Tensor) -> Tensor:
        """Feed-forward, [B, L, C] → [B, L, C]."""
        return self.linear2(functional.leaky_relu(self.linear1(tokens), SLOPE))


class EncoderBlock(Block):
    """Tokens and places [B, S, C], bias [B, 1, S, S] → [B, S, C]."""

    def forward(self, tokens: Tensor, places: Tensor, bias: Tensor) -> Tensor:
        tokens = self.add(tokens, lambda given: self.attend(given, places, bias), self.norm1)
        return self.add(tokens, self.think, self.norm2)


class DecoderBlock(Block):
    """Tokens and places [B, T, C], memory and its places [B, S, C] → [B, T, C]."""

    def __init__(self, width: int, heads: int, feed_forward: int, pre_norm: bool) -> None:
        super().__init__(width, heads, feed_forward, pre_norm)
        self.multihead_attn = Attention(width, heads)
        self.norm3 = nn.LayerNorm(width)

    def forward(
        self, tokens: Tensor, places: Tensor, memory: Tensor, memory_places: Tensor
    ) -> Tensor:
        def ask(given: Tensor) -> Tensor:
            return self.multihead_attn(given + places, memory + memory_places, memory)

        tokens = self.add(tokens, lambda given: self.attend(given, places, None), self.norm1)
        tokens = self.add(tokens, ask, self.norm2)
        return self.add(tokens, self.think, self.norm3)


class Stack(nn.Module):
    """Blocks one after another, and a norm (nn.Identity for none) behind the last."""

    def __init__(self, blocks: list[Block], norm: nn.Module) -> None:
        super().__init__()
        self.layers, self.norm = nn.ModuleList(blocks), norm

    def forward(self, tokens: Tensor, *others: Tensor) -> Tensor:
        for layer in self.layers:
            tokens = layer(tokens, *others)
        return self.norm(tokens)

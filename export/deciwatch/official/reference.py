"""The authors' net the way they run it: all T frames at once, the unwatched ones masked.

Built of torch's own transformer, and so apart from deciwatch.official's nets, which it checks. Its
state_dict is that of the authors' `transformer`, key by key and shape by shape.
"""

import math

import torch
from torch import Tensor, nn
from torch.nn import functional

from deciwatch.official.config import OfficialConfig


class _EncoderLayer(nn.TransformerEncoderLayer):
    """torch's layer with positions [1, T, C] in queries and keys, as in DETR."""

    places: Tensor

    def _sa_block(self, x, attn_mask, key_padding_mask, is_causal=False):
        moved, masks = x + self.places, {"key_padding_mask": key_padding_mask}
        return self.self_attn(moved, moved, x, attn_mask=attn_mask, need_weights=False, **masks)[0]


class _DecoderLayer(nn.TransformerDecoderLayer):
    """torch's layer with positions in queries and keys; frames and memory have the same ones."""

    places: Tensor

    def _sa_block(self, x, attn_mask, key_padding_mask, is_causal=False):
        moved = x + self.places
        return self.self_attn(moved, moved, x, need_weights=False)[0]

    def _mha_block(self, x, mem, attn_mask, key_padding_mask, is_causal=False):
        queries, keys, masks = x + self.places, mem + self.places, {}
        masks["key_padding_mask"] = key_padding_mask
        return self.multihead_attn(queries, keys, mem, need_weights=False, **masks)[0]


def index_positions(frames: int, width: int) -> Tensor:
    """[1, T, C]: sine and cosine by turns of the index, stretched so that the last is at 2 π."""
    count = width // 2
    index = torch.arange(frames, dtype=torch.float32) / (frames - 1 + 1e-6) * (2 * math.pi)
    angles = index[:, None] / 10000 ** (2 * torch.arange(count, dtype=torch.float32) / count)
    places = torch.zeros(1, frames, width)
    places[0, :, 0::2], places[0, :, 1::2] = torch.sin(angles), torch.cos(angles)
    return places


class Reference(nn.Module):
    """The authors' `transformer`, without dropout; windows are of N·Q + 1 frames."""

    def __init__(self, config: OfficialConfig) -> None:
        super().__init__()
        self.config = config
        values, width = config.input_dim, config.hidden
        sizes = (width, config.heads, config.feed_forward, 0.0, functional.leaky_relu)
        options = {"batch_first": True, "norm_first": config.pre_norm}
        self.encoder_embed = nn.Linear(values, width)
        self.encoder = nn.TransformerEncoder(
            _EncoderLayer(*sizes, **options),
            config.encoder_layers,
            nn.LayerNorm(width) if config.pre_norm else None,
            enable_nested_tensor=False,
        )
        self.encoder_joints_embed = nn.Linear(width, values)
        self.decoder_embed = nn.Conv1d(values, width, kernel_size=5, padding=2)
        self.decoder = nn.TransformerDecoder(
            _DecoderLayer(*sizes, **options), config.decoder_layers, nn.LayerNorm(width)
        )
        self.decoder_joints_embed = nn.Linear(width, values)

    def forward(self, estimates: Tensor) -> tuple[Tensor, Tensor, Tensor]:
        """estimates [B, T, K·D], of which one in N is looked at.

        Returns poses [B, T, K·D], and of the samples clean [B, S, K·D] and features [B, S, C].
        """
        batch, frames, _ = estimates.shape
        torch._assert(frames == self.config.last_frame + 1, "a window has N·Q + 1 frames")
        for layer in (*self.encoder.layers, *self.decoder.layers):
            layer.places = index_positions(frames, self.config.hidden)
        unseen = (torch.arange(frames) % self.config.interval != 0).expand(batch, -1)
        seen = estimates.masked_fill(unseen[..., None], 0.0)
        itself = torch.eye(frames, dtype=torch.bool)
        memory = self.encoder(self.encoder_embed(seen), itself, src_key_padding_mask=unseen)
        watched = slice(None, None, self.config.interval)
        clean = (seen + self.encoder_joints_embed(memory))[:, watched]
        start = functional.interpolate(
            clean.transpose(1, 2), size=frames, mode="linear", align_corners=True
        )
        tokens = self.decoder_embed(start).transpose(1, 2)
        decoded = self.decoder(tokens, memory, memory_key_padding_mask=unseen)
        poses = start.transpose(1, 2) + self.decoder_joints_embed(decoded)
        return poses, clean, memory[:, watched]


def random_reference(config: OfficialConfig, seed: int) -> Reference:
    """A net with seeded weights, none of them zero or one, in evaluation mode."""
    generator = torch.Generator().manual_seed(seed)
    reference = Reference(config).eval()
    with torch.no_grad():
        for name, weight in reference.named_parameters():
            centre = 1.0 if "norm" in name and name.endswith("weight") else 0.0
            spread = 0.15 if weight.ndim == 1 else weight[0].numel() ** -0.5
            weight.copy_(centre + spread * torch.randn(weight.shape, generator=generator))
    return reference

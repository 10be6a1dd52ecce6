"""W_PR, the matrix of the preliminary recovery (the paper's equation 3), made from the times.

The paper learns one matrix for its one window length; here it is computed, so that it fits any.
"""

import torch
from torch import Tensor

KINDS = ("linear", "cubic")


def preliminary_matrix(sample_times: Tensor, frame_times: Tensor, kind: str) -> Tensor:
    """W_PR [B, T, S] for sample_times [B, S], ascending, and frame_times [B, T].

    "linear" joins samples by straight lines. "cubic" is piecewise cubic Hermite with the slope at
    a sample taken across its two neighbours (one-sided at the ends). Rows sum to one, and both
    give a motion of constant velocity back exactly. Times beyond the samples count as the nearest
    one. A single sample is held.
    """
    value, slope = _bases(sample_times, frame_times, kind)
    return value if slope is None else value + slope @ _slopes(sample_times)


def preliminary_recovery(
    clean: Tensor, sample_times: Tensor, frame_times: Tensor, kind: str
) -> Tensor:
    """W_PR · clean, [B, S, K·D] → [B, T, K·D], without building W_PR for "cubic".

    Slopes are taken of the values instead, which keeps the cost quadratic in S and T.
    """
    value, slope = _bases(sample_times, frame_times, kind)
    held = value @ clean
    return held if slope is None else held + slope @ (_slopes(sample_times) @ clean)


def _gaps(sample_times: Tensor) -> tuple[Tensor, Tensor]:
    """Time to the sample before and after each, [B, S]; one unit where there is none."""
    gaps = sample_times[:, 1:] - sample_times[:, :-1]
    one = torch.ones_like(sample_times[:, :1])
    return torch.cat([one, gaps], dim=1), torch.cat([gaps, one], dim=1)


def _bases(sample_times: Tensor, frame_times: Tensor, kind: str) -> tuple[Tensor, Tensor | None]:
    """Weights [B, T, S] of the samples' values and, for "cubic", of their slopes."""
    first, last = sample_times[:, :1], sample_times[:, -1:]
    times = torch.minimum(torch.maximum(frame_times, first), last).unsqueeze(-1)
    after_sample = times - sample_times.unsqueeze(1)
    left, right = (gap.unsqueeze(1) for gap in _gaps(sample_times))
    # 0 at the sample, 1 at and beyond the neighbour on that side; at most one is not 0.
    beyond = torch.clamp(after_sample / right, 0.0, 1.0)
    before = torch.clamp(-after_sample / left, 0.0, 1.0)
    away = beyond + before
    if kind == "linear":
        return 1.0 - away, None
    if kind != "cubic":
        raise ValueError(f"preliminary recovery {kind!r} is none of {KINDS}")
    value = 1.0 - away * away * (3.0 - 2.0 * away)
    rise = away * (1.0 - away) * (1.0 - away)
    return value, torch.where(after_sample >= 0, right, -left) * rise


def _slopes(sample_times: Tensor) -> Tensor:
    """[B, S, S] matrix from values at the samples to slopes at them."""
    left, right = _gaps(sample_times)
    index = torch.cumsum(torch.ones_like(sample_times), dim=1)
    count = index[:, -1:]
    is_first, is_last = (index == 1.0).to(left.dtype), (index == count).to(left.dtype)
    after, before = index + 1.0 - is_last, index - 1.0 + is_first
    span = right * (1.0 - is_last) + left * (1.0 - is_first)
    column = index.unsqueeze(1)
    difference = (column == after.unsqueeze(2)).to(span.dtype)
    difference = difference - (column == before.unsqueeze(2)).to(span.dtype)
    # One sample alone has no neighbour on either side: span 0, difference 0.
    return difference / torch.clamp(span, min=1e-6).unsqueeze(2)

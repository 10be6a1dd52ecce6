"""W_PR, the matrix of the preliminary recovery (the paper's equation 3), made from the times.

The paper learns one matrix for its one window length; here it is computed, so that it fits any.
"""

import torch
from torch import Tensor

KINDS = ("linear", "cubic", "spline")
SPLINE_SHARE = 0.8  # of the way to a sweep's slopes; lowest error at N = 2 on recorded motion


def preliminary_matrix(sample_times: Tensor, frame_times: Tensor, kind: str) -> Tensor:
    """W_PR [B, T, S] for sample_times [B, S], ascending, and frame_times [B, T].

    "linear" joins samples by straight lines. "cubic" is piecewise cubic Hermite with the slope at
    a sample taken across its two neighbours (one-sided at the ends). "spline" is the same with
    slopes near those of the cubic spline: closer on true samples, but it follows noisy ones. Rows
    sum to one, and all give a motion of constant velocity back exactly. Times beyond the samples
    count as the nearest one. A single sample is held.
    """
    value, slope = _bases(sample_times, frame_times, kind)
    return value if slope is None else value + slope @ _slopes(sample_times, kind)


def preliminary_recovery(
    clean: Tensor, sample_times: Tensor, frame_times: Tensor, kind: str
) -> Tensor:
    """W_PR · clean, [B, S, K·D] → [B, T, K·D], without building W_PR.

    Slopes are taken of the values instead, which keeps the cost quadratic in S and T.
    """
    value, slope = _bases(sample_times, frame_times, kind)
    held = value @ clean
    return held if slope is None else held + slope @ (_slopes(sample_times, kind) @ clean)


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
    if kind not in KINDS:
        raise ValueError(f"preliminary recovery {kind!r} is none of {KINDS}")
    value = 1.0 - away * away * (3.0 - 2.0 * away)
    rise = away * (1.0 - away) * (1.0 - away)
    return value, torch.where(after_sample >= 0, right, -left) * rise


def _slopes(sample_times: Tensor, kind: str) -> Tensor:
    """[B, S, S] matrix from values at the samples to slopes at them."""
    across = _slopes_across(sample_times)
    return across if kind == "cubic" else _towards_spline(across, sample_times)


def _towards_spline(slopes: Tensor, sample_times: Tensor) -> Tensor:
    """Slopes at which the second derivative makes less of a step.

    The spline's own, at which it makes none, come from a tridiagonal system; one sweep of Jacobi's
    iteration over its rows needs no solver in the graph. First and last gap become parabolas.
    """
    left, right = (gap.unsqueeze(2) for gap in _gaps(sample_times))
    index = torch.cumsum(torch.ones_like(sample_times), dim=1).unsqueeze(2)
    count = index[:, -1:]
    is_first, is_last = (index == 1.0).to(left.dtype), (index == count).to(left.dtype)
    inner = (1.0 - is_first) * (1.0 - is_last)
    own = (index == index.transpose(1, 2)).to(left.dtype)
    # Rises per unit of time over the gap before and after each sample; 0 where there is none.
    before = (own - _row_before(own)) / left
    after = (_row_after(own) - own) / right

    def with_ends(slopes: Tensor) -> Tensor:
        first = is_first * (2.0 * after - _row_after(slopes))
        last = is_last * (2.0 * before - _row_before(slopes))
        # One sample alone has no slope at all.
        return (inner * slopes + first + last) * (count > 1.0).to(left.dtype)

    slopes = with_ends(slopes)
    rest = right * _row_before(slopes) + left * _row_after(slopes)
    swept = (3.0 * (right * before + left * after) - rest) / (2.0 * (left + right))
    return with_ends(slopes + SPLINE_SHARE * (swept - slopes))


def _row_before(matrix: Tensor) -> Tensor:
    """[B, S, S] with each row's predecessor in its place, the first row its own."""
    return torch.cat([matrix[:, :1], matrix[:, :-1]], dim=1)


def _row_after(matrix: Tensor) -> Tensor:
    """[B, S, S] with each row's successor in its place, the last row its own."""
    return torch.cat([matrix[:, 1:], matrix[:, -1:]], dim=1)


def _slopes_across(sample_times: Tensor) -> Tensor:
    """[B, S, S] matrix to slopes taken across each sample's two neighbours, one-sided at ends."""
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

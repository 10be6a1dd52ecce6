"""How the shipped nets' weights are rounded, so that their files can hold them in a byte or two.

The nets compute in float32 all the same. Weights are rounded once, in torch (`round_weights`); the
graph is made of the rounded ones and holds exactly those (deciwatch.compact), so that torch and
onnxruntime still agree to the last digits.
"""

from typing import TypeVar

import numpy as np
import torch
from torch import nn

# Smaller tensors (biases, norms) stay as they are: they are a hundredth of the numbers.
LEAST = 1000
TOP = 127
STEP_BITS = 8
# These read the estimator's poses and scores, which are large beside the correction that they add
# up to. In int8 they cost 0.6 mm of the validation pairs' MPJPE, in float16 nothing; all others in
# int8 cost less than 0.01 mm.
FINE = ("denoise.embed.weight", "denoise.skip.weight")

Net = TypeVar("Net", bound=nn.Module)


def as_int8(weight: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Nearest whole numbers -127 to 127 in shape [out, ...], and the steps [out] that they count.

    A step is the largest weight's 127th part to STEP_BITS significant bits. So a product with a
    whole number is exact in float32; and as the largest weight is within 127 / 2**STEP_BITS < 1/2
    of 127 steps, it always counts 127, and rounding what is rounded already changes nothing.
    """
    rows = weight.reshape(len(weight), -1)
    mantissa, exponent = np.frexp(np.abs(rows).max(axis=1) / np.float32(TOP))
    mantissa = np.round(mantissa * 2**STEP_BITS) / np.float32(2**STEP_BITS)
    steps = np.ldexp(mantissa, exponent).astype(np.float32)
    steps[steps == 0] = 1
    whole = np.round(rows / steps[:, None]).astype(np.int8)
    return whole.reshape(weight.shape), steps


def from_int8(whole: np.ndarray, steps: np.ndarray) -> np.ndarray:
    """The float32 weights that `as_int8` stands for."""
    return whole.astype(np.float32) * steps.reshape(-1, *[1] * (whole.ndim - 1))


def rounded(name: str, weight: np.ndarray) -> np.ndarray:
    """A parameter [out, ...] of a net as its file can hold it; `name` as in the net's state."""
    if weight.size <= LEAST or weight.ndim < 2:
        return weight
    if name in FINE:
        return weight.astype(np.float16).astype(np.float32)
    return from_int8(*as_int8(weight))


@torch.no_grad()
def round_weights(net: Net) -> Net:
    """Round a net's weights in place; returns it. Names are those of a Pair or a ForecastNet."""
    for name, weight in net.named_parameters():
        weight.copy_(torch.from_numpy(rounded(name, weight.numpy())))
    return net

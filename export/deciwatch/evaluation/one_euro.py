"""The 1€ filter, run on every frame: a low-pass whose cutoff rises with speed.

G. Casiez, N. Roussel, D. Vogel, "1€ Filter", CHI 2012, https://gery.casiez.net/1euro/, algorithm 1.
"""

import numpy as np

SPEED_CUTOFF = 1.0  # Hz, the paper's d_cutoff


def _share(cutoff: np.ndarray | float, step: float) -> np.ndarray:
    """Share of the new value for a cutoff in Hz and a step in seconds (the paper's α)."""
    return 1.0 / (1.0 + 1.0 / (2 * np.pi * cutoff * step))


def one_euro(
    values: np.ndarray,
    times: np.ndarray,
    min_cutoff: np.ndarray | float,
    beta: np.ndarray | float,
) -> np.ndarray:
    """Values [T, C] at ascending times [T] seconds, filtered.

    min_cutoff in Hz, beta in Hz per unit of speed: numbers, which give [T, C], or [G, 1], which
    try G settings at once and give [T, G, C].
    """
    filtered = [values[0] + np.zeros_like(np.asarray(min_cutoff * values[0]))]
    speed = np.zeros_like(filtered[0])
    for step, value in zip(np.diff(times), values[1:], strict=True):
        speed += _share(SPEED_CUTOFF, step) * ((value - filtered[-1]) / step - speed)
        share = _share(min_cutoff + beta * np.abs(speed), step)
        filtered.append(filtered[-1] + share * (value - filtered[-1]))
    return np.stack(filtered)

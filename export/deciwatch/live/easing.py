"""Passing over from what was shown to what is known better by now; as in `web/pose/easing.ts`."""

import numpy as np

EASE_SECONDS = 0.1


def eased_share(age: np.ndarray) -> np.ndarray:
    """The share of an old difference still shown after `age` seconds: 1 at 0, 0 at EASE_SECONDS."""
    x = np.clip(np.asarray(age, float) / EASE_SECONDS, 0.0, 1.0)
    return 1 - x**3 * (x * (6 * x - 15) + 10)

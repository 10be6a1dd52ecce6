"""Light, colours and occluders of a clip, as `export/render/job.ts` wants them."""

import numpy as np

from deciwatch.pairs.cameras import Camera


def draw_surroundings(rng: np.random.Generator, camera: Camera, landmarks: np.ndarray) -> dict:
    """Random surroundings; one clip in six has one or two boxes before the person."""
    occluders = []
    if rng.random() < 1 / 6:
        occluders = [_box(rng, camera, landmarks) for _ in range(rng.integers(1, 3))]
    direction = rng.standard_normal(3)
    direction[1] = abs(direction[1]) + 0.3
    return {
        "seed": int(rng.integers(2**31)),
        "sky": _colour(rng),
        "floor": _colour(rng),
        "hasFloor": bool(rng.random() < 0.7),
        "ambient": float(rng.uniform(0.5, 1.8)),
        "sun": float(rng.uniform(0.3, 3.0)),
        "sunDirection": direction.tolist(),
        "sunColour": (1 - 0.3 * rng.random(3)).tolist(),
        "occluders": occluders,
    }


def _colour(rng: np.random.Generator) -> list[float]:
    return (rng.uniform(0.15, 0.9) + 0.25 * (rng.random(3) - 0.5)).clip(0, 1).tolist()


def _box(rng: np.random.Generator, camera: Camera, landmarks: np.ndarray) -> dict:
    """A box on the line from the lens to a landmark at some moment."""
    frame, landmark = rng.integers(len(landmarks)), rng.integers(landmarks.shape[1])
    point, lens = landmarks[frame, landmark], camera.position[frame]
    centre = point + rng.uniform(0.25, 0.5) * (lens - point)
    return {
        "centre": centre.tolist(),
        "size": rng.uniform(0.08, 0.4, size=3).tolist(),
        "yaw": float(rng.uniform(0, np.pi)),
        "colour": _colour(rng),
    }

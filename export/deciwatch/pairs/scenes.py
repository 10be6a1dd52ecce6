"""One clip made ready: the avatar moved, the camera placed, the truth known."""

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from deciwatch.motion.cmu import Bodies
from deciwatch.motion.landmarks import global_rotations
from deciwatch.pairs.cameras import Camera, draw_camera
from deciwatch.pairs.plan import Clip
from deciwatch.pairs.points import landmarks
from deciwatch.pairs.rig import Rig, local_matrices, pose_rig, read_rig
from deciwatch.pairs.surroundings import draw_surroundings
from deciwatch.pairs.variation import vary_movement, vary_rig
from deciwatch.skeleton import mid_hip


@dataclass(frozen=True)
class Scene:
    """truth_3d [F, 33, 3] metres and truth_2d [F, 33, 2] pixels of every frame of the clip.

    nodes [m] and matrices [F, m, 4, 4] move the avatar.
    """

    clip: Clip
    camera: Camera
    surroundings: dict
    nodes: list[str]
    matrices: np.ndarray
    truth_3d: np.ndarray
    truth_2d: np.ndarray

    @property
    def box(self) -> np.ndarray:
        """Box of each frame's true landmarks, [F, 4]: x0, y0, x1, y1."""
        return np.concatenate([self.truth_2d.min(axis=1), self.truth_2d.max(axis=1)], axis=1)


@lru_cache(maxsize=32)
def _rig(path: Path) -> Rig:
    return read_rig(path)


def stage(bodies: Bodies, clip: Clip, avatars: Path, varied: bool = False) -> Scene:
    """The scene of a clip; its camera, light and so on come from the clip's own seed.

    With `varied` the movement and the body's proportions are changed as well (`variation.py`).
    """
    rng = np.random.default_rng(clip.seed)
    rig = _rig(avatars / clip.avatar)
    frames = slice(bodies.start[clip.sequence] + clip.first, None)
    frames = slice(frames.start, frames.start + clip.length)
    angles = bodies.axis_angles[frames]
    if varied:
        rig, angles = vary_rig(rng, rig), vary_movement(rng, bodies, angles)
    rotations = global_rotations(angles)
    root = bodies.joints[frames, 0].astype(float)
    # Long legs take long steps.
    hips = root * rig.world[rig.index("Hips"), 1, 3] / _standing_height(bodies, clip.sequence)
    world = pose_rig(rig, rotations, hips)
    points = landmarks(rig, world)
    drop = np.quantile(points[..., 1].min(axis=1), 0.05)
    move = np.array([points[..., 0].mean(), drop, points[..., 2].mean()])
    world[..., :3, 3] -= move
    points -= move
    camera = draw_camera(rng, points)
    nodes, matrices = local_matrices(rig, world)
    turned = np.einsum("fij,fkj->fki", camera.rotation, points - mid_hip(points))
    return Scene(
        clip,
        camera,
        draw_surroundings(rng, camera, points),
        nodes,
        matrices,
        turned.astype(np.float32),
        camera.project(points).astype(np.float32),
    )


def _standing_height(bodies: Bodies, sequence: int) -> float:
    """Length of the legs, hip to ankle, plus the ankle's height: where the pelvis is at rest."""
    joints = bodies.joints[bodies.start[sequence]]
    hip, knee, ankle = joints[4], joints[5], joints[6]
    return float(np.linalg.norm(hip - knee) + np.linalg.norm(knee - ankle) + 0.09)

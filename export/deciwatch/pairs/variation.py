"""Movements and bodies that nobody recorded, for clips whose truth alone is wanted.

Twenty minutes of seventeen people are soon known by heart. Arms of one movement on the trunk of
another, limbs a little more bent, longer shins: a net that is to correct poses has to see them.
"""

from dataclasses import replace

import numpy as np
from scipy.ndimage import gaussian_filter1d

from deciwatch.motion.cmu import Bodies
from deciwatch.motion.landmarks import SMPL_JOINTS
from deciwatch.pairs.rig import BONES, Rig

GRAFTED = 0.5  # share of clips with the arms, or the legs, of another movement
BENT = 0.12  # radians, root mean square, of a joint's lasting and of its slow extra turn
SLOW = 15.0  # frames over which the extra turn changes
LENGTHS = 0.06  # standard deviation of a bone's length over its own

_ARMS = [i for i, name in enumerate(SMPL_JOINTS) if name[2:] in ("shoulder", "elbow", "wrist")]
_LEGS = [i for i, name in enumerate(SMPL_JOINTS) if name[2:] in ("hip", "knee", "ankle")]
# Toes and collars stay as they are: no landmark tells how they are turned.
_BENT = [
    i
    for i, name in enumerate(SMPL_JOINTS)
    if name != "pelvis" and name[2:] not in ("foot", "collar")
]


def vary_movement(rng: np.random.Generator, bodies: Bodies, angles: np.ndarray) -> np.ndarray:
    """Local axis-angle [F, 22, 3] → the same with other limbs and other bends."""
    angles = np.array(angles, dtype=np.float32)
    for joints in (_ARMS, _LEGS):
        if rng.random() < GRAFTED:
            other = _stretch(rng, bodies, len(angles))
            angles[:, joints] = other[:, joints]
    strength = rng.uniform(0.0, 1.5)
    shape = (len(angles), len(_BENT), 3)
    slow = gaussian_filter1d(rng.standard_normal(shape), SLOW, axis=0, mode="wrap")
    slow /= slow.std() + 1e-9
    lasting = rng.standard_normal((1, *shape[1:]))
    angles[:, _BENT] += (BENT * strength * (slow + lasting)).astype(np.float32)
    return angles


def _stretch(rng: np.random.Generator, bodies: Bodies, frames: int) -> np.ndarray:
    """`frames` frames of some sequence, forwards and backwards where it is too short."""
    sequence = rng.integers(len(bodies.length))
    length = int(bodies.length[sequence])
    first = int(rng.integers(max(length - frames, 0) + 1))
    course = np.arange(first, first + frames) % (2 * length - 2)
    course = np.where(course < length, course, 2 * length - 2 - course)
    return bodies.axis_angles[bodies.start[sequence] + course]


def vary_rig(rng: np.random.Generator, rig: Rig) -> Rig:
    """Another body: each bone longer or shorter, left as right."""
    local = rig.local.copy()
    factors: dict[str, float] = {}
    for bone in BONES.values():
        key = bone.removeprefix("Left").removeprefix("Right")
        factor = factors.setdefault(key, float(np.exp(LENGTHS * rng.standard_normal())))
        if key != "Hips":
            local[rig.index(bone), :3, 3] *= factor
    world = local.copy()
    for i, parent in enumerate(rig.parents):
        if parent >= 0:
            world[i] = world[parent] @ local[i]
    return replace(rig, local=local, world=world)

"""An avatar's skeleton, read from its glTF, moved by SMPL-ordered rotations.

The avatars (VALID, MIT licence) stand in a T-pose, facing +z, their left at +x, in metres, as the
motions' rest pose does. Bones have Mixamo's names.
"""

import json
import struct
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from deciwatch.errors import UserError
from deciwatch.motion.landmarks import SMPL_JOINTS

_SIDES = {"hip": "UpLeg", "knee": "Leg", "ankle": "Foot", "foot": "ToeBase"} | {
    "collar": "Shoulder",
    "shoulder": "Arm",
    "elbow": "ForeArm",
    "wrist": "Hand",
}
# The avatar's bone that each SMPL joint turns.
BONES: dict[str, str] = {
    "pelvis": "Hips",
    "spine1": "Spine",
    "spine2": "Spine1",
    "spine3": "Spine2",
    "neck": "Neck",
    "head": "Head",
}
for _side, _name in (("l", "Left"), ("r", "Right")):
    BONES |= {f"{_side}_{joint}": _name + bone for joint, bone in _SIDES.items()}

# Bones whose direction at rest is brought to the motions' own: where they end, and where to point.
_ALIGNED = {
    "UpLeg": ("Leg", (0.0, -1.0, 0.0)),
    "Leg": ("Foot", (0.0, -1.0, 0.0)),
    "Arm": ("ForeArm", (1.0, 0.0, 0.0)),
    "ForeArm": ("Hand", (1.0, 0.0, 0.0)),
}


@dataclass(frozen=True)
class Rig:
    """A node tree at rest.

    names [n], parents [n] (−1 for a root), each parent before its children; local [n, 4, 4] node to
    parent, world [n, 4, 4] node to world.
    """

    names: tuple[str, ...]
    parents: tuple[int, ...]
    local: np.ndarray
    world: np.ndarray

    def index(self, name: str) -> int:
        """Place of a node; raises UserError where the rig has none of that name."""
        if name not in self.names:
            raise UserError(f"The avatar has no bone {name}; use one with Mixamo's bone names.")
        return self.names.index(name)


def read_rig(path: Path) -> Rig:
    """The node tree of a .glb. Raises UserError if it is not one."""
    try:
        content = path.read_bytes()
        magic, _, _, size, kind = struct.unpack("<4sII I4s", content[:20])
        if magic != b"glTF" or kind != b"JSON":
            raise ValueError("no glTF header")
        nodes = json.loads(content[20 : 20 + size])["nodes"]
    except (OSError, ValueError, KeyError, struct.error) as error:
        raise UserError(f"{path} is not a binary glTF file ({error}); fetch it again.") from error
    parent_of = {child: i for i, node in enumerate(nodes) for child in node.get("children", [])}
    order: list[int] = []
    waiting = [i for i in range(len(nodes)) if i not in parent_of]
    while waiting:
        order.append(waiting.pop())
        waiting += nodes[order[-1]].get("children", [])
    local = np.stack([_matrix(nodes[i]) for i in order])
    parents = tuple(order.index(parent_of[i]) if i in parent_of else -1 for i in order)
    world = local.copy()
    for i, parent in enumerate(parents):
        if parent >= 0:
            world[i] = world[parent] @ local[i]
    return Rig(tuple(str(nodes[i].get("name", i)) for i in order), parents, local, world)


def _matrix(node: dict) -> np.ndarray:
    matrix = np.eye(4)
    x, y, z, w = node.get("rotation", (0, 0, 0, 1))
    rotation = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    matrix[:3, :3] = rotation * np.array(node.get("scale", (1, 1, 1)))
    matrix[:3, 3] = node.get("translation", (0, 0, 0))
    return matrix


def turn_between(start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """The smallest rotation [3, 3] that brings direction `start` to `end`."""
    start, end = start / np.linalg.norm(start), end / np.linalg.norm(end)
    cross, cosine = np.cross(start, end), float(start @ end)
    x, y, z = cross
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + skew + skew @ skew / (1 + cosine)


def _alignments(rig: Rig) -> dict[str, np.ndarray]:
    """Rotation of each aligned bone from the avatar's rest pose to the motions', by joint."""
    turns = {}
    for joint, bone in BONES.items():
        part = bone.removeprefix("Left").removeprefix("Right")
        if part not in _ALIGNED:
            continue
        end, (x, y, z) = _ALIGNED[part]
        side = "Left" if bone.startswith("Left") else "Right"
        along = rig.world[rig.index(side + end)] - rig.world[rig.index(bone)]
        to = np.array([x if side == "Left" else -x, y, z])
        turns[joint] = turn_between(along[:3, 3], to)
    return turns


def pose_rig(rig: Rig, rotations: np.ndarray, hips: np.ndarray) -> np.ndarray:
    """Node-to-world matrices [F, n, 4, 4] for joints' rotations from rest to world.

    rotations: [F, 22, 3, 3] in SMPL_JOINTS order; hips: [F, 3], where the Hips bone goes, metres.
    Nodes without a joint of their own follow their parent.
    """
    turns, frames = _alignments(rig), len(rotations)
    joint_of = {rig.index(bone): joint for joint, bone in BONES.items()}
    world = np.empty((frames, len(rig.names), 4, 4))
    for i, parent in enumerate(rig.parents):
        world[:, i] = rig.local[i] if parent < 0 else world[:, parent] @ rig.local[i]
        if i not in joint_of:
            continue
        joint = joint_of[i]
        turn = rotations[:, SMPL_JOINTS.index(joint)] @ turns.get(joint, np.eye(3))
        world[:, i, :3, :3] = turn @ rig.world[i, :3, :3]
        if joint == "pelvis":
            world[:, i, :3, 3] = hips
    return world


def local_matrices(rig: Rig, world: np.ndarray) -> tuple[list[str], np.ndarray]:
    """Names [m] and node-to-parent matrices [F, m, 4, 4] of the bones that `pose_rig` moves."""
    indices = sorted(rig.index(bone) for bone in BONES.values())
    local = np.empty((len(world), len(indices), 4, 4))
    for place, i in enumerate(indices):
        parent = rig.parents[i]
        local[:, place] = (
            world[:, i] if parent < 0 else np.linalg.inv(world[:, parent]) @ world[:, i]
        )
    return [rig.names[i] for i in indices], local

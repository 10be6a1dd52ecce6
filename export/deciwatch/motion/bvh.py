"""Biovision files (.bvh): the hierarchy, the motion, and forward kinematics.

Positions come in the file's own length unit; y up in the two CMU conversions read here.
"""

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from deciwatch.errors import UserError
from deciwatch.rotations import euler


@dataclass
class Joint:
    """A joint: parent's name ("" for the root), offset from it at rest, channel names in order."""

    parent: str
    offset: np.ndarray = field(default_factory=lambda: np.zeros(3))
    channels: tuple[str, ...] = ()


@dataclass(frozen=True)
class Bvh:
    """joints by name, parents first; values [F, channels of all joints in order]; frame rate."""

    joints: dict[str, Joint]
    values: np.ndarray
    fps: float


def read_bvh(path: Path) -> Bvh:
    """Read a file; end sites become joints named after their parent plus "_end".

    Raises UserError if it cannot be read or is no whole BVH.
    """
    try:
        text = Path(path).read_text(errors="replace")
    except OSError as error:
        raise UserError(f"{path} cannot be read ({error.strerror}).") from error
    head, mark, tail = text.partition("MOTION")
    try:
        if not mark:
            raise ValueError("it has no MOTION")
        joints = _hierarchy(head.split())
        width = sum(len(joint.channels) for joint in joints.values())
        words = tail.split()
        # Frames: n Frame Time: seconds, then the numbers.
        count, seconds = int(words[1]), float(words[4])
        values = np.array(words[5:], dtype=float)
        if values.size != count * width:
            raise ValueError(f"it has {values.size} numbers where {count} × {width} belong")
        return Bvh(joints, values.reshape(count, width), 1.0 / seconds)
    except (IndexError, KeyError, ValueError, ZeroDivisionError) as error:
        raise UserError(f"{path} cannot be read as a BVH ({error}); fetch it again.") from error


def _hierarchy(words: list[str]) -> dict[str, Joint]:
    joints: dict[str, Joint] = {}
    above: list[str] = []
    name, at = "", 1
    while at < len(words):
        word = words[at]
        if word in ("ROOT", "JOINT", "End"):
            parent = above[-1] if above else ""
            name = f"{parent}_end" if word == "End" else words[at + 1]
            joints[name] = Joint(parent)
            at += 2
        elif word == "OFFSET":
            joints[name].offset = np.array([float(x) for x in words[at + 1 : at + 4]])
            at += 4
        elif word == "CHANNELS":
            count = int(words[at + 1])
            joints[name].channels = tuple(words[at + 2 : at + 2 + count])
            at += 2 + count
        elif word == "{":
            above.append(name)
            at += 1
        elif word == "}":
            above.pop()
            at += 1
        else:
            raise ValueError(f"it has {word!r} in its hierarchy")
    if above or not joints:
        raise ValueError("its braces do not match")
    return joints


def pose(bvh: Bvh) -> tuple[dict[str, np.ndarray], dict[str, np.ndarray]]:
    """World positions [F, 3] in file units and rotations from rest [F, 3, 3] of every joint."""
    places: dict[str, np.ndarray] = {}
    turns: dict[str, np.ndarray] = {}
    column, frames = 0, len(bvh.values)
    for name, joint in bvh.joints.items():
        values = bvh.values[:, column : column + len(joint.channels)]
        column += len(joint.channels)
        offset = np.tile(joint.offset, (frames, 1))
        angles, order = [], ""
        for channel, value in zip(joint.channels, values.T, strict=True):
            axis = channel[0].lower()
            if channel.endswith("position"):
                offset[:, "xyz".index(axis)] = value
            else:
                angles.append(np.radians(value))
                order += axis
        local = euler(np.stack(angles, axis=-1), order) if order else np.eye(3)
        if joint.parent:
            turn = turns[joint.parent]
            places[name] = places[joint.parent] + np.einsum("fij,fj->fi", turn, offset)
            turns[name] = turn @ local
        else:
            places[name], turns[name] = offset, np.broadcast_to(local, (frames, 3, 3))
    return places, turns

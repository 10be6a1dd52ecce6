"""Where each of the 33 landmarks lies on an avatar: the truth of a pair.

A landmark is a bone's head, or a point fixed to a bone. The points that no bone marks (nose, mouth,
ears, corners of the eyes, heels, tips of the shoes) were first read off the mesh and then moved to
where MediaPipe's estimates lie on the average, so that a mere difference of definition is not
counted as an error; POINTS has them.
"""

from dataclasses import dataclass

import numpy as np

from deciwatch.pairs.rig import Rig
from deciwatch.skeleton import INDEX, KEYPOINTS


@dataclass(frozen=True)
class Point:
    """The head of bone `at`, plus an offset in metres that turns with bone `turns` from rest."""

    at: str
    turns: str
    offset: tuple[float, float, float] = (0.0, 0.0, 0.0)


def _at(bone: str) -> Point:
    return Point(bone, bone)


# Left side and middle, axes of the T-pose: x to the avatar's left, y up, z forwards.
_LEFT: dict[str, Point] = {
    "left_eye_inner": Point("LeftEye", "Head", (-0.016, 0.006, 0.036)),
    "left_eye": Point("LeftEye", "Head", (-0.015, 0.007, 0.036)),
    "left_eye_outer": Point("LeftEye", "Head", (-0.014, 0.007, 0.036)),
    "left_ear": Point("LeftEye", "Head", (0.036, -0.021, -0.061)),
    "mouth_left": Point("LeftEye", "Head", (-0.010, -0.054, 0.027)),
    "left_shoulder": _at("LeftArm"),
    "left_elbow": _at("LeftForeArm"),
    "left_wrist": _at("LeftHand"),
    "left_pinky": _at("LeftHandPinky1"),
    "left_index": _at("LeftHandIndex1"),
    "left_thumb": _at("LeftHandThumb2"),
    "left_hip": _at("LeftUpLeg"),
    "left_knee": _at("LeftLeg"),
    "left_ankle": _at("LeftFoot"),
    "left_heel": Point("LeftFoot", "LeftFoot", (0.0, -0.030, -0.015)),
    "left_foot_index": Point("LeftToeBase", "LeftToeBase", (0.0, 0.010, 0.030)),
}


def _mirrored(point: Point) -> Point:
    x, y, z = point.offset
    at, turns = (bone.replace("Left", "Right") for bone in (point.at, point.turns))
    return Point(at, turns, (-x, y, z))


POINTS: dict[str, Point] = {"nose": Point("Head", "Head", (0.0, 0.031, 0.122))} | _LEFT
POINTS |= {name.replace("left", "right"): _mirrored(point) for name, point in _LEFT.items()}


def landmarks(rig: Rig, world: np.ndarray) -> np.ndarray:
    """Landmarks [F, 33, 3] in metres for node-to-world matrices [F, n, 4, 4] of `pose_rig`."""
    found = np.empty((len(world), KEYPOINTS, 3))
    for name, point in POINTS.items():
        bone = rig.index(point.turns)
        turn = world[:, bone, :3, :3] @ np.linalg.inv(rig.world[bone, :3, :3])
        place = world[:, rig.index(point.at), :3, 3]
        found[:, INDEX[name]] = place + turn @ np.array(point.offset)
    return found

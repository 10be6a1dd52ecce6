"""The 33 MediaPipe landmarks from the 24 CMU joints and 22 SMPL-ordered rotations.

Frames: metres, world axes, y up. At rest (T-pose) the body faces +z and its left is +x, and each
joint's own axes are the world's. Every row of the table below says where a landmark comes from.
"""

from dataclasses import dataclass

import numpy as np

from deciwatch.rotations import axis_angle
from deciwatch.skeleton import INDEX, KEYPOINTS

# Joints of a body, in the order of the shards; H36M's 17 first.
JOINTS: tuple[str, ...] = (
    *("pelvis", "r_hip", "r_knee", "r_ankle", "l_hip", "l_knee", "l_ankle"),
    *("spine", "thorax", "neck", "head", "l_shoulder", "l_elbow", "l_wrist"),
    *("r_shoulder", "r_elbow", "r_wrist", "nose", "l_eye", "r_eye", "l_ear", "r_ear"),
    *("l_toe", "r_toe"),
)
SMPL_JOINTS: tuple[str, ...] = (
    *("pelvis", "l_hip", "r_hip", "spine1", "l_knee", "r_knee", "spine2", "l_ankle"),
    *("r_ankle", "spine3", "l_foot", "r_foot", "neck", "l_collar", "r_collar", "head"),
    *("l_shoulder", "r_shoulder", "l_elbow", "r_elbow", "l_wrist", "r_wrist"),
)
# The bones whose own axes carry landmarks.
FRAMES = ("head", "l_wrist", "r_wrist", "l_ankle", "r_ankle")
SMPL_PARENTS = (-1, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 12, 13, 14, 16, 17, 18, 19)


@dataclass(frozen=True)
class Source:
    """Where a landmark comes from: a joint, plus an offset (metres) in a bone's own axes.

    `frame` None means the joint itself: "measured" where CMU's markers give it, "data" where the
    shards already hold it as a fixed offset in the head frame.
    """

    joint: str
    kind: str
    frame: str | None = None
    offset: tuple[float, float, float] = (0.0, 0.0, 0.0)


# Left side and middle; the right side is its mirror image (x → −x, l_ → r_).
_LEFT: dict[str, Source] = {
    "left_eye_inner": Source("l_eye", "offset", "head", (-0.014, 0.0, 0.004)),
    "left_eye": Source("l_eye", "data"),
    "left_eye_outer": Source("l_eye", "offset", "head", (0.014, 0.0, -0.006)),
    "left_ear": Source("l_ear", "data"),
    "mouth_left": Source("nose", "offset", "head", (0.024, -0.036, -0.016)),
    "left_shoulder": Source("l_shoulder", "measured"),
    "left_elbow": Source("l_elbow", "measured"),
    "left_wrist": Source("l_wrist", "measured"),
    # Knuckles of a flat hand, palm down in the T-pose, thumb forward.
    "left_pinky": Source("l_wrist", "offset", "l_wrist", (0.080, -0.006, -0.028)),
    "left_index": Source("l_wrist", "offset", "l_wrist", (0.092, 0.0, 0.022)),
    "left_thumb": Source("l_wrist", "offset", "l_wrist", (0.055, -0.016, 0.052)),
    "left_hip": Source("l_hip", "measured"),
    "left_knee": Source("l_knee", "measured"),
    "left_ankle": Source("l_ankle", "measured"),
    # The back of the heel, below and behind the ankle's joint centre.
    "left_heel": Source("l_ankle", "offset", "l_ankle", (0.0, -0.050, -0.045)),
    "left_foot_index": Source("l_toe", "measured"),
}


def _mirrored(source: Source) -> Source:
    def other(name: str | None) -> str | None:
        return "r_" + name[2:] if name and name.startswith("l_") else name

    x, y, z = source.offset
    return Source(other(source.joint), source.kind, other(source.frame), (-x, y, z))


SOURCES: dict[str, Source] = {"nose": Source("nose", "data")} | _LEFT
SOURCES |= {name.replace("left", "right"): _mirrored(source) for name, source in _LEFT.items()}


def global_rotations(axis_angles: np.ndarray) -> np.ndarray:
    """Local axis-angle [F, 22, 3] → each joint's rotation from rest to world, [F, 22, 3, 3]."""
    local = axis_angle(axis_angles)
    world = np.empty_like(local)
    for joint, parent in enumerate(SMPL_PARENTS):
        world[:, joint] = local[:, joint] if parent < 0 else world[:, parent] @ local[:, joint]
    return world


def landmarks_from_frames(joints: np.ndarray, frames: dict[str, np.ndarray]) -> np.ndarray:
    """Joints [F, 24, 3] and rotations [F, 3, 3] of FRAMES → landmarks [F, 33, 3], float32."""
    landmarks = np.empty((len(joints), KEYPOINTS, 3), dtype=np.float32)
    for name, source in SOURCES.items():
        point = joints[:, JOINTS.index(source.joint)]
        if source.frame is not None:
            point = point + frames[source.frame] @ np.array(source.offset)
        landmarks[:, INDEX[name]] = point
    return landmarks


def landmarks_from_body(joints: np.ndarray, axis_angles: np.ndarray) -> np.ndarray:
    """Joints [F, 24, 3] and axis-angles [F, 22, 3] → landmarks [F, 33, 3], float32."""
    if joints.shape[1:] != (24, 3) or axis_angles.shape[1:] != (22, 3):
        raise ValueError(
            f"expected [F, 24, 3] and [F, 22, 3], got {joints.shape}, {axis_angles.shape}"
        )
    rotations = global_rotations(axis_angles)
    frames = {name: rotations[:, SMPL_JOINTS.index(name)] for name in FRAMES}
    return landmarks_from_frames(joints, frames)

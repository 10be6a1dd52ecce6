"""The blazepose-33 skeleton: MediaPipe Pose's landmarks in MediaPipe's order."""

import numpy as np

NAME = "blazepose-33"

LANDMARKS: tuple[str, ...] = (
    "nose",
    "left_eye_inner",
    "left_eye",
    "left_eye_outer",
    "right_eye_inner",
    "right_eye",
    "right_eye_outer",
    "left_ear",
    "right_ear",
    "mouth_left",
    "mouth_right",
    "left_shoulder",
    "right_shoulder",
    "left_elbow",
    "right_elbow",
    "left_wrist",
    "right_wrist",
    "left_pinky",
    "right_pinky",
    "left_index",
    "right_index",
    "left_thumb",
    "right_thumb",
    "left_hip",
    "right_hip",
    "left_knee",
    "right_knee",
    "left_ankle",
    "right_ankle",
    "left_heel",
    "right_heel",
    "left_foot_index",
    "right_foot_index",
)
KEYPOINTS = len(LANDMARKS)
INDEX: dict[str, int] = {name: index for index, name in enumerate(LANDMARKS)}
LEFT_HIP, RIGHT_HIP = INDEX["left_hip"], INDEX["right_hip"]

# MediaPipe's POSE_CONNECTIONS.
BONES: tuple[tuple[int, int], ...] = (
    *((0, 1), (1, 2), (2, 3), (3, 7), (0, 4), (4, 5), (5, 6), (6, 8), (9, 10)),
    *((11, 12), (11, 13), (13, 15), (15, 17), (15, 19), (15, 21), (17, 19)),
    *((12, 14), (14, 16), (16, 18), (16, 20), (16, 22), (18, 20)),
    *((11, 23), (12, 24), (23, 24), (23, 25), (25, 27), (27, 29), (29, 31), (27, 31)),
    *((24, 26), (26, 28), (28, 30), (30, 32), (28, 32)),
)


def _other_side(name: str) -> str:
    swapped = name.replace("left", "\0").replace("right", "left")
    return swapped.replace("\0", "right")


# MIRROR[i] is the landmark that i becomes in a mirror; its own inverse.
MIRROR = np.array([INDEX[_other_side(name)] for name in LANDMARKS])

HEAD = np.arange(0, 11)
LEFT_ARM = np.array([13, 15, 17, 19, 21])
RIGHT_ARM = LEFT_ARM + 1
LEFT_LEG = np.array([25, 27, 29, 31])
RIGHT_LEG = LEFT_LEG + 1
TORSO = np.array([11, 12, 23, 24])
ARMS = np.concatenate([[11, 12], LEFT_ARM, RIGHT_ARM])
LEGS = np.concatenate([[23, 24], LEFT_LEG, RIGHT_LEG])


def mid_hip(landmarks: np.ndarray) -> np.ndarray:
    """Mean of both hips, [..., 33, D] → [..., 1, D]: the origin of 3D poses."""
    return landmarks[..., [LEFT_HIP, RIGHT_HIP], :].mean(axis=-2, keepdims=True)

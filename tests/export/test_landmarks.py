"""The 33 landmarks made from recorded bodies, and the skeleton's own tables."""

import numpy as np

from deciwatch import skeleton
from deciwatch.data.augment import mirror
from deciwatch.motion.landmarks import JOINTS, SOURCES, landmarks_from_body
from deciwatch.motion.load import load_motions

RIGID = [("nose", "left_ear"), ("mouth_left", "right_eye_outer"), ("left_wrist", "left_index")]
RIGID += [("right_pinky", "right_thumb"), ("left_ankle", "left_heel"), ("left_hip", "left_knee")]
RIGID += [("right_knee", "right_ankle"), ("left_shoulder", "left_elbow"), ("left_hip", "right_hip")]


def test_the_tables_are_whole():
    assert skeleton.KEYPOINTS == 33 and set(SOURCES) == set(skeleton.LANDMARKS)
    assert (skeleton.MIRROR[skeleton.MIRROR] == np.arange(33)).all()
    assert skeleton.MIRROR[0] == 0 and np.unique(skeleton.MIRROR).size == 33
    pairs = {tuple(sorted(bone)) for bone in skeleton.BONES}
    assert len(pairs) == len(skeleton.BONES) == 35
    mirrored = {tuple(sorted(skeleton.MIRROR[list(bone)])) for bone in pairs}
    assert mirrored == pairs
    assert {source.kind for source in SOURCES.values()} == {"measured", "data", "offset"}


def test_a_t_pose_gives_a_symmetric_body():
    joints = np.zeros((1, 24, 3))
    for joint, place in {
        "hip": (0.1, 1.0, 0),
        "knee": (0.1, 0.5, 0),
        "ankle": (0.1, 0.1, 0),
        "toe": (0.1, 0, 0.1),
        "shoulder": (0.2, 1.4, 0),
        "elbow": (0.5, 1.4, 0),
        "wrist": (0.75, 1.4, 0),
        "eye": (0.03, 1.6, 0.1),
        "ear": (0.07, 1.6, 0),
    }.items():
        for side, sign in (("l", 1), ("r", -1)):
            joints[0, JOINTS.index(f"{side}_{joint}")] = np.array(place) * [sign, 1, 1]
    joints[0, JOINTS.index("nose")] = (0, 1.55, 0.12)
    landmarks = landmarks_from_body(joints, np.zeros((1, 22, 3)))
    np.testing.assert_allclose(mirror(landmarks), landmarks, atol=1e-6)
    at = {name: landmarks[0, index] for name, index in skeleton.INDEX.items()}
    assert at["left_index"][0] > at["left_wrist"][0] > at["left_elbow"][0] > 0
    assert at["left_thumb"][2] > at["left_index"][2] > at["left_pinky"][2]
    assert at["left_heel"][2] < 0 < at["left_foot_index"][2]
    assert at["mouth_left"][0] > at["mouth_right"][0]


def test_bones_keep_their_length_and_people_stand_on_the_floor(data):
    motions = load_motions(data, "val")
    for index in range(0, len(motions.length), 5):
        poses = motions.sequence(index)
        for first, second in RIGID:
            ends = poses[:, [skeleton.INDEX[first], skeleton.INDEX[second]]]
            length = np.linalg.norm(ends[:, 0] - ends[:, 1], axis=-1)
            assert length.std() < 0.0015, (motions.names[index], first, second)
        assert -0.05 < np.percentile(poses[:, :, 1].min(axis=1), 5) < 0.08

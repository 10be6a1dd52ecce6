"""Rendered pairs: the avatar's bones, the camera, the plan, the pair file; and one real clip."""

import json
import struct
from dataclasses import replace

import numpy as np
import pytest

from deciwatch.errors import UserError
from deciwatch.motion.cmu import Bodies
from deciwatch.motion.landmarks import SMPL_JOINTS
from deciwatch.pairs.cameras import draw_camera
from deciwatch.pairs.plan import plan
from deciwatch.pairs.points import POINTS, landmarks
from deciwatch.pairs.rig import BONES, local_matrices, pose_rig, read_rig
from deciwatch.pairs.store import assemble
from deciwatch.rotations import axis_angle
from deciwatch.skeleton import INDEX

# Bone: parent, head in metres (left side; the right mirrors it).
DOLL = {
    "Hips": (None, (0, 1, 0)),
    "Spine": ("Hips", (0, 1.1, 0)),
    "Spine1": ("Spine", (0, 1.2, 0)),
    "Spine2": ("Spine1", (0, 1.3, 0)),
    "Neck": ("Spine2", (0, 1.5, 0)),
    "Head": ("Neck", (0, 1.6, 0)),
    "LeftEye": ("Head", (0.03, 1.65, 0.1)),
    "LeftShoulder": ("Spine2", (0.05, 1.45, 0)),
    "LeftArm": ("LeftShoulder", (0.2, 1.45, 0)),
    "LeftForeArm": ("LeftArm", (0.45, 1.40, 0)),  # hangs a little: has to be aligned
    "LeftHand": ("LeftForeArm", (0.70, 1.40, 0)),
    "LeftHandPinky1": ("LeftHand", (0.78, 1.40, -0.02)),
    "LeftHandIndex1": ("LeftHand", (0.78, 1.40, 0.03)),
    "LeftHandThumb2": ("LeftHand", (0.74, 1.38, 0.05)),
    "LeftUpLeg": ("Hips", (0.1, 0.95, 0)),
    "LeftLeg": ("LeftUpLeg", (0.1, 0.5, 0)),
    "LeftFoot": ("LeftLeg", (0.1, 0.1, 0)),
    "LeftToeBase": ("LeftFoot", (0.1, 0.03, 0.13)),
}


def write_doll(path, leave_out=()):
    """A .glb with nothing but the doll's nodes."""
    bones = {}
    for name, (parent, (x, y, z)) in DOLL.items():
        bones[name] = (parent, np.array([x, y, z], float))
        if name.startswith("Left"):
            right = (parent or "").replace("Left", "Right")
            bones[name.replace("Left", "Right")] = (right, np.array([-x, y, z], float))
    names = [name for name in bones if name not in leave_out]
    nodes = []
    for name in names:
        parent, head = bones[name]
        origin = bones[parent][1] if parent in bones else np.zeros(3)
        children = [i for i, other in enumerate(names) if bones[other][0] == name]
        nodes.append({"name": name, "translation": (head - origin).tolist(), "children": children})
    content = json.dumps({"asset": {"version": "2.0"}, "nodes": nodes}).encode()
    content += b" " * (-len(content) % 4)
    header = struct.pack("<4sII", b"glTF", 2, 20 + len(content))
    path.write_bytes(header + struct.pack("<I4s", len(content), b"JSON") + content)
    return path


@pytest.fixture
def rig(tmp_path):
    return read_rig(write_doll(tmp_path / "doll.glb"))


def posed(rig, **turns):
    """World matrices of one frame with some joints' rotations from rest to world."""
    rotations = np.broadcast_to(np.eye(3), (1, 22, 3, 3)).copy()
    for joint, vector in turns.items():
        rotations[0, SMPL_JOINTS.index(joint)] = axis_angle(np.array(vector, float))
    return pose_rig(rig, rotations, np.array([[0.0, 2.0, 0.0]]))


def test_the_rest_pose_becomes_the_motions_t_pose(rig):
    world = posed(rig)[0, :, :3, 3]
    shoulder, elbow, hand = (world[rig.index(f"Left{b}")] for b in ("Arm", "ForeArm", "Hand"))
    upper = np.hypot(0.25, 0.05)
    np.testing.assert_allclose(shoulder, [0.2, 2.45, 0], atol=1e-9)
    np.testing.assert_allclose(elbow - shoulder, [upper, 0, 0], atol=1e-9)
    np.testing.assert_allclose(hand - elbow, [0.25, 0, 0], atol=1e-9)


def test_a_joint_turns_its_limb_and_nothing_else(rig):
    bent = posed(rig, l_elbow=[0, 0, np.pi / 2], l_wrist=[0, 0, np.pi / 2])
    still = posed(rig)
    elbow = bent[0, rig.index("LeftForeArm"), :3, 3]
    np.testing.assert_allclose(
        bent[0, rig.index("LeftHand"), :3, 3] - elbow, [0, 0.25, 0], atol=1e-9
    )
    same = [rig.index(name) for name in rig.names if not name.startswith(("LeftHand", "LeftFore"))]
    np.testing.assert_allclose(bent[0, same], still[0, same], atol=1e-9)
    points = landmarks(rig, bent)[0]
    # The index knuckle was 8 cm out along x and 3 cm forward; now it is 8 cm up.
    hand = points[INDEX["left_wrist"]]
    np.testing.assert_allclose(points[INDEX["left_index"]] - hand, [0, 0.08, 0.03], atol=1e-9)


def test_local_matrices_rebuild_the_pose(rig):
    world = posed(rig, pelvis=[0.3, 1, 0], l_knee=[1, 0.2, 0], head=[0, 0.5, 0.2])
    names, local = local_matrices(rig, world)
    assert set(names) == set(BONES.values())
    for name in ("LeftFoot", "Head", "RightHand"):
        matrix, node = np.eye(4), rig.index(name)
        while node >= 0:
            moved = rig.names[node] in names
            step = local[0, names.index(rig.names[node])] if moved else rig.local[node]
            matrix, node = step @ matrix, rig.parents[node]
        np.testing.assert_allclose(matrix, world[0, rig.index(name)], atol=1e-9)


def test_every_landmark_has_a_point_and_both_sides_mirror(rig):
    assert set(POINTS) == set(INDEX)
    points = landmarks(rig, posed(rig))[0]
    left, right = points[INDEX["left_heel"]], points[INDEX["right_heel"]]
    np.testing.assert_allclose(left * [-1, 1, 1], right, atol=1e-9)


def test_files_that_are_no_avatar_are_refused(tmp_path):
    (tmp_path / "no.glb").write_bytes(b"not a model at all, but long enough")
    with pytest.raises(UserError, match="not a binary glTF"):
        read_rig(tmp_path / "no.glb")
    headless = read_rig(write_doll(tmp_path / "headless.glb", leave_out=("LeftHand",)))
    with pytest.raises(UserError, match="no bone LeftHand"):
        posed(headless)


def test_the_camera_sees_the_person_and_projects_as_its_matrix_says():
    rng = np.random.default_rng(3)
    body = rng.uniform([-0.4, 0, -0.3], [0.4, 1.7, 0.3], size=(50, 33, 3))
    inside = []
    for _ in range(40):
        camera = draw_camera(rng, body)
        pixels = camera.project(body)
        inside.append(((pixels >= 0) & (pixels <= [camera.width, camera.height])).all(-1).mean())
    assert np.median(inside) == 1 and min(inside) > 0.3
    point = np.append(body[7, 3], 1)
    x, y, z, _ = np.linalg.inv(camera.matrices()[7]) @ point
    middle, focal = np.array([camera.width, camera.height]) / 2, camera.focal
    np.testing.assert_allclose(pixels[7, 3], middle + focal * np.array([x, -y]) / -z, rtol=1e-9)
    angle = np.radians(camera.field_of_view / 2)
    assert np.isclose(np.tan(angle), camera.height / 2 / focal)


def some_bodies():
    lengths = np.array([50, 300, 1000, 41])
    total = int(lengths.sum())
    start = np.concatenate([[0], np.cumsum(lengths)[:-1]])
    return Bodies(
        np.zeros((total, 24, 3)), np.zeros((total, 22, 3)), start, lengths, ("a", "b", "c", "d")
    )


def test_a_longer_plan_begins_with_the_shorter_one():
    short, long = (plan(some_bodies(), ["x", "y"], n, False, 5) for n in (300, 2000))
    assert long[: len(short)] == short
    assert sum(len(clip.estimated) for clip in long) >= 2000
    assert {clip.stride for clip in long} == {1, 3, 4, 5}
    for clip in long:
        assert clip.first >= 0 and clip.first + clip.length <= some_bodies().length[clip.sequence]
    assert {clip.stride for clip in plan(some_bodies(), ["x"], 500, True, 5)} == {1}


def test_a_pair_file_has_nan_where_nothing_was_estimated(tmp_path):
    truth = np.arange(5 * 33 * 3, dtype=np.float32).reshape(5, 33, 3)
    common = {"gt": truth, "gt_2d": truth[..., :2], "box": np.zeros((5, 4)), "frames": [0, 3]}
    common |= {"size": np.array([4, 3]), "field_of_view": 40.0, "camera": np.zeros((5, 3, 4))}
    common |= {"avatar": "x", "sequence": 1}
    seen = {"full_3d": truth[[0, 3]], "full_2d": truth[[0, 3], :, :2]}
    seen |= {"full_scores": np.ones((2, 33)), "full_ms": np.array([7, 8])}
    np.savez(tmp_path / "a.npz", **common, **seen)
    np.savez(tmp_path / "b.npz", **common)
    whole = assemble([tmp_path / "a.npz", tmp_path / "b.npz", tmp_path / "a.npz"], "full", "pq")
    assert whole["start"].tolist() == [0, 5] and whole["names"].tolist() == ["q/a", "q/a"]
    assert whole["estimated"].tolist() == [True, False, False, True, False] * 2
    np.testing.assert_array_equal(np.isfinite(whole["pred"][:, 0, 0]), whole["estimated"])
    np.testing.assert_array_equal(whole["pred"][8], truth[3])
    assert assemble([tmp_path / "b.npz"], "full", "pq") is None


def test_a_real_clip_is_drawn_and_estimated_close_to_the_truth(data, tmp_path):
    """The renderer itself, in headless Chromium, with the estimator that the page ships."""
    from deciwatch.motion.cmu import read_shard
    from deciwatch.pairs.command import AVATARS
    from deciwatch.pairs.renderer import Renderer
    from deciwatch.pairs.scenes import stage

    avatars = AVATARS / "test"
    if not avatars.is_dir():
        pytest.skip(f"needs the avatars, which are not at {avatars}")
    bodies = read_shard(data, "test")
    names = sorted(path.name for path in avatars.glob("*.glb"))
    clip = replace(plan(bodies, names, 1, True, 3)[0], stride=40)
    scene = stage(bodies, clip, avatars)
    with Renderer(avatars, tmp_path / "work") as renderer:
        found, pictures = renderer.draw(scene, ["lite"], [0])
    seen, watched = found["lite"], clip.estimated
    assert pictures[0].startswith(b"\xff\xd8")
    off = np.linalg.norm(seen.poses_3d - scene.truth_3d[watched], axis=-1).mean(axis=1)
    assert np.nanmedian(off) < 0.25
    pixels = np.linalg.norm(seen.poses_2d - scene.truth_2d[watched], axis=-1).mean(axis=1)
    assert np.nanmedian(pixels) < 0.15 * np.ptp(scene.truth_2d[watched], axis=1).max()
    assert not (tmp_path / "work").exists()

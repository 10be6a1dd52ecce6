"""Bodies from the CMU database's own files: ASF/AMC, the cgspeed BVH and the Daz BVH.

The same 24 joints as the shards, metres, y up, floor at y = 0; see tests/export/test_raw.py for
how closely they agree with them (0.3 mm at most).
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from deciwatch.errors import UserError
from deciwatch.motion import asf_amc, bvh
from deciwatch.motion.landmarks import FRAMES, JOINTS, landmarks_from_frames

# Joint names of each flavour in the order of _MEASURED.
_MEASURED = (
    *("r_hip", "r_knee", "r_ankle", "l_hip", "l_knee", "l_ankle", "thorax", "neck"),
    *("l_shoulder", "l_elbow", "l_wrist", "r_shoulder", "r_elbow", "r_wrist", "l_toe", "r_toe"),
)
_AMC = (
    *("rhipjoint", "rfemur", "rtibia", "lhipjoint", "lfemur", "ltibia", "thorax", "upperneck"),
    *("lclavicle", "lhumerus", "lradius", "rclavicle", "rhumerus", "rradius", "lfoot", "rfoot"),
)
_CGSPEED = (
    *("RightUpLeg", "RightLeg", "RightFoot", "LeftUpLeg", "LeftLeg", "LeftFoot", "Neck", "Head"),
    *("LeftArm", "LeftForeArm", "LeftHand", "RightArm", "RightForeArm", "RightHand"),
    *("LeftToeBase", "RightToeBase"),
)
_DAZ = (
    *("rThigh", "rShin", "rFoot", "lThigh", "lShin", "lFoot", "neck", "head"),
    *("lShldr", "lForeArm", "lHand", "rShldr", "rForeArm", "rHand", "lFoot_end", "rFoot_end"),
)
# In the head's axes, metres, from the middle between neck and the top of the head.
_FACE = {
    "nose": (0.0, -0.010, 0.115),
    "l_eye": (0.033, 0.025, 0.095),
    "r_eye": (-0.033, 0.025, 0.095),
    "l_ear": (0.075, 0.005, 0.005),
    "r_ear": (-0.075, 0.005, 0.005),
}
_DAZ_HEAD = 0.19  # metres from the neck's end to the top; the Daz files have no joint there
_SOLE = 0.03  # metres of the lowest foot joint above the floor


@dataclass(frozen=True)
class Body:
    """One recording: joints [F, 24, 3] in JOINTS order, FRAMES' rotations [F, 3, 3], rate."""

    joints: np.ndarray
    frames: dict[str, np.ndarray]
    fps: float


def read_body(path: Path, asf: Path | None = None) -> Body:
    """Read a .bvh, or an .amc with its skeleton (default: SUBJECT.asf beside SUBJECT_TRIAL.amc).

    Raises UserError if a file is missing, damaged, or not of a known flavour.
    """
    path = Path(path)
    if path.suffix.lower() == ".amc":
        return _from_amc(path, asf or path.with_name(path.stem.split("_")[0] + ".asf"))
    if path.suffix.lower() != ".bvh":
        raise UserError(f"{path} is neither .bvh nor .amc; give one of those.")
    file = bvh.read_bvh(path)
    if set(_CGSPEED) <= file.joints.keys():
        return _from_cgspeed(file)
    if set(_DAZ) <= file.joints.keys():
        return _from_daz(file)
    raise UserError(f"{path} has neither the cgspeed nor the Daz joint names; use one of those.")


def _from_amc(path: Path, asf: Path) -> Body:
    bones = asf_amc.read_asf(asf)
    missing = set(_AMC) - bones.keys()
    if missing:
        raise UserError(f"{asf} has no bone {min(missing)!r}; give a CMU skeleton.")
    places, turns = asf_amc.pose(bones, asf_amc.read_amc(path, bones))
    places = {name: place * asf_amc.METRES_PER_UNIT for name, place in places.items()}
    joints = dict(zip(_MEASURED, (places[name] for name in _AMC), strict=True))
    joints["head"] = places["head"]
    joints["spine"] = (places["lowerback"] + places["upperback"]) / 2
    names = ("head", "lwrist", "rwrist", "lfoot", "rfoot")
    return _body(joints, [turns[name] for name in names], asf_amc.FPS)


def _from_cgspeed(file: bvh.Bvh) -> Body:
    places, turns = bvh.pose(file)
    places = {name: place * asf_amc.METRES_PER_UNIT for name, place in places.items()}
    joints = dict(zip(_MEASURED, (places[name] for name in _CGSPEED), strict=True))
    joints["head"] = places["Head_end"]
    joints["spine"] = (places["Spine"] + places["Spine1"]) / 2
    # The conversion dropped the thorax bone, a straight one as long as the bone below it (12 cm):
    # everything from the thorax up moves by it.
    length = np.linalg.norm(file.joints["Spine1"].offset) * asf_amc.METRES_PER_UNIT
    thorax = turns["Spine1"] @ np.array([0.0, length, 0.0])
    for name in ("thorax", "neck", "head"):
        joints[name] = joints[name] + thorax
    for name in ("shoulder", "elbow", "wrist"):
        for side in "lr":
            joints[f"{side}_{name}"] = joints[f"{side}_{name}"] + thorax
    names = ("Head", "LeftHand", "RightHand", "LeftFoot", "RightFoot")
    # The first frame is the T-pose, not the recording.
    return _body(joints, [turns[name] for name in names], file.fps, skip=1)


def _from_daz(file: bvh.Bvh) -> Body:
    places, turns = bvh.pose(file)
    places = {name: place * 0.01 for name, place in places.items()}
    joints = dict(zip(_MEASURED, (places[name] for name in _DAZ), strict=True))
    joints["head"] = joints["neck"] + turns["head"] @ np.array([0.0, _DAZ_HEAD, 0.0])
    joints["spine"] = (places["abdomen"] + places["chest"]) / 2
    hands = []
    for side, out in (("l", 1.0), ("r", -1.0)):
        # At rest these forearms point forwards; turn the hand's axes to a straight arm's.
        forearm = file.joints[f"{side}Hand"].offset
        hands.append(turns[f"{side}Hand"] @ _between(np.array([out, 0.0, 0.0]), forearm))
    frames = [turns["head"], *hands, turns["lFoot"], turns["rFoot"]]
    # A rest pose and one frame more, as in the shards.
    return _body(joints, frames, file.fps, skip=2)


def _between(start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """The smallest rotation from one direction to another, not opposite, one."""
    start, end = start / np.linalg.norm(start), end / np.linalg.norm(end)
    x, y, z = np.cross(start, end)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + cross + cross @ cross / (1 + start @ end)


def _body(joints: dict[str, np.ndarray], frames: list, fps: float, skip: int = 0) -> Body:
    joints["pelvis"] = (joints["l_hip"] + joints["r_hip"]) / 2
    middle = (joints["neck"] + joints["head"]) / 2
    for name, offset in _FACE.items():
        joints[name] = middle + frames[0] @ np.array(offset)
    stacked = np.stack([joints[name] for name in JOINTS], axis=1)[skip:]
    # Set down on the floor: a low percentile, since single frames may dip below it.
    floor = np.percentile(stacked[:, :, 1].min(axis=1), 2) - _SOLE
    start = stacked[0, 0] * [1, 0, 1] + [0, floor, 0]
    turned = {name: turn[skip:] for name, turn in zip(FRAMES, frames, strict=True)}
    return Body((stacked - start).astype(np.float32), turned, fps)


def landmarks(body: Body, fps: float = 30.0) -> np.ndarray:
    """Landmarks [F, 33, 3] of a recording at another frame rate, blended between its frames."""
    return resample(landmarks_from_frames(body.joints, body.frames), body.fps, fps)


def resample(values: np.ndarray, old: float, new: float) -> np.ndarray:
    """Positions [F, ...] at frame rate `old` → at `new`; exact where frames coincide."""
    # BVH files give the frame time to 7 digits: 120.0005 is 120.
    step = round(old / new, 3)
    places = np.arange(int((len(values) - 1) / step) + 1) * step
    left = np.minimum(places.astype(int), max(len(values) - 2, 0))
    part = (places - left).reshape(-1, *[1] * (values.ndim - 1)).astype(values.dtype)
    right = np.minimum(left + 1, len(values) - 1)
    return values[left] * (1 - part) + values[right] * part

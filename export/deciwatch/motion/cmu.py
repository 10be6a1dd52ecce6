"""Reader of the CMU shards cmu30_{train,val,test}.npz and their *_rot.npz.

Source: CMU Graphics Lab Motion Capture Database, mocap.cs.cmu.edu, created with funding from
NSF EIA-0196217. Metres, y up, 30 frames a second, floor at y = 0.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from deciwatch.errors import UserError
from deciwatch.motion.landmarks import JOINTS, landmarks_from_body
from deciwatch.motion.motions import Motions


@dataclass(frozen=True)
class Bodies:
    """A shard as stored: joints [F, 24, 3] metres in JOINTS order, aa [F, 22, 3] in SMPL order."""

    joints: np.ndarray
    axis_angles: np.ndarray
    start: np.ndarray
    length: np.ndarray
    names: tuple[str, ...]


def read_shard(directory: Path, split: str) -> Bodies:
    """One split, "train", "val" or "test". Raises UserError if it is missing or damaged."""
    paths = [Path(directory) / f"cmu30_{split}{part}.npz" for part in ("", "_rot")]
    for path in paths:
        if not path.is_file():
            raise UserError(f"{path} is missing; point --data at a folder with the CMU shards.")
    try:
        with np.load(paths[0]) as positions, np.load(paths[1]) as rotations:
            root, rel = positions["root"], positions["rel"].astype(np.float32)
            joints = np.concatenate([root[:, None], root[:, None] + rel], axis=1)
            names = tuple(str(name) for name in positions["name"])
            bodies = Bodies(
                joints=joints,
                axis_angles=rotations["aa"].astype(np.float32),
                start=positions["start"],
                length=positions["length"],
                names=names,
            )
            same = tuple(positions["joints"]) == JOINTS and np.array_equal(
                positions["name"], rotations["name"]
            )
    except (KeyError, OSError, ValueError) as error:
        raise UserError(
            f"{paths[0]} cannot be read as a CMU shard ({error}); fetch it again."
        ) from error
    if not same or len(bodies.axis_angles) != len(joints):
        raise UserError(f"{paths[0]} and {paths[1].name} do not belong together; fetch both again.")
    return bodies


def shard_motions(directory: Path, split: str) -> Motions:
    """The 33 landmarks of every sequence of a split."""
    bodies = read_shard(directory, split)
    landmarks = landmarks_from_body(bodies.joints, bodies.axis_angles)
    landmarks.setflags(write=False)
    return Motions(landmarks, bodies.start, bodies.length, bodies.names)

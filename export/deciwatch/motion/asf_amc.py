"""Acclaim skeletons (.asf) and motions (.amc), as the CMU database gives them.

Lengths stay in the files' own unit, inches over the header's `length` factor of 0.45; times
METRES_PER_UNIT they are metres. y up.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from deciwatch.errors import UserError
from deciwatch.rotations import euler

FPS = 120.0  # CMU's capture rate; the files do not say
METRES_PER_UNIT = 0.056444


@dataclass(frozen=True)
class Bone:
    """One bone: parent name, direction × length in world axes at rest, own axes, free angles."""

    parent: str
    offset: np.ndarray
    axes: np.ndarray
    freedoms: tuple[str, ...]


def read_asf(path: Path) -> dict[str, Bone]:
    """Bones by name, every parent before its children. Raises UserError if it is no ASF."""
    bones: dict[str, dict] = {}
    parents: dict[str, str] = {}
    section, current = "", {}
    try:
        for line in _lines(path):
            word, *rest = line.split()
            if word.startswith(":"):
                section = word
            elif section == ":bonedata" and word == "begin":
                current = {"dof": ()}
            elif section == ":bonedata" and word == "end":
                bones[current["name"]] = current
            elif section == ":bonedata" and word == "name":
                current["name"] = rest[0]
            elif section == ":bonedata" and word == "dof":
                current["dof"] = tuple(name.lower() for name in rest)
            elif section == ":bonedata" and word in ("direction", "length", "axis"):
                current[word] = np.array([float(x) for x in rest[:3]])
                current["order"] = rest[3].lower() if len(rest) > 3 else "xyz"
            elif section == ":hierarchy" and word not in ("begin", "end"):
                parents |= dict.fromkeys(rest, word)
        return {name: _bone(bones[name], parent) for name, parent in parents.items()}
    except (KeyError, IndexError, ValueError) as error:
        raise UserError(f"{path} cannot be read as an ASF skeleton ({error}).") from error


def _bone(entry: dict, parent: str) -> Bone:
    # An ASF applies a bone's axis angles in the order written: x first means Rz·Ry·Rx.
    axes = euler(np.radians(entry["axis"][::-1]), entry["order"][::-1])
    return Bone(parent, entry["direction"] * entry["length"][0], axes, entry["dof"])


def read_amc(path: Path, bones: dict[str, Bone]) -> dict[str, np.ndarray]:
    """Numbers of every frame: "root" [F, 6] and each bone's free angles [F, n] in degrees."""
    frames: list[dict[str, list[float]]] = []
    for line in _lines(path):
        word, *rest = line.split()
        if word.startswith(":"):
            continue
        if not rest and word.isdigit():
            frames.append({})
        elif frames:
            try:
                frames[-1][word] = [float(x) for x in rest]
            except ValueError as error:
                raise UserError(f"{path} cannot be read as an AMC motion ({error}).") from error
    freedoms = {name: len(bone.freedoms) for name, bone in bones.items() if bone.freedoms}
    try:
        return {
            name: np.array([frame[name] for frame in frames]).reshape(len(frames), count)
            for name, count in ({"root": 6} | freedoms).items()
        }
    except (KeyError, ValueError) as error:
        raise UserError(
            f"{path} does not fit its skeleton ({error}); give it its own .asf."
        ) from error


def pose(
    bones: dict[str, Bone], motion: dict[str, np.ndarray]
) -> tuple[dict[str, np.ndarray], dict[str, np.ndarray]]:
    """Of "root" and every bone: its far end [F, 3] in file units, its rotation from rest [F, 3, 3].

    The skeleton's rest pose is a T-pose with the legs spread; axes are the world's.
    """
    root = motion["root"]
    rotations = {"root": euler(np.radians(root[:, [5, 4, 3]]), "zyx")}
    ends = {"root": root[:, :3]}
    for name, bone in bones.items():
        turn = rotations[bone.parent]
        if bone.freedoms:
            angles = np.zeros((len(root), 3))
            for column, freedom in enumerate(bone.freedoms):
                angles[:, "xyz".index(freedom[-1])] = motion[name][:, column]
            local = euler(np.radians(angles[:, ::-1]), "zyx")
            turn = turn @ bone.axes @ local @ bone.axes.T
        rotations[name] = turn
        ends[name] = ends[bone.parent] + turn @ bone.offset
    return ends, rotations


def _lines(path: Path) -> list[str]:
    """Lines that hold anything but a comment. Raises UserError if the file cannot be read."""
    try:
        lines = Path(path).read_text(errors="replace").splitlines()
    except OSError as error:
        raise UserError(f"{path} cannot be read ({error.strerror}).") from error
    kept = (line.split("#")[0].strip() for line in lines)
    return [line for line in kept if line]

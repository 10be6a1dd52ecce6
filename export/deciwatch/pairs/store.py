"""Clips that are done, one small file each, and the pair file that they make together."""

from pathlib import Path

import numpy as np

from deciwatch.atomic import write_npz
from deciwatch.pairs.renderer import Estimates
from deciwatch.pairs.scenes import Scene

FPS = 30.0


def save_clip(path: Path, scene: Scene, found: dict[str, Estimates]) -> None:
    """Write a clip's truth and estimates."""
    content = {
        "gt": scene.truth_3d,
        "gt_2d": scene.truth_2d,
        "box": scene.box.astype(np.float32),
        "frames": scene.clip.estimated,
        "size": np.array([scene.camera.width, scene.camera.height]),
        "field_of_view": np.float32(scene.camera.field_of_view),
        "camera": scene.camera.matrices()[:, :3].astype(np.float32),
        "avatar": np.array(scene.clip.avatar),
        "sequence": np.array(scene.clip.sequence),
    }
    for name, seen in found.items():
        content |= {f"{name}_3d": seen.poses_3d, f"{name}_2d": seen.poses_2d}
        content |= {f"{name}_scores": seen.scores, f"{name}_ms": seen.ms}
    write_npz(path, content)


def assemble(clips: list[Path], estimator: str, movements: tuple[str, ...]) -> dict | None:
    """The pair file (docs/pair-file.md) of the clips that `estimator` has seen; None without any.

    `movements` are the names of the recorded sequences.
    """
    rows: dict[str, list] = {}
    for path in clips:
        with np.load(path) as clip:
            if f"{estimator}_3d" not in clip:
                continue
            frames, count = clip["frames"], len(clip["gt"])
            estimated = np.zeros(count, dtype=bool)
            estimated[frames] = True

            def spread(values: np.ndarray, count: int = count, frames: np.ndarray = frames):
                whole = np.full((count, *values.shape[1:]), np.nan, dtype=np.float32)
                whole[frames] = values
                return whole

            row = {
                "pred": spread(clip[f"{estimator}_3d"]),
                "pred_2d": spread(clip[f"{estimator}_2d"]),
                "scores": spread(clip[f"{estimator}_scores"]),
                "ms": spread(clip[f"{estimator}_ms"]),
                "gt": clip["gt"],
                "gt_2d": clip["gt_2d"],
                "box": clip["box"],
                "camera": clip["camera"],
                "estimated": estimated,
                "length": [count],
                "names": [f"{movements[int(clip['sequence'])]}/{path.stem}"],
                "avatar": [str(clip["avatar"])],
                "size": clip["size"][None],
                "field_of_view": [clip["field_of_view"]],
            }
        for key, value in row.items():
            rows.setdefault(key, []).append(value)
    if not rows:
        return None
    content = {key: np.concatenate(values) for key, values in rows.items()}
    content["start"] = np.concatenate([[0], np.cumsum(content["length"])[:-1]])
    content |= {"fps": np.array(FPS), "estimator": np.array(f"mediapipe-{estimator}")}
    return content


def truth_alone(scenes: list[Scene], movements: tuple[str, ...]) -> dict:
    """A pair file without estimates: the truth of clips that were not rendered."""
    length = np.array([len(scene.truth_3d) for scene in scenes])
    return {
        "gt": np.concatenate([scene.truth_3d for scene in scenes]),
        "gt_2d": np.concatenate([scene.truth_2d for scene in scenes]),
        "start": np.concatenate([[0], np.cumsum(length)[:-1]]),
        "length": length,
        "fps": np.array(FPS),
        "names": np.array([movements[scene.clip.sequence] for scene in scenes]),
    }

"""A contact sheet: rendered frames with the truth (green) and the estimate (red) drawn in."""

import io
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

from deciwatch.pairs.plan import Clip
from deciwatch.pairs.renderer import Renderer
from deciwatch.pairs.scenes import stage
from deciwatch.skeleton import BONES

COLUMNS, ROWS, CELL = 8, 5, 240


def draw_sheet(path: Path, bodies, clips: list[Clip], avatars: Path, work: Path, names) -> None:
    """Write a PNG of one frame each of clips spread over the plan."""
    from dataclasses import replace

    chosen = [clips[i] for i in np.linspace(0, len(clips) - 1, COLUMNS * ROWS).astype(int)]
    sheet = Image.new("RGB", (COLUMNS * CELL, ROWS * CELL), "white")
    with Renderer(avatars, work / "sheet") as renderer:
        for place, clip in enumerate(chosen):
            # Ten frames of each clip, of which the middle one is shown.
            clip = replace(clip, stride=max(clip.length // 10, 1))
            scene = stage(bodies, clip, avatars)
            middle = len(clip.estimated) // 2
            found, pictures = renderer.draw(scene, names[:1], [middle])
            seen = found[names[0]]
            image = Image.open(io.BytesIO(pictures[0])).convert("RGB")
            pen = ImageDraw.Draw(image)
            _skeleton(pen, scene.truth_2d[clip.estimated[middle]], "lime")
            _skeleton(pen, seen.poses_2d[middle], "red")
            off = np.linalg.norm(seen.poses_3d - scene.truth_3d[clip.estimated], axis=-1)
            pen.text((4, 4), f"{clip.name} {1000 * np.nanmean(off):.0f} mm", fill="yellow")
            image.thumbnail((CELL, CELL))
            column, row = place % COLUMNS, place // COLUMNS
            sheet.paste(image, (column * CELL, row * CELL))
    path.parent.mkdir(parents=True, exist_ok=True)
    sheet.save(path)


def _skeleton(pen: ImageDraw.ImageDraw, points: np.ndarray, colour: str) -> None:
    if not np.isfinite(points).all():
        return
    for a, b in BONES:
        pen.line([tuple(points[a]), tuple(points[b])], fill=colour, width=1)

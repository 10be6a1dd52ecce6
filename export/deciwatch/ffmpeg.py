"""Runs ffmpeg, so that the same pictures give the same file on every run.

The program comes from the PyPI package `imageio-ffmpeg` (`requirements-bundles.txt`), whose pinned
version pins the encoders too; another ffmpeg makes clips that look the same but differ in bytes.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING

from deciwatch import atomic
from deciwatch.errors import UserError

if TYPE_CHECKING:
    import numpy as np

# No version strings, dates or random ids in the file; one thread, since x264 cuts its work by their
# number.
REPEATABLE = (
    *("-map_metadata", "-1", "-fflags", "+bitexact", "-flags", "+bitexact+cgop", "-threads", "1"),
)
# Decoders guess the colours of untagged video, each in its own way. A filter, since ffmpeg's own
# options for this are overridden by what the frames say of themselves.
COLOUR = "setparams=range=tv:color_primaries=bt709:color_trc=bt709:colorspace=bt709"
FASTSTART = ("-movflags", "+faststart")


def find_ffmpeg() -> str:
    """The ffmpeg of `imageio-ffmpeg`, else the system's."""
    try:
        import imageio_ffmpeg

        return imageio_ffmpeg.get_ffmpeg_exe()
    except (ImportError, RuntimeError):
        found = shutil.which("ffmpeg")
    if found is None:
        raise UserError("There is no ffmpeg here: pip install imageio-ffmpeg, or install one.")
    return found


def call(arguments: list[str], stdin: bytes | None = None) -> subprocess.CompletedProcess[bytes]:
    """Runs ffmpeg; its last line of complaint becomes the error's message."""
    command = [find_ffmpeg(), "-hide_banner", "-nostdin", "-y", *arguments]
    if stdin is not None:
        command.remove("-nostdin")
    done = subprocess.run(command, input=stdin, capture_output=True, check=False)
    if done.returncode != 0:
        lines = done.stderr.decode(errors="replace").strip().splitlines()
        raise UserError(f"ffmpeg failed: {lines[-1] if lines else 'no reason given'}")
    return done


def write(path: Path, inputs: list[str], outputs: list[str], stdin: bytes | None = None) -> None:
    """Encodes to `path`, which is there only when it is whole."""
    with tempfile.TemporaryDirectory() as folder:
        part = Path(folder) / path.name
        call(["-v", "error", *inputs, *outputs, str(part)], stdin)
        atomic.write_bytes(path, part.read_bytes())


def write_frames(path: Path, frames: np.ndarray, fps: int, outputs: list[str]) -> None:
    """Encodes `frames` (T, height, width, 3), uint8 RGB."""
    _, height, width, _ = frames.shape
    inputs = ["-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{width}x{height}", "-r", str(fps)]
    # Without this the scaler would take BT.601, whatever the file then claims.
    to_yuv = ["-vf", f"scale=out_color_matrix=bt709:out_range=tv,format=yuv420p,{COLOUR}"]
    if "-vf" in outputs:
        at = outputs.index("-vf") + 1
        to_yuv[1] += f",{outputs[at]}"
        outputs = [*outputs[: at - 1], *outputs[at + 1 :]]
    write(path, [*inputs, "-i", "pipe:0"], [*to_yuv, *outputs], frames.tobytes())


def read_frames(path: Path, width: int, height: int, filters: str = "null") -> np.ndarray:
    """Every frame of a video as (T, height, width, 3) uint8 RGB; the size is what `filters` give.

    Rotation metadata is not applied.
    """
    import numpy as np

    outputs = ["-vf", filters, "-fps_mode", "passthrough", "-f", "rawvideo", "-pix_fmt", "rgb24"]
    raw = call(["-v", "error", "-noautorotate", "-i", str(path), *outputs, "pipe:1"]).stdout
    return np.frombuffer(raw, np.uint8).reshape(-1, height, width, 3)


def read_times(path: Path) -> list[float]:
    """Presentation times of the decoded frames in seconds, from the file's own ticks."""
    outputs = ["-vf", "showinfo", "-fps_mode", "passthrough", "-f", "null", "-"]
    log = call(["-noautorotate", "-i", str(path), *outputs]).stderr.decode(errors="replace")
    base = re.search(r"config in time_base: (\d+)/(\d+)", log)
    if base is None:
        raise UserError(f"{path} has no video frame to read the time of.")
    tick = Fraction(int(base[1]), int(base[2]))
    return [float(int(pts) * tick) for pts in re.findall(r"n: *\d+ pts: *(-?\d+)", log)]

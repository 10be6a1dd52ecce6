"""The short clips under tests/fixtures, and `clips.json`, which says what is in each.

A barcode clip carries each frame's number in its picture, so that a test can tell which frame a
decoder really handed over: 8 columns over the full height, 20 px wide, most significant bit on the
left, white = 1, black = 0; 160 x 96 pixels. Frame k carries the number k.
"""

from __future__ import annotations

import json
import random
from pathlib import Path
from typing import TYPE_CHECKING, Any

from deciwatch import atomic, ffmpeg
from deciwatch.errors import UserError

if TYPE_CHECKING:
    import numpy as np

FPS = 30
BITS, COLUMN_WIDTH, HEIGHT = 8, 20, 96
WIDTH = BITS * COLUMN_WIDTH

X264 = ["-c:v", "libx264", "-pix_fmt", "yuv420p", "-preset", "slow", "-g", "20", "-crf", "20"]
# Left to itself x264 codes pictures as unlike as these without B-frames, and adds keyframes.
B_FRAMES = ["-bf", "2", "-x264-params", "b-adapt=0:b-pyramid=none:scenecut=0"]
NO_B_FRAMES = ["-bf", "0", "-x264-params", "scenecut=0"]
VP9 = ["-c:v", "libvpx-vp9", "-pix_fmt", "yuv420p", "-b:v", "0", "-crf", "30", "-g", "20"]
MP4 = [*ffmpeg.REPEATABLE, *ffmpeg.FASTSTART]

# gap.mp4: frames of the source in which the woman is clear of the tree and of the left edge, and a
# crop that holds her from the first to the last of them. She is away for the middle second, when
# the source's own first frames (nobody there yet) take the place of these.
GAP_FIRST, GAP_FRAMES, GAP_FROM, GAP_TO = 60, 105, 36, 69
GAP_CROP, GAP_SIZE = "crop=1240:512:290:480", (480, 198)


def write_fixtures(source: Path, folder: Path) -> None:
    """Writes every clip and `clips.json`. `source` is the demo video that the sample is cut from.

    Clips that can be decoded are read back, and their frame times in `clips.json` are those read.
    """
    makers = {
        "barcode.mp4": _write_barcode_mp4,
        "barcode.webm": _write_barcode_webm,
        "rotated.mp4": _write_rotated,
        "vfr.mp4": _write_vfr,
        "two-frames.mp4": _write_two_frames,
        "empty-room.mp4": _write_empty_room,
        "truncated.mp4": _write_truncated,
        "corrupt.mp4": _write_corrupt,
        "audio-only.mp4": _write_audio_only,
    }
    clips = {name: make(folder / name) for name, make in makers.items()}
    clips["gap.mp4"] = _write_gap(folder / "gap.mp4", source)
    barcode = {"bits": BITS, "columnWidth": COLUMN_WIDTH, "height": HEIGHT, "first": "left"}
    content = {"format": "deciwatch-test-clips/1", "barcode": barcode, "clips": clips}
    atomic.write_text(folder / "clips.json", _to_json(content))
    for name in clips:
        print(f"{folder / name}: {(folder / name).stat().st_size} bytes")


def barcode_frames(count: int) -> np.ndarray:
    """Frames 0..count-1, (count, 96, 160, 3) uint8."""
    import numpy as np

    numbers = np.arange(count)[:, None]
    bits = (numbers >> np.arange(BITS - 1, -1, -1)) & 1
    rows = np.repeat(bits.astype(np.uint8) * 255, COLUMN_WIDTH, axis=1)
    return np.broadcast_to(rows[:, None, :, None], (count, HEIGHT, WIDTH, 3)).copy()


def read_barcodes(frames: np.ndarray) -> list[int]:
    """The number each frame carries, by the brightness in the middle of each column."""
    centres = frames[:, HEIGHT // 2, COLUMN_WIDTH // 2 :: COLUMN_WIDTH, 1] > 127
    return [sum(int(bit) << (BITS - 1 - i) for i, bit in enumerate(row)) for row in centres]


def _write_barcode_mp4(path: Path) -> dict[str, Any]:
    """64 frames with B-frames, so that the order in the file is not the order on screen."""
    ffmpeg.write_frames(path, barcode_frames(64), FPS, [*X264, *B_FRAMES, *MP4])
    return _barcode_entry(path, 64, "H.264, two B-frames between references, GOP 20")


def _write_barcode_webm(path: Path) -> dict[str, Any]:
    """64 frames; WebM keeps times in whole milliseconds."""
    outputs = [*VP9, "-auto-alt-ref", "1", "-lag-in-frames", "16", *ffmpeg.REPEATABLE]
    ffmpeg.write_frames(path, barcode_frames(64), FPS, outputs)
    return _barcode_entry(path, 64, "VP9, GOP 20, times rounded to milliseconds")


def _write_rotated(path: Path) -> dict[str, Any]:
    """12 frames that a player must turn a quarter clockwise, as from a phone held upright."""
    upright = path.with_name(f".{path.name}.mp4")
    try:
        ffmpeg.write_frames(upright, barcode_frames(12), FPS, [*X264, *NO_B_FRAMES, *MP4])
        # ffmpeg counts counter-clockwise.
        ffmpeg.write(path, ["-display_rotation", "-90", "-i", str(upright)], ["-c", "copy", *MP4])
    finally:
        upright.unlink(missing_ok=True)
    about = "to be shown turned 90 degrees clockwise: 96 x 160, most significant bit on top"
    return _barcode_entry(path, 12, about) | {"rotationClockwise": 90}


def _write_vfr(path: Path) -> dict[str, Any]:
    """60 frames at the uneven times of a phone: jitter, dropped frames, one long pause."""
    rng = random.Random(20)
    times_ms, now = [], 0
    for frame in range(60):
        times_ms.append(now)
        now += 33 + rng.randint(-4, 4)
        now += 33 if frame % 9 == 8 else 0
        now += 220 if frame == 31 else 0
    steps = "+".join(f"{ms}*eq(N,{frame})" for frame, ms in enumerate(times_ms))
    outputs = ["-vf", f"settb=1/1000,setpts='{steps}'", "-fps_mode", "passthrough"]
    outputs += ["-enc_time_base", "1:1000", "-video_track_timescale", "1000"]
    ffmpeg.write_frames(path, barcode_frames(60), FPS, [*outputs, *X264, *NO_B_FRAMES, *MP4])
    entry = _barcode_entry(path, 60, "uneven frame times")
    if entry["times"] != [ms / 1000 for ms in times_ms]:
        raise UserError(f"{path.name} did not keep its frame times.")
    return entry


def _write_two_frames(path: Path) -> dict[str, Any]:
    ffmpeg.write_frames(path, barcode_frames(2), FPS, [*X264, *NO_B_FRAMES, *MP4])
    return _barcode_entry(path, 2, "the shortest clip that still moves")


def _write_empty_room(path: Path) -> dict[str, Any]:
    """20 frames of a lit wall above a floor, with film grain, and nobody in it."""
    import numpy as np

    rng = np.random.default_rng(7)
    height, width, count = 240, 320, 20
    y, x = np.mgrid[0:height, 0:width]
    wall = np.where(y < 170, 150 + 50 * x / width - 0.15 * y, 95 + 0.2 * y)
    room = wall[..., None] * np.array([1.0, 0.95, 0.88]) + rng.normal(0, 4, (height, width, 1))
    light = 1 + 0.03 * np.sin(np.arange(count) / 3)
    frames = np.clip(room[None] * light[:, None, None, None], 0, 255).astype(np.uint8)
    ffmpeg.write_frames(path, frames, FPS, [*X264, "-crf", "26", *NO_B_FRAMES, *MP4])
    return _entry(path, width, height, count, "nobody in it; no barcode")


def _write_truncated(path: Path) -> dict[str, Any]:
    """An index of 60 frames in front, and half the frames that it promises."""
    ffmpeg.write_frames(path, barcode_frames(60), FPS, [*X264, *NO_B_FRAMES, *MP4])
    whole = path.read_bytes()
    start = whole.index(b"mdat") + 4
    atomic.write_bytes(path, whole[: start + (len(whole) - start) // 2])
    times = ffmpeg.read_times(path)
    if read_barcodes(ffmpeg.read_frames(path, WIDTH, HEIGHT)) != list(range(len(times))):
        raise UserError(f"{path.name} does not carry its frame numbers.")
    return {
        "barcode": True,
        "about": "faststart, its media data cut off half way; no B-frames",
        "width": WIDTH,
        "height": HEIGHT,
        "framesInIndex": 60,
        # Those that are whole; the next one is cut.
        "frames": len(times),
        "times": times,
    }


def _write_corrupt(path: Path) -> dict[str, Any]:
    """An MP4 with its index at the end, cut in the middle: the index is lost."""
    outputs = [*X264, *NO_B_FRAMES, *ffmpeg.REPEATABLE]
    ffmpeg.write_frames(path, barcode_frames(60), FPS, outputs)
    whole = path.read_bytes()
    atomic.write_bytes(path, whole[: whole.index(b"moov") // 2])
    return {"about": "cut before its index: no reader can open it", "frames": 0, "times": []}


def _write_audio_only(path: Path) -> dict[str, Any]:
    tone = ["-f", "lavfi", "-i", "sine=frequency=440:duration=1:sample_rate=44100"]
    ffmpeg.write(path, tone, ["-c:a", "aac", "-b:a", "32k", *ffmpeg.REPEATABLE, *ffmpeg.FASTSTART])
    return {"about": "one second of a 440 Hz tone, no video track", "frames": 0, "times": []}


def _write_gap(path: Path, source: Path) -> dict[str, Any]:
    """The sample's woman, away for the middle second. See the constants above."""
    width, height = GAP_SIZE
    filters = f"{GAP_CROP},scale={width}:{height}:flags=area"
    everything = ffmpeg.read_frames(source, width, height, filters)
    frames = everything[GAP_FIRST : GAP_FIRST + GAP_FRAMES].copy()
    frames[GAP_FROM:GAP_TO] = everything[: GAP_TO - GAP_FROM]
    ffmpeg.write_frames(path, frames, FPS, [*X264, "-crf", "27", *MP4])
    about = "one person, gone from frame `from` up to, not including, frame `to`"
    return _entry(path, width, height, GAP_FRAMES, about) | {
        "gap": {"from": GAP_FROM, "to": GAP_TO},
    }


def _entry(path: Path, width: int, height: int, count: int, about: str) -> dict[str, Any]:
    """What `clips.json` says of a clip; size is as coded, before any rotation."""
    times = ffmpeg.read_times(path)
    if len(times) != count:
        raise UserError(f"{path.name} has {len(times)} frames, expected {count}.")
    return {"about": about, "width": width, "height": height, "frames": count, "times": times}


def _barcode_entry(path: Path, count: int, about: str) -> dict[str, Any]:
    entry = _entry(path, WIDTH, HEIGHT, count, about)
    if read_barcodes(ffmpeg.read_frames(path, WIDTH, HEIGHT)) != list(range(count)):
        raise UserError(f"{path.name} does not carry its frame numbers.")
    return entry | {"barcode": True}


def _to_json(content: dict[str, Any]) -> str:
    """Indented, but with each list of times on one line."""
    clips = content["clips"]
    marks = {f'"@{name}"': json.dumps(clip["times"]) for name, clip in clips.items()}
    marked = {name: clip | {"times": f"@{name}"} for name, clip in clips.items()}
    text = json.dumps(content | {"clips": marked}, indent=2) + "\n"
    for mark, times in marks.items():
        text = text.replace(mark, times)
    return text

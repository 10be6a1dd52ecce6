"""Tiny imported pairs for the web's tests: a folder that the page can load, and what torch gave."""

import json
import tempfile
from pathlib import Path

from deciwatch.atomic import write_text
from deciwatch.fixture_parity import flat
from deciwatch.official.check import reference_case
from deciwatch.official.config import OfficialConfig
from deciwatch.official.convert import write_pair
from deciwatch.official.read import read_state
from deciwatch.official.reference import random_reference
from deciwatch.official.write import save

_SMALL = {"heads": 4, "encoder_layers": 2, "decoder_layers": 2}
CONFIGS = {
    "3d": OfficialConfig(99, 10, 3, hidden=16, feed_forward=32, pre_norm=True, dims=3, **_SMALL),
    "2d": OfficialConfig(66, 5, 2, hidden=8, feed_forward=16, pre_norm=False, dims=2, **_SMALL),
}


def cases(seed: int) -> dict:
    """Each pair's inputs, and the outputs of the net as its authors run it, as flat arrays."""
    made = {}
    for name, config in CONFIGS.items():
        arrays = reference_case(random_reference(config, seed), seed)
        made[name] = {
            key: {"data": flat(array), "dims": list(array.shape)} for key, array in arrays.items()
        }
    return made


def write_official(folder: Path, seed: int) -> None:
    """Write checkpoints of random nets, import them into `folder`, and put the cases beside."""
    for name, config in CONFIGS.items():
        with tempfile.TemporaryDirectory() as temporary:
            path = Path(temporary) / f"random-{name}.pth.tar"
            save(path, random_reference(config, seed))
            write_pair(read_state(path), config, path, 1.0, folder)
    write_text(folder / "cases.json", json.dumps(cases(seed), separators=(",", ":")) + "\n")

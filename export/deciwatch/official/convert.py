"""Writes an imported pair where the page can load it."""

import tempfile
from pathlib import Path

from deciwatch import manifest
from deciwatch.atomic import write_bytes
from deciwatch.errors import UserError
from deciwatch.official.check import difference_from_reference
from deciwatch.official.config import OfficialConfig
from deciwatch.official.fit import fitting_weights
from deciwatch.official.pair import pair_of
from deciwatch.onnx_export import TOLERANCE, convert, largest_difference
from deciwatch.paths import MODELS
from deciwatch.skeleton import KEYPOINTS


def write_pair(
    given: dict[str, object], config: OfficialConfig, path: Path, scale: float, folder: Path
) -> float:
    """The state_dict `given` of the checkpoint `path` as two graphs and a manifest in `folder`.

    `scale`: metres that are 1 to the nets (3D). Returns the largest difference of the graphs from
    the authors' way of running the net. Raises UserError, with nothing written, if the weights do
    not fit or that difference is too large.
    """
    weights = fitting_weights(given, config, path)
    pair = pair_of(weights, config)
    graphs = convert(pair)
    worst = difference_from_reference(weights, config, graphs)
    anywhere = largest_difference(pair, graphs)
    if not (worst <= TOLERANCE and anywhere <= TOLERANCE):
        raise UserError(
            f"The graphs of {path} differ from torch by {worst:.1e} on windows like those of its "
            f"training and by {anywhere:.1e} on others, more than {TOLERANCE:.0e}, and nothing was "
            f"written; see whether its weights are those of a trained net."
        )
    with tempfile.TemporaryDirectory() as temporary:
        drafts = Path(temporary)
        for kind, graph in graphs.items():
            write_bytes(drafts / manifest.file_name(config.dims, kind), graph)
        entry = _entry(config, path, scale, drafts)
    for kind, graph in graphs.items():
        write_bytes(folder / manifest.file_name(config.dims, kind), graph)
    manifest.update(folder, entry, None)
    return worst


def _entry(config: OfficialConfig, path: Path, scale: float, drafts: Path) -> dict:
    training = {"data": f"imported from {path.name}, a checkpoint in the authors' format"}
    entry = manifest.describe_pair(config, training, drafts)
    entry |= {"interval": [config.interval] * 2, "intervals": [1, config.window_q]}
    if config.dims == 3:
        entry["normalisation"] = {"3d": {"kind": "scale", "scale": scale}}
    if config.keypoints != KEYPOINTS:
        entry |= {"skeleton": "unknown", "keypoints": config.keypoints}
    return entry


def complete(folder: Path, dims: int, models: Path = MODELS) -> bool:
    """Give `folder` the `dims`D pair of `models` if it has none, since the page wants both.

    Returns whether it was copied. Raises UserError where `models` lacks it.
    """
    name = f"{dims}d"
    if name in manifest.read(folder)["pairs"]:
        return False
    pairs = manifest.read(models)["pairs"]
    if name not in pairs:
        raise UserError(f"{models} has no {dims}D nets to go with the imported ones; export some.")
    for kind in manifest.KINDS:
        file = pairs[name][kind]["file"]
        write_bytes(folder / file, (models / file).read_bytes())
    manifest.update(folder, pairs[name], None)
    return True

"""`deciwatch export`: write a pair as ONNX files and enter it in the manifest."""

import argparse
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from deciwatch.paths import MODELS

if TYPE_CHECKING:
    from deciwatch.nets.forecast import ForecastNet


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("--dims", type=int, choices=(2, 3), default=3)
    parser.add_argument("--checkpoint", metavar="FILE", help="default: the committed one")
    parser.add_argument(
        "--keep", action="store_true", help="also make its weights the committed checkpoint"
    )
    parser.add_argument(
        "--forecast", metavar="FILE", help="its ForecastNet (default: the committed one if it fits)"
    )
    parser.add_argument("--out", metavar="DIR", default=str(MODELS))


def run(args: argparse.Namespace) -> int:
    """Export, check against torch, write. Nothing is written if the check fails."""
    from deciwatch import checkpoint, manifest
    from deciwatch.atomic import write_bytes
    from deciwatch.compact import compact
    from deciwatch.errors import UserError
    from deciwatch.onnx_export import (
        TOLERANCE,
        convert,
        convert_forecast,
        forecast_difference,
        largest_difference,
    )
    from deciwatch.storage import round_weights

    path = Path(args.checkpoint or checkpoint.default_path(args.dims))
    pair, content = checkpoint.load_pair(path, args.dims)
    forecast = _forecast(args, path)
    # `content` keeps the trained weights: those are committed, and training goes on from them.
    graphs = {kind: compact(graph) for kind, graph in convert(round_weights(pair)).items()}
    worst = largest_difference(pair, graphs)
    if forecast:
        net = round_weights(forecast[0])
        graphs[manifest.FORECAST] = compact(convert_forecast(net))
        worst = max(worst, forecast_difference(net, graphs[manifest.FORECAST]))
    if not worst <= TOLERANCE:
        raise UserError(
            f"The exported graphs of {path} differ from torch by {worst:.1e}, "
            f"more than {TOLERANCE:.0e}; nothing was written, look into the export."
        )
    # Described before anything is put in place, so that a failure leaves the old nets whole.
    with tempfile.TemporaryDirectory() as temporary:
        drafts = Path(temporary)
        for kind, graph in graphs.items():
            write_bytes(drafts / manifest.file_name(args.dims, kind), graph)
        entry = manifest.describe_pair(pair.config, _in_camel_case(content["training"]), drafts)
        if forecast:
            training = _in_camel_case(forecast[1]["training"])
            entry[manifest.FORECAST] = manifest.describe_forecast(training, drafts, args.dims)
    trained = sum(weight.numel() for weight in pair.parameters())
    counted = entry["denoise"]["parameters"] + entry["recover"]["parameters"]
    if trained != counted:
        raise RuntimeError(f"counted {counted} parameters in the graphs, torch has {trained}")
    folder = Path(args.out)
    for kind, graph in graphs.items():
        write_bytes(folder / manifest.file_name(args.dims, kind), graph)
    manifest.update(folder, entry, content["training"].get("commit"))
    if args.keep:
        kept = checkpoint.default_path(args.dims)
        checkpoint.save(kept, pair.config, content["weights"], content["training"])
        if forecast:
            kept = checkpoint.forecast_path(args.dims)
            net, content = forecast
            checkpoint.save(kept, net.config, content["weights"], content["training"])
    print(f"{args.dims}D nets in {folder}, within {worst:.1e} of torch")
    return 0


def _forecast(args: argparse.Namespace, path: Path) -> "tuple[ForecastNet, dict] | None":
    """The ForecastNet that was trained on this pair, and its checkpoint. Raises UserError.

    None where none is named and the committed one was trained on another.
    """
    from deciwatch import checkpoint
    from deciwatch.errors import UserError

    committed = checkpoint.forecast_path(args.dims)
    if not args.forecast and not committed.is_file():
        return None
    net, content = checkpoint.load_forecast(Path(args.forecast or committed), args.dims)
    if content["training"]["pair"] == checkpoint.digest(path):
        return net, content
    words = f"was trained on another pair than {path}; run `deciwatch train-forecast`"
    if args.forecast:
        raise UserError(f"{args.forecast} {words}.")
    print(f"{committed} {words}: live playback goes without looking ahead.")
    return None


def _in_camel_case(training: dict) -> dict:
    """The manifest's keys are camelCase, as its readers' are."""

    def camel(key: str) -> str:
        first, *rest = key.split("_")
        return first + "".join(part.capitalize() for part in rest)

    return {
        camel(key): _in_camel_case(value) if isinstance(value, dict) else value
        for key, value in training.items()
    }

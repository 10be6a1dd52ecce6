"""A trained pair as two ONNX graphs, checked against torch."""

import contextlib
import io
import logging
import tempfile
import warnings
from pathlib import Path

import numpy as np
import onnx
import onnxruntime
import torch
from torch import Tensor, nn

from deciwatch.nets.forecast import ForecastNet
from deciwatch.nets.pair import Pair

OPSET = 18
TOLERANCE = 1e-4
SIZES = ((2, 2), (2, 11), (3, 7), (4, 31), (11, 11), (11, 101), (11, 201), (14, 261), (1, 1))
NAMES = {
    "denoise": (("sampled", "sample_times"), ("clean", "features")),
    "recover": (("clean", "features", "sample_times", "frame_times"), ("poses",)),
}
FORECAST_NAMES = (("sampled", "sample_times", "frame_times"), ("poses",))


def example(pair: Pair, samples: int, frames: int, seed: int, even: bool = True) -> tuple:
    """Random sampled [1, S, I], sample_times [1, S], frame_times [1, T] for a check."""
    rng = np.random.default_rng(seed)
    times = np.arange(frames, dtype=np.float32)
    if not even:
        times = np.cumsum(rng.uniform(0.3, 2.5, size=frames)).astype(np.float32)
    picked = np.linspace(0, frames - 1, samples).round().astype(int)
    if not even and frames > samples > 2:
        inner = rng.choice(np.arange(1, frames - 1), size=samples - 2, replace=False)
        picked = np.sort(np.concatenate([[0, frames - 1], inner]))
    sampled = 0.5 * rng.standard_normal((1, samples, pair.config.channels))
    times -= times[0]
    arrays = sampled.astype(np.float32), times[None, picked], times[None]
    return tuple(torch.from_numpy(np.ascontiguousarray(array)) for array in arrays)


@torch.no_grad()
def _convert(net: nn.Module, kind: str, arguments: tuple, dims: dict[str, dict]) -> bytes:
    ins, outs = (NAMES | {"forecast": FORECAST_NAMES})[kind]
    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
        path = Path(folder) / "net.onnx"
        logging.getLogger("torch.onnx").setLevel(logging.ERROR)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            torch.onnx.export(
                net,
                arguments,
                path,
                input_names=list(ins),
                output_names=list(outs),
                opset_version=OPSET,
                dynamo=True,
                dynamic_shapes=tuple(dims[name] for name in ins),
                external_data=False,
                verbose=False,
            )
        return _without_notes(onnx.load(path)).SerializeToString()


def _without_notes(model: onnx.ModelProto) -> onnx.ModelProto:
    """Drop the source lines noted at every node: a sixth of the file, and paths of this machine."""
    for item in (model, model.graph, *model.graph.node, *model.graph.value_info):
        item.ClearField("doc_string")
        item.ClearField("metadata_props")
    for item in (*model.graph.input, *model.graph.output, *model.graph.initializer):
        item.ClearField("doc_string")
        item.ClearField("metadata_props")
    model.ClearField("functions")
    return model


def convert(pair: Pair) -> dict[str, bytes]:
    """The two graphs of a pair, "denoise" and "recover": float32, batch 1, any S and T."""
    pair = pair.eval()
    sampled, sample_times, frame_times = example(pair, 5, 23, seed=0)
    with torch.no_grad():
        clean, features = pair.denoise(sampled, sample_times)
    count, frames = torch.export.Dim("S", min=2), torch.export.Dim("T", min=2)
    dims = {name: {1: count} for name in ("sampled", "clean", "features", "sample_times")}
    dims["frame_times"] = {1: frames}
    return {
        "denoise": _convert(pair.denoise, "denoise", (sampled, sample_times), dims),
        "recover": _convert(
            pair.recover, "recover", (clean, features, sample_times, frame_times), dims
        ),
    }


def convert_forecast(net: ForecastNet) -> bytes:
    """A ForecastNet as a graph: float32, batch 1, any S and T."""
    arrays = forecast_example(net, 5, 13, seed=0)
    count, frames = torch.export.Dim("S", min=2), torch.export.Dim("T", min=2)
    dims = {"sampled": {1: count}, "sample_times": {1: count}, "frame_times": {1: frames}}
    return _convert(Poses(net).eval(), "forecast", arrays, dims)


class Poses(nn.Module):
    """A ForecastNet's poses alone."""

    def __init__(self, net: ForecastNet) -> None:
        super().__init__()
        self.net = net

    def forward(self, sampled: Tensor, sample_times: Tensor, frame_times: Tensor) -> Tensor:
        """As ForecastNet."""
        return self.net(sampled, sample_times, frame_times)[1]


def forecast_example(net: ForecastNet, samples: int, frames: int, seed: int) -> tuple:
    """Random sampled [1, S, I], sample_times [1, S], frame_times [1, T] after the last of them."""
    rng = np.random.default_rng(seed)
    times = np.cumsum(rng.uniform(1.0, 12.0, size=samples))
    ahead = times[-1] + np.cumsum(rng.uniform(0.0, 2.0, size=frames))
    arrays = (
        0.5 * rng.standard_normal((1, samples, net.config.pair.channels)),
        times[None] - times[0],
        ahead[None] - times[0],
    )
    return tuple(torch.from_numpy(array.astype(np.float32)) for array in arrays)


@torch.no_grad()
def forecast_difference(net: ForecastNet, graph: bytes) -> float:
    """Largest difference of the graph's poses from torch's."""
    run, worst = session(graph), 0.0
    for seed, (samples, frames) in enumerate(((2, 1), (2, 14), (7, 3), (11, 30))):
        arrays = forecast_example(net, samples, frames, seed)
        names = FORECAST_NAMES[0]
        got = run.run(None, {x: a.numpy() for x, a in zip(names, arrays, strict=True)})[0]
        worst = max(worst, float(np.abs(got - net(*arrays)[1].numpy()).max()))
    return worst


def session(model: bytes | Path) -> onnxruntime.InferenceSession:
    """A one-threaded CPU session of a graph."""
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = 1
    options.log_severity_level = 3
    source = model if isinstance(model, bytes) else str(model)
    return onnxruntime.InferenceSession(source, options, providers=["CPUExecutionProvider"])


@torch.no_grad()
def largest_difference(pair: Pair, graphs: dict[str, bytes | Path]) -> float:
    """Largest difference of any output from torch's over SIZES, even and uneven times."""
    denoise, recover = session(graphs["denoise"]), session(graphs["recover"])
    worst = 0.0
    for seed, (samples, frames) in enumerate(SIZES):
        for even in (True, False):
            sampled, sample_times, frame_times = example(pair, samples, frames, seed, even)
            clean, features = pair.denoise(sampled, sample_times)
            poses = pair.recover(clean, features, sample_times, frame_times)
            times = {"sample_times": sample_times.numpy()}
            got = denoise.run(None, {"sampled": sampled.numpy()} | times)
            times["frame_times"] = frame_times.numpy()
            got += recover.run(None, {"clean": clean.numpy(), "features": features.numpy()} | times)
            for ours, theirs in zip(got, (clean, features, poses), strict=True):
                worst = max(worst, float(np.abs(ours - theirs.numpy()).max()))
    return worst

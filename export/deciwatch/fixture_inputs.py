"""Two small pairs that nobody trained, which take every kind of input, and what they make of poses.

They hold the web's way from estimates to recovered poses to Python's, whatever inputs the shipped
nets take: a 3D pair whose RecoverNet spends tokens on the samples, a 2D one with the paper's.
"""

from pathlib import Path

import numpy as np
import torch

from deciwatch import manifest
from deciwatch.atomic import write_bytes
from deciwatch.data.batches import TIME_UNIT
from deciwatch.fixture_parity import CASES, estimates, flat
from deciwatch.nets.pair import Pair, PairConfig
from deciwatch.onnx_export import convert
from deciwatch.runner import nets_of, recover_window

CONFIGS = (
    PairConfig(dims=3, width=8, blocks=1, inputs=("3d", "2d", "scores"), recover="samples"),
    PairConfig(dims=2, width=8, blocks=1, inputs=("2d", "scores", "3d"), recover="frames"),
)
NAMES = ("N10-Q3", "N1-Q1", "uneven")


def small_pair(config: PairConfig, seed: int) -> Pair:
    """A pair with random weights, none of them zero, small enough that poses stay poses."""
    torch.manual_seed(seed)
    pair = Pair(config).eval()
    for weight in pair.parameters():
        torch.nn.init.normal_(weight, std=0.1)
    return pair


def write_models(folder: Path, seed: int) -> None:
    """The pairs' ONNX files and their manifest, as `deciwatch export` writes them but for weights
    in plain float32: the web is to run both."""
    (folder / "manifest.json").unlink(missing_ok=True)
    for config in CONFIGS:
        for kind, graph in convert(small_pair(config, seed)).items():
            write_bytes(folder / manifest.file_name(config.dims, kind), graph)
        manifest.update(folder, manifest.describe_pair(config, {}, folder), None)


def input_cases(seed: int) -> dict:
    """Estimates in metres, pixels and scores, seconds, and both pairs' recovered poses; flat."""
    cases = []
    for i, case in enumerate(case for case in CASES if case["name"] in NAMES):
        samples, *times = estimates(case, np.random.default_rng(seed + i))
        seconds = [np.round(at.astype(np.float64) * TIME_UNIT, 9) for at in times]
        entry = {"name": case["name"]}
        entry |= {"sampleTimes": seconds[0].tolist(), "frameTimes": seconds[1].tolist()}
        entry |= {"keypoints3d": flat(samples.poses_3d), "keypoints2d": flat(samples.poses_2d)}
        entry["scores"] = flat(samples.scores)
        for config in CONFIGS:
            nets = nets_of(small_pair(config, seed))
            entry[f"poses{config.dims}d"] = flat(recover_window(nets, samples, *seconds).poses)
        cases.append(entry)
    return {"cases": cases}

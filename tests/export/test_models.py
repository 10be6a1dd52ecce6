"""The committed nets: ONNX against torch, the manifest against the files, fixtures against both."""

import hashlib
import json
import math

import numpy as np
import onnx
import pytest
import torch

from deciwatch import checkpoint, manifest
from deciwatch.flops import COUNTED, GraphCounter, evaluate
from deciwatch.nets.pair import Pair, PairConfig
from deciwatch.onnx_export import TOLERANCE, convert, largest_difference, session
from deciwatch.paths import FIXTURES, MODELS

DIMS = [2, 3]


@pytest.fixture(scope="module")
def entries():
    return manifest.read(MODELS)["pairs"]


@pytest.fixture(scope="module", params=DIMS)
def dims(request):
    return request.param


@pytest.fixture(scope="module")
def pair(dims):
    return checkpoint.load_pair(checkpoint.default_path(dims), dims)[0]


def paths(entries, dims):
    return {kind: MODELS / entries[f"{dims}d"][kind]["file"] for kind in manifest.KINDS}


def test_the_committed_graphs_equal_the_committed_checkpoint(entries, dims, pair):
    assert largest_difference(pair, paths(entries, dims)) <= TOLERANCE


def test_the_manifest_describes_the_committed_files(entries, dims, pair):
    entry = entries[f"{dims}d"]
    assert entry["dims"] == dims and entry["keypoints"] == 33
    assert entry["width"] == pair.config.width and entry["blocks"] == pair.config.blocks
    total = 0
    for kind, path in paths(entries, dims).items():
        content = path.read_bytes()
        assert entry[kind]["bytes"] == len(content)
        assert entry[kind]["sha256"] == hashlib.sha256(content).hexdigest()
        counter = GraphCounter(path)
        assert entry[kind]["parameters"] == counter.parameters()
        total += counter.parameters()
        for place in ((2, 2), (3, 41), (11, 101), (12, 240)):
            assert evaluate(entry[kind]["flops"], *place) == counter.count(*place)
    assert total == sum(weight.numel() for weight in pair.parameters())
    ours = entry["training"]["validation"]
    assert ours["deciwatchPosition"] < ours["linearPosition"]
    assert ours["deciwatchAccel"] < ours["linearAccel"]


def test_flops_are_those_of_the_architecture(entries, dims):
    """An independent count from the paper's structure: what each layer must multiply."""
    entry = entries[f"{dims}d"]
    width, blocks, values, forward = entry["width"], entry["blocks"], 33 * dims, 256
    for samples, frames in ((2, 11), (11, 101)):
        per_block = 4 * width**2 + 2 * width * forward
        denoise = samples * (2 * values * width + values**2 + blocks * per_block)
        denoise += blocks * 2 * samples**2 * width
        assert evaluate(entry["denoise"]["flops"], samples, frames) == 2 * denoise
        recover = frames * (5 * values * width + width * values + blocks * per_block)
        recover += blocks * (2 * frames**2 * width + 2 * frames * width**2)
        recover += blocks * (2 * samples * width**2 + 2 * frames * samples * width)
        # W_PR, cubic: values and slopes, and the slopes from the values.
        recover += 2 * frames * samples * values + samples**2 * values
        assert evaluate(entry["recover"]["flops"], samples, frames) == 2 * recover


def test_graphs_are_plain_and_carry_no_paths(entries, dims):
    for path in paths(entries, dims).values():
        model = onnx.load(path)
        onnx.checker.check_model(model)
        assert {item.domain for item in model.opset_import} == {""}
        assert 17 <= model.opset_import[0].version <= 18
        assert not {"Einsum", "If", "Loop", "Attention"} & {n.op_type for n in model.graph.node}
        assert {"MatMul", *COUNTED} & {node.op_type for node in model.graph.node}
        assert b"/work/" not in path.read_bytes() and b"site-packages" not in path.read_bytes()
        for value in (*model.graph.input, *model.graph.output):
            assert value.type.tensor_type.elem_type == onnx.TensorProto.FLOAT


def test_names_of_inputs_and_outputs(entries, dims):
    graphs = {kind: session(path) for kind, path in paths(entries, dims).items()}
    names = {
        kind: ([i.name for i in graph.get_inputs()], [o.name for o in graph.get_outputs()])
        for kind, graph in graphs.items()
    }
    assert names["denoise"] == (["sampled", "sample_times"], ["clean", "features"])
    assert names["recover"] == (["clean", "features", "sample_times", "frame_times"], ["poses"])


def test_parity_fixtures_hold_for_torch_and_onnx(entries, dims, pair):
    fixture = json.loads((FIXTURES / f"parity-{dims}d.json").read_text())
    graphs = {kind: session(path) for kind, path in paths(entries, dims).items()}
    assert {case["name"] for case in fixture["cases"]} >= {"N10-Q3", "N1-Q2", "N20-Q2", "uneven"}
    for case in fixture["cases"]:
        arrays = {
            name: np.array(case[name], np.float32).reshape(shape)
            for name, shape in case["shapes"].items()
        }
        times = {"sample_times": arrays["sampleTimes"]}
        clean, features = graphs["denoise"].run(None, {"sampled": arrays["sampled"]} | times)
        times["frame_times"] = arrays["frameTimes"]
        feeds = {"clean": arrays["clean"], "features": arrays["features"]} | times
        (poses,) = graphs["recover"].run(None, feeds)
        for name, got in (("clean", clean), ("features", features), ("poses", poses)):
            np.testing.assert_allclose(got, arrays[name], atol=TOLERANCE, err_msg=case["name"])
        with torch.no_grad():
            tensors = (arrays[name] for name in ("sampled", "sampleTimes", "frameTimes"))
            _, again = pair(*map(torch.from_numpy, tensors))
        np.testing.assert_allclose(again.numpy(), arrays["poses"], atol=1e-5)


def test_flops_fixture_is_what_the_graphs_count(entries):
    fixture = json.loads((FIXTURES / "flops.json").read_text())["pairs"]
    assert fixture.keys() == entries.keys()
    for name, rows in fixture.items():
        for row in rows:
            for kind in manifest.KINDS:
                flops = entries[name][kind]["flops"]
                assert row[kind] == evaluate(flops, row["samples"], row["frames"])


def test_fixtures_are_small():
    for name in ("parity-3d", "parity-2d", "normalise", "interpolation", "metrics", "flops"):
        assert (FIXTURES / f"{name}.json").stat().st_size < 600_000


def test_a_linear_pair_exports_too():
    torch.manual_seed(0)
    net = Pair(PairConfig(dims=2, width=8, blocks=1, preliminary="linear")).eval()
    for weight in net.parameters():
        torch.nn.init.normal_(weight, std=0.1)
    worst = largest_difference(net, convert(net))
    assert worst <= TOLERANCE and not math.isnan(worst)

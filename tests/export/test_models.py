"""The committed nets: ONNX against torch, the manifest against the files, fixtures against both.

Most tests run over the shipped pairs and over the small ones in tests/fixtures/models, which take
every input and of which one has the RecoverNet that the other lacks.
"""

import hashlib
import json
import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import onnx
import pytest
import torch

from deciwatch import checkpoint, manifest
from deciwatch.errors import UserError
from deciwatch.fixture_inputs import CONFIGS, input_cases, small_pair
from deciwatch.fixtures import SEED
from deciwatch.flops import COUNTED, GraphCounter, evaluate
from deciwatch.nets.blocks import feed_forward_width
from deciwatch.nets.pair import Pair, PairConfig
from deciwatch.normalise import Samples, sampled_values
from deciwatch.onnx_export import TOLERANCE, convert, largest_difference, session
from deciwatch.paths import FIXTURES, MODELS
from deciwatch.runner import onnx_nets, recover_window
from deciwatch.storage import round_weights

SMALL = FIXTURES / "models"


@dataclass(frozen=True)
class Exported:
    """A pair in torch, its entry in the manifest, and its two files."""

    pair: Pair
    entry: dict
    paths: dict[str, Path]


def exported(folder: Path, pair: Pair) -> Exported:
    entry = manifest.read(folder)["pairs"][f"{pair.config.dims}d"]
    return Exported(pair, entry, {kind: folder / entry[kind]["file"] for kind in manifest.KINDS})


def shipped(dims: int) -> Pair:
    """The committed checkpoint, rounded as it is exported."""
    return round_weights(checkpoint.load_pair(checkpoint.default_path(dims), dims)[0])


@pytest.fixture(scope="module", params=["shipped-3d", "shipped-2d", "small-3d", "small-2d"])
def nets(request):
    which, dims = request.param.removesuffix("d").split("-")
    if which == "small":
        return exported(SMALL, small_pair(next(c for c in CONFIGS if c.dims == int(dims)), SEED))
    return exported(MODELS, shipped(int(dims)))


def test_the_committed_graphs_equal_the_committed_checkpoint(nets):
    assert largest_difference(nets.pair, nets.paths) <= TOLERANCE


def test_the_manifest_describes_the_committed_files(nets):
    entry, config = nets.entry, nets.pair.config
    assert entry["dims"] == config.dims and entry["keypoints"] == 33
    assert entry["width"] == config.width and entry["blocks"] == config.blocks
    assert entry["inputs"] == list(config.inputs)
    assert entry["normalisation"].keys() == set(config.inputs) - {"scores"}
    assert entry["recover"]["tokens"] == config.recover
    assert entry["recover"].get("preliminary", "cubic") == config.preliminary
    total = 0
    for kind, path in nets.paths.items():
        content = path.read_bytes()
        assert entry[kind]["bytes"] == len(content)
        assert entry[kind]["sha256"] == hashlib.sha256(content).hexdigest()
        counter = GraphCounter(path)
        assert entry[kind]["parameters"] == counter.parameters()
        assert entry[kind]["stored"] == counter.stored()
        total += counter.parameters()
        for place in ((2, 2), (3, 41), (11, 101), (12, 240)):
            assert evaluate(entry[kind]["flops"], *place) == counter.count(*place)
    assert total == sum(weight.numel() for weight in nets.pair.parameters())


@pytest.mark.parametrize("name", ["3d", "2d"])
def test_the_shipped_pairs_beat_straight_lines_in_validation(name):
    ours = manifest.read(MODELS)["pairs"][name]["training"]["validation"]
    assert ours["deciwatchPosition"] < ours["linearPosition"]
    assert ours["deciwatchAccel"] < ours["everyFrameAccel"] / 4


def test_flops_are_those_of_the_architecture(nets):
    """An independent count from the nets' structure: what each layer must multiply."""
    config = nets.pair.config
    width, blocks, values, channels = config.width, config.blocks, config.values, config.channels
    per_block = 4 * width**2 + 2 * width * (config.feed_forward or feed_forward_width(width))
    for samples, frames in ((2, 11), (11, 101)):
        self_attention = blocks * 2 * samples**2 * width
        denoise = samples * (channels * width + width * values + channels * values)
        denoise += samples * blocks * per_block + self_attention
        assert evaluate(nets.entry["denoise"]["flops"], samples, frames) == 2 * denoise
        # W_PR, cubic: values and slopes, and the slopes from the values.
        recover = 2 * frames * samples * values + samples**2 * values
        if config.recover == "frames":
            recover += frames * (5 * values * width + width * values + blocks * per_block)
            recover += blocks * (2 * frames**2 * width + 2 * frames * width**2)
            recover += blocks * (2 * samples * width**2 + 2 * frames * samples * width)
        else:
            head = 2 * width
            # The pose half way, the steps of five gaps with how long they are, the features of two.
            recover += samples * ((6 * values + 10) * width + 2 * width**2 + blocks * per_block)
            recover += self_attention + samples * width * head
            # Each frame's gap, its begin, its token and its phase; then the head.
            recover += frames * samples * (head + 2) + frames * (9 * head + head * values)
            if config.dims == 3:  # which way it faces; the bones' lengths at both of its samples
                recover += frames * samples * (2 + 2 * 35)
        assert evaluate(nets.entry["recover"]["flops"], samples, frames) == 2 * recover


def test_graphs_are_plain_and_carry_no_paths(nets):
    for path in nets.paths.values():
        model = onnx.load(path)
        onnx.checker.check_model(model)
        assert {item.domain for item in model.opset_import} == {""}
        assert 17 <= model.opset_import[0].version <= 18
        assert not {"Einsum", "If", "Loop", "Attention"} & {n.op_type for n in model.graph.node}
        assert {"MatMul", *COUNTED} & {node.op_type for node in model.graph.node}
        assert b"/work/" not in path.read_bytes() and b"site-packages" not in path.read_bytes()
        for value in (*model.graph.input, *model.graph.output):
            assert value.type.tensor_type.elem_type == onnx.TensorProto.FLOAT


def test_names_of_inputs_and_outputs(nets):
    graphs = {kind: session(path) for kind, path in nets.paths.items()}
    names = {
        kind: ([i.name for i in graph.get_inputs()], [o.name for o in graph.get_outputs()])
        for kind, graph in graphs.items()
    }
    assert names["denoise"] == (["sampled", "sample_times"], ["clean", "features"])
    assert names["recover"] == (["clean", "features", "sample_times", "frame_times"], ["poses"])


@pytest.mark.parametrize("dims", [3, 2])
def test_parity_fixtures_hold_for_torch_and_onnx(dims):
    pair = shipped(dims)
    graphs = {k: session(path) for k, path in exported(MODELS, pair).paths.items()}
    fixture = json.loads((FIXTURES / f"parity-{dims}d.json").read_text())
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


def test_flops_fixture_is_what_the_graphs_count():
    entries = manifest.read(MODELS)["pairs"]
    fixture = json.loads((FIXTURES / "flops.json").read_text())["pairs"]
    assert fixture.keys() == entries.keys()
    for name, rows in fixture.items():
        for row in rows:
            for kind in (*manifest.KINDS, manifest.FORECAST):
                flops = entries[name][kind]["flops"]
                assert row[kind] == evaluate(flops, row["samples"], row["frames"])


def test_fixtures_are_small():
    for path in FIXTURES.glob("*.json"):
        assert path.stat().st_size < 600_000
    assert sum(path.stat().st_size for path in SMALL.iterdir()) < 300_000


def test_input_fixtures_hold_for_onnx():
    """From estimates to poses: what the web must give too, of every kind of input."""
    fixture = json.loads((FIXTURES / "inputs.json").read_text())
    for made, case in zip(input_cases(SEED)["cases"], fixture["cases"], strict=True):
        shape = (len(case["sampleTimes"]), 33)
        samples = Samples(
            np.array(case["keypoints3d"], np.float32).reshape(*shape, 3),
            np.array(case["keypoints2d"], np.float32).reshape(*shape, 2),
            np.array(case["scores"], np.float32).reshape(shape),
        )
        times = [np.array(case[name]) for name in ("sampleTimes", "frameTimes")]
        for dims, unit in ((3, 0.5), (2, 500.0)):
            poses, clean = recover_window(onnx_nets(SMALL, dims), samples, *times)
            assert clean.shape == (*shape, dims)
            expected = np.array(case[f"poses{dims}d"])
            np.testing.assert_allclose(poses.ravel(), expected, atol=unit * TOLERANCE)
            np.testing.assert_allclose(made[f"poses{dims}d"], expected, atol=unit * TOLERANCE)


def test_a_batch_is_built_as_its_windows_are():
    rng = np.random.default_rng(1)
    batch = Samples(
        rng.normal(0, 0.5, size=(3, 4, 33, 3)),
        rng.uniform(0, 900, size=(3, 4, 33, 2)),
        rng.uniform(size=(3, 4, 33)),
    )
    inputs = ("2d", "scores", "3d")
    values = sampled_values(batch, inputs)
    assert values.shape == (3, 4, 33 * 6) and values.dtype == np.float32
    for i in range(3):
        window = Samples(batch.poses_3d[i], batch.poses_2d[i], batch.scores[i])
        np.testing.assert_array_equal(values[i], sampled_values(window, inputs))
    np.testing.assert_array_equal(values[..., 66:99], batch.scores.astype(np.float32))
    np.testing.assert_allclose(values[..., 99:], 2 * batch.poses_3d.reshape(3, 4, 99), rtol=1e-6)


def test_an_input_that_the_estimates_lack_is_named():
    times = np.array([0.0, 0.5])
    poses = np.zeros((2, 33, 3), np.float32)
    with pytest.raises(UserError, match="2D poses"):
        recover_window(onnx_nets(SMALL, 3), Samples(poses_3d=poses), times, times)
    with pytest.raises(UserError, match="take scores"):
        samples = Samples(poses_3d=poses, poses_2d=poses[..., :2])
        recover_window(onnx_nets(SMALL, 3), samples, times, times)


@pytest.mark.parametrize("recover", ["frames", "samples"])
def test_a_linear_pair_exports_too(recover):
    config = PairConfig(dims=2, width=8, blocks=1, preliminary="linear", recover=recover)
    net = small_pair(config, 0)
    worst = largest_difference(net, convert(net))
    assert worst <= TOLERANCE and not math.isnan(worst)

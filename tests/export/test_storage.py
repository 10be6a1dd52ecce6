"""Rounded weights, and graphs that hold them in a byte or two each without losing anything."""

import collections

import numpy as np
import onnx
import onnxruntime
import pytest
import torch
from onnx import numpy_helper

from deciwatch import checkpoint, manifest
from deciwatch.compact import compact, sources
from deciwatch.fixture_inputs import small_pair
from deciwatch.flops import GraphCounter, inputs
from deciwatch.nets.pair import PairConfig
from deciwatch.onnx_export import convert, forecast_difference, session
from deciwatch.paths import MODELS
from deciwatch.storage import FINE, LEAST, STEP_BITS, as_int8, from_int8, round_weights, rounded

# One net of either kind of RecoverNet: with a convolution, and with none.
CONFIGS = [
    PairConfig(dims=2, width=16, blocks=1, inputs=("2d", "3d", "scores"), recover="frames"),
    PairConfig(dims=3, width=16, blocks=1, inputs=("3d", "2d", "scores"), recover="samples"),
]


@pytest.fixture(scope="module", params=CONFIGS, ids=lambda config: config.recover)
def graphs(request):
    """Of each net, before and after: made of the same rounded weights."""
    made = convert(round_weights(small_pair(request.param, 1)))
    return {kind: (graph, compact(graph)) for kind, graph in made.items()}


@pytest.mark.parametrize("spread", [1e-6, 0.1, 300.0])
def test_int8_is_within_half_a_step_and_rounding_again_changes_nothing(spread):
    rng = np.random.default_rng(0)
    weight = (spread * rng.standard_normal((500, 40)) ** 3).astype(np.float32)
    weight[3] = 0
    whole, steps = as_int8(weight)
    assert whole.dtype == np.int8 and steps.dtype == np.float32
    # The largest weight of every channel uses the whole range, so it gives the same step again.
    assert (np.abs(whole).max(axis=1)[weight.any(axis=1)] == 127).all()
    found = from_int8(whole, steps)
    assert found.dtype == np.float32 and not found[3].any()
    assert (np.abs(found - weight) <= 0.5001 * steps[:, None]).all()
    np.testing.assert_array_equal(found.astype(np.float64), whole * steps[:, None].astype(float))
    for again, before in zip(as_int8(found), (whole, steps), strict=True):
        np.testing.assert_array_equal(again, before)


def test_steps_have_few_bits():
    weight = np.random.default_rng(1).standard_normal((2000, 3)).astype(np.float32)
    mantissa = np.frexp(as_int8(weight)[1])[0] * 2**STEP_BITS
    np.testing.assert_array_equal(mantissa, np.round(mantissa))


def test_rounding_of_a_net():
    net = small_pair(CONFIGS[0], 0)
    before = {name: weight.detach().clone() for name, weight in net.named_parameters()}
    assert set(FINE) < before.keys()
    round_weights(net)
    once = {name: weight.detach().clone() for name, weight in net.named_parameters()}
    round_weights(net)
    for name, weight in net.named_parameters():
        assert torch.equal(weight, once[name]), name
        if weight.numel() <= LEAST:
            assert torch.equal(weight, before[name]), name
        else:
            assert not torch.equal(weight, before[name]), name
            error = (weight - before[name]).abs().max() / before[name].abs().max()
            assert error < (2**-11 if name in FINE else 0.5 / 126), name
    bias = np.random.default_rng(2).standard_normal(2 * LEAST).astype(np.float32)
    assert rounded("denoise.norm.bias", bias) is bias


def test_a_compact_graph_holds_the_very_same_weights(graphs):
    for plain, small in graphs.values():
        before, after = onnx.load_from_string(plain), onnx.load_from_string(small)
        held = sources(after.graph)
        run = _constants(after)
        for tensor in before.graph.initializer:
            values = numpy_helper.to_array(tensor)
            stored = held[tensor.name].data_type
            if values.size > LEAST and values.dtype == np.float32:
                assert stored in (onnx.TensorProto.INT8, onnx.TensorProto.FLOAT16), tensor.name
                np.testing.assert_array_equal(run[tensor.name], values)
            else:
                assert stored == tensor.data_type
        assert len(small) < 0.75 * len(plain)
        assert compact(small) == small


def test_a_compact_graph_computes_the_same_and_costs_the_same(graphs, tmp_path):
    for kind, both in graphs.items():
        counters = []
        for i, graph in enumerate(both):
            (tmp_path / f"{kind}-{i}.onnx").write_bytes(graph)
            counters.append(GraphCounter(tmp_path / f"{kind}-{i}.onnx"))
        plain, small = counters
        assert small.polynomial() == plain.polynomial()
        assert small.parameters() == plain.parameters()
        assert plain.stored() == {"float32": plain.parameters()}
        assert set(small.stored()) - {"float32"} == (
            {"int8", "float16"} if kind == "denoise" else {"int8"}
        )
        feeds = inputs(plain.model, 5, 33)
        rng = np.random.default_rng(0)
        for name in feeds.keys() & {"sampled", "clean", "features"}:
            feeds[name] = rng.standard_normal(feeds[name].shape).astype(np.float32)
        results = [session(graph).run(None, feeds) for graph in both]
        for ours, theirs in zip(*results, strict=True):
            np.testing.assert_array_equal(ours, theirs)


def test_what_is_left_after_loading_is_the_plain_graph(graphs, tmp_path):
    """Casts and steps are gone once a session is made, so a run costs what it did."""
    for both in graphs.values():
        counts = []
        for graph in both:
            options = onnxruntime.SessionOptions()
            options.log_severity_level = 3
            options.optimized_model_filepath = str(tmp_path / "optimized.onnx")
            onnxruntime.InferenceSession(graph, options, providers=["CPUExecutionProvider"])
            nodes = onnx.load(options.optimized_model_filepath).graph.node
            counts.append(collections.Counter(node.op_type for node in nodes))
        assert counts[0] == counts[1]


def test_weights_that_nobody_rounded_stay_as_they_are():
    for graph in convert(small_pair(CONFIGS[1], 3)).values():
        before, after = onnx.load_from_string(graph), onnx.load_from_string(compact(graph))
        kinds = collections.Counter(tensor.data_type for tensor in before.graph.initializer)
        assert kinds == collections.Counter(t.data_type for t in after.graph.initializer)


@pytest.mark.parametrize("dims", [2, 3])
def test_the_shipped_nets_are_small(dims):
    entry = manifest.read(MODELS)["pairs"][f"{dims}d"]
    for kind in (*manifest.KINDS, manifest.FORECAST):
        net = entry[kind]
        assert sum(net["stored"].values()) == net["parameters"]
        assert net["stored"]["float32"] < 0.02 * net["parameters"]
        # A byte each, two for those in FINE, and the graph itself.
        assert net["bytes"] < 1.1 * net["parameters"] + 110_000


@pytest.mark.parametrize("dims", [2, 3])
def test_the_shipped_forecast_equals_its_rounded_checkpoint(dims):
    net = round_weights(checkpoint.load_forecast(checkpoint.forecast_path(dims), dims)[0])
    graph = (MODELS / manifest.file_name(dims, manifest.FORECAST)).read_bytes()
    assert forecast_difference(net, graph) <= 1e-4


def _constants(model: onnx.ModelProto) -> dict[str, np.ndarray]:
    """What onnxruntime makes of every constant of a compact graph."""
    names = [
        name for node in model.graph.node for name in node.output if name in sources(model.graph)
    ]
    probe = onnx.ModelProto()
    probe.CopyFrom(model)
    probe.graph.output.extend(onnx.helper.make_empty_tensor_value_info(name) for name in names)
    run = session(probe.SerializeToString())
    values = run.run(names, inputs(model, 3, 7))
    return dict(zip(names, values, strict=True))

"""Two tiny pose models that nobody trained, for the web's `OnnxPoseEstimator`.

Both find three keypoints: the middle of what is red in the picture, of what is green and of what is
blue. One says so by heatmaps of a quarter of the input's size, the other by SimCC's distributions.
They take `input` [1, 3, 64, 48]: red, green and blue from 0 to 1.
"""

from pathlib import Path

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

from deciwatch.atomic import write_bytes

HEIGHT, WIDTH = 64, 48
STRIDE = 4
SPLIT = 2
KERNEL, SIGMA = 9, 2.5
OPSET = 17
# A channel less half of the two others: white and grey are no colour.
COLOURS = np.eye(3) * 1.5 - 0.5


def _constant(name: str, values: np.ndarray) -> onnx.TensorProto:
    return numpy_helper.from_array(np.asarray(values, np.float32), name)


def _model(nodes: list, constants: list, outputs: dict[str, tuple]) -> bytes:
    def tensor(name: str, shape: tuple) -> onnx.ValueInfoProto:
        return helper.make_tensor_value_info(name, TensorProto.FLOAT, shape)

    graph = helper.make_graph(
        nodes,
        "colours",
        [tensor("input", (1, 3, HEIGHT, WIDTH))],
        [tensor(name, shape) for name, shape in outputs.items()],
        constants,
    )
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", OPSET)], ir_version=9)
    onnx.checker.check_model(model, full_check=True)
    return model.SerializeToString()


def heatmap_model() -> bytes:
    """One strided convolution with a bell: `heatmaps` [1, 3, 16, 12], cell i about pixel 4·i."""
    bell = np.exp(-((np.arange(KERNEL) - KERNEL // 2) ** 2) / (2 * SIGMA**2))
    bell = np.outer(bell, bell) / np.outer(bell, bell).sum()
    # A spot as wide as the bell fills three quarters of it; so the peaks come near 1.
    weights = _constant("weights", 1.3 * COLOURS[:, :, None, None] * bell)
    pad = KERNEL // 2
    nodes = [
        helper.make_node(
            "Conv",
            ["input", "weights"],
            ["heatmaps"],
            strides=[STRIDE, STRIDE],
            pads=[pad, pad, pad, pad],
        )
    ]
    return _model(nodes, [weights], {"heatmaps": (1, 3, HEIGHT // STRIDE, WIDTH // STRIDE)})


def simcc_model() -> bytes:
    """How much colour each column and each row has, smoothed: `simcc_x` [1, 3, 96], `simcc_y`."""

    def bells(pixels: int) -> np.ndarray:
        apart = np.arange(pixels)[:, None] - np.arange(pixels * SPLIT)[None] / SPLIT
        return np.exp(-(apart**2) / (2 * SIGMA**2)) / 40

    constants = [
        _constant("weights", COLOURS[:, :, None, None]),
        _constant("bells_x", bells(WIDTH)),
        _constant("bells_y", bells(HEIGHT)),
        numpy_helper.from_array(np.array([2], np.int64), "rows"),
        numpy_helper.from_array(np.array([3], np.int64), "columns"),
    ]
    nodes = [
        helper.make_node("Conv", ["input", "weights"], ["mixed"]),
        helper.make_node("Relu", ["mixed"], ["colours"]),
        helper.make_node("ReduceSum", ["colours", "rows"], ["by_column"], keepdims=0),
        helper.make_node("ReduceSum", ["colours", "columns"], ["by_row"], keepdims=0),
        helper.make_node("MatMul", ["by_column", "bells_x"], ["simcc_x"]),
        helper.make_node("MatMul", ["by_row", "bells_y"], ["simcc_y"]),
    ]
    outputs = {"simcc_x": (1, 3, WIDTH * SPLIT), "simcc_y": (1, 3, HEIGHT * SPLIT)}
    return _model(nodes, constants, outputs)


MODELS = {"heatmap.onnx": heatmap_model, "simcc.onnx": simcc_model}


def write_estimators(folder: Path) -> None:
    """Write both."""
    for name, make in MODELS.items():
        write_bytes(folder / name, make())

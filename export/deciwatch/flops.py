"""FLOPs and parameters of an ONNX net, counted from its graph.

FLOPs are 2 × multiply-accumulates of Conv, MatMul and Gemm, so attention's two products and the
preliminary recovery count too; normalisation, softmax and additions do not. Shapes are those
that onnxruntime meets when it runs the graph.
"""

import math
from fractions import Fraction
from pathlib import Path

import numpy as np
import onnx
import onnxruntime
from onnx import TensorProto

from deciwatch.compact import sources

COUNTED = ("Conv", "MatMul", "Gemm")
WEIGHTED = (*COUNTED, "Add", "LayerNormalization")
STORED = {
    TensorProto.INT8: "int8",
    TensorProto.FLOAT16: "float16",
    TensorProto.FLOAT: "float32",
}
TERMS = ("1", "S", "SS", "T", "ST", "TT")
# Six places fix the six terms, the others prove them.
FIT = ((2, 5), (3, 7), (5, 9), (4, 16), (7, 3), (6, 11))
HELD_OUT = ((2, 2), (11, 101), (11, 201), (9, 33), (2, 21))


def inputs(model: onnx.ModelProto, samples: int, frames: int) -> dict[str, np.ndarray]:
    """Zero inputs for S samples and T frames at even times, by the names that the net asks for."""
    sizes = {"sampled": samples, "clean": samples, "features": samples}
    feeds = {}
    for value in model.graph.input:
        if value.name == "sample_times":
            feeds[value.name] = np.linspace(0, frames - 1, samples, dtype=np.float32)[None]
        elif value.name == "frame_times":
            feeds[value.name] = np.arange(frames, dtype=np.float32)[None]
        else:
            width = value.type.tensor_type.shape.dim[-1].dim_value
            feeds[value.name] = np.zeros((1, sizes[value.name], width), np.float32)
    return feeds


class GraphCounter:
    """Counts the FLOPs of one net at any S and T."""

    def __init__(self, path: Path) -> None:
        self.model = onnx.load(path)
        graph = self.model.graph
        self.nodes = [node for node in graph.node if node.op_type in COUNTED]
        self.sources = sources(graph)
        self.fixed = {name: tuple(weight.dims) for name, weight in self.sources.items()}
        self.known = {name for value in graph.input for name in [value.name]}
        wanted = {name for node in self.nodes for name in (*node.input[:2], *node.output)}
        self.seen = sorted(wanted - self.fixed.keys() - self.known)
        probe = onnx.ModelProto()
        probe.CopyFrom(self.model)
        present = {value.name for value in graph.output}
        probe.graph.output.extend(
            onnx.helper.make_empty_tensor_value_info(name)
            for name in self.seen
            if name not in present
        )
        # Optimising would fuse away the very products that are looked at.
        options = onnxruntime.SessionOptions()
        options.graph_optimization_level = onnxruntime.GraphOptimizationLevel.ORT_DISABLE_ALL
        self.session = onnxruntime.InferenceSession(
            probe.SerializeToString(), options, providers=["CPUExecutionProvider"]
        )

    def count(self, samples: int, frames: int) -> int:
        """FLOPs of one call with S samples and T frames."""
        feeds = inputs(self.model, samples, frames)
        values = self.session.run(self.seen, feeds)
        shapes = self.fixed | {name: value.shape for name, value in feeds.items()}
        shapes |= {name: value.shape for name, value in zip(self.seen, values, strict=True)}
        return 2 * sum(_macs(node, shapes) for node in self.nodes)

    def polynomial(self) -> dict[str, int]:
        """FLOPs as integer coefficients of 1, S, S², T, S·T and T²; exact, and checked so."""
        rows = [[Fraction(x) for x in _powers(*place)] for place in FIT]
        solution = _solve(rows, [Fraction(self.count(*place)) for place in FIT])
        if any(value.denominator != 1 for value in solution):
            raise ValueError("the FLOPs are not an integer polynomial in S and T")
        terms = dict(zip(TERMS, (int(value) for value in solution), strict=True))
        for place in HELD_OUT:
            if evaluate(terms, *place) != self.count(*place):
                raise ValueError(f"the FLOPs polynomial fails at S, T = {place}")
        return terms

    def parameters(self) -> int:
        """Trained numbers in the graph: weights of products, biases and normalisations."""
        return sum(self.stored().values())

    def stored(self) -> dict[str, int]:
        """How many of the parameters the file holds as int8, float16 and float32."""
        used = {
            name
            for node in self.model.graph.node
            if node.op_type in WEIGHTED
            for name in node.input
        }
        counted = dict.fromkeys(STORED.values(), 0)
        for name in used & self.sources.keys():
            weight = self.sources[name]
            if weight.dims and not _picks(weight):
                counted[STORED[weight.data_type]] += math.prod(weight.dims)
        return {kind: count for kind, count in counted.items() if count}


def _picks(weight: onnx.TensorProto) -> bool:
    """Whether a matrix adds and subtracts chosen keypoints (nets/facing.py): nobody trained it."""
    values = onnx.numpy_helper.to_array(weight)
    return values.ndim == 2 and values.any() and bool(np.isin(values, (-1, 0, 1)).all())


def _macs(node: onnx.NodeProto, shapes: dict[str, tuple[int, ...]]) -> int:
    first, second, out = (shapes[name] for name in (node.input[0], node.input[1], node.output[0]))
    if node.op_type == "Conv":
        return math.prod(out) * math.prod(second[1:])
    if node.op_type == "Gemm":
        transposed = any(item.name == "transA" and item.i for item in node.attribute)
        return math.prod(out) * first[0 if transposed else 1]
    return math.prod(out) * first[-1]


def _powers(samples: int, frames: int) -> list[int]:
    return [1, samples, samples**2, frames, samples * frames, frames**2]


def evaluate(terms: dict[str, int], samples: int, frames: int) -> int:
    """FLOPs of a polynomial from the manifest at S and T."""
    powers = dict(zip(TERMS, _powers(samples, frames), strict=True))
    return sum(terms[name] * powers[name] for name in TERMS)


def _solve(rows: list[list[Fraction]], right: list[Fraction]) -> list[Fraction]:
    """Gauss-Jordan on exact fractions; the places in FIT make the rows independent."""
    table = [[*row, value] for row, value in zip(rows, right, strict=True)]
    size = len(table)
    for column in range(size):
        pivot = next(i for i in range(column, size) if table[i][column])
        table[column], table[pivot] = table[pivot], table[column]
        table[column] = [x / table[column][column] for x in table[column]]
        for i in range(size):
            if i != column and table[i][column]:
                factor = table[i][column]
                table[i] = [x - factor * y for x, y in zip(table[i], table[column], strict=True)]
    return [row[-1] for row in table]

"""Keeps a graph's weights in a byte or two each, where that loses nothing.

An int8 tensor is cast and multiplied by its channels' steps, a float16 one is cast. Not by
DequantizeLinear: onnxruntime would leave that to every run, but works these out as it loads the
graph, and from then on runs what it always ran.
"""

import numpy as np
import onnx
from onnx import NodeProto, TensorProto, helper, numpy_helper

from deciwatch.storage import LEAST, as_int8, from_int8


def compact(graph: bytes) -> bytes:
    """The graph with every large float32 tensor that allows it as int8 or float16, else as it is.

    What it computes does not change by a bit, so weights that nobody rounded
    (deciwatch.storage.round_weights) stay float32.
    """
    model = onnx.load_from_string(graph)
    kept: list[TensorProto] = []
    added: list[NodeProto] = []
    for tensor in model.graph.initializer:
        tensors, nodes = _compacted(tensor)
        kept += tensors
        added += nodes
    nodes = [*added, *model.graph.node]
    del model.graph.initializer[:], model.graph.node[:]
    model.graph.initializer.extend(kept)
    model.graph.node.extend(nodes)
    onnx.checker.check_model(model)
    return model.SerializeToString()


def sources(graph: onnx.GraphProto) -> dict[str, TensorProto]:
    """The tensor that holds the numbers, by the name of each constant that the nodes use."""
    tensors = {tensor.name: tensor for tensor in graph.initializer}
    found = dict(tensors)
    for node in graph.node:
        scaled = node.op_type == "Mul" and node.input[1] in tensors
        if (node.op_type == "Cast" or scaled) and node.input[0] in found:
            found[node.output[0]] = found[node.input[0]]
    return found


def _compacted(tensor: TensorProto) -> tuple[list[TensorProto], list[NodeProto]]:
    """What to put in place of a tensor, and the nodes that make it again under its name."""
    plain, name = ([tensor], []), tensor.name
    if tensor.data_type != TensorProto.FLOAT:
        return plain
    values = numpy_helper.to_array(tensor)
    if values.size <= LEAST or values.ndim < 2:
        return plain
    if found := _in_int8(values):
        whole, steps = f"{name}.int8", f"{name}.steps"
        tensors = [numpy_helper.from_array(found[0], whole)]
        tensors += [numpy_helper.from_array(found[1], steps)]
        scale = helper.make_node("Mul", [f"{name}.whole", steps], [name])
        return tensors, [_cast(whole, f"{name}.whole"), scale]
    half = values.astype(np.float16)
    if not np.array_equal(half.astype(np.float32), values):
        return plain
    return [numpy_helper.from_array(half, f"{name}.half")], [_cast(f"{name}.half", name)]


def _cast(name: str, to: str) -> NodeProto:
    return helper.make_node("Cast", [name], [to], to=TensorProto.FLOAT)


def _in_int8(values: np.ndarray) -> tuple[np.ndarray, np.ndarray] | None:
    """Whole numbers and steps, shaped to be multiplied, if they are exactly `values`.

    Channels come last in a product's matrix, which torch has the other way round, and first in a
    convolution's.
    """
    for axis in (values.ndim - 1, 0):
        turned = np.moveaxis(values, axis, 0)
        whole, steps = as_int8(turned)
        if np.array_equal(from_int8(whole, steps), turned):
            shape = [-1 if i == axis else 1 for i in range(values.ndim)]
            return np.ascontiguousarray(np.moveaxis(whole, 0, axis)), steps.reshape(shape)
    return None

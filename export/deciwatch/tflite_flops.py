"""FLOPs and parameters of a TensorFlow Lite model, counted from its graph.

FLOPs are 2 x multiply-accumulates of the ops that multiply by weights (CONV_2D, DEPTHWISE_CONV_2D,
TRANSPOSE_CONV, FULLY_CONNECTED) or by one another (BATCH_MATMUL). Additions, activations, pooling
and resizing are left out, as they are for our own nets. Sparse weights (DENSIFY) count as dense.
Every op of the graph counts, since the TFLite interpreter runs them all: BlazePose's segmentation
and heatmap heads too, although nobody reads them here (62 to 74 MFLOP of segmentation).

Needs the PyPI package `tflite` (the schema's generated reader), nothing of TensorFlow itself.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class TfliteCost:
    """What one call of the model costs and how large it is.

    flops: all FLOPs of one call (2 x MACs), at the shapes stored in the graph.
    flops_by_op: FLOPs of each counted kind of op, by its name in the schema.
    op_counts: how often each kind of op occurs, counted or not.
    parameters: elements of all constant floating-point tensors, each tensor once.
    input_shape: shape of the first input without the batch axis, e.g. (256, 256, 3).
    """

    flops: int
    flops_by_op: dict[str, int]
    op_counts: dict[str, int]
    parameters: int
    input_shape: tuple[int, ...]


def count_tflite(model_bytes: bytes) -> TfliteCost:
    """Counts the first subgraph of a `.tflite` file's bytes.

    A weight that reaches its op through DEQUANTIZE (float16 -> float32) or DENSIFY needs no special
    care for FLOPs, since the op's input has the dense shape; for parameters the stored tensor is
    the one that counts, and a tensor computed by an op does not.
    """
    import tflite

    if not tflite.Model.ModelBufferHasIdentifier(model_bytes, 0):
        raise ValueError("these bytes are no TensorFlow Lite model")
    model = tflite.Model.GetRootAs(model_bytes, 0)
    if model.SubgraphsLength() != 1:
        raise ValueError(f"expected one subgraph, found {model.SubgraphsLength()}")
    graph = model.Subgraphs(0)
    names = {value: name for name, value in vars(tflite.BuiltinOperator).items() if _is_int(value)}

    flops_by_op: dict[str, int] = {}
    op_counts: dict[str, int] = {}
    for index in range(graph.OperatorsLength()):
        op = graph.Operators(index)
        name = names[_opcode(model.OperatorCodes(op.OpcodeIndex()))]
        op_counts[name] = op_counts.get(name, 0) + 1
        if name in _MACS:
            flops_by_op[name] = flops_by_op.get(name, 0) + 2 * _MACS[name](graph, op)

    first_input = _shape(graph, graph.Inputs(0))
    return TfliteCost(
        flops=sum(flops_by_op.values()),
        flops_by_op=flops_by_op,
        op_counts=op_counts,
        parameters=_count_parameters(model, graph),
        input_shape=tuple(first_input[1:]),
    )


def _is_int(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool)


def _opcode(code: Any) -> int:
    # Codes above 127 did not fit the first field; each writer fills the other one with a default.
    return max(code.BuiltinCode(), code.DeprecatedBuiltinCode())


def _shape(graph: Any, tensor: int) -> list[int]:
    shape = [int(n) for n in graph.Tensors(tensor).ShapeAsNumpy()]
    if any(n <= 0 for n in shape):
        raise ValueError(f"tensor {tensor} has no fixed shape: {shape}")
    return shape


def _conv_macs(graph: Any, op: Any) -> int:
    """Output [B,H,W,O], weights [O,kh,kw,I]: each output is a sum over one kernel of kh*kw*I."""
    _, kernel_h, kernel_w, channels = _shape(graph, op.Inputs(1))
    return math.prod(_shape(graph, op.Outputs(0))) * kernel_h * kernel_w * channels


def _depthwise_macs(graph: Any, op: Any) -> int:
    """Output [B,H,W,O], weights [1,kh,kw,O]: each output sees one channel only."""
    _, kernel_h, kernel_w, _ = _shape(graph, op.Inputs(1))
    return math.prod(_shape(graph, op.Outputs(0))) * kernel_h * kernel_w


def _transpose_conv_macs(graph: Any, op: Any) -> int:
    """Inputs (output shape, weights [O,kh,kw,I], x [B,h,w,I]): an input meets each kernel once."""
    out_channels, kernel_h, kernel_w, _ = _shape(graph, op.Inputs(1))
    return math.prod(_shape(graph, op.Inputs(2))) * kernel_h * kernel_w * out_channels


def _fully_connected_macs(graph: Any, op: Any) -> int:
    """Weights [O,I]: each of the output's elements is a sum over I."""
    return math.prod(_shape(graph, op.Outputs(0))) * _shape(graph, op.Inputs(1))[1]


def _batch_matmul_macs(graph: Any, op: Any) -> int:
    """x [...,n,k] times y [...,k,m]; either may be stored transposed."""
    import tflite

    table = op.BuiltinOptions()
    transposed = False
    if table is not None:
        options = tflite.BatchMatMulOptions()
        options.Init(table.Bytes, table.Pos)
        transposed = bool(options.AdjX())
    inner = _shape(graph, op.Inputs(0))[-2 if transposed else -1]
    return math.prod(_shape(graph, op.Outputs(0))) * inner


_MACS = {
    "CONV_2D": _conv_macs,
    "DEPTHWISE_CONV_2D": _depthwise_macs,
    "TRANSPOSE_CONV": _transpose_conv_macs,
    "FULLY_CONNECTED": _fully_connected_macs,
    "BATCH_MATMUL": _batch_matmul_macs,
}


def _count_parameters(model: Any, graph: Any) -> int:
    """Elements of the stored float tensors. Integer constants are shapes and paddings."""
    import tflite

    floats = (tflite.TensorType.FLOAT32, tflite.TensorType.FLOAT16)
    total = 0
    for index in range(graph.TensorsLength()):
        tensor = graph.Tensors(index)
        stored = model.Buffers(tensor.Buffer()).DataLength() > 0
        if stored and tensor.Type() in floats:
            total += math.prod(int(n) for n in tensor.ShapeAsNumpy())
    return total

"""The committed estimator bundles, their manifest, and the FLOPs counter. Needs no mediapipe."""

import hashlib
import io
import json
import tarfile
import zipfile
from pathlib import Path

import flatbuffers
import numpy as np
import pytest
import tflite

from deciwatch import bundles
from deciwatch.errors import UserError
from deciwatch.tflite_flops import count_tflite

ESTIMATORS = Path(__file__).resolve().parents[2] / "public" / "estimators"
MANIFEST = json.loads((ESTIMATORS / "manifest.json").read_text())
NAMES = ["pose_detector.tflite", "pose_landmarks_detector.tflite"]


def read_models(variant: str) -> tuple[bytes, bytes]:
    with zipfile.ZipFile(ESTIMATORS / MANIFEST["estimators"][variant]["file"]) as archive:
        return archive.read(NAMES[0]), archive.read(NAMES[1])


def test_manifest_names_its_source_and_all_three_variants():
    assert MANIFEST["format"] == "deciwatch-estimators/1"
    assert MANIFEST["skeleton"] == "blazepose-33"
    assert MANIFEST["source"]["version"] == bundles.VERSION
    assert list(MANIFEST["estimators"]) == ["lite", "full", "heavy"]


@pytest.mark.parametrize("variant", bundles.VARIANTS)
def test_bundle_has_the_bytes_that_the_manifest_promises(variant):
    entry = MANIFEST["estimators"][variant]
    content = (ESTIMATORS / entry["file"]).read_bytes()
    assert len(content) == entry["bytes"]
    assert hashlib.sha256(content).hexdigest() == entry["sha256"]


@pytest.mark.parametrize("variant", bundles.VARIANTS)
def test_bundle_is_a_stored_zip_of_two_models_that_packs_again_to_the_same_bytes(variant):
    path = ESTIMATORS / MANIFEST["estimators"][variant]["file"]
    with zipfile.ZipFile(path) as archive:
        assert archive.namelist() == NAMES
        assert {item.compress_type for item in archive.infolist()} == {zipfile.ZIP_STORED}
        assert archive.testzip() is None
    assert bundles.pack_task(*read_models(variant)) == path.read_bytes()


@pytest.mark.parametrize("variant", bundles.VARIANTS)
def test_manifest_counts_are_those_of_the_models_inside(variant):
    entry = MANIFEST["estimators"][variant]
    detector, landmarks = (count_tflite(model) for model in read_models(variant))
    assert entry["flops"] == {
        "detector": detector.flops,
        "landmarks": landmarks.flops,
        "perCall": detector.flops + landmarks.flops,
    }
    assert entry["parameters"] == detector.parameters + landmarks.parameters
    assert entry["inputs"] == {"detector": [224, 224, 3], "landmarks": [256, 256, 3]}


@pytest.mark.parametrize("variant", bundles.VARIANTS)
def test_both_models_carry_the_metadata_that_tasks_asks_for(variant):
    for content in read_models(variant):
        model = tflite.Model.GetRootAs(content, 0)
        names = {model.Metadata(i).Name() for i in range(model.MetadataLength())}
        assert b"TFLITE_METADATA" in names


def test_first_layer_of_the_detector_by_hand():
    """Its stem: 3 x 3, stride 2, on 224 x 224 x 3, so 112 x 112 outputs of 27 products each."""
    detector, _ = read_models("lite")
    model = tflite.Model.GetRootAs(detector, 0)
    graph = model.Subgraphs(0)
    convs = [
        graph.Operators(i)
        for i in range(graph.OperatorsLength())
        if model.OperatorCodes(graph.Operators(i).OpcodeIndex()).DeprecatedBuiltinCode()
        == tflite.BuiltinOperator.CONV_2D
    ]
    stem = next(op for op in convs if graph.Tensors(op.Inputs(1)).Shape(3) == 3)
    out_channels, kernel_h, kernel_w, in_channels = graph.Tensors(stem.Inputs(1)).ShapeAsNumpy()
    assert (kernel_h, kernel_w, in_channels) == (3, 3, 3)
    alone = tiny_model(
        tflite.BuiltinOperator.CONV_2D,
        inputs=[[1, 224, 224, 3], [int(out_channels), 3, 3, 3]],
        output=[1, 112, 112, int(out_channels)],
    )
    assert count_tflite(alone).flops == 2 * 112 * 112 * 27 * int(out_channels)
    assert list(graph.Tensors(stem.Outputs(0)).ShapeAsNumpy()) == [1, 112, 112, out_channels]


@pytest.mark.parametrize(
    ("op", "inputs", "output", "macs"),
    [
        # 4 x 4 places, 5 kernels of 3 x 3 x 2
        ("CONV_2D", [[1, 4, 4, 2], [5, 3, 3, 2]], [1, 4, 4, 5], 16 * 5 * 18),
        # 2 x 2 places, 6 channels, each with a kernel of 3 x 3 of its own
        ("DEPTHWISE_CONV_2D", [[1, 4, 4, 6], [1, 3, 3, 6]], [1, 2, 2, 6], 4 * 6 * 9),
        # 7 outputs that are sums over 11
        ("FULLY_CONNECTED", [[1, 11], [7, 11]], [1, 7], 77),
        # each of 3 x 3 x 2 inputs is spread over 2 x 2 places in 4 channels
        ("TRANSPOSE_CONV", [[4], [4, 2, 2, 2], [1, 3, 3, 2]], [1, 6, 6, 4], 18 * 16),
        # two products of (3 x 5) and (5 x 4)
        ("BATCH_MATMUL", [[2, 3, 5], [2, 5, 4]], [2, 3, 4], 2 * 60),
        ("ADD", [[1, 8], [1, 8]], [1, 8], 0),
    ],
)
def test_counts_each_op_as_by_hand(op, inputs, output, macs):
    code = getattr(tflite.BuiltinOperator, op)
    assert count_tflite(tiny_model(code, inputs, output)).flops == 2 * macs


def test_the_convolution_formula_is_the_number_of_products_in_a_naive_loop():
    height, width, channels, kernel, out_channels = 5, 6, 3, 3, 4
    products = 0
    for _ in np.ndindex(height - kernel + 1, width - kernel + 1, out_channels):
        products += kernel * kernel * channels
    model = tiny_model(
        tflite.BuiltinOperator.CONV_2D,
        inputs=[[1, height, width, channels], [out_channels, kernel, kernel, channels]],
        output=[1, height - kernel + 1, width - kernel + 1, out_channels],
    )
    assert count_tflite(model).flops == 2 * products


def test_parameters_are_the_stored_floats_only():
    # The second input is stored; the first comes from outside.
    model = tiny_model(tflite.BuiltinOperator.FULLY_CONNECTED, [[1, 11], [7, 11]], [1, 7])
    assert count_tflite(model).parameters == 77


def test_bytes_that_are_no_model_are_refused():
    with pytest.raises(ValueError, match="no TensorFlow Lite model"):
        count_tflite(b"nothing of the kind")


def test_a_package_with_another_model_in_it_is_refused(tmp_path):
    tarball = tmp_path / bundles.TARBALL
    with tarfile.open(tarball, "w:gz") as archive:
        entry = tarfile.TarInfo(bundles.DETECTOR.member)
        entry.size = 5
        archive.addfile(entry, io.BytesIO(b"other"))
    with pytest.raises(UserError, match=r"has sha256 .*, expected a63c614b"):
        bundles.read_net(tarball, bundles.DETECTOR)


def test_a_broken_package_is_refused(tmp_path):
    tarball = tmp_path / bundles.TARBALL
    tarball.write_bytes(b"half a downl")
    with pytest.raises(UserError, match="cannot be read"):
        bundles.read_net(tarball, bundles.DETECTOR)


def tiny_model(op: int, inputs: list[list[int]], output: list[int]) -> bytes:
    """A TFLite model of one op; every input but the first is stored, as zeros, in float32."""
    builder = flatbuffers.Builder(1024)

    def vector(items: list[int]) -> int:
        return builder.CreateNumpyVector(np.array(items, np.int32))

    def offsets(start, items: list[int]) -> int:
        start(builder, len(items))
        for item in reversed(items):
            builder.PrependUOffsetTRelative(item)
        return builder.EndVector()

    buffers = []
    for index, shape in enumerate([*inputs, output]):
        stored = 0 < index < len(inputs)
        data = builder.CreateByteVector(bytes(4 * int(np.prod(shape)))) if stored else None
        tflite.BufferStart(builder)
        if data is not None:
            tflite.BufferAddData(builder, data)
        buffers.append(tflite.BufferEnd(builder))

    tensors = []
    for index, shape in enumerate([*inputs, output]):
        sizes = vector(shape)
        tflite.TensorStart(builder)
        tflite.TensorAddShape(builder, sizes)
        tflite.TensorAddType(builder, tflite.TensorType.FLOAT32)
        tflite.TensorAddBuffer(builder, index)
        tensors.append(tflite.TensorEnd(builder))

    op_inputs, op_outputs = vector(list(range(len(inputs)))), vector([len(inputs)])
    tflite.OperatorStart(builder)
    tflite.OperatorAddOpcodeIndex(builder, 0)
    tflite.OperatorAddInputs(builder, op_inputs)
    tflite.OperatorAddOutputs(builder, op_outputs)
    operator = tflite.OperatorEnd(builder)

    # The converter names the input that comes from outside, whichever place it has in the op.
    graph_inputs, graph_outputs = vector([0]), vector([len(inputs)])
    all_tensors = offsets(tflite.SubGraphStartTensorsVector, tensors)
    all_operators = offsets(tflite.SubGraphStartOperatorsVector, [operator])
    tflite.SubGraphStart(builder)
    tflite.SubGraphAddTensors(builder, all_tensors)
    tflite.SubGraphAddInputs(builder, graph_inputs)
    tflite.SubGraphAddOutputs(builder, graph_outputs)
    tflite.SubGraphAddOperators(builder, all_operators)
    graph = tflite.SubGraphEnd(builder)

    tflite.OperatorCodeStart(builder)
    tflite.OperatorCodeAddDeprecatedBuiltinCode(builder, min(op, 127))
    tflite.OperatorCodeAddBuiltinCode(builder, op)
    code = tflite.OperatorCodeEnd(builder)

    codes = offsets(tflite.ModelStartOperatorCodesVector, [code])
    graphs = offsets(tflite.ModelStartSubgraphsVector, [graph])
    all_buffers = offsets(tflite.ModelStartBuffersVector, buffers)
    tflite.ModelStart(builder)
    tflite.ModelAddVersion(builder, 3)
    tflite.ModelAddOperatorCodes(builder, codes)
    tflite.ModelAddSubgraphs(builder, graphs)
    tflite.ModelAddBuffers(builder, all_buffers)
    builder.Finish(tflite.ModelEnd(builder), b"TFL3")
    return bytes(builder.Output())

"""The number fixtures against this package's own functions, which did not make them."""

import json

import numpy as np
import onnxruntime
import pytest

from deciwatch.fixture_estimators import HEIGHT, MODELS, SPLIT, STRIDE, WIDTH
from deciwatch.fixture_numbers import interpolation_cases, metric_cases, normalise_cases
from deciwatch.fixture_stitching import stitching_cases
from deciwatch.interpolate import interpolate
from deciwatch.metrics import accel, mpjpe, pck
from deciwatch.normalise import SCALE_3D, window_box
from deciwatch.paths import FIXTURES


def read(name: str) -> dict:
    return json.loads((FIXTURES / f"{name}.json").read_text())


def test_normalise():
    fixture = read("normalise")
    for case in fixture["windowBox"]:
        shape = (case["samples"], case["keypoints"], 2)
        pixels = np.array(case["pixels"]).reshape(shape)
        centre, scale = window_box(pixels)
        np.testing.assert_allclose(centre, case["centre"])
        assert scale == pytest.approx(case["scale"])
        np.testing.assert_allclose(
            ((pixels - centre) / scale).ravel(), case["normalised"], atol=1e-8
        )
    assert fixture["scale"]["scale"] == SCALE_3D


def test_interpolation():
    for case in read("interpolation")["cases"]:
        for method, expected in case["results"].items():
            got = interpolate(
                np.array(case["times"]), np.array(case["values"]), np.array(case["queries"]), method
            )
            np.testing.assert_allclose(got, expected, atol=1e-8, err_msg=case["name"])


def test_metrics():
    for case in read("metrics")["cases"]:
        shape = (case["frames"], case["keypoints"], case["dims"])
        poses, truth = (np.array(case[name]).reshape(shape) for name in ("poses", "truth"))
        assert mpjpe(poses, truth) == pytest.approx(case["mpjpe"])
        assert accel(poses, truth) == pytest.approx(case["accel"])
        for alpha, share in case.get("pck", {}).items():
            assert pck(poses, truth, float(alpha)) == pytest.approx(share)


def test_the_committed_numbers_can_be_made_again():
    made = {"normalise": normalise_cases(5), "interpolation": interpolation_cases(5)}
    made |= {"metrics": metric_cases(5), "stitching": stitching_cases(5)}
    for name, content in made.items():
        assert json.loads(json.dumps(content)) == read(name)


@pytest.mark.parametrize("name", MODELS)
def test_the_estimators_find_colours(name):
    """The committed models, and those made now, on a picture with one spot of each colour."""
    places = ((12, 20), (30, 40), (36, 8))
    rows, columns = np.mgrid[:HEIGHT, :WIDTH]
    spots = [np.hypot(columns - x, rows - y) <= 4 for x, y in places]
    picture = np.stack(spots)[None].astype(np.float32)
    for model in ((FIXTURES / "onnx-estimators" / name).read_bytes(), MODELS[name]()):
        outputs = onnxruntime.InferenceSession(model).run(None, {"input": picture})
        for k, (x, y) in enumerate(places):
            if name == "heatmap.onnx":
                cell = np.unravel_index(outputs[0][0, k].argmax(), outputs[0].shape[2:])
                assert (cell[1] * STRIDE, cell[0] * STRIDE) == pytest.approx((x, y), abs=STRIDE / 2)
            else:
                bins = [axis[0, k].argmax() / SPLIT for axis in outputs]
                assert bins == pytest.approx([x, y], abs=1 / SPLIT)
            assert all(0.4 < axis[0, k].max() < 1.5 for axis in outputs)

"""`evaluate --pairs`, `baselines` and `evaluate --labelling` as commands."""

import json

import numpy as np
import pytest
import torch

from deciwatch import checkpoint
from deciwatch.__main__ import main
from deciwatch.evaluation.method import METHODS
from deciwatch.nets.pair import Pair, PairConfig
from deciwatch.paths import FIXTURES
from made_up_pairs import pair_arrays, write_pairs

NETS = ("--models", str(FIXTURES / "models"))
KEYS = {"method", "interval", "estimator", "mpjpe_mm", "pa_mpjpe_mm", "accel_mm", "pck_20"}
KEYS |= {"pck_10", "pck_05", "mpjpe_px", "accel_px", "flops_per_frame", "ms_per_frame", "frames"}
KEYS |= {"groups"}


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """Pair files of two estimators, and baselines fitted on others."""
    folder = tmp_path_factory.mktemp("pairs")
    lite = pair_arrays(1, noise=0.06, lost=(50,)) | {"estimator": np.array("mediapipe-lite")}
    made = {"full": pair_arrays(0), "lite": lite, "train": pair_arrays(2), "val": pair_arrays(3)}
    paths = {name: write_pairs(folder / f"{name}.npz", arrays) for name, arrays in made.items()}
    paths["baselines"] = str(folder / "baselines.npz")
    options = ("--pairs", paths["train"], "--val-pairs", paths["val"], "--steps", "60")
    assert main(["baselines", *options, "--out", paths["baselines"]]) == 0
    return paths


def rows(capsys, *options: str) -> tuple[dict, str]:
    """Rows by (estimator, method, interval) of JSON on stdout, and what stderr says."""
    assert main(["evaluate", *NETS, *options, "--json"]) == 0
    said = capsys.readouterr()
    table = json.loads(said.out)["rows"]
    return {(row["estimator"], row["method"], row["interval"]): row for row in table}, said.err


def test_all_methods_of_two_estimators(capsys, files):
    both = (files["full"], files["lite"])
    got, said = rows(capsys, "--pairs", *both, "--every", "1,10", "--baselines", files["baselines"])
    full = [(method, n) for estimator, method, n in got if estimator == "mediapipe-full"]
    assert {method for method, _ in full} == set(METHODS)
    assert len(full) == 4 + 2 * 7
    assert "every_frame_calibrated is left out for mediapipe-lite" in said
    for row in got.values():
        assert row.keys() == KEYS and len(row["groups"]) == 6
        assert all(row[key] is not None for key in KEYS)
        # Files of one truth are scored on the frames that both have: 7, 50 and 130 are lost.
        assert row["frames"] == 162
    every, ten = got["mediapipe-full", "every_frame", 1], got["mediapipe-full", "linear", 10]
    assert ten["flops_per_frame"] == round(every["flops_per_frame"] * 19 / 165)
    assert got["mediapipe-full", "linear", 1]["mpjpe_mm"] == every["mpjpe_mm"]
    for better in ("one_euro", "smoothnet"):
        row = got["mediapipe-full", better, 1]
        assert row["mpjpe_mm"] < every["mpjpe_mm"] and row["accel_px"] < every["accel_px"]
    assert got["mediapipe-lite", "every_frame", 1]["mpjpe_px"] > every["mpjpe_px"]


def test_a_stranger_s_file(capsys, tmp_path):
    """Other keypoints, 2D alone, no estimator's name: what can be scored is, the rest is told."""
    arrays = pair_arrays()
    mine = {"pred": arrays["pred_2d"][:, :17], "gt": arrays["gt_2d"][:, :17]}
    mine |= {name: arrays[name] for name in ("start", "length")}
    options = ("--every", "10", "--baselines", str(tmp_path / "none.npz"))
    path = write_pairs(tmp_path / "mine.npz", mine)
    got, said = rows(capsys, "--pairs", path, *options)
    assert {method for _, method, _ in got} == {
        "every_frame", "nearest", "linear", "quadratic", "cubic"
    }  # fmt: skip
    row = got["mine", "cubic", 10]
    assert row["mpjpe_mm"] is None and row["flops_per_frame"] is None and row["groups"] == {}
    assert row["mpjpe_px"] > 0 and 0 < row["pck_05"] <= 1
    assert "33 keypoints" in said and "one_euro is left out" in said
    three = {name: arrays[name] for name in ("pred", "gt", "start", "length")}
    got, said = rows(capsys, "--pairs", write_pairs(tmp_path / "three.npz", three), *options)
    assert "3D nets are left out for three: they need 2d and scores" in said
    assert ("three", "linear", 10) in got and ("three", "deciwatch", 10) not in got


def test_the_table_and_chosen_methods(capsys, files, tmp_path):
    path = tmp_path / "rows.json"
    options = ("--every", "5,10", "--methods", "deciwatch,linear", "--json", str(path))
    assert main(["evaluate", "--pairs", files["full"], *NETS, *options]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert "163 of 165 frames" in lines[0]
    body = [line for line in lines if line.startswith("mediapipe-full  ")]
    assert len({len(line) for line in body[:4]}) == 1 and len(body) == 8
    written = json.loads(path.read_text())
    assert [(row["method"], row["interval"]) for row in written["rows"]] == [
        ("linear", 5), ("linear", 10), ("deciwatch", 5), ("deciwatch", 10)
    ]  # fmt: skip


def test_checkpoints_of_one_representation(capsys, files, tmp_path):
    pair = Pair(PairConfig(dims=3, width=8, blocks=1))
    checkpoint.save(tmp_path / "3d.pt", pair.config, pair.state_dict(), {})
    options = ("--every", "10", "--methods", "deciwatch,cubic")
    nets = ("--checkpoint-3d", str(tmp_path / "3d.pt"))
    got, _ = rows(capsys, "--pairs", files["full"], *options, *nets)
    ours = got["mediapipe-full", "deciwatch", 10]
    assert ours["mpjpe_mm"] > 0 and ours["mpjpe_px"] is None
    assert got["mediapipe-full", "cubic", 10]["mpjpe_px"] > 0


def test_complaints(capsys, files, tmp_path):
    estimated = np.arange(165) % 4 == 0
    sparse = write_pairs(tmp_path / "sparse.npz", pair_arrays() | {"estimated": estimated})
    (tmp_path / "broken.npz").write_bytes(b"no")
    for options, part in (
        (("evaluate", "--pairs", files["full"], files["full"]), "both of mediapipe-full"),
        (("evaluate", "--pairs", sparse), "No sequence"),
        (("evaluate", "--pairs", files["full"], "--checkpoint", "x.pt"), "--checkpoint-3d"),
        (
            ("evaluate", "--pairs", files["full"], "--baselines", str(tmp_path / "broken.npz")),
            "not a baselines file",
        ),
        (("baselines", "--pairs", sparse, "--val-pairs", files["val"]), "estimated at every frame"),
    ):
        assert main([*options]) == 2
        text = capsys.readouterr().err.strip()
        assert part in text and text.endswith(".") and "\n" not in text


def test_labelling(capsys, tmp_path, data):
    torch.manual_seed(0)
    pair = Pair(PairConfig(dims=3, width=8, blocks=1, denoise=False, recover="samples"))
    checkpoint.save(tmp_path / "label.pt", pair.config, pair.state_dict(), {})
    options = ("--labelling", "--data", str(data), "--split", "val", "--every", "10")
    got, _ = rows(capsys, *options, "--checkpoint", str(tmp_path / "label.pt"))
    assert [method for _, method, _ in got] == [
        "nearest", "linear", "quadratic", "cubic", "deciwatch"
    ]  # fmt: skip
    errors = {method: row["mpjpe_mm"] for (_, method, _), row in got.items()}
    # An untrained net is its W_PR, a cubic through the samples.
    assert errors["nearest"] > errors["linear"] > errors["deciwatch"]
    assert len({row["frames"] for row in got.values()}) == 1

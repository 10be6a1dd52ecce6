"""The command line: quick help, one sentence and exit code 2 for bad input, real results."""

import json
import subprocess
import sys

import numpy as np
import pytest
import torch

from deciwatch.__main__ import COMMANDS, main

OURS = (
    *("train", "export", "import-official", "evaluate", "baselines", "fixtures"),
    *("study", "results"),
)


def complaint(capsys, *arguments: str) -> str:
    assert main(list(arguments)) == 2
    text = capsys.readouterr().err.strip()
    assert text.endswith(".") and "\n" not in text and "Traceback" not in text
    return text


@pytest.mark.parametrize("command", OURS)
def test_help_needs_no_torch(command):
    code = (
        "import sys; from deciwatch.__main__ import main\n"
        f"try: main(['{command}', '--help'])\n"
        "except SystemExit as stop: assert not stop.code\n"
        "assert not {'torch', 'onnx', 'scipy'} & set(sys.modules)"
    )
    got = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert got.returncode == 0, got.stderr
    assert f"usage: deciwatch {command}" in got.stdout


def test_the_list_of_commands(capsys):
    assert main(["--help"]) == 0
    out = capsys.readouterr().out
    assert all(command in out for command in COMMANDS)
    assert main([]) == 2
    assert "no command 'trian'" in complaint(capsys, "trian")


def test_missing_data(capsys, tmp_path, monkeypatch):
    for command in ("train", "evaluate"):
        missing = str(tmp_path / "none")
        assert missing in complaint(capsys, command, "--data", missing)
        assert "neither" in complaint(capsys, command, "--data", str(tmp_path))
    monkeypatch.setenv("DECIWATCH_DATA", str(tmp_path / "elsewhere"))
    assert "elsewhere" in complaint(capsys, "evaluate")


def test_damaged_data(capsys, tmp_path):
    for part in ("", "_rot"):
        (tmp_path / f"cmu30_test{part}.npz").write_bytes(b"not a zip")
    assert "cannot be read" in complaint(capsys, "evaluate", "--data", str(tmp_path))


@pytest.mark.parametrize(
    ("arguments", "part"),
    [
        (("evaluate", "--every", "21"), "--every 21"),
        (("evaluate", "--every", "0"), "--every 0"),
        (("evaluate", "--every", "5,x"), "--every 5,x"),
        (("evaluate", "--every", "5,10"), "one interval"),
        (("evaluate", "--pairs", "/nowhere/x.npz"), "/nowhere/x.npz"),
        (("evaluate", "--pairs", "x.npz", "--methods", "magic"), "--methods magic"),
        (("evaluate", "--labelling", "--checkpoint", "/nowhere/label.pt"), "/nowhere/label.pt"),
        (("evaluate", "--window", "11"), "--window 11"),
        (("train", "--minutes", "0"), "--minutes 0"),
        (("train", "--width", "30"), "--width 30"),
        (("train", "--dropout", "1.5"), "--dropout 1.5"),
        (("export", "--checkpoint", "/nowhere/3d.pt"), "/nowhere/3d.pt"),
        (("export", "--dims", "2", "--checkpoint", "export/checkpoints/3d.pt"), "3D pair"),
        (("fixtures", "--checkpoint-3d", "/nowhere/3d.pt"), "/nowhere/3d.pt"),
    ],
)
def test_bad_options(capsys, monkeypatch, arguments, part):
    from deciwatch.paths import REPOSITORY

    monkeypatch.chdir(REPOSITORY)
    assert part in complaint(capsys, *arguments)


def test_models_that_are_not_there_or_damaged(capsys, tmp_path, data):
    options = ("evaluate", "--data", str(data), "--models", str(tmp_path))
    assert "no manifest" in complaint(capsys, *options)
    (tmp_path / "manifest.json").write_text('{"format": "deciwatch-models/2", "pairs": {}}')
    assert "no 3D nets" in complaint(capsys, *options)
    (tmp_path / "manifest.json").write_text('{"format": "recipes/1"}')
    assert "models manifest" in complaint(capsys, *options)


def test_deciwatch_is_ahead_of_every_interpolation(capsys, tmp_path, data):
    for dims, unit in ((3, "mm"), (2, "px")):
        file = tmp_path / f"{dims}.json"
        options = ("--data", str(data), "--dims", str(dims), "--json", str(file))
        assert main(["evaluate", *options]) == 0
        rows = {row["method"]: row for row in json.loads(file.read_text())["rows"]}
        ours = rows.pop("deciwatch")
        assert ours["interval"] == 10 and rows["every_frame"]["interval"] == 1
        for name, row in rows.items():
            assert ours[f"mpjpe_{unit}"] < row[f"mpjpe_{unit}"], (dims, name)
        assert ours[f"accel_{unit}"] < rows["every_frame"][f"accel_{unit}"] / 4
        assert "deciwatch" in capsys.readouterr().out


def test_a_rounded_checkpoint_and_its_exported_graphs_score_the_same(
    tmp_path, data, rounded_checkpoint
):
    scores = []
    for source in ([], ["--checkpoint", str(rounded_checkpoint(3))]):
        file = tmp_path / "rows.json"
        options = ["--split", "val", "--every", "5", "--window", "4", "--json", str(file)]
        assert main(["evaluate", "--data", str(data), *options, *source]) == 0
        scores.append([row["mpjpe_mm"] for row in json.loads(file.read_text())["rows"]])
    np.testing.assert_allclose(scores[0], scores[1], atol=1e-3)


def test_train_export_and_resume_by_command(tmp_path, monkeypatch, data, capsys):
    monkeypatch.setattr("deciwatch.train.RUNS", tmp_path)
    small = ["--data", str(data), "--dims", "2", "--width", "8", "--blocks", "1", "--name", "tiny"]
    assert main(["train", *small, "--steps", "2"]) == 0
    assert main(["train", *small, "--steps", "3", "--resume"]) == 0
    assert '"step": 3' in capsys.readouterr().out
    out = tmp_path / "models"
    last = str(tmp_path / "tiny" / "last.pt")
    assert main(["export", "--dims", "2", "--checkpoint", last, "--out", str(out)]) == 0
    names = sorted(path.name for path in out.iterdir())
    assert names == ["2d-denoise.onnx", "2d-recover.onnx", "manifest.json"]
    pairs = json.loads((out / "manifest.json").read_text())["pairs"]
    assert list(pairs) == ["2d"] and pairs["2d"]["training"]["steps"] == 3
    assert main(["train", *small, "--steps", "1", "--start-from", last]) == 0
    assert main(["train", *small, "--steps", "2", "--resume"]) == 0
    training = torch.load(last, weights_only=True)["training"]
    assert training["steps"] == 5 and training["windows"] > 0
    wider = [word if word != "8" else "12" for word in small]
    assert "not a running training" in complaint(capsys, "train", *wider, "--resume")

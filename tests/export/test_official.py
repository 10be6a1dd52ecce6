"""Checkpoints in the authors' format: through import-official to graphs that give the same."""

import dataclasses
import hashlib
import json

import numpy as np
import pytest
import torch

from deciwatch import manifest
from deciwatch.__main__ import main
from deciwatch.flops import GraphCounter
from deciwatch.official.blocks import not_itself
from deciwatch.official.check import difference_from_reference, reference_case
from deciwatch.official.config import OfficialConfig
from deciwatch.official.convert import write_pair
from deciwatch.official.fit import fitting_weights
from deciwatch.official.fixture import CONFIGS, cases
from deciwatch.official.pair import pair_of
from deciwatch.official.read import read_state
from deciwatch.official.reference import Reference, random_reference
from deciwatch.official.write import save
from deciwatch.onnx_export import TOLERANCE
from deciwatch.paths import FIXTURES

SMALL = OfficialConfig(
    99, 10, 3, hidden=16, heads=4, feed_forward=24, encoder_layers=2, decoder_layers=2
)
OPTIONS = {"--input-dim": 99, "--sample-interval": 10, "--window-q": 3, "--hidden": 16}
OPTIONS |= {"--feed-forward": 24, "--encoder-layers": 2, "--decoder-layers": 2}


@pytest.fixture
def checkpoint(tmp_path):
    path = tmp_path / "checkpoint.pth.tar"
    save(path, random_reference(SMALL, seed=2))
    return path


def command(path, out, **changed) -> list[str]:
    options = OPTIONS | {f"--{name.replace('_', '-')}": value for name, value in changed.items()}
    words = [str(word) for option in options.items() for word in option if word is not True]
    return ["import-official", str(path), "--out", str(out), *words]


def complaint(capsys, *arguments: str) -> str:
    assert main(list(arguments)) == 2
    text = capsys.readouterr().err.strip()
    assert text.endswith(".") and "\n" not in text
    return text


@pytest.mark.parametrize(
    ("pre_norm", "prefix", "interval", "window_q"),
    [(True, "transformer.", 10, 3), (False, "module.transformer.", 7, 1)],
)
def test_the_graphs_give_what_the_authors_way_gives(tmp_path, pre_norm, prefix, interval, window_q):
    config = dataclasses.replace(
        SMALL, pre_norm=pre_norm, interval=interval, window_q=window_q, decoder_layers=1
    )
    path = tmp_path / "checkpoint.pth.tar"
    save(path, random_reference(config, seed=1), prefix)
    given = read_state(path)
    assert write_pair(given, config, path, 1.0, tmp_path) <= TOLERANCE
    graphs = {kind: tmp_path / manifest.file_name(3, kind) for kind in manifest.KINDS}
    weights = fitting_weights(given, config, path)
    assert difference_from_reference(weights, config, graphs, seed=9) <= TOLERANCE
    counted = sum(GraphCounter(path).parameters() for path in graphs.values())
    assert counted == sum(weight.numel() for weight in weights.values())


@pytest.mark.parametrize(("interval", "window_q", "pre_norm"), [(10, 3, True), (1, 4, False)])
@torch.no_grad()
def test_positions_come_from_times(interval, window_q, pre_norm):
    config = dataclasses.replace(
        SMALL, interval=interval, window_q=window_q, pre_norm=pre_norm, heads=2
    )
    reference = random_reference(config, seed=4)
    pair = pair_of(reference.state_dict(), config)
    case = {name: torch.from_numpy(x) for name, x in reference_case(reference, seed=0).items()}
    sampled, *times = (case[name] for name in ("sampled", "sample_times", "frame_times"))
    clean, poses = pair(sampled, *(at + 40 for at in times))
    torch.testing.assert_close(clean, case["clean"], atol=1e-5, rtol=0)
    torch.testing.assert_close(poses, case["poses"], atol=1e-5, rtol=0)


@torch.no_grad()
def test_a_sample_attends_to_the_others_alone():
    pair = pair_of(random_reference(SMALL, seed=0).state_dict(), SMALL)
    block = pair.denoise.encoder.layers[0]
    tokens = torch.randn(1, 2, 16, generator=torch.Generator().manual_seed(1))
    taken = block.attend(tokens, torch.zeros_like(tokens), not_itself(torch.tensor([[0.0, 10.0]])))
    torch.testing.assert_close(
        taken, block.self_attn.out_proj(block.self_attn.value(tokens.flip(1)))
    )
    # Where there is no other one, it must not turn into NaN.
    alone, _ = pair.denoise(torch.ones(1, 1, 99), torch.zeros(1, 1))
    assert alone.isfinite().all()


def test_the_command_writes_a_folder_for_the_page(checkpoint, tmp_path, capsys):
    out = tmp_path / "models"
    assert main(command(checkpoint, out, scale=0.5)) == 0
    said = capsys.readouterr().out
    assert "pre-norm" in said and "2D nets beside them are copied" in said
    assert "windows of 10 intervals, longer than the 3" in said
    pairs = manifest.read(out)["pairs"]
    assert list(pairs) == ["3d", "2d"]
    assert pairs["3d"]["normalisation"] == {"3d": {"kind": "scale", "scale": 0.5}}
    assert pairs["3d"]["interval"] == [10, 10] and pairs["3d"]["keypoints"] == 33
    for pair in pairs.values():
        for kind in manifest.KINDS:
            content = (out / pair[kind]["file"]).read_bytes()
            assert pair[kind]["sha256"] == hashlib.sha256(content).hexdigest()


def test_other_keypoints_are_written_and_said_to_be_of_no_use_to_the_page(tmp_path, capsys):
    path, out = tmp_path / "h36m.pth.tar", tmp_path / "models"
    layers = {"encoder_layers": 1, "decoder_layers": 1}
    save(path, random_reference(dataclasses.replace(SMALL, input_dim=51, **layers), seed=2))
    assert main(command(path, out, input_dim=51, **layers)) == 0
    assert "take 17" in capsys.readouterr().out
    assert manifest.read(out)["pairs"]["3d"]["keypoints"] == 17


@pytest.mark.parametrize(
    ("changed", "parts"),
    [
        (
            {"hidden": 32},
            ["wants --hidden 16;", "encoder_embed.weight is [16, 99] instead of [32, 99]."],
        ),
        ({"input_dim": 51}, ["wants --input-dim 99;"]),
        ({"feed_forward": 32}, ["layers.0.linear1.weight is [24, 16] instead of [32, 16]."]),
        ({"encoder_layers": 3}, ["transformer.encoder.layers.2.* is missing."]),
        ({"decoder_layers": 1}, ["transformer.decoder.layers.1.* is not expected."]),
        ({"post_norm": True}, ["wants --pre-norm;", "encoder.norm.bias is not expected"]),
        ({"heads": 3}, ["--hidden 16", "--heads 3"]),
        ({"input_dim": 100}, ["--input-dim 100"]),
        ({"window_q": 0}, ["--window-q 0"]),
        ({"scale": -1}, ["--scale -1"]),
    ],
)
def test_what_does_not_fit_is_named(checkpoint, tmp_path, capsys, changed, parts):
    text = complaint(capsys, *command(checkpoint, tmp_path / "out", **changed))
    assert all(part in text for part in parts), text
    assert not (tmp_path / "out").exists()


def test_every_wrong_key_is_named(checkpoint, tmp_path, capsys):
    content = torch.load(checkpoint, weights_only=True)
    weights = content["state_dict"]
    weights["transformer.encoder.layers.1.lineal1.bias"] = weights.pop(
        "transformer.encoder.layers.1.linear1.bias"
    )
    weights["transformer.decoder_embed.weight"] = torch.zeros(16, 99, 3)
    weights["transformer.decoder.norm.weight"][3] = float("nan")
    weights["transformer.encoder_joints_embed.bias"] = 7
    torch.save(content, checkpoint)
    text = complaint(capsys, *command(checkpoint, tmp_path / "out"))
    for part in (
        "transformer.decoder_embed.weight is [16, 99, 3] instead of [16, 99, 5]",
        "transformer.encoder.layers.1.linear1.bias is missing",
        "transformer.encoder.layers.1.lineal1.bias is not expected",
        "transformer.decoder.norm.weight has values that are not finite",
        "transformer.encoder_joints_embed.bias is of type int instead of a tensor [99]",
    ):
        assert part in text


class Stranger:
    """Something that only a pickle that runs code could bring back."""


def test_no_code_of_a_file_is_run_but_their_trainers_numbers_pass(checkpoint, tmp_path, capsys):
    content = torch.load(checkpoint, weights_only=True)
    torch.save(content | {"performance": {"mpjpe": np.float64(53.02)}}, checkpoint)
    assert read_state(checkpoint).keys() == content["state_dict"].keys()
    torch.save(content | {"performance": Stranger()}, checkpoint)
    text = complaint(capsys, *command(checkpoint, tmp_path / "out"))
    assert "Stranger" in text and "save only its state_dict" in text
    checkpoint.write_bytes(b"not torch's")
    assert "damaged" in complaint(capsys, *command(checkpoint, tmp_path / "out"))
    torch.save(content["state_dict"], checkpoint)
    assert read_state(checkpoint).keys() == content["state_dict"].keys()
    torch.save({"epoch": 3, "state_dict": [1]}, checkpoint)
    assert "no state_dict" in complaint(capsys, *command(checkpoint, tmp_path / "out"))
    assert "no checkpoint" in complaint(capsys, *command(tmp_path / "none", tmp_path / "out"))


def test_the_reference_has_the_published_names():
    names = set(Reference(SMALL).state_dict())
    assert {
        *(f"encoder_embed.{x}" for x in ("weight", "bias")),
        "encoder.layers.1.self_attn.in_proj_weight",
        "encoder.layers.1.self_attn.out_proj.bias",
        "encoder.norm.weight",
        "encoder_joints_embed.bias",
        "decoder_embed.weight",
        "decoder.layers.1.multihead_attn.in_proj_bias",
        "decoder.layers.1.norm3.bias",
        "decoder.norm.bias",
        "decoder_joints_embed.weight",
    } <= names
    post = Reference(dataclasses.replace(SMALL, pre_norm=False)).state_dict()
    assert names - set(post) == {"encoder.norm.weight", "encoder.norm.bias"}


def test_the_committed_fixture_can_be_made_again():
    folder = FIXTURES / "official"
    committed = json.loads((folder / "cases.json").read_text())
    made = json.loads(json.dumps(cases(5)))
    pairs = manifest.read(folder)["pairs"]
    for name, config in CONFIGS.items():
        for key, value in made[name].items():
            assert value["dims"] == committed[name][key]["dims"]
            np.testing.assert_allclose(value["data"], committed[name][key]["data"], atol=1e-6)
        weights = random_reference(config, 5).state_dict()
        graphs = {kind: folder / pairs[name][kind]["file"] for kind in manifest.KINDS}
        assert difference_from_reference(weights, config, graphs, seed=5) <= TOLERANCE
    assert sum(path.stat().st_size for path in folder.iterdir()) < 300_000

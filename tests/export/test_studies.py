"""The studies' own measurements on made-up pairs, and what docs/results.md says of numbers."""

import json
from itertools import pairwise

import numpy as np
import pytest

from deciwatch.__main__ import main
from deciwatch.data.noise_file import save_noise
from deciwatch.data.residuals import ResidualNoise
from deciwatch.nets.pair import PairConfig
from deciwatch.paths import FIXTURES, REPOSITORY
from deciwatch.sampling.watched import watched_frames
from deciwatch.skeleton import mid_hip
from deciwatch.studies.charts.style import apart
from deciwatch.studies.measured import Measured, read_measured
from deciwatch.studies.page import write_page
from deciwatch.studies.schemes import SCHEMES
from deciwatch.studies.variants import VALUES, Settings, variants
from deciwatch.studies.words import against, listed, percent

BASE = Settings(PairConfig(inputs=("3d", "2d", "scores"), recover="samples", width=64, blocks=3))

TINY = BASE.changed("width", 8).changed("blocks", 1)


@pytest.fixture(scope="module")
def files(motions, tmp_path_factory):
    """A folder with pairs of the made-up recordings, staged truth and a noise model."""
    folder = tmp_path_factory.mktemp("pairs")
    rng = np.random.default_rng(2)
    truth = (motions.landmarks - mid_hip(motions.landmarks)).astype(np.float32)
    flat = 300 + 200 * truth[..., :2]
    sequences = {"start": motions.start, "length": motions.length, "fps": np.array(30.0)}
    noisy = truth + 0.03 * rng.standard_normal(truth.shape, dtype=np.float32)
    pairs = {"pred": noisy - mid_hip(noisy), "gt": truth, "gt_2d": flat}
    pairs |= {"pred_2d": flat + rng.standard_normal(flat.shape, dtype=np.float32)}
    pairs |= {"scores": rng.uniform(0.3, 1, truth.shape[:2]).astype(np.float32)}
    np.savez(folder / "pairs.npz", **pairs, **sequences, estimator=np.array("mediapipe-full"))
    np.savez(folder / "truth.npz", gt=truth, gt_2d=flat, **sequences)
    shapes = {"bias": (100, 198), "lasting": (1, 198), "lasting_rest": 198, "own": (1, 198)}
    shapes |= {"own_rest": 198, "own_scale": 198, "by_score": (2, 33), "score_mean": 33}
    shapes |= {"clip_sizes": 1, "sample_sizes": 1, "share": (), "seconds": (), "swaps": 3}
    noise = {name: np.full(shape, 0.02, np.float32) for name, shape in shapes.items()}
    save_noise(folder / "noise.npz", ResidualNoise(**noise))
    return folder


def study(files, *words, out):
    test = ["--test", str(files / "pairs.npz"), "--out", str(out)]
    assert main(["study", *words, *test]) == 0
    return json.loads(out.read_text())


def test_every_variant_differs_from_the_base_in_one_thing():
    every = variants(BASE)
    assert len({variant.name for variant in every}) == len(every)
    assert len(every) == 1 + sum(len(values) - 1 for values in VALUES.values())
    for variant in every[1:]:
        ours, theirs = variant.settings.as_dict(), BASE.as_dict()
        assert [key for key in ours if ours[key] != theirs[key]] == list(variant.differs)
    names = {variant.name for variant in every}
    assert {"width-192", "lam-2", "inputs-3d-scores", "data-noise"} <= names
    assert "width-64" not in names and "width-128" in names


def test_variants_are_trained_scored_and_taken_up_again(files, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("deciwatch.studies.train_variants.RUNS", tmp_path)
    monkeypatch.setattr("deciwatch.studies.train_variants.base_settings", lambda path: TINY)
    paths = ["--pairs", "pairs.npz", "--truth", "truth.npz", "--noise-model", "noise.npz"]
    paths = [str(files / word) if word.endswith(".npz") else word for word in paths]
    out = tmp_path / "variants.json"
    first = study(files, "train", "--steps", "2", "--only", "base,recover", *paths, out=out)
    base, frames = first["rows"]
    assert (base["name"], frames["name"]) == ("base", "recover-frames")
    assert frames["differs"] == {"recover": "frames"} and frames["steps"] == 2
    assert base["flops_per_window"] < frames["flops_per_window"]
    assert base["windows"] > 0 and base["parameters"] > 10_000
    assert 0 < base["no_recover"]["mpjpe_mm"] < 100 and base["mpjpe_mm"] > 0
    assert first["base"]["width"] == 8 and first["test"]["estimator"] == "mediapipe-full"

    capsys.readouterr()
    second = study(files, "train", "--steps", "2", "--only", "base,data-noise", *paths, out=out)
    assert "base: is in variants.json" in capsys.readouterr().err
    assert second["rows"][:2] == first["rows"] and second["rows"][2]["name"] == "data-noise"
    options = ["--test", str(files / "pairs.npz"), "--out", str(out), *paths]
    assert main(["study", "train", "--steps", "3", *options]) == 2
    assert "other steps" in capsys.readouterr().err
    assert main(["study", "train", "--only", "bass", *options]) == 2
    assert "--only bass is no variant" in capsys.readouterr().err


@pytest.mark.parametrize("name", SCHEMES)
def test_a_scheme_spends_the_budget_and_keeps_both_ends(name):
    for frames in (*range(1, 60), 203):
        watched = SCHEMES[name](np.random.default_rng(5), frames, 10)
        assert len(watched) == len(watched_frames(frames, 10)), frames
        assert watched[0] == 0 and watched[-1] == frames - 1 and (np.diff(watched) > 0).all()
    gaps = np.diff(watched)
    if name == "uniform_3":
        assert watched[:3].tolist() == [0, 1, 2] and sorted(set(gaps))[1] > 20
    if name == "random":
        assert not np.array_equal(watched, SCHEMES[name](np.random.default_rng(6), 203, 10))


def test_sampling_and_window_run_the_shipped_kind_of_nets(files, tmp_path):
    models = ["--models", str(FIXTURES / "models")]
    sampling = study(files, "sampling", *models, out=tmp_path / "sampling.json")
    rows = {(row["scheme"], row["draw"], row["method"]): row for row in sampling["rows"]}
    assert len({row["watched"] for row in rows.values()}) == 1
    assert ("random", 2, "deciwatch") in rows and ("uniform", 1, "linear") not in rows
    # Straight lines over long gaps are worse on any motion.
    assert rows["uniform", 0, "linear"]["mpjpe_mm"] < rows["random", 0, "linear"]["mpjpe_mm"]
    assert rows["uniform", 0, "linear"]["longest_gap"] == 10

    window = study(files, "window", *models, out=tmp_path / "window.json")
    assert [row["window"] for row in window["rows"]] == [1, 2, 3, 5, 10]
    assert len({row["mpjpe_mm"] for row in window["rows"]}) == 5
    # One thing measured in two ways.
    assert sampling["test"]["frames"] == window["test"]["frames"]
    assert rows["uniform", 0, "deciwatch"]["mpjpe_mm"] == window["rows"][-1]["mpjpe_mm"]


def pair_rows(ours=100.0, accel=7.0, heavy=90.0):
    """pairs.json: full, lite and heavy, whose every frame is at 120, 130 and 110 mm."""
    rows = []
    for name, error, flops in (("lite", 130.0, 1e9), ("full", 120.0, 2e9), ("heavy", 110.0, 5e9)):
        mine = {"lite": ours + 5, "full": ours, "heavy": heavy}[name]
        for method, interval, mpjpe, jerk in (
            ("every_frame", 1, error, 50.0),
            *((m, n, error + n, 9.0) for m in ("linear", "cubic") for n in (5, 10, 20)),
            *(("no_denoise", n, mine + 9, 9.0) for n in (5, 10, 20)),
            *(("no_recover", n, mine - 1, 8.0) for n in (5, 10, 20)),
            *(("deciwatch", n, mine + abs(n - 10), accel) for n in (5, 10, 20)),
        ):
            rows.append(
                {"method": method, "interval": interval, "estimator": f"mediapipe-{name}"}
                | {"mpjpe_mm": mpjpe, "accel_mm": jerk, "pck_05": 0.5, "ms_per_frame": 9.0}
                | {"flops_per_frame": flops / interval + 1e6 * (method == "deciwatch")}
                | {"groups": {"head": mpjpe / 2, "feet": mpjpe * (0.8 if interval == 1 else 1.2)}}
                | {"frames": 500 if name == "full" else 200}
            )
    return rows


def section(rows, title, name="pairs", **about):
    """The text of one section."""
    text, _ = write_page({name: Measured(name, rows, about)}, "results")
    return text.split(f"# {title}", 1)[1].split("\n#")[0]


def test_sentences_turn_with_the_numbers():
    won, lost = pair_rows(), pair_rows(ours=140.0, accel=12.0, heavy=150.0)
    title = "One frame in ten"
    assert "100.0 mm, 17 % below that of the estimator on every frame" in section(won, title)
    assert "By MPJPE nobody in the table is ahead of it" in section(won, title)
    assert "140.0 mm, 17 % above that of the estimator" in section(lost, title)
    assert "By MPJPE it loses to the estimator on every frame (120.0), linear" in section(
        lost, title
    )
    title = "How many frames to watch"
    assert "lowest at N = 10, 100.0 mm" in section(won, title)
    assert "below the estimator's at every N up to 20" in section(won, title)
    assert "below the estimator's at no N" in section(lost, title)
    assert "as good or better at N = 5 (145.0 mm against 125.0 mm)" in section(lost, title)
    title = "A heavy estimator seldom, or a light one always"
    assert "it is both better and cheaper" in section(won, title)
    assert "so one is bought with the other" in section(lost, title)
    assert "Not all on the same clips" in section(won, title)
    title = "Without DenoiseNet, without RecoverNet"
    assert "Without RecoverNet it is no worse at N = 10" in section(won, title)
    assert "RecoverNet does not lower MPJPE at N = 5, 10 and 20" in section(won, title)
    assert "no better than the estimator on every frame for the feet" in section(
        won, "Which joints"
    )
    assert "Of its relative gain on full it keeps 115 % on lite" in section(won, "Estimators that")
    assert "the nets take 1.0 MFLOP of it" in section(won, "What it costs")


def test_a_small_difference_between_variants_is_called_chance():
    def row(name, mpjpe, **differs):
        return {
            "name": name,
            "group": next(iter(differs), "base"),
            "differs": differs,
            "mpjpe_mm": mpjpe,
            "accel_mm": 7.0,
            "no_recover": {"mpjpe_mm": mpjpe + 1, "accel_mm": 8.0},
            "parameters": 1000,
            "flops_per_window": 1e6,
            "windows": 10,
        }

    rows = [row("base", 100.0), row("lam-2", 99.5, lam=2.0), row("width-128", 95.0, width=128)]
    about = {"base": BASE.as_dict(), "steps": 1500}

    def of(title):
        return section([*rows, row("seed-2", 100.8, seed=2)], title, "variants", **about)

    assert "λ = 2 has the lowest MPJPE, 99.5 mm, 0.5 % below the base" in of("λ of")
    assert "no more than seeds alone do (0.8 mm)" in of("λ of")
    assert "C = 128 has the lowest" in of("Width C") and "seeds alone" not in of("Width C")
    assert "nothing of the group blocks" in of("Blocks M") and "study train" in of("Blocks M")


def test_what_was_not_measured_is_left_out_with_its_command(tmp_path, capsys):
    (tmp_path / "pairs.json").write_text(json.dumps({"rows": pair_rows()}))
    page = tmp_path / "docs" / "results.md"
    words = ["results", "--from", str(tmp_path), "--out", str(page)]
    assert main(words) == 0
    text = page.read_text()
    assert "Not measured: there is no window.json. `python -m deciwatch study window`" in text
    drawn = sorted(path.name for path in tmp_path.glob("*.svg"))
    assert all(f"](../{name})" in text for name in drawn) and "ratio.svg" in drawn
    before = {name: (tmp_path / name).read_bytes() for name in drawn}
    assert b"<text" in before["ratio.svg"] and b"DeciWatch" in before["ratio.svg"]
    assert main(words) == 0
    assert {name: (tmp_path / name).read_bytes() for name in drawn} == before
    (tmp_path / "window.json").write_text("[1]")
    capsys.readouterr()
    assert main(words) == 2
    assert "window.json holds no rows" in capsys.readouterr().err


def test_the_page_in_the_repository_says_what_its_numbers_say():
    page = REPOSITORY / "docs" / "results.md"
    if not page.is_file():
        pytest.skip("docs/results.md was not written yet")
    text, plots = write_page(read_measured(page.parent / "results"), "results")
    assert page.read_text() == text
    assert all((page.parent / "results" / f"{plot.name}.svg").is_file() for plot in plots)


def test_words_and_places():
    assert against(79.0, 100.0) == "21 % below" and against(103.14, 100.0) == "3.1 % above"
    assert against(100.01, 100.0) == "level with" and percent(0.0996) == "10 %"
    assert listed(["a", "b", "c"]) == "a, b and c" and listed(["a"]) == "a"
    places = apart([5.0, 1.0, 1.2, 9.0], 1.0)
    assert all(b - a >= 1 - 1e-9 for a, b in pairwise(np.sort(places)))
    np.testing.assert_allclose(places, [5.0, 0.6, 1.6, 9.0])

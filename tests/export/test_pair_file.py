"""Reading pair files: what is in them, and one sentence for whatever is wrong."""

import numpy as np
import pytest

from deciwatch.errors import UserError
from deciwatch.evaluation.pair_file import read_pair_file
from made_up_pairs import LENGTHS, pair_arrays, write_pairs


def changed(**arrays) -> dict:
    """The made-up file with other arrays; None takes one out."""
    whole = pair_arrays() | arrays
    return {name: array for name, array in whole.items() if array is not None}


def test_a_whole_file(tmp_path):
    file = read_pair_file(write_pairs(tmp_path / "x.npz", pair_arrays()))
    assert file.estimator == "mediapipe-full" and file.keypoints == 33
    assert file.estimates["3d"].shape == (165, 33, 3) and file.truths["2d"].shape == (165, 33, 2)
    assert np.flatnonzero(~file.seen).tolist() == [7, 130]
    second = file.sequence(1)
    assert len(second.times) == LENGTHS[1] and second.times[3] == 3 / 30
    np.testing.assert_array_equal(second.estimates["3d"], file.estimates["3d"][101:])
    assert file.dense() == [0, 1]


def test_the_least_that_a_file_may_hold(tmp_path):
    arrays = pair_arrays()
    least = {"pred": arrays["pred_2d"][:, :17], "gt": arrays["gt_2d"][:, :17]}
    least |= {name: arrays[name] for name in ("start", "length")}
    file = read_pair_file(write_pairs(tmp_path / "mine.npz", least))
    assert file.estimator == "mine" and list(file.estimates) == ["2d"] and file.keypoints == 17
    assert file.fps.tolist() == [30, 30] and file.scores is None and file.ms is None


def test_sequences_that_were_estimated_here_and_there_are_not_dense(tmp_path):
    estimated = np.ones(165, bool)
    estimated[3] = False
    file = read_pair_file(write_pairs(tmp_path / "x.npz", changed(estimated=estimated)))
    assert file.dense() == [1]


BAD = {
    "no array 'gt'": {"gt": None},
    "only one of": {"gt_2d": None},
    "no numbers": {"pred": np.full((165, 33, 3), "x")},
    "shape [165, 33]": {"pred": np.zeros((165, 33))},
    "gt in": {"gt": np.zeros((165, 32, 3))},
    "scores in": {"scores": np.zeros((164, 33))},
    "one number for each": {"length": np.array([101])},
    "neither one number": {"fps": np.array([30.0, 30.0, 30.0])},
    "Sequence 1": {"length": np.array([101, 65])},
    "Sequence 0": {"start": np.array([-1, 101])},
    "share frames": {"start": np.array([0, 100])},
    "fps": {"fps": np.array(0.0)},
    "finite truth": {"gt": np.full((165, 33, 3), np.nan)},
    "finite estimate": {"pred": np.full((165, 33, 3), np.nan)},
    "millimetres": {"gt": 1000 * pair_arrays()["gt"]},
}


@pytest.mark.parametrize("part", BAD)
def test_what_is_wrong_is_said_in_a_sentence(tmp_path, part):
    with pytest.raises(UserError) as caught:
        read_pair_file(write_pairs(tmp_path / "bad.npz", changed(**BAD[part])))
    text = str(caught.value)
    assert part in text and "bad.npz" in text and text.endswith(".") and "\n" not in text


def test_files_that_are_none(tmp_path):
    with pytest.raises(UserError, match="no pair file"):
        read_pair_file(tmp_path / "none.npz")
    for content in (b"", b"PK\x03\x04 cut off", b"plain text"):
        (tmp_path / "bad.npz").write_bytes(content)
        with pytest.raises(UserError, match="not a whole"):
            read_pair_file(tmp_path / "bad.npz")
    np.savez(tmp_path / "bad.npz", **pair_arrays())
    whole = (tmp_path / "bad.npz").read_bytes()
    (tmp_path / "bad.npz").write_bytes(whole[: len(whole) // 2])
    with pytest.raises(UserError, match="not a whole"):
        read_pair_file(tmp_path / "bad.npz")
    np.save(tmp_path / "one.npy", np.zeros(3))
    with pytest.raises(UserError, match="not a whole"):
        read_pair_file(tmp_path / "one.npy")

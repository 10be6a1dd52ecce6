"""Fixtures shared by the tests of the Python half."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import torch

from deciwatch import checkpoint
from deciwatch.errors import UserError
from deciwatch.motion.motions import Motions
from deciwatch.paths import data_directory
from deciwatch.storage import round_weights

torch.set_num_threads(1)


@pytest.fixture(scope="session")
def data():
    """The motion data folder; tests that need it are skipped without."""
    try:
        directory = data_directory()
    except UserError as error:
        pytest.skip(f"needs the CMU motion data: {error}")
    if not (directory / "cmu30_train.npz").exists():
        pytest.skip(f"needs the CMU shards, which {directory} does not hold")
    return directory


@pytest.fixture(scope="session")
def motions() -> Motions:
    """Two made-up recordings of a walking doll, so that training can be tested without data."""
    from deciwatch.fixture_parity import standing_person

    lengths = np.array([150, 320])
    poses = standing_person(np.arange(lengths.sum()) / 30) + np.array([0.0, 0.9, 0.0])
    return Motions(poses.astype(np.float32), np.array([0, 150]), lengths, ("short", "long"))


@pytest.fixture
def rounded_checkpoint(tmp_path) -> Callable[[int], Path]:
    """The committed checkpoint of as many dimensions, its weights rounded as they are shipped."""

    def write(dims: int) -> Path:
        pair, content = checkpoint.load_pair(checkpoint.default_path(dims), dims)
        weights = round_weights(pair).state_dict()
        path = tmp_path / f"rounded-{dims}d.pt"
        checkpoint.save(path, pair.config, weights, content["training"])
        return path

    return write

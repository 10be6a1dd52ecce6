"""Fixtures shared by the tests of the Python half."""

import numpy as np
import pytest
import torch

from deciwatch.errors import UserError
from deciwatch.motion.motions import Motions
from deciwatch.paths import data_directory

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

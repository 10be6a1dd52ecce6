"""Metrics and classical interpolation against values worked out by hand."""

import numpy as np
import pytest
from scipy.linalg import orthogonal_procrustes
from scipy.spatial.transform import Rotation

from deciwatch.interpolate import METHODS, interpolate
from deciwatch.metrics import accel, mpjpe, pa_mpjpe, pck, procrustes


def test_mpjpe_by_hand():
    truth = np.zeros((2, 2, 3))
    poses = truth.copy()
    poses[0, 0] = (3, 4, 0)
    poses[1, 1] = (0, 0, 2)
    assert mpjpe(poses, truth) == pytest.approx((5 + 0 + 0 + 2) / 4)


def test_accel_by_hand():
    truth = np.zeros((4, 1, 2))
    poses = truth.copy()
    poses[1, 0] = (1, 0)
    # Frame 1: −2·1, frame 2: +1.
    assert accel(poses, truth) == pytest.approx(1.5)
    # A constant error and a constant drift have none.
    drift = truth + np.arange(4)[:, None, None] * 7 + 3
    assert accel(drift, truth) == pytest.approx(0)
    with pytest.raises(ValueError, match="three frames"):
        accel(poses[:2], truth[:2])


def test_pck_by_hand():
    truth = np.array([[[0, 0], [100, 0], [0, 50], [40, 40.0]]])
    poses = truth + np.array([[[10, 0], [0, 10.001], [19, 0], [0, 0]]])
    assert pck(poses, truth, 0.1) == pytest.approx(0.5)
    assert pck(poses, truth, 0.2) == 1.0


def test_interpolation_by_hand():
    times, values = np.array([0.0, 2.0, 4.0, 6.0]), np.array([[0.0], [4.0], [16.0], [36.0]])
    at = np.array([0.0, 1.0, 2.5, 5.0])
    got = {method: interpolate(times, values, at, method)[:, 0] for method in METHODS}
    np.testing.assert_allclose(got["nearest"], [0, 0, 4, 16])
    np.testing.assert_allclose(got["linear"], [0, 2, 7, 26])
    np.testing.assert_allclose(got["quadratic"], at**2, atol=1e-9)
    np.testing.assert_allclose(got["cubic"], at**2, atol=1e-9)


@pytest.mark.parametrize("method", METHODS)
def test_few_samples_fall_back_and_times_outside_are_held(method):
    values = np.array([[1.0, 5.0], [3.0, 9.0], [4.0, 0.0]])
    times = np.array([0.0, 1.0, 2.0])
    one = interpolate(times[:1], values[:1], np.array([0.0, 8.0]), method)
    np.testing.assert_array_equal(one, values[[0, 0]])
    two = interpolate(times[:2], values[:2], np.array([-1.0, 0.25, 1.5]), method)
    np.testing.assert_allclose(two[[0, 2]], values[:2])
    np.testing.assert_allclose(two[1], [1, 5] if method == "nearest" else [1.5, 6])
    assert interpolate(times, values, np.array([0.7]), method).shape == (1, 2)


def test_unknown_methods_are_refused():
    with pytest.raises(ValueError, match="none of"):
        interpolate(np.arange(3.0), np.zeros((3, 1)), np.zeros(1), "septic")


def test_procrustes_against_scipy():
    rng = np.random.default_rng(3)
    truth = rng.normal(size=(6, 33, 3))
    poses = truth + rng.normal(0, 0.3, size=truth.shape)
    poses[3] = poses[3] * [1, 1, -1]  # a mirrored pose may be turned, not mirrored back
    expected = []
    for pose, target in zip(poses, truth, strict=True):
        centred, aim = pose - pose.mean(axis=0), target - target.mean(axis=0)
        rotation, _ = orthogonal_procrustes(centred, aim)
        if np.linalg.det(rotation) < 0:
            rotation = Rotation.align_vectors(aim, centred)[0].as_matrix().T
        turned = centred @ rotation
        scale = (turned * aim).sum() / (turned**2).sum()
        expected.append(scale * turned + target.mean(axis=0))
    np.testing.assert_allclose(procrustes(poses, truth), expected, atol=1e-9)
    turn = Rotation.from_rotvec([0.3, -2.0, 0.5]).as_matrix()
    assert pa_mpjpe(0.4 * truth @ turn.T + [5, 6, 7], truth) == pytest.approx(0, abs=1e-9)
    assert pa_mpjpe(poses, truth) < mpjpe(poses, truth)

"""Windows, cameras, noise and batches, on made-up motion."""

from dataclasses import replace

import numpy as np
import pytest

from deciwatch.data.augment import augment, graft, mirror
from deciwatch.data.batches import INTERVALS, WINDOWS, draw_lengths, keep_samples, training_batch
from deciwatch.data.camera import NEAREST, draw_views
from deciwatch.data.noise import JITTER, NOMINAL, NONE, add_noise
from deciwatch.data.places import PER_GAP
from deciwatch.data.windows import choose, resample, slices
from deciwatch.normalise import frame_of, from_net, to_net
from deciwatch.skeleton import INDEX, mid_hip


def rng(seed: int = 0) -> np.random.Generator:
    return np.random.default_rng(seed)


def still(batch: int, samples: int, motions) -> tuple[np.ndarray, np.ndarray]:
    truth = np.tile(motions.landmarks[:1] - mid_hip(motions.landmarks[:1]), (batch, samples, 1, 1))
    return truth, np.tile(np.arange(samples) / 3, (batch, 1))


def test_windows_stay_within_their_recording(motions):
    spans = rng().uniform(5, 400, size=300)
    sequence, first, span = choose(rng(1), motions, spans)
    assert (first >= 0).all() and (first + span <= motions.length[sequence] - 1 + 1e-9).all()
    assert (span <= motions.length.max() - 1).all()
    assert (sequence[spans > 149] == 1).all()


def test_resampling_meets_the_recorded_frames_and_is_smooth_between(motions):
    frames = np.array([[0.0, 7.0, 149.0], [3.0, 3.5, 4.0]])
    got = resample(motions, np.array([0, 1]), frames)
    np.testing.assert_allclose(got[0], motions.sequence(0)[[0, 7, 149]], atol=1e-6)
    assert np.abs(got[1, 1] - (got[1, 0] + got[1, 2]) / 2).max() < 0.005


def test_slices_share_their_ends(motions):
    places = slices(motions, 10, 10)
    assert places == [(0, 0), (1, 0), (1, 100), (1, 200)]
    assert slices(motions, 20, 20) == []


def test_a_mirror_image_of_a_mirror_image_is_the_original(motions):
    poses = motions.landmarks[:3]
    np.testing.assert_array_equal(mirror(mirror(poses)), poses)
    assert augment(rng(), poses[None].repeat(5, axis=0)).shape == (5, 3, 33, 3)


def test_grafted_legs_are_anothers_and_fit_the_hips(motions):
    turned = motions.sequence(1)[:40] @ np.array([[0, 0, 1.0], [0, 1, 0], [-1, 0, 0]])
    poses = np.stack([motions.sequence(0)[60:100], turned] * 20)
    grafted = graft(rng(), poses)
    np.testing.assert_array_equal(grafted[:, :, :23], poses[:, :, :23])
    changed = [i for i in range(40) if not np.allclose(grafted[i], poses[i], atol=1e-6)]
    assert 4 < len(changed) < 20
    for i in changed:
        # About the hips, the legs are those of the other recording, turned about the vertical.
        legs, donor = ((x - mid_hip(x))[:, 25:33] for x in (grafted[i], poses[1 - i % 2]))
        np.testing.assert_allclose(legs[..., 1], donor[..., 1], atol=1e-6)
        np.testing.assert_allclose(*(np.linalg.norm(x, axis=-1) for x in (legs, donor)), atol=1e-5)
        hips = [(x[:, 23] - x[:, 24]).mean(axis=0)[[0, 2]] for x in (grafted[i], poses[i])]
        cosine = hips[0] @ hips[1] / np.linalg.norm(hips[0]) / np.linalg.norm(hips[1])
        assert cosine > 1 - 1e-6


def test_cameras_keep_lengths_and_agree_in_2d_and_3d(motions):
    world = np.stack([motions.sequence(1)[:50]] * 40)
    views = draw_views(rng(), world)
    poses3d, poses2d = views.poses3d(world), views.poses2d(world)
    np.testing.assert_allclose(mid_hip(poses3d), 0, atol=1e-5)
    for a, b in ((11, 13), (23, 25), (0, 8)):
        length = np.linalg.norm(poses3d[:, :, a] - poses3d[:, :, b], axis=-1)
        true = np.linalg.norm(world[:, :, a] - world[:, :, b], axis=-1)
        np.testing.assert_allclose(length, true, atol=1e-4)
    # Up stays up in every camera: the head is above the feet, smaller y in pixels, larger in 3D.
    assert (poses3d[:, :, 0, 1] > poses3d[:, :, 27, 1]).all()
    assert (poses2d[:, :, 0, 1] < poses2d[:, :, 27, 1]).all()
    depth = views.distance[..., None] - views.to_camera(world)[..., 2]
    assert depth.min() > NEAREST - 1e-6
    # z points towards the camera: what is nearer has the larger z.
    assert np.corrcoef(depth[0, 0], poses3d[0, 0, :, 2])[0, 1] < -0.99


def test_no_noise_is_no_noise(motions):
    truth, times = still(3, 4, motions)
    np.testing.assert_allclose(add_noise(rng(), truth, times, NONE), truth, atol=1e-6)


def test_jitter_has_the_sizes_that_the_table_says(motions):
    truth, times = still(400, 11, motions)
    # Pixels, since 3D poses are taken relative to their own noisy mid-hip.
    truth = truth[..., :2] * 100
    noise = replace(NONE, jitter=1.0)
    unit = np.ptp(truth[0, 0], axis=0).max() / 1.7
    error = (add_noise(rng(), truth, times, noise) - truth) / unit
    size = np.sqrt((error**2).sum(axis=-1).mean(axis=(0, 1)))
    np.testing.assert_allclose(size, JITTER, rtol=0.05)
    assert JITTER[INDEX["left_shoulder"]] == 0.015 and JITTER[INDEX["left_index"]] == 0.045


def test_depth_is_twice_as_noisy_and_the_hips_stay_the_origin(motions):
    truth, times = still(400, 11, motions)
    estimate = add_noise(rng(), truth, times, replace(NONE, jitter=1.0))
    np.testing.assert_allclose(mid_hip(estimate), 0, atol=1e-5)
    x, y, z = (estimate - truth)[:, :, INDEX["nose"]].std(axis=(0, 1))
    assert z / x == pytest.approx(2, rel=0.1) and z / y == pytest.approx(2, rel=0.1)


def test_bias_is_constant_in_a_window_and_differs_between_windows(motions):
    truth, times = still(500, 6, motions)
    error = add_noise(rng(), truth[..., :2], times, replace(NONE, bias=0.02)) - truth[..., :2]
    np.testing.assert_allclose(error, error[:, :1].repeat(6, axis=1), atol=1e-6)
    unit = np.ptp(truth[0, 0, :, :2], axis=0).max() / 1.7
    size = np.sqrt((error**2).sum(axis=-1).mean()) / unit
    assert size == pytest.approx(0.02, rel=0.1)


def test_outliers_and_swaps_come_as_often_as_said(motions):
    truth, times = still(1000, 11, motions)
    flat = truth[..., :2]
    far = add_noise(rng(), flat, times, replace(NONE, outlier_rate=0.03, outlier=0.15)) - flat
    assert (np.abs(far).max(axis=-1) > 1e-4).mean() == pytest.approx(0.03, rel=0.15)
    swapped = add_noise(rng(), flat, times, replace(NONE, swap_rate=0.015)) - flat
    assert (np.abs(swapped).max(axis=(-1, -2)) > 0.05).mean() == pytest.approx(0.015, rel=0.3)


def test_nominal_noise_is_of_the_size_that_estimators_have(motions):
    truth, times = still(300, 11, motions)
    error = np.linalg.norm(add_noise(rng(), truth, times, NOMINAL) - truth, axis=-1)
    assert 0.045 < error.mean() < 0.075


def test_normalisation_and_back():
    for dims, spread in ((2, 300.0), (3, 0.5)):
        samples = rng().normal(size=(4, 5, 33, dims)) * spread
        origin, unit = frame_of(samples)
        values = to_net(samples, origin, unit)
        assert values.shape == (4, 5, 33 * dims) and values.dtype == np.float32
        np.testing.assert_allclose(from_net(values, origin, unit), samples, rtol=1e-4, atol=1e-3)


@pytest.mark.parametrize("dims", [2, 3])
@pytest.mark.parametrize("sparse", [False, True])
def test_batches_hold_together(motions, dims, sparse):
    generator = rng(4)
    for _ in range(8):
        batch = training_batch(generator, motions, (f"{dims}d",), sparse=sparse)
        size, samples, values = batch.sampled.shape
        frames = batch.poses.shape[1]
        assert values == 33 * dims and batch.clean.shape == batch.sampled.shape
        assert batch.sample_times.shape == (size, samples)
        assert batch.frame_times.shape == (size, frames)
        assert (frames == samples) or not sparse
        assert (np.diff(batch.frame_times) > 0).all() and (batch.frame_times[:, 0] == 0).all()
        np.testing.assert_array_equal(batch.sample_times[:, 0], batch.frame_times[:, 0])
        np.testing.assert_array_equal(batch.sample_times[:, -1], batch.frame_times[:, -1])
        # The truth at the samples is the truth of the frames at their times.
        for sample, time in enumerate(batch.sample_times[0]):
            frame = int(np.argmin(np.abs(batch.frame_times[0] - time)))
            np.testing.assert_array_equal(batch.clean[0, sample], batch.poses[0, frame])
        assert np.isfinite(batch.poses).all() and np.isfinite(batch.sampled).all()


def test_a_few_frames_of_every_gap_are_the_truth_at_their_times(motions):
    generator = rng(3)
    for _ in range(6):
        batch = training_batch(generator, motions, ("3d",), estimator=NONE, few=True)
        assert batch.poses.shape[1] == PER_GAP * (batch.clean.shape[1] - 1)
        left, right = batch.sample_times[:, :-1, None], batch.sample_times[:, 1:, None]
        inside = batch.frame_times.reshape(*left.shape[:2], PER_GAP)
        assert ((left <= inside) & (inside <= right)).all()
        np.testing.assert_allclose(batch.sampled, batch.clean, atol=1e-5)
        # A frame as close to a sample as a tenth of a frame has nearly the sample's pose.
        off = np.abs(batch.frame_times[:, :, None] - batch.sample_times[:, None])
        window, frame, sample = np.nonzero(off < 0.1)
        moved = np.abs(batch.poses[window, frame] - batch.clean[window, sample])
        assert moved.size == 0 or moved.max() < 0.05


def test_batches_are_the_same_for_the_same_seed(motions):
    first, second = (training_batch(rng(9), motions, ("3d",)) for _ in range(2))
    np.testing.assert_array_equal(first.sampled, second.sampled)
    np.testing.assert_array_equal(first.poses, second.poses)


def test_lengths_and_missing_samples_cover_their_ranges():
    generator = rng(2)
    drawn = np.array([draw_lengths(generator) for _ in range(2000)])
    assert (drawn.min(axis=0) == [INTERVALS[0], WINDOWS[0]]).all()
    assert (drawn.max(axis=0) == [INTERVALS[1], WINDOWS[1]]).all()
    kept = [keep_samples(generator, 7, 10) for _ in range(500)]
    assert all(one[0] == 0 and one[-1] == 70 for one in kept)
    assert {len(one) for one in kept} >= {11, 10, 9, 8}

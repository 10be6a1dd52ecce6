"""The raw readers against the shards, which hold the same recordings."""

import numpy as np
import pytest

from deciwatch.motion.cmu import read_shard
from deciwatch.motion.landmarks import landmarks_from_body
from deciwatch.motion.raw import landmarks, read_body, resample

CASES = [("cmu_07_01", "07_01.bvh"), ("cmu_13_11", "13_11.bvh"), ("cmu_35_01", "35_01.amc")]


@pytest.fixture(scope="module")
def shard(data):
    return read_shard(data, "train")


def part(shard, name: str) -> slice:
    index = shard.names.index(name)
    return slice(shard.start[index], shard.start[index] + shard.length[index])


@pytest.mark.parametrize(("name", "file"), CASES)
def test_raw_file_gives_the_shards_joints_and_landmarks(data, shard, name, file):
    body = read_body(data / "raw" / file)
    stored = shard.joints[part(shard, name)]
    stored_marks = landmarks_from_body(stored, shard.axis_angles[part(shard, name)])
    # The AMC at hand is an excerpt, frames 135 to 358; the shards count every fourth from 1.
    first = 34 if file.endswith(".amc") else 0
    late = 2 if file.endswith(".amc") else 0
    joints = resample(body.joints[late:], body.fps, 30.0)
    marks = resample(landmarks(body, 120.0)[late:], body.fps, 30.0)
    stored, stored_marks = stored[first:][: len(joints)], stored_marks[first:][: len(marks)]
    assert len(stored) == len(joints)
    for ours, theirs in ((joints, stored), (marks, stored_marks)):
        off = (ours - joints[:, :1]) - (theirs - stored[:, :1])
        assert np.linalg.norm(off, axis=-1).max() < 0.0005
        assert np.linalg.norm(off, axis=-1).mean() < 0.00015
    # The floor's exact place is a matter of taste.
    assert abs(np.median(joints[:, 0, 1] - stored[:, 0, 1])) < 0.002

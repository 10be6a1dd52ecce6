"""BVH and ASF/AMC parsers on tiny files whose positions can be worked out by hand."""

import numpy as np
import pytest

from deciwatch.errors import UserError
from deciwatch.motion import asf_amc, bvh
from deciwatch.motion.raw import read_body, resample

BVH = """HIERARCHY
ROOT Base
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation
  JOINT Arm
  {
    OFFSET 0 2 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 1 0 0
    }
  }
}
MOTION
Frames: 3
Frame Time: 0.0333333
0 0 0 0 0 0 0 0 0
1 2 3 90 0 0 0 0 0
0 0 0 90 0 90 90 0 0
"""

ASF = """# a comment
:version 1.10
:units
  length 0.45
  angle deg
:root
  order TX TY TZ RX RY RZ
  axis XYZ
:bonedata
  begin
    id 1
    name upper
    direction 0 1 0
    length 2
    axis 0 0 90 XYZ
    dof rx rz
    limits (-10 10)
           (-10 10)
  end
  begin
    id 2
    name lower
    direction 1 0 0
    length 3
    axis 0 0 0 XYZ
  end
:hierarchy
  begin
    root upper
    upper lower
  end
"""

AMC = """#!OML:ASF tiny.asf
:FULLY-SPECIFIED
:DEGREES
1
root 1 2 3 0 0 0
upper 0 0
2
root 0 0 0 0 0 90
upper 0 0
3
root 0 0 0 0 0 0
upper 90 0
4
root 0 0 0 90 0 90
upper 0 0
"""


@pytest.fixture
def files(tmp_path):
    for name, text in (("tiny.bvh", BVH), ("tiny.asf", ASF), ("tiny_01.amc", AMC)):
        (tmp_path / name).write_text(text)
    return tmp_path


def test_bvh_positions(files):
    file = bvh.read_bvh(files / "tiny.bvh")
    places, turns = bvh.pose(file)
    assert file.fps == pytest.approx(30, abs=1e-3)
    assert list(places) == ["Base", "Arm", "Arm_end"]
    # 1: rest. 2: moved, and turned a quarter about z: y → −x, x → y.
    # 3: the root by Rz·Rx, so y → z; the arm by another quarter about z: x → y → z.
    np.testing.assert_allclose(places["Base"], [[0, 0, 0], [1, 2, 3], [0, 0, 0]], atol=1e-9)
    np.testing.assert_allclose(places["Arm"], [[0, 2, 0], [-1, 2, 3], [0, 0, 2]], atol=1e-9)
    np.testing.assert_allclose(places["Arm_end"], [[1, 2, 0], [-1, 3, 3], [0, 0, 3]], atol=1e-9)
    np.testing.assert_allclose(
        turns["Arm_end"] @ np.swapaxes(turns["Arm_end"], 1, 2), [np.eye(3)] * 3, atol=1e-12
    )


def test_asf_and_amc_positions(files):
    bones = asf_amc.read_asf(files / "tiny.asf")
    assert bones["upper"].freedoms == ("rx", "rz") and bones["lower"].parent == "upper"
    ends, _ = asf_amc.pose(bones, asf_amc.read_amc(files / "tiny_01.amc", bones))
    # 3: a quarter about the bone's own x, which its axis (z by 90°) makes the world's y: x → −z.
    # 4: the root by Rz·Rx: y → z, x → y.
    upper = [[1, 4, 3], [-2, 0, 0], [0, 2, 0], [0, 0, 2]]
    lower = [[4, 4, 3], [-2, 3, 0], [0, 2, -3], [0, 3, 2]]
    np.testing.assert_allclose(ends["upper"], upper, atol=1e-9)
    np.testing.assert_allclose(ends["lower"], lower, atol=1e-9)


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("cut.bvh", BVH[:-30]),
        ("headless.bvh", "Frames: 3"),
        ("braces.bvh", BVH.replace("}", "", 1)),
        ("words.bvh", BVH.replace("OFFSET", "OFFSIDE", 1)),
        ("tiny.bvh", BVH),
        ("poem.txt", "no motion"),
        ("lost_01.amc", AMC),
    ],
)
def test_damaged_and_foreign_files_are_named(tmp_path, name, text):
    (tmp_path / name).write_text(text)
    with pytest.raises(UserError) as caught:
        read_body(tmp_path / name)
    assert str(tmp_path) in str(caught.value) and "\n" not in str(caught.value)


def test_an_amc_that_lacks_a_bone_is_refused(files):
    (files / "tiny_01.amc").write_text(AMC.replace("upper 90 0\n", ""))
    with pytest.raises(UserError, match="give it its own"):
        asf_amc.read_amc(files / "tiny_01.amc", asf_amc.read_asf(files / "tiny.asf"))


def test_resample_between_rates():
    values = np.arange(13.0)[:, None]
    assert resample(values, 120.0005, 30.0)[:, 0].tolist() == [0, 4, 8, 12]
    np.testing.assert_allclose(resample(values, 20.0, 30.0)[:4, 0], [0, 2 / 3, 4 / 3, 2], atol=1e-3)


def test_a_folder_of_raw_files_serves_as_data(data, tmp_path, capsys):
    from deciwatch.motion.folder import split_of
    from deciwatch.motion.load import load_motions

    splits = {}
    for file in (data / "raw").iterdir():
        (tmp_path / file.name).write_bytes(file.read_bytes())
        splits.setdefault(split_of(file.stem.split("_")[0]), set()).add(file.stem)
    (tmp_path / "07_99.bvh").write_text("HIERARCHY")
    for split, names in splits.items():
        motions = load_motions(tmp_path, split)
        assert set(motions.names) == {name for name in names if "_" in name}
        assert motions.start[0] == 0 and motions.length.sum() == len(motions.landmarks)
    assert "07_99.bvh" in capsys.readouterr().err

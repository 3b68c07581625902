"""A data set in Python, made by the built program, against what its own files say."""

import json
import subprocess

import msisf
import numpy as np
import pytest
from msisf._process import find_program

FILE = """
count: 2
seed: 5
states: {latitude: [-60, 60], altitude: [300e3, 400e3], off-nadir: [0, 30], roll: [0, 360], sun-elevation: [20, 60]}
pair: {shift: 8e3, turn: 1}
accept: {ground: 1}
split: {train: 0.5, test: 0.5, width: 90}
licences: {c.csv: public domain}
options: {width: 40, height: 30, fov: 30, albedo-map: none, layers: "depth,normal,position", craters: c.csv, crater-size: 1}
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    place = tmp_path_factory.mktemp("dataset")
    craters = "".join(f"{i},{latitude},{longitude},40\n" for i, (latitude, longitude) in enumerate(
        (latitude, longitude) for latitude in range(-80, 81, 5) for longitude in range(0, 360, 5)))  # fmt: skip
    (place / "c.csv").write_text("id,lat,lon,diam_km\n" + craters)
    (place / "set.yaml").write_text(FILE)
    call = [find_program(), "dataset", str(place / "set.yaml"), "--output-dir", str(place / "data"), "--batch"]
    subprocess.run(call, check=True, stdout=subprocess.DEVNULL)
    return place / "data"


def test_samples_have_what_their_files_have(folder):
    dataset = msisf.Dataset(folder)
    assert len(dataset) == 4 and [sample.number for sample in dataset] == [1, 2, 3, 4]
    assert [sample.split for sample in dataset] == ["train", "train", "test", "test"]
    for sample in dataset:
        written = json.loads(sample.path(".layers.json").read_text())
        np.testing.assert_allclose(sample.R, written["R"], atol=1e-15)
        np.testing.assert_allclose(sample.t, written["t"], rtol=1e-14)
        np.testing.assert_array_equal(sample.K, written["K"])
        assert sample.image.shape == (30, 40) and sample.image.dtype == np.uint8
        assert sample.depth.dtype == np.float32 and sample.normals.shape == (30, 40, 3)
        assert 20 <= sample.sun_elevation <= 60 and sample.ground == 1
        assert len(sample.craters) == len(sample.path(".craters.csv").read_text().splitlines()) - 1 > 0
        assert sample.craters.semiMajor[0] > 0 and isinstance(sample.craters.id[0], str)


def test_flow_of_a_pair_leads_to_the_points_of_the_other(folder):
    """Pixel by pixel: the surface point's own projection into the second camera."""
    first, second = msisf.Dataset(folder, split="test")
    v, u = np.mgrid[0:30, 0:40]
    seen = first.layer("position") @ second.R.T + second.t
    projected = (seen / seen[..., 2:]) @ second.K.T
    np.testing.assert_allclose(np.stack([u, v], axis=-1) + first.flow, projected[..., :2], atol=1e-6)


def test_a_split_is_a_part_and_errors_say_what_is_missing(folder, tmp_path):
    assert [sample.number for sample in msisf.Dataset(folder, split="test")] == [3, 4]
    with pytest.raises(ValueError, match="has no split 'val'; there are train, test"):
        msisf.Dataset(folder, split="val")
    with pytest.raises(FileNotFoundError, match="card.json: missing. Give the folder of a data set"):
        msisf.Dataset(tmp_path)
    with pytest.raises(AttributeError, match="neither a layer nor a column 'albedo'"):
        msisf.Dataset(folder)[0].albedo

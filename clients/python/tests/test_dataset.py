"""A data set in Python, made by the built program, against what its own files say."""

import json
import os
import re
import shutil
import subprocess
import sys
import warnings

import msisf
import numpy as np
import pytest
from conftest import CLIENT
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
    with pytest.raises(msisf.MsisfError, match="has no split 'val'; there are train, test"):
        msisf.Dataset(folder, split="val")
    with pytest.raises(msisf.MsisfError, match="card.json: missing. Give the folder of a data set"):
        msisf.Dataset(tmp_path)
    with pytest.raises(msisf.MsisfError, match="neither a layer nor a column 'albedo'"):
        msisf.Dataset(folder)[0].albedo
    assert not hasattr(msisf.Dataset(folder)[0], "albedo")
    with pytest.raises(msisf.MsisfError, match="albedo.npy: missing: the data set has no layer 'albedo'"):
        msisf.Dataset(folder)[0].layer("albedo")


def test_slices_are_data_sets_and_places_count_as_in_lists(folder):
    dataset = msisf.Dataset(folder)
    for part in (slice(0, 3), slice(None, None, -1), slice(1, None, 2), slice(3, 1), slice(-2, None), slice(2, 99)):
        assert [sample.number for sample in dataset[part]] == [1, 2, 3, 4][part]
        assert len(dataset[part]) == len([1, 2, 3, 4][part]) and dataset[part].folder == dataset.folder
    assert len(dataset) == 4 and dataset[0:3][1:][-1].number == 3
    assert dataset[-1].number == dataset[np.int64(3)].number == 4
    for place in (4, -5, np.int64(4)):
        with pytest.raises(msisf.MsisfError, match=f"place {place} of 4 images; they are 0 to 3"):
            dataset[place]
    for place in (1.0, "train", None, (0, 1)):
        with pytest.raises(msisf.MsisfError, match="a whole number or a slice, not"):
            dataset[place]
    assert [sample.number for sample in map(dataset.__getitem__, range(2))] == [1, 2]
    with pytest.raises(IndexError):  # ends the loops of those who go by places, as PyTorch's do
        dataset[4]


def test_names_of_several_meanings_are_not_silent(folder):
    """A data set with the layers position and latitude beside the camera's position and the column latitude."""
    sample = msisf.Dataset(folder)[0]
    with pytest.warns(UserWarning, match="sample.position is the camera's position; the layer is sample.layer"):
        np.testing.assert_array_equal(sample.position, [sample.index[name] for name in "xyz"])
    assert sample.positions.shape == (30, 40, 3)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert sample.latitude == sample.index["latitude"] and sample.t.shape == (3,)
    layer = sample.path(".latitude.npy")
    np.save(layer, np.zeros((30, 40)))
    try:
        with pytest.warns(UserWarning, match="sample.latitude is the layer 'latitude'; the column of the index is sample.index"):
            assert sample.latitude.shape == (30, 40)
    finally:
        layer.unlink()


@pytest.mark.parametrize("name, damage", [
    ("card.json", b"{"), ("card.json", b"[]"), ("index.csv", b"number,file\n1,000001.png\n"), ("index.csv", b"\xff\xfe"),
    ("index.csv", b"number,file,split\nx,y,z\n"), ("000001.png", b""), ("000001.png", b"\x89PNG\r\n\x1a\n" + b"x" * 40),
    ("000001.depth.npy", b"\x93NUMPY"), ("000001.depth.npy", b""), ("000001.craters.csv", b"number,id\n1.5\n"),
])  # fmt: skip
def test_a_damaged_file_is_named(folder, tmp_path, name, damage):
    copy = tmp_path / "data"
    shutil.copytree(folder, copy)
    (copy / name).write_bytes(damage)
    with pytest.raises(msisf.MsisfError, match=f"{name}: damaged: "):
        sample = msisf.Dataset(copy, split="train")[0]
        for _ in (sample.image, sample.depth, sample.craters):
            pass


def test_jupyter_gets_the_file(folder):
    sample = msisf.Dataset(folder)[0]
    assert sample._repr_png_() == sample.path(".png").read_bytes()


def test_the_example_for_pytorch_runs(folder, tmp_path):
    pytest.importorskip("torch")
    page = (CLIENT.parents[1] / "docs/data-sets.md").read_text(encoding="utf-8")
    (example,) = re.findall(r"^```py\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
    (tmp_path / "data").symlink_to(folder)
    (tmp_path / "example.py").write_text(example)
    run = subprocess.run(
        [sys.executable, "example.py"], cwd=tmp_path, env={**os.environ, "PYTHONPATH": os.pathsep.join([str(CLIENT), *sys.path])},
        capture_output=True, text=True, timeout=300)  # fmt: skip
    assert run.returncode == 0, run.stderr
    assert re.fullmatch(r"torch.Size\(\[2, 1, 30, 40\]\) \d+\.\d+ torch.Size\(\[2, 3, 3\]\) torch.Size\(\[2, 3\]\)", run.stdout.strip())

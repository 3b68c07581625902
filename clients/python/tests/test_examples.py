"""The examples do what they promise."""

import sys
import xml.etree.ElementTree

import closed_loop
import data_set
import in_time
import information_descent
import latency
import numpy as np
import pose_from_craters
import pose_information
import pytest
import soak
import visual_odometry


@pytest.mark.parametrize(
    "example", [closed_loop, data_set, in_time, information_descent, latency, pose_from_craters, pose_information, soak, visual_odometry])
def test_help_helps(example, monkeypatch, capsys, tmp_path):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "argv", [f"{example.__name__}.py", "--help"])
    with pytest.raises(SystemExit) as end:
        example.main()
    assert end.value.code == 0
    help_text = capsys.readouterr().out
    assert help_text.startswith(f"usage: {example.__name__}.py [-h]") and example.__doc__.splitlines()[0][:40] in help_text
    assert not list(tmp_path.iterdir())


def test_information_descent_leaves_out_what_an_image_does_not_tell(tmp_path):
    table = tmp_path / "frame.information.csv"
    table.write_text("row,unit,deviation\nposition-axis-1,m,9.5\nposition-axis-3,m,\nturn-axis-1,rad,0.001\n")
    assert information_descent.bounds(table) == {
        "position-axis-1": "9.5", "position-axis-3": "", "turn-axis-1": "0.001", "turn-axis-3": ""}


def test_visual_odometry_follows_the_camera(tmp_path):
    (tmp_path / "exact").mkdir()
    (tmp_path / "noisy").mkdir()
    error, way = visual_odometry.run(tmp_path / "exact", frames=3, noise=0.0)
    assert way > 5e3 and error < 1e-3
    error, way = visual_odometry.run(tmp_path / "noisy", frames=3, noise=0.2)
    assert error < 0.01 * way


def test_closed_loop_finds_its_position(moon):
    errors = closed_loop.run(moon, frames=300)

    assert errors.shape == (300,)
    # The filter begins 2.2 km off. A pixel is 2.3 km on the ground, and spots are found to a tenth of a pixel.
    assert np.median(errors[-100:]) < 300.0
    assert errors[-100:].max() < 1000.0


def test_data_set_has_images_with_their_truth(moon, tmp_path):
    data_set.make(moon, tmp_path, count=3)

    files = sorted(tmp_path.glob("*.npz"))
    assert [file.name for file in files] == ["00000.npz", "00001.npz", "00002.npz"]
    with np.load(files[0]) as sample:
        assert sample["image"].shape == sample["depth"].shape == (256, 256)
        assert sample["image"].max() > 20
        # The light falls on what is bright: lit pixels face the Sun.
        lit = sample["mask"] == 1
        assert (sample["normal"][lit] @ sample["sun_direction"] > -1e-6).all()


def test_latency_has_the_times_of_each_image(moon, monkeypatch):
    monkeypatch.setattr(latency, "WARM", 3)
    run = latency.measure(moon, 64, images=5, clients=2)

    assert [len(times) for times in run.client] == [len(times) for times in run.drawing] == [5, 5]
    # What the client waits for holds what the renderer needs.
    assert all((client > drawing).all() and drawing.min() > 0.0 for client, drawing in zip(run.client, run.drawing))
    assert run.needed["server"] > 0.0 and run.needed["bytes"] > 0.0
    assert latency.added_by_render(moon, 64, images=3) > 0.0


def test_in_time_counts_from_the_time_of_each_state(moon, monkeypatch):
    monkeypatch.setattr(in_time, "WARM", 3)
    late = in_time.fly(moon, 32, rate=1e4, seconds=1e-3)  # ten states in a ms: each waits for all before it

    assert len(late) == 10 and (np.diff(late) > 0.0).all() and late[0] > 0.0
    picture = xml.etree.ElementTree.fromstring(in_time.plot(late, 1e4, late[4], "ten"))
    assert [len(line.get("points").split()) for line in picture.iter("{http://www.w3.org/2000/svg}polyline")] == [10, 10]
    assert in_time.summary(late, late[4]).endswith(f"5 later than {late[4]:g} ms")


def test_soak_of_seconds_has_no_error(moon):
    result = soak.run(moon, seconds=2.0)

    assert result.errors == []
    assert result.answers > 5
    assert min(result.before, result.after) > 20e6  # bytes: .NET alone needs more

"""Craters and landmarks of a frame against points projected in numpy, and the example that finds a pose from craters."""

import msisf
import numpy as np
import pose_from_craters
import pytest

CRATERS = """id,lat,lon,diam_km
Tycho,-43.3,-11.2,85
Maginus,-50.5,-6.3,156
Street,-46.6,-10.8,58
Pictet,-43.6,-7.4,60
Saussure,-43.4,-3.9,55
Orontius,-40.6,-4.6,105
Wilhelm,-43.4,-20.4,100
far,40,170,100
"""
LANDMARKS = "id,lat,lon,height\nground,-44,-9,\nabove,-44.5,-10,5000\nbelow,-43,-9,-9000\nfar,40,170,0\n"


@pytest.fixture(scope="module")
def navigating(tmp_path_factory):
    folder = tmp_path_factory.mktemp("lists")
    (folder / "c.csv").write_text(CRATERS)
    (folder / "l.csv").write_text(LANDMARKS)
    with msisf.Moon(model="LDEM_4", serve=["--catalogues", f"c={folder / 'c.csv'},l={folder / 'l.csv'}"]) as moon:
        yield moon


def render(moon, **options):
    return moon.render(
        position=(-45.0, -10.0, 300e3), look_at=(-43.0, -8.0), time="2010-03-25T06:00:00Z", camera=msisf.Camera(256, 200, 60.0), **options
    )


def test_craters_are_the_projected_rims(navigating):
    frame = render(navigating, craters="c", layers=["crater"])

    assert "far" not in frame.craters.id and len(frame.craters) == 6
    for crater, rim in zip(frame.craters, pose_from_craters.rims(frame.craters)):
        seen = (rim @ frame.R.T + frame.t) @ frame.K.T
        x, y = (seen[:, :2] / seen[:, 2:] + 1.0 - [crater.h, crater.v]).T
        turn = np.radians(crater.turn)
        along = (np.cos(turn) * x + np.sin(turn) * y) / crater.semiMajor
        across = (np.cos(turn) * y - np.sin(turn) * x) / crater.semiMinor
        np.testing.assert_allclose(np.hypot(along, across), 1.0, atol=1e-9)
    tycho = frame.craters[frame.craters.id == "Tycho"][0]
    assert frame.crater[int(tycho.v) - 1, int(tycho.h) - 1] == 1
    assert set(np.unique(frame.crater)) <= set(range(-(2**31), -(2**31) + 1)) | set(range(8))


def test_landmarks_are_projected_points_with_derivatives(navigating):
    frame = render(navigating, landmarks="l")

    assert list(frame.landmarks.id) == ["ground", "above", "below", "far"]
    assert list(frame.landmarks.visible) == [True, True, False, False]  # the last one is behind the Moon
    for mark in frame.landmarks:
        point = np.array([mark.x, mark.y, mark.z])
        seen = frame.K @ (frame.R @ point + frame.t)
        np.testing.assert_allclose(seen[:2] / seen[2] + 1.0, [mark.h, mark.v], atol=1e-8)
        for axis in np.eye(3):
            moved = [frame.K @ (frame.R @ (point + step * axis) + frame.t) for step in (100.0, -100.0)]
            slope = (moved[0][:2] / moved[0][2] - moved[1][:2] / moved[1][2]) / 200.0
            np.testing.assert_allclose([mark.hByPoint @ axis, mark.vByPoint @ axis], slope, atol=1e-9)
    assert len(render(navigating).craters) == 0


def test_unknown_catalogue_is_named(navigating):
    with pytest.raises(msisf.RequestError, match="'x'"):
        render(navigating, craters="x")
    with pytest.raises(msisf.RequestError, match="flow"):
        render(navigating, flow="next")


@pytest.mark.parametrize("seed", range(5))
def test_pose_from_craters_is_within_a_hundredth_of_the_altitude(navigating, seed):
    error, altitude, count = pose_from_craters.run(navigating, "c", noise=0.5, seed=seed)

    assert count >= 3
    assert error < 0.01 * altitude
    assert pose_from_craters.run(navigating, "c", noise=0.0, seed=seed)[0] < 1e-3

"""View.project against what the program itself does with each lens: rays through pixels, and pixels of places."""

import msisf
import numpy as np
import pytest
from msisf import _lens

PIXELS = {"width": 200, "height": 150, "focal-length-px": [180, 170], "principal-point": [90, 80], "skew": 3}
MILLIMETRES = {"width": 200, "height": 150, "focal-length": 2, "pixel-pitch": [0.011, 0.012], "principal-point": [90, 80], "skew": 3}
LENSES = {
    "none": PIXELS,
    "brown-conrady": {**PIXELS, "distortion": {"model": "brown-conrady", "k1": -0.25, "k2": 0.05, "k3": 0.01, "p1": 0.002, "p2": -0.003}},
    "opencv": {**PIXELS, "distortion": {"model": "opencv", "k1": 0.2, "k2": 0.05, "k3": 0.01, "k4": 0.3, "k5": 0.04, "k6": 0.02,
                                        "p1": 0.002, "p2": -0.001, "s1": 0.003, "s2": -0.002, "s3": 0.001, "s4": 0.004}},
    "owen": {**MILLIMETRES, "distortion": {"model": "owen", "e1": 0.003, "e2": -0.02, "e3": 0.001, "e4": 0.002, "e5": 0.004, "e6": -0.003}},
    "fisheye": {**PIXELS, "focal-length-px": [110, 105],
                "distortion": {"model": "fisheye", "k1": 0.02, "k2": -0.01, "k3": 0.002, "k4": -0.0005}},
    "radial factor": {**MILLIMETRES, "distortion": {"model": "radial", "form": "factor", "k": [0.03, 0.004, 0.0005]}},
    "radial division": {**MILLIMETRES, "distortion": {"model": "radial", "form": "division", "k": [-0.03, 0.004, -0.0005]}},
    "polynomial radius": {**MILLIMETRES, "distortion": {"model": "polynomial", "argument": "radius",
                                                        "x": [0.01, 0.002, -0.03, 0.001], "y": [-0.02, 0.01, 0.02]}},
    "polynomial x": {**MILLIMETRES, "distortion": {"model": "polynomial", "argument": "x",
                                                   "x": [0.01, 0.002, -0.03, 0.001], "y": [-0.02, 0.01, 0.02]}},
    "brown": {**MILLIMETRES, "distortion": {"model": "brown", "k0": 0.01, "k1": 0.03, "k2": 0.004, "k3": 0.0005, "p1": 0.003, "p2": -0.002,
                                            "s1": 0.002, "s2": 0.001, "s3": -0.003, "s4": -0.001, "x0": 0.1, "y0": -0.05}},
}  # fmt: skip
PROMISED = 1e-9  # px


@pytest.mark.parametrize("lens", LENSES)
def test_project_is_the_inverse_of_the_rays(moon, lens):
    frame = moon.render((10, 20, 3e4), time=55289, look_at=(10.1, 20.2), camera=LENSES[lens])
    pixels = np.stack(np.meshgrid(np.linspace(0, 199, 9), np.linspace(0, 149, 7)), axis=-1).reshape(-1, 2)

    points = frame.locate(pixels)

    is_ground = np.array([point is not None for point in points])
    assert is_ground.sum() > 40
    np.testing.assert_allclose(frame.project([point.position for point in points if point]), pixels[is_ground], rtol=0, atol=PROMISED)
    if lens != "none":  # the lens moves the corners by a pixel at least
        pinhole = msisf.View(moon, {}, frame.position, (frame.K, frame.R, frame.t))
        assert np.abs(pinhole.project(points[0].position) - pixels[0]).max() > 1.0


@pytest.mark.parametrize("lens", LENSES)
def test_project_is_what_the_server_says_of_places_far_outside_the_image_too(moon, lens):
    frame = moon.render((10, 20, 3e4), time=55289, look_at=(10.1, 20.2), camera=LENSES[lens])
    random = np.random.default_rng(1)
    places = np.column_stack((random.uniform(5, 15, 300), random.uniform(15, 25, 300), random.uniform(0, 5e3, 300)))
    latitude, longitude, radius = np.radians(places[:, 0]), np.radians(places[:, 1]), 1737400.0 + places[:, 2]
    points = radius[:, None] * np.column_stack(
        (np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)))  # fmt: skip

    ours = frame.project(points)

    theirs = np.array([[one["x"], one["y"]] for one in frame.visible(places)], dtype=float)
    ahead = (points - frame.position) @ frame.R[2] / np.linalg.norm(points - frame.position, axis=1)
    in_field = ahead > np.cos(np.radians(85.0))  # where fields of view end (docs/cameras.md)
    assert 100 < in_field.sum() and np.isnan(ours[ahead <= 0.0]).all()
    np.testing.assert_array_equal(np.isnan(ours[in_field]), np.isnan(theirs[in_field]))
    is_near = in_field & (np.abs(theirs - 100.0).max(axis=1) < 1000.0)
    assert is_near.sum() > 50
    np.testing.assert_allclose(ours[is_near], theirs[is_near], rtol=0, atol=PROMISED)


def test_close_to_the_ground_no_digit_is_lost(moon):
    frame = moon.render((10, 20, 2e3), time=55289, nadir=True, camera=msisf.Camera(64, 48, 1.0))

    point = frame.locate([[12.25, 30.5]])[0]

    np.testing.assert_allclose(frame.project(point.position), [12.25, 30.5], rtol=0, atol=PROMISED)


def test_place_that_the_lens_does_not_show_has_no_pixel():
    x = np.array([0.3, 1.2, 3.0])
    # k1 = -0.25: x + k1 x^3 has its top where 1 + 3 k1 x^2 = 0, x = 1.155.
    right, down = _lens.measured_of("opencv", [-0.25] + 11 * [0.0], x, 0.0 * x)

    np.testing.assert_allclose(right, [0.3 - 0.25 * 0.027, np.nan, np.nan])
    np.testing.assert_array_equal(np.isnan(down), [False, True, True])
    # x = x' (1 + k1 x'^2) reaches 0.7698 at most.
    right, _ = _lens.measured_of("radial-factor", [-0.25, 0.0, 0.0], x, 0.0 * x)
    assert np.isnan(right).tolist() == [False, True, True]
    assert right[0] - 0.25 * right[0] ** 3 == pytest.approx(0.3, abs=1e-15)


def test_lens_of_a_later_version_is_refused():
    with pytest.raises(msisf.MsisfError, match="the model 'prism', which this version"):
        _lens.measured_of("prism", [], np.zeros(1), np.zeros(1))

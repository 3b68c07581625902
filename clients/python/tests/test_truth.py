"""Every layer, the meta file, the server and the client against numpy_moon: cameras off centre, with skew, with each lens.

Each frame is compared from the definitions of docs/formats.md on. What a camera does in one place only (a principal point, a scanning
direction, several samples a pixel) must reach every number or none.
"""

import json
import subprocess
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest
from msisf import _process
from numpy_camera import looking_down
from numpy_moon import GROUND, dot, expected_layers, unit

TIME = 55289.0  # the Sun is over 1.5 N, 44 W
OPTIONS = {"lod": "off", "reflectance": "lambert"}

LENGTH = 1e-7  # m: coordinates of 2e6 m have steps of 2e-10, and a ray grazes the ground at up to 40 degrees
DEGREES = 1e-9
OF_DIFFERENCES = 1e-6  # differences over 2 m or a hundredth of a pixel in place of derivatives

SIZE = {"width": 32, "height": 24, "principal-point": [8.3, 19.6]}
PINHOLE = {**SIZE, "focal-length-px": [40, 43], "skew": 2.5}
IN_MM = {**SIZE, "focal-length": 4, "pixel-pitch": [0.1, 0.093]}
CAMERAS = {
    "off centre": {**SIZE, "focal-length-px": 40},
    "skew": PINHOLE,
    "brown-conrady": {**PINHOLE, "distortion": {"model": "brown-conrady", "k1": -0.1, "k2": 0.02, "k3": 0.001, "p1": 2e-3, "p2": -1e-3}},
    "opencv": {**PINHOLE, "distortion": {
        "model": "opencv", "k1": 0.1, "k2": 0.02, "k3": 0.01, "k4": 0.15, "k5": 0.01, "k6": 0.002, "p1": 2e-3, "p2": -1e-3,
        "s1": 1e-3, "s2": -2e-3, "s3": 3e-3, "s4": 1e-3}},
    "owen": {**IN_MM, "distortion": {"model": "owen", "e1": 2e-3, "e2": -5e-3, "e3": 2e-4, "e4": 1e-4, "e5": 3e-3, "e6": -2e-3}},
    "fisheye": {**PINHOLE, "distortion": {"model": "fisheye", "k1": 0.02, "k2": -0.005, "k3": 0.001, "k4": -2e-4}},
    "radial factor": {**IN_MM, "skew": 1, "distortion": {"model": "radial", "form": "factor", "k": [-5e-3, 1e-4, 1e-6]}},
    "radial division": {**IN_MM, "distortion": {"model": "radial", "form": "division", "k": [6e-3, 1e-4, -1e-6]}},
    "polynomial of the radius": {**IN_MM, "distortion": {
        "model": "polynomial", "argument": "radius", "x": [0.01, 2e-3, -1e-3, 1e-4], "y": [-0.02, 1e-3, 2e-3, -1e-4]}},
    "polynomial of x": {**IN_MM, "distortion": {
        "model": "polynomial", "argument": "x", "x": [0.01, 2e-3, -1e-3, 1e-4], "y": [-0.02, 1e-3, 2e-3, -1e-4]}},
    "brown": {**IN_MM, "skew": 1, "distortion": {
        "model": "brown", "k0": 0.01, "k1": -3e-3, "k2": 1e-4, "k3": 1e-6, "p1": 2e-3, "p2": -1e-3, "s1": 1e-3, "s2": 1e-4, "s3": -2e-3,
        "s4": -1e-4, "x0": 0.1, "y0": -0.2}},
}  # fmt: skip

# Electrons that are in proportion to the light, up to the highest DN.
DETECTOR = {
    "aperture": 5, "exposure-time": 1e-4, "quantum-efficiency": 0.5, "band": [633, 653], "gain": 2000, "adc-bits": 12, "seed": "none",
}  # fmt: skip

TOLERANCES = {
    **dict.fromkeys(["depth", "range", "position", "height"], LENGTH),
    **dict.fromkeys(["incidence", "emission", "phase", "sphere-incidence", "slope", "latitude", "longitude"], DEGREES),
    **dict.fromkeys(["mask", "sun-visibility", "tile", "cell", "source"], 0.0),
    "normal": 1e-11,
    "radiance-factor": 1e-11,
    "aspect": 1e-7,  # level ground: over the sine of the slope
    "illumination-direction": OF_DIFFERENCES,
}


def require_equal(actual, expected, name):
    shape = np.asarray(expected).shape
    actual = np.asarray(actual, dtype=float).reshape(shape)
    if name in ("longitude", "aspect", "illumination-direction"):
        expected = actual + (np.asarray(expected) - actual + 180.0) % 360.0 - 180.0
    tolerance = {"rtol": 1e-6} if name in ("pixel-scale", "radiance") else {"rtol": 0.0, "atol": TOLERANCES[name]}
    np.testing.assert_allclose(actual, expected, err_msg=name, **tolerance)


def render(moon, camera, file, **options):
    return moon.render(camera.position, camera.quaternion(), TIME, camera=file, **{**OPTIONS, **options})


@pytest.mark.parametrize("name", CAMERAS)
def test_layers_meta_file_and_readings_are_those_of_numpy(moon, name):
    file = CAMERAS[name]
    camera = looking_down(file)
    names = [layer for layer in moon.models()["layers"] if layer not in ("all", "electrons", "saturated", "crater", "rays", "indirect", "object")]

    frame = render(moon, camera, file, layers=names, surface="terrain", gridH=3, gridV=2)
    several = render(moon, camera, file, layers=names, samples=4)

    np.testing.assert_allclose(frame.K, camera.K, rtol=1e-15)
    np.testing.assert_allclose(frame.R, camera.R, atol=1e-15)
    np.testing.assert_allclose(frame.t, -camera.R @ camera.position, atol=LENGTH)
    for drawn, samples in ((frame, 1), (several, 4)):
        expected = expected_layers(camera, drawn.sun_position, samples)
        assert set(drawn.layers) == set(expected)
        for layer, values in expected.items():
            require_equal(drawn.layers[layer], values, layer)
    expected = expected_layers(camera, frame.sun_position)
    require_pixels(frame.meta["PixelInformation"]["Pixel"], expected, camera)
    require_readings(frame, expected, camera)
    np.testing.assert_allclose(frame.project(expected["position"]), camera.pixels(), atol=1e-9)


def require_pixels(pixels, expected, camera):
    """Pixels of a meta file as JSON."""
    at = np.array([(pixel["v"] - 1) * camera.width + pixel["h"] - 1 for pixel in pixels])
    assert len(at) == (camera.width // 3) * (camera.height // 2)
    for layer, read in {
        "latitude": lambda pixel: pixel["SelenographicCoordinates"]["lat"],
        "longitude": lambda pixel: pixel["SelenographicCoordinates"]["lon"],
        "illumination-direction": lambda pixel: pixel["IlluminationDirection"]["value"],
        "height": lambda pixel: pixel["Height"]["value"],
        "position": lambda pixel: vector(pixel["Position"]),
        "range": lambda pixel: pixel["Range"]["value"],
        "normal": lambda pixel: vector(pixel["Normal"]),
        "incidence": lambda pixel: pixel["IncidenceAngle"]["value"],
        "emission": lambda pixel: pixel["EmissionAngle"]["value"],
        "phase": lambda pixel: pixel["PhaseAngle"]["value"],
        "sun-visibility": lambda pixel: pixel["Illumination"]["visibleFraction"],
        "cell": lambda pixel: [pixel["Facet"]["line"], pixel["Facet"]["sample"]],
    }.items():
        require_equal([read(pixel) for pixel in pixels], expected[layer][at], layer)


def vector(element):
    return [element["Vector3D"][name] for name in "xyz"]


def require_readings(frame, expected, camera):
    """Points that the server reads one by one, whole pixels and others, and where it says that they are seen."""
    at = np.array([0, 31, 17 * 32 + 9, 23 * 32 + 30])
    readings = frame.locate(camera.pixels()[at])
    for layer, name in {"range": "distance", "sun-visibility": "lit_fraction", **{name: name.replace("-", "_") for name in (
        "latitude", "longitude", "height", "position", "incidence", "emission", "phase", "illumination-direction", "pixel-scale", "slope",
    )}}.items():  # fmt: skip
        require_equal([getattr(reading, name) for reading in readings], expected[layer][at], layer)
    require_equal([reading.facet[:2] for reading in readings], expected["cell"][at], "cell")
    between = np.array([[0.3, 1.8], [17.25, 9.5]])
    points = np.array([reading.position for reading in frame.locate(between)])
    np.testing.assert_allclose(points, GROUND.hit(camera.position, camera.rays(between)), atol=LENGTH)
    places = np.stack([expected[layer][at] for layer in ("latitude", "longitude", "height")], axis=1)
    seen = frame.visible(places)
    np.testing.assert_allclose([[one["x"], one["y"]] for one in seen], camera.pixels()[at], atol=1e-6)


@pytest.mark.parametrize(("way", "direction"), [(1.0, "down"), (-1.0, "up")])
def test_detector_that_scans_up_or_down_keeps_the_truth_of_the_frame(moon, way, direction):
    scanned = {**DETECTOR, "shutter": "rolling", "line-time": 1e-2, "smear-row-time": 1e-7, "smear-direction": direction}
    camera = looking_down(PINHOLE)
    names = ["depth", "range", "position", "mask", "pixel-scale", "electrons", "saturated"]
    along = 4e4 * way * camera.R[1]  # m/s: a pixel while the shutter goes over the image
    motion = [*along, 0.0, 0.0, 0.0]

    still = render(moon, camera, {**PINHOLE, "detector": DETECTOR}, layers=names)
    frame = render(moon, camera, {**PINHOLE, "detector": scanned}, layers=names, motion=motion)

    expected = expected_layers(camera, frame.sun_position)
    for name in names[:5]:
        require_equal(frame.layers[name], expected[name], name)
        require_equal(still.layers[name], expected[name], name)
    assert not np.array_equal(frame.layers["electrons"], still.layers["electrons"])
    # Electrons: irradiance over a flat aperture, in a band whose photons have nearly the energy of 643 nm.
    incoming = expected["radiance"] * (expected["pixel-scale"] / expected["range"]) ** 2 * expected["depth"] / expected["range"]
    photons = incoming * np.pi * 2.5e-3**2 * 20.0 * 1e-4 * 643e-9 / (6.62607015e-34 * 299792458.0)
    ratio = still.layers["electrons"].ravel() / (0.5 * photons)
    np.testing.assert_allclose(ratio / ratio.mean(), 1.0, atol=1e-3)  # a pixel of 0.02 rad is not small
    assert ratio.mean() == pytest.approx(1.0, abs=0.02)
    full = np.floor(still.layers["electrons"] / 2000.0 + 0.5) >= 4095
    assert 0 < full.sum() < full.size
    np.testing.assert_array_equal(still.layers["saturated"], full)


def test_low_sun_is_hidden_where_the_ground_is_in_between(moon):
    camera = looking_down(CAMERAS["opencv"], latitude=35.0, longitude=43.0, height=5e5)

    frame = render(moon, camera, CAMERAS["opencv"], layers=["mask", "sun-visibility", "position"])

    some = slice(None, None, 11)
    points = GROUND.hit(camera.position, camera.rays(camera.pixels()))
    require_equal(frame.layers["position"], points, "position")
    points = points[some]
    to_sun = unit(frame.sun_position - points)
    clearance = GROUND.clearance(points, to_sun)
    reached = (dot(GROUND.facet(points)[4], to_sun) > 0.0) & (clearance > 0.0)
    state = np.where(reached, 1, np.where(dot(points, to_sun) > 0.0, 3, 4))
    sure = np.abs(clearance) > 5.0  # m: steps of 100 m miss the top of a ridge by less
    assert sure.mean() > 0.8 and set(state[sure]) == {1, 3, 4}
    np.testing.assert_array_equal(frame.mask.ravel()[some][sure], state[sure])
    np.testing.assert_array_equal(frame.layers["sun-visibility"].ravel()[some][sure], reached[sure])


def test_files_of_the_command_line_are_those_of_numpy(tmp_path):
    camera = looking_down(CAMERAS["opencv"])
    (tmp_path / "own.yaml").write_text(json.dumps(CAMERAS["opencv"]))  # JSON is YAML
    state = ",".join(repr(float(number)) for number in (TIME, *camera.position, *camera.quaternion()))
    subprocess.run(
        [_process.find_program(), "--fixed-state", f"{{{state}}}", "--camera", str(tmp_path / "own.yaml"), "--renderer", "native",
         "--lod", "off", "--reflectance", "lambert", "--samples", "4", "--layers", "all", "--layers-format", "npy", "--surface", "terrain",
         "--grid", "5", "--output-dir", str(tmp_path), "--batch"],
        check=True, capture_output=True,
    )  # fmt: skip

    (meta,) = tmp_path.glob("*.xml")
    root = ElementTree.parse(meta).getroot()
    sun = np.array([float(root.find("GeneralInformation/SunPosition/Vector3D").get(name)) for name in "xyz"])
    expected = expected_layers(camera, sun, samples=4)
    del expected["source"]  # `all` leaves it out of one model
    files = {path.name.split(".")[-2]: np.load(path) for path in tmp_path.glob("*.npy")}
    assert set(files) == set(expected)
    for layer, values in expected.items():
        require_equal(files[layer], values, layer)
    pixels = root.findall("PixelInformation/Pixel")
    at = np.array([(int(pixel.get("v")) - 1) * camera.width + int(pixel.get("h")) - 1 for pixel in pixels])
    positions = [[float(pixel.find("Position/Vector3D").get(name)) for name in "xyz"] for pixel in pixels]
    require_equal(positions, expected["position"][at], "position")
    for layer, element in {"range": "Range", "incidence": "IncidenceAngle", "illumination-direction": "IlluminationDirection"}.items():
        require_equal([float(pixel.find(element).text) for pixel in pixels], expected[layer][at], layer)

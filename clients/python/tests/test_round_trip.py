"""Numbers come back as the doubles that they were, so that the same state again is the same frame."""

import json
import re

import msisf
import numpy as np
from msisf._http import parts_of
from test_render import DETECTOR

SMALL = msisf.Camera(64, 48, 40.123456789012345)


def test_state_that_is_read_from_a_frame_has_the_same_noise(moon):
    random = np.random.default_rng(2)
    for _ in range(8):
        place = (random.uniform(-85, 85), random.uniform(0, 360), random.uniform(5e4, 5e5))
        frame = moon.render(place, time=55289.0 + random.uniform(0, 5000), nadir=True, roll=random.uniform(0, 360), camera=DETECTOR)

        again = moon.render(frame.position, frame.quaternion, frame.mjd, camera=DETECTOR)

        np.testing.assert_array_equal(again.image, frame.image)
        assert (again.position == frame.position).all() and (again.quaternion == frame.quaternion).all() and again.mjd == frame.mjd
    other = moon.render(frame.position + np.spacing(frame.position), frame.quaternion, frame.mjd, camera=DETECTOR)
    assert (other.image != frame.image).any()  # a neighbour is another state: its noise is another one


def test_every_double_of_a_state_comes_back(moon):
    random = np.random.default_rng(3)
    needed_17_digits = 0
    for _ in range(10):
        quaternion = random.normal(size=4)
        quaternion /= np.linalg.norm(quaternion)
        direction = random.normal(size=3)
        position = random.uniform(1.8e6, 1e7) * direction / np.linalg.norm(direction)
        mjd, exposure = random.uniform(50000, 60000), random.uniform(0.1, 2.0)

        frame = moon.render(position, quaternion, mjd, camera=SMALL, exposure=exposure)

        state = [mjd, *position, *quaternion]
        assert [frame.mjd, *frame.position, *frame.quaternion] == state
        words = frame.meta["GeneralInformation"]["CommandLine"]
        assert [float(number) for number in re.search(r"--fixed-state '\{(.*?)\}'", words)[1].split(",")] == state
        assert float(re.search(r"--exposure (\S+)", words)[1]) == exposure
        assert float(re.search(r"--fov (\S+)", words)[1]) == frame.meta["GeneralInformation"]["FOV"]["value"] == SMALL.fov
        needed_17_digits += sum(float(f"{number:.15e}") != number for number in state)
    assert needed_17_digits > 10


def test_all_numbers_of_the_json_are_those_of_the_array_files(moon):
    """The array files have doubles as they are, and layers.json, which another writer makes, numbers that read back."""
    layers = ["position", "normal"]
    camera = {"width": 64, "height": 48, "focal-length-px": [71.3, 70.1], "skew": 0.3, "principal-point": [30.1, 20.7],
              "distortion": {"model": "opencv", "k1": -0.123456789012345678, "p1": 0.00123456789012345678}}  # fmt: skip
    request = {"position": [10.1, 20.2, 1e5], "time": 55285.123456789, "look-at": [10.5, 20.5], "camera": camera, "grid": 4,
               "surface": "terrain", "layers": layers, "layers-format": "npy", "model": "LDEM_4"}  # fmt: skip
    headers, content = moon._http.post("/v1/render", request, "multipart/mixed, application/x-npy, application/json")
    parts = parts_of(headers, content)
    meta, other = (json.loads(bytes(parts[name].content)) for name in ("json", "layers.json"))
    general = meta["GeneralInformation"]

    def vector(element):
        return [element["Vector3D"][axis] for axis in "xyz"]

    assert vector(general["CameraPosition"]) == other["cameraPositionM"]
    assert [general["CameraOrientation"]["Quaternion"][name] for name in "xyzr"] == other["cameraQuaternionXyz0"]
    assert vector(general["SunPosition"]) == other["sunPositionM"]
    assert general["SimulationTime"]["MJD"] == other["mjdUtc"] == request["time"]
    assert general["FlightAltitude"]["value"] == other["flightAltitudeM"]
    assert general["HeightOverTerrain"]["value"] == other["heightOverTerrainM"]
    assert general["Camera"]["K"]["value"] == np.ravel(other["K"]).tolist()
    assert general["Camera"]["R"] == np.ravel(other["R"]).tolist()
    assert general["Camera"]["t"]["value"] == other["t"]
    assert general["Camera"]["Distortion"]["value"] == other["distortion"]
    assert general["Camera"]["Distortion"]["value"][0] == camera["distortion"]["k1"]

    frame = moon.render((10.1, 20.2, 1e5), time=request["time"], look_at=(10.5, 20.5), camera=camera, layers=layers)
    pixels = meta["PixelInformation"]["Pixel"]
    assert len(pixels) == 16 * 12
    for pixel in pixels:
        at = (pixel["v"] - 1, pixel["h"] - 1)
        assert vector(pixel["Position"]) == frame.layers["position"][at].tolist()
        assert vector(pixel["Normal"]) == frame.layers["normal"][at].tolist()
    # Of every kind of number some need 17 digits; one that was rounded to 16 has none.
    for name in ("lat", "lon", "IlluminationDirection", "Height", "Range", "IncidenceAngle", "EmissionAngle", "PhaseAngle"):
        values = [value for pixel in pixels for value in numbers_of(pixel, name)]
        assert len(values) == len(pixels)
        assert sum(float(f"{value:.15e}") != value for value in values) > 5, name


def numbers_of(element, name):
    """The numbers of a name, at any depth."""
    for key, value in element.items():
        if isinstance(value, dict):
            yield from [value["value"]] if key == name else numbers_of(value, name)
        elif key == name:
            yield value

"""Arguments as NumPy users have them; frames as Python users treat them."""

import copy
import datetime
import pathlib
import pickle

import msisf
import numpy as np
import pytest
from msisf._values import time_text

PLACE = {"position": (10.0, 20.0, 1e5), "time": 55289.0, "look_at": (10.5, 20.5)}
SMALL = msisf.Camera(64, 48, 40.0)
NOWHERE = "http://127.0.0.1:9"


@pytest.fixture(scope="module")
def frame(moon):
    return moon.render(**PLACE, camera=SMALL, layers=["depth", "mask"])


@pytest.mark.parametrize(
    "arguments",
    [
        {"position": np.array([10.0, 20.0, 1e5])},
        {"position": np.array([[10], [20], [100000]], dtype=np.int32)},
        {"position": [np.float32(10.0), np.int8(20), np.float64(1e5)]},
        {"time": np.float64(55289.0)},
        {"time": np.int64(55289)},
        {"time": np.array([55289.0])},
        {"time": np.datetime64("2010-04-03")},
        {"time": np.array("2010-04-03T00:00:00.000000000", dtype="datetime64[ns]")},
        {"time": np.str_("2010-04-03T00:00:00Z")},
        {"look_at": np.array([10.5, 20.5])},
        {"look_at": np.array([10.5, 20.5])[:, None]},
        {"camera": msisf.Camera(np.int64(64), np.uint16(48), np.float32(40.0))},
        {"camera": {"width": np.int64(64), "height": 48, "field-of-view": np.array(40.0), "principal-point": np.array([32.5, 24.5])}},
        {"samples": np.int64(1), "bit_depth": np.int64(8)},
        {"reflectance": np.str_("moon")},
        {"roll": np.float32(0.0), "look_at": None, "nadir": np.bool_(True), "position": (10.5, 20.5, 1e5)},
        {"layers": np.array(["depth", "mask"])},
        {"layers": ("depth", "mask")},
        {"layers": "depth"},
        {"layers": np.str_("depth")},
    ],
)
def test_numpy_is_taken_for_every_argument(moon, frame, arguments):
    layers = arguments.get("layers", ["depth", "mask"])

    other = moon.render(**{**PLACE, "camera": SMALL, "layers": ["depth", "mask"], **arguments})

    assert list(other.layers) == (["depth"] if isinstance(layers, str) else ["depth", "mask"])
    if "nadir" not in arguments:
        np.testing.assert_array_equal(other.image, frame.image)
        np.testing.assert_array_equal(other.depth, frame.depth)


def test_numpy_is_taken_by_all_methods(moon, frame):
    own = msisf.Moon(np.str_(moon.address), model=np.array(["LDEM_4"]), timeout=np.float32(60), samples=np.int64(1))
    np.testing.assert_array_equal(own.render(**PLACE, camera=SMALL).image, frame.image)
    assert own.sun(np.float32(55289), np.array([10.0, 20.0])) == own.sun(55289, (10, 20)) == own.sun("2010-04-03T00:00:00Z", [10, 20])
    assert own.sun(np.datetime64("2010-04-03")) == own.sun(datetime.datetime(2010, 4, 3, tzinfo=datetime.timezone.utc))
    state = (frame.position[None, :], frame.quaternion[:, None], np.array([frame.mjd]))
    with own.stream(camera=SMALL, timing=np.bool_(True), newest_only=np.bool_(False)) as stream:
        np.testing.assert_array_equal(stream.render(*state), frame.image)
    view = own.view(*state, camera=msisf.Camera(np.int64(64), np.int64(48), np.float64(40.0)))
    np.testing.assert_allclose(view.K, frame.K, rtol=1e-15)
    np.testing.assert_allclose(view.R, frame.R, atol=1e-15)
    (one,), (two,) = view.locate(np.array([10, 20])), frame.locate([[10.0, 20.0]])
    assert one.height == two.height
    assert view.locate([]) == view.visible(np.empty((0, 2))) == [] and view.project([]).shape == (0, 2)
    assert view.visible(np.float32([10, 20])) == frame.visible([(10, 20)])


@pytest.mark.parametrize(
    ("wrong", "text"),
    [
        (lambda moon: moon.render((1, "x", 3), time=0, nadir=True), "position: numbers are needed"),
        (lambda moon: moon.render((1, 2), time=0, nadir=True), "position: 2 given; 3 are needed"),
        (lambda moon: moon.render((1, 2, np.nan), time=0, nadir=True), "position: not all numbers are finite"),
        (lambda moon: moon.render((1, 2, 3), (0, 0, 1), 0), "orientation_xyz0: 3 given; 4 are needed"),
        (lambda moon: moon.render((1, 2, 3), time=0, look_at=5), "look_at: 1 given; 2 or 3 are needed"),
        (lambda moon: moon.render((1, 2, 3), time=float("nan"), nadir=True), "time is nan; give an MJD"),
        (lambda moon: moon.render((1, 2, 3), time=datetime.date(2010, 4, 3), nadir=True), "time is 2010-04-03; give an MJD"),
        (lambda moon: moon.render((1, 2, 3), time=np.datetime64("NaT"), nadir=True), "time is NaT; give an MJD"),
        (lambda moon: moon.render((1, 2, 3), time=0, nadir=True, fov=object()), "fov is of the type object"),
        (lambda moon: moon.render((1, 2, 3), time=0, nadir=True, fov=np.inf), "fov is inf"),
        (lambda moon: moon.render((1, 2, 3), time=0, nadir=True, camera={"width": 1j}), "camera, width is of the type complex"),
        (lambda moon: moon.render((1, 2, 3), time=0, nadir=True, layers=[{1}]), "layers is of the type set"),
        (lambda moon: moon.view((1, 2, 3), (0, 0, 0, 1), 0, camera="thesis"), "a view needs an msisf.Camera"),
        (lambda moon: moon.view((1, 2, 3), (0, 0, 0, 1), 0).locate([1, 2, 3]), "pixels: 3 numbers given; rows of 2"),
        (lambda moon: moon.view((1, 2, 3), (0, 0, 0, 1), 0).visible([[1]]), "places: 1 x 1 numbers given; rows of 2 or 3"),
        (lambda moon: moon.view((1, 2, 3), (0, 0, 0, 1), 0).project([1, "x", 3]), "points: numbers are needed"),
        (lambda moon: moon.sun(0, (1,)), "place: 1 given; 2 are needed"),
        (lambda moon: moon.stream(fov=[np.nan]), "fov is nan"),
        (lambda moon: msisf.Moon(NOWHERE, timeout=0), "timeout is 0"),
        (lambda moon: msisf.Moon("http://127.0.0.1:port").models(), "http://127.0.0.1:port: "),
        (lambda moon: msisf.Moon(pathlib.Path("/no/such.sock")).models(), "/no/such.sock: no answer"),
        (lambda moon: msisf.Moon(NOWHERE, token="\u2603" * 16).models(), NOWHERE),
        (lambda moon: moon.models(), f"{NOWHERE}: no answer"),
    ],
)
def test_wrong_argument_is_an_msisf_error_that_names_it(wrong, text):
    with pytest.raises(msisf.MsisfError, match=text):
        wrong(msisf.Moon(NOWHERE))


def test_time_keeps_its_digits():
    assert time_text(55289.12345678901) == "55289.12345678901"
    assert time_text(np.datetime64("2010-04-03T01:02:03.123456")) == "2010-04-03T01:02:03.123456Z"
    assert time_text(np.datetime64("2010-04-03T01:02:03.123456789")) == "2010-04-03T01:02:03.123456789Z"


def test_frame_says_what_it_is(moon, frame):
    assert repr(frame).startswith("<msisf.Frame from (17")
    assert repr(frame).endswith(" m at 2010-04-03T00:00:00Z: 64 x 48 px, uint8, layers depth, mask>")
    view = moon.view((1.9e6, 0.0, 0.0), (0, 0, 0, 1), 55289)
    assert repr(view) == "<msisf.View from (1900000.0, 0.0, 0.0) m>"


def test_frame_is_pickled_and_copied(moon, frame, tmp_path):
    frame.save(tmp_path / "frame.png")
    for other in (pickle.loads(pickle.dumps(frame)), copy.copy(frame), copy.deepcopy(frame)):
        assert repr(other) == repr(frame)
        np.testing.assert_array_equal(other.image, frame.image)
        np.testing.assert_array_equal(other.depth, frame.depth)
        np.testing.assert_array_equal(other.project([1.7374e6, 3e5, 3e5]), frame.project([1.7374e6, 3e5, 3e5]))
        other.save(tmp_path / "other.png")
        assert (tmp_path / "other.png").read_bytes() == (tmp_path / "frame.png").read_bytes()
        if other.moon is None:
            with pytest.raises(msisf.MsisfError, match="came out of a pickle"):
                other.locate([1, 2])
            other.moon = moon
        assert other.moon is moon
        assert other.locate([1, 2])[0].height == frame.locate([1, 2])[0].height
    assert copy.deepcopy(frame).image is not frame.image


def test_everything_that_a_process_hands_to_another_is_pickled(moon, frame):
    with moon.stream(camera=SMALL) as stream:
        stream.send((1.9e6, 0, 0), (0, 0, 0, 1), 55289)
        image = stream.receive()
    assert pickle.loads(pickle.dumps(image)).number == 1
    (point,) = frame.locate([1, 2])
    assert pickle.loads(pickle.dumps(point)).facet == point.facet
    assert pickle.loads(pickle.dumps(SMALL)) == SMALL
    assert pickle.loads(pickle.dumps(moon.view((1.9e6, 0.0, 0.0), (0, 0, 0, 1), 55289))).position[0] == 1.9e6
    error = pickle.loads(pickle.dumps(msisf.RequestError("no", 400, ["--fov"])))
    assert (str(error), error.status, error.options) == ("no", 400, ["--fov"])
    assert str(pickle.loads(pickle.dumps(msisf.ServerError("gone")))) == "gone"

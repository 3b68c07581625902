"""Moon.render against what geometry says, and against msis itself."""

import copy
import datetime
import json
import pickle
import subprocess
import warnings

import msisf
import numpy as np
import pytest
from msisf import _process

STATE = {"position": (1.9e6, 0.0, 0.0), "orientation_xyz0": (0.0, 0.0, 0.0, 1.0), "time": 55289.0}
SMALL = msisf.Camera(64, 48, 40.0)
DETECTOR = {
    "width": 64, "height": 48, "focal-length": 10, "pixel-pitch": 0.1,
    "detector": {
        "f-number": 4, "band": [500, 650], "transmission": 0.8, "quantum-efficiency": 0.45, "exposure-time": 2e-5, "gain": 2,
        "read-noise": 15, "bias": 64, "full-well": 40000, "adc-bits": 12, "seed": 7,
    },
}  # fmt: skip


def test_image_is_that_of_msis(moon, tmp_path):
    subprocess.run(
        [_process.find_program(), "--fixed-state", "{55289,1.9e6,0,0,0,0,0,1}", "--width", "64", "--height", "48", "--renderer", "native",
         "--layers", "depth,radiance-factor", "--layers-format", "npy", "--output-dir", str(tmp_path), "--batch"],
        check=True, capture_output=True,
    )  # fmt: skip

    frame = moon.render(**STATE, camera=SMALL, layers=["depth", "radiance-factor"])

    assert frame.camera_models == {}
    assert frame.image.shape == (48, 64) and frame.image.dtype == np.uint8
    for name in ("depth", "radiance-factor"):
        (path,) = tmp_path.glob(f"*.{name}.npy")
        np.testing.assert_array_equal(frame.layers[name], np.load(path))
    assert frame.image.max() > 50
    frame.save(tmp_path / "saved.png")
    (path,) = tmp_path.glob("Moon*.png")
    assert (tmp_path / "saved.png").read_bytes() == path.read_bytes()


def test_camera_models_are_those_of_msis(moon, tmp_path):
    subprocess.run(
        [_process.find_program(), "--fixed-state", "{55289,1.9e6,0,0,0,0,0,1}", "--width", "64", "--height", "48", "--renderer", "native",
         "--camera-model", "csm,tsai", "--output-name", "frame", "--output-dir", str(tmp_path), "--batch"],
        check=True, capture_output=True,
    )  # fmt: skip

    frame = moon.render(**STATE, camera=SMALL, camera_model=["csm", "tsai"], layers="depth")

    assert frame.camera_models == {name: (tmp_path / f"frame.{name}").read_text() for name in ("csm.json", "tsai")}
    assert frame.depth.shape == (48, 64)


def test_invented_detail_is_that_of_msis_and_says_so(moon, tmp_path):
    near = {**STATE, "position": (1.8e6, 0.0, 0.0)}
    subprocess.run(
        [_process.find_program(), "--fixed-state", "{55289,1.8e6,0,0,0,0,0,1}", "--width", "64", "--height", "48", "--renderer", "native",
         "--refine", "7", "--refine-cell", "64", "--layers", "depth", "--layers-format", "npy", "--output-dir", str(tmp_path), "--batch"],
        check=True, capture_output=True,
    )  # fmt: skip

    frame = moon.render(**near, camera=SMALL, layers=["depth"], refine=7, refine_cell=64)

    (path,) = tmp_path.glob("*.depth.npy")
    np.testing.assert_array_equal(frame.depth, np.load(path))
    assert frame.locate([[31.5, 23.5]])[0].invented
    assert not moon.render(**near, camera=SMALL).locate([[31.5, 23.5]])[0].invented


def test_images_of_several_cameras_are_those_of_each(moon):
    cameras = [SMALL, msisf.Camera(31, 17, 5.0), DETECTOR]
    state = (STATE["position"], STATE["orientation_xyz0"], STATE["time"])
    with moon.stream(cameras=cameras) as stream:
        for _ in range(2):
            images = stream.render_all(*state)
            for image, camera in zip(images, cameras):
                np.testing.assert_array_equal(image, moon.render(*state, camera=camera).image)
            assert len(images) == 3
        stream.send(*state)
        assert [image.camera for image in stream] == [0, 1, 2]
    with pytest.raises(msisf.MsisfError, match="give a camera, or a list"):
        moon.stream(camera=SMALL, cameras=[SMALL])


RIG = """cameras:
  left:
    width: 64
    height: 48
    fov: 40
    quaternion: [0.02, -0.3, 0.1, 0.9484724561103501]
    offset: [3, -250, 40]
  line:
    camera: line.yaml
    lines: 12
    quaternion: [0, 0, 0.28, 0.96]
"""
LINE = {"width": 40, "height": 1, "focal-length-px": 90, "scan": {"kind": "line-scan", "period": 0.6}}
MOTION = (10.0, 1600.0, -30.0, 0.001, 0.02, -0.003)


def test_images_of_a_rig_are_those_of_msis(moon, tmp_path):
    (tmp_path / "rig.yaml").write_text(RIG)
    (tmp_path / "line.yaml").write_text(json.dumps(LINE))
    subprocess.run(
        [_process.find_program(), "--fixed-state", "{55289,1.9e6,1e5,0,0,0.28,0,0.96}", "--motion", "{10,1600,-30,0.001,0.02,-0.003}",
         "--rig", tmp_path / "rig.yaml", "--renderer", "native", "--layers", "radiance-factor", "--layers-format", "npy", "--transfer",
         "linear", "--exposure", "1", "--output-name", "{camera}", "--output-dir", tmp_path, "--batch"],
        check=True, capture_output=True,
    )  # fmt: skip
    left = msisf.Mounted(SMALL, (0.02, -0.3, 0.1, 0.9484724561103501), (3, -250, 40), "left")
    line = msisf.Mounted(LINE, (0.0, 0.0, 0.28, 0.96), name="line", options={"lines": 12})
    with moon.stream(cameras=[left, line], transfer="linear", exposure=1) as stream:
        images = stream.render_all((1.9e6, 1e5, 0.0), (0.0, 0.28, 0.0, 0.96), 55289.0, MOTION)
    frames = moon.render_all(
        (1.9e6, 1e5, 0.0), (0.0, 0.28, 0.0, 0.96), 55289.0, cameras=[left, line], motion=MOTION, transfer="linear", exposure=1,
        layers=["radiance-factor", "position"])  # fmt: skip
    for frame, image in zip(frames, images):
        np.testing.assert_array_equal(frame.image, image)
    row, column = np.argwhere(np.isfinite(frames[0].layers["position"][..., 0]))[7]
    np.testing.assert_allclose(
        frames[0].locate([(column, row)])[0].position, frames[0].layers["position"][row, column], atol=1e-6)  # fmt: skip
    with pytest.raises(msisf.MsisfError, match="render it alone"):
        frames[1].locate([(1, 1)])
    assert frames[1].meta["GeneralInformation"]["Rig"]["OtherCamera"][0]["name"] == "left"
    for name, image in zip(("left", "line"), images):
        factor = np.load(tmp_path / f"{name}.radiance-factor.npy").reshape(image.shape)
        np.testing.assert_array_equal(image, np.floor(255.0 * np.clip(np.nan_to_num(factor), 0.0, 1.0) + 0.5))
        assert image.max() > 5
    for wrong, said in (
        ([left, left], "one name"), ([msisf.Mounted(SMALL, (0, 0, 0, 2))], "has length 2, and a rotation"),
        ([msisf.Mounted(SMALL, name="a b")], "is not a name of a camera"),
        ([msisf.Mounted(SMALL, options={"lines": 3})], "--lines needs a camera"),
    ):  # fmt: skip
        with pytest.raises(msisf.RequestError, match=said):
            moon.stream(cameras=wrong)
        with pytest.raises(msisf.RequestError, match=said):
            moon.render_all((1.9e6, 1e5, 0.0), (0.0, 0.28, 0.0, 0.96), 55289.0, cameras=wrong)


def test_scan_is_that_of_msis(moon, tmp_path):
    """A scan along samples of a motion, with jitter: the same lists that the files of msis have."""
    samples = [[55289 + k / 86400, 1.9e6, 2e5 + 1600.0 * k, 3.0 * k * k, 0.0, 0.0, 0.0, 1.0] for k in range(20)]
    jitter = [["pitch", 0.4, 9000, 1], ["roll", 0.1, 9000, 0]]
    for name, rows in (("a.path", samples), ("a.jitter", jitter)):
        (tmp_path / name).write_text("".join(" ".join(x if isinstance(x, str) else repr(x) for x in row) + "\n" for row in rows))
    (tmp_path / "line.yaml").write_text(json.dumps(LINE))
    subprocess.run(
        [_process.find_program(), "--trajectory", tmp_path / "a.path", "--time", "55289.00002", "--jitter", tmp_path / "a.jitter",
         "--camera", tmp_path / "line.yaml", "--lines", "16", "--scan-period", "0.5", "--trajectory-attitudes", "squad", "--renderer",
         "native", "--layers", "depth", "--layers-format", "npy", "--output-name", "a", "--output-dir", tmp_path, "--batch"],
        check=True, capture_output=True,
    )  # fmt: skip
    frame = moon.render(
        time=55289.00002, trajectory=samples, jitter=jitter, camera=LINE, lines=16, scan_period=0.5, trajectory_attitudes="squad",
        layers=["depth"])  # fmt: skip

    np.testing.assert_array_equal(frame.depth, np.load(tmp_path / "a.depth.npy"))
    frame.save(tmp_path / "saved.png")
    assert (tmp_path / "saved.png").read_bytes() == (tmp_path / "a.png").read_bytes()
    for wrong, said in (({"jitter": [["pitch", 1]]}, "jitter, line 1"), ({"jitter": "a.txt"}, "'jitter' is"),
                        ({"trajectory": samples[:1]}, "one state only"), ({"lines": 60}, "its states reach from")):  # fmt: skip
        with pytest.raises(msisf.RequestError, match=said):
            moon.render(**{**dict(time=55289.00002, trajectory=samples, camera=LINE, lines=16), **wrong})


@pytest.mark.parametrize("options", [{"bit_depth": 16}, {"transfer": "linear"}, {"width": 1, "height": 1}])
def test_file_is_that_of_the_server_without_it(moon, options, tmp_path):
    """The file is made here, from the levels as they came."""
    frame = moon.render(**STATE, camera=msisf.Camera(201, 67, 50.0), **options)
    expected = moon._http.post("/v1/render", frame._request, "image/png")[1]
    frame.moon = None
    frame.image[:] = 0

    frame.save(tmp_path / "saved.png")

    assert (tmp_path / "saved.png").read_bytes() == expected


def test_file_of_a_detector_is_that_of_msis(moon, tmp_path):
    (tmp_path / "camera.yaml").write_text(json.dumps(DETECTOR))  # JSON is YAML
    subprocess.run(
        [_process.find_program(), "--fixed-state", "{55289,1.9e6,0,0,0,0,0,1}", "--renderer", "native",
         "--camera", str(tmp_path / "camera.yaml"), "--output-dir", str(tmp_path), "--batch"],
        check=True, capture_output=True,
    )  # fmt: skip

    frame = moon.render(**STATE, camera=DETECTOR)

    frame.save(tmp_path / "saved.png")
    (path,) = tmp_path.glob("Moon*.png")
    assert (tmp_path / "saved.png").read_bytes() == path.read_bytes()
    assert frame.image.dtype == np.uint16 and 100 < frame.image.max() < 4096


@pytest.mark.parametrize("options", [{}, {"bit_depth": 16}, {"camera": DETECTOR}, {"camera": {**DETECTOR, "width": 1, "height": 1}}])
def test_image_is_that_of_a_stream(moon, options):
    options = {"camera": SMALL, **options}
    with moon.stream(**options) as stream:  # levels as they are, without a PNG around them
        levels = stream.render(*STATE.values())

    image = moon.render(**STATE, **options).image

    np.testing.assert_array_equal(image, levels)
    assert image.dtype == levels.dtype and image.max() > 50


def test_camera_looks_along_minus_x_with_y_to_the_right(moon):
    frame = moon.render(**STATE, camera=SMALL)

    # The focal length is half the width over the tangent of half the field of view.
    assert frame.K[0, 0] == pytest.approx(32.0 / np.tan(np.radians(20.0)), rel=1e-12)
    np.testing.assert_allclose(frame.project([1.7374e6, 0.0, 0.0]), [31.5, 23.5], atol=1e-9)
    right = frame.project([[1.7374e6, 1e4, 0.0], [1.7374e6, 0.0, 1e4], [2e6, 0.0, 0.0]])
    assert right[0, 0] > 31.5 and right[0, 1] == pytest.approx(23.5)
    assert right[1, 1] < 23.5  # z is up
    assert np.isnan(right[2]).all()  # behind the camera


def test_depth_normals_and_sun_fit_together(moon):
    layers = ["depth", "position", "normal", "incidence"]
    frame = moon.render(position=(10.0, 20.0, 1e5), time="2010-04-03T00:00:00Z", nadir=True, camera=SMALL, layers=layers)

    ahead = frame.layers["position"] @ frame.R.T + frame.t
    np.testing.assert_allclose(ahead[..., 2], frame.depth, rtol=1e-9)
    np.testing.assert_allclose(np.linalg.norm(frame.normals, axis=2), 1.0, atol=1e-12)
    incidence = np.degrees(np.arccos(np.clip(frame.normals @ frame.sun_direction, -1.0, 1.0)))
    np.testing.assert_allclose(incidence, frame.incidence, atol=1e-3)  # degrees; the Sun is far, but not infinitely


def test_locate_and_project_are_inverse(moon):
    frame = moon.render(position=(10.0, 20.0, 1e5), time=55289.0, look_at=(10.5, 20.5), camera=SMALL)
    pixels = np.array([[0.0, 0.0], [31.5, 23.5], [12.25, 40.75]])

    points = frame.locate(pixels)

    np.testing.assert_allclose(frame.project([point.position for point in points]), pixels, atol=1e-6)
    seen = frame.visible([[point.latitude, point.longitude, point.height] for point in points])
    np.testing.assert_allclose([[one["x"], one["y"]] for one in seen], pixels, atol=1e-6)


def test_view_has_the_camera_of_the_drawn_frame(moon):
    state = {**STATE, "orientation_xyz0": np.array([0.1, -0.2, 0.05, 1.0]) / np.linalg.norm([0.1, -0.2, 0.05, 1.0])}
    drawn = moon.render(**state, camera=SMALL)

    frame = moon.view(**state, camera=SMALL)

    np.testing.assert_allclose(frame.K, drawn.K, rtol=1e-15)
    np.testing.assert_allclose(frame.R, drawn.R, atol=1e-15)
    np.testing.assert_allclose(frame.t, drawn.t, atol=1e-6)
    assert frame.locate([[10.0, 23.0]])[0].height == drawn.locate([[10.0, 23.0]])[0].height


def test_named_place_is_its_numbers(moon):
    named = moon.render(position="Tycho,200000", time=55289.0, look_at="clavius", camera=SMALL)
    numbers = moon.render(position=(-43.2958, 348.785, 200e3), time=55289.0, look_at=(-58.6228, 345.272), camera=SMALL)

    assert named.image.max() > 50
    np.testing.assert_array_equal(named.image, numbers.image)
    with pytest.raises(msisf.MsisfError, match="did you mean Tycho"):
        moon.render(position="Tyco,200000", time=55289.0, nadir=True, camera=SMALL)


def test_look_is_its_options(moon):
    near = {"position": (10.0, 20.0, 6e4), "time": 55289.0, "look_at": (10.5, 20.5), "camera": SMALL}
    looked = moon.render(**near, look="photo", samples=4)
    given = moon.render(**near, shading="smooth", sun="disc", refine=1, samples=4)
    plain = moon.render(**near, samples=4)

    np.testing.assert_array_equal(looked.image, given.image)
    assert (looked.image != plain.image).any()


def test_sky_is_no_surface_point(moon):
    frame = moon.render(position=(0.0, 0.0, 1e5), time=55289.0, look_at="horizon:90", camera=SMALL)

    assert frame.locate([[31.5, 0.0]]) == [None]


def test_times_are_the_same(moon):
    when = datetime.datetime(2010, 4, 3, tzinfo=datetime.timezone.utc)
    by_mjd, by_text, by_date = (
        moon.render(position=(0.0, 0.0, 1e5), time=time, nadir=True, camera=SMALL) for time in (55289.0, "2010-04-03T00:00:00Z", when)
    )

    np.testing.assert_array_equal(by_mjd.image, by_text.image)
    np.testing.assert_array_equal(by_mjd.image, by_date.image)
    assert by_date.utc.startswith("2010-04-03T00:00:00")


def test_options_go_by_the_names_of_the_command_line(moon):
    frame = moon.render(**STATE, camera=SMALL, bit_depth=16, reflectance="lambert", samples=4)

    assert frame.image.dtype == np.uint16
    assert "--samples 4" in frame.meta["GeneralInformation"]["CommandLine"]


SIXTEEN_BITS = {"width": 40, "height": 30, "focal-length": 5, "pixel-pitch": 0.1, "detector": {
    "aperture": 1, "exposure-time": 1e-5, "band": [500, 650], "quantum-efficiency": 0.45, "gain": 1, "adc-bits": 16, "fits": "no",
}}  # fmt: skip


def test_noise_seed_draws_other_noises_of_one_state(moon):
    frames = (moon.render(**STATE, camera=SIXTEEN_BITS, noise_seed=seed) for seed in (7, 7, 8, "7:2"))
    first, again, second, third = (frame.image.astype(float) for frame in frames)

    np.testing.assert_array_equal(first, again)
    signal = first.mean()
    for other in (second, third):
        assert (first - other).var() == pytest.approx(2.0 * signal, rel=0.2)  # shot noise of one electron per DN, drawn twice


def test_exposure_time_goes_before_the_cameras(moon):
    short, long = (moon.render(**STATE, camera=SIXTEEN_BITS, exposure_time=time, noise_seed=1) for time in (1e-5, 2e-5))

    assert long.image.mean() == pytest.approx(2.0 * short.image.mean(), rel=0.01)
    assert "--exposure-time 2E-05" in long.meta["GeneralInformation"]["CommandLine"]
    with pytest.raises(msisf.RequestError, match="Give seconds"):
        moon.render(**STATE, camera=SIXTEEN_BITS, exposure_time="auto")


def test_camera_file_and_preset(moon):
    own = moon.render(**STATE, camera={"width": 40, "height": 30, "focal-length-px": [50, 51], "principal-point": [19, 16]})

    assert own.K[0, 0] == 50.0 and own.K[1, 1] == 51.0
    np.testing.assert_allclose(own.K[:2, 2], [18.0, 15.0])  # the file counts from 1
    assert any(camera["name"] == "clementine-uvvis" for camera in moon.models()["cameras"])


@pytest.mark.parametrize(
    ("wrong", "text"),
    [
        ({"camera": msisf.Camera(64, 64, 500.0)}, "--fov is 500"),
        ({"layers": ["depht"]}, "did you mean depth"),
        ({"widht": 5}, "did you mean width"),
        ({"camera": "cassini"}, "which the server does not have"),
    ],
)
def test_wrong_request_says_what_the_server_says(moon, wrong, text):
    with pytest.raises(msisf.RequestError, match=text) as error:
        moon.render(**STATE, **wrong)
    assert error.value.status == 400


def test_two_ways_to_point_are_refused(moon):
    with pytest.raises(msisf.MsisfError, match="orientation_xyz0, look_at and nadir"):
        moon.render(**STATE, nadir=True)
    with pytest.raises(msisf.MsisfError, match="has no zone"):
        moon.render(position=(0, 0, 1e5), time=datetime.datetime(2010, 4, 3), nadir=True)


def test_time_is_needed(moon):
    with pytest.raises(msisf.MsisfError, match="time is missing: give an MJD"):
        moon.render((0, 0, 1e5), nadir=True)


def test_layer_that_was_not_asked_for_is_named(moon):
    with pytest.raises(AttributeError, match="layers are asked for"):
        _ = moon.render(**STATE, camera=SMALL).depth


def circle(minutes, axes=np.eye(3)):
    """Rows of states on a circle about an axis: MJD, m, m/s."""
    radius, rate = 2e6, 8e-4
    angles = rate * 60.0 * np.asarray(minutes, dtype=float)[:, None]
    position = radius * (np.cos(angles) * axes[0] + np.sin(angles) * axes[1])
    velocity = radius * rate * (np.cos(angles) * axes[1] - np.sin(angles) * axes[0])
    return np.hstack([60328.5 + np.asarray(minutes, dtype=float)[:, None] / 1440.0, position, velocity])


def test_trajectory_places_the_camera_between_its_states(moon):
    states = circle(range(12))
    (row,) = circle([3.7])

    frame = moon.render(states=states, time=row[0], nadir=True, camera=SMALL)
    turned = moon.render(states=states, time=row[0], orientation_xyz0=frame.quaternion, camera=SMALL)

    np.testing.assert_allclose(frame.position, row[1:4], atol=2e-3)  # an MJD is rounded to 0.6 microseconds
    np.testing.assert_array_equal(turned.image, frame.image)
    assert frame.image.max() > 50
    assert frame.locate([[31.5, 23.5]])[0] is not None
    inertial = moon.render(states=states, time=row[0], nadir=True, camera=SMALL, orbit_frame="j2000")
    assert np.linalg.norm(np.subtract(inertial.position, frame.position)) > 1e5


@pytest.mark.parametrize(
    "arguments, words",
    [
        ({}, "give one of position and states"),
        ({"states": "orbit.oem", "position": (1.9e6, 0.0, 0.0)}, "give one of position and states"),
        ({"states": [[60328.5, 2e6, 0.0, 0.0]]}, "states: 1 x 4 numbers given; rows of 7 are needed"),
        ({"states": "orbit.oem"}, "not a trajectory of this server"),
        ({"states": circle([2, 1])}, "state 2: its time is not after"),
        ({"states": circle([1, 2]), "time": 60329.0}, "is outside"),
    ],
)
def test_wrong_trajectory_is_refused(moon, arguments, words):
    with pytest.raises(msisf.MsisfError, match=words):
        moon.render(**{"time": 60328.5, "nadir": True, "camera": SMALL, **arguments})


def test_trajectory_of_an_oem_is_that_of_its_states(tmp_path):
    states = circle(range(12))
    with open(tmp_path / "orbit.oem", "w") as out:
        out.write("CCSDS_OEM_VERS = 2.0\nMETA_START\nOBJECT_NAME = A\nOBJECT_ID = A\nCENTER_NAME = MOON\nREF_FRAME = MOON_ME\n"
                  "TIME_SYSTEM = UTC\nMETA_STOP\n")  # fmt: skip
        for minute, row in enumerate(states):
            out.write(f"2024-01-19T12:{minute:02d}:00 {' '.join(f'{number / 1000.0:.12f}' for number in row[1:])}\n")

    with msisf.Moon(model="LDEM_4", serve=["--folders", str(tmp_path / "orbit.oem")], camera=SMALL) as moon:
        by_name = moon.render(states="orbit.oem", time="2024-01-19T12:03:37Z", look_at=(0.0, 11.0))
        by_list = moon.render(states=states, time="2024-01-19T12:03:37Z", look_at=(0.0, 11.0))

    np.testing.assert_allclose(by_name.position, by_list.position, atol=2e-3)
    np.testing.assert_array_equal(by_name.image, by_list.image)
    assert by_name.image.max() > 50


def test_every_layer_is_an_attribute_or_warns(moon):
    of_options = ("all", "electrons", "saturated", "crater", "rays", "indirect", "object")
    names = [layer for layer in moon.models()["layers"] if layer not in of_options]
    assert not any(hasattr(msisf.Frame, layer) for layer in of_options)
    frame = moon.render((1.9e6, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0), 55289.0, camera=msisf.Camera(4, 3, 1.0), layers=names)
    assert set(frame.layers) == set(names) and len(names) > 10
    for name in names:
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            value = getattr(frame, name.replace("-", "_"))
        if value is not frame.layers[name]:
            assert [str(warning.message) for warning in said] == [
                f"frame.{name} is the camera's {name}; the layer is frame.{name}s, or frame.layers['{name}']"]  # fmt: skip
            assert getattr(frame, f"{name}s") is frame.layers[name] and value.shape == (3,)
        else:
            assert not said
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        frame.project(frame.positions.reshape(-1, 3)), repr(frame), frame.locate((1, 1)), copy.copy(frame), pickle.dumps(frame)


def test_a_frame_shows_itself_in_jupyter_and_saves_only_png(moon, tmp_path):
    frame = moon.render((1.9e6, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0), 55289.0, camera=msisf.Camera(40, 30, 40.0))
    for name in ("a.png", "b.PNG"):
        frame.save(str(tmp_path / name))
        assert (tmp_path / name).read_bytes() == frame._repr_png_()
    assert frame._repr_png_()[:8] == b"\x89PNG\r\n\x1a\n"
    for name in ("a.jpg", "a.png.jpeg", "a", "a.tif", ".png"):
        with pytest.raises(msisf.MsisfError, match=f"{name}: save.. writes PNG; give a name that ends in .png"):
            frame.save(tmp_path / name)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.png", "b.PNG"]


def test_pixels_in_messages_count_from_zero(moon):
    frame = moon.render((1.9e6, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0), 55289.0, camera=SMALL)
    view = moon.view((1.9e6, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0), 55289.0, camera=SMALL)
    assert all(frame.locate([[-0.499, -0.499], [63.499, 47.499], [0, 47], [63, 0]]))
    for asked in (frame, view):
        for x, y in ((-1, 0), (64, 0), (0, -0.5), (3, 48), (63.5, 47)):
            with pytest.raises(msisf.MsisfError) as error:
                asked.locate([(1, 2), (x, y)])
            assert str(error.value) == (
                f"the pixel ({x}, {y}) lies outside the image of 64 x 48 px, whose pixels are (0, 0) to (63, 47)")  # fmt: skip

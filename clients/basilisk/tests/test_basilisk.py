"""msis in Vizard's place, played by vizinterface.py."""
import os
import random
import re
import shlex
import signal
import socket
import subprocess
import threading
import time
from pathlib import Path

import numpy as np
import pytest

zmq = pytest.importorskip("zmq")

from vizinterface import (Camera, VizInterface, body, craft, matrix_of_rodrigues, message, rodrigues_of_matrix, whole)  # noqa: E402

ROOT = Path(__file__).resolve().parents[3]
MSIS = os.environ.get("MSISF_PROGRAM", str(ROOT / "msis"))
EPOCH = (2019, 3, 4, 5, 6, 7.25)
EPOCH_MJD = 58546 + (5 * 3600 + 6 * 60 + 7.25) / 86400  # 2019-03-04
LONG = os.environ.get("MSISF_LONG_TESTS") == "1"


def free_address():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return f"tcp://127.0.0.1:{probe.getsockname()[1]}"


class Server:
    """The server as Basilisk's scripts start it, in a folder of its own."""

    def __init__(self, folder, options="", mode="-noDisplay"):
        self.address, self.folder = free_address(), folder
        self.process = subprocess.Popen(
            [ROOT / "clients/basilisk/vizard", "--args", mode, self.address], cwd=folder, text=True,
            env=os.environ | {"MSISF_BASILISK": f"--ldem {ROOT / 'input/ldem'} {options}"},
            stdout=subprocess.PIPE, stderr=(folder / "log").open("w"))
        assert self.process.stdout.readline().strip() == self.address

    @property
    def log(self):
        return (self.folder / "log").read_text()

    def end(self):
        self.process.kill()  # as Basilisk's scripts do
        self.process.wait(60)
        self.process.stdout.close()


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    running = Server(tmp_path_factory.mktemp("server"))
    yield running
    running.end()


def turn(axis, angle):
    """The matrix that turns components into axes that are turned about one of them."""
    c, s = np.cos(angle), np.sin(angle)
    m = np.eye(3)
    j, k = (axis + 1) % 3, (axis + 2) % 3
    m[j, j], m[j, k], m[k, j], m[k, k] = c, s, -s, c
    return m


class Flyby:
    """A craft that passes the Moon at 300 km while it, and the Moon, turn; N has its origin far away."""

    MOON_VELOCITY, SUN = np.array([400.0, -900.0, 60.0]), np.array([1.1e11, -0.9e11, 2e9])
    CAMERA = Camera(7, 41.0, 120, 90, [0.4, -1.3, 2.2], turn(2, 0.03) @ turn(0, -0.2) @ turn(1, 0.11))

    def at(self, seconds):
        moon = np.array([-2.4e10, 1.4e11, 6e9]) + seconds * self.MOON_VELOCITY
        moon_from_n = turn(2, 1.2 + 2.7e-6 * seconds) @ turn(0, 0.4) @ turn(2, -2.0)
        place = np.array([seconds * 1500.0 - 2.2e6, -2.0e6, 3e5])
        forward = -place / np.linalg.norm(place)
        right = np.cross(forward, [0.1, 0.2, 1.0])
        right /= np.linalg.norm(right)
        craft_from_n = turn(2, 1e-4 * seconds) @ np.array([right, np.cross(forward, right), forward])
        return moon, moon_from_n, moon + place, craft_from_n

    def message(self, frame, seconds, cameras=None, bodies=(), first=False):
        moon, moon_from_n, place, craft_from_n = self.at(seconds)
        return message(
            frame, seconds * 1e9, [body("Moon_planet_data", moon, moon_from_n), body("sun_planet_data", self.SUN), *bodies],
            [craft("relay", place + 1e5, [0, 0, 0]), craft("lander", place, rodrigues_of_matrix(craft_from_n))],
            [camera.message() for camera in (cameras or [self.CAMERA])], EPOCH if first else None)

    def state(self, seconds, camera):
        """Position, matrix of Moon axes from the camera's, Sun; as docs/clients.md has them."""
        moon, moon_from_n, place, craft_from_n = self.at(seconds)
        position = moon_from_n @ (place - moon + craft_from_n.T @ camera.position)
        return position, moon_from_n @ craft_from_n.T @ camera.camera_from_craft.T, moon_from_n @ (self.SUN - moon)


def recorded(path):
    """Name of the command that draws again, and the states: MJD, position, quaternion, Sun."""
    lines = path.read_text().splitlines()
    return re.search("drawn again by: (msis .*)", lines[0])[1], np.array([[float(x) for x in line.split(",")] for line in lines[2:]])


def matrix_of_quaternion(q):
    x, y, z, w = q
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + 2 * w * cross + 2 * cross @ cross


def draw_again(record, folder):
    command, _ = recorded(record)
    words = shlex.split(command)
    subprocess.run(
        [MSIS, *words[1:-1], str(record), "--ldem", str(ROOT / "input/ldem/LDEM_4.LBL"), "--output-dir", str(folder), "--batch"],
        check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return [path.read_bytes() for path in sorted(folder.glob("*.png"))]


@pytest.mark.parametrize("mode", ["-noDisplay", "-directComm"])
def test_flyby(tmp_path, mode):
    """300 steps in the order of calls of the mode; the images are those of msis from the states that the messages mean."""
    flyby, steps, every, images, seconds = Flyby(), 300, 3, [], []
    server = Server(tmp_path, "--record record", mode)
    viz = VizInterface(server.address)
    try:
        viz.ping()
        viz.ping()
        for step in range(1, steps + 1):
            time_of_step = 10.0 * step
            is_due = step % every == 0
            if mode == "-directComm" or step <= 11 or is_due:
                viz.update(flyby.message(step, time_of_step, first=step == 1))
            if mode == "-directComm":
                assert viz.ask(b"REQUEST_INPUT") == [b"VIZARD_INPUT", b""]
            if is_due:
                images.append(viz.image(flyby.CAMERA.number))
                seconds.append(time_of_step)
            if mode == "-noDisplay":
                viz.ping()
    finally:
        viz.close()
        server.end()
    assert all(image is not None and image.startswith(b"\x89PNG") for image in images), server.log
    record = tmp_path / "record/camera-7.csv"
    command, states = recorded(record)
    assert len(states) == len(images)
    opencv_from_camera = np.array([[0, 1, 0], [0, 0, -1], [-1, 0, 0]])
    for row, at in zip(states, seconds):
        position, moon_from_camera, sun = flyby.state(at, flyby.CAMERA)
        assert abs(row[0] - EPOCH_MJD - at / 86400) < 2e-11  # a double holds today's MJD to 7e-12
        np.testing.assert_allclose(row[1:4], position, rtol=0, atol=1e-4)  # m: coordinates of 1.4e11 m have steps of 3e-5 m
        np.testing.assert_allclose(matrix_of_quaternion(row[4:8]) @ opencv_from_camera.T, moon_from_camera, rtol=0, atol=1e-14)
        np.testing.assert_allclose(row[8:11], sun, rtol=1e-15, atol=1e-4)
    assert draw_again(record, tmp_path / "again") == images
    assert len(set(images)) == len(images)


def test_bytes_of_the_note():
    """The messages that this client makes are those of Basilisk (its source, read and run)."""
    assert message(1, 1e9, [], [], []).hex().startswith("0a0b0801110000000065cdcd41")
    camera = Camera(1, 55.0, 512, 512, [0, 0, 0], np.eye(3), "bskSat").message()
    assert camera.hex().startswith("0801" "1206" "62736b536174" "19" "0000000000804b40" "2204" "80048004")
    np.testing.assert_allclose(rodrigues_of_matrix(np.array([[0, 0, -1.0], [1, 0, 0], [0, -1, 0]])), [1 / 3, 1 / 3, -1 / 3], atol=1e-15)
    m = matrix_of_rodrigues([0.1, -0.3, 0.2])
    np.testing.assert_allclose(rodrigues_of_matrix(m), [0.1, -0.3, 0.2], atol=1e-15)


def test_axes(server):
    """Each arrow of docs/clients.md: what lies right, down and ahead of a camera stands there in the image."""
    moon, radius = np.array([1e9, 2e9, -3e9]), 1737.4e3
    viz = VizInterface(server.address)
    cv2 = pytest.importorskip("matplotlib.image")
    place = moon + [6e6, 0, 0]
    ahead = np.array([[0.0, 1, 0], [0, 0, -1], [-1, 0, 0]])  # x_c = N's y, y_c = -z, z_c = -x: the Moon is in the middle

    def centre(mount, sun=(1.4e11, 0, 0), moon_from_n=np.eye(3), craft_from_n=np.eye(3)):
        """Column and row of the middle of what is lit, counted from the image's middle."""
        camera = Camera(1, 60.0, 101, 81, [0, 0, 0], mount)
        viz.update(message(
            1, 1e9, [body("moon", moon, moon_from_n), body("sun", moon + np.asarray(sun))],
            [craft("lander", place, rodrigues_of_matrix(craft_from_n))], [camera.message()], EPOCH))
        levels = cv2.imread(__import__("io").BytesIO(viz.image(1)))
        rows, columns = np.nonzero(levels > 0.02)
        return columns.mean() - 50, rows.mean() - 40

    half = 40 / np.tan(np.radians(30))  # px: focal length; the field of view is the vertical one
    assert np.abs(centre(ahead)).max() < 1
    shift = half * np.tan(0.2)
    x, y = centre(turn(1, 0.2) @ ahead)  # the camera turns about its y (down) from z to x: to the right, the Moon goes to the left
    assert abs(x + shift) < 4 and abs(y) < 1
    x, y = centre(turn(0, 0.15) @ ahead)  # about its x (right) from y to z: the line of sight goes up, the Moon goes down
    assert abs(y - half * np.tan(0.15)) < 4 and abs(x) < 1
    x, _ = centre(ahead, sun=(0, 1.4e11, 0))  # the Sun is on the right
    assert x > 5
    _, y = centre(ahead, sun=(0, 0, 1.4e11))  # above
    assert y < -5
    attitude = turn(2, 0.7) @ turn(0, 0.3)
    assert np.abs(centre(ahead @ attitude.T, craft_from_n=attitude)).max() < 1  # the mounting undoes the craft's attitude
    x, _ = centre(ahead, sun=(0, 1.4e11, 0), moon_from_n=turn(2, 2.1) @ turn(0, 0.5))  # the Moon's attitude moves ground, not light
    assert x > 5
    viz.close()


def test_two_simulations_have_their_own_states(server):
    first, second, flyby = VizInterface(server.address), VizInterface(server.address), Flyby()
    first.update(flyby.message(1, 1000.0, first=True))
    second.update(flyby.message(1, 1800.0, first=True))
    one, two = first.image(7), second.image(7)
    assert one != two
    both = {}
    threads = [threading.Thread(target=lambda viz=viz, name=name: both.update({name: viz.image(7)}))
               for viz, name in ((first, "one"), (second, "two"))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(60)
    assert both == {"one": one, "two": two}
    first.close()
    second.close()


def test_what_cannot_be_drawn_is_the_invalid_image_and_the_run_goes_on(server):
    viz, flyby = VizInterface(server.address), Flyby()
    assert viz.image(7) is None  # before any update
    good = flyby.message(1, 1000.0, first=True)
    moon, rotation, place, attitude = flyby.at(1000.0)
    sun, lander = body("sun", flyby.SUN), craft("lander", place, rodrigues_of_matrix(attitude))
    camera = flyby.CAMERA.message()
    bodies = [body("moon", moon, rotation), sun]
    for wrong, words in [
            (message(1, 1e9, [body("moon", moon, rotation)], [lander], [camera], EPOCH), "no body 'sun'"),
            (message(1, 1e9, [sun], [lander], [camera], EPOCH), "no body 'moon'"),
            (message(1, 1e9, [body("moon", moon, 2 * rotation), sun], [lander], [camera], EPOCH), "the rotation of 'moon' is none"),
            (message(1, 1e9, bodies, [craft("other", place, [0, 0, 0])], [camera], EPOCH), "is on 'lander'; the message has other"),
            (message(1, 1e9, bodies, [craft("lander", [float("nan")] * 3, [0, 0, 0])], [camera], EPOCH), "three finite numbers"),
            (message(1, 1e9, bodies, [craft("lander", moon, [0, 0, 0])], [camera], EPOCH), "inside"),
            (message(1, 1e9, bodies, [lander], [Camera(7, 0.0, 120, 90, [0, 0, 0], np.eye(3)).message()], EPOCH), "field of view of 0"),
            (message(1, 1e9, bodies, [lander], [Camera(7, 40.0, 10**6, 10**6, [0, 0, 0], np.eye(3)).message()], EPOCH), "--width is"),
            (message(1, 1e9, bodies, [lander], [Camera(7, 40.0, 9000, 9000, [0, 0, 0], np.eye(3)).message()], EPOCH), "--max-pixels"),
            (message(1, 1e9, bodies, [lander], [camera + whole(16, 1)], EPOCH), "renderMode 1"),
            (message(1, 1e9, [body("moon", moon, rotation), body("sun", moon + 1e3)], [lander], [camera], EPOCH), "the Sun is"),
            (message(1, 1e9, bodies, [lander], [camera], (2019, 13, 4, 0, 0, 0.0)), "is not a date"),
            (b"no protobuf", "not a VizMessage")]:
        viz.update(wrong)
        assert viz.image(7) is None
        if words:
            assert words in server.log, (words, server.log)
        assert viz.ask(b"REQUEST_IMAGE_8")[1] == b""
        viz.update(good)
        assert viz.image(7)
    viz.update(flyby.message(2, 1010.0, bodies=[body("earth", moon + 3.8e8)], first=True))
    assert viz.image() is not None and "earth is left out" in server.log
    assert "Exception" not in server.log and "   at " not in server.log
    viz.close()


def test_cut_and_changed_messages(server):
    """Each prefix of a message, and random changes of it: an answer each time, and the next run works."""
    viz, flyby = VizInterface(server.address), Flyby()
    good, chance = flyby.message(1, 1000.0, first=True), random.Random(20120222)
    viz.update(good)
    expected = viz.image(7)
    for cut in range(0, len(good), 1 if LONG else 7):
        viz.update(good[:cut])
    for number in range(10_000 if LONG else 1_000):
        changed = bytearray(good)
        for _ in range(chance.randint(1, 4)):
            changed[chance.randrange(len(changed))] = chance.randrange(256)
        viz.update(bytes(changed))
        if number % 20 == 0:
            viz.image(7)
    viz.update(good + b"\x7a" + b"\xff\xff\xff\x04" + bytes(10**7))  # 10 MB, and the length of a field that is not there
    viz.update(good + b"\x7a\x80\xad\xe2\x04" + bytes(10**7))  # an unknown field of 10 MB
    assert viz.image(7) == expected
    assert viz.ask(b"NO_COMMAND") == [b"UNKNOWN"]
    assert viz.ask(b"SIM_UPDATE") == [b"OK"]
    assert viz.image(7) is None
    assert viz.ask(b"") == [b"UNKNOWN"]
    viz.update(good)
    assert viz.image(7) == expected
    assert "   at " not in server.log
    viz.close()


def test_a_simulation_that_dies_leaves_the_server_to_the_next(server):
    flyby = Flyby()
    lost = VizInterface(server.address)
    lost.update(flyby.message(1, 1000.0, first=True))
    lost.socket.send(b"REQUEST_IMAGE_7")
    lost.close()
    next_run = VizInterface(server.address)
    next_run.ping()
    next_run.ping()
    next_run.update(flyby.message(1, 1000.0, first=True))
    assert next_run.image(7)
    next_run.close()


def test_a_camera_file_that_disagrees_is_refused(tmp_path):
    (tmp_path / "nav.yaml").write_text("width: 120\nheight: 90\nfocal-length-px: 120\n")
    server = Server(tmp_path, "--camera 7=nav.yaml --record record")
    viz, flyby = VizInterface(server.address), Flyby()
    viz.update(flyby.message(1, 1000.0, first=True))
    assert viz.image(7) is None
    assert "px and 41.11" in server.log and "nav.yaml" in server.log
    good = Camera(7, float(np.degrees(2 * np.arctan(45 / 120))), 120, 90, [0, 0, 0], np.eye(3))
    viz.update(flyby.message(1, 1000.0, [good], first=True))
    assert viz.image(7)
    viz.close()
    server.end()


def test_moon_attitude_of_the_kernels(tmp_path):
    """The message's IAU_MOON gives way to MOON_ME at the simulation's time; another epoch is refused."""
    server = Server(tmp_path, "--moon-attitude spice --record record")
    viz, flyby = VizInterface(server.address), Flyby()
    viz.update(flyby.message(1, 1000.0, first=True))
    assert viz.image(7) is None
    assert "degrees against MOON_ME" in server.log
    moon_me = np.array([  # tests/reference/moon_attitude.py 2019-03-04T05:22:47.25, CSPICE N0067
        [-0.71403104983524701, 0.64636967742684637, 0.26900910760472274],
        [-0.69966593424854073, -0.64505137503841636, -0.3072072655605087],
        [-0.025044766385245817, -0.40757203493881006, 0.91282955474313254]])
    moon, _, place, attitude = flyby.at(1000.0)
    near = turn(0, np.radians(0.005)) @ moon_me
    bodies = [body("moon", moon, near), body("sun", flyby.SUN)]
    lander = craft("lander", place, rodrigues_of_matrix(attitude))
    viz.update(message(1, 1000e9, bodies, [lander], [flyby.CAMERA.message()], EPOCH))
    assert viz.image(7), server.log
    _, states = recorded(tmp_path / "record/camera-7.csv")
    expected = moon_me @ (place - moon + attitude.T @ flyby.CAMERA.position)
    np.testing.assert_allclose(states[-1][1:4], expected, rtol=0, atol=1e-3)  # m: 5e-10 of the rotation; coordinates to 3e-5
    viz.close()
    server.end()


def test_the_server_ends_with_the_script(tmp_path):
    server = Server(tmp_path)
    children = subprocess.run(["pgrep", "-P", str(server.process.pid)], capture_output=True, text=True).stdout.split()
    assert children
    server.end()
    for _ in range(100):
        if not any(Path(f"/proc/{child}").exists() for child in children):
            return
        time.sleep(0.1)
    pytest.fail("the server runs on")


@pytest.mark.parametrize("words, message_of_error", [
    ("--basilisk udp://127.0.0.1:5556", "tcp://, an address and a port are needed"),
    ("--moon-attitude spice", "has no meaning without --basilisk"),
    ("--basilisk --listen 127.0.0.1:0", "has no meaning with --basilisk"),
    ("--basilisk --camera nav=none.yaml", "none.yaml"),
    ("--basilisk --frame-options none.json", "none.json"),
])
def test_wrong_options(words, message_of_error):
    run = subprocess.run([MSIS, "serve", *words.split()], capture_output=True, text=True, timeout=60)
    assert run.returncode in (1, 2) and message_of_error in run.stderr and run.stdout == "", run.stderr
    assert len(run.stderr.splitlines()) == 1


def test_an_address_that_is_taken(server):
    run = subprocess.run([MSIS, "serve", "--basilisk", server.address], capture_output=True, text=True, timeout=60)
    assert run.returncode == 3 and run.stderr == (
        f"msis: error: --basilisk {server.address}: can't be listened on: another program listens there. End it, or choose another port.\n")
    foreign = "tcp://192.0.2.1:5556"  # RFC 5737: no computer has it
    run = subprocess.run([MSIS, "serve", "--basilisk", foreign], capture_output=True, text=True, timeout=60)
    assert run.returncode == 3 and run.stderr == (
        f"msis: error: --basilisk {foreign}: can't be listened on: this computer has no such address. Choose one that it has.\n")


def test_a_run_that_ends_in_an_impact_is_drawn_again(tmp_path):
    """What was refused (below the ground, beside its time) is not in the record, so that the record's command draws all that was."""
    server = Server(tmp_path, "--record record")
    viz, flyby = VizInterface(server.address), Flyby()
    images = []
    for frame, seconds in enumerate((1000.0, 1010.0, 1020.0), 1):
        viz.update(flyby.message(frame, seconds, first=frame == 1))
        images.append(viz.image(7))
    moon, moon_from_n, _, attitude = flyby.at(1030.0)
    bodies = [body("Moon_planet_data", moon, moon_from_n), body("sun_planet_data", flyby.SUN)]
    fallen = craft("lander", moon + moon_from_n.T @ [1.6e6, 0.0, 0.0], rodrigues_of_matrix(attitude))
    viz.update(message(4, 1030e9, bodies, [fallen], [flyby.CAMERA.message()]))
    assert viz.image(7) is None
    viz.close()
    server.end()
    assert all(images) and "no image: " in server.log
    record = tmp_path / "record/camera-7.csv"
    assert len(recorded(record)[1]) == len(images)
    assert draw_again(record, tmp_path / "again") == images

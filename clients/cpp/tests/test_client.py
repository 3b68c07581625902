"""The client in C++: against the files of msis, against the loop in Python, and against servers that break, lie and hang."""
import base64
import hashlib
import os
import re
import shutil
import socket
import struct
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest

HERE, ROOT = Path(__file__).resolve().parents[1], Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "clients/python"), str(ROOT / "clients/python/examples")]
MSIS = os.environ.get("MSISF_PROGRAM", str(ROOT / "msis"))
LDEM = str(ROOT / "input/ldem/LDEM_4.LBL")
STATE = [55289.25, 1.9e6, 1e5, -2e5, 0.01, -0.02, 0.03, 0.9992997549098]
CHECKED = ["-fsanitize=undefined", "-fno-sanitize-recover=all", "-D_GLIBCXX_ASSERTIONS"]
MOTION = [10.0, 1600.0, -30.0, 0.001, 0.02, -0.003]


@pytest.fixture(scope="module")
def programs(tmp_path_factory):
    """The programs, warnings as errors; the one of the tests ends at the first thing that the language leaves undefined."""
    if not shutil.which("g++"):
        pytest.skip("missing: g++")
    folder = tmp_path_factory.mktemp("build")
    compilers = [
        subprocess.Popen(
            ["g++", "-std=c++17", "-O1", "-Werror", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wno-sign-conversion", *options, "-I",
             HERE / "include", HERE / f"{program}.cpp", "-o", folder / Path(program).name])
        for program, options in (("examples/closed_loop", []), ("examples/image", []), ("tests/client", CHECKED))]
    assert [compiler.wait(300) for compiler in compilers] == [0, 0, 0]
    return folder


def test_cmake_project(tmp_path):
    """As a user builds it, also as a part of another project."""
    if not shutil.which("cmake"):
        pytest.skip("missing: cmake")
    (tmp_path / "CMakeLists.txt").write_text(
        f"cmake_minimum_required(VERSION 3.16)\nproject(other LANGUAGES CXX)\nadd_subdirectory({HERE} msisf)\n"
        f"add_executable(other {HERE}/examples/image.cpp)\ntarget_link_libraries(other msisf)\n")
    subprocess.run(["cmake", "-S", tmp_path, "-B", tmp_path / "build"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", tmp_path / "build"], check=True, stdout=subprocess.DEVNULL)
    assert subprocess.run([tmp_path / "build/other"], capture_output=True).returncode == 1
    subprocess.run(["cmake", "-S", HERE, "-B", tmp_path / "alone"], check=True, stdout=subprocess.DEVNULL)


@pytest.fixture(scope="module", params=["http", "socket"])
def address(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp("server")
    (folder / "token").write_text("0123456789abcdef\n")
    listen = "127.0.0.1:0" if request.param == "http" else str(folder / "msis.sock")
    server = subprocess.Popen(
        [MSIS, "serve", "--listen", listen, "--ldem", LDEM, "--token-file", folder / "token", "--end-with-input"], text=True,
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    yield server.stdout.readline().strip()
    server.stdin.close()
    server.wait(30)


def call(programs, address, *words, token="0123456789abcdef", seconds="60"):
    return subprocess.run([programs / "client", address, token, seconds, *map(str, words)], capture_output=True, timeout=120)


def files_of_msis(folder, *words):
    subprocess.run(
        [MSIS, "--renderer", "native", "--ldem", LDEM, "--output-dir", folder, "--batch", *words], check=True,
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return folder


def levels_of(png):
    """The grey levels of a PNG of 8 or 16 bits, by a decoder of its own."""
    import zlib
    data, at, content = Path(png).read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IHDR":
            width, height, bits = struct.unpack(">IIB", data[at + 8:at + 17])
        content += data[at + 8:at + 8 + length] if kind == b"IDAT" else b""
        at += 12 + length
    step = bits // 8
    rows = np.frombuffer(zlib.decompress(content), np.uint8).reshape(height, 1 + width * step)
    out = np.zeros((height, width * step), np.uint8)
    for y, row in enumerate(rows):
        above = out[y - 1] if y else np.zeros(width * step, np.uint8)
        for x in range(width * step):
            a, b, c = (int(out[y, x - step]) if x >= step else 0), int(above[x]), (int(above[x - step]) if x >= step else 0)
            p = a + b - c
            paeth = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
            out[y, x] = (int(row[x + 1]) + [0, a, b, (a + b) // 2, paeth][row[0]]) & 255
    return out if bits == 8 else out.reshape(height, width, 2).astype(np.uint16) @ np.array([256, 1], np.uint16)


@pytest.mark.parametrize("bits", [8, 16])
def test_stream_and_image_are_the_files_of_msis(programs, address, tmp_path, bits):
    other = [55289.5, *(1.01 * np.array(STATE[1:4])), *STATE[4:]]
    frame = f'{{"width": 75, "height": 40, "fov": 33.5, "bit-depth": {bits}, "reflectance": "lommel-seeliger"}}'
    run = call(programs, address, "stream", frame, *map(repr, STATE), *map(repr, other))
    assert run.returncode == 0, run.stderr
    assert run.stderr.decode().split() == ["1", "75", "40", str(bits), "2", "75", "40", str(bits)]
    images = np.frombuffer(run.stdout, np.uint8 if bits == 8 else "<u2").reshape(2, 40, 75)
    for image, state in zip(images, (STATE, other)):
        folder = files_of_msis(
            tmp_path / str(state[0]), "--fixed-state", "{" + ",".join(map(repr, state)) + "}", "--width", "75", "--height", "40",
            "--fov", "33.5", "--bit-depth", str(bits), "--reflectance", "lommel-seeliger")
        np.testing.assert_array_equal(image, levels_of(next(folder.glob("*.png"))))
    place = f'{frame[:-1]}, "fixed-state": {STATE}}}'
    assert call(programs, address, "image", place).stdout == images[0].tobytes()


def test_layers_are_the_files_of_msis(programs, address, tmp_path):
    frame = f'{{"width": 31, "height": 22, "fov": 60, "fixed-state": {STATE}}}'
    folder = files_of_msis(
        tmp_path, "--fixed-state", "{" + ",".join(map(repr, STATE)) + "}", "--width", "31", "--height", "22", "--fov", "60",
        "--layers", "depth,position,mask,normal", "--layers-format", "npy")
    for name in ("depth", "position", "mask", "normal"):
        expected = np.load(next(folder.rglob(f"*.{name}.npy")))
        run = call(programs, address, "layer", frame, name)
        assert run.returncode == 0, run.stderr
        width, height, planes = map(int, run.stderr.split())
        values = np.frombuffer(run.stdout).reshape(height, width, planes)
        np.testing.assert_array_equal(values, expected.astype(float).reshape(values.shape))


def test_motion_of_a_shutter(programs, address):
    """An image with motion is another one, and has the numbers of the detector."""
    camera = ('{"width": 24, "height": 18, "focal-length": 50, "pixel-pitch": 0.5, "detector": {"f-number": 4, "band": [500, 650], "quantum-efficiency": 0.4,'
              '"exposure-time": 0.5, "gain": 1000000, "full-well": 40000000000, "adc-bits": 16, "read-noise": 10, "seed": 1, "shutter": "global"}}')
    run = call(programs, address, "motion", f'{{"camera": {camera}}}', *STATE, *MOTION, *STATE, *([0.0] * 6))
    assert run.returncode == 0 and run.stderr.split() == [b"1", b"24", b"18", b"16", b"2", b"24", b"18", b"16"], run.stderr
    moving, resting = np.frombuffer(run.stdout, "<u2").reshape(2, 18, 24)
    assert resting.max() > 1000 and (moving != resting).mean() > 0.3


def test_images_of_a_rig_are_the_files_of_msis(programs, address, tmp_path):
    (tmp_path / "rig.yaml").write_text(
        "cameras:\n  a:\n    fov: 33.5\n    width: 75\n    height: 40\n    quaternion: [0, 0, 0, 1]\n    offset: [0, -2000, 5]\n"
        "  b:\n    fov: 20\n    width: 31\n    height: 17\n    quaternion: [0, 0, 0.28, 0.96]\n")
    cameras = ('[{"fov": 33.5, "width": 75, "height": 40, "offset": [0, -2000, 5]}, '
               '{"fov": 20, "width": 31, "height": 17, "quaternion": [0, 0, 0.28, 0.96]}]')
    run = call(programs, address, "rig", "{}", cameras, *map(repr, STATE))
    assert run.returncode == 0 and run.stderr.split() == [b"31", b"17"], run.stderr
    folder = files_of_msis(
        tmp_path, "--fixed-state", "{" + ",".join(map(repr, STATE)) + "}", "--rig", tmp_path / "rig.yaml", "--output-name", "{camera}")
    assert run.stdout == levels_of(folder / "a.png").tobytes() + levels_of(folder / "b.png").tobytes()


def test_refused_states_leave_the_stream_open(programs, address):
    frame = '{"width": 16, "height": 16}'
    inside = [55289.25, 1e5, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]
    run = call(programs, address, "stream", frame, *STATE, *inside, *STATE, '{"position": [0, 30, 1e5], "time": 55289.5}', '{"position": [0, 30, 1e5], "time": 55289.5, "fov": 400}')
    lines = run.stderr.decode().splitlines()
    assert run.returncode == 0 and len(run.stdout) == 3 * 256
    assert [line.split()[0] for line in lines] == ["1", "refused:", "3", "4", "refused:"]
    assert "inside" in lines[1] and "--fov" in lines[4]


@pytest.mark.parametrize("words, token, expected", [
    (["stream", '{"fov": 400}'], "0123456789abcdef", "error 400: --fov"),
    (["stream", "{"], "0123456789abcdef", "error 400"),
    (["image", '{"width": 0, "position": [0, 30, 1e5], "time": 55289}'], "0123456789abcdef", "error 400: --width"),
    (["layer", "{}", "nothing"], "0123456789abcdef", "error 400: "),
    (["get", "/v1/nothing"], "0123456789abcdef", "error 404"),
    (["stream", "{}"], "wrong", "error 401"),
])
def test_errors_have_the_words_of_the_server(programs, address, words, token, expected):
    run = call(programs, address, *words, token=token)
    assert run.returncode == 2 and run.stderr.decode().startswith(expected), run.stderr
    assert len(run.stderr.splitlines()) == 1


@pytest.mark.parametrize("where, expected", [
    ("http://127.0.0.1:1", "no server at '127.0.0.1:1'"),
    ("/nowhere/msis.sock", "no server at '/nowhere/msis.sock'"),
    ("localhost", "is no http://HOST:PORT"),
    ("https://127.0.0.1:1", "'https://127.0.0.1:1': this client has no TLS. Give the http:// of a proxy"),
    ("https://[::1]:8810/", "this client has no TLS"),
    ("http://no.such.host.invalid:80", "is not found"),
    ("/" + "x" * 200, "too long"),
])
def test_no_server(programs, where, expected):
    run = call(programs, where, "get", "/healthz")
    assert run.returncode == 2 and expected in run.stderr.decode(), run.stderr


def serve_once(answer):
    """A server that gives one connection to a function."""
    listening = socket.create_server(("127.0.0.1", 0))

    def serve():
        connection, _ = listening.accept()
        with connection:
            connection.settimeout(60)
            try:
                answer(connection)
            except OSError:
                pass  # the client is gone
        listening.close()

    threading.Thread(target=serve, daemon=True).start()
    return f"http://127.0.0.1:{listening.getsockname()[1]}"


def head_of(connection):
    head = b""
    while b"\r\n\r\n" not in head:
        head += connection.recv(4096)
    return head


def upgrade(connection):
    head = head_of(connection)
    key = re.search(rb"Sec-WebSocket-Key: (\S+)", head)[1]
    accept = base64.b64encode(hashlib.sha1(key + b"258EAFA5-E914-47DA-95CA-C5AB0DC85B11").digest())
    connection.sendall(b"HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nSec-WebSocket-Accept: " + accept + b"\r\n\r\n")
    return head


def message(kind, content, last=True):
    size = bytes([len(content)]) if len(content) < 126 else b"\x7e" + struct.pack(">H", len(content))
    return bytes([kind | (128 if last else 0)]) + size + content


READY = message(1, b'{"ready": true, "width": 4, "height": 3}')


def image(number=1, width=4, height=3, levels=12, magic=b"MSIF"):
    return magic + struct.pack("<III", number, width, height) + bytes(levels)


def receive(connection):
    """A message of the client, unmasked."""
    def take(count):
        data = b""
        while len(data) < count:
            data += connection.recv(count - len(data))
        return data
    first, second = take(2)
    assert second & 128, "clients mask"
    length = second & 127
    if length == 126:
        length = struct.unpack(">H", take(2))[0]
    mask = take(4)
    return first & 15, bytes(byte ^ mask[k % 4] for k, byte in enumerate(take(length)))


def test_programs_say_their_names(programs):
    """So that the server tells them apart."""
    heads = [], []
    for of_one in heads:
        call(programs, serve_once(lambda connection, heads=of_one: heads.append(upgrade(connection))), "stream", "{}", *STATE)
    names = [re.search(rb"\r\nX-Msisf-Client: (\S+)\r\n", of_one[0])[1] for of_one in heads]
    assert names[0] != names[1]


def test_fragments_and_pings(programs):
    heard, answered = [], threading.Event()

    def answer(connection):
        upgrade(connection)
        heard.append(receive(connection))
        connection.sendall(READY)
        heard.append(receive(connection))
        whole = image(levels=12)
        connection.sendall(message(2, whole[:9], last=False) + message(9, b"hear me") + message(10, b"") + message(0, whole[9:], last=True))
        heard.append(receive(connection))
        answered.set()

    run = call(programs, serve_once(answer), "stream", '{"width": 4}', *STATE)
    assert run.returncode == 0 and run.stdout == bytes(12), run.stderr
    assert answered.wait(30)
    assert b'"frame": {"width": 4}' in heard[0][1] and heard[1] == (2, struct.pack("<8d", *STATE)) and heard[2] == (10, b"hear me")


@pytest.mark.parametrize("sent, expected", [
    (message(2, image(number=2)), "number 2, 1 is due"),
    (message(2, image(width=6, height=2)), "another size than its camera"),
    (message(2, image(levels=11)), "no image of this stream"),
    (message(2, image(magic=b"XXXX")), "no image of this stream"),
    (message(2, b"MSIF"), "no image of this stream"),
    (message(8, struct.pack(">H", 1001) + b"going away"), "closed the stream: going away"),
    (message(8, b""), "closed the stream"),
    (b"\x82\x7f" + struct.pack(">Q", 1 << 60), "too long"),
    (message(2, image())[:20], "closed the connection"),
    (b"", "closed the connection"),
])
def test_broken_streams(programs, sent, expected):
    def answer(connection):
        upgrade(connection)
        receive(connection)
        connection.sendall(READY)
        receive(connection)
        connection.sendall(sent)

    run = call(programs, serve_once(answer), "stream", "{}", *STATE)
    assert run.returncode == 2 and expected in run.stderr.decode(), run.stderr
    assert run.stdout == b""


@pytest.mark.parametrize("sent, expected", [
    (b"HTTP/1.1 101 Switching\r\nSec-WebSocket-Accept: no\r\n\r\n", "not that of a WebSocket"),
    (b"SSH-2.0-OpenSSH\r\n\r\n", "no HTTP/1.1"),
    (b"HTTP/1.1 nonsense\r\n\r\n", "where a number is due"),
    (b"HTTP/1.1 200 OK\r\n\r\n", "where a number is due"),
    (b"HTTP/1.1 500 Bad\r\nTransfer-Encoding: chunked\r\n\r\n4\r\n{\"de\r\n9\r\ntail\": \"x\r\n2\r\n\"}\r\n0\r\n\r\n", "error 500: x"),
    (b"x" * 70000, "no HTTP"),
    (b"HTTP/1.1 400 Bad\r\nContent-Length: 10\r\n\r\n{\"detail\":", "error 400: the server answers 400"),
    (b"HTTP/1.1 400 Bad\r\nContent-Length: 17\r\n\r\n{\"detail\": \"a\\u00", "error 400: a"),
    (b"HTTP/1.1 400 Bad\r\nContent-Length: 18\r\n\r\n{\"detail\": \"\\uXYZW", "where a number is due"),
    (b"HTTP/1.1 400 Bad\r\nContent-Length: 0\r\n\r\n", "error 400: the server answers 400"),
    (b"HTTP/1.1 503 Busy\r\nContent-Length: 100\r\n\r\nshort", "closed the connection"),
    (b"HTTP/1.1 200 OK\r\nContent-Length: 9999999999999999999\r\n\r\nshort", "closed the connection"),
    (b"HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\nffffffffffffffff\r\nshort", "closed the connection"),
])
def test_broken_answers(programs, sent, expected):
    def answer(connection):
        head_of(connection)
        connection.sendall(sent)

    run = call(programs, serve_once(answer), "stream", "{}", *STATE)
    assert run.returncode == 2 and expected in run.stderr.decode(), run.stderr


@pytest.mark.parametrize("seconds", ["1e300", "inf", "120.5"])
def test_long_waits(programs, seconds):
    def answer(connection):
        head_of(connection)
        connection.sendall(b"HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\nok")

    assert call(programs, serve_once(answer), "get", "/healthz", seconds=seconds).stdout == b"ok"


def test_a_server_that_is_silent(programs):
    silent = threading.Event()
    run = call(programs, serve_once(lambda connection: silent.wait(30)), "stream", "{}", seconds="0.5")
    silent.set()
    assert run.returncode == 2 and "no answer of the server" in run.stderr.decode()


def test_closed_loop_is_that_of_python(programs):
    """The same loop in both languages has the same result: the filter ends within a metre of the other."""
    import closed_loop
    import msisf
    frames = 25
    with msisf.Moon(model="LDEM_4") as moon:
        errors = closed_loop.run(moon, frames)
        # The example has no token: it is for a server of one's own.
        run = subprocess.run([programs / "closed_loop", moon.address, str(frames)], capture_output=True, text=True, timeout=120)
    first, last = map(int, re.findall(r"(\d+) m after", run.stdout))
    assert abs(first - errors[0]) < 1.0 and abs(last - errors[-1]) < 1.0, (run.stdout, run.stderr, errors[0], errors[-1])


def test_example_image(programs, tmp_path):
    import msisf
    with msisf.Moon(model="LDEM_4") as moon:
        run = subprocess.run([programs / "image", moon.address, tmp_path / "moon.png"], capture_output=True, text=True, timeout=120)
    assert (tmp_path / "moon.png").read_bytes().startswith(b"\x89PNG")
    folder = files_of_msis(
        tmp_path / "msis", "--position", "0,30,100000", "--time", "2024-01-19T12:00:00Z", "--width", "512", "--height", "512",
        "--layers", "depth", "--layers-format", "npy")
    depth = np.load(next(folder.rglob("*.depth.npy")))[256, 256]
    assert abs(float(re.search(r": ([\d.e+]+) m", run.stdout)[1]) - depth) < 0.5  # m: printed with six digits

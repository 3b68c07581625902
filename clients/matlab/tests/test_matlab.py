"""The class for MATLAB, run in Octave where it is installed, against raw images of the server."""
import os
import re
import shutil
import socket
import subprocess
import sys
import threading
import urllib.request
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "clients/python"), str(ROOT / "clients/python/examples")]
MSIS = os.environ.get("MSISF_PROGRAM", str(ROOT / "msis"))


def has_octave():
    if not shutil.which("octave-cli"):
        return False
    run = subprocess.run(["octave-cli", "--eval", "pkg load instrument-control"], capture_output=True)
    return run.returncode == 0


needs_octave = pytest.mark.skipif(not has_octave(), reason="missing: octave with octave-instrument-control")


def octave(words):
    folders = [word for folder in ("", "tests", "examples") for word in ("--path", ROOT / "clients/matlab" / folder)]
    return subprocess.run(
        ["octave-cli", "-q", *folders, "--eval", f"pkg load instrument-control; {words}"], capture_output=True, text=True, timeout=120)


def die(server, heads):
    """Answers nothing of sense and closes, first as a server of HTTP would, then as one of streams. Notes what it was asked."""
    for answer in (b"hello\r\n\r\n", b"HTTP/1.1 101 Yes\r\n\r\n"):
        connection, _ = server.accept()
        heads.append(connection.recv(4096).decode())
        connection.sendall(answer)
        connection.close()


@needs_octave
def test_stream_in_octave(tmp_path):
    from msisf._http import parts_of
    (tmp_path / "token").write_text("0123456789abcdef\n")
    with subprocess.Popen(
            [MSIS, "serve", "--listen", "127.0.0.1:0", "--ldem", ROOT / "input/ldem/LDEM_4.LBL", "--token-file", tmp_path / "token",
             "--end-with-input"], text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as server:
        address = server.stdout.readline().strip()
        port = address.rsplit(":", 1)[1]
        with socket.create_server(("127.0.0.1", 0)) as dying:
            threading.Thread(target=die, args=(dying, heads := []), daemon=True).start()
            run = octave(f"run_stream('127.0.0.1', {port}, '{tmp_path}', {dying.getsockname()[1]})")
        assert run.returncode == 0, run.stderr
        named = [re.search(r"\r\nX-Msisf-Client: (\S+)\r\n", head)[1] for head in heads]
        assert len(named) == 2 and named[0] == named[1]  # one program
        for name, place in (("first", '"fixed-state": [55289.25, 1.9e6, 1e5, -2e5, 0, 0, 0, 1]'),
                            ("second", '"position": [0, 30, 1e5], "time": 55289.5')):
            request = urllib.request.Request(
                f"{address}/v1/render", f'{{"width": 37, "height": 20, "fov": 33.5, "bit-depth": 16, {place}}}'.encode(),
                {"Content-Type": "application/json", "Accept": "application/octet-stream", "Authorization": "Bearer 0123456789abcdef"})
            with urllib.request.urlopen(request, timeout=60) as answer:
                assert (tmp_path / name).read_bytes() == answer.read()
        request = urllib.request.Request(
            f"{address}/v1/render",
            b'''{"frame": {"width": 37, "height": 20, "bit-depth": 16, "fixed-state": [55289.25, 1.9e6, 1e5, -2e5, 0, 0, 0, 1]},
                 "cameras": [{"fov": 40, "offset": [0, -1000, 0]},
                             {"fov": 12, "width": 24, "height": 31, "bit-depth": 8, "quaternion": [0, 0, 0.1, 0.99498743710662]}]}''',
            {"Content-Type": "application/json", "Accept": "multipart/mixed, application/octet-stream",
             "Authorization": "Bearer 0123456789abcdef"})
        with urllib.request.urlopen(request, timeout=60) as answer:
            parts = parts_of(answer.headers, answer.read())
        for name, part in (("one of several", "camera1.image.raw"), ("other of several", "camera2.image.raw")):
            assert (tmp_path / name).read_bytes() == bytes(parts[part].content)
        server.stdin.close()
    lines = run.stdout.splitlines()
    assert "inside the Moon" in lines[0] and "all finite" in lines[1] and "--fov" in lines[2] and "401" in lines[3]
    assert lines[4] == "uint16 20 37"
    assert "inside the Moon" in lines[5] and lines[6] == "uint16 20 37, uint8 31 24"
    assert "says where the camera is" in lines[7] and "--token-file is needed" in lines[8] and "no HTTP" in lines[9]
    assert "onnection" in lines[10]  # lost: in the words of tcpclient


@needs_octave
def test_closed_loop_is_that_of_python(tmp_path):
    import closed_loop
    import msisf
    frames = 12
    with msisf.Moon(model="LDEM_4") as moon:
        errors = closed_loop.run(moon, frames)
        port = moon.address.rsplit(":", 1)[1]
        run = octave(f"e = closed_loop('127.0.0.1', {port}, {frames}); fprintf('%.17g\\n', e)")
    assert run.returncode == 0, run.stderr
    first, *others = run.stdout.splitlines()
    assert first == f"error of the position: {errors[0]:.0f} m after the first frame, {errors[-1]:.0f} m after the last"
    np.testing.assert_allclose([float(line) for line in others], errors, rtol=0, atol=1e-3)  # m; another order of sums: 5e-8 after 40

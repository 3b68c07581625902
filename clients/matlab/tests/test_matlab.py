"""The class for MATLAB, run in Octave where it is installed, against raw images of the server."""
import os
import shutil
import subprocess
import urllib.request
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
MSIS = os.environ.get("MSISF_PROGRAM", str(ROOT / "msis"))


def has_octave():
    if not shutil.which("octave-cli"):
        return False
    run = subprocess.run(["octave-cli", "--eval", "pkg load instrument-control"], capture_output=True)
    return run.returncode == 0


@pytest.mark.skipif(not has_octave(), reason="missing: octave with octave-instrument-control")
def test_stream_in_octave(tmp_path):
    (tmp_path / "token").write_text("0123456789abcdef\n")
    with subprocess.Popen(
            [MSIS, "serve", "--listen", "127.0.0.1:0", "--ldem", ROOT / "input/ldem/LDEM_4.LBL", "--token-file", tmp_path / "token",
             "--end-with-input"], text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as server:
        address = server.stdout.readline().strip()
        port = address.rsplit(":", 1)[1]
        run = subprocess.run(
            ["octave-cli", "-q", "--path", ROOT / "clients/matlab", "--path", ROOT / "clients/matlab/tests", "--eval",
             f"run_stream('127.0.0.1', {port}, '{tmp_path}')"], capture_output=True, text=True, timeout=120)
        assert run.returncode == 0, run.stderr
        for name, place in (("first", '"fixed-state": [55289.25, 1.9e6, 1e5, -2e5, 0, 0, 0, 1]'),
                            ("second", '"position": [0, 30, 1e5], "time": 55289.5')):
            request = urllib.request.Request(
                f"{address}/v1/render", f'{{"width": 37, "height": 20, "fov": 33.5, "bit-depth": 16, {place}}}'.encode(),
                {"Content-Type": "application/json", "Accept": "application/octet-stream", "Authorization": "Bearer 0123456789abcdef"})
            with urllib.request.urlopen(request, timeout=60) as answer:
                assert (tmp_path / name).read_bytes() == answer.read()
        server.stdin.close()
    lines = run.stdout.splitlines()
    assert "inside the Moon" in lines[0] and "all finite" in lines[1] and "--fov" in lines[2] and "401" in lines[3]
    assert lines[4] == "uint16 20 37"

"""A server that the client started ends with it, however that ends."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import msisf
import pytest

CLIENT = Path(msisf.__file__).resolve().parents[1]

#: s: at most 2 on an idle machine; the server would wait for minutes for a frame in work.
LIMIT = 30.0

START = """
import os, sys, threading, time
import msisf
moon = msisf.Moon(model="LDEM_4")
def draw():
    moon.render((1.9e6, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0), 55289.0, camera=msisf.Camera(2048, 2048, 40.0), samples=64)
threading.Thread(target=draw, daemon=True).start()
while moon.metrics()["msisf_running"] < 1.0:
    time.sleep(0.01)
print(moon.address, moon._process._process.pid, flush=True)
"""

#: How a program ends, and the signal that ends it.
ENDS = {
    "its end without close": ("", None),
    "an exception": ("raise SystemExit('wrong')", None),
    "SIGTERM": ("time.sleep(600)", signal.SIGTERM),
    "SIGKILL": ("time.sleep(600)", signal.SIGKILL),
    "SIGKILL, a forked worker keeps the pipe open": ("os.fork() or (time.sleep(20), os._exit(0))\ntime.sleep(600)", signal.SIGKILL),
}
SHORT = ("an exception", "SIGKILL, a forked worker keeps the pipe open")


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs Unix")
def test_server_ends_however_its_client_ends():
    ways = ENDS if os.environ.get("MSISF_LONG_TESTS") == "1" else SHORT
    environment = {**os.environ, "PYTHONPATH": str(CLIENT)}
    clients = {
        way: subprocess.Popen(
            [sys.executable, "-c", START + ENDS[way][0]], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, env=environment
        )
        for way in ways
    }
    for way, client in clients.items():
        address, server = client.stdout.readline().split()
        if ENDS[way][1] is not None:
            client.send_signal(ENDS[way][1])
        client.wait(LIMIT)
        start = time.monotonic()
        while _group(int(server)):
            assert time.monotonic() - start < LIMIT, f"{way}: the server goes on"
            time.sleep(0.01)
        print(f"{way}: {time.monotonic() - start:.2f} s")
        with pytest.raises(msisf.ServerError):
            msisf.Moon(address).models()
        client.stdout.close()


def test_close_does_not_wait_for_streams_and_ctrl_c_does_not_reach_the_server():
    moon = msisf.Moon(model="LDEM_4")
    stream = moon.stream(camera=msisf.Camera(64, 48, 40.0))
    server = moon._process._process
    assert os.getpgid(server.pid) != os.getpgid(0)
    moon.close()
    assert server.returncode != -signal.SIGKILL
    assert not _group(server.pid)
    stream.close()


def _group(leader):
    """Processes of the server that still run: msis, and the program that it starts."""
    found = subprocess.run(["ps", "-o", "stat=", "-g", str(leader)], stdout=subprocess.PIPE, text=True).stdout
    return [state for state in found.split() if not state.startswith("Z")]

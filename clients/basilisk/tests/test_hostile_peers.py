"""Peers of msis in Vizard's place that are no simulations."""
import random
import socket

import numpy as np
import pytest

zmq = pytest.importorskip("zmq")

from test_basilisk import Flyby, server  # noqa: E402, F401
from vizinterface import Camera, VizInterface  # noqa: E402


def test_hostile_peers_leave_a_simulation_its_images(server):
    """Garbage on the port, peers that hang, a flood of one that does not wait, and names of cameras that are none."""
    viz, flyby, chance = VizInterface(server.address), Flyby(), random.Random(7)
    good = flyby.message(1, 1000.0, first=True)
    viz.update(good)
    expected = viz.image(7)
    host, port = server.address[len("tcp://"):].split(":")
    hung = [socket.create_connection((host, int(port))) for _ in range(40)]
    for number, connection in enumerate(hung):
        connection.sendall([b"GET / HTTP/1.1\r\n\r\n", chance.randbytes(200), b"\xff" + bytes(8) + b"\x7f\x03" + bytes(5), b""][number % 4])
    flood = zmq.Context.instance().socket(zmq.DEALER)
    flood.setsockopt(zmq.LINGER, 0)
    flood.setsockopt(zmq.RCVTIMEO, 60_000)
    flood.connect(server.address)
    for number in range(200):
        cameras = [Camera(7, 30.0 + number % 5, 120, 90, [0, 0, 0], np.eye(3))]
        flood.send_multipart([b"", b"SIM_UPDATE", b"", b"", flyby.message(1, 1000.0 + number % 7, cameras, first=True)])
        flood.send_multipart([b"", b"REQUEST_IMAGE_7"])
    assert viz.image(7) == expected
    assert all(flood.recv_multipart()[1] for _ in range(400))
    for name in (b"7x", b"-1", b"99999999999999999999"):
        assert viz.ask(b"REQUEST_IMAGE_" + name)[1] == b"" and f"camera '{name.decode()}' is asked for" in server.log
    assert viz.image() == viz.image(7) == expected
    assert "   at " not in server.log
    for one in [viz, flood, *hung]:
        one.close()

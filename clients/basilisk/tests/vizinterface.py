"""Plays Basilisk's vizInterface against a server: its messages, its order of calls, and what they mean, in numpy.

Shares nothing with msis.
"""
import struct

import numpy as np
import zmq

# [uC], Unity's camera axes from the camera's own (x right, y down, z along the line of sight): x_u = -z_c, y_u = x_c, z_u = -y_c.
UNITY_FROM_CAMERA = np.array([[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0]])


def varint(value):
    value &= (1 << 64) - 1
    text = b""
    while value > 0x7F:
        text += bytes([value & 0x7F | 0x80])
        value >>= 7
    return text + bytes([value])


def whole(field, value):
    return varint(field << 3) + varint(value) if value else b""


def real(field, value):
    return varint(field << 3 | 1) + struct.pack("<d", value) if value else b""


def nested(field, content):
    return varint(field << 3 | 2) + varint(len(content)) + content


def text(field, value):
    return nested(field, value.encode()) if value else b""


def reals(field, values):
    return nested(field, b"".join(struct.pack("<d", value) for value in values))


def wholes(field, values):
    return nested(field, b"".join(varint(value) for value in values))


def matrix_of_rodrigues(s):
    """[BN] of the modified Rodrigues parameters of B relative to N."""
    s = np.asarray(s, float)
    cross = np.array([[0, -s[2], s[1]], [s[2], 0, -s[0]], [-s[1], s[0], 0]])
    square = s @ s
    return np.eye(3) + (8 * cross @ cross - 4 * (1 - square) * cross) / (1 + square) ** 2


def rodrigues_of_matrix(m):
    """The parameters of a rotation matrix, the shorter way round."""
    w = np.sqrt(max(0.0, 1 + np.trace(m))) / 2
    if w > 1e-3:
        v = np.array([m[1, 2] - m[2, 1], m[2, 0] - m[0, 2], m[0, 1] - m[1, 0]]) / (4 * w)
    else:
        i = int(np.argmax(np.diag(m)))
        j, k = (i + 1) % 3, (i + 2) % 3
        v = np.zeros(3)
        v[i] = np.sqrt(1 + m[i, i] - m[j, j] - m[k, k]) / 2
        v[j], v[k] = (m[i, j] + m[j, i]) / (4 * v[i]), (m[i, k] + m[k, i]) / (4 * v[i])
        w = (m[j, k] - m[k, j]) / (4 * v[i])
    return v / (1 + w) if w >= 0 else -v / (1 - w)


class Camera:
    """A camera as the user of Basilisk sets it."""

    def __init__(self, number, field_of_view, width, height, position, camera_from_craft, parent="lander"):
        self.number, self.field_of_view, self.width, self.height = number, field_of_view, width, height
        self.position, self.camera_from_craft, self.parent = np.asarray(position, float), np.asarray(camera_from_craft, float), parent

    def message(self):
        direction = rodrigues_of_matrix(UNITY_FROM_CAMERA @ self.camera_from_craft)
        return (whole(1, self.number) + text(2, self.parent) + real(3, self.field_of_view) + wholes(4, [self.width, self.height])
                + whole(5, 1) + reals(7, self.position) + reals(8, direction) + whole(9, 10**10) + text(10, "black"))


def body(name, position, rotation=np.eye(3)):
    return (text(1, name) + reals(2, position) + reals(3, [1.0, 2.0, 3.0]) + reals(4, np.asarray(rotation).ravel())
            + real(5, 4902.8) + real(6, 1737.4) + real(7, 1.0))


def craft(name, position, rodrigues):
    return text(1, name) + reals(2, position) + reals(3, [0.0, 1.0, 0.0]) + reals(4, rodrigues) + text(13, "bskSat")


def message(frame, nanoseconds, bodies, spacecraft, cameras, epoch=None):
    parts = [nested(1, whole(1, frame) + real(2, nanoseconds))]
    parts += [nested(2, part) for part in bodies] + [nested(3, part) for part in spacecraft] + [nested(4, part) for part in cameras]
    parts.append(nested(7, real(1, 0.5) + text(11, "black")))  # settings of the display
    if epoch:
        parts.append(nested(8, b"".join(whole(index + 1, part) for index, part in enumerate(epoch[:5])) + real(6, epoch[5])))
    return b"".join(parts)


class VizInterface:
    """The REQ socket of a simulation; an answer that takes longer than a minute is a failure."""

    def __init__(self, address):
        self.socket = zmq.Context.instance().socket(zmq.REQ)
        self.socket.setsockopt(zmq.RCVTIMEO, 60_000)
        self.socket.setsockopt(zmq.LINGER, 0)
        self.socket.connect(address)

    def ask(self, *frames):
        self.socket.send_multipart(list(frames))
        return self.socket.recv_multipart()

    def ping(self):
        assert self.ask(b"PING") == [b"PONG"]

    def update(self, content):
        assert self.ask(b"SIM_UPDATE", b"", b"", content) == [b"OK"]

    def image(self, number=None):
        """The image of a camera; None if the answer is the invalid image."""
        answer = self.ask(b"REQUEST_IMAGE" if number is None else b"REQUEST_IMAGE_%d" % number)
        assert len(answer) == 2 and len(answer[0]) == 4
        assert struct.unpack(">i", answer[0])[0] == len(answer[1])
        return answer[1] or None

    def close(self):
        self.socket.close()

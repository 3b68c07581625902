"""A WebSocket (RFC 6455), no more of it than a stream of images needs."""

from __future__ import annotations

import base64
import hashlib
import http.client
import os
import socket
import struct
from typing import Mapping, Tuple

import numpy as np

from ._errors import ServerError
from ._http import problem_of

TEXT, BINARY = 1, 2
_CLOSE, _PING, _PONG = 8, 9, 10
_GUID = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11"


class WebSocket:
    """Messages over a connection."""

    def __init__(self, connection: http.client.HTTPConnection, path: str, headers: Mapping[str, str]) -> None:
        connection.connect()
        self._socket = _upgrade(connection, path, headers)

    def close(self) -> None:
        """Says that nothing more comes, if the server can still hear it; the connection is closed by its owner."""
        try:
            self.send(_CLOSE, struct.pack(">H", 1000))
        except OSError:
            pass  # the server is gone already

    def send(self, kind: int, content: bytes) -> None:
        """Sends a message."""
        mask = os.urandom(4)
        length = len(content)
        if length < 126:
            head = struct.pack("!BB", 0x80 | kind, 0x80 | length)
        elif length < 65536:
            head = struct.pack("!BBH", 0x80 | kind, 0x80 | 126, length)
        else:
            head = struct.pack("!BBQ", 0x80 | kind, 0x80 | 127, length)
        key = np.resize(np.frombuffer(mask, np.uint8), length)
        masked = np.bitwise_xor(np.frombuffer(content, np.uint8), key).tobytes()
        self._socket.sendall(head + mask + masked)

    def receive(self, longest: int) -> Tuple[int, bytearray]:
        """The next message, of so many bytes at most, put together from its fragments."""
        message = bytearray()
        kind = 0
        while True:
            first, second = self._read(2)
            length = second & 0x7F
            if length == 126:
                (length,) = struct.unpack("!H", self._read(2))
            elif length == 127:
                (length,) = struct.unpack("!Q", self._read(8))
            if len(message) + length > longest:
                raise ValueError(f"a message of {len(message) + length} bytes; the longest has {longest}")
            content = self._read(length)
            code = first & 0x0F
            if code == _PING:
                self.send(_PONG, bytes(content))
            elif code == _CLOSE:
                reason = bytes(content[2:]).decode(errors="replace")
                raise ServerError(f"the server closed the stream: {reason}")
            elif code != _PONG:
                kind = code or kind
                message = message + content if message else content  # one fragment is not copied
                if first & 0x80:
                    return kind, message

    def _read(self, length: int) -> bytearray:
        buffer = bytearray(length)
        view = memoryview(buffer)
        taken = 0
        while taken < length:
            count = self._socket.recv_into(view[taken:])
            if count == 0:
                raise ServerError("the server closed the stream")
            taken += count
        return buffer


def _upgrade(connection: http.client.HTTPConnection, path: str, headers: Mapping[str, str]) -> socket.socket:
    """Turns a connection into a WebSocket."""
    key = base64.b64encode(os.urandom(16)).decode()
    own = {"Upgrade": "websocket", "Connection": "Upgrade", "Sec-WebSocket-Key": key, "Sec-WebSocket-Version": "13"}
    connection.request("GET", path, headers={**headers, **own})
    plain = connection.sock
    answer = http.client.HTTPResponse(plain)
    answer.begin()
    if answer.status != 101:
        raise problem_of(answer.status, answer.read())
    expected = base64.b64encode(hashlib.sha1((key + _GUID).encode()).digest()).decode()
    if answer.headers["Sec-WebSocket-Accept"] != expected:
        raise ServerError("the server's answer is not that of a WebSocket")
    return plain

"""A WebSocket to the server (RFC 6455), no more of it than a stream of images needs."""

from __future__ import annotations

import base64
import hashlib
import http.client
import json
import os
import socket
import struct
from types import TracebackType
from typing import TYPE_CHECKING, Any, Dict, Iterator, Mapping, NamedTuple, Optional, Tuple, Type

import numpy as np

from ._errors import RequestError, ServerError
from ._http import Http, problem_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

_TEXT, _BINARY, _CLOSE, _PING, _PONG = 1, 2, 8, 9, 10
_GUID = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11"


class StreamImage(NamedTuple):
    """An image of a stream.

    Attributes:
        number: Of the frame, from 1 in the order of the states.
        image: Grey levels [height, width].
    """

    number: int
    image: "NDArray[Any]"


class Stream:
    """Draws one image for each state with a camera that stays the same. Not for several threads.

    Attributes:
        last_times: With ``timing``, ms that the server took for the last image: "wait", "draw" and "write".
    """

    def __init__(self, server: Http, frame: Mapping[str, Any], newest_only: bool, timing: bool = False) -> None:
        connection = server.connection()
        try:
            connection.connect()
            self._socket = _upgrade(connection, server.headers())
        except (OSError, http.client.HTTPException) as error:
            raise ServerError(f"{server.address}: no stream of the server: {error}") from error
        self._connection = connection
        self.last_times: Dict[str, float] = {}
        first = {"frame": frame, "mode": "newest-only" if newest_only else "lock-step", "format": "u8", "timing": timing}
        self._send(_TEXT, json.dumps(first, allow_nan=False).encode())
        kind, content = self._receive()
        answer = json.loads(content) if kind == _TEXT else {}
        if not answer.get("ready"):
            self.close()
            raise RequestError(answer.get("error", "the server closed the stream"), 400)

    def render(self, position: "ArrayLike", orientation_xyz0: "ArrayLike", mjd: float) -> "NDArray[Any]":
        """Sends a state and waits for its image.

        Args:
            position: m, MOON_ME.
            orientation_xyz0: Unit quaternion (qx, qy, qz, q0) that turns camera axes (looks along -x, y right, z up) into MOON_ME.
            mjd: Time, days, UTC.
        """
        self.send(position, orientation_xyz0, mjd)
        return self.receive().image

    def send(self, position: "ArrayLike", orientation_xyz0: "ArrayLike", mjd: float) -> None:
        """Sends a state; ``receive`` gives its image."""
        state = np.concatenate(([mjd], np.asarray(position, dtype=float).ravel(), np.asarray(orientation_xyz0, dtype=float).ravel()))
        self._send(_BINARY, state.astype("<f8").tobytes())

    def receive(self) -> StreamImage:
        """The next image.

        Raises:
            RequestError: The server refuses the state; the stream goes on.
            ServerError: The server closed the stream.
        """
        kind, content = self._receive()
        while kind == _TEXT:
            answer = json.loads(content)
            if "error" in answer:
                raise RequestError(answer["error"], 400)
            self.last_times = {name: answer[name] for name in ("wait", "draw", "write")}
            kind, content = self._receive()
        number, width, height = struct.unpack_from("<III", content, 4)
        levels = "<u2" if len(content) - 16 == 2 * width * height else "u1"
        return StreamImage(number, np.frombuffer(content, levels, offset=16).reshape(height, width))

    def __iter__(self) -> Iterator[StreamImage]:
        while True:
            yield self.receive()

    def close(self) -> None:
        """Closes the stream."""
        try:
            self._send(_CLOSE, struct.pack(">H", 1000))
        except (OSError, ServerError):
            pass  # the server is gone already
        self._socket.close()
        self._connection.close()

    def __enter__(self) -> "Stream":
        return self

    def __exit__(
        self, kind: Optional[Type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]
    ) -> None:
        self.close()

    def _send(self, kind: int, content: bytes) -> None:
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
        try:
            self._socket.sendall(head + mask + masked)
        except OSError as error:
            raise ServerError(f"the stream is closed: {error}") from error

    def _receive(self) -> Tuple[int, bytearray]:
        """The next message, put together from its fragments."""
        message = bytearray()
        kind = 0
        while True:
            first, second = self._read(2)
            length = second & 0x7F
            if length == 126:
                (length,) = struct.unpack("!H", self._read(2))
            elif length == 127:
                (length,) = struct.unpack("!Q", self._read(8))
            content = self._read(length)
            code = first & 0x0F
            if code == _PING:
                self._send(_PONG, bytes(content))
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
            try:
                count = self._socket.recv_into(view[taken:])
            except OSError as error:
                raise ServerError(f"the stream is closed: {error}") from error
            if count == 0:
                raise ServerError("the server closed the stream")
            taken += count
        return buffer


def _upgrade(connection: http.client.HTTPConnection, headers: Mapping[str, str]) -> socket.socket:
    """Turns a connection into a WebSocket."""
    key = base64.b64encode(os.urandom(16)).decode()
    own = {"Upgrade": "websocket", "Connection": "Upgrade", "Sec-WebSocket-Key": key, "Sec-WebSocket-Version": "13"}
    connection.request("GET", "/v1/stream", headers={**headers, **own})
    plain = connection.sock
    answer = http.client.HTTPResponse(plain)
    answer.begin()
    if answer.status != 101:
        raise problem_of(answer.status, answer.read())
    expected = base64.b64encode(hashlib.sha1((key + _GUID).encode()).digest()).decode()
    if answer.headers["Sec-WebSocket-Accept"] != expected:
        raise ServerError("the server's answer is not that of a WebSocket")
    return plain

"""A stream: states go in, images come out."""

from __future__ import annotations

import http.client
import json
import os
import struct
from contextlib import contextmanager
from types import TracebackType
from typing import Any, Dict, Iterator, List, Mapping, NamedTuple, Optional, Sequence, Type

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import MsisfError, RequestError, ServerError
from ._http import Http
from ._values import json_of, numbers
from ._websocket import BINARY, TEXT, WebSocket


_HEAD = struct.Struct("<4sIII")  # of an image: "MSIF", number, width, height
_LONGEST_TEXT = 1 << 20  # bytes


class StreamImage(NamedTuple):
    """An image of a stream.

    Attributes:
        number: Of the state, from 1 in the order in which they were sent.
        image: Grey levels [height, width].
        camera: Which one of the stream's cameras, from 0.
    """

    number: int
    image: NDArray[Any]
    camera: int = 0


class Stream:
    """Draws one image for each state and each camera, which stay the same. Not for several threads.

    A timeout, Ctrl-C or a broken answer closes the stream, so that no image is taken for that of a later state; open another one then.

    Attributes:
        last_times: With ``timing``, ms that the server took for the last image: "wait", "draw" and "write".
    """

    def __init__(
        self, server: Http, frame: Mapping[str, Any], newest_only: bool, timing: bool = False,
        cameras: Optional[Sequence[Mapping[str, Any]]] = None,
    ) -> None:
        self._server = server
        self._newest_only = bool(newest_only)
        self._connection: Optional[http.client.HTTPConnection] = None
        self._owner = os.getpid()
        self._end: Optional[str] = None
        self._sent = self._answered = self._number = self._camera = 0
        self._sizes = [(0, 0)]
        self.last_times: Dict[str, float] = {}
        try:
            with self._exchange():
                self._open(server, frame, timing, cameras)
        except BaseException:
            self._close("it did not open")
            raise

    def render(
        self, position: ArrayLike, orientation_xyz0: ArrayLike, mjd: float, motion: Optional[ArrayLike] = None
    ) -> NDArray[Any]:
        """Sends a state and waits for its image.

        Args:
            position: m, MOON_ME.
            orientation_xyz0: Unit quaternion (qx, qy, qz, q0) that turns camera axes (looks along -x, y right, z up) into MOON_ME.
            mjd: Time, days, UTC.
            motion: m/s over the Moon and rad/s about the camera's axes, six numbers; only for a camera with a shutter, or one that scans.
        """
        if len(self._sizes) > 1:
            raise MsisfError(f"the stream has {len(self._sizes)} cameras; render_all() has the images of all")
        return self.render_all(position, orientation_xyz0, mjd, motion)[0]

    def render_all(
        self, position: ArrayLike, orientation_xyz0: ArrayLike, mjd: float, motion: Optional[ArrayLike] = None
    ) -> List[NDArray[Any]]:
        """As ``render``: the images of all cameras, in the order in which ``Moon.stream`` got them."""
        state = _state(position, orientation_xyz0, mjd, motion)
        if self._sent != self._answered and self._end is None:
            raise MsisfError(f"{self._sent - self._answered} images of send() are not received yet; receive() them before render()")
        with self._exchange():
            self._send_state(state)
            return [self._next().image for _ in self._sizes]

    def send(
        self, position: ArrayLike, orientation_xyz0: ArrayLike, mjd: float, motion: Optional[ArrayLike] = None
    ) -> None:
        """Sends a state; ``receive`` gives its image, of several cameras one after another."""
        state = _state(position, orientation_xyz0, mjd, motion)
        with self._exchange():
            self._send_state(state)

    def receive(self) -> StreamImage:
        """The next image.

        Raises:
            RequestError: The server refuses the state; the stream goes on.
            ServerError: The stream is closed.
        """
        if self._sent == self._answered and self._end is None:
            raise MsisfError("there is nothing to receive: all states that were sent are answered")
        with self._exchange():
            return self._next()

    def __iter__(self) -> Iterator[StreamImage]:
        while self._sent != self._answered:
            yield self.receive()

    def close(self) -> None:
        """Closes the stream."""
        if self._end is None and self._owner == os.getpid():
            self._socket.close()
        self._close("close() was called")

    def __enter__(self) -> Stream:
        return self

    def __exit__(
        self, kind: Optional[Type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]
    ) -> None:
        self.close()

    def _open(
        self, server: Http, frame: Mapping[str, Any], timing: bool, cameras: Optional[Sequence[Mapping[str, Any]]]
    ) -> None:
        self._connection = server.connection()
        self._socket = WebSocket(self._connection, "/v1/stream", server.headers())
        mode = "newest-only" if self._newest_only else "lock-step"
        opening = {"frame": frame, "mode": mode, "format": "u8", "timing": bool(timing)}
        self._socket.send(TEXT, json_of(opening if cameras is None else {**opening, "cameras": list(cameras)}))
        answer = json.loads(self._socket.receive(_LONGEST_TEXT)[1])
        if "error" in answer:
            raise RequestError(str(answer["error"]), 400)
        self._sizes = [(int(size["width"]), int(size["height"])) for size in (answer["cameras"] if cameras else [answer])]
        if len(self._sizes) != len(cameras or "1"):
            raise ValueError(f"{len(self._sizes)} cameras are ready of {len(cameras or '1')}")

    @contextmanager
    def _exchange(self) -> Iterator[None]:
        """Closes the stream if something does not end as it should: a late answer would be taken for that of the next state."""
        if self._end is None and self._owner != os.getpid():
            self._close("it belongs to the process that this one was forked from")
        if self._end is not None:
            raise ServerError(f"the stream is closed: {self._end}. Open another one with Moon.stream()")
        try:
            with self._server.answers():
                yield
        except RequestError:
            raise
        except BaseException as error:
            self._close(str(error) or type(error).__name__)
            raise

    def _close(self, reason: str) -> None:
        self._end = self._end or reason
        if self._connection is not None:
            self._connection.close()

    def _send_state(self, state: List[float]) -> None:
        self._sent += 1
        self._socket.send(BINARY, struct.pack(f"<{len(state)}d", *state))

    def _next(self) -> StreamImage:
        camera, size = self._camera, self._sizes[self._camera]
        longest = max(_LONGEST_TEXT, _HEAD.size + 2 * size[0] * size[1])
        kind, content = self._socket.receive(longest)
        while kind == TEXT:
            answer = json.loads(content)
            if "error" in answer:
                self._count(answer["number"], camera)
                self._answered, self._camera = self._number, 0
                raise RequestError(str(answer["error"]), 400)
            self.last_times = {name: float(answer[name]) for name in ("wait", "draw", "write")}
            kind, content = self._socket.receive(longest)
        magic, number, width, height = _HEAD.unpack_from(content)
        pixels = width * height
        if magic != b"MSIF" or (width, height) != size or len(content) - _HEAD.size not in (pixels, 2 * pixels):
            raise ValueError(f"{len(content)} bytes are no image of {size[0]} x {size[1]} px")
        self._count(number, camera)
        self._camera = (camera + 1) % len(self._sizes)
        if self._camera == 0:
            self._answered = number
        levels = "<u2" if len(content) - _HEAD.size == 2 * pixels else "u1"
        return StreamImage(number, np.frombuffer(content, levels, offset=_HEAD.size).reshape(height, width), camera)

    def _count(self, number: int, camera: int) -> None:
        due = self._number if camera else self._sent if self._newest_only else self._answered + 1
        if not max(self._answered + 1, due if camera else 0) <= number <= due <= self._sent:
            raise ValueError(f"the answer has number {number}, and {due} is due")
        self._number = number


def _state(
    position: ArrayLike, orientation_xyz0: ArrayLike, mjd: ArrayLike, motion: Optional[ArrayLike]
) -> List[float]:
    state = [*numbers(mjd, "mjd", 1), *numbers(position, "position", 3), *numbers(orientation_xyz0, "orientation_xyz0", 4)]
    return state if motion is None else [*state, *numbers(motion, "motion", 6)]

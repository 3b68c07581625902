"""HTTP to the server: one connection per thread, kept open."""

from __future__ import annotations

import http.client
import json
import os
import selectors
import socket
import ssl
import threading
import uuid
from contextlib import contextmanager
from email.message import Message
from typing import Any, Callable, Dict, Iterator, List, Mapping, NamedTuple, Optional, Tuple
from urllib.parse import urlsplit

from ._errors import RequestError, ServerError, answers_of
from ._values import json_of


class Part(NamedTuple):
    """A part of an answer with several; its headers by their names in small letters."""

    headers: Dict[str, str]
    content: memoryview


class UnixConnection(http.client.HTTPConnection):
    """A connection by a Unix socket."""

    def __init__(self, path: str, timeout: float) -> None:
        super().__init__("localhost", timeout=timeout)
        self._path = path

    def connect(self) -> None:
        self.sock = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        self.sock.settimeout(self.timeout)
        self.sock.connect(self._path)


class Http:
    """Sends requests to a server.

    Args:
        fate: Says how the server ended; None while it runs, and for a server that somebody else started.
    """

    def __init__(
        self,
        address: str,
        token: Optional[str],
        timeout: float,
        context: Optional[ssl.SSLContext],
        fate: Callable[[], Optional[str]] = lambda: None,
    ) -> None:
        self.address = address
        self.timeout = timeout
        self._token = token
        self._context = context
        self._fate = fate
        self._name = uuid.uuid4().hex
        self._is_closed = False
        self._local = threading.local()
        self._open: List[http.client.HTTPConnection] = []
        self._gate = threading.Lock()

    def headers(self) -> Dict[str, str]:
        """The headers of every request; the server shares itself evenly among the clients by their names."""
        named = {"X-Msisf-Client": self._name}
        return {**named, "Authorization": f"Bearer {self._token}"} if self._token else named

    @contextmanager
    def answers(self) -> Iterator[None]:
        """As ``answers_of``; where there is no answer because the Moon was closed or the server ended, the error says that."""
        if self._is_closed:
            raise self._closed()
        try:
            with answers_of(self.address):
                yield
        except RequestError:
            raise
        except ServerError as error:
            if self._is_closed:
                raise self._closed() from error
            ended = self._fate()
            if ended is not None:
                raise ServerError(f"{ended}. Make another msisf.Moon() to go on") from error
            raise

    def connection(self) -> http.client.HTTPConnection:
        """A new connection."""
        url = urlsplit(self.address)
        if url.scheme == "http":
            return http.client.HTTPConnection(url.hostname or "localhost", url.port, timeout=self.timeout)
        if url.scheme == "https":
            return http.client.HTTPSConnection(url.hostname or "localhost", url.port, timeout=self.timeout, context=self._context)
        return UnixConnection(self.address, self.timeout)

    def get(self, path: str) -> Any:
        """Asks for JSON."""
        with self.answers():
            return json.loads(self._send("GET", path, None, "application/json")[1])

    def get_text(self, path: str) -> str:
        """Asks for a text. To be called in ``answers``."""
        return self._send("GET", path, None, "text/plain")[1].decode()

    def post(self, path: str, body: Mapping[str, Any], accept: str) -> Tuple[http.client.HTTPMessage, bytes]:
        """Sends JSON; the answer's headers and content. To be called in ``answers``."""
        return self._send("POST", path, json_of(body), accept)

    def close(self) -> None:
        """Closes the connections of all threads; there are no others after them."""
        self._is_closed = True
        with self._gate:
            for connection in self._open:
                connection.close()
            self._open.clear()
        self._local = threading.local()

    def _closed(self) -> ServerError:
        return ServerError(f"{self.address}: the Moon is closed: close() was called, or its with block ended. Make another msisf.Moon() to go on")

    def _send(self, method: str, path: str, body: Optional[bytes], accept: str) -> Tuple[http.client.HTTPMessage, bytes]:
        headers = {**self.headers(), "Accept": accept}
        if body is not None:
            headers["Content-Type"] = "application/json"
        kept = self._kept()
        if kept is not None:
            try:
                return _exchange(kept, method, path, body, headers)
            except (ConnectionError, http.client.BadStatusLine):
                pass  # the server closes connections that were idle for long
        return _exchange(self._new(), method, path, body, headers)

    def _kept(self) -> Optional[http.client.HTTPConnection]:
        """This thread's connection, if it can be used again. That of the process that this one was forked from is not ours."""
        owner, kept = getattr(self._local, "kept", (0, None))
        if kept is None or kept.sock is None or owner != os.getpid():
            return None
        with selectors.DefaultSelector() as selector:
            selector.register(kept.sock, selectors.EVENT_READ)
            if not selector.select(0):
                return kept  # type: ignore[no-any-return]
        kept.close()  # its end, or what nobody asked for: not the answer to the next request
        return None

    def _new(self) -> http.client.HTTPConnection:
        connection = self.connection()
        with self._gate:
            self._open = [other for other in self._open if other.sock is not None] + [connection]
        self._local.kept = (os.getpid(), connection)
        return connection


def _exchange(
    connection: http.client.HTTPConnection, method: str, path: str, body: Optional[bytes], headers: Dict[str, str]
) -> Tuple[http.client.HTTPMessage, bytes]:
    try:
        connection.request(method, path, body, headers)
        answer = connection.getresponse()
        content = answer.read()
    except BaseException:  # a timeout or Ctrl-C too: what comes later would be taken for the answer to another request
        connection.close()
        raise
    if answer.status != 200:
        raise problem_of(answer.status, content)
    return answer.headers, content


def problem_of(status: int, content: bytes) -> RequestError:
    """The exception for an answer that tells a problem (RFC 9457)."""
    try:
        problem = json.loads(content)
        return RequestError(problem["detail"], status, problem.get("options", []))
    except (ValueError, KeyError, TypeError, AttributeError):
        return RequestError(f"the server answers with status {status}", status)


def parts_of(headers: Message, content: bytes) -> Dict[str, Part]:
    """The parts of a multipart answer by their names; each says its length, so content is never searched."""
    boundary = b"--" + (headers.get_boundary() or "").encode()
    parts: Dict[str, Part] = {}
    whole = memoryview(content)
    place = content.index(boundary) + len(boundary)
    while content[place : place + 2] == b"\r\n":
        end = content.index(b"\r\n\r\n", place) + 4
        lines = content[place + 2 : end - 4].decode("latin-1").split("\r\n")
        head = {name.lower(): value.strip() for name, _, value in (line.partition(":") for line in lines)}
        length = int(head["content-length"])
        if not 0 <= length <= len(content) - end:
            raise ValueError(f"a part has {length} bytes of {len(content) - end}")
        parts[head["content-disposition"].split('filename="')[1].rstrip('"')] = Part(head, whole[end : end + length])
        place = end + length + 2 + len(boundary)
    return parts

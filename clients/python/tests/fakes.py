"""Servers that hang, die and lie, and a way between the client and a real server that can be blocked."""

import base64
import contextlib
import hashlib
import socket
import struct
import threading
from urllib.parse import urlsplit


class Fake:
    """Listens on loopback; each connection goes to a handler with its number, from 1, in a thread of its own."""

    def __init__(self, handler):
        self._handler = handler
        self._listener = socket.create_server(("127.0.0.1", 0))
        self._open = []
        self.connections = 0
        self.address = "http://127.0.0.1:%d" % self._listener.getsockname()[1]
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self):
        with contextlib.suppress(OSError):
            while True:
                connection = self._listener.accept()[0]
                self._open.append(connection)
                self.connections += 1
                threading.Thread(target=self._handle, args=(connection, self.connections), daemon=True).start()

    def _handle(self, connection, number):
        with contextlib.suppress(OSError, EOFError), connection:
            self._handler(connection, number)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for one in [self._listener, *self._open]:
            with contextlib.suppress(OSError):
                one.shutdown(socket.SHUT_RDWR)
            one.close()


def read(connection, count):
    """So many bytes."""
    content = b""
    while len(content) < count:
        part = connection.recv(count - len(content))
        if not part:
            raise EOFError
        content += part
    return content


def read_request(connection):
    """The head of a request; its body is read too."""
    head = b""
    while not head.endswith(b"\r\n\r\n"):
        head += read(connection, 1)
    for line in head.split(b"\r\n"):
        if line.lower().startswith(b"content-length:"):
            read(connection, int(line.split(b":")[1]))
    return head


def answer(content, kind="application/json"):
    """A whole answer of HTTP."""
    return b"HTTP/1.1 200 OK\r\nContent-Type: %s\r\nContent-Length: %d\r\n\r\n" % (kind.encode(), len(content)) + content


def hang(connection):
    """Until the client goes away."""
    while connection.recv(4096):
        pass


def open_stream(connection, ready=b'{"ready": true, "width": 4, "height": 2}'):
    """Becomes a WebSocket, reads the first message and answers it."""
    head = read_request(connection).decode()
    key = next(line.split(": ")[1] for line in head.split("\r\n") if line.startswith("Sec-WebSocket-Key"))
    accept = base64.b64encode(hashlib.sha1((key + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11").encode()).digest()).decode()
    connection.sendall(f"HTTP/1.1 101 x\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: {accept}\r\n\r\n".encode())
    read_message(connection)
    connection.sendall(message(1, ready))


def read_message(connection):
    """The content of a client's message."""
    length = read(connection, 2)[1] & 0x7F
    if length == 126:
        (length,) = struct.unpack("!H", read(connection, 2))
    mask = read(connection, 4)
    return bytes(byte ^ mask[i % 4] for i, byte in enumerate(read(connection, length)))


def message(kind, content):
    """A server's message: 1 text, 2 binary, 8 close."""
    return struct.pack("!BBH", 0x80 | kind, 126, len(content)) + content


def image(number, level, width=4, height=2):
    """The answer to a state."""
    return message(2, struct.pack("<4sIII", b"MSIF", number, width, height) + bytes([level]) * (width * height))


def echo_stream(connection, _):
    """Answers each state by an image whose level is the state's rx."""
    open_stream(connection)
    number = 0
    while True:
        content = read_message(connection)
        if len(content) != 64:
            return  # the client closes
        number += 1
        connection.sendall(image(number, int(struct.unpack("<8d", content)[1])))


def echo_requests(connection, _):
    """Answers each request by its own path."""
    while True:
        path = read_request(connection).split(b" ")[1]
        connection.sendall(answer(b'{"path": "%s"}' % path))


class Way:
    """Leads to a real server; answers can be held back."""

    def __init__(self, address):
        self._server = (urlsplit(address).hostname, urlsplit(address).port)
        self.is_open = threading.Event()
        self.is_open.set()
        self.on_request = lambda: None

    def __call__(self, connection, _):
        with socket.create_connection(self._server) as server:
            threading.Thread(target=self._back, args=(server, connection), daemon=True).start()
            try:
                while content := connection.recv(1 << 16):
                    server.sendall(content)
                    self.on_request()
            finally:
                server.shutdown(socket.SHUT_RDWR)  # close() alone waits for the other thread

    def _back(self, server, connection):
        with contextlib.suppress(OSError):
            while content := server.recv(1 << 16):
                self.is_open.wait(60.0)
                connection.sendall(content)

"""Images as PNG files, without a library."""

from __future__ import annotations

import struct
import zlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from numpy.typing import NDArray


def png_of(image: "NDArray[Any]") -> bytes:
    """A grey image [height, width] of 8 or 16 bits as the bytes of a PNG file."""
    height, width = image.shape
    rows = image.astype(">u2" if image.itemsize == 2 else "u1").view("u1").reshape(height, -1)
    data = b"".join(b"\0" + row.tobytes() for row in rows)  # 0: the row is stored as it is
    head = struct.pack(">IIBBBBB", width, height, 8 * image.itemsize, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + _chunk(b"IHDR", head) + _chunk(b"IDAT", zlib.compress(data)) + _chunk(b"IEND", b"")


def _chunk(name: bytes, content: bytes) -> bytes:
    return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))

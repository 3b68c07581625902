"""PNG files as msis writes them, without a library."""

from __future__ import annotations

import struct
import zlib
from typing import Any, Dict, List

import numpy as np
from numpy.typing import NDArray


_UP = 2  # filter: each row is the difference from the row above
_CHUNK = 65536  # bytes of compressed data
_GAMMA = {"srgb": 45455, "linear": 100000, "detector": 100000}


def png_of(levels: NDArray[Any], bits: int, transfer: str) -> bytes:
    """The file of a grey image; with zlib it is byte for byte that of msis (libraries in its place may compress differently).

    Args:
        levels: [height, width], uint8 or uint16; of a detector its numbers.
        bits: Of a level or number.
        transfer: What the levels mean: "srgb", "linear", or "detector" for numbers, which are scaled to 16 bits.
    """
    chunks = [(b"IHDR", struct.pack(">IIBBBBB", levels.shape[1], levels.shape[0], 8 * levels.itemsize, 0, 0, 0, 0)),
              (b"gAMA", struct.pack(">I", _GAMMA[transfer]))]  # fmt: skip
    if transfer == "srgb":
        chunks.append((b"sRGB", b"\0"))
    if transfer == "detector":
        chunks.append((b"sBIT", bytes([bits])))
        largest = (1 << bits) - 1
        levels = ((levels.astype(np.uint32) * 65535 + largest // 2) // largest).astype(np.uint16)
    rows = levels.astype(f">u{levels.itemsize}").view(np.uint8)
    packed = np.full((len(rows), 1 + rows.shape[1]), _UP, np.uint8)
    packed[0, 1:] = rows[0]
    np.subtract(rows[1:], rows[:-1], out=packed[1:, 1:])
    compressor = zlib.compressobj(1, zlib.DEFLATED, 15, 8, zlib.Z_RLE)
    data = compressor.compress(packed.tobytes()) + compressor.flush()
    chunks += [(b"IDAT", data[start : start + _CHUNK]) for start in range(0, len(data), _CHUNK)]
    return b"\x89PNG\r\n\x1a\n" + b"".join(_chunk(kind, content) for kind, content in [*chunks, (b"IEND", b"")])


def image_of(png: bytes) -> NDArray[Any]:
    """The levels of a grey image as the server writes it, [height, width]; of a detector its numbers: sample >> (16 - bits)."""
    chunks: Dict[bytes, List[bytes]] = {}
    place = 8
    while place < len(png):
        length, kind = struct.unpack_from(">I4s", png, place)
        chunks.setdefault(kind, []).append(png[place + 8 : place + 8 + length])
        place += 12 + length
    width, height, depth, colors = struct.unpack_from(">IIBB", chunks[b"IHDR"][0])
    packed = np.frombuffer(zlib.decompress(b"".join(chunks[b"IDAT"])), np.uint8).reshape(height, 1 + width * depth // 8)
    if depth not in (8, 16) or colors != 0 or (packed[:, 0] != _UP).any():
        raise ValueError("the PNG is not of the kind that msis writes")
    levels = packed[:, 1:].copy()
    for above, row in zip(levels, levels[1:]):  # 60 times as fast as np.add.accumulate
        row += above
    if depth == 8:
        return levels
    bits = chunks[b"sBIT"][0][0] if b"sBIT" in chunks else 16
    numbers: NDArray[Any] = levels.view(">u2").astype(np.uint16) >> np.uint16(16 - bits)
    return numbers


def _chunk(kind: bytes, content: bytes) -> bytes:
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

#!/usr/bin/env python3
"""A GeoTIFF with as many pixels as is said, in a file of 59 MB (docs/surface.md).

    large_raster.py SIDE FILE.tif

SIDE x SIDE pixels of 1 m around the south pole, with relief everywhere. The tiles of 8,192 x 8,192 pixels are named many times in its
table, so that reading costs as much as if each were there.
"""
import struct
import sys

import numpy as np
from osgeo import gdal, osr

REAL, TILE = 8192, 512
BYTES = {1: 1, 2: 1, 3: 2, 4: 4, 5: 8, 12: 8}  # of a number, by TIFF's type
OFFSETS, COUNTS = 324, 325


def relief():
    random = np.random.default_rng(7)
    wave = np.hypot(np.fft.fftfreq(REAL)[:, None], np.fft.rfftfreq(REAL)[None])
    wave[0, 0] = np.inf
    noise = random.standard_normal(wave.shape, np.float32) + 1j * random.standard_normal(wave.shape, np.float32)
    heights = np.fft.irfft2(noise * wave ** -1.9, (REAL, REAL))
    return (np.round(heights * (16 * 150 / heights.std())) / 16).astype(np.float32)


def real_file(side):
    system = osr.SpatialReference()
    system.ImportFromProj4("+proj=stere +lat_0=-90 +R=1737400")
    name = "/vsimem/real.tif"
    data = gdal.GetDriverByName("GTiff").Create(
        name, REAL, REAL, 1, gdal.GDT_Float32,
        ["TILED=YES", f"BLOCKXSIZE={TILE}", f"BLOCKYSIZE={TILE}", "COMPRESS=DEFLATE", "PREDICTOR=3"])
    data.SetProjection(system.ExportToWkt())
    data.SetGeoTransform((-side / 2, 1, 0, side / 2, 0, -1))
    data.GetRasterBand(1).WriteArray(relief())
    data = None
    return bytes(gdal.VSIFReadL(1, gdal.VSIStatL(name).size, gdal.VSIFOpenL(name, "rb")))


def tags_of(data):
    (head,) = struct.unpack_from("<I", data, 4)
    (count,) = struct.unpack_from("<H", data, head)
    tags = {}
    for i in range(count):
        tag, kind, number, value = struct.unpack_from("<HHII", data, head + 2 + 12 * i)
        size = BYTES[kind] * number
        tags[tag] = (kind, number, data[value:value + size] if size > 4 else struct.pack("<I", value)[:size])
    return tags


def main():
    gdal.UseExceptions()
    side = int(sys.argv[1])
    data = real_file(side)
    data += b"\0" * (len(data) % 2)
    tags = tags_of(data)
    tiles = -(-side // TILE)
    repeated = np.arange(tiles) % (REAL // TILE)
    for tag in OFFSETS, COUNTS:
        kind, _, values = tags[tag]
        table = np.frombuffer(values, "<u4" if kind == 4 else "<u2").reshape(REAL // TILE, -1)
        tags[tag] = (4, tiles * tiles, table[np.ix_(repeated, repeated)].astype("<u4").tobytes())
    tags[256] = tags[257] = (4, 1, struct.pack("<I", side))
    entries, values = b"", b""
    for tag, (kind, number, value) in sorted(tags.items()):
        if len(value) > 4:
            place = struct.pack("<I", len(data) + len(values))
            values += value + b"\0" * (len(value) % 2)
        else:
            place = value.ljust(4, b"\0")
        entries += struct.pack("<HHI", tag, kind, number) + place
    with open(sys.argv[2], "wb") as file:
        file.write(data[:4] + struct.pack("<I", len(data) + len(values)) + data[8:] + values)
        file.write(struct.pack("<H", len(tags)) + entries + bytes(4))


if __name__ == "__main__":
    main()

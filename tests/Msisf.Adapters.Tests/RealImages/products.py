#!/usr/bin/env python3
"""Writes small products as ISIS, PDS3 and PDS4 have them, by the formats' own pages and with numpy alone, and the numbers that they hold.

    /usr/bin/python3 -B products.py FOLDER

prints a line for each product: its label, bands, lines, samples, and the file of its numbers (float32, bands by lines by samples, NaN where
there is no value).
"""
import pathlib
import sys

import numpy as np

BANDS, LINES, SAMPLES = 2, 7, 11
NULL = np.frombuffer(b"\xfb\xff\x7f\xff", "<f4")[0]  # ISIS: 0xff7ffffb


def numbers(seed, low, high):
    return np.random.default_rng(seed).integers(low, high, (BANDS, LINES, SAMPLES)).astype(float)


def cube(folder, name, pixel_type, dtype, raw, expected, tile=None, base=0.0, multiplier=1.0, detached=False):
    """An ISIS cube; pixels in tiles that are filled up, or band by band."""
    order = "Msb" if dtype.startswith(">") else "Lsb"
    stored = raw.astype(dtype)
    if tile:
        down, across = -(-LINES // tile[0]), -(-SAMPLES // tile[1])
        filled = np.full((BANDS, down * tile[0], across * tile[1]), 77).astype(dtype)
        filled[:, :LINES, :SAMPLES] = stored
        stored = filled.reshape(BANDS, down, tile[0], across, tile[1]).transpose(0, 1, 3, 2, 4)
    start = 1 if detached else 4097
    form = "    Format      = BandSequential\n"
    if tile:
        form = f"    Format      = Tile\n    TileSamples = {tile[1]}\n    TileLines   = {tile[0]}\n"
    core = f"    ^Core       = {name}.cub\n" if detached else ""
    label = (f"Object = IsisCube\n  Object = Core\n{core}    StartByte   = {start}\n{form}\n    Group = Dimensions\n"
             f"      Samples = {SAMPLES}\n      Lines   = {LINES}\n      Bands   = {BANDS}\n    End_Group\n\n"
             f"    Group = Pixels\n      Type       = {pixel_type}\n"
             f"      ByteOrder  = {order}\n      Base       = {base}\n      Multiplier = {multiplier}\n    End_Group\n  End_Object\n\n"
             f"  Group = Instrument\n    InstrumentId = TEST\n    TargetName   = Moon\n    ExposureDuration = 26.0 <ms>\n  End_Group\n"
             f"  Group = Kernels\n    Long = $lro/kernels/spk/LRO_ES_31_201503_GRGM900C_L6-\n           00.bsp\n  End_Group\n"
             "End_Object\nObject = Label\n  Bytes = 4096\nEnd_Object\nEnd\n")
    if detached:
        (folder / f"{name}.lbl").write_text(label)
        (folder / f"{name}.cub").write_bytes(stored.tobytes())
        path = folder / f"{name}.lbl"
    else:
        path = folder / f"{name}.cub"
        path.write_bytes(label.encode().ljust(4096, b"\0") + stored.tobytes())
    return path, expected


def pds3(folder, name, sample_type, bits, dtype, raw, expected, storage, attached=False, prefix=0, more=""):
    stored = raw.astype(dtype)
    stored = {"BAND_SEQUENTIAL": stored, "LINE_INTERLEAVED": stored.transpose(1, 0, 2),
              "SAMPLE_INTERLEAVED": stored.transpose(1, 2, 0)}[storage]
    rows = stored.reshape(-1, stored.shape[-1] * (stored.shape[-2] if storage == "SAMPLE_INTERLEAVED" else 1))
    data = b"".join(b"\x11" * prefix + row.tobytes() for row in rows)
    record = 512
    pointer = "^IMAGE = 5" if attached else f'^IMAGE = ("{name}.img", 3)'
    label = (f"PDS_VERSION_ID = PDS3\r\nRECORD_TYPE = FIXED_LENGTH\r\nRECORD_BYTES = {record}\r\n{pointer}\r\n"
             f"LRO:LINE_EXPOSURE_DURATION = 1.0288 <ms>\r\nOBJECT = IMAGE\r\n  LINES = {LINES}\r\n  LINE_SAMPLES = {SAMPLES}\r\n"
             f"  BANDS = {BANDS}\r\n  BAND_STORAGE_TYPE = {storage}\r\n  SAMPLE_TYPE = {sample_type}\r\n  SAMPLE_BITS = {bits}\r\n"
             f"  LINE_PREFIX_BYTES = {prefix}\r\n{more}END_OBJECT = IMAGE\r\nEND\r\n").encode()
    if attached:
        path = folder / f"{name}.img"
        path.write_bytes(label.ljust(4 * record, b" ") + data)
    else:
        path = folder / f"{name}.lbl"
        path.write_bytes(label)
        (folder / f"{name}.img").write_bytes(bytes(2 * record) + data)
    return path, expected


def pds4(folder, name, data_type, dtype, raw, expected, axes, more=""):
    order = [("Band", "Line", "Sample").index(axis) for axis in axes]
    sizes = {"Band": BANDS, "Line": LINES, "Sample": SAMPLES}
    (folder / f"{name}.img").write_bytes(bytes(100) + raw.transpose(order).astype(dtype).tobytes())
    rows = "".join(f"<Axis_Array><axis_name>{axis}</axis_name><elements>{sizes[axis]}</elements>"
                   f"<sequence_number>{number}</sequence_number></Axis_Array>" for number, axis in enumerate(axes, 1))
    path = folder / f"{name}.xml"
    path.write_text(
        '<?xml version="1.0"?>\n<Product_Observational xmlns="http://pds.nasa.gov/pds4/pds/v1"><Observation_Area><Time_Coordinates>'
        "<start_date_time>2020-01-01T00:00:00Z</start_date_time></Time_Coordinates><Observing_System><Observing_System_Component>"
        "<name>Test Camera</name></Observing_System_Component></Observing_System><Target_Identification><name>Moon</name>"
        f"</Target_Identification></Observation_Area><File_Area_Observational><File><file_name>{name}.img</file_name></File>"
        f'<Array_3D_Image><offset unit="byte">100</offset><axes>3</axes><Element_Array><data_type>{data_type}</data_type>{more}'
        f"</Element_Array>{rows}<Special_Constants><missing_constant>-32768</missing_constant></Special_Constants></Array_3D_Image>"
        "</File_Area_Observational></Product_Observational>\n")
    return path, expected


def main():
    folder = pathlib.Path(sys.argv[1])
    real = np.random.default_rng(1).normal(0.0, 100.0, (BANDS, LINES, SAMPLES)).astype("f4")
    with_null = real.copy()
    with_null[0, 2, 3] = NULL
    gaps = np.where(with_null == NULL, np.nan, with_null)
    word = numbers(2, -32752, 32767)
    word[1, 6, 10] = -32768
    word_gaps = np.where(word < -32752, np.nan, word)
    byte = numbers(3, 1, 255)
    byte[0, 0, 0], byte[0, 0, 1] = 0, 255
    byte_gaps = np.where((byte == 0) | (byte == 255), np.nan, byte)
    unsigned = numbers(4, 3, 65523)
    unsigned[0, 1, 1], unsigned[0, 1, 2] = 65535, 0
    unsigned_gaps = np.where((unsigned < 3) | (unsigned > 65522), np.nan, unsigned)
    plain = numbers(5, 0, 255)
    missing = numbers(6, -1000, 1000)
    missing[1, 3, 5] = -32768
    missing_gaps = np.where(missing == -32768, np.nan, missing)
    made = [
        cube(folder, "tiles", "Real", "<f4", with_null, gaps, tile=(4, 5)),
        cube(folder, "words", "SignedWord", ">i2", word, 0.5 + 0.013 * word_gaps, base=0.5, multiplier=0.013),
        cube(folder, "bytes", "UnsignedByte", "u1", byte, byte_gaps, tile=(7, 11)),
        cube(folder, "detached", "UnsignedWord", "<u2", unsigned, unsigned_gaps, detached=True),
        pds3(folder, "bytes3", "LSB_INTEGER", 8, "u1", plain, plain, "BAND_SEQUENTIAL", attached=True),
        pds3(folder, "lines3", "MSB_INTEGER", 16, ">i2", missing, 3.0 + 2.0 * missing_gaps, "LINE_INTERLEAVED",
             more="  OFFSET = 3.0\r\n  SCALING_FACTOR = 2.0\r\n  MISSING_CONSTANT = -32768\r\n"),
        pds3(folder, "samples3", "PC_REAL", 32, "<f4", real, real, "SAMPLE_INTERLEAVED", prefix=6),
        pds3(folder, "doubles3", "IEEE_REAL", 64, ">f8", real, real, "BAND_SEQUENTIAL", prefix=4),
        pds4(folder, "lines4", "SignedMSB2", ">i2", missing, -1.0 + 0.25 * missing_gaps, ("Line", "Band", "Sample"),
             "<scaling_factor>0.25</scaling_factor><value_offset>-1</value_offset>"),
        pds4(folder, "bands4", "IEEE754LSBDouble", "<f8", real, real, ("Band", "Line", "Sample")),
    ]
    for path, expected in made:
        values = path.with_suffix(".expected")
        values.write_bytes(expected.astype("<f4").tobytes())
        print(path.name, BANDS, LINES, SAMPLES, values.name)


if __name__ == "__main__":
    main()

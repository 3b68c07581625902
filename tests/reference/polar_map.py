#!/usr/bin/env python3
"""Vertices of polar stereographic maps at 60 digits, from latitude and longitude, for PolarStereographicTests and PlaneGeometryTests.

The map as DSMAP_POLAR.CAT describes it in prose: rho = 2 R tan((90 - |latitude|) / 2), X = rho sin(longitude), Y = rho cos(longitude);
sample = sample offset + X / scale; line = line offset - Y / scale at the south pole, + Y / scale at the north pole.

    tests/reference/polar_map.py                      the table of the tests
    tests/reference/polar_map.py IMAGE.LBL LINE SAMPLE   position of a sample of a 16-bit or 32-bit image, counted from 0, m
"""
import re
import struct
import sys

from mpmath import atan, atan2, cos, floor, mp, mpf, pi, sin, sqrt, tan

mp.dps = 60
R = mpf(1737400)


def direction(south, scale, line_offset, sample_offset, line, sample):
    x = (mpf(sample) - mpf(sample_offset)) * mpf(scale)
    y = (mpf(line_offset) - mpf(line)) * mpf(scale)
    y = y if south else -y
    rho = sqrt(x * x + y * y)
    latitude = pi / 2 - 2 * atan(rho / (2 * R))
    assert abs(2 * R * tan((pi / 2 - latitude) / 2) - rho) < mpf(10) ** -40
    longitude = atan2(x, y)
    up = -sin(latitude) if south else sin(latitude)
    return cos(latitude) * cos(longitude), cos(latitude) * sin(longitude), up


def lattice(metres, k):
    return int(floor(metres * 2 ** k + mpf(1) / 2))


def k_of(scale):
    k = 7
    while mpf(2048) / mpf(scale) > 2 ** k:
        k += 1
    return k


def table():
    cases = [
        (True, "20", "15199.5", "15199.5", 0, 0, "1738123.5"),
        (True, "20", "15199.5", "15199.5", 15199, 15200, "1736000"),
        (True, "20", "15199.5", "15199.5", 30399, 7, "1737400.5"),
        (True, "5", "15167.5", "15167.5", 4711, 30335, "1741029.5"),
        (False, "5", "15167.5", "15167.5", 4711, 30335, "1741029.5"),
        (False, "100", "14399.5", "14399.5", 28799, 28799, "1732111"),
        (True, "1", "-3000.25", "12000.75", 77, 1, "1737399.875"),
        (False, "80", "3799.5", "3799.5", 3799, 3799, "1737400"),
    ]
    for south, scale, line_offset, sample_offset, line, sample, radius in cases:
        d = direction(south, scale, line_offset, sample_offset, line, sample)
        steps = [lattice(mpf(radius) * c, k_of(scale)) for c in d]
        print(
            f"    [InlineData({str(south).lower()}, {scale}.0, {line_offset}, {sample_offset}, {line}, {sample}, {radius}, "
            + ", ".join(mp.nstr(c, 20) for c in d) + f", {k_of(scale)}, " + ", ".join(f"{s}L" for s in steps) + ")]"
        )


def position(label, line, sample):
    text = open(label, encoding="latin-1").read()
    number = lambda key: mpf(re.search(rf"^\s*{key}\s*=\s*([-+.\deE]+)", text, re.M).group(1))
    south = number("CENTER_LATITUDE") < 0
    samples = int(number("LINE_SAMPLES"))
    is_integer = "LSB_INTEGER" in text
    size, form = (2, "<h") if is_integer else (4, "<f")
    unit = 1000 if "KILOMETER" in text else 1
    with open(re.sub(r"\.LBL$", ".IMG", label), "rb") as image:
        image.seek(size * (line * samples + sample))
        value = struct.unpack(form, image.read(size))[0]
    radius = unit * (number("OFFSET") + number("SCALING_FACTOR") * mpf(value))
    d = direction(south, number("MAP_SCALE"), number("LINE_PROJECTION_OFFSET"), number("SAMPLE_PROJECTION_OFFSET"), line, sample)
    return [radius * c for c in d]


if __name__ == "__main__":
    if len(sys.argv) == 4:
        for component in position(sys.argv[1], int(sys.argv[2]), int(sys.argv[3])):
            print(mp.nstr(component, 25))
    else:
        table()

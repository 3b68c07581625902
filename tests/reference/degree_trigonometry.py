#!/usr/bin/env python3
"""Checks the sines of docs/pattern-format.md against mpmath, and prints a few of them as test data.

The algorithm is written here a second time, from the page alone, in Python's doubles (IEEE 754, no fused multiply-add).
For each resolution every sine that a grid of that resolution needs is compared with the true value rounded once.

    python3 tests/reference/degree_trigonometry.py            # all resolutions of LDEM products, about a minute
"""

import struct
import sys

from mpmath import mp, mpf, radians, sin

from pattern_format import sine_of_degrees

mp.prec = 200


def bits(value):
    return struct.unpack("<Q", struct.pack("<d", value))[0]


def check(resolution):
    wrong = 0
    for k in range(90 * resolution):
        numerator, denominator = 2 * k + 1, 2 * resolution
        true = float(sin(radians(mpf(numerator) / denominator)))
        wrong += bits(true) != bits(sine_of_degrees(numerator, denominator))
    print(f"{resolution} px/deg: {90 * resolution} sines, {wrong} not correctly rounded")
    return wrong


if __name__ == "__main__":
    resolutions = [int(text) for text in sys.argv[1:]] or [1, 2, 3, 4, 5, 7, 8, 10, 16, 32, 64, 128, 256, 512, 1024]
    failures = sum(check(resolution) for resolution in resolutions)
    for numerator, denominator in [(1, 8), (1, 2048), (5, 2), (89, 2), (45, 1), (91, 2), (1, 3), (359999, 8000)]:
        true = float(sin(radians(mpf(numerator) / denominator)))
        print(f"[InlineData({numerator}, {denominator}, 0x{bits(true):016x})]")
    sys.exit(failures != 0)

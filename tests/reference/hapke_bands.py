#!/usr/bin/env python3
"""Medians of Hapke's parameters of the Moon in seven bands, between 32 S and 32 N.

    python3 tests/reference/hapke_bands.py 1x1_70NS_7b_wbhs_albflt_grid_geirist_tcorrect.reduced.cub

The file is a part of the test data of USGS ISIS: the maps of Sato et al. (2014), 9 parameters in each of 7 bands, as means over
32 degrees: 4 lines of 11 samples, 32-bit real numbers from byte 65537. The two middle lines lie between 32 S and 32 N.
"""
import statistics
import struct
import sys

NAMES = ('w', 'b', 'c', 'Bc0', 'hc', 'Bs0', 'hs', 'theta', 'phi')
BANDS = (321, 360, 415, 566, 604, 643, 689)
SAMPLES, LINES, START = 11, 4, 65536

data = open(sys.argv[1], 'rb').read()
for band, nanometres in enumerate(BANDS):
    medians = []
    for parameter in range(len(NAMES)):
        start = START + (band * len(NAMES) + parameter) * SAMPLES * LINES * 4
        values = struct.unpack_from(f'<{SAMPLES * LINES}f', data, start)
        medians.append(statistics.median(values[SAMPLES:3 * SAMPLES]))
    print(nanometres, *(f'{name} {value:.5f}' for name, value in zip(NAMES, medians)))

#!/usr/bin/env python3
"""Mean solar irradiance at 1 au in the bands of the LROC Wide Angle Camera, W m^-2 nm^-1.

    python3 tests/reference/solar_irradiance.py E490_00a_AM0.csv

The file is ASTM E490-00a, "Standard Solar Constant and Zero Air Mass Solar Spectral Irradiance Tables", as NREL publishes it:
wavelength in micrometres and irradiance in W m^-2 um^-1 in the first two columns. The spectrum is linear between its points;
each band is taken as even over its full width at half maximum (BandBin of the reduced Hapke maps in the test data of USGS ISIS).
"""
import bisect
import csv
import sys

BANDS = ((321, 32), (360, 15), (415, 36), (566, 20), (604, 20), (643, 23), (689, 39))
STEPS = 20000

points = []
for row in csv.reader(open(sys.argv[1], encoding='utf-8-sig')):
    try:
        points.append((float(row[0]) * 1e3, float(row[1]) * 1e-3))
    except (ValueError, IndexError):
        continue
points.sort()
wavelengths = [point[0] for point in points]


def irradiance(nanometres):
    i = min(max(bisect.bisect(wavelengths, nanometres) - 1, 0), len(points) - 2)
    (a, low), (b, high) = points[i], points[i + 1]
    return low + (nanometres - a) / (b - a) * (high - low)


for centre, width in BANDS:
    mean = sum(irradiance(centre - width / 2 + (k + 0.5) * width / STEPS) for k in range(STEPS)) / STEPS
    print(centre, width, f'{mean:.4f}')

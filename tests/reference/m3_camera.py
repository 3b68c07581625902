#!/usr/bin/env python3
"""Cubic polynomials for cameras/chandrayaan-m3.yaml: the lens of the Moon Mineralogy Mapper by the keywords of ISIS's addendum.

    /usr/bin/python3 -B tests/reference/m3_camera.py

Keywords: NaifKeywords of M3T20090630T083407_V03_RDN in the test data of USGS's ALE (CC0). Formula: ISIS's Chandrayaan1M3DistortionMap.
"""
import numpy as np

FOCAL = 39.63
TRANSX = (-0.64, -4.00552916405788e-05)
TRANSY = (-0.052, -0.0269999702883839)
ORIGIN = 304.5
OD_K = (0.000379921103637315, 0.000213226448051461, -4.0186287875859195e-08)
DECENTER = (0.004047, -5e-06)
PITCH = 0.027
SAMPLES = 608


def ideal(sample):
    """Right (-y) and down (+x) in the focal plane, mm, of a sample counted from 1."""
    x = TRANSX[0] + TRANSX[1] * (sample - ORIGIN)
    y = TRANSY[0] + TRANSY[1] * (sample - ORIGIN)
    rr = x * x + y * y
    radial = OD_K[0] + OD_K[1] * rr + OD_K[2] * rr * rr
    ux = x + x * radial + DECENTER[0] * (rr + 2 * x * x) + 2 * DECENTER[1] * x * y
    uy = y + y * radial + 2 * DECENTER[0] * x * y + DECENTER[1] * (rr + 2 * y * y)
    return -uy, ux


if __name__ == "__main__":
    samples = np.arange(1.0, SAMPLES + 1.0)
    s = (samples - ORIGIN) * PITCH
    right, down = ideal(samples)
    for name, values, start in (("x", right - s, "a"), ("y", down, "b")):
        # Chebyshev nodes would be a little better at the ends; all samples count the same here.
        fit = np.polynomial.Polynomial.fit(s, values, 3).convert().coef
        rest = (np.polynomial.Polynomial(fit)(s) - values) / PITCH
        print(f"  {name}: [{', '.join(repr(round(float(c), 12)) for c in fit)}]    # largest error {np.abs(rest).max():.4f} px")

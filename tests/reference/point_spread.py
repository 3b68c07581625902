#!/usr/bin/env python3
"""Pixels of point spread functions that are cut off at 7 px, and encircled energies; needs: python3, mpmath.

Prints the central pixel, its neighbour and the pixel (2, 1), as parts of the sum, by integration over pixels; and the encircled energy
of the formula (cut off at 7 px) at some radii, from its closed form.
"""
import mpmath as mp

mp.mp.dps = 20
CUTOFF = 7


def gaussian(sigma):
    return (lambda r: mp.exp(-r * r / (2 * sigma ** 2))), (lambda r: 2 * mp.pi * sigma ** 2 * (1 - mp.exp(-r * r / (2 * sigma ** 2))))


def airy(s):
    def f(r):
        x = mp.pi * r / s
        return mp.mpf(1) if x == 0 else (2 * mp.besselj(1, x) / x) ** 2

    def energy(r):
        x = mp.pi * r / s
        return 4 * s * s / mp.pi * (1 - mp.besselj(0, x) ** 2 - mp.besselj(1, x) ** 2)
    return f, energy


def wings(r0, b):
    return ((lambda r: (1 + (r / r0) ** 2) ** (-mp.mpf(b) / 2)),
            (lambda r: 2 * mp.pi * r0 ** 2 / (b - 2) * (1 - (1 + (r / r0) ** 2) ** (1 - mp.mpf(b) / 2))))


def pixel(f, x, y):
    return mp.quad(lambda u: mp.quad(lambda v: f(mp.hypot(u, v)), [y - mp.mpf(1) / 2, y, y + mp.mpf(1) / 2]),
                   [x - mp.mpf(1) / 2, x, x + mp.mpf(1) / 2])


for name, (f, energy) in (("gaussian 0.7", gaussian(mp.mpf("0.7"))), ("airy 1.3", airy(mp.mpf("1.3"))), ("wings 1.5 2.6", wings(mp.mpf("1.5"), mp.mpf("2.6")))):
    total = energy(CUTOFF)
    print(name, "pixels", *(mp.nstr(pixel(f, x, y) / total, 12) for x, y in ((0, 0), (1, 0), (2, 1))))
    print(name, "encircled", *(mp.nstr(energy(r) / total, 12) for r in (1, 2, 3, 5)))

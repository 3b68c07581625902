"""Numbers of Msisf.Core.Tests/Sky, by ERFA and numpy: proper motion and parallax, aberration, and the electrons of stars.

Run: /usr/bin/python3 tests/reference/stars.py
"""
import math

import erfa
import numpy as np

YEAR = 365.25


def direction(ra, dec, pmra, pmdec, plx, years, observer):
    """erfa.pmpx: angles in rad, proper motion of right ascension without the cosine, years of proper motion, observer in au."""
    r, d = math.radians(ra), math.radians(dec)
    mas = math.pi / 648e6
    # pmpx adds the light's way across the observer's orbit to the epoch (Roemer), below 1e-5 mas a year here
    return erfa.pmpx(r, d, pmra * mas / math.cos(d), pmdec * mas, plx / 1000.0, 0.0, years, np.array(observer))


def aberrated(p, v):
    """erfa.ab with the Sun so far away that its potential does nothing."""
    v = np.array(v)
    return erfa.ab(np.array(p), v, 1e12, math.sqrt(1.0 - v @ v))


def electrons(v, colour, area, exposure, shortest, longest, transmission, efficiency):
    """Trapezoids of 0.001 nm; Planck's law in SI units, scaled to Bessell's flux at 545 nm."""
    h, c, k = 6.62607015e-34, 299792458.0, 1.380649e-23
    t = 4600.0 * (1.0 / (0.92 * colour + 1.7) + 1.0 / (0.92 * colour + 0.62))
    planck = lambda nm: (nm * 1e-9) ** -5 / np.expm1(h * c / (nm * 1e-9 * k * t))
    nm = np.linspace(shortest, longest, int((longest - shortest) * 1000) + 1)
    flux = 3.631e-11 * 10.0 ** (-0.4 * v) * planck(nm) / planck(545.0)
    rate = np.trapezoid(flux * nm, nm) * 1e-9 / (h * c) if hasattr(np, "trapezoid") else np.trapz(flux * nm, nm) * 1e-9 / (h * c)
    return rate * area * exposure * transmission * efficiency


if __name__ == "__main__":
    for row in ((101.28854105, -16.71314306, -546.01, -1223.07, 379.21, 35.0, (0.3, 0.9, 0.4)),
                (269.45402305, 4.66828815, -797.84, 10326.93, 549.01, 18.5, (-0.98, 0.12, 0.05)),
                (37.95456067, 89.26410897, 44.48, -11.85, 7.54, 10.25, (0.5, -0.8, -0.35))):
        print("DirectionFrom", row, ["%.17g" % x for x in direction(*row)])
    for p, v in (((0.6, -0.64, 0.48), (9e-5, 4e-5, -2e-5)), ((0.0, 0.0, 1.0), (1e-4, 0.0, 0.0)), ((0.8, 0.6, 0.0), (0.3, -0.2, 0.5))):
        print("Of", p, v, ["%.17g" % x for x in aberrated(p, v)])
    for v, colour in ((-1.44, 0.009), (0.03, 0.0), (0.45, 1.5), (4.0, 0.653), (6.0, -0.2)):
        print("ElectronRate", v, colour, "%.9g" % electrons(v, colour, 1.0, 1.0, 400.0, 700.0, 0.8, 0.5))
    print("Vega, 20 mm, 400 to 700 nm, QE 0.5: %.4g a second" % electrons(0.03, 0.0, math.pi * 0.01 ** 2, 1.0, 400.0, 700.0, 1.0, 0.5))

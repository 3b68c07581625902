#!/usr/bin/env python3
"""I/F of Hapke's law with the Moon's medians at 643 nm, and of the LROC NAC law of 2019, from the printed formulas.

    python3 tests/reference/moon_law.py

Sato et al., J. Geophys. Res. Planets 119 (2014), p. 1775: w 0.3854, b 0.2375, c 0.3253, BS0 1.686, hs 0.0672, theta 23.6566
degrees, BC0 0, K 1 (medians within 30 degrees of the equator).
"""
from mpmath import cos, exp, mp, mpf, nstr, pi, radians, sqrt

from reflectance import hapke

mp.dps = 40


def nac(i, e, g):
    """Angles in degrees."""
    mu0, mu, g = cos(radians(i)), cos(radians(e)), mpf(g)
    return mu0 / (mu + mu0) * exp(
        mpf('-1.479654495') - mpf('8.3528e-5') * g ** 2 + mpf('0.012964707') * g - mpf('0.237774774') * sqrt(g)
        + mpf('0.556075496') * mu + mpf('0.66367146') * mu0 - mpf('0.439918609') * mu0 ** 2)


MOON = tuple(mpf(x) for x in ('0.3854', '0.2375', '0.3253', '1.686', '0.0672'))
if __name__ == '__main__':
    for angle in (30, 60):
        print('moon', angle, 0, angle, nstr(
            hapke(radians(mpf(angle)), mpf(0), radians(mpf(angle)), mpf(0), *MOON, radians(mpf('23.6566'))), 17))
    for angles in ((30, 0, 30), (60, 20, 45), (0, 0, 0), (80, 70, 140)):
        print('nac', *angles, nstr(nac(*angles), 17))

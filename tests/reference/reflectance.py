#!/usr/bin/env python3
"""Radiance factors I/F of four reflectance laws from the printed formulas: angles in, 40 digits.

    python3 tests/reference/reflectance.py > tests/golden/reflectance.tsv

Hapke: "Theory of Reflectance and Emittance Spectroscopy", 2nd ed. (Cambridge 2012): particle phase function of two
Henyey-Greenstein lobes, B_S(g) = 1 / (1 + tan(g/2) / h), H(x) of Hapke (2002), eq. 12.45-12.55 with K = 1 and B_C0 = 0.
Lunar-Lambert: McEwen, LPSC XXVII (1996), p. 841, L of the phase angle in degrees, kept in [0, 1].
"""
import random

from mpmath import atan2, cos, cot, exp, log, mp, mpf, nstr, pi, radians, sin, sqrt, tan

mp.dps = 40
SEED = 20120222


def lambert(i, e, g, albedo):
    return albedo * cos(i)


def lommel_seeliger(i, e, g, albedo):
    return albedo * 2 * cos(i) / (cos(i) + cos(e))


def lunar_lambert(i, e, g, albedo):
    a = g * 180 / pi
    weight = 1 - mpf('0.019') * a + mpf('2.42e-4') * a ** 2 - mpf('1.46e-6') * a ** 3
    weight = min(max(weight, mpf(0)), mpf(1))
    return albedo * (weight * 2 * cos(i) / (cos(i) + cos(e)) + (1 - weight) * cos(i))


def hapke(i, e, g, psi, w, b, c, b0, h, theta):
    def e1(x):
        return mpf(0) if theta == 0 or x == 0 else exp(-2 / pi * cot(theta) * cot(x))

    def e2(x):
        return mpf(0) if theta == 0 or x == 0 else exp(-1 / pi * cot(theta) ** 2 * cot(x) ** 2)

    def chandrasekhar(x):
        r0 = (1 - sqrt(1 - w)) / (1 + sqrt(1 - w))
        return 1 / (1 - w * x * (r0 + (1 - 2 * r0 * x) / 2 * log((1 + x) / x)))

    def eta(x):
        return chi * (cos(x) + sin(x) * tan(theta) * e2(x) / (2 - e1(x)))

    chi = 1 / sqrt(1 + pi * tan(theta) ** 2)
    half = sin(psi / 2) ** 2
    if i <= e:
        below = 2 - e1(e) - psi / pi * e1(i)
        mu0e = chi * (cos(i) + sin(i) * tan(theta) * (cos(psi) * e2(e) + half * e2(i)) / below)
        mue = chi * (cos(e) + sin(e) * tan(theta) * (e2(e) - half * e2(i)) / below)
        hidden = chi * cos(i) / eta(i)
    else:
        below = 2 - e1(i) - psi / pi * e1(e)
        mu0e = chi * (cos(i) + sin(i) * tan(theta) * (e2(i) - half * e2(e)) / below)
        mue = chi * (cos(e) + sin(e) * tan(theta) * (cos(psi) * e2(i) + half * e2(e)) / below)
        hidden = chi * cos(e) / eta(e)
    f = exp(-2 * tan(psi / 2)) if psi < pi else mpf(0)
    shadowing = mue / eta(e) * cos(i) / eta(i) * chi / (1 - f + f * hidden)
    phase = ((1 + c) / 2 * (1 - b ** 2) / (1 - 2 * b * cos(g) + b ** 2) ** mpf('1.5')
             + (1 - c) / 2 * (1 - b ** 2) / (1 + 2 * b * cos(g) + b ** 2) ** mpf('1.5'))
    surge = b0 / (1 + tan(g / 2) / h)
    single_and_multiple = phase * (1 + surge) + chandrasekhar(mu0e) * chandrasekhar(mue) - 1
    return w / 4 * mu0e / (mu0e + mue) * single_and_multiple * shadowing


def phase_angle(i, e, psi):
    x = cos(i) * cos(e) + sin(i) * sin(e) * cos(psi)
    across = sqrt(max(1 - x ** 2, mpf(0)))
    return atan2(across, x)


MOON = ('0.32357', '0.23955', '0.30452', '1.80238', '0.07145', '23.4')
PARAMETERS = [
    MOON,
    ('0.21', '0.29', '0.39', '1', '0.07', '0'),
    ('0.95', '0.1', '-0.4', '0', '1', '40'),
    ('1', '0.6', '0.9', '3', '0.01', '10'),
]
ANGLES = [(0, 0, 0), (30, 0, 0), (0, 30, 0), (30, 30, 0), (30, 30, 180), (60, 60, 90), (60, 20, 135), (20, 60, 135), (85, 80, 10),
          (80, 85, 170), (89.9, 5, 60), (5, 89.9, 60), (89.9, 89.95, 120), (45, 45, 1), (70, 69, 0), (89.99, 89.99, 179)]


def rows():
    draw = random.Random(SEED)
    drawn = [(round(draw.uniform(0, 89.9), 3), round(draw.uniform(0, 89.9), 3), round(draw.uniform(0, 180), 3)) for _ in range(60)]
    for angles in ANGLES + drawn:
        i, e, psi = (radians(mpf(str(angle))) for angle in angles)
        g = phase_angle(i, e, psi)
        values = [lambert(i, e, g, mpf(1)), lommel_seeliger(i, e, g, mpf(1)), lunar_lambert(i, e, g, mpf(1))]
        for parameters in PARAMETERS:
            *numbers, slope = (mpf(text) for text in parameters)
            values.append(hapke(i, e, g, psi, *numbers, radians(slope)))
        yield [cos(i), cos(e), sin(g / 2) ** 2] + values


if __name__ == '__main__':
    print('# cos i, cos e, haversine of phase; I/F: lambert, lommel-seeliger, lunar-lambert (albedo 1); hapke w b c b0 h theta = '
          + '; '.join(' '.join(parameters) for parameters in PARAMETERS))
    for row in rows():
        print('\t'.join(nstr(value, 17) for value in row))

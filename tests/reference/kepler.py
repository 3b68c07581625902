#!/usr/bin/env python3
"""Reference values for Kepler's equation and the mean anomaly, with mpmath at 50 digits and more.

usage: kepler.py OUTPUT_FOLDER

kepler.csv: M, e; E in [-pi, pi]; x/a, y/a, r/a. The doubles M and e are taken as exact; results are rounded once to a double.
mean_anomaly.csv: a, M0, dt; M0 + sqrt(mu / a^3) dt in [-pi, pi].
"""
import math
import pathlib
import random
import sys

import mpmath as mp

mp.mp.dps = 80  # 50 digits are left when 1e300 rad loses its turns by mp.sin, which works at the precision it needs
MU = 4902801076000
SEED = 20120222


def reduced(angle):
    """In [-pi, pi]; with the digits that an angle of any size needs."""
    with mp.workdps(80 + max(0, int(mp.log10(abs(angle) + 1)))):
        return angle - 2 * mp.pi * mp.nint(angle / (2 * mp.pi))


def eccentric_anomaly(m, e):
    """Bisection in the logarithm down to 1e-4 of the bracket, then Newton to the last of 80 digits."""
    if m == 0:
        return mp.mpf(0)
    sign, m = mp.sign(m), abs(m)
    low, high = m, min(m / (1 - e), mp.pi + mp.mpf(10) ** -70)
    while high / low > 1 + mp.mpf(10) ** -4:
        middle = mp.sqrt(low * high)
        low, high = (middle, high) if residual(middle, e, m) < 0 else (low, middle)
    angle = high
    for _ in range(12):
        angle -= residual(angle, e, m) / (1 - e * mp.cos(angle))
    assert abs(residual(angle, e, m)) <= m * mp.mpf(10) ** -50, (m, e)
    return sign * angle


def residual(angle, e, m):
    with mp.workdps(80 + max(0, int(-3 * mp.log10(angle)))):  # E - sin E loses two powers of E
        return angle - e * mp.sin(angle) - m


def solutions(rng):
    eccentricities = [0.0, 1e-300, 1e-10, 0.05, 0.3, 0.5, math.nextafter(0.5, 0.0), 0.9, 0.99, 0.9999]
    eccentricities += [1.0 - 10.0 ** -k for k in range(5, 16)] + [math.nextafter(1.0, 0.0)]
    turn = 2.0 * math.pi
    anomalies = [0.0, 1e-300, 1e-30, 1e-15, 1e-8, 1e-4, 0.01, 0.1, 0.5707963267948966, 1.0, 2.0, 3.0, 3.14159, math.pi]
    anomalies += [-1e-9, -1.0, -math.pi, 4.0, 5.0, turn, math.nextafter(turn, 0.0), -turn, 3.0 * math.pi]
    anomalies += [turn * 1e3, turn * 1e6, -turn * 1e6, 1e6 * turn + 1.0, 123456.789, 1e15, 1e22, -1e300]
    pairs = [(m, e) for e in eccentricities for m in anomalies]
    for _ in range(400):
        pairs.append((rng.uniform(-math.pi, math.pi), rng.random()))
        pairs.append((10.0 ** rng.uniform(-20.0, 0.4), min(1.0 - 10.0 ** rng.uniform(-16.0, -0.5), math.nextafter(1.0, 0.0))))
        pairs.append((rng.uniform(-1e6, 1e6) * turn, rng.random()))
    for m, e in pairs:
        exact_e = mp.mpf(e)
        angle = eccentric_anomaly(reduced(mp.mpf(m)), exact_e)
        with mp.workdps(800):  # 1 - cos E for E = 1e-300
            x = mp.cos(angle) - exact_e
            y = mp.sqrt(1 - exact_e ** 2) * mp.sin(angle)
            r = 1 - exact_e * mp.cos(angle)
        yield [m, e] + [float(value) for value in (angle, x, y, r)]


def mean_anomalies(rng):
    year = 365.25 * 86400.0
    for _ in range(100):
        a = 10.0 ** rng.uniform(math.log10(1.75e6), 8.0)
        m0 = rng.uniform(0.0, 2.0 * math.pi)
        dt = rng.choice([-1.0, 1.0]) * 10.0 ** rng.uniform(0.0, math.log10(100.0 * year))
        motion = mp.sqrt(MU / mp.mpf(a) ** 3)
        yield [a, m0, dt, float(reduced(mp.mpf(m0) + motion * mp.mpf(dt)))]


def write(path, header, rows):
    path.write_text("\n".join([header] + [",".join(map(repr, row)) for row in rows]) + "\n", newline="\n")


def main():
    folder = pathlib.Path(sys.argv[1])
    rng = random.Random(SEED)
    write(folder / "kepler.csv", "M,e,E,x/a,y/a,r/a", list(solutions(rng)))
    write(folder / "mean_anomaly.csv", "a,M0,dt,M", list(mean_anomalies(rng)))
    print(f"mpmath {mp.__version__}")


if __name__ == "__main__":
    main()

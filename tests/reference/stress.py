#!/usr/bin/env python3
"""What the references of the stress tests are held against, with mpmath at 60 digits.

usage: stress.py OUTPUT_FOLDER

A number X is printed as two doubles, X and X low: the double nearest to it and the one nearest to what that leaves.
functions.csv: x; sin x, cos x, x - sin x; y > 0; sqrt y, x / y.
residuals.csv: E, M, e; E - e sin E - M, M less its turns within half a turn of 0.
orbits.csv: a, e, omega, Omega, i, M0, dt; position and velocity then (m, m/s).
leap_seconds.csv: MJD, TDB seconds past J2000, next to every leap second. Dates from IERS Bulletin C; the formula of naif0012.tls.
"""
import datetime
import math
import pathlib
import random
import sys

import mpmath as mp

mp.mp.dps = 60
MU = 4902801076000
SEED = 20120615

# First days with a new TAI - UTC, from 10 s on 1972-01-01: IERS, https://hpiers.obspm.fr/iers/bul/bulc/Leap_Second.dat
LEAP_DAYS = """1972-01-01 1972-07-01 1973-01-01 1974-01-01 1975-01-01 1976-01-01 1977-01-01 1978-01-01 1979-01-01 1980-01-01
1981-07-01 1982-07-01 1983-07-01 1985-07-01 1988-01-01 1990-01-01 1991-01-01 1992-07-01 1993-07-01 1994-07-01 1996-01-01 1997-07-01
1999-01-01 2006-01-01 2009-01-01 2012-07-01 2015-07-01 2017-01-01""".split()
FIRST_TAI_MINUS_UTC = 10
BESIDE = [0.001, 1.0, 3600.0]  # s


def two(x):
    high = float(x)
    return [high, float(x - high)]


def reduced(angle):
    return angle - 2 * mp.pi * mp.nint(angle / (2 * mp.pi))


def functions(rng):
    xs = [10.0 ** -k for k in range(1, 30, 3)] + [math.pi, -math.pi, math.pi / 2, math.pi / 4, -math.pi / 4, 0.7853981633974484]
    xs += [rng.uniform(-7.0, 7.0) for _ in range(60)]
    for x in xs:
        y = 10.0 ** rng.uniform(-12.0, 12.0)
        with mp.workdps(150):  # x - sin x loses two powers of x
            exact = mp.mpf(x)
            minus_sine = exact - mp.sin(exact)
        yield [x] + two(mp.sin(exact)) + two(mp.cos(exact)) + two(minus_sine) + [y] + two(mp.sqrt(mp.mpf(y))) + two(exact / mp.mpf(y))


def residuals(rng):
    for _ in range(100):
        e = rng.choice([rng.random(), 1.0 - 10.0 ** rng.uniform(-12.0, 0.0)])
        angle = rng.choice([-1.0, 1.0]) * rng.choice([rng.uniform(0.0, math.pi), 10.0 ** rng.uniform(-25.0, 0.0)])
        with mp.workdps(150):
            mean = mp.mpf(angle) - mp.mpf(e) * mp.sin(mp.mpf(angle))
            turns = rng.choice([0, 0, rng.randint(-1000000, 1000000)])
            m = float(mean + 2 * mp.pi * turns)
            m_reduced = reduced(mp.mpf(m))
            yield [angle, m, e] + two(mean - m_reduced) + two(m_reduced)


def state(a, e, omega, node, i, m0, dt):
    a, e, omega, node, i, m0, dt = map(mp.mpf, (a, e, omega, node, i, m0, dt))
    n = mp.sqrt(MU / a ** 3)
    m = reduced(m0 + n * dt)
    angle = m + mp.mpf("0.85") * e * mp.sign(m)
    for _ in range(30):
        angle -= (angle - e * mp.sin(angle) - m) / (1 - e * mp.cos(angle))
    assert abs(angle - e * mp.sin(angle) - m) < mp.mpf(10) ** -55
    x, y = a * (mp.cos(angle) - e), a * mp.sqrt(1 - e * e) * mp.sin(angle)
    rate = a * n / (1 - e * mp.cos(angle))
    dx, dy = -rate * mp.sin(angle), rate * mp.sqrt(1 - e * e) * mp.cos(angle)
    co, so, cn, sn, ci, si = mp.cos(omega), mp.sin(omega), mp.cos(node), mp.sin(node), mp.cos(i), mp.sin(i)
    p = (co * cn - so * sn * ci, co * sn + so * cn * ci, so * si)
    q = (-so * cn - co * sn * ci, -so * sn + co * cn * ci, co * si)
    return [x * p[k] + y * q[k] for k in range(3)] + [dx * p[k] + dy * q[k] for k in range(3)]


def orbits(rng):
    for _ in range(60):
        tiny = 10.0 ** rng.uniform(-16.0, -3.0)
        row = [
            10.0 ** rng.uniform(6.25, 8.0), rng.choice([0.0, tiny, rng.uniform(0.0, 0.9)]), rng.uniform(-3.1, 3.1), rng.uniform(-3.1, 3.1),
            rng.choice([0.0, tiny, math.pi - tiny, rng.uniform(0.0, 3.1)]), rng.uniform(-3.1, 3.1), rng.choice([0.0, 10.0 ** rng.uniform(0.0, 10.0)])]
        yield row + [part for number in state(*row) for part in two(number)]


def tdb(mjd, leap_days):
    """Seconds past J2000 in TDB of an MJD in UTC."""
    utc = (mp.mpf(mjd) - mp.mpf("51544.5")) * 86400
    steps = sum(1 for day in leap_days if mjd >= day)
    tai_minus_utc = FIRST_TAI_MINUS_UTC - 1 + steps
    tt = utc + tai_minus_utc + mp.mpf("32.184")
    m = mp.mpf("6.239996") + mp.mpf("1.99096871e-7") * tt
    return tt + mp.mpf("1.657e-3") * mp.sin(m + mp.mpf("1.671e-2") * mp.sin(m))


def leap_seconds():
    day_zero = datetime.date(1858, 11, 17)
    leap_days = [(datetime.date.fromisoformat(day) - day_zero).days for day in LEAP_DAYS]
    for day in leap_days:
        midnight = float(day)
        times = [midnight - seconds / 86400.0 for seconds in reversed(BESIDE)] + [math.nextafter(midnight, 0.0), midnight]
        times += [math.nextafter(midnight, math.inf)] + [midnight + seconds / 86400.0 for seconds in BESIDE]
        for mjd in times:
            yield [mjd, float(tdb(mjd, leap_days))]


def write(path, header, rows):
    path.write_text("\n".join([header] + [",".join(map(repr, row)) for row in rows]) + "\n", newline="\n")


def main():
    folder = pathlib.Path(sys.argv[1])
    rng = random.Random(SEED)
    write(folder / "functions.csv", "x,sin,sin low,cos,cos low,x-sin,x-sin low,y,sqrt,sqrt low,x/y,x/y low", functions(rng))
    write(folder / "residuals.csv", "E,M,e,residual,residual low,M reduced,M reduced low", residuals(rng))
    names = ("x", "y", "z", "dx", "dy", "dz")
    write(folder / "orbits.csv", "a,e,omega,Omega,i,M0,dt," + ",".join(f"{name},{name} low" for name in names), orbits(rng))
    write(folder / "leap_seconds.csv", "MJD,TDB", leap_seconds())
    print(f"mpmath {mp.__version__}")


if __name__ == "__main__":
    main()

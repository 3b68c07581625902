"""The Sun from the Moon without and with light time and stellar aberration, from the kernels in kernels/ with 40 digits.

Reads the kernels itself and computes with mpmath: shares nothing with the program or with CSPICE but the definitions:
  LT    the Sun where it was before (its geometric distance / c), the Moon where it is; one step, as SPICE documents "LT"
  LT+S  that, turned towards the Moon's motion round the solar system's barycentre by asin((v/c) sin(angle)), as SPICE's STELAB
both in the axes of MOON_ME at the time of the Moon.

Run in the repository's folder: /usr/bin/python3 tests/reference/sun_aberration.py [year]
"""
import re
import struct
import sys

from mpmath import asin, atan2, cos, matrix, mp, mpf, norm, pi, sin, sqrt

mp.dps = 40
C = mpf("299792.458")


def segments(path, integers):
    """(start, end, integers, doubles) of each segment of a DAF with two doubles a summary."""
    data = open(path, "rb").read()
    record = struct.unpack_from("<i", data, 76)[0]
    found = []
    while record > 0:
        base = (record - 1) * 1024
        following, _, count = struct.unpack_from("<3d", data, base)
        for i in range(int(count)):
            at = base + 24 + i * 8 * (2 + (integers + 1) // 2)
            start, end = struct.unpack_from("<2d", data, at)
            values = struct.unpack_from("<%di" % integers, data, at + 16)
            first, last = values[-2:]
            found.append((start, end, values, struct.unpack_from("<%dd" % (last - first + 1), data, 8 * (first - 1))))
        record = int(following)
    return found


def chebyshev(coefficients, x):
    """Sum and derivative, by T_k = cos(k acos x) written as polynomials: T_k = 2x T_(k-1) - T_(k-2), T_k' likewise."""
    t, u = [mpf(1), x], [mpf(0), mpf(1)]
    for _ in coefficients[2:]:
        u.append(2 * t[-1] + 2 * x * u[-1] - u[-2])
        t.append(2 * x * t[-1] - t[-2])
    return sum(c * v for c, v in zip(coefficients, t)), sum(c * v for c, v in zip(coefficients, u))


def value(segment, tdb):
    """Three components and their rates, of a segment of type 2."""
    data = segment[3]
    start, length, size, count = data[-4:]
    index = min(int((tdb - mpf(start)) / mpf(length)), int(count) - 1)
    record = [mpf(x) for x in data[index * int(size):(index + 1) * int(size)]]
    n = (int(size) - 2) // 3
    pairs = [chebyshev(record[2 + k * n:2 + (k + 1) * n], (tdb - record[0]) / record[1]) for k in range(3)]
    return matrix([p for p, _ in pairs]), matrix([r for _, r in pairs]) / record[1]


SPK = {s[2][0]: s for s in segments("kernels/de421.bsp", 6)}
PCK = {s[2][0]: s for s in segments("kernels/moon_pa_de421_1900-2050.bpc", 5)}
LSK = open("kernels/naif0012.tls").read()
FK = open("kernels/moon_080317.tf").read()
MONTHS = "JAN FEB MAR APR MAY JUN JUL AUG SEP OCT NOV DEC".split()


def mjd_of(year, month):
    import datetime
    return (datetime.date(year, month, 1) - datetime.date(1858, 11, 17)).days


STEPS = [(mjd_of(int(y), 1 + MONTHS.index(m)), int(s)) for s, y, m in re.findall(r"(\d+),\s*@(\d+)-(\w+)-1", LSK)]


def tdb_of(mjd):
    """LSK: TDB = UTC + leap seconds + 32.184 + K sin E."""
    tai = ([9] + [s for day, s in STEPS if mjd >= day])[-1]
    utc = (mpf(mjd) - mpf("51544.5")) * 86400
    m = mpf("6.239996") + mpf("1.99096871e-7") * (utc + tai + mpf("32.184"))
    return utc + tai + mpf("32.184") + mpf("1.657e-3") * sin(m + mpf("1.671e-2") * sin(m))


def chain(body, tdb):
    position, velocity = matrix([0, 0, 0]), matrix([0, 0, 0])
    while body != 0:
        p, v = value(SPK[body], tdb)
        position, velocity, body = position + p, velocity + v, SPK[body][2][1]
    return position, velocity


def axis(i, angle):
    c, s = cos(angle), sin(angle)
    return {1: matrix([[1, 0, 0], [0, c, s], [0, -s, c]]), 2: matrix([[c, 0, -s], [0, 1, 0], [s, 0, c]]),
            3: matrix([[c, s, 0], [-s, c, 0], [0, 0, 1]])}[i]


def moon_me_from_j2000(tdb):
    angles = value(PCK[31006], tdb)[0]
    numbers = re.search(r"TKFRAME_31007_ANGLES\s*=\s*\(([^)]*)\)", FK).group(1).split()
    axes = re.search(r"TKFRAME_31007_AXES\s*=\s*\(([^)]*)\)", FK).group(1).replace(",", " ").split()
    pa_from_me = matrix([[1, 0, 0], [0, 1, 0], [0, 0, 1]])
    for number, i in zip(numbers, axes):
        pa_from_me = pa_from_me * axis(int(i), mpf(number.strip(",")) / 3600 * pi / 180)
    return pa_from_me.T * axis(3, angles[2]) * axis(1, angles[1]) * axis(3, angles[0])


def cross(a, b):
    return matrix([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def angle(a, b):
    return atan2(norm(cross(a, b)), dot(a, b))


def turned(p, v):
    """STELAB, with Rodrigues' formula."""
    h = cross(p / norm(p), v / C)
    phi, k = asin(norm(h)), h / norm(h)
    return p * cos(phi) + cross(k, p) * sin(phi) + k * dot(k, p) * (1 - cos(phi))


def relativistic(p, v):
    """The direction of the light in the observer's own frame (Lorentz), with the same distance."""
    b = v / C
    n = p / norm(p)
    gamma = 1 / sqrt(1 - dot(b, b))
    return norm(p) * (n / gamma + b + (gamma / (gamma + 1)) * dot(b, n) * b) / (1 + dot(b, n))


def suns(mjd, more=False):
    """The Sun in km: NONE, LT, LT+S; with more also light time to the end, and with Lorentz's aberration."""
    tdb = tdb_of(mjd)
    moon, velocity = chain(301, tdb)
    none = chain(10, tdb)[0] - moon
    lt = chain(10, tdb - norm(none) / C)[0] - moon
    found = [none, lt, turned(lt, velocity)]
    if more:
        converged = lt
        for _ in range(8):
            converged = chain(10, tdb - norm(converged) / C)[0] - moon
        found += [converged, relativistic(converged, velocity)]
    return [moon_me_from_j2000(tdb) * p for p in found]


def main():
    print("m, MOON_ME: MJD, correction, x, y, z")
    for mjd in (55289.0, 15021.0, 33447.5, 52000.123456789, 57754.0, 70171.0):
        for name, sun in zip(("None", "LightTime", "LightTimeAndStellar"), suns(mjd)):
            print("[InlineData(%r, Aberration.%s, %s)]" % (mjd, name, ", ".join(mp.nstr(1000 * x, 17) for x in sun)))

    year = int(sys.argv[1]) if len(sys.argv) > 1 else 2010
    arcsecond = pi / 180 / 3600
    effects = {}
    for quarter in range(4 * 365):
        mjd = mjd_of(year, 1) + quarter / 4
        none, lt, lts, converged, lorentz = suns(mjd, more=True)
        for name, a, b in (("LT against NONE", none, lt), ("LT+S against LT", lt, lts), ("LT+S against NONE", none, lts),
                           ("LT against light time to the end", lt, converged), ("LT+S against special relativity", lts, lorentz)):
            effects.setdefault(name, []).append((angle(a, b) / arcsecond, 1000 * norm(a - b), mjd))
    print("%d, every 6 h: least and greatest angle (arcsec), greatest distance (m)" % year)
    for name, found in effects.items():
        least, greatest = min(found), max(found)
        print("%s: %s (MJD %.2f) to %s (MJD %.2f), %s m" % (
            name, mp.nstr(least[0], 8), least[2], mp.nstr(greatest[0], 8), greatest[2], mp.nstr(max(f[1] for f in found), 8)))


if __name__ == "__main__":
    main()

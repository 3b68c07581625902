"""The Sun from Mercury in IAU_MERCURY, from kernels/de421.bsp and the IAU's pole and prime meridian, with 40 digits.

Computes with mpmath; shares nothing with the program or with CSPICE but the definitions. The rotational elements stand here as published
(B. A. Archinal et al., Celest. Mech. Dyn. Astr. 130 (2018) 22, table 1): the angles M1 to M5 with their daily rates, not the centuries
of the text kernel. Prints TDB, the Sun's position (km), its distance, and the sub-solar point.

Run in the repository's folder: /usr/bin/python3 tests/reference/mercury_sun.py
"""
import struct

from mpmath import atan2, cos, matrix, mp, mpf, norm, pi, sin, sqrt

mp.dps = 40
DEGREE = pi / 180
TIMES = {  # seconds of UTC past 2000-01-01T12:00:00, leap seconds not counted; TAI - UTC
    "2010-04-06T20:24:00Z": (mpf(323857440), 34),
    "2020-11-23T06:00:00Z": (mpf(659383200), 37),
}


def segments(path):
    """Body, centre, start, end and doubles of each segment of an SPK."""
    data = open(path, "rb").read()
    base = (struct.unpack_from("<i", data, 76)[0] - 1) * 1024  # DE421 has one summary record
    for i in range(int(struct.unpack_from("<d", data, base + 16)[0])):
        start, end, body, centre, _, kind, first, last = struct.unpack_from("<2d6i", data, base + 24 + i * 40)
        assert kind == 2
        yield body, centre, start, end, struct.unpack_from("<%dd" % (last - first + 1), data, 8 * (first - 1))


def tdb(utc, tai_minus_utc):
    """TDB as NAIF's leap seconds kernel defines it: TT plus K sin E."""
    tt = utc + tai_minus_utc + mpf("32.184")
    m = mpf("6.239996") + mpf("1.99096871e-7") * tt
    return tt + mpf("1.657e-3") * sin(m + mpf("1.671e-2") * sin(m))


def position(bodies, body, time):
    """Sum over the chain of centres up to the solar system's barycentre, km, J2000; Clenshaw's sum of Chebyshev polynomials."""
    total = matrix(3, 1)
    while body != 0:
        _, body, _, _, data = next(s for s in bodies if s[0] == body and s[2] <= time <= s[3])
        first, length, size, count = data[-4:]
        record = min(int((time - mpf(first)) / mpf(length)), int(count) - 1) * int(size)
        x = (time - mpf(data[record])) / mpf(data[record + 1])
        terms = (int(size) - 2) // 3
        for axis in range(3):
            begin = record + 2 + axis * terms
            b1 = b2 = mpf(0)
            for c in reversed(data[begin + 1:begin + terms]):
                b1, b2 = 2 * x * b1 - b2 + mpf(c), b1
            total[axis] += x * b1 - b2 + mpf(data[begin])
    return total


def about(axis, angle):
    """The rotation of a frame about an axis."""
    c, s = cos(angle), sin(angle)
    return matrix([[1, 0, 0], [0, c, s], [0, -s, c]]) if axis == 1 else matrix([[c, s, 0], [-s, c, 0], [0, 0, 1]])


def mercury_from_j2000(time):
    days = time / 86400
    centuries = days / 36525
    m = [(mpf(a) + mpf(b) * days) * DEGREE for a, b in (
        ("174.7910857", "4.092335"), ("349.5821714", "8.184670"), ("164.3732571", "12.277005"), ("339.1643429", "16.369340"),
        ("153.9554286", "20.461675"))]
    amplitudes = [mpf(a) for a in ("0.01067257", "-0.00112309", "-0.00011040", "-0.00002539", "-0.00000571")]
    alpha = mpf("281.0103") - mpf("0.0328") * centuries
    delta = mpf("61.4155") - mpf("0.0049") * centuries
    w = mpf("329.5988") + mpf("6.1385108") * days + sum(a * sin(x) for a, x in zip(amplitudes, m))
    return about(3, w * DEGREE) * about(1, (90 - delta) * DEGREE) * about(3, (90 + alpha) * DEGREE)


def main():
    bodies = list(segments("kernels/de421.bsp"))
    for name, (utc, tai_minus_utc) in TIMES.items():
        time = tdb(utc, tai_minus_utc)
        sun = mercury_from_j2000(time) * (position(bodies, 10, time) - position(bodies, 199, time))
        longitude = atan2(sun[1], sun[0]) / DEGREE
        latitude = atan2(sun[2], sqrt(sun[0] ** 2 + sun[1] ** 2)) / DEGREE
        print(name, "TDB", mp.nstr(time, 18))
        print("  Sun, km:", ", ".join(mp.nstr(x, 17) for x in sun), " distance", mp.nstr(norm(sun), 12))
        print("  sub-solar latitude", mp.nstr(latitude, 12), "longitude", mp.nstr(longitude % 360, 12))


if __name__ == "__main__":
    main()

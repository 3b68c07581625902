"""Reference values for the ephemeris tests, from CSPICE N0067 with the kernels in kernels/.

Run in the repository's folder: python3 tests/reference/ephemeris.py [libcspice.so]
"""
import ctypes
import math
import sys

spice = ctypes.CDLL(sys.argv[1] if len(sys.argv) > 1 else "lib/native/libcspice.so")
double = ctypes.c_double
spice.tkvrsn_c.restype = ctypes.c_char_p
spice.vsep_c.restype = double
print(spice.tkvrsn_c(b"TOOLKIT").decode())
for kernel in ("naif0012.tls", "moon_080317.tf", "moon_assoc_me.tf", "moon_pa_de421_1900-2050.bpc", "de421.bsp"):
    spice.furnsh_c(b"kernels/" + kernel.encode())


def tdb(utc):
    seconds = double()
    spice.utc2et_c(utc.encode(), ctypes.byref(seconds))
    return seconds.value


def sun_km(utc, correction=b"NONE"):
    position, light_time = (double * 3)(), double()
    spice.spkpos_c(b"SUN", double(tdb(utc)), b"MOON_ME", correction, b"MOON", position, ctypes.byref(light_time))
    return position


def rotation(utc):
    rows = (double * 9)()
    spice.pxform_c(b"J2000", b"MOON_ME", double(tdb(utc)), rows)
    return list(rows)


print("Sun in m, MOON_ME")
for utc in ("2010-04-03T00:00:00", "1900-01-01T00:00:00", "1950-06-15T12:00:00", "2050-12-31T00:00:00"):
    print(utc, ["%.15E" % (1000.0 * x) for x in sun_km(utc)])

print("MOON_ME from J2000")
print("2010-04-03T00:00:00", rotation("2010-04-03T00:00:00"))

print("TDB before and at each leap second")
leap_years = ((1972, 1), (1972, 7), (1973, 1), (1974, 1), (1975, 1), (1976, 1), (1977, 1), (1978, 1), (1979, 1), (1980, 1),
              (1981, 7), (1982, 7), (1983, 7), (1985, 7), (1988, 1), (1990, 1), (1991, 1), (1992, 7), (1993, 7), (1994, 7),
              (1996, 1), (1997, 7), (1999, 1), (2006, 1), (2009, 1), (2012, 7), (2015, 7), (2017, 1))
for year, month in leap_years:
    before = "%d-12-31" % (year - 1) if month == 1 else "%d-06-30" % year
    print("[InlineData(%d, %d, %r, %r)]" % (year, month, tdb(before + "T23:59:59.5"), tdb("%d-%02d-01T00:00:00" % (year, month))))

print("docs/deviations.md row 11: what cutting the time to whole seconds costs, at 2010-04-03T00:00:00.999")
cut, whole = sun_km("2010-04-03T00:00:00"), sun_km("2010-04-03T00:00:00.999")
print("%.6f mdeg, %.0f m" % (1e3 * math.degrees(spice.vsep_c(cut, whole)), 1e3 * math.dist(cut, whole)))

print("docs/deviations.md row 23: angle between NONE and LT+S, arcsec, over 2010 in steps of a day")
angles = []
for day in range(365):
    utc = "2010-%03dT00:00:00" % (day + 1)
    angles.append(3600.0 * math.degrees(spice.vsep_c(sun_km(utc), sun_km(utc, b"LT+S"))))
print("least %.3f, greatest %.3f" % (min(angles), max(angles)))

print("MOON_ME_DE421 from MOON_PA_DE421")
rows = (double * 9)()
spice.pxform_c(b"MOON_PA_DE421", b"MOON_ME_DE421", double(0.0), rows)
print(list(rows))

"""When the Sun stands as the benchmark's scenes want it (tests/Msisf.Benchmarks/Definitions/Places.cs), from CSPICE N0067 with the kernels in kernels/.

Run in the repository's folder: python3 tests/reference/benchmark_scenes.py [libcspice.so]
"""
import ctypes
import math
import sys

spice = ctypes.CDLL(sys.argv[1] if len(sys.argv) > 1 else "lib/native/libcspice.so")
double = ctypes.c_double
for kernel in ("naif0012.tls", "moon_080317.tf", "moon_assoc_me.tf", "moon_pa_de421_1900-2050.bpc", "de421.bsp"):
    spice.furnsh_c(b"kernels/" + kernel.encode())


def sun_km(mjd):
    seconds, position, light_time = double(), (double * 3)(), double()
    spice.utc2et_c(("JD %.12f" % (mjd + 2400000.5)).encode(), ctypes.byref(seconds))
    spice.spkpos_c(b"SUN", seconds, b"MOON_ME", b"NONE", b"MOON", position, ctypes.byref(light_time))
    return position


def elevation(mjd, latitude, longitude):
    """Of the Sun over the horizon of the sphere, degrees; by atan2."""
    x, y, z = sun_km(mjd)
    phi, lam = math.radians(latitude), math.radians(longitude)
    up = math.cos(phi) * (x * math.cos(lam) + y * math.sin(lam)) + z * math.sin(phi)
    east = -x * math.sin(lam) + y * math.cos(lam)
    north = -math.sin(phi) * (x * math.cos(lam) + y * math.sin(lam)) + z * math.cos(phi)
    return math.degrees(math.atan2(up, math.hypot(east, north)))


def sunrise(wanted, latitude, longitude, start, end):
    """Bisection between a time with a lower and one with a higher Sun."""
    while end - start > 1e-6:
        middle = 0.5 * (start + end)
        if elevation(middle, latitude, longitude) < wanted:
            start = middle
        else:
            end = middle
    return end


print("far: MJD 55289, Sun %.2f degrees over the horizon of 0 N 45 E" % elevation(55289, 0, 45))
for name, wanted, latitude, longitude in (("nadir", 10, 10, 20), ("oblique", 3, 11.16, 20), ("prime", 10, 0, 0)):
    first = next(day for day in range(55290, 55320)
                 if elevation(day, latitude, longitude) < 0 <= elevation(day + 2, latitude, longitude))
    mjd = round(sunrise(wanted, latitude, longitude, first, first + 4), 2)
    print("%s: MJD %.2f, Sun %.3f degrees over the horizon of %g N %g E, rising" % (
        name, mjd, elevation(mjd, latitude, longitude), latitude, longitude))
for latitude in (90, -90):
    best = max(range(55197, 55562), key=lambda day: elevation(day, latitude, 0))
    print("pole: MJD %d, Sun %.3f degrees over the horizon of %g N" % (best, elevation(best, latitude, 0), latitude))

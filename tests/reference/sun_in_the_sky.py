"""Reference values for the Sun's elevation and azimuth over a point of the Moon, from CSPICE N0067 (azlcpo_c) with the kernels in kernels/.

The Moon is the sphere of 1 737.4 km. Azimuth is clockwise from north. Run in the repository's folder:
python3 tests/reference/sun_in_the_sky.py [libcspice.so]
"""
import ctypes
import math
import sys

spice = ctypes.CDLL(sys.argv[1] if len(sys.argv) > 1 else "lib/native/libcspice.so")
double = ctypes.c_double
spice.tkvrsn_c.restype = ctypes.c_char_p
print(spice.tkvrsn_c(b"TOOLKIT").decode())
for kernel in ("naif0012.tls", "moon_080317.tf", "moon_assoc_me.tf", "moon_pa_de421_1900-2050.bpc", "de421.bsp"):
    spice.furnsh_c(b"kernels/" + kernel.encode())
spice.pdpool_c(b"BODY301_RADII", 3, (double * 3)(1737.4, 1737.4, 1737.4))

for utc in ("2010-04-03T00:00:00", "2036-11-03T06:30:00"):
    tdb, light_time, sun = double(), double(), (double * 3)()
    spice.utc2et_c(utc.encode(), ctypes.byref(tdb))
    spice.spkpos_c(b"SUN", tdb, b"MOON_ME", b"NONE", b"MOON", sun, ctypes.byref(light_time))
    print(utc, "Sun in m, MOON_ME:", ", ".join("%.15E" % (1000.0 * x) for x in sun))
    for latitude, longitude in ((0, 45), (-43.3, 348.8), (26.1, 3.6), (89.9, 120), (-89.5, 222), (60, 180), (10, 300), (0, 270)):
        lat, lon = math.radians(latitude), math.radians(longitude)
        point = (double * 3)(
            1737.4 * math.cos(lat) * math.cos(lon), 1737.4 * math.cos(lat) * math.sin(lon), 1737.4 * math.sin(lat))
        state = (double * 6)()
        spice.azlcpo_c(
            b"ELLIPSOID", b"SUN", tdb, b"NONE", 0, 1, point, b"MOON", b"MOON_ME", state, ctypes.byref(light_time))
        print("    %r, %r: azimuth %.12f, elevation %.12f degrees" % (
            latitude, longitude, math.degrees(state[1]), math.degrees(state[2])))

#!/usr/bin/env python3
"""Reference positions for the orbit frames, from NAIF's CSPICE: conics_c for the orbit, pxform_c for the frames.

usage: orbit_frames.py path/to/libcspice.so path/to/kernels

Prints, for each frame and time, the position in m, MOON_ME of the time. The orbit is given at MJD 55289 (UTC).
"""
import ctypes
import pathlib
import sys

from conics import CSpice

ORBIT = (1.9e6, 0.05, 0.7, 1.1, 0.9, 2.0)  # a, e, omega, Omega, i, M0
EPOCH = b"2010-04-03T00:00:00"
TIMES = [(b"2010-04-03T03:00:00", 10800.0), (b"2010-05-03T00:00:00", 30 * 86400.0)]


def main():
    spice = CSpice(sys.argv[1])
    folder = pathlib.Path(sys.argv[2])
    for name in ["naif0012.tls", "moon_080317.tf", "moon_assoc_me.tf", "moon_pa_de421_1900-2050.bpc", "de421.bsp"]:
        spice.lib.furnsh_c(str(folder / name).encode())

    def moon_me_from_j2000(utc):
        et = ctypes.c_double()
        spice.lib.utc2et_c(utc, ctypes.byref(et))
        matrix = ((ctypes.c_double * 3) * 3)()
        spice.lib.pxform_c(b"J2000", b"MOON_ME", et, matrix)
        spice.check(utc)
        return [list(row) for row in matrix]

    def times(matrix, vector):
        return [sum(m * v for m, v in zip(row, vector)) for row in matrix]

    j2000_from_epoch = [list(column) for column in zip(*moon_me_from_j2000(EPOCH))]
    for utc, seconds in TIMES:
        position = spice.conics(*ORBIT, seconds)[:3]
        print(utc.decode(), "moon-me", *map(repr, position))
        print(utc.decode(), "j2000", *map(repr, times(moon_me_from_j2000(utc), position)))
        print(utc.decode(), "moon-me-epoch", *map(repr, times(moon_me_from_j2000(utc), times(j2000_from_epoch, position))))


if __name__ == "__main__":
    main()

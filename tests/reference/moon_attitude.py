"""The rotation from J2000 to MOON_ME at a time, for clients/basilisk/tests: pxform of CSPICE with kernels/msisf.tm.

Run in the repository's folder: python3 tests/reference/moon_attitude.py 2019-03-04T05:22:47.25 [libcspice.so]
"""
import ctypes
import os
import sys

spice = ctypes.CDLL(os.path.abspath(sys.argv[2] if len(sys.argv) > 2 else "lib/native/libcspice.so"))
os.chdir("kernels")
spice.furnsh_c(b"msisf.tm")
et, matrix = ctypes.c_double(), (ctypes.c_double * 9)()
spice.utc2et_c(sys.argv[1].encode(), ctypes.byref(et))
spice.pxform_c.argtypes = [ctypes.c_char_p, ctypes.c_char_p, ctypes.c_double, ctypes.c_double * 9]
spice.pxform_c(b"J2000", b"MOON_ME", et, matrix)
for row in range(3):
    print(", ".join(f"{number:.17g}" for number in matrix[3 * row:3 * row + 3]))

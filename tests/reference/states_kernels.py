"""Reads the kernels of msis states --format spice by CSPICE, straight by ctypes, and compares them with its CSV.

  states_kernels.py LIBCSPICE KERNELS_OF_PROJECT FOLDER CSV

Prints the greatest difference of positions (parts of their length) and of the rotation's elements; and the field of view of the camera's
kernel (getfov): shape, frame, corners.
"""
import ctypes as c
import math
import os
import sys

library, project, folder, table = (os.path.abspath(path) for path in sys.argv[1:])
spice = c.CDLL(library)
spice.erract_c(b"SET", 0, b"RETURN")
spice.errprt_c(b"SET", 0, b"NONE")


def call(function, *arguments):
    getattr(spice, function)(*arguments)
    if spice.failed_c():
        text = c.create_string_buffer(1841)
        spice.getmsg_c(b"LONG", 1841, text)
        sys.exit(f"{function}: {text.value.decode()}")


os.chdir(project)  # the meta-kernel's paths are relative
call("furnsh_c", b"msisf.tm")
for ending in ("tsc", "tf", "ti", "bsp", "bc"):
    call("furnsh_c", f"{folder}/states.{ending}".encode())

worst_position = worst_rotation = 0.0
with open(table) as lines:
    for line in lines:
        if line[0] in "#t":
            continue
        mjd, x, y, z, qx, qy, qz, qw = (float(number) for number in line.split(",")[:8])
        day = math.floor(mjd)
        utc = 86400.0 * (day - 51544) - 43200.0 + (mjd - day) * 86400.0
        delta, light = c.c_double(), c.c_double()
        call("deltet_c", c.c_double(utc), b"UTC", c.byref(delta))
        et = c.c_double(utc + delta.value)
        position, rotation = (c.c_double * 3)(), (c.c_double * 9)()
        call("spkpos_c", b"MSISF", et, b"MOON_ME", b"NONE", b"MOON", position, c.byref(light))
        call("pxform_c", b"MSISF_CAMERA", b"MOON_ME", et, rotation)
        distance = math.hypot(x, y, z)
        worst_position = max(worst_position, math.dist([1000.0 * number for number in position], (x, y, z)) / distance)

        # The quaternion turns axes of which -x is forward, y right, z up; right, down, forward are y, -z, -x.
        columns = [
            (1 - 2 * (qy * qy + qz * qz), 2 * (qx * qy + qz * qw), 2 * (qx * qz - qy * qw)),
            (2 * (qx * qy - qz * qw), 1 - 2 * (qx * qx + qz * qz), 2 * (qy * qz + qx * qw)),
            (2 * (qx * qz + qy * qw), 2 * (qy * qz - qx * qw), 1 - 2 * (qx * qx + qy * qy))]
        for j, (column, sign) in enumerate(((columns[1], 1), (columns[2], -1), (columns[0], -1))):
            for i in range(3):
                worst_rotation = max(worst_rotation, abs(rotation[3 * i + j] - sign * column[i]))

count, corners, boresight = c.c_int(), (c.c_double * 12)(), (c.c_double * 3)()
shape, frame = c.create_string_buffer(32), c.create_string_buffer(32)
call("getfov_c", c.c_int(-999001), 4, 32, 32, shape, frame, boresight, c.byref(count), corners)
print(worst_position, worst_rotation)
print(shape.value.decode(), frame.value.decode(), *(f"{corner / corners[2]:.12f}" for corner in corners))

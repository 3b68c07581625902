#!/usr/bin/env python3
"""The orientation behind the example scene of thesis section 5.3, from its printed location and camera vectors.

The printed direction stands 39.9999994 degrees off nadir and the printed right vector is perpendicular to the location, both
within the rounding of 7 decimals: the camera looks to nadir and is then pitched by 40 degrees about its right axis. That
leaves one free number, the azimuth of the right axis, which is taken from the printed right vector. All nine printed
components must then come out of (location, azimuth, 40 degrees, FOV 90, 1900 x 1200).

    python3 tests/reference/camera_section_5_3.py
"""
from mpmath import mp, mpf, nstr, radians, tan, cos, sin, acos, degrees

from illumination import add, cross, dot, norm, quaternion_looking, rotate, scale, unit
from mpmath import atan2

mp.dps = 50
LOCATION = [mpf(c) for c in ("125.340753", "18.2633239", "1793.96436")]
RIGHT = [mpf(c) for c in ("0.2277842", "-1.5668627", "0.0000365")]
UP = [mpf(c) for c in ("0.8009921", "0.1164587", "0.5872385")]
DIRECTION = [mpf(c) for c in ("0.4600632", "0.0668672", "-0.6407861")]


def main():
    nadir = unit(scale(-1, LOCATION))
    print("off nadir, degrees:", nstr(degrees(acos(dot(nadir, unit(DIRECTION)))), 12))
    print("right . location / lengths:", nstr(dot(RIGHT, LOCATION) / norm(RIGHT) / norm(LOCATION), 3))

    right = unit(add(RIGHT, scale(-dot(RIGHT, nadir), nadir)))
    nadir_up = cross(right, nadir)
    pitch = radians(40)
    forward = add(scale(cos(pitch), nadir), scale(sin(pitch), nadir_up))

    helper = [0, 0, 1] if abs(forward[2]) < 0.9 else [1, 0, 0]
    side = unit(cross(forward, helper))
    roll = atan2(dot(right, cross(side, forward)), dot(right, side))
    q = quaternion_looking(forward, roll)
    print("quaternion qx qy qz q0:", *(repr(c) for c in q))

    aspect = mpf(1900) / 1200
    q = [mpf(c) for c in q]
    for name, printed, computed in (
        ("right", RIGHT, rotate(q, [0, aspect, 0])),
        ("up", UP, rotate(q, [0, 0, 1])),
        ("direction", DIRECTION, rotate(q, [-aspect / 2 / tan(radians(45)), 0, 0])),
    ):
        print(name, *(nstr(c, 12) for c in computed), "| printed - computed, 1e-7:",
              *(nstr((a - b) * mpf(10) ** 7, 3) for a, b in zip(printed, computed)))


if __name__ == "__main__":
    main()

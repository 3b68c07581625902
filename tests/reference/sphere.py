#!/usr/bin/env python3
"""Where the ray from the Sun of thesis section 9.2 to (1e6, 1.2e6, 5e5) m meets the reference sphere: 50 digits, and eq. 8.4 in doubles.

    python3 tests/reference/sphere.py
"""
import math

from mpmath import mp, mpf, nstr, sqrt

mp.dps = 50
SUN = (1.074955473280880e11, -1.042430734878980e11, 4.036164305561260e9)
TARGET = (1e6, 1.2e6, 5e5)


def hit(origin, direction, root):
    b = sum(o * d for o, d in zip(origin, direction))
    a = sum(d * d for d in direction)
    c = sum(o * o for o in origin) - type(b)(1737400) ** 2
    t = (-b - root(b * b - a * c)) / a
    return [o + t * d for o, d in zip(origin, direction)]


direction = [t - s for t, s in zip(TARGET, SUN)]  # in doubles, as the program has it
exact = hit([mpf(c) for c in SUN], [mpf(c) for c in direction], sqrt)
naive = hit(SUN, direction, math.sqrt)
print("exact:", *(nstr(c, 20) for c in exact))
print("eq. 8.4 in doubles is off by", nstr(sqrt(sum((mpf(n) - e) ** 2 for n, e in zip(naive, exact))), 3), "m")

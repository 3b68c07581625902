#!/usr/bin/env python3
"""Sines, cosines and arc tangents, rounded to doubles from 300 bits, and the parts of pi / 2, for TrigonometryTests and Trigonometry."""

from mpmath import atan2, cos, mp, mpf, pi, sin

mp.prec = 300
ANGLES = (1e-9, 0.1, 0.785398163397448, 1.0, 1.5707963267948966, 2.5, 3.141592653589793, -4.71238898038469, 100.0, 6283.185, -0.3)
VECTORS = ((1.0, 3.0), (-2e6, 1e6), (1e-9, -1.0), (0.3, 1e-20), (-7e-5, 3.3), (5.0, 5.0), (1.25e6, -3e5))

high = float(pi / 2)
low = float(pi / 2 - mpf(high))
print(repr(high), repr(low), repr(float(pi / 2 - mpf(high) - mpf(low))))
for angle in ANGLES:
    print(repr(angle), repr(float(sin(mpf(angle)))), repr(float(cos(mpf(angle)))))
for y, x in VECTORS:
    print(repr(y), repr(x), repr(float(atan2(mpf(y), mpf(x)))))

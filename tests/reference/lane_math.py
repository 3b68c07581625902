#!/usr/bin/env python3
"""Coefficients of the polynomials of src/Msisf.Core/Numerics/LaneMath.cs: interpolation at Chebyshev nodes, 60 digits.

    python3 tests/reference/lane_math.py
"""
import mpmath as mp

mp.mp.dps = 60


def fit(name, function, end, degree):
    """Coefficients in powers of x on [0, end], lowest first, and the greatest relative error of their rounded values."""
    count = degree + 1
    nodes = [(mp.cos(mp.pi * (2 * k + 1) / (2 * count)) + 1) / 2 * end for k in range(count)]
    matrix = mp.matrix(count, count)
    values = mp.matrix(count, 1)
    for i, node in enumerate(nodes):
        for j in range(count):
            matrix[i, j] = node ** j
        values[i] = function(node)
    rounded = [float(value) for value in mp.lu_solve(matrix, values)]
    error = max(abs(sum(mp.mpf(c) * x ** j for j, c in enumerate(rounded)) / function(x) - 1)
                for x in (mp.mpf(k) * end / 2000 for k in range(1, 2001)))
    print(name, mp.nstr(error, 3), *map(repr, rounded), sep='\n    ')


def from_minus(name, function, end, degree):
    """The same on [-end, end], by absolute error."""
    count = degree + 1
    nodes = [mp.cos(mp.pi * (2 * k + 1) / (2 * count)) * end for k in range(count)]
    matrix = mp.matrix(count, count)
    values = mp.matrix(count, 1)
    for i, node in enumerate(nodes):
        for j in range(count):
            matrix[i, j] = node ** j
        values[i] = function(node)
    rounded = [float(value) for value in mp.lu_solve(matrix, values)]
    error = max(abs(sum(mp.mpf(c) * x ** j for j, c in enumerate(rounded)) - function(x))
                for x in (mp.mpf(k) * end / 2000 + mp.mpf(10) ** -20 for k in range(-2000, 2001)))
    print(name, mp.nstr(error, 3), *map(repr, rounded), sep='\n    ')


def arcsin_over_sine_cosine(x):
    return mp.asin(mp.sqrt(x)) / mp.sqrt(x * (1 - x))


fit('arcsin(s) / (s cos) of s^2', arcsin_over_sine_cosine, mp.mpf(1) / 2, 17)
fit('2 artanh(s) / s of s^2', lambda x: 2 * mp.atanh(mp.sqrt(x)) / mp.sqrt(x), mp.mpf(0.0403), 7)
from_minus('(e^x - 1 - x) / x^2', lambda x: mp.hyp1f1(1, 3, x) / 2, mp.log(2) / 2, 8)

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


fit('arcsin(s) / s of s^2', lambda x: mp.asin(mp.sqrt(x)) / mp.sqrt(x), mp.mpf(1) / 2, 17)
fit('2 artanh(s) / s of s^2', lambda x: 2 * mp.atanh(mp.sqrt(x)) / mp.sqrt(x), mp.mpf(1) / 9, 10)

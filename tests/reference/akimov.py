#!/usr/bin/env python3
"""Radiance factors of Akimov's law (Shkuratov et al. 2011) as printed, in photometric longitude and latitude, by NumPy's long doubles.

    python3 tests/reference/akimov.py > tests/golden/akimov.tsv

The geometry is drawn in these coordinates, so that nothing is inverted here: cos e = cos(beta) cos(gamma),
cos i = cos(beta) cos(gamma - a). One degree off limb and terminator, phase angles from 0.1 to 170 degrees.
"""
import numpy as np

SEED = 20111326
REAL = np.longdouble
PI = REAL('3.14159265358979323846264338327950288')
SLOPES = (REAL('0.7'), REAL(0), REAL('2.5'))


def akimov(a, gamma, beta, slope):
    rest = PI - a
    return (np.exp(-slope * a) * np.cos(a / 2) * np.cos(PI / rest * (gamma - a / 2)) * np.cos(beta) ** (a / rest) / np.cos(gamma))


draw = np.random.default_rng(SEED)
degrees = PI / 180
a = np.concatenate([np.geomspace(0.1, 10, 40), draw.uniform(10, 170, 158), [0.1, 170]]).astype(REAL) * degrees
share = np.concatenate([draw.uniform(0, 1, 196), [0, 1, 0, 1]]).astype(REAL)
gamma = a - PI / 2 + degrees + share * (PI - a - 2 * degrees)
beta = draw.uniform(-89, 89, 200).astype(REAL) * degrees
print('# cos i, cos e, haversine of phase; I/F for mu = ' + ', '.join(f'{float(slope)}' for slope in SLOPES) + ' (albedo 1)')
for row in zip(np.cos(beta) * np.cos(gamma - a), np.cos(beta) * np.cos(gamma), np.sin(a / 2) ** 2,
               *(akimov(a, gamma, beta, slope) for slope in SLOPES)):
    print('\t'.join(np.format_float_scientific(value, precision=18, unique=False) for value in row))

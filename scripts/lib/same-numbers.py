#!/usr/bin/env python3
"""Compares two folders of outputs from different systems: bytes, or the numbers of texts, within one unit of the 16th digit, of arrays
within some in the last place.

    same-numbers.py ONE OTHER

The 16th digit counts of the largest number in a line: a vector's small components come from its large ones. The letters of annotated
pictures are drawn by the system, and the manifest has the checksums.
"""

import pathlib
import re
import sys
from decimal import Decimal

import numpy

ARRAY_STEPS = 4  # units in the last place of angles in degrees: an arc tangent, 180 / pi, and a difference
NUMBER = re.compile(r'[+-]?\d+\.\d+(?:[eE][+-]?\d+)?')
LEFT_OUT = ('.jsonl', '.annotated.png')


def unit(numbers):
    """One unit of the 16th digit of the largest number, or of the last digit of one with fewer."""
    largest = max(abs(number) for number in numbers)
    return Decimal(1).scaleb(max(largest.adjusted() - 15, min(number.as_tuple().exponent for number in numbers)))


def same_text(one, other):
    lines = one.splitlines(), other.splitlines()
    if [NUMBER.sub('#', line) for line in lines[0]] != [NUMBER.sub('#', line) for line in lines[1]]:
        return 'other words'
    for a, b in zip(*lines):
        numbers = [[Decimal(number) for number in NUMBER.findall(line)] for line in (a, b)]
        if a != b and max(abs(x - y) for x, y in zip(*numbers)) > unit(numbers[0]):
            return f'{a.strip()} and {b.strip()}'
    return None


def same_array(one, other):
    a, b = numpy.load(one), numpy.load(other)
    if a.dtype != b.dtype or a.shape != b.shape or not numpy.array_equal(numpy.isnan(a), numpy.isnan(b)):
        return 'another array'
    known = ~numpy.isnan(a)
    steps = numpy.max(numpy.abs(a[known] - b[known]) / numpy.spacing(numpy.abs(a[known])))
    return None if steps <= ARRAY_STEPS else f'{steps} units in the last place'


def difference(one, other):
    a, b = one.read_bytes(), other.read_bytes()
    if a == b:
        return None
    if one.suffix == '.npy':
        return same_array(one, other)
    try:
        return same_text(a.decode(), b.decode())
    except UnicodeDecodeError:
        return 'other bytes'


def main(one, other):
    folders = [pathlib.Path(one), pathlib.Path(other)]
    names = [
        {path.relative_to(folder).as_posix() for path in folder.rglob('*') if path.is_file() and not path.name.endswith(LEFT_OUT)}
        for folder in folders
    ]
    wrong = sorted(names[0] ^ names[1])
    for name in sorted(names[0] & names[1]):
        said = difference(folders[0] / name, folders[1] / name)
        if said:
            wrong.append(f'{name}: {said}')
    print('\n'.join(wrong), end='\n' if wrong else '')
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:]))

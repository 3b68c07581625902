#!/usr/bin/env python3
"""Compares two folders of outputs from different systems: bytes, or for texts and arrays their numbers, within one unit of the 16th digit.

    same-numbers.py ONE OTHER

Sines, cosines and arc tangents of two systems differ by one unit in the last place of a double (2.2e-16 of the number, half a unit of the
16th digit, before it is rounded to 16 digits). The letters of annotated pictures are drawn by the system. The manifest has the checksums.
"""

import pathlib
import re
import sys
from decimal import Decimal

NUMBER = re.compile(r'[+-]?\d+\.\d+(?:[eE][+-]?\d+)?')
LEFT_OUT = ('.jsonl', '.annotated.png')


def unit(number):
    """One unit of the 16th digit of a number, or of its last digit if it is written with fewer."""
    return Decimal(1).scaleb(max(number.as_tuple().exponent, number.adjusted() - 15))


def same_text(one, other):
    if NUMBER.sub('#', one) != NUMBER.sub('#', other):
        return 'other words'
    for a, b in zip(NUMBER.findall(one), NUMBER.findall(other)):
        if a != b and abs(Decimal(a) - Decimal(b)) > max(unit(Decimal(a)), unit(Decimal(b))):
            return f'{a} and {b}'
    return None


def difference(one, other):
    a, b = one.read_bytes(), other.read_bytes()
    if a == b:
        return None
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

"""The order of a pixel's 8 x 8 samples (src/Msisf.Core/Render/Visibility/SamplePattern.cs).

A permutation of the eight columns, and its eight shifts by exclusive-or, are eight sets of eight samples with one in every row and
column. For random straight edges through a pixel, half of them nearly along the axes and diagonals, this prints the rms difference of
the covered part from that of all 64 samples, over the contrast, with one, two and four sets; the best permutation, and the best order.

Usage: python3 sample_pattern.py
"""

import itertools
import math
import random

SIDE = 8
EDGES = 1500

random.seed(7)
GRID = [(i + 0.5) / SIDE - 0.5 for i in range(SIDE)]


def edge(number):
    """The samples on one side of a random edge, as bits."""
    angle = random.uniform(0.0, 2.0 * math.pi) if number % 2 else random.randrange(4) * math.pi / 4.0 + random.gauss(0.0, 0.05)
    offset = random.uniform(-0.7, 0.7)
    x, y = math.cos(angle), math.sin(angle)
    return sum(
        1 << (SIDE * row + column) for row in range(SIDE) for column in range(SIDE) if x * GRID[column] + y * GRID[row] < offset)


def samples(permutation, shift):
    return sum(1 << (SIDE * row + (permutation[row] ^ shift)) for row in range(SIDE))


def error(chosen):
    count = chosen.bit_count()
    return math.sqrt(sum(((mask & chosen).bit_count() / count - mask.bit_count() / 64.0) ** 2 for mask in MASKS) / EDGES)


MASKS = [edge(number) for number in range(EDGES)]
PERMUTATIONS = random.sample([p for p in itertools.permutations(range(SIDE)) if p[0] == 0], 700)
PERMUTATIONS.append((0, 4, 2, 6, 1, 5, 3, 7))
ranked = sorted(set(PERMUTATIONS), key=lambda p: min(error(samples(p, shift)) for shift in (0, 3, 5)))
results = []
for p in ranked[:12]:
    sets = [samples(p, shift) for shift in range(SIDE)]
    for a, b in itertools.permutations(range(SIDE), 2):
        results.append((error(sets[a]) / 0.06 + error(sets[a] | sets[b]) / 0.03, p, a, b))

_, best, a, b = min(results)
sets = [samples(best, shift) for shift in range(SIDE)]
rest = [shift for shift in range(SIDE) if shift not in (a, b)]
c, d = min(itertools.combinations(rest, 2), key=lambda pair: error(sets[a] | sets[b] | sets[pair[0]] | sets[pair[1]]))
print("columns of the rows", best, "shifts", [a, b, c, d] + [shift for shift in rest if shift not in (c, d)])
print(f"8: {error(sets[a]):.4f}  16: {error(sets[a] | sets[b]):.4f}  32: {error(sets[a] | sets[b] | sets[c] | sets[d]):.4f}")

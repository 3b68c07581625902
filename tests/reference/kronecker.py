"""Chooses the constants of AdditiveRecurrence: python3 recurrence.py, some ten seconds; needs NumPy.

n steps of a constant fill a circle evenly, whatever n is, if the partial quotients of its continued fraction are small. From random
constants those are kept whose own quotients are, and those of their sums and differences with each constant that was chosen before: at
most 10 after a denominator up to 16, 16 up to 128, 32 up to 1024.
"""
import numpy as np

LIMITS = ((1, 100.0), (2, 50.0), (4, 25.0), (64, 22.0), (256, 60.0))


def is_even(number):
    """Whether the quotients of numbers in [0, 1) are within the limits."""
    rest, before, denominator, kept = number.copy(), np.zeros_like(number), np.ones_like(number), np.ones(number.shape, bool)
    for _ in range(8):
        inverse = 1.0 / np.maximum(rest, 1e-12)
        quotient = np.floor(inverse)
        allowed = np.full(number.shape, np.inf)
        for largest, limit in reversed(LIMITS):
            allowed[denominator <= largest] = limit
        kept &= quotient <= allowed
        before, denominator = denominator, quotient * denominator + before
        rest = inverse - quotient
    return kept


random = np.random.default_rng(20120222)
pool = random.random(4_000_000)
pool = pool[is_even(pool)]
chosen = []
while len(chosen) < 16:
    fits = [is_even((pool + number) % 1.0) & is_even((pool - number) % 1.0) for number in pool[:12]]
    best = max(range(len(fits)), key=lambda index: fits[index].sum())
    chosen.append(pool[best])
    pool = pool[fits[best]]
    print(len(chosen), len(pool))
print(", ".join(f"0x{int(number * 2.0**53) << 11 | 1:016X}" for number in chosen))

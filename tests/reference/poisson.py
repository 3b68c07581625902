#!/usr/bin/env python3
"""Error of the expansion of the inverse Poisson distribution in PoissonDeviate, in parts of its bound; and some inverses.

needs: python3, mpmath. Prints for each mean the worst error over normal deviates in steps of 0.1; all must be below 1.
The bound is used for deviates up to 3 and up to a sixth of the root of the mean. Then n for some means and uniform numbers.
"""
import mpmath as mp

mp.mp.dps = 40


def inverse(u, mean, start):
    """x with Q(x, mean) = u; the number of events is its whole part."""
    def difference(x):
        return mp.gammainc(x, mean, mp.inf, regularized=True) - u
    return mp.findroot(difference, (start, start + mp.mpf("0.01")), tol=1e-25)


def expansion(mean, w):
    root = mp.sqrt(mean)
    x = mean + root * w + (mp.mpf(1) / 3 + w * w / 6) * (1 - w / (12 * root))
    bound = (mp.mpf(1) / 40 + w * w / 80 + w ** 4 / 160) / mean
    return x, bound


for mean in (10, 11, 13, 17, 23, 40, 100, 400, 1600):
    mean = mp.mpf(mean)
    worst = mp.mpf(0)
    for step in range(-70, 71):
        w = mp.mpf(step) / 10
        if abs(w) > 3 and w * w > mean / 36:
            continue
        x, bound = expansion(mean, w)
        ratio = (inverse(mp.ncdf(w), mean, x) - x) / bound
        worst = max(worst, abs(ratio))
    print(f"mean {float(mean):6.0f}: worst error {float(worst):.3f} of the bound")

for mean, u in ((0.3, 0.5), (0.3, 0.999), (9.99, 0.2), (10, 0.0001), (10, 0.9999999), (37.5, 0.5), (1000, 1e-9), (1000, 0.3),
                (123456.7, 0.75), (4e6, 0.9999)):
    mean, u = mp.mpf(mean), mp.mpf(u)
    x, _ = expansion(mean, mp.sqrt(2) * mp.erfinv(2 * u - 1))
    n = max(0, int(mp.floor(x)) - 4)
    while mp.gammainc(n + 1, mean, mp.inf, regularized=True) < u:
        n += 1
    print(f"inverse({float(mean)!r}, {float(u)!r}) = {n}")

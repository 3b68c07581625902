# Reference values of PortableMathTests, with mpmath: python3 tests/reference/portable_math.py
from mpmath import mp, mpf, sin, cos, log, pi

mp.dps = 30
for degrees in ("0.125", "29.375", "45", "89.9921875", "134.5", "270.25", "-90.25", "359.875"):
    x = mpf(degrees) * pi / 180
    print("sin, cos", degrees, mp.nstr(sin(x), 20), mp.nstr(cos(x), 20))
for base, exponent in (("0.0442", "-1.83"), ("150", "0.301"), ("7.5", "1.01"), ("27.88", "-0.24")):
    print("pow", base, exponent, mp.nstr(mpf(base) ** mpf(exponent), 20))
for value in ("3", "0.7", "1740000"):
    print("log2", value, mp.nstr(log(mpf(value), 2), 20))
# Slopes at other baselines than 17 m: tan(s) = tan(s17) (L / 17)^(H - 1)
for s17, hurst in (("7.5", "0.95"), ("2", "0.76")):
    t = mp.tan(mpf(s17) * pi / 180) * (mpf("473.80") / 17) ** (mpf(hurst) - 1)
    print("slope at 473.80 m", s17, hurst, mp.nstr(mp.atan(t) * 180 / pi, 8))

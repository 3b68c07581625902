"""The largest differences (s) of TAI, TT and GPS time from those of Astropy (erfa), for UTC in the first column of a file.

moments.py FILE: lines of UTC, TAI, TT, TDB and GPS time in ISO, to the nanosecond. TDB is not compared: erfa's is another formula.
"""
import sys
import warnings

import numpy as np
from astropy.time import Time
from astropy.utils import iers

iers.conf.auto_download = False
warnings.simplefilter("ignore")
utc, tai, tt, _, gps = zip(*(line.split() for line in open(sys.argv[1], encoding="ascii")))
moments = Time(list(utc), format="isot", scale="utc")


def worst(expected, found):
    """Both are two doubles of days, so that their difference is exact to some 1e-12 s."""
    days = (found.jd1 - expected.jd1) + (found.jd2 - expected.jd2)
    return np.max(np.abs(days)) * 86400.0


print(worst(moments.tai, Time(list(tai), format="isot", scale="tai")))
print(worst(moments.tt, Time(list(tt), format="isot", scale="tt")))
gps_from_epoch = Time(list(gps), format="isot", scale="tai") - Time("1980-01-06T00:00:00", scale="tai")
since = moments.tai - Time("1980-01-06T00:00:19", scale="tai")
print(np.max(np.abs((gps_from_epoch - since).sec)))
print(worst(moments.tai.utc, moments))

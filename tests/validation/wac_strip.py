"""Reads the LROC WAC strip of ../shared/validation: its pixels, and the camera's position and pointing at each framelet."""
import pathlib
import re

import numpy as np

BANDS_NM = (415, 566, 604, 643, 689)
FRAMELET_LINES = 14
REDUCTION = 32  # pixels of the instrument in each direction that make one pixel of the strip
SAMPLES = 704
ASTRONOMICAL_UNIT_KM = 149597870.7  # IAU 2012
NULL_BELOW = -1e30  # ISIS: special pixels are below -3.4e38


class Strip:
    """The strip, as an ISIS cube with its tables has it.

    dn         DN, [band, line, sample]; NaN where the file has none
    positions  m, MOON_ME, one for each framelet that was kept
    moon_from_instrument  rotations of these framelets: +z is the line of sight, +y the direction of the samples
    mjd_utc    times of these framelets
    period_s   s from one of them to the next
    sun_distance_au  distance of the Sun from the Moon's centre
    """

    def __init__(self, path):
        data = pathlib.Path(path).read_bytes()
        label = data[:65536].split(b"\0")[0].decode("latin-1")
        core = re.search(r"Samples = (\d+)\s+Lines   = (\d+)\s+Bands   = (\d+)", label)
        samples, lines, bands = (int(size) for size in core.groups())
        self.dn = np.frombuffer(data, "<f4", bands * lines * samples, 65536).reshape(bands, lines, samples).astype(float)
        self.dn[self.dn < NULL_BELOW] = np.nan
        self.exposure_ms = _number(label, "ExposureDuration")
        self.delay_s = _number(label, "InterframeDelay") / 1000.0
        self.period_s = 2.0 * self.delay_s
        self.framelets = np.arange(0, int(_number(label, "NumFramelets")), 2)
        pointing = _table(data, label, "InstrumentPointing")
        position = _table(data, label, "InstrumentPosition")
        body = _table(data, label, "BodyRotation")

        # The tables begin in the middle of the first framelet's exposure.
        start_et = _number(_object(label, "InstrumentPointing"), "CkTableStartTime")
        ets = start_et + self.framelets * self.delay_s
        instrument_from_j2000 = _constant(label, "InstrumentPointing") @ _rotations(_slerp(pointing, ets))
        moon_from_j2000 = _constant(label, "BodyRotation") @ _rotations(_slerp(body, ets))
        self.moon_from_instrument = moon_from_j2000 @ instrument_from_j2000.transpose(0, 2, 1)
        self.positions = 1000.0 * np.einsum("nij,nj->ni", moon_from_j2000, _hermite(position, ets))
        sun = _table(data, label, "SunPosition")
        self.sun_distance_au = np.linalg.norm(sun[0, :3]) / ASTRONOMICAL_UNIT_KM
        start_utc = np.datetime64(re.search(r"StartTime\s+= (\S+)", label)[1])
        start_mjd = (start_utc - np.datetime64("1858-11-17T00:00:00")) / np.timedelta64(1, "s")
        self.mjd_utc = (start_mjd + self.exposure_ms / 2000.0 + self.framelets * self.delay_s) / 86400.0

    def reduce(self, framelet_images):
        """Means over 32 x 32 pixels of framelets [framelet, 14, 704], as ISIS's `reduce` made them: [line, sample]."""
        lines = self.dn.shape[1]
        sums = np.zeros((lines, SAMPLES // REDUCTION))
        counts = np.zeros(lines)
        for framelet, image in zip(self.framelets, framelet_images):
            columns = image.reshape(FRAMELET_LINES, -1, REDUCTION).mean(axis=2)
            for row in range(FRAMELET_LINES):
                line = (framelet * FRAMELET_LINES + row) // REDUCTION
                if line < lines:
                    sums[line] += columns[row]
                    counts[line] += 1
        with np.errstate(invalid="ignore"):
            return sums / counts[:, None]


def _object(label, table):
    return re.search(rf"Object = Table\s+Name\s+= {table}\n.*?\nEnd_Object", label, re.S)[0]


def _number(label, key):
    return float(re.search(rf"\b{key}\s+= \(?([-+0-9.eE]+)", label)[1])


def _constant(label, table):
    text = re.search(r"ConstantRotation\s+= \((.*?)\)", _object(label, table), re.S)[1]
    return np.array([float(number) for number in text.split(",")]).reshape(3, 3)


def _table(data, label, name):
    table = _object(label, name)
    start, size, records = (int(_number(table, key)) for key in ("StartByte", "Bytes", "Records"))
    return np.frombuffer(data, "<f8", size // 8, start - 1).reshape(records, -1)


def _slerp(table, ets):
    """Quaternions (scalar first) at the times, from a table of quaternion, angular velocity, time."""
    times = table[:, 7]
    at = np.clip(np.searchsorted(times, ets) - 1, 0, len(times) - 2)
    a, b = table[at, :4], table[at + 1, :4]
    cosine = np.sum(a * b, axis=1)
    b = np.where(cosine[:, None] < 0.0, -b, b)
    angle = np.arctan2(np.linalg.norm(b - a, axis=1), np.linalg.norm(b + a, axis=1)) * 2.0
    t = (ets - times[at]) / (times[at + 1] - times[at])
    with np.errstate(invalid="ignore", divide="ignore"):
        first = np.where(angle < 1e-9, 1.0 - t, np.sin((1.0 - t) * angle) / np.sin(angle))
        second = np.where(angle < 1e-9, t, np.sin(t * angle) / np.sin(angle))
    q = first[:, None] * a + second[:, None] * b
    return q / np.linalg.norm(q, axis=1)[:, None]


def _rotations(q):
    """SPICE's matrices of quaternions: they turn vectors of the base frame into the other frame."""
    w, x, y, z = q.T
    return np.stack([
        1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
        2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
        2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)], axis=1).reshape(-1, 3, 3)


def _hermite(table, ets):
    times = table[:, 6]
    at = np.clip(np.searchsorted(times, ets) - 1, 0, len(times) - 2)
    h = (times[at + 1] - times[at])[:, None]
    t = (ets - times[at])[:, None] / h
    p0, p1, v0, v1 = table[at, :3], table[at + 1, :3], table[at, 3:6], table[at + 1, 3:6]
    return ((2 * t**3 - 3 * t**2 + 1) * p0 + (t**3 - 2 * t**2 + t) * h * v0
            + (3 * t**2 - 2 * t**3) * p1 + (t**3 - t**2) * h * v1)


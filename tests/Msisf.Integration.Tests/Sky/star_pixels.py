"""Where images show stars, by ERFA and by CSPICE's stelab, from the files of a run: prints for each folder how many stars were
compared and the greatest difference from each of the two, px.

  /usr/bin/python3 -B star_pixels.py REPOSITORY CATALOGUE LIBCSPICE FOLDER=MODE[:ATTITUDE[:VX,VY,VZ]] ...

MODE is that of the ground: none, lt or lt+s. ATTITUDE: quaternion (x, y, z, w) of the real camera, J2000 from camera axes (looks along -x, y
right, z up), needed with lt+s. VX, VY, VZ: velocity of the camera relative to the Moon, m/s, J2000.
"""
import csv
import ctypes
import glob
import math
import os
import re
import sys
import xml.etree.ElementTree as ET

import erfa
import numpy as np

repository, catalogue, library = sys.argv[1:4]
cspice = ctypes.CDLL(library)
os.chdir(repository)
sys.path.insert(0, os.path.join(repository, "tests", "reference"))
import sun_aberration as kernels  # reads the kernels with 40 digits; shares nothing with the program

AU = 149597870.7
C = 299792.458
RADIUS = 1737400.0


def numbers(matrix, rows, columns):
    return np.array([[float(matrix[i, j]) for j in range(columns)] for i in range(rows)])


def rotation(q):
    x, y, z, w = q
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def brown(x, y, k1, k2, p1, p2, k3, *zeros):
    assert not any(zeros)
    r2 = x * x + y * y
    radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
    return (x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x), y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y)


def tdb_at(root):
    return kernels.tdb_of(kernels.mpf(root.findtext("GeneralInformation/SimulationTime/MJD").strip("+")))


def light_seconds(position, forward):
    along = -position @ forward
    miss = np.linalg.norm(position + along * forward)
    distance = along - math.sqrt(RADIUS ** 2 - miss ** 2) if along > 0 and miss < RADIUS else np.linalg.norm(position) - RADIUS
    return distance / (1000 * C)


def by_erfa(u, v):
    b = v / C
    return erfa.ab(u, b, 1e12, math.sqrt(1 - b @ b))


def by_stelab(u, v):
    """CSPICE's aberration, without special relativity: up to 0.5 mas from ERFA's."""
    vector = ctypes.c_double * 3
    seen = vector()
    cspice.stelab_c(vector(*u), vector(*v), seen)
    return np.array(seen)


def compare(folder, mode, attitude, velocity):
    count, greatest = 0, [0.0, 0.0]
    for path in sorted(glob.glob(os.path.join(folder, "*.xml"))):
        root = ET.fromstring(re.sub(r"<!DOCTYPE.*?\]>", "", open(path).read(), flags=re.S))
        tdb = tdb_at(root)
        moon, moon_velocity = (numbers(m, 3, 1)[:, 0] for m in kernels.chain(301, tdb))
        camera = root.find("GeneralInformation/Camera")
        k = np.array(camera.findtext("K").split(), float).reshape(3, 3)
        r = np.array(camera.findtext("R").split(), float).reshape(3, 3)
        t = np.array(camera.findtext("t").split(), float)
        position = -r.T @ t
        lens = camera.find("Distortion")
        if mode == "lt+s":
            # camera axes are -x forward, y right, z up; of OpenCV x right, y down, z forward
            camera_from_j2000 = np.array([[0, 1, 0], [0, 0, -1], [-1, 0, 0]]) @ rotation(attitude).T
            v = moon_velocity + np.array(velocity) / 1000
        else:
            seconds = 0.0 if mode == "none" else light_seconds(position, r[2])
            camera_from_j2000 = r @ numbers(kernels.moon_me_from_j2000(tdb - kernels.mpf(seconds)), 3, 3)
            v = moon_velocity if mode == "none" else np.zeros(3)
        years = float(tdb) / (86400 * 365.25)
        seen = {row["id"]: row for row in csv.DictReader(open(path[:-4] + ".stars.csv"))}
        for row in csv.DictReader(open(catalogue)):
            ra, dec = math.radians(float(row["ra_deg"])), math.radians(float(row["dec_deg"]))
            mas = math.pi / 648e6
            u = erfa.pmpx(ra, dec, float(row["pm_ra_cosdec_mas_per_year"]) * mas / math.cos(dec),
                          float(row["pm_dec_mas_per_year"]) * mas, max(0.0, float(row["parallax_mas"])) / 1000, 0.0,
                          years - (float(row["epoch"]) - 2000), moon / AU)
            name = "HIP " + row["hip"]
            for oracle, aberrated in enumerate((by_erfa, by_stelab)):
                s = camera_from_j2000 @ aberrated(u, v)
                # a lens may show directions far outside its field again
                if s[2] <= 0.05 or math.hypot(s[0] / s[2], s[1] / s[2]) >= 1.2:
                    continue
                x, y = s[0] / s[2], s[1] / s[2]
                if lens is not None:
                    x, y = brown(x, y, *(float(c) for c in lens.text.split()))
                h, w, _ = k @ (x, y, 1) + 1
                width, height = int(camera.get("width")), int(camera.get("height"))
                if 0.6 < h < width + 0.4 and 0.6 < w < height + 0.4:
                    assert name in seen, "%s: %s is missing at %f, %f" % (path, name, h, w)
                    greatest[oracle] = max(greatest[oracle], abs(h - float(seen[name]["h"])), abs(w - float(seen[name]["v"])))
                    count += oracle == 0
    print("%s %d %.3g %.3g" % (os.path.basename(folder), count, *greatest))


for argument in sys.argv[4:]:
    folder, _, rest = argument.rpartition("=")
    parts = rest.split(":")
    compare(folder, parts[0], [float(x) for x in parts[1].split(",")] if len(parts) > 1 else None,
            [float(x) for x in parts[2].split(",")] if len(parts) > 2 else None)

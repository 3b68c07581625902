"""Median slopes at 17 m of the ground that --refine invents.

python3 tests/reference/refine_slopes.py PATH-OF-MSIS LDEM_4.LBL [PLACES]

Needs numpy. Of each place one image from 230 m over the ground, looking down, whose pixels are some 4.25 m wide: the heights of the layer
`position` four pixels apart give slopes. The median over all places is told, with its standard error by resampling places, and the median
of the places' own medians. Places lie around the middles of maria, and on the highlands of the far side and of the near side's south.
Measured with seed 1: see docs/invented-detail.md.
"""
import glob
import subprocess
import sys
import tempfile

import numpy as np

MARIA = [(35, 345), (27, 18), (17, 59), (18, 303), (8, 31), (-5, 52), (-20, 345), (-24, 321), (40, 330), (12, 315), (30, 340), (22, 22)]


def draw(msis, label, places, folder):
    table = folder + "/places.csv"
    with open(table, "w") as file:
        file.write("time,lat,lon,height\n")
        for latitude, longitude in places:
            file.write(f"2026-01-10T00:00:00Z,{latitude:.6f},{longitude:.6f},terrain+230\n")
    subprocess.run(
        [msis, "--renderer", "native", "--ldem", label, "--refine", "1", "--batch-file", table, "--ignore-sun", "--fov", "61",
         "--width", "64", "--height", "64", "--batch", "--layers", "position", "--layers-format", "npy", "-o", folder],
        check=True, capture_output=True)
    return sorted(glob.glob(folder + "/*position.npy"))


def slopes(name):
    position = np.load(name).astype(float)
    position = position if position.shape[-1] == 3 else np.moveaxis(position, 0, -1)
    up = position[32, 32] / np.linalg.norm(position[32, 32])
    found = []
    for i in range(8, 52, 3):
        for j in range(8, 52, 3):
            across, down = position[i, j + 4] - position[i, j], position[i + 4, j] - position[i, j]
            normal = np.cross(across, down)
            found.append(np.degrees(np.arccos(abs(normal @ up) / np.linalg.norm(normal))))
    return found


def main():
    msis, label = sys.argv[1:3]
    count = int(sys.argv[3]) if len(sys.argv) > 3 else 96
    random = np.random.default_rng(1)
    maria = [np.add(MARIA[i % len(MARIA)], random.uniform(-1.5, 1.5, 2)) for i in range(count)]
    highlands = [(random.uniform(-40, 40), random.uniform(130, 220)) for _ in range(count)]
    near = [(random.uniform(-65, -35), random.uniform(-30, 60) % 360) for _ in range(count)]
    for name, places in (("maria", maria), ("highlands of the far side", highlands), ("highlands of the near side", near)):
        with tempfile.TemporaryDirectory() as folder:
            found = [slopes(image) for image in draw(msis, label, places, folder)]
        found, medians = np.array(found), np.median(found, axis=1)
        error = np.std([np.median(found[random.integers(0, count, count)]) for _ in range(100)])
        print(f"{name}: median slope at 17 m {np.median(found):.2f} +- {error:.2f} degrees, of {count} places; the median of their own "
              f"medians is {np.median(medians):.2f}, half of these are between {np.percentile(medians, 25):.2f} and "
              f"{np.percentile(medians, 75):.2f}")


main()

"""Median slopes at 17 m of the ground that --refine invents, and how far it is off the means of LDEM_4's cells.

python3 tests/reference/refine_slopes.py PATH-OF-MSIS LDEM_4.LBL [PLACES]

Needs numpy. For each place one image from 230 m over the ground, looking down, whose pixels are some 4.25 m wide: the heights of the
layer `position` four pixels apart give slopes. Places are in the middles of maria, and on the far side's highlands. Measured with 12
places each (seed 1): see docs/invented-detail.md.
"""
import glob
import subprocess
import sys
import tempfile

import numpy as np

MARIA = [(35, 345), (27, 18), (17, 59), (18, 303), (8, 31), (-5, 52), (-20, 345), (-24, 321), (40, 330), (12, 315), (30, 340), (22, 22)]
HIGHLANDS = [(a, b) for a in (-40, -15, 10, 35) for b in (130, 175, 220)]


def slopes(msis, label, latitude, longitude):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(
            [msis, "--renderer", "native", "--ldem", label, "--refine", "1", f"--position={latitude},{longitude},terrain+230",
             "--time", "2026-01-10T00:00:00Z", "--ignore-sun", "--fov", "61", "--width", "64", "--height", "64", "--batch",
             "--layers", "position", "--layers-format", "npy", "-o", folder], check=True, capture_output=True)
        position = np.load(glob.glob(folder + "/*position.npy")[0]).astype(float)
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
    places = int(sys.argv[3]) if len(sys.argv) > 3 else 12
    for name, where in (("maria", MARIA), ("highlands", HIGHLANDS)):
        medians = [np.median(slopes(msis, label, *place)) for place in where[:places]]
        print(f"{name}: median slope at 17 m {np.median(medians):.2f} degrees (of {len(medians)} places: "
              f"{min(medians):.2f} to {max(medians):.2f})")


main()

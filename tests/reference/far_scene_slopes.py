"""What shading can gain with one sample in a far image (docs/native-renderer.md, "Levels of detail").

Draws the far scene of ./benchmark.sh (pixels of 0.8 km and more, cells of 474 m) four times as wide and high, so that each pixel has 16 points with
their radiance factor and whether they are lit. One point is off from the pixel's mean for two reasons: the lit points differ in their slopes, and
some points are in shadow. A shading that knew the mean of the lit points exactly would be off for the second reason only, by that mean times
sqrt(f (1 - f)), f being the lit part. The errors are means over the choice of the point, in the unit of the one point's.

Run in the repository's folder, 4 GB of memory: /usr/bin/python3 tests/reference/far_scene_slopes.py LDEM_64_SYNTHETIC.LBL
"""
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from astropy.io import fits

STATE = "{55289,2E6,2E6,0,-2.391176183943345e-001,+9.904576054128762e-002,+3.696438106143861e-001,+8.923991008325228e-001}"  # thesis, 9.2
SIDE, PARTS = 1024, 4


def draw(model, side, *options):
    """Radiance factor, and whether the light reaches the point, of a frame [side, side]."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(
            ["./msis", "--renderer", "native", "--reflectance", "lambert", "--lod", "off", "--ldem", model, "--res", "64", "--fixed-state", STATE,
             "--width", str(side), "--height", str(side), "--fov", "40", "--layers", "radiance-factor,mask", "--output-dir", folder, *options],
            check=True, stdout=subprocess.DEVNULL)
        with fits.open(next(pathlib.Path(folder).glob("*.fits"))) as file:
            return file["RADIANCE_FACTOR"].data.astype(float), file["MASK"].data == 1


def points(image):
    """The points of each pixel [1024, 1024, 16]."""
    return image.reshape(SIDE, PARTS, SIDE, PARTS).swapaxes(1, 2).reshape(SIDE, SIDE, PARTS * PARTS)


def main():
    radiance, lit = (points(image) for image in draw(sys.argv[1], SIDE * PARTS))
    part = lit.mean(axis=2)
    mean_of_lit = np.divide((radiance * lit).sum(axis=2), lit.sum(axis=2), out=np.zeros_like(part), where=part > 0.0)
    unit = np.sqrt(radiance.var(axis=2).mean())
    print(f"perfect shading, light by one point: {np.sqrt((mean_of_lit**2 * part * (1.0 - part)).mean()) / unit:.2f}")
    truth = draw(sys.argv[1], SIDE, "--samples", "64")[0]
    one = np.sqrt(((draw(sys.argv[1], SIDE)[0] - truth) ** 2).mean())
    for way in (["--shading", "smooth"], ["--samples", "4"]):
        print(f"{' '.join(way)}: {np.sqrt(((draw(sys.argv[1], SIDE, *way)[0] - truth) ** 2).mean()) / one:.2f}")


if __name__ == "__main__":
    main()

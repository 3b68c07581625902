"""Size-frequency distribution of the fresh craters that --refine invents on maria, against the published law.

python3 tests/reference/refine_craters.py PATH-OF-MSIS LDEM_4.LBL [PLACES]

Needs numpy. Of each place one image looking down, whose heights come from the layer `position`. Craters are found in the heights alone, by
correlation with the profile of a new simple crater (Pike 1977) at eight diameters an octave; the factor of the profile's height that fits
best is how fresh a crater is. Those from half as deep as new ones on are counted: a fifth of all, if the logarithm of the depth is uniform
from a 32nd to 1. The law is the production of 3.2 Ga, 3e-3 D^-3 for each km2, D in km. Craters below eight pixels are not looked for, and
of overlapping ones only the clearer one is counted. Measured with seed 1: see docs/invented-detail.md.
"""
import glob
import subprocess
import sys
import tempfile

import numpy as np

SIDE, PIXEL, MOON = 256, 12.0, 1737400.0  # px, m, m
LEAST, OCTAVES, STEPS = 96.0, 2, 8  # m, diameters from LEAST on
CLEAR, FRESH = 0.8, 0.5  # correlation; depth of a new crater
MARIA = [(35, 345), (27, 18), (17, 59), (18, 303), (8, 31), (-5, 52), (-20, 345), (-24, 321), (40, 330), (12, 315), (30, 340), (22, 22)]


def draw(msis, label, places, folder):
    height = 0.5 * SIDE * PIXEL / np.tan(np.radians(15.0))
    table = folder + "/places.csv"
    with open(table, "w") as file:
        file.write("time,lat,lon,height\n")
        for latitude, longitude in places:
            file.write(f"2026-01-10T00:00:00Z,{latitude:.6f},{longitude:.6f},terrain+{height:.1f}\n")
    subprocess.run(
        [msis, "--renderer", "native", "--ldem", label, "--refine", "1", "--batch-file", table, "--ignore-sun", "--fov", "30",
         "--width", str(SIDE), "--height", str(SIDE), "--batch", "--layers", "position", "--layers-format", "npy", "-o", folder],
        check=True, capture_output=True)
    return sorted(glob.glob(folder + "/*position.npy"))


def heights(name):
    """Heights in m, and the mean width of a pixel in m."""
    position = np.load(name).astype(float)
    position = position if position.shape[-1] == 3 else np.moveaxis(position, 0, -1)
    across = np.linalg.norm(position[:, -1] - position[:, 0], axis=-1).mean() / (SIDE - 1)
    return np.linalg.norm(position, axis=-1) - MOON, across


def profile(radii, diameter):
    """Height of a new crater over the ground at distances in radii: bowl, and ejecta that fall with the third power."""
    depth, rim = 196.0 * (diameter / 1000.0) ** 1.010, 36.0 * (diameter / 1000.0) ** 1.014
    bowl = depth * radii**2 - (depth - rim)
    return np.minimum(bowl, rim * np.maximum(radii, 0.5) ** -3)


def fits(ground, diameter, pixel):
    """Factor of the profile's height, and its correlation with the ground, around each pixel within two radii."""
    reach = 2.0
    y, x = np.meshgrid(*[np.fft.fftfreq(SIDE, 1.0 / SIDE) * pixel / (0.5 * diameter)] * 2, indexing="ij")
    radii = np.hypot(x, y)
    inside = (radii <= reach).astype(float)
    shape = np.where(inside > 0, profile(radii, diameter), 0.0)
    shape -= inside * shape.sum() / inside.sum()
    spectrum = np.fft.rfft2(ground)

    def correlate(kernel, of=spectrum):
        return np.fft.irfft2(of * np.conj(np.fft.rfft2(kernel)), s=ground.shape)

    product, mean = correlate(shape), correlate(inside) / inside.sum()
    variance = correlate(inside, np.fft.rfft2(ground**2)) - inside.sum() * mean**2
    for slope in (x, y):  # a tilt of the ground is no crater's doing
        kernel = slope * inside
        variance -= correlate(kernel) ** 2 / (kernel**2).sum()
    power = (shape**2).sum()
    return product / power, product / np.sqrt(power * np.maximum(variance, 1e-12))


def craters(name):
    """Diameters of the fresh craters of an image whose middles are not near its sides, and the area for each diameter, km2."""
    ground, pixel = heights(name)
    ground = ground - ground.mean()
    diameters = LEAST * 2.0 ** (np.arange(-1, OCTAVES * STEPS + 1) / STEPS)
    found = []
    for diameter in diameters:
        factor, clear = fits(ground, diameter, pixel)
        edge = int(np.ceil(diameter / pixel))
        rows, columns = np.nonzero((clear > CLEAR) & (factor > 0.3))
        whole = (np.minimum(rows, columns) >= edge) & (np.maximum(rows, columns) < SIDE - edge)
        found += [(clear[r, c], diameter, factor[r, c], r, c) for r, c in zip(rows[whole], columns[whole])]
    kept = []
    for clear, diameter, factor, row, column in sorted(found, reverse=True):
        if all(np.hypot(row - r, column - c) * pixel > 0.5 * max(diameter, d) or not 0.5 < diameter / d < 2.0 for d, _, r, c in kept):
            kept.append((diameter, factor, row, column))
    return [d for d, factor, _, _ in kept if factor >= FRESH], [(1e-3 * pixel * (SIDE - 2 * np.ceil(d / pixel))) ** 2 for d in diameters]


def main():
    msis, label = sys.argv[1:3]
    random = np.random.default_rng(1)
    count = int(sys.argv[3]) if len(sys.argv) > 3 else 48
    places = [np.add(MARIA[i % len(MARIA)], random.uniform(-1.5, 1.5, 2)) for i in range(count)]
    with tempfile.TemporaryDirectory() as folder:
        found, areas = zip(*[craters(image) for image in draw(msis, label, places, folder)])
    diameters = LEAST * 2.0 ** (np.arange(-1, OCTAVES * STEPS + 1) / STEPS)
    area = np.sum(areas, axis=0)
    for first in range(1, OCTAVES * STEPS + 1, STEPS // 2):
        steps = slice(first, first + STEPS // 2)
        low, high = diameters[first] * 2 ** (-0.5 / STEPS), diameters[first] * 2 ** (0.5 - 0.5 / STEPS)
        number = sum(low <= d < high for image in found for d in image)
        law = 0.2 * 3e-3 * ((low / 1000.0) ** -3 - (high / 1000.0) ** -3) * area[steps].mean()
        print(f"{low:.0f} to {high:.0f} m: {number} fresh craters in {area[steps].mean():.0f} km2, by the law {law:.1f}; "
              f"{number / law:.2f} +- {np.sqrt(max(number, 1)) / law:.2f} of it")


main()

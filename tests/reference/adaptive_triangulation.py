"""Does an adaptive triangulation need fewer triangles than the regular grids of the levels of detail, at equal error of the image?

/usr/bin/python3 tests/reference/adaptive_triangulation.py LABEL [LATITUDE LONGITUDE]

A patch of 4 (16 at 4 px/deg) degrees is drawn from straight above, one pixel a cell, with the Sun 10 degrees up in the east, Lambert, no cast shadows.
With 2 or 4 samples of the model a pixel the grid is the level of detail whose cell is a pixel (means of 2 x 2 or 4 x 4 samples). The truth of
the image is always the mean over each pixel of all facets of the model itself. Against each other:
- regular grids: the level itself, and the next coarser ones (means again);
- right-triangulated irregular networks of the level (W. Evans, D. Kirkpatrick, G. Townsend, "Right-triangulated irregular networks",
  Algorithmica 30 (2001) 264): halved until the grey of a triangle is within a tolerance, rms over its pixels, of what these pixels show in
  truth, and its heights are within half a pixel. Crack-free by taking each vertex's error as the greatest of all that depend on it.
  "This Sun": its grey under the image's own Sun, a mesh for one image. "Any Sun": under Suns 10 degrees up in the east, north, west and
  south, a mesh that can be kept.
"""
import re
import sys

import numpy as np

RADIUS = 1737400.0  # m
MARGIN = 8  # px at the patch's border that are not compared: coarse means do not reach them
UP, ALONG = np.sin(np.radians(10.0)), np.cos(np.radians(10.0))
SUNS = ((ALONG, 0.0), (0.0, -ALONG), (-ALONG, 0.0), (0.0, ALONG))  # x east, y south; the first is the image's
TOLERANCES = (0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0)  # levels
MOST_HEIGHT_ERROR = 0.5  # px


def read(label, latitude, longitude, size):
    """Heights in m of size x size samples from the north-west corner given, and px/deg."""
    text = open(label, encoding="latin-1").read()
    value = lambda name: re.search(name + r"\s*=\s*\"?([-0-9.]+)", text).group(1)
    lines, samples = int(value(r"\n\s*LINES")), int(value(r"\n\s*LINE_SAMPLES"))
    resolution = lines // 180
    image = np.memmap(label.replace(".LBL", ".IMG"), "<i2", "r", shape=(lines, samples))
    line, sample = int((90.0 - latitude) * resolution), int(longitude * resolution)
    return image[line:line + size, sample:sample + size] * float(value("SCALING_FACTOR")), resolution


def bent(heights, cell):
    """Over the tangent plane of the patch's middle: the sphere falls away."""
    place = (np.arange(len(heights)) - 0.5 * (len(heights) - 1)) * cell
    return heights - (place[:, None] ** 2 + place[None, :] ** 2) / (2.0 * RADIUS)


def radiance(slope_x, slope_y, sun=SUNS[0]):
    """Lambert of a facet z(x, y), x east, y south, cut off at the terminator."""
    return 0.64 * np.maximum(0.0, UP - slope_x * sun[0] - slope_y * sun[1]) / np.sqrt(1.0 + slope_x ** 2 + slope_y ** 2)


def levels(linear):
    """Grey levels by sRGB, not rounded."""
    return 255.0 * np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * np.maximum(linear, 1e-9) ** (1 / 2.4) - 0.055)


def quarters(z, cell):
    """Slopes on the four quarters (N, E, S, W, between both diagonals) of each cell, of facets cut from north-west to south-east."""
    nw, ne, sw, se = z[:-1, :-1], z[:-1, 1:], z[1:, :-1], z[1:, 1:]
    upper = ((ne - nw) / cell, (se - ne) / cell)
    lower = ((se - sw) / cell, (sw - nw) / cell)
    return np.stack([upper[0], upper[0], lower[0], lower[0]]), np.stack([upper[1], upper[1], lower[1], lower[1]])


def truth_of(z, cell, per_pixel, sun=SUNS[0]):
    """Radiance of each pixel: of the cells of the level whose vertices are means of per_pixel x per_pixel samples."""
    pixels = len(z) // per_pixel - 1
    cells = radiance(*quarters(z, cell), sun).mean(axis=0)
    if per_pixel > 1:
        weights = np.array([0.5] + [1.0] * (per_pixel - 1) + [0.5]) / per_pixel  # the pixel begins in the middle of a cell
        first = per_pixel // 2 - 1
        take = lambda a: sum(w * a[first + i:first + i + per_pixel * (pixels - 1) + 1:per_pixel] for i, w in enumerate(weights))
        cells = take(take(cells).T).T
    return cells


def means(heights, factor):
    side = len(heights) // factor
    return heights[:side * factor, :side * factor].reshape(side, factor, side, factor).mean(axis=(1, 3))


def coarser(heights, cell, factor):
    """Radiance of each quarter of each pixel on a grid of means of factor x factor samples."""
    z = bent_means(heights, cell, factor)
    slopes = quarters(z, cell * factor)
    offsets = ((0.5, 1 / 6), (5 / 6, 0.5), (0.5, 5 / 6), (1 / 6, 0.5))  # of the quarters' centroids in a pixel, x and y
    pixels = len(heights) - 1
    image = np.zeros((4, pixels, pixels))
    for quarter, (dx, dy) in enumerate(offsets):
        u = (np.arange(pixels) + dx - 0.5 * (factor - 1)) / factor
        v = (np.arange(pixels) + dy - 0.5 * (factor - 1)) / factor
        i = np.clip(np.floor(u).astype(int), 0, len(z) - 2)
        j = np.clip(np.floor(v).astype(int), 0, len(z) - 2)
        is_lower = (v - j)[:, None] > (u - i)[None, :]
        piece = np.where(is_lower, 2, 0)
        image[quarter] = radiance(slopes[0][piece, j[:, None], i[None, :]], slopes[1][piece, j[:, None], i[None, :]])
    return image


def bent_means(heights, cell, factor):
    """Means of the heights, bent about the same middle as the fine grid."""
    coarse = means(heights, factor)
    place = ((np.arange(len(coarse)) + 0.5) * factor - 0.5 - 0.5 * (len(heights) - 1)) * cell
    return coarse - (place[:, None] ** 2 + place[None, :] ** 2) / (2.0 * RADIUS)


def triangles_by_level(n):
    """For each number of splits the triangles (a, b, c as x, y; hypotenuse a to b); the two halves of number i are 2i and 2i + 1."""
    current = np.array([[[0, 0], [n, n], [n, 0]], [[n, n], [0, 0], [0, n]]])
    result = [current]
    while len(current) < 2 * n * n:
        a, b, c = current[:, 0], current[:, 1], current[:, 2]
        m = (a + b) // 2
        current = np.stack([np.stack([c, a, m], 1), np.stack([b, c, m], 1)], 1).reshape(-1, 3, 2)
        result.append(current)
    return result


def finest_of_quarters(finest, n):
    """Number of the finest triangle that holds each quarter of each cell, [quarter, y, x]."""
    result = np.zeros((4, n, n), int)
    corner = finest.min(axis=1)
    apex = finest[:, 2] - corner
    number = np.arange(len(finest))
    for (x, y), pair in {(0, 0): (0, 3), (1, 0): (0, 1), (1, 1): (1, 2), (0, 1): (2, 3)}.items():
        chosen = (apex[:, 0] == x) & (apex[:, 1] == y)
        for quarter in pair:
            result[quarter, corner[chosen, 1], corner[chosen, 0]] = number[chosen]
    return result


class Network:
    """The adaptive triangulation of a patch."""

    def __init__(self, z, cell, truths):
        """truths: of the image under each of the first Suns that count."""
        self.cells = len(z) - 1
        self.triangles = triangles_by_level(self.cells)
        self.splits = len(self.triangles) - 1
        self.holder = finest_of_quarters(self.triangles[-1], self.cells)
        self.slopes = [self.slopes_of(triangles, z, cell) for triangles in self.triangles]
        every = range(self.splits + 1)
        self.grey_error = self.to_vertices([np.max([self.grey(k, *pair) for pair in zip(truths, SUNS)], axis=0) for k in every])
        self.height_error = self.to_vertices([self.height(k, z, cell) for k in every])

    @staticmethod
    def slopes_of(triangles, z, cell):
        (ax, ay), (bx, by), (cx, cy) = (triangles[:, i].T for i in range(3))
        ux, uy, uz = (bx - ax) * cell, (by - ay) * cell, z[by, bx] - z[ay, ax]
        vx, vy, vz = (cx - ax) * cell, (cy - ay) * cell, z[cy, cx] - z[ay, ax]
        area = ux * vy - uy * vx
        return (uz * vy - uy * vz) / area, (ux * vz - uz * vx) / area

    def grey(self, k, truth, sun):
        """Rms over the quarters of each triangle, levels."""
        number = self.holder >> (self.splits - k)
        off = (levels(radiance(*self.slopes[k], sun))[number] - levels(truth)[None]) ** 2
        count = len(self.triangles[k])
        return np.sqrt(np.bincount(number.ravel(), off.ravel(), count) / np.bincount(number.ravel(), minlength=count))

    def height(self, k, z, cell):
        """Greatest distance of a cell's middle, m."""
        number = self.holder >> (self.splits - k)
        middle = (z[:-1, :-1] + z[1:, 1:]) / 2.0  # on the diagonal that the facets are cut by
        ax, ay = self.triangles[k][:, 0].T
        x, y = np.arange(self.cells)[None, None, :] + 0.5, np.arange(self.cells)[None, :, None] + 0.5
        slope_x, slope_y = self.slopes[k]
        plane = z[ay, ax][number] + slope_x[number] * (x - ax[number]) * cell + slope_y[number] * (y - ay[number]) * cell
        off = np.zeros(len(self.triangles[k]))
        np.maximum.at(off, number.ravel(), np.abs(plane - middle[None]).ravel())
        return off

    def to_vertices(self, errors):
        """The error that decides whether the triangles about the middle of a hypotenuse are halved there, [y, x]."""
        error = np.zeros((self.cells + 1, self.cells + 1))
        for k in range(self.splits - 1, -1, -1):
            a, b, c = (self.triangles[k][:, i] for i in range(3))
            own = errors[k]
            for p, q in ((a, c), (b, c)) if k < self.splits - 1 else ():
                m = (p + q) // 2
                own = np.maximum(own, error[m[:, 1], m[:, 0]])
            m = (a + b) // 2
            np.maximum.at(error, (m[:, 1], m[:, 0]), own)
        return error

    def draw(self, grey, height):
        """Number of triangles and radiance of each quarter, for tolerances in levels and m."""
        is_split = (self.grey_error > grey) | (self.height_error > height)
        open_ = np.ones(len(self.triangles[0]), bool)
        image = np.zeros((4, self.cells, self.cells))
        count = 0
        for k, triangles in enumerate(self.triangles):
            m = (triangles[:, 0] + triangles[:, 1]) // 2
            halve = open_ & is_split[m[:, 1], m[:, 0]] if k < self.splits else np.zeros(len(triangles), bool)
            leaf = open_ & ~halve
            count += leaf.sum()
            number = self.holder >> (self.splits - k)
            image = np.where(leaf[number], radiance(*self.slopes[k])[number], image)
            open_ = np.repeat(halve, 2)
        return count, image


def error_of(image, truth):
    """Rms in levels."""
    inside = slice(MARGIN, -MARGIN)
    return np.sqrt(np.mean((levels(image.mean(axis=0)) - levels(truth))[inside, inside] ** 2))


def study(label, latitude, longitude, per_pixel):
    cells = 64 if "LDEM_4." in label else 256
    heights, resolution = read(label, latitude, longitude, (cells + 1) * per_pixel)
    cell = np.pi / 180.0 * RADIUS / resolution
    truths = [truth_of(bent(heights, cell), cell, per_pixel, sun) for sun in SUNS]
    grid = means(heights, per_pixel)
    pixel = cell * per_pixel
    z = bent(grid, pixel)
    whole = 2 * cells * cells
    print(f"\n{resolution} px/deg, {per_pixel} x {per_pixel} samples a pixel\n\n| triangulation | triangles | rms error, levels |\n|---|---|---|")
    print(f"| regular, the level with a cell a pixel | {whole} | {error_of(radiance(*quarters(z, pixel)), truths[0]):.2f} |")
    for factor in (2, 4):
        print(f"| regular, {factor} px a cell | {100 / factor ** 2:.1f} % | {error_of(coarser(grid, pixel, factor), truths[0]):.2f} |")
    this_sun, any_sun = Network(z, pixel, truths[:1]), Network(z, pixel, truths)
    for tolerance in TOLERANCES:
        results = [network.draw(tolerance, MOST_HEIGHT_ERROR * pixel) for network in (this_sun, any_sun)]
        shares = ", ".join(f"{100 * count / whole:.1f} %" for count, _ in results)
        errors = ", ".join(f"{error_of(image, truths[0]):.2f}" for _, image in results)
        print(f"| adaptive, {tolerance:g} levels: this Sun, any Sun | {shares} | {errors} |")


if __name__ == "__main__":
    corner = [float(x) for x in sys.argv[2:4]] or [12.0, 18.0]
    for samples in (1, 2, 4):
        study(sys.argv[1], *corner, samples)

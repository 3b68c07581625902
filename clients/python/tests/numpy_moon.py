"""What a camera over the facets of LDEM_4 sees, in numpy: what msis draws, from the definitions in docs/, by other means.

Rays are followed facet by facet; directions in the image and widths of pixels are differences of projected points and of rays. Nothing is
shared with msis but the elevation model's file.
"""

from pathlib import Path

import numpy as np
from numpy_camera import RADIUS

LDEM_4 = Path(__file__).resolve().parents[3] / "input" / "ldem" / "LDEM_4.IMG"
ALBEDO = 0.64
SUNLIGHT = 1.62  # W m^-2 nm^-1 at 1 au and 643 nm (docs/photometry.md)
AU = 149597870700.0


def dot(a, b):
    return np.sum(a * b, axis=-1)


def unit(v):
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def angle(a, b):
    """Degrees between vectors, right to the last digits at 0 and 180 too."""
    return np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b), axis=-1), dot(a, b)))


class Ground:
    """The facets of LDEM_4 (docs/pattern-format.md), away from the poles and where the camera's rays meet the ground once."""

    RES = 4

    def __init__(self):
        self.radii = np.fromfile(LDEM_4, "<i2").reshape(180 * self.RES, 360 * self.RES) * 0.5 + RADIUS

    def vertex(self, line, sample):
        latitude, longitude = np.radians(90.0 - (line + 0.5) / self.RES), np.radians((sample + 0.5) / self.RES)
        across = np.cos(latitude)
        direction = np.stack([across * np.cos(longitude), across * np.sin(longitude), np.sin(latitude)], axis=-1)
        return np.round(self.radii[line, sample % (360 * self.RES)][..., None] * direction * 128.0) / 128.0

    def facet(self, points):
        """Line and sample of the cell, 0 for its south-western and 1 for its north-eastern half, a vertex, and the outward normal."""
        x, y, z = points.T
        line = np.floor((90.0 - np.degrees(np.arctan2(z, np.hypot(x, y)))) * self.RES - 0.5).astype(int)
        sample = np.floor(np.degrees(np.arctan2(y, x)) % 360.0 * self.RES - 0.5).astype(int)
        # The sides of a cell to the north and south are straight, no parallels.
        line -= dot(np.cross(self.vertex(line, sample), self.vertex(line, sample + 1)), points) > 0.0
        line += dot(np.cross(self.vertex(line + 1, sample), self.vertex(line + 1, sample + 1)), points) < 0.0
        northwest, southeast = self.vertex(line, sample), self.vertex(line + 1, sample + 1)
        half = (dot(np.cross(northwest, southeast), points) > 0.0).astype(int)
        third = np.where(half[:, None] == 1, self.vertex(line, sample + 1), self.vertex(line + 1, sample))
        normal = unit(np.cross(southeast - northwest, third - northwest))
        return line, sample % (360 * self.RES), half, northwest, normal * np.sign(dot(normal, points))[:, None]

    def hit(self, origin, rays):
        """The points that rays meet, m: from facet to facet until the ray meets the plane of a facet in that facet."""
        b, c = dot(rays, origin), dot(rays, rays)
        t = (-b - np.sqrt(b * b - c * (origin @ origin - (RADIUS - 2000.0) ** 2))) / c
        for _ in range(60):
            _, _, _, corner, normal = self.facet(origin + t[:, None] * rays)
            last, t = t, dot(normal, corner - origin) / dot(normal, rays)
            if np.abs(t - last).max() < 1e-12 * t.max():
                return origin + t[:, None] * rays
        raise AssertionError("a ray does not settle on a facet: take a steeper view")

    def heights(self, point, ways, steps):
        """Heights of places on ways from a point, or from one for each, over the plane of the facet under each, m, [way, step]."""
        at = (point + steps[:, None] * ways[:, None]).reshape(-1, 3)
        _, _, _, corner, normal = self.facet(at)
        return (np.linalg.norm(at, axis=1) * (1.0 - dot(normal, corner) / dot(normal, at))).reshape(len(ways), len(steps))

    def clearance(self, points, directions, reach=2e5, step=100.0):
        """The least height over the ground of the lines from points along directions, m, from one step on."""
        return self.heights(points[:, None], directions, np.arange(step, reach, step)).min(axis=1)


GROUND = Ground()


def expected_layers(camera, sun, samples=1):
    """What the layers hold, [pixel] or [pixel, plane]; all of it is lit."""
    pixels = camera.pixels()
    rays = camera.rays(pixels)
    points = GROUND.hit(camera.position, rays)
    line, sample, _, _, normal = GROUND.facet(points)
    zenith, to_sun, to_camera = unit(points), sun - points, camera.position - points
    distance = np.linalg.norm(to_camera, axis=1)
    north = np.array([0.0, 0.0, 1.0]) - zenith[:, 2:] * zenith
    east = np.cross(north, zenith)
    sunward = unit(to_sun - dot(to_sun, zenith)[:, None] * zenith)
    x, y = (camera.project(points + sunward) - camera.project(points - sunward)).T
    corners = [unit(camera.rays(pixels + 0.005 * np.array(way))) for way in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    solid_angle = 0.5e4 * np.linalg.norm(np.cross(corners[2] - corners[0], corners[3] - corners[1]), axis=1)
    cosines = [light_on(camera, pixels + shift, sun) for shift in shifts(samples)]
    factor = ALBEDO * np.mean(cosines, axis=0)
    nothing = np.zeros(len(points))
    return {
        "depth": ((points - camera.position) @ camera.R.T)[:, 2],
        "range": distance,
        "position": points,
        "latitude": np.degrees(np.arcsin(zenith[:, 2])),
        "longitude": np.degrees(np.arctan2(zenith[:, 1], zenith[:, 0])) % 360.0,
        "height": np.linalg.norm(points, axis=1) - RADIUS,
        "normal": normal,
        "incidence": angle(normal, to_sun),
        "emission": angle(normal, to_camera),
        "phase": angle(to_sun, to_camera),
        "illumination-direction": np.degrees(np.arctan2(x, y)) % 360.0,
        "mask": nothing + 1,
        "sun-visibility": nothing + 1,
        "source": np.tile([0.0, 1.0], (line.size, 1)),
        "tile": 72 * ((180 * 4 - 1 - line) // 20) + sample // 20,
        "cell": np.stack([line, sample], axis=1),
        "pixel-scale": distance * np.sqrt(solid_angle),
        "slope": angle(normal, points),
        "aspect": np.degrees(np.arctan2(dot(normal, east), dot(normal, north))) % 360.0,
        "sphere-incidence": angle(points, to_sun),
        "radiance-factor": factor,
        "radiance": factor * SUNLIGHT * (AU / np.linalg.norm(sun)) ** 2 / np.pi,
    }


def shifts(samples):
    across = round(samples**0.5)
    return [((np.array([i, j]) + 0.5) / across) - 0.5 for j in range(across) for i in range(across)]


def light_on(camera, pixels, sun):
    points = GROUND.hit(camera.position, camera.rays(pixels))
    return np.cos(np.radians(angle(GROUND.facet(points)[4], sun - points)))


def gathered_light(points, sun, rays=(24, 32)):
    """I/F of the light that lit ground throws on points once, by rays in all directions that go over the ground in growing steps."""
    up, around = rays
    part = ((np.arange(up) + 0.5) / up)[:, None]
    sine, weight = part**2, np.repeat(4.0 * part**3, around)  # of the elevation over the facet: most rays go low
    turn = 2.0 * np.pi * (np.arange(around) + 0.5) / around
    cosine = np.sqrt(1.0 - sine * sine)
    steps = 100.0 * 1.09 ** np.arange(90)  # m
    light = []
    for point in points:
        normal = GROUND.facet(point[None])[4][0]
        right = unit(np.cross(normal, [0.6, 0.0, 0.8]))
        ways = (cosine * np.cos(turn))[..., None] * right + (cosine * np.sin(turn))[..., None] * np.cross(normal, right)
        ways = (ways + (sine * np.ones(around))[..., None] * normal).reshape(-1, 3)
        heights = GROUND.heights(point, ways, steps)
        under = heights < 0.0
        last = np.argmax(under, axis=1)
        met = under[np.arange(len(ways)), last] & (last > 0)
        ways, last, heights = ways[met], last[met], heights[met]
        before, after = heights[np.arange(len(ways)), last - 1], heights[np.arange(len(ways)), last]
        between = before / (before - after)
        places = point + (steps[last - 1] + between * (steps[last] - steps[last - 1]))[:, None] * ways
        to_sun = unit(sun - places)
        cosines = dot(GROUND.facet(places)[4], to_sun)
        cosines[cosines > 0.0] *= GROUND.clearance(places[cosines > 0.0], to_sun[cosines > 0.0], step=1000.0) > 0.0
        light.append(ALBEDO * ALBEDO * (weight[met] * cosines.clip(0.0)).sum() / (up * around))
    return np.array(light)

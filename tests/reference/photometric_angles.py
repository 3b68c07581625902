#!/usr/bin/env python3
"""Reference values for incidence, emission and phase at a point of the surface, with 50 digits.

By the arc cosine of the dot product, which 50 digits bear: nothing of the program's own formula. Inputs are doubles, printed so
that they read back exactly; an output has 25 digits.

    python3 tests/reference/photometric_angles.py > tests/golden/photometric_angles.tsv
"""
import math
import random

from mpmath import acos, degrees, mp, mpf, nstr, sqrt

mp.dps = 50
SEED = 20120222
SUN = 1.496e11


def angle(u, v):
    dot = sum(a * b for a, b in zip(u, v))
    cosine = dot / sqrt(sum(a * a for a in u) * sum(b * b for b in v))
    return degrees(acos(max(mpf(-1), min(mpf(1), cosine))))


def angles(point, normal, camera, light):
    point, normal, camera, light = ([mpf(c) for c in v] for v in (point, normal, camera, light))
    to_camera = [c - p for c, p in zip(camera, point)]
    to_light = [c - p for c, p in zip(light, point)]
    return angle(to_light, normal), angle(to_camera, normal), angle(to_light, to_camera)


class Scenes:
    """Random scenes, the same in every run."""

    def __init__(self):
        self.random = random.Random(SEED)

    def direction(self):
        z = self.random.uniform(-1.0, 1.0)
        longitude = self.random.uniform(0.0, 2.0 * math.pi)
        r = math.sqrt(1.0 - z * z)
        return [r * math.cos(longitude), r * math.sin(longitude), z]

    def near(self, direction, turn):
        turned = [d + turn * e for d, e in zip(direction, self.direction())]
        length = math.sqrt(sum(c * c for c in turned))
        return [c / length for c in turned]

    def point(self):
        return [self.random.uniform(1.728e6, 1.748e6) * c for c in self.direction()]

    @staticmethod
    def along(point, direction, distance):
        return [p + distance * d for p, d in zip(point, direction)]

    def anywhere(self):
        point, normal = self.point(), self.direction()
        camera = self.along(point, self.near(normal, 1.0), 10.0 ** self.random.uniform(3.0, 7.0))
        return point, normal, camera, [SUN * c for c in self.direction()]

    def one_metre_above(self):
        point = self.point()
        normal = self.near([c / 1.7374e6 for c in point], 0.5)
        return point, normal, self.along(point, self.near(normal, 0.9), 1.0), [SUN * c for c in self.direction()]

    def far(self):
        point, normal = self.point(), self.direction()
        return point, normal, self.along(point, self.near(normal, 0.9), 1e10), [SUN * c for c in self.direction()]

    def small_phase(self):
        point, normal = self.point(), self.direction()
        view = self.near(normal, 0.9)
        light = self.near(view, 10.0 ** self.random.uniform(-9.0, -2.0))
        return point, normal, self.along(point, view, 1e6), self.along(point, light, SUN)

    def grazing(self):
        """Sun and camera within 1e-9 to 0.01 rad of the facet's plane."""
        point, normal = self.point(), self.direction()
        helper = self.direction()
        dot = sum(a * b for a, b in zip(normal, helper))
        level = self.near([h - dot * n for h, n in zip(helper, normal)], 0.0)
        light = self.near(level, 10.0 ** self.random.uniform(-9.0, -2.0))
        view = self.near(level, 10.0 ** self.random.uniform(-9.0, -2.0))
        return point, normal, self.along(point, view, 1e5), self.along(point, light, SUN)

    def lamp_at_camera(self):
        point, normal = self.point(), self.direction()
        camera = self.along(point, self.near(normal, 0.9), 10.0 ** self.random.uniform(3.0, 7.0))
        return point, normal, camera, camera


def main():
    scenes = Scenes()
    print("# python3 tests/reference/photometric_angles.py (mpmath, 50 digits); m and doubles in, degrees out")
    print("# case\tpoint_x\tpoint_y\tpoint_z\tnormal_x\tnormal_y\tnormal_z\tcamera_x\tcamera_y\tcamera_z"
          "\tlight_x\tlight_y\tlight_z\tincidence\temission\tphase")
    counts = [("anywhere", 150), ("one_metre_above", 50), ("far", 50), ("small_phase", 50), ("grazing", 50),
              ("lamp_at_camera", 50)]
    for case, count in counts:
        for _ in range(count):
            scene = getattr(scenes, case)()
            print("\t".join([case, *(repr(c) for v in scene for c in v), *(nstr(v, 25) for v in angles(*scene))]))


if __name__ == "__main__":
    main()

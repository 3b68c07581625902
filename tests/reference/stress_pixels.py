#!/usr/bin/env python3
"""Pixels of cameras of all kinds with 50 digits: what tests/Msisf.Stress/Reference is held against.

The formulas are those of illumination.py. A line "camera" (position m, quaternion, field of view rad, width, height, Sun m; doubles
that read back exactly) is followed by its lines "pixel" (x, y; latitude, longitude, illumination direction in degrees, 24 digits).

    python3 tests/reference/stress_pixels.py > tests/golden/stress_pixels.tsv
"""
import math
import random

from illumination import add, cross, pixel, quaternion_looking, scale, unit
from mpmath import mp, mpf, nstr

mp.dps = 50
SEED = 20120615
CAMERAS = 1200
PIXELS_EACH = 10
RADIUS = 1737400.0


class Cameras:
    """Random cameras, the same in every run: 1 m to 1e12 m up, 1e-4 to 179.9 degrees, 1 x 1 to 16384 x 16384 px."""

    def __init__(self):
        self.random = random.Random(SEED)

    def log(self, low, high):
        return low * (high / low) ** self.random.random()

    def direction(self):
        z = self.random.uniform(-1.0, 1.0)
        longitude = self.random.uniform(0.0, 2.0 * math.pi)
        across = math.sqrt(1.0 - z * z)
        return [across * math.cos(longitude), across * math.sin(longitude), z]

    def zenith(self, number):
        if number % 10 == 0:
            return [0.0, 0.0, self.random.choice([-1.0, 1.0])]
        if number % 10 == 1:
            return [float(c) for c in unit(add([0.0, 0.0, 1.0], scale(self.log(1e-12, 1e-2), self.direction())))]
        return self.direction()

    def make(self, number):
        """Looks at a place on the disc, from its middle (0) to close to the limb (1)."""
        zenith = self.zenith(number)
        distance = RADIUS + self.log(1.0, 1e12)
        position = [distance * c for c in zenith]
        share = math.sqrt(self.random.random()) if number % 4 else 1.0 - self.log(1e-9, 1e-2)
        nadir = unit([-mpf(c) for c in zenith])
        sideward = unit(cross(nadir, self.direction()))
        sine = share * RADIUS / distance
        forward = add(scale(mpf(math.sqrt((1.0 - sine) * (1.0 + sine))), nadir), scale(mpf(sine), sideward))
        q = quaternion_looking(forward, self.random.uniform(0.0, 6.28))
        width, height = int(self.log(1, 16385)), int(self.log(1, 16385))
        fov = math.radians(self.log(1e-4, 179.9) if number % 2 else self.random.uniform(1.0, 179.9))
        light = self.direction()
        if number % 5 == 2:  # low distances from the zenith of what is looked at
            light = [float(c) for c in unit(add(zenith, scale(self.log(1e-7, 1e-1), self.direction())))]
        sun = position if number % 7 == 3 else [1.496e11 * c for c in light]
        return position, q, fov, width, height, sun

    def pixels(self, camera):
        """Pixels that show the Moon, each tried near the middle first where the image is wide."""
        position, q, fov, width, height, sun = camera
        found = {}
        for attempt in range(8 * PIXELS_EACH):
            reach = 0.5 ** (attempt % 8)
            x = 1 + int((0.5 + reach * (self.random.random() - 0.5)) * width)
            y = 1 + int((0.5 + reach * (self.random.random() - 0.5)) * height)
            values = pixel(position, q, fov, width, height, x, y, sun)
            if values is not None and values[4] > 1e-12:
                found[x, y] = values
            if len(found) == PIXELS_EACH:
                break
        return found.items()


def main():
    cameras = Cameras()
    print("# python3 tests/reference/stress_pixels.py (mpmath, 50 digits); doubles in, degrees out")
    for number in range(CAMERAS):
        camera = cameras.make(number)
        found = cameras.pixels(camera)
        if found:
            position, q, fov, width, height, sun = camera
            print("\t".join(["camera", *(repr(float(c)) for c in (*position, *q, fov)), str(width), str(height),
                             *(repr(float(c)) for c in sun)]))
        for (x, y), values in found:
            print("\t".join(["pixel", str(x), str(y), *(nstr(v, 24) for v in values[:3])]))


if __name__ == "__main__":
    main()

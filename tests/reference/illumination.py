#!/usr/bin/env python3
"""Reference values for pixel metadata: hit point and illumination direction, thesis section 9.3, with 50 digits.

Literal steps 1 to 8 of the thesis (quadratic of eq. 8.4, a second point 1000 m towards the Sun, its projection), with
docs/deviations.md rows 7 to 10: nothing of the program's own formulas. Inputs are doubles, printed so that they read back
exactly; an output has 25 digits.

    python3 tests/reference/illumination.py > tests/golden/illumination.tsv
"""
import math
import random

from mpmath import atan2, cos, degrees, mp, mpf, nstr, pi, sin, sqrt, tan

mp.dps = 50
RADIUS = mpf(1737400)
SEED = 20120222


def dot(u, v):
    return sum(a * b for a, b in zip(u, v))


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def norm(v):
    return sqrt(dot(v, v))


def scale(k, v):
    return [k * a for a in v]


def add(*vectors):
    return [sum(parts) for parts in zip(*vectors)]


def unit(v):
    return scale(1 / norm(v), v)


def rotate(q, v):
    """q [0, v] q*, with q = (qx, qy, qz, q0) of any length."""
    q = unit(q)
    once = scale(2, cross(q[:3], v))
    return add(v, scale(q[3], once), cross(q[:3], once))


def pixel(position, q, fov, width, height, x, y, sun):
    """(latitude, longitude, illumination direction in degrees, cosine of emission, sine between line of sight and the
    Sun's ground line times its length, projected point of step 7), or None for space."""
    position, q, sun = ([mpf(c) for c in v] for v in (position, q, sun))
    aspect = mpf(width) / height
    forward = scale(aspect / 2 / tan(mpf(fov) / 2), rotate(q, [-1, 0, 0]))
    right = scale(aspect, rotate(q, [0, 1, 0]))
    up = rotate(q, [0, 0, 1])
    ray = add(forward, scale(mpf(1 + height - 2 * y) / (2 * height), up), scale(mpf(2 * x - 1 - width) / (2 * width), right))

    half_b = dot(position, ray)
    discriminant = half_b**2 - dot(ray, ray) * (dot(position, position) - RADIUS**2)
    if discriminant < 0 or half_b > 0:
        return None
    surface = add(position, scale((-half_b - sqrt(discriminant)) / dot(ray, ray), ray))
    normal = unit(surface)
    latitude = degrees(atan2(surface[2], sqrt(surface[0] ** 2 + surface[1] ** 2)))
    longitude = degrees(atan2(surface[1], surface[0])) % 360

    to_sun = unit(add(sun, scale(-1, surface)))
    step = mpf(1000)
    while True:
        local = add(surface, scale(step, add(to_sun, scale(-dot(to_sun, normal), normal))))
        seen = add(local, scale(-1, position))
        if dot(seen, forward) > 0:
            break
        step /= 2  # the second point lies behind the camera: a nearer one on the same line does not
    on_plane = scale(dot(forward, forward) / dot(seen, forward), seen)
    x2 = width * dot(on_plane, right) / dot(right, right) + mpf(1 + width) / 2
    y2 = mpf(1 + height) / 2 - height * dot(on_plane, up)
    direction = degrees(atan2(x2 - x, y2 - y)) % 360

    tangent = add(to_sun, scale(-dot(to_sun, normal), normal))
    return latitude, longitude, direction, -dot(unit(ray), normal), norm(cross(unit(ray), tangent)), (x2, y2)


def quaternion_looking(forward, roll):
    """Doubles (qx, qy, qz, q0) of a camera that looks along `forward`, turned by `roll` about it."""
    f = unit([mpf(c) for c in forward])
    helper = [0, 0, 1] if abs(f[2]) < 0.9 else [1, 0, 0]
    side = unit(cross(f, helper))
    upward = cross(side, f)
    right = add(scale(cos(roll), side), scale(sin(roll), upward))
    columns = [scale(-1, f), right, cross(right, f)]
    m = [[columns[j][i] for j in range(3)] for i in range(3)]
    candidates = [
        [1 + m[0][0] - m[1][1] - m[2][2], m[1][0] + m[0][1], m[2][0] + m[0][2], m[2][1] - m[1][2]],
        [m[1][0] + m[0][1], 1 - m[0][0] + m[1][1] - m[2][2], m[2][1] + m[1][2], m[0][2] - m[2][0]],
        [m[2][0] + m[0][2], m[2][1] + m[1][2], 1 - m[0][0] - m[1][1] + m[2][2], m[1][0] - m[0][1]],
        [m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1], 1 + m[0][0] + m[1][1] + m[2][2]],
    ]
    return [float(c) for c in unit(max(candidates, key=norm))]


class Scenes:
    """Random scenes, the same in every run."""

    def __init__(self):
        self.random = random.Random(SEED)

    def direction(self):
        z = self.random.uniform(-1.0, 1.0)
        longitude = self.random.uniform(0.0, 2.0 * math.pi)
        r = math.sqrt(1.0 - z * z)
        return [r * math.cos(longitude), r * math.sin(longitude), z]

    def near(self, direction, angle):
        """A direction about `angle` rad away."""
        return [float(c) for c in unit(add(direction, scale(angle, self.direction())))]

    def at(self, zenith, distance, fov, tilt=0.3, sun=None):
        """A camera over `zenith` that looks at the ground, up to `tilt` rad off nadir, and a random pixel of it."""
        position = [distance * c for c in zenith]
        q = quaternion_looking(self.near([-c for c in zenith], tilt), self.random.uniform(0.0, 6.28))
        width, height = self.random.choice([(1024, 1024), (1900, 1200), (640, 1333), (16384, 16384)])
        x, y = self.random.randint(1, width), self.random.randint(1, height)
        light = sun or [1.496e11 * c for c in self.direction()]
        return position, q, fov, width, height, x, y, position if light == "camera" else light

    def moderate(self):
        distance = 1.7374e6 + 10.0 ** self.random.uniform(3.0, 7.0)
        return self.at(self.direction(), distance, self.random.uniform(0.02, 1.5))

    def one_metre_above(self):
        return self.at(self.direction(), 1737401.0, 0.7)

    def far(self):
        return self.at(self.direction(), 1e12, 3.4e-6, tilt=1e-7)

    def limb(self):
        distance = 1.7374e6 + 10.0 ** self.random.uniform(4.0, 7.0)
        return self.at(self.direction(), distance, 0.5, tilt=2.0 * math.asin(1.7374e6 / distance))

    def pole(self):
        return self.at(self.near([0.0, 0.0, self.random.choice([-1.0, 1.0])], 1e-4), 1.9e6, 0.01, tilt=1e-4)

    def subsolar(self):
        zenith = self.direction()
        sun = [1.496e11 * c for c in self.near(zenith, 10.0 ** self.random.uniform(-5.0, -2.0))]
        return self.at(zenith, 1.9e6, 0.02, tilt=1e-3, sun=sun)

    def light_at_camera(self):
        distance = 1.7374e6 + 10.0 ** self.random.uniform(4.0, 6.5)
        return self.at(self.direction(), distance, 0.7, sun="camera")


def main():
    scenes = Scenes()
    print("# python3 tests/reference/illumination.py (mpmath, 50 digits); doubles in, degrees out")
    print("# case\tx\ty\tz\tqx\tqy\tqz\tq0\tfov_rad\twidth\theight\tpixel_x\tpixel_y\tsun_x\tsun_y\tsun_z"
          "\tlat\tlon\tdirection\tcos_emission\tsine")
    counts = [("moderate", 400), ("one_metre_above", 50), ("far", 50), ("limb", 100), ("pole", 50), ("subsolar", 100),
              ("light_at_camera", 50)]
    for case, count in counts:
        found = 0
        while found < count:
            scene = getattr(scenes, case)()
            result = pixel(*scene)
            if result is None or (case == "limb") != (result[3] < 0.05):
                continue
            found += 1
            position, q, fov, width, height, x, y, sun = scene
            numbers = [repr(float(c)) for c in (*position, *q, fov)] + [str(n) for n in (width, height, x, y)]
            numbers += [repr(float(c)) for c in sun]
            print("\t".join([case, *numbers, *(nstr(v, 25) for v in result[:3]), *(nstr(v, 6) for v in result[3:5])]))


def published():
    """The example of section 9.2 (arguments as printed there), the numbers of docs/deviations.md row 10."""
    q = [-2.391176183943345e-001, 9.904576054128762e-002, 3.696438106143861e-001, 8.923991008325228e-001]
    sun = [1.074955473280880e011, -1.042430734878980e011, 4.036164305561260e009]
    for x in (450, 500):
        values = pixel([2e6, 2e6, 0.0], q, 40 * pi / 180, 1024, 1024, x, 100, sun)
        print(f"# section 9.2, pixel ({x},100): " + " ".join(nstr(v, 21) for v in (*values[:3], *values[5])))


if __name__ == "__main__":
    main()
    published()

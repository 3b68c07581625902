#!/usr/bin/env python3
"""Reference values for the layers of a sphere, with 50 digits; inputs are doubles that read back exactly.

The scenes are those of illumination.py. Angles are arc cosines of unit vectors, at 50 digits as good as anything. The pixel
scale comes from the solid angle of the whole pixel (A. van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125,
for its two triangles), not from the first-order formula of docs/formats.md.

    python3 tests/reference/layers.py > tests/golden/layers.tsv
"""
from illumination import RADIUS, Scenes, add, cross, dot, norm, rotate, scale, unit
from mpmath import acos, atan2, degrees, mpf, nstr, sqrt, tan


def solid_angle(a, b, c):
    a, b, c = unit(a), unit(b), unit(c)
    return 2 * atan2(abs(dot(a, cross(b, c))), 1 + dot(a, b) + dot(b, c) + dot(c, a))


def angle(u, v):
    return degrees(acos(min(dot(unit(u), unit(v)), mpf(1))))


def layers(position, q, fov, width, height, x, y, sun):
    """Depth, range, position, height, incidence, emission, phase, pixel scale; or None for space."""
    position, q, sun = ([mpf(c) for c in v] for v in (position, q, sun))
    aspect = mpf(width) / height
    forward = scale(aspect / 2 / tan(mpf(fov) / 2), rotate(q, [-1, 0, 0]))
    right = scale(aspect, rotate(q, [0, 1, 0]))
    up = rotate(q, [0, 0, 1])

    def ray_through(px, py):
        return add(forward, scale((1 + height - 2 * py) / (2 * height), up), scale((2 * px - 1 - width) / (2 * width), right))

    ray = unit(ray_through(mpf(x), mpf(y)))
    half_b = dot(position, ray)
    discriminant = half_b**2 - dot(position, position) + RADIUS**2
    if discriminant < 0 or half_b > 0:
        return None
    slant = -half_b - sqrt(discriminant)
    surface = add(position, scale(slant, ray))
    to_sun = add(sun, scale(-1, surface))
    to_camera = scale(-1, ray)
    half = mpf("0.5")
    corners = [ray_through(x + i, y + j) for i, j in ((-half, -half), (half, -half), (half, half), (-half, half))]
    solid = solid_angle(corners[0], corners[1], corners[2]) + solid_angle(corners[0], corners[2], corners[3])
    return (slant * dot(ray, unit(forward)), slant, *surface, norm(surface) - RADIUS, angle(surface, to_sun),
            angle(surface, to_camera), angle(to_sun, to_camera), slant * sqrt(solid))


def main():
    scenes = Scenes()
    print("# python3 tests/reference/layers.py (mpmath, 50 digits); doubles in, m and degrees out")
    print("# case\tx\ty\tz\tqx\tqy\tqz\tq0\tfov_rad\twidth\theight\tpixel_x\tpixel_y\tsun_x\tsun_y\tsun_z"
          "\tdepth\trange\tpoint_x\tpoint_y\tpoint_z\theight\tincidence\temission\tphase\tpixel_scale")
    for case, count in [("moderate", 30), ("one_metre_above", 10), ("pole", 10), ("subsolar", 10), ("light_at_camera", 10)]:
        found = 0
        while found < count:
            scene = getattr(scenes, case)()
            result = layers(*scene)
            if result is None or result[7] > 80:  # towards the limb the hit's own rounding grows
                continue
            found += 1
            position, q, fov, width, height, x, y, sun = scene
            numbers = [repr(float(c)) for c in (*position, *q, fov)] + [str(n) for n in (width, height, x, y)]
            numbers += [repr(float(c)) for c in sun]
            print("\t".join([case, *numbers, *(nstr(v, 25) for v in result)]))


if __name__ == "__main__":
    main()

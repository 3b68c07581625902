"""The camera of a camera file (docs/cameras.md) in numpy: rays of pixels, pixels of points. Lenses are inverted by Newton's method."""

import numpy as np

RADIUS = 1737400.0


class Camera:
    """A camera file, at a place; pixels from (0, 0), tangents right and down from the optical axis."""

    def __init__(self, file, position, axes):
        """file: the keys of a camera file; position: m; axes: rows right, down, forward, MOON_ME."""
        self.width, self.height = file["width"], file["height"]
        self.position, self.R = np.array(position, float), np.array(axes, float)
        focal = np.array(file.get("focal-length-px", 0.0)) + np.zeros(2)
        if "focal-length" in file:
            focal = file["focal-length"] / (np.array(file["pixel-pitch"]) + np.zeros(2))
        self.K = np.array([[focal[0], file.get("skew", 0.0), 0], [0, focal[1], 0], [0, 0, 1]])
        self.K[:2, 2] = np.array(file["principal-point"]) - 1.0
        lens = file.get("distortion")
        self.measured, self.ideal = LENSES[lens["model"]](lens, file.get("focal-length")) if lens else (None, None)

    def quaternion(self):
        """(qx, qy, qz, q0) that turns camera axes (looks along -x, y right, z up) into MOON_ME."""
        right, down, forward = self.R
        m = np.stack([-forward, right, -down], axis=1)
        q0 = 0.5 * np.sqrt(1.0 + np.trace(m))
        return np.array([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], 4.0 * q0 * q0]) / (4.0 * q0)

    def pixels(self):
        y, x = np.mgrid[0 : self.height, 0 : self.width]
        return np.stack([x.ravel(), y.ravel()], axis=1).astype(float)

    def rays(self, pixels):
        """Directions in MOON_ME whose part along the optical axis has length 1."""
        down = (pixels[:, 1] - self.K[1, 2]) / self.K[1, 1]
        seen = np.stack([(pixels[:, 0] - self.K[0, 2] - self.K[0, 1] * down) / self.K[0, 0], down], axis=1)
        ideal = seen if self.measured is None else self.ideal(seen) if self.ideal else inverse(self.measured, seen)
        return np.column_stack([ideal, np.ones(len(ideal))]) @ self.R

    def project(self, points):
        ahead = (points - self.position) @ self.R.T
        ideal = ahead[:, :2] / ahead[:, 2:]
        seen = ideal if self.measured is None else inverse(self.ideal, ideal) if self.ideal else self.measured(ideal)
        return (np.column_stack([seen, np.ones(len(seen))]) @ self.K.T)[:, :2]


def inverse(function, values):
    """Newton's method, from the values themselves."""
    at, step = values.copy(), 1e-6
    for _ in range(30):
        error = function(at) - values
        if np.abs(error).max() < 1e-14:
            return at
        slopes = [(function(at + step * e) - function(at - step * e)) / (2.0 * step) for e in np.eye(2)]
        at = at - np.linalg.solve(np.stack(slopes, axis=2), error[..., None])[..., 0]
    assert np.abs(function(at) - values).max() < 1e-12
    return at


def opencv(lens, _):
    """Also brown-conrady."""
    k1, k2, k3, k4, k5, k6, p1, p2, s1, s2, s3, s4 = (
        lens.get(name, 0.0) for name in ("k1", "k2", "k3", "k4", "k5", "k6", "p1", "p2", "s1", "s2", "s3", "s4")
    )

    def measured(at):
        x, y = at.T
        q = x * x + y * y
        c = (1 + k1 * q + k2 * q**2 + k3 * q**3) / (1 + k4 * q + k5 * q**2 + k6 * q**3)
        u = c * x + 2 * p1 * x * y + p2 * (q + 2 * x * x) + s1 * q + s2 * q * q
        v = c * y + p1 * (q + 2 * y * y) + 2 * p2 * x * y + s3 * q + s4 * q * q
        return np.stack([u, v], axis=1)

    return measured, None


def owen(lens, focal):
    e1, e2, e3, e4, e5, e6 = (lens.get(f"e{i}", 0.0) for i in range(1, 7))

    def measured(at):
        x, y = focal * at.T
        r = np.hypot(x, y)
        c, turn = 1 + e2 * r**2 + e4 * r**4 + e5 * y + e6 * x, e1 * r + e3 * r**3
        return np.stack([x * c - y * turn, y * c + x * turn], axis=1) / focal

    return measured, None


def fisheye(lens, _):
    k1, k2, k3, k4 = (lens.get(f"k{i}", 0.0) for i in range(1, 5))

    def measured(at):
        r = np.maximum(np.linalg.norm(at, axis=1), 1e-30)[:, None]
        t = np.arctan(r)
        return at * t * (1 + k1 * t**2 + k2 * t**4 + k3 * t**6 + k4 * t**8) / r

    return measured, None


def radial(lens, focal):
    k1, k2, k3 = lens["k"]

    def ideal(at):
        q = focal * focal * np.sum(at * at, axis=1)[:, None]
        c = 1 + k1 * q + k2 * q**2 + k3 * q**3
        return at / c if lens["form"] == "division" else at * c

    return True, ideal


def polynomial(lens, focal):
    def ideal(at):
        s = focal * (at[:, 0] if lens["argument"] == "x" else np.linalg.norm(at, axis=1))
        powers = np.stack([s**0, s, s**2, s**3])
        return at + np.stack([np.array(lens["x"]) @ powers, np.array(lens["y"]) @ powers], axis=1) / focal

    return True, ideal


def brown(lens, focal):
    k0, k1, k2, k3, p1, p2, s1, s2, s3, s4, x0, y0 = (
        lens.get(name, 0.0) for name in ("k0", "k1", "k2", "k3", "p1", "p2", "s1", "s2", "s3", "s4", "x0", "y0")
    )

    def ideal(at):
        x, y = (focal * at - [x0, y0]).T
        q = x * x + y * y
        c = k0 + k1 * q + k2 * q**2 + k3 * q**3
        u = c * x + p1 * (q + 2 * x * x) + 2 * p2 * x * y + s1 * q + s2 * q * q
        v = c * y + 2 * p1 * x * y + p2 * (q + 2 * y * y) + s3 * q + s4 * q * q
        return at + np.stack([u, v], axis=1) / focal

    return True, ideal


LENSES = {
    "opencv": opencv, "brown-conrady": opencv, "owen": owen, "fisheye": fisheye, "radial": radial, "polynomial": polynomial,
    "brown": brown,
}  # fmt: skip


def looking_down(file, latitude=20.0, longitude=-0.5, height=4e5, roll=25.0):
    """A camera straight above a place, between the last and the first sample of the elevation model's lines."""
    la, lo, turn = np.radians([latitude, longitude, roll])
    up = np.array([np.cos(la) * np.cos(lo), np.cos(la) * np.sin(lo), np.sin(la)])
    east = np.array([-np.sin(lo), np.cos(lo), 0.0])
    right = np.cos(turn) * east + np.sin(turn) * np.cross(up, east)
    return Camera(file, (RADIUS + height) * up, [right, np.cross(-up, right), -up])

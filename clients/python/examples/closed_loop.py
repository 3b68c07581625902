"""A closed loop: a Kalman filter finds its way over the Moon by what its camera sees.

Each step the true spacecraft takes a picture. The filter draws what it would see from where it believes to be, finds the same spots of
ground in both pictures, asks where these spots are, and corrects its position and velocity. Attitude and time are known.

    python closed_loop.py [FRAMES]
"""

from __future__ import annotations

import argparse
from typing import List, Tuple

import msisf
import numpy as np

MU = 4.902800066e12  # m^3/s^2, gravity of the Moon (JPL DE421)
SPIN = 2.6617e-6  # rad/s, of the frame MOON_ME about z
SPHERE = 1737400.0  # m
STEP = 5.0  # s between pictures
PIXELS = 128
HALF_PATCH, SEARCH = 8, 6  # px
LANDMARKS = 8
PIXEL_NOISE = 0.4  # px, of a spot that is found again
ACCELERATION_NOISE = 1e-4  # m/s^2
SECONDS_PER_DAY = 86400.0


def rate(state: np.ndarray) -> np.ndarray:
    """Motion in the frame that turns with the Moon."""
    position, velocity = state[:3], state[3:]
    gravity = -MU * position / np.linalg.norm(position) ** 3
    turning = [2.0 * SPIN * velocity[1] + SPIN**2 * position[0], -2.0 * SPIN * velocity[0] + SPIN**2 * position[1], 0.0]
    return np.concatenate((velocity, gravity + turning))


def propagate(state: np.ndarray, seconds: float) -> np.ndarray:
    """One step of Runge and Kutta's fourth order."""
    k1 = rate(state)
    k2 = rate(state + 0.5 * seconds * k1)
    k3 = rate(state + 0.5 * seconds * k2)
    k4 = rate(state + seconds * k3)
    return state + seconds / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)


def attitude(position: np.ndarray) -> np.ndarray:
    """The quaternion (qx, qy, qz, q0) of a camera that looks to the Moon's centre, north up: what a star tracker would tell."""
    up = position / np.linalg.norm(position)
    east = np.cross([0.0, 0.0, 1.0], up)
    east /= np.linalg.norm(east)
    m = np.column_stack((up, east, np.cross(up, east)))  # x against the line of sight, y right, z up
    q0 = 0.5 * np.sqrt(max(0.0, 1.0 + np.trace(m)))
    q = np.array([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]])
    if q0 > 1e-3:
        return np.append(q / (4.0 * q0), q0)
    axis = np.sqrt(np.maximum(0.0, (1.0 + np.diag(m)) / 2.0))
    return np.append(axis, 0.0)


def corners(image: np.ndarray) -> np.ndarray:
    """The spots with most contrast in both directions, one in each cell of a grid, [n, 2] of x, y."""
    dy, dx = np.gradient(image.astype(float))
    border, cell = HALF_PATCH + SEARCH + 1, PIXELS // 4
    sums = [box(dx * dx), box(dy * dy), box(dx * dy)]
    strength = sums[0] * sums[1] - sums[2] ** 2
    found: List[Tuple[float, int, int]] = []
    for top in range(border, PIXELS - border - 1, cell):
        for left in range(border, PIXELS - border - 1, cell):
            part = strength[top : min(top + cell, PIXELS - border), left : min(left + cell, PIXELS - border)]
            y, x = np.unravel_index(np.argmax(part), part.shape)
            found.append((float(part[y, x]), left + int(x), top + int(y)))
    return np.array([(x, y) for _, x, y in sorted(found, reverse=True)[:LANDMARKS]])


def box(values: np.ndarray) -> np.ndarray:
    """Sums over the 7 x 7 pixels around each."""
    return sums_over(np.pad(values, 3), 7)


def sums_over(values: np.ndarray, size: int) -> np.ndarray:
    """Sums over each square of so many pixels, by differences of running sums."""
    sums = np.pad(values, ((1, 0), (1, 0))).cumsum(axis=0).cumsum(axis=1)
    return sums[size:, size:] - sums[:-size, size:] - sums[size:, :-size] + sums[:-size, :-size]


def find(spot: np.ndarray, expected: np.ndarray, seen: np.ndarray) -> Tuple[np.ndarray, float]:
    """Where a spot of the expected picture is in the seen one, to a part of a pixel, and how alike the two are (1: the same)."""
    x, y = int(spot[0]), int(spot[1])
    size = 2 * HALF_PATCH + 1
    patch = expected[y - HALF_PATCH : y + HALF_PATCH + 1, x - HALF_PATCH : x + HALF_PATCH + 1].astype(float)
    reach = HALF_PATCH + SEARCH
    area = seen[y - reach : y + reach + 1, x - reach : x + reach + 1].astype(float)
    windows = np.lib.stride_tricks.sliding_window_view(area, (size, size))
    patch = patch - patch.mean()
    count = size * size
    products = np.einsum("abij,ij->ab", windows, patch)
    squares = sums_over(area**2, size) - sums_over(area, size) ** 2 / count
    likeness = products / (np.sqrt(np.maximum(squares, 0.0) * (patch**2).sum()) + 1e-9)
    row, column = np.unravel_index(np.argmax(likeness), likeness.shape)
    if not (0 < row < 2 * SEARCH and 0 < column < 2 * SEARCH):
        return spot.astype(float), 0.0
    offset = [column - SEARCH + vertex(likeness[row, column - 1 : column + 2]), row - SEARCH + vertex(likeness[row - 1 : row + 2, column])]
    return spot + np.array(offset), float(likeness[row, column])


def vertex(three: np.ndarray) -> float:
    """Where the parabola through three values has its top."""
    curvature = three[0] - 2.0 * three[1] + three[2]
    return float(0.5 * (three[0] - three[2]) / curvature) if curvature < 0.0 else 0.0


class Filter:
    """An extended Kalman filter of position and velocity."""

    def __init__(self, state: np.ndarray, covariance: np.ndarray) -> None:
        self.state, self.covariance = state, covariance

    def predict(self) -> None:
        steps = np.diag([1.0, 1.0, 1.0, 1e-3, 1e-3, 1e-3])
        after = propagate(self.state, STEP)
        transition = np.column_stack([(propagate(self.state + d, STEP) - after) / np.abs(d).max() for d in steps])
        noise = np.vstack((0.5 * STEP**2 * np.eye(3), STEP * np.eye(3))) * ACCELERATION_NOISE
        self.state = after
        self.covariance = transition @ self.covariance @ transition.T + noise @ noise.T

    def update(self, view: msisf.View, points: np.ndarray, pixels: np.ndarray) -> None:
        """Corrects by points (m) that are seen at pixels, and expected where the view projects them."""
        expected = view.project(points)
        ahead = points @ view.R.T + view.t
        rows = []
        for x, y, z in ahead:  # of the pixel, after the camera's position: t = -R position
            focal = view.K[0, 0]
            rows.append(np.array([[focal / z, 0.0, -focal * x / z**2], [0.0, focal / z, -focal * y / z**2]]) @ -view.R)
        design = np.hstack((np.vstack(rows), np.zeros((2 * len(points), 3))))
        innovation = (pixels - expected).ravel()
        total = design @ self.covariance @ design.T + PIXEL_NOISE**2 * np.eye(len(innovation))
        gain = np.linalg.solve(total, design @ self.covariance).T
        self.state = self.state + gain @ innovation
        self.covariance = (np.eye(6) - gain @ design) @ self.covariance


def run(moon: msisf.Moon, frames: int = 300) -> np.ndarray:
    """Flies; returns the error of the position after each frame, m."""
    camera = msisf.Camera(PIXELS, PIXELS, 40.0)
    mjd = 55289.0
    sun = np.radians(moon.sun(mjd)["sub_solar_point"]["longitude"])
    radius = SPHERE + 400e3
    start = sun - np.radians(75.0)  # the Sun stands low first, then higher
    speed = np.sqrt(MU / radius) - SPIN * radius
    truth = np.array([radius * np.cos(start), radius * np.sin(start), 0.0, -speed * np.sin(start), speed * np.cos(start), 0.0])
    believed = Filter(truth + [1500.0, -1200.0, 1000.0, 0.5, -0.5, 0.5], np.diag([2000.0**2] * 3 + [1.0] * 3))
    errors = []
    with moon.stream(camera=camera, bit_depth=16) as eye, moon.stream(camera=camera, bit_depth=16) as mind:
        for _ in range(frames):
            turn = attitude(truth[:3])
            seen = eye.render(truth[:3], turn, mjd)
            expected = mind.render(believed.state[:3], turn, mjd)
            spots = corners(expected)
            matches = [find(spot, expected, seen) for spot in spots]
            good = np.array([likeness > 0.8 for _, likeness in matches])
            if good.any():
                view = moon.view(believed.state[:3], turn, mjd, camera=camera)
                located = view.locate(spots[good])
                kept = [(point.position, pixel) for point, (pixel, _) in zip(located, np.array(matches, dtype=object)[good]) if point]
                believed.update(view, np.array([point for point, _ in kept]), np.array([pixel for _, pixel in kept]))
            errors.append(float(np.linalg.norm(believed.state[:3] - truth[:3])))
            truth = propagate(truth, STEP)
            believed.predict()
            mjd += STEP / SECONDS_PER_DAY
    return np.array(errors)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("frames", type=int, nargs="?", default=300, help="number of pictures (300)")
    words = parser.parse_args()
    with msisf.Moon() as moon:
        found = run(moon, words.frames)
    print(f"error of the position: {found[0]:.0f} m after the first frame, {found[-1]:.0f} m after the last")


if __name__ == "__main__":
    main()

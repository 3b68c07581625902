"""Finds a camera's pose from the ellipses of craters in its image, by least squares in numpy.

    python pose_from_craters.py CATALOGUE [--noise PX]
"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any, Tuple

import msisf
import numpy as np

RADIUS = 1737400.0
PHASES = np.linspace(0.0, 2.0 * np.pi, 5)[:-1]  # a few points of each rim


def rims(craters: Any) -> np.ndarray:
    """Points of the craters' rims, m, MOON_ME [crater, point, 3]: circles in the plane of the centre, as docs/navigation-truth.md says."""
    latitude, longitude = np.radians(craters.latitude), np.radians(craters.longitude)
    up = np.stack([np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)], axis=-1)
    east = np.stack([-np.sin(longitude), np.cos(longitude), np.zeros_like(longitude)], axis=-1)
    north = np.cross(up, east)
    centre = (RADIUS + craters.height)[:, None] * up
    around = np.cos(PHASES)[:, None] * east[:, None] + np.sin(PHASES)[:, None] * north[:, None]
    return centre[:, None] + 0.5 * craters.diameter[:, None, None] * around


def shapes(craters: Any) -> np.ndarray:
    """Centre and shape of ellipses, both in px [crater, 5]: shape^-1 is the form that is 1 on the ellipse."""
    turn = np.radians(craters.turn)
    along, across = craters.semiMajor, craters.semiMinor
    xx = (along * np.cos(turn)) ** 2 + (across * np.sin(turn)) ** 2
    yy = (along * np.sin(turn)) ** 2 + (across * np.cos(turn)) ** 2
    xy = (along**2 - across**2) * np.sin(turn) * np.cos(turn)
    return np.stack([craters.h - 1.0, craters.v - 1.0, np.sqrt(xx), np.sqrt(yy), xy / np.sqrt(np.sqrt(xx * yy))], axis=-1)


def seen(craters: Any, K: np.ndarray, R: np.ndarray, position: np.ndarray) -> np.ndarray:
    """The same of the craters as a camera sees them: the dual conic of each disc."""
    rim = rims(craters)
    centre = 0.5 * (rim[:, 0] + rim[:, 2])
    major, minor = rim[:, 0] - centre, rim[:, 1] - centre
    columns = np.stack([major, minor, centre - position], axis=-1)
    H = K @ R @ columns
    dual = H @ np.diag([1.0, 1.0, -1.0]) @ np.swapaxes(H, 1, 2)
    dual = dual / -dual[:, 2:, 2:]
    x, y = -dual[:, 0, 2], -dual[:, 1, 2]
    xx, yy, xy = dual[:, 0, 0] + x * x, dual[:, 1, 1] + y * y, dual[:, 0, 1] + x * y
    return np.stack([x, y, np.sqrt(xx), np.sqrt(yy), xy / np.sqrt(np.sqrt(xx * yy))], axis=-1)


def turned(R: np.ndarray, turn: np.ndarray) -> np.ndarray:
    """A rotation turned about its own axes by a small vector (rad), by Rodrigues's formula."""
    angle = np.linalg.norm(turn)
    if angle == 0.0:
        return R
    x, y, z = turn / angle
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return (np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * cross @ cross) @ R


def pose(craters: Any, measured: np.ndarray, K: np.ndarray, R: np.ndarray, position: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """R and position of the camera from a first guess, by Gauss and Newton."""
    for _ in range(30):
        height = np.linalg.norm(position) - RADIUS
        steps = np.array([1e-6] * 3 + [1e-6 * height] * 3)
        misfit = (measured - seen(craters, K, R, position)).ravel()
        slopes = []
        for i, step in enumerate(np.diag(steps)):
            more = seen(craters, K, turned(R, step[:3]), position + step[3:])
            less = seen(craters, K, turned(R, -step[:3]), position - step[3:])
            slopes.append((more - less).ravel() / (2.0 * steps[i]) * steps[i])
        change = np.linalg.lstsq(np.array(slopes).T, misfit, rcond=None)[0] * steps
        R, position = turned(R, change[:3]), position + change[3:]
        if np.linalg.norm(change[3:]) < 1e-6:
            break
    return R, position


def run(moon: msisf.Moon, catalogue: str, noise: float, seed: int = 1) -> Tuple[float, float, int]:
    """Error of the position (m), altitude (m) and number of craters of one image."""
    random = np.random.default_rng(seed)
    frame = moon.render(
        position=(-45.0, -10.0, 300e3), look_at=(-43.0, -8.0), time="2010-03-25T06:00:00Z", camera=msisf.Camera(1024, 1024, 50.0),
        craters=catalogue, crater_size=20.0, grid=1024,
    )  # fmt: skip
    craters = frame.craters[(frame.craters.inside == 1.0) & (frame.craters.hidden < 0.2)]
    measured = shapes(craters) + random.normal(0.0, noise, (len(craters), 5))
    start = frame.position + random.normal(0.0, 3e3, 3)
    _, position = pose(craters, measured, frame.K, turned(frame.R, random.normal(0.0, 0.01, 3)), start)
    return float(np.linalg.norm(position - frame.position)), float(np.linalg.norm(frame.position) - RADIUS), len(craters)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("catalogue", type=Path, help="of craters, CSV with columns lat, lon and diam_km")
    parser.add_argument("--noise", type=float, default=0.5, help="px: of each ellipse's centre and size (0.5)")
    words = parser.parse_args()
    with msisf.Moon(serve=["--catalogues", f"craters={words.catalogue}"]) as moon:
        error, altitude, count = run(moon, "craters", words.noise)
    print(f"{count} craters: {error:.1f} m off at {altitude / 1e3:.0f} km")


if __name__ == "__main__":
    main()

"""Compares the accuracy of a pose estimator with the bound that `msis --information` states.

    python pose_information.py [--msis PROGRAM] [--seeds N]

The program draws noisy images of one pose. A Gauss-Newton estimator in numpy, which uses the layers of `--sensitivity`, finds the pose from
each image. The six standard deviations over all images are compared with the Cramer-Rao bound.
"""

from __future__ import annotations

import argparse
import csv
import shlex
import subprocess
import tempfile
from pathlib import Path
from typing import Dict, List, Sequence, Tuple

import numpy as np

NAMES = ("position-x", "position-y", "position-z", "turn-x", "turn-y", "turn-z")
GAIN, READ_NOISE, BIAS = 4.0, 10.0, 64.0
CAMERA = f"""width: 64
height: 64
focal-length: 5
pixel-pitch: 0.06
detector:
  f-number: 4
  band: [500, 650]
  transmission: 0.8
  quantum-efficiency: 0.45
  exposure-time: 0.00001
  psf: gaussian
  psf-sigma: 0.8
  gain: {GAIN}
  read-noise: {READ_NOISE}
  bias: {BIAS}
  adc-bits: 16
  seed: 7
  fits: no
"""
MJD = 55292.85
PLACE, HEIGHT, RADIUS = (-43.3, -11.3), 60e3, 1737400.0
ROUNDS = 2  # of Gauss-Newton's method: the start is a few deviations off


def product(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    """The turn q, then p; quaternions with the scalar last."""
    vector = p[3] * q[:3] + q[3] * p[:3] + np.cross(p[:3], q[:3])
    return np.append(vector, p[3] * q[3] - p[:3] @ q[:3])


def rotated(q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """A vector turned by a quaternion."""
    twice = 2.0 * np.cross(q[:3], v)
    return v + q[3] * twice + np.cross(q[:3], twice)


def straight_down() -> np.ndarray:
    """A pose over the place: position (m, MOON_ME) and quaternion from camera axes (-x forward, y right, z up)."""
    latitude, longitude = np.radians(PLACE)
    up = np.array([np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)])
    east = np.array([-np.sin(longitude), np.cos(longitude), 0.0])
    m = np.column_stack([up, east, np.cross(up, east)])
    w = 0.5 * np.sqrt(1.0 + np.trace(m))
    vector = np.array([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]]) / (4.0 * w)
    return np.concatenate([(RADIUS + HEIGHT) * up, vector, [w]])


def moved(pose: np.ndarray, step: np.ndarray) -> np.ndarray:
    """A pose after a step along and about its own axes, m and rad."""
    angle = np.linalg.norm(step[3:])
    turn = np.append(0.5 * np.sinc(0.5 * angle / np.pi) * step[3:], np.cos(0.5 * angle))
    quaternion = product(pose[3:], turn)
    return np.concatenate([pose[:3] + rotated(pose[3:], step[:3]), quaternion / np.linalg.norm(quaternion)])


def between(truth: np.ndarray, pose: np.ndarray) -> np.ndarray:
    """The small step from one pose to another, along and about the first one's axes, m and rad."""
    back = truth[3:] * np.array([-1.0, -1.0, -1.0, 1.0])
    turn = product(back, pose[3:])
    return np.concatenate([rotated(back, pose[:3] - truth[:3]), 2.0 * np.sign(turn[3]) * turn[:3]])


def draw(msis: Sequence[str], folder: Path, poses: Sequence[np.ndarray], *options: str) -> List[str]:
    """Draws an image of each pose; returns the stems of its files."""
    folder.mkdir()
    (folder / "camera.yaml").write_text(CAMERA)
    lines = [" ".join(repr(float(value)) for value in np.append(MJD, pose)) for pose in poses]
    (folder / "poses.tab").write_text("\n".join(lines) + "\n")
    subprocess.run(
        [*msis, "--renderer", "native", "--samples", "256", "--lod", "off", "--camera", str(folder / "camera.yaml"),
         "--batch-file", str(folder / "poses.tab"), "--output-dir", str(folder), "--output-name", "image_{step:00000}", *options],
        check=True, stdout=subprocess.DEVNULL)
    return [str(path.with_suffix("")) for path in sorted(folder.glob("*.png"))]


def numbers(path: str) -> np.ndarray:
    """The digital numbers of an image of 16 bits: a PNG without interlace."""
    import struct
    import zlib

    data, at, packed = Path(path).read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IHDR":
            width, height = struct.unpack(">II", data[at + 8:at + 16])
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    rows = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, 1 + 2 * width)
    values = rows[:, 1:].astype(int)
    for y in range(height):
        filtered, above = rows[y, 0], values[y - 1] if y else np.zeros(2 * width, int)
        if filtered == 2:
            values[y] = (values[y] + above) & 255
            continue
        for x in range(2 * width if filtered else 0):
            left, corner = (values[y, x - 2], above[x - 2]) if x > 1 else (0, 0)
            guess = left + above[x] - corner
            nearest = min((left, above[x], corner), key=lambda value: abs(guess - value))
            values[y, x] = (values[y, x] + {1: left, 3: (left + above[x]) // 2, 4: nearest}[filtered]) & 255
    return 256 * values[:, 0::2] + values[:, 1::2]


def bound(path: str) -> Tuple[np.ndarray, np.ndarray]:
    """The bound of the six standard deviations, and the information [6, 6]."""
    with open(path, newline="") as file:
        rows: Dict[str, Dict[str, str]] = {row["row"]: row for row in csv.DictReader(file)}
    deviations = np.array([float(rows[name]["deviation"]) for name in NAMES])
    return deviations, np.array([[float(rows[a][f"information_{b}"]) for b in NAMES] for a in NAMES])


def run(msis: Sequence[str], seeds: int) -> Tuple[np.ndarray, np.ndarray, float]:
    """Estimates the pose from noisy images: standard deviations, their bounds, and the mean chi square, which should be 6."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        truth = straight_down()
        deviations, information = bound(draw(msis, folder / "truth", [truth], "--information", "pose")[0] + ".information.csv")
        noisy = draw(msis, folder / "noisy", [truth] * seeds, "--noise-seed", "1")
        images = [GAIN * (numbers(stem + ".png") - BIAS) for stem in noisy]
        start = moved(truth, 3.0 * deviations * np.array([1.0, -1.0, 1.0, -1.0, 1.0, -1.0]))
        poses = [start] * seeds
        for round_ in range(ROUNDS):
            stems = draw(
                msis, folder / f"round{round_}", poses, "--sensitivity", ",".join((*NAMES, "albedo")), "--layers", "electrons",
                "--layers-format", "npy")
            for seed, stem in enumerate(stems):
                expected = np.load(stem + ".electrons.npy").ravel()
                slopes = np.stack([np.load(f"{stem}.sensitivity.d-{n}.npy").ravel() for n in NAMES], axis=-1)
                # The brightness that the slopes belong to: at edges other samples than those of the image are lit.
                signal = np.load(stem + ".sensitivity.d-albedo.npy").ravel()
                weights = 1.0 / (signal + READ_NOISE**2 + GAIN**2 / 12.0)
                weighted = weights[:, None] * slopes
                step = np.linalg.solve(weighted.T @ slopes, weighted.T @ (images[seed].ravel() - expected))
                poses[seed] = moved(poses[seed], step)
        errors = np.array([between(truth, pose) for pose in poses])
        chi = np.einsum("si,ij,sj->s", errors, information, errors)
        return np.sqrt((errors**2).mean(axis=0)), deviations, float(chi.mean())


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--msis", default="msis", help="the program, with options if need be")
    parser.add_argument("--seeds", type=int, default=500, help="number of noisy images")
    arguments = parser.parse_args()
    found, bounds, chi = run(shlex.split(arguments.msis), arguments.seeds)
    for name, deviation, least in zip(NAMES, found, bounds):
        print(f"{name:11} {deviation:.4g} (bound {least:.4g}, ratio {deviation / least:.3f})")
    print(f"chi square {chi:.2f} in the mean over {arguments.seeds} images, 6 expected")


if __name__ == "__main__":
    main()

"""Follows a camera from image to image by the flow of its pixels and their depth, as visual odometry does.

    python visual_odometry.py [--frames N] [--noise PX]
"""

from __future__ import annotations

import argparse
import json
import subprocess
import tempfile
from pathlib import Path
from typing import Tuple

import numpy as np
from msisf._process import find_program
from pose_from_craters import turned


def draw(folder: Path, frames: int) -> None:
    """Draws a descent of 2 km an image with the flow to the next image and the depth of each pixel."""
    states = [f"2010-03-25T06:00:{i:02d}Z,{-58.0 + 0.05 * i},-14,{150000 - 2000 * i},-55,-12" for i in range(frames)]
    (folder / "states.csv").write_text("time,lat,lon,height,look_lat,look_lon\n" + "\n".join(states) + "\n")
    command = [
        find_program(), "--renderer", "native", "--batch-file", str(folder / "states.csv"), "--fov", "50", "--width", "128",
        "--height", "128", "--output-name", "{step:00}", "--output-dir", str(folder), "--batch", "--layers", "depth", "--layers-format", "npy",
        "--flow", "next", "--flow-format", "npy",
    ]  # fmt: skip
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def move(points: np.ndarray, pixels: np.ndarray, K: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """R and t of the next camera from points in this camera's axes and where they are seen next, by Gauss and Newton."""
    R, t = np.eye(3), np.zeros(3)
    for _ in range(20):
        x, y, z = (points @ R.T + t).T
        misfit = (pixels - np.stack([K[0, 0] * x / z + K[0, 2], K[1, 1] * y / z + K[1, 2]], axis=1)).ravel()
        zero = np.zeros_like(z)
        by_place = np.stack([
            np.stack([K[0, 0] / z, zero, -K[0, 0] * x / z**2], axis=1), np.stack([zero, K[1, 1] / z, -K[1, 1] * y / z**2], axis=1),
        ], axis=1)  # fmt: skip
        turned_points = np.stack([x, y, z], axis=1) - t
        by_turn = np.cross(turned_points[:, None], by_place)
        slopes = np.concatenate([by_turn, by_place], axis=2).reshape(-1, 6)
        change = np.linalg.lstsq(slopes, misfit, rcond=None)[0]
        R, t = turned(R, change[:3]), t + change[3:]
        if np.abs(change[3:]).max() < 1e-6:
            break
    return R, t


def run(folder: Path, frames: int = 6, noise: float = 0.2, seed: int = 1) -> Tuple[float, float]:
    """Error of the last position (m), and the length of the way (m)."""
    random = np.random.default_rng(seed)
    draw(folder, frames)
    cameras = [json.loads((folder / f"{step:02d}.layers.json").read_text()) for step in range(1, frames + 1)]
    K = np.array(cameras[0]["K"])
    R, t = np.array(cameras[0]["R"]), np.array(cameras[0]["t"])
    places = [-np.array(camera["R"]).T @ np.array(camera["t"]) for camera in cameras]
    y, x = np.mgrid[0:128, 0:128]
    rays = np.stack([(x - K[0, 2]) / K[0, 0], (y - K[1, 2]) / K[1, 1], np.ones_like(x)], axis=-1)
    for step in range(1, frames):
        depth, flow, kind = (np.load(folder / f"{step:02d}.{name}.npy") for name in ("depth", "flow", "flow-class"))
        shown = kind == 1
        pixels = (np.stack([x, y], axis=-1) + flow)[shown]
        step_R, step_t = move(rays[shown] * depth[shown][:, None], pixels + random.normal(0.0, noise, pixels.shape), K)
        R, t = step_R @ R, step_R @ t + step_t
    way = sum(float(np.linalg.norm(after - before)) for before, after in zip(places, places[1:]))
    return float(np.linalg.norm(-R.T @ t - places[-1])), way


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--frames", type=int, default=6, help="number of images (6)")
    parser.add_argument("--noise", type=float, default=0.2, help="px: of each pixel's flow (0.2)")
    words = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        error, way = run(Path(folder), words.frames, words.noise)
    print(f"{error:.2f} m off after {way / 1e3:.1f} km")


if __name__ == "__main__":
    main()

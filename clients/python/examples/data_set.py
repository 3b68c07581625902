"""Makes a data set with truth for learning: images, depth, normals and cameras of random places of the Moon.

    python data_set.py FOLDER [COUNT]
"""

from __future__ import annotations

import argparse
from pathlib import Path

import msisf
import numpy as np


def make(moon: msisf.Moon, folder: Path, count: int = 200, seed: int = 1) -> None:
    """Writes 00000.npz, 00001.npz, ...: image, depth (m), normal, mask, K, R, t, sun_direction."""
    folder.mkdir(parents=True, exist_ok=True)
    random = np.random.default_rng(seed)
    camera = msisf.Camera(256, 256, 30.0)
    made = 0
    while made < count:
        latitude = np.degrees(np.arcsin(random.uniform(-1.0, 1.0)))  # even on the sphere
        longitude = random.uniform(0.0, 360.0)
        mjd = 55289.0 + random.uniform(0.0, 365.0)
        sun = moon.sun(mjd, (latitude, longitude))
        if sun["elevation"] < 5.0:
            continue  # night
        frame = moon.render(
            position=(latitude, longitude, random.uniform(100e3, 500e3)),
            time=mjd,
            nadir=True,
            roll=random.uniform(0.0, 360.0),
            camera=camera,
            layers=["depth", "normal", "mask"],
        )
        np.savez_compressed(
            folder / f"{made:05d}.npz",
            image=frame.image, depth=frame.depth, normal=frame.normals, mask=frame.mask,
            K=frame.K, R=frame.R, t=frame.t, sun_direction=frame.sun_direction,
        )  # fmt: skip
        made += 1


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, help="receives 00000.npz, 00001.npz, ...; it is made if it is missing")
    parser.add_argument("count", type=int, nargs="?", default=200, help="number of images (200)")
    parser.add_argument("--seed", type=int, default=1, help="of the places and times (1); the same seed gives the same files")
    words = parser.parse_args()
    with msisf.Moon() as moon:
        make(moon, words.folder, words.count, words.seed)


if __name__ == "__main__":
    main()

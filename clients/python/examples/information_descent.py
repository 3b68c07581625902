"""Plots how accurately the images of a descent can tell the camera's pose, as `msis --information` states.

    python information_descent.py OUTPUT.png [--msis PROGRAM] [--csv OUTPUT.csv]

A camera comes down over Tycho, looking straight down or tilted by 30 degrees. Each image gives the Cramer-Rao bound of the camera's position
and orientation; the plot has the longest axes of their ellipsoids. OUTPUT.csv has a row for each image. Below its resolution the ground is
invented (--refine).
"""

from __future__ import annotations

import argparse
import csv
import shlex
import subprocess
import tempfile
from pathlib import Path
from typing import Dict, List, Sequence

import numpy as np
from pose_information import CAMERA, MJD, RADIUS, moved, straight_down

HEIGHTS = np.geomspace(100e3, 5e3, 10)  # m over the Moon's mean radius
TILTS = (0.0, 30.0)  # degrees from straight down
AXES = ("position-axis-1", "position-axis-3", "turn-axis-1", "turn-axis-3")


def bounds(path: Path) -> Dict[str, str]:
    """The longest and shortest axes of the bound's ellipsoids, m and rad; empty where the image does not tell them."""
    with open(path, newline="") as file:
        rows = {row["row"]: row["deviation"] for row in csv.DictReader(file)}
    return {name: rows.get(name, "") for name in AXES}


def descend(msis: Sequence[str]) -> List[Dict[str, str]]:
    """Draws the images; returns a row for each of them."""
    rows = [{"height": repr(float(height)), "tilt": repr(tilt)} for tilt in TILTS for height in HEIGHTS]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "camera.yaml").write_text(CAMERA)
        lines = []
        for row in rows:
            pose = straight_down()
            pose[:3] *= (RADIUS + float(row["height"])) / np.linalg.norm(pose[:3])
            pose = moved(pose, np.array([0.0, 0.0, 0.0, 0.0, np.radians(float(row["tilt"])), 0.0]))
            lines.append(" ".join(repr(float(value)) for value in np.append(MJD, pose)))
        (folder / "poses.tab").write_text("\n".join(lines) + "\n")
        subprocess.run(
            [*msis, "--renderer", "native", "--refine", "1", "--camera", str(folder / "camera.yaml"), "--information", "pose",
             "--batch-file", str(folder / "poses.tab"), "--output-dir", str(folder), "--output-name", "image_{step:00000}"],
            check=True, stdout=subprocess.DEVNULL)
        for row, path in zip(rows, sorted(folder.glob("*.information.csv"))):
            row.update(bounds(path))
    return rows


def plot(rows: Sequence[Dict[str, str]], output: str) -> None:
    """Draws the longest axes over the height."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, panels = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    for panel, axis, unit, scale in ((panels[0], "position-axis-1", "m", 1.0), (panels[1], "turn-axis-1", "mrad", 1e3)):
        for tilt, style in zip(TILTS, ("o-", "s--")):
            known = [row for row in rows if float(row["tilt"]) == tilt and row[axis]]
            panel.loglog(
                [float(row["height"]) / 1e3 for row in known], [scale * float(row[axis]) for row in known], style,
                label="straight down" if tilt == 0.0 else f"tilted by {tilt:.0f} degrees")
        panel.invert_xaxis()
        panel.set_xlabel("height over the mean radius, km")
        panel.set_ylabel(f"least standard deviation, {unit}")
        panel.set_title("position" if unit == "m" else "orientation")
        panel.grid(True, which="both", alpha=0.3)
        panel.legend()
    figure.savefig(output, dpi=110)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", help="the plot, PNG")
    parser.add_argument("--msis", default="msis", help="the program, with options if need be")
    parser.add_argument("--csv", help="receives a row for each image")
    arguments = parser.parse_args()
    rows = descend(shlex.split(arguments.msis))
    if arguments.csv:
        with open(arguments.csv, "w", newline="") as file:
            writer = csv.DictWriter(file, ["height", "tilt", *AXES], lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
    plot(rows, arguments.output)


if __name__ == "__main__":
    main()

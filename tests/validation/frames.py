"""Draws frames with ./msis and reads a layer of each."""
import pathlib
import subprocess

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]


def draw(folder, states, *options, layer="radiance-factor"):
    """A layer of each frame, [frame, y, x], 0 where no surface is seen.

    folder   where the frames are written; it must not exist
    states   rows of MJD (UTC), position (m, MOON_ME), quaternion x, y, z, w that turns msis's camera axes into MOON_ME axes
    """
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True)
    batch = folder / "states.tab"
    batch.write_text("".join(" ".join(repr(float(number)) for number in state) + "\n" for state in states))
    run("--batch-file", batch, "--renderer", "native", *options, "--lod", "off", "--batch", "--layers", layer, "--layers-format", "npy",
        "--output-dir", folder, "--output-name", "frame_{step:00000}")
    return [np.nan_to_num(np.load(folder / f"frame_{step:05d}.{layer}.npy"), nan=0.0) for step in range(1, len(states) + 1)]


def scan(folder, states, period, *options, layer="radiance-factor"):
    """A layer of a push-frame image in one run, [framelet, y, x], 0 where no surface is seen.

    folder   where the image is written; it must not exist
    states   of the framelets, as in draw; they are samples of one motion
    period   s from one framelet to the next
    """
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True)
    samples = folder / "samples.tab"
    samples.write_text("".join(" ".join(repr(float(number)) for number in state) + "\n" for state in states))
    run("--trajectory", samples, "--framelets", str(len(states)), "--scan-period", repr(period), "--renderer", "native", *options,
        "--lod", "off", "--batch", "--layers", layer, "--layers-format", "npy", "--output-dir", folder, "--output-name", "scan")
    image = np.nan_to_num(np.load(folder / f"scan.{layer}.npy"), nan=0.0)
    return image.reshape(len(states), -1, image.shape[1])


def run(*arguments):
    """Runs ./msis, and ends with its message if that fails."""
    done = subprocess.run([ROOT / "msis", *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"validation: msis ended with {done.returncode}: {done.stderr.strip()}")


def camera_quaternion(moon_from_camera):
    """x, y, z, w of msis's camera (looks along -x, y right, z up) from the axes right, down, forward as the columns of a matrix."""
    right, down, forward = np.asarray(moon_from_camera).T
    return quaternion(np.stack([-forward, right, -down], axis=1))


def quaternion(m):
    """x, y, z, w of a rotation matrix, by the largest component (Shepperd 1978)."""
    squares = np.array([1 + m[0, 0] - m[1, 1] - m[2, 2], 1 - m[0, 0] + m[1, 1] - m[2, 2],
                        1 - m[0, 0] - m[1, 1] + m[2, 2], 1 + np.trace(m)])
    rows = np.array([
        (squares[0], m[0, 1] + m[1, 0], m[0, 2] + m[2, 0], m[2, 1] - m[1, 2]),
        (m[0, 1] + m[1, 0], squares[1], m[1, 2] + m[2, 1], m[0, 2] - m[2, 0]),
        (m[0, 2] + m[2, 0], m[1, 2] + m[2, 1], squares[2], m[1, 0] - m[0, 1]),
        (m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], squares[3])])
    largest = rows[np.argmax(squares)]
    return largest / np.linalg.norm(largest)

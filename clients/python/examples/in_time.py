"""A camera at a fixed rate: is every image there in time? Draws a plot of all answers.

    python in_time.py [MINUTES] [--rate HZ] [--width PX] [--limit MS] [--ldem PATH] [--address URL] [--plot FILE.svg]

Each state has its time, and so many ms after it its image must be there: an image that comes late makes the next ones late too, as in a
loop with hardware. Ends with 1 if one came later than the limit.
"""

from __future__ import annotations

import argparse
import gc
import sys
import time
from pathlib import Path
from typing import List

import msisf
import numpy as np
from latency import WARM, pose

WIDE, HIGH, LEFT, TOP = 900, 320, 60, 50  # px of the plot's area, and its place


def fly(moon: msisf.Moon, width: int, rate: float, seconds: float) -> np.ndarray:
    """ms from the time of each state to its image."""
    late: List[float] = []
    with moon.stream(camera=msisf.Camera(width, width, 40.0)) as stream:
        for image in range(WARM):
            stream.render(*pose(image))
        gc.collect()
        gc.freeze()
        start = time.perf_counter()
        for image in range(max(1, round(rate * seconds))):
            due = start + image / rate
            time.sleep(max(0.0, due - time.perf_counter()))
            stream.render(*pose(WARM + image))
            late.append(1e3 * (time.perf_counter() - due))
    return np.array(late)


def summary(late: np.ndarray, limit: float) -> str:
    """One line about all answers."""
    p50, p99, most = np.percentile(late, [50, 99, 100])
    count = (late > limit).sum()
    return f"{len(late)} images: p50 {p50:.1f} ms, p99 {p99:.1f} ms, the latest {most:.1f} ms; {count} later than {limit:g} ms"


def plot(late: np.ndarray, rate: float, limit: float, title: str) -> str:
    """The answers as SVG: of each of at most 900 parts of the time the median and the latest."""
    parts = np.array_split(late, min(WIDE, len(late)))
    top = 1.1 * max(limit, late.max())
    minutes = len(late) / rate / 60.0

    def line(values: List[float], color: str) -> str:
        points = " ".join(f"{LEFT + WIDE * (k + 0.5) / len(values):.1f},{TOP + HIGH * (1 - y / top):.1f}" for k, y in enumerate(values))
        return f'<polyline points="{points}" fill="none" stroke="{color}"/>'

    def text(x: float, y: float, words: str, anchor: str = "middle") -> str:
        return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{words}</text>'

    level = TOP + HIGH * (1 - limit / top)
    return "\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDE + LEFT + 20}" height="{HIGH + TOP + 50}" '
        'font-family="sans-serif" font-size="13">',
        '<rect width="100%" height="100%" fill="white"/>',
        f'<rect x="{LEFT}" y="{TOP}" width="{WIDE}" height="{HIGH}" fill="none" stroke="gray"/>',
        text(LEFT, 20, title, "start"), text(LEFT, 40, summary(late, limit), "start"),
        f'<line x1="{LEFT}" x2="{LEFT + WIDE}" y1="{level:.1f}" y2="{level:.1f}" stroke="black" stroke-dasharray="6"/>',
        line([float(part.max()) for part in parts], "firebrick"), line([float(np.median(part)) for part in parts], "steelblue"),
        *(text(LEFT + WIDE * k / 5, TOP + HIGH + 18, f"{minutes * k / 5:.3g}") for k in range(6)),
        *(text(LEFT - 6, TOP + HIGH * (1 - k / 4) + 4, f"{top * k / 4:.0f}", "end") for k in range(5)),
        text(LEFT + WIDE / 2, TOP + HIGH + 40, "minutes; ms from state to image: red the latest of each part, blue the median"),
        "</svg>\n",
    ])  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("minutes", type=float, nargs="?", default=30.0, help="how long (30)")
    parser.add_argument("--rate", type=float, default=10.0, help="images a second (10)")
    parser.add_argument("--width", type=int, default=512, help="of the image, px (512)")
    parser.add_argument("--limit", type=float, default=100.0, help="the latest that an image may come, ms (100)")
    parser.add_argument("--ldem", help="the elevation model, as in msis serve --ldem; its finest one is taken")
    parser.add_argument("--address", help="of a server that runs already, in place of one that is started")
    parser.add_argument("--plot", type=Path, default=Path("in_time.svg"), help="the file of the plot (in_time.svg)")
    words = parser.parse_args()
    with msisf.Moon(words.address, serve=["--ldem", words.ldem] if words.ldem else []) as server:
        model = server.models()["models"][-1]["name"]
        late = fly(msisf.Moon(server.address, model=model), words.width, words.rate, 60.0 * words.minutes)
    title = f"{model}, {words.width} x {words.width} px, {words.rate:g} Hz, {words.minutes:g} minutes"
    words.plot.write_text(plot(late, words.rate, words.limit, title))
    print(f"{title}\n{summary(late, words.limit)}\n{words.plot}")
    sys.exit(bool((late > words.limit).any()))


if __name__ == "__main__":
    main()

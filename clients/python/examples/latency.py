"""How long a state takes to become an image: by the stream in lock-step, 1,000 images after 20.

    python latency.py [WIDTH [IMAGES [CLIENTS]]]

Prints the median and the 99th percentile of a client's time, and of the time that the server takes to draw the same image.
"""

from __future__ import annotations

import sys
import threading
import time
from typing import List

import msisf
import numpy as np

WARM = 20
POSITION, TURN, MJD = (1737400.0 + 100e3, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0), 55289.0  # 100 km over the middle of the near side, nadir


def measure(moon: msisf.Moon, width: int, images: int) -> List[float]:
    """ms for each image."""
    times = []
    with moon.stream(camera=msisf.Camera(width, width, 40.0)) as stream:
        for number in range(WARM + images):
            start = time.perf_counter()
            stream.render(POSITION, TURN, MJD + 1e-6 * number)
            times.append(1e3 * (time.perf_counter() - start))
    return times[WARM:]


def drawing(moon: msisf.Moon, width: int, images: int) -> List[float]:
    """ms that the renderer itself takes, as the server says with each answer."""
    times = []
    for number in range(WARM + images):
        moon.render(POSITION, TURN, MJD + 1e-6 * number, camera=msisf.Camera(width, width, 40.0))
        times.append(moon.last_times["draw"])
    return times[WARM:]


def main() -> None:
    width, images, clients = (int(word) for word in (sys.argv[1:] + ["1024", "1000", "1"][len(sys.argv) - 1 :]))
    with msisf.Moon() as moon:
        drawn = drawing(moon, width, min(images, 200))
        times: List[List[float]] = [[] for _ in range(clients)]
        threads = [threading.Thread(target=lambda own: own.extend(measure(moon, width, images)), args=(own,)) for own in times]
        start = time.perf_counter()
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        rate = clients * (images + WARM) / (time.perf_counter() - start)
    for name, values in [("renderer", drawn)] + [(f"client {number + 1}", values) for number, values in enumerate(times)]:
        print(f"{name}: p50 {np.percentile(values, 50):.2f} ms, p99 {np.percentile(values, 99):.2f} ms")
    print(f"together {rate:.1f} images/s")


if __name__ == "__main__":
    main()

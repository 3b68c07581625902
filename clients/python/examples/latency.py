"""How long a state takes to become an image: by the stream in lock-step, on this computer, after 200 images to warm up.

    python latency.py [WIDTH [IMAGES [CLIENTS]]] [--ldem PATH] [--model NAME]

Without WIDTH all is measured that has a target: 1024 x 1024 and 512 x 512 px, one client and four at once. The camera moves. The
renderer's own time is that of the same images. Processor time and memory are those of the whole program divided by the images.
"""

from __future__ import annotations

import argparse
import threading
import time
from typing import Dict, List, NamedTuple, Optional, Tuple

import msisf
import numpy as np

WARM = 200  # images: what is drawn first is compiled again and again
RADIUS, STEP, MJD = 1737400.0 + 100e3, 163.0 / 1837400.0, 55289.0  # m: 100 km up; rad: along the equator in 0.1 s; days


def pose(image: int) -> Tuple[Tuple[float, float, float], Tuple[float, float, float, float], float]:
    """Position, quaternion and time of an image: over the near side and on, nadir."""
    angle = STEP * image
    return ((RADIUS * np.cos(angle), RADIUS * np.sin(angle), 0.0), (0.0, 0.0, np.sin(0.5 * angle), np.cos(0.5 * angle)),
            MJD + image / 864000.0)


class Run(NamedTuple):
    """Times of the images of some clients, ms, and what the server needed for them."""

    client: List["np.ndarray"]
    drawing: List["np.ndarray"]
    rate: float
    needed: Dict[str, float]


def measure(moon: msisf.Moon, width: int, images: int, clients: int) -> Run:
    """Draws with some clients at once."""
    ready = threading.Barrier(clients + 1)
    client: List[List[float]] = [[] for _ in range(clients)]
    drawing: List[List[float]] = [[] for _ in range(clients)]

    def draw(number: int) -> None:
        with moon.stream(camera=msisf.Camera(width, width, 40.0), timing=True) as stream:
            for image in range(WARM):
                stream.render(*pose(image))
            ready.wait()
            for image in range(images):
                start = time.perf_counter()
                stream.render(*pose(WARM + image))
                client[number].append(1e3 * (time.perf_counter() - start))
                drawing[number].append(stream.last_times["draw"])

    threads = [threading.Thread(target=draw, args=(number,)) for number in range(clients)]
    for thread in threads:
        thread.start()
    ready.wait()
    before, start, own = moon.metrics(), time.perf_counter(), time.process_time()
    for thread in threads:
        thread.join()
    rate = clients * images / (time.perf_counter() - start)
    own = time.process_time() - own
    after, count = moon.metrics(), clients * images
    needed = {
        "server": 1e3 * (after["process_cpu_seconds_total"] - before["process_cpu_seconds_total"]) / count,
        "client": 1e3 * own / count,
        "bytes": (after["dotnet_allocated_bytes_total"] - before["dotnet_allocated_bytes_total"]) / count,
        "collections": sum(after[name] - before[name] for name in after if name == 'dotnet_collections_total{generation="2"}'),
    }
    return Run([np.array(times) for times in client], [np.array(times) for times in drawing], rate, needed)


def added_by_render(moon: msisf.Moon, width: int, images: int) -> float:
    """ms that ``render`` takes beside the drawing, the median."""
    added = []
    for image in range(WARM + images):
        start = time.perf_counter()
        moon.render(*pose(image), camera=msisf.Camera(width, width, 40.0))
        added.append(1e3 * (time.perf_counter() - start) - moon.last_times["draw"])
    return float(np.median(added[WARM:]))


def row(name: str, value: str, target: Optional[str] = None, is_met: bool = True) -> None:
    """Prints a line of the table."""
    print(f"{name:<58} {value:>14}  {'' if target is None else f'{target:<14} ' + ('met' if is_met else 'MISSED')}".rstrip())


def tell(run: Run, width: int) -> None:
    """Prints what one client met."""
    name, times, drawing = f"{width} x {width}", np.concatenate(run.client), np.concatenate(run.drawing)
    alone = float(np.percentile(drawing, 50))
    row(f"{name}, renderer alone, p50 and p99", f"{alone:.2f} {np.percentile(drawing, 99):.2f} ms")
    for part, limit in ((50, 1.1), (99, 1.6)):
        value = float(np.percentile(times, part))
        row(f"{name}, p{part}", f"{value:.2f} ms")
        row(f"{name}, p{part}, times the p50 of the renderer alone", f"{value / alone:.3f}", f"<= {limit}", value <= limit * alone)
    row(f"{name}, median of each image's own difference", f"{np.median(times - drawing):.2f} ms")
    row(f"{name}, processor time an image, server", f"{run.needed['server']:.2f} ms")
    row(f"{name}, processor time an image, client", f"{run.needed['client']:.2f} ms")
    row(f"{name}, memory allocated an image", f"{run.needed['bytes'] / 1024:.0f} KiB")
    row(f"{name}, collections of the whole memory", f"{run.needed['collections']:.0f}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("width", type=int, nargs="?")
    parser.add_argument("images", type=int, nargs="?", default=1000)
    parser.add_argument("clients", type=int, nargs="?", default=4)
    parser.add_argument("--ldem", help="the elevation model, as in msis serve --ldem; LDEM_64 is what the targets are for")
    parser.add_argument("--model", help="its name of /v1/models; the finest if it is missing")
    words = parser.parse_args()
    with msisf.Moon(serve=["--ldem", words.ldem] if words.ldem else []) as server:
        model = words.model or server.models()["models"][-1]["name"]
        moon = msisf.Moon(server.address, model=model)
        print(f"{model}, 100 km, nadir, 8 bits, lock-step, {words.images} images")
        for width in [words.width] if words.width else [512, 1024]:
            one = measure(moon, width, words.images, 1)
            tell(one, width)
            added = added_by_render(moon, width, min(words.images, 200))
            row(f"{width} x {width}, render() beside the drawing, median", f"{added:.2f} ms", "<= 3 ms", added <= 3.0)
        all_of_them = measure(moon, width, max(1, words.images // words.clients), words.clients)
        part = all_of_them.rate / one.rate
        row(f"{width} x {width}, images a second of one client", f"{one.rate:.1f}")
        row(f"{words.clients} clients together, part of that", f"{part:.2f}", ">= 0.90", part >= 0.9)
        medians = [float(np.median(times)) for times in all_of_them.client]
        ratio = max(medians) / min(medians)
        row("medians of the clients, slowest to fastest", f"{ratio:.2f}", "<= 1.50", ratio <= 1.5)


if __name__ == "__main__":
    main()

"""Keeps a server busy for a time with all kinds of clients, and says whether its memory grows.

    python soak.py [SECONDS [--ldem PATH]]

Exit code 1: a request failed that should not, or the memory at the end is more than 5 % above that after a quarter of the time.
"""

from __future__ import annotations

import argparse
import random
import socket
import sys
import threading
import time
from typing import Callable, List, NamedTuple
from urllib.parse import urlsplit

import msisf
import numpy as np

MOST_GROWTH = 0.05
WARM = 0.25  # part of the time until caches are filled


class Result(NamedTuple):
    """What happened: errors, answers, and the server's memory (bytes) after the warm part and at the end."""

    errors: List[str]
    answers: int
    before: float
    after: float

    @property
    def growth(self) -> float:
        """Part by which the memory grew."""
        return self.after / self.before - 1.0


def orbit(number: int) -> "tuple[tuple[float, float, float], float]":
    """A place over the Moon, and a time."""
    return (-60.0 + number * 7.3 % 120.0, number * 11.7 % 360.0, 50e3 + number * 1e3 % 400e3), 55289.0 + number * 0.01 % 300.0


def run(moon: msisf.Moon, seconds: float) -> Result:
    """Keeps the server busy: streams, single images with layers, pixels, wrong requests, and clients that go away."""
    end, errors, answers = time.monotonic() + seconds, [], [0]
    gate = threading.Lock()

    def client(seed: int, work: "Callable[[random.Random, int], None]") -> None:
        chance, number = random.Random(seed), 0
        while time.monotonic() < end and not errors:
            number += 1
            try:
                work(chance, number)
            except Exception as error:  # whatever it is, it is the result
                errors.append(f"{work.__name__} {number}: {type(error).__name__}: {error}")
            with gate:
                answers[0] += 1

    def streams(chance: random.Random, number: int) -> None:
        width = chance.choice([128, 256, 512])
        with moon.stream(camera=msisf.Camera(width, width, 40.0), newest_only=chance.random() < 0.5) as stream:
            for step in range(30):
                angle = 1e-3 * (30 * number + step)
                place = 1.85e6 * np.array([np.cos(angle), np.sin(angle), 0.0])
                turn = (0.0, 0.0, np.sin(angle / 2.0), np.cos(angle / 2.0))
                assert stream.render(place, turn, 55289.0 + angle).shape == (width, width)

    def images(chance: random.Random, number: int) -> None:
        place, mjd = orbit(number)
        options = chance.choice([{}, {"samples": 4}, {"sun": "disc"}, {"shading": "smooth"}, {"reflectance": "lambert"}, {"bit_depth": 16}])
        layers = chance.choice([[], ["depth"], ["position", "incidence"]])
        camera = msisf.Camera(chance.choice([64, 256]), 200, chance.uniform(5.0, 60.0))
        frame = moon.render(place, time=mjd, nadir=True, camera=camera, layers=layers, **options)
        frame.locate([[10.0, 20.0], [31.5, 99.25]])

    def wrong(chance: random.Random, number: int) -> None:
        place, mjd = orbit(number)
        option = {chance.choice(["samples", "fov", "bit_depth", "nothing"]): chance.choice([-1, 1e300, "x"])}
        try:
            moon.render(place, time=mjd, nadir=True, **option)
        except msisf.RequestError as error:
            assert error.status in (400, 413, 422), f"status {error.status}"

    def leaves(chance: random.Random, number: int) -> None:
        address = urlsplit(moon.address)
        body = b'{"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "width": 512, "height": 512, "samples": 16}'
        head = b"POST /v1/render HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: %d\r\n\r\n" % len(body)
        whole = head + body
        with socket.create_connection((address.hostname or "", address.port or 0)) as connection:
            connection.sendall(whole[: chance.randrange(len(whole) + 1)])
            time.sleep(chance.uniform(0.0, 0.1))

    threads = [threading.Thread(target=client, args=(seed, work)) for seed, work in enumerate([streams, streams, images, wrong, leaves])]
    for thread in threads:
        thread.start()
    samples: List["tuple[float, float]"] = []
    while time.monotonic() < end and not errors:
        time.sleep(min(1.0, seconds / 40.0))
        samples.append((seconds - (end - time.monotonic()), moon.metrics()["process_resident_memory_bytes"]))
    for thread in threads:
        thread.join()

    def memory(start: float) -> float:
        """Mean over an eighth of the time: collections make it go up and down."""
        return float(np.mean([bytes_ for at, bytes_ in samples if start * seconds <= at <= (start + 0.125) * seconds] or [np.nan]))

    return Result(errors, answers[0], memory(WARM), memory(0.875))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("seconds", type=float, nargs="?", default=3600.0)
    parser.add_argument("--ldem", help="the elevation model, as in msis serve --ldem")
    words = parser.parse_args()
    with msisf.Moon(serve=["--ldem", words.ldem] if words.ldem else []) as moon:
        result = run(moon, words.seconds)
    for error in result.errors:
        print(error)
    print(f"{result.answers} answers in {words.seconds:.0f} s, {len(result.errors)} errors; memory {result.before / 2**20:.0f} MiB, "
          f"at the end {result.after / 2**20:.0f} MiB ({100.0 * result.growth:+.1f} %)")  # fmt: skip
    return 1 if result.errors or not result.growth <= MOST_GROWTH else 0


if __name__ == "__main__":
    sys.exit(main())

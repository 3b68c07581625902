"""Measures what light from the ground costs against its error, and writes the table of docs/performance.md.

/usr/bin/python3 -B tests/Msisf.Benchmarks/plots/indirect.py [--msis PROGRAM] [--errors PART,...] [--side PIXELS] [--write]

In the root of the repository, after scripts/build.sh and scripts/get-ldem.sh. The view is that of docs/photometry.md: from 50 km into a
crater at the south pole, on a synthetic map of 50 m inside LDEM_4 that is made first; one of 512 x 512 pixels at the default error comes
first. The others, smaller, see a little more, so that some of the ground is lit; that with the least error is what they are compared with.
Without --write the table is printed only. Needs numpy.
"""
import argparse
import os
import subprocess
import tempfile
import time

import numpy as np

PAGE = os.path.join("docs", "performance.md")
BEGIN, END = "<!-- indirect.py: begin -->", "<!-- indirect.py: end -->"
BASE = "input/ldem/LDEM_4.LBL"
MAP = ["ldem", "synthesize", "--projection", "polar-south", "--map-scale", "50", "--latitude", "88.5", "--seed", "3", "--base", BASE]
VIEW = [
    "--renderer", "native", "--ldem", BASE, "--position=-89.739,122,terrain+50000", "--time", "2026-01-01T00:00:00Z",
    "--ephemeris", "builtin", "--sun-position", "{1.495e11,0,-7e9}", "--albedo-map", "none", "--exposure", "200", "--jobs", "2",
    "--layers-format", "npy", "--batch",
]  # fmt: skip
FULL, DEFAULT = 512, "0.01"
FIELD, WIDER = "14", "20"  # degrees
SHADOW = 3  # from this number on the layer mask means ground on which the Sun does not shine


def run(program, options):
    """Processor and wall seconds of a run, from the start of the process to its end, all files written."""
    start = time.monotonic()
    child = subprocess.Popen([*program, *options], stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        raise SystemExit(f"msis ended with {child.returncode}")
    return usage.ru_utime + usage.ru_stime, time.monotonic() - start


def drawn(program, folder, side, error):
    """Processor and wall seconds of a drawing; its light from the ground, and which pixels lie in shadow."""
    light = ["--layers", "mask,indirect", "--indirect", "--indirect-error", error] if error else ["--layers", "mask"]
    name = f"drawn-{side}-{error}"
    field = FIELD if side == FULL else WIDER
    size = ["--fov", field, "--width", str(side), "--height", str(side), "--output-dir", folder, "--output-name", name]
    times = run(program, [*VIEW, "--ldem", os.path.join(folder, "LDEM_885S_50M_SYNTHETIC.LBL"), *size, *light])
    if not error:
        return times, None, None
    indirect, mask = (np.load(os.path.join(folder, f"{name}.{layer}.npy")) for layer in ("indirect", "mask"))
    return times, np.where(mask > 0, indirect, 0.0), mask >= SHADOW


def rms(values):
    return float(np.sqrt(np.mean(values * values)))


def table(program, errors, side):
    with tempfile.TemporaryDirectory() as folder:
        run(program, [*MAP, "--output-dir", folder, "--batch"])
        yield "| drawing | processor time | wall time | rms difference in shadow | over all pixels |"
        yield "|---|---|---|---|---|"
        for error, what in ((None, "the Sun alone"), (DEFAULT, f"`--indirect`, {DEFAULT}")):
            (processor, wall), _, _ = drawn(program, folder, FULL, error)
            yield f"| {FULL} x {FULL}, {what} | {processor:.1f} s | {wall:.1f} s | | |"
        finest = min(errors, key=float)
        times, exact, shadow = drawn(program, folder, side, finest)
        for error in errors:
            (processor, wall), light, _ = (times, None, None) if error == finest else drawn(program, folder, side, error)
            differences = "| | |"
            if light is not None:
                parts = (rms((light - exact)[pixels]) / rms(exact[pixels]) for pixels in (shadow, shadow >= 0))
                differences = "".join(f"| {part:.3f} " for part in parts) + "|"
            yield f"| {side} x {side}, {error} | {processor:.1f} s | {wall:.1f} s {differences}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--msis", default="./msis")
    parser.add_argument("--errors", default="0.04,0.02,0.01,0.005,0.0025")
    parser.add_argument("--side", default=64, type=int)
    parser.add_argument("--write", action="store_true")
    chosen = parser.parse_args()
    rows = []
    for row in table(chosen.msis.split(), chosen.errors.split(","), chosen.side):
        print(row, flush=True)
        rows.append(row)
    if chosen.write:
        with open(PAGE, encoding="utf-8") as page:
            before, rest = page.read().split(BEGIN)
        after = rest.split(END)[1]
        with open(PAGE, "w", encoding="utf-8") as page:
            page.write("\n".join([before + BEGIN, "", *rows, "", END + after]))


if __name__ == "__main__":
    main()

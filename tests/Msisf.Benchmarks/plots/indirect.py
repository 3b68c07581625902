"""Measures what light from the ground costs against its error, and writes the tables of its page.

/usr/bin/python3 -B tests/Msisf.Benchmarks/plots/indirect.py [--msis PROGRAM] [--side PIXELS] [--write]

In the root of the repository, after scripts/build.sh and ./msis fetch ldem. First the view of docs/photometry.md, from 50 km into a
crater at the south pole, on a synthetic map of 50 m inside LDEM_4 that is made before; then several scenes at the default error, each against a
drawing at a quarter of it, which is 16 times the work. Without --write the tables are printed only. Needs numpy.
"""
import argparse
import os
import subprocess
import tempfile
import time

import numpy as np

PAGE = os.path.join("tests", "Msisf.Benchmarks", "results", "light-from-the-ground.md")
BEGIN, END = "<!-- indirect.py: begin -->", "<!-- indirect.py: end -->"
BASE = "input/ldem/LDEM_4.LBL"
MAP = ["ldem", "synthesize", "--projection", "polar-south", "--map-scale", "50", "--latitude", "88.5", "--seed", "3", "--base", BASE]
VIEW = [
    "--renderer", "native", "--ldem", BASE, "--time", "2026-01-01T00:00:00Z", "--ephemeris", "builtin", "--albedo-map", "none",
    "--exposure", "200", "--jobs", "2", "--layers-format", "npy", "--batch",
]  # fmt: skip
FULL, DEFAULT, FINER = 512, "0.01", "0.0025"  # a quarter of the error is 16 times the work
CRATER = ["--position=-89.739,122,terrain+50000", "--sun-position={1.495e11,0,-7e9}"]
REFINED = ["--refine", "7", "--refine-cell", "32", "--position=-20,15,terrain+6000", "--fov", "20"]
SCENES = {  # and whether the map of 50 m is there
    "crater's floor at the pole, all in shadow": (True, [*CRATER, "--fov", "14"]),
    "the crater and its rim": (True, [*CRATER, "--fov", "20"]),
    "the rim at 25 m a pixel": (True, [*CRATER[1:], "--position=-89.5,0,terrain+50000", "--fov", "1"]),
    "highlands from 2,000 km, low Sun": (False, ["--position=-35,10,2000000", "--sun-position={1.2e10,1.4e11,-5.1e10}", "--fov", "10"]),
    "highlands from 300 km, high Sun": (False, ["--position=-43,-11,terrain+300000", "--sun-position={1.47e11,-2.9e10,0}", "--fov", "20"]),
    "highlands with invented ground, low Sun": (False, [*REFINED, "--sun-position={-2e10,1.4e11,-5.1e10}"]),
    "the same, high Sun": (False, [*REFINED, "--sun-position={1.45e11,3.9e10,0}"]),
}
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


def drawn(program, folder, scene, side, error):
    """Processor and wall seconds of a drawing; its light from the ground, and which pixels lie in shadow."""
    has_map, view = SCENES[scene]
    light = ["--layers", "mask,indirect", "--indirect", "--indirect-error", error] if error else ["--layers", "mask"]
    name = f"drawn-{list(SCENES).index(scene)}-{side}-{error}"
    maps = ["--ldem", os.path.join(folder, "LDEM_885S_50M_SYNTHETIC.LBL")] if has_map else []
    size = ["--width", str(side), "--height", str(side), "--output-dir", folder, "--output-name", name]
    times = run(program, [*VIEW, *maps, *view, *size, *light])
    if not error:
        return times, None, None
    indirect, mask = (np.load(os.path.join(folder, f"{name}.{layer}.npy")) for layer in ("indirect", "mask"))
    return times, np.where(mask > 0, indirect, 0.0), mask >= SHADOW


def rms(values):
    return float(np.sqrt(np.mean(values * values)))


def table(program, side):
    with tempfile.TemporaryDirectory() as folder:
        run(program, [*MAP, "--output-dir", folder, "--batch"])
        yield "| drawing | processor time | wall time |"
        yield "|---|---|---|"
        for error, what in ((None, "the Sun alone"), (DEFAULT, f"`--indirect`, {DEFAULT}")):
            (processor, wall), _, _ = drawn(program, folder, next(iter(SCENES)), FULL, error)
            yield f"| {FULL} x {FULL}, {what} | {processor:.1f} s | {wall:.1f} s |"
        yield ""
        yield f"| {side} x {side} | processor time at {DEFAULT} | at {FINER} | rms difference | in shadow alone |"
        yield "|---|---|---|---|---|"
        for scene in SCENES:
            (coarse_time, _), light, shadow = drawn(program, folder, scene, side, DEFAULT)
            (fine_time, _), exact, _ = drawn(program, folder, scene, side, FINER)
            dark = f"{rms((light - exact)[shadow]) / rms(exact[shadow]):.3f}" if exact[shadow].any() else ""
            yield f"| {scene} | {coarse_time:.1f} s | {fine_time:.1f} s | {rms(light - exact) / rms(exact):.3f} | {dark} |"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--msis", default="./msis")
    parser.add_argument("--side", default=32, type=int)
    parser.add_argument("--write", action="store_true")
    chosen = parser.parse_args()
    rows = []
    for row in table(chosen.msis.split(), chosen.side):
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

#!/usr/bin/env python3
"""Puts what is promised beside what the stress tests found, in one table for docs/accuracy.md.

    /usr/bin/python3 promises.py STRESS.CSV FOLDER      writes FOLDER/promises.md
"""
import csv
import pathlib
import re
import sys

# What the reader wants to know, and the figure of stress.csv that says it.
PROMISES = (
    ("Point that a pixel shows, on the reference sphere; camera within 1e7 m, seen below 84 degrees",
     "camera", "hit point on the reference sphere, camera within 1e7 m, emission below 84 degrees"),
    ("The same on the terrain", "camera", "hit point on the terrain, camera within 1e7 m, facet seen below 84 degrees"),
    ("Pixels that name another facet than the first that their ray enters", "camera", "terrain: rays that meet no facet or another than the first they enter"),
    ("Direction of a pixel's ray", "camera", "direction of a pixel's ray"),
    ("Latitude in the meta file, where the inputs can hold it (below)", "coordinates", "latitude"),
    ("Longitude, likewise", "coordinates", "longitude"),
    ("Illumination direction, likewise", "coordinates", "illumination direction"),
    ("Pixels that differ because tiles were left out, LDEM_4", "selection", "LDEM_4: pixels that differ from the image with all tiles"),
    ("Part of an image's pixels in which the two renderers differ by more than a grey level", "renderers", "part of an image's pixels that differ by more than one grey level"),
    ("POV-Ray's surface from the facets of the pattern", "pov-ray-trace", "tile-local mesh2: from the facet's plane"),
    ("Bytes in which the two writers of patterns differ", "pattern-writers", "bytes of a file that differ"),
    ("Kepler's equation: residual in units of the last place of M", "kepler", "residual, in units of the last place of the M given"),
    ("Phase on an orbit after up to a million turns", "propagation", "phase"),
    ("Orbital position from elements, of its length", "elements", "position from elements, of its length"),
    ("Attitude after up to 10 million steps", "attitude", "transition, difference from the closed form"),
    ("Time steps of 1e-6 s that stand still, until 2038", "time", "steps of 1e-6 s that stand still or go back, in MJD or TDB"),
    ("CSPICE and the built-in reader: the Sun's position, of its distance", "ephemeris-engines", "the Sun with --aberration lt+s, difference in parts of its distance"),
    ("Processes killed at any moment: files that differ from an undisturbed run", "kills", "files that differ from those of one undisturbed process"),
    ("The same with Slurm and its daemons killed", "slurm-kills", "files that differ from those of one undisturbed process"),
    ("16 processes in one folder: frames made twice", "crowd", "frames made again that were not in flight"),
    ("Damaged inputs that end with a crash", "fuzz", "calls that ended with exit code 70 or an exception"),
)


def text_of(number, unit):
    """Three digits, e.g. 2.8e-8 m; 8 x 2^-53 rad."""
    text = re.sub(r"e([+-])0", r"e\1", f"{float(number):.3g}")
    times = "x " if unit[:1].isdigit() else ""
    return text if unit in ("", "1") else f"{text} {times}{unit}"


def table(rows):
    figures = {(row["test"], row["quantity"]): row for row in rows if row["limit"]}
    lines = ["| what | at most | found | test | its cases |", "|---|---|---|---|---|"]
    for words, test, quantity in PROMISES:
        if (test, quantity) not in figures:
            raise SystemExit(f"promises.py: there is no figure with a limit, \"{quantity}\", of the test {test}")
        row = figures[test, quantity]
        found = text_of(row["worst"], row["unit"]) + (" (**missed**)" if row["verdict"] == "missed" else "")
        lines.append(f"| {words} | {text_of(row['limit'], row['unit'])} | {found} | [{test}](../tests/Msisf.Benchmarks/results/accuracy-tables.md#{test}) | {int(row['cases']):,} |")
    verdicts = [row["verdict"] for row in rows]
    met, missed = verdicts.count("met"), verdicts.count("missed")
    return [*lines, "", f"{met} of {met + missed} limits are met, {missed} missed."]


def main(path, folder):
    with open(path, newline="", encoding="utf-8") as file:
        lines = table(list(csv.DictReader(file)))
    pathlib.Path(folder, "promises.md").write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])

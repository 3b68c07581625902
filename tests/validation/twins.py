#!/usr/bin/env python3
"""Draws the twins of real images, and writes a line for each into the table of docs/validation.md; lines of other images stay.

    /usr/bin/python3 -B tests/validation/twins.py --page docs/validation.md --folder FOLDER LABEL...

What an image needs beyond its label stands in LABEL.options, as the program takes it with @FILE. ./benchmark.sh --validate LABEL...
calls it.
"""
import argparse
import json
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
BEGIN, END = "<!-- twins: begin -->", "<!-- twins: end -->"
HEAD = ["| image | camera | px | pixels compared | correlation | relative rms | shift, px | blocks of 64 px, shifts |",
        "|---|---|---|---|---|---|---|---|"]


def twin(label, folder):
    """The numbers of an image's twin."""
    options = pathlib.Path(f"{label}.options")
    done = subprocess.run(
        [ROOT / "msis", "twin", label, "--output-dir", folder, "--batch", *([f"@{options}"] if options.exists() else [])],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"validation: {done.stderr.strip()}")
    numbers = next(line for line in done.stdout.splitlines() if line.endswith(".twin.json"))
    return json.loads(pathlib.Path(numbers).read_text(encoding="utf-8"))


def line(found):
    """A row of the table."""
    name, compared = f"`{found['label']}`", found["comparison"]
    size = f"{found['samples']} x {found['lines']}"
    if compared is None:
        return f"| {name} | {found['camera']} | {size} | none | | | | |"
    shifts = [block["shift"] for block in compared["blocks"] if block["shift"]]
    spread = "none"
    if shifts:
        values = ([shift[axis] for shift in shifts] for axis in ("right", "down"))
        ranges = (f"{min(found):+.2f} to {max(found):+.2f}" for found in values)
        spread = f"{len(shifts)}: {', '.join(ranges)}"
    whole = compared["shift"]
    moved = "none" if whole is None else f"{whole['right']:+.2f}, {whole['down']:+.2f}"
    return (f"| {name} | {found['camera']} | {size} | {compared['pixels']:,} | {compared['correlation']:.3f} | "
            f"{100 * compared['relativeRms']:.1f} % | {moved} | {spread} |")


def merged(page, rows):
    """The page with the rows in its table, in the order of the images' names."""
    before, _, rest = page.partition(BEGIN)
    inside, _, after = rest.partition(END)
    if not rest or not after:
        raise SystemExit(f"validation: the page needs the lines {BEGIN} and {END}")
    table = {row.split("|")[1]: row for row in inside.splitlines() if row.startswith("| `")}
    table.update({row.split("|")[1]: row for row in rows})
    return "\n".join([before + BEGIN, "", *HEAD, *(table[name] for name in sorted(table)), "", END]) + after


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--page", type=pathlib.Path, required=True)
    arguments.add_argument("--folder", type=pathlib.Path, required=True)
    arguments.add_argument("labels", nargs="+", type=pathlib.Path)
    given = arguments.parse_args()
    rows = [line(twin(label, given.folder / label.stem)) for label in given.labels]
    print("\n".join([*HEAD, *rows]))
    given.page.write_text(merged(given.page.read_text(encoding="utf-8"), rows), encoding="utf-8")


if __name__ == "__main__":
    main()

"""Measures how processor time and memory of a scan grow with its lines, and writes the table of its page.

/usr/bin/python3 -B tests/Msisf.Benchmarks/plots/scans.py [--msis PROGRAM] [--lines N,...] [--write]

In the root of the repository, after scripts/build.sh and ./msis fetch ldem. Each scan is one of LRO's narrow angle camera from 100 km over
LDEM_4, alone and with the layer depth in single precision. Without --write the table is printed only.
"""
import argparse
import os
import subprocess
import tempfile

PAGE = os.path.join("tests", "Msisf.Benchmarks", "results", "lines-of-a-scan.md")
BEGIN, END = "<!-- scans.py: begin -->", "<!-- scans.py: end -->"
ORBIT = ["--kepler-set", "{1.8374E6,0,0,0.3,1.5,0.52}", "--epoch", "55289", "--time", "2010-04-03T00:00:00Z"]
LAYER = ["--layers", "depth", "--layers-precision", "single"]


def measured(program, lines, options):
    """Processor seconds and MB of a run, from the start of the process to its end, all files written."""
    with tempfile.TemporaryDirectory() as folder:
        command = [
            *program, *ORBIT, "--renderer", "native", "--camera", "lroc-nac-l", "--lines", str(lines), "--ldem", "input/ldem/LDEM_4.LBL",
            "--ephemeris", "builtin", "--grid", "500", "--batch", "--output-dir", folder, *options,
        ]  # fmt: skip
        child = subprocess.Popen(command, stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode != 0:
            raise SystemExit(f"msis ended with {child.returncode}")
        return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1000.0


def table(program, counts):
    yield "| lines of 5,064 px | processor time | memory at most | with the layer `depth`, processor time | memory at most |"
    yield "|---|---|---|---|---|"
    for lines in counts:
        (alone, own), (layered, more) = (measured(program, lines, options) for options in ([], LAYER))
        yield f"| {lines:,} | {alone:.1f} s | {own:.0f} MB | {layered:.1f} s | {more:.0f} MB |"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--msis", default="./msis")
    parser.add_argument("--lines", default="1000,5000,20000,50000")
    parser.add_argument("--write", action="store_true")
    chosen = parser.parse_args()
    rows = []
    for row in table(chosen.msis.split(), [int(lines) for lines in chosen.lines.split(",")]):
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

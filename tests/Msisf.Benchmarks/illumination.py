"""Measures what a cell of `msis illumination` costs, and writes the table of docs/illumination.md.

    python3 -B tests/Msisf.Benchmarks/illumination.py PROGRAM [CELLS] [--write]

PROGRAM is the built msis; the map is a synthetic one of 100 m, made once in benchmark/illumination; CELLS x CELLS cells of 20 m (100).
Processor time of whole processes, so that other programs hardly count: a day with new horizons, the same with kept ones, a year with
kept ones. The first less the second is the horizons' time, the third less the second the light's; of both that of a single cell is
taken off, which has the same ephemerides to compute. With --write the table goes into docs/illumination.md, else to standard output.
"""
import os
import pathlib
import shutil
import sys

PLACES = {"a ridge, 89.45 degrees south": "-89.45,222.7", "a slope, 88.6 degrees south": "-88.6,40"}
DAY, YEAR = ("2026-01-01T00:00:00Z:1h:2026-01-02T00:00:00Z", "2026-01-01T00:00:00Z:1h:2027-01-01T00:00:00Z")
BEGIN, END = "<!-- illumination.py: begin -->\n", "<!-- illumination.py: end -->\n"


def run(*arguments):
    """Processor time in s and greatest memory in MB of a process."""
    sink = os.open(os.devnull, os.O_WRONLY)
    child = os.posix_spawn(arguments[0], arguments, os.environ,
                           file_actions=[(os.POSIX_SPAWN_DUP2, sink, 1), (os.POSIX_SPAWN_DUP2, sink, 2)])
    _, status, usage = os.wait4(child, 0)
    os.close(sink)
    if status != 0:
        sys.exit("this failed: " + " ".join(arguments))
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024.0


def measure(program, label, centre, cells):
    """Processor time in s of the horizons and of a year's light of a square of cells; and the greatest memory in MB."""
    output = label.parent / "maps"
    shutil.rmtree(output, ignore_errors=True)
    seconds, memory = zip(*(run(
        program, "illumination", "--ldem", "input/ldem/LDEM_4.LBL", "--ldem", str(label), "--center", centre,
        "--size", str(0.02 * cells), "--cell", "20", "--above-ground", "2", "--time-interval", times,
        "--output-dir", str(output), "--batch") for times in (DAY, DAY, YEAR)))
    return (seconds[0] - seconds[1], seconds[2] - seconds[1]), max(memory)


def main(program, cells, is_written):
    root = pathlib.Path(__file__).resolve().parents[2]
    os.chdir(root)
    folder = root / "benchmark" / "illumination"
    label = folder / "LDEM_875S_100M_SYNTHETIC.LBL"
    if not label.exists():
        run(program, "ldem", "synthesize", "--projection", "polar-south", "--map-scale", "100", "--latitude", "87.5",
            "--base", "input/ldem/LDEM_4.LBL", "--seed", "1", "--output-dir", str(folder))
    rows = [
        "| place | horizon of a cell, whatever the interval | light of a cell, each year hour by hour "
        "| from this, 1,000 x 1,000 cells on two cores | memory |\n", "|---|---|---|---|---|\n"]
    for place, centre in PLACES.items():
        all_cells, memory = measure(program, label, centre, cells)
        one, _ = measure(program, label, centre, 1)
        horizon, light = ((whole - single) / (cells ** 2 - 1) for whole, single in zip(all_cells, one))
        rows.append(f"| {place} | {1e3 * horizon:.2f} ms | {1e3 * light:.3f} ms | {1e6 * horizon / 120:.0f} minutes, and "
                    f"{1e6 * light / 2:.0f} s a year | {memory:.0f} MB |\n")
    if not is_written:
        print("".join(rows), end="")
        return
    page = root / "docs" / "illumination.md"
    text = page.read_text()
    before, rest = text.split(BEGIN)
    page.write_text(before + BEGIN + "\n" + "".join(rows) + "\n" + END + rest.split(END)[1])


if __name__ == "__main__":
    names = [argument for argument in sys.argv[1:] if argument != "--write"]
    main(os.path.abspath(names[0]), int(names[1]) if len(names) > 1 else 100, "--write" in sys.argv)

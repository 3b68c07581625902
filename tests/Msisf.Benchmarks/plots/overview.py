#!/usr/bin/env python3
"""Says on one page what the benchmark found: three plots over all scenes, and the figures that the pages quote.

    /usr/bin/python3 overview.py FRONT.CSV FIGURES.CSV FOLDER

Writes FOLDER/time.svg, error.svg, memory.svg; summary.md and scaling.md for docs/performance.md.
"""
import csv
import math
import os
import sys

from style import save
from matplotlib import pyplot, ticker

# Setting in front.csv: label, colour, marker.
WAYS = {
    "thesis": ("thesis", "black", "*"),
    "povray": ("POV-Ray", "tab:blue", "o"),
    "native, 1": ("native, 1 sample", "tab:orange", "s"),
    "native, 4": ("native, 4 samples", "tab:red", "D"),
}
SCALING_SCENE = "nadir-64"  # the view of the sequence's orbit
VIDEO_RATE = 30  # frames a second
NODES = (1, 16, 1000)
SERIES = (("45 s of video, as the thesis made", 45 * VIDEO_RATE), ("an hour of video", 3600 * VIDEO_RATE), ("1e6 frames", 1_000_000))
MEGABYTE = 1e6
MANIFEST_RATES = (("a local disk", 2600.0), ("a network", 500.0))  # lines a second, docs/performance.md


class Results:
    """The figures of one run of the benchmark, SI units."""

    def __init__(self, front_path, figures_path):
        self.scenes = {}  # name -> text, in the order of the run
        self.fronts = {}  # (scene, way) -> row of front.csv
        for row in rows_of(front_path):
            self.scenes[row["scene"]] = row["about"]
            self.fronts[row["scene"], row["setting"]] = row
        self.figures = {(row["scene"], row["quantity"], row["setting"]): float(row["median"]) for row in rows_of(figures_path)}

    def of(self, scene, way, column):
        """A number of front.csv; None if it was not measured."""
        text = self.fronts.get((scene, way), {}).get(column, "")
        return float(text) if text else None

    def seconds(self, scene, way):
        return self.of(scene, way, "seconds_median")

    def error(self, scene, way):
        return self.of(scene, way, "grey_rms_levels")

    def memory(self, scene, way):
        """Peak of msis and POV-Ray together, bytes; POV-Ray's is None where only some of the thesis's tiles were taken."""
        if self.is_scaled(scene, way) or (scene, way) not in self.fronts:
            return None
        return self.of(scene, way, "msis_peak_bytes") + (self.of(scene, way, "povray_peak_bytes") or 0.0)

    def is_scaled(self, scene, way):
        return self.of(scene, way, "tiles") != self.of(scene, way, "tiles_measured")

    def further(self, scene):
        """The program's default is the first setting of a scene: all threads, the widest vectors."""
        return next((value for (name, quantity, _), value in self.figures.items() if (name, quantity) == (scene, "further frame")), None)

    def all_further(self):
        return [self.further(scene) for scene in dict.fromkeys(name for name, quantity, _ in self.figures if quantity == "further frame")]

    def sequence(self, quantity, setting="", scene="sequence"):
        return self.figures.get((scene, quantity, setting))


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as lines:
        return list(csv.DictReader(lines))


def plot(results, value, xlabel):
    """A row for each scene, a point for each way."""
    names = [name for name in results.scenes if any(value(name, way) for way in WAYS)]
    figure, axes = pyplot.subplots(figsize=(8.5, 0.6 + 0.27 * max(len(names), 2)))
    for way, (label, colour, marker) in WAYS.items():
        points = [(value(name, way), -row) for row, name in enumerate(names) if value(name, way)]
        if points:
            axes.plot(*zip(*points), marker, color=colour, label=label, markersize=6, zorder=4 if way == "thesis" else 3)
    axes.set_xscale("log")
    axes.set_yticks([-row for row in range(len(names))], [results.scenes[name] for name in names])
    axes.set_ylim(-len(names) + 0.4, 0.6)
    axes.xaxis.set_minor_locator(ticker.LogLocator(subs=(2, 5)))
    for formatted in (axes.xaxis.set_major_formatter, axes.xaxis.set_minor_formatter):
        formatted(ticker.FuncFormatter(lambda number, _: f"{number:g}"))
    axes.set_xlabel(xlabel)
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), fontsize=8)
    return figure


def text_of(number, digits=3):
    """A number with so many significant digits, without an exponent."""
    if number is None:
        return "-"
    places = max(0, digits - 1 - math.floor(math.log10(abs(number)))) if number else 0
    return f"{number:.{places}f}"


def span(numbers, digits=2):
    numbers = [number for number in numbers if number is not None]
    if not numbers:
        return "-"
    low, high = text_of(min(numbers), digits), text_of(max(numbers), digits)
    return low if low == high else f"{low} to {high}"


def table(header, rows):
    return ["| " + " | ".join(header) + " |", "|" + "---|" * len(header), *("| " + " | ".join(row) + " |" for row in rows)]


def summary(results):
    names = list(results.scenes)

    def ratios(way):
        return [results.seconds(name, "thesis") / results.seconds(name, way) for name in names
                if results.seconds(name, "thesis") and results.seconds(name, way)]

    def errors(way):
        return [results.error(name, way) / results.error(name, "povray") for name in names
                if results.error(name, "povray") and results.error(name, way)]

    def memory(way):
        return span([results.memory(name, way) / MEGABYTE for name in names if results.memory(name, way)])

    lines = [
        f"- **The native renderer** makes an image in {span([results.seconds(name, 'native, 1') for name in names])} s from the start of the process to "
        f"its end, with 4 samples a pixel in {span([results.seconds(name, 'native, 4') for name in names])} s. Each further image of the same process is drawn in "
        f"{span([1e3 * seconds for seconds in results.all_further()])} ms. It needs {memory('native, 1')} MB.",
        f"- **POV-Ray** takes {span([results.seconds(name, 'povray') for name in names])} s and {memory('povray')} MB.",
        f"- **Against the thesis's way** POV-Ray is {span(ratios('povray'))} times as fast, the native renderer with 4 samples {span(ratios('native, 4'))} times.",
        f"- **Error**: with 4 samples a pixel the native renderer's rms error is {span(errors('native, 4'))} times POV-Ray's with its antialiasing, with 1 sample "
        f"{span(errors('native, 1'))} times.",
    ]
    rate = results.sequence("rate", "all frames")
    if rate:
        lines.append(f"- **A series**: {text_of(results.sequence('frames'), 4)} frames of an orbit 100 km above LDEM_64 at {text_of(rate)} frames a second, images and meta "
                     f"files written. With the ground truth of all pixels in FITS {text_of(results.sequence('rate', 'all frames', 'sequence with layers'), 2)} a second.")
    lines += ["", "![Time of an image, all scenes](../tests/Msisf.Benchmarks/results/time.svg)", "", "![Error of an image, all scenes](../tests/Msisf.Benchmarks/results/error.svg)", "",
              "![Memory of an image, all scenes](../tests/Msisf.Benchmarks/results/memory.svg)", ""]
    rows = []
    for name in names:
        seconds = {way: text_of(results.seconds(name, way)) for way in WAYS}
        if results.is_scaled(name, "thesis"):
            seconds["thesis"] += " (scaled)"
        further = results.further(name)
        rows.append([results.scenes[name], *seconds.values(), text_of(1e3 * further if further else None),
                     text_of(results.error(name, "povray")), text_of(results.error(name, "native, 4"))])
    header = ["scene", "thesis, s", "POV-Ray, s", "native, s", "native, 4 samples, s", "further native image, ms", "error of POV-Ray, levels", "error of native, 4 samples, levels"]
    return lines + table(header, rows)


def duration(seconds):
    for unit, size in (("days", 86400.0), ("h", 3600.0), ("min", 60.0)):
        if seconds >= 2.0 * size:
            return f"{text_of(seconds / size, 2)} {unit}"
    return f"{text_of(seconds, 2)} s"


def scaling(results):
    """What series cost on many nodes, and what each node asks of the storage."""
    rates = {"native": results.sequence("rate", "all frames"), "POV-Ray": results.seconds(SCALING_SCENE, "povray")}
    if None in rates.values():
        return ["The run had no sequence."]
    rates["POV-Ray"] = 1.0 / rates["POV-Ray"]
    file_bytes = results.sequence("files") / results.sequence("frames")
    rows = [[what if name == "native" else "", f"{frames:,}" if name == "native" else "", name, *(duration(frames / rate / nodes) for nodes in NODES)]
            for what, frames in SERIES for name, rate in rates.items()]
    lines = table(["series", "frames", "renderer", *(f"{nodes:,} node" + "s" * (nodes > 1) for nodes in NODES)], rows)
    lines += ["", "For each node, from the same run:", ""]
    lines += table(["what", *(f"{name}, {text_of(rate)} frames/s" for name, rate in rates.items())], [
        [f"outputs, {text_of(file_bytes / 1e3)} kB a frame", *(f"{text_of(rate * file_bytes / MEGABYTE, 2)} MB/s" for rate in rates.values())],
        ["outputs of 1e6 frames", *(f"{file_bytes * 1e6 / 1e9:.0f} GB" for _ in rates)],
        ["lines of the manifest", *(f"{text_of(rate)} a second" for rate in rates.values())],
        *([f"nodes that fill the manifest's lock on {where}, {lines_a_second:,.0f} lines/s", *(f"{lines_a_second / rate:,.0f}" for rate in rates.values())]
          for where, lines_a_second in MANIFEST_RATES),
        ["nodes that write 1 GB/s", *(f"{1e9 / (rate * file_bytes):,.0f}" for rate in rates.values())],
        [f"nodes that make a live video ({VIDEO_RATE} frames a second)", *(f"{math.ceil(VIDEO_RATE / rate)}" for rate in rates.values())],
    ])
    return lines


def main(front_path, figures_path, folder):
    results = Results(front_path, figures_path)
    for name, value, xlabel in (
        ("time", results.seconds, "time of an image, s (thesis: partly scaled)"),
        ("error", results.error, "rms error, grey levels of 255"),
        ("memory", lambda scene, way: (results.memory(scene, way) or 0.0) / MEGABYTE, "peak memory of msis and POV-Ray, MB"),
    ):
        figure = plot(results, value, xlabel)
        save(figure, os.path.join(folder, f"{name}.svg"))
        pyplot.close(figure)
    for name, lines in (("summary", summary(results)), ("scaling", scaling(results))):
        with open(os.path.join(folder, f"{name}.md"), "w", encoding="utf-8", newline="\n") as page:
            page.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])

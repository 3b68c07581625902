"""Plots time against error of each scene from the benchmark's front.csv.

/usr/bin/python3 performance.py FRONT.CSV FOLDER    writes FOLDER/front-SCENE.svg

A point is a way to make the scene's image. The lines are Pareto fronts: the ways that no other one beats in both; of all, and of POV-Ray's alone.
"""
import csv
import os
import sys

from style import save
from matplotlib import pyplot, ticker

KINDS = {"Thesis": ("thesis", "black", "*"), "PovRay": ("POV-Ray", "tab:blue", "o"), "Native": ("native", "tab:orange", "s")}
OFFSETS = (4, -9, 12, -17)  # points: neighbours in time are often neighbours in error too, so labels take turns
LEAST_ERROR = 1e-3  # levels: an image without any error would have no place on a logarithmic axis


def front_of(points):
    """Of (seconds, error, ...) those that no other one beats in both, by time."""
    front = []
    for point in sorted(points):
        if not front or point[1] < front[-1][1]:
            front.append(point)
    return front


def read(path):
    """Scenes in their order: name -> (about, [(seconds, error, setting, kind)])."""
    scenes = {}
    with open(path, newline="", encoding="utf-8") as lines:
        for row in csv.DictReader(lines):
            _, points = scenes.setdefault(row["scene"], (row["about"], []))
            if row["grey_rms_levels"]:
                error = max(float(row["grey_rms_levels"]), LEAST_ERROR)
                points.append((float(row["seconds_median"]), error, row["setting"], row["kind"]))
    return scenes


def plot(about, points):
    figure, axes = pyplot.subplots(figsize=(8.5, 4.2))
    axes.set_xscale("log")
    axes.set_yscale("log")
    for kind, (label, colour, marker) in KINDS.items():
        chosen = [point for point in points if point[3] == kind]
        if chosen:
            axes.plot([p[0] for p in chosen], [p[1] for p in chosen], marker, color=colour, label=label, markersize=6)
    povray = [point for point in points if point[3] != "Native"]
    for name, colour, chosen in (("front, all", "tab:green", points), ("front, POV-Ray", "tab:blue", povray)):
        front = front_of(chosen)
        axes.plot([p[0] for p in front], [p[1] for p in front], "--", color=colour, linewidth=1, zorder=1, label=name)
    for index, (seconds, error, setting, _) in enumerate(sorted(points)):
        offset = (4, OFFSETS[index % len(OFFSETS)])
        axes.annotate(setting, (seconds, error), xytext=offset, textcoords="offset points", fontsize=6)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_minor_locator(ticker.LogLocator(subs=(2, 5)))
        axis.set_major_formatter(ticker.FuncFormatter(lambda value, _: f"{value:g}"))
        axis.set_minor_formatter(ticker.FuncFormatter(lambda value, _: f"{value:g}"))
    axes.margins(x=0.15, y=0.2)
    axes.set_xlabel("time of the image, s")
    axes.set_ylabel("rms error, levels of 255")
    axes.set_title(about)
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), fontsize=7)
    return figure


def main(path, folder):
    for name, (about, points) in read(path).items():
        if points:
            figure = plot(about, points)
            save(figure, os.path.join(folder, f"front-{name}.svg"))
            pyplot.close(figure)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])

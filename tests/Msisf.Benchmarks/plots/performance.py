"""Plots time against error of each scene from the benchmark's front.csv.

/usr/bin/python3 performance.py FRONT.CSV FOLDER    writes FOLDER/front-SCENE.svg

A point is a way to make the scene's image. The lines are Pareto fronts: the ways that no other one beats in both; of all, and of POV-Ray's alone.
"""
import csv
import os
import sys

from style import save
from matplotlib import pyplot, ticker, transforms
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Text

KINDS = {"Thesis": ("thesis", "black", "*"), "PovRay": ("POV-Ray", "tab:blue", "o"), "Native": ("native", "tab:orange", "s")}
RINGS = (5, 11, 17, 24, 32, 42, 54)  # points from the marker: places for its label, the nearest first
DIRECTIONS = ((1, 0.5), (1, -0.9), (-1, 0.5), (-1, -0.9), (0, 1), (0, -1.4))  # right above, right below, left above, ...
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


def overlaps(box, others):
    return any(box.x0 < other.x1 and other.x0 < box.x1 and box.y0 < other.y1 and other.y0 < box.y1 for other in others)


def write_labels(axes, points):
    """Names the points, each at the nearest place where it covers no marker and no other name, with a line to its marker if that is far."""
    canvas = FigureCanvasAgg(axes.figure)
    canvas.draw()  # lays out the axes, so that places in pixels are known
    pixel = axes.figure.dpi / 72.0
    places = {point: axes.transData.transform(point[:2]) for point in points}
    taken = [transforms.Bbox.from_extents(x - 4 * pixel, y - 4 * pixel, x + 4 * pixel, y + 4 * pixel) for x, y in places.values()]
    for point in sorted(points):
        for ring, (right, up) in ((ring, direction) for ring in RINGS for direction in DIRECTIONS):
            label = axes.annotate(
                point[2], point[:2], xytext=(right * ring, up * ring), textcoords="offset points", fontsize=6, va="center",
                ha={1: "left", -1: "right", 0: "center"}[right],
                arrowprops={"arrowstyle": "-", "linewidth": 0.4, "color": "grey", "shrinkB": 3} if ring > RINGS[1] else None)
            label.set_in_layout(False)  # the axes stay where they are
            box = Text.get_window_extent(label, canvas.get_renderer())
            if not overlaps(box, taken):
                taken.append(box)
                break
            label.remove()
        else:
            raise SystemExit(f"performance.py: there is no place for the label {point[2]}")


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
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_minor_locator(ticker.LogLocator(subs=(2, 5)))
        axis.set_major_formatter(ticker.FuncFormatter(lambda value, _: f"{value:g}"))
        axis.set_minor_formatter(ticker.FuncFormatter(lambda value, _: f"{value:g}"))
    axes.margins(x=0.15, y=0.2)
    axes.set_xlabel("time of the image, s")
    axes.set_ylabel("rms error, levels of 255")
    axes.set_title(about)
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), fontsize=7)
    write_labels(axes, points)
    return figure


def main(path, folder):
    for name, (about, points) in read(path).items():
        if points:
            figure = plot(about, points)
            save(figure, os.path.join(folder, f"front-{name}.svg"))
            pyplot.close(figure)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])

#!/usr/bin/env python3
"""Draws what the stress tests found: worst and mean error over the range of an input.

usage: accuracy.py stress_series.csv OUTPUT_FOLDER     writes stress_TEST_NUMBER.svg for each series
"""
import csv
import itertools
import math
import pathlib
import sys

try:
    import matplotlib.pyplot as plt
    import style
except ImportError as error:
    sys.exit(f"accuracy.py: {error}. Install matplotlib for {sys.executable}: apt-get install python3-matplotlib")

SIZE = (6.4, 3.2)  # inches
DECADES_FOR_LOG = 1.5  # errors and limits that spread further are shown in the logarithm, where a 0 has no place


def label(quantity, unit):
    return f"{quantity} [{unit}]" if unit else quantity


def spread_in_decades(numbers):
    """How far the greatest is from the least of those that have a logarithm."""
    positive = [number for number in numbers if number > 0.0 and math.isfinite(number)]
    return math.log10(max(positive) / min(positive)) if positive else 0.0


def draw(bins):
    """A figure of one series; each bin is a step from its start to its end."""
    first = bins[0]
    edges = [float(row["from"]) for row in bins], [float(row["to"]) for row in bins]
    figure, axes = plt.subplots(figsize=SIZE)
    errors = {name: [float(row[name]) for row in bins] for name in ("worst", "mean")}
    for name, colour in (("worst", "C3"), ("mean", "C0")):
        axes.hlines(errors[name], *edges, color=colour, linewidth=1.8, label=name)
    limits = [float(first["limit"])] if first["limit"] else []
    for limit in limits:
        axes.axhline(limit, color="black", linewidth=1.0, linestyle="--", label="limit")
    axes.set_xscale(first["scale"])
    if spread_in_decades(errors["worst"] + errors["mean"] + limits) > DECADES_FOR_LOG:
        axes.set_yscale("log")
    else:
        axes.set_ylim(bottom=0.0)
    axes.set_xlabel(label(first["input"], first["input_unit"]))
    axes.set_ylabel(label(first["quantity"], first["unit"]))
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=3, frameon=False)
    return figure


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[2])
    with open(sys.argv[1], newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    for (test, number), bins in itertools.groupby(rows, key=lambda row: (row["test"], row["number"])):
        figure = draw(list(bins))
        style.save(figure, folder / f"stress_{test}_{number}.svg")
        plt.close(figure)


if __name__ == "__main__":
    main()

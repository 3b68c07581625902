#!/usr/bin/env python3
"""Shows what msis batchconvert --balance gains over equal counts, from measured frame times.

    /usr/bin/python3 tests/Msisf.Benchmarks/plots/balance.py docs/benchmark/frame-times.csv docs/benchmark

Reads the times of frames along an orbit with the triangles of the tiles that each needs (columns series, step, seconds, triangles).
For each series: the correlation of the estimate with the times; then a turn about the Moon in many frames, the time of each drawn (seeded) from
those of the five measured frames around its place. It is cut into pieces of equal
counts, and into pieces of equal estimated cost; each free node takes the next piece. Writes balance.md and balance.svg.
"""
import csv
import heapq
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["svg.hashsalt"] = "msisf"
import matplotlib.pyplot as plt
import numpy as np

FRAMES = 10_000
NODES = (4, 16, 64, 256)
PIECES_PER_NODE = (1, 4)
DRAWS = 20
NEIGHBOURS = 2  # to either side

# Pieces/FrameCost.cs: s a frame, s a sample, s a triangle; and the samples of the measured images.
COSTS = {"native-64": (0.0, 1.57e-7, 1.19e-8, 512 * 512), "povray-16": (0.8, 9.1e-7, 4.7e-6, 320 * 320)}


def read(path):
    series = {}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            series.setdefault(row["series"], []).append((float(row["seconds"]), float(row["triangles"])))
    return {name: np.array(rows).T for name, rows in series.items()}


def estimates(name, triangles):
    fixed, per_sample, per_triangle, samples = COSTS[name]
    return fixed + per_sample * samples + per_triangle * triangles


def cut_by_count(frames, pieces):
    return [frames * piece // pieces for piece in range(pieces + 1)]


def cut_by_cost(costs, pieces):
    """The smallest limit with which so many pieces suffice, by bisection, as Pieces/RunCutter.cs."""
    sums = np.concatenate([[0.0], np.cumsum(costs)])

    def cuts(limit):
        ends = [0]
        while ends[-1] < len(costs):
            end = int(np.searchsorted(sums, sums[ends[-1]] + limit, side="right")) - 1
            ends.append(max(end, ends[-1] + 1))
        return ends

    low, high = float(np.max(costs)), float(sums[-1])
    for _ in range(60):
        middle = (low + high) / 2.0
        low, high = (low, middle) if len(cuts(middle)) - 1 <= pieces else (middle, high)
    return cuts(high)


def makespan(times, cuts, nodes):
    free = [0.0] * nodes
    for start, end in zip(cuts, cuts[1:]):
        heapq.heappush(free, heapq.heappop(free) + float(np.sum(times[start:end])))
    return max(free)


def simulate(name, seconds, triangles, nodes, per_node, random):
    """Mean over the draws of makespan by that of a perfect division: by count, by cost."""
    estimate = estimates(name, triangles)
    places = np.arange(FRAMES) * len(seconds) // FRAMES
    smooth = np.interp(np.arange(FRAMES) * len(seconds) / FRAMES, np.arange(len(seconds)), estimate)
    results = []
    for _ in range(DRAWS):
        around = places + random.integers(-NEIGHBOURS, NEIGHBOURS + 1, FRAMES)
        times = seconds[np.clip(around, 0, len(seconds) - 1)]
        perfect = np.sum(times) / nodes
        results.append([makespan(times, cuts, nodes) / perfect
                        for cuts in (cut_by_count(FRAMES, per_node * nodes), cut_by_cost(smooth, per_node * nodes))])
    return np.mean(results, axis=0)


def main(source, folder):
    lines = ["| series | frames measured | slowest by fastest | correlation of estimate and time |", "|---|---|---|---|"]
    series = read(source)
    for name, (seconds, triangles) in series.items():
        correlation = np.corrcoef(estimates(name, triangles), seconds)[0, 1]
        lines.append(f"| {name} | {len(seconds)} | {np.max(seconds) / np.min(seconds):.0f} | {correlation:.2f} |")
    lines += ["", "| series | nodes | pieces | equal counts | `--balance` |", "|---|---|---|---|---|"]
    figure, axes = plt.subplots(1, len(series), figsize=(9, 3.5), sharey=True)
    for axis, (name, (seconds, triangles)) in zip(np.atleast_1d(axes), series.items()):
        for per_node in PIECES_PER_NODE:
            random = np.random.default_rng(20121)
            found = [simulate(name, seconds, triangles, nodes, per_node, random) for nodes in NODES]
            for nodes, (by_count, by_cost) in zip(NODES, found):
                lines.append(f"| {name} | {nodes} | {per_node * nodes} | {by_count:.2f} | {by_cost:.2f} |")
            style = "-" if per_node == 1 else "--"
            axis.plot(NODES, [pair[0] for pair in found], style, color="tab:red", marker="o", label=f"equal counts, {per_node} a node")
            axis.plot(NODES, [pair[1] for pair in found], style, color="tab:blue", marker="o", label=f"--balance, {per_node} a node")
        axis.set(title=name, xlabel="nodes", xscale="log", xticks=NODES, xticklabels=NODES)
        axis.minorticks_off()
        axis.grid(alpha=0.3)
    np.atleast_1d(axes)[0].set_ylabel("time until the last frame,\nby that of a perfect division")
    np.atleast_1d(axes)[-1].legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(Path(folder) / "balance.svg", metadata={"Date": None})
    text = "\n".join(lines) + "\n"
    (Path(folder) / "balance.md").write_text(text)
    print(text, end="")


if __name__ == "__main__":
    main(*sys.argv[1:3])

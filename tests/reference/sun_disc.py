"""Errors of the visible fraction that the 64 points of SunDisc give for a disc cut by a straight edge (numpy)."""
import numpy as np

RINGS = [4, 12, 20, 28]
TURNS = [0.5, 0.75, 0.0, 0.75]


def points():
    placed = []
    done = 0
    for count, turn in zip(RINGS, TURNS):
        radius = np.sqrt((done + count / 2) / sum(RINGS))
        angle = (np.arange(count) + turn) * 2 * np.pi / count
        placed.append(np.c_[radius * np.cos(angle), radius * np.sin(angle)])
        done += count
    return np.vstack(placed)


def area(edge):
    """Part of the unit disc with x <= edge."""
    return (np.arccos(np.clip(-edge, -1, 1)) + edge * np.sqrt(np.clip(1 - edge * edge, 0, 1))) / np.pi


disc = points()
worst = 0.0
squares = []
for angle in np.linspace(0, 2 * np.pi, 7200, endpoint=False):
    along = np.sort(disc @ [np.cos(angle), np.sin(angle)])
    number = np.arange(len(along))
    # The error is greatest just before or just behind a point.
    worst = max(worst, np.max(np.abs(area(along) - number / 64)), np.max(np.abs(area(along) - (number + 1) / 64)))
    edge = np.linspace(-1, 1, 401)
    squares.append((np.searchsorted(along, edge) / 64 - area(edge)) ** 2)
print("mean of the points:", disc.mean(axis=0))
print("greatest error:", worst, " root mean square:", np.mean(squares) ** 0.5)

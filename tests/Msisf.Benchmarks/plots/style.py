"""How all plots look: SVG with the same bytes for the same numbers."""
import matplotlib

matplotlib.use("svg")
matplotlib.rcParams.update({
    "svg.hashsalt": "msisf",
    "svg.fonttype": "none",
    "font.family": "sans-serif",
    "font.size": 9,
    "axes.grid": True,
    "grid.alpha": 0.3,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "figure.constrained_layout.use": True,
})


def save(figure, path):
    """Writes the figure without the time and the version that matplotlib would add."""
    figure.savefig(path, format="svg", metadata={"Date": None, "Creator": None})

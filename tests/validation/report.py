"""Writes the tables and plots of the validation."""
import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "msisf"  # the same data, the same bytes
import matplotlib.pyplot as plt
import numpy as np

import disc

ASKED_CORRELATION = 0.975
ASKED_RMS = 0.07
ASKED_MAGNITUDE = 0.15


def write(folder, real, drawn, chosen, laws, bands, by_phase, magnitudes):
    """Writes validation.md, strip.png, scatter.svg and disc.svg into the folder."""
    factor = laws["moon", "with"]["factor"]
    _strip_plot(folder / "strip.png", real, factor * drawn, chosen)
    _scatter_plot(folder / "scatter.svg", real[chosen], factor * drawn[chosen])
    _disc_plot(folder / "disc.svg", magnitudes)
    best = laws["moon", "with"]
    lines = [
        f"**`--reflectance moon` with the map correlates by {best['correlation']:.3f} with the real image, relative rms "
        f"{100 * best['rms']:.1f} %** over {best['count']:,} pixels, 643 nm, after one factor for the whole image "
        f"(asked: at least {ASKED_CORRELATION}, at most {100 * ASKED_RMS:.0f} %: "
        f"{_met(best['correlation'] >= ASKED_CORRELATION and best['rms'] <= ASKED_RMS)}).",
        "",
        "| law, 643 nm | correlation | with the map | relative rms | with the map |",
        "|---|---|---|---|---|",
    ]
    for law in dict.fromkeys(law for law, _ in laws):
        without, with_map = laws[law, "without"], laws[law, "with"]
        lines.append(f"| `{law}` | {without['correlation']:.3f} | {with_map['correlation']:.3f} | {100 * without['rms']:.1f} % | "
                     f"{100 * with_map['rms']:.1f} % |")
    lines += ["", "| band, `moon` with the map | correlation | relative rms | measured / drawn I/F, median |", "|---|---|---|---|"]
    for band, found in bands.items():
        lines.append(f"| {band} nm | {found['correlation']:.3f} | {100 * found['rms']:.1f} % | {found['absolute']:.3f} |")
    lines += ["", "| phase angle, 643 nm, `moon` with the map | pixels | correlation | relative rms |", "|---|---|---|---|"]
    for low, high, found in by_phase:
        lines.append(f"| {low:.0f} to {high:.0f} degrees | {found['count']} | {found['correlation']:.3f} | {100 * found['rms']:.1f} % |")
    lines += [
        "",
        "![The real strip, the drawn one and their ratio, side by side](validation/strip.png)",
        "",
        "![Drawn against real grey levels: one point a pixel](validation/scatter.svg)",
        "",
        "Whole disc: magnitude drawn less Allen's, both set to zero at 30 degrees.",
        "",
        "| phase angle | " + " | ".join(f"`{law}`" for law in magnitudes) + " |",
        "|---|" + "---|" * len(magnitudes),
    ]
    for number, phase in enumerate(disc.PHASES_DEGREES):
        lines.append(f"| {phase} | " + " | ".join(f"{values[number]:+.2f}" for values in magnitudes.values()) + " |")
    worst = np.abs(magnitudes["moon"]).max()
    lines += [
        "",
        f"`moon` stays within {worst:.2f} mag from {disc.PHASES_DEGREES[0]} to {disc.PHASES_DEGREES[-1]} degrees "
        f"(asked: {ASKED_MAGNITUDE}: {_met(worst <= ASKED_MAGNITUDE)}).",
        "",
        "![Magnitude of the whole disc less Allen's, by phase angle and law](validation/disc.svg)",
        "",
    ]
    (folder / "validation.md").write_text("\n".join(lines), encoding="utf-8")


def _met(is_met):
    return "met" if is_met else "missed"


def _strip_plot(path, real, drawn, chosen):
    lines = chosen.any(axis=1)
    levels = dict(cmap="gray", vmin=0.0, vmax=np.percentile(real[chosen], 99.5), aspect="equal", interpolation="nearest")
    figure, axes = plt.subplots(3, 1, figsize=(9.0, 4.6), layout="constrained")
    axes[0].imshow(real[lines].T, **levels)
    axes[0].set_title("LROC WAC M1181493219CE, 643 nm (32 x 32 pixels each)", fontsize=9)
    axes[1].imshow(drawn[lines].T, **levels)
    axes[1].set_title("msis, LDEM_4, --reflectance moon, NASA's albedo map, one factor", fontsize=9)
    axes[2].imshow((real / drawn)[lines].T, cmap="coolwarm", vmin=0.8, vmax=1.2, aspect="equal", interpolation="nearest")
    axes[2].set_title("real / drawn, 0.8 (blue) to 1.2 (red)", fontsize=9)
    for axis in axes:
        axis.set_xticks([])
        axis.set_yticks([])
    figure.savefig(path, dpi=110, metadata={"Software": None})
    plt.close(figure)


def _scatter_plot(path, real, drawn):
    figure, axis = plt.subplots(figsize=(4.2, 4.2), layout="constrained")
    axis.scatter(drawn, real, s=3, linewidths=0, alpha=0.5, rasterized=True)
    top = max(real.max(), drawn.max()) * 1.03
    axis.plot([0.0, top], [0.0, top], color="0.4", linewidth=0.8)
    axis.set(xlim=(0.0, top), ylim=(0.0, top), xlabel="drawn, DN (one factor)", ylabel="real, DN")
    figure.savefig(path, metadata={"Date": None, "Creator": None})
    plt.close(figure)


def _disc_plot(path, magnitudes):
    figure, axis = plt.subplots(figsize=(6.0, 3.2), layout="constrained")
    axis.axhspan(-ASKED_MAGNITUDE, ASKED_MAGNITUDE, color="0.92")
    for law, values in magnitudes.items():
        axis.plot(disc.PHASES_DEGREES, values, marker="o", markersize=3, label=law)
    axis.set(xlabel="phase angle, degrees", ylabel="drawn less Allen, mag")
    axis.invert_yaxis()
    axis.legend(fontsize=8)
    figure.savefig(path, metadata={"Date": None, "Creator": None})
    plt.close(figure)

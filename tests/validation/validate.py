#!/usr/bin/env python3
"""Compares what msis draws with a real LROC WAC strip and with the brightness of the whole Moon.

    /usr/bin/python3 -B tests/validation/validate.py --data ../shared/validation --map MAP --folder FOLDER

writes FOLDER/validation.md and the plots beside it; ./benchmark.sh --validate calls it. The strip comes from USGS's test data of
ISIS (public domain). Nothing is fitted to it but one factor an image.
"""
import argparse
import pathlib
import shutil
import xml.etree.ElementTree as xml

import numpy as np

import disc
import report
from frames import camera_quaternion, draw, scan
from wac_strip import BANDS_NM, FRAMELET_LINES, SAMPLES, Strip

LAWS = ("lambert", "lommel-seeliger", "lunar-lambert", "hapke", "nac", "moon")
MAIN_BAND_NM = 643

# The map of NASA SVS 4720 has a measured scale at 415, 566, 643 and 689 nm; at 604 nm it is interpolated between its neighbours.
SCALE_604 = 2.63e-4 + (604.0 - 566.0) / (643.0 - 566.0) * (3.16e-4 - 2.63e-4)

# DN per ms for I/F = 1 at 1 au: INS-85631_RESPONSIVITY ... of ISIS's lrowaccal.
RESPONSIVITIES = {415: 143.35, 566: 143.90, 604: 140.71, 643: 130.91, 689: 130.61}


def states_of(strip):
    """The state of the camera at each framelet: samples run along the instrument's +y, lines along its -x, it looks along +z."""
    for mjd, position, axes in zip(strip.mjd_utc, strip.positions, strip.moon_from_instrument):
        yield [mjd, *position, *camera_quaternion(np.stack([axes[:, 1], -axes[:, 0], axes[:, 2]], axis=1))]


def strip_image(folder, strip, law, band, albedo_map):
    """The strip as msis draws it, [line, sample] of I/F."""
    law_options = ["--reflectance", law] + (["--band", str(band)] if law == "moon" else [])
    map_options = ["--albedo-map", str(albedo_map)] + (["--albedo-map-properties", f"scale={SCALE_604!r}"] if band == 604 else [])
    images = scan(folder, list(states_of(strip)), strip.period_s, "--camera", f"lroc-wac-{band}", *law_options, *map_options)
    if images[0].shape != (FRAMELET_LINES, SAMPLES):
        raise SystemExit(f"validation: framelets of {images[0].shape}, {(FRAMELET_LINES, SAMPLES)} expected")
    return strip.reduce(images)


def compare(real, drawn, chosen):
    """Correlation, relative rms difference and the one factor, over the chosen pixels."""
    real, drawn = real[chosen], drawn[chosen]
    factor = (real * drawn).sum() / (drawn * drawn).sum()
    return {
        "correlation": np.corrcoef(real, drawn)[0, 1],
        "rms": np.sqrt(np.mean((real - factor * drawn) ** 2)) / real.mean(),
        "factor": factor,
        "count": int(chosen.sum()),
    }


def phase_angles(folder, strip):
    """Phase angle of each pixel of the strip, degrees: the mean over its pixels."""
    states = list(states_of(strip))
    images = scan(folder, states, strip.period_s, "--camera", f"lroc-wac-{MAIN_BAND_NM}", "--reflectance", "lambert", "--albedo-map",
                  "none", layer="phase")
    return strip.reduce(images)


def sun_position(folder):
    """Position of the Sun at the time of the disc's images, m, MOON_ME, from the meta file of an image."""
    draw(folder, [[disc.TIME_MJD, 3.0e6, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]], "--width", "16", "--height", "16", "--reflectance", "lambert")
    element = xml.parse(folder / "frame_00001.xml").getroot().find(".//SunPosition")
    vector = next(iter(element))
    return np.array([float(vector.get(axis)) for axis in "xyz"])


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--data", type=pathlib.Path, required=True)
    arguments.add_argument("--map", type=pathlib.Path, required=True)
    arguments.add_argument("--folder", type=pathlib.Path, required=True)
    chosen_arguments = arguments.parse_args()
    folder = chosen_arguments.folder
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    strip = Strip(next((chosen_arguments.data / "wac").glob("*.cub")))
    main_band = BANDS_NM.index(MAIN_BAND_NM)
    chosen = ~np.isnan(strip.dn[main_band])

    laws = {}
    images = {}
    for law in LAWS:
        for name, albedo_map in (("without", "none"), ("with", chosen_arguments.map)):
            images[law, name] = strip_image(folder / f"{law}-{name}-map", strip, law, MAIN_BAND_NM, albedo_map)
            laws[law, name] = compare(strip.dn[main_band], images[law, name], chosen)

    bands = {}
    for number, band in enumerate(BANDS_NM):
        image = images["moon", "with"] if band == MAIN_BAND_NM else strip_image(
            folder / f"moon-{band}", strip, "moon", band, chosen_arguments.map)
        bands[band] = compare(strip.dn[number], image, chosen)
        radiance_factor = strip.dn[number] / strip.exposure_ms * strip.sun_distance_au**2 / RESPONSIVITIES[band]
        bands[band]["absolute"] = np.median(radiance_factor[chosen] / image[chosen])

    phases = phase_angles(folder / "phase", strip)
    edges = np.arange(0.0, 70.0, 10.0)
    by_phase = []
    for low, high in zip(edges, edges[1:]):
        part = chosen & (phases >= low) & (phases < high)
        if part.sum() > 50:
            by_phase.append((low, high, compare(strip.dn[main_band], images["moon", "with"], part)))

    sun = sun_position(folder / "sun")
    magnitudes = {law: disc.differences(folder / f"disc-{law}", sun, "--reflectance", law, "--albedo-map", "none")
                  for law in ("lambert", "lunar-lambert", "hapke", "moon")}
    report.write(folder, strip.dn[main_band], images["moon", "with"], chosen, laws, bands, by_phase, magnitudes)


if __name__ == "__main__":
    main()

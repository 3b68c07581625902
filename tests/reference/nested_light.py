#!/usr/bin/env python3
"""How much of a map is lit alone and in a model of the whole Moon (docs/surface.md).

    nested_light.py MSIS LDEM_4.LBL NPC_final_adj_5mpp_surf_piece_2km_2_1.tif

MSIS is the program. The map is a piece of 400 x 400 samples around 84.809 S, 125.960 E. Counted are the pixels that show its samples
without the outermost 64 along each side; a point is lit if the Sun's centre shines on it.
"""
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

WHEN = [61060.06223092263, 61058.02454325592, 61056.72444129065]  # MJD: the Sun is 5.3, 3.7 and 2.4 degrees high at the map's middle
BORDER = 64


def draw(folder, name, when, *models):
    layers = ["mask", "cell", "sphere-incidence"]
    subprocess.run(
        [sys.argv[1], "--renderer", "native", "--position=-84.809,125.96,20000", "--time", str(when), "--width", "512", "--height", "512",
         "--fov", "6", "--lod", "off", "--layers", ",".join(layers), "--layers-format", "npy", "--batch", "--output-dir", folder,
         "--output-name", name, *models], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return [np.load(pathlib.Path(folder) / f"{name}.{layer}.npy") for layer in layers]


def share(mask, cell, part):
    inner = np.all((cell[..., :2] >= BORDER) & (cell[..., :2] < 400 - BORDER), axis=-1)
    if cell.shape[-1] == 3:
        inner &= cell[..., 2] == part
    return 100.0 * np.mean(mask[inner] == 1)


def main():
    moon, site = ["--ldem", sys.argv[2]], ["--ldem", sys.argv[3]]
    print("Sun, degrees   alone    nested")
    for number, when in enumerate(WHEN):
        with tempfile.TemporaryDirectory() as folder:
            alone = draw(folder, "alone", when, *site)
            nested = draw(folder, "nested", when, *moon, *site)
            print(f"{90.0 - np.nanmean(alone[2]):8.2f}     {share(*alone[:2], 0):6.2f}   {share(*nested[:2], 1):6.2f}")


if __name__ == "__main__":
    main()

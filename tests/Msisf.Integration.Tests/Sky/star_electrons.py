"""Electrons of the stars of a run by numpy's integration: prints how many stars were compared and the greatest relative difference.

  /usr/bin/python3 -B star_electrons.py REPOSITORY STEM AREA EXPOSURE SHORTEST LONGEST TRANSMISSION EFFICIENCY

STEM: path of the meta file without its ending. AREA in m^2, EXPOSURE in s, SHORTEST and LONGEST in nm. The camera is a pinhole without PSF.
"""
import csv
import math
import os
import re
import sys
import xml.etree.ElementTree as ET

sys.path.insert(0, os.path.join(sys.argv[1], "tests", "reference"))
import stars

stem = sys.argv[2]
area, exposure, *band = (float(word) for word in sys.argv[3:])
root = ET.fromstring(re.sub(r"<!DOCTYPE.*?\]>", "", open(stem + ".xml").read(), flags=re.S))
k = [float(word) for word in root.findtext("GeneralInformation/Camera/K").split()]
count, greatest = 0, 0.0
for row in csv.DictReader(open(stem + ".stars.csv")):
    x, y = (float(row["h"]) - 1 - k[2]) / k[0], (float(row["v"]) - 1 - k[5]) / k[4]
    if row["hiddenBy"]:
        assert float(row["electrons"]) == 0.0, row
        continue
    # a flat aperture is seen at an angle
    expected = stars.electrons(float(row["magnitude"]), float(row["colour"]), area, exposure, *band) / math.sqrt(1 + x * x + y * y)
    greatest = max(greatest, abs(float(row["electrons"]) / expected - 1))
    count += 1
print("%d %.3g" % (count, greatest))

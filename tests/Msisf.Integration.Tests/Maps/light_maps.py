"""Prints what GDAL and Astropy read of maps of light: light_maps.py GEOTIFF FITS EXTENSION; a line each of JSON."""
import json
import sys

import numpy as np
from astropy.io import fits
from osgeo import gdal

gdal.UseExceptions()
tiff = gdal.Open(sys.argv[1])
band = tiff.GetRasterBand(1)
info = gdal.Info(sys.argv[1])
with fits.open(sys.argv[2], checksum=True) as file:
    first, image = file[0].header, file[sys.argv[3]]
    print(json.dumps({
        "description": band.GetDescription(), "unit": band.GetUnitType(), **tiff.GetMetadata(),
        "shown": f"Description = {band.GetDescription()}" in info and f"Unit Type: {band.GetUnitType()}" in info,
    }))
    print(json.dumps({
        **{key: first[key] for key in ("TIMESYS", "DATE-BEG", "DATE-END", "STEP", "SUN")},
        **{key: image.header[key] for key in ("BUNIT", "HEIGHT")}, "about": "".join(image.header["COMMENT"]),
        "same": bool(np.array_equal(image.data, band.ReadAsArray())),
    }))

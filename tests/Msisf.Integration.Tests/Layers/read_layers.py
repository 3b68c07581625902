"""Opens layers with other people's readers and writes what they see as plain little-endian numbers, in C order.

    read_layers.py astropy|gdal FILE.fits FOLDER       one FOLDER/EXTNAME.bin for each extension
    read_layers.py numpy FILE.npy FOLDER               FOLDER/array.bin

Prints what the reader says of the header: one "NAME=value" a line.
"""
import os
import sys
import warnings

import numpy


def save(folder, name, array):
    array.astype(array.dtype.newbyteorder("<")).tofile(os.path.join(folder, name + ".bin"))


def read_astropy(path, folder):
    from astropy.io import fits

    warnings.simplefilter("error")  # a wrong checksum is a warning only
    with fits.open(path, checksum=True, do_not_scale_image_data=True) as units:
        for key, value in units[0].header.items():
            print(f"{key}={value}")
        for unit in units[1:]:
            for key in ("BITPIX", "NAXIS1", "NAXIS2", "NAXIS3", "BUNIT", "BLANK", "ROWORDER", "PLANE1", "PLANE2", "PLANE3"):
                if key in unit.header:
                    print(f"{unit.name}.{key}={unit.header[key]}")
            save(folder, unit.name, unit.data)


def read_gdal(path, folder):
    from osgeo import gdal

    gdal.UseExceptions()
    for name, text in gdal.Open(path).GetSubDatasets():
        data = gdal.Open(name)
        # GDAL takes the last row of a FITS image as the top one.
        save(folder, text.split(", ")[-1], data.ReadAsArray()[..., ::-1, :])


def read_numpy(path, folder):
    array = numpy.load(path, allow_pickle=False)
    print(f"shape={array.shape}")
    print(f"dtype={array.dtype}")
    save(folder, "array", array)


{"astropy": read_astropy, "gdal": read_gdal, "numpy": read_numpy}[sys.argv[1]](sys.argv[2], sys.argv[3])

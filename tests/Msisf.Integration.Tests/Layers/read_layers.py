"""Opens layers with other people's readers and writes what they see as plain little-endian numbers, in C order.

    read_layers.py astropy|gdal FILE.fits FOLDER       one FOLDER/EXTNAME.bin for each extension
    read_layers.py tiff FILE.tif FOLDER                FOLDER/array.bin, page after page, as GDAL reads them
    read_layers.py numpy FILE.npy FOLDER               FOLDER/array.bin
    read_layers.py projection FILE.fits FOLDER         nothing: projects POSITION by the header's camera

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


def read_tiff(path, folder):
    from osgeo import gdal

    gdal.UseExceptions()
    names = [name for name, _ in gdal.Open(path).GetSubDatasets()] or [path]
    pages = [gdal.Open(name) for name in names]
    print(f"about={'|'.join(page.GetMetadataItem('TIFFTAG_IMAGEDESCRIPTION') for page in pages)}")
    print(f"software={pages[0].GetMetadataItem('TIFFTAG_SOFTWARE')}")
    print(f"undefined={pages[0].GetRasterBand(1).GetNoDataValue()}")
    array = numpy.stack([page.ReadAsArray() for page in pages])
    print(f"shape={array.shape}")
    print(f"dtype={array.dtype}")
    save(folder, "array", array)


def read_numpy(path, folder):
    array = numpy.load(path, allow_pickle=False)
    print(f"shape={array.shape}")
    print(f"dtype={array.dtype}")
    save(folder, "array", array)


def project(path, folder):
    from astropy.io import fits

    head = fits.getheader(path)
    points = fits.getdata(path, "POSITION").reshape(3, -1)
    k, r = (numpy.array([[head[f"CAM{name}{i}_{j}"] for j in (1, 2, 3)] for i in (1, 2, 3)]) for name in "KR")
    t = numpy.array([head[f"CAMT{i}"] for i in (1, 2, 3)])
    seen = k @ (r @ points + t[:, None])
    row, column = numpy.mgrid[0:head["CAMH"], 0:head["CAMW"]]
    shown = ~numpy.isnan(points[0])
    error = numpy.abs(seen[:2] / seen[2] - numpy.array([column.ravel(), row.ravel()]))[:, shown]
    print(f"pixels={shown.sum()}")
    print(f"error={error.max()}")


{"astropy": read_astropy, "gdal": read_gdal, "tiff": read_tiff, "numpy": read_numpy, "projection": project}[sys.argv[1]](sys.argv[2], sys.argv[3])

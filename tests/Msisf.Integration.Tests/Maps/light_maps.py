"""Prints what GDAL and Astropy read of maps of light, a line of JSON each: light_maps.py FOLDER MAP.

FOLDER has MAP.tif, illumination.fits, MAP.npy and maps.json of the same region. With "references" as MAP it prints the entries of the list
FOLDER that PROJ knows otherwise.
"""
import json
import os
import sys

import numpy as np
from astropy.io import fits
from astropy.wcs import WCS
from osgeo import gdal, osr

gdal.UseExceptions()
osr.UseExceptions()
FOLDER, MAP = sys.argv[1:3]


def path(name):
    return os.path.join(FOLDER, name)


def by_proj(image):
    """Longitude and latitude of all cells' middles, degrees, by GDAL's geotransform and PROJ."""
    left, width, _, top, _, height = image.GetGeoTransform()
    srs = osr.SpatialReference(image.GetProjection())
    srs.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    globe = srs.CloneGeogCS()
    globe.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    sample, line = np.meshgrid(np.arange(image.RasterXSize), np.arange(image.RasterYSize))
    places = np.stack([left + (sample.ravel() + 0.5) * width, top + (line.ravel() + 0.5) * height], axis=1)
    return np.array(osr.CoordinateTransformation(srs, globe).TransformPoints(places))[:, :2], srs


def by_formula(about):
    """The same by J. Snyder, USGS PP 1395 (1987), 20-14 to 20-18, from the file beside the arrays."""
    sample, line = np.meshgrid(np.arange(about["samples"]), np.arange(about["lines"]))
    x = about["left"] + (sample.ravel() + 0.5) * about["cellWidth"]
    y = about["top"] - (line.ravel() + 0.5) * about["cellHeight"]
    if about["crsUnit"] == "degree":
        return np.stack([x, y], axis=1)
    radius = float(about["crsWkt"].split("SPHEROID")[1].split(",")[1])
    sign = -1.0 if '"latitude_of_origin",-90' in about["crsWkt"] else 1.0
    polar = 2.0 * np.arctan2(np.hypot(x, y), 2.0 * radius)
    return np.stack([np.degrees(np.arctan2(x, -sign * y)), sign * (90.0 - np.degrees(polar))], axis=1)


def apart(a, b):
    """Greatest distance of two lists of places, degrees."""
    def direction(places):
        lon, lat = np.radians(places).T
        return np.stack([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)], axis=1)
    return float(np.degrees(np.linalg.norm(direction(a) - direction(b), axis=1).max()))


def same(srs, named):
    """Whether two systems have one name and the same X and Y: IsSame() of GDAL 3.6 tells a polar system from its own WKT 1."""
    def on_map(system):
        system = system.Clone()
        globe = system.CloneGeogCS()
        for each in (system, globe):
            each.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
        transformation = osr.CoordinateTransformation(globe, system)

        def of(lon, lat):
            try:
                return transformation.TransformPoint(lon, lat)[:2]
            except RuntimeError:  # the map does not show it
                return np.nan, np.nan
        found = np.array([of(lon, lat) for lon in (10.0, 100.0, 200.0, 300.0) for lat in (-80.0, -50.0, -10.0, 10.0, 50.0, 80.0)])
        return np.where(np.isfinite(found), found, np.nan)
    return srs.GetName() == named.GetName() and bool(np.allclose(on_map(srs), on_map(named), rtol=0, atol=1e-6, equal_nan=True))


if MAP == "references":  # FOLDER is a list of names and WKT
    for entry in open(FOLDER):
        name, wkt = entry.rstrip("\n").split("\t")
        srs = osr.SpatialReference(wkt)
        named = osr.SpatialReference()
        named.SetFromUserInput(name or wkt)
        if not same(srs, named) or srs.Validate() != 0:
            print(name, wkt)
    sys.exit()

tiff = gdal.Open(path(MAP + ".tif"))
band = tiff.GetRasterBand(1)
info = gdal.Info(path(MAP + ".tif"))
about = json.load(open(path("maps.json")))
places, srs = by_proj(tiff)
array = np.load(path(MAP + ".npy"))
named = None
if about["crs"]:
    named = osr.SpatialReference()
    named.SetFromUserInput(about["crs"])
with fits.open(path("illumination.fits"), checksum=True) as file:
    first, image = file[0].header, file[MAP.upper()]
    line, sample = np.indices(image.data.shape)
    world = WCS(image.header).all_pix2world(np.stack([sample.ravel(), line.ravel()], axis=1), 0)
    print(json.dumps({
        "description": band.GetDescription(), "unit": band.GetUnitType(), **tiff.GetMetadata(),
        "shown": f"Description = {band.GetDescription()}" in info and f"Unit Type: {band.GetUnitType()}" in info,
        "nodata": str(band.GetNoDataValue()), "is_named": named is None or same(srs, named),
    }))
    print(json.dumps({
        **{key: first[key] for key in ("TIMESYS", "DATE-BEG", "DATE-END", "STEP", "SUN")},
        **{key: image.header[key] for key in ("BUNIT", "HEIGHT")}, "about": "".join(image.header["COMMENT"]),
        "same": bool(np.array_equal(image.data, band.ReadAsArray(), equal_nan=True) and np.array_equal(image.data, array, equal_nan=True)),
    }))
    print(json.dumps({
        "of_fits": {key: first.get(key) for key in ("CREATOR", "CMDLINE", "CRS", "OBJECT")},
        "inputs": [first[f"INPUT{i + 1}"] for i in range(len(about["inputs"]))], "json": about,
        "types": [image.header["CTYPE1"], image.header["CTYPE2"]], "radius": image.header["A_RADIUS"],
        "wcs": apart(world, by_formula(about)), "proj": apart(places, by_formula(about)),
        "kernel_hashes": [entry["sha256"] for entry in about["inputs"] if entry["kind"] == "kernel"],
    }))

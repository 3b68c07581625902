"""Compares cubes and PDS4 products of msis with the layers and numbers of the same frames, as GDAL and a parser of its own read them.

  cubes.py LIBCSPICE KERNELS_OF_PROJECT MJD FOLDER...

MJD is the time of the images; of a scan, whose folder's name begins with "scan", of its first line. In the cube of "scan-up" the last
row of the image is line 1.

In each folder lie frame.cub, frame.lblx, frame.img and frame.fits, with a detector frame.dn.fits. A line for each folder: its name, body,
mean of the image, then what differs ("ok" for nothing).
"""
import ctypes as c
import os
import sys
import xml.etree.ElementTree as ET

import numpy as np
from astropy.io import fits
from osgeo import gdal

from isis import Cube

gdal.UseExceptions()
# Elements and their order: PDS4 information model 1.20.
LABEL = """Identification_Area/logical_identifier Identification_Area/version_id Identification_Area/title
Identification_Area/information_model_version Identification_Area/product_class Observation_Area/comment
Observation_Area/Time_Coordinates/start_date_time Observation_Area/Time_Coordinates/stop_date_time
Observation_Area/Investigation_Area/name Observation_Area/Investigation_Area/type
Observation_Area/Investigation_Area/Internal_Reference/lid_reference
Observation_Area/Investigation_Area/Internal_Reference/reference_type
Observation_Area/Observing_System/Observing_System_Component/name Observation_Area/Observing_System/Observing_System_Component/type
Observation_Area/Observing_System/Observing_System_Component/description Observation_Area/Target_Identification/name
Observation_Area/Target_Identification/type Observation_Area/Target_Identification/Internal_Reference/lid_reference
Observation_Area/Target_Identification/Internal_Reference/reference_type File_Area_Observational/File/file_name
File_Area_Observational/Array_2D_Image/local_identifier File_Area_Observational/Array_2D_Image/offset
File_Area_Observational/Array_2D_Image/axes File_Area_Observational/Array_2D_Image/axis_index_order
File_Area_Observational/Array_2D_Image/description File_Area_Observational/Array_2D_Image/Element_Array/data_type
File_Area_Observational/Array_2D_Image/Element_Array/scaling_factor File_Area_Observational/Array_2D_Image/Element_Array/value_offset
File_Area_Observational/Array_2D_Image/Axis_Array/axis_name File_Area_Observational/Array_2D_Image/Axis_Array/elements
File_Area_Observational/Array_2D_Image/Axis_Array/sequence_number File_Area_Observational/Array_2D_Image/Axis_Array/axis_name
File_Area_Observational/Array_2D_Image/Axis_Array/elements File_Area_Observational/Array_2D_Image/Axis_Array/sequence_number
File_Area_Observational/Array_2D_Image/Special_Constants/missing_constant""".split()


def leaves(element, path=""):
    for child in element:
        name = path + child.tag.split("}")[1]
        yield from leaves(child, name + "/") if len(child) else [name]


def of_gdal(path, expected, missing):
    """What GDAL finds in a file that is not so in the layer."""
    image = gdal.Open(path)
    band = image.GetRasterBand(1)
    found = band.ReadAsArray()
    least, most, mean, spread = band.ComputeStatistics(False)
    used = expected[np.isfinite(expected)].astype(np.float64)
    yield "size", (image.RasterXSize, image.RasterYSize, image.RasterCount) == (*expected.shape[::-1], 1)
    yield "type", band.DataType == gdal.GDT_Float32
    yield "pixels", np.array_equal(found[np.isfinite(expected)], used)
    yield "scale", (band.GetScale() or 1.0, band.GetOffset() or 0.0) == (1.0, 0.0)
    yield "no-data", np.float32(band.GetNoDataValue()) == missing and np.all(found[~np.isfinite(expected)] == missing)
    yield "statistics", (least, most) == (used.min(), used.max()) and np.allclose([mean, spread], [used.mean(), used.std()], rtol=1e-9)


def wrong(folder, spice, mjd):
    stem = os.path.join(folder, "frame")
    has_detector = os.path.exists(stem + ".dn.fits")
    layers = fits.open(stem + ".fits")
    expected = (fits.getdata(stem + ".dn.fits") if has_detector else layers["RADIANCE_FACTOR"].data).astype(np.float32)
    cube = Cube(stem + ".cub")
    null = np.array([0xFF7FFFFB], "<u4").view("<f4")[0]
    in_cube = expected[::-1] if folder.endswith("up") else expected
    checks = [("cube " + name, is_right) for name, is_right in of_gdal(stem + ".cub", in_cube, null)]
    checks += [("pds4 " + name, is_right) for name, is_right in of_gdal(stem + ".lblx", expected, np.float32(-32768))]
    group = cube.label["IsisCube"]
    naif = cube.label["NaifKeywords"]
    target = group["Instrument"]["TargetName"]
    frame = b"MOON_ME" if target == "Moon" else b"IAU_" + target.upper().encode()
    day = int(mjd)
    utc = 86400.0 * (day - 51544) - 43200.0 + (mjd - day) * 86400.0
    delta, code, count = c.c_double(), c.c_int(), c.c_int()
    spice.deltet_c(c.c_double(utc), b"UTC", c.byref(delta))
    time = utc + delta.value
    rotation, radii, state, light_time = (c.c_double * 9)(), (c.c_double * 3)(), (c.c_double * 6)(), c.c_double()
    spice.pxform_c(b"J2000", frame, c.c_double(time), rotation)
    spice.spkezr_c(b"SUN", c.c_double(time), b"J2000", b"NONE", target.encode(), state, c.byref(light_time))
    spice.namfrm_c(frame, c.byref(code))
    spice.bodn2c_c(target.encode(), c.byref(count), c.byref(c.c_int()))
    sun, *_ = cube.column("SunPosition", "J2000X", "J2000Y", "J2000Z", "J2000XV", "J2000YV", "J2000ZV")
    duration = group["Instrument"].get("ExposureDuration", 0.0) / 1000.0
    times = [table["ET"][0] for table in cube.tables.values()] + [group["Instrument"]["EphemerisTime"] + duration / 2]
    is_scan = "scan" in os.path.basename(folder)
    checks += [
        ("image", np.array_equal(cube.image.astype(np.float32), in_cube, equal_nan=True)),
        ("unit", group["Radiometry"]["RadiometricType"] == ("DN" if has_detector else "IOF")),
        ("tables", list(cube.tables) == ["InstrumentPointing", "InstrumentPosition", "BodyRotation", "SunPosition"]),
        ("camera", (group["Instrument"]["InstrumentId"], group["Kernels"]["CameraVersion"]) == ("IdealCamera", 1)),
        ("kernels", all(group["Kernels"][name] == "Table" for name in ("TargetPosition", "InstrumentPosition", "InstrumentPointing"))),
        ("times", np.ptp(times) < 2e-7 * is_scan + 1e-9 and abs(times[0] - time) < 2e-6),
        ("type", group["Instrument"]["InstrumentType"] == ("Linescan" if is_scan else "Framing")),
        ("body-rotation", np.abs(cube.rotation("BodyRotation") - np.reshape(rotation, (3, 3))).max() < 1e-12),
        ("sun", np.linalg.norm(sun[:3] - state[:3]) < 1.0 and np.linalg.norm(sun[3:] - state[3:]) < 1e-6),
        ("codes", (naif["BODY_CODE"], naif["BODY_FRAME_CODE"]) == (count.value, code.value)),
        ("label", list(leaves(ET.parse(stem + ".lblx").getroot())) == LABEL),
        ("file", ET.parse(stem + ".lblx").getroot().find(".//{*}file_name").text == "frame.img"),
    ]
    position = np.moveaxis(layers["POSITION"].data, 0, -1)
    seen = np.isfinite(position).all(axis=-1)
    v, h = np.nonzero(seen)
    v = len(seen) - 1 - v if folder.endswith("up") else v
    sample, line = cube.pixels(position[seen], v + 1)
    checks.append(("projection", len(h) > 100 and np.hypot(sample - 1 - h, line - 1 - v).max() < 1e-6))
    return target, expected.mean(), [name for name, is_right in checks if not is_right]


folders = [os.path.abspath(folder) for folder in sys.argv[4:]]
library = c.CDLL(os.path.abspath(sys.argv[1]))
os.chdir(sys.argv[2])  # the meta-kernel's paths are relative
for kernel in (b"msisf.tm", b"bodies.tm"):
    library.furnsh_c(kernel)
for folder in folders:
    target, mean, names = wrong(folder, library, float(sys.argv[3]))
    print(os.path.basename(folder), target, mean, ",".join(names) or "ok")

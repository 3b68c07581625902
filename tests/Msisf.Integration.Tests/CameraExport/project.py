"""Projects the points of position layers by camera models of msis, each from its file alone, and says how far they are from their pixels.

  project.py LIBCSPICE KERNELS_OF_PROJECT MJD FOLDER...

In each folder lies a layer frame.position.npy (m, MOON_ME). A line for each camera model in it: folder, file, pixels compared, largest
error (px), what is wrong with the text ("-" for nothing). Formulas: OpenCV's calib3d, COLMAP's models.h, the manual of the Ames Stereo
Pipeline, USGSCSM's Distortion.cpp.
"""
import ctypes as c
import json
import os
import re
import sys

import numpy as np

from isis import Cube, turn


def opencv(x, y, k):
    k = list(k) + [0.0] * (12 - len(k))
    k1, k2, p1, p2, k3, k4, k5, k6, s1, s2, s3, s4 = k
    r = x*x + y*y
    q = (1 + k1*r + k2*r**2 + k3*r**3) / (1 + k4*r + k5*r**2 + k6*r**3)
    return (x*q + 2*p1*x*y + p2*(r + 2*x*x) + s1*r + s2*r*r, y*q + p1*(r + 2*y*y) + 2*p2*x*y + s3*r + s4*r*r)


def fisheye(x, y, k):
    r = np.hypot(x, y)
    t = np.arctan(r)
    q = t * (1 + k[0]*t**2 + k[1]*t**4 + k[2]*t**6 + k[3]*t**8) / r
    return x*q, y*q


def division(x, y, k):
    """COLMAP's closed form of u = d / (1 + k d^2)."""
    r = 2 / (1 + np.sqrt(1 - 4*k[0]*(x*x + y*y)))
    return x*r, y*r


def pixels_opencv(path, points):
    text = open(path).read()
    matrices = {name: np.array(json.loads(data)).reshape(int(rows), int(columns)) for name, rows, columns, data in re.findall(
        r"(\w+): !!opencv-matrix\s+rows: (\d+)\s+cols: (\d+)\s+dt: d\s+data: (\[[^]]*\])", text)}
    k, lens = matrices["camera_matrix"], matrices["distortion_coefficients"].ravel()
    a, b, z = (points @ matrices["R"].T + matrices["t"].ravel()).T
    x, y = (fisheye if "distortion_model: fisheye" in text else opencv)(a / z, b / z, lens)
    assert k[0, 1] == 0.0  # projectPoints does not read it
    return k[0, 0]*x + k[0, 2], k[1, 1]*y + k[1, 2]


def pixels_colmap(path, points):
    def lines(name):
        return [line.split() for line in open(path.replace(".cameras.", f".{name}.")) if not line.startswith("#")]
    (_, model, _, _, *p), = lines("cameras")
    image = [float(word) for word in lines("images")[0][1:8]]
    assert lines("images")[0][8:] == ["1", "frame.png"] and lines("points3D") == []
    fx, fy, cx, cy, *lens = map(float, p)
    a, b, z = (points @ turn(*image[:4]).T + image[4:]).T
    assert len(lens) == {"PINHOLE": 0, "OPENCV": 4, "FULL_OPENCV": 8, "OPENCV_FISHEYE": 4, "DIVISION": 1}[model]
    x, y = {"OPENCV_FISHEYE": fisheye, "DIVISION": division}.get(model, opencv)(a / z, b / z, lens)
    return fx*x + cx - 0.5, fy*y + cy - 0.5


def pixels_tsai(path, points):
    lines = open(path).read().splitlines()
    values = {name: [float(word) for word in text.split()] for name, text in (line.split(" = ") for line in lines if "=" in line)}
    lens = lines[lines.index("pitch = 1") + 1]
    assert lines[:2] == ["VERSION_4", "PINHOLE"] and values["pitch"] == [1.0]
    assert [values[axis + "_direction"] for axis in "uvw"] == np.eye(3).tolist()
    a, b, z = ((points - values["C"]) @ np.reshape(values["R"], (3, 3))).T
    names = {"NULL": [], "TSAI": ["k1", "k2", "p1", "p2", "k3"], "FISHEYE": ["k1", "k2", "k3", "k4"],
             "BROWNCONRADY": ["xp", "yp", "k1", "k2", "k3", "p1", "p2", "phi"]}[lens]
    assert [line.split()[0] for line in lines[lines.index(lens) + 1:]] == names
    k = [values[name][0] for name in names]
    if lens == "BROWNCONRADY":  # from measured to ideal, in the unit of the pitch
        assert k[:2] + k[5:] == [0.0] * 5
        x, y = inverse(lambda a, b: (a*np.polyval([*k[4:1:-1], 1.0], a*a + b*b), b*np.polyval([*k[4:1:-1], 1.0], a*a + b*b)),
                       values["fu"][0]*a/z, values["fv"][0]*b/z)
        return x + values["cu"][0], y + values["cv"][0]
    x, y = (fisheye if lens == "FISHEYE" else opencv)(a / z, b / z, k)
    return values["fu"][0]*x + values["cu"][0], values["fv"][0]*y + values["cv"][0]


def inverse(undistorted, x, y):
    """Measured coordinates of ideal ones, by fixed points."""
    a, b = x, y
    for _ in range(200):
        u, v = undistorted(a, b)
        a, b = a + x - u, b + y - v
    return a, b


def lens_csm(kind, k, x, y, f):
    """Of lengths in the focal plane, ideal to measured."""
    if kind == 7:
        a, b = opencv(x / f, y / f, k)
        return a*f, b*f
    if kind == 4:
        a, b = inverse(lambda a, b: (a, b / (1 + k[0]*b*b)), x, y)
        return a, np.where(np.abs(y) > 40, y, b)  # the unit is meant to be mm
    if kind == 1:
        terms = np.array([np.ones_like(x), x, y, x*x, x*y, y*y, x**3, x*x*y, x*y*y, y**3])
        return np.tensordot(k[:10], terms, 1), np.tensordot(k[10:], terms, 1)
    if kind == 0:
        def radial(a, b):
            r = a*a + b*b
            q = 1 - k[0] - k[1]*r - k[2]*r*r
            return a*q, b*q
        return inverse(radial, x, y)

    def kaguya(a, b):
        r = np.hypot(a, b)
        return a + k[0] + np.polyval(k[4:0:-1], r), b + k[5] + np.polyval(k[:5:-1], r)
    assert kind == 2
    return inverse(kaguya, x, y)


def to_pixels(x, y, z, camera):
    f, samples, lines, center, kind, k = camera
    a, b = lens_csm(kind, np.array(k), f * x / z, f * y / z, f)
    return (samples[0] + samples[1]*a + samples[2]*b + center[1] - 0.5, lines[0] + lines[1]*a + lines[2]*b + center[0] - 0.5)


def pixels_csm(path, points):
    s = json.loads(open(path).read().split("\n", 1)[1])
    p = s["m_currentParameterValue"]
    x, y, z = ((points - p[:3]) @ turn(p[6], *p[3:6])).T
    return to_pixels(x, y, z, (s["m_focalLength"], s["m_iTransS"], s["m_iTransL"], s["m_ccdCenter"], s["m_distortionType"],
                               s["m_opticalDistCoeffs"]))


def pixels_isd(path, points):
    s = json.load(open(path))
    (name, lens), = s["optical_distortion"].items()
    kind, k = {
        "radtan": lambda: (7, lens["coefficients"]), "radial": lambda: (0, lens["coefficients"]),
        "lrolrocnac": lambda: (4, lens["coefficients"]), "transverse": lambda: (1, lens["x"] + lens["y"]),
        "kaguyalism": lambda: (2, [lens["boresight_x"], *lens["x"], lens["boresight_y"], *lens["y"]]),
    }[name]()
    inertial = points @ turn(*s["body_rotation"]["quaternions"][0])  # rows: the inverse of J2000 to body
    constant = np.reshape(s["instrument_pointing"]["constant_rotation"], (3, 3))
    sensor = constant @ turn(*s["instrument_pointing"]["quaternions"][0])
    x, y, z = ((inertial - 1000.0 * np.array(s["instrument_position"]["positions"][0])) @ sensor.T).T
    center = s["detector_center"]
    return to_pixels(x, y, z, (s["focal_length_model"]["focal_length"], s["focal2pixel_samples"], s["focal2pixel_lines"],
                               (center["line"], center["sample"]), kind, k))


def pixels_isis(path, points):
    x, y = Cube(path).pixels(points)
    return x - 1, y - 1


def wrong_text(path, time, body_from_j2000):
    """What breaks a rule of the format; "-" for nothing."""
    if path.endswith(".cub"):
        return "-"  # cubes.py
    text = open(path).read()
    if re.search(r"nan|inf\b", text, re.I):
        return "not-a-number"
    if not path.endswith(".json"):
        return "-"
    if re.search(r"\[-?\d+[,\]]", text):
        return "array-begins-with-an-integer"
    if not path.endswith(".csm.json"):
        s = json.loads(text)
        expected = np.eye(3) if "isd-body" in path else body_from_j2000
        return ("body-rotation" if np.abs(turn(*s["body_rotation"]["quaternions"][0]) - expected).max() > 1e-12 else  # the Moon turns by 8e-13 rad in half a step of an MJD
                "time" if abs(s["center_ephemeris_time"] - time) > 2e-6 else
                "radii" if (s["radii"]["semimajor"], s["radii"]["unit"]) != (1737.4, "km") else "-")
    name, body = text.split("\n", 1)
    s = json.loads(body)
    p = s["m_currentParameterValue"]
    required = """m_modelName m_imageIdentifier m_sensorName m_platformName m_collectionIdentifier m_nLines m_nSamples m_focalLength
        m_focalLengthEpsilon m_iTransS m_iTransL m_transX m_transY m_ccdCenter m_startingDetectorSample m_startingDetectorLine
        m_detectorSampleSumming m_detectorLineSumming m_distortionType m_opticalDistCoeffs m_majorAxis m_minorAxis
        m_currentParameterValue m_currentParameterCovariance m_ephemerisTime m_spacecraftVelocity m_sunPosition""".split()
    counts = {0: 3, 1: 20, 2: 10, 4: 1, 7: 5}
    pixel_of_mm = np.array([s["m_iTransS"][1:], s["m_iTransL"][1:]])
    mm_of_pixel = np.array([s["m_transX"][1:], s["m_transY"][1:]])
    return ("name" if name != "USGS_ASTRO_FRAME_SENSOR_MODEL" or name != s["m_modelName"] else
            "missing" if any(field not in s for field in required) else
            "counts" if (len(p), len(s["m_currentParameterCovariance"]), len(s["m_opticalDistCoeffs"])) !=
            (7, 49, counts[s["m_distortionType"]]) else
            "quaternion" if abs(np.linalg.norm(p[3:]) - 1.0) > 1e-14 else
            "inverse" if np.abs(pixel_of_mm @ mm_of_pixel - np.eye(2)).max() > 1e-14 else
            "time" if abs(s["m_ephemerisTime"] - time) > 2e-6 else
            "axes" if s["m_majorAxis"] != 1737400.0 else "-")


def of_cspice(library, kernels, mjd):
    """TDB seconds and the rotation from J2000 to MOON_ME."""
    spice = c.CDLL(library)
    os.chdir(kernels)  # the meta-kernel's paths are relative
    spice.furnsh_c(b"msisf.tm")
    day = int(mjd)
    utc = 86400.0 * (day - 51544) - 43200.0 + (mjd - day) * 86400.0
    delta, rotation = c.c_double(), (c.c_double * 9)()
    spice.deltet_c(c.c_double(utc), b"UTC", c.byref(delta))
    spice.pxform_c(b"J2000", b"MOON_ME", c.c_double(utc + delta.value), rotation)
    return utc + delta.value, np.reshape(rotation, (3, 3))


folders = [os.path.abspath(folder) for folder in sys.argv[4:]]
time, body_from_j2000 = of_cspice(os.path.abspath(sys.argv[1]), sys.argv[2], float(sys.argv[3]))
readers = {".opencv.yaml": pixels_opencv, ".cameras.txt": pixels_colmap, ".tsai": pixels_tsai, ".csm.json": pixels_csm,
           ".isd.json": pixels_isd, ".isd-body.json": pixels_isd, ".cub": pixels_isis}
for folder in folders:
    layer = np.load(f"{folder}/frame.position.npy")
    seen = np.isfinite(layer).all(axis=-1)
    v, h = np.nonzero(seen)
    for ending, reader in readers.items():
        path = f"{folder}/frame{ending}"
        if os.path.exists(path):
            x, y = reader(path, layer[seen])
            error = np.hypot(x - h, y - v).max()
            print(os.path.basename(folder), ending[1:], len(h), error, wrong_text(path, time, body_from_j2000))

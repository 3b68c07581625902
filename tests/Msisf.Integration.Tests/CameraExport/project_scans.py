"""Projects the points of position layers of scans by camera models of msis, each from its file alone, and says how far they are from
their pixels.

  project_scans.py FOLDER[:VX,VY,VZ,WX,WY,WZ,LINE_TIME]...

In each folder lies a layer frame.position.npy (m, body-fixed). With numbers it shows one time, and the rows were exposed one after the
other while the camera moved so (m/s; rad/s about its axes: looks along -x, y right, z up): points come from frame.opencv.yaml then. A line
for each camera model in it: folder, file, pixels compared, largest error (px), nodes, what is wrong with the text ("-" for nothing).
Formulas: USGSCSM's UsgsAstroLsSensorModel.cpp, UsgsAstroPushFrameSensorModel.cpp (the state and how it is made of image support data),
Utilities.cpp (lagrangeInterp), Distortion.cpp.
"""
import json
import os
import re
import sys

import numpy as np

LINE_SCAN, PUSH_FRAME = "USGS_ASTRO_LINE_SCANNER_SENSOR_MODEL", "USGS_ASTRO_PUSH_FRAME_SENSOR_MODEL"


def turns(q):
    """The matrices of quaternions x, y, z, w of any length."""
    x, y, z, w = np.moveaxis(q / np.linalg.norm(q, axis=-1, keepdims=True), -1, 0)
    return np.moveaxis(np.array([[1 - 2*(y*y + z*z), 2*(x*y - w*z), 2*(x*z + w*y)],
                                 [2*(x*y + w*z), 1 - 2*(x*x + z*z), 2*(y*z - w*x)],
                                 [2*(x*z - w*y), 2*(y*z + w*x), 1 - 2*(x*x + y*y)]]), [0, 1], [-2, -1])


def interpolate(values, start, step, times):
    """lagrangeInterp: through 8 neighbours, 6, 4 or 2 near the ends."""
    n = len(values)
    at = (times - start) / step
    index = np.clip(at.astype(int), 0, n - 2)
    order = np.where((index >= 3) & (index < n - 4), 8, np.where((index >= 2) & (index < n - 3), 6, np.where(
        (index >= 1) & (index < n - 2), 4, 2)))
    result = np.empty((len(times), values.shape[1]))
    for k in np.unique(order):
        here = order == k
        nodes = index[here, None] - k//2 + 1 + np.arange(k)
        weights = np.ones(nodes.shape)
        for i in range(k):
            for j in range(k):
                if i != j:
                    weights[:, i] *= (at[here] - nodes[:, j]) / (i - j)
        result[here] = np.einsum("ni,nic->nc", weights, values[nodes])
    return result


def opencv(x, y, k):
    k1, k2, p1, p2, k3 = k
    r = x*x + y*y
    q = 1 + k1*r + k2*r**2 + k3*r**3
    return x*q + 2*p1*x*y + p2*(r + 2*x*x), y*q + p1*(r + 2*y*y) + 2*p2*x*y


def inverse(undistorted, x, y):
    a, b = x, y
    for _ in range(100):
        u, v = undistorted(a, b)
        a, b = a + x - u, b + y - v
        if max(np.abs(x - u).max(), np.abs(y - v).max()) < 1e-12:
            break
    return a, b


def distort(kind, k, x, y, f):
    """Lengths in the focal plane, ideal to measured."""
    k = np.array(k)
    if kind == 7:
        a, b = opencv(x / f, y / f, k)
        return a*f, b*f
    if kind == 1:
        terms = np.array([np.ones_like(x), x, y, x*x, x*y, y*y, x**3, x*x*y, x*y*y, y**3])
        return np.tensordot(k[:10], terms, 1), np.tensordot(k[10:], terms, 1)
    if kind == 4:
        a, b = inverse(lambda a, b: (a, b / (1 + k[0]*b*b)), x, y)
        return a, np.where(np.abs(y) > 40, y, b)  # the unit is meant to be mm
    if kind == 0:
        return inverse(lambda a, b: (a*(1 - k[0] - k[1]*(a*a + b*b) - k[2]*(a*a + b*b)**2),
                                     b*(1 - k[0] - k[1]*(a*a + b*b) - k[2]*(a*a + b*b)**2)), x, y)
    assert kind == 2
    return inverse(lambda a, b: (a + k[0] + np.polyval(k[4:0:-1], np.hypot(a, b)), b + k[5] + np.polyval(k[:5:-1], np.hypot(a, b))), x, y)


def detector(s, points, times):
    """Line and sample on the detector of points at times after the centre; the line's zero is the exposed one of a line-scan."""
    positions = np.array(s["m_positions"]).reshape(-1, 3)
    quaternions = np.array(s["m_quaternions"]).reshape(-1, 4)
    position = interpolate(positions, s["m_t0Ephem"], s["m_dtEphem"], times)
    turn = turns(interpolate(quaternions, s["m_t0Quat"], s["m_dtQuat"], times))
    x, y, z = np.einsum("nji,nj->in", turn, points - position)
    f = s["m_focalLength"]
    a, b = distort(s["m_distortionType"], s["m_opticalDistCoeffs"], f*x/z, f*y/z, f)
    return tuple(t[0] + t[1]*a + t[2]*b + s[origin] for t, origin in (
        (s["m_iTransL"], "m_detectorLineOrigin"), (s["m_iTransS"], "m_detectorSampleOrigin")))


def line_scan(s, points, lines):
    """groundToImage: the line at whose time the point is on the detector's line, searched from the one given."""
    (edge,), (start,), (period,) = s["m_intTimeLines"], s["m_intTimeStartTimes"], s["m_intTimes"]

    def at(line):
        return detector(s, points, start + period*(line - edge + 0.5))
    before, line = lines - 0.01, lines + 0.01
    error = at(before)[0]
    for _ in range(30):
        now, sample = at(line)
        slope = (now - error) / np.where(line == before, 1.0, line - before)
        still = np.abs(slope) < 1e-9  # without motion any line is right: that of the pixel
        moving = np.where(np.abs(now) < 1e-9, 0.0, now / np.where(still, 1.0, slope))
        step = np.where(still & (line != before), line - lines, np.where(still, 0.0, moving))
        if not step.any():
            break
        before, error, line = line, now, line - step
    return line, sample


def push_frame(s, points, lines):
    """The pixel in the framelet of a line."""
    height = s["m_reducedframeletHeight"]
    assert s["m_frameletHeight"] == height and s["m_numLinesOverlap"] == 0 and not s["m_frameletsFlipped"]
    framelet = (lines // height).astype(int)
    exposure = s["m_nReducedLines"] // height - framelet - 1 if s["m_frameletsOrderReversed"] else framelet
    times = s["m_startingEphemerisTime"] + 0.5*s["m_exposureDuration"] + exposure*s["m_interframeDelay"] - s["m_centerEphemerisTime"]
    line, sample = detector(s, points, times)
    return line + framelet*height, sample


def state_of_isd(s):
    """constructStateFromIsd: motion and rotation of the body as the file has them, at the file's own times."""
    times = np.array(s["instrument_position"]["ephemeris_times"])
    steps = times[0] + np.arange(len(times)) * (times[-1] - times[0]) / (len(times) - 1)
    assert len(times) >= 25 and np.abs(times - steps).max() < 2e-7  # of others USGSCSM makes nodes of its own
    for name in ("instrument_pointing", "body_rotation"):
        assert s[name]["ephemeris_times"] == times.tolist()
    scalar_last = [1, 2, 3, 0]
    sensor = np.array(s["instrument_pointing"]["quaternions"])[:, scalar_last]  # from J2000
    body = np.array(s["body_rotation"]["quaternions"])[:, scalar_last]
    assert s["instrument_pointing"]["constant_rotation"] == np.eye(3).ravel().tolist()
    x, y, z, w = (body * [1, 1, 1, 1]).T  # body times inverse of sensor
    a, b, c, d = (sensor * [-1, -1, -1, 1]).T
    product = np.array([w*a + x*d + y*c - z*b, w*b - x*c + y*d + z*a, w*c + x*b - y*a + z*d, w*d - x*a - y*b - z*c]).T
    # cubic Hermite at the uniform times, which are those of the file but for their rounding
    inertial = np.array(s["instrument_position"]["positions"]) + (steps - times)[:, None] * s["instrument_position"]["velocities"]
    center, center_time = s["detector_center"], s["center_ephemeris_time"]
    (lens, content), = s["optical_distortion"].items()
    kind, k = {
        "radtan": lambda: (7, content["coefficients"]), "radial": lambda: (0, content["coefficients"]),
        "lrolrocnac": lambda: (4, content["coefficients"]), "transverse": lambda: (1, content["x"] + content["y"]),
        "kaguyalism": lambda: (2, [content["boresight_x"], *content["x"], content["boresight_y"], *content["y"]]),
    }[lens]()
    state = {"m_modelName": s["name_model"], "m_focalLength": s["focal_length_model"]["focal_length"],
             "m_iTransL": s["focal2pixel_lines"], "m_iTransS": s["focal2pixel_samples"], "m_detectorLineOrigin": center["line"],
             "m_detectorSampleOrigin": center["sample"], "m_distortionType": kind, "m_opticalDistCoeffs": k,
             "m_positions": 1000.0 * np.einsum("nij,nj->ni", turns(body), inertial), "m_quaternions": product,
             "m_t0Ephem": steps[0] - center_time, "m_dtEphem": (times[-1] - times[0]) / (len(times) - 1),
             "m_t0Quat": times[0] - center_time, "m_dtQuat": (times[-1] - times[0]) / (len(times) - 1), "m_nLines": s["image_lines"],
             "m_nSamples": s["image_samples"],
             "m_centerEphemerisTime": center_time, "m_startingEphemerisTime": s["starting_ephemeris_time"]}
    if s["name_model"] == LINE_SCAN:
        rate, = s["line_scan_rate"]
        return state | dict(zip(("m_intTimeLines", "m_intTimeStartTimes", "m_intTimes"), ([value] for value in rate)))
    height = s["framelet_height"] - s["num_lines_overlap"]
    return state | {"m_exposureDuration": s["exposure_duration"], "m_interframeDelay": s["interframe_delay"],
                    "m_frameletHeight": s["framelet_height"], "m_frameletsFlipped": s["framelets_flipped"],
                    "m_frameletsOrderReversed": s["framelet_order_reversed"], "m_numLinesOverlap": s["num_lines_overlap"],
                    "m_reducedframeletHeight": height, "m_nReducedLines": s["image_lines"] // s["framelet_height"] * height}


def wrong_text(text, s, is_state):
    """What breaks a rule of the format; "-" for nothing."""
    quaternions = np.array(s["m_quaternions"]).reshape(-1, 4)
    if re.search(r"nan|inf\b", text, re.I):
        return "not-a-number"
    if re.search(r"\[-?\d+[,\]]", text):
        return "array-begins-with-an-integer"
    if (np.sum(quaternions[1:] * quaternions[:-1], axis=1) <= 0.0).any() or np.abs(np.linalg.norm(quaternions, axis=1) - 1).max() > 1e-12:
        return "quaternions"
    if not is_state:
        return "-"
    required = """m_modelName m_imageIdentifier m_sensorName m_sensorIdentifier m_platformIdentifier m_platformFlag m_ikCode m_nLines
        m_nSamples m_startingEphemerisTime m_centerEphemerisTime m_focalLength m_zDirection m_iTransS m_iTransL m_detectorSampleOrigin
        m_detectorLineOrigin m_startingDetectorSample m_startingDetectorLine m_detectorSampleSumming m_detectorLineSumming
        m_distortionType m_opticalDistCoeffs m_majorAxis m_minorAxis m_minElevation m_maxElevation m_t0Ephem m_dtEphem m_numPositions
        m_positions m_velocities m_t0Quat m_dtQuat m_numQuaternions m_quaternions m_currentParameterValue m_referencePointXyz
        m_sunPosition m_sunVelocity m_gsd m_flyingHeight m_halfSwath m_halfTime m_covariance""".split()
    required += {LINE_SCAN: ["m_intTimeLines", "m_intTimeStartTimes", "m_intTimes"], PUSH_FRAME: [
        "m_exposureDuration", "m_interframeDelay", "m_frameletHeight", "m_reducedframeletHeight", "m_nReducedLines", "m_numLinesOverlap",
        "m_frameletsFlipped", "m_frameletsOrderReversed", "m_parameterType"]}[s["m_modelName"]]
    whole = """m_nLines m_nSamples m_numPositions m_numQuaternions m_distortionType m_platformFlag m_ikCode m_frameletHeight
        m_reducedframeletHeight m_nReducedLines m_numLinesOverlap""".split()
    counts = {0: 3, 1: 20, 2: 10, 4: 1, 7: 5}
    return ("name" if text.split("\n", 1)[0] != s["m_modelName"] else
            "missing" if any(field not in s for field in required) else
            "whole" if any(type(s[name]) is not int for name in whole if name in s) else
            "real" if any(type(value) is int for name, value in s.items() if name not in whole and not isinstance(value, bool)) else
            "counts" if (s["m_numPositions"], s["m_numQuaternions"]) != (len(s["m_positions"]), len(s["m_quaternions"])) or
            len(s["m_positions"]) != len(s["m_velocities"]) or len(s["m_positions"]) * 4 != len(s["m_quaternions"]) * 3 or
            len(s["m_currentParameterValue"]) != 16 or len(s["m_opticalDistCoeffs"]) != counts[s["m_distortionType"]] else
            "axes" if s["m_majorAxis"] != 1737400.0 else "-")


def velocity_error(s):
    """m/s: how far the velocities are from the slopes of the positions, at inner nodes."""
    p, v = (np.array(s[name]).reshape(-1, 3) for name in ("m_positions", "m_velocities"))
    return np.abs((p[2:] - p[:-2]) / (2 * s["m_dtEphem"]) - v[1:-1]).max()


def points_of_rows(folder, motion):
    """A point 300 km along the ray of each pixel, at the time of its row, and rows and columns."""
    text = open(f"{folder}/frame.opencv.yaml").read()
    k, r, t = (np.array(json.loads(re.search(name + r": !!opencv-matrix[^[]*(\[[^]]*\])", text)[1])) for name in (
        "camera_matrix", "R", "t"))
    k, r = k.reshape(3, 3), r.reshape(3, 3)
    *velocity, wx, wy, wz, line_time = motion
    height, width = (int(re.search(rf"image_{name}: (\d+)", text)[1]) for name in ("height", "width"))
    v, h = np.indices((height, width)).reshape(2, -1)
    seconds = (v - 0.5*(height - 1)) * line_time
    spin = np.array([wy, -wz, -wx])  # about OpenCV's axes
    rate = np.linalg.norm(spin)
    half = 0.5 * rate * seconds[:, None]
    turn = turns(np.hstack([np.sin(half) * spin / rate, np.cos(half)]))
    rays = np.linalg.solve(k, np.array([h, v, np.ones_like(h)])).T
    position = -r.T @ t + seconds[:, None] * velocity
    return position + 3e5 * np.einsum("nij,nj->ni", turn, rays) @ r, v, h


for argument in sys.argv[1:]:
    folder, *motion = argument.split(":")
    layer = np.load(f"{folder}/frame.position.npy")
    seen = np.isfinite(layer).all(axis=-1)
    v, h = np.nonzero(seen)
    points = layer[seen]
    if motion:
        points, v, h = points_of_rows(folder, [float(number) for number in motion[0].split(",")])
    for ending in ("csm.json", "isd.json", "isd-body.json"):
        path = f"{folder}/frame.{ending}"
        if not os.path.exists(path):
            continue
        text = open(path).read()
        is_state = ending == "csm.json"
        state = json.loads(text.split("\n", 1)[1]) if is_state else state_of_isd(json.loads(text))
        assert (state["m_nLines"], state["m_nSamples"]) == layer.shape[:2]
        project = line_scan if state["m_modelName"] == LINE_SCAN else push_frame
        y, x = project(state, points, v + 0.5)
        error = np.hypot(x - 0.5 - h, y - 0.5 - v).max()
        wrong = wrong_text(text, state, is_state)
        if wrong == "-" and is_state and velocity_error(state) > 1e-6:
            wrong = "velocities"
        print(os.path.basename(folder), ending, len(h), error, len(state["m_quaternions"]) // (4 if is_state else 1), wrong)

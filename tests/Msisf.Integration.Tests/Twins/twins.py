#!/usr/bin/env python3
"""Cubes as ISIS's spiceinit leaves them, from the camera models of real images, and where each of their pixels looks, by the formulas of
ISIS's cameras and numpy alone.

    /usr/bin/python3 -B twins.py make MODELS FOLDER                cubes clementine, kaguya, nac and m3 with pixels of 1
    /usr/bin/python3 -B twins.py check MODELS NAME POSITIONS ROWS  largest error, px, of lines of sight to the layer position (m)
    /usr/bin/python3 -B twins.py shift TWIN.npy CUBE FACTOR RIGHT DOWN    pixels: the twin moved by whole pixels times a factor, and noise
    /usr/bin/python3 -B twins.py agree TWIN.npy CUBE               count, correlation, factor, rms of a cube's pixels against the twin

MODELS: the folder of USGS ALE's camera models (CC0). That of M3 stands below.
"""
import json
import pathlib
import struct
import sys

import numpy as np

LABEL_BYTES = 65536

# ALE's chandrayannM3_isd.json: M3T20090630T083407, 5 lines.
M3 = {
    "image_lines": 5, "image_samples": 608, "starting_ephemeris_time": 299622941.60814995,
    "center_ephemeris_time": 299622941.73534995, "line_scan_rate": [[0.5, -0.12720000743865967, 0.05088]],
    "body_rotation": {
        "ephemeris_times": [299622941.60814995, 299622941.86254996],
        "quaternions": [[-0.9747735513065916, 0.19646555501476617, -0.009172349392417702, 0.1055162422212761],
                        [-0.9747735156174205, 0.196465551731104, -0.009172415802241563, 0.10551657226330902]],
        "constant_rotation": [0.9999998732547144, -0.00032928542237557133, 0.00038086961867138755, 0.00032928600021094723,
                              0.9999999457843062, -1.4544409378362713e-06, -0.00038086911909607826, 1.5798557868269087e-06,
                              0.9999999274681067]},
    "instrument_pointing": {
        "ephemeris_times": [299622941.60806996, 299622941.65895, 299622941.70983, 299622941.76071, 299622941.81158996,
                            299622941.86247, 299622941.86547],
        "quaternions": [[-0.07932458945117579, 0.6686267050477891, -0.7382516883292113, 0.04037800743484437],
                        [-0.07931136277253394, 0.6686270378355014, -0.7382536542422642, 0.040362532235106274],
                        [-0.07929816903614584, 0.6686273679739351, -0.7382556180070331, 0.0403470651326279],
                        [-0.07928500836507205, 0.6686276954564626, -0.7382575796169487, 0.04033160615764239],
                        [-0.07927188089774231, 0.6686280202760814, -0.7382595390631518, 0.0403161553584303],
                        [-0.07925878672648098, 0.6686283424269328, -0.7382614963436729, 0.04030071272892822],
                        [-0.07925878672648098, 0.6686283424269328, -0.7382614963436729, 0.04030071272892822]],
        "constant_rotation": [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]},
    "instrument_position": {
        "ephemeris_times": [299622941.60814995, 299622941.65902996, 299622941.70991, 299622941.76078993, 299622941.81166995,
                            299622941.86254996],
        "positions": [[87.43803283072197, 170.58382785758494, 1937.3684802589921],
                      [87.43510506145041, 170.5039141771109, 1937.376298445722],
                      [87.43218518920048, 170.42401232587338, 1937.3841107949745],
                      [87.42927324562292, 170.3441224440555, 1937.3919172883918],
                      [87.42636925235688, 170.26424439143332, 1937.3997179348762],
                      [87.42347324097756, 170.18437830744463, 1937.4075127164092]],
        "velocities": [[-0.05762002410373986, -1.5707459933015884, 0.1537165891795824],
                       [-0.05746510464914588, -1.5705139595332909, 0.1536019506461352],
                       [-0.05730961271290819, -1.5702809919216132, 0.15348712189335625],
                       [-0.05715359501832903, -1.570047160550427, 0.1533721371829534],
                       [-0.0569969401442109, -1.569812298292768, 0.1532569148111189],
                       [-0.056840025211490175, -1.5695769708168128, 0.15314173131318826]]},
    "sun_position": {"ephemeris_times": [299622941.73534995], "positions": [[-22279396.272817865, 138086310.683749, 59901633.861951254]],
                     "velocities": [[-29.247063986944152, -3.0931661850381134, -1.3160268288136903]]},
}

FILES = {"clementine": "clem_uvvis_isd.json", "kaguya": "kaguyatc_isd.json", "nac": "lrolroc_isd.json"}
LINES = {"clementine": 288, "kaguya": 6, "nac": 6, "m3": 5}

# Group Instrument as ISIS's labels of these images have it, as far as cameras need it; %s is the clock's count.
GROUPS = {
    "clementine": "    SpacecraftName = \"CLEMENTINE 1\"\n    InstrumentId = UVVIS\n    StartTime = 1994-03-25T15:14:15.347\n"
                  "    ExposureDuration = 9.0624 <ms>\n",
    "kaguya": "    SpacecraftName = KAGUYA\n    InstrumentId = TC1\n    StartTime = 2009-04-05T20:09:53.607478\n"
              "    SpacecraftClockStartCount = 922997380.174174 <s>\n"
              "    LineSamplingInterval = 6.500000 <ms>\n    SwathModeId = FULL\n",
    "nac": "    SpacecraftName = \"LUNAR RECONNAISSANCE ORBITER\"\n    InstrumentId = NACL\n    FrameId = LEFT\n"
           "    StartTime = 2009-07-30T12:20:38.185\n    SpacecraftClockPrerollCount = 1/270649237:07208\n"
           "    LineExposureDuration = 1.028800 <ms>\n    SpatialSumming = 1\n    SampleFirstPixel = 0\n",
    "m3": "    SpacecraftName = CHANDRAYAAN-1\n    InstrumentId = M3\n    StartTime = 2009-06-30T08:34:35.424411\n"
          "    SpacecraftClockStartCount = 12/1759056.764\n    SpatialSumming = 1\n    LineExposureDuration = 50.88\n",
}


def model_of(models, name):
    return M3 if name == "m3" else json.loads((pathlib.Path(models) / FILES[name]).read_text())


def table(name, columns, rows, extra):
    fields = "".join(f"  Group = Field\n    Name = {column}\n    Type = Double\n    Size = 1\n  End_Group\n" for column in columns)
    data = np.asarray(rows, "<f8").tobytes()
    return (f"Object = Table\n  Name = {name}\n  StartByte = %d\n  Bytes = {len(data)}\n  Records = {len(rows)}\n  ByteOrder = Lsb\n{extra}"
            f"{fields}End_Object\n", data)


def tables_of(model):
    def rotation(name, part):
        rows = [[*q, t] for q, t in zip(part["quaternions"], part["ephemeris_times"])]
        constant = ", ".join(repr(number) for number in part.get("constant_rotation", []))
        return table(name, ["J2000Q0", "J2000Q1", "J2000Q2", "J2000Q3", "ET"], rows,
                     f"  ConstantRotation = ({constant})\n" if constant else "")

    def position(name, part):
        rows = [[*p, *v, t] for p, v, t in zip(part["positions"], part["velocities"], part["ephemeris_times"])]
        kind = "HermiteSpline" if len(rows) > 1 else "Linear"
        return table(name, ["J2000X", "J2000Y", "J2000Z", "J2000XV", "J2000YV", "J2000ZV", "ET"], rows, f"  CacheType = {kind}\n")

    return [rotation("InstrumentPointing", model["instrument_pointing"]), position("InstrumentPosition", model["instrument_position"]),
            rotation("BodyRotation", model["body_rotation"]), position("SunPosition", model["sun_position"])]


# The optics that ISIS takes over from the kernels of these cameras, and that stand in its cubes. Clementine's are those of filter D, NAC's
# and Kaguya's have a lens twice and ten times as strong as the real one, so that another lens than the cube's own is seen.
OPTICS = {
    "clementine": "-40024", "kaguya": "-131351", "nac": "-85600", "m3": "-86520",
}
KEYWORDS = {
    "clementine": "FOCAL_LENGTH = 89.991267|PIXEL_PITCH = 0.023|BORESIGHT_SAMPLE = 192.5|BORESIGHT_LINE = 144.5|"
                  "TRANSX = (0.0, 0.023, 0.0)|TRANSY = (0.0, 0.0, 0.023)|ITRANSS = (0.0, 43.47826087, 0.0)|"
                  "ITRANSL = (0.0, 0.0, 43.47826087)|PP = (0.0, 0.0)|OD_K = (0.0, -2.398624e-05, 0.0)|"
                  "DECENTER = (1.414502e-05, -1.372645e-04)",
    "kaguya": "FOCAL_LENGTH = 72.45|PIXEL_PITCH = 0.007|BORESIGHT_SAMPLE = 2047.5|BORESIGHT_LINE = 0.0|"
              "TRANSX = (0.0, 0.0, -0.007)|TRANSY = (0.0, -0.007, 0.0)|ITRANSS = (0.0, 0.0, -142.857142857)|"
              "ITRANSL = (0.0, -142.857142857, 0.0)|BORESIGHT = (-0.0725, 0.0214, 72.45)|"
              "DISTORTION_COEF_X = (-9.6499e-4, 9.8441e-4, 8.5773e-5, -3.7438e-6)|"
              "DISTORTION_COEF_Y = (-1.3796e-3, 1.3502e-5, 2.7251e-5, -6.1938e-6)",
    "nac": "FOCAL_LENGTH = 699.62|PIXEL_PITCH = 0.007|BORESIGHT_SAMPLE = 2548.0|BORESIGHT_LINE = 0.0|"
           "TRANSX = (0.0, 0.0, 0.0)|TRANSY = (0.0, 0.007, 0.0)|ITRANSS = (0.0, 0.0, 142.857142857)|"
           "ITRANSL = (0.0, -142.857142857, 0.0)|OD_K = 3.62e-05",
    "m3": "FOCAL_LENGTH = 39.63|PIXEL_PITCH = 0.027|BORESIGHT_SAMPLE = 304.5|BORESIGHT_LINE = 0.0|"
          "TRANSX = (-0.64, -0.0000400552916405788, 0.0269999702883839)|"
          "TRANSY = (-0.052, -0.0269999702883839, -0.0000400552916405788)|"
          "ITRANSS = (-1.96108894601637, -0.0549455303711644, -37.036996280362)|"
          "ITRANSL = (23.7008204518524, 37.036996280362, -0.0549455303711644)|PP = (0.0, 0.0)|"
          "OD_K = (0.000379921103637315, 0.000213226448051461, -4.01862878758592E-08)|DECENTER = (0.004047, -0.000005)",
}


def naif_of(name, model):
    """Keywords of the clock and of the optics."""
    clock = ""
    if name == "nac":
        preroll = model["starting_ephemeris_time"] - 1024.0 * 1.0288e-3 * 1.0045
        clock = f"  CLOCK_ET_-85_1/270649237:07208_COMPUTED = {struct.pack('<d', preroll).hex()}\n"
    if name == "m3":
        clock = f"  CLOCK_ET_-86_12/1759056.764_COMPUTED = {struct.pack('<d', model['starting_ephemeris_time']).hex()}\n"
    if name == "kaguya":
        clock = "  CLOCK_ET_-131_922997380.174174_COMPUTED = eeabd213246bb141\n"  # as ISIS's own cube of the image has it
    return clock + "".join(f"  INS{OPTICS[name]}_{keyword}\n" for keyword in KEYWORDS[name].split("|"))


def write_cube(path, name, model, pixels):
    lines, samples = pixels.shape
    parts = tables_of(model)
    start = LABEL_BYTES + pixels.size * 4
    texts = []
    for text, data in parts:
        texts.append(text % (start + 1))
        start += len(data)
    label = (f"Object = IsisCube\n  Object = Core\n    StartByte = {LABEL_BYTES + 1}\n    Format = BandSequential\n    Group = Dimensions\n"
             f"      Samples = {samples}\n      Lines = {lines}\n      Bands = 1\n    End_Group\n    Group = Pixels\n      Type = Real\n"
             "      ByteOrder = Lsb\n      Base = 0.0\n      Multiplier = 1.0\n    End_Group\n  End_Object\n  Group = Instrument\n"
             f"{GROUPS[name]}    TargetName = Moon\n  End_Group\n  Group = Kernels\n"
             f"    NaifFrameCode = {OPTICS[name]}\n  End_Group\nEnd_Object\nObject = Label\n  Bytes = {LABEL_BYTES}\nEnd_Object\n"
             f"{''.join(texts)}Object = NaifKeywords\n{naif_of(name, model)}End_Object\nEnd\n")
    path.write_bytes(label.encode().ljust(LABEL_BYTES, b"\0") + pixels.astype("<f4").tobytes() + b"".join(data for _, data in parts))


def matrix(q):
    w, x, y, z = np.asarray(q) / np.linalg.norm(q)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def between(times, t):
    at = int(np.clip(np.searchsorted(times, t) - 1, 0, max(0, len(times) - 2)))
    return at, 0.0 if len(times) == 1 else (t - times[at]) / (times[at + 1] - times[at])


def rotation_at(part, t):
    at, u = between(part["ephemeris_times"], t)
    q = np.array(part["quaternions"][at])
    if u != 0.0:
        other = np.array(part["quaternions"][at + 1])
        other = -other if q @ other < 0 else other
        half = np.arctan2(np.linalg.norm(other - (q @ other) * q), q @ other)
        if half > 0:
            q = (np.sin((1 - u) * half) * q + np.sin(u * half) * other) / np.sin(half)
    return np.array(part.get("constant_rotation", np.eye(3))).reshape(3, 3) @ matrix(q)


def position_at(part, t):
    times = part["ephemeris_times"]
    at, u = between(times, t)
    if len(times) == 1:
        return np.array(part["positions"][0])
    h = times[at + 1] - times[at]
    p, q = np.array(part["positions"][at]), np.array(part["positions"][at + 1])
    v, w = np.array(part["velocities"][at]), np.array(part["velocities"][at + 1])
    return ((2 * u**3 - 3 * u**2 + 1) * p + (u**3 - 2 * u**2 + u) * h * v + (3 * u**2 - 2 * u**3) * q + (u**3 - u**2) * h * w)


def sight(name, samples):
    """Lines of sight of samples (from 1) in the instrument's frame, mm, by line of the detector; and the px per mm."""
    if name == "clementine":
        lines = np.arange(1, 289)[:, None]
        x = np.broadcast_to((samples - 192.5) * 0.023, (288, len(samples)))
        y = np.broadcast_to((lines - 144.5) * 0.023, x.shape)
        rr = x * x + y * y
        ux = x - 2.398624e-05 * rr * x + 1.414502e-05 * (rr + 2 * x * x) - 2 * 1.372645e-04 * x * y
        uy = y - 2.398624e-05 * rr * y + 2 * 1.414502e-05 * x * y - 1.372645e-04 * (rr + 2 * y * y)
        return np.stack([ux, uy, np.full(x.shape, 89.991267)], axis=-1), 1 / 0.023
    if name == "kaguya":
        r = -(samples - 2048.5) * 0.007
        x = -0.0725 - 9.6499e-4 + 9.8441e-4 * r + 8.5773e-5 * r**2 - 3.7438e-6 * r**3
        y = 0.0214 + r - 1.3796e-3 + 1.3502e-5 * r + 2.7251e-5 * r**2 - 6.1938e-6 * r**3
        return np.stack([x, y, np.full(x.shape, 72.45)], axis=-1)[None], 1 / 0.007
    if name == "nac":
        y = (samples - 2548.0) * 0.007
        return np.stack([0 * y, y / (1 + 3.62e-5 * y * y), np.full(y.shape, 699.62)], axis=-1)[None], 1 / 0.007
    x = -0.64 - 4.00552916405788e-05 * (samples - 304.5)
    y = -0.052 - 0.0269999702883839 * (samples - 304.5)
    rr = x * x + y * y
    dr = 0.000379921103637315 + 0.000213226448051461 * rr - 4.0186287875859195e-08 * rr * rr
    ux = x + x * dr + 0.004047 * (rr + 2 * x * x) + 2 * -5e-06 * x * y
    uy = y + y * dr + 2 * 0.004047 * x * y - 5e-06 * (rr + 2 * y * y)
    return np.stack([ux, uy, np.full(x.shape, 39.63)], axis=-1)[None], 1 / 0.027


def check(models, name, positions, rows):
    model = model_of(models, name)
    points, states = np.load(positions), np.load(rows) if rows != "-" else None
    height, width = points.shape[:2]
    looks, scale = sight(name, np.arange(1.0, width + 1.0))
    focal = looks[0, 0, 2]
    worst = 0.0
    for line in range(height):
        if name == "clementine":
            t = model["center_ephemeris_time"]
        else:
            first, start, period = model["line_scan_rate"][0]
            t = model["center_ephemeris_time"] + start + period * (line + 0.5)
        instrument = rotation_at(model["instrument_pointing"], t)
        body = rotation_at(model["body_rotation"], t)
        camera = 1000.0 * body @ position_at(model["instrument_position"], t)
        seen = (points[line] - camera) @ (instrument @ body.T).T  # in the instrument's frame
        there = np.isfinite(seen[:, 0])
        expected = looks[min(line, len(looks) - 1)]
        error = (seen[there, :2] / seen[there, 2:] * focal - expected[there, :2]) * scale
        worst = max(worst, np.hypot(*error.T).max(initial=0.0))
    print(f"{worst:.6f} {int(np.isfinite(points[..., 0]).sum())} {0 if states is None else len(states)}")


def pixels_of(cube):
    data = pathlib.Path(cube).read_bytes()
    label = data[:LABEL_BYTES].decode("latin-1")
    samples, lines = (int(label.split(f"{key} = ")[1].split()[0]) for key in ("Samples", "Lines"))
    return data, np.frombuffer(data, "<f4", lines * samples, LABEL_BYTES).reshape(lines, samples)


def shift(twin, cube, factor, right, down):
    drawn = np.load(twin).astype(float)
    moved = np.roll(drawn, (int(down), int(right)), (0, 1)) * float(factor)
    moved += np.random.default_rng(3).normal(0.0, 0.01 * moved.mean(), moved.shape)
    moved[5:9, 11:30] = -3.4028226550889045e38  # NULL
    data, _ = pixels_of(cube)
    pathlib.Path(cube).write_bytes(data[:LABEL_BYTES] + moved.astype("<f4").tobytes() + data[LABEL_BYTES + moved.size * 4:])


def agree(twin, cube):
    drawn, (_, real) = np.load(twin).astype(float), pixels_of(cube)
    there = real > -1e30
    real, drawn = real[there].astype(float), drawn[there]
    factor = (real * drawn).sum() / (drawn**2).sum()
    print(there.sum(), repr(float(np.corrcoef(real, drawn)[0, 1])), repr(float(factor)),
          repr(float(np.sqrt(np.mean((real - factor * drawn)**2)) / real.mean())))


def make(models, folder):
    for name in GROUPS:
        model = model_of(models, name)
        width = 4096 if name == "kaguya" else model["image_samples"]
        write_cube(pathlib.Path(folder) / f"{name}.cub", name, model, np.ones((LINES[name], width)))


if __name__ == "__main__":
    {"make": make, "check": check, "shift": shift, "agree": agree}[sys.argv[1]](*sys.argv[2:])

"""States in the habits of other programs, with what they are in MOON_ME: numpy and CSPICE (spice/spiceypy.py).

    states.py habits FOLDER                     batch files of the same five states, and expected.txt
    states.py gmat FOLDER                       ReportFile1.txt as GMAT writes it, and expected.txt
    states.py spice FOLDER START STEP COUNT     expected.txt of the recipe for SPICE: the Earth, axes of MOON_PA

expected.txt has a line a state: MJD, position (m, MOON_ME), and the matrix that turns camera axes into Moon axes, by rows.
"""
import os
import sys
from datetime import datetime

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "spice"))
import numpy as np
import spiceypy as spice

CV_FROM_CAMERA = np.array([[0, 1, 0], [0, 0, -1], [-1, 0, 0]])
EPOCH, MJD_EPOCH = "2010-04-06T20:24:00", 55292.85
DAY = 86400.0


def turn(axis, angle):
    """Rodrigues: the vectors of a matrix's columns, turned about an axis."""
    x, y, z = axis / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def moon_from_j2000(seconds):
    return np.array(spice.pxform("J2000", "MOON_ME", spice.str2et(EPOCH) + seconds))


def text(numbers):
    return [f"{number:.17g}" for number in np.ravel(numbers)]


def write(folder, name, *lines):
    with open(os.path.join(folder, name), "w") as out:
        out.writelines(line + "\n" for line in lines)


def expect(folder, states):
    write(folder, "expected.txt", *(" ".join(text([mjd, *position, *np.ravel(matrix)])) for mjd, position, matrix in states))


def habits(folder):
    random = np.random.default_rng(24)
    states, lines = [], {name: [] for name in ("wxyz", "opencv", "j2000", "still", "thesis", "seconds", "zyx", "313", "rounded")}
    still = moon_from_j2000(0)
    for k in range(5):
        seconds = 12.5 * k
        mjd = MJD_EPOCH + seconds / DAY
        axis, angle = random.normal(size=3), random.uniform(-3, 3)
        matrix = turn(axis, angle)
        quaternion = np.append(axis / np.linalg.norm(axis) * np.sin(angle / 2), np.cos(angle / 2))
        latitude, longitude, height = random.uniform(-1.5, 1.5), random.uniform(0, 6), random.uniform(1e4, 1e6)
        position = (1737400 + height) * np.array([
            np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)])
        states.append((mjd, position, matrix))
        place = [*np.degrees([latitude, longitude])]

        # The same attitude as a quaternion in J2000, from the matrix: no quaternions are multiplied here.
        inertial = moon_from_j2000(seconds).T
        value, vector = np.linalg.eig(inertial @ matrix)
        n = np.real(vector[:, np.argmin(abs(value - 1))])
        s = inertial @ matrix
        sine = np.array([s[2, 1] - s[1, 2], s[0, 2] - s[2, 0], s[1, 0] - s[0, 1]]) @ n
        turned = np.arctan2(sine, np.trace(s) - 1)
        q_inertial = np.append(n * np.sin(turned / 2), np.cos(turned / 2))

        angles = {"zyx": (3, 2, 1), "313": (3, 1, 3)}
        given = {name: random.uniform(-1.4, 1.4, size=3) + [0, 1.5 if name == "313" else 0, 0] for name in angles}
        lines["wxyz"].append([mjd, *position, quaternion[3], *quaternion[:3]])
        lines["opencv"].append([mjd, *position / 1000, *np.ravel(CV_FROM_CAMERA @ matrix.T)])
        lines["j2000"].append([mjd, *(inertial @ position / 1000), q_inertial[3], *q_inertial[:3]])
        lines["still"].append([mjd, *(still @ inertial @ position), *np.ravel(still @ inertial @ matrix)])
        lines["thesis"].append([mjd, *(inertial @ position), *q_inertial])
        lines["seconds"].append([seconds, *place, height / 1000, *np.ravel(matrix)])
        lines["rounded"].append([mjd, *place, height, *np.round(quaternion, 5)])
        for name, axes in angles.items():
            body_from_frame = spice.eul2m(*reversed(given[name]), *reversed(axes))
            lines[name].append([mjd, *position, *np.degrees(given[name]), *np.ravel(np.transpose(body_from_frame))])

    nine = "r11,r12,r13,r21,r22,r23,r31,r32,r33"
    head = {
        "wxyz": ["time,x,y,z,q0,q1,q2,q3"],
        "opencv": ["# msis: axes=opencv rotation=to-camera", "time,x_km,y_km,z_km," + nine],
        "j2000": ["#msis: frame=J2000", "time,x_km,y_km,z_km,qw,qx,qy,qz"],
        "still": [f"# msis: frame=moon-me-epoch epoch={MJD_EPOCH}", "MJD,x,y,z," + nine],
        "seconds": ["# states", f"# msis: epoch={MJD_EPOCH}", "seconds,lat,lon,height_km," + nine],
        "rounded": ["time,lat,lon,alt,qx,qy,qz,qw"],
    }
    for name, first in head.items():
        write(folder, name + ".csv", *first, *(",".join(text(line)) for line in lines[name]))
    write(folder, "thesis.csv", "# msis: frame=j2000", *(" ".join(text(line)) for line in lines["thesis"]))
    for name in ("zyx", "313"):
        write(
            folder, name + ".csv", f"# msis: euler={name.upper()}", "time,x,y,z,euler1,euler2,euler3",
            *(",".join(text(line[:7])) for line in lines[name]))
        write(folder, name + ".txt", *(" ".join(text([*line[:4], *line[7:]])) for line in lines[name]))
    expect(folder, states)


def gmat(folder):
    random = np.random.default_rng(25)
    states, report = [], []
    for k in range(4):
        mjd = MJD_EPOCH + k / 1440
        axis, angle = random.normal(size=3), random.uniform(-3, 3)
        body = turn(axis, angle)  # its columns are the body's axes in the inertial frame
        position = random.normal(size=3)
        position *= 1.9e6 / np.linalg.norm(position)
        report.append([
            mjd - 29999.5, *position / 1000, *(axis / np.linalg.norm(axis) * np.sin(angle / 2)), np.cos(angle / 2)])
        moon = moon_from_j2000(60 * k)
        # The camera of the recipe looks along the body's z, which is its -x; up, its z, is the body's x; its y is the body's.
        states.append((mjd, moon @ position, moon @ np.column_stack([-body[:, 2], body[:, 1], body[:, 0]])))
    names = ["UTCModJulian", *("LunaICRF." + axis for axis in "XYZ"), *(f"Q{i}" for i in (1, 2, 3, 4))]
    write(
        folder, "ReportFile1.txt", "".join(f"{'Orbiter.' + name:<26}" for name in names),
        *("".join(f"{number:<26}" for number in text(line)) for line in report))
    expect(folder, states)


def recipe(folder, start, step, count):
    states = []
    for k in range(int(count)):
        et = spice.str2et(start) + k * float(step)
        position, _ = spice.spkpos("EARTH", et, "MOON_ME", "NONE", "MOON")
        mjd = (datetime.fromisoformat(start) - datetime(1858, 11, 17)).total_seconds() / DAY + k * float(step) / DAY
        states.append((mjd, 1000 * np.array(position), np.array(spice.pxform("MOON_PA", "MOON_ME", et)) @ CV_FROM_CAMERA))
    expect(folder, states)


spice.furnsh(os.environ["MSISF_KERNELS"])
{"habits": habits, "gmat": gmat, "spice": recipe}[sys.argv[1]](*sys.argv[2:])

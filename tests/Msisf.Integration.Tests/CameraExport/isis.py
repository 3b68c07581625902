"""Reads cubes of ISIS from their text and bytes: label (PVL), pixels, tables; and projects as IdealCamera does.

Formulas: IdealCamera.cpp, CameraFocalPlaneMap.cpp, CameraGroundMap.cpp, SpiceRotation.cpp of ISIS.
"""
import re

import numpy as np


def turn(w, x, y, z):
    """The matrix of a quaternion of any length."""
    m = np.array([[w*w + x*x - y*y - z*z, 2*(x*y - w*z), 2*(x*z + w*y)],
                  [2*(x*y + w*z), w*w - x*x + y*y - z*z, 2*(y*z - w*x)],
                  [2*(x*z - w*y), 2*(y*z + w*x), w*w - x*x - y*y + z*z]])
    return m / (w*w + x*x + y*y + z*z)


def value(text):
    if text.startswith("("):
        return [value(part.strip()) for part in text[1:-1].split(",")]
    text = text.split("<")[0].strip()
    return int(text) if re.fullmatch(r"-?\d+", text) else float(text) if re.fullmatch(r"-?\d+\.\d+(E[-+]\d+)?", text) else text


class Cube:
    def __init__(self, path):
        data = open(path, "rb").read()
        head = data[:65536]
        assert head.rstrip(b"\0").endswith(b"End\n") and head.isascii()
        stack = [{"Table": {}}]
        for line in head.rstrip(b"\0").decode().splitlines():
            words = line.strip()
            if words.startswith(("Object = ", "Group = ")):
                stack.append({"": words.split(" = ")[1], "Fields": []})
            elif words in ("End_Object", "End_Group"):
                part = stack.pop()
                if part[""] == "Table":
                    stack[-1]["Table"][part["Name"]] = part
                elif part[""] == "Field":
                    stack[-1]["Fields"].append(part)
                else:
                    stack[-1][part[""]] = part
            elif " = " in words:
                name, text = words.split(" = ", 1)
                stack[-1][name.strip()] = value(text.strip())
        label, = stack
        self.label, core = label, label["IsisCube"]["Core"]
        size = core["Dimensions"]
        assert (core["StartByte"], core["Format"], size["Bands"], label["Label"]["Bytes"]) == (65537, "BandSequential", 1, 65536)
        assert (core["Pixels"]["Type"], core["Pixels"]["ByteOrder"]) == ("Real", "Lsb")
        shape = size["Lines"], size["Samples"]
        raw = np.frombuffer(data, "<f4", shape[0] * shape[1], 65536).reshape(shape)
        # Above NULL and the other special pixels of real numbers.
        valid = raw > np.array([0xFF7FFFFA], "<u4").view("<f4")[0]
        self.image = np.where(valid, core["Pixels"]["Base"] + core["Pixels"]["Multiplier"] * raw, np.nan)
        self.tables, end = {}, 65536 + raw.nbytes
        for name, table in label["Table"].items():
            assert (table["StartByte"], table["ByteOrder"]) == (end + 1, "Lsb")
            assert all((field["Type"], field["Size"]) == ("Double", 1) for field in table["Fields"])
            columns = [field["Name"] for field in table["Fields"]]
            assert table["Bytes"] == 8 * len(columns) * table["Records"]
            rows = np.frombuffer(data, "<f8", table["Records"] * len(columns), end).reshape(-1, len(columns))
            self.tables[name] = dict(zip(columns, rows.T))
            end += table["Bytes"]
        assert end == len(data)

    def column(self, table, *names):
        return np.stack([self.tables[table][name] for name in names], axis=-1)

    def rotation(self, table, record=0):
        return turn(*self.column(table, "J2000Q0", "J2000Q1", "J2000Q2", "J2000Q3")[record])

    def records(self, lines):
        """Of a scan, the record of each line, which must be at its time: LineScanCameraDetectorMap.cpp."""
        inst = self.label["IsisCube"]["Instrument"]
        times = inst["EphemerisTime"] + inst["ExposureDuration"] / 1000.0 * (lines - 0.5)
        for table in ("InstrumentPosition", "InstrumentPointing", "BodyRotation"):
            assert np.abs(self.tables[table]["ET"][lines - 1] - times).max() < 2e-7
        return lines - 1

    def pixels(self, points, lines=None):
        """Samples and lines, the first at 1, of points (m, body-fixed); of a scan in the lines that are given."""
        naif, inst = self.label["NaifKeywords"], self.label["IsisCube"]["Instrument"]
        is_scan = inst["InstrumentType"] == "Linescan"
        record = self.records(lines) if is_scan else np.zeros(len(points), int)
        body = np.stack([self.rotation("BodyRotation", i) for i in range(record.max() + 1)])[record]
        sensor = np.stack([self.rotation("InstrumentPointing", i) for i in range(record.max() + 1)])[record]
        inertial = np.einsum("nj,njk->nk", points / 1000.0, body)
        away = inertial - self.column("InstrumentPosition", "J2000X", "J2000Y", "J2000Z")[record]
        x, y, z = np.einsum("njk,nk->jn", sensor, away)
        dx, dy = naif["IDEAL_FOCAL_LENGTH"] * x / z, naif["IDEAL_FOCAL_LENGTH"] * y / z
        s, l = naif["IDEAL_TRANSS"], naif["IDEAL_TRANSL"]
        forward, back = np.array([s[1:], l[1:]]), np.array([naif["IDEAL_TRANSX"][1:], naif["IDEAL_TRANSY"][1:]])
        assert np.abs(forward @ back - np.eye(2)).max() < 1e-14
        assert np.abs(forward @ [naif["IDEAL_TRANSX"][0], naif["IDEAL_TRANSY"][0]] + [s[0], l[0]]).max() < 1e-12
        return (s[0] + s[1]*dx + s[2]*dy + inst["SampleDetectors"] / 2 + 0.5,
                l[0] + l[1]*dx + l[2]*dy + (lines if is_scan else inst["LineDetectors"] / 2 + 0.5))

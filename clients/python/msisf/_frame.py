"""A drawn frame with its truth."""

from __future__ import annotations

import io
import json
import os
import warnings as python_warnings
from functools import cached_property
from os import PathLike
from pathlib import Path
from typing import Any, Dict, Mapping, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

import msisf  # for type hints alone: msisf.Moon imports this module

from ._errors import MsisfError, NoSuchAttribute, answers_of
from ._http import Part
from ._png import png_of
from ._view import View


class Frame(View):
    """An image with its camera, its light and its layers.

    A layer is also an attribute: ``frame.depth``; "-" is "_", and "normals" is the layer "normal". ``frame.position`` is the camera's
    position; the layer of that name is ``frame.layers["position"]`` or ``frame.positions``.

    Attributes:
        image: Grey levels [height, width], uint8 or uint16; the digital numbers of a camera with a detector.
        layers: Arrays by their names ("depth", "normal", ...), [height, width] or [height, width, planes].
        quaternion: Of the camera, (qx, qy, qz, q0): turns camera axes (looks along -x, y right, z up) into MOON_ME.
        sun_position: [3], m.
        sun_direction: [3], length 1, from the camera to the Sun, MOON_ME.
        mjd: Time, days, UTC.
        utc: Time, ISO 8601.
        meta: The meta file; read when it is first asked for, as are craters and landmarks.
        warnings: What the server finds strange about the request.
        camera_models: With ``camera_model="csm,tsai"`` the texts of the files that msis writes so, by their endings: "csm.json", "tsai".
        craters: With ``craters="NAME"`` a record array of the craters in the image: id, name, latitude, longitude, diameter, h, v,
            semiMajor, semiMinor, turn (degrees), inside, hidden, lit, incidence, emission; NaN where a number is not defined.
        landmarks: With ``landmarks="NAME"`` a record array of the landmarks: id, name, x, y, z, h, v, visible, lit, range, pixelScale, and
            the partial derivatives hByShift, hByTurn, hByPoint and those of v, [3] each.
        stars: With ``stars=True`` or a catalogue's name a record array of the stars: id, h, v (px, from 1), magnitude (V), colour (B - V),
            electrons, visible, hiddenBy, rightAscension and declination (degrees, J2000), start and end of the streak, [2] each, and the
            partial derivatives hByTurn and vByTurn, [3] each; NaN where there is no number.
        bodies: With ``sky=True``, ``planets=True``, ``earth=True`` or ``sun_in_view=True`` a record array of the bodies that the image
            shows: name, h, v, radius (px), angularRadius and phase (degrees), distance (m), magnitude, electrons, visible (0 to 1).
    """

    def __init__(
        self,
        moon: msisf.Moon,
        request: Mapping[str, Any],
        image: Part,
        layers: Mapping[str, NDArray[Any]],
        meta: str,
        warnings: Sequence[str],
    ) -> None:
        self._meta = meta
        general = _member_of(meta, "GeneralInformation")
        camera = general["Camera"]
        matrices = (
            np.array(camera["K"]["value"], dtype=float).reshape(3, 3),
            np.array(camera["R"], dtype=float).reshape(3, 3),
            np.array(camera["t"]["value"], dtype=float),
        )
        super().__init__(moon, request, _vector(general["CameraPosition"]), matrices, camera.get("Distortion"))
        self._levels = _levels_of(image)
        self._meaning = (int(image.headers["x-msisf-bits"]), image.headers["x-msisf-transfer"])
        self.layers: Dict[str, NDArray[Any]] = dict(layers)
        self.warnings = list(warnings)
        self.camera_models: Dict[str, str] = {}
        quaternion = general["CameraOrientation"]["Quaternion"]
        self.quaternion: NDArray[np.float64] = np.array([quaternion[name] for name in ("x", "y", "z", "r")], dtype=float)
        self.sun_position = _vector(general["SunPosition"])
        away = self.sun_position - self._position
        length = float(np.linalg.norm(away))
        self.sun_direction = away / length if length > 0.0 else away
        self.mjd = float(general["SimulationTime"]["MJD"])
        self.utc = str(general["SimulationTime"]["UTC"])

    @classmethod
    def of_parts(cls, moon: msisf.Moon, request: Mapping[str, Any], parts: Mapping[str, Part], warnings: Sequence[str]) -> Frame:
        """The frame of an answer of several parts."""
        arrays = {name[:-4]: np.load(io.BytesIO(part.content)) for name, part in parts.items() if name.endswith(".npy")}
        frame = cls(moon, request, parts["image.raw"], arrays, str(parts["json"].content, "utf-8"), warnings)
        frame.camera_models = {
            name: str(part.content, "utf-8") for name, part in parts.items() if part.headers["content-type"] == "text/plain"
        }
        return frame

    def ask_alone(self) -> None:
        """Lets questions to the Moon name the camera where it is, in place of the body that carries it and others."""
        self._is_scan_of_several = '"Scan":{' in self._meta
        options = {name: value for name, value in self._request.items() if name not in _OF_BODY}
        self._request = {**options, "fixed-state": [self.mjd, *self._position.tolist(), *self.quaternion.tolist()]}

    @property
    def position(self) -> NDArray[np.float64]:
        """Of the camera, [3], m; a warning says so if there is also a layer of this name."""
        if "position" in self.layers:
            python_warnings.warn(
                "frame.position is the camera's position; the layer is frame.positions, or frame.layers['position']", stacklevel=2)  # fmt: skip
        return self._position

    def _size(self) -> Tuple[int, int]:
        return self._levels.shape[1], self._levels.shape[0]

    @cached_property
    def image(self) -> NDArray[Any]:
        return self._levels.copy()

    @cached_property
    def meta(self) -> Dict[str, Any]:
        with answers_of("the meta file"):
            meta: Dict[str, Any] = json.loads(self._meta)
            return meta

    @cached_property
    def craters(self) -> NDArray[Any]:
        return _records(self.meta, "CraterInformation", "Crater", _CRATER)

    @cached_property
    def landmarks(self) -> NDArray[Any]:
        return _records(self.meta, "LandmarkInformation", "Landmark", _LANDMARK)

    @cached_property
    def stars(self) -> NDArray[Any]:
        return _records(self.meta, "StarInformation", "Star", _STAR)

    @cached_property
    def bodies(self) -> NDArray[Any]:
        return _records(self.meta, "SkyBodyInformation", "SkyBody", _BODY)

    def save(self, path: Union[str, PathLike[str]]) -> None:
        """Writes the image as the PNG file that msis writes, byte for byte, whatever was done to ``image`` since.

        Args:
            path: Ends in ".png".
        """
        if Path(path).suffix.lower() != ".png":
            raise MsisfError(f"{os.fspath(path)}: save() writes PNG; give a name that ends in .png")
        Path(path).write_bytes(self._repr_png_())

    def _repr_png_(self) -> bytes:
        """For Jupyter, which shows the image."""
        return png_of(self._levels, *self._meaning)

    def __repr__(self) -> str:
        height, width = self._levels.shape
        layers = f", layers {', '.join(self.layers)}" if self.layers else ""
        return f"{super().__repr__()[:-1]} at {self.utc}: {width} x {height} px, {self._levels.dtype}{layers}>"

    def __getattr__(self, name: str) -> NDArray[Any]:
        layers = self.__dict__.get("layers", {})
        dashed = name.replace("_", "-")
        for known in (dashed, dashed[:-1]):
            if known in layers:
                array: NDArray[Any] = layers[known]
                return array
        raise NoSuchAttribute(f"the frame has no '{name}'; layers are asked for by render(layers=[...])")


#: Options of a request that say where a body is, and how a camera is mounted on it.
_OF_BODY = frozenset(
    ("fixed-state position states trajectory trajectory-positions trajectory-attitudes orbit-frame time epoch kepler-set state-vectors "
     "attitude attitude-frame attitude-transition look-at off-nadir up roll normalize motion jitter name quaternion offset").split())  # fmt: skip

_NUMBERS = ("latitude", "longitude", "diameter", "minorDiameter", "angle", "height", "h", "v", "semiMajor", "semiMinor", "turn", "inside",
            "hidden", "lit", "incidence", "emission", "residual")  # fmt: skip
_CRATER = [("number", int), ("id", object), ("name", object), *((name, float) for name in _NUMBERS)]
_PLACES = ("latitude", "longitude", "height", "x", "y", "z", "h", "v")
_DERIVATIVES = ("hByShift", "hByTurn", "hByPoint", "vByShift", "vByTurn", "vByPoint")
_LANDMARK = [("number", int), ("id", object), ("name", object), *((name, float) for name in _PLACES), ("visible", bool), ("lit", bool),
             ("incidence", float), ("range", float), ("pixelScale", float), *((name, float, 3) for name in _DERIVATIVES)]  # fmt: skip
_STAR = [("id", object), *((name, float) for name in ("h", "v", "magnitude", "colour", "electrons")), ("visible", bool),
         ("hiddenBy", object), ("rightAscension", float), ("declination", float), ("start", float, 2), ("end", float, 2),
         ("hByTurn", float, 3), ("vByTurn", float, 3)]  # fmt: skip
_BODIES = ("h", "v", "radius", "angularRadius", "distance", "phase", "magnitude", "electrons", "visible")
_BODY = [("name", object), *((name, float) for name in _BODIES)]


def _records(meta: Mapping[str, Any], group: str, element: str, fields: Sequence[Any]) -> NDArray[Any]:
    """The elements of a group of the meta file as a record array; empty without the group."""
    elements = meta.get(group, {}).get(element, [])
    records = np.zeros(len(elements), dtype=fields)
    for name, kind, *size in fields if elements else ():
        missing = np.full(size, np.nan) if kind is float else None
        values = [each.get(name, missing) for each in elements]
        records[name] = [value == "yes" for value in values] if kind is bool else values
    return records.view(np.recarray)


def _member_of(text: str, name: str) -> Any:
    """The first member of an object in JSON: most of a meta file's time is that of its pixels, which few ask for."""
    head = '{"' + name + '":'
    return json.JSONDecoder().raw_decode(text, len(head))[0] if text.startswith(head) else json.loads(text)[name]


def _levels_of(image: Part) -> NDArray[Any]:
    kind = {"u8": "u1", "u16": "<u2"}[image.headers["x-msisf-type"]]
    shape = int(image.headers["x-msisf-height"]), int(image.headers["x-msisf-width"])
    is_alone = 2 * len(image.content) > len(image.content.obj)  # else a copy: it would keep all layers of the answer
    return np.frombuffer(image.content if is_alone else bytes(image.content), kind).reshape(shape)


def _vector(element: Mapping[str, Any]) -> NDArray[np.float64]:
    vector = element["Vector3D"]
    return np.array([vector["x"], vector["y"], vector["z"]], dtype=float)

"""A drawn frame with its truth."""

from __future__ import annotations

from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from ._png import png_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ._moon import Moon


@dataclass(frozen=True)
class SurfacePoint:
    """What a point of an image shows; angles in degrees, lengths in m, MOON_ME (mean Earth/polar axis).

    Attributes:
        latitude: Degrees.
        longitude: Degrees, east, 0 to 360.
        height: m over the sphere of 1 737 400 m.
        position: m, from the Moon's centre.
        distance: m from the camera.
        incidence: Degrees from the normal of the facet to the Sun.
        emission: Degrees from the normal to the camera.
        phase: Degrees from the Sun to the camera.
        illumination_direction: Degrees in the image, counter-clockwise from straight down: where the Sun lies; None where undefined.
        lit: "lit", "penumbra", "shadow" or "night".
        lit_fraction: Part of the Sun that is seen from there, 0 to 1.
        pixel_scale: m, width of a pixel across the line of sight.
        slope: Degrees between the normal and the radius.
        facet: Line, sample and half of the facet.
        invented: Whether the ground is invented (``refine``), below the resolution of the elevation model.
    """

    latitude: float
    longitude: float
    height: float
    position: "NDArray[np.float64]"
    distance: float
    incidence: float
    emission: float
    phase: float
    illumination_direction: Optional[float]
    lit: str
    lit_fraction: float
    pixel_scale: float
    slope: float
    facet: Tuple[int, int, int]
    invented: bool = False

    @staticmethod
    def _of(json: Mapping[str, Any]) -> "SurfacePoint":
        facet = json["facet"]
        values = {**json, "position": np.array(json["position"]), "facet": (facet["line"], facet["sample"], facet["half"])}
        return SurfacePoint(**values, invented=facet.get("invented", False))


class View:
    """A camera over the Moon, without an image.

    The camera is that of OpenCV: a point p (m, MOON_ME) is seen at K (R p + t), pixels from (0, 0) for the middle of the first pixel,
    x right, y down. ``project``, ``locate`` and ``visible`` use these pixels too.

    Attributes:
        K: [3, 3], px.
        R: [3, 3], from MOON_ME to camera axes.
        t: [3], m.
    """

    def __init__(
        self, moon: "Moon", request: Mapping[str, Any], K: "NDArray[np.float64]", R: "NDArray[np.float64]", t: "NDArray[np.float64]"
    ) -> None:
        self._moon = moon
        self._request = dict(request)
        self.K, self.R, self.t = K, R, t

    def project(self, points: "ArrayLike") -> "NDArray[np.float64]":
        """Where points are seen, without regard to what hides them.

        Args:
            points: [n, 3] or [3], m, MOON_ME.

        Returns:
            Pixels, [n, 2] or [2], from (0, 0); NaN for points behind the camera. A lens's distortion is left out: ``visible`` has it.
        """
        given = np.asarray(points, dtype=float)
        ahead = np.atleast_2d(given) @ self.R.T + self.t
        with np.errstate(divide="ignore", invalid="ignore"):
            pixels = (ahead @ self.K.T)[:, :2] / ahead[:, 2:3]
        pixels[ahead[:, 2] <= 0.0] = np.nan
        return pixels[0] if given.ndim == 1 else pixels

    def locate(self, pixels: "ArrayLike") -> List[Optional[SurfacePoint]]:
        """What points of the image show, exactly.

        Args:
            pixels: [n, 2], from (0, 0); need not be whole.

        Returns:
            A point for each, None where the image does not show the Moon.
        """
        ours = (np.atleast_2d(np.asarray(pixels, dtype=float)) + 1.0).tolist()
        json = self._moon._post("/v1/pixels", {"frame": self._request, "pixels": ours})
        return [None if point is None else SurfacePoint._of(point) for point in json["points"]]

    def visible(self, places: "ArrayLike") -> List[Mapping[str, Any]]:
        """Where places are seen, and what hides them.

        Args:
            places: [n, 2] of latitude, longitude (degrees) for places on the surface, or [n, 3] with the height (m over the sphere).

        Returns:
            For each "x" and "y" (pixels from (0, 0), None behind the camera), "visible", "hidden_by" ("limb", "terrain",
            "outside the image" or None) and "lit".
        """
        given = np.atleast_2d(np.asarray(places, dtype=float)).tolist()
        json = self._moon._post("/v1/points", {"frame": self._request, "points": given})
        return [
            {**pixel, "x": None if pixel["x"] is None else pixel["x"] - 1.0, "y": None if pixel["y"] is None else pixel["y"] - 1.0}
            for pixel in json["pixels"]
        ]


class Frame(View):
    """An image with its camera, its light and its layers.

    A layer is also an attribute: ``frame.depth``; "-" is "_", and "normals" is the layer "normal".

    Attributes:
        image: Grey levels [height, width], uint8 or uint16.
        layers: Arrays by their names ("depth", "normal", ...), [height, width] or [height, width, planes].
        position: Of the camera, [3], m.
        quaternion: Of the camera, (qx, qy, qz, q0): turns camera axes (looks along -x, y right, z up) into MOON_ME.
        sun_position: [3], m.
        sun_direction: [3], length 1, from the camera to the Sun, MOON_ME.
        mjd: Time, days, UTC.
        utc: Time, ISO 8601.
        meta: The meta file.
        warnings: What the server finds strange about the request.
    """

    def __init__(
        self,
        moon: "Moon",
        request: Mapping[str, Any],
        image: "NDArray[Any]",
        layers: Mapping[str, "NDArray[Any]"],
        meta: Mapping[str, Any],
        warnings: Sequence[str],
    ) -> None:
        general = meta["GeneralInformation"]
        camera = general["Camera"]
        super().__init__(
            moon,
            request,
            np.array(camera["K"]["value"], dtype=float).reshape(3, 3),
            np.array(camera["R"], dtype=float).reshape(3, 3),
            np.array(camera["t"]["value"], dtype=float),
        )
        self.image = image
        self.layers: Dict[str, "NDArray[Any]"] = dict(layers)
        self.meta = meta
        self.warnings = list(warnings)
        self.distortion: Optional[Mapping[str, Any]] = camera.get("Distortion")
        self.position = _vector(general["CameraPosition"])
        quaternion = general["CameraOrientation"]["Quaternion"]
        self.quaternion: "NDArray[np.float64]" = np.array([quaternion[name] for name in ("x", "y", "z", "r")], dtype=float)
        self.sun_position = _vector(general["SunPosition"])
        away = self.sun_position - self.position
        length = float(np.linalg.norm(away))
        self.sun_direction = away / length if length > 0.0 else away
        self.mjd = float(general["SimulationTime"]["MJD"])
        self.utc = str(general["SimulationTime"]["UTC"])

    def save(self, path: "Union[str, PathLike[str]]") -> None:
        """Writes the image as a PNG file."""
        Path(path).write_bytes(png_of(self.image))

    def __getattr__(self, name: str) -> "NDArray[Any]":
        layers = self.__dict__.get("layers", {})
        dashed = name.replace("_", "-")
        for known in (dashed, dashed[:-1]):
            if known in layers:
                array: "NDArray[Any]" = layers[known]
                return array
        raise AttributeError(f"the frame has no '{name}'; layers are asked for by render(layers=[...])")


def _vector(element: Mapping[str, Any]) -> "NDArray[np.float64]":
    vector = element["Vector3D"]
    return np.array([vector["x"], vector["y"], vector["z"]], dtype=float)

"""A camera over the Moon, and what the Moon answers about it."""

from __future__ import annotations

import copy
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Mapping, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

import msisf  # for type hints alone: msisf.Moon imports this module

from ._errors import MsisfError, answers_of
from ._lens import measured_of
from ._values import array_of, rows


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
        shaded_at: m, in shadow: to the ground that stands before the Sun's centre; 0 where the slope faces away from it. None elsewhere.
    """

    latitude: float
    longitude: float
    height: float
    position: NDArray[np.float64]
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
    shaded_at: Optional[float] = None

    @staticmethod
    def _of(json: Mapping[str, Any]) -> SurfacePoint:
        facet = json["facet"]
        values = {**json, "position": np.array(json["position"]), "facet": (facet["line"], facet["sample"], facet["half"])}
        return SurfacePoint(**values, invented=facet.get("invented", False))


class View:
    """A camera over the Moon, without an image.

    The camera is that of OpenCV: a point p (m, MOON_ME) is seen at K (R p + t), pixels from (0, 0) for the middle of the first pixel,
    x right, y down; the lens comes before K. ``project``, ``locate`` and ``visible`` use these pixels too.

    A copy asks the same Moon. A pickle has none: set ``moon`` where it is read, to ask again.

    Attributes:
        moon: Answers ``locate`` and ``visible``; None after a pickle.
        K: [3, 3], px.
        R: [3, 3], from MOON_ME to camera axes.
        t: [3], m.
        distortion: Model and coefficients of the lens (docs/cameras.md); None for a pinhole.
    """

    def __init__(
        self,
        moon: msisf.Moon,
        request: Mapping[str, Any],
        position: NDArray[np.float64],
        matrices: Tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]],
        distortion: Optional[Mapping[str, Any]] = None,
    ) -> None:
        self.moon: Optional[msisf.Moon] = moon
        self._request = dict(request)
        self._is_scan_of_several = False
        self._position = position
        self.K, self.R, self.t = matrices
        self.distortion = distortion

    @property
    def position(self) -> NDArray[np.float64]:
        """Of the camera, [3], m."""
        return self._position

    def project(self, points: ArrayLike) -> NDArray[np.float64]:
        """Where points are seen, without regard to what hides them.

        Args:
            points: [n, 3] or [3], m, MOON_ME.

        Returns:
            Pixels, [n, 2] or [2], from (0, 0); NaN for points behind the camera, and for those so far off that the lens does not show them.
        """
        ahead = (rows(points, "points", 3) - self._position) @ self.R.T  # t would cost digits close to the ground
        with np.errstate(all="ignore"):
            right, down = ahead[:, 0] / ahead[:, 2], ahead[:, 1] / ahead[:, 2]
            if self.distortion is not None:
                coefficients = np.atleast_1d(self.distortion["value"]).tolist()
                right, down = measured_of(self.distortion["model"], coefficients, right, down)
            pixels = np.column_stack((right, down)) @ self.K[:2, :2].T + self.K[:2, 2]
        pixels[~(ahead[:, 2] > 0.0)] = np.nan
        return pixels[0] if array_of(points, "points").ndim == 1 and len(pixels) else pixels

    def locate(self, pixels: ArrayLike) -> List[Optional[SurfacePoint]]:
        """What points of the image show, exactly.

        Args:
            pixels: [n, 2] or [2], from (0, 0); need not be whole.

        Returns:
            A point for each, None where the image does not show the Moon.
        """
        given = rows(pixels, "pixels", 2)
        size = self._size()
        outside = given[~((given > -0.5) & (given < np.subtract(size, 0.5))).all(axis=1)] if size else []
        if len(outside):
            raise MsisfError(
                f"the pixel ({outside[0][0]:g}, {outside[0][1]:g}) lies outside the image of {size[0]} x {size[1]} px, "
                f"whose pixels are (0, 0) to ({size[0] - 1}, {size[1] - 1})"
            )
        ours = (given + 1.0).tolist()
        return self._ask("pixels", "points", ours, lambda point: None if point is None else SurfacePoint._of(point))

    def visible(self, places: ArrayLike) -> List[Dict[str, Any]]:
        """Where places are seen, and what hides them.

        Args:
            places: [n, 2] of latitude, longitude (degrees) for places on the surface, or [n, 3] with the height (m over the sphere).

        Returns:
            For each "x" and "y" (pixels from (0, 0), None behind the camera), "visible", "hidden_by" ("limb", "terrain",
            "outside the image" or None) and "lit".
        """
        given = rows(places, "places", 2, 3).tolist()
        return self._ask("points", "pixels", given, lambda pixel: {**pixel, "x": _from_zero(pixel["x"]), "y": _from_zero(pixel["y"])})

    def _size(self) -> Optional[Tuple[int, int]]:
        """Width and height, px; None if the request does not tell it."""
        width, height = self._request.get("width"), self._request.get("height")
        return None if width is None or height is None else (int(width), int(height))

    def _ask(self, path: str, answers: str, given: List[List[float]], read: Callable[[Any], Any]) -> List[Any]:
        if self.moon is None:
            raise MsisfError("this came out of a pickle and has no server to ask: set its attribute 'moon' to an msisf.Moon")
        if self._is_scan_of_several:
            raise MsisfError("the points of a scan can't be asked where it was drawn with other cameras; render it alone")
        if not given:
            return []
        json = self.moon._post(f"/v1/{path}", {"frame": self._request, path: given})
        with answers_of(self.moon.address):
            if len(json[answers]) != len(given):
                raise ValueError(f"{len(json[answers])} answers to {len(given)} questions")
            return [read(answer) for answer in json[answers]]

    def __getstate__(self) -> Dict[str, Any]:
        return {**self.__dict__, "moon": None}

    def __setstate__(self, state: Mapping[str, Any]) -> None:
        self.__dict__.update(state)

    def __copy__(self) -> View:
        return self._of(self.__dict__)

    def __deepcopy__(self, memo: Dict[int, Any]) -> View:
        memo[id(self.moon)] = self.moon  # a connection is shared
        return self._of(copy.deepcopy(self.__dict__, memo))

    def _of(self, state: Mapping[str, Any]) -> View:
        other = object.__new__(type(self))
        other.__setstate__(state)
        return other

    def __repr__(self) -> str:
        x, y, z = self._position
        return f"<msisf.{type(self).__name__} from ({x:.1f}, {y:.1f}, {z:.1f}) m>"


def _from_zero(pixel: Optional[float]) -> Optional[float]:
    return None if pixel is None else pixel - 1.0

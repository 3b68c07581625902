"""The camera of images."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, Mapping, Union

from ._values import named, plain


@dataclass(frozen=True)
class Camera:
    """A pinhole camera without distortion, as --width, --height and --fov describe it.

    Attributes:
        width: Pixels.
        height: Pixels.
        fov: Horizontal field of view, degrees.
    """

    width: int = 1024
    height: int = 1024
    fov: float = 40.0


#: A Camera, the name of a preset (``Moon.models()["cameras"]``), or a mapping with the keys of a camera file (docs/cameras.md).
AnyCamera = Union[Camera, str, Mapping[str, Any]]


def options_of(camera: AnyCamera) -> Dict[str, Any]:
    """The options of a request that describe a camera."""
    if isinstance(camera, Camera):
        return named({"width": camera.width, "height": camera.height, "fov": camera.fov})
    return {"camera": plain(camera, "camera")}

"""The camera of images."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Dict, Mapping, Optional, Sequence, Union

from ._values import named, numbers, plain


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


@dataclass(frozen=True)
class Mounted:
    """A camera of a rig: how it sits on the body whose states are sent (docs/cameras.md).

    Attributes:
        camera: A Camera, the name of a preset, or a mapping with the keys of a camera file.
        quaternion_xyz0: Body from camera (qx, qy, qz, q0).
        offset: m: the camera's focal point in the body's axes (-x ahead, y right, z up).
        name: Its name.
        options: Further options of this camera's images, as ``lines``.
    """

    camera: Union[Camera, str, Mapping[str, Any]]
    quaternion_xyz0: Sequence[float] = (0.0, 0.0, 0.0, 1.0)
    offset: Sequence[float] = (0.0, 0.0, 0.0)
    name: Optional[str] = None
    options: Mapping[str, Any] = field(default_factory=dict)


#: A Camera, the name of a preset (``Moon.models()["cameras"]``), or a mapping with the keys of a camera file (docs/cameras.md).
AnyCamera = Union[Camera, str, Mapping[str, Any]]


def options_of(camera: Union[AnyCamera, Mounted]) -> Dict[str, Any]:
    """The options of a request that describe a camera."""
    if isinstance(camera, Mounted):
        mounting = {"quaternion": numbers(camera.quaternion_xyz0, "quaternion_xyz0", 4), "offset": numbers(camera.offset, "offset", 3)}
        name = {} if camera.name is None else {"name": str(camera.name)}
        return {**options_of(camera.camera), **named(camera.options), **mounting, **name}
    if isinstance(camera, Camera):
        return named({"width": camera.width, "height": camera.height, "fov": camera.fov})
    return {"camera": plain(camera, "camera")}

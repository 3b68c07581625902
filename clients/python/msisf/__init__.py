"""Exact synthetic images of the Moon, drawn by the server of MSISF (``msis serve``)."""

from ._camera import Camera
from ._errors import MsisfError, RequestError, ServerError
from ._frame import Frame, SurfacePoint, View
from ._moon import Moon
from ._stream import Stream

__all__ = ["Camera", "Frame", "Moon", "MsisfError", "RequestError", "ServerError", "Stream", "SurfacePoint", "View"]
__version__ = "2.0.0"

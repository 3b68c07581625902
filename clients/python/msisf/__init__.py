"""Exact synthetic images of the Moon, drawn by the server of MSISF (``msis serve``)."""

from ._camera import Camera, Mounted
from ._dataset import Dataset, Sample
from ._errors import MsisfError, RequestError, ServerError
from ._frame import Frame
from ._illumination import illumination
from ._moon import Moon
from ._stream import Stream, StreamImage
from ._view import SurfacePoint, View

__all__ = ["Camera", "Dataset", "Frame", "Moon", "Mounted", "MsisfError", "RequestError", "Sample", "ServerError", "Stream", "StreamImage",
           "SurfacePoint", "View", "illumination"]  # fmt: skip
__version__ = "2.0.0"

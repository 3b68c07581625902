"""The Moon: draws images by a server."""

from __future__ import annotations

import json
import os
import ssl
import threading
from types import TracebackType
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Type, Union
from urllib.parse import urlencode

import numpy as np
from numpy.typing import ArrayLike

from ._camera import AnyCamera, Camera, Mounted, options_of
from ._errors import MsisfError
from ._frame import Frame
from ._http import Http, Part, parts_of
from ._process import ServerProcess
from ._stream import Stream
from ._values import Time, array_of, listed, named, numbers, plain, rows, time_text
from ._view import View


class Moon:
    """The Moon, drawn by a server. A server is started if none is given, and ended by ``close`` or at the end of ``with``.

    Safe for several threads, each of which has a connection of its own.

    Args:
        address: Of a running server, e.g. "http://127.0.0.1:8810" or the path of its Unix socket; None to start one.
        token: Of the server's --token-file.
        model: Elevation model, a name of ``models()``; a list of names draws them as one surface; None for the first.
        camera: For images that name none.
        program: Path of msis, to start it; None to look for it.
        serve: Options of msis serve, e.g. ["--ldem", "models"].
        timeout: Seconds without a byte of an answer after which it is given up; the next request has a new connection.
        context: Of TLS, for certificates of your own.
        options: Further options of all images under the names of the command line, "-" as "_": ``samples=4``, ``reflectance="hapke"``.
    """

    def __init__(
        self,
        address: Union[str, os.PathLike[str], None] = None,
        *,
        token: Optional[str] = None,
        model: Union[str, Sequence[str], None] = None,
        camera: AnyCamera = Camera(),
        program: Optional[str] = None,
        serve: Sequence[str] = (),
        timeout: float = 120.0,
        context: Optional[ssl.SSLContext] = None,
        **options: Any,
    ) -> None:
        self._camera = camera
        self._options = named(options)
        if model is not None:
            self._options["model"] = plain(model, "model")
        (seconds,) = numbers(timeout, "timeout", 1)
        if seconds <= 0.0:
            raise MsisfError(f"timeout is {seconds}; seconds above 0 are needed")
        self._local = threading.local()
        self._process = ServerProcess(program, [str(word) for word in listed(serve, "serve")]) if address is None else None
        if self._process is None:
            self._http = Http(os.fspath(address or ""), token, seconds, context)
        else:
            self._http = Http(self._process.address, token, seconds, context, self._process.fate)

    @property
    def address(self) -> str:
        """Where the server is."""
        return self._http.address

    @property
    def last_times(self) -> Dict[str, float]:
        """ms that the server took for the last image of ``render`` in this thread: "wait", "draw" and "write"."""
        times: Dict[str, float] = getattr(self._local, "times", {})
        return times

    def render(
        self,
        position: Union[str, ArrayLike, None] = None,
        orientation_xyz0: Optional[ArrayLike] = None,
        time: Optional[Time] = None,
        *,
        states: Union[str, ArrayLike, None] = None,
        look_at: Union[str, ArrayLike, None] = None,
        nadir: bool = False,
        camera: Optional[AnyCamera] = None,
        layers: Union[str, Sequence[str]] = (),
        **options: Any,
    ) -> Frame:
        """Draws an image.

        Args:
            position: m, MOON_ME (mean Earth/polar axis) with ``orientation_xyz0``; else (latitude, longitude, height): degrees,
                degrees east, m over the sphere of 1 737 400 m, or "NAME,HEIGHT" over a named place.
            orientation_xyz0: Unit quaternion (qx, qy, qz, q0) that turns camera axes (looks along -x, y right, z up) into MOON_ME.
            states: In place of the position, the camera's trajectory: rows of (MJD, rx, ry, rz, vx, vy, vz), m and m/s in MOON_ME, or in
                J2000 with ``orbit_frame="j2000"``; or the name of an OEM of the server's --folders. It is interpolated at ``time``.
            time: MJD (days, UTC), ISO 8601 with its zone, a datetime with its zone, or NumPy's datetime64 (UTC). Always needed: it says
                where the Sun is.
            look_at: In place of the quaternion: (latitude, longitude[, height]), the name of a place, "sun", or
                "horizon:AZIMUTH".
            nadir: In place of the quaternion: look straight down.
            camera: A Camera, the name of a preset, or a mapping with the keys of a camera file.
            layers: Names of ground truth layers, e.g. ["depth", "normal"], or one name; ``models()["layers"]`` has all.
            options: Further options of the command line, "-" as "_": ``samples=9``, ``sun="disc"``. Of cameras that scan ``lines=1000``,
                and as lists of what stands in the lines of their files ``jitter`` and, in place of where the camera is, ``trajectory``.

        Raises:
            RequestError: The server refuses the request, and says why.
            ServerError: The server does not answer.
        """
        request = self._request(position, orientation_xyz0, time, look_at, nadir, camera, options, states)
        with self._http.answers():
            parts, warnings = self._render(_with_layers(request, layers))
            return Frame.of_parts(self, request, parts, warnings)

    def render_all(
        self,
        position: Union[str, ArrayLike, None] = None,
        orientation_xyz0: Optional[ArrayLike] = None,
        time: Optional[Time] = None,
        *,
        cameras: Sequence[Union[AnyCamera, Mounted]],
        states: Union[str, ArrayLike, None] = None,
        look_at: Union[str, ArrayLike, None] = None,
        nadir: bool = False,
        layers: Union[str, Sequence[str]] = (),
        **options: Any,
    ) -> List[Frame]:
        """Draws an image with each of several cameras, in one request.

        Args:
            cameras: All where the state is, or, as ``Mounted``, on the body whose state it is (docs/cameras.md).
            position, orientation_xyz0, time, states, look_at, nadir, layers, options: As for ``render``.

        The frames are in the order of the cameras. ``locate`` and ``visible`` can't be asked of a camera that scans.
        """
        if not cameras:
            raise MsisfError("give a list of cameras with one at least")
        body = self._request(position, orientation_xyz0, time, look_at, nadir, None, options, states, has_camera=False)
        own = [options_of(one) for one in cameras]
        with self._http.answers():
            frames = []
            parts, warnings = self._render({"frame": _with_layers(body, layers), "cameras": own})
            for index, camera in enumerate(own):
                prefix = f"{camera.get('name', f'camera{index + 1}')}."
                ours = {name[len(prefix):]: part for name, part in parts.items() if name.startswith(prefix)}
                frames.append(Frame.of_parts(self, {**body, **camera}, ours, warnings))
                frames[-1].ask_alone()
        return frames

    def _render(self, request: Mapping[str, Any]) -> Tuple[Dict[str, Part], List[str]]:
        headers, content = self._http.post("/v1/render", request, "multipart/mixed, application/octet-stream, application/json")
        self._local.times = _times(headers.get("Server-Timing", ""))
        warning = headers.get("X-Msisf-Warning")
        return parts_of(headers, content), [warning] if warning else []

    def view(
        self, position: ArrayLike, orientation_xyz0: ArrayLike, time: Time, *, camera: Optional[Camera] = None, **options: Any
    ) -> View:
        """A camera without its image: nothing is drawn, but the Moon can be asked what it would see.

        Args:
            position: m, MOON_ME.
            orientation_xyz0: Unit quaternion (qx, qy, qz, q0) that turns camera axes (looks along -x, y right, z up) into MOON_ME.
            time: As for ``render``.
            camera: A Camera.
            options: As for ``render``.
        """
        pinhole = camera if camera is not None else self._camera
        if not isinstance(pinhole, Camera):
            raise MsisfError("a view needs an msisf.Camera; render() takes presets and camera files")
        request = self._request(position, orientation_xyz0, time, None, False, pinhole, options)
        focal = 0.5 * pinhole.width / np.tan(np.radians(0.5 * pinhole.fov))
        K = np.array([[focal, 0.0, 0.5 * (pinhole.width - 1)], [0.0, focal, 0.5 * (pinhole.height - 1)], [0.0, 0.0, 1.0]])
        turn = array_of(orientation_xyz0, "orientation_xyz0").ravel()
        x, y, z, w = turn / np.linalg.norm(turn)
        moon_from_camera = np.array([
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w), 2.0 * (x * z + y * w)],
            [2.0 * (x * y + z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w)],
            [2.0 * (x * z - y * w), 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y)],
        ])  # fmt: skip
        R = np.array([moon_from_camera[:, 1], -moon_from_camera[:, 2], -moon_from_camera[:, 0]])
        place = array_of(position, "position").ravel()
        return View(self, request, place, (K, R, -R @ place))

    def stream(
        self,
        *,
        camera: Optional[AnyCamera] = None,
        cameras: Optional[Sequence[Union[AnyCamera, Mounted]]] = None,
        newest_only: bool = False,
        timing: bool = False,
        **options: Any,
    ) -> Stream:
        """Opens a stream for closed loops: states go in, grey images come out, with less to send and to read than ``render``.

        Args:
            camera: As for ``render``; the same for all images.
            cameras: Several in its place: ``render_all`` has the image of each. All are at the state that is sent, or, as ``Mounted``, on
                the body whose state that is.
            newest_only: Leave out states that are older than another one that waits; the default draws all, in their order.
            timing: Ask the server what each image took: ``last_times`` of the stream.
            options: As for ``render``.
        """
        if cameras is not None:
            if camera is not None or not cameras:
                raise MsisfError("give a camera, or a list of cameras with one at least")
            own = [options_of(one) for one in cameras]
            return Stream(self._http, {**self._options, **named(options)}, newest_only, timing, own)
        frame = {**self._options, **options_of(camera if camera is not None else self._camera), **named(options)}
        return Stream(self._http, frame, newest_only, timing)

    def models(self) -> Dict[str, Any]:
        """The names that requests may use: models, maps, cameras, laws of reflectance and layers."""
        answer: Dict[str, Any] = self._http.get("/v1/models")
        return answer

    def metrics(self) -> Dict[str, float]:
        """What the server counts (docs/server.md), by the names of Prometheus with their labels."""
        with self._http.answers():
            lines = self._http.get_text("/metrics").splitlines()
            pairs = (line.rsplit(" ", 1) for line in lines if not line.startswith("#"))
            return {name: float(value) for name, value in pairs}

    def sun(self, time: Time, place: Optional[ArrayLike] = None) -> Dict[str, Any]:
        """Where the Sun is at a time, and where it is in the sky of a place (latitude, longitude in degrees)."""
        when = time_text(time)
        query = {"utc" if "T" in when else "mjd": when}
        if place is not None:
            query.update(zip(("latitude", "longitude"), map(repr, numbers(place, "place", 2))))
        answer: Dict[str, Any] = self._http.get(f"/v1/sun?{urlencode(query)}")
        return answer

    def close(self) -> None:
        """Closes the connections, and ends the server if it was started here."""
        self._http.close()
        if self._process is not None:
            self._process.close()
            self._process = None

    def __enter__(self) -> Moon:
        return self

    def __exit__(
        self, kind: Optional[Type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]
    ) -> None:
        self.close()

    def _post(self, path: str, body: Mapping[str, Any]) -> Any:
        with self._http.answers():
            return json.loads(self._http.post(path, body, "application/json")[1])

    def _request(
        self,
        position: Union[str, ArrayLike, None],
        orientation: Optional[ArrayLike],
        time: Optional[Time],
        look_at: Union[str, ArrayLike, None],
        nadir: bool,
        camera: Optional[AnyCamera],
        options: Mapping[str, Any],
        states: Union[str, ArrayLike, None] = None,
        has_camera: bool = True,
    ) -> Dict[str, Any]:
        of_camera = options_of(camera if camera is not None else self._camera) if has_camera else {}
        if "trajectory" in options:
            if any(given is not None for given in (position, orientation, look_at, states)) or nadir:
                raise MsisfError("a trajectory says where the camera is and how it points; leave the other arguments out")
            moving = {**self._options, **of_camera, **named(options)}
            return moving if time is None else {**moving, "time": time_text(time)}
        if (orientation is not None) + (look_at is not None) + bool(nadir) != 1:
            raise MsisfError("give one of orientation_xyz0, look_at and nadir=True: it says how the camera points")
        if (position is None) == (states is None):
            raise MsisfError("give one of position and states: it says where the camera is")
        when = time_text(time)
        request = {**self._options, **of_camera, **named(options)}
        is_named = isinstance(position, str) and orientation is None
        if states is None:
            place: Dict[str, Any] = {"position": position if is_named else numbers(position, "position", 3)}
        else:
            place = {"states": str(states) if isinstance(states, str) else rows(states, "states", 7).tolist()}
        if orientation is not None:
            turn = numbers(orientation, "orientation_xyz0", 4)
            if states is None:
                return {**request, "fixed-state": [when, *place["position"], *turn]}
            return {**request, **place, "time": when, "attitude": turn}
        target = "nadir" if nadir else str(look_at) if isinstance(look_at, str) else numbers(look_at, "look_at", 2, 3)
        return {**request, **place, "time": when, "look-at": target}


def _with_layers(request: Dict[str, Any], layers: Union[str, Sequence[str]]) -> Dict[str, Any]:
    wanted = listed(layers, "layers") or listed(request.pop("layers", None), "layers")
    return {**request, "layers": wanted, "layers-format": "npy"} if wanted else request


def _times(text: str) -> Dict[str, float]:
    pairs = (entry.strip().split(";dur=") for entry in text.split(",") if ";dur=" in entry)
    return {name: float(value) for name, value in pairs}

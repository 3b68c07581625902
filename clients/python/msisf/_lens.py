"""The lenses of docs/cameras.md: where a point of the ideal image plane, as a pinhole has it, is measured in the image.

Both planes are in units of the focal length, x to the right and y down, from the principal point. Coefficients are those of the meta file.
"""

from __future__ import annotations

from typing import Any, Callable, Dict, List, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from ._errors import MsisfError

Plane = Tuple[NDArray[Any], NDArray[Any]]
Formula = Callable[[NDArray[Any], NDArray[Any], Sequence[float]], Plane]

_WAY_STEPS = 12  # on the way from the principal point to a point, where the lens must not fold; as many as msis takes
_NEWTON_STEPS = 5
_FOUND = 1e-14  # units of the focal length
_STEP = 1e-30  # of derivatives by a complex step: nothing cancels, so it can be as small as one likes


def measured_of(model: str, coefficients: Sequence[float], x: NDArray[Any], y: NDArray[Any]) -> Plane:
    """Where ideal points are measured; NaN where the lens does not show them: it folds on the way there from the principal point."""
    if model in _FROM_IDEAL:
        formula = _FROM_IDEAL[model]
        is_shown = np.ones(x.shape, bool)
        for step in range(1, _WAY_STEPS + 1):
            part = step / _WAY_STEPS
            is_shown &= _determinant(_slopes(formula, part * x, part * y, coefficients)) > 0.0
        right, down = formula(x, y, coefficients)
    elif model in _FROM_MEASURED:
        right, down, is_shown = _inverse(_FROM_MEASURED[model], x, y, coefficients)
    else:
        raise MsisfError(f"the lens is of the model '{model}', which this version of msisf does not know; take the one of the server")
    return np.where(is_shown, right, np.nan), np.where(is_shown, down, np.nan)


def _inverse(formula: Formula, x: NDArray[Any], y: NDArray[Any], k: Sequence[float]) -> Any:
    """Follows the inverse of a formula from the principal point, by Newton's method."""
    u, v = np.zeros(x.shape), np.zeros(x.shape)
    x0, y0 = formula(u, v, k)
    is_shown = np.ones(x.shape, bool)
    for step in range(1, _WAY_STEPS + 1):
        part = step / _WAY_STEPS
        for _ in range(_NEWTON_STEPS):
            reached_x, reached_y = formula(u, v, k)
            slopes = xx, xy, yx, yy = _slopes(formula, u, v, k)
            dx, dy = reached_x - (x0 + part * (x - x0)), reached_y - (y0 + part * (y - y0))
            determinant = _determinant(slopes)
            u, v = u - (yy * dx - xy * dy) / determinant, v - (xx * dy - yx * dx) / determinant
        is_shown &= _determinant(_slopes(formula, u, v, k)) > 0.0
    back_x, back_y = formula(u, v, k)
    is_shown &= np.maximum(abs(back_x - x), abs(back_y - y)) <= _FOUND * (1.0 + np.maximum(abs(x), abs(y)))
    return u, v, is_shown


def _slopes(formula: Formula, x: NDArray[Any], y: NDArray[Any], k: Sequence[float]) -> List[NDArray[Any]]:
    along_x, along_y = formula(x + 1j * _STEP, y, k), formula(x, y + 1j * _STEP, k)
    return [along.imag / _STEP for along in (along_x[0], along_y[0], along_x[1], along_y[1])]


def _determinant(slopes: List[NDArray[Any]]) -> NDArray[Any]:
    xx, xy, yx, yy = slopes
    determinant: NDArray[Any] = xx * yy - xy * yx
    return determinant


def _opencv(x: NDArray[Any], y: NDArray[Any], k: Sequence[float]) -> Plane:
    k1, k2, p1, p2, k3, k4, k5, k6, s1, s2, s3, s4 = k
    q = x * x + y * y
    c = (1.0 + q * (k1 + q * (k2 + q * k3))) / (1.0 + q * (k4 + q * (k5 + q * k6)))
    return (c * x + 2.0 * p1 * x * y + p2 * (q + 2.0 * x * x) + q * (s1 + q * s2),
            c * y + p1 * (q + 2.0 * y * y) + 2.0 * p2 * x * y + q * (s3 + q * s4))  # fmt: skip


def _owen(x: NDArray[Any], y: NDArray[Any], e: Sequence[float]) -> Plane:
    e1, e2, e3, e4, e5, e6 = e
    q = x * x + y * y
    radial = 1.0 + q * (e2 + q * e4) + e5 * y + e6 * x
    turn = np.sqrt(q) * (e1 + q * e3)
    return x * radial - y * turn, y * radial + x * turn


def _fisheye(x: NDArray[Any], y: NDArray[Any], k: Sequence[float]) -> Plane:
    k1, k2, k3, k4 = k
    r = np.sqrt(x * x + y * y)
    angle = np.arctan(r)
    q = angle * angle
    factor = np.divide(angle, r, out=np.ones_like(r), where=r != 0.0) * (1.0 + q * (k1 + q * (k2 + q * (k3 + q * k4))))
    return factor * x, factor * y


def _radial(x: NDArray[Any], y: NDArray[Any], k: Sequence[float]) -> Plane:
    q = x * x + y * y
    factor = 1.0 + q * (k[0] + q * (k[1] + q * k[2]))
    return x * factor, y * factor


def _division(x: NDArray[Any], y: NDArray[Any], k: Sequence[float]) -> Plane:
    q = x * x + y * y
    divisor = 1.0 + q * (k[0] + q * (k[1] + q * k[2]))
    return x / divisor, y / divisor


def _polynomial(x: NDArray[Any], y: NDArray[Any], argument: NDArray[Any], k: Sequence[float]) -> Plane:
    s = argument
    return x + k[0] + s * (k[1] + s * (k[2] + s * k[3])), y + k[4] + s * (k[5] + s * (k[6] + s * k[7]))


def _brown(x: "NDArray[Any]", y: "NDArray[Any]", k: Sequence[float]) -> Plane:
    k0, k1, k2, k3, p1, p2, s1, s2, s3, s4, x0, y0 = k
    a, b = x - x0, y - y0
    q = a * a + b * b
    factor = k0 + q * (k1 + q * (k2 + q * k3))
    return (x + a * factor + p1 * (q + 2.0 * a * a) + 2.0 * p2 * a * b + q * (s1 + q * s2),
            y + b * factor + 2.0 * p1 * a * b + p2 * (q + 2.0 * b * b) + q * (s3 + q * s4))  # fmt: skip


_FROM_IDEAL: Dict[str, Formula] = {"opencv": _opencv, "owen": _owen, "fisheye": _fisheye}
_FROM_MEASURED: Dict[str, Formula] = {
    "brown": _brown,
    "radial-factor": _radial,
    "radial-division": _division,
    "polynomial-radius": lambda x, y, k: _polynomial(x, y, np.sqrt(x * x + y * y), k),
    "polynomial-x": lambda x, y, k: _polynomial(x, y, x, k),
}

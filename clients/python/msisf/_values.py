"""Arguments as a request has them: NumPy's scalars and arrays are taken wherever Python's numbers, texts and lists are."""

from __future__ import annotations

import datetime
import json
import math
import os
from typing import Any, Dict, List, Mapping, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import MsisfError

#: MJD (days, UTC), ISO 8601 with its zone, a datetime with its zone, or NumPy's datetime64 (UTC).
Time = Union[float, str, datetime.datetime, np.datetime64]

_TIMES = 'an MJD (days, UTC), "2024-01-19T12:00:00Z", or datetime(..., tzinfo=timezone.utc)'


def array_of(given: ArrayLike, name: str) -> NDArray[np.float64]:
    """Numbers, all of them finite."""
    try:
        array: NDArray[np.float64] = np.asarray(given, dtype=float)
    except (TypeError, ValueError) as error:
        raise MsisfError(f"{name}: numbers are needed: {error}") from error
    if not np.isfinite(array).all():
        raise MsisfError(f"{name}: not all numbers are finite")
    return array


def numbers(given: ArrayLike, name: str, *counts: int) -> List[float]:
    """So many numbers, in whatever shape."""
    array = array_of(given, name)
    if array.size not in counts:
        raise MsisfError(f"{name}: {array.size} given; {' or '.join(map(str, counts))} are needed")
    values: List[float] = array.ravel().tolist()
    return values


def rows(given: ArrayLike, name: str, *columns: int) -> NDArray[np.float64]:
    """Rows of so many numbers; one row may stand alone."""
    array = array_of(given, name)
    if array.size == 0:
        return np.empty((0, columns[0]))
    if array.ndim > 2 or array.shape[-1:] not in [(count,) for count in columns]:
        shape = " x ".join(map(str, array.shape)) or "1"
        raise MsisfError(f"{name}: {shape} numbers given; rows of {' or '.join(map(str, columns))} are needed")
    return np.atleast_2d(array)


def time_text(time: Optional[Time]) -> str:
    """A time as the options have it."""
    if isinstance(time, np.ndarray) and time.size == 1:
        time = time.reshape(-1)[0]
    if time is None:
        raise MsisfError(f"time is missing: give {_TIMES}")
    if isinstance(time, datetime.datetime):
        if time.tzinfo is None:
            raise MsisfError("the time has no zone; give datetime(..., tzinfo=timezone.utc)")
        return time.isoformat()
    if isinstance(time, np.datetime64) and not np.isnat(time):
        is_fine = np.datetime_data(time.dtype)[0] in ("ns", "ps", "fs", "as")
        return f"{np.datetime_as_string(time if is_fine else time.astype('datetime64[us]'))}Z"
    if isinstance(time, str):
        return str(time)
    try:
        days = float(time)
    except (TypeError, ValueError):
        days = math.nan
    if not math.isfinite(days):
        raise MsisfError(f"time is {str(time)[:60]}; give {_TIMES}")
    return repr(days)


def named(options: Mapping[str, Any]) -> Dict[str, Any]:
    """Options under the names of the command line."""
    return {name.replace("_", "-"): plain(value, name) for name, value in options.items()}


def listed(given: Any, name: str) -> List[Any]:
    """A list of names; one name may stand alone."""
    value = plain(given, name)
    return value if isinstance(value, list) else [] if value is None else [value]


def plain(value: Any, name: str) -> Any:
    """A value that JSON can hold."""
    if isinstance(value, (datetime.datetime, np.datetime64)):
        return time_text(value)
    if isinstance(value, (np.generic, np.ndarray)):
        value = value.tolist()
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if isinstance(value, Mapping):
        return {str(key): plain(member, f"{name}, {key}") for key, member in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(member, name) for member in value]
    if isinstance(value, float) and not math.isfinite(value):
        raise MsisfError(f"{name} is {value}; a finite number is needed")
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    raise MsisfError(f"{name} is of the type {type(value).__name__}; a number, a text, True or False, or a list of these is needed")


def json_of(request: Mapping[str, Any]) -> bytes:
    """A request as JSON; each number reads back to the same double."""
    return json.dumps(request, allow_nan=False).encode()

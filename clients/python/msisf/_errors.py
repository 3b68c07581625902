"""What can go wrong."""

from __future__ import annotations

import http.client
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Iterator, Sequence, Tuple


class MsisfError(Exception):
    """A failure of the server or of a request; the text says what is wrong and what to do."""


class RequestError(MsisfError):
    """The server refuses a request; the text is the server's, in the words of the command line.

    Attributes:
        status: HTTP status, e.g. 400.
        options: Options that the text is about, e.g. ["--fov"].
    """

    def __init__(self, text: str, status: int, options: Sequence[str] = ()) -> None:
        super().__init__(text)
        self.status = status
        self.options = list(options)

    def __reduce__(self) -> Tuple[Any, ...]:
        return type(self), (self.args[0], self.status, self.options)  # processes hand each other their exceptions in pickles


class ServerError(MsisfError):
    """The server can't be started or reached, it ended, or its answer is not what it should be."""


class NoSuchAttribute(MsisfError, AttributeError):
    """A frame or a sample has no layer or column of that name; ``hasattr`` says so too."""


class NoSuchSample(MsisfError, IndexError):
    """A data set has fewer images; a loop over its places ends with it."""


@contextmanager
def reading(path: Path) -> Iterator[None]:
    """Makes an MsisfError of all that goes wrong with a file, whatever it holds."""
    try:
        yield
    except MsisfError:
        raise
    except OSError as error:
        raise MsisfError(f"{path}: can't be read: {error.strerror or error}") from error
    except Exception as error:  # no list is complete: a damaged file can hold anything
        raise MsisfError(f"{path}: damaged: {type(error).__name__}: {error}. msis verify names all damaged files of a folder.") from error


@contextmanager
def answers_of(address: str) -> Iterator[None]:
    """Makes a ServerError of all that goes wrong with a server's answer, whatever the server sends or does not send."""
    try:
        yield
    except MsisfError:
        raise
    except (OSError, http.client.HTTPException) as error:
        raise ServerError(f"{address}: no answer of the server: {error or type(error).__name__}") from error
    except Exception as error:  # no list is complete: anything can come from a network
        raise ServerError(f"{address}: the server's answer can't be read: {type(error).__name__}: {error}") from error

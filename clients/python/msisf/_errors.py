"""What can go wrong."""

from __future__ import annotations

from typing import Sequence


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


class ServerError(MsisfError):
    """The server can't be started or reached, or it ended."""

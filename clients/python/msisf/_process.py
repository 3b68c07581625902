"""The server that the client starts if none is given."""

from __future__ import annotations

import os
import shutil
import subprocess
import threading
from collections import deque
from pathlib import Path
from typing import Deque, List, Optional, Sequence

from ._errors import ServerError

_MOMENT = 0.5  # s: the connection of a server that ends breaks before its process is gone


class ServerProcess:
    """A running ``msis serve`` at a free port of this computer."""

    def __init__(self, program: Optional[str], options: Sequence[str]) -> None:
        command: List[str] = [program or find_program(), "serve", "--listen", "127.0.0.1:0", "--end-with-input", *options]
        try:
            self._process = subprocess.Popen(
                command,
                stdin=subprocess.PIPE,  # its end ends the server, however this program ends
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                text=True,
                start_new_session=True,  # Ctrl-C is for this program, which may go on
            )
        except OSError as error:
            raise ServerError(f"{command[0]}: can't be started: {error}") from error
        self._owner = os.getpid()
        assert self._process.stdout is not None and self._process.stderr is not None
        self.address = self._process.stdout.readline().strip()
        if not self.address:
            text = self._process.stderr.read().strip()
            self._process.wait()
            raise ServerError(f"{command[0]} serve ended: {text}")
        # A full pipe would hold the server up; the last lines tell why it ended.
        self._last_lines: Deque[str] = deque(maxlen=3)
        self._reader = threading.Thread(target=self._last_lines.extend, args=(self._process.stderr,), daemon=True)
        self._reader.start()

    def fate(self) -> Optional[str]:
        """How the server ended, with its last lines; None while it runs."""
        if os.getpid() != self._owner:
            return None  # only its parent learns how a process ended
        try:
            code = self._process.wait(_MOMENT)
        except subprocess.TimeoutExpired:
            return None
        self._reader.join(_MOMENT)
        how = f"by signal {-code}" if code < 0 else f"with exit code {code}"
        words = " ".join(line.strip() for line in self._last_lines)
        return f"the server that msisf.Moon() started has ended {how}{': ' if words else ''}{words}"

    def close(self) -> None:
        """Ends the server at once."""
        if self._process.poll() is None:
            self._process.terminate()
            try:
                self._process.wait(5.0)
            except subprocess.TimeoutExpired:
                self._process.kill()
                self._process.wait()
        for pipe in (self._process.stdin, self._process.stdout):
            if pipe is not None:
                pipe.close()


def find_program() -> str:
    """msis: of MSISF_PROGRAM, of this package, on the PATH, or in the tree that this file lies in."""
    named = os.environ.get("MSISF_PROGRAM")
    if named:
        return named
    own = Path(__file__).resolve().parent / "_installation" / ("msis.exe" if os.name == "nt" else "msis")
    if own.is_file():
        return str(own)
    found = shutil.which("msis")
    if found:
        return found
    for folder in Path(__file__).resolve().parents:
        if (folder / "msis").is_file() and (folder / "kernels").is_dir():
            return str(folder / "msis")
    raise ServerError("msis is not on the PATH; name it with Moon(program=...) or the variable MSISF_PROGRAM")

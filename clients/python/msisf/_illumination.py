"""Maps of light as arrays, made by ``msis illumination``."""

from __future__ import annotations

import subprocess
import tempfile
from pathlib import Path
from typing import Any, Dict, List, Optional, Union

from ._errors import ServerError
from ._process import find_program


def illumination(
    *, folder: Optional[Union[str, Path]] = None, program: Optional[str] = None, **options: Any
) -> Dict[str, Any]:
    """Maps how much of the time a region is lit.

    The options are those of ``msis illumination`` with underscores: ``center=(-89.45, 222.7), size=5, cell=100,
    time_interval="61041:1h:61072", above_ground=[0, 2], exact=True``; for an option that is given several times a list of texts, as
    in ``ldem=["LDEM_4.LBL", "LDEM_80S_20M.LBL"]``. With a folder the horizons stay there for the next call.

    Returns the maps by name, float32, line 0 at the top: ``lit``, ``longest_dark`` ... (docs/illumination.md).
    """
    import numpy as np

    for wrong in ("format", "output_dir", "points", "piece"):
        if wrong in options:
            raise TypeError(f"illumination() takes no {wrong}; it gives the maps of a region as arrays")
    command: List[str] = [program or find_program(), "illumination", "--batch", "--format", "npy"]
    for name, value in options.items():
        option = "--" + name.replace("_", "-")
        if value is True:
            command.append(option)
        elif isinstance(value, (list, tuple)) and any(isinstance(item, (str, Path)) for item in value):
            for item in value:
                command += [option, str(item)]
        elif value is not None and value is not False:
            command += [option, ",".join(map(repr, value)) if isinstance(value, (list, tuple)) else str(value)]
    with tempfile.TemporaryDirectory() as temporary:
        target = Path(folder if folder is not None else temporary)
        try:
            run = subprocess.run([*command, "--output-dir", str(target)], capture_output=True, text=True)
        except OSError as error:
            raise ServerError(f"{command[0]}: can't be started: {error}") from error
        if run.returncode != 0:
            raise ServerError(f"msis illumination ended with {run.returncode}: {run.stderr.strip().splitlines()[-1]}")
        paths = [Path(line) for line in run.stdout.splitlines() if line.endswith(".npy")]
        return {path.stem: np.load(path) for path in paths}

"""Makes the package of msisf for pip (PEP 517, PEP 660). It needs nothing but Python, so that `pip install` needs no network.

Nothing is written beside the sources. The same sources give the same bytes.
"""

from __future__ import annotations

import ast
import base64
import gzip
import hashlib
import io
import tarfile
import zipfile
from pathlib import Path
from typing import Any, Dict, List, Mapping, Optional, Tuple

HERE = Path(__file__).resolve().parent
ANY_PLATFORM = "any"
INSTALLATION = "msisf/_installation"  # where a package that brings the program has it
STARTER = b'''"""Starts the program that this package brings, without the time that NumPy takes."""

import os
import subprocess
import sys


def main() -> int:
    root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "msisf", "_installation")
    if os.name == "posix":
        program = os.path.join(root, "msis")
        os.execv(program, [program, *sys.argv[1:]])
    process = subprocess.Popen([os.path.join(root, "msis.exe"), *sys.argv[1:]])
    while True:
        try:
            return process.wait()
        except KeyboardInterrupt:
            continue  # the program has it too, and ends by itself
'''


def build_wheel(wheel_directory: str, config_settings: Any = None, metadata_directory: Optional[str] = None) -> str:
    """What pip installs."""
    return _wheel(Path(wheel_directory), _plain(_package()))


def build_wheel_with_program(folder: Path, program: Mapping[str, Tuple[bytes, int]], platform: str) -> str:
    """What pip installs where the program comes along: path within its installation -> content and mode. scripts/release.sh makes it."""
    installation = {f"{INSTALLATION}/{path}": file for path, file in program.items()}
    return _wheel(folder, {**_plain({**_package(), "msisf_program.py": STARTER}), **installation}, platform)


def build_editable(wheel_directory: str, config_settings: Any = None, metadata_directory: Optional[str] = None) -> str:
    """What `pip install -e` installs: a reference to the sources."""
    return _wheel(Path(wheel_directory), _plain({"msisf.pth": f"{HERE}\n".encode()}))


def build_sdist(sdist_directory: str, config_settings: Any = None) -> str:
    """The sources."""
    name = f"msisf-{_project()['version']}"
    sources = {path.name: path.read_bytes() for path in (HERE / file for file in ("build_backend.py", "pyproject.toml", "README.md"))}
    unpacked = io.BytesIO()
    with tarfile.open(fileobj=unpacked, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for path, content in {"PKG-INFO": _metadata(), **sources, **_package()}.items():
            entry = tarfile.TarInfo(f"{name}/{path}")
            entry.size = len(content)
            archive.addfile(entry, io.BytesIO(content))
    (Path(sdist_directory) / f"{name}.tar.gz").write_bytes(gzip.compress(unpacked.getvalue(), mtime=0))
    return f"{name}.tar.gz"


def _plain(files: Mapping[str, bytes]) -> Dict[str, Tuple[bytes, int]]:
    return {path: (content, 0o644) for path, content in files.items()}


def _wheel(folder: Path, files: Mapping[str, Tuple[bytes, int]], platform: str = ANY_PLATFORM) -> str:
    name = f"msisf-{_project()['version']}"
    tag = f"py3-none-{platform}"
    pure = "true" if platform == ANY_PLATFORM else "false"
    notes = {"METADATA": _metadata(), "WHEEL": f"Wheel-Version: 1.0\nGenerator: msisf\nRoot-Is-Purelib: {pure}\nTag: {tag}\n".encode()}
    if platform != ANY_PLATFORM:
        notes["entry_points.txt"] = b"[console_scripts]\nmsis = msisf_program:main\n"
    files = {**files, **_plain({f"{name}.dist-info/{note}": content for note, content in notes.items()})}
    record = f"{name}.dist-info/RECORD"
    lines = [f"{path},sha256={_digest(content)},{len(content)}\n" for path, (content, _) in files.items()] + [f"{record},,\n"]
    with zipfile.ZipFile(folder / f"{name}-{tag}.whl", "w") as archive:
        for path, (content, mode) in {**files, **_plain({record: "".join(lines).encode()})}.items():
            entry = zipfile.ZipInfo(path)  # of 1980-01-01
            entry.external_attr = (0o100000 | mode) << 16
            archive.writestr(entry, content, zipfile.ZIP_DEFLATED)
    return f"{name}-{tag}.whl"


def _package() -> Dict[str, bytes]:
    files = sorted(path for path in (HERE / "msisf").iterdir() if path.suffix == ".py" or path.name == "py.typed")
    return {f"msisf/{path.name}": path.read_bytes() for path in files}


def _metadata() -> bytes:
    project = _project()
    return "".join([
        f"Metadata-Version: 2.1\nName: {project['name']}\nVersion: {project['version']}\nSummary: {project['description']}\n",
        f"Requires-Python: {project['requires-python']}\n",
        *(f"Requires-Dist: {dependency}\n" for dependency in project["dependencies"]),
        "Description-Content-Type: text/markdown\n\n",
        (HERE / project["readme"]).read_text(encoding="utf-8"),
    ]).encode()  # fmt: skip


def _project() -> Dict[str, Any]:
    """The table [project] of pyproject.toml, whose lines are also Python's: a reader of TOML comes with Python 3.11 only."""
    text = (HERE / "pyproject.toml").read_text(encoding="utf-8")
    lines: List[str] = text.split("[project]\n")[1].split("\n\n")[0].splitlines()
    return {key: ast.literal_eval(value) for key, value in (line.split(" = ", 1) for line in lines)}


def _digest(content: bytes) -> str:
    return base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()

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
from typing import Any, Dict, List, Mapping, Optional

HERE = Path(__file__).resolve().parent
TAG = "py3-none-any"


def build_wheel(wheel_directory: str, config_settings: Any = None, metadata_directory: Optional[str] = None) -> str:
    """What pip installs."""
    return _wheel(Path(wheel_directory), _package())


def build_editable(wheel_directory: str, config_settings: Any = None, metadata_directory: Optional[str] = None) -> str:
    """What `pip install -e` installs: a reference to the sources."""
    return _wheel(Path(wheel_directory), {"msisf.pth": f"{HERE}\n".encode()})


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


def _wheel(folder: Path, files: Mapping[str, bytes]) -> str:
    name = f"msisf-{_project()['version']}"
    tags = f"Wheel-Version: 1.0\nGenerator: msisf\nRoot-Is-Purelib: true\nTag: {TAG}\n".encode()
    record = f"{name}.dist-info/RECORD"
    files = {**files, f"{name}.dist-info/METADATA": _metadata(), f"{name}.dist-info/WHEEL": tags}
    lines = [f"{path},sha256={_digest(content)},{len(content)}\n" for path, content in files.items()] + [f"{record},,\n"]
    with zipfile.ZipFile(folder / f"{name}-{TAG}.whl", "w") as archive:
        for path, content in {**files, record: "".join(lines).encode()}.items():
            entry = zipfile.ZipInfo(path)  # of 1980-01-01
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, content, zipfile.ZIP_DEFLATED)
    return f"{name}-{TAG}.whl"


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

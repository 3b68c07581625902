"""The package as pip makes it; what pip itself does with it is in scripts/suites/python.sh."""

import base64
import csv
import hashlib
import inspect
import io
import sys
import tarfile
import typing
import zipfile
from email import message_from_bytes

import msisf
import pytest
from conftest import CLIENT

sys.path.append(str(CLIENT))
import build_backend  # noqa: E402


def test_wheel_has_the_package_and_says_so(tmp_path):
    name = build_backend.build_wheel(str(tmp_path))

    with zipfile.ZipFile(tmp_path / name) as wheel:
        names = wheel.namelist()
        files = {name: wheel.read(name) for name in names}
    info = f"msisf-{msisf.__version__}.dist-info"
    assert {name for name in names if name.startswith("msisf/")} == {
        f"msisf/{path.name}" for path in (CLIENT / "msisf").iterdir() if path.name != "__pycache__"
    }
    record = {row[0]: row[1:] for row in csv.reader(io.StringIO(files[f"{info}/RECORD"].decode()))}
    assert set(record) == set(names) and record.pop(f"{info}/RECORD") == ["", ""]
    for file, (digest, length) in record.items():
        assert base64.urlsafe_b64decode(digest[len("sha256=") :] + "=") == hashlib.sha256(files[file]).digest()
        assert int(length) == len(files[file])
    metadata = message_from_bytes(files[f"{info}/METADATA"])
    assert (metadata["Name"], metadata["Version"]) == ("msisf", msisf.__version__)
    assert metadata.get_all("Requires-Dist") == ["numpy>=1.21"]
    assert "msis serve" in metadata.get_payload()


@pytest.mark.parametrize("build", [build_backend.build_wheel, build_backend.build_editable, build_backend.build_sdist])
def test_same_sources_give_the_same_bytes(tmp_path, build):
    contents = []
    for folder in (tmp_path / "a", tmp_path / "b"):
        folder.mkdir()
        contents.append((folder / build(str(folder))).read_bytes())
    assert contents[0] == contents[1]


def test_sources_build_the_same_wheel(tmp_path):
    with tarfile.open(tmp_path / build_backend.build_sdist(str(tmp_path))) as sources:
        names = {name.split("/", 1)[1] for name in sources.getnames()}
    assert {"PKG-INFO", "pyproject.toml", "build_backend.py", "README.md", "msisf/py.typed", "msisf/__init__.py"} <= names


def test_all_type_hints_can_be_read():
    """As pydantic, dataclass tools and notebooks read them."""
    seen = 0
    for name in msisf.__all__:
        public = getattr(msisf, name)
        found = typing.get_type_hints(public) if inspect.isclass(public) else {}
        for member in [public, *(vars(public).values() if inspect.isclass(public) else ())]:
            for attribute in ("fget", "func", "__func__"):  # of a property, a cached property, a class method
                member = getattr(member, attribute, None) or member
            found = {**found, **(typing.get_type_hints(member) if inspect.isfunction(member) else {})}
        assert not [hint for hint in found.values() if isinstance(hint, str)]
        seen += len(found)
    assert seen > 50
    assert typing.get_type_hints(msisf.View.__init__)["moon"] is msisf.Moon

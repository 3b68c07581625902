"""One server for all tests."""

import sys
from pathlib import Path

import pytest

CLIENT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(CLIENT), str(CLIENT / "examples")]

import msisf  # noqa: E402  (found by the path above)


@pytest.fixture(scope="session")
def moon():
    with msisf.Moon(model="LDEM_4") as the_moon:
        yield the_moon

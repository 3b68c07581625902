"""A data set that ``msis dataset`` made."""

from __future__ import annotations

import copy
import csv
import json
import warnings
from functools import cached_property
from os import PathLike
from pathlib import Path
from typing import Any, Dict, Iterator, List, Mapping, Optional, SupportsIndex, Union, overload

import numpy as np
from numpy.typing import NDArray

from ._errors import MsisfError, NoSuchAttribute, NoSuchSample, reading
from ._png import image_of


_WORDS = ("file", "split", "sha256")
_CRATER_WORDS = ("id", "name")


class Dataset:
    """The images of a data set in their order, or those of one split: a sequence of samples; ``dataset[0:3]`` is one, too.

    Attributes:
        folder: Folder of the data set.
        card: The data set's card: how it was made, and from what.
        K: [3, 3], the matrix of all its cameras in the form of OpenCV.
    """

    def __init__(self, folder: Union[str, PathLike[str]], split: Optional[str] = None) -> None:
        self.folder = Path(folder)
        card = self.folder / "card.json"
        if not card.is_file():
            raise MsisfError(f"{card}: missing. Give the folder of a data set that msis dataset has finished.")
        with reading(card):
            self.card: Dict[str, Any] = json.loads(card.read_text(encoding="utf-8"))
            names = [each["name"] for each in self.card["splits"]]
            self.K: NDArray[np.float64] = np.array(self.card["camera"]["K"], dtype=float)
        if split is not None and split not in names:
            raise MsisfError(f"{self.folder} has no split '{split}'; there are {', '.join(names)}")
        index = self.folder / "index.csv"
        with reading(index), open(index, newline="", encoding="utf-8") as lines:
            all_rows = [_row_of(row) for row in csv.DictReader(lines)]
        self._rows = [row for row in all_rows if split is None or row["split"] == split]

    def __len__(self) -> int:
        return len(self._rows)

    @overload
    def __getitem__(self, place: SupportsIndex) -> Sample: ...

    @overload
    def __getitem__(self, place: slice) -> Dataset: ...

    def __getitem__(self, place: Union[SupportsIndex, slice]) -> Union[Sample, Dataset]:
        """An image by its place, from 0, or from the end by a negative one; of a slice a data set with these images."""
        if isinstance(place, slice):
            part = copy.copy(self)
            part._rows = self._rows[place]
            return part
        try:
            return Sample(self, self._rows[place])
        except IndexError:
            raise NoSuchSample(f"{self.folder}: place {place} of {len(self)} images; they are 0 to {len(self) - 1}") from None
        except TypeError:
            raise MsisfError(f"{self.folder}: the place of an image is a whole number or a slice, not {type(place).__name__}") from None

    def __iter__(self) -> Iterator[Sample]:
        return (Sample(self, row) for row in self._rows)

    def __repr__(self) -> str:
        return f"<msisf.Dataset {self.folder}: {len(self)} images>"


class Sample:
    """An image of a data set with its truth; files are read when they are asked for.

    A layer is also an attribute: ``sample.depth``; "-" is "_", and "normals" is the layer "normal". So is a column of the index:
    ``sample.sun_elevation``, ``sample.lit``. Where a name has several meanings (``position`` is the camera's, a layer goes before a
    column), a warning says which one it is; ``sample.layer(name)`` and ``sample.index[name]`` are clear.

    Attributes:
        number: From 1; both images of a pair follow one another, the odd one first.
        split: Name of its split.
        index: Its row of the index; numbers as float, NaN where there is none.
    """

    def __init__(self, dataset: Dataset, row: Mapping[str, Any]) -> None:
        self._dataset = dataset
        self.index: Dict[str, Any] = dict(row)
        self.number = int(row["number"])
        self.split: str = row["split"]
        self._stem: str = row["file"][: -len(".png")]

    @cached_property
    def image(self) -> NDArray[Any]:
        """Grey levels [height, width], or the digital numbers of a camera with a detector."""
        with reading(self.path(".png")):
            return image_of(self._repr_png_())

    def _repr_png_(self) -> bytes:
        """For Jupyter, which shows the image."""
        with reading(self.path(".png")):
            return self.path(".png").read_bytes()

    @property
    def K(self) -> NDArray[np.float64]:
        """[3, 3], the camera's matrix in the form of OpenCV."""
        return self._dataset.K

    @property
    def position(self) -> NDArray[np.float64]:
        """Of the camera, [3], m, MOON_ME; a warning says so if there is also a layer of this name."""
        if self.path(".position.npy").is_file():
            warnings.warn("sample.position is the camera's position; the layer is sample.layer('position')", stacklevel=2)
        return self._position

    @cached_property
    def _position(self) -> NDArray[np.float64]:
        return np.array([self.index[name] for name in ("x", "y", "z")])

    @cached_property
    def quaternion(self) -> NDArray[np.float64]:
        """(qx, qy, qz, q0): turns camera axes (looks along -x, y right, z up) into MOON_ME."""
        return np.array([self.index[name] for name in ("qx", "qy", "qz", "q0")])

    @cached_property
    def R(self) -> NDArray[np.float64]:
        """[3, 3]: turns MOON_ME into camera axes of OpenCV (x right, y down, z forward)."""
        x, y, z, w = self.quaternion
        moon_from_camera = np.array([
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ])  # fmt: skip
        return np.stack([moon_from_camera[:, 1], -moon_from_camera[:, 2], -moon_from_camera[:, 0]])

    @cached_property
    def t(self) -> NDArray[np.float64]:
        """[3], m: the Moon's centre in these axes."""
        t: NDArray[np.float64] = -self.R @ self._position
        return t

    @cached_property
    def craters(self) -> NDArray[Any]:
        """The craters in the image, a record array of the columns of its .craters.csv; empty without a catalogue."""
        path = self.path(".craters.csv")
        if not path.is_file():
            return np.recarray(0, dtype=[("number", int)])
        with reading(path), open(path, newline="", encoding="utf-8") as file:
            lines = csv.DictReader(file)
            names: List[str] = list(lines.fieldnames or [])
            kinds = [(name, object if name in _CRATER_WORDS else int if name == "number" else float) for name in names]
            rows = [
                tuple(kind(line[name] or "nan") if kind is not object else line[name] for name, kind in kinds) for line in lines
            ]
            return np.array(rows, dtype=kinds).view(np.recarray)

    def path(self, ending: str) -> Path:
        """The path of one of its files, e.g. ``path(".xml")``."""
        return self._dataset.folder / (self._stem + ending)

    def layer(self, name: str) -> NDArray[Any]:
        """A layer: [height, width] or [height, width, planes]; "flow" is one, too. Layers in FITS are not read here."""
        path = self.path(f".{name}.npy")
        if not path.is_file():
            raise MsisfError(f"{path}: missing: the data set has no layer '{name}'. Its file's options say which it has: layers: [{name}].")
        with reading(path):
            array: NDArray[Any] = np.load(path)
            return array

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        dashed = name.replace("_", "-")
        for known in (dashed, dashed[:-1]):
            if self.path(f".{known}.npy").is_file():
                if name in self.index:
                    warnings.warn(
                        f"sample.{name} is the layer '{known}'; the column of the index is sample.index['{name}']", stacklevel=2)  # fmt: skip
                return self.layer(known)
        if name in self.index:
            return self.index[name]
        raise NoSuchAttribute(f"image {self.number} of {self._dataset.folder} has neither a layer nor a column '{name}'")

    def __repr__(self) -> str:
        return f"<msisf.Sample {self.number} of {self._dataset.folder}, {self.split}>"


def _row_of(row: Mapping[str, str]) -> Dict[str, Any]:
    """A row of the index with its numbers; NaN where there is none."""
    int(row["number"]), row["file"], row["split"]  # what every image needs: an exception where it is missing
    return {name: value if name in _WORDS else float(value) if value else float("nan") for name, value in row.items()}

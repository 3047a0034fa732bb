"""Files of pairs: CSV, OpenCV's key points and matches as `.npz`, COLMAP's database and its `images.txt`."""

from __future__ import annotations

import csv
import zlib
from pathlib import Path
from zipfile import BadZipFile

import numpy as np
from numpy.typing import NDArray

from algebroproj_derivations.studies.pairs import colmap
from algebroproj_derivations.studies.pairs.matching import chosen, form, paired

Numbers = NDArray[np.float64]

COLUMNS = "x1,y1,x2,y2"
POINTS = "X,Y,Z"
NUMERALS = {3: "three", 4: "four"}
ZIP = b"PK\x03\x04"


def read_pairs(path: Path, columns: str = COLUMNS, images: str | None = None, every: bool = False) -> Numbers:
    """Return the pixels of a file of pairs, shape (2, n, 2).

    Parameters
    ----------
    path : Path
        The content says what it is, and of COLMAP's text files the name ``images.txt``.
    columns : str, optional
        Of a CSV file: the names of the columns with x and y of the left and of the right picture, in the first line.
        Or their numbers, from 1, if the first line is a pair, too.  Other columns are ignored.
    images : str, optional
        Of COLMAP's files: the names of the left and of the right picture.
    every : bool, optional
        Of a database: take all matches, not those that COLMAP has verified.

    Raises
    ------
    ValueError
        If the file is of none of these kinds or damaged, a column, array or picture is missing, or a number is not
        finite.
    OSError
        If the file cannot be read.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     path = Path(folder) / "pairs.csv"
    ...     _ = path.write_text("u,v,r,s\\n1,2,3,4\\n5,6,7,8\\n")
    ...     read_pairs(path, "u,v,r,s").tolist()
    [[[1.0, 2.0], [5.0, 6.0]], [[3.0, 4.0], [7.0, 8.0]]]
    """
    with path.open("rb") as file:
        start = file.read(len(colmap.SQLITE))
    if start == colmap.SQLITE:
        return colmap.of_database(path, images, every)
    if path.name == colmap.IMAGES:
        return colmap.of_model(path, images)
    if images is not None:
        raise ValueError(f"images: expected them with a database or {colmap.IMAGES} of COLMAP alone, got {path}")
    if start.startswith(ZIP):
        return _of_arrays(path)
    return _of_table(path, _names(columns, 4, "columns", COLUMNS)).reshape(-1, 2, 2).transpose(1, 0, 2)


def is_verified(path: Path) -> bool:
    """Return whether a file has what COLMAP's RANSAC has kept."""
    with path.open("rb") as file:
        return path.name == colmap.IMAGES or file.read(len(colmap.SQLITE)) == colmap.SQLITE


def read_objects(path: Path, points: str) -> Numbers:
    """Return the object coordinates of a CSV file of pairs, shape (n, 3); NaN in lines where they are not given.

    Raises
    ------
    ValueError
        If the file is no such file, a column is missing, or a number is not finite.
    OSError
        If the file cannot be read.
    """
    with path.open("rb") as file:
        start = file.read(len(colmap.SQLITE))
    if start == colmap.SQLITE or start.startswith(ZIP) or path.name == colmap.IMAGES:
        raise ValueError(f"points: expected them with a CSV file alone, got {path}")
    return _of_table(path, _names(points, 3, "points", POINTS), lacking=True)


def arrays(path: Path) -> dict[str, NDArray[np.generic]]:
    """Return the arrays of a file that `numpy.savez` has written."""
    try:
        with np.load(path, allow_pickle=False) as file:
            return dict(file)
    except (ValueError, BadZipFile, EOFError, KeyError, NotImplementedError, RuntimeError, zlib.error) as error:
        raise ValueError(
            f"file: expected arrays of numbers as numpy.savez writes them, got {path} ({error})"
        ) from error


def _of_arrays(path: Path) -> Numbers:
    found = arrays(path)
    for names in (("keypoints1", "keypoints2", "matches"), ("x1", "x2")):
        if set(names) <= found.keys():
            break
    else:
        raise ValueError(
            "file: expected the arrays x1 and x2, or keypoints1, keypoints2 and matches, "
            f"got {', '.join(sorted(found)) or 'none'} in {path}"
        )
    points = []
    for name in names[:2]:
        if found[name].ndim != 2 or found[name].shape[1] < 2 or found[name].dtype.kind not in "fiu":
            raise ValueError(f"file: expected {name} as numbers of the shape (n, 2), got {form(found[name])} in {path}")
        points.append(found[name].astype(np.float64))
    if len(names) == 3:
        return chosen(points, found["matches"], path)
    if len(points[0]) != len(points[1]):
        raise ValueError(f"file: expected {len(points[0])} points x2 as of x1, got {len(points[1])} in {path}")
    return paired(np.concatenate([side[:, :2] for side in points], axis=1), path)


def _names(columns: str, count: int, option: str, example: str) -> list[str]:
    names = [name.strip() for name in columns.split(",")]
    if len(names) != count or len(set(names)) != count:
        raise ValueError(f"{option}: expected {NUMERALS[count]} names such as {example}, got {columns}")
    return names


def _of_table(path: Path, names: list[str], lacking: bool = False) -> Numbers:
    """Return the columns with some names; NaN in lines where all of them are empty, if these may be `lacking`."""
    try:
        lines = list(csv.reader(path.read_text(encoding="utf-8-sig").splitlines(), skipinitialspace=True, strict=True))
    except (UnicodeDecodeError, csv.Error) as error:
        raise ValueError(f"file: expected a text file of comma-separated values, got {path} ({error})") from error
    numbered = all(name.isdecimal() and int(name) > 0 for name in names)
    if numbered:
        places = [int(name) - 1 for name in names]
    else:
        header = [name.strip() for name in lines[0]] if lines else []
        for name in names:
            if header.count(name) != 1:
                got = ", ".join(header) or "none"
                raise ValueError(f"file: expected one column {name} in the first line of {path}, got the columns {got}")
        places = [header.index(name) for name in names]
    cells = [
        [np.nan] * len(names)
        if lacking and not any(_cell(line, place) for place in places)
        else [_number(line, place, name, number, path) for place, name in zip(places, names, strict=True)]
        for number, line in enumerate(lines, 1)
        if line and (numbered or number > 1)
    ]
    return np.array(cells, dtype=np.float64).reshape(-1, len(names))


def _cell(line: list[str], place: int) -> str:
    return line[place].strip() if place < len(line) else ""


def _number(line: list[str], place: int, name: str, number: int, path: Path) -> float:
    text = _cell(line, place)
    try:
        value = float(text)
    except ValueError:
        value = np.nan
    if not np.isfinite(value):
        raise ValueError(f"file: expected a finite number in line {number} of {path}, column {name}, got {text!r}")
    return value

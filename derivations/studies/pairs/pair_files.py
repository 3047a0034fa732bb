"""Files of pairs: CSV with the columns x1, y1, x2, y2 in pixels."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

COLUMNS = "x1", "y1", "x2", "y2"


def read_pairs(path: Path) -> NDArray[np.float64]:
    """Return the pixels of a file of pairs, shape (2, n, 2).

    Parameters
    ----------
    path : Path
        A CSV file whose first line names the columns.  Other columns are ignored.

    Raises
    ------
    ValueError
        If the file is not text, a column is missing, or a cell is not a finite number.
    OSError
        If the file cannot be read.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     path = Path(folder) / "pairs.csv"
    ...     _ = path.write_text("x1,y1,x2,y2\\n1,2,3,4\\n5,6,7,8\\n")
    ...     read_pairs(path).tolist()
    [[[1.0, 2.0], [5.0, 6.0]], [[3.0, 4.0], [7.0, 8.0]]]
    """
    try:
        lines = list(csv.reader(path.read_text(encoding="utf-8-sig").splitlines(), skipinitialspace=True, strict=True))
    except (UnicodeDecodeError, csv.Error) as error:
        raise ValueError(f"file: expected a text file of comma-separated values, got {path} ({error})") from error
    header = [name.strip() for name in lines[0]] if lines else []
    for name in COLUMNS:
        if header.count(name) != 1:
            got = ", ".join(header) or "none"
            raise ValueError(f"file: expected one column {name} in the first line of {path}, got the columns {got}")
    places = [header.index(name) for name in COLUMNS]
    cells = [
        [_number(line, place, name, number, path) for place, name in zip(places, COLUMNS, strict=True)]
        for number, line in enumerate(lines[1:], 2)
        if line
    ]
    return np.array(cells, dtype=np.float64).reshape(-1, 2, 2).transpose(1, 0, 2)


def _number(line: list[str], place: int, name: str, number: int, path: Path) -> float:
    text = line[place].strip() if place < len(line) else ""
    try:
        value = float(text)
    except ValueError:
        value = np.nan
    if not np.isfinite(value):
        raise ValueError(f"file: expected a finite number in line {number} of {path}, column {name}, got {text!r}")
    return value

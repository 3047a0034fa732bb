"""COLMAP's files: matches and cameras of a database, and of a model exported as text.

COLMAP counts pixels from the corner of the picture: the middle of the first pixel is (0.5, 0.5).  The coordinates are
taken as they are.
"""

from __future__ import annotations

import sqlite3
from collections.abc import Iterable, Sequence
from contextlib import closing
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from algebroproj_derivations.studies.pairs.matching import chosen, paired

Numbers = NDArray[np.float64]

SQLITE = b"SQLite format 3\0"
IMAGES, CAMERAS = "images.txt", "cameras.txt"
LAST_IMAGE = 2147483647
"""COLMAP numbers the pair of the pictures i < j as i * 2147483647 + j."""
NAMED = 5
MODELS = {
    "SIMPLE_PINHOLE": "f cx cy",
    "PINHOLE": "fx fy cx cy",
    "SIMPLE_RADIAL": "f cx cy k1",
    "RADIAL": "f cx cy k1 k2",
    "OPENCV": "fx fy cx cy k1 k2 p1 p2",
    "FULL_OPENCV": "fx fy cx cy k1 k2 p1 p2 k3 k4 k5 k6",
}
"""Models of cameras with the names of their parameters in order; OpenCV has the same distortion."""
NUMBERS = dict(
    enumerate(["SIMPLE_PINHOLE", "PINHOLE", "SIMPLE_RADIAL", "RADIAL", "OPENCV", "OPENCV_FISHEYE", "FULL_OPENCV"])
)


def of_database(path: Path, images: str | None, every: bool) -> Numbers:
    """Return the matched key points of two pictures, shape (2, n, 2): those verified by COLMAP, or all."""
    pictures = {name: number for number, name in _rows(path, "SELECT image_id, name FROM images ORDER BY image_id")}
    for name, number in pictures.items():
        if not isinstance(name, str) or not isinstance(number, int) or not 0 <= number < LAST_IMAGE:
            raise ValueError(f"file: expected names and numbers of pictures, got {name!r} and {number!r} in {path}")
    names = _two(pictures, images, path)
    numbers = [pictures[name] for name in names]
    points = []
    for name, number in zip(names, numbers, strict=True):
        found = _rows(path, "SELECT rows, cols, data FROM keypoints WHERE image_id = ?", number)
        if not found:
            raise ValueError(f"file: expected key points of {name}, got none in {path}")
        points.append(_array(*found[0], "<f4", path).astype(np.float64))
    low, high = sorted(numbers)
    table = "matches" if every else "two_view_geometries"
    found = _rows(path, f"SELECT rows, cols, data FROM {table} WHERE pair_id = ?", low * LAST_IMAGE + high)
    if not found or not found[0][0]:
        kind = "matches" if every else "verified matches"
        raise ValueError(f"file: expected {kind} of {' and '.join(names)}, got none in {path}")
    matches = _array(*found[0], "<u4", path).astype(np.int64)
    return chosen(points, matches if numbers[0] == low else matches[:, ::-1], path)


def of_model(path: Path, images: str | None) -> Numbers:
    """Return the pixels of the points that two pictures of ``images.txt`` share, shape (2, n, 2)."""
    pictures = {name: points for name, _, points in _pictures(path)}
    seen = [_seen(pictures[name], name, path) for name in _two(pictures, images, path)]
    shared = sorted(seen[0].keys() & seen[1].keys())
    return paired(np.array([seen[0][number] + seen[1][number] for number in shared]).reshape(-1, 4), path)


def cameras(path: Path, images: str | None) -> list[dict[str, float]]:
    """Return the parameters of two pictures' cameras, of a database or of ``cameras.txt`` beside ``images.txt``."""
    if path.name == CAMERAS:
        of_pictures = {name: number for name, number, _ in _pictures(path.with_name(IMAGES))}
        found = {words[0]: (words[1], words[4:]) for words in map(str.split, _lines(path)) if len(words) > 4}
    else:
        of_pictures = {name: str(number) for name, number in _rows(path, "SELECT name, camera_id FROM images")}
        found = {
            str(number): (NUMBERS.get(model, f"number {model}"), np.frombuffer(values, "<f8").tolist())
            for number, model, values in _rows(path, "SELECT camera_id, model, params FROM cameras")
        }
    result = []
    for name in _two(of_pictures, images, path):
        model, values = found.get(of_pictures[name], ("none", []))
        if model not in MODELS:
            raise ValueError(
                f"camera: expected one of the models {', '.join(MODELS)} for {name}, got {model} in {path}. "
                "Undistort the pictures first"
            )
        result.append(dict(zip(MODELS[model].split(), _floats(values, MODELS[model], path), strict=True)))
    return result


def _two(pictures: Iterable[str], images: str | None, path: Path) -> Sequence[str]:
    """Return the names of the left and of the right picture; both may be left out if there are no others."""
    known = list(pictures)
    names = known if images is None else [name.strip() for name in images.split(",")]
    if len(set(names)) != 2 or not set(names) <= set(known):
        listed = ", ".join(known[:NAMED]) + (", ..." if len(known) > NAMED else "")
        got = "none" if images is None else images
        raise ValueError(f"images: expected two of the {len(known)} pictures {listed} of {path}, got {got}")
    return names


def _rows(path: Path, query: str, *values: int) -> list[Any]:
    try:
        with closing(sqlite3.connect(f"{path.resolve().as_uri()}?mode=ro", uri=True)) as database:
            return database.execute(query, values).fetchall()
    except sqlite3.Error as error:
        raise ValueError(f"file: expected a database of COLMAP, got {path} ({error})") from error


def _array(rows: Any, columns: Any, data: Any, kind: str, path: Path) -> NDArray[Any]:
    """Return what a database keeps as bytes; each of the three may be anything in a damaged one."""
    got = f"{len(data)} bytes" if isinstance(data, bytes) else "none"
    numbers = isinstance(rows, int) and isinstance(columns, int) and isinstance(data, bytes)
    if not numbers or rows < 0 or columns < 2 or len(data) != 4 * rows * columns:
        raise ValueError(f"file: expected {rows} rows of {columns} numbers, got {got} in {path}")
    return np.frombuffer(data, kind).reshape(rows, columns)


def _lines(path: Path) -> list[str]:
    try:
        return [line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    except UnicodeDecodeError as error:
        raise ValueError(f"file: expected a text file of COLMAP, got {path} ({error})") from error


def _pictures(path: Path) -> list[tuple[str, str, list[str]]]:
    """Return name, number of the camera, and words of the points of each picture: two lines of the file."""
    lines = _lines(path)
    found = []
    for first, second in zip(lines[::2], [*lines[1::2], ""], strict=False):
        words = first.split(maxsplit=9)
        if len(words) != 10:
            raise ValueError(f"file: expected ten words for each picture, got {first[:60]!r} in {path}")
        found.append((words[9].strip(), words[8], second.split()))
    return found


def _seen(words: list[str], name: str, path: Path) -> dict[int, list[float]]:
    """Return the pixels of the points of a picture by their numbers; points that occur more than once are left out."""
    cells = np.array(_floats(words, None, path))
    if len(cells) % 3 or not np.isfinite(cells).all():
        raise ValueError(f"file: expected three finite numbers for each point of {name}, got others in {path}")
    points = cells.reshape(-1, 3)
    numbers, first, counts = np.unique(points[:, 2], return_index=True, return_counts=True)
    return {
        int(number): points[place, :2].tolist()
        for number, place in zip(numbers[counts == 1], first[counts == 1], strict=True)
        if number >= 0
    }


def _floats(words: Sequence[Any], names: str | None, path: Path) -> list[float]:
    try:
        found = [float(word) for word in words]
    except ValueError as error:
        raise ValueError(f"file: expected numbers in {path} ({error})") from error
    if names is not None and len(found) != len(names.split()):
        raise ValueError(f"camera: expected the parameters {names}, got {len(found)} numbers in {path}")
    return found

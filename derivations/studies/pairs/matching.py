"""Pairs from key points and matches, whoever found them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Numbers = NDArray[np.float64]


def chosen(points: list[Numbers], matches: NDArray[np.generic], path: Path) -> Numbers:
    """Return the pairs that are matched, each once, from the key points of both pictures; the first two columns count.

    Detectors give a key point once for each of its orientations: then several matches are one pair.
    """
    if matches.ndim != 2 or matches.shape[1] != 2 or not np.issubdtype(matches.dtype, np.integer):
        raise ValueError(f"file: expected matches as whole numbers of the shape (m, 2), got {form(matches)} in {path}")
    for side, (found, numbers) in enumerate(zip(points, matches.T, strict=True), 1):
        wrong = (numbers < 0) | (numbers >= len(found))
        if wrong.any():
            raise ValueError(
                f"file: expected matches among the {len(found)} key points of picture {side}, "
                f"got {numbers[wrong][0]} in {path}"
            )
    rows = np.concatenate([side[numbers, :2] for side, numbers in zip(points, matches.T, strict=True)], axis=1)
    return paired(rows, path)


def paired(rows: Numbers, path: Path) -> Numbers:
    """Return the pixels, shape (2, n, 2), of rows x1, y1, x2, y2 that may occur again."""
    if not np.isfinite(rows).all():
        raise ValueError(f"file: expected finite numbers, got {rows[~np.isfinite(rows)][0]} in {path}")
    once = np.sort(np.unique(rows, axis=0, return_index=True)[1])
    return rows[once].astype(np.float64).reshape(-1, 2, 2).transpose(1, 0, 2)


def form(array: NDArray[np.generic]) -> str:
    """Return type and shape of an array, for a message."""
    return f"{array.dtype} of the shape {array.shape}"

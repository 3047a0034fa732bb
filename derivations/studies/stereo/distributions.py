"""Joint distributions of two quantities of a dataset that is larger than memory, counted chunk by chunk."""

from __future__ import annotations

from dataclasses import dataclass

import dask.array
import numpy as np
import xarray
from numpy.typing import ArrayLike, NDArray

from algebroproj_sym.study.declaration import MEMBER

Numbers = NDArray[np.float64]


@dataclass(frozen=True)
class Joint:
    """A joint distribution of two quantities, as counts.

    Attributes
    ----------
    x_edges, y_edges : ndarray
        Edges of the cells.
    counts : ndarray, shape (len(x_edges) - 1, len(y_edges) - 1)
        Members in each cell.
    outside : int
        Members that are in no cell, or not finite.
    """

    x_edges: Numbers
    y_edges: Numbers
    counts: Numbers
    outside: int

    def quantiles(self, probabilities: ArrayLike, least: int = 20) -> Numbers:
        """Return quantiles of y in each column of x, shape (len(probabilities), columns); NaN below `least` members."""
        wanted = np.atleast_1d(np.asarray(probabilities, dtype=np.float64))
        result = np.full((len(wanted), len(self.counts)), np.nan)
        for column, cells in enumerate(self.counts):
            total = cells.sum()
            if total >= least:
                cumulative = np.concatenate([[0.0], np.cumsum(cells)]) / total
                result[:, column] = np.interp(wanted, cumulative, self.y_edges)
        return result

    def line(self, low: float, high: float) -> tuple[float, float, float]:
        """Return slope, intercept and scatter (standard deviation of y) of the regression line for x in a range."""
        x, y = self._centers(self.x_edges), self._centers(self.y_edges)
        weights = np.where(((x >= low) & (x <= high))[:, None], self.counts, 0.0)
        total = weights.sum()
        mean_x, mean_y = (weights.sum(axis=1) @ x) / total, (weights.sum(axis=0) @ y) / total
        dx, dy = x - mean_x, y - mean_y
        slope = float((dx @ weights @ dy) / (dx**2 @ weights.sum(axis=1)))
        rest = dy[None, :] - slope * dx[:, None]
        return slope, float(mean_y - slope * mean_x), float(np.sqrt((weights * rest**2).sum() / total))

    @staticmethod
    def _centers(edges: Numbers) -> Numbers:
        middle: Numbers = (edges[1:] + edges[:-1]) / 2
        return middle


def joint(dataset: xarray.Dataset, x: str, y: str, x_edges: ArrayLike, y_edges: ArrayLike) -> Joint:
    """Count the members of a dataset by two of its variables.

    Examples
    --------
    >>> dataset = xarray.Dataset({"x": ("member", [0.5, 0.5, 1.5]), "y": ("member", [0.2, 0.4, np.nan])})
    >>> counted = joint(dataset, "x", "y", [0, 1, 2], [0, 0.3, 0.6])
    >>> counted.counts.tolist(), counted.outside
    ([[1.0, 1.0], [0.0, 0.0]], 1)
    """
    edges = np.asarray(x_edges, dtype=np.float64), np.asarray(y_edges, dtype=np.float64)
    counted = dask.array.histogram2d(*(dask.array.asarray(dataset[name].data) for name in (x, y)), bins=edges)[0]
    counts = counted.compute(scheduler="synchronous")
    return Joint(*edges, counts, int(dataset.sizes[MEMBER] - counts.sum()))

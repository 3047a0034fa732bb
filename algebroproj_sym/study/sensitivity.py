"""Which inputs make a result uncertain: Sobol's indices and Morris's elementary effects, by SALib."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

__all__ = ["Effects", "Input", "Shares", "morris", "sobol"]

Array = NDArray[np.float64]
Output = Callable[[Array], Array]


@dataclass(frozen=True)
class Input:
    """An uncertain input.

    Attributes
    ----------
    name : str
    distribution : {"normal", "uniform"}
    first, second : float
        Mean and standard deviation, or lower and upper limit.

    Raises
    ------
    ValueError
        If the second number is too small, or the distribution is unknown.
    """

    name: str
    distribution: Literal["normal", "uniform"]
    first: float
    second: float

    def __post_init__(self) -> None:
        if self.distribution not in ("normal", "uniform"):
            raise ValueError(f"{self.name}: expected the distribution normal or uniform, got {self.distribution!r}")
        least = 0.0 if self.distribution == "normal" else self.first
        if not (np.isfinite(self.first) and self.second > least):
            raise ValueError(f"{self.name}: expected a second number above {least}, got {self.second}")


@dataclass(frozen=True)
class Shares:
    """Sobol's indices: which share of the variance of a result is due to each input.

    Attributes
    ----------
    names : tuple of str
    first, total : ndarray, shape (p,)
        Alone, and with all interactions.
    first_confidence, total_confidence : ndarray, shape (p,)
        Half the 95 % confidence intervals, by resampling.
    """

    names: tuple[str, ...]
    first: Array
    total: Array
    first_confidence: Array
    total_confidence: Array


@dataclass(frozen=True)
class Effects:
    """Morris's elementary effects of each input, over its whole range.

    Attributes
    ----------
    names : tuple of str
    size : ndarray, shape (p,)
        Mean of their absolute values.
    spread : ndarray, shape (p,)
        Standard deviation: large where the effect depends on the other inputs, or is not linear.
    confidence : ndarray, shape (p,)
        Half the 95 % confidence interval of the size, by resampling.
    """

    names: tuple[str, ...]
    size: Array
    spread: Array
    confidence: Array


def sobol(output: Output, inputs: Sequence[Input], samples: int = 1024, seed: int = 0) -> Shares:
    """Return Sobol's indices of a result.

    Parameters
    ----------
    output : callable
        From points, shape (n, p), to a number for each, shape (n,).
    inputs : sequence of Input
        Independent of each other.
    samples : int
        A power of two.  The result is computed at (p + 2) times as many points.
    seed : int
        The seed of the scrambled sequence and of the resampling.

    Returns
    -------
    Shares

    Raises
    ------
    ValueError
        If the number of samples is no power of two, there is no input, or a result is not finite or has another shape.

    Examples
    --------
    >>> found = sobol(lambda x: x[:, 0] + 2 * x[:, 1], [Input("a", "normal", 0, 1), Input("b", "normal", 0, 1)], 512)
    >>> found.first.round(1).tolist()
    [0.2, 0.8]
    """
    from SALib.analyze import sobol as analysis
    from SALib.sample import sobol as sampling

    if samples < 2 or samples & (samples - 1):
        raise ValueError(f"sobol: expected a power of two as the number of samples, got {samples}")
    problem = _problem(inputs)
    points = sampling.sample(problem, samples, calc_second_order=False, seed=seed)
    values = _computed("sobol", output, points)
    found = analysis.analyze(problem, values, calc_second_order=False, seed=seed)
    return Shares(tuple(problem["names"]), *(np.asarray(found[key]) for key in ("S1", "ST", "S1_conf", "ST_conf")))


def morris(output: Output, inputs: Sequence[Input], trajectories: int = 100, seed: int = 0) -> Effects:
    """Return Morris's elementary effects on a result.

    Parameters
    ----------
    output : callable
        From points, shape (n, p), to a number for each, shape (n,).
    inputs : sequence of Input
        The inputs.  A normal input ranges between its quantiles of 1/8 and 7/8.
    trajectories : int
        The result is computed at (p + 1) times as many points.
    seed : int
        The seed of the trajectories and of the resampling.

    Returns
    -------
    Effects

    Raises
    ------
    ValueError
        If there are less than two trajectories, there is no input, or a result is not finite or has another shape.

    Examples
    --------
    >>> found = morris(lambda x: 3 * x[:, 0] + x[:, 1], [Input("a", "uniform", 0, 1), Input("b", "uniform", 0, 1)])
    >>> found.size.round(6).tolist(), bool(found.spread.max() < 1e-9)
    ([3.0, 1.0], True)
    """
    from SALib.analyze import morris as analysis
    from SALib.sample import morris as sampling

    if trajectories < 2:
        raise ValueError(f"morris: expected at least two trajectories, got {trajectories}")
    problem = _problem([_as_range(one) for one in inputs])
    points = sampling.sample(problem, trajectories, num_levels=4, seed=seed)
    values = _computed("morris", output, points)
    found = analysis.analyze(problem, points, values, num_levels=4, seed=seed)
    return Effects(
        tuple(problem["names"]), *(np.asarray(found[key], dtype=float) for key in ("mu_star", "sigma", "mu_star_conf"))
    )


def _problem(inputs: Sequence[Input]) -> Mapping[str, Any]:
    if not inputs:
        raise ValueError("inputs: expected at least one, got none")
    return {
        "num_vars": len(inputs),
        "names": [one.name for one in inputs],
        "bounds": [[one.first, one.second] for one in inputs],
        "dists": [{"normal": "norm", "uniform": "unif"}[one.distribution] for one in inputs],
    }


def _as_range(one: Input) -> Input:
    """Return a uniform input between the quantiles of 1/8 and 7/8, which are at 1.15 standard deviations."""
    if one.distribution == "uniform":
        return one
    half = 1.1503493803760079 * one.second
    return Input(one.name, "uniform", one.first - half, one.first + half)


def _computed(name: str, output: Output, points: Array) -> Array:
    values = np.asarray(output(points), dtype=np.float64)
    if values.shape != points.shape[:1]:
        raise ValueError(f"{name}: expected a result of shape {points.shape[:1]}, got shape {values.shape}")
    if not np.isfinite(values).all():
        raise ValueError(f"{name}: expected finite results, got {values[~np.isfinite(values)][0]}")
    return values

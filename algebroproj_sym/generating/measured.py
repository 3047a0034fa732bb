"""Errors that were measured, which the docstring of a function tells."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any


@dataclass(frozen=True)
class Plain:
    """The errors of a function without compensation, in units in the last place of the exact result.

    Attributes
    ----------
    median_ulp, max_ulp : float
        Over all samples.
    max_ulp_of_ordinary : float
        Over those of ordinary size, which come near no singularity on purpose.
    """

    median_ulp: float
    max_ulp: float
    max_ulp_of_ordinary: float

    def sentence(self) -> str:
        """Return what a docstring says.

        Examples
        --------
        >>> print(Plain(1, 1e13, 8.0).sentence())
        Without compensation (`plain`): 1 ULP in the median; at most 8 ULP on ordinary input, 1e+13 ULP on all samples.
        """
        largest = f"at most {self.max_ulp_of_ordinary:.3g} ULP on ordinary input, {self.max_ulp:.3g} ULP on all samples"
        return f"Without compensation (`plain`): {self.median_ulp} ULP in the median; {largest}."


@dataclass(frozen=True)
class Measured:
    """The errors of a function over all samples.

    Attributes
    ----------
    samples : int
        How many.
    median_ulp, max_ulp : float
        Errors in units in the last place of the exact result.
    max_ratio : float
        The largest error, over what rounding the input or the result changes.
    plain : Plain, optional
        The errors without compensation.
    """

    samples: int
    median_ulp: float
    max_ulp: float
    max_ratio: float
    plain: Plain | None = None

    def sentence(self, backward: bool) -> str:
        """Return what a docstring says; of a `backward` function, which solves a linear system, the ratio.

        Examples
        --------
        >>> Measured(100, 0.25, 0.75, 1.5).sentence(False)
        'Measured error in float64: 0.25 ULP in the median, at most 0.75 ULP (100 samples, some near singularities).'
        """
        largest = f"{self.max_ratio} times what rounding the arguments changes" if backward else f"{self.max_ulp} ULP"
        figures = f"{self.median_ulp} ULP in the median, at most {largest}"
        return f"Measured error in float64: {figures} ({self.samples} samples, some near singularities)."


def measured_errors(record: Mapping[str, Any]) -> dict[str, Measured]:
    """Return the errors of each function of a record, which is what ``accuracy.json`` holds.

    Examples
    --------
    >>> figures = {"samples": 2, "median_ulp": 0.1, "max_ulp": 0.5, "max_ratio": 1.0}
    >>> measured_errors({"functions": [{"function": "first.double", "all": figures}]})
    {'first.double': Measured(samples=2, median_ulp=0.1, max_ulp=0.5, max_ratio=1.0, plain=None)}
    """
    return {entry["function"]: _measured(entry) for entry in record["functions"]}


def _measured(entry: Mapping[str, Any]) -> Measured:
    names = ("samples", "median_ulp", "max_ulp", "max_ratio")
    return Measured(
        **{name: entry["all"][name] for name in names}, plain=_plain(entry["plain"]) if "plain" in entry else None
    )


def _plain(figures: Mapping[str, Any]) -> Plain:
    everywhere = figures["all"]
    ordinary = next(stratum for stratum in figures["strata"] if stratum["name"] == "ordinary")
    return Plain(everywhere["median_ulp"], everywhere["max_ulp"], ordinary["max_ulp"])


def recorded_errors(path: Path) -> dict[str, Measured]:
    """Return the errors that a file records, none if there is no such file.

    Raises
    ------
    ValueError
        If it is no record of errors.
    """
    if not path.is_file():
        return {}
    try:
        return measured_errors(json.loads(path.read_text(encoding="utf-8")))
    except (KeyError, TypeError, ValueError) as error:
        raise ValueError(f"{path}: expected a record of errors, as verify writes it, got {error!r}") from error

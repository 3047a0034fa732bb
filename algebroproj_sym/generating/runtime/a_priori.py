"""A-priori error bounds: what is known of the error of a function before it is called."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

from .evaluation import parts_of

__all__ = ["AprioriBound", "a_priori"]

RECORD = "accuracy.json"


@dataclass(frozen=True)
class AprioriBound:
    """A bound of the relative error of one entry of a result in float64, for every input.

    Let u = 2**-53, and let the result not overflow or underflow.  The error is at most t/(1 - t) times the exact
    result, where t is less than 1: u for each rounding, and for each term its coefficient times u**2 times its
    condition number.

    Attributes
    ----------
    roundings : int
        The number of roundings.
    terms : tuple of (float, str)
        Coefficients and condition numbers, which are expressions in the arguments; bars are absolute values.
    where : dict of str to str
        What abbreviations in the condition numbers stand for.
    """

    roundings: int
    terms: tuple[tuple[float, str], ...]
    where: Mapping[str, str] = field(hash=False)

    def __str__(self) -> str:
        return " + ".join([f"{self.roundings} u", *(f"{c:g} u**2 {kappa}" for c, kappa in self.terms)])


def a_priori(function: Callable[..., Any]) -> tuple[AprioriBound | None, ...]:
    """Return a bound of the error of each entry of the results, before any call.

    Parameters
    ----------
    function : callable
        A generated function of this package.

    Returns
    -------
    tuple of AprioriBound or None
        One for each entry of the results in row-major order; None for an entry of which no bound is known.  The tuple
        is empty for a function that solves linear systems or calls elementary functions.

    Raises
    ------
    TypeError
        If the function is not a generated one, or computes in another way, such as one that `plain` returns.
    """
    signature, _ = parts_of(function, "a_priori")
    if signature.plain:
        raise TypeError(f"a_priori: expected a generated function, got {function!r}")
    package = Path(function.__globals__["__file__"]).parent
    entry = _entries(package).get(f"{function.__module__.rpartition('.')[2]}.{function.__name__}")
    found = entry and entry.get("a_priori")
    if not found:
        return ()
    return tuple(None if bound is None else _bound(bound, found["where"]) for bound in found["results"])


def _bound(record: Mapping[str, Any], where: Mapping[str, str]) -> AprioriBound:
    terms = tuple((term["coefficient"], term["kappa"]) for term in record["terms"])
    return AprioriBound(record["roundings"], terms, dict(where) if terms else {})


@cache
def _entries(package: Path) -> Mapping[str, Any]:
    """Return what the file of a package records, by the names of functions."""
    path = package / RECORD
    if not path.is_file():
        return {}
    return {entry["function"]: entry for entry in json.loads(path.read_text(encoding="utf-8"))["functions"]}

"""The factors that must not be zero where the formula of a function is to hold."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from functools import reduce
from importlib import import_module
from types import FunctionType
from typing import Any

import numpy as np

from .evaluation import Body, Signature, evaluate, parts_of, placed, without_range
from .wrapping import Wrapped

__all__ = ["hypotheses"]

SYSTEMS = ("solve", "null_vector")


def hypotheses(function: Callable[..., Any]) -> Callable[..., dict[str, Any]]:
    """Return a function that computes the factors that must not be zero.

    Parameters
    ----------
    function : callable
        A generated function of this package.

    Returns
    -------
    callable
        It takes the arguments of the function.  It returns a dictionary: the keys are the factors, as the docstring
        of the function writes them, and the values are arrays with one number for each point.  Of a function that
        solves a linear system there is also the least pivot, as a part of the largest coefficient of its unknown (for
        a null space, of its equation).  It is 0 where rounding could have made it: then the rank is not known.

    Raises
    ------
    TypeError
        If the function is not a generated one.

    Examples
    --------
    >>> import algebroproj, numpy as np
    >>> left = np.random.default_rng(1).uniform(-1, 1, (8, 2))
    >>> algebroproj.hypotheses(algebroproj.correlation.general_correlation_matrix)(left, left)
    {'least pivot': np.float64(0.0)}
    """
    signature, whole = parts_of(function, "hypotheses")
    names = function.__globals__
    factors: tuple[str, ...] = names.get(f"_{function.__name__.upper()}_FACTORS", ())
    body = names.get(f"_{function.__name__}_factors", lambda *entries: ())
    if not {*SYSTEMS}.isdisjoint(whole.__code__.co_names):
        factors, body = (*factors, "least pivot"), _with_least_pivot(body, whole)
    wanted = Signature(
        signature.name, signature.arguments, ((),) * len(factors), signature.block, reach=without_range(signature)
    )

    def values(*arguments: Any, **named: Any) -> dict[str, Any]:
        given = placed(signature, arguments, named)
        if not factors:
            return {}
        computed = evaluate(wanted, body, given)
        return dict(zip(factors, computed if len(factors) > 1 else (computed,), strict=True))

    return Wrapped(hypotheses, function, "The factors that must not be zero, by their names.", values)


def _with_least_pivot(body: Body, whole: Body) -> Body:
    """Return a body that computes the factors, and the least pivot of all systems that a function solves."""
    assert isinstance(whole, FunctionType)

    def both(*entries: Any) -> tuple[Any, ...]:
        pivots: list[Any] = []

        def watched(name: str) -> Callable[..., Any]:
            solve = whole.__globals__[name]
            systems = import_module(solve.__module__)

            def solved(*rows: Any) -> Any:
                pivots.append(systems.least_pivot(name, rows))
                return solve(*rows)

            return solved

        meaning = {name: watched(name) for name in SYSTEMS if name in whole.__code__.co_names}
        with np.errstate(all="ignore"):
            with suppress(ZeroDivisionError):  # of exact numbers, whose pivot is zero
                FunctionType(whole.__code__, whole.__globals__ | meaning)(*entries)
            return (*body(*entries), reduce(_lesser, pivots))

    return both


def _lesser(first: Any, second: Any) -> Any:
    return first * (first <= second) + second * (first > second)

"""Generated functions without compensation: every operation rounds once, and linear systems are not refined."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from importlib import import_module
from types import FunctionType
from typing import Any

from .evaluation import BLOCK, parts_of
from .pairs import DIGITS
from .wrapping import Wrapped

__all__ = ["plain"]


def plain(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a generated function that computes without compensation.

    It is faster and less accurate.  It runs the same formula, compiled where the function is compiled, but no sum is
    computed with extra digits.  On ordinary input the error is a few units in the last place.  Near a singularity all
    digits may be lost.  `bounds` of the new function tells how many are left.

    Parameters
    ----------
    function : callable
        A generated function of this package.

    Returns
    -------
    callable
        It has the parameters of the function, ``out`` included, and raises the same errors.

    Raises
    ------
    TypeError
        If the function is not a generated one.

    Examples
    --------
    >>> import algebroproj
    >>> quickly = algebroproj.plain(algebroproj.optics.scale)
    >>> float(quickly(1.0, 2.0))
    0.3333333333333333
    """
    signature, body = parts_of(function, "plain")
    function = getattr(function, "function", function)
    assert isinstance(function, FunctionType)
    assert isinstance(body, FunctionType)
    names = function.__globals__ | dict.fromkeys(DIGITS, _unchanged)
    names |= {name: _once(names[name]) for name in ("solve", "null_vector") if name in names}
    names[body.__name__] = _with_names(body, names)
    names[f"_{function.__name__.upper()}_SIGNATURE"] = replace(
        signature, block=BLOCK, twin=signature.plain_twin, plain=True, reach=None
    )
    return Wrapped(plain, function, "The same without compensation of sums that cancel.", _with_names(function, names))


def _unchanged(number: Any) -> Any:
    return number


def _once(solve: Callable[..., Any]) -> Any:
    """Return the function that does the same without refinement."""
    return getattr(import_module(solve.__module__), f"{solve.__name__}_once")


def _with_names(function: FunctionType, names: dict[str, Any]) -> FunctionType:
    """Return a function of the same code that finds other meanings of global names."""
    copy = FunctionType(function.__code__, names, function.__name__, function.__defaults__, function.__closure__)
    copy.__kwdefaults__ = function.__kwdefaults__
    return copy

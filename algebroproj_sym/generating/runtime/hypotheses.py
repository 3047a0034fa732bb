"""The factors that must not be zero where the formula of a function is to hold."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from .evaluation import Signature, evaluate, parts_of, placed
from .wrapping import Wrapped

__all__ = ["hypotheses"]


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
        of the function writes them, and the values are arrays with one number for each point.

    Raises
    ------
    TypeError
        If the function is not a generated one.
    """
    signature, _ = parts_of(function, "hypotheses")
    names = function.__globals__
    factors: tuple[str, ...] = names.get(f"_{function.__name__.upper()}_FACTORS", ())
    body = names.get(f"_{function.__name__}_factors", lambda *entries: ())
    wanted = Signature(signature.name, signature.arguments, ((),) * len(factors), signature.block)

    def values(*arguments: Any, **named: Any) -> dict[str, Any]:
        given = placed(signature, arguments, named)
        if not factors:
            return {}
        computed = evaluate(wanted, body, given)
        return dict(zip(factors, computed if len(factors) > 1 else (computed,), strict=True))

    return Wrapped(hypotheses, function, "The factors that must not be zero, by their names.", values)

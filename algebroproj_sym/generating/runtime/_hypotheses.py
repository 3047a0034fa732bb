"""The factors that must not vanish, where the formula of a function holds."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ._evaluation import Signature, evaluate, parts_of, require_count

__all__ = ["hypotheses"]


def hypotheses(function: Callable[..., Any]) -> Callable[..., dict[str, Any]]:
    """Return what gives the values of the factors that must not vanish, by name.

    Parameters
    ----------
    function : callable
        A generated function of this package.

    Returns
    -------
    callable
        It takes the arguments of the function, and returns a dictionary from each factor, as the docstring of the
        function names it, to its values: one for each point of the batch.

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

    def values(*arguments: Any) -> dict[str, Any]:
        require_count(signature, arguments)
        if not factors:
            return {}
        computed = evaluate(wanted, body, arguments)
        return dict(zip(factors, computed if len(factors) > 1 else (computed,), strict=True))

    return values

"""The factors that must not vanish, where the formula of a function holds."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ._evaluation import Signature, evaluate

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
    names = getattr(function, "__globals__", {})
    signature = names.get(f"_{function.__name__.upper()}_SIGNATURE")
    if not isinstance(signature, Signature):
        raise TypeError(f"hypotheses: expected a generated function, got {function.__name__}")
    factors: tuple[str, ...] = names.get(f"_{function.__name__.upper()}_FACTORS", ())
    body = names.get(f"_{function.__name__}_factors", lambda *entries: ())
    wanted = Signature(signature.name, signature.arguments, ((),) * len(factors), signature.block)

    def values(*arguments: Any) -> dict[str, Any]:
        if len(arguments) != len(signature.arguments):
            expected = ", ".join(name for name, _ in signature.arguments)
            raise TypeError(f"{signature.name}: expected the arguments {expected}, got {len(arguments)}")
        if not factors:
            return {}
        computed = evaluate(wanted, body, arguments)
        return dict(zip(factors, computed if len(factors) > 1 else (computed,), strict=True))

    return values

"""The array library that some values belong to: NumPy, or one that says so by ``__array_namespace__``.

Tensors of PyTorch do not say so; the package array-api-compat speaks for them, and is imported if one is given.
"""

from __future__ import annotations

from collections.abc import Iterable
from importlib import import_module
from typing import Any

import numpy as np

__all__ = ["is_foreign", "is_traced", "namespace"]


def is_foreign(value: Any) -> bool:
    """Whether a value is an array of another library than NumPy.

    Examples
    --------
    >>> is_foreign(np.ones(3)), is_foreign(1.0)
    (False, False)
    """
    return _is_tensor(value) or (
        hasattr(value, "__array_namespace__") and not isinstance(value, np.ndarray | np.generic)
    )


def is_traced(value: Any) -> bool:
    """Whether a value stands for the numbers of a program that ``jax.jit`` compiles.

    Examples
    --------
    >>> is_traced(np.ones(3))
    False
    """
    # Arrays are of jaxlib. Tracers of derivatives and of vmap have a value within; all others are compiled.
    while type(value).__module__.startswith("jax."):
        inner = getattr(value, "primal", getattr(value, "val", None))
        if inner is None:
            return True
        value = inner
    return False


def namespace(values: Iterable[Any]) -> Any:
    """Return the functions of the library of the first foreign array, or else NumPy.

    Examples
    --------
    >>> namespace([1.0, np.ones(3)]) is np
    True
    """
    for value in values:
        if is_foreign(value):
            return _of_tensors() if _is_tensor(value) else value.__array_namespace__()
    return np


def _is_tensor(value: Any) -> bool:
    return type(value).__module__.partition(".")[0] == "torch"


def _of_tensors() -> Any:
    try:
        return import_module("array_api_compat.torch")
    except ImportError as error:
        raise TypeError("expected the package array-api-compat, which tensors of torch need, got none") from error

"""The array library that some values belong to: NumPy, or one that says so by ``__array_namespace__``."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

__all__ = ["is_foreign", "namespace"]


def is_foreign(value: Any) -> bool:
    """Whether a value is an array of another library than NumPy.

    Examples
    --------
    >>> is_foreign(np.ones(3)), is_foreign(1.0)
    (False, False)
    """
    return hasattr(value, "__array_namespace__") and not isinstance(value, np.ndarray | np.generic)


def namespace(values: Iterable[Any]) -> Any:
    """Return the functions of the library of the first foreign array, or else NumPy.

    Examples
    --------
    >>> namespace([1.0, np.ones(3)]) is np
    True
    """
    for value in values:
        if is_foreign(value):
            return value.__array_namespace__()
    return np

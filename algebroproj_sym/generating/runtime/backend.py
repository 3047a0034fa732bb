"""Which version of the functions runs: the NumPy source or the compiled one.  Both give the same bits.

Set the environment variable ``ALGEBROPROJ_BACKEND`` to ``numpy`` or ``compiled`` before the package is imported.  If it
is not set, the compiled version runs if there is one.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from importlib import import_module
from types import ModuleType
from typing import Any, Literal

__all__ = ["backend", "calls", "exceeded", "ufunc"]

VARIABLE = "ALGEBROPROJ_BACKEND"
DIGEST = "DIGEST_OF_THE_SOURCE"
"""What identifies the C source that belongs to this package."""


def backend() -> Literal["numpy", "compiled"]:
    """Return which version of the functions was chosen when the package was imported.

    Some calls run the NumPy source in both cases: those with float32, long doubles, objects or complex numbers, those
    with arrays of other libraries, and those of functions that need a sine, cosine or arctangent.
    """
    return "numpy" if _COMPILED is None else "compiled"


def ufunc(name: str) -> Any:
    """Return the generalized ufunc of this name, or None if the NumPy source is to run."""
    return getattr(_COMPILED, name, None)


def _chosen() -> ModuleType | None:
    wanted = os.environ.get(VARIABLE, "")
    if wanted not in ("", "numpy", "compiled"):
        raise ValueError(f"{VARIABLE}: expected numpy or compiled, got {wanted!r}")
    if wanted == "numpy":
        return None
    try:
        compiled = import_module(".._compiled", __package__)
    except ImportError as error:
        problem = str(error)
    else:
        if compiled.DIGEST == DIGEST:
            return compiled
        problem = "it was built from another source"
    if wanted == "compiled":
        raise ImportError(f"{VARIABLE}: expected compiled functions, got none ({problem}): install with a C compiler")
    return None


_COMPILED = _chosen()

calls: Mapping[Any, Callable[..., Any]] = getattr(_COMPILED, "calls", {})
"""For each ufunc what does the same for arrays of one dtype and one leading shape, sooner; for others it gives None."""

exceeded: Callable[[], bool] = getattr(_COMPILED, "exceeded", bool)
"""Whether an intermediate result of a compiled function overflowed or underflowed since this was asked last, in this
thread."""

"""Derive, judge and compile the closed forms of algebro-projective photogrammetry.

The flow is a pipeline, one folder a stage: `expressions` (what is reasoned about), `proving` (decisions),
`declaring` (claims and kernels), `showing` (claims for a reader), `generating` (code), `verifying` (numbers),
`reporting` (the ledger), and the command line `cli` over them.  A stage imports earlier ones only.

Examples
--------
>>> import sympy
>>> from algebroproj_sym import prove
>>> x, y = sympy.symbols("x y")
>>> prove((x**2 - y**2) / (x - y), x + y).verdict
'proved'
>>> prove("(a^2 + b^2)*(c^2 + d^2)", "(a*c - b*d)^2 + (a*d + b*c)^2").verdict
'proved'
"""

from __future__ import annotations

import importlib
import os
import sys
from typing import TYPE_CHECKING, Any

# How many results SymPy keeps of each operation; it reads this once, when it is imported.  Derivations need more than
# its thousand: the same products and sums are built again and again.
os.environ.setdefault("SYMPY_CACHE_SIZE", "100000")

if TYPE_CHECKING:
    from algebroproj_sym.declaring import Section
    from algebroproj_sym.proving import Proof
    from algebroproj_sym.proving.statements import prove

__all__ = ["Proof", "Section", "prove"]

__version__ = "0.1.0"

_HOMES = {"Proof": "proving", "Section": "declaring", "prove": "proving.statements"}


def __getattr__(name: str) -> Any:
    """Import a public name when it is asked for: the test plugin is loaded where nobody asks for SymPy."""
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"{__name__}.{_HOMES[name]}"), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})


if "IPython" in sys.modules:
    from algebroproj_sym.showing.notebook import show_claims_of_cells

    show_claims_of_cells()

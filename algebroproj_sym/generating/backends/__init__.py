"""Backends: each prints lowered kernels as the source of a package.

A backend is a folder here: its `__init__` has what `Backend` asks for, and beside it are its printer and its templates.
To add one, write the folder and name it in `BACKENDS`.  What it is given are kernels that are proved, each with its
straight-line program; it has nothing to decide about formulas.
"""

from collections.abc import Sequence
from typing import Protocol

from algebroproj_sym.declaring import Driver
from algebroproj_sym.generating.backends import cpp, numpy
from algebroproj_sym.generating.lowering import Lowered


class Backend(Protocol):
    """What a module has that is a backend."""

    def render(self, lowered: Sequence[Lowered], drivers: Sequence[Driver], package: str) -> dict[str, str]:
        """Return the text of each file of the package by its path in it.

        Parameters
        ----------
        lowered : sequence of Lowered
            The kernels with their programs.
        drivers : sequence of Driver
            Hand-written functions, of which a backend takes those in its language.
        package : str
            The name of the package.
        """


BACKENDS: dict[str, Backend] = {"numpy": numpy, "cpp": cpp}
"""All backends by name."""

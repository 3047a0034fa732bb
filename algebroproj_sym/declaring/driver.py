"""Drivers: hand-written functions that call generated ones, and travel with the generated package."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

from algebroproj_sym.declaring.claim import DeclarationError


@dataclass(frozen=True)
class Driver:
    """A hand-written function.

    Attributes
    ----------
    module, name : str
        Where it is found in the package: ``algebroproj.<module>.<name>``.
    source : Path
        The module that defines it, which is copied into the package.
    needs : tuple of Path
        Other hand-written modules that it imports, which are copied, too.
    """

    module: str
    name: str
    source: Path
    needs: tuple[Path, ...] = ()


def declared_driver(qualified_name: str, function: Callable[..., Any], needs: Sequence[ModuleType] = ()) -> Driver:
    """Return a driver.

    Raises
    ------
    DeclarationError
        If the function has another name than the driver.
    """
    module, _, name = qualified_name.partition(".")
    if function.__name__ != name:
        raise DeclarationError(f"driver {qualified_name}: expected a function {name}, got {function.__name__}")
    needed = tuple(Path(str(inspect.getsourcefile(each))) for each in needs)
    return Driver(module, name, Path(str(inspect.getsourcefile(function))), needed)

"""Drivers: hand-written functions that call generated ones, and are part of the generated package."""

import ast
import inspect
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from algebroproj_sym.declaring.claim import DeclarationError
from algebroproj_sym.expressions.walking import each_once


@dataclass(frozen=True)
class Driver:
    """A hand-written function."""

    module: str
    name: str
    """Where it is found in the package: ``algebroproj.<module>.<name>``."""
    source: Path
    """The module that defines it, which is copied into the package."""

    @property
    def sources(self) -> frozenset[Path]:
        """The module that defines it, and those beside it that it imports, which are copied, too."""
        return frozenset(each_once([self.source], _imported_from_beside))


def _imported_from_beside(source: Path) -> list[Path]:
    nodes = ast.walk(ast.parse(source.read_text(encoding="utf-8")))
    names = [node.module for node in nodes if isinstance(node, ast.ImportFrom) and node.level == 1]
    return [path for name in names if (path := source.with_name(f"{name}.py")).is_file()]


def declared_driver(qualified_name: str, function: Callable[..., Any]) -> Driver:
    """Return a driver.

    It raises `DeclarationError` if the function has another name than the driver.
    """
    module, _, name = qualified_name.partition(".")
    if function.__name__ != name:
        raise DeclarationError(f"driver {qualified_name}: expected a function {name}, got {function.__name__}")
    return Driver(module, name, Path(str(inspect.getsourcefile(function))))

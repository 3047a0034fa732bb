"""Where a claim is declared: its forms as they are written there, with the order and the names of the author."""

import ast
import linecache
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from itertools import islice
from pathlib import Path
from types import CodeType
from typing import Any, TypeAlias

Place: TypeAlias = tuple[int, int, int, int]
"""First line and column, last line and column."""


@dataclass(frozen=True, eq=False)
class Source:
    """The call that declares a claim.

    It stays in the process that has run it: a claim that is sent to another process leaves it behind.
    """

    code: CodeType
    """What was running."""
    instruction: int
    """The place of the call in it."""
    names: Mapping[str, Any]
    """What names meant there, when the claim was declared."""

    def __reduce__(self) -> tuple[Any, ...]:
        return type(None), ()

    @property
    def folder(self) -> Path:
        """The folder of the module; in a notebook, the working directory."""
        file = Path(self.code.co_filename)
        return file.parent if file.is_file() else Path.cwd()

    def argument(self, name: str) -> ast.expr | None:
        """Return an argument of the call as it is written; None if it cannot be read, or is not written there."""
        call = _read(self._text)[0].get(self._place)
        found = [keyword.value for keyword in call.keywords if keyword.arg == name] if call else []
        return found[0] if found else None

    def assigned(self, name: str) -> ast.expr | None:
        """Return what the module assigned to a name before the call; None if that cannot be told."""
        before = [value for line, value in _read(self._text)[1].get(name, ()) if line < self._place[0]]
        return before[-1] if before else None

    @property
    def _text(self) -> str:
        return "".join(linecache.getlines(self.code.co_filename))

    @property
    def _place(self) -> Place:
        line, last_line, column, last_column = next(
            islice(self.code.co_positions(), self.instruction // 2, None), (None,) * 4
        )
        return line or 0, column or 0, last_line or 0, last_column or 0


def calling(depth: int) -> Source:
    """Return the call that is made by the function so many frames above."""
    frame = sys._getframe(depth + 1)
    return Source(frame.f_code, frame.f_lasti, {**frame.f_globals, **frame.f_locals})


@lru_cache(maxsize=128)
def _read(text: str) -> tuple[Mapping[Place, ast.Call], Mapping[str, list[tuple[int, ast.expr]]]]:
    """Return the calls of a module by their places, and what it assigns to names of its own, with the lines."""
    try:
        module = ast.parse(text)
    except SyntaxError:
        return {}, {}
    calls = {
        (node.lineno, node.col_offset, node.end_lineno or 0, node.end_col_offset or 0): node
        for node in ast.walk(module)
        if isinstance(node, ast.Call)
    }
    assigned: dict[str, list[tuple[int, ast.expr]]] = {}
    for statement in module.body:
        if isinstance(statement, ast.Assign) and isinstance(statement.targets[0], ast.Name):
            assigned.setdefault(statement.targets[0].id, []).append((statement.lineno, statement.value))
    return calls, assigned

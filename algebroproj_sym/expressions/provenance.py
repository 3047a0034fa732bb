"""Provenance: of which operation on which operands a value is the result, noted while derivations are imported.

Nothing rests on it: an export writes the operations out, and a proof assistant computes them again.  A matrix carries
its provenance; a scalar, of which SymPy keeps one copy, is found by its value, as it was made last.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any, TypeVar

import sympy


@dataclass(frozen=True, eq=False)
class Made:
    """A value, and how it was made.

    Attributes
    ----------
    operation : str
        What was done; "entries" if a matrix was given entry by entry, "scalar" if an expression was given.
    operands : tuple
        Provenances and, for some operations, plain data.
    value : sympy.Expr or sympy matrix
        The result.
    """

    operation: str
    operands: tuple[Any, ...]
    value: Any


@dataclass
class Record:
    """What was noted.

    Attributes
    ----------
    claims : dict of (paper, number) to Made
        How the derived forms of claims were made.
    scalars : dict of Expr to Made
        How scalars were made, the last time.
    atoms : list of Made
        Results since the last claim that are a number or a symbol, which say nothing by their value.
    names : dict of Made to str
        What modules call their objects.
    """

    claims: dict[tuple[str, str], Made] = field(default_factory=dict)
    scalars: dict[Any, Made] = field(default_factory=dict)
    atoms: list[Made] = field(default_factory=list)
    names: dict[Made, str] = field(default_factory=dict)


Result = TypeVar("Result")
_records: list[Record] = []


@contextmanager
def recording() -> Iterator[Record]:
    """Note provenance of what is made within.

    Examples
    --------
    >>> from algebroproj_sym.expressions import Matrix
    >>> with recording():
    ...     square = Matrix([[2]]) * Matrix([[2]])
    >>> made_of(square).operation
    'times'
    """
    _records.append(Record())
    try:
        yield _records[-1]
    finally:
        _records.pop()


def is_recording() -> bool:
    """Whether provenance is noted."""
    return bool(_records)


def noted(operation: str, operands: tuple[Any, ...], result: Result) -> Result:
    """Return the result of an operation, after noting how it was made; plain data among operands stay as they are."""
    if not _records or not isinstance(result, sympy.Expr | sympy.MatrixBase):
        return result
    made = Made(operation, tuple(map(_operand, operands)), result)
    if isinstance(result, sympy.MatrixBase):
        if hasattr(result, "__dict__"):
            result = result._new(result.rows, result.cols, list(result.flat()))
            result.__dict__["made"] = made
    elif result.args:
        _records[-1].scalars[result] = made
    else:
        _records[-1].atoms.append(made)
    return result


def _operand(value: Any) -> Any:
    return made_of(value) if isinstance(value, sympy.Expr | sympy.MatrixBase) else value


def made_of(value: Any) -> Made:
    """Return how a value was made."""
    if isinstance(value, sympy.MatrixBase):
        kept: dict[str, Any] = getattr(value, "__dict__", {})
        if "made" not in kept:
            made = Made("entries", (value.shape, *map(made_of, value.flat())), value)
            kept["made"] = made
            return made
        found: Made = kept["made"]
        return found
    value = sympy.sympify(value)
    scalars = _records[-1].scalars if _records else {}
    return scalars.get(value) or Made("scalar", tuple(_references(value, scalars)), value)


def _references(value: Any, scalars: dict[Any, Made]) -> list[tuple[Any, Made]]:
    """Return the largest parts of an expression whose provenance is known."""
    found, waiting, met = [], list(value.args), set()
    while waiting:
        node = waiting.pop()
        if node in scalars:
            found.append((node, scalars[node]))
        elif node not in met:
            met.add(node)
            waiting += node.args
    return found


def declare(key: tuple[str, str], derived: Any) -> None:
    """Note how the derived form of a claim was made."""
    if _records and isinstance(derived, sympy.Expr | sympy.MatrixBase):
        record = _records[-1]
        record.claims[key] = _with_atoms(made_of(derived), record.atoms)
        record.atoms.clear()


def name(objects: Mapping[str, Any]) -> None:
    """Note what a module calls its objects."""
    for called, value in objects.items() if _records else ():
        made = None
        if isinstance(value, sympy.MatrixBase):
            made = getattr(value, "__dict__", {}).get("made")
        elif isinstance(value, sympy.Expr) and value.args:
            made = _records[-1].scalars.get(value)
        if made is not None and not called.startswith("_"):
            _records[-1].names.setdefault(made, called)


def _with_atoms(made: Made, atoms: list[Made]) -> Made:
    """Return how a value was made whose numbers and symbols, in order, are the last ones that operations gave."""
    parts = [made] if made.operation == "scalar" else [*made.operands[1:]] if made.operation == "entries" else []
    places = [place for place, part in enumerate(parts) if not part.value.args]
    for results in (atoms, [atom for atom in atoms if atom.operation != "part"]):
        last = results[len(results) - len(places) :] if len(results) >= len(places) else []
        if places and [atom.value for atom in last] == [parts[place].value for place in places]:
            found = dict(enumerate(parts)) | dict(zip(places, last, strict=True))
            if made.operation == "scalar":
                return found[0]
            return Made("entries", (made.operands[0], *found.values()), made.value)
    return made

"""Provenance: the operation and the operands behind each value, recorded while derivations are imported.

Nothing rests on it: an export writes the operations out, and a proof assistant computes them again.  A matrix and a
number carry their provenance; any other scalar, of which SymPy keeps one copy, is found by its value, as it was made
last.
"""

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import wraps
from typing import Any, TypeVar

import sympy


@dataclass(frozen=True, eq=False)
class Made:
    """A value, and how it was made."""

    operation: str
    """What was done; "entries" if a matrix was given entry by entry, "scalar" if an expression was given."""
    operands: tuple[Any, ...]
    """Provenances and, for some operations, plain data."""
    value: Any
    """The result."""


@dataclass
class Record:
    """What was noted."""

    claims: dict[tuple[str, str], Made] = field(default_factory=dict)
    """How the derived forms of claims were made."""
    scalars: dict[Any, Made] = field(default_factory=dict)
    """How scalars were made, the last time."""
    atoms: list[Made] = field(default_factory=list)
    """Results since the last claim that are a symbol, which says nothing by its value."""
    names: dict[Made, str] = field(default_factory=dict)
    """What modules call their objects."""


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
    kept = sympy.Basic.subs, sympy.Basic.xreplace
    sympy.Basic.subs, sympy.Basic.xreplace = map(noting, kept)
    try:
        yield _records[-1]
    finally:
        _records.pop()
        sympy.Basic.subs, sympy.Basic.xreplace = kept


def is_recording() -> bool:
    """Whether provenance is noted."""
    return bool(_records)


def noted(operation: str, operands: tuple[Any, ...], result: Result) -> Result:
    """Return the result of an operation, after noting how it was made; plain data among operands stay as they are."""
    if not _records or not isinstance(result, sympy.Expr | sympy.MatrixBase):
        return result
    made = Made(operation, tuple(map(_operand, operands)), plain(result))
    if isinstance(result, sympy.MatrixBase):
        copied: Result = result._new(result.rows, result.cols, list(result.flat()))
        return with_provenance(copied, made)
    if isinstance(result, sympy.Rational):
        number: Result = _number(made)
        return number
    if result.args:
        _records[-1].scalars[result] = made
    else:
        _records[-1].atoms.append(made)
    return result


def with_provenance(matrix: Result, made: Made) -> Result:
    """Return a matrix after writing into it how it was made."""
    if hasattr(matrix, "__dict__"):
        matrix.__dict__["made"] = made
    return matrix


def noting(substitute: Callable[..., Any]) -> Callable[..., Any]:
    """Return a method that substitutes, and notes what stands for which symbol, but not how it carries that out."""

    @wraps(substitute)
    def method(whole: Any, *arguments: Any, **options: Any) -> Any:
        if not _records or _within or not isinstance(whole, sympy.Expr | sympy.MatrixBase):
            return substitute(whole, *arguments, **options)
        given, *more = arguments
        pairs = [(given, *more)] if more else [*given.items()] if hasattr(given, "items") else [*given]
        _within.append(True)
        try:
            result = substitute(whole, *_without_provenance(given, more, pairs), **options)
        finally:
            _within.pop()
        if not all(isinstance(old, sympy.Symbol) for old, _ in pairs):
            return result
        return noted("substituted", (whole, tuple((old.name, made_of(new)) for old, new in pairs)), result)

    return method


def _without_provenance(given: Any, more: list[Any], pairs: list[Any]) -> tuple[Any, ...]:
    if more:
        return given, plain(sympy.sympify(more[0]))
    known = [(old, plain(sympy.sympify(new))) for old, new in pairs]
    return (dict(known) if hasattr(given, "items") else known,)


_within: list[bool] = []


class _Noted:
    """A number that knows how it was made; it is equal to any other of this value."""

    made: Made
    p: int
    q: int

    def __hash__(self) -> int:
        return hash(_value(self))

    def __reduce_ex__(self, protocol: Any) -> Any:
        return _value(self).__reduce_ex__(protocol)


class _Integer(_Noted, sympy.Integer):  # type: ignore[misc]
    pass


class _Rational(_Noted, sympy.Rational):  # type: ignore[misc]
    pass


def _number(made: Made) -> Any:
    value = made.value
    kind = _Integer if value.q == 1 else _Rational
    found = sympy.Expr.__new__(kind)
    found.p, found.made = value.p, made
    if kind is _Rational:
        found.q = value.q
    return found


def _value(number: Any) -> Any:
    return sympy.Rational(int(number.p), int(number.q)) if isinstance(number, _Noted) else number


def _counting(name: str, operation: str, reflected: bool = False) -> Callable[..., Any]:
    """Return a method for numbers that know how they were made."""

    def method(self: Any, *others: Any) -> Any:
        if any(isinstance(other, sympy.MatrixBase) for other in others):
            return NotImplemented
        result = getattr(_value(self), name)(*map(_value, others))
        exact = all(isinstance(other, int) or (not reflected and isinstance(other, sympy.Rational)) for other in others)
        operands = map(sympy.sympify, (*others, self) if reflected else (self, *others))
        return noted(operation, (*operands,), result) if exact and isinstance(result, sympy.Rational) else result

    return method


for _name, _operation in {"add": "plus", "sub": "minus", "mul": "times", "truediv": "divided"}.items():
    setattr(_Noted, f"__{_name}__", _counting(f"__{_name}__", _operation))
    setattr(_Noted, f"__r{_name}__", _counting(f"__r{_name}__", _operation, reflected=True))
for _name, _operation in {"pow": "power", "neg": "negated", "abs": "absolute"}.items():
    setattr(_Noted, f"__{_name}__", _counting(f"__{_name}__", _operation))


def is_noted(value: Any) -> bool:
    """Whether a value is a number that knows how it was made."""
    return isinstance(value, _Noted)


def plain(value: Any) -> Any:
    """Return an expression or a matrix whose numbers do not know how they were made."""
    if isinstance(value, sympy.MatrixBase):
        return value
    found = {atom for atom in value.atoms(sympy.Rational) if isinstance(atom, _Noted)}
    if not found:
        return value
    return _value(value) if value in found else value._xreplace({atom: _value(atom) for atom in found})[0]


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
    if isinstance(value, _Noted):
        return value.made
    scalars = _records[-1].scalars if _records else {}
    return scalars.get(value) or Made("scalar", tuple(_references(value, scalars)), plain(value))


def _references(value: Any, scalars: dict[Any, Made]) -> list[tuple[Any, Made]]:
    """Return the largest parts of an expression whose provenance is known."""
    found, waiting, met = [], list(value.args), set()
    while waiting:
        node = waiting.pop()
        if isinstance(node, _Noted):
            found.append((_value(node), node.made))
        elif node in scalars:
            found.append((node, scalars[node]))
        elif node not in met:
            met.add(node)
            waiting += node.args
    return found


def declare(key: tuple[str, str], derived: Any) -> Any:
    """Return the derived form of a claim, after noting how it was made."""
    if not _records or not isinstance(derived, sympy.Expr | sympy.MatrixBase):
        return derived
    record = _records[-1]
    record.claims[key] = _with_atoms(made_of(derived), record.atoms)
    record.atoms.clear()
    return plain(derived)


def name(objects: Mapping[str, Any]) -> None:
    """Note what a module calls its objects."""
    for called, value in objects.items() if _records else ():
        made = None
        if isinstance(value, dict) and all(isinstance(key, str) for key in value):
            name({f"{called}_{key}": part for key, part in value.items() if isinstance(part, sympy.MatrixBase | dict)})
        elif isinstance(value, sympy.MatrixBase):
            made = getattr(value, "__dict__", {}).get("made")
        elif isinstance(value, _Noted):
            made = value.made
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

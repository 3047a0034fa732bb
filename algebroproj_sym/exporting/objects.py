"""Objects of derivations as Coq definitions, made step by step as the derivation makes them.

Each operation occurs twice: as the call of a function of ``Linear.v``, and as what this function computes of formulas,
part by part in the same order.  Coq compares the two; if they differ, it rejects the theorem.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypeAlias

import sympy

from algebroproj_sym.exporting.gallina import formula, identifier, listed
from algebroproj_sym.exporting.refusal import NotExportable
from algebroproj_sym.exporting.terms import (
    Term,
    integer,
    name,
    names,
    negative,
    number,
    power,
    product,
    quotient,
    size,
    substituted,
    total,
)
from algebroproj_sym.expressions import over
from algebroproj_sym.expressions.provenance import Made

Rows: TypeAlias = tuple[tuple[Term, ...], ...]
MOST_PARTS = 30_000


@dataclass(frozen=True)
class Definition:
    """A definition of Coq: its name, its variables, and its text."""

    name: str
    variables: tuple[str, ...]
    text: str

    @property
    def command(self) -> str:
        """The command that makes it."""
        bound = f" ({' '.join(map(identifier, self.variables))} : R)" if self.variables else ""
        return f"Definition {self.name}{bound} :=\n  {self.text}."


@dataclass(frozen=True)
class Piece:
    """A value: as Coq's text, as formulas, and with the variables that occur in the text.

    Attributes
    ----------
    text : str
        In parentheses, or a single word.
    rows : tuple of tuple of Term
        The entries; of a scalar one.
    variables : frozenset of str
    scalar : bool
    made : bool
        Whether some operation made it, other than writing its entries down.
    """

    text: str
    rows: Rows
    variables: frozenset[str]
    scalar: bool
    made: bool


@dataclass(frozen=True)
class Object:
    """What a claim is about: its definitions in order, and the derived form in their terms."""

    definitions: tuple[Definition, ...]
    text: str
    rows: Rows
    variables: frozenset[str]
    scalar: bool


class Workshop:
    """The objects of a section.

    Parameters
    ----------
    called : mapping of Made to str
        What the derivation calls its objects.
    """

    def __init__(self, called: Mapping[Made, str]) -> None:
        self.called = called
        self.pieces: dict[Made, Piece] = {}
        self.defined: dict[Made, Definition] = {}
        self.taken: set[str] = set()

    def object(self, made: Made) -> Object | None:
        """Return what a claim is about, None if nothing but its entries is known."""
        piece = self.piece(made)
        if not piece.made:
            return None
        order: dict[Made, None] = {}
        self._collect(made, order, set())
        return Object(
            tuple(self.defined[step] for step in order), piece.text, piece.rows, piece.variables, piece.scalar
        )

    def _collect(self, made: Made, order: dict[Made, None], met: set[Made]) -> None:
        if made in met:
            return
        met.add(made)
        for part in _operands(made):
            self._collect(part, order, met)
        if made in self.defined:
            order[made] = None

    def piece(self, made: Made) -> Piece:
        """Return a value, after defining it if it has a name."""
        if made not in self.pieces:
            found = self._made(made)
            if size([entry for row in found.rows for entry in row]) > MOST_PARTS:
                raise NotExportable("the steps are too many to be written out")
            self.pieces[made] = self._named(made, found) if made in self.called and found.made else found
        return self.pieces[made]

    def _named(self, made: Made, piece: Piece, wanted: str = "") -> Piece:
        called = identifier(f"the_{wanted or self.called[made]}")
        while called in self.taken:
            called += "'"
        self.taken.add(called)
        variables = tuple(sorted(piece.variables))
        self.defined[made] = Definition(called, variables, piece.text.removeprefix("(").removesuffix(")"))
        return Piece(_applied(called, map(identifier, variables)), piece.rows, piece.variables, piece.scalar, True)

    def _made(self, made: Made) -> Piece:
        if made.operation == "scalar":
            return self._scalar(made)
        if made.operation == "entries":
            return self._entries(made)
        if made.operation == "substituted":
            return self._substituted(made)
        if made.operation.startswith("system"):
            return self._system(made)
        if made.operation == "part":
            return self._part(made)
        parts = [
            self.piece(operand if isinstance(operand, Made) else Made("scalar", (), sympy.sympify(operand)))
            for operand in made.operands
        ]
        return _OPERATIONS[made.operation](*parts)

    def _scalar(self, made: Made) -> Piece:
        known: dict[Any, Term] = {}
        parts = {}
        for place, (value, reference) in enumerate(made.operands):
            piece = self.piece(reference)
            if piece.made:
                known[value] = name(f"part{place}_")
                parts[f"part{place}_"] = piece
        term = _term(made.value, known)
        text = formula(term)
        for called in sorted(parts, key=len, reverse=True):
            text = text.replace(identifier(called), parts[called].text)
        (entry,) = substituted([term], {called: piece.rows[0][0] for called, piece in parts.items()})
        variables = frozenset(names([term])) - parts.keys()
        for piece in parts.values():
            variables |= piece.variables
        return Piece(f"({text})", ((entry,),), variables, scalar=True, made=bool(parts))

    def _entries(self, made: Made) -> Piece:
        (height, width), *operands = made.operands
        if not height or not width:
            raise NotExportable("a matrix has no entries")
        parts = [self.piece(operand) for operand in operands]
        rows = [parts[start : start + width] for start in range(0, len(parts), width)]
        text = listed([listed([part.text.removeprefix("(").removesuffix(")") for part in row]) for row in rows])
        return Piece(
            text,
            tuple(tuple(part.rows[0][0] for part in row) for row in rows),
            frozenset().union(*(part.variables for part in parts)),
            scalar=False,
            made=any(part.made for part in parts),
        )

    def _substituted(self, made: Made) -> Piece:
        whole, pairs = made.operands
        piece = self.piece(whole)
        values = {old: self.piece(new) for old, new in pairs if old in piece.variables}
        if not values:
            return piece
        if whole not in self.defined:
            if not piece.made:
                self.pieces[whole] = piece = self._named(whole, piece, self.called.get(whole, "entries"))
            else:
                self.pieces[whole] = piece = self._named(whole, piece, self.called.get(whole, "step"))
        definition = self.defined[whole]
        arguments = [values[v].text if v in values else identifier(v) for v in definition.variables]
        variables = (piece.variables - values.keys()).union(*(value.variables for value in values.values()))
        return Piece(
            _applied(definition.name, arguments),
            _replaced(piece.rows, {old: value.rows[0][0] for old, value in values.items()}),
            frozenset(variables),
            piece.scalar,
            made=True,
        )

    def _system(self, made: Made) -> Piece:
        """Linear equations at zero and at units."""
        forms, unknowns = made.operands
        piece = self.piece(forms)
        if forms not in self.defined:
            self.pieces[forms] = piece = self._named(forms, piece, self.called.get(forms, "equations"))
        definition = self.defined[forms]

        def at(unknown: str | None) -> Piece:
            values = {v: integer(int(v == unknown)) for v in unknowns}
            arguments = [formula(values[v]) if v in values else identifier(v) for v in definition.variables]
            variables = piece.variables - values.keys()
            return Piece(_applied(definition.name, arguments), _replaced(piece.rows, values), variables, False, True)

        at_zero, at_units = at(None), [at(unknown) for unknown in unknowns]
        if made.operation == "system right side":
            return _OPERATIONS["negated"](at_zero)
        columns = [_flat(_difference(unit.rows, at_zero.rows)) for unit in at_units]
        text = f"(system_matrix {at_zero.text} {listed([unit.text for unit in at_units])})"
        return Piece(text, _transposed(tuple(columns)), at_zero.variables, False, True)

    def _part(self, made: Made) -> Piece:
        whole, key = made.operands
        piece = self.piece(whole)
        height, width = len(piece.rows), len(piece.rows[0])
        if not isinstance(key, tuple):
            key = divmod(range(height * width)[int(key)], width)
        rows, columns = (
            [*range(count)[k]] if isinstance(k, slice) else k for k, count in zip(key, (height, width), strict=True)
        )
        if not isinstance(rows, list) and not isinstance(columns, list):
            i, j = range(height)[int(rows)], range(width)[int(columns)]
            entry = piece.rows[i][j]
            if not piece.made:
                return Piece(f"({formula(entry)})", ((entry,),), frozenset(names([entry])), True, False)
            return Piece(f"(entry {piece.text} {i} {j})", ((entry,),), piece.variables, scalar=True, made=True)
        rows = [range(height)[int(k)] for k in (rows if isinstance(rows, list | tuple) else [rows])]
        columns = [range(width)[int(k)] for k in (columns if isinstance(columns, list | tuple) else [columns])]
        chosen = tuple(tuple(piece.rows[i][j] for j in columns) for i in rows)
        places = " ".join(f"{listed([*map(str, part)])}%nat" for part in (rows, columns))
        return Piece(f"(part {piece.text} {places})", chosen, piece.variables, scalar=False, made=piece.made)


def _operands(made: Made) -> list[Made]:
    found: list[Made] = []
    waiting: list[Any] = [*made.operands]
    while waiting:
        value = waiting.pop(0)
        if isinstance(value, Made):
            found.append(value)
        elif isinstance(value, tuple):
            waiting = [*value, *waiting]
    return found


def _applied(called: str, arguments: Any) -> str:
    spelled = " ".join(arguments)
    return f"({called} {spelled})" if spelled else called


def _term(value: Any, known: Mapping[Any, Term]) -> Term:
    """Return an expression of SymPy as a term."""
    if value in known:
        return known[value]
    if isinstance(value, sympy.Rational):
        return number(Fraction(int(value.p), int(value.q)))
    if isinstance(value, sympy.Symbol):
        return name(value.name)
    if isinstance(value, sympy.Pow) and value.exp.is_Integer:
        return power(_term(value.base, known), int(value.exp))
    parts = [_term(part, known) for part in value.args]
    if isinstance(value, sympy.Add):
        return total(parts)
    if isinstance(value, sympy.Mul):
        return negative(product(parts[1:])) if value.args[0] == -1 else product(parts)
    if isinstance(value, over):
        return quotient(*parts)
    raise NotExportable("an operation has no counterpart")


def _replaced(rows: Rows, values: Mapping[str, Term]) -> Rows:
    entries = iter(substituted(_flat(rows), values))
    return tuple(tuple(next(entries) for _ in row) for row in rows)


def _flat(rows: Rows) -> tuple[Term, ...]:
    return tuple(entry for row in rows for entry in row)


def _transposed(rows: Rows) -> Rows:
    return tuple(zip(*rows, strict=True))


def _zipped(join: Callable[[Term, Term], Term], a: Rows, b: Rows) -> Rows:
    return tuple(tuple(join(x, y) for x, y in zip(u, v, strict=True)) for u, v in zip(a, b, strict=True))


def _difference(a: Rows, b: Rows) -> Rows:
    return _zipped(lambda x, y: total([x, negative(y)]), a, b)


def dot(u: Sequence[Term], v: Sequence[Term]) -> Term:
    """Return the sum of products as the lemmas compute it."""
    found = integer(0)
    for a, b in reversed([*zip(u, v, strict=True)]):
        found = total([product([a, b]), found])
    return found


def _without(k: int, items: Sequence[Any]) -> tuple[Any, ...]:
    return (*items[:k], *items[k + 1 :])


def _determinant(rows: Rows) -> Term:
    if not rows:
        return integer(1)
    if len(rows) > 5:
        raise NotExportable("the steps are too many to be written out")
    first, *rest = rows
    found = integer(0)
    for k in reversed(range(len(first))):
        term = product([first[k], _determinant(tuple(_without(k, row) for row in rest))])
        found = total([negative(term) if k % 2 else term, found])
    return found


def _adjugate(rows: Rows) -> Rows:
    def cofactor(i: int, j: int) -> Term:
        minor = _determinant(tuple(_without(j, row) for row in _without(i, rows)))
        return minor if (i + j) % 2 == 0 else negative(minor)

    return tuple(tuple(cofactor(i, j) for i in range(len(rows))) for j in range(len(rows)))


def _solution(rows: Rows, right: Sequence[Term]) -> Rows:
    below = _determinant(rows)

    def above(j: int) -> Term:
        return _determinant(tuple((*row[:j], x, *row[j + 1 :]) for row, x in zip(rows, right, strict=True)))

    return tuple((quotient(above(j), below),) for j in range(len(rows)))


def _cross(a: Sequence[Term], b: Sequence[Term]) -> Rows:
    def entry(i: int, j: int) -> tuple[Term]:
        return (total([product([a[i], b[j]]), negative(product([a[j], b[i]]))]),)

    return entry(1, 2), entry(2, 0), entry(0, 1)


def _called(function: str, compute: Callable[..., Any], scalar: bool = False) -> Callable[..., Piece]:
    def make(*parts: Piece) -> Piece:
        found = compute(*(part.rows for part in parts))
        variables = frozenset().union(*(part.variables for part in parts))
        text = f"({function} {' '.join(part.text for part in parts)})"
        return Piece(text, ((found,),) if scalar else found, variables, scalar, made=True)

    return make


def _times(a: Piece, b: Piece) -> Piece:
    if a.scalar or b.scalar:
        k, m = (a, b) if a.scalar else (b, a)
        return _called("scaled", lambda u, v: tuple(tuple(product([u[0][0], x]) for x in row) for row in v))(k, m)
    return _called("product", lambda u, v: tuple(tuple(dot(row, column) for column in _transposed(v)) for row in u))(
        a, b
    )


def _columns(*parts: Piece) -> Piece:
    *others, found = parts
    for other in reversed(others):
        found = _OPERATIONS["beside"](other, found)
    return found


_OPERATIONS: Mapping[str, Callable[..., Piece]] = {
    "plus": _called("sum", lambda a, b: _zipped(lambda x, y: total([x, y]), a, b)),
    "minus": _called("difference", _difference),
    "negated": _called("negated", lambda a: tuple(tuple(map(negative, row)) for row in a)),
    "times": _times,
    "divided": _called("divided", lambda a, k: tuple(tuple(quotient(x, k[0][0]) for x in row) for row in a)),
    "transposed": _called("transposed", _transposed),
    "beside": _called("beside", lambda a, b: tuple((*u, *v) for u, v in zip(a, b, strict=True))),
    "above": _called("stacked", lambda a, b: (*a, *b)),
    "columns": _columns,
    "dot": _called("scalar_product", lambda a, b: dot(_flat(a), _flat(b)), scalar=True),
    "cross": _called("cross_product", lambda a, b: _cross(_flat(a), _flat(b))),
    "determinant": _called("determinant", _determinant, scalar=True),
    "adjugate": _called("adjugate", _adjugate),
    "inverse": _called(
        "inverse", lambda a: tuple(tuple(quotient(x, _determinant(a)) for x in row) for row in _adjugate(a))
    ),
    "solve": _called("solution", lambda a, b: _solution(a, _flat(b))),
}

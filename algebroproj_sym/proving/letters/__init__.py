"""Deciding statements about vectors and matrices as letters: in words, which hold for every size, or by entries."""

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import sympy

from algebroproj_sym.expressions import SymbolError, assumed, is_plain
from algebroproj_sym.expressions.letters import (
    LetterError,
    Reading,
    Shape,
    Size,
    Term,
    letters_text,
    made,
    minus,
    number,
    parse_letters,
)
from algebroproj_sym.proving.engines import ENGINES
from algebroproj_sym.proving.letters.candidates import Point
from algebroproj_sym.proving.letters.deciding import Found, decide
from algebroproj_sym.proving.letters.derivatives import without_derivatives
from algebroproj_sym.proving.letters.properties import PROPERTIES, Letter, declared_letters
from algebroproj_sym.proving.letters.statements import Statement
from algebroproj_sym.proving.letters.words import Algebra, NotWordsError
from algebroproj_sym.proving.polynomials import EffortExceededError
from algebroproj_sym.proving.proof import Proof

__all__ = [
    "PROPERTIES",
    "Found",
    "Point",
    "are_same",
    "declared_in",
    "prove_letters",
    "prove_texts",
    "require_statement",
    "shape_in_text",
    "worked_out",
]

_DECLARED = re.compile(r"([0-9]+|[a-wyz])x([0-9]+|[a-wyz])(?: (.+))?")


def prove_letters(
    lhs: Any,
    rhs: Any,
    *,
    constraints: Sequence[Any] = (),
    nonzero: Sequence[Any] = (),
    properties: Mapping[Any, Any] | None = None,
    engine: str = "flint",
) -> Proof:
    """Decide whether two sides are equal wherever both are defined and all letters have their properties.

    The arguments are those of `algebroproj_sym.prove`; a number 0 stands for a zero matrix, and `PROPERTIES` are what
    letters may be.  It raises `LetterError` if shapes do not fit, a property is unknown, or a name is not declared.  It
    raises `UndefinedError` if what is inverted has no inverse anywhere.  It raises `ValueError` if the engine is
    unknown.
    """
    if engine not in ENGINES:
        raise ValueError(f"engine: expected one of {', '.join(ENGINES)}, got {engine!r}")
    reading = Reading()
    sides = [reading.term(side, name) for side, name in ((lhs, "lhs"), (rhs, "rhs"))]
    zeros = [reading.term(term, f"constraints[{place}]") for place, term in enumerate(constraints)]
    units = [reading.term(term, f"nonzero[{place}]") for place, term in enumerate(nonzero)]
    shapes = _shapes(reading)
    statement = _statement(sides, zeros, units, shapes, _named(properties or {}, reading), reading.scalars)
    found = decide(statement, engine)
    try:
        stated = assumed(reading.scalars.values(), "symbols")
    except SymbolError as error:
        raise LetterError(str(error)) from error
    return Proof(
        found.verdict,
        tuple(map(reading.expression, found.hypotheses)),
        found.certificate,
        None if found.point is None else _by_symbol(found.point, reading.letters, reading.scalars),
        engine,
        tuple(symbol for symbol in stated if not is_plain(symbol)),
        found.scope,
    )


def prove_texts(
    lhs: str,
    rhs: str,
    letters: Mapping[str, str],
    *,
    constraints: Sequence[str] = (),
    nonzero: Sequence[str] = (),
    engine: str = "flint",
) -> Proof:
    """Decide a statement that is given as text, with letters such as ``{"R": "3x3 rotation", "v": "nx1"}``.

    It raises `LetterError` if a text is not of the grammar, or a letter is not declared well.
    """
    if engine not in ENGINES:
        raise ValueError(f"engine: expected one of {', '.join(ENGINES)}, got {engine!r}")
    statement = _read(lhs, rhs, letters, constraints, nonzero)
    found = decide(statement, engine)
    point = None if found.point is None else _by_symbol(found.point, {}, {})
    return Proof(found.verdict, found.conditions, found.certificate, point, engine, (), found.scope)


def worked_out(lhs: str, rhs: str, letters: Mapping[str, str]) -> str:
    """Return an equation as text in which derivatives are worked out, so that it may be a constraint.

    Examples
    --------
    >>> worked_out("diff(dot(x, x), x, d)", "0", {"x": "nx1", "d": "nx1"})
    'dot(d, x) + dot(x, d) = 0'
    """
    found = without_derivatives(_read(lhs, rhs, letters, (), ()))
    return f"{letters_text(found.left)} = {letters_text(found.right)}"


def are_same(one: str, other: str, letters: Mapping[str, str]) -> bool:
    """Whether two texts have the same normal form in words.

    Examples
    --------
    >>> are_same("3/2*trace(A.T*A)", "3*(1/2*trace(A*A.T))", {"A": "nxn"})
    True
    """
    statement = _read(one, other, letters, (), ())
    try:
        algebra = Algebra(statement.letters)
        return algebra.poly(statement.left) == algebra.poly(statement.right)
    except (NotWordsError, EffortExceededError):
        return False


def _read(
    lhs: str, rhs: str, letters: Mapping[str, str], constraints: Sequence[str], nonzero: Sequence[str]
) -> Statement:
    declared = {name: _declared(name, text) for name, text in letters.items()}
    shapes = {name: shape for name, (shape, _) in declared.items()}
    sides = [_parsed(text, shapes, argument) for argument, text in (("lhs", lhs), ("rhs", rhs))]
    zeros = [_difference(text, shapes, f"constraints[{place}]") for place, text in enumerate(constraints)]
    units = [_parsed(text, shapes, f"nonzero[{place}]") for place, text in enumerate(nonzero)]
    return _statement(sides, zeros, units, shapes, {name: listed for name, (_, listed) in declared.items()}, {})


def _parsed(text: Any, shapes: Mapping[str, Shape], argument: str) -> Term:
    if not isinstance(text, str):
        raise LetterError(f"{argument}: expected text, because letters are declared by name, got {text!r:.80}")
    return parse_letters(text, shapes, argument)


def require_statement(
    lhs: str, rhs: str, letters: Mapping[str, str], constraints: Sequence[str] = (), nonzero: Sequence[str] = ()
) -> None:
    """Reject a statement in letters that is not well formed; one that is may be asked, see `prove_texts`."""
    _read(lhs, rhs, letters, constraints, nonzero)


def declared_in(reading: Reading, properties: Mapping[Any, Any]) -> dict[str, str]:
    """Return what the letters that were read are, as text, in the order of their names.

    Examples
    --------
    >>> reading, R = Reading(), sympy.MatrixSymbol("R", 3, 3)
    >>> _ = reading.term(R.T, "lhs")
    >>> declared_in(reading, {R: "rotation"})
    {'R': '3x3 rotation'}
    """
    shapes, named = _shapes(reading), _named(properties, reading)
    declared_letters(shapes, named)
    found = {}
    for name, (rows, columns) in sorted(shapes.items()):
        given = named.get(name, ())
        listed = given if isinstance(given, str) else ", ".join(given)
        found[name] = f"{rows}x{columns}" + (f" {listed}" if listed else "")
    return found


def shape_in_text(name: str, text: str) -> Shape:
    """Return the shape of a letter that is declared as text."""
    return _declared(name, text)[0]


def letter_in_text(name: str, text: str) -> Letter:
    """Return a letter that is declared as text.

    Examples
    --------
    >>> letter_in_text("R", "3x3 rotation").shape
    (3, 3)
    """
    shape, listed = _declared(name, text)
    return declared_letters({name: shape}, {name: listed})[name]


def _shapes(reading: Reading) -> dict[str, Shape]:
    return {name: Reading().term(letter, name).shape for name, letter in reading.letters.items()}


def _declared(name: str, text: str) -> tuple[Shape, tuple[str, ...]]:
    match = _DECLARED.fullmatch(text) if isinstance(text, str) else None
    if match is None:
        raise LetterError(f"letters, {name}: expected a shape and properties such as '3x3 rotation', got {text!r}")
    rows, columns, listed = match.groups()
    return (_size(rows), _size(columns)), tuple(listed.split(", ")) if listed else ()


def _size(text: str) -> Size:
    return int(text) if text.isdecimal() else text


def _difference(text: Any, shapes: Mapping[str, Shape], argument: str) -> Term:
    left, equal, right = text.partition("=") if isinstance(text, str) else (text, "", "")
    first = _parsed(left, shapes, argument)
    if not equal:
        return first
    second = parse_letters(right, shapes, argument)
    if second == number(0):
        return first
    return minus(first, second)


def _statement(
    sides: Sequence[Term],
    zeros: Sequence[Term],
    units: Sequence[Term],
    shapes: Mapping[str, Shape],
    properties: Mapping[str, Any],
    scalars: Mapping[str, sympy.Symbol],
) -> Statement:
    left, right = (
        made("zeros", value=other.shape) if side == number(0) and other.shape != (1, 1) else side
        for side, other in (sides, [*reversed(sides)])
    )
    if left.shape != right.shape:
        shown = " and ".join(f"{side.shape[0]}x{side.shape[1]}" for side in (left, right))
        raise LetterError(f"prove: expected two sides of one shape, got {shown}")
    if any(unit.shape != (1, 1) for unit in units):
        raise LetterError("nonzero: expected numbers, got a matrix")
    statement = Statement(left, right, declared_letters(shapes, properties), (*zeros,), (*units,), scalars)
    both = sorted(statement.letters.keys() & {*statement.size_names})
    if both:
        raise LetterError(f"letters: expected another name than that of a size, got {both[0]}")
    return statement


def _named(properties: Mapping[Any, Any], reading: Reading) -> dict[str, Any]:
    """Return properties by name."""
    if not isinstance(properties, Mapping):
        raise LetterError(f"properties: expected a mapping of letters to properties, got {type(properties).__name__}")
    found = {}
    for letter, given in properties.items():
        name = letter if isinstance(letter, str) else str(getattr(letter, "name", ""))
        if not isinstance(letter, str) and reading.letters.get(name) != letter:
            known = ", ".join(sorted(reading.letters)) or "none"
            raise LetterError(f"properties: expected letters that occur ({known}), got {letter}")
        found[name] = given
    return found


def _by_symbol(
    point: Point, letters: Mapping[str, sympy.MatrixSymbol], scalars: Mapping[str, sympy.Symbol]
) -> dict[Any, Any]:
    """Return a point by symbol: matrices for letters, fractions for numbers, integers for sizes."""
    matrices = {
        letters.get(name, sympy.MatrixSymbol(name, len(rows), len(rows[0]))): sympy.ImmutableMatrix(
            [[_number(point.shown(name, entry)) for entry in row] for row in rows]
        )
        for name, rows in point.letters.items()
    }
    numbers = {name: point.shown(name, value) for name, value in point.scalars.items()} | dict(point.sizes)
    return matrices | {scalars.get(name, sympy.Symbol(name)): value for name, value in numbers.items()}


def _number(value: Any) -> Any:
    return sympy.Rational(value.numerator, value.denominator) if isinstance(value, Fraction) else value

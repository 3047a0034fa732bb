"""Decide whether two rational expressions are equal wherever they are defined and what is assumed holds.

Without constraints the normal form in Q(x1, ..., xn) decides.  With constraints a proof has a witness: a point that
satisfies constraints and hypotheses, so that neither inconsistent constraints nor a denominator that vanishes on them
can prove anything.  A refutation is an exact point at which both sides are defined and differ.
What SymPy assumes of symbols is left out of proofs, except that what is not zero does not vanish; a point satisfies it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import islice
from typing import Any

import sympy

from algebroproj_sym.expressions import (
    Expression,
    admits,
    assumed,
    evaluate,
    free_symbols,
    is_plain,
    parse,
    rational,
    shape,
    symbols_of,
    text,
    values_of,
    written,
)
from algebroproj_sym.expressions.exact import fmpq
from algebroproj_sym.proving.constrained import NO_POINT, Problem
from algebroproj_sym.proving.engines import ENGINES
from algebroproj_sym.proving.points import Point, rational_points, seed_of, vanish
from algebroproj_sym.proving.proof import Proof, UndefinedError, undecided
from algebroproj_sym.proving.rational_function import RationalFunction, RationalFunctionField

FILTER_POINTS = 3
SEARCH_POINTS = 400
FILLINGS = 100

Witness = Mapping[sympy.Symbol, Fraction | int] | Mapping[str, Fraction | int | str]


def prove(
    lhs: Any,
    rhs: Any,
    *,
    constraints: Sequence[Any] = (),
    nonzero: Sequence[Any] = (),
    witness: Witness | None = None,
    engine: str = "flint",
    assumptions: Sequence[sympy.Symbol] = (),
) -> Proof:
    """Decide whether two rational expressions are equal, with the arguments and errors of `algebroproj_sym.prove`.

    They are not text here, and symbols that are listed as assumptions stand for the plain ones of their names.  With
    constraints the verdict may be ``"open"``; without them it never is for lack of a method.  It is open where no point
    satisfies constraints, hypotheses and assumptions: anything is true there.
    """
    if engine not in ENGINES:
        raise ValueError(f"engine: expected one of {', '.join(ENGINES)}, got {engine!r}")
    left, right = rational(lhs, "lhs", assuming=True), rational(rhs, "rhs", assuming=True)
    if shape(left) != shape(right):
        raise ValueError(f"prove: expected two sides of one shape, got {shape(left)} and {shape(right)}")
    given = tuple(_scalar(expression, "constraints") for expression in constraints)
    units = tuple(_scalar(expression, "nonzero") for expression in nonzero)
    question = _question(left, right, given, units, witness, engine, assumptions)
    proof = _decided(question)
    return replace(proof, assumptions=tuple(question.assumed.values())) if question.assumed else proof


def _question(
    left: Expression,
    right: Expression,
    constraints: Sequence[sympy.Expr],
    nonzero: Sequence[sympy.Expr],
    witness: Witness | None,
    engine: str,
    assumptions: Sequence[sympy.Symbol],
) -> _Question:
    """Put plain symbols for those with assumptions, of which those that are not zero do not vanish."""
    symbols = {symbol for form in (left, right, *constraints, *nonzero) for symbol in free_symbols(form)}
    others = [symbol for symbol in assumptions if symbol.name in {symbol.name for symbol in symbols}]
    named = {symbol.name for symbol in others}
    plain = assumed([*others, *(s for s in symbols if s.name not in named or not is_plain(s))], "symbols")
    if any(symbol != kept for symbol, kept in plain.items()):
        left, right, *rest = (form.xreplace(plain) for form in (left, right, *constraints, *nonzero))
        constraints, nonzero = rest[: len(constraints)], rest[len(constraints) :]
    stated = {kept: symbol for symbol, kept in plain.items() if not is_plain(symbol)}
    implied = [kept for kept, symbol in stated.items() if symbol.is_zero is False and kept not in nonzero]
    point = None if witness is None else _witness(witness)
    return _Question(left, right, tuple(constraints), (*nonzero, *implied), point, engine, stated)


def _decided(question: _Question) -> Proof:
    given = question.given_witnesses() if question.constraints else []
    reason = _contradiction(question)
    if reason is not None:
        return undecided(reason, question.engine)
    return _prove_constrained(question, given) if question.constraints else _prove_identity(question)


def _contradiction(question: _Question) -> str | None:
    """Return why some condition holds at no point; None if each may hold."""
    if not question.constraints and not question.nonzero:
        return None
    field = RationalFunctionField(question.symbols, question.engine)
    for argument, conditions in {"constraints": question.constraints, "nonzero": question.nonzero}.items():
        for place, condition in enumerate(conditions):
            try:
                numerator = _numerator(field, condition)
            except ZeroDivisionError:
                return f"{argument}[{place}] has a denominator that is always zero, so it is defined at no point"
            powers = list(field.ring.terms(numerator))
            if argument == "nonzero" and not powers:
                return f"nonzero[{place}] is always zero, so no point satisfies the conditions"
            if argument == "constraints" and powers and not any(map(any, powers)):
                return f"constraints[{place}] is never zero, so no point satisfies the conditions"
    return None


def _scalar(value: Any, argument: str) -> sympy.Expr:
    expression = rational(value, argument, assuming=True)
    if shape(expression) != ():
        raise ValueError(f"{argument}: expected scalars, got a matrix of shape {shape(expression)}")
    return expression


@dataclass(frozen=True)
class _Question:
    left: Expression
    right: Expression
    constraints: tuple[sympy.Expr, ...]
    nonzero: tuple[sympy.Expr, ...]
    witness: Point | None
    engine: str
    assumed: Mapping[sympy.Symbol, sympy.Symbol]
    """The symbols with assumptions, by the plain ones."""

    @property
    def values(self) -> Mapping[sympy.Symbol, Sequence[Fraction]]:
        """The numbers from which the values of a symbol are taken, where its assumptions restrict them."""
        return {plain: values_of(symbol) for plain, symbol in self.assumed.items()}

    def admits(self, point: Mapping[sympy.Symbol, Any]) -> bool:
        """Whether a point satisfies the assumptions."""
        return all(admits(symbol, point[plain]) for plain, symbol in self.assumed.items())

    @property
    def symbols(self) -> tuple[sympy.Symbol, ...]:
        return symbols_of((self.left, self.right, *self.constraints, *self.nonzero))

    @property
    def seed(self) -> int:
        return seed_of(text(self.left), text(self.right), *map(written, self.constraints))

    def differs_at(self, point: Point) -> bool | None:
        """Whether the sides differ at a point; None where a side is undefined or a hypothesis or assumption fails."""
        if not self.admits(point):
            return None
        at = {symbol: fmpq(value) for symbol, value in point.items()}
        try:
            if any(evaluate(unit, at, fmpq)[0] == 0 for unit in self.nonzero):
                return None
            return evaluate(self.left, at, fmpq) != evaluate(self.right, at, fmpq)
        except ZeroDivisionError:
            return None

    def points(self) -> Iterator[Point]:
        """Yield points of the whole space."""
        return islice(rational_points(self.symbols, self.seed, self.values), SEARCH_POINTS)

    def given_witnesses(self) -> list[Point]:
        """Return points with the given coordinates, if there are any, at which hypotheses hold; others are random."""
        if self.witness is None:
            return []
        found = list[Point]()
        for place, filling in enumerate(islice(rational_points(self.symbols, self.seed, self.values), FILLINGS)):
            point = filling | self.witness
            wrong = next((constraint for constraint in self.constraints if not vanish([constraint], point)), None)
            if wrong is not None and place == 0:
                raise ValueError(f"witness: expected a point with {wrong} = 0, got {dict(self.witness)}")
            if wrong is None and self.differs_at(point) is not None:
                found.append({symbol: point[symbol] for symbol in self.symbols})
            if self.witness.keys() >= {*self.symbols}:
                break
        return found


def _witness(given: Witness) -> Point:
    if not isinstance(given, Mapping):
        raise TypeError(f"witness: expected a mapping of symbols to numbers, got {type(given).__name__}")
    point: Point = {}
    for key, value in given.items():
        if not isinstance(key, str | sympy.Symbol):
            raise TypeError(f"witness: expected symbols or their names as keys, got {key!r}")
        name = key if isinstance(key, str) else key.name
        if sympy.Symbol(name) in point:
            raise ValueError(f"witness: expected one value for {name}, got two")
        point[sympy.Symbol(name)] = _exact(value, f"witness, {name}")
    return point


def _exact(value: Any, argument: str) -> Fraction:
    number = parse(value, argument) if isinstance(value, str) else rational(value, argument)
    if not isinstance(number, sympy.Rational):
        raise ValueError(f"{argument}: expected an exact number, got {value!r}")
    return Fraction(int(number.p), int(number.q))


def _prove_identity(question: _Question) -> Proof:
    first = islice(rational_points(question.symbols, 0, question.values), FILTER_POINTS)
    suspicious = next(filter(question.differs_at, first), None)
    if suspicious is not None:
        return _refuted(question, _first_difference(question, SEARCH_POINTS) or suspicious)
    field, difference = _normal_form(question)
    if all(entry.is_zero for entry in difference):
        if question.assumed and all(question.differs_at(point) is None for point in question.points()):
            return undecided(NO_POINT, question.engine, field.divisors())
        certificate = {"method": "normal form", "denominators": [text(factor) for factor in field.divisors()]}
        return Proof("proved", field.divisors(), certificate, None, question.engine)
    refuting = _first_difference(question, SEARCH_POINTS)
    if refuting is not None:
        return _refuted(question, refuting)
    reason = "the normal form is not zero, but no counterexample was found"
    return undecided(reason, question.engine, field.divisors())


def _prove_constrained(question: _Question, given: Sequence[Point]) -> Proof:
    field, difference = _normal_form(question)
    return Problem(
        field=field,
        left=question.left,
        right=question.right,
        numerators=[field.primitive(entry.numerator) for entry in difference],
        constraints=[field.primitive(_numerator(field, constraint)) for constraint in question.constraints],
        nonzero=[_numerator(field, unit) for unit in question.nonzero],
        seed=question.seed,
        given=given,
        admits=question.admits,
        engine=question.engine,
    ).decided()


def _normal_form(question: _Question) -> tuple[RationalFunctionField, list[RationalFunction]]:
    field = RationalFunctionField(question.symbols, question.engine)
    try:
        left = evaluate(question.left, field.variables, field.lift)
        right = evaluate(question.right, field.variables, field.lift)
    except ZeroDivisionError:
        raise UndefinedError(
            f"prove: expected expressions with denominators that are not identically zero, "
            f"got {text(question.left)} and {text(question.right)}"
        ) from None
    return field, [a - b for a, b in zip(left, right, strict=True)]


def _numerator(field: RationalFunctionField, expression: sympy.Expr) -> Any:
    return evaluate(expression, field.variables, field.lift)[0].numerator


def _first_difference(question: _Question, tries: int) -> Point | None:
    return next(filter(question.differs_at, islice(question.points(), tries)), None)


def _refuted(question: _Question, point: Point) -> Proof:
    certificate = {
        "method": "counterexample",
        "left": [str(fmpq(value)) for value in evaluate(question.left, point)],
        "right": [str(fmpq(value)) for value in evaluate(question.right, point)],
    }
    used = {symbol: point[symbol] for symbol in question.symbols}
    return Proof("refuted", (), certificate, used, question.engine)

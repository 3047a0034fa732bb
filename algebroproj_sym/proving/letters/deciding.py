"""Decide a statement in letters: by exact matrices, then in the algebra of words, then entry by entry.

A refutation is exact matrices that have every property and at which the sides differ.  A proof in words holds for every
size.  A proof by entries holds for the sizes that are given.  With either goes a witness: matrices at which both sides
are defined, so that nothing is proved about nothing.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from itertools import count, islice, product
from typing import Any

from algebroproj_sym.expressions import admits, is_plain, text
from algebroproj_sym.expressions.letters import Term, factors_of, letters_text
from algebroproj_sym.proving.buchberger import Work
from algebroproj_sym.proving.letters.candidates import ENOUGH_POINTS, SPARSE_TRIES, Candidates, Point
from algebroproj_sym.proving.letters.derivatives import without_derivatives
from algebroproj_sym.proving.letters.entries import Field, Rows, degree_of, entries_of
from algebroproj_sym.proving.letters.expansion import Expansion
from algebroproj_sym.proving.letters.points import NUMBERS, example, has_properties
from algebroproj_sym.proving.letters.rewriting import Proof, proof_in_words
from algebroproj_sym.proving.letters.rules import rules_for
from algebroproj_sym.proving.letters.series import speaks_of_angles, without_series
from algebroproj_sym.proving.letters.statements import Statement, hypotheses_of, without_definitions, without_lengths
from algebroproj_sym.proving.letters.turns import Turn
from algebroproj_sym.proving.letters.words import Algebra, NotWordsError
from algebroproj_sym.proving.polynomials import EffortExceededError
from algebroproj_sym.proving.proof import Decision, UndefinedError
from algebroproj_sym.proving.prove import prove as decided
from algebroproj_sym.proving.rational_function import RationalFunction, RationalFunctionField

LARGEST_TURN = 3
MOST_DEGREE = 20
FIRST_TRIES = 40
MORE_TRIES = 200
MOST_PRODUCTS = 50_000_000
MOST_TERMS = 50_000
MOST_EVALUATED = 500_000
"""How long a difference may be that is compared with constraints; how many products the points of a search may take."""

NOWHERE = "no exact matrices were found at which both sides are defined and all conditions hold"


@dataclass(frozen=True)
class Found:
    """What became of a statement."""

    verdict: Decision
    """The decision."""
    certificate: Mapping[str, Any]
    """The evidence, or why there is none."""
    scope: str = ""
    """What it holds for: ``for every size``, or some sizes."""
    point: Point | None = None
    """A counterexample."""
    hypotheses: tuple[Term, ...] = ()
    """What is not zero wherever the statement is made: determinants of what is inverted, and divisors."""

    @property
    def conditions(self) -> tuple[str, ...]:
        """The hypotheses as text."""
        return tuple(map(letters_text, self.hypotheses))


def decide(statement: Statement, engine: str = "flint") -> Found:
    """Decide a statement.

    It raises `LetterError` if a norm is not squared, or entries are needed and a letter is too large for them.  It
    raises `UndefinedError` if what is inverted has no inverse anywhere.
    """
    return _Question(statement, engine).found()


class _Question:
    def __init__(self, statement: Statement, engine: str) -> None:
        self.letters = statement.letters
        self.size_names = statement.size_names
        statement = without_lengths(statement)
        _, stated = without_definitions(statement)
        self.definitions, statement = without_definitions(without_derivatives(statement))
        parts = {part.value for term in statement.terms for part in factors_of(term) if part.kind == "letter"}
        statement = replace(
            statement, letters={name: statement.letters[name] for name in statement.letters if name in parts}
        )
        self.statement = statement
        self.engine = engine
        self.witness: Point | None = None
        self.angles, self.plain = without_series(statement) if speaks_of_angles(statement) else ([], statement)
        shown = statement if self.angles else stated
        self.candidates = Candidates(statement, shown, self.angles, self.letters, self.definitions, self.size_names)
        self.hypotheses = hypotheses_of(statement.terms, statement.letters)

    def found(self) -> Found:
        refuting = self._differing(self.candidates.sparse(), SPARSE_TRIES)
        refuting = refuting or self._differing(self.candidates.points(FIRST_TRIES), ENOUGH_POINTS)
        if refuting is not None:
            return self._refuted(refuting)
        found, reason = self._proof()
        if found is None:
            refuting = self._differing(self.candidates.points(MORE_TRIES), MORE_TRIES)
            return self._open(reason) if refuting is None else self._refuted(refuting)
        if self.witness is None and found.verdict == "proved":
            return self._open(NOWHERE)
        return found

    def _proof(self) -> tuple[Found | None, str]:
        """Return what words or entries decide; if they decide nothing, what was tried."""
        words = "no proof was found in words"
        try:
            if found := self._in_words():
                return found, ""
        except EffortExceededError:
            words = "a proof in words costs too much"
        if reason := self._without_entries():
            return None, f"{words}, and {reason}"
        try:
            found = self._by_entries()
        except EffortExceededError:
            return None, f"{words}, and one by entries costs too much"
        return found, f"{words}, none was found by entries, and no exact matrices at which the sides differ"

    def _without_entries(self) -> str:
        """Return why entries decide nothing; empty if they may."""
        if self.size_names:
            return "sizes with names have no entries"
        turning = [each for each in self.statement.letters.values() if "orthogonal" in each.properties]
        if any(int(letter.shape[0]) > LARGEST_TURN for letter in turning):
            return f"rotations have entries up to {LARGEST_TURN}x{LARGEST_TURN} only"
        degree = max(degree_of(side, self.letters) for side in self.plain.terms[:2])
        if self.angles and degree > MOST_DEGREE:
            return f"entries have degree {degree}: those up to {MOST_DEGREE} are tried"
        return ""

    def _open(self, reason: str) -> Found:
        return Found("open", {"method": "none", "reason": reason})

    # -- points

    def _differing(self, points: Iterator[Point], enough: int) -> Point | None:
        """Return a point at which the sides differ; the first other one is the witness."""
        count = 0
        for point in islice(points, max(ENOUGH_POINTS, MOST_EVALUATED // self.products)):
            differs = self.differs_at(point)
            if differs:
                return point
            if differs is False:
                self.witness = self.witness or point
                count += 1
                if count == enough:
                    break
        return None

    @cached_property
    def products(self) -> int:
        """About how many products of entries the sides and conditions take at a point."""
        parts = {part for term in self.statement.terms for part in factors_of(term)}
        shapes = [[size if isinstance(size, int) else 2 for size in part.shape] for part in parts]
        return sum(rows * columns * max(rows, columns) for rows, columns in shapes)

    def differs_at(self, point: Point) -> bool | None:
        """Whether the sides differ at a point; None where a condition fails or a side is undefined."""
        statement = self.statement
        if not all(has_properties(letter, point.letters[name]) for name, letter in statement.letters.items()):
            return None
        try:
            sizes = {name: Fraction(size) for name, size in point.sizes.items()}
            if not all(self._admits(*each) for each in {**self._completed(point).scalars, **sizes}.items()):
                return None
            if any(entry for term in statement.constraints for row in point.value(term) for entry in row):
                return None
            if any(point.value(term) == [[0]] for term in statement.nonzero):
                return None
            left, right = map(point.value, (statement.left, statement.right))
        except (ZeroDivisionError, IndexError):
            return None
        if point.turn is not None and not self._is_exact(point.turn):
            return None
        return left != right

    def _is_exact(self, turn: Turn) -> bool:
        """Whether constraints hold at an angle if they hold with a number in its place, and nothing else is assumed."""
        scalars = self.statement.scalars
        plain = all(name not in scalars or is_plain(scalars[name]) for name in self.definitions)
        return plain and all(turn.degree(term) is not None for term in self.statement.constraints)

    def _admits(self, name: str, value: Fraction) -> bool:
        return name not in self.statement.scalars or admits(self.statement.scalars[name], value)

    def _refuted(self, point: Point) -> Found:
        shown = ([[*map(str, row)] for row in point.value(side)] for side in self.statement.terms[:2])
        certificate = {"method": "counterexample"} | dict(zip(("left", "right"), shown, strict=True))
        if point.turn is not None:
            certificate = {"method": "counterexample", "angle": str(point.turn.value)}
        return Found("refuted", certificate, self._scope(point.sizes), self._completed(point))

    def _completed(self, point: Point) -> Point:
        """Return a point with values also for what constraints define, if these are exact."""
        if point.turn is not None:
            parts = {part.value for term in self.statement.terms for part in factors_of(term) if part.kind == "symbol"}
            used = {name: value for name, value in point.scalars.items() if name in parts}
            return Point(self._with_others(point), used, point.sizes, point.turn)
        point = replace(point, letters=self._with_others(point))
        letters, scalars = dict(point.letters), dict(point.scalars)
        for name, term in self.definitions.items():
            rows = point.value(term)
            if name in self.letters:
                letters[name] = rows
            else:
                scalars[name] = rows[0][0]
        return Point(letters, scalars, point.sizes, point.turn)

    def _with_others(self, point: Point) -> dict[str, Rows]:
        """Return the letters of a point, and values of those that do not occur."""
        generator, others = random.Random(0), dict[str, Rows]()
        for name in sorted(self.letters.keys() - self.definitions.keys() - point.letters.keys()):
            tries = (example(self.letters[name], point.sizes, generator, attempt) for attempt in count())
            others[name] = next(rows for rows in tries if rows is not None)
        return {
            name: (dict(point.letters) | others)[name] for name in self.letters if name in {*point.letters, *others}
        }

    # -- proofs

    def _in_words(self) -> Found | None:
        statement = self.plain
        algebra = Algebra(statement.letters)
        try:
            claim = algebra.poly(statement.left) - algebra.poly(statement.right)
            constraints = [algebra.poly(term) for term in statement.constraints]
            rules = rules_for(algebra, [claim, algebra.poly(statement.left)], constraints)
            proof = proof_in_words(algebra, claim, rules)
        except NotWordsError:
            return None
        except ZeroDivisionError:
            raise self._undefined() from None
        if proof is None:
            return None
        scope = self._scope({}) if self._is_sized(proof) else "for every size"
        return self._proved({"method": "words"} | proof.record(algebra), scope)

    def _is_sized(self, proof: Proof) -> bool:
        """Whether the statement, or a proof of it, uses what holds for the given sizes alone."""
        algebra = Algebra(self.plain.letters)
        _, _, *constraints = map(algebra.poly, self.plain.terms[: 2 + len(self.plain.constraints)])
        proof.multiply_out(algebra, constraints)
        return algebra.is_sized

    def _proved(self, certificate: Mapping[str, Any], scope: str) -> Found:
        witness = {} if self.witness is None else {"witness": self._completed(self.witness).record()}
        angles: dict[str, Any] = {"angles": [*map(letters_text, self.angles)]} if self.angles else {}
        if self.witness is not None and self.witness.turn is not None:
            angles["angle"] = str(self.witness.turn.value)
        return Found("proved", {**certificate, **angles, "scope": scope, **witness}, scope, None, self.hypotheses)

    def _scope(self, sizes: Mapping[str, int]) -> str:
        """Return the shapes of the letters, such as ``for 3x3 and 3x1``."""
        shapes = {tuple(str(sizes.get(str(size), size)) for size in letter.shape) for letter in self.letters.values()}
        return f"for {' and '.join('x'.join(shape) for shape in sorted(shapes, reverse=True))}" if shapes else ""

    def _by_entries(self) -> Found | None:
        expansion = Expansion(self.plain)
        field = RationalFunctionField(expansion.symbols, self.engine, Work(MOST_PRODUCTS).spend)
        if expansion.equations:
            with suppress(ZeroDivisionError):
                Work(MOST_TERMS).spend(sum(len(entry.numerator) for entry in self._difference(expansion, field, {})))
            return self._constrained(expansion)
        try:
            for signs in product((1, -1), repeat=len(expansion.signs)):
                values = {name: field.lift(Fraction(s)) for name, s in zip(expansion.signs, signs, strict=True)}
                if any(not entry.is_zero for entry in self._difference(expansion, field, values)):
                    return None
        except ZeroDivisionError:
            raise self._undefined() from None
        divisors = [str(factor) for factor in field.divisors()]
        return self._proved(
            {"method": "entries", "entries": expansion.texts(), "denominators": divisors}, self._scope({})
        )

    def _difference(
        self, expansion: Expansion, field: RationalFunctionField, signs: Mapping[str, RationalFunction]
    ) -> Iterator[RationalFunction]:
        """Yield the entries of the difference of the sides."""
        numbers = Field(field.lift)
        values = {symbol.name: value for symbol, value in field.variables.items()} | dict(signs)
        letters = {k: entries_of(each.entries, {}, values, numbers) for k, each in expansion.letters.items()}
        left, right = (entries_of(side, letters, values, numbers) for side in self.plain.terms[:2])
        yield from (a - b for rows in zip(left, right, strict=True) for a, b in zip(*rows, strict=True))

    def _undefined(self) -> UndefinedError:
        texts = " and ".join(map(letters_text, self.statement.terms[:2]))
        return UndefinedError(f"prove: expected sides in which something has an inverse somewhere, got {texts}")

    def _constrained(self, expansion: Expansion) -> Found | None:
        try:
            left, right, *others = (expansion.matrix(term) for term in self.plain.terms)
        except ZeroDivisionError:
            raise self._undefined() from None
        nonzero = [unit[0] for unit in others[len(self.plain.constraints) :]]
        given = [
            symbol for symbol in self.statement.scalars.values() if symbol.name in {s.name for s in expansion.symbols}
        ]
        proof = decided(
            left, right, constraints=expansion.equations, nonzero=nonzero, engine=self.engine, assumptions=given
        )
        if proof.verdict == "refuted" and proof.counterexample is not None and not self.angles:
            values = {symbol.name: value for symbol, value in proof.counterexample.items()}
            if all(isinstance(value, Fraction) for value in values.values()):
                values |= {symbol.name: Fraction(1) for symbol in expansion.symbols if symbol.name not in values}
                letters = {k: entries_of(e.entries, {}, values, NUMBERS) for k, e in expansion.letters.items()}
                point = Point(letters, {name: values[name] for name in self.candidates.scalars}, {})
                return self._refuted(point) if self.differs_at(point) else None
        if proof.verdict != "proved":
            return None
        certificate = {
            "method": "entries",
            "entries": expansion.texts(),
            "equations": [*map(text, expansion.equations)],
            "conditions": [*map(text, nonzero)],
            "proof": self._whole(expansion, dict(proof.certificate or {})),
        }
        return self._proved(certificate, self._scope({}))

    def _whole(self, expansion: Expansion, proof: dict[str, Any]) -> dict[str, Any]:
        """Return a proof with a witness that has a value also for coordinates that cancel."""
        return proof | {"witness": dict.fromkeys(expansion.values, "1") | proof["witness"]}

"""Points at which a statement in letters may fail: random ones, and such on which its constraints hold."""

import random
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from itertools import islice
from typing import Any

import sympy

from algebroproj_sym.expressions import admits, values_of
from algebroproj_sym.expressions.letters import Term, factors_of, made, number
from algebroproj_sym.proving.buchberger import Work
from algebroproj_sym.proving.letters.entries import Rows, entries_of
from algebroproj_sym.proving.letters.expansion import Expansion
from algebroproj_sym.proving.letters.points import NUMBERS, example, sparse
from algebroproj_sym.proving.letters.properties import Letter
from algebroproj_sym.proving.letters.series import FUNCTIONS
from algebroproj_sym.proving.letters.statements import Statement, fixed, replaced, without_definitions
from algebroproj_sym.proving.letters.turns import Turn
from algebroproj_sym.proving.points import rational_zeros

ENOUGH_POINTS = 4
CONSTRAINED_STARTS = 8
CONSTRAINED_TRIES = 60
SPARSE_TRIES = 200
MOST_OF_SEARCH = 1_000_000

_CIRCLE = [(Fraction(a, c), Fraction(b, c)) for a, b, c in ((3, 4, 5), (-4, 3, 5), (5, 12, 13), (-8, 15, 17))]


@dataclass(frozen=True)
class Point:
    """Exact values of letters and numbers, at sizes that have names."""

    letters: Mapping[str, Rows]
    """The matrices."""
    scalars: Mapping[str, Fraction]
    """The numbers."""
    sizes: Mapping[str, int]
    turn: Turn | None = None
    """The angle of which others are multiples; values have a number in its place."""

    def value(self, term: Term) -> Rows:
        """Return the rows of a term.

        It raises `ZeroDivisionError` if it is not defined, or not known exactly.
        """
        return entries_of(term, self.letters, self.scalars, NUMBERS, self.sizes, self.turn)

    def record(self) -> dict[str, Any]:
        """Return the values as text."""
        rows = {
            name: [[str(self.shown(name, x)) for x in row] for row in value] for name, value in self.letters.items()
        }
        values = {name: str(self.shown(name, value)) for name, value in self.scalars.items()}
        return rows | values | dict(self.sizes)

    def shown(self, name: str, value: Fraction) -> Any:
        """Return what an entry of a letter, or a number, is."""
        return value if self.turn is None or name not in self.turn.names else self.turn.shown(value)


@dataclass(frozen=True)
class Candidates:
    """Where to look for points of a statement."""

    statement: Statement
    """The statement in the letters that are left, without lengths, derivatives and definitions."""
    stated: Statement
    """The same, whose numbers are to have values."""
    angles: Sequence[Term]
    """The vectors or numbers whose functions occur."""
    letters: Mapping[str, Letter]
    """All letters."""
    definitions: Mapping[str, Term]
    """What constraints say that some are."""
    size_names: Sequence[str]
    """The names of sizes."""
    search: Work = field(default_factory=lambda: Work(MOST_OF_SEARCH))
    """What is left of the effort."""

    def sparse(self) -> Iterator[Point]:
        """Yield points at which letters in constraints have few entries other than zero, where the constraints hold."""
        constraints = self.statement.constraints
        if not constraints or self.angles:
            return
        generator = random.Random(self.statement.seed)
        bound = {part.value for term in constraints for part in factors_of(term) if part.kind == "letter"}
        for attempt in range(SPARSE_TRIES):
            sizes = self._sizes(generator, attempt)
            letters = {
                name: sparse(letter, sizes, generator)
                if name in bound and not letter.properties
                else example(letter, sizes, generator, 0)
                for name, letter in self.statement.letters.items()
            }
            scalars = {name: self._number(symbol, generator, 0) for name, symbol in self.scalars.items()}
            if None not in letters.values():
                yield Point(letters, scalars, sizes)  # type: ignore[arg-type]

    def points(self, tries: int) -> Iterator[Point]:
        """Yield points, with or without constraints, until there were so many tries."""
        generator = random.Random(self.statement.seed)
        for attempt in range(tries):
            sizes = self._sizes(generator, attempt)
            if self.statement.constraints and not self.angles:
                yield from self._constrained_points(sizes, attempt)
            letters = {
                name: example(letter, sizes, generator, attempt) for name, letter in self.statement.letters.items()
            }
            scalars = {name: self._number(symbol, generator, attempt) for name, symbol in self.scalars.items()}
            if None not in letters.values():
                point = Point(letters, scalars, sizes)  # type: ignore[arg-type]
                point = self._turned(point, generator, attempt) if self.angles else point
                yield from self._with_implied(point, attempt)

    def _with_implied(self, point: Point, attempt: int) -> Iterator[Point]:
        """Yield a point, and the same with what constraints say of letters that have properties, and of others."""
        yield point
        with suppress(ZeroDivisionError):
            if self.implied:
                point = replace(
                    point, letters={**point.letters, **{k: point.value(v) for k, v in self.implied.items()}}
                )
                yield point
            if self.statement.constraints and self.angles:
                yield from self._solved(point, attempt)

    @cached_property
    def implied(self) -> dict[str, Term]:
        """What constraints say that letters with properties are."""
        plain = {name: Letter(name, letter.shape, frozenset()) for name, letter in self.statement.letters.items()}
        defined, _ = without_definitions(replace(self.statement, letters=plain))
        return {name: term for name, term in defined.items() if name in plain}

    def _solved(self, point: Point, attempt: int) -> Iterator[Point]:
        """Yield points at which angles are given, and other letters are on the constraints."""
        if attempt >= CONSTRAINED_STARTS:
            return
        bound = {part.value for term in self.angles for part in factors_of(term) if part.kind in ("letter", "symbol")}

        def valued(part: Term) -> Term | None:
            is_known = part.kind in FUNCTIONS or (part.kind in ("letter", "symbol") and part.value in bound)
            return _constant(point.value(part)) if is_known else None

        zeros = tuple(replaced(term, valued) for term in self.statement.constraints)
        letters = {name: letter for name, letter in self.statement.letters.items() if name not in bound}
        left = number(0)
        for other in self._on_constraints(fixed(Statement(left, left, letters, zeros), point.sizes), attempt):
            yield replace(point, letters={**point.letters, **other[0]}, scalars={**point.scalars, **other[1]})

    def _turned(self, point: Point, generator: random.Random, attempt: int) -> Point:
        """Return a point at which lengths are rational, and angles multiples of one."""
        cosine, sine = generator.choice(_CIRCLE)
        if self.statement.constraints and attempt % 4 == 3:
            cosine, sine = Fraction(0), Fraction(1)
        value = Fraction(generator.randint(1, 3))
        letters, scalars, names = dict(point.letters), dict(point.scalars), set[str]()
        parts = {part for term in self.statement.terms for part in factors_of(term)}
        has_angle = any(part.kind in FUNCTIONS and part.kind != "norm" for part in parts)
        frame, lengths = _frame(generator), generator.choice(((3, 4, 5), (1, 2, 4), (2, 1, 4), (2, 2, 2)))
        within = {
            part.value for angle in self.angles for part in factors_of(angle) if part.kind in ("letter", "symbol")
        }
        for place, name in enumerate(sorted(within - {*point.sizes})):
            turns = has_angle and generator.random() < 0.8
            length = lengths[place % 3] * (value if turns else Fraction(1))
            if name in scalars:
                symbol = self.statement.scalars.get(name, sympy.Symbol(name))
                if turns and symbol.is_algebraic is None:
                    signed = generator.choice((length, -length))
                    scalars[name] = signed if admits(symbol, signed) else -signed
                    names.add(name)
                continue
            if self.letters[name].properties <= {"skew"}:
                axis = frame[place % 3] if generator.random() < 0.7 else generator.choice(_frame(generator))
                if len(letters[name]) not in (3, 6):
                    axis = _direction(len(letters[name]), generator)
                letters[name] = _of_length(letters[name], [length * entry for entry in axis], self.letters[name])
                names |= {name} if turns else set()
        return Point(letters, scalars, point.sizes, Turn(cosine, sine, value, frozenset(names)))

    def _constrained_points(self, sizes: Mapping[str, int], attempt: int) -> Iterator[Point]:
        """Yield points on the constraints, in the coordinates of the letters."""
        if attempt >= CONSTRAINED_STARTS:
            return
        for letters, scalars in self._on_constraints(fixed(self.statement, sizes), attempt):
            numbers = {
                name: scalars[name] if name in scalars else values_of(symbol)[0]
                for name, symbol in self.scalars.items()
            }
            yield Point(letters, numbers, sizes)

    def _on_constraints(
        self, statement: Statement, attempt: int
    ) -> Iterator[tuple[dict[str, Rows], dict[str, Fraction]]]:
        """Yield letters, and numbers, that are zeros of the constraints of a statement of fixed size."""
        expansion = Expansion(statement)
        if not expansion.equations:
            return
        seed = statement.seed + attempt
        zeros = rational_zeros(expansion.equations, expansion.symbols, seed, CONSTRAINED_TRIES, self.search)
        with suppress(ZeroDivisionError):
            for values in islice(zeros, ENOUGH_POINTS):
                scalars = {symbol.name: value for symbol, value in values.items()}
                letters = {k: entries_of(each.entries, {}, scalars, NUMBERS) for k, each in expansion.letters.items()}
                yield letters, scalars

    def _sizes(self, generator: random.Random, attempt: int) -> dict[str, int]:
        names = self.size_names
        if attempt < 4:
            return {name: 2 + (k + attempt) % 2 for k, name in enumerate(names)}
        return {name: generator.randint(1, 3) for name in names}

    @cached_property
    def scalars(self) -> dict[str, sympy.Symbol]:
        """The numbers that occur, by name."""
        terms = (*self.stated.terms, *self.definitions.values())
        names = {part.value for term in terms for part in factors_of(term) if part.kind == "symbol"}
        others = sorted(names - {*self.size_names})
        return {name: self.statement.scalars.get(name, sympy.Symbol(name)) for name in others}

    def _number(self, symbol: sympy.Symbol, generator: random.Random, attempt: int) -> Fraction:
        return generator.choice(values_of(symbol)[: 8 + attempt])


def _constant(rows: Rows) -> Term:
    """Return rows of numbers as a term."""
    if len(rows) == len(rows[0]) == 1:
        return number(rows[0][0])
    return made("block", *(number(entry) for row in rows for entry in row), value=tuple(map(len, rows)))


def _frame(generator: random.Random) -> Rows:
    """Return three vectors of length 1, each orthogonal to the others."""
    rotation = Letter("R", (3, 3), frozenset({"rotation", "orthogonal"}))
    return example(rotation, {}, generator, 0) or [[Fraction(i == j) for j in range(3)] for i in range(3)]


def _direction(size: int, generator: random.Random) -> list[Fraction]:
    """Return a vector of length 1."""
    found = example(Letter("n", (size, 1), frozenset({"unit"})), {}, generator, 0)
    return [row[0] for row in found] if found else [Fraction(k == 0) for k in range(size)]


def _of_length(rows: Rows, vector: list[Fraction], letter: Letter) -> Rows:
    """Return a cross-product matrix, or a vector, of which the last components are given; others as they are."""
    if "skew" in letter.properties and len(rows) == 3:
        x, y, z = vector
        return [[Fraction(0), -z, y], [z, Fraction(0), -x], [-y, x, Fraction(0)]]
    return [*rows[: -len(vector)], *([entry] for entry in vector)] if len(rows[0]) == 1 else rows

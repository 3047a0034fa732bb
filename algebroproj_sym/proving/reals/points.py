"""Rational points at which a statement says something, and whether its sides differ there."""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import flint

from algebroproj_sym.proving.points import seed_of
from algebroproj_sym.proving.reals.balls import Balls
from algebroproj_sym.replaying.reals import Statement
from algebroproj_sym.replaying.reals.integrals import with_ends
from algebroproj_sym.replaying.reals.intervals import Intervals
from algebroproj_sym.replaying.reals.terms import written
from algebroproj_sym.replaying.reals.values import UndecidedError, UndefinedError

Point = Mapping[str, Fraction]

FIRST, ALL = (64,), (64, 1024, 4096)
QUADRATURE = (128, 512)
"""Of integrals: the second only where there is one point."""
SMALL = [Fraction(p, q) for p, q in ((1, 1), (2, 1), (1, 2), (3, 1), (1, 3), (3, 2), (3, 4), (1, 5), (5, 1), (7, 3))]
FURTHER = [Fraction(p, q) for p, q in ((1, 10), (9, 10), (9, 2), (7, 1), (10, 1), (1, 100), (40, 1), (19, 20), (8, 5))]


@dataclass(frozen=True)
class Place:
    """A point where a statement says something, and whether it is seen to fail there."""

    point: Point
    fails: bool


def places(statement: Statement, tries: int, precisions: Sequence[int] = FIRST) -> Iterator[Place]:
    """Yield points where both sides are defined and the conditions hold."""
    names = sorted(statement.symbols())
    for number, point in enumerate(_points(names, seed_of(written(statement.left), written(statement.right)))):
        if number >= tries or (not names and number):
            return
        place = judged(statement, point, precisions)
        if place is not None:
            yield place


def _points(names: list[str], seed: int) -> Iterator[Point]:
    generator = random.Random(seed)
    number = 0
    while True:
        pool = SMALL if number < 25 else SMALL + FURTHER
        point = {}
        for name in names:
            value = generator.choice(pool)
            if number >= 200:
                value = Fraction(generator.randint(1, 60), generator.randint(1, 40))
            kind = 0 if number < 4 else generator.randint(0, 7)
            point[name] = value if kind < 4 else Fraction(0) if kind == 7 and number % 3 == 0 else -value
        yield point
        number += 1


def judged(statement: Statement, point: Point, precisions: Sequence[int] = FIRST) -> Place | None:
    """Return whether a statement fails at a point; None where it says nothing, or that is not decided."""
    kept, found = flint.ctx.prec, None
    has_integrals = any(with_ends(statement.sides))
    try:
        for bits in precisions if not has_integrals else QUADRATURE[: 1 if point else 2]:
            flint.ctx.prec = bits
            numbers = Intervals(bits) if has_integrals else Balls()
            try:
                found = Place(point, statement.fails_at(point, numbers))
            except UndecidedError:
                continue
            except UndefinedError:
                return None
            if found.fails:
                return found
        return found
    finally:
        flint.ctx.prec = kept


def bits_for(statement: Statement, place: Place) -> int | None:
    """Return how many bits intervals need to show the same; None if too many."""
    for bits in (128, 512, 2048, 4096):
        numbers = Intervals(bits)
        try:
            fails = statement.fails_at(place.point, numbers)
        except (UndecidedError, UndefinedError):
            continue
        if fails or not place.fails:
            return bits
    return None

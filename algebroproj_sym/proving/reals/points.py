"""Points at which a statement says something, and whether it fails there: rational ones, and those of exact numbers."""

import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from operator import itemgetter
from typing import Any

import flint

from algebroproj_sym.expressions import NotRationalError
from algebroproj_sym.proving.points import seed_of
from algebroproj_sym.proving.polynomials import EffortExceededError
from algebroproj_sym.proving.reals.balls import Balls
from algebroproj_sym.proving.reals.exact_points import exact_points
from algebroproj_sym.proving.reals.reading import settled
from algebroproj_sym.proving.reals.samples import FLOATS, UNKNOWN, nearly
from algebroproj_sym.proving.reals.search import Search
from algebroproj_sym.replaying.reals import Statement
from algebroproj_sym.replaying.reals.integrals import with_ends
from algebroproj_sym.replaying.reals.intervals import Intervals
from algebroproj_sym.replaying.reals.terms import Term, written
from algebroproj_sym.replaying.reals.theory import Theory
from algebroproj_sym.replaying.reals.values import UndecidedError, UndefinedError
from algebroproj_sym.replaying.rejection import NotReplayable, Rejected

Point = Mapping[str, Fraction]

FIRST, ALL = (64,), (64, 1024, 4096)
QUADRATURE = (128, 512)
"""Of integrals: the second only where there is one point."""
SMALL = [Fraction(p, q) for p, q in ((1, 1), (2, 1), (1, 2), (3, 1), (1, 3), (3, 2), (3, 4), (1, 5), (5, 1), (7, 3))]
FURTHER = [Fraction(p, q) for p, q in ((1, 10), (9, 10), (9, 2), (7, 1), (10, 1), (1, 100), (40, 1), (19, 20), (8, 5))]


MOST_SEEMING = 12
SOON = 80
"""How many points come before others that are plainer."""
MOST_PROOFS = 5
"""How often it is tried to show that a statement fails at a point where it seems to."""
POINT_EFFORT = 60
"""What a search may spend on a point: what is true of plain numbers is found soon."""


@dataclass(frozen=True)
class Place:
    """A point where a statement says something, and whether it is seen to fail there.

    The coordinates are fractions, or terms if a proof shows this.
    """

    point: Mapping[str, Any]
    fails: bool
    proof: Mapping[str, Any] | None = None

    def texts(self) -> dict[str, str]:
        """Return the coordinates as text."""
        return {
            name: written(value) if isinstance(value, Term) else str(value)
            for name, value in sorted(self.point.items())
        }


def places(statement: Statement, tries: int, precisions: Sequence[int] = FIRST) -> Iterator[Place]:
    """Yield points where both sides are defined and the conditions hold."""
    names = sorted(statement.symbols())
    for number, point in enumerate(_points(names, seed_of(written(statement.left), written(statement.right)))):
        if number >= tries or (not names and number):
            return
        place = judged(statement, point, precisions)
        if place is not None:
            yield place


def refuting(statement: Statement, tries: int, closely: int) -> Place | None:
    """Return a rational point at which a statement fails; None if none was found.

    The first points are judged closely, and of the others those that seem to refute.
    """
    names = sorted(statement.symbols())
    points = _points(names, seed_of(written(statement.left), written(statement.right)))
    for number, point in zip(range(tries if names else 1), points, strict=False):
        if number < closely or seems_to_fail(statement, point):
            place = judged(statement, point, ALL)
            if place is not None and place.fails:
                return place
    return None


def exact_places(statement: Statement, tries: int, *, fails: bool) -> Iterator[Place]:
    """Yield a point of exact numbers where a statement fails; if there is none, and more is asked for, others.

    Of these only the first is shown to be one where the statement says something.
    """
    kinds = (True,) if fails else (True, False)
    seeming: dict[bool, list[tuple[bool, int, int, Mapping[str, Term]]]] = {kind: [] for kind in kinds}
    for number, point in enumerate(exact_points(statement, tries)):
        values = {name: nearly(value) for name, value in point.items()}
        fails_there = None if None in values.values() else seems_to_fail(statement, values)
        if fails_there in seeming:
            size = sum(map(Term.size, point.values()))
            seeming[fails_there].append((number >= SOON, size, number, point))
            if fails_there == bool(seeming[True]) and len(seeming[fails_there]) >= MOST_SEEMING:
                break
    for kind in kinds:
        plain_first = [point for *_, point in sorted(seeming[kind], key=itemgetter(0, 1, 2))]
        for number, seen in enumerate(plain_first[:MOST_PROOFS], 1):
            try:
                point = {name: settled(value) for name, value in seen.items()}
                proof = Search(Theory(()), statement.at(point, fails=kind), effort=[POINT_EFFORT]).proof()
            except (EffortExceededError, NotReplayable, Rejected, NotRationalError):
                continue
            if proof is not None:
                yield Place(point, kind, proof)
                yield from (Place(other, kind) for other in plain_first[number:] if not kind)
                return


def seems_to_fail(statement: Statement, point: Mapping[str, Any]) -> bool | None:
    """Whether a statement seems to fail at a point; None where it seems to say nothing."""
    try:
        return statement.fails_at(point, FLOATS)
    except UNKNOWN:
        return None


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


def bits_for(statement: Statement, point: Mapping[str, Any], *, fails: bool) -> int | None:
    """Return how many bits intervals need to show the same; None if too many."""
    for bits in (128, 512, 2048, 4096):
        numbers = Intervals(bits)
        try:
            if statement.fails_at(point, numbers) or not fails:
                return bits
        except (UndecidedError, UndefinedError):
            continue
    return None

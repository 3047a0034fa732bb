"""The rank that a matrix of rational functions has in general.

From below by the rank at a rational point, which is the rank of a matrix of fractions; from above by independent
vectors that the matrix takes to zero identically.
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import islice
from math import lcm
from typing import Any, NamedTuple, Unpack

import sympy

from algebroproj_sym.declaring.claim import Claim, DeclarationError
from algebroproj_sym.declaring.kind import QUOTED, Declaring, Kind, Options
from algebroproj_sym.declaring.kinds.minor import Minor, largest_minor
from algebroproj_sym.declaring.transcription import transcribed_count
from algebroproj_sym.expressions import Expression, columns, evaluate, symbols_of, text, vector
from algebroproj_sym.proving import (
    Point,
    Proof,
    RationalFunctionField,
    numerators_over_one,
    point_record,
    prove,
    rational_points,
    seed_of,
    undecided,
)

POINTS = 20


class Bound(NamedTuple):
    """An upper bound of all ranks: by the size, or by vectors that are independent at a point, as a minor shows."""

    rank: int
    independent: Minor | None


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide ``printed == rank of derived``."""
    matrix: Any = claim.derived
    if not isinstance(matrix, sympy.MatrixBase):
        raise DeclarationError(f"{claim.number}: expected a matrix whose rank is claimed, got {matrix}")
    smaller = min(matrix.shape)
    vectors = polynomial_vectors(claim, engine)
    kernel: Any = columns(*vectors) if vectors else None
    annihilated = kernel is not None and _is_annihilated(matrix, kernel, engine)

    def bound_at(point: Point) -> Bound:
        if not annihilated:
            return Bound(int(smaller), None)
        return bounded(int(smaller), int(matrix.cols), largest_minor(values_at(kernel, point)))

    return generic_rank(
        claim,
        printed,
        symbols_of((matrix, *vectors)),
        vectors,
        lambda point: largest_minor(values_at(matrix, point)),
        bound_at,
        engine,
    )


def _is_annihilated(matrix: Any, kernel: Any, engine: str) -> bool:
    zero = sympy.ImmutableDenseMatrix.zeros(matrix.rows, kernel.cols)
    return prove(matrix * kernel, zero, engine=engine).verdict == "proved"


def polynomial_vectors(claim: Claim, engine: str) -> list[Expression]:
    """Return the vectors of a claim, each times what makes its components polynomials with integer coefficients."""
    return [_polynomial(given, engine) for given in claim.kernel]


def _polynomial(given: Expression, engine: str) -> Expression:
    field = RationalFunctionField(symbols_of((given,)), engine)
    numerators = numerators_over_one(evaluate(given, field.variables, field.lift))
    number = lcm(*(value.denominator for part in numerators for value in field.ring.terms(part).values()))
    scale = field.ring.constant(Fraction(number))
    return vector(*(field.expression(numerator * scale) for numerator in numerators))


def bounded(smaller: int, width: int, independent: Minor) -> Bound:
    """Return the bound that independent vectors give in a space of a width, or the smaller dimension if that is less.

    Examples
    --------
    >>> bounded(3, 4, Minor([0, 1], [0, 1], Fraction(1))).rank
    2
    """
    by_kernel = width - len(independent.rows)
    return Bound(by_kernel, independent) if by_kernel < smaller else Bound(smaller, None)


def generic_rank(
    claim: Claim,
    printed: int,
    symbols: Sequence[sympy.Symbol],
    vectors: Sequence[Expression],
    minor_at: Callable[[Point], Minor],
    bound_at: Callable[[Point], Bound],
    engine: str,
) -> Proof:
    """Decide a rank from below by points and from above by a bound, which rests on vectors.

    `minor_at` returns a largest minor that is not zero at a point, and `bound_at` an upper bound of all ranks that the
    point gives.  They raise `ZeroDivisionError` where something is not defined.
    """
    if not isinstance(printed, int | sympy.Integer):
        raise DeclarationError(f"{claim.number}: expected a number as printed form, got {printed}")
    ranked = []
    for point in islice(rational_points(symbols, seed_of(claim.number)), POINTS):
        try:
            ranked.append((minor_at(point), bound_at(point), point))
        except ZeroDivisionError:
            continue
        if len(ranked[-1][0].rows) == ranked[-1][1].rank:
            break
    if not ranked:
        return undecided("no point was found", engine)
    minor, _, point = max(ranked, key=lambda entry: len(entry[0].rows))
    _, bound, bound_point = min(ranked, key=lambda entry: entry[1].rank)
    largest = len(minor.rows)
    below = {"rows": minor.rows, "columns": minor.columns, "minor": str(minor.value)}
    if largest > printed:
        return Proof("refuted", (), {"method": "counterexample", "rank": largest, **below}, point, engine)
    above = _above(vectors, bound, bound_point)
    if bound.rank < printed:
        certificate = {"method": "kernel vectors", "rank at most": bound.rank, **above}
        return Proof("refuted", (), certificate, {}, engine)
    if largest < printed or bound.rank > printed:
        reason = f"the rank lies between {largest} and {bound.rank}"
        return undecided(reason, engine)
    certificate = {"method": "rank at a point and kernel vectors", "point": point_record(point), **below, **above}
    return Proof("proved", (), certificate, None, engine)


def _above(vectors: Sequence[Expression], bound: Bound, point: Point) -> dict[str, Any]:
    """Return the evidence of an upper bound: vectors, and a minor that shows that they are independent at a point."""
    if bound.independent is None:
        return {"kernel": []}
    rows, chosen, value = bound.independent
    return {
        "kernel": [text(vectors[place]) for place in chosen],
        "kernel at": point_record(point),
        "kernel rows": rows,
        "kernel minor": str(value),
    }


def values_at(matrix: Any, point: Point) -> list[list[Fraction]]:
    """Return a matrix at a point, as rows of fractions."""
    values = evaluate(matrix, point)
    return [list(values[i * matrix.cols : (i + 1) * matrix.cols]) for i in range(matrix.rows)]


def rank(
    section: Declaring, number: str, title: str, *, printed: int = QUOTED, derived: Any, **options: Unpack[Options]
) -> Claim:
    """Declare the rank that a matrix has in general; `kernel` are independent vectors that it takes to zero."""
    return section.declare(RANK, number, title, printed, derived, **options)


RANK = Kind(
    "rank",
    rank,
    compare,
    "The generic rank of the matrix.",
    transcribe=transcribed_count,
    takes=("kernel", "letters"),
    of_entries=True,
    is_reduced=False,
    printed="Printed: the rank",
    derived="Derived: the matrix",
    applied=r"\operatorname{rank} %(derived)s",
)

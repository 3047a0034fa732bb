"""How many functions are independent: the rank that their Jacobian matrix has in general.

From below by the Jacobian at a rational point; from above by independent directions, in the variables, along which all
functions stay what they are.  The derivatives are taken over fractions and over rational functions.
"""

from typing import Any, Unpack

import sympy

from algebroproj_sym.declaring.claim import Claim, DeclarationError
from algebroproj_sym.declaring.kind import QUOTED, Declaring, Kind, Options
from algebroproj_sym.declaring.kinds.minor import Minor, largest_minor
from algebroproj_sym.declaring.kinds.rank import Bound, bounded, generic_rank, polynomial_vectors, values_at
from algebroproj_sym.declaring.transcription import transcribed_count
from algebroproj_sym.expressions import columns, derivatives, entries, evaluate, jacobian, symbols_of
from algebroproj_sym.proving import Point, Proof, RationalFunctionField


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide ``printed == number of independent functions among the entries of derived``."""
    functions: Any = claim.derived
    if not claim.variables:
        raise DeclarationError(f"{claim.number}: expected the variables of the functions to be counted")
    if not all(isinstance(variable, sympy.Symbol) for variable in claim.variables):
        raise DeclarationError(f"{claim.number}: expected symbols as variables of the functions, got {claim.variables}")
    wrong = [direction for direction in claim.kernel if len(entries(direction)) != len(claim.variables)]
    if wrong:
        raise DeclarationError(f"{claim.number}: expected directions of {len(claim.variables)} components, got {wrong}")
    vectors = polynomial_vectors(claim, engine)
    symbols = symbols_of((functions, *vectors, *claim.variables))

    def minor_at(point: Point) -> Minor:
        return largest_minor(jacobian(functions, point, claim.variables))

    field = RationalFunctionField(symbols, engine)
    invariant = all(_is_invariant(claim, direction, field) for direction in vectors)
    largest = min(len(entries(functions)), len(claim.variables))

    def bound_at(point: Point) -> Bound:
        if not invariant or not vectors:
            return Bound(largest, None)
        return bounded(largest, len(claim.variables), largest_minor(values_at(columns(*vectors), point)))

    return generic_rank(claim, printed, symbols, vectors, minor_at, bound_at, engine)


def _is_invariant(claim: Claim, direction: sympy.MatrixBase, field: RationalFunctionField) -> bool:
    """Whether the derivatives of all functions along a direction are identically zero."""
    functions: Any = claim.derived
    along = evaluate(direction, field.variables, field.lift)
    changes = derivatives(functions, field.variables, claim.variables, along, field.lift)
    return all(change.is_zero for change in changes)


def count(
    section: Declaring, number: str, title: str, *, printed: int = QUOTED, derived: Any, **options: Unpack[Options]
) -> Claim:
    """Declare how many of the functions `derived` of `variables` are independent.

    `kernel` are independent directions, in the variables, along which no function changes.
    """
    return section.declare(COUNT, number, title, printed, derived, **options)


COUNT = Kind(
    "count",
    count,
    compare,
    "The number of independent functions.",
    transcribe=transcribed_count,
    takes=("variables", "kernel"),
    is_reduced=False,
    printed="Printed: how many are independent",
    derived="Derived: the functions",
    applied=r"\operatorname{rank} \partial %(derived)s",
)

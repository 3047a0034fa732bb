"""A definition: well-formed, with one exact instance."""

from itertools import islice
from typing import Any, Unpack

from algebroproj_sym.declaring.claim import Claim
from algebroproj_sym.declaring.kind import QUOTED, Declaring, Kind, Options
from algebroproj_sym.declaring.kinds.identity import decided_text
from algebroproj_sym.expressions import Expression, TextForm, evaluate, symbols_of
from algebroproj_sym.proving import Point, Proof, prove, rational_points, seed_of, undecided

TRIES = 100


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Find the denominators of the definiens and a point at which it is defined.

    What has real functions or letters is proved to equal itself, which needs such a point, too.
    """
    if isinstance(printed, TextForm):
        return decided_text(claim, printed, printed.text, engine)
    hypotheses = prove(printed, printed, engine=engine).hypotheses
    symbols = symbols_of((printed,))
    for point in islice(rational_points(symbols, seed_of(claim.number)), TRIES):
        values = _values(printed, point)
        if values is not None:
            instance = {symbol.name: str(point[symbol]) for symbol in symbols}
            certificate = {"method": "instance", "instance": instance, "values": [str(value) for value in values]}
            return Proof("proved", hypotheses, certificate, None, engine)
    return undecided("no instance was found", engine, hypotheses)


def _values(printed: Expression, point: Point) -> tuple[Any, ...] | None:
    try:
        return evaluate(printed, point)
    except ZeroDivisionError:
        return None


def definition(
    section: Declaring, number: str, title: str, *, printed: Any = QUOTED, **options: Unpack[Options]
) -> Claim:
    """Declare a notation."""
    return section.declare(DEFINITION, number, title, printed, None, **options)


DEFINITION = Kind(
    "definition",
    definition,
    compare,
    "It introduces a notation.",
    takes=("letters", "assumptions"),
    of_entries=True,
    is_notation=True,
)

"""A printed number: it must be the exact number, rounded as declared to the same number of decimals."""

import re
from decimal import Decimal
from typing import Any, Unpack

from algebroproj_sym.declaring.claim import Claim, DeclarationError
from algebroproj_sym.declaring.kind import QUOTED, Declaring, Kind, Options
from algebroproj_sym.declaring.transcription import transcribed_number
from algebroproj_sym.expressions import decimals, evaluate, rounded, shape, symbols_of
from algebroproj_sym.proving import Proof

_DECIMAL = re.compile(r"-?[0-9]+(\.[0-9]+)?")
_ROUNDED = {
    "nearest": "The printed number is the exact one, rounded to the nearest.",
    "cut": "The printed number is the exact one, with further digits cut off.",
}


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide whether the exact number, rounded as declared, is the printed one; the sign of a zero says nothing."""
    assert claim.derived is not None
    found = rounded(evaluate(claim.derived, {})[0], decimals(printed), claim.rounding)
    holds = found == printed
    certificate = {"method": "exact rounding", "rounded": f"{found:f}"}
    return Proof("proved" if holds else "refuted", (), certificate, None if holds else {}, engine)


def numeric(
    section: Declaring, number: str, title: str, *, printed: str = QUOTED, derived: Any, **options: Unpack[Options]
) -> Claim:
    """Declare that a printed decimal number is the derived rational number, rounded as `rounding` says."""
    where = f"claim {section.paper}:{number}"
    if "corrected" in options:
        options["corrected"] = decimal(options["corrected"], f"{where}, corrected")
    form = printed if printed is QUOTED else decimal(printed, f"{where}, printed")
    return section.declare(NUMERIC, number, title, form, derived, **options)


def decimal(value: Any, where: str) -> Decimal:
    """Return a printed number with all its digits.

    It raises `DeclarationError` if the value is not the text of digits with a decimal point (a float has lost the
    printed digits).

    Examples
    --------
    >>> decimal("-0.0000000", "printed").as_tuple().exponent
    -7
    """
    if not isinstance(value, str) or not _DECIMAL.fullmatch(value):
        raise DeclarationError(f"{where}: expected the text of a decimal number such as -0.50, got {value!r}")
    return Decimal(value)


def _require_number(claim: Claim, where: str) -> None:
    if claim.derived is not None and (shape(claim.derived) or symbols_of([claim.derived])):
        raise DeclarationError(f"{where}, derived: expected a number, got {claim.derived}")


NUMERIC = Kind(
    "numeric",
    numeric,
    compare,
    lambda claim: _ROUNDED[claim.rounding],
    transcribe=transcribed_number,
    takes=("rounding",),
    require=_require_number,
    relation=r"\approx",
    negated=r"\not\approx",
)

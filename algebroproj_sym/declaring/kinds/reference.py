"""A reference within a paper: the number that is printed against the number of what is meant."""

import re
from typing import Any, Unpack

import sympy

from algebroproj_sym.declaring.claim import Claim, DeclarationError
from algebroproj_sym.declaring.kind import QUOTED, Declaring, Kind, Options
from algebroproj_sym.declaring.source import calling
from algebroproj_sym.declaring.transcription import transcribed_reference
from algebroproj_sym.proving import Proof


def compare(claim: Claim, printed: Any, engine: str) -> Proof:
    """Decide ``printed == derived``, number by number."""
    certificate = {"method": "comparison of references"}
    if printed == claim.derived:
        return Proof("proved", (), certificate, None, engine)
    return Proof("refuted", (), certificate, {}, engine)


def reference(
    section: Declaring, number: str, title: str, *, printed: str = QUOTED, meant: str, **options: Unpack[Options]
) -> Claim:
    """Declare which formula a reference such as "2.3.3" means; a wrong reference is a misprint."""
    where = f"claim {section.paper}:{number}"
    if printed is QUOTED:
        try:
            printed = transcribed_reference(calling(depth=1).folder, number)
        except DeclarationError as error:
            raise DeclarationError(f"{where}, printed: {error}") from error
    right = numbers(meant, f"{where}, meant")
    if printed != meant:
        options = {"expect": "misprint", "corrected": right, **options}
    return section.declare(REFERENCE, number, title, numbers(printed, f"{where}, printed"), right, **options)


def numbers(value: Any, where: str) -> sympy.ImmutableDenseMatrix:
    """Return a reference such as "1.3.8" as its numbers in a row.

    It raises `DeclarationError` if the value is not the text of numbers separated by points or strokes.

    Examples
    --------
    >>> numbers("1.3.8", "printed")
    Matrix([[1, 3, 8]])
    """
    if not isinstance(value, str) or not re.fullmatch(r"\d+([./]\d+)*", value):
        raise DeclarationError(f"{where}: expected the text of a reference such as 1.3.8, got {value!r}")
    return sympy.ImmutableDenseMatrix([[int(part) for part in re.split("[./]", value)]])


REFERENCE = Kind(
    "reference",
    reference,
    compare,
    "The formula that the reference names.",
    is_marked=True,
    derived="Meant",
    text=lambda form: ".".join(map(str, form)),
)

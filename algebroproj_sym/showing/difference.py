"""Where a printed matrix differs from the derived one."""

from decimal import Decimal

from algebroproj_sym.declaring.claim import Claim, in_derived_terms
from algebroproj_sym.expressions import Scalar, TextForm, entries, shape
from algebroproj_sym.proving import prove, reduced


def differing_entries(claim: Claim) -> tuple[tuple[int, Scalar, Scalar], ...]:
    """Return the place, the printed and the derived form of each entry that the prover refutes.

    Only an identity of matrices without constraints has entries to compare. The place counts them row by row.

    Examples
    --------
    >>> from algebroproj_sym.declaring.section import Section
    >>> from algebroproj_sym.expressions import vector
    >>> from sympy.abc import x
    >>> section = Section("demo", "1", "Squares")
    >>> claim = section.identity("1.1", "powers", printed=vector(x, 2 * x), derived=vector(x, x**2))
    >>> differing_entries(claim)
    ((1, 2*x, x**2),)
    """
    if claim.kind != "identity" or claim.printed is None or claim.derived is None:
        return ()
    printed = in_derived_terms(claim.printed, claim.where)
    if isinstance(printed, tuple | Decimal | TextForm) or shape(printed) == ():
        return ()
    pairs = enumerate(zip(entries(printed), entries(claim.derived), strict=True))
    return tuple((place, p, reduced(d)) for place, (p, d) in pairs if prove(p, d).verdict == "refuted")

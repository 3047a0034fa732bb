"""Statements with real functions, checked from their evidence with polynomials, intervals and a list of laws.

The prover of such statements works on the same facts and laws: it calls proved only what `require_real` accepts.
"""

from algebroproj_sym.replaying.reals.matrices import require_real_form
from algebroproj_sym.replaying.reals.statement import Statement, require_real

METHODS = ("real laws", "enclosures", "exact point")
"""What certificates of such statements are called."""

__all__ = ["METHODS", "Statement", "require_real", "require_real_form"]

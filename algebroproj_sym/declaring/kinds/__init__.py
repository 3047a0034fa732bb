"""The kinds of claims: for each, how a printed form is compared with the derived one.

A kind is a function ``compare(claim, printed, engine)`` that returns a `Proof`; every decision in it is made by
`prove`.  `printed` is given apart from the claim, because a corrected form is compared in the same way.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from algebroproj_sym.declaring.claim import Claim, Kind
from algebroproj_sym.declaring.kinds import (
    count,
    definition,
    identity,
    limit,
    numeric,
    projective,
    rank,
    reference,
    structure,
    vanishing,
)
from algebroproj_sym.proving import Proof

Compare = Callable[[Claim, Any, str], Proof]

KINDS: dict[Kind, Compare] = {
    "identity": identity.compare,
    "identity under constraints": identity.compare,
    "identity up to scale": projective.compare,
    "structure": structure.compare,
    "vanishing": vanishing.compare,
    "rank": rank.compare,
    "count": count.compare,
    "limit": limit.compare,
    "numeric": numeric.compare,
    "reference": reference.compare,
    "definition": definition.compare,
}

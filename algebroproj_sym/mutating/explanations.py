"""Changes that survive for a reason: each is listed beside the derivations, with the reason, and with nothing else."""

import tomllib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cache
from importlib.resources import files

from algebroproj_sym.mutating.claims import MutantFate, MutatedClaim
from algebroproj_sym.papers import PAPERS

FILE = "survivors.toml"


@dataclass(frozen=True)
class Explanation:
    """Why a changed form holds as well as the printed one.

    The claim is a selector.
    """

    claim: str
    form: str
    why: str


@cache
def explanations() -> tuple[Explanation, ...]:
    """Return the explanations of the installed papers."""
    known = tomllib.loads((files(PAPERS) / FILE).read_text(encoding="utf-8"))
    return tuple(Explanation(**entry) for entry in known.get("survivor", ()))


def with_reasons(claims: Sequence[MutatedClaim], known: Iterable[Explanation]) -> list[MutatedClaim]:
    """Return the claims with the reasons why changes survive, where they are known.

    Examples
    --------
    >>> survivor = MutantFate("last digit, one more", "0.34", "survived", "within the tolerance")
    >>> claim = MutatedClaim("demo", "1.1", "numeric", 1, (survivor,))
    >>> with_reasons([claim], [Explanation("demo:1.1", "0.34", "A third, cut off.")])[0].fates[0].fate
    'explained'
    """
    reasons = {(entry.claim, entry.form): entry.why for entry in known}

    def explained(claim: MutatedClaim, fate: MutantFate) -> MutantFate:
        why = reasons.get((f"{claim.paper}:{claim.number}", fate.form))
        return replace(fate, fate="explained", reason=why) if why and fate.fate == "survived" else fate

    return [replace(claim, fates=tuple(explained(claim, fate) for fate in claim.fates)) for claim in claims]


def superfluous(claims: Sequence[MutatedClaim], known: Iterable[Explanation]) -> list[Explanation]:
    """Return the explanations of changes that do not survive, among the claims of which every change was tried."""
    complete = {f"{claim.paper}:{claim.number}": claim for claim in claims if len(claim.fates) == claim.total}
    return [
        entry
        for entry in known
        if entry.claim in complete
        and not any(fate.fate == "explained" and fate.form == entry.form for fate in complete[entry.claim].fates)
    ]

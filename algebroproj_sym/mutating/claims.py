"""Mutation of claims: a printed form with a single change must be refuted, or be the same statement."""

from dataclasses import dataclass, replace
from typing import Any, Literal

import sympy

from algebroproj_sym.declaring import Claim, DeclarationError, judge
from algebroproj_sym.declaring.claim import expressions_of, in_derived_terms
from algebroproj_sym.declaring.kinds import KINDS
from algebroproj_sym.expressions import entries, size, vector, written
from algebroproj_sym.mutating.forms import mutants, sampled
from algebroproj_sym.proving import UndefinedError, seed_of

Fate = Literal["refuted", "undefined", "equivalent", "explained", "survived"]

SHORT = 200
"""How many symbols and numbers a printed form has whose changed forms are kept as text, even if they are refuted."""


@dataclass(frozen=True)
class MutantFate:
    """What became of a changed form."""

    change: str
    """What was changed."""
    form: str
    """The changed form; empty for one that is refuted or undefined of a long printed form."""
    fate: Fate
    """Whether it is refuted by an exact counterexample, undefined because a denominator is zero, or proved
    equivalent to the unchanged form; if not, whether it is known why."""
    reason: str = ""
    """Why it survives, or is undefined."""


@dataclass(frozen=True)
class MutatedClaim:
    """The mutants of a claim.

    There are `total` of them; those that were tried have a fate.
    """

    paper: str
    number: str
    kind: str
    total: int
    fates: tuple[MutantFate, ...]


def mutate_claim(claim: Claim, limit: int = 0) -> MutatedClaim:
    """Change the printed form of a proved claim in single places, and judge what comes out.

    At most `limit` changes are tried, chosen by the number of the claim; all if it is 0.

    Examples
    --------
    >>> from algebroproj_sym import Section
    >>> x, y = sympy.symbols("x y")
    >>> claim = Section("demo", "1", "Squares").identity("1.1", "square", printed=x**2, derived=x * x)
    >>> [(fate.form, fate.fate) for fate in mutate_claim(claim).fates]
    [('x**(-2)', 'refuted'), ('x**3', 'refuted')]
    """
    if claim.expected != "proved" or judge(claim).verdict != "proved":
        return MutatedClaim(claim.paper, claim.number, claim.kind, 0, ())
    found = mutants(claim)
    chosen = sampled(found, limit, seed_of(claim.paper, claim.number))
    is_long = sum(size(form, SHORT) for form in expressions_of(claim.printed)) > SHORT
    fates = []
    for mutant in chosen:
        fate, reason = _fate(claim, mutant.form)
        shown = "" if is_long and fate in ("refuted", "undefined") else _shown(mutant.form)
        fates.append(MutantFate(mutant.change, shown, fate, reason))
    return MutatedClaim(claim.paper, claim.number, claim.kind, len(found), tuple(fates))


def _fate(claim: Claim, form: Any) -> tuple[Fate, str]:
    """Return what becomes of a changed form, and why it survives or is undefined."""
    try:
        asked, changed = _where_changed(claim, form)
        proof = KINDS[claim.kind].compare(asked, in_derived_terms(changed, claim.where), "flint")
    except (UndefinedError, DeclarationError, ZeroDivisionError) as error:
        return "undefined", str(error).partition("\n")[0][:200]
    if proof.verdict == "refuted":
        return "refuted", ""
    if proof.verdict == "open":
        return "survived", f"undecided: {(proof.certificate or {})['reason']}"
    if _is_same(claim, form):
        return "equivalent", ""
    return "survived", "the changed form holds, but is not the same statement"


def _where_changed(claim: Claim, form: Any) -> tuple[Claim, Any]:
    """Return what remains to be decided of an identity of matrices: the entries that are changed."""
    if claim.kind not in ("identity", "identity under constraints") or not isinstance(form, sympy.MatrixBase):
        return claim, form
    printed: Any = claim.printed
    derived: Any = claim.derived
    sides = zip(entries(form), entries(printed), entries(derived), strict=True)
    changed = [(new, meant) for new, old, meant in sides if new != old]
    return replace(claim, derived=vector(*(meant for _, meant in changed))), vector(*(new for new, _ in changed))


def _shown(form: Any) -> str:
    if isinstance(form, tuple):
        return written(sympy.Tuple(*form))
    return written(form) if isinstance(form, sympy.Basic | sympy.MatrixBase) else str(form)


def _is_same(claim: Claim, form: Any) -> bool:
    """Whether a changed form that holds is the same statement: what equals the derived form equals the printed one."""
    if claim.kind == "structure":
        return _partition(form) == _partition(claim.printed)
    return claim.kind not in ("rank", "count", "numeric", "reference")


def _partition(pattern: Any) -> list[tuple[int, int]]:
    """Return, for each entry of a pattern, where its mark stands first, and whether with the same sign."""
    first: dict[Any, tuple[int, int]] = {}
    found = []
    for place, mark in enumerate(pattern):
        if mark.is_Integer:
            found.append((-1, int(mark)))
            continue
        sign = -1 if mark.could_extract_minus_sign() else 1
        start, start_sign = first.setdefault(sign * mark, (place, sign))
        found.append((start, sign * start_sign))
    return found

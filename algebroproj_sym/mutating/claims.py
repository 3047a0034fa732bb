"""Mutation of claims: a printed form with a single change must be refuted, or be the same statement."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Literal

import sympy

from algebroproj_sym.declaring import Claim, DeclarationError, judge
from algebroproj_sym.declaring.claim import in_derived_terms
from algebroproj_sym.declaring.kinds import KINDS
from algebroproj_sym.expressions import written
from algebroproj_sym.mutating.forms import Mutant, mutants, sampled
from algebroproj_sym.proving import Proof, UndefinedError, seed_of

Fate = Literal["refuted", "undefined", "equivalent", "explained", "survived"]


@dataclass(frozen=True)
class MutantFate:
    """What became of a mutant: ``refuted`` by an exact counterexample, ``undefined`` because a denominator is zero,
    ``equivalent`` to the unchanged form by a proof, or ``survived``, ``explained`` where it is known why it must.
    """  # noqa: D205

    change: str
    form: str
    fate: Fate
    reason: str = ""


@dataclass(frozen=True)
class MutatedClaim:
    """The mutants of a claim.

    Attributes
    ----------
    paper, number, kind : str
        Which claim.
    total : int
        How many mutants there are; those that were tried are `fates`.
    fates : tuple of MutantFate
        What became of them.
    """

    paper: str
    number: str
    kind: str
    total: int
    fates: tuple[MutantFate, ...]


def mutate_claim(claim: Claim, limit: int = 0, engine: str = "flint") -> MutatedClaim:
    """Change the printed form of a proved claim in single places, and judge what comes out.

    Parameters
    ----------
    claim : Claim
        A claim; if it is not proved, there are no mutants.
    limit : int
        How many mutants to try at most, chosen by the number of the claim; 0 for all.
    engine : {"flint", "sympy"}
        Which polynomial arithmetic to use.

    Examples
    --------
    >>> from algebroproj_sym import Section
    >>> x, y = sympy.symbols("x y")
    >>> claim = Section("demo", "1", "Squares").identity("1.1", "square", printed=x**2, derived=x * x)
    >>> [(fate.form, fate.fate) for fate in mutate_claim(claim).fates]
    [('x**(-2)', 'refuted'), ('x**3', 'refuted')]
    """
    if claim.expected != "proved" or judge(claim, engine).verdict != "proved":
        return MutatedClaim(claim.paper, claim.number, claim.kind, 0, ())
    found = mutants(claim)
    chosen = sampled(found, limit, seed_of(claim.paper, claim.number))
    fates = tuple(_fate(claim, mutant, engine) for mutant in chosen)
    return MutatedClaim(claim.paper, claim.number, claim.kind, len(found), fates)


def _fate(claim: Claim, mutant: Mutant, engine: str) -> MutantFate:
    shown = _shown(mutant.form)
    try:
        proof = _compared(claim, mutant.form, engine)
    except (UndefinedError, DeclarationError, ZeroDivisionError) as error:
        return MutantFate(mutant.change, shown, "undefined", str(error).partition("\n")[0][:200])
    if proof.verdict == "refuted":
        return MutantFate(mutant.change, shown, "refuted")
    if proof.verdict == "open":
        return MutantFate(mutant.change, shown, "survived", f"undecided: {(proof.certificate or {})['reason']}")
    if _is_same(claim, mutant.form, engine):
        return MutantFate(mutant.change, shown, "equivalent")
    return MutantFate(mutant.change, shown, "survived", _tolerance(claim))


def _shown(form: Any) -> str:
    if isinstance(form, tuple):
        return written(sympy.Tuple(*form))
    return written(form) if isinstance(form, sympy.Basic | sympy.MatrixBase) else str(form)


def _compared(claim: Claim, form: Any, engine: str) -> Proof:
    return KINDS[claim.kind](claim, in_derived_terms(form, claim.where), engine)


def _is_same(claim: Claim, form: Any, engine: str) -> bool:
    """Whether a changed form is proved equal, in the sense of the kind, to the unchanged one."""
    printed: Any = claim.printed
    if claim.kind == "structure":
        return _partition(form) == _partition(printed)
    if claim.kind in ("rank", "count", "numeric", "reference", "definition"):
        return False
    unchanged: Any = in_derived_terms(printed, claim.where)
    if claim.kind == "vanishing":
        unchanged = sympy.Mul(*unchanged)
    kind = "identity" if claim.kind == "limit" else claim.kind
    return _compared(replace(claim, kind=kind, derived=unchanged), form, engine).verdict == "proved"


def _partition(pattern: Any) -> list[tuple[int, int]]:
    """Return, for each entry of a pattern, where its mark stands first, and whether with the same sign."""
    first: dict[Any, tuple[int, int]] = {}
    found = []
    for place, mark in enumerate(pattern):
        sign = -1 if mark.could_extract_minus_sign() and not mark.is_Integer else 1
        name = mark if sign > 0 else -mark
        if name.is_Integer:
            found.append((-1, int(name)))
            continue
        start, start_sign = first.setdefault(name, (place, sign))
        found.append((start, sign * start_sign))
    return found


def _tolerance(claim: Claim) -> str:
    if claim.kind != "numeric":
        return "the changed form holds, but is not the same statement"
    if claim.unrounded is not None:
        return "holds as well: the printed inputs give it, or unrounded inputs within the tolerance"
    return f"within the declared tolerance of {claim.units} units of the last digit"

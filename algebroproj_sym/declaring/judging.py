"""From claim to verdict."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import sympy

from algebroproj_sym.declaring.claim import Claim, Verdict, expressions_of, in_derived_terms
from algebroproj_sym.declaring.kinds import KINDS
from algebroproj_sym.expressions import free_symbols, symbols_of
from algebroproj_sym.proving import Proof


@dataclass(frozen=True)
class Judgement:
    """The verdict on a claim and its evidence.

    Attributes
    ----------
    claim : Claim
        What was judged.
    verdict : str
        One of the six verdicts.
    hypotheses : tuple of sympy.Expr
        The factors of all denominators.
    certificate : mapping or None
        The evidence for the printed form, or for the corrected form if the printed form is refuted.
    counterexample : mapping of Symbol to Fraction, or None
        A point where the printed form fails.
    engine : str
        The library for polynomials that was used.
    seconds : float
        The time it took.
    """

    claim: Claim
    verdict: Verdict
    hypotheses: tuple[sympy.Expr, ...]
    certificate: Mapping[str, Any] | None
    counterexample: Mapping[sympy.Symbol, Fraction] | None
    engine: str
    seconds: float

    @property
    def as_declared(self) -> bool:
        """Whether the verdict is the one that the claim declares."""
        return self.verdict == self.claim.expected


def judge(claim: Claim, engine: str = "flint") -> Judgement:
    """Decide a claim.

    Parameters
    ----------
    claim : Claim
        As declared by a derivation.
    engine : {"flint", "sympy"}
        The library for polynomials.

    Returns
    -------
    Judgement

    Examples
    --------
    >>> from algebroproj_sym.declaring.section import Section
    >>> x = sympy.Symbol("x")
    >>> claim = Section("demo", "1", "Squares").identity(
    ...     "1.1", "square", printed=x**2 + 1, derived=(x + 1)**2, corrected=x**2 + 2*x + 1, expect="misprint")
    >>> judge(claim).verdict
    'misprint'
    """
    start = time.perf_counter()
    compare = KINDS[claim.kind]
    printed = None if claim.printed is None else compare(claim, in_derived_terms(claim.printed, claim.where), engine)
    corrected = (
        None if claim.corrected is None else compare(claim, in_derived_terms(claim.corrected, claim.where), engine)
    )
    verdict = _verdict(claim, printed, corrected)
    evidence = _evidence(verdict, printed, corrected)
    return Judgement(
        claim=claim,
        verdict=verdict,
        hypotheses=evidence.hypotheses,
        certificate=evidence.certificate,
        counterexample=None if printed is None else _completed(claim, printed.counterexample),
        engine=engine,
        seconds=time.perf_counter() - start,
    )


def abridged(judgement: Judgement) -> Judgement:
    """Return what a table shows of a judgement: the claim without its forms, the verdict without its evidence."""
    claim = judgement.claim
    named = Claim(
        claim.paper,
        claim.section,
        claim.number,
        claim.title,
        claim.kind,
        printed=None,
        derived=None,
        expected=claim.expected,
        instead=claim.instead,
        note=claim.note,
    )
    return replace(judgement, claim=named, hypotheses=(), certificate=None, counterexample=None)


def _completed(claim: Claim, point: Mapping[sympy.Symbol, Fraction] | None) -> Mapping[sympy.Symbol, Fraction] | None:
    """Give a value also to symbols that cancel when the meanings of others are put in, wherever a point has values."""
    shown = {symbol for form in expressions_of(claim.printed) for symbol in free_symbols(form)}
    meanings = [value for symbol, value in claim.where.items() if symbol in shown]
    needed = shown.difference(claim.where).union(*map(free_symbols, meanings))
    if not point or needed <= point.keys():
        return point
    completed = dict.fromkeys(needed, Fraction(1)) | {**point}
    return {symbol: completed[symbol] for symbol in symbols_of(completed)}


def _verdict(claim: Claim, printed: Proof | None, corrected: Proof | None) -> Verdict:
    corrected_holds = corrected is not None and corrected.verdict == "proved"
    if printed is None:
        return "illegible" if corrected_holds else "open"
    if printed.verdict == "proved":
        return "definition" if claim.kind == "definition" else "proved"
    if printed.verdict == "refuted" and corrected is None:
        return "false"
    return "misprint" if printed.verdict == "refuted" and corrected_holds else "open"


def _evidence(verdict: Verdict, printed: Proof | None, corrected: Proof | None) -> Proof:
    """Return the proof of what is true: of the corrected form where the printed one is refuted or missing."""
    chosen = corrected if verdict in ("misprint", "illegible") else printed
    evidence = chosen or corrected
    assert evidence is not None
    if verdict == "misprint" and printed is not None:
        refutation = {"refutation": printed.certificate}
        return replace(evidence, certificate={**(evidence.certificate or {}), **refutation})
    return evidence

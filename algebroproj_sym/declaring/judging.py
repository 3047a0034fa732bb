"""From claim to verdict."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from typing import Any

import sympy

from algebroproj_sym.declaring.claim import CORRECTED, Claim, Statement, Verdict, expressions_of, in_derived_terms
from algebroproj_sym.declaring.kinds import KINDS
from algebroproj_sym.expressions import TextForm, free_symbols, symbols_of, values_of
from algebroproj_sym.processes import mapped
from algebroproj_sym.proving import Proof, UndefinedError


@dataclass(frozen=True)
class Judgement:
    """The verdict on a claim and its evidence.

    Attributes
    ----------
    claim : Claim
        What was judged.
    verdict : str
        One of the six verdicts.
    hypotheses : tuple of sympy.Expr, or of TextForm
        The factors of all denominators; with real functions, what must hold for both sides to be real.
    certificate : mapping or None
        The evidence for the printed form, or for the corrected form if the printed form is refuted.
    counterexample : mapping of Symbol to Fraction, or None
        A point where the printed form fails; in letters it has exact matrices, and the sizes as integers.
    engine : str
        The library for polynomials that was used.
    seconds : float
        The time it took.
    """

    claim: Claim
    verdict: Verdict
    hypotheses: tuple[Any, ...]
    certificate: Mapping[str, Any] | None
    counterexample: Mapping[sympy.Symbol, Any] | None
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
    printed, corrected = _compared(claim, claim.printed, engine), _compared(claim, claim.corrected, engine)
    verdict = _verdict(claim, printed, corrected)
    evidence = _evidence(verdict, printed, corrected)
    return Judgement(
        claim=claim,
        verdict=verdict,
        hypotheses=evidence.hypotheses,
        certificate=_with_whole_witness(claim, verdict, evidence.certificate),
        counterexample=None if printed is None else _completed(claim, claim.printed, printed.counterexample),
        engine=engine,
        seconds=time.perf_counter() - start,
    )


def judge_all(claims: Sequence[Claim], engine: str = "flint", jobs: int = 1) -> Iterator[Judgement]:
    """Decide claims in some processes, in order; the judgements have the very claims that were given."""
    for claim, found in zip(claims, mapped(partial(_found, engine=engine), claims, jobs), strict=True):
        yield Judgement(claim=claim, **found)


def _found(claim: Claim, engine: str) -> dict[str, Any]:
    """Return a judgement without its claim, whose forms take longer to be sent than to be judged."""
    return {name: value for name, value in vars(judge(claim, engine)).items() if name != "claim"}


def _compared(claim: Claim, form: Statement | None, engine: str) -> Proof | None:
    if form is None:
        return None
    try:
        return KINDS[claim.kind].compare(claim, in_derived_terms(form, claim.where), engine)
    except ZeroDivisionError:
        where = f"claim {claim.paper}:{claim.number}"
        raise UndefinedError(f"{where}: expected denominators that are not identically zero") from None


def _with_whole_witness(
    claim: Claim, verdict: Verdict, certificate: Mapping[str, Any] | None
) -> Mapping[str, Any] | None:
    form = claim.corrected if verdict in (*CORRECTED, "illegible") else claim.printed
    if certificate is None or "witness" not in certificate or isinstance(form, TextForm):
        return certificate
    witness = {sympy.Symbol(name): value for name, value in certificate["witness"].items()}
    completed = _completed(claim, form, witness) or {}
    return {**certificate, "witness": {symbol.name: str(value) for symbol, value in completed.items()}}


def _completed(
    claim: Claim, form: Statement | None, point: Mapping[sympy.Symbol, Any] | None
) -> Mapping[sympy.Symbol, Any] | None:
    """Give a value also to symbols that cancel when the meanings of others are put in, wherever a point has values."""
    shown = {symbol for part in expressions_of(form) for symbol in free_symbols(part)}
    meanings = [value for symbol, value in claim.where.items() if symbol in shown]
    needed = shown.difference(claim.where).union(*map(free_symbols, meanings))
    if not point or needed <= point.keys():
        return point
    values = {symbol.name: values_of(symbol)[0] for symbol in claim.assumed}
    completed = {symbol: values.get(symbol.name, Fraction(1)) for symbol in needed} | {**point}
    return {symbol: completed[symbol] for symbol in symbols_of(completed)}


def _verdict(claim: Claim, printed: Proof | None, corrected: Proof | None) -> Verdict:
    corrected_holds = corrected is not None and corrected.verdict == "proved"
    if printed is None:
        return "illegible" if corrected_holds else "open"
    if printed.verdict == "proved":
        return KINDS[claim.kind].when_it_holds
    if printed.verdict == "refuted" and corrected is None:
        return "false"
    if printed.verdict == "refuted" and corrected_holds:
        return "error" if claim.expected == "error" else "misprint"
    return "open"


def _evidence(verdict: Verdict, printed: Proof | None, corrected: Proof | None) -> Proof:
    """Return the proof of what is true: of the corrected form where the printed one is refuted or missing."""
    chosen = corrected if verdict in (*CORRECTED, "illegible") else printed
    evidence = chosen or corrected
    assert evidence is not None
    if verdict in CORRECTED and printed is not None:
        refutation = {"refutation": printed.certificate}
        return replace(evidence, certificate={**(evidence.certificate or {}), **refutation})
    return evidence

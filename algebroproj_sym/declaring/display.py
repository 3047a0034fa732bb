"""How a claim shows itself in a notebook: formula, verdict and evidence."""

from __future__ import annotations

from decimal import Decimal

import sympy

from algebroproj_sym.declaring.claim import Claim, Statement, Verdict
from algebroproj_sym.declaring.judging import Judgement, judge
from algebroproj_sym.declaring.names import latex_names
from algebroproj_sym.expressions import Expression, divided
from algebroproj_sym.proving import reduced

_RELATION = {"identity up to scale": r"\sim", "vanishing": r"= 0 \iff", "numeric": r"\approx"}


def markdown(claim: Claim) -> str:
    """Return the claim as Markdown with LaTeX: number, title, what is printed and derived, verdict and evidence.

    Examples
    --------
    >>> from algebroproj_sym.declaring.section import Section
    >>> x = sympy.Symbol("x")
    >>> claim = Section("demo", "1", "Squares").identity("1.1", "square", printed=x**2, derived=x * x)
    >>> print(markdown(claim))
    **(1.1)** square: **proved**
    <BLANKLINE>
    $$x^{2} = x^{2}$$
    <BLANKLINE>
    by normal form
    """
    judgement = judge(claim)
    paragraphs = [
        f"**({claim.number})** {claim.title}: **{judgement.verdict}**",
        f"$${_formula(claim, judgement.verdict)}$$",
    ]
    if claim.corrected is not None:
        label = "reconstructed" if claim.printed is None else "corrected"
        paragraphs.append(f"{label}: ${_latex(claim.corrected)}$")
    paragraphs += evidence_lines(judgement)
    if claim.note:
        paragraphs.append(f"note: {claim.note}")
    return "\n\n".join(paragraphs)


def evidence_lines(judgement: Judgement) -> list[str]:
    """Return the evidence for a verdict, a line each: method, hypotheses, counterexample, what is true instead."""
    lines = []
    if judgement.certificate:
        method = judgement.certificate["method"]
        lines.append(f"undecided: {judgement.certificate['reason']}" if method == "none" else f"by {method}")
    if judgement.hypotheses:
        lines.append("holds where none of these vanishes: " + ", ".join(map(str, judgement.hypotheses)))
    if judgement.counterexample:
        values = ", ".join(f"{symbol} = {value}" for symbol, value in judgement.counterexample.items())
        lines.append(f"counterexample: {values}")
    if judgement.claim.instead:
        lines.append(f"true instead: ({judgement.claim.instead})")
    return lines


def _formula(claim: Claim, verdict: Verdict) -> str:
    if claim.derived is None:
        return _latex(claim.printed)
    derived = _latex(reduced(claim.derived))
    if claim.kind == "vanishing":
        return f"{derived} {_RELATION[claim.kind]} {_latex(claim.printed)}"
    if claim.printed is None:
        return derived
    return f"{_latex(claim.printed)} {_relation(claim, verdict)} {derived}"


def _relation(claim: Claim, verdict: Verdict) -> str:
    relation = _RELATION.get(claim.kind, "=")
    return rf"\not{relation}" if verdict in ("misprint", "false") else relation


def _latex(statement: Statement | None) -> str:
    if isinstance(statement, Decimal):
        return f"{statement:f}"
    if isinstance(statement, tuple):
        return r" \cdot ".join(rf"\left({_expression(factor)}\right)" for factor in statement) + " = 0"
    return _expression(divided(statement)) if statement is not None else ""


def _expression(expression: Expression) -> str:
    return str(sympy.latex(expression, symbol_names=latex_names(expression.free_symbols)))

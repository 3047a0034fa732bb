"""How a claim shows itself in a notebook: formula, verdict and evidence."""

from __future__ import annotations

import re
from collections.abc import Callable
from decimal import Decimal

import sympy

from algebroproj_sym.declaring.claim import Claim, Statement, Verdict
from algebroproj_sym.declaring.judging import Judgement
from algebroproj_sym.declaring.latex import latex
from algebroproj_sym.expressions import Expression, assumption, decimals, evaluate, leading, size
from algebroproj_sym.proving import reduced

LONGEST = 400
"""Symbols and numbers of the largest expression that is shown as a formula."""

_MARKDOWN = re.compile(r"[\\`*_\[\]<>#$|~]")
_RELATION = {"identity up to scale": r"\sim", "vanishing": r"= 0 \iff", "numeric": r"\approx"}
_NEGATED = {"identity up to scale": r"\nsim", "vanishing": r"= 0 \nLeftrightarrow", "numeric": r"\not\approx"}


def markdown(judgement: Judgement) -> str:
    """Return a claim as Markdown with LaTeX: number, title, what is printed and derived, verdict and evidence.

    Examples
    --------
    >>> from algebroproj_sym.declaring import Section, judge
    >>> x = sympy.Symbol("x")
    >>> claim = Section("demo", "1", "Squares").identity("1.1", "square", printed=x**2, derived=x * x)
    >>> print(markdown(judge(claim)))
    **(1.1)** square: **proved**
    <BLANKLINE>
    $$x^{2} = x^{2}$$
    <BLANKLINE>
    by normal form
    """
    claim = judgement.claim
    paragraphs = [
        f"**({_escaped(claim.number)})** {_escaped(claim.title)}: **{_verdict(judgement)}**",
        f"$${_formula(claim, judgement.verdict)}$$",
    ]
    if claim.corrected is not None:
        label = "reconstructed" if claim.printed is None else "corrected"
        paragraphs.append(f"{label}:\n\n$${_latex(claim.corrected)}$$")
    paragraphs += evidence_lines(judgement, _in_line)
    if claim.note:
        paragraphs.append(f"note: {_escaped(claim.note)}")
    return "\n\n".join(paragraphs)


def evidence_lines(judgement: Judgement, show: Callable[[object], str] = str) -> list[str]:
    """Return the evidence for a verdict, a line each: method, hypotheses, counterexample, what is true instead.

    Parameters
    ----------
    judgement : Judgement
        A claim and its verdict.
    show : callable
        How symbols, expressions and numbers are written.
    """
    lines = []
    if judgement.certificate:
        method = judgement.certificate["method"]
        about = f": {_rounding(judgement)}" if method == "exact rounding" else ""
        lines.append(f"undecided: {judgement.certificate['reason']}" if method == "none" else f"by {method}{about}")
    if judgement.hypotheses:
        lines.append("holds where none of these vanishes: " + ", ".join(map(show, judgement.hypotheses)))
    if judgement.claim.assumed:
        lines.append("assumed: " + "; ".join(map(assumption, judgement.claim.assumed)))
    if judgement.counterexample:
        values = ", ".join(f"{show(symbol)} = {show(value)}" for symbol, value in judgement.counterexample.items())
        lines.append(f"counterexample: {values}")
    if judgement.claim.instead:
        lines.append(f"true instead: ({judgement.claim.instead})")
    return lines


def _rounding(judgement: Judgement) -> str:
    """Return the one exact number of a printed one, with more digits, and what its rounding gives."""
    claim, given = judgement.claim, (judgement.certificate or {})["rounded"]
    assert claim.derived is not None
    exact = leading(evaluate(claim.derived, {})[0], decimals(Decimal(given)) + 3)
    return f"{exact}, {'cut off' if claim.rounding == 'cut' else 'to the nearest'} {given}"


def _in_line(expression: object) -> str:
    return f"${_latex(sympy.sympify(expression))}$"


def _escaped(text: str) -> str:
    return _MARKDOWN.sub(r"\\\g<0>", text)


def _verdict(judgement: Judgement) -> str:
    declared = "" if judgement.as_declared else f", declared {judgement.claim.expected}"
    return f"{judgement.verdict}{declared}"


def _formula(claim: Claim, verdict: Verdict) -> str:
    if claim.derived is None:
        return _latex(claim.printed)
    as_written = claim.kind in ("count", "rank") or _is_long(claim.derived)
    derived = _applied(claim, _latex(claim.derived if as_written else reduced(claim.derived)))
    if claim.kind == "vanishing":
        return f"{derived} {_relation(claim, verdict)} {_latex(claim.printed)}"
    if claim.printed is None:
        return derived
    return f"{_latex(claim.printed)} {_relation(claim, verdict)} {derived}"


def _applied(claim: Claim, derived: str) -> str:
    """Return what is compared with the printed form: of a rank, a count and a limit not the derived form itself."""
    if claim.kind == "limit":
        return rf"\lim_{{{_latex(claim.variable)} \to 0}} \left({derived}\right)"
    operators = {"rank": r"\operatorname{rank} ", "count": r"\operatorname{rank} \partial "}
    return operators.get(claim.kind, "") + derived


def _relation(claim: Claim, verdict: Verdict) -> str:
    if verdict in ("misprint", "false"):
        return _NEGATED.get(claim.kind, r"\neq")
    return _RELATION.get(claim.kind, "=")


def _latex(statement: Statement | None) -> str:
    if isinstance(statement, Decimal):
        return f"{statement:f}"
    if isinstance(statement, tuple):
        return r" \cdot ".join(rf"\left({_expression(factor)}\right)" for factor in statement) + " = 0"
    return _expression(statement) if statement is not None else ""


def _expression(expression: Expression) -> str:
    if _is_long(expression):
        return rf"\text{{{_described(expression)}}}"
    return latex(expression)


def _is_long(expression: Expression) -> bool:
    return size(expression, LONGEST) > LONGEST


def _described(expression: Expression) -> str:
    if isinstance(expression, sympy.MatrixBase):
        return f"a {expression.rows} × {expression.cols} matrix, too long to be read"
    if isinstance(expression, sympy.Add):
        return f"a sum of {len(expression.args)} terms, too long to be read"
    return "an expression too long to be read"

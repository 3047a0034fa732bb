"""How a claim shows itself in a notebook: formula, verdict and evidence."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from decimal import Decimal
from itertools import accumulate

import sympy

from algebroproj_sym.declaring.claim import CORRECTED, Claim, Statement, as_stated
from algebroproj_sym.declaring.judging import Judgement
from algebroproj_sym.declaring.kinds import KINDS
from algebroproj_sym.expressions import Expression, TextForm, assumption, decimals, evaluate, leading, size
from algebroproj_sym.expressions.arranging import arranged
from algebroproj_sym.showing.arranging import Part, as_declared, shown
from algebroproj_sym.showing.forms import derived_form, entries_of_letters
from algebroproj_sym.showing.latex import latex
from algebroproj_sym.showing.naming import Meaning, Named, in_names, latex_of_name, named_latex
from algebroproj_sym.showing.text_latex import NEGATED, RELATIONS

LONGEST = 400
"""Symbols and numbers of the largest expression that is shown as a formula."""
LARGEST = 3000
"""Symbols and numbers of the largest derived form that is written in lowest terms to be shown."""
LONGEST_ITEM = 136
LONGEST_LIST = 272
"""Characters of the longest expression, and of the longest list of expressions, in a line of evidence."""

_MARKDOWN = re.compile(r"[\\`*_\[\]<>#$|~]")


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
        f"$${formula(judgement)}$$",
    ]
    if claim.corrected is not None:
        label = "reconstructed" if claim.printed is None else "corrected"
        paragraphs.append(f"{label}:\n\n$${_side(claim, 'corrected')}$$")
    paragraphs += _meanings(claim)
    paragraphs += evidence_lines(judgement, _in_line)
    if claim.note:
        paragraphs.append(f"note: {_escaped(claim.note)}")
    return "\n\n".join(paragraphs)


def evidence_lines(
    judgement: Judgement, show: Callable[[object], str] | None = None, *, full: bool = False
) -> list[str]:
    """Return what a verdict rests on, a line each: conditions, method, hypotheses, counterexample, replacement.

    What is shown is written by `show`; by default as text, where long expressions are shortened, unless they are to be
    in `full`.
    """
    show = show or (_whole if full else _shortened)
    most = None if full else LONGEST_LIST
    claim = judgement.claim
    lines = [*conditions(claim, show, most)]
    if judgement.certificate:
        method = judgement.certificate["method"]
        about = f": {_rounding(judgement)}" if method == "exact rounding" else ""
        scope = judgement.certificate.get("scope")
        about = f"{about}, {scope}" if scope else about
        lines.append(f"undecided: {judgement.certificate['reason']}" if method == "none" else f"by {method}{about}")
    if judgement.hypotheses:
        lines.append(f"holds wherever {_are('not zero', judgement.hypotheses, show, most)}")
    if judgement.counterexample:
        values = [f"{show(symbol)} = {show(value)}" for symbol, value in judgement.counterexample.items()]
        lines.append(f"counterexample: {_listed(values, most)}")
    if claim.instead:
        lines.append(f"true instead: ({claim.instead})")
    if full:
        lines += [f"entries of {name}: {form}" for name, form in entries_of_letters(judgement).items()]
    return lines


def _rounding(judgement: Judgement) -> str:
    """Return the one exact number of a printed one, with more digits, and what its rounding gives."""
    claim, given = judgement.claim, (judgement.certificate or {})["rounded"]
    assert claim.derived is not None
    exact = leading(evaluate(claim.derived, {})[0], decimals(Decimal(given)) + 3)
    return f"{exact}, {'cut off' if claim.rounding == 'cut' else 'to the nearest'} {given}"


def conditions(claim: Claim, show: Callable[[object], str], most: int | None = None) -> list[str]:
    """Return under which conditions a claim is made, a line each; without them its formula may be false."""
    given = (("zero", claim.constraints), ("not zero", as_stated(claim, "nonzero")))
    lines = [f"claimed wherever {_are(what, factors, show, most)}" for what, factors in given if factors]
    assumed = [*map(show, claim.assumptions), *map(assumption, claim.assumed)]
    letters = [f"{show(sympy.Symbol(name))} is {described_letter(text)}" for name, text in claim.letters]
    return [
        *([f"in letters: {_listed(letters, most)}"] if letters else []),
        *lines,
        *([f"assumed: {'; '.join(assumed)}"] if assumed else []),
    ]


def described_letter(text: str) -> str:
    """Return what a letter is, in words.

    Examples
    --------
    >>> described_letter("3x3 rotation"), described_letter("nx1")
    ('a 3x3 matrix (rotation)', 'a vector of n components')
    """
    shape, _, properties = text.partition(" ")
    rows, _, columns = shape.partition("x")
    noun = f"a vector of {rows} components" if columns == "1" else f"a {shape} matrix"
    return f"{noun} ({properties})" if properties else noun


def folded(text: str, most: int) -> str:
    """Return a text, or its beginning and its size; it is cut before a sign of addition where that is possible.

    Examples
    --------
    >>> folded("a + b", 10), folded("alpha*beta + gamma*delta + epsilon", 32)
    ('a + b', 'alpha*beta … (34 characters)')
    """
    if len(text) <= most:
        return text
    size = f" … ({len(text):,} characters)"
    kept = text[: max(most - len(size), 1)]
    cut = max(kept.rfind(" + "), kept.rfind(" - "))
    return f"{kept[:cut] if cut > len(kept) // 3 else kept}{size}"


def _are(what: str, factors: Sequence[object], show: Callable[[object], str], most: int | None) -> str:
    if all(isinstance(factor, TextForm) and factor.is_relation for factor in factors):
        return _listed(list(map(show, factors)), most)
    return f"{'this is' if len(factors) == 1 else 'these are'} {what}: {_listed(list(map(show, factors)), most)}"


def _listed(items: Sequence[str], most: int | None) -> str:
    """Join items by commas; only the first ones, if they take more than so many characters."""
    lengths = accumulate(len(item) + 2 for item in items)
    count = len(items) if most is None else max(1, sum(length <= most for length in lengths))
    more = [] if count == len(items) else [f"… and {len(items) - count} more"]
    return ", ".join([*items[:count], *more])


def _whole(value: object) -> str:
    if isinstance(value, sympy.MatrixBase):
        return f"[{shown(value)}]"
    return shown(arranged(value)) if isinstance(value, sympy.Expr) else str(value)


def _shortened(value: object) -> str:
    return folded(_whole(value), LONGEST_ITEM)


def _in_line(expression: object) -> str:
    form = expression if isinstance(expression, TextForm) else arranged(sympy.sympify(expression))
    return f"${_latex(form)}$"


def _escaped(text: str) -> str:
    return _MARKDOWN.sub(r"\\\g<0>", text)


def _verdict(judgement: Judgement) -> str:
    declared = "" if judgement.as_declared else f", declared {judgement.claim.expected}"
    return f"{judgement.verdict}{declared}"


def formula(judgement: Judgement) -> str:
    r"""Return what is printed and what is derived as LaTeX, and how they compare.

    Examples
    --------
    >>> from algebroproj_sym.declaring import Section, judge
    >>> x = sympy.Symbol("x")
    >>> claim = Section("demo", "1", "Squares").identity("1.1", "square", printed=2 * x, derived=x * x)
    >>> print(formula(judge(claim)))
    2 x \neq x^{2}
    """
    claim = judgement.claim
    if claim.derived is None:
        return _side(claim, "printed")
    kind = KINDS[claim.kind]
    variable = "" if claim.variable is None else _latex(claim.variable)
    derived = kind.applied % {"derived": _side(claim, "derived"), "variable": variable}
    if claim.printed is None:
        return derived
    holds = judgement.verdict not in (*CORRECTED, "false")
    relation = kind.relation if holds else kind.negated
    if claim.relation != "=":
        relation = (RELATIONS if holds else NEGATED)[claim.relation]
    sides = (derived, _side(claim, "printed")) if kind.derived_first else (_side(claim, "printed"), derived)
    return f"{sides[0]} {relation} {sides[1]}"


def _side(claim: Claim, part: Part) -> str:
    named = _named(claim, part)
    return named_latex(named.written, named.source.names) if named else _latex(_form(claim, part))


def _form(claim: Claim, part: Part) -> Statement | None:
    """Return a form of a claim as it is declared; what is derived in lowest terms."""
    if part != "derived" or claim.derived is None or size(claim.derived, LARGEST) > LARGEST:
        return as_declared(claim, part)
    lowest: Expression = arranged(derived_form(claim))
    return lowest


def _named(claim: Claim, part: Part) -> Named | None:
    """Return a long form by the names of what it is made of."""
    form = _form(claim, part)
    return in_names(claim, part) if isinstance(form, sympy.Basic) and _is_long(form) else None


def _meanings(claim: Claim) -> list[str]:
    """Return what the names in long forms stand for."""
    parts: tuple[Part, ...] = ("printed", "derived", "corrected")
    found = {m.name: (m, named) for part in parts if (named := _named(claim, part)) for m in named.meanings}
    return [f"where ${latex_of_name(name, named)} = {_value(m, named)}$" for name, (m, named) in found.items()]


def _value(meaning: Meaning, named: Named) -> str:
    return named_latex(meaning.written, named.source.names) if meaning.written else _latex(arranged(meaning.value))


def _latex(statement: Statement | None) -> str:
    if isinstance(statement, Decimal):
        return f"{statement:f}"
    if isinstance(statement, tuple):
        return r" \cdot ".join(rf"\left({_expression(factor)}\right)" for factor in statement) + " = 0"
    return _expression(statement) if statement is not None else ""


def _expression(expression: Expression) -> str:
    if _is_long(expression):
        return rf"\text{{{_described(expression)}}}"
    return latex(expression, ordered=False)


def _is_long(expression: Expression) -> bool:
    return size(expression, LONGEST) > LONGEST


def _described(expression: Expression) -> str:
    if isinstance(expression, sympy.MatrixBase):
        return f"a {expression.rows} × {expression.cols} matrix, too long to be read"
    if isinstance(expression, sympy.Add):
        return f"a sum of {len(expression.args)} terms, too long to be read"
    return "an expression too long to be read"

r"""Text with real functions, or in letters, as LaTeX: with the parts in the order in which they are written."""

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import chain, zip_longest
from math import prod
from typing import Any, TypeAlias

from algebroproj_sym.expressions import TextForm
from algebroproj_sym.replaying.reals.matrices import is_matrix, rows_of
from algebroproj_sym.replaying.reals.terms import Term, read
from algebroproj_sym.showing.marks import NOTHING, Marks, marked
from algebroproj_sym.showing.names import latex_name

SUM, PRODUCT, POWER, ATOM = range(4)
Written: TypeAlias = tuple[str, int]
"""LaTeX, and how tightly it binds."""

_COMPARISON = re.compile("(<=|>=|!=|==|<|>|=)")
RELATIONS = {"=": "=", "!=": r"\neq", "<": "<", "<=": r"\leq", ">": ">", ">=": r"\geq", "==": "="}
NEGATED = {"=": r"\neq", "!=": "=", "<": r"\not<", "<=": r"\not\leq", ">": r"\not>", ">=": r"\not\geq"}
"""LaTeX of what relates two sides, and of what says that it does not hold everywhere."""
_NAMES = {
    **{name: rf"\{name}" for name in ("sin", "cos", "tan", "cot", "sec", "csc", "sinh", "cosh", "tanh", "coth")},
    "exp": r"\exp",
    "log": r"\log",
    "asin": r"\arcsin",
    "acos": r"\arccos",
    "atan": r"\arctan",
}


def latex_of_text(form: TextForm, marks: Marks = NOTHING) -> str:
    r"""Return a form as LaTeX.  In a form in letters the parts of a side can be marked.

    Examples
    --------
    >>> print(latex_of_text(TextForm("sqrt(1 - sin(x)^2)/2")))
    \frac{\sqrt{1 - \sin^{2}\left(x\right)}}{2}
    >>> print(latex_of_text(TextForm("E - skew(t)*R.T", (("E", "3x3"), ("R", "3x3"), ("t", "3x1")))))
    E - \left[t\right]_{\times} R^{T}
    """
    if form.letters is None and is_matrix(form.text):
        return marked(_matrix([map(_with_functions, row) for row in rows_of(form.text)]), marks.whole)
    texts = _COMPARISON.split(form.text)
    if form.letters is None:
        sides = [_with_functions(text) for text in texts[::2]]
    else:
        terms = enumerate(sides_in_letters(form))
        sides = [_in_letters(_with_marks(term, marks.of(place)))[0] for place, term in terms]
    relations = (f" {RELATIONS[text]} " for text in texts[1::2])
    return marked("".join(chain.from_iterable(zip_longest(sides, relations, fillvalue=""))), marks.whole)


def _inside(written: Written, level: int) -> str:
    text, own = written
    return text if own >= level else _bracketed(text)


def _bracketed(text: str) -> str:
    return rf"\left({text}\right)"


def _matrix(rows: Sequence[Iterable[str]]) -> str:
    content = r" \\ ".join(" & ".join(row) for row in rows)
    return rf"\left[\begin{{matrix}} {content} \end{{matrix}}\right]"


def _number(value: Fraction) -> Written:
    size = str(abs(value)) if value.denominator == 1 else rf"\frac{{{abs(value.numerator)}}}{{{value.denominator}}}"
    return (f"-{size}", SUM) if value < 0 else (size, ATOM if value.denominator == 1 else POWER)


def _attached(base: Written, where: str, content: object) -> str:
    """Return a form with an exponent or an index; a letter that has a prime or an index is grouped first."""
    text, level = base
    grouped = f"{{{text}}}" if level == ATOM and {*text} & {*"'^_"} else _inside(base, ATOM)
    return f"{grouped}{where}{{{content}}}"


def _added(terms: list[tuple[bool, str]]) -> Written:
    """Return a sum of terms, each with whether it is subtracted."""
    (minus, first), *others = terms
    rest = "".join(f" {'-' if minus else '+'} {text}" for minus, text in others)
    return f"{'-' if minus else ''}{first}{rest}", SUM


def _multiplied(factors: list[str]) -> Written:
    first, *others = factors
    return first + "".join(rf" \cdot {text}" if text[0].isdigit() else f" {text}" for text in others), PRODUCT


# -- real functions


def _with_functions(text: str) -> str:
    return _real(read(text))[0]


def _real(term: Term) -> Written:
    kind, args = term.kind, term.args
    if kind == "number":
        return _number(term.value)
    if kind == "symbol":
        return latex_name(term.value), ATOM
    if kind == "pi":
        return r"\pi", ATOM
    if kind == "+":
        return _added([_signed(part) for part in args])
    if kind == "-":
        return f"-{_inside(_real(args[0]), PRODUCT)}", SUM
    if kind == "*":
        minus, first = _signed(args[0])
        text = _multiplied([first, *(_inside(_real(part), PRODUCT) for part in args[1:])])[0]
        return (f"-{text}", SUM) if minus else (text, PRODUCT)
    if kind == "/":
        above, below = (_real(part)[0] for part in args)
        return rf"\frac{{{above}}}{{{below}}}", POWER
    if kind == "^":
        return _power(args[0], term.value)
    if kind == "taylor":
        names, degree = term.value
        return rf"\left[{_real(args[0])[0]}\right]_{{{', '.join(map(latex_name, names))}}}^{{\leq {degree}}}", POWER
    if kind in ("diff", "integrate"):
        return _of_calculus(term)
    return _function(kind, args)


def _of_calculus(term: Term) -> Written:
    """Return a derivative, with its order, or an integral."""
    (whole, *ends), variable, order = term.args, latex_name(term.value), 1
    if term.kind == "integrate":
        low, high = (f"{sign}{{{_real(end)[0]}}}" for sign, end in zip("_^", ends, strict=True)) if ends else ("", "")
        return rf"\int{low}{high} {_inside(_real(whole), PRODUCT)} \, d{variable}", PRODUCT
    while whole.kind == "diff" and whole.value == term.value:
        (whole,), order = whole.args, order + 1
    power = f"^{{{order}}}" if order > 1 else ""
    return rf"\frac{{d{power}}}{{d{variable}{power}}} {_inside(_real(whole), POWER)}", PRODUCT


def _signed(term: Term) -> tuple[bool, str]:
    if term.kind == "-":
        return True, _inside(_real(term.args[0]), PRODUCT)
    text, level = _real(term)
    minus = term.kind == "*" and text.startswith("-")
    return minus, text.removeprefix("-") if minus else _inside((text, level), PRODUCT)


def _power(base: Term, exponent: Fraction) -> Written:
    if exponent == Fraction(1, 2):
        return rf"\sqrt{{{_real(base)[0]}}}", ATOM
    above = str(exponent)
    if base.kind in _NAMES and exponent > 1 and exponent.denominator == 1 and base.kind not in ("exp", "log"):
        return f"{_NAMES[base.kind]}^{{{above}}}{_bracketed(_real(base.args[0])[0])}", POWER
    return _attached(_real(base), "^", above), POWER


def _function(name: str, args: tuple[Term, ...]) -> Written:
    inner = ", ".join(_real(part)[0] for part in args)
    if name == "sqrt":
        return rf"\sqrt{{{inner}}}", ATOM
    if name == "abs":
        return rf"\left|{inner}\right|", ATOM
    return _NAMES.get(name, rf"\operatorname{{{name}}}") + _bracketed(inner), POWER


# -- letters


def sides_in_letters(form: TextForm) -> list[Any]:
    """Return the sides of a form as terms; what that needs is imported for it alone."""
    from algebroproj_sym.expressions.letters import parse_letters
    from algebroproj_sym.proving.letters import shape_in_text

    shapes = {name: shape_in_text(name, text) for name, text in form.letters or ()}
    return [parse_letters(text, shapes) for text in _COMPARISON.split(form.text)[::2]]


def _with_marks(term: Any, marks: Marks) -> Any:
    """Return a term with another one of the kind ``marked`` around each of its parts that is marked."""
    parts = tuple(_with_marks(part, marks.of(place)) for place, part in enumerate(term.parts))
    whole = replace(term, parts=parts)
    return replace(whole, kind="marked", parts=(whole,)) if marks.whole else whole


_OPERATORS = {"cross": r" \times ", "dot": r" \cdot ", "kron": r" \otimes ", "qmul": r" \circ "}
_AROUND = {"skew": r"\left[%s\right]_{\times}", "norm": r"\left\|%s\right\|", "conj": r"\overline{%s}"}
_CALLED = {
    "det": r"\det", "trace": r"\operatorname{tr}", "rotation": r"\operatorname{rot}", "sin": r"\sin", "cos": r"\cos",
    "exp": r"\exp", "jl": "J_l", "jr": "J_r",
}  # fmt: skip


def _in_letters(term: Any) -> Written:
    kind, parts, value = term.kind, term.parts, term.value
    if kind == "marked":
        text, level = _in_letters(parts[0])
        return marked(text), level
    if kind == "number":
        return _number(value)
    if kind in ("symbol", "letter"):
        return latex_name(value), ATOM
    if kind == "sum":
        return _added([_signed_letters(part) for part in parts])
    if kind == "product":
        minus, text = _signed_letters(term)
        return (f"-{text}", SUM) if minus else (text, PRODUCT)
    if kind == "power":
        return _attached(_in_letters(parts[0]), "^", value), POWER
    if kind == "transpose":
        return _attached(_in_letters(parts[0]), "^", "T"), POWER
    if kind == "outer":
        first, second = map(_in_letters, parts)
        return f"{_inside(first, ATOM)} {_attached(second, '^', 'T')}", PRODUCT
    if kind in ("eye", "zeros"):
        return (f"I_{{{value[0]}}}" if kind == "eye" else "0"), ATOM
    if kind == "entry":
        return _attached(_in_letters(parts[0]), "_", f"{value[0] + 1},{value[1] + 1}"), POWER
    if kind == "block":
        texts, width = [_in_letters(part)[0] for part in parts], value[0]
        return _matrix([texts[place : place + width] for place in range(0, len(texts), width)]), ATOM
    if kind in _OPERATORS:
        return _OPERATORS[kind].join(_inside(_in_letters(part), ATOM) for part in parts), PRODUCT
    inner = ", ".join(_in_letters(part)[0] for part in parts)
    if kind in _AROUND:
        return _AROUND[kind] % inner, ATOM
    if kind in ("vee", "hat"):
        return _attached(_in_letters(parts[0]), "^", r"\vee" if kind == "vee" else r"\wedge"), POWER
    return _CALLED.get(kind, rf"\operatorname{{{kind}}}") + _bracketed(inner), POWER


def _factors(term: Any) -> list[Any]:
    """Return the factors of a product, and of products in it."""
    return [factor for part in term.parts for factor in (_factors(part) if part.kind == "product" else [part])]


def _signed_letters(term: Any) -> tuple[bool, str]:
    """Return whether a term of a sum is subtracted, and what follows the sign."""
    if term.kind == "marked":
        minus, text = _signed_letters(term.parts[0])
        return minus, marked(text)
    if term.kind == "number" and term.value < 0:
        return True, _number(-term.value)[0]
    if term.kind != "product":
        return False, _inside(_in_letters(term), PRODUCT)
    factors = _factors(term)
    value = prod((part.value for part in factors if part.kind == "number"), start=Fraction(1))
    others = [
        _inside(_in_letters(part), PRODUCT if part.kind == "marked" else POWER)
        for part in factors
        if part.kind != "number"
    ]
    numbers = [] if abs(value) == 1 and others else [_number(abs(value))[0]]
    return value < 0, _multiplied([*numbers, *others])[0]

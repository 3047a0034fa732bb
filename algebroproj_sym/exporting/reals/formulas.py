"""Terms with real functions as formulas of Coq, and relations between them."""

from fractions import Fraction

from algebroproj_sym.exporting.gallina import digits, identifier
from algebroproj_sym.exporting.refusal import Silent
from algebroproj_sym.replaying.reals.definitions import Condition, expanded
from algebroproj_sym.replaying.reals.terms import CALCULUS, Term

_OWN = ("sqrt", "sign", "exp", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh")
APPLIED = {"abs": "Rabs", "log": "ln", **{name: name for name in _OWN}}
"""How functions are called; the others are written by these."""

SIGNS = {"=": "{} = 0", "!=": "{} <> 0", ">": "0 < {}", ">=": "0 <= {}"}
"""Relations to zero."""

_BETWEEN = {"=": ("{0} = {1}", "equal"), "!=": ("{0} <> {1}", "unequal"), ">": ("{1} < {0}", "less")} | {
    ">=": ("{1} <= {0}", "at_most")
}


def called(name: str) -> str:
    """Return the name of a symbol, or of a value that a proof introduces.

    Examples
    --------
    >>> called("x"), called("_2"), called("pi")
    ('x', "v'2", 'PI')
    """
    if name == "pi":
        return "PI"
    return f"v'{name[1:]}" if name[0] == "_" and name[1:].isdecimal() else identifier(name)


_SUM, _SIGN, _PRODUCT, _POWER, _APPLICATION, _ATOM = range(6)
"""How tightly formulas bind."""


def formula(term: Term, within: int = _ATOM) -> str:
    """Return a term as a formula, in brackets if what is around it binds more tightly.

    Examples
    --------
    >>> from algebroproj_sym.replaying.reals.terms import read
    >>> formula(read("x**(2/3) - log(cot(x))/2"), 0)
    '(root 3 x) ^ 2 - ln (cos x / sin x) / 2'
    """
    text, binds = _formula(term)
    return text if binds >= within else f"({text})"


def _formula(term: Term) -> tuple[str, int]:
    kind, value = term.kind, term.value
    if kind in CALCULUS:
        raise Silent("no theorem is written yet for derivatives, integrals and expansions")
    if kind == "number":
        return _number(value)
    if kind in ("symbol", "pi"):
        return called(value or "pi"), _ATOM
    if kind == "+":
        first, *others = term.args
        return formula(first, _SIGN) + "".join(map(_added, others)), _SUM
    if kind == "-":
        return f"- {formula(term.args[0], _POWER)}", _SIGN
    if kind in ("*", "/"):
        return f"{formula(term.args[0], _PRODUCT)} {kind} {formula(term.args[1], _POWER)}", _PRODUCT
    if kind == "^":
        return _power(formula(term.args[0]), value)
    if kind in APPLIED:
        return f"{APPLIED[kind]} {' '.join(map(formula, term.args))}", _APPLICATION
    return _formula(expanded(term)[0])


def _number(value: Fraction) -> tuple[str, int]:
    above, below = digits(abs(value.numerator)), digits(value.denominator)
    text, binds = (above, _ATOM) if value.denominator == 1 else (f"{above} / {below}", _PRODUCT)
    return (text, binds) if value >= 0 else (f"- ({text})", _SIGN)


def _added(term: Term) -> str:
    minus = term.kind == "-"
    return f" {'-' if minus else '+'} {formula(term.args[0] if minus else term, _PRODUCT)}"


def _power(base: str, exponent: Fraction) -> tuple[str, int]:
    taken, size = root(base, exponent.denominator), abs(exponent.numerator)
    raised = taken if size == 1 else f"{taken} ^ {size}"
    if exponent.numerator <= 0:
        return f"1 / {raised if size == 1 else f'({raised})'}", _PRODUCT
    return raised, _ATOM if size == 1 else _POWER


def root(base: str, degree: int) -> str:
    """Return a root of a formula in brackets."""
    return base if degree == 1 else f"(sqrt {base})" if degree == 2 else f"(root {degree} {base})"


def compared(condition: Condition) -> tuple[str, str]:
    """Return a relation of a term to zero as one between two sides, and its proof of that to zero.

    Examples
    --------
    >>> from algebroproj_sym.replaying.reals.terms import read
    >>> compared((">", read("1 - x"))), compared((">=", read("x")))
    (('x < 1', 'less_difference _ _ {}'), ('0 <= x', '{}'))
    """
    relation, term = condition
    if term.kind != "+" or len(term.args) != 2 or term.args[1].kind != "-":
        return SIGNS[relation].format(formula(term, _SUM)), "{}"
    left, right = term.args[0], term.args[1].args[0]
    text, name = _BETWEEN[relation]
    return text.format(formula(left, _SUM), formula(right, _SUM)), f"{name}_difference _ _ {{}}"


def concluded(condition: Condition) -> tuple[str, str]:
    """Return a relation to zero as one between two sides, and the lemma by which it follows.

    Examples
    --------
    >>> from algebroproj_sym.replaying.reals.comparisons import compared as between
    >>> from algebroproj_sym.replaying.reals.terms import read
    >>> concluded(between(read("x"), "<=", read("y")))
    ('x <= y', 'difference_at_most')
    """
    relation, term = condition
    left, right = term.args[0], term.args[1].args[0]
    text, name = _BETWEEN[relation]
    return text.format(formula(left, _SUM), formula(right, _SUM)), f"difference_{name}"

"""What functions are defined as, where terms are defined and smooth, and their derivatives."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction

from algebroproj_sym.replaying.reals.terms import (
    ONE_HALF,
    PI,
    Term,
    constant,
    function,
    negative,
    over,
    plus,
    power,
    times,
)

Condition = tuple[str, Term]
"""A relation, and what it relates to zero."""


def expanded(term: Term) -> tuple[Term, tuple[Condition, ...]]:
    """Return what a derived function is defined as, and what is asked of its arguments beyond that.

    Examples
    --------
    >>> from algebroproj_sym.replaying.reals.terms import read, written
    >>> written(expanded(read("tan(x)"))[0]), written(expanded(read("Abs(x)"))[0])
    ('sin(x)/cos(x)', '(x**2)**(1/2)')
    >>> written(expanded(read("diff(sin(x**2), x)"))[0])
    'cos(x**2)*(2*x)'
    """
    kind = term.kind
    if kind == "diff":
        (whole,) = term.args
        return derivative(whole, term.value), (*conditions(whole), *smoothness(whole, term.value))
    if kind not in _DEFINED:
        return term, ()
    u = term.args[0]
    return _DEFINED[kind](u), tuple((relation, made(u)) for relation, made in _ASKED.get(kind, ()))


def _one(sign: int, u: Term) -> Term:
    return plus(constant(1), u if sign > 0 else negative(u))


def _inverse(name: str) -> Callable[[Term], Term]:
    return lambda u: function(name, over(constant(1), u))


def _reciprocal(name: str) -> Callable[[Term], Term]:
    return lambda u: over(constant(1), function(name, u))


def _exponentials(sign: int, u: Term) -> Term:
    """Return ``exp(u) + sign*exp(-u)``, with one exponential."""
    exp = function("exp", u)
    below = over(constant(1), exp)
    return plus(exp, below if sign > 0 else negative(below))


_TWO = constant(2)
_DEFINED: dict[str, Callable[[Term], Term]] = {
    "sqrt": lambda u: power(u, Fraction(1, 2)),
    "abs": lambda u: power(power(u, 2), Fraction(1, 2)),
    "tan": lambda u: over(function("sin", u), function("cos", u)),
    "cot": lambda u: over(function("cos", u), function("sin", u)),
    "sec": _reciprocal("cos"),
    "csc": _reciprocal("sin"),
    "acos": lambda u: plus(over(PI, _TWO), negative(function("asin", u))),
    "asec": _inverse("acos"),
    "acsc": _inverse("asin"),
    "sinh": lambda u: over(_exponentials(-1, u), _TWO),
    "cosh": lambda u: over(_exponentials(1, u), _TWO),
    "tanh": lambda u: over(_exponentials(-1, u), _exponentials(1, u)),
    "coth": lambda u: over(_exponentials(1, u), _exponentials(-1, u)),
    "sech": lambda u: over(_TWO, _exponentials(1, u)),
    "csch": lambda u: over(_TWO, _exponentials(-1, u)),
    "asinh": lambda u: function("log", plus(u, power(plus(power(u, 2), constant(1)), Fraction(1, 2)))),
    "acosh": lambda u: function("log", plus(u, power(plus(power(u, 2), constant(-1)), Fraction(1, 2)))),
    "atanh": lambda u: times(ONE_HALF, function("log", over(_one(1, u), _one(-1, u)))),
    "acoth": _inverse("atanh"),
    "asech": _inverse("acosh"),
    "acsch": _inverse("asinh"),
}
_ASKED: dict[str, tuple[tuple[str, Callable[[Term], Term]], ...]] = {
    "acosh": ((">=", lambda u: plus(u, constant(-1))),),
    "atanh": ((">", lambda u: _one(1, u)), (">", lambda u: _one(-1, u))),
}


def conditions(term: Term) -> Iterator[Condition]:
    """Yield what must hold for a term to be defined and real, inside first: ``>=``, ``>`` or ``!=`` zero.

    Of an integral, these are the conditions of its ends.

    Examples
    --------
    >>> from algebroproj_sym.replaying.reals.terms import read, written
    >>> [(relation, written(part)) for relation, part in conditions(read("tan(x) + log(1/sqrt(y))"))]
    [('!=', 'cos(x)'), ('>=', 'y'), ('!=', 'sqrt(y)'), ('>', '1/sqrt(y)')]
    """
    for part in term.args[1:] if term.kind == "integrate" else term.args:
        yield from conditions(part)
    if term.kind == "diff":
        yield from smoothness(term.args[0], term.value)
        yield from conditions(derivative(term.args[0], term.value))
        return
    u = term.args[0] if term.args else term
    one = constant(1)
    if term.kind == "/":
        yield "!=", term.args[1]
    elif term.kind == "^":
        if term.value.denominator > 1:
            yield (">=" if term.value > 0 else ">"), u
        elif term.value <= 0:
            yield "!=", u
    elif term.kind in ("tan", "sec"):
        yield "!=", function("cos", u)
    elif term.kind in ("cot", "csc"):
        yield "!=", function("sin", u)
    elif term.kind == "sqrt":
        yield ">=", u
    elif term.kind == "log":
        yield ">", u
    elif term.kind in ("asin", "acos"):
        yield ">=", plus(one, negative(power(u, 2)))
    elif term.kind == "atan2":
        yield "!=", plus(power(u, 2), power(term.args[1], 2))
    elif term.kind in ("coth", "csch", "acsch", "asec", "acsc", "acoth", "asech"):
        yield "!=", u
        if term.kind in ("asec", "acsc"):
            yield ">=", plus(power(u, 2), negative(one))
        elif term.kind == "acoth":
            yield ">", plus(power(u, 2), negative(one))
        elif term.kind == "asech":
            yield from ((">", u), (">=", plus(one, negative(u))))
    elif term.kind == "acosh":
        yield ">=", plus(u, negative(one))
    elif term.kind == "atanh":
        yield ">", plus(one, negative(power(u, 2)))


def smoothness(term: Term, name: str) -> Iterator[Condition]:
    """Yield what must hold, beyond its conditions, for a term to have a derivative by a symbol.

    Each is an inequality that is strict, so that it holds nearby as well.

    Examples
    --------
    >>> from algebroproj_sym.replaying.reals.terms import read, written
    >>> [(relation, written(part)) for relation, part in smoothness(read("sqrt(x) + Abs(x - 1) + sqrt(y)"), "x")]
    [('>', 'x'), ('>', '(x - 1)**2')]
    """
    if name not in term.symbols():
        return
    if term.kind == "diff":
        yield from smoothness(term.args[0], name)
    definition = derivative(*_by(term)) if term.kind == "diff" else expanded(term)[0]
    if definition is not term:
        yield from smoothness(definition, name)
        return
    for part in term.args:
        yield from smoothness(part, name)
    u = term.args[0] if term.args else term
    if term.kind == "^" and term.value.denominator > 1:
        yield ">", u
    elif term.kind == "sign":
        yield "!=", u
    elif term.kind == "asin":
        yield ">", plus(constant(1), negative(power(u, 2)))
    elif term.kind == "atan2":
        x = term.args[1]
        yield ">", plus(power(plus(power(u, 2), power(x, 2)), Fraction(1, 2)), x)


def _by(term: Term) -> tuple[Term, str]:
    return term.args[0], term.value


def derivative(term: Term, name: str) -> Term:
    """Return the derivative by a symbol, where the conditions of `conditions` and `smoothness` hold.

    Examples
    --------
    >>> from algebroproj_sym.replaying.reals.terms import read, written
    >>> written(derivative(read("x**3*log(x)"), "x"))
    '3*x**2*log(x) + x**3*(1/x)'
    """
    if name not in term.symbols():
        return constant(0)
    if term.kind == "diff":
        return derivative(derivative(*_by(term)), name)
    definition = expanded(term)[0]
    if definition is not term:
        return derivative(definition, name)
    if term.kind == "symbol":
        return constant(1)
    u = term.args[0]
    slopes = [derivative(part, name) for part in term.args]
    slope = slopes[0]
    if term.kind == "+":
        return _sum(*slopes)
    if term.kind == "-":
        return negative(slope)
    if term.kind == "*":
        return _sum(_product(slope, term.args[1]), _product(u, slopes[1]))
    if term.kind in ("/", "atan2"):
        v = term.args[1]
        if term.kind == "/" and _is(slopes[1], 0):
            return over(slope, v)
        above = _sum(_product(slope, v), negative(_product(u, slopes[1])))
        return over(above, power(v, 2) if term.kind == "/" else plus(power(u, 2), power(v, 2)))
    if term.kind == "^":
        outer = _product(constant(term.value), u if term.value == 2 else power(u, term.value - 1))
        return constant(0) if term.value == 0 else slope if term.value == 1 else _product(outer, slope)
    return _product(_DERIVATIVES[term.kind](u), slope)


_DERIVATIVES: dict[str, Callable[[Term], Term]] = {
    "exp": lambda u: function("exp", u),
    "log": lambda u: over(constant(1), u),
    "sin": lambda u: function("cos", u),
    "cos": lambda u: negative(function("sin", u)),
    "asin": lambda u: over(constant(1), power(plus(constant(1), negative(power(u, 2))), Fraction(1, 2))),
    "atan": lambda u: over(constant(1), plus(constant(1), power(u, 2))),
    "sign": lambda u: constant(0),
}


def _is(term: Term, value: int) -> bool:
    return term.kind == "number" and bool(term.value == value)


def _sum(*terms: Term) -> Term:
    kept = [term for term in terms if not _is(term, 0) and not (term.kind == "-" and _is(term.args[0], 0))]
    return plus(*kept) if len(kept) > 1 else kept[0] if kept else constant(0)


def _product(left: Term, right: Term) -> Term:
    if _is(left, 0) or _is(right, 0):
        return constant(0)
    return right if _is(left, 1) else left if _is(right, 1) else times(left, right)


def kinds(term: Term) -> frozenset[str]:
    """Return the kinds of all parts of a term, as it is written."""
    return frozenset({term.kind}).union(*map(kinds, term.args))


def is_affine(term: Term, name: str) -> bool:
    """Whether a term is written as one of first degree in a symbol.

    Examples
    --------
    >>> from algebroproj_sym.replaying.reals.terms import read
    >>> [is_affine(read(text), "x") for text in ("sin(y)*(2*x - 1)/3", "x*x", "1/x", "sin(y)")]
    [True, False, False, True]
    """
    if name not in term.symbols() or term.kind == "symbol":
        return True
    others = [part for part in term.args if name in part.symbols()]
    return (
        term.kind in ("+", "-")
        or (term.kind in ("*", "/") and others == [term.args[0]])
        or (term.kind == "*" and others == [term.args[1]])
    ) and all(is_affine(part, name) for part in others)


def replaced(term: Term, name: str, value: Term) -> Term:
    """Return a term without derivatives with a value for a symbol.

    Examples
    --------
    >>> from algebroproj_sym.replaying.reals.terms import read, written
    >>> written(replaced(read("sin(x)/x"), "x", constant(3)))
    'sin(3)/3'
    """
    if name not in term.symbols():
        return term
    if term.kind == "symbol":
        return value
    return Term(term.kind, term.value, tuple(replaced(part, name, value) for part in term.args))

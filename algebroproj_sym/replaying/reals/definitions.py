"""The definitions of functions, where terms are defined and smooth, and their derivatives and expansions."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from functools import lru_cache
from operator import add

from algebroproj_sym.replaying.reals.terms import (
    CALCULUS,
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
from algebroproj_sym.replaying.rejection import require

MOST_PARTS = 20_000
"""How many parts the coefficients of an expansion may have."""

NOT_CONTINUOUS = frozenset({"sign", "atan2"}) | CALCULUS
"""Kinds of terms that are refused where a function must be continuous wherever it is defined."""

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
    if kind == "taylor":
        return expansion(term), (*conditions(term),)
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
    if term.kind == "taylor":
        yield from _analytic_at_zero(term)
        return
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


def _analytic_at_zero(term: Term) -> Iterator[Condition]:
    """Yield what must hold for a term to be analytic where the symbols of its expansion are zero."""
    names, (whole,) = term.value[0], term.args
    for relation, part in (*conditions(whole), *(pair for name in names for pair in smoothness(whole, name))):
        yield relation, expansion(Term("taylor", (names, 0), (part,)))


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
    if term.kind == "taylor":
        for relation, part in conditions(term):
            if name in part.symbols():
                yield from smoothness(part, name)
                yield (">" if relation == ">=" else relation), part
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
    if term.kind == "/":
        v = term.args[1]
        if _is(slopes[1], 0):
            return over(slope, v)
        return over(_sum(_product(slope, v), negative(_product(u, slopes[1]))), power(v, 2))
    return _sum(*map(_product, _partial_derivatives(term), slopes))


def _partial_derivatives(term: Term) -> list[Term]:
    """Return the derivatives of a power, or a function, by its arguments."""
    u = term.args[0]
    if term.kind == "^":
        outer = constant(term.value)
        return [
            constant(0)
            if term.value == 0
            else outer
            if term.value == 1
            else times(outer, u if term.value == 2 else power(u, term.value - 1))
        ]
    if term.kind == "atan2":
        square = plus(power(u, 2), power(term.args[1], 2))
        return [over(term.args[1], square), negative(over(u, square))]
    return [_DERIVATIVES[term.kind](u)]


_DERIVATIVES: dict[str, Callable[[Term], Term]] = {
    "exp": lambda u: function("exp", u),
    "log": lambda u: over(constant(1), u),
    "sin": lambda u: function("cos", u),
    "cos": lambda u: negative(function("sin", u)),
    "asin": lambda u: over(constant(1), power(plus(constant(1), negative(power(u, 2))), Fraction(1, 2))),
    "atan": lambda u: over(constant(1), plus(constant(1), power(u, 2))),
    "sign": lambda u: constant(0),
}


@lru_cache(maxsize=256)
def expansion(term: Term) -> Term:
    """Return the polynomial that ``taylor(f, (x, y), n)`` is: the terms of f up to degree n in x and y.

    It differs from f by what is of order n + 1, where f is analytic at zero.

    It raises `Rejected` if it has too many parts.

    Examples
    --------
    >>> from algebroproj_sym.replaying.reals.terms import read, written
    >>> written(expansion(read("taylor(y*exp(2*x), x, 3)")))
    'y + y*2*x + y*2*x**2 + y*(4/3)*x**3'
    """
    names, order = term.value
    whole = _Expansion(names).parts(term.args[0], order)
    terms = ((_monomial(names, powers), part) for form in whole for powers, part in sorted(form.items(), reverse=True))
    return _sum(*(_product(part, monomial) for monomial, part in terms))


def _monomial(names: Sequence[str], powers: Sequence[int]) -> Term:
    found = constant(1)
    for name, exponent in zip(names, powers, strict=True):
        symbol = Term("symbol", name)
        found = _product(found, power(symbol, exponent) if exponent > 1 else symbol if exponent else constant(1))
    return found


Form = dict[tuple[int, ...], Term]
"""The coefficients of monomials of one degree, without those that are zero."""


class _Expansion:
    """The parts of degree 0, 1, ... in some symbols of terms that are analytic where these are zero."""

    def __init__(self, names: Sequence[str]) -> None:
        self.names = frozenset(names)
        self.one = (0,) * len(names)
        self.variables = {name: tuple(int(name == other) for other in names) for name in names}
        self.size = 0
        self._known: dict[tuple[Term, int], list[Form]] = {}

    def parts(self, term: Term, order: int) -> list[Form]:
        """Return the parts up to an order."""
        if (term, order) not in self._known:
            found = self._parts(term, order)
            self.size += sum(coefficient.size() for form in found for coefficient in form.values())
            require(self.size <= MOST_PARTS, f"an expansion has more than {MOST_PARTS} parts")
            self._known[term, order] = found
        return self._known[term, order]

    def _parts(self, term: Term, order: int) -> list[Form]:
        others: list[Form] = [{} for _ in range(order)]
        if not self.names & term.symbols():
            return [self._constant(term), *others]
        if term.kind == "symbol":
            return [{}, {self.variables[term.value]: constant(1)}, *others][: order + 1]
        definition = expanded(term)[0]
        if definition is not term:
            return self.parts(definition, order)
        args = [self.parts(part, order) for part in term.args]
        if term.kind == "+":
            return [_added(forms) for forms in zip(*args, strict=True)]
        if term.kind == "-":
            return [_negated(form) for form in args[0]]
        if term.kind == "*":
            return [_added(_multiplied(args[0][k], args[1][n - k]) for k in range(n + 1)) for n in range(order + 1)]
        if term.kind == "/":
            return self._quotient(*args)
        at_zero = Term(term.kind, term.value, tuple(self._value(parts) for parts in args))
        found = [self._constant(_at_zero(at_zero)), *others]
        slopes = [self.parts(slope, order - 1) for slope in _partial_derivatives(term)] if order else []
        for parts, slope in zip(args, slopes, strict=False):
            for n in range(1, order + 1):
                shares = ({self.one: constant(Fraction(k, n))} for k in range(1, n + 1))
                moved = (_multiplied(share, parts[k]) for k, share in enumerate(shares, 1))
                found[n] = _added([found[n], *(_multiplied(by, slope[n - k]) for k, by in enumerate(moved, 1))])
        return found

    def _constant(self, term: Term) -> Form:
        return {} if _is(term, 0) else {self.one: term}

    def _value(self, parts: Sequence[Form]) -> Term:
        return parts[0].get(self.one, constant(0))

    def _quotient(self, above: Sequence[Form], below: Sequence[Form]) -> list[Form]:
        divisor, found = self._value(below), list[Form]()
        for n, form in enumerate(above):
            known = _added(_multiplied(found[k], below[n - k]) for k in range(n))
            rest = _added([form, _negated(known)])
            found.append({powers: _ratio(part, divisor) for powers, part in rest.items()})
        return found


def _added(forms: Iterable[Form]) -> Form:
    found: dict[tuple[int, ...], list[Term]] = {}
    for form in forms:
        for powers, part in form.items():
            found.setdefault(powers, []).append(part)
    sums = {powers: _sum(*parts) for powers, parts in found.items()}
    return {powers: part for powers, part in sums.items() if not _is(part, 0)}


def _multiplied(left: Form, right: Form) -> Form:
    return _added(
        {tuple(map(add, ours, theirs)): _product(one, other)}
        for ours, one in left.items()
        for theirs, other in right.items()
    )


def _negated(form: Form) -> Form:
    return {
        powers: constant(-part.value) if part.kind == "number" else part.args[0] if part.kind == "-" else negative(part)
        for powers, part in form.items()
    }


def _at_zero(term: Term) -> Term:
    """Return a power, or a function, of numbers as a number where it is plain."""
    first = term.args[0]
    if first.kind == "number" and term.kind == "^" and term.value.denominator == 1 and (first.value or term.value > 0):
        return constant(first.value**term.value.numerator)
    value = _PLAIN.get((term.kind, first.value)) if first.kind == "number" and len(term.args) == 1 else None
    return term if value is None else constant(value)


_PLAIN = {("sin", 0): 0, ("cos", 0): 1, ("exp", 0): 1, ("log", 1): 0, ("asin", 0): 0, ("atan", 0): 0}


def _is(term: Term, value: int) -> bool:
    return term.kind == "number" and bool(term.value == value)


def _sum(*terms: Term) -> Term:
    number = sum((term.value for term in terms if term.kind == "number"), Fraction(0))
    kept = [term for term in terms if term.kind != "number" and not (term.kind == "-" and _is(term.args[0], 0))]
    kept += [constant(number)] if number or not kept else []
    return plus(*kept) if len(kept) > 1 else kept[0]


def _product(left: Term, right: Term) -> Term:
    if left.kind == right.kind == "number":
        return constant(left.value * right.value)
    if _is(left, 0) or _is(right, 0):
        return constant(0)
    return right if _is(left, 1) else left if _is(right, 1) else times(left, right)


def _ratio(above: Term, below: Term) -> Term:
    if above.kind == below.kind == "number" and below.value:
        return constant(above.value / below.value)
    return above if _is(below, 1) else over(above, below)


def explicit(term: Term) -> Term:
    """Return a term with its derivatives and expansions carried out.

    Examples
    --------
    >>> from algebroproj_sym.replaying.reals.terms import read, written
    >>> written(explicit(read("x*diff(x**2, x)")))
    'x*(2*x)'
    """
    if term.kind == "taylor":
        return expansion(term)
    args = tuple(map(explicit, term.args))
    return derivative(args[0], term.value) if term.kind == "diff" else Term(term.kind, term.value, args)


def kinds(term: Term) -> frozenset[str]:
    """Return the kinds of all parts of a term, as it is written."""
    return frozenset(part.kind for part in term.parts())


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
    if term.kind == "symbol":
        return value if term.value == name else term
    if not term.args or (term.kind in CALCULUS and name not in term.symbols()):
        return term
    return Term(term.kind, term.value, tuple(replaced(part, name, value) for part in term.args))

"""Statements about complex numbers: two statements about real ones, the real and the imaginary parts of both sides.

A complex variable ``z`` has the parts ``z_re`` and ``z_im``; other variables are real, and ``I`` is the imaginary unit.
"""

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any, TypeAlias

from algebroproj_sym.replaying.reals.comparisons import comparisons, equations
from algebroproj_sym.replaying.reals.terms import (
    COMPLEX,
    Term,
    constant,
    function,
    negative,
    over,
    plus,
    power,
    read,
    times,
    written,
)
from algebroproj_sym.replaying.rejection import Rejected, require
from algebroproj_sym.replaying.text import texts

UNIT = "I"
LARGEST_POWER = 12

Parts: TypeAlias = tuple[Term, Term | None]
"""The real and the imaginary part; None for the second one of a number that is real by its form."""

_ZERO, _ONE = constant(0), constant(1)
_REAL_ONE: Parts = (_ONE, None)
_I: Parts = (_ZERO, _ONE)
_WITH_CUTS = {"log", "sqrt", "diff", "integrate", "taylor"}
_NOWHERE_SMOOTH = {"conjugate", "re", "im", "abs", "arg", "sign"}


def real_statements(record: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return what a statement says about real numbers: one statement, or one for each part.

    Each has the domain of all parts of both sides.

    It raises `Rejected` if a function of a complex number is not known here, or what is compared is not real.

    Examples
    --------
    >>> empty = dict.fromkeys(("assumptions", "constraints", "nonzero"), ())
    >>> record = {"lhs": "exp(I*x)", "rhs": "cos(x) + I*sin(x)", "relation": "=", "complex": [], **empty}
    >>> [statement["rhs"] for statement in real_statements(record)]
    ['cos(x) + 0*sin(x)', 'sin(x)']
    """
    names = frozenset(texts(record["complex"]))
    require(UNIT not in names, f"{UNIT} is the imaginary unit, and no variable")
    sides = [_parts(read(record[side]), names) for side in ("lhs", "rhs")]
    stated = {"relation": record["relation"], **_conditions(record, names)}
    (left, left_im), (right, right_im) = sides
    if left_im is None and right_im is None:
        return [{"lhs": written(left), "rhs": written(right), **stated}]
    require(record["relation"] == "=", "complex numbers are equal, or are not compared")
    parts = [part for side in sides for part in side if part is not None]
    domain = times(_ZERO, plus(*parts))
    pairs = ((left, right), (left_im or _ZERO, right_im or _ZERO))
    return [{"lhs": written(plus(domain, a)), "rhs": written(b), **stated} for a, b in pairs]


def _conditions(record: Mapping[str, Any], names: frozenset[str]) -> dict[str, list[str]]:
    assumptions, constraints, nonzero = list[str](), list[str](), list[str]()
    for text in texts(record["assumptions"]):
        for relation, term in comparisons(text):
            real, imaginary = _parts(term, names)
            require(imaginary is None, "what an assumption compares is not real")
            assumptions.append(f"{written(real)} {relation} 0")
    for text in texts(record["constraints"]):
        for _, term in equations(text):
            constraints += [f"{written(part)} = 0" for part in _parts(term, names) if part is not None]
    for text in texts(record["nonzero"]):
        nonzero.append(written(_square(_parts(read(text), names))))
    return {"assumptions": assumptions, "constraints": constraints, "nonzero": nonzero}


def _parts(term: Term, names: frozenset[str]) -> Parts:
    """Return the parts of a term, each defined where the term is."""
    if term.kind == "symbol":
        return _symbol(term, names)
    if term.kind in ("diff", "integrate", "taylor"):
        return _of_calculus(term, names)
    inner = [_parts(part, names) for part in term.args]
    if term.kind in _OPERATIONS:
        return _OPERATIONS[term.kind](*inner)
    if term.kind == "^" and inner[0][1] is not None:
        return _power(inner[0], int(term.value)) if term.value.denominator == 1 else _root(inner[0], term.value)
    if term.kind in _FUNCTIONS and (term.kind in COMPLEX or inner[0][1] is not None):
        return _FUNCTIONS[term.kind](inner[0])
    if any(imaginary is not None for _, imaginary in inner):
        raise Rejected(f"{term.kind} is known here of real numbers alone, got {written(term):.80}")
    return term._replace(args=tuple(real for real, _ in inner)), None


def _symbol(term: Term, names: frozenset[str]) -> Parts:
    if term.value == UNIT:
        return _I
    if term.value in names:
        return Term("symbol", f"{term.value}_re"), Term("symbol", f"{term.value}_im")
    base, _, end = term.value.rpartition("_")
    require(not (base in names and end in ("re", "im")), f"{term.value} is a part of {base}")
    return term, None


def _of_calculus(term: Term, names: frozenset[str]) -> Parts:
    """Return parts of a derivative or an integral over a real variable, or of a derivative by a complex one."""
    (real, imaginary), *ends = (_parts(part, names) for part in term.args)
    variables = term.value[0] if term.kind == "taylor" else (term.value,)
    require(UNIT not in variables, f"{UNIT} is the imaginary unit, and no variable")
    require(all(end is None for _, end in ends), "the ends of an integral are not real")
    require(term.kind != "taylor" or imaginary is None, "taylor is known here of real numbers alone")
    value = term.value
    if names & {*variables}:
        require(term.kind == "diff", f"{term.kind} is known here of real variables alone")
        require(all(map(_is_smooth, term.args[0].parts())), "a derivative by a complex variable of what may have none")
        value = f"{term.value}_re"
    limits = tuple(end for end, _ in ends)
    whole, part = (each and Term(term.kind, value, (each, *limits)) for each in (real, imaginary))
    assert whole is not None
    return whole, part


def _is_smooth(part: Term) -> bool:
    """Whether a function has a derivative by a complex variable wherever it is defined."""
    is_root = part.kind == "^" and part.value.denominator > 1
    return not is_root and part.kind not in _WITH_CUTS | _NOWHERE_SMOOTH


def _sum(*terms: Parts) -> Parts:
    imaginary = [part for _, part in terms if part is not None]
    return plus(*(real for real, _ in terms)), plus(*imaginary) if len(imaginary) > 1 else next(iter(imaginary), None)


def _negative(term: Parts) -> Parts:
    real, imaginary = term
    return negative(real), None if imaginary is None else negative(imaginary)


def _product(left: Parts, right: Parts) -> Parts:
    if _I in (left, right):
        return _turned(right if left == _I else left)
    (a, b), (c, d) = left, right
    if b is None or d is None:
        mixed = None if b is None and d is None else times(a, d) if d is not None else times(b or _ZERO, c)
        return times(a, c), mixed
    return plus(times(a, c), negative(times(b, d))), plus(times(a, d), times(b, c))


def _turned(term: Parts) -> Parts:
    """Return I times a number."""
    real, imaginary = term
    if imaginary is None:
        return _ZERO if real.kind in ("number", "symbol", "pi") else times(_ZERO, real), real
    return negative(imaginary), real


def _quotient(left: Parts, right: Parts) -> Parts:
    c, d = right
    if d is None:
        return over(left[0], c), None if left[1] is None else over(left[1], c)
    real, imaginary = _product(left, (c, negative(d)))
    assert imaginary is not None
    return over(real, _square(right)), over(imaginary, _square(right))


def _square(term: Parts) -> Term:
    """Return the square of the absolute value; of a real number the number itself, which is zero where it is."""
    real, imaginary = term
    return real if imaginary is None else plus(power(real, 2), power(imaginary, 2))


def _power(base: Parts, exponent: int) -> Parts:
    require(abs(exponent) <= LARGEST_POWER, f"a power of a complex number is at most {LARGEST_POWER}")
    found = _sum(_REAL_ONE, (times(_ZERO, plus(*filter(None, base))), None))
    for count in range(abs(exponent)):
        found = _product(found, base) if count else base
    return found if exponent >= 0 else _quotient(_REAL_ONE, found)


def _root(term: Parts, exponent: Fraction) -> Parts:
    """Return the principal power of a number that is not zero."""
    length, angle = power(_absolute(term), exponent), times(constant(exponent), _angle(term))
    return times(length, function("cos", angle)), times(length, function("sin", angle))


def _with(kept: Term, other: Term | None) -> Term:
    """Return one part, defined where the other is."""
    return kept if other is None else plus(kept, times(_ZERO, other))


def _exp(term: Parts) -> Parts:
    cosine, sine = function("cos", _imaginary(term)), function("sin", _imaginary(term))
    if term[0] == _ZERO:
        return cosine, sine
    return times(function("exp", term[0]), cosine), times(function("exp", term[0]), sine)


def _mixed(first: str, second: str, signs: tuple[int, int]) -> Callable[[Parts], Parts]:
    """Return a function such as sin(a + I*b) = sin(a)*cosh(b) + I*cos(a)*sinh(b)."""
    turned = {"sin": ("cosh", "sinh"), "cos": ("cosh", "sinh"), "sinh": ("cos", "sin"), "cosh": ("cos", "sin")}

    def parts(term: Parts) -> Parts:
        a, b = term[0], _imaginary(term)
        even, odd = turned[first]
        products = (function(first, a), function(even, b)), (function(second, a), function(odd, b))
        real, imaginary = (
            times(*each) if sign > 0 else negative(times(*each)) for sign, each in zip(signs, products, strict=True)
        )
        return real, imaginary

    return parts


def _imaginary(term: Parts) -> Term:
    return _ZERO if term[1] is None else term[1]


_sin, _cos = _mixed("sin", "cos", (1, 1)), _mixed("cos", "sin", (1, -1))
_sinh, _cosh = _mixed("sinh", "cosh", (1, 1)), _mixed("cosh", "sinh", (1, 1))


def _log(term: Parts) -> Parts:
    return function("log", _absolute(term)), _angle(term)


def _absolute(term: Parts) -> Term:
    return function("sqrt", plus(power(term[0], 2), power(_imaginary(term), 2)))


def _angle(term: Parts) -> Term:
    return function("atan2", _imaginary(term), term[0])


_OPERATIONS: Mapping[str, Callable[..., Parts]] = {"+": _sum, "-": _negative, "*": _product, "/": _quotient}
_FUNCTIONS: Mapping[str, Callable[[Parts], Parts]] = {
    "re": lambda term: (_with(*term), None),
    "im": lambda term: (_with(_imaginary(term), term[0]), None),
    "conjugate": lambda term: (term[0], None if term[1] is None else negative(term[1])),
    "arg": lambda term: (_angle(term), None),
    "abs": lambda term: (_absolute(term), None),
    "sqrt": lambda term: _root(term, Fraction(1, 2)),
    "exp": _exp,
    "log": _log,
    "sin": _sin,
    "cos": _cos,
    "tan": lambda term: _quotient(_sin(term), _cos(term)),
    "cot": lambda term: _quotient(_cos(term), _sin(term)),
    "sec": lambda term: _quotient(_REAL_ONE, _cos(term)),
    "csc": lambda term: _quotient(_REAL_ONE, _sin(term)),
    "sinh": _sinh,
    "cosh": _cosh,
    "tanh": lambda term: _quotient(_sinh(term), _cosh(term)),
    "coth": lambda term: _quotient(_cosh(term), _sinh(term)),
    "sech": lambda term: _quotient(_REAL_ONE, _cosh(term)),
    "csch": lambda term: _quotient(_REAL_ONE, _sinh(term)),
}

"""From SymPy's expressions, relations and assumed symbols to terms and to the text of conditions."""

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from fractions import Fraction
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from algebroproj_sym.expressions import (
    NotRationalError,
    ParseError,
    SymbolError,
    admits,
    assumption,
    is_plain,
    over,
    symbols_of,
    taylor,
)
from algebroproj_sym.expressions.symbols import is_name
from algebroproj_sym.replaying.reals.comparisons import comparisons, equations
from algebroproj_sym.replaying.reals.complex_numbers import UNIT
from algebroproj_sym.replaying.reals.definitions import Condition, expansion
from algebroproj_sym.replaying.reals.intervals import Intervals
from algebroproj_sym.replaying.reals.terms import (
    ALIASES,
    ARITY,
    COMPLEX,
    FUNCTIONS,
    PI,
    Term,
    UnreadableError,
    constant,
    function,
    has_parts,
    negative,
    plus,
    power,
    read,
    times,
    written,
)
from algebroproj_sym.replaying.reals.terms import over as quotient
from algebroproj_sym.replaying.reals.theory import RESERVED
from algebroproj_sym.replaying.reals.values import value_of
from algebroproj_sym.replaying.rejection import Rejected

MOST_PARTS = 4_000
EULER = function("exp", constant(1))
"""The number e, for which the letter is a symbol."""

_RELATIONS: dict[Any, str] = {
    sympy.Gt: ">",
    sympy.Ge: ">=",
    sympy.Lt: "<",
    sympy.Le: "<=",
    sympy.Eq: "=",
    sympy.Ne: "!=",
}
_SIGNS = {"positive": ">", "negative": "<", "nonnegative": ">=", "nonpositive": "<=", "nonzero": "!="}
_FOLLOWING = {
    "positive": ("nonnegative", "nonzero"),
    "negative": ("nonpositive", "nonzero"),
}
_OF_EVERY_SIGN = [Fraction(p, 2) for p in (-2, -1, 0, 1, 2)]


def term_of(value: Any, argument: str, *, is_complex: bool = False) -> Term:
    """Return text, a number or a SymPy expression as a term, as it stands.

    It raises `ParseError` if a text is not in the grammar.  It raises `NotRationalError` if an expression has a part
    that is not a real function known here.

    Examples
    --------
    >>> x = sympy.Symbol("x")
    >>> written(term_of(sympy.sqrt(1 - x**2) / sympy.tan(x), "lhs"))
    '(1 - x**2)**(1/2)/tan(x)'
    """
    if isinstance(value, str):
        return _read(value, argument)
    if isinstance(value, int | Fraction) and not isinstance(value, bool):
        return constant(Fraction(value))
    if isinstance(value, sympy.MatrixBase):
        raise NotRationalError(f"{argument}: expected scalars in a statement with functions, got a matrix")
    if not isinstance(value, sympy.Expr):
        raise NotRationalError(f"{argument}: expected an expression, got {value!r:.80} ({type(value).__name__})")
    if sum(1 for _ in sympy.preorder_traversal(value)) > MOST_PARTS:
        raise NotRationalError(f"{argument}: expected at most {MOST_PARTS} parts")
    if not is_complex and has_complex_parts(value):
        raise NotRationalError(f"{argument}: expected real numbers, got {str(value)[:80]}")
    return _read(written(_term(value, argument)), argument)


def has_complex_parts(value: Any) -> bool:
    """Whether text or an expression has I, as SymPy's number, re, im, conjugate or arg.

    Examples
    --------
    >>> z = sympy.Symbol("z")
    >>> [has_complex_parts(value) for value in (sympy.exp(sympy.I * z), "conjugate(z)", "I*z", z)]
    [True, True, False, False]
    """
    if isinstance(value, str):
        return has_parts(value)
    return isinstance(value, sympy.Basic | sympy.MatrixBase) and value.has(
        sympy.I, sympy.re, sympy.im, sympy.conjugate, sympy.arg
    )


def _read(text: str, argument: str) -> Term:
    try:
        found = _unreserved(read(text), argument)
        for part in found.parts():
            if part.kind == "taylor":
                expansion(part)
    except UnreadableError as error:
        raise ParseError(error.position, error.expected, error.got, argument) from None
    except Rejected as error:
        raise NotRationalError(f"{argument}: expected fewer terms, {error}") from None
    return found


def _unreserved(term: Term, argument: str) -> Term:
    for name in term.symbols():
        if RESERVED.fullmatch(name) or name in FUNCTIONS:
            raise SymbolError(f"{argument}: expected another name than {name}, which is reserved")
        if not is_name(name):
            raise SymbolError(f"{argument}: expected a name such as x, x_1, alpha or x', got {name!r}")
    return term


def _term(node: Any, argument: str) -> Term:
    if isinstance(node, sympy.Symbol):
        return _unreserved(Term("symbol", node.name), argument)
    if isinstance(node, sympy.Rational) and node.is_finite:
        return constant(Fraction(int(node.p), int(node.q)))
    if node is sympy.pi:
        return PI
    if node is sympy.I:
        return Term("symbol", UNIT)
    if node is sympy.E:
        return function("exp", constant(1))
    if isinstance(node, over):
        return quotient(_term(node.args[0], argument), _term(node.args[1], argument))
    if isinstance(node, sympy.Add):
        return plus(*(_term(part, argument) for part in node.args))
    if isinstance(node, sympy.Mul):
        return _product(node, argument)
    if isinstance(node, sympy.Pow):
        base = _term(node.base, argument)
        if isinstance(node.exp, sympy.Rational):
            return power(base, Fraction(int(node.exp.p), int(node.exp.q)))
        return function("exp", times(_term(node.exp, argument), function("log", base)))
    if isinstance(node, sympy.Derivative) and all(order.is_Integer for _, order in node.variable_count):
        found = _term(node.expr, argument)
        for symbol, order in node.variable_count:
            if not isinstance(symbol, sympy.Symbol):
                raise NotRationalError(f"{argument}: expected a derivative by a symbol, got one by {str(symbol)[:80]}")
            name = _unreserved(Term("symbol", symbol.name), argument).value
            for _ in range(int(order)):
                found = Term("diff", name, (found,))
        return found
    if isinstance(node, sympy.Integral) and len(node.limits) == 1:
        variable, *ends = node.limits[0]
        if len(ends) != 1:
            name = _unreserved(Term("symbol", variable.name), argument).value
            return Term("integrate", name, tuple(_term(part, argument) for part in (node.function, *ends)))
    if isinstance(node, taylor):
        whole, variables, degree = node.args
        given = variables if isinstance(variables, sympy.Tuple) else (variables,)
        names = tuple(_unreserved(Term("symbol", symbol.name), argument).value for symbol in given)
        return Term("taylor", (names, int(degree)), (_term(whole, argument),))
    name = type(node).__name__
    name = ALIASES.get(name, name)
    is_own = isinstance(node, sympy.Function) and not isinstance(node, AppliedUndef)
    if is_own and (ARITY.get(name) == len(node.args) or name in COMPLEX):
        return function(name, *(_term(part, argument) for part in node.args))
    known = ", ".join(sorted(ARITY))
    raise NotRationalError(
        f"{argument}: expected + - * /, powers, derivatives, integrals, taylor and the functions {known}, "
        f"got {str(node)[:80]}"
    )


def _product(node: sympy.Mul, argument: str) -> Term:
    first = node.args[0]
    if isinstance(first, sympy.Rational) and first < 0:
        others = node.args[1:] if first == -1 else (-first, *node.args[1:])
        rest = others[0] if len(others) == 1 else sympy.Mul(*others, evaluate=False)
        return negative(_term(rest, argument))
    above, below = list[Term](), list[Term]()
    for part in node.args:
        if isinstance(part, sympy.Pow) and isinstance(part.exp, sympy.Integer) and part.exp < 0:
            base = _term(part.base, argument)
            below.append(base if part.exp == -1 else power(base, int(-part.exp)))
        else:
            above.append(_term(part, argument))
    top = above[0] if above else constant(1)
    for part in above[1:]:
        top = times(top, part)
    if not below:
        return top
    bottom = below[0]
    for part in below[1:]:
        bottom = times(bottom, part)
    return quotient(top, bottom)


def condition_of(value: Any, argument: str) -> str:
    """Return an assumption as text: a SymPy relation, or text with a comparison.

    Examples
    --------
    >>> x = sympy.Symbol("x")
    >>> condition_of(x > 0, "assumptions[0]"), condition_of("0 < x < pi", "assumptions[0]")
    ('x > 0', '0 < x < pi')
    """
    if isinstance(value, str):
        _require_known(comparisons, value, argument)
        return value
    sign = _RELATIONS.get(type(value))
    if sign is None:
        raise TypeError(f"{argument}: expected a relation such as x > 0, got {value!r:.80}")
    left, right = (written(term_of(side, argument)) for side in (value.lhs, value.rhs))
    return f"{left} {sign} {right}"


def _require_known(read_all: Callable[[str], tuple[Condition, ...]], text: str, argument: str) -> None:
    """Reject a text that cannot be read, or has names that are reserved."""
    try:
        for _, term in read_all(text):
            _unreserved(term, argument)
    except UnreadableError as error:
        raise ParseError(error.position, error.expected, error.got, argument) from None


def zero_of(value: Any, argument: str) -> str:
    """Return a constraint as the text of an equation."""
    if isinstance(value, str):
        _require_known(equations, value, argument)
        return value if "=" in value else f"{value} = 0"
    return f"{written(term_of(value, argument))} = 0"


def symbols_in(values: Iterable[Any]) -> list[sympy.Symbol]:
    """Return the symbols of expressions, matrices and relations, but no variables of integrals with ends.

    Examples
    --------
    >>> x, a = sympy.symbols("x a")
    >>> symbols_in([sympy.Integral(x, (x, 0, a)), "text"])
    [a]
    """
    forms = [side for value in values for side in (value.args if isinstance(value, sympy.Rel) else (value,))]
    given = [form for form in forms if isinstance(form, sympy.Expr | sympy.MatrixBase)]
    integrals = {integral for form in given for integral in form.atoms(sympy.Integral)}
    bound = {limit[0] for integral in integrals for limit in integral.limits if len(limit) == 3}
    return [symbol for symbol in symbols_of(given) if symbol not in bound]


def assumed_of(symbols: Iterable[sympy.Symbol]) -> Iterator[str]:
    """Yield what SymPy assumes of symbols, as text.

    It raises `SymbolError` if something is assumed that is not a sign.

    Examples
    --------
    >>> [*assumed_of([sympy.Symbol("x", positive=True), sympy.Symbol("y")])]
    ['x > 0']
    """
    for symbol in sorted(symbols, key=lambda symbol: symbol.name):
        if is_plain(symbol):
            continue
        signs = [fact for fact in _SIGNS if symbol.assumptions0.get(fact)]
        if any(admits(symbol, value) != _has_signs(value, signs) for value in _OF_EVERY_SIGN):
            raise SymbolError(
                f"assumptions: expected symbols for real numbers of a sign, got one with more: {assumption(symbol)}"
            )
        implied = {more for fact in signs for more in _FOLLOWING.get(fact, ())}
        for fact in signs:
            if fact not in implied:
                yield f"{symbol.name} {_SIGNS[fact]} 0"


def _has_signs(value: Fraction, signs: Iterable[str]) -> bool:
    number = sympy.Rational(value.numerator, value.denominator)
    return all(getattr(number, f"is_{fact}") for fact in signs)


def witness_of(given: Any, names: Collection[str]) -> dict[str, Fraction]:
    """Return a point by name, with rational numbers as values.

    It raises `TypeError` if it is not a mapping.  It raises `ValueError` if a name does not occur, or a value is not a
    rational number.

    Examples
    --------
    >>> witness_of({"x": "1/2"}, {"x"})
    {'x': Fraction(1, 2)}
    """
    if not isinstance(given, Mapping):
        raise TypeError(f"witness: expected a mapping of symbols to numbers, got {type(given).__name__}")
    found = {}
    for key, number in given.items():
        name = str(getattr(key, "name", key))
        if name not in names:
            known = ", ".join(sorted(names)) or "none"
            raise ValueError(f"witness: expected values for symbols that occur ({known}), got one for {name!r:.120}")
        term = term_of(number, f"witness, {name}")
        try:
            value = None if term.symbols() else value_of(term, {}, Intervals(64))
        except ArithmeticError:
            value = None
        if not isinstance(value, Fraction):
            raise ValueError(f"witness, {name}: expected a rational number, got {number!s:.80}")
        found[name] = value
    return found


def _positive(name: str) -> sympy.Symbol:
    return sympy.Symbol(name, positive=True)


def expression_of(term: Term, symbol: Callable[[str], sympy.Symbol] = _positive) -> sympy.Expr:
    """Return a term as SymPy has it, in positive symbols or in those that are made.

    Examples
    --------
    >>> expression_of(_read("abs(sin(x))/sqrt(2)", "lhs"))
    sqrt(2)*Abs(sin(x))/2
    """
    kind, value, args = term
    if kind == "number":
        return sympy.Rational(value.numerator, value.denominator)
    if kind == "symbol":
        return symbol(value)
    if kind == "pi":
        return sympy.pi
    parts = [expression_of(each, symbol) for each in args]
    if kind == "^":
        return parts[0] ** sympy.Rational(value.numerator, value.denominator)
    return _OPERATIONS[kind](*parts) if kind in _OPERATIONS else getattr(sympy, _NAMES.get(kind, kind))(*parts)


_OPERATIONS: Mapping[str, Any] = {"+": sympy.Add, "*": sympy.Mul, "-": lambda u: -u, "/": lambda u, v: u / v}
_NAMES = {"abs": "Abs"}


def number_of(term: Term) -> Any:
    """Return a number that a term is, as a fraction if it is one, else as SymPy has it.

    Examples
    --------
    >>> number_of(_read("1/2", "x")), number_of(_read("pi/4", "x"))
    (Fraction(1, 2), pi/4)
    """
    if term == EULER:
        return sympy.exp(1, evaluate=False)
    found = expression_of(term)
    return Fraction(int(found.p), int(found.q)) if isinstance(found, sympy.Rational) else found


def settled(term: Term) -> Term:
    """Return a number in the form in which SymPy writes it.

    It raises `NotRationalError` if that form is not read as the same number.

    Examples
    --------
    >>> written(settled(_read("2*pi/4 - 0", "x")))
    'pi/2'
    """
    if term == EULER:
        return term
    found = expression_of(term)
    text = str(found)
    if found.is_real is not True or found.has(sympy.E) or has_complex_parts(found):
        raise NotRationalError(f"expected a real number, got {text[:80]}")
    return _read(text, "a coordinate")

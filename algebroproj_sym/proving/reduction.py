"""The shortest way to write a rational function: cancelled, numerator and denominator factored."""

import sympy

from algebroproj_sym.expressions import Expression, divided, entries, evaluate, symbols_of, written
from algebroproj_sym.proving.rational_function import RationalFunction, RationalFunctionField

MOST_TERMS = 2000


def reduced(expression: Expression) -> Expression:
    """Return a rational expression, defined somewhere, in lowest terms, or as it is if that is shorter.

    The result is the same rational function; divisors that cancel are no longer seen in it.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> reduced((x**2 - y**2) / (x**2 + 2*x*y + y**2))
    (x - y)/(x + y)
    """
    field = RationalFunctionField(symbols_of((expression,)), "flint")
    values = evaluate(expression, field.variables, field.lift)
    written = [_written(divided(entry), value) for entry, value in zip(entries(expression), values, strict=True)]
    if isinstance(expression, sympy.MatrixBase):
        return sympy.ImmutableDenseMatrix(*expression.shape, written)
    return written[0]


def _written(entry: sympy.Expr, value: RationalFunction) -> sympy.Expr:
    """Return the shorter of an entry and its lowest terms; an expanded form of very many terms is never shorter."""
    if len(value.numerator) > MOST_TERMS:
        return entry
    return _shorter(entry, _lowest_terms(value))


def _lowest_terms(value: RationalFunction) -> sympy.Expr:
    field = value.field
    if value.is_zero:
        return sympy.Integer(0)
    content, factors = field.irreducible(value.numerator)
    exponents = {field.place(factor): count for factor, count in factors}
    for place, count in value.denominator:
        exponents[place] = exponents.get(place, 0) - count
    powers = [field.expression(field.factors[place]) ** count for place, count in sorted(exponents.items()) if count]
    return sympy.Rational(content.numerator, content.denominator) * sympy.Mul(*powers)


def _shorter(first: sympy.Expr, second: sympy.Expr) -> sympy.Expr:
    return first if len(written(first)) <= len(written(second)) else second

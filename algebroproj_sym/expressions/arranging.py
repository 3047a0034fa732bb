"""Arranged forms: equal expressions whose terms and factors are in the order in which they are shown.

SymPy has an order of its own and multiplies numbers out: ``3*(y - x)`` becomes ``-3*x + 3*y``.  What is built here
stays as it is.
"""

from collections.abc import Iterable
from functools import lru_cache
from typing import Any

import sympy

from algebroproj_sym.expressions.quotient import over
from algebroproj_sym.expressions.size import size

LONG = 1500
"""Symbols and numbers of the largest form that is put in order."""
REMEMBERED = 1 << 16


def arranged(statement: Any) -> Any:
    """Return a form whose parts are stored in the order in which SymPy shows them; a long one stays as it is."""
    if isinstance(statement, tuple):
        return tuple(map(arranged, statement))
    if not isinstance(statement, sympy.Basic | sympy.MatrixBase) or size(statement, LONG) > LONG:
        return statement
    if isinstance(statement, sympy.MatrixBase):
        return sympy.ImmutableDenseMatrix(*statement.shape, list(map(_arranged, statement.flat())))
    return _arranged(statement)


@lru_cache(maxsize=REMEMBERED)
def value_of(form: Any) -> Any:
    """Return the expression that an arranged form stands for."""
    return form.func(*map(value_of, form.args)) if form.args else form


@lru_cache(maxsize=REMEMBERED)
def _arranged(node: Any) -> Any:
    if not node.args:
        return node
    if isinstance(node, sympy.Mul):
        return numbers_first(map(_arranged, node.as_ordered_factors()))
    return with_parts(node, map(_arranged, node.as_ordered_terms() if isinstance(node, sympy.Add) else node.args))


def sum_of(first: Any, *others: Any) -> Any:
    """Return a sum that keeps the order of its terms; where the first one is a sum, it is continued."""
    return sympy.Add(*(first.args if isinstance(first, sympy.Add) else (first,)), *others, evaluate=False)


def product_of(*forms: Any) -> Any:
    """Return a product that keeps the order of its factors."""
    return sympy.Mul(*(factor for form in forms for factor in _factors(form)), evaluate=False)


def power_of(base: Any, exponent: Any) -> Any:
    """Return a power."""
    return sympy.Pow(base, exponent, evaluate=False)


def quotient_of(above: Any, below: Any) -> Any:
    """Return a product whose divisors come last."""
    if below == 1:
        return above
    numerators = [] if above == 1 else _factors(above)
    return sympy.Mul(*numerators, *map(_inverted, _factors(below)), evaluate=False)


def negated(form: Any) -> Any:
    """Return a form with the other sign, which its number takes.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> sum_of(y, negated(product_of(2, x)), negated(y)).args
    (y, -2*x, -y)
    """
    first, *others = _factors(form)
    if not first.is_Rational:
        return sympy.Mul(-1, first, *others, evaluate=False)
    kept = [] if first == -1 and others else [-first]
    return sympy.Mul(*kept, *others, evaluate=False)


def with_parts(node: Any, parts: Iterable[Any]) -> Any:
    """Return a form of the same kind, of other parts."""
    return over(*parts) if isinstance(node, over) else node.func(*parts, evaluate=False)


def numbers_first(parts: Iterable[Any]) -> Any:
    """Return a product of the factors of some products, with their numbers as one before them."""
    factors = [factor for part in parts for factor in _factors(part)]
    number = sympy.Mul(*(factor for factor in factors if factor.is_Number))
    others = [factor for factor in factors if not factor.is_Number]
    return sympy.Mul(*([] if number == 1 and others else [number]), *others, evaluate=False)


def _factors(form: Any) -> tuple[Any, ...]:
    return form.args if isinstance(form, sympy.Mul) else (form,)


def _inverted(factor: Any) -> Any:
    base, exponent = factor.args if factor.is_Pow else (factor, sympy.S.One)
    return base if exponent == -1 else sympy.Pow(base, -exponent, evaluate=False)

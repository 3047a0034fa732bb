"""The factored form of a kernel: each entry as a quotient of products of irreducible factors.

A derivative, for one, is a difference of quotients by the quotient rule, where factors may cancel between the two.
"""

from collections import Counter
from collections.abc import Mapping
from dataclasses import replace
from typing import TypeAlias

import sympy

from algebroproj_sym.declaring import Kernel
from algebroproj_sym.expressions import Matrix, Scalar, entries, evaluate, over, shape
from algebroproj_sym.proving import RationalFunction, RationalFunctionField

Abbreviations: TypeAlias = "tuple[tuple[sympy.Symbol, sympy.Expr], ...]"

LONGEST = 12
"""Factors with more terms than that are not written out: their sums would have no form that keeps digits."""

LARGEST = 500
"""Numerators with more terms than that are not factored."""


def factored(kernel: Kernel) -> Kernel | None:
    """Return a kernel with its results in factored form, None if that has long factors or there are stages.

    Examples
    --------
    >>> from algebroproj_sym.declaring.kernel import declared_kernel
    >>> x, y = sympy.symbols("x y")
    >>> told = {"arguments": {"x": x, "y": y}, "describe": {"x": "", "y": ""}, "example": {"x": "1", "y": "2"}}
    >>> difference = over(x, y) - over(x**2, x * y + y**2)
    >>> factored(declared_kernel("p", "1", "m.f", "F.", derived=difference, claims=["1"], **told)).form
    over(x, x + y)
    """
    if kernel.stages:
        return None
    field = RationalFunctionField(kernel.symbols, "flint")
    names = _abbreviations(kernel, field)
    forms = list[Scalar]()
    for value in evaluate(kernel.derived, field.variables, field.lift):
        form = _quotient(value, names)
        if form is None:
            return None
        forms.append(form)
    used = {symbol for form in forms for symbol in form.free_symbols}
    results, rest = [], iter(forms)
    for result in kernel.results:
        size = shape(result.derived)
        written = [next(rest) for _ in entries(result.derived)]
        columns = size[1] if len(size) > 1 else 1
        results.append(replace(result, form=Matrix(size[0], columns, written) if size else written[0]))
    return replace(kernel, results=tuple(results), where=_needed(kernel.where, used))


def _abbreviations(kernel: Kernel, field: RationalFunctionField) -> dict[int, Scalar]:
    """Return the abbreviations that are irreducible polynomials, up to sign, by the places of those."""
    values = dict(field.variables)
    names: dict[int, Scalar] = {}
    for symbol, expression in kernel.where:
        (values[symbol],) = evaluate(expression, values, field.lift)
        if not values[symbol].denominator and _is_small(values[symbol]):
            content, factors = field.irreducible(values[symbol].numerator)
            if abs(content) == 1 and [count for _, count in factors] == [1]:
                names.setdefault(field.place(factors[0][0]), int(content) * symbol)
    return names


def _quotient(value: RationalFunction, names: Mapping[int, Scalar]) -> Scalar | None:
    """Return a rational function as a quotient of products of irreducible factors, None if one of them is long.

    A constant fraction has no form without division of integers.
    """
    if value.is_zero:
        return sympy.Integer(0)
    if not _is_small(value):
        return None
    field = value.field
    content, factors = field.irreducible(value.numerator)
    if not (factors or value.denominator) and content.denominator != 1:
        return None
    powers = Counter({field.place(factor): count for factor, count in factors})
    powers.subtract(dict(value.denominator))
    above, below = [sympy.Integer(content.numerator)], [sympy.Integer(content.denominator)]
    for place, count in powers.items():
        factor = field.factors[place]
        if place not in names and len(factor) > LONGEST:
            return None
        (above if count > 0 else below).append(names.get(place, field.expression(factor)) ** abs(count))
    return over(sympy.Mul(*above), sympy.Mul(*below))


def _is_small(value: RationalFunction) -> bool:
    return 0 < len(value.numerator) <= LARGEST


def _needed(where: Abbreviations, used: set[sympy.Symbol]) -> Abbreviations:
    """Return the abbreviations that are used, and those that these are made of."""
    kept = []
    for symbol, expression in reversed(where):
        if symbol in used:
            used = used | expression.free_symbols
            kept.append((symbol, expression))
    return tuple(reversed(kept))

r"""Factorials of numbers that differ by a whole one: each is a multiple of the inverse of one of them.

The inverse of a factorial has a value everywhere, zero for -1, -2 and so on: ``1/n! = (n + 1)/(n + 1)!`` always holds.
So ``\binom{n}{k} = n! \cdot 1/k! \cdot 1/(n - k)!`` holds for every k, if n is no negative whole number.
"""

from collections.abc import Callable, Mapping
from math import prod
from typing import Any

import sympy

from algebroproj_sym.expressions import over
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.evaluating import MOST_FACTORIAL

MOST_SHIFTS = 20
"""By how much numbers may differ whose factorials are multiples of one letter."""
_OF_HALF = over(2, sympy.sqrt(sympy.pi))
Letter = Callable[[Any], Any]


def inverse_factorial(value: Any, letter: Letter) -> Any:
    """Return 1/value!, as a multiple of the one that is a letter.

    Examples
    --------
    >>> n = sympy.Symbol("n")
    >>> inverse_factorial(n - 2, lambda base: sympy.Symbol(f"inverse_{base}"))
    inverse_n*n*(n - 1)
    """
    first, base, shift = _parts(value, letter)
    if base == 0:
        return over(1, sympy.factorial(shift)) if shift >= 0 else sympy.S.Zero
    if shift > 0:
        return first * over(1, _rising(base, shift))
    return first * prod(base - i for i in range(-shift))


def factorial(value: Any, letter: Letter) -> Any:
    """Return value!, as a multiple of the inverse of a letter.

    Examples
    --------
    >>> n = sympy.Symbol("n")
    >>> factorial(n + 1, lambda base: sympy.Symbol(f"inverse_{base}"))
    (n + 1)*over(1, inverse_n)
    """
    first, base, shift = _parts(value, letter)
    if base == 0 and shift < 0:
        raise UnreadableError("a negative whole number has no factorial")
    if base == 0:
        return sympy.factorial(shift)
    if shift > 0:
        return _rising(base, shift) * over(1, first)
    return over(1, first * prod(base - i for i in range(-shift)))


def binomial(above: Any, below: Any, letter: Letter) -> Any:
    """Return a binomial coefficient of factorials; None if the upper number may be negative, where customs differ."""
    if sympy.expand(above).as_coeff_Add()[1].could_extract_minus_sign() or (above.is_number and not above >= 0):
        return None
    inverse = inverse_factorial(below, letter) * inverse_factorial(above - below, letter)
    return factorial(above, letter) * inverse if inverse != 0 or above.is_number else None


def sum_of_binomials(
    body: Any, index: Any, last: Any, inverses: Mapping[Any, Any], is_fixed: Callable[[Any], bool]
) -> Any:
    r"""Return ``(x + y)^n`` for ``\sum_{k=0}^n \frac{x^k y^{n-k}}{k! (n-k)!}``, ``1/n!`` times this; else None.

    The letters of inverse factorials are given with what they are of, and what does not depend on the index.
    """
    factors = [*sympy.Mul.make_args(body)]
    known = [inverses[each] for each in factors if each in inverses]
    if sorted(map(str, known)) != sorted(map(str, (index, last - index))):
        return None
    first, second = sympy.S.One, sympy.S.One
    for factor in factors:
        if factor in inverses:
            continue
        base, exponent = factor.as_base_exp()
        count = sympy.expand(exponent).coeff(index)
        rest = sympy.expand(exponent - count * index)
        if not count.is_Integer or not is_fixed(base) or (rest != 0 and sympy.expand(rest + count * last) != 0):
            return None
        first, second = (first * base**count, second) if rest == 0 else (first, second * base**-count)
    return (first + second) ** last


def _parts(value: Any, letter: Letter) -> tuple[Any, Any, int]:
    """Return the inverse factorial of a base, the base, and the whole number that is added to it."""
    value = value.replace(over, lambda above, below: above / below if below.is_Rational else over(above, below))
    number, rest = sympy.expand(value).as_coeff_Add()
    shift = int(sympy.floor(number)) if number.is_Rational else 0
    if (abs(shift) > MOST_SHIFTS and rest + number != shift) or shift > MOST_FACTORIAL:
        shift = 0
    base = rest + number - shift
    first = sympy.S.One if base == 0 else _OF_HALF if base == sympy.S.Half else letter(base)
    return first, base, shift


def _rising(base: Any, count: int) -> Any:
    return prod(base + i for i in range(1, count + 1))

"""Rounding: the decimal number that is printed for an exact one."""

from decimal import Decimal
from fractions import Fraction
from math import floor
from typing import Literal, get_args

Rounding = Literal["nearest", "cut"]
ROUNDINGS: tuple[Rounding, ...] = get_args(Rounding)


def rounded(exact: Fraction, decimals: int, rounding: Rounding = "nearest") -> Decimal:
    """Return a number with so many digits after the decimal point.

    It is the nearest such number, of two nearest ones that with the larger absolute value; or all further digits are
    cut off, which goes towards zero.

    Examples
    --------
    >>> str(rounded(Fraction(2, 3), 3)), str(rounded(Fraction(-2, 3), 3, "cut"))
    ('0.667', '-0.666')
    >>> str(rounded(Fraction(25, 2), 0)), str(rounded(Fraction(-25, 2), 0))
    ('13', '-13')
    """
    units = abs(exact) * 10**decimals
    whole = floor(units + Fraction(1, 2)) if rounding == "nearest" else floor(units)
    return Decimal((int(exact < 0 < whole), tuple(map(int, str(whole))), -decimals))


def decimals(printed: Decimal) -> int:
    """Return how many digits a decimal number has after the point.

    Examples
    --------
    >>> decimals(Decimal("0.5756072")), decimals(Decimal("-12"))
    (7, 0)
    """
    return -int(printed.as_tuple().exponent)


def leading(exact: Fraction, digits: int) -> str:
    """Return the first digits after the point of an exact number, with dots if there are more.

    Examples
    --------
    >>> leading(Fraction(2, 3), 4), leading(Fraction(-1, 2), 4), leading(Fraction(-1, 30), 1)
    ('0.6666…', '-0.5000', '-0.0…')
    """
    shown = rounded(abs(exact), digits, "cut")
    return f"{'-' * (exact < 0)}{shown:f}{'' if Fraction(shown) == abs(exact) else '…'}"

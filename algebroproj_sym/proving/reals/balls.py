"""Ball arithmetic of FLINT for the values of terms."""

from fractions import Fraction
from typing import Any

import flint

from algebroproj_sym.expressions.exact import fmpq
from algebroproj_sym.replaying.reals.values import Numbers, UndecidedError


class Balls(Numbers):
    """Real balls at the precision of FLINT's context.

    Examples
    --------
    >>> numbers = Balls()
    >>> numbers.sign(numbers.operation("plus", numbers.pi(), Fraction(-22, 7)))
    -1
    """

    def enclosed(self, value: Fraction) -> Any:
        """Return a ball around a rational number."""
        return flint.arb(fmpq(value))

    def sign(self, value: Any) -> int:
        """Return the sign of a number, or of all numbers of a ball."""
        if value == 0:
            return 0
        if value > 0 or value < 0:
            return 1 if value > 0 else -1
        raise UndecidedError

    def even(self, value: Any) -> Any:
        """Return the part of a ball that is not negative."""
        return value if isinstance(value, Fraction) else value.nonnegative_part()

    def plus(self, left: Any, right: Any) -> Any:
        """Return a sum."""
        return _finite(left + right)

    def times(self, left: Any, right: Any) -> Any:
        """Return a product."""
        return _finite(left * right)

    def over(self, left: Any, right: Any) -> Any:
        """Return a quotient by what is not zero."""
        return _finite(left / right)

    def _root(self, value: Any, degree: int) -> Any:
        return _finite(value.nonnegative_part().root(degree))

    def _exp(self, value: Any) -> Any:
        if not abs(value) < 1000:
            raise UndecidedError
        return value.exp()

    def _log(self, value: Any) -> Any:
        return _finite(value.log())

    def _sin(self, value: Any) -> Any:
        return _finite(value.sin())

    def _cos(self, value: Any) -> Any:
        return _finite(value.cos())

    def _atan(self, value: Any) -> Any:
        return _finite(value.atan())

    def _asin(self, value: Any) -> Any:
        return _finite(value.asin())

    def _pi(self) -> Any:
        return flint.arb.pi()


def _finite(value: Any) -> Any:
    if not value.is_finite():
        raise UndecidedError
    return value

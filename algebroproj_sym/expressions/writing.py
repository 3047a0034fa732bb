"""Expressions as text: as `str` of SymPy writes them, or with every division that was made."""

from functools import lru_cache
from typing import Any

import sympy
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.str import StrPrinter

from algebroproj_sym.expressions.quotient import over

REMEMBERED = 1 << 18


class _WithFractions(StrPrinter):  # type: ignore[misc]
    """SymPy's printer, except that a remembered quotient is written as a fraction."""

    _divisors: frozenset[Any] = frozenset()
    _in_product = False

    def _print_Mul(self, node: Any) -> str:  # noqa: N802 - SymPy calls it so
        outer = self._divisors, self._in_product
        self._divisors, self._in_product = frozenset(each.base for each in node.args if each.is_Pow), True
        try:
            return str(super()._print_Mul(node))
        finally:
            self._divisors, self._in_product = outer

    def _print_over(self, node: Any) -> str:
        outer, self._in_product = self._in_product, False
        try:
            parts = zip(node.args, ("Add", "Mul"), strict=True)
            above, below = (self.parenthesize(each, PRECEDENCE[of]) for each, of in parts)
        finally:
            self._in_product = outer
        return f"{above}/({below})" if below.startswith("1/") else f"{above}/{below}"

    def parenthesize(self, item: Any, level: int, strict: bool = False) -> str:
        """Return the text of a part, in parentheses if it does not bind tightly enough; SymPy forgets some divisors."""
        if isinstance(item, over):
            binds = level < PRECEDENCE["Mul"] and item not in self._divisors
            return str(self._print(item)) if binds else f"({self._print(item)})"
        found = str(super().parenthesize(item, level, strict))
        factor = self._in_product and PRECEDENCE["Add"] <= level <= PRECEDENCE["Mul"]
        divides = factor and (item.is_Rational or found.startswith("1/"))
        return f"({found})" if divides and "/" in found and not found.startswith("(") else found


def written(expression: Any, *, ordered: bool = True, fractions: bool = False) -> str:
    """Return an expression, a matrix or a tuple of expressions as SymPy writes it.

    Terms and factors are put in order, as `str` does, or left as they are stored.  With `fractions` a remembered
    quotient is written as a fraction, so that the text shows every division that was made.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> written((x + y) * y**2 / (2 * x) - 1)
    '-1 + y**2*(x + y)/(2*x)'
    >>> written(over(x, x) * y, fractions=True)
    'y*(x/x)'
    """
    if isinstance(expression, sympy.MatrixBase) and (ordered or fractions) and 0 not in expression.shape:
        texts = [_written(entry, ordered, fractions) for entry in expression.flat()]
        rows = (", ".join(texts[i : i + expression.cols]) for i in range(0, len(texts), expression.cols))
        return f"Matrix([{', '.join(f'[{row}]' for row in rows)}])"
    return _written(expression, ordered, fractions)


@lru_cache(maxsize=REMEMBERED)
def _written(expression: Any, ordered: bool, fractions: bool) -> str:
    printer = _WithFractions if fractions else StrPrinter
    return str(printer({} if ordered else {"order": "none"}).doprint(expression))

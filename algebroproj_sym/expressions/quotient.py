"""Divisions that are remembered: SymPy turns x/x into 1 and so loses the pole, but `over(x, x)` stays."""

from typing import Any

import sympy


class over(sympy.Function):  # type: ignore[misc]  # noqa: N801 - reads as mathematics: over(numerator, denominator)
    """The quotient of two expressions, which SymPy does not simplify.

    Derivations divide with `over`.  So the prover sees every divisor, even one that cancels.

    Parameters
    ----------
    numerator, denominator : sympy.Expr or int
        Rational expressions; the denominator must not be the number zero.

    Raises
    ------
    ZeroDivisionError
        If the denominator is the number zero.
    TypeError
        If an argument is text or a float.

    Examples
    --------
    >>> from sympy import Symbol
    >>> x = Symbol("x")
    >>> over(x, x)
    over(x, x)
    >>> over(x, x).doit()
    1
    """

    nargs = 2

    def __new__(cls, *arguments: Any, **options: Any) -> Any:
        """Make the node, from expressions and exact numbers, not from text."""
        if any(isinstance(argument, str | float) for argument in arguments):
            raise TypeError(f"over: expected SymPy expressions or exact numbers, got {arguments}")
        return super().__new__(cls, *arguments, **options)

    @classmethod
    def eval(cls, numerator: sympy.Expr, denominator: sympy.Expr) -> None:
        """Keep the node as it is, except that a zero denominator is refused."""
        if denominator.is_Integer and int(denominator) == 0:
            raise ZeroDivisionError(f"over: the denominator of ({numerator})/0 is zero")

    def doit(self, **hints: Any) -> sympy.Expr:
        """Divide, as SymPy divides."""
        numerator, denominator = (argument.doit(**hints) for argument in self.args)
        return numerator / denominator

    def fdiff(self, argindex: int = 1) -> sympy.Expr:
        """Differentiate with respect to the numerator (1) or the denominator (2)."""
        numerator, denominator = self.args
        return over(1, denominator) if argindex == 1 else -over(numerator, denominator**2)

    def _latex(self, printer: Any, exp: str | None = None) -> str:
        numerator, denominator = (printer.doprint(argument) for argument in self.args)
        fraction = rf"\frac{{{numerator}}}{{{denominator}}}"
        return fraction if exp is None else rf"\left({fraction}\right)^{{{exp}}}"


def remembered(expression: Any) -> Any:
    """Return an expression, or a matrix, with its negative powers written as `over`, so that none can cancel.

    Examples
    --------
    >>> from sympy import Symbol
    >>> x = Symbol("x")
    >>> remembered(1 / x).xreplace({x: x**2}) * x**2
    x**2*over(1, x**2)
    """
    powers = {
        power: over(1, remembered(power.base) ** -power.exp)
        for power in expression.atoms(sympy.Pow)
        if isinstance(power.exp, sympy.Integer) and power.exp.is_negative
    }
    return expression.xreplace(powers)

"""The terms of a function up to a degree in what is small, for statements such as "for small angles"."""

from typing import Any

import sympy


class taylor(sympy.Function):  # type: ignore[misc]  # noqa: N801 - reads as mathematics: taylor(sin(x), x, 3)
    """The Taylor polynomial of a function about zero, which is not evaluated.

    Parameters
    ----------
    function : sympy.Expr
        A scalar.
    variables : sympy.Symbol, or tuple of them
        What is small.
    degree : int
        The highest degree that is kept, in all variables together.

    Raises
    ------
    TypeError
        If the variables are not symbols, or the degree is not a natural number.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> taylor(sympy.sin(x) * sympy.exp(y), (x, y), 2)
    taylor(exp(y)*sin(x), (x, y), 2)
    """

    nargs = 3

    @classmethod
    def eval(cls, function: Any, variables: Any, degree: Any) -> None:
        """Keep the node as it is, if it has a meaning."""
        given = variables if isinstance(variables, sympy.Tuple) else (variables,)
        if not given or not all(isinstance(symbol, sympy.Symbol) for symbol in given):
            raise TypeError(f"taylor, variables: expected a symbol or several, got {variables}")
        if not (degree.is_Integer and degree >= 0):
            raise TypeError(f"taylor, degree: expected a natural number, got {degree}")

    def _latex(self, printer: Any) -> str:
        function, variables, degree = self.args
        names = ", ".join(map(printer.doprint, variables if isinstance(variables, sympy.Tuple) else (variables,)))
        return rf"\left[{printer.doprint(function)}\right]_{{{names}}}^{{\leq {degree}}}"

"""Symmetric and skew results: each pair of entries is computed once, so that both are exactly equal or opposite."""

from dataclasses import replace
from itertools import combinations

from algebroproj_sym.declaring import Kernel, Result
from algebroproj_sym.expressions import Matrix, evaluate
from algebroproj_sym.proving import RationalFunctionField


def mirrored(kernel: Kernel) -> list[Kernel]:
    """Return a kernel in whose symmetric and skew results the upper triangle stands for the lower one, and conversely.

    What is derived decides whether a result is symmetric.  A kernel without such results is returned alone.

    Examples
    --------
    >>> import sympy
    >>> from algebroproj_sym.declaring.kernel import declared_kernel
    >>> a, b = sympy.symbols("a b")
    >>> told = {"arguments": {"a": a, "b": b}, "describe": {"a": "", "b": ""}, "example": {"a": "1", "b": "2"}}
    >>> square = sympy.ImmutableMatrix([[a, a * (a + b)], [a**2 + b * a, b]])
    >>> kernel = declared_kernel("p", "1", "m.f", "F.", derived=square, claims=["1"], **told)
    >>> [each.form[0, 1] for each in mirrored(kernel)]
    [a*(a + b), a**2 + a*b]
    """
    field = RationalFunctionField((*kernel.symbols, *kernel.intermediate), "flint")
    signs = [_sign(result, field) for result in kernel.results]
    if not any(signs):
        return [kernel]
    both = ([_turned(*each, upper) for each in zip(kernel.results, signs, strict=True)] for upper in (True, False))
    return [replace(kernel, results=tuple(results)) for results in both]


def _sign(result: Result, field: RationalFunctionField) -> int:
    """Return 1 for a symmetric result, -1 for a skew one, and 0 if there is nothing to gain."""
    size = result.shape
    if len(size) < 2 or size[0] != size[1] or result.form in (result.form.T, -result.form.T):
        return 0
    values = evaluate(result.derived, field.variables, field.lift)
    places = range(size[0])
    both = [(values[i * size[0] + j], values[j * size[0] + i]) for i, j in combinations(places, 2)]
    if all((above - below).is_zero for above, below in both):
        return 1
    diagonal = [values[i * size[0] + i] for i in places]
    return -all(value.is_zero for value in [*diagonal, *(above + below for above, below in both)])


def _turned(result: Result, sign: int, upper: bool) -> Result:
    form = result.form
    if not sign:
        return result
    return replace(
        result, form=Matrix(*result.shape, lambda i, j: form[i, j] if i == j or (i < j) == upper else sign * form[j, i])
    )

"""Jacobians: a kernel whose results are the derivatives of another one's results.

What the other kernel computes on the way is differentiated on the way: an abbreviation gets abbreviations for its
derivatives, and a linear system A x = b gives A dx = db - dA x.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import sympy

from algebroproj_sym.declaring.claim import DeclarationError
from algebroproj_sym.declaring.elementary import ELEMENTARY
from algebroproj_sym.declaring.kernel import Kernel, KernelParts, Result
from algebroproj_sym.declaring.stage import Stage, let, solution
from algebroproj_sym.expressions import Expression, Matrix, Scalar, differential, entries, over

Tangents = dict[sympy.Symbol, Scalar]


def jacobian_parts(kernel: Kernel) -> KernelParts:
    """Return the declaration of the Jacobian of a kernel.

    Its results are those of the kernel: of each, a matrix of the derivatives of the entries, row by row, by the entries
    of all arguments, in order; of a scalar, the gradient as a vector.

    It raises `DeclarationError` if the kernel spans null spaces, whose scale is not differentiable.
    """
    stages = list[Stage]()
    tangents: list[Tangents] = [{symbol: sympy.Integer(1)} for symbol in kernel.symbols]
    for stage in kernel.stages:
        stages += [stage, *_differentiated(stage, kernel, tangents)]
    derived = _rows(kernel.results, kernel.symbols, tangents, "derived")
    where = _abbreviations(kernel, tangents)
    form = _rows(kernel.results, kernel.symbols, tangents, "form")
    several = len(kernel.results) > 1
    return {
        "arguments": {argument.name: argument.entries for argument in kernel.arguments},
        "derived": derived if several else derived["result"],
        "form": form if several else form["result"],
        "where": where,
        "through": stages,
        "claims": kernel.claims,
        "example": kernel.example,
        "describe": kernel.describe,
        "normwise": kernel.normwise,
    }


def derivative(expression: Scalar, tangents: Tangents) -> Scalar:
    """Return the derivative of an expression in which quotients p/q are kept: (p' - (p/q) q') / q.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> derivative(over(y, x), {x: sympy.Integer(1)})
    over(-over(y, x), x)
    """
    return differential(expression, tangents, _kept)


def _kept(quotient: Any, above: Scalar, below: Scalar) -> Scalar:
    return over(above - quotient * below, quotient.args[1])


def _rows(
    results: Sequence[Result], symbols: Sequence[sympy.Symbol], tangents: Sequence[Tangents], which: str
) -> dict[str, Expression]:
    """Return the derivatives of each result: the gradient of a scalar as a column, and else a row for each entry."""
    found = {}
    for result in results:
        rows = [[derivative(entry, along) for along in tangents] for entry in entries(getattr(result, which))]
        found[result.name] = Matrix(rows) if result.shape else Matrix(rows).T
    return found


def _abbreviations(kernel: Kernel, tangents: Sequence[Tangents]) -> dict[sympy.Symbol, Scalar]:
    """Return the abbreviations, each followed by its derivatives, of which the tangents take note."""
    where = dict[sympy.Symbol, Scalar]()
    for symbol, expression in kernel.where:
        where[symbol] = expression
        for by, along in zip(kernel.symbols, tangents, strict=True):
            slope = derivative(expression, along)
            if slope.is_Integer:
                along[symbol] = slope
            else:
                along[symbol] = _name(symbol, by)
                where[_name(symbol, by)] = slope
    return where


def _differentiated(stage: Stage, kernel: Kernel, tangents: Sequence[Tangents]) -> list[Stage]:
    """Return the stages that give the derivatives of what a stage gives; the tangents take note of them."""
    found = list[Stage]()
    for by, along in zip(kernel.symbols, tangents, strict=True):
        slopes = {symbol: _name(symbol, by) for symbol in stage.results}
        if all(derivative(entry, along) == 0 for entry in entries(stage.derived)):
            continue
        found.append(_tangent(stage, slopes, along))
        along |= slopes
    return found


def _tangent(stage: Stage, slopes: Mapping[sympy.Symbol, sympy.Symbol], along: Tangents) -> Stage:
    if stage.primitive == "solve":
        return _tangent_of_solution(stage, slopes, along)
    derived, form = (_slopes(stage, entries(given), along) for given in (stage.derived, stage.form))
    names = [slopes[symbol] for symbol in stage.results]
    return let(dict(zip(names, derived, strict=True)), form=dict(zip(names, form, strict=True)))


def _slopes(stage: Stage, operands: Sequence[Scalar], along: Tangents) -> list[Scalar]:
    slopes = [derivative(operand, along) for operand in operands]
    if stage.primitive == "let":
        return slopes
    if stage.primitive in ELEMENTARY:
        return ELEMENTARY[stage.primitive].tangent(operands, stage.results, slopes, over)
    raise DeclarationError(f"jacobian: expected stages that can be differentiated, got {stage.primitive}")


def _tangent_of_solution(stage: Stage, slopes: Mapping[sympy.Symbol, sympy.Symbol], along: Tangents) -> Stage:
    def system(given: Any) -> Any:
        size = len(stage.results)
        rows = [[given[i, j] for j in range(size + 1)] for i in range(size)]
        changes = [[derivative(entry, along) for entry in row] for row in rows]
        right = [
            change[-1] - sympy.Add(*(slope * unknown for slope, unknown in zip(change, stage.results, strict=False)))
            for change in changes
        ]
        return Matrix([[*row[:-1], value] for row, value in zip(rows, right, strict=True)])

    derived = system(stage.derived)
    names = [slopes[symbol] for symbol in stage.results]
    return solution(names, derived[:, :-1], derived[:, -1], form=system(stage.form))


def _name(symbol: sympy.Symbol, by: sympy.Symbol) -> sympy.Symbol:
    return sympy.Symbol(f"d_{symbol}_{by}")

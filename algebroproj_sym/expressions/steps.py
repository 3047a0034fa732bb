"""Writing an expression in steps, each part that occurs twice once, and with every division that was made."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any

import sympy

from algebroproj_sym.expressions.grammar import Expression, entries
from algebroproj_sym.expressions.quotient import over

_SUM, _PRODUCT, _POWER, _ATOM = range(4)


def in_steps(expression: Expression) -> dict[str, list[str]]:
    """Return an expression as text that keeps every division, in steps that later ones refer to by ``$0``, ``$1``, ...

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> in_steps(over(x + y, x) * (x + y))
    {'steps': ['x + y'], 'entries': ['$0*($0/x)']}
    """
    roots = entries(expression)
    uses = _uses(roots)
    written: dict[Any, tuple[str, int]] = {}
    steps: list[str] = []
    for root in roots:
        _write(root, uses, written, steps)
    return {"steps": steps, "entries": [written[root][0] for root in roots]}


def _uses(roots: Sequence[Any]) -> Counter[Any]:
    uses: Counter[Any] = Counter(roots)
    waiting = list(dict.fromkeys(roots))
    while waiting:
        for argument in waiting.pop().args:
            uses[argument] += 1
            if uses[argument] == 1:
                waiting.append(argument)
    return uses


def _write(node: Any, uses: Counter[Any], written: dict[Any, tuple[str, int]], steps: list[str]) -> None:
    if node in written:
        return
    for argument in node.args:
        _write(argument, uses, written, steps)
    text, rank = _text(node, written)
    if uses[node] > 1 and len(text) > 3 and rank != _ATOM:
        steps.append(text)
        text, rank = f"${len(steps) - 1}", _ATOM
    written[node] = text, rank


def _text(node: Any, written: dict[Any, tuple[str, int]]) -> tuple[str, int]:
    def within(argument: Any, least: int) -> str:
        text, rank = written[argument]
        return text if rank >= least else f"({text})"

    if isinstance(node, sympy.Add):
        return " + ".join(within(argument, _PRODUCT) for argument in node.args), _SUM
    if isinstance(node, sympy.Mul):
        return "*".join(within(argument, _POWER) for argument in node.args), _PRODUCT
    if isinstance(node, over):
        return f"{within(node.args[0], _POWER)}/{within(node.args[1], _POWER)}", _PRODUCT
    if isinstance(node, sympy.Pow):
        exponent = int(node.exp)
        return f"{within(node.base, _ATOM)}**{exponent if exponent >= 0 else f'({exponent})'}", _POWER
    text = str(node.name if isinstance(node, sympy.Symbol) else node)
    return text, _ATOM if text.isalnum() or not isinstance(node, sympy.Rational) else _SUM

"""Single changes of the source of a generated function."""

from __future__ import annotations

import ast
import copy
import inspect
import textwrap
from collections.abc import Callable, Iterator
from functools import partial
from types import FunctionType
from typing import Any, NamedTuple

from algebroproj_sym.verifying import without_twin

_SWAPPED: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
}

_DIGITS = {"wide": "narrow", "rounded": "unrounded"}
"""Words of the sources that change how many digits a number has, and what stands for leaving them out."""


class SourceMutant(NamedTuple):
    """What was changed, the line that it changed, and what compiles the changed function."""

    change: str
    line: str
    compiled: Callable[[], Callable[..., Any]]


def source_mutants(function: Callable[..., Any]) -> list[SourceMutant]:
    """Return a function with each single change of its body: operator, operands, index, dropped term, number, digits.

    The body of a generated function is the private one of the same name, which it evaluates.  A change of digits leaves
    out a word that asks for twice the digits, or that rounds to one number: no real number changes by it.

    Examples
    --------
    >>> from algebroproj import optics
    >>> [mutant.line for mutant in source_mutants(optics.scale)][:2]
    ['f * (f + x3)', '(f + x3) / f']
    """
    body = function.__globals__[f"_{function.__name__}"]
    tree = ast.parse(textwrap.dedent(inspect.getsource(body)))
    found, seen = [], {(number, ast.unparse(holder[place])) for number, (holder, place) in enumerate(_parts(tree))}
    for change, number, part in _changed(tree):
        line = ast.unparse(part)
        if (number, line) not in seen:
            seen.add((number, line))
            found.append(SourceMutant(change, line, partial(_compiled, tree, number, part, function)))
    return found


def _parts(tree: ast.Module) -> list[tuple[list[Any], int]]:
    """Return where the parts of a body are that are changed one by one: its statements, and the values it returns."""
    definition = tree.body[0]
    assert isinstance(definition, ast.FunctionDef)
    last = definition.body[-1]
    assert isinstance(last, ast.Return)
    assert isinstance(last.value, ast.Tuple)
    statements = [(definition.body, place) for place in range(len(definition.body) - 1)]
    return statements + [(last.value.elts, place) for place in range(len(last.value.elts))]


def _compiled(tree: ast.Module, number: int, part: ast.AST, function: Callable[..., Any]) -> Callable[..., Any]:
    """Return the function with another part in its body."""
    assert isinstance(function, FunctionType)
    holder, place = _parts(tree)[number]
    unchanged = holder[place]
    holder[place] = part
    try:
        code = compile(ast.fix_missing_locations(tree), f"<mutant of {function.__name__}>", "exec")
    finally:
        holder[place] = unchanged
    names = function.__globals__ | {"rounded": _rounded} | dict.fromkeys(_DIGITS.values(), _as_it_is)
    exec(code, names)
    mutant = FunctionType(function.__code__, names, function.__name__)
    mutant.__kwdefaults__ = function.__kwdefaults__
    return without_twin(mutant)


def _rounded(number: Any) -> Any:
    """Return the one number nearest to a sum of two; where a change has left one number, it is that."""
    return number.rounded() if hasattr(number, "rounded") else number


def _as_it_is(number: Any) -> Any:
    return number


def _changed(tree: ast.Module) -> Iterator[tuple[str, int, ast.AST]]:
    """Yield what is changed, the number of the part, and the changed part."""
    names = sorted({node.arg for node in ast.walk(tree) if isinstance(node, ast.arg)})
    names += sorted({node.id for node in ast.walk(tree) if isinstance(node, ast.Name)} - {*names})
    for number, (holder, at) in enumerate(_parts(tree)):
        for place in range(sum(1 for _ in ast.walk(holder[at]))):
            for change, edit in _edits(_node_at(holder[at], place), names):
                part = copy.deepcopy(holder[at])
                edit(_node_at(part, place))
                yield change, number, part


def _node_at(part: ast.AST, place: int) -> ast.AST:
    for at, node in enumerate(ast.walk(part)):
        if at == place:
            return node
    raise IndexError(place)


def _edits(node: ast.AST, names: list[str]) -> Iterator[tuple[str, Callable[[Any], None]]]:
    if isinstance(node, ast.BinOp):
        if type(node.op) in _SWAPPED:
            yield "operator", _operator
        if isinstance(node.op, ast.Sub | ast.Div):
            yield "operands", _operands
        yield "dropped term", _dropped("right")
        yield "dropped term", _dropped("left")
    elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in _DIGITS:
        yield "digits", _with_other_digits
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        yield "sign", _unsigned
    elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
        other = next((name for name in names if _is_sibling(node.id, name)), None)
        if other is not None:
            yield "index", _renamed(other)
    elif isinstance(node, ast.Constant) and type(node.value) is int:
        yield "number", _incremented


def _is_sibling(name: str, other: str) -> bool:
    differing = [(a, b) for a, b in zip(name, other, strict=False) if a != b]
    return len(name) == len(other) and len(differing) == 1 and "".join(differing[0]).isdecimal()


def _operator(node: Any) -> None:
    node.op = _SWAPPED[type(node.op)]()


def _operands(node: Any) -> None:
    node.left, node.right = node.right, node.left


def _with_other_digits(node: Any) -> None:
    node.func.id = _DIGITS[node.func.id]


def _unsigned(node: Any) -> None:
    node.op = ast.UAdd()


def _renamed(name: str) -> Callable[[Any], None]:
    def edit(node: Any) -> None:
        node.id = name

    return edit


def _incremented(node: Any) -> None:
    node.value = 1 - node.value if node.value in (0, 1) else node.value + 1


def _dropped(side: str) -> Callable[[Any], None]:
    """Replace an operand by the neutral one, so that it no longer counts."""

    def edit(node: Any) -> None:
        setattr(node, side, ast.Constant(0 if isinstance(node.op, ast.Add | ast.Sub) else 1))

    return edit

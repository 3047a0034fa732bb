"""Single changes of the source of a generated function."""

from __future__ import annotations

import ast
import copy
import inspect
import textwrap
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

_SWAPPED: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
}


class SourceMutant(NamedTuple):
    """A changed function, what was changed, and the line that it changed."""

    change: str
    line: str
    function: Callable[..., Any]


def source_mutants(function: Callable[..., Any]) -> list[SourceMutant]:
    """Return a function with each single change of its source: operator, operands, index, dropped term, number.

    The first statement, which brings the arguments into shape, and the last, which returns, stay as they are.

    Examples
    --------
    >>> from algebroproj import optics
    >>> [mutant.line for mutant in source_mutants(optics.scale)][:2]
    ['out[...] = f * (f + x3)', 'out[...] = (f + x3) / f']
    """
    tree = ast.parse(textwrap.dedent(inspect.getsource(function)))
    found, seen = [], {ast.unparse(tree)}
    for change, number, statement in _changed(_definition(tree)):
        mutated = copy.deepcopy(tree)
        _definition(mutated).body[number] = statement
        text = ast.unparse(ast.fix_missing_locations(mutated))
        if text not in seen:
            seen.add(text)
            found.append(SourceMutant(change, ast.unparse(statement), _compiled(text, function)))
    return found


def _definition(tree: ast.Module) -> ast.FunctionDef:
    definition = tree.body[0]
    assert isinstance(definition, ast.FunctionDef)
    return definition


def _compiled(text: str, function: Callable[..., Any]) -> Callable[..., Any]:
    names = dict(function.__globals__)
    exec(compile(text, f"<mutant of {function.__name__}>", "exec"), names)
    made: Callable[..., Any] = names[function.__name__]
    return made


def _changed(definition: ast.FunctionDef) -> Iterator[tuple[str, int, ast.stmt]]:
    """Yield what is changed, the number of the statement, and the changed statement."""
    start = 2 if ast.get_docstring(definition) is not None else 1
    body = definition.body
    names = sorted({node.id for node in ast.walk(definition) if isinstance(node, ast.Name)})
    for number in range(start, len(body) - 1):
        count = sum(1 for _ in ast.walk(body[number]))
        for place in range(count):
            for change, edit in _edits(_node_at(body[number], place), names):
                statement = copy.deepcopy(body[number])
                edit(_node_at(statement, place))
                yield change, number, statement


def _node_at(statement: ast.stmt, place: int) -> ast.AST:
    for at, node in enumerate(ast.walk(statement)):
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

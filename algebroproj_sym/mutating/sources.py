"""Single changes of the source of a generated function."""

import ast
import copy
import inspect
import textwrap
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, NamedTuple

from algebroproj_sym.generating.runtime.pairs import DIGITS, ROUNDINGS
from algebroproj_sym.mutating.forms import same_but_index
from algebroproj_sym.verifying.shipped import without_twin

_SWAPPED: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
}


class SourceMutant(NamedTuple):
    """What was changed, the line that it changed, and what compiles the changed function."""

    change: str
    line: str
    compiled: Callable[[], Callable[..., Any]]


def source_mutants(function: Callable[..., Any]) -> list[SourceMutant]:
    """Return a function with each single change of its body: operator, operands, index, dropped term, number, digits.

    The body of a generated function is the private one of the same name, which it evaluates.  Changes of digits leave
    out `wide`, which asks for twice the digits, `rounded` or `rounded_twice`: no real number changes by them.

    Examples
    --------
    >>> from algebroproj import optics
    >>> [mutant.line for mutant in source_mutants(optics.scale)][:2]
    ['f * (f + x3)', '(f + x3) / f']
    """
    tree = _parsed(function)
    found, seen = [], {(number, ast.unparse(holder[place])) for number, (holder, place) in enumerate(_parts(tree))}
    for change, number, part in _changed(tree):
        line = ast.unparse(part)
        if (number, line) not in seen:
            seen.add((number, line))
            found.append(SourceMutant(change, line, partial(_compiled, tree, number, part, function)))
    return found


def recompiled(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a generated function as its mutants are made, but without a change."""
    tree = _parsed(function)
    holder, place = _parts(tree)[0]
    return _compiled(tree, 0, holder[place], function)


def _parsed(function: Callable[..., Any]) -> ast.Module:
    body = function.__globals__[f"_{function.__name__}"]
    return ast.parse(textwrap.dedent(inspect.getsource(body)))


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
    holder, place = _parts(tree)[number]
    unchanged = holder[place]
    holder[place] = part
    try:
        code = compile(ast.fix_missing_locations(tree), f"<mutant of {function.__name__}>", "exec")
    finally:
        holder[place] = unchanged
    mutant = without_twin(function)
    mutant.__globals__.update(_digits_of(function))
    exec(code, mutant.__globals__)
    return mutant


def _digits_of(function: Callable[..., Any]) -> dict[str, Callable[[Any], Any]]:
    """Return what the words for digits mean in mutants: one number, which a change may leave, is rounded to itself."""
    known = function.__globals__
    words = {word: known[word] for word in DIGITS if word in known}
    return words | {word: partial(_rounded, words[word]) for word in words.keys() & {*ROUNDINGS}}


def _rounded(rounding: Callable[[Any], Any], number: Any) -> Any:
    return rounding(number) if hasattr(number, "rounded") else number


def _changed(tree: ast.Module) -> Iterator[tuple[str, int, ast.AST]]:
    """Yield what is changed, the number of the part, and the changed part."""
    names = sorted({node.arg for node in ast.walk(tree) if isinstance(node, ast.arg)})
    names += sorted({node.id for node in ast.walk(tree) if isinstance(node, ast.Name)} - {*names})
    for number, (holder, place) in enumerate(_parts(tree)):
        for node in ast.walk(holder[place]):
            for change, changed in _changes(node, names):
                yield change, number, copy.deepcopy(holder[place], {id(node): changed})


def _changes(node: ast.AST, names: list[str]) -> Iterator[tuple[str, ast.expr]]:
    """Yield what may stand for a node of a source, and what that changes."""
    if isinstance(node, ast.BinOp):
        left, operator, right = node.left, node.op, node.right
        if type(operator) in _SWAPPED:
            yield "operator", ast.BinOp(left, _SWAPPED[type(operator)](), right)
        if isinstance(operator, ast.Sub | ast.Div):
            yield "operands", ast.BinOp(right, operator, left)
        yield "dropped term", left
        yield "dropped term", _without_left(operator, right)
    elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in DIGITS:
        yield f"{node.func.id} left out", node.args[0]
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        yield "sign", node.operand
    elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
        other = next((name for name in names if same_but_index(node.id, name)), None)
        if other is not None:
            yield "index", ast.Name(other, ast.Load())
    elif isinstance(node, ast.Constant) and type(node.value) is int:
        yield "number", ast.Constant(1 - node.value if node.value in (0, 1) else node.value + 1)


def _without_left(operator: ast.operator, right: ast.expr) -> ast.expr:
    if isinstance(operator, ast.Add | ast.Mult):
        return right
    if isinstance(operator, ast.Sub):
        return ast.UnaryOp(ast.USub(), right)
    return ast.BinOp(ast.Constant(1), operator, right)

"""Executing generated C source, statement by statement, on exact numbers of any kind.

This is C as far as the generator writes it: functions of declarations, assignments, array entries, arithmetic, the
conditional operator, calls, and one loop over points.  Anything else is refused, so that nothing is proved of a source
that is not understood.  Of the preprocessor's macros those are known that head a function or name one for its type.
The name ``range`` is not a variable here: what keeps the range of operands can be read by nothing that computes.
"""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from pycparser import CParser, c_ast
from pycparser.c_parser import ParseError

_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
_HEADS = ("KERNEL", "SOLVER", "INLINE", "PLAIN", "NARROW", "SOLVER_ONCE")
_FUNCTION = re.compile(rf"^({'|'.join(_HEADS)})(\(.*?\)+)\n(\{{\n.*?^\}})", re.DOTALL | re.MULTILINE)
_CALL = re.compile(r"^CALL\((\w+), (\w+), (.*)\)$", re.MULTILINE)
_NAME = re.compile(r"\bNAME\((\w+)\)")
_TYPES = "typedef double real; typedef long npy_intp;\n"
_POINTS = "for (npy_intp i = 0; i < points; i++)"

PRODUCT_ERRORS = ("fused_product_error", "split_product_error")
"""The functions one of which is meant by ``product_error``: zero, in real arithmetic, for the product itself."""

_ARITHMETIC: dict[str, Callable[[Any, Any], Any]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
}


class NotUnderstoodError(ValueError):
    """The source is not what the generator writes."""


class Magnitude:
    """An absolute value, or what is computed from some: only decisions may depend on it, never a result."""

    def _computed(self, other: object) -> Magnitude:
        return self

    __add__ = __radd__ = __sub__ = __rsub__ = __mul__ = __rmul__ = __truediv__ = __rtruediv__ = _computed


@dataclass(frozen=True)
class Meaning:
    """What the source does not say itself."""

    constants: Mapping[str, Any] = field(default_factory=dict)
    """The values of names that are not variables."""
    is_larger: Callable[[Any, Any], bool] | None = None
    """Whether one absolute value is larger than another; for numbers without an order, a choice.  Without it, the
    conditional operator is refused.  Of magnitudes the first one is taken for larger: a matrix has full rank."""
    equal: Callable[[Any, Any], bool] = operator.eq
    """Whether two numbers are equal."""
    call: Callable[[str, list[list[Any]]], Sequence[Any]] | None = None
    """What a function that solves a linear system gives: from its name and the rows of the system."""
    is_zero: Callable[[Any], bool] = operator.not_
    """Whether a number is zero."""
    product_error: Callable[[Any, Any, Any], Any] | None = None
    """The error of a product, from its factors and the product, where it matters how often is rounded.  Without it,
    it must be that of the product itself, which is zero."""


@dataclass(frozen=True)
class Source:
    """The functions of a source: the text of each body by its name, after the macro that heads it.

    Those without compensation begin with their parameters; of their calls there are the number of points and the rest.
    """

    kernels: Mapping[str, str]
    solvers: Mapping[str, str]
    inlines: Mapping[str, str]
    plains: Mapping[str, str] = field(default_factory=dict)
    calls: Mapping[str, tuple[str, str]] = field(default_factory=dict)


@cache
def source_of(text: str) -> Source:
    r"""Take a source apart into its functions.

    Examples
    --------
    >>> list(source_of("KERNEL(f)\n{\n    out[0][i] = 1;\n}\n").kernels)
    ['f']
    """
    bare = _COMMENT.sub("", text)
    rest = _CALL.sub("", _FUNCTION.sub("", bare)).split()
    if rest:
        raise NotUnderstoodError(f"C source: expected nothing but functions, got {' '.join(rest[:5])}")
    functions: dict[str, dict[str, str]] = {head: {} for head in _HEADS}
    for head, name, body in _FUNCTION.findall(bare):
        if name in functions[head]:
            raise NotUnderstoodError(f"C source: expected one function {head}{name}, got two")
        functions[head][name] = _NAME.sub(r"\1", body)
    kernels = {name[1:-1]: body for name, body in functions["KERNEL"].items()}
    solvers = {"_".join(name[1:-1].split(", ")[:2]): body for name, body in functions["SOLVER"].items()}
    for name, body in functions["SOLVER_ONCE"].items():
        primitive, height = name[1:-1].split(", ")[:2]
        solvers[f"{primitive}_once_{height}"] = body
    inlines, plains, narrow = (
        {name.split(")")[0][1:]: name.partition(")")[2] + body for name, body in functions[head].items()}
        for head in ("INLINE", "PLAIN", "NARROW")
    )
    if twice := plains.keys() & narrow.keys():
        raise NotUnderstoodError(f"C source: expected one function of each name, got two of {', '.join(sorted(twice))}")
    calls = {name: (length, given) for name, length, given in _CALL.findall(bare)}
    return Source(kernels, solvers, inlines, plains | narrow, calls)


def kernel_outputs(source: Source, name: str, inputs: Sequence[Any], meaning: Meaning) -> list[Any]:
    """Execute a kernel for one point; return its outputs.

    It raises `NotUnderstoodError` if there is no such kernel, it is more than loops over points, or an output is not
    set.
    """
    if name not in source.kernels:
        raise NotUnderstoodError(f"C source: expected a kernel {name}, there is none")
    variables: dict[str, Any] = {"in": dict(enumerate(inputs)), "out": {}, "i": _POINT}
    _run_loops(name, source.kernels[name], "all", _Scope(variables, source, meaning))
    return _in_order(name, variables["out"])


def plain_outputs(
    source: Source, name: str, inputs: Sequence[Sequence[Any]], sizes: Sequence[int], meaning: Meaning
) -> list[Any]:
    """Execute a function without compensation for one point; return the entries of its results.

    It raises `NotUnderstoodError` if there is no such function, it takes or is given other arrays, it is more than
    loops over points, or an entry is not set.
    """
    if name not in source.plains or name not in source.calls:
        raise NotUnderstoodError(f"C source: expected a function {name} and its call, there is none")
    arrays = [("const real", f"in{place}", len(entries)) for place, entries in enumerate(inputs)]
    arrays += [("real", f"out{place}", size) for place, size in enumerate(sizes)]
    parameters = ", ".join(f"{kind} (*restrict {array})[{size}]" for kind, array, size in arrays)
    given = ", ".join(f"({kind} (*)[{size}])data[{place}] + first" for place, (kind, _, size) in enumerate(arrays))
    head, _, body = source.plains[name].partition("{")
    length, really_given = source.calls[name]
    if (head, really_given) != (f"({parameters}, const npy_intp points)", given):
        raise NotUnderstoodError(f"{name}: expected the arrays {parameters}, got {head} and {really_given}")
    variables: dict[str, Any] = {f"in{place}": _Points(dict(enumerate(e))) for place, e in enumerate(inputs)}
    variables |= {f"out{place}": _Points({}) for place in range(len(sizes))}
    _run_loops(name, f"{{{body}", length, _Scope(variables | {"i": _POINT}, source, meaning))
    outputs = [variables[f"out{place}"].entries for place in range(len(sizes))]
    if [sorted(entries) for entries in outputs] != [list(range(size)) for size in sizes]:
        raise NotUnderstoodError(f"{name}: expected all entries of the results to be set")
    return [entries[place] for entries in outputs for place in range(len(entries))]


def _run_loops(name: str, body: str, length: str, scope: _Scope) -> None:
    """Execute loops over the same points, one after the other; before them, rows may be declared for all of them."""
    declared, *loops = _parsed(f"void {name}(void)\n{body.replace(_POINTS, '')}").body.block_items or [None]
    rows: dict[int, Any] = {}
    match declared:
        case c_ast.Decl(
            name="rows", init=None, type=c_ast.ArrayDecl(dim=count, type=c_ast.ArrayDecl(dim=strip, type=kind))
        ):
            places, same_length = _index(count), str(_index(strip)) == length and kind.type.names == ["real"]
        case _:
            loops, places, same_length = [declared, *loops], 0, length == "all"
    if not same_length or len(loops) != body.count(_POINTS):
        raise NotUnderstoodError(f"{name}: expected rows for the points of a call, and nothing but loops over them")
    for loop in loops:
        if not isinstance(loop, c_ast.Compound):
            raise NotUnderstoodError(f"{name}: expected loops over points")
        _run(loop, _Scope(scope.variables | {"rows": rows}, scope.source, scope.meaning))
    if any(place >= places for place in rows):
        raise NotUnderstoodError(f"{name}: expected no more than {places} rows")


def solver_outputs(source: Source, name: str, system: list[list[Any]], meaning: Meaning) -> list[Any]:
    """Execute a function that solves a linear system, given row by row; return its solution."""
    if name not in source.solvers:
        raise NotUnderstoodError(f"C source: expected a function {name}, there is none")
    variables: dict[str, Any] = {"system": system, "solution": {}}
    _run(_parsed(f"void {name}(void)\n{source.solvers[name]}").body, _Scope(variables, source, meaning))
    return _in_order(name, variables["solution"])


def _in_order(name: str, entries: Mapping[int, Any]) -> list[Any]:
    """Return what was set, all of it from the first entry on."""
    if sorted(entries) != list(range(len(entries))):
        raise NotUnderstoodError(f"{name}: expected all outputs to be set, got {sorted(entries)}")
    return [entries[place] for place in range(len(entries))]


def body_values(body: str, given: Mapping[str, Any], names: Sequence[str], meaning: Meaning) -> list[Any]:
    """Execute the body of a function of given values; return what some names and integers stand for at its end."""
    scope = _Scope(dict(given), Source({}, {}, {}), meaning)
    _run(_parsed(f"void body(void)\n{body}").body, scope)
    if not all(name in scope.variables or name.removeprefix("-").isdecimal() for name in names):
        raise NotUnderstoodError(f"C source: expected values, got {', '.join(names)}")
    return [scope.variables[name] if name in scope.variables else int(name) for name in names]


def inline_value(source: Source, name: str, arguments: Sequence[Any], meaning: Meaning) -> Any:
    """Return what an inline function gives."""
    return _inline(name, arguments, _Scope({}, source, meaning))


@dataclass(frozen=True)
class _Scope:
    """The variables of a function, in the order in which they are declared, and what they are used with."""

    variables: dict[str, Any]
    source: Source
    meaning: Meaning


_POINT = object()
"""The index of the point: it may only choose the column of inputs and outputs, and the point of an array."""


@dataclass(frozen=True)
class _Points:
    """An array of points: the entries of the point of the loop by their places."""

    entries: dict[int, Any]


@cache
def _parsed(text: str) -> Any:
    try:
        return CParser().parse(_TYPES + text).ext[-1]
    except ParseError as error:
        raise NotUnderstoodError(f"C source: {error}") from error


def _run(block: Any, scope: _Scope) -> Any:
    """Execute the statements of a block; return the value of its return statement."""
    for statement in block.block_items or []:
        match statement:
            case c_ast.Return() if not _is_range(statement.expr):
                return _value(statement.expr, scope)
            case c_ast.Decl() if statement.name != "range":
                _declare(statement, scope)
            case c_ast.Assignment(op="=", lvalue=target) if not _is_range(target):
                _assign(statement, scope)
            case c_ast.FuncCall(name=c_ast.ID(name=name), args=c_ast.ExprList(exprs=[system, solution])):
                _solve(name, system.name, solution.name, scope)
            case _:
                _keep_range(statement, scope)
    return None


def _is_range(node: Any) -> bool:
    """Whether a node is the range of operands, or where that of the point of the loop is written."""
    name = node.name if isinstance(node, c_ast.ArrayRef) else node
    return isinstance(name, c_ast.ID) and name.name in ("range", "ranges")


def _keep_range(statement: Any, scope: _Scope) -> None:
    """Execute a statement about the range of operands, which changes nothing else but what a called function solves."""
    match statement:
        case c_ast.Return(expr=c_ast.ID(name="range")):
            pass
        case c_ast.Decl(name="range", init=c_ast.ID(name="headroom")):
            pass
        case c_ast.Assignment(
            lvalue=c_ast.ArrayRef(name=c_ast.ID(name="ranges"), subscript=c_ast.ID(name="i")),
            rvalue=c_ast.ID(name="range"),
        ):
            pass
        case c_ast.Assignment(
            lvalue=c_ast.ID(name="range"),
            rvalue=c_ast.FuncCall(name=c_ast.ID(name="within"), args=c_ast.ExprList(exprs=[before, operand])),
        ) if _is_range(before):
            _value(operand, scope)
        case c_ast.Assignment(
            lvalue=c_ast.ID(name="range"),
            rvalue=c_ast.FuncCall(name=c_ast.ID(name=name), args=c_ast.ExprList(exprs=[system, solution, before])),
        ) if _is_range(before):
            _solve(name, system.name, solution.name, scope)
        case _:
            raise NotUnderstoodError(f"C source: unexpected {type(statement).__name__} at {statement.coord}")


def _declare(statement: Any, scope: _Scope) -> None:
    if statement.name in scope.variables:
        raise NotUnderstoodError(f"C source: {statement.name} is declared twice")
    if isinstance(statement.type, c_ast.TypeDecl) and statement.init is None:
        scope.variables[statement.name] = None
    elif isinstance(statement.type, c_ast.TypeDecl):
        value = _value(statement.init, scope)
        if statement.type.type.names != (["int"] if isinstance(value, bool) else ["real"]):
            raise NotUnderstoodError(f"C source: unexpected type of {statement.name}")
        scope.variables[statement.name] = value
    elif statement.init is None:
        scope.variables[statement.name] = {}
    else:
        rows = statement.init.exprs
        scope.variables[statement.name] = [[_value(e, scope) for e in row.exprs] for row in rows]


def _assign(statement: Any, scope: _Scope) -> None:
    value = _value(statement.rvalue, scope)
    target = statement.lvalue
    if isinstance(target, c_ast.ID) and target.name in scope.variables:
        scope.variables[target.name] = value
        return
    match target:
        case c_ast.ArrayRef(name=c_ast.ArrayRef(name=c_ast.ID(name=name), subscript=first), subscript=second) if (
            _has_points(name, scope)
        ):
            entries, place = _entry(name, first, second, scope)
            if name.startswith("in"):
                raise NotUnderstoodError(f"C source: expected inputs to keep their values at {target.coord}")
            entries[place] = value
        case c_ast.ArrayRef(name=c_ast.ID(name=name), subscript=place) if isinstance(scope.variables.get(name), dict):
            scope.variables[name][_index(place)] = value
        case _:
            raise NotUnderstoodError(f"C source: unexpected target at {target.coord}")


def _solve(name: str, system: str, solution: str, scope: _Scope) -> None:
    """Let a linear system be solved by the function of some name."""
    if scope.meaning.call is None or scope.variables[solution] != {}:
        raise NotUnderstoodError(f"C source: unexpected call of {name}")
    results = scope.meaning.call(name, scope.variables[system])
    scope.variables[solution] |= dict(enumerate(results))


def _has_points(name: str, scope: _Scope) -> bool:
    return name in ("in", "out", "rows") or isinstance(scope.variables.get(name), _Points)


def _entry(name: str, first: Any, second: Any, scope: _Scope) -> tuple[dict[int, Any], int]:
    """Return the entries, at the point of the loop, of an array of points or of rows, and which of them is meant."""
    array = scope.variables.get(name)
    point, place = (first, second) if isinstance(array, _Points) else (second, first)
    if array is None or _value(point, scope) is not _POINT:
        raise NotUnderstoodError(f"C source: expected {name} at the point of the loop")
    return (array.entries if isinstance(array, _Points) else array), _index(place)


def _index(node: Any) -> int:
    if not isinstance(node, c_ast.Constant) or node.type != "int":
        raise NotUnderstoodError("C source: expected a number as index")
    return _decimal(node)


def _decimal(node: Any) -> int:
    """Return an integer; with a zero before it, it would be octal."""
    if not re.fullmatch("0|[1-9][0-9]*", node.value):
        raise NotUnderstoodError(f"C source: expected a decimal number, got {node.value}")
    return int(node.value)


def _value(node: Any, scope: _Scope) -> Any:
    def value(part: Any) -> Any:
        return _value(part, scope)

    match node:
        case c_ast.Constant(type="int"):
            return _decimal(node)
        case c_ast.ID(name=name) if scope.variables.get(name) is not None:
            return scope.variables[name]
        case c_ast.ID(name=name) if name in scope.meaning.constants:
            return scope.meaning.constants[name]
        case c_ast.UnaryOp(op="-"):
            return -value(node.expr)
        case c_ast.TernaryOp() if scope.meaning.is_larger is not None:
            return value(node.iftrue if value(node.cond) else node.iffalse)
        case c_ast.BinaryOp():
            return _operation(node.op, value(node.left), value(node.right), scope.meaning)
        case c_ast.ArrayRef(name=c_ast.ArrayRef(name=c_ast.ID(name=name), subscript=first), subscript=second) if (
            _has_points(name, scope)
        ):
            entries, place = _entry(name, first, second, scope)
            if place not in entries:
                raise NotUnderstoodError(f"C source: expected {name} to have an entry {place}")
            return entries[place]
        case c_ast.ArrayRef():
            return value(node.name)[_index(node.subscript)]
        case c_ast.FuncCall(name=c_ast.ID(name="constant"), args=c_ast.ExprList(exprs=[number])):
            return value(number)
        case c_ast.FuncCall(name=c_ast.ID(name="is_larger")) if scope.meaning.is_larger is not None:
            left, right = map(value, node.args.exprs)
            return isinstance(left, Magnitude) or scope.meaning.is_larger(left, right)
        case c_ast.FuncCall(name=c_ast.ID(name="absolute")) if scope.meaning.is_larger is not None:
            return Magnitude()
        case c_ast.FuncCall(name=c_ast.ID(name="multiply_add")):
            if scope.meaning.product_error is not None:
                raise NotUnderstoodError(
                    f"C source: multiply_add at {node.coord} rounds once, not as a product and a sum"
                )
            left, right, term = map(value, node.args.exprs)
            return _operation("+", _operation("*", left, right, scope.meaning), term, scope.meaning)
        case c_ast.FuncCall(name=c_ast.ID(name="product_error")):
            left, right, product = map(value, node.args.exprs)
            if scope.meaning.product_error is not None:
                return scope.meaning.product_error(left, right, product)
            error = left * right - product
            if not scope.meaning.is_zero(error):
                raise NotUnderstoodError(f"C source: expected the error of the product itself at {node.coord}")
            return error
        case c_ast.FuncCall(name=c_ast.ID(name=name)):
            return _inline(name, list(map(value, node.args.exprs)), scope)
        case _:
            raise NotUnderstoodError(f"C source: unexpected {type(node).__name__}")


def _inline(name: str, arguments: Sequence[Any], scope: _Scope) -> Any:
    """Return what an inline function gives."""
    if name not in scope.source.inlines:
        raise NotUnderstoodError(f"C source: unexpected call of {name}")
    function = _parsed(f"real {name}{scope.source.inlines[name]}")
    names = [parameter.name for parameter in function.decl.type.args.params]
    return _run(function.body, _Scope(dict(zip(names, arguments, strict=True)), scope.source, scope.meaning))


def _operation(sign: str, left: Any, right: Any, meaning: Meaning) -> Any:
    if _POINT in (left, right) or (isinstance(left, int) and isinstance(right, int)):
        raise NotUnderstoodError("C source: expected no arithmetic of integers, which C does in another way")
    if sign == "==":
        return meaning.equal(left, right)
    if sign in _ARITHMETIC:
        return _ARITHMETIC[sign](left, right)
    raise NotUnderstoodError(f"C source: unexpected operator {sign}")

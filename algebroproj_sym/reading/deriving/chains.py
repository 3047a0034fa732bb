r"""Derivatives by the chain rule, as ``\frac{\partial L}{\partial w}`` where y gives L, and w gives y."""

from collections.abc import Mapping

from lark import Token, Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import stands_within
from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in

_CLOSED = ("big", "call", "slope", "inner", "matrix")
"""What letters are not put into."""


def chained(
    sign: str, function: str, below: str, names: Mapping[str, str], vocabulary: Vocabulary
) -> tuple[Formula, tuple[str, ...], Definition, Definition | None] | None:
    r"""Return a derivative of what a letter stands for, through the letters that give it; None if there is none.

    The sign is ``d`` or ``\partial``, and names are the letters of the document by their bare names.  A partial
    derivative by a letter that stands in the formula itself, and in what another letter of it stands for, may mean two
    things: there is none.  By x it leaves ``\dot x`` as it is, if the document has one by ``\dot x`` as well.

    Beside the derivative are the letters that do not change, the definition of the function, and that of the derivative
    with the letter free if it has a value itself.
    """
    definition = vocabulary.definitions.get(function)
    if definition is None or not definition.usable or definition.parameters or definition.role == "case":
        return None
    used = {each.symbol: each for each in vocabulary.used_in(definition.tree)}
    reached = {*definition.symbols}.union(*(each.symbols for each in used.values()))
    variable = names.get(below, "")
    if variable not in reached or variable == function:
        return None
    through = _through(variable, used)
    direct, via = variable in definition.symbols, through & {*definition.symbols}
    if (direct and via and sign != "d") or any(used[each].parameters or used[each].role == "case" for each in through):
        return None
    tree = filled(definition.tree, {each: used[each].tree for each in through})
    closed = [part for part in tree.iter_subtrees() if part.data in _CLOSED]
    others = frozenset(symbols_in(tree)) - {variable}
    others |= frozenset().union(*(vocabulary.behind(each) for each in others if each in used))
    if sign != "d" and any(each.endswith(rf"/\partial\dot{below}") for each in names):
        others -= {names.get(rf"\dot{below}", ""), *used}
    if variable in others or vocabulary.moves_with(others, variable) or stands_within(variable, others):
        return None
    kept = tuple(sorted(vocabulary.letters_of(tree) - {variable})) if sign == "d" else ()
    if variable not in used:
        return (slope_of(letter_of(function), variable), kept, definition, None) if via else None
    own = {variable}.union(vocabulary.behind(variable))
    if closed or (sign == "d" and own & others):
        return None
    free = Definition(f"{function} by {variable} ", (variable,), slope_of(tree, variable), definition.where, -1, True)
    value: Formula = Tree("call", [Token("CALLEE", free.symbol), Tree("items", [letter_of(variable)])])
    return value, kept, definition, free


def _through(variable: str, used: Mapping[str, Definition]) -> frozenset[str]:
    """Return the letters, without the variable, in whose values the variable stands."""
    found = set[str]()
    while more := {
        each.symbol
        for each in used.values()
        if each.symbol not in found | {variable} and ({variable} | found) & {*each.symbols}
    }:
        found |= more
    return frozenset(found)


def filled(tree: Formula, values: Mapping[str, Formula]) -> Formula:
    """Return a formula with what letters stand for in their place."""
    if tree.data == "symbol" and (value := values.get(str(tree.children[0]))) is not None:
        return Tree("group", [filled(value, values)])
    return Tree(tree.data, [filled(each, values) if isinstance(each, Tree) else each for each in tree.children])


def slope_of(value: Formula, variable: str, order: str | None = None) -> Formula:
    """Return the derivative of a value by a letter; ``^2`` is the order of a second one."""
    for _ in range(int((order or "^1")[1:])):
        value = Tree("slope", [value, letter_of(variable)])
    return value

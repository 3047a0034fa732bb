r"""Derivatives by a vector whose components are printed, as of ``\mathbf{u}`` by ``\mathbf{p} = (X, Y, Z)^T``.

They have a column for each component: ``\frac{\partial\mathbf{u}}{\partial\mathbf{p}}`` has the derivatives of all
entries of ``\mathbf{u}`` by X in its first column.
"""

import re
from collections.abc import Sequence
from dataclasses import replace

from lark import Token, Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.notation import Derivative
from algebroproj_sym.reading.deriving.asking import Asked, slope_of
from algebroproj_sym.reading.parsing.grammar import Formula, lone, symbols_in, trees_in, without_brackets

_LISTED = re.compile(r"\(([^()]*,[^()]*)\)")


def jacobian(asked: Asked) -> Definition | None:
    """Return the matrix of derivatives of one letter by another; each may be a list in brackets, as (X, Y, Z).

    There is no matrix if a component has a value itself, or if another one or other letters may change with it.  Nor is
    there one if a component stands in the formula and in what another letter of it stands for: a partial derivative may
    mean two things then.
    """
    vocabulary = asked.vocabulary
    components, given = _components(asked) if asked.is_first else ([], [])
    functions = _functions(asked) if len({*components}) == len(components) > 1 else []
    by_others = [each for function in functions for each in vocabulary.used_in(function.tree) if each not in given]
    direct = {symbol for function in functions for symbol in symbols_in(function.tree)}
    via = {symbol for each in by_others for symbol in each.symbols}
    letters = frozenset().union(*(vocabulary.letters_of(each.tree) for each in functions))
    others = (letters | direct | via | {*components}) - {each.symbol for each in (*given, *by_others)}
    if {*components} & direct & via or not {*components} & letters:
        return None
    if any(vocabulary.moves_with(others - {each}, each) for each in components):
        return None
    rows = [[Tree("cell", [slope_of(function.tree, each)]) for each in components] for function in functions]
    parts: list[Formula] = [Tree("row", [*row]) for row in rows]
    where = " and ".join(dict.fromkeys(each.where for each in (*functions, *given)))
    return asked.case(Tree("matrix", [Token("BEGIN", "("), *parts]), replace(functions[0], where=where))


def _components(asked: Asked) -> tuple[list[str], list[Definition]]:
    """Return the letters of which a vector is printed, and what says so; none if one of them has a value."""
    given = asked.given(asked.below)
    if match := _LISTED.fullmatch(asked.below):
        found, sources = [asked.names.get(each, "") for each in match[1].split(",")], []
    elif given is not None and not given.parameters:
        found, sources = _column(given.tree), [given]
    else:
        return [], []
    is_given = any(not each or each in asked.vocabulary.definitions for each in found)
    return ([], []) if is_given else (found, sources)


def _column(tree: Formula) -> list[str]:
    """Return the letters of a printed column, or of a row that is transposed or stands in round brackets."""
    tree = without_brackets(tree, ("group",))
    turned = tree.data == "marked" and tree.children[1] == "T"
    inside = without_brackets(trees_in(tree)[0], ("group",)) if turned else tree
    if inside.data == "bracket":
        return [*map(lone, trees_in(without_brackets(inside, ("bracket",))))]
    rows: Sequence[Formula] = trees_in(inside) if inside.data == "matrix" else ()
    cells = [trees_in(row) for row in rows]
    is_column = all(len(row) == 1 for row in cells) and not turned
    if not (is_column or (len(cells) == 1 and turned)):
        return []
    return [lone(without_brackets(each)) for row in cells for cell in row for each in trees_in(cell)]


def _functions(asked: Asked) -> list[Definition]:
    """Return what gives a letter, or each of a list; none if one is not given, or is one of other letters."""
    match = _LISTED.fullmatch(asked.above)
    at_vectors = {each.symbol: each for each in asked.at_vectors}
    names = match[1].split(",") if match else [Derivative("", asked.above, ()).head]
    known = [asked.names.get(each, "") for each in names]
    found = [asked.vocabulary.definitions.get(each, at_vectors.get(each)) for each in known]
    usable = [each for each in found if each is not None and each.usable and each.role != "case"]
    fits = all(not each.parameters or asked.names.get(asked.below) in each.parameters for each in usable)
    return usable if fits and len(usable) == len(found) else []

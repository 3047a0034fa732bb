r"""Derivatives by a vector whose components are printed, as of ``\mathbf{u}`` by ``\mathbf{p} = (X, Y, Z)^T``.

They have a column for each component: ``\frac{\partial\mathbf{u}}{\partial\mathbf{p}}`` has the derivatives of all
entries of ``\mathbf{u}`` by X in its first column.
"""

import re
from collections.abc import Mapping, Sequence

from lark import Token, Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.deriving.chains import slope_of
from algebroproj_sym.reading.parsing.grammar import Formula, lone, symbols_in, trees_in, without_brackets

_LISTED = re.compile(r"\(([^()]*,[^()]*)\)")


def jacobian_of(
    above: str, below: str, names: Mapping[str, str], vocabulary: Vocabulary, at_vectors: Mapping[str, Definition]
) -> tuple[Formula, list[Definition]] | None:
    """Return the matrix of derivatives of one letter by another, and what gives both; None if there is none.

    The letters are bare, and so are the keys of the names.  Each may be a list in brackets, as (X, Y, Z).  Of some
    functions it is known what they are at a vector.

    There is no matrix if a component has a value itself, or if another one or other letters may change with it.  Nor is
    there one if a component stands in the formula and in what another letter of it stands for: a partial derivative may
    mean two things then.
    """
    components, given = _components(below, names, vocabulary)
    functions = _functions(above, names, {**at_vectors, **vocabulary.definitions}, below)
    if len({*components}) != len(components) or len(components) < 2 or not functions:
        return None
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
    return Tree("matrix", [Token("BEGIN", "("), *parts]), [*functions, *given]


def _components(below: str, names: Mapping[str, str], vocabulary: Vocabulary) -> tuple[list[str], list[Definition]]:
    """Return the letters of which a vector is printed, and what says so; none if one of them has a value."""
    definition = vocabulary.definitions.get(names.get(below, ""))
    if match := _LISTED.fullmatch(below):
        found, given = [names.get(each, "") for each in match[1].split(",")], []
    elif definition is not None and definition.usable and not definition.parameters:
        found, given = _column(definition.tree), [definition]
    else:
        return [], []
    return ([], []) if any(not each or each in vocabulary.definitions for each in found) else (found, given)


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


def _functions(above: str, names: Mapping[str, str], known: Mapping[str, Definition], below: str) -> list[Definition]:
    """Return what gives a letter, or each of a list; none if one is not given, or is one of other letters."""
    match = _LISTED.fullmatch(above)
    bare = re.sub(r"\(.*\)$", "", above)
    found = [known.get(names.get(each, "")) for each in (match[1].split(",") if match else [bare])]
    usable = [each for each in found if each is not None and each.usable and each.role != "case"]
    fits = all(not each.parameters or names.get(below) in each.parameters for each in usable)
    return usable if fits and len(usable) == len(found) else []

r"""A tilde in square brackets that marks a cross product: ``[\tilde{\mathbf a}] \mathbf b`` is that of a and b."""

import re
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, Sides, lone, tokens_in, trees_in

_TILDE = re.compile(r"\\(?:wide)?tilde\{\\mathbf(\\?[a-zA-Z]+)\}(.*)")


def crossed_by_tildes(equations: Iterable[Sides]) -> dict[str, str]:
    r"""Return the bold letters with a tilde that are matrices of cross products, with those without it.

    They stand alone in square brackets, and nowhere else.  One of them must stand somewhere without its tilde, and
    the document must have a cross.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> said = parsed(r"[\tilde{\mathbf a}] \mathbf b = \mathbf a \times \mathbf b + \tilde{\mathbf c}")
    >>> crossed_by_tildes([said.sides])
    {'\\tilde{\\mathbfa}': '\\mathbf{a}'}
    """
    sides = [side for each in equations for side in each]
    times = Counter(str(each.children[0]) for side in sides for each in side.find_data("symbol"))
    within = Counter(_in_brackets(each) for side in sides for each in side.find_data("bracket"))
    tildes = {each: match for each in within if (match := _TILDE.fullmatch(each)) and within[each] == times[each]}
    found = {each: rf"\mathbf{{{match[1]}}}{match[2]}" for each, match in tildes.items()}
    crossed = any(tokens_in(side, "CROSS") for side in sides)
    return found if crossed and not times.keys().isdisjoint(found.values()) else {}


def with_crosses(formula: Parsed, tildes: Mapping[str, str]) -> Parsed:
    """Return a formula in which the matrices of cross products are marked as such."""
    return replace(formula, sides=tuple(_marked(each, tildes) for each in formula.sides))


def _marked(tree: Any, tildes: Mapping[str, str]) -> Any:
    if not isinstance(tree, Tree):
        return tree
    if tree.data == "bracket" and (vector := tildes.get(_in_brackets(tree))):
        return Tree("marked", [Tree("symbol", [Token("SYMBOL", vector)]), Token("MARK", "hat")])
    return Tree(tree.data, [_marked(each, tildes) for each in tree.children])


def _in_brackets(bracket: Formula) -> str:
    """Return the letter that stands alone in a bracket; empty for more."""
    inside = [part for items in trees_in(bracket) for part in trees_in(items)]
    return lone(inside[0]) if len(inside) == 1 else ""

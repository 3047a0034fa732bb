r"""Derivatives at a place, as ``\frac{du}{dr}\big|_{r=R}``, and at fixed letters, as ``(\partial V/\partial T)_p``."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from lark import Token, Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import stands_within
from algebroproj_sym.reading.defining.notation import PARTIAL, derivative_in, has_rate
from algebroproj_sym.reading.defining.premises import Premise, letter_of
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.deriving.asking import slope_of, unchanged
from algebroproj_sym.reading.deriving.chains import filled
from algebroproj_sym.reading.deriving.derivatives import derivatives_in
from algebroproj_sym.reading.deriving.implicit import tied
from algebroproj_sym.reading.deriving.rates import ONE, ZERO
from algebroproj_sym.reading.lexing.names import bare_name
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula, parsed, put_in, symbols_in, without_brackets

_PLACE = re.compile(r"_at_([^=]+)=([^=]+)")
_KEPT = re.compile(r"_(?:at_)?([^=]+)")
_Relation = tuple[Formula, frozenset[str], str, Premise | None]
"""A derivative, the letters of what gives it, where that stands, and the equation if no letter is alone in it."""


def at_places(
    tree: Formula, vocabulary: Vocabulary, occurring: frozenset[str], above: Sequence[Premise]
) -> tuple[Formula, list[Definition], list[Premise]]:
    r"""Return a formula in which each derivative at a place, or at fixed letters, is a value that others stand for.

    ``\frac{du}{dr}|_{r=R}`` is computed from what u stands for.  ``(\partial V/\partial T)_p`` is computed from what V
    stands for, or from a relation of V, T and p: a definition of one of them, or an equation above.  What else stands
    there does not change, which the name of the value says.  Also returned are these values, and the equations.
    """
    parts = [at_places(each, vocabulary, occurring, above) for each in tree.children if isinstance(each, Tree)]
    made, under = [each for _, more, _ in parts for each in more], [each for *_, more in parts for each in more]
    trees = iter([part for part, *_ in parts])
    found: Formula = Tree(tree.data, [next(trees) if isinstance(each, Tree) else each for each in tree.children])
    if found.data != "marked" or not isinstance(found.children[0], Tree):
        return found, made, under
    body, mark = found.children[0], str(found.children[1])
    if place := _PLACE.fullmatch(mark):
        value = _at_place(body, place[1], place[2], vocabulary, occurring)
        return (found, made, under) if value is None else (value[0], [*made, value[1]], under)
    kept, inside = _KEPT.fullmatch(mark), without_brackets(body)
    slope = derivative_in(str(inside.children[0])) if kept and inside.data == "opaque" else None
    if kept is None or slope is None or not slope.is_first or slope.sign != PARTIAL:
        return found, made, under
    if given := _at_fixed((slope.function, slope.variable, kept[1]), vocabulary, occurring, above):
        rate, tie = given
        rate = replace(rate, symbol=f"{vocabulary.text(body)} at {kept[1]} ")
        return letter_of(rate.symbol), [*made, rate], [*under, *([tie] if tie else [])]
    return found, made, under


def is_at_place(tree: Formula) -> bool:
    """Whether a formula has a mark of a place, or of fixed letters."""
    return tree.data == "marked" and _KEPT.fullmatch(str(tree.children[1]).partition("=")[0]) is not None


def _at_place(
    body: Formula, letter: str, value: str, vocabulary: Vocabulary, occurring: frozenset[str]
) -> tuple[Formula, Definition] | None:
    """Return the value of a formula where a letter has one, and the function of this letter that has it."""
    rates = derivatives_in((body,), vocabulary, occurring)
    tree = put_in(body, {kind: Tree("group", [each.tree]) for each in rates for kind in _as_symbol(each.symbol)})
    used = [each for each in vocabulary.used_in(tree) if not each.parameters]
    tree = filled(tree, {each.symbol: each.tree for each in used})
    symbol = next((each for each in symbols_in(tree) if bare_name(each) == bare_name(letter)), "")
    try:
        sides = parsed(value).sides
    except UnreadableError:
        return None
    if not symbol or symbol in vocabulary.definitions or len(sides) != 1:
        return None
    others = vocabulary.letters_of(tree) - {symbol}
    if vocabulary.moves_with(others, symbol) or any(
        "/" in each or has_rate(each, symbol, occurring) for each in others
    ):
        return None
    where = " with ".join(dict.fromkeys(each.where for each in (*rates, *used))) or vocabulary.text(body)
    function = Definition(f"{vocabulary.text(body)} at {letter} ", (symbol,), tree, where, -1, True, role="case")
    return Tree("call", [Token("CALLEE", function.symbol), Tree("items", [Tree("group", [*sides])])]), function


def _as_symbol(symbol: str) -> Iterator[Formula]:
    """Yield both ways in which a derivative may stand in a tree."""
    yield letter_of(symbol)
    yield Tree("opaque", [Token("OPAQUE", symbol)])


def _at_fixed(
    names: tuple[str, str, str], vocabulary: Vocabulary, occurring: frozenset[str], premises: Sequence[Premise]
) -> tuple[Definition, Premise | None] | None:
    """Return the derivative of a letter by another one, as a formula or a relation with the kept letters gives it."""
    symbols = {bare_name(each): each for each in (*sorted(occurring), *vocabulary.definitions)}
    function, variable, kept = symbols.get(names[0], ""), symbols.get(names[1], ""), names[2]
    relations = [
        *_from_definitions(function, variable, vocabulary),
        *_from_premises(function, variable, vocabulary, premises),
    ]
    for rate, letters, where, tie in relations:
        fixed = letters - {function, variable}
        own = {each for each in fixed if bare_name(each) in kept}
        others = fixed - own
        if not own or "".join(sorted(kept)) != "".join(sorted("".join(map(bare_name, own)))):
            continue
        own_tie = tie.symbols if tie else frozenset()
        state = {function, variable, *own}
        hidden = any(vocabulary.moves_with(others, each, own_tie) for each in state) or stands_within(variable, fixed)
        if not (hidden or any(has_rate(one, two, occurring) for one in others for two in (*state, "t"))):
            where = f"{where}{unchanged(sorted(others), vocabulary)}"
            return Definition("", (), rate, where, -1, True, role="case"), tie
    return None


def _from_definitions(function: str, variable: str, vocabulary: Vocabulary) -> Iterator[_Relation]:
    """Yield derivatives by the formula of the letter, of the variable, or of another letter that both give."""
    known = vocabulary.definitions
    for given in (each for each in known.values() if each.usable and not each.parameters):
        letters, where = vocabulary.letters_of(given.tree), f"the derivative of {given.where}"
        if given.symbol == function and variable not in known:
            rate = slope_of(letter_of(function), variable) if variable in letters else ZERO
            yield rate, letters, where, None
        elif function in letters and variable == given.symbol:
            yield Tree("fraction", [ONE, slope_of(given.tree, function)]), letters, where, None
        elif {function, variable} <= letters:
            yield tied(given.tree, function, variable), letters | {given.symbol}, where, None


def _from_premises(
    function: str, variable: str, vocabulary: Vocabulary, premises: Sequence[Premise]
) -> Iterator[_Relation]:
    """Yield derivatives by the equations that have both letters."""
    for each in premises:
        both: Formula = Tree("sum", [each.left, Token("SIGN", "-"), Tree("group", [each.right])])
        letters = vocabulary.letters_of(both)
        if {function, variable} <= letters:
            yield tied(both, function, variable), letters, f"the derivative of {each.where}", each

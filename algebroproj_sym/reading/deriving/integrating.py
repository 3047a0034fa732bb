r"""What integrals between bounds are, such as ``\int_0^L k x \, dx``."""

import re
from collections.abc import Iterable, Mapping
from typing import Any

from lark import Token, Tree

from algebroproj_sym.expressions import shape
from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.defining.vocabulary import UNCOMPUTED, Vocabulary
from algebroproj_sym.reading.lexing.commands import LETTERS
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula, parsed, put_in, symbols_in
from algebroproj_sym.reading.parsing.integrals import INFINITE, integral_of

_BETWEEN = re.compile(r"\\int_\{(.+)\}\^\{(.+)\}")
_COMMAND = re.compile(r"\\[a-zA-Z]+")
_READ = LETTERS | {r"\frac", r"\sqrt", r"\infty"}
OVER = "the integral over"
"""How the name of an integral begins."""


def is_integral(tree: object) -> bool:
    """Whether a formula is an integral between bounds."""
    return isinstance(tree, Tree) and tree.data == "big" and _BETWEEN.fullmatch(str(tree.children[0])) is not None


def integral_in(tree: Formula, step: str, vocabulary: Vocabulary) -> Definition | None:
    """Return the value of an integral over the letter of a differential, with a letter for it; None if it stays."""
    body, variable, ends = tree.children[1], step[2:], _ends(str(tree.children[0]))
    if not ends or not isinstance(body, Tree) or variable in vocabulary.definitions or vocabulary.is_matrix(variable):
        return None
    letters = letter_of(variable), letter_of(step)
    try:
        bounds = [INFINITE[end] if isinstance(end, Token) else vocabulary.value(end) for end in ends]
        values = [*map(vocabulary.value, (body, *letters)), *bounds]
        if any(map(shape, values)):
            return None
        _, notes = integral_of(*values)
    except UNCOMPUTED:
        return None
    where = f"{OVER} {vocabulary.name(variable)}{''.join(f', with {each}' for each in notes)}"
    symbol = f"{tree.children[0]} {vocabulary.text(body)}"
    return Definition(symbol, (), Tree("integral", [body, *ends, *letters]), where, -1, True)


def with_integrals(tree: Formula, made: Mapping[str, Formula], vocabulary: Vocabulary) -> Formula:
    """Return a formula in which integrals stand where their letters were, over letters that stand nowhere else."""
    if tree.data == "symbol" and str(tree.children[0]) in made:
        return with_integrals(_over_another(made[str(tree.children[0])], vocabulary), made, vocabulary)
    parts = [with_integrals(each, made, vocabulary) if isinstance(each, Tree) else each for each in tree.children]
    return Tree(tree.data, parts)


def _over_another(integral: Formula, vocabulary: Vocabulary) -> Formula:
    """Return an integral over another letter, unless something else gives what stands in it."""
    body, *ends, variable, step = integral.children
    if not isinstance(body, Tree) or vocabulary.used_in(body):
        return integral
    ((letter,), (change,)) = (symbols_in(each) for each in (variable, step) if isinstance(each, Tree))
    bare = re.sub(r"\W", "", letter)
    others = {letter: rf"\bullet_{{{bare}}}", change: rf"d \bullet_{{{bare}}}"}
    renamed: dict[Formula, Formula] = {
        Tree(kind, [Token(kind.upper(), one)]): letter_of(other)
        for one, other in others.items()
        for kind in ("symbol", "opaque")
    }
    return Tree("integral", [put_in(body, renamed), *ends, *map(letter_of, others.values())])


def variables_of(sides: Iterable[Formula]) -> dict[tuple[str, str], str]:
    """Return the letters over which the integrals of an equation run, by bounds that no other letter has."""
    found: dict[tuple[str, str], str] = {}
    for part in (part for side in sides for part in side.find_data("big") if is_integral(part)):
        steps = [each[2:] for each in symbols_in(part) if each.startswith("d ")]
        match = _BETWEEN.fullmatch(str(part.children[0]))
        bounds = (match[1], match[2]) if match else ("", "")
        found[bounds] = steps[0] if len(steps) == 1 and found.get(bounds, steps[0]) == steps[0] else ""
    return {bounds: variable for bounds, variable in found.items() if variable}


def between_bounds(tree: Formula, variables: Mapping[tuple[str, str], str], vocabulary: Vocabulary) -> Formula:
    r"""Return a formula in which ``[F]_a^b`` is the difference of both values, where its equation has ``\int_a^b``."""
    parts = [between_bounds(each, variables, vocabulary) if isinstance(each, Tree) else each for each in tree.children]
    found = _bounds_of(tree)
    if found is None or found not in variables:
        return Tree(tree.data, parts)
    inside: Any = tree.children[0].children[0] if tree.data == "power" else tree.children[0]  # type: ignore[union-attr]
    variable, ends = variables[found], _ends(rf"\int_{{{found[0]}}}^{{{found[1]}}}")
    hidden = any(variable in vocabulary.letters_of(each.tree) for each in vocabulary.used_in(inside))
    if hidden or variable in vocabulary.definitions or len(ends) != 2 or any(isinstance(each, Token) for each in ends):
        return Tree(tree.data, parts)
    low, high = (Tree("group", [put_in(inside, {letter_of(variable): Tree("group", [end])})]) for end in ends)
    return Tree("group", [Tree("sum", [high, Token("SIGN", "-"), low])])


def _bounds_of(tree: Formula) -> tuple[str, str] | None:
    """Return between which bounds the value of a bracket, or of what stands before a bar, is taken; None for others."""
    if tree.data not in ("marked", "power"):
        return None
    first, *rest = tree.children
    if tree.data == "marked" and (match := _AT.fullmatch(str(rest[0]))):
        return match[1], match[2]
    if tree.data == "power" and isinstance(first, Tree) and first.data == "marked" and isinstance(rest[0], Tree):
        mark = str(first.children[1])
        above = rest[0].children[0] if rest[0].data in ("symbol", "number") else ""
        return (mark[1:], str(above)) if mark[:1] == "_" and above else None
    return None


_AT = re.compile(r"_at_([^^]+)\^([^^]+)")
"""The mark of a bar behind which bounds stand."""


def _ends(name: str) -> list[Any]:
    """Return the bounds in the name of an integral; none if they cannot be read."""
    match = _BETWEEN.fullmatch(name)
    found: list[Any] = []
    for written in match.groups() if match else ():
        if written in INFINITE:
            found.append(Token("END", written))
            continue
        if not {*_COMMAND.findall(written)} <= _READ:
            return []
        try:
            sides = parsed(written).sides
        except UnreadableError:
            return []
        if len(sides) != 1:
            return []
        found.append(sides[0])
    return found

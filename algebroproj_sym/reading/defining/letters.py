"""Relations of vectors and matrices as letters: their shapes are found from what can be added and multiplied.

A bold small letter is a column.  A size that nothing says is a letter, so that what is proved holds for every size.
The value of a function, a sum or an integral is a letter of its own, the same for the same text.
"""

import re
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import cycle
from typing import TypeVar

from algebroproj_sym.proving import Question
from algebroproj_sym.proving.letters import worked_out
from algebroproj_sym.reading.defining.building import built
from algebroproj_sym.reading.defining.maps import Map
from algebroproj_sym.reading.defining.parts import Part, Size, have_same_blocks, is_null, refused, same_shape
from algebroproj_sym.reading.defining.sizing import Reader
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.lexing.commands import VECTOR_STYLE
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula

Read = TypeVar("Read")
LONGEST = 2_000
"""How many characters a question may have: proofs of longer ones take too long."""
_NAME = re.compile(r"[A-Za-z]\w*")
_COORDINATE = re.compile(r"(.+)_(q?\d+)")
"""How a coordinate of a letter is called."""
_COLUMN = re.compile(rf"{VECTOR_STYLE}(?:\{{(?:\\\w+\{{)*(?:[a-z]|\\[a-z]+)\}}|(?:[a-z]|\\[a-z]+)\}})")
_LATIN = re.compile(rf"{VECTOR_STYLE}\{{(?:\\\w+\{{)*[a-z]\}}|{VECTOR_STYLE}[a-z]")


def lettered(
    vocabulary: Vocabulary, left: Formula, right: Formula, given: Sequence[tuple[Formula, Formula]] = ()
) -> list[Question]:
    """Return the question whether two sides are equal, with vectors and matrices as letters; of blocks, one for each.

    What is given are the sides of equations that hold, and that have no blocks.  Bold Greek letters are tensors if they
    cannot be columns.  A rotation has three dimensions if blocks need a size.  It raises `UnreadableError` if shapes do
    not fit, or something is read and not computed.
    """
    return _first_read(vocabulary, lambda reader: _asked(reader, left, right, given))


def has_shape(vocabulary: Vocabulary, tree: Formula) -> bool:
    """Whether a formula can be written with vectors and matrices as letters."""
    try:
        _first_read(vocabulary, lambda reader: reader.part(tree))
    except UnreadableError:
        return False
    return True


def _first_read(vocabulary: Vocabulary, read: Callable[[Reader], Read]) -> Read:
    """Return what is read with bold Greek letters as columns, or as tensors, or with rotations of three dimensions."""
    try:
        return read(Reader(vocabulary, _COLUMN, built))
    except UnreadableError as error:
        for reader in (Reader(vocabulary, _LATIN, built), Reader(vocabulary, _COLUMN, built, Size(3))):
            with suppress(UnreadableError):
                return read(reader)
        raise error


def _asked(reader: Reader, left: Formula, right: Formula, given: Sequence[tuple[Formula, Formula]]) -> list[Question]:
    reader.keep_names(left, right, *(side for pair in given for side in pair))
    sides = _of_one_shape(reader, left, right)
    constraints = [pair for each in given for pair in _in_blocks(_of_one_shape(reader, *each))]
    if any(side.blocks for pair in constraints for side in pair):
        raise refused("an equation of blocks")
    questions = [reader.question(pair) for pair in _in_blocks(sides)]
    if any(len(each.lhs) + len(each.rhs) > LONGEST for each in questions):
        raise UnreadableError("with all definitions put in, it is too long")
    texts = [pair for one, other in constraints if len({*(pair := (one.text(), other.text()))}) > 1]
    return [
        each
        if each.lhs == each.rhs
        else _told_apart(
            replace(each, constraints=(*each.constraints, *(worked_out(*pair, each.letters or {}) for pair in texts)))
        )
        for each in questions
    ]


def _told_apart(question: Question) -> Question:
    """Return a question in which no vector or matrix is called as a coordinate of another one: P_1 beside P is P1.

    A number that is called so may be the coordinate.
    """
    letters = dict(question.letters or {})
    texts = (question.lhs, question.rhs, *question.constraints, *question.nonzero)
    taken = {*letters, *(name for each in texts for name in _NAME.findall(each))}
    names: dict[str, str] = {}
    for name in sorted(letters):
        whose = _COORDINATE.fullmatch(name)
        if whose is not None and whose[1] in letters:
            names[name] = f"{whose[1]}{whose[2]}"
            while names[name] in taken:
                names[name] += "v"
            taken.add(names[name])
    if not names:
        return question
    left, right, *others = (_NAME.sub(lambda found: names.get(found[0], found[0]), each) for each in texts)
    place = len(question.constraints)
    letters = {names.get(name, name): text for name, text in letters.items()}
    return replace(
        question, lhs=left, rhs=right, constraints=(*others[:place],), nonzero=(*others[place:],), letters=letters
    )


def _of_one_shape(reader: Reader, left: Formula, right: Formula) -> list[Part]:
    sides = [reader.part(tree) for tree in (left, right)]
    if all(isinstance(side, Map) for side in sides):
        same_shape(*sides)
        matrix = reader.whole("any matrix", [], sides[0].shape)
        sides = [side.of(matrix) for side in sides if isinstance(side, Map)]
    if not any(side.is_zero for side in sides):
        same_shape(*sides)
    return sides


def _in_blocks(sides: list[Part]) -> list[list[Part]]:
    """Return the sides of an equation, or of that of each block if both have the same, or one is zero."""
    if not have_same_blocks(*sides) and not any(side.is_zero for side in sides):
        return [sides]
    blocks = [[cell for row in side.blocks for cell in row] for side in sides]
    pairs = zip(*(each or cycle([side]) for each, side in zip(blocks, sides, strict=True)), strict=False)
    found = [[*pair] for pair in pairs] if any(blocks) else [sides]
    return [pair for pair in found if not all(map(is_null, pair))] or found[:1]

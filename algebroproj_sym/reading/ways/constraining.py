"""Relations under equations above them: those of their letters alone, or all tied to them."""

from collections.abc import Collection, Iterator, Sequence
from itertools import combinations

from lark import Tree

from algebroproj_sym.reading.asking.questions import Way
from algebroproj_sym.reading.defining.premises import MOST_NEAR, MOST_TOGETHER, Premise, extended, sides_of
from algebroproj_sym.reading.defining.recognising import differ_in_one_letter
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in
from algebroproj_sym.reading.remembering.standing import Standing
from algebroproj_sym.reading.ways.substituting import with_rates


def under_equations(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    """Yield a relation under near or cited equations above it: those of its letters alone, or all tied to it.

    An equation of vectors is one for each component.
    All are taken together only where words, an arrow or a citation say that it follows.
    """
    if any(each.parameters for each in standing.vocabulary.used_in(left, right)):
        return
    letters = standing.vocabulary.letters_of(left, right)
    near = standing.near(MOST_TOGETHER)
    speaks = {each: standing.vocabulary.letters_of(*each.sides) for each in near}
    asserted = [each for place, each in enumerate(near) if is_asserted(standing, each, is_last=place < MOST_NEAR)]
    alone = tuple(each for each in asserted if not (each.gives or each.chained) and speaks[each] <= letters)
    supposed = standing.supposed(left, right)
    own = [each for each in supposed if each.gives is None]
    told = extended(standing.vocabulary, [each.gives for each in supposed if each.gives is not None])
    if alone:
        yield Way(left, right, told, under=(*alone, *own))
    last = [
        each
        for each in near[:MOST_NEAR]
        if each.gives is None and speaks[each] <= letters and _is_still_so(standing, each)
    ]
    several = [each for each in asserted if _has_components(each, speaks[each] & letters)]
    for each in dict.fromkeys((*last, *several)):
        if (each,) != alone:
            yield Way(left, right, told, under=(each, *own))
    tied = set(letters)
    together: list[Premise] = []
    while standing.follows and (more := [each for each in asserted if each not in together and speaks[each] & tied]):
        tied = tied.union(*(speaks[each] for each in more))
        together += more
    if any(differ_in_one_letter(one.sides, other.sides) for one, other in combinations(together, 2)):
        return
    if together and tuple(together) != alone:
        yield Way(left, right, told, under=(*together, *own))
    yield from _with_given_letters(standing, left, right, [each for each in asserted if each.gives is None])
    yield from _with_rates_put_in(standing, left, right, asserted, own)


def is_asserted(standing: Standing, premise: Premise, *, is_last: bool) -> bool:
    """Whether an equation holds where no case is spoken of: words cite it, or it is one of the last ones."""
    is_named = bool(premise.names & standing.cited) and not premise.context.kind
    is_near = is_last and premise.part == standing.part and _is_still_so(standing, premise)
    return not premise.special or is_named or is_near


def _is_still_so(standing: Standing, premise: Premise) -> bool:
    """Whether no letter of an equation was given since, but by a display that defines it; of a chain, if it is zero."""
    known = standing.vocabulary.definitions
    given = [each for each in premise.symbols if each not in known or known[each].explicit]
    is_zero = any(side.data == "number" and side.children[0] == "0" for side in premise.sides)
    since = any(standing.given_at.get(symbol, -1) > premise.place for symbol in given)
    return (is_zero or not premise.chained) and not since


def _with_given_letters(standing: Standing, left: Formula, right: Formula, others: Sequence[Premise]) -> Iterator[Way]:
    """Yield a relation under an equation in which letters stand for what equations beside it say of them."""
    given = standing.given_beside(left, right)
    told = extended(standing.vocabulary, given)
    letters = told.letters_of(left, right)
    tied = [each for each in others if told.letters_of(*each.sides) & letters]
    symbols = {letter.symbol for letter in given}
    own = {*symbols_in(left), *symbols_in(right)}
    changed = [each for each in tied if symbols & (each.symbols | own)]
    for under in dict.fromkeys(((changed[0],), (*tied,))) if changed else ():
        yield Way(left, right, told, under=under)


def _with_rates_put_in(
    standing: Standing, left: Formula, right: Formula, others: Sequence[Premise], own: Sequence[Premise]
) -> Iterator[Way]:
    r"""Yield a relation under one of its letters with derivatives put in, as ``\dot p = F`` with ``p = m v``."""
    known = standing.vocabulary
    for under in [(each, *own) for each in others] or [(*own,)]:
        given = sides_of(under)
        told = with_rates(standing, (left, right, *given), known)
        rates = {each.symbol for each in told.used_in(left, right, *given)} - {*known.definitions}
        letters = told.letters_of(left, right, *given[2:])
        if under and rates and told.letters_of(*given[:2]) <= letters:
            yield Way(left, right, told, under=under)


def _has_components(premise: Premise, letters: Collection[str]) -> bool:
    """Whether an equation has a printed matrix, and some letters: it is one for each component."""
    return bool(letters) and any(_is_printed(part) for side in premise.sides for part in side.iter_subtrees())


def _is_printed(tree: Formula) -> bool:
    """Whether a formula is a matrix, or a vector as ``(x, y)``."""
    inside = tree.children[0] if tree.data == "bracket" else tree
    return tree.data == "matrix" or (isinstance(inside, Tree) and inside.data == "items" and len(inside.children) > 1)

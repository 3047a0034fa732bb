"""Equations with both sides differentiated."""

from collections.abc import Iterator
from dataclasses import replace

from algebroproj_sym.reading.defining.notation import DOT, derivative_in
from algebroproj_sym.reading.defining.premises import Premise
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.deriving.asking import unchanged
from algebroproj_sym.reading.deriving.rates import ONE, ZERO
from algebroproj_sym.reading.deriving.totals import derived, rates_in
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in


def derived_by(*sides: Formula) -> Iterator[str]:
    """Yield the letters by which the derivatives in some formulas are; a dot is one by t."""
    found = [each for side in sides for symbol in symbols_in(side) if (each := derivative_in(symbol)) is not None]
    if any(each.sign == DOT for each in found):
        yield "t"
    yield from dict.fromkeys(each.variable for each in found if each.is_first)


def differentiated(
    premise: Premise, variable: str, vocabulary: Vocabulary, occurring: frozenset[str]
) -> Premise | None:
    """Return an equation with both sides differentiated by a letter; None if nothing in it changes.

    Letters without a derivative in the document are taken not to change, and where it stands says so.
    """
    own = {**rates_in(occurring, variable), variable: ONE}
    rates, fixed = [], set[str]()
    try:
        for side in (premise.left, premise.right):
            rate, known, letters = derived(side, own, vocabulary)
            rates.append(rate)
            fixed |= letters - known.keys()
    except UnreadableError:
        return None
    fixed = {each for each in fixed if vocabulary.constant(each) is None and f"{each}({variable})" not in own}
    moves = any(map(vocabulary.gives_letters, fixed)) or vocabulary.moves_with(fixed, variable, premise.symbols)
    if rates == [None, None] or moves:
        return None
    left, right = (each or ZERO for each in rates)
    where = f"the derivative of {premise.where}{unchanged(sorted(fixed), vocabulary)}"
    return replace(premise, left=left, right=right, where=where, chained=False)

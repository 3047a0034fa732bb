"""Equations with both sides differentiated."""

import re
from collections.abc import Iterator
from dataclasses import replace

from algebroproj_sym.reading.defining.premises import Premise
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.deriving.derivatives import rates_in, through_given, unchanged
from algebroproj_sym.reading.deriving.rates import ONE, ZERO, rate_of
from algebroproj_sym.reading.lexing.names import bare_name
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in

_DOTTED = re.compile(r"\\(?:mathbf\{\s*)?\\?d+ot(?![a-z])")
_SLOPE = re.compile(r"(?:d|\\partial)[^/]*/(?:d|\\partial)([^/^]+)")


def derived_by(*sides: Formula) -> Iterator[str]:
    """Yield the letters by which the derivatives in some formulas are; a dot is one by t."""
    symbols = [symbol for side in sides for symbol in symbols_in(side)]
    if any(map(_DOTTED.search, symbols)):
        yield "t"
    yield from dict.fromkeys(bare_name(match[1]) for each in symbols if (match := _SLOPE.fullmatch(each)))


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
            known, trees = through_given(side, own, vocabulary)
            rates.append(rate_of(side, known))
            fixed |= {each for tree in trees for each in symbols_in(tree) if each not in known}
    except UnreadableError:
        return None
    fixed = {each for each in fixed if vocabulary.constant(each) is None and f"{each}({variable})" not in own}
    moves = any(map(vocabulary.gives_letters, fixed)) or vocabulary.moves_with(fixed, variable, premise.symbols)
    if rates == [None, None] or moves:
        return None
    left, right = (each or ZERO for each in rates)
    where = f"the derivative of {premise.where}{unchanged(sorted(fixed), vocabulary)}"
    return replace(premise, left=left, right=right, where=where, chained=False)

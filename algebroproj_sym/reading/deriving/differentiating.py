"""Equations with both sides differentiated."""

from collections.abc import Iterator, Mapping
from dataclasses import replace

from algebroproj_sym.reading.defining.notation import DOT, bare, derivative_in, derivatives_among, names_in
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
    yield from dict.fromkeys(each.variable for each in found if each.is_quotient and each.variable)


def differentiated(
    premise: Premise, variable: str, vocabulary: Vocabulary, occurring: frozenset[str]
) -> Iterator[Premise]:
    """Yield an equation with both sides differentiated by a letter, once and twice, if its derivatives stand somewhere.

    Letters without a derivative in the document are taken not to change, and where it stands says so.
    """
    names = names_in(occurring)
    known = occurring.union(*(each.lower for each in derivatives_among(occurring)))
    rates = {**rates_in(known, variable), variable: ONE}
    made, fixed = premise, set[str]()
    for which in ("derivative", "second derivative"):
        sides, more = _rates_of(made, rates, vocabulary)
        fixed |= {each for each in more if vocabulary.constant(each) is None and f"{each}({variable})" not in rates}
        moves = any(map(vocabulary.gives_letters, fixed)) or vocabulary.moves_with(fixed, variable, made.symbols)
        if not any(sides) or moves:
            return
        left, right = (each or ZERO for each in sides)
        where = f"the {which} of {premise.where}{unchanged(sorted(fixed), vocabulary)}"
        made = replace(premise, left=left, right=right, where=where, chained=False)
        if all(bare(each) in names for each in made.symbols if derivative_in(each)):
            yield made


def _rates_of(
    premise: Premise, rates: Mapping[str, Formula], vocabulary: Vocabulary
) -> tuple[list[Formula | None], set[str]]:
    """Return the derivatives of both sides, none for one that is not computed, and the letters that do not change."""
    found, fixed = list[Formula | None](), set[str]()
    for side in premise.sides:
        try:
            rate, known, letters = derived(side, rates, vocabulary)
        except UnreadableError:
            return [], fixed
        found.append(rate)
        fixed |= letters - known.keys()
    return found, fixed

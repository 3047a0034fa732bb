"""Relations with what their own sentences suppose."""

from collections.abc import Collection, Iterator

from algebroproj_sym.reading.asking.questions import Way
from algebroproj_sym.reading.defining.dependence import index_of, letters_of_symbol
from algebroproj_sym.reading.defining.premises import extended, given_values, sides_of, with_given
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in
from algebroproj_sym.reading.remembering.standing import Standing
from algebroproj_sym.reading.remembering.survey import Survey
from algebroproj_sym.reading.ways.substituting import solutions, with_rates


def as_its_sentence_supposes(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    """Yield a relation with what its own sentence supposes put in, alone and with the equations above it."""
    own = standing.supposed(left, right)
    supposed = [each.gives for each in own if each.gives is not None]
    used = standing.vocabulary.with_used(left, right)
    bound = {symbol for side in used for part in side.find_data("big") for symbol in _bound_in(part, standing.survey)}
    places = {(each.symbol, each.place) for each in supposed}
    twice = len({symbol for symbol, _ in places}) < len(places)
    if not own or twice or bound.intersection(each.symbol for each in supposed):
        return
    for premises, given in (([], []), (standing.above, standing.given)):
        known = extended(standing.vocabulary, [*given, *supposed])
        changing = with_rates(standing, (left, right), known)
        differs = changing.used_in(left, right) != known.used_in(left, right)
        yield from (Way(left, right, each) for each in (known, changing)[: 1 + differs])
        values = given_values([*premises, *own], known, (left, right))
        if values:
            ours, theirs = (with_given(side, values) for side in (left, right))
            yield Way(ours, theirs, extended(known, values.values()))
    last = standing.near(1)
    wanted = {*symbols_in(left), *symbols_in(right)}
    changing = with_rates(standing, sides_of(own), standing.vocabulary)
    for each in (*standing.near(), *own):
        for solution in solutions(each, changing, wanted):
            yield Way(left, right, extended(standing.vocabulary, [solution, *supposed]))
    letters = {*symbols_in(left), *symbols_in(right), *standing.vocabulary.definitions}
    letters = letters.union(*(each.symbols for each in last))
    tied = tuple(each for each in own if each.gives is None or each.gives.symbol in letters)
    for under in dict.fromkeys(((*tied, *last), tied)):
        yield Way(left, right, changing, under=under)


def _bound_in(big: Formula, survey: Survey) -> Collection[str]:
    """Return the letters of an integral or a sum into which nothing is put; in a sum, those that may change with it."""
    index = index_of(str(big.children[0]))
    varying = survey.dependence.related(index) | {index} if index else frozenset()
    return [each for each in symbols_in(big) if not index or varying & {each, *letters_of_symbol(each)}]

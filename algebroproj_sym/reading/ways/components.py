"""Relations by components: of vectors in printed cross products, and in index notation."""

from collections.abc import Iterator
from dataclasses import replace

from algebroproj_sym.reading.asking.questions import Way
from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.premises import applicable, extended
from algebroproj_sym.reading.deriving.summation import in_components
from algebroproj_sym.reading.parsing.grammar import Formula
from algebroproj_sym.reading.remembering.standing import Standing
from algebroproj_sym.reading.ways.substituting import with_rates


def with_printed_components(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    """Yield a relation with the components of vectors and matrices, and the functions, that printed matrices tell."""
    place = standing.beside.place
    if standing.survey.shows_components(left, right, place):
        return
    above = [each for each in standing.survey.crossed if each.place < place]
    made = [each for each in above if each.symbol not in standing.vocabulary.definitions]
    crosses = [each for each in above if each.tree.data == "marked" and (each in made or not each.parameters)]
    seen = list[list[Definition]]()
    for given in (crosses, made, [*made, *_last_entries(standing)]):
        for known in (extended(standing.vocabulary, given), extended(standing.told, given)):
            for changing in (known, with_rates(standing, (left, right), known)):
                used = changing.used_in(left, right)
                if used not in seen and any(each in given for each in used):
                    seen.append(used)
                    yield Way(left, right, changing)


def _last_entries(standing: Standing) -> list[Definition]:
    """Return what the last printed matrix above says of the letters for its entries: all are of the same one."""
    above = [each for each in standing.survey.entries if each.place < standing.beside.place]
    last = {each.symbol: each for each in above}
    return [each for each in last.values() if each.symbol not in standing.vocabulary.definitions]


def by_components(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    """Yield a relation in index notation by its components, with the last that is given of each letter.

    Of what is given in the same section, the first serves as well.  What may be a matrix beside a letter with indices
    is a number.
    """
    survey = standing.survey
    if not survey.sums_over_indices or survey.is_flat:
        return
    above = applicable([*standing.premises, *standing.summed], standing.part, standing.cited)
    given = [*standing.vocabulary.definitions.values(), *(each.gives for each in (*above, *standing.own) if each.gives)]
    given.sort(key=lambda each: each.place)
    shown = standing.vocabulary.equation(left, right)
    numbers = standing.vocabulary.changed(kinds=replace(standing.vocabulary.kinds, open=frozenset()))
    seen = []
    here, others = ([each for each in given if (each.part == standing.part) is same] for same in (True, False))
    for serving in (given, [*others, *here[::-1]]):
        found = in_components((left, right), serving, survey.tensor_indices, unit=survey.says(r"\b<permutations>\b"))
        if found is None or found in seen:
            return
        seen.append(found)
        ours, theirs, known, components = found
        if components & {*standing.vocabulary.definitions} - {each.symbol for each in known}:
            return
        reads = f"{shown}, with sums from 1 to 3 over what stands twice in a term as an index"
        yield Way(ours, theirs, extended(numbers, known), reads)

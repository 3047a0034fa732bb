"""Relations at another index, with other ends of their sums, and from one whole number to the next one."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from lark import Tree

from algebroproj_sym.reading.asking.questions import Way
from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import ANY, letters_of_symbol
from algebroproj_sym.reading.defining.premises import MOST_TOGETHER, extended
from algebroproj_sym.reading.deriving.ends import with_same_ends
from algebroproj_sym.reading.deriving.indexed import instance_of, instances, sources_of
from algebroproj_sym.reading.deriving.indices import excludes
from algebroproj_sym.reading.deriving.induction import steps_of
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in
from algebroproj_sym.reading.remembering.standing import Standing


def at_other_indices(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    """Yield a relation with what equations above it say at another index: of a lone letter, and of all letters."""
    known, indices = standing.vocabulary, standing.survey.indices
    if not indices.counted or excludes(standing.beside.words):
        return
    given, others = sources_of(standing.premises, known, indices, standing.part, standing.cited)
    shown = known.equation(left, right)
    told = extended(known, given)
    seen: list[tuple[Definition, str]] = []
    both: Formula = Tree("items", [left, right])
    for sides in ((left, right), (both,)):
        found = [*instances(given, told, indices, sides)]
        if found and found != seen:
            put = "; ".join(f"{how} in {each.where}" for each, how in found)
            yield Way(left, right, extended(told, [each for each, _ in found]), f"{shown}, with {put}")
        seen = found
    for each in others[-MOST_TOGETHER:]:
        if (instance := instance_of(each, known, indices, {*symbols_in(left), *symbols_in(right)})) is not None:
            premise, how = instance
            yield Way(left, right, known, f"{shown}, with {how} in {each.where}", under=(premise,))


def gives_at_other_index(standing: Standing, left: Formula, right: Formula) -> bool:
    """Whether an equation above says what a letter is at another index, by letters that the right side has."""
    if excludes(standing.beside.words):
        return False
    given, _ = sources_of(
        standing.premises, standing.vocabulary, standing.survey.indices, standing.part, standing.cited
    )
    found = instances(given, standing.vocabulary, standing.survey.indices, (left,))
    return any({*each.symbols} & {*symbols_in(right)} for each, _ in found)


def with_same_ends_in(standing: Standing, ways: Sequence[Way]) -> Iterator[Way]:
    """Yield ways in which sums have the same ends, also in what is put in."""
    for way in ways:
        used = [each for each in way.vocabulary.used_in(*way.sides) if any(True for _ in each.tree.find_data("big"))]
        trees = [*way.sides, *(each.tree for each in used)]
        left, right, *others = with_same_ends(trees, standing.survey.indices)
        if [left, right, *others] != trees:
            given = [replace(each, tree=tree) for each, tree in zip(used, others, strict=True)]
            yield Way(left, right, extended(way.vocabulary, given), way.reads)


def by_induction(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    """Yield the first value and the step to the next one of a sum or a product that is given up to a letter."""
    known = standing.vocabulary

    def is_fixed(symbol: str, index: str, last: str) -> bool:
        behind = {symbol, *known.behind(symbol)}
        varying = {index, last, ANY} | known.dependence.related(index, last)
        return varying.isdisjoint(behind.union(*map(letters_of_symbol, behind)))

    for sides in ((left, right), (right, left)):
        found = steps_of(*sides, is_fixed)
        if found is not None and found.last not in known.definitions:
            shown = f"{known.equation(left, right)}, by induction"
            supposes = (f"{known.name(found.last)} is a whole number >= {found.first}",)
            yield Way(found.left, found.right, known, shown, supposes=supposes, last=found.last)

"""Relations in which letters stand for other formulas, also in what they may rest on."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import partial

from algebroproj_sym.reading.asking.questions import Way
from algebroproj_sym.reading.defining.premises import MOST_PREMISES, extended, sides_of
from algebroproj_sym.reading.deriving.arguments import (
    Changed,
    alike,
    eliminated_in,
    known_without,
    premise_without,
    without_arguments,
)
from algebroproj_sym.reading.deriving.components import columns_as_letters
from algebroproj_sym.reading.deriving.multiples import Multiples
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, put_in, symbols_in
from algebroproj_sym.reading.parsing.grammar import lone as lone_letter
from algebroproj_sym.reading.remembering.standing import Standing
from algebroproj_sym.reading.ways.constraining import under_equations
from algebroproj_sym.reading.ways.substituting import solutions, with_premises
from algebroproj_sym.reading.ways.supposing import as_its_sentence_supposes


def with_functions_as_letters(standing: Standing, formula: Parsed, index: int) -> Iterator[Way]:
    """Yield a relation in which functions with and without their argument are the same letters."""
    survey = standing.survey
    known, omitted = standing.vocabulary, survey.omits_arguments
    functions = alike(survey.lone_arguments, survey.occurring, known, standing.premises, omitted=omitted)
    eliminated = eliminated_in(standing.beside.sentence)
    for each in known.definitions.values():
        if len(each.parameters) == 1 and eliminated.issuperset(each.parameters):
            functions[each.symbol] = each.parameters[0]
    if functions:
        name = standing.vocabulary.name
        calls = {each: f"{name(each)}({', '.join(of.split())})" for each, of in sorted(functions.items())}
        changed = partial(without_arguments, functions=functions)
        yield from _changed(standing, formula, index, functions, changed, calls)


def with_columns_as_letters(standing: Standing, formula: Parsed, index: int) -> Iterator[Way]:
    """Yield a relation in which each printed column is a letter, also in the equations above it."""
    near = sides_of(standing.premises[-MOST_PREMISES:])
    known = [each.tree for each in standing.vocabulary.definitions.values()]
    letters = columns_as_letters([*formula.sides[index : index + 2], *known, *near])
    names = {str(letter.children[0]): standing.vocabulary.text(column) for column, letter in letters.items()}
    if letters:
        yield from _changed(standing, formula, index, {}, partial(put_in, values=letters), names)


def _changed(
    standing: Standing,
    formula: Parsed,
    index: int,
    functions: Mapping[str, str],
    changed: Changed,
    stands_for: Mapping[str, str],
) -> Iterator[Way]:
    """Yield a relation in which letters stand for other formulas, also in what it may rest on."""
    sides = tuple(map(changed, formula.sides))
    left, right = sides[index : index + 2]
    known = known_without(standing.vocabulary, functions, changed)
    used = known.with_used(left, right)
    made = {symbol for each in used for symbol in symbols_in(each)}
    told = ", ".join(f"{known.name(each)} is {what}" for each, what in stands_for.items() if each in made)
    if not told:
        return
    bare = replace(standing, vocabulary=known, premises=[premise_without(each, changed) for each in standing.premises])
    of_letters = replace(formula, sides=sides)
    for way in (
        Way(left, right, known),
        *with_premises(bare, of_letters, index),
        *under_equations(bare, left, right),
        *as_its_sentence_supposes(bare, left, right),
    ):
        yield replace(way, reads=f"{known.equation(*way.sides)}, where {told}")


def as_multiples(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    """Yield a relation in which what is not computed is one letter, also in the equations above it."""
    multiples = Multiples(standing.told)
    if all(map(multiples.is_number, (left, right))):
        return
    try:
        sides = multiples.changed(left), multiples.changed(right)
    except UnreadableError:
        return
    flat = multiples.known(standing.vocabulary.definitions.values())
    own = [*multiples.premises(standing.own)]
    given = [each.gives for each in (*multiples.premises(standing.above), *own) if each.gives is not None]
    others = [each for each in given if each.symbol not in map(lone_letter, sides)]
    wanted = {symbol for each in sides for symbol in symbols_in(each)}
    near = [*multiples.premises(standing.near()), *own]
    solved = [one for each in near for one in solutions(each, flat, wanted)]
    for letters in ([], others, given, *([one] for one in solved), *([*others, one] for one in solved)):
        known = extended(flat, letters)
        if multiples.are_sums(known, sides):
            made = {each: tree for each, tree in multiples.letters.items() if each in wanted}
            named = ", ".join(f"{known.name(each)} is {known.text(tree)}" for each, tree in made.items())
            yield Way(*sides, known, f"{known.equation(*sides)}{named and ', where '}{named}")

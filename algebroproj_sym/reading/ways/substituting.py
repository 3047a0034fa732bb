"""Relations with what equations above them say put in."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from itertools import product

from algebroproj_sym.reading.asking.doubts import doubt_of, doubt_of_premises
from algebroproj_sym.reading.asking.questions import A_VALUE, Way, complex_letters_in
from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import free_symbols
from algebroproj_sym.reading.defining.notation import derivative_in
from algebroproj_sym.reading.defining.premises import MOST_NEAR, Premise, extended, given_values, said_by, with_given
from algebroproj_sym.reading.defining.vanishing import are_lone, factors_of_zero, leave_a_choice, share_a_sum
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.deriving.asking import UNCHANGED
from algebroproj_sym.reading.deriving.chains import filled
from algebroproj_sym.reading.deriving.derivatives import derivatives_in
from algebroproj_sym.reading.deriving.differentiating import derived_by, differentiated
from algebroproj_sym.reading.deriving.integrating import OVER, between_bounds, variables_of, with_integrals
from algebroproj_sym.reading.deriving.operating import computed, is_worked_out
from algebroproj_sym.reading.deriving.places import at_places, is_at_place
from algebroproj_sym.reading.deriving.solving import solution_of
from algebroproj_sym.reading.parsing.factors import base_of
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, symbols_in
from algebroproj_sym.reading.prose.devices import says
from algebroproj_sym.reading.prose.words import Beside
from algebroproj_sym.reading.remembering.standing import Standing

MOST_SOLVED = 4
"""For how many vectors and matrices an equation is solved."""


_CHANGES = frozenset(
    {
        *("loses", "gains", "burns", "ejects", "gathers", "hardens", "softens", "melts", "evaporates", "leaks"),
        *("empties", "drains", "shrinks", "draws", "apart", "faster", "slower", "accelerates", "decelerates"),
        "grows",
    }
)
"""Words of things whose masses, lengths or stiffnesses change, so that no letter is taken to be fixed."""


def with_premises(standing: Standing, formula: Parsed, index: int) -> Iterator[Way]:
    """Yield the ways to take a relation that rest on equations above it, and on derivatives."""
    left, right = formula.sides[index], formula.sides[index + 1]
    seen = [tuple(map(id, standing.vocabulary.used_in(left, right)))]
    for known in _vocabularies(standing, left, right):
        used = known.used_in(left, right)
        if (ids := tuple(map(id, used))) not in seen:
            seen.append(ids)
            yield Way(left, right, known, doubt=doubt_of_premises(standing.beside, formula, index, known))
    yield from _with_given_values(standing, left, right)
    yield from _solved_for_values(standing, left, right)
    yield from _with_computed(standing, formula, index)


def _vocabularies(standing: Standing, left: Formula, right: Formula) -> Iterator[Vocabulary]:
    """Yield what letters stand for by the equations above a relation: those of lone letters, and then of others.

    The last one serves alone where those before it give its letters by its own one.
    """
    for given in ([], standing.given_beside(left, right), standing.given, standing.given[-1:]):
        known = extended(standing.vocabulary, given)
        yield known
        yield with_rates(standing, (left, right), known)
    wanted = [*symbols_in(left), *symbols_in(right)]
    parameters = {symbol for each in standing.vocabulary.used_in(left, right) for symbol in each.parameters}
    supposed = frozenset().union(*(each.symbols for each in standing.own))
    for each in standing.near():
        tied = (parameters | supposed) & each.symbols
        for solution in [] if tied else solutions(each, standing.vocabulary, wanted):
            yield extended(standing.vocabulary, [solution])


def _with_given_values(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    """Yield a relation in which values that equations above give, such as E(X), stand for what they say.

    What gives one of its sides serves, or does not: ``s^2 = b`` may follow from other equations than ``s^2 = a``.
    """
    premises = standing.above
    others = [each for each in premises if {left, right}.isdisjoint(value for value, _ in each.values)]
    for serving in (premises, others)[: 1 + (len(others) < len(premises))]:
        values = given_values(serving, standing.vocabulary, (left, right))
        if any(each.role != "definition" for each in values.values()):
            ours, theirs = (with_given(side, values) for side in (left, right))
            for plain in ([], standing.given_beside(left, right)):
                yield Way(ours, theirs, extended(standing.vocabulary, [*plain, *values.values()]))


def _solved_for_values(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    r"""Yield a relation with a side such as ``\cos a`` as what an equation above it, solved for it, says."""
    known, plain = standing.vocabulary, standing.vocabulary.changed(definitions={})
    for value, other in ((left, right), (right, left)):
        if value.data != "function" or complex_letters_in(known, left, right):
            continue
        of_value = {value: Definition(f"{known.text(value)} ", (), value, "", 0, True)}
        letter = with_given(value, of_value)
        for each in (*standing.near(), *standing.supposed(left, right)):
            sides = [with_given(side, of_value) for side in each.sides]
            if sides != [*each.sides] and letter not in sides:
                renamed = replace(each, left=sides[0], right=sides[1])
                solution = renamed.solved(plain, symbols_in(letter), alone=True)
                given_with = [] if solution is None else [[solution], [*standing.given, solution]]
                yield from (Way(letter, other, extended(known, given)) for given in given_with)


def _with_computed(standing: Standing, formula: Parsed, index: int) -> Iterator[Way]:
    r"""Yield a relation with what stands behind ``\frac{d}{dx}`` and ``\int_a^b`` computed, also in what is put in."""
    left, right = formula.sides[index], formula.sides[index + 1]
    told, own = standing.told, free_symbols(left) | free_symbols(right)
    variables = variables_of(formula.sides)
    sides = [between_bounds(side, variables, told) for side in (left, right)] if variables else [left, right]
    lone = [told.definitions[each] for each in (*symbols_in(left), *symbols_in(right)) if each in told.definitions]
    put_in = [
        each
        for each in dict.fromkeys((*told.used_in(left, right), *(each for each in lone if each.holds)))
        if any(map(_is_worked_out, each.tree.iter_subtrees()))
    ]
    worked = [_worked_out(each, standing, own) for each in (*sides, *(each.tree for each in put_in))]
    (ours, theirs, *trees), made = [tree for tree, *_ in worked], [each for _, more, _ in worked for each in more]
    under = tuple(dict.fromkeys(each for *_, more in worked for each in more))
    if not (made or sides != [left, right]) or any(_rests_on_what_changes(each, standing.beside) for each in made):
        return
    given = [
        replace(each, tree=tree, usable=each.usable or (each.holds and tree != each.tree))
        for each, tree in zip(put_in, trees, strict=True)
    ]
    known = extended(standing.vocabulary, [*made, *given])
    plain = not variables and not any(each.where.startswith(OVER) or each.role == "case" for each in made)
    doubt = doubt_of(standing.beside, formula, index, standing.vocabulary) if plain else A_VALUE
    yield Way(ours, theirs, known, under=under, doubt=doubt)
    rated = extended(with_rates(standing, (ours, theirs), told), [*made, *given])
    yield Way(ours, theirs, rated, under=under)


def _is_worked_out(tree: Formula) -> bool:
    return is_worked_out(tree) or is_at_place(tree)


def _worked_out(
    tree: Formula, standing: Standing, own: frozenset[str]
) -> tuple[Formula, list[Definition], list[Premise]]:
    """Return a formula with what stands in it worked out, what that stands for, and under which equations."""
    occurring = standing.survey.occurring
    placed, values, under = at_places(tree, standing.told, occurring, standing.above)
    worked, made = computed(placed, standing.told, occurring, own)
    return worked, [*values, *made], under


def from_worked_out(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    r"""Yield a relation with a letter for which an equation near it, or cited, is solved once it is worked out.

    Such an equation has integrals, ``\frac{d}{dt}`` or derivatives at a place.
    """
    own, wanted = free_symbols(left) | free_symbols(right), [*symbols_in(left), *symbols_in(right)]
    for each in standing.near():
        if not any(_is_worked_out(part) for side in each.sides for part in side.iter_subtrees()):
            continue
        beside = replace(standing, premises=[one for one in standing.premises if one.place != each.place])
        (one, made, _), (other, more, _) = (_worked_out(side, beside, own) for side in each.sides)
        made = [*made, *more]
        integrals = {letter.symbol: letter.tree for letter in made if letter.tree.data == "integral"}
        one, other = (with_integrals(side, integrals, standing.vocabulary) for side in (one, other))
        rates = [letter for letter in made if letter.symbol not in integrals]
        one, other = (filled(side, {letter.symbol: letter.tree for letter in rates}) for side in (one, other))
        known = extended(with_rates(beside, (one, other), beside.told), rates) if rates else standing.vocabulary
        for solution in solutions(replace(each, left=one, right=other), known, wanted):
            where = "; ".join((solution.where, *(letter.where for letter in made)))
            yield Way(left, right, extended(known, [replace(solution, where=where)]))


def from_derivatives(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    """Yield a relation under equations near it or cited with both sides differentiated, where words speak of that.

    They must hold not only at one moment, which is said.
    """
    if not says(r"\b<differentiates>\b", standing.beside.sentence):
        return
    within = {each.display.place for each in standing.survey.statements if each.display.environment == "inline"}
    last = standing.near()[:1]
    near = [each for each in standing.near() if not each.special or each.place in within or each in last]
    given = sorted(standing.vocabulary.definitions.values(), key=lambda each: each.place)[-MOST_NEAR:]
    near += [said_by(each) for each in given if each.part == standing.part and not each.parameters]
    for variable, each in product(derived_by(left, right), near):
        for made in differentiated(each, variable, standing.vocabulary, standing.survey.occurring):
            if _rests_on_what_changes(made, standing.beside):
                continue
            where = (f"{each.where} holds for every {standing.vocabulary.name(variable)}",)
            for under in ((made,), (made, each)):
                yield Way(left, right, standing.vocabulary, under=under, supposes=where)
            for solution in solutions(made, standing.vocabulary, [*symbols_in(left), *symbols_in(right)]):
                yield Way(left, right, extended(standing.vocabulary, [solution]), supposes=where)


def solutions(premise: Premise, vocabulary: Vocabulary, wanted: Collection[str]) -> Iterator[Definition]:
    """Yield what an equation says of a number in which it is linear, or else of vectors and matrices."""
    if share_a_sum(*premise.sides):
        return
    if (solution := premise.solved(vocabulary, wanted)) is not None:
        yield solution
        return
    factors = factors_of_zero(*premise.sides)
    if are_lone(factors):
        return
    unknown = [each for each in wanted if each in premise.symbols and each not in vocabulary.definitions]
    has_vectors = any(map(vocabulary.is_matrix, premise.symbols))
    if has_vectors and vocabulary.with_identity(*premise.sides) is not None:
        unknown = [each for each in unknown if not vocabulary.is_like_identity(each)]
    factors = [each for each in factors if not vocabulary.is_matrix(base_of(each))]
    numbers = {each: not vocabulary.is_matrix(each) for each in unknown}
    values = {
        each: solution_of(*premise.sides, each, is_number=is_number)
        for each, is_number in numbers.items()
        if not is_number or (has_vectors and not leave_a_choice(factors, each))
    }
    yield from [premise.said(each, value) for each, value in values.items() if value is not None][:MOST_SOLVED]


def with_rates(standing: Standing, trees: Sequence[Formula], known: Vocabulary) -> Vocabulary:
    """Return a vocabulary with what the derivatives in some formulas stand for."""
    at_vectors = [each.at_vector for each in standing.above if each.at_vector is not None]
    rates = derivatives_in(trees, known, standing.survey.occurring, at_vectors)
    changing = {each.symbol for each in rates if _rests_on_what_changes(each, standing.beside)}
    others = {each.symbol for each in rates if standing.beside.variables - known.letters_of(each.tree) - _below(each)}
    return extended(known, [each for each in rates if each.symbol not in changing | others])


def _below(rate: Definition) -> set[str]:
    """Return the letters by which a derivative is."""
    slope = derivative_in(rate.symbol)
    return set() if slope is None else {*slope.letters}


def _rests_on_what_changes(rate: Definition | Premise, beside: Beside) -> bool:
    """Whether a derivative takes letters to be fixed though words say that something changes."""
    return rate.where.endswith(UNCHANGED) and not _CHANGES.isdisjoint(beside.words | {*rate.words})

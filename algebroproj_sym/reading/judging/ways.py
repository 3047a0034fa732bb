"""The ways in which a relation may be meant, and on what of the document it may rest in each."""

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from itertools import combinations

from lark import Tree

from algebroproj_sym.reading.defining.dependence import free_symbols, index_of, letters_of_symbol
from algebroproj_sym.reading.defining.premises import (
    MOST_NEAR,
    MOST_PREMISES,
    MOST_TOGETHER,
    Premise,
    applicable,
    extended,
    given_values,
    letter_of,
    neighbours,
    with_given,
)
from algebroproj_sym.reading.defining.recognising import defined_by, differ_in_one_letter
from algebroproj_sym.reading.defining.tensors import DIMENSIONS, depend_on_size
from algebroproj_sym.reading.defining.vanishing import are_lone, factors_of_zero, leave_a_choice, share_a_sum
from algebroproj_sym.reading.defining.vocabulary import Definition, Numbers, Vocabulary
from algebroproj_sym.reading.deriving.arguments import Changed, alike, known_without, premise_without, without_arguments
from algebroproj_sym.reading.deriving.components import columns_as_letters
from algebroproj_sym.reading.deriving.derivatives import computed, derivatives_in
from algebroproj_sym.reading.deriving.ends import with_same_ends
from algebroproj_sym.reading.deriving.gradients import along_directions
from algebroproj_sym.reading.deriving.indexed import instance_of, instances, sources_of
from algebroproj_sym.reading.deriving.indices import excludes
from algebroproj_sym.reading.deriving.instances import powers_of
from algebroproj_sym.reading.deriving.integrating import OVER, between_bounds, is_integral, variables_of, with_integrals
from algebroproj_sym.reading.deriving.multiples import Multiples
from algebroproj_sym.reading.deriving.quaternions import AsMatrices
from algebroproj_sym.reading.deriving.rates import UNCHANGED
from algebroproj_sym.reading.deriving.solving import solution_of
from algebroproj_sym.reading.deriving.summation import in_components
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.judging.doubts import A_VALUE, doubt_of, doubt_of_premises
from algebroproj_sym.reading.judging.questions import Sides, Way, complex_letters_in, used_by
from algebroproj_sym.reading.judging.survey import Survey
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.factors import base_of
from algebroproj_sym.reading.parsing.grammar import (
    Formula,
    Parsed,
    put_in,
    regrouped,
    symbols_in,
    with_divided_angles,
)
from algebroproj_sym.reading.parsing.grammar import lone as lone_letter
from algebroproj_sym.reading.prose.words import Beside

MOST_SOLVED = 4
"""For how many vectors and matrices an equation is solved."""


_SEVERAL = re.compile(r"(.+)_\{?(?:12|1,2|1/2|\\pm)\}?")
"""A letter for both roots of an equation."""
_CHANGES = frozenset(
    {
        *("loses", "gains", "burns", "ejects", "gathers", "hardens", "softens", "melts", "evaporates", "leaks"),
        *("empties", "drains", "shrinks", "draws", "apart", "faster", "slower", "accelerates", "decelerates"),
    }
)
"""Words of things whose masses, lengths or stiffnesses change, so that no letter is taken to be fixed."""


@dataclass(frozen=True)
class Standing:
    """Where an equation stands: what is known there, and what it may rest on."""

    survey: Survey
    """What is known of the whole document."""
    vocabulary: Vocabulary
    """What letters stand for there."""
    beside: Beside
    """The words beside it."""
    part: int
    """How many headings come before it."""
    premises: Sequence[Premise]
    """The equations above it that hold there."""
    cited: frozenset[str]
    """The labels and numbers that words before it name."""
    given_at: Mapping[str, int]
    """Where each letter was alone on a side for the last time."""
    own: Sequence[Premise] = ()
    """The equations within the text that its own sentence supposes."""
    summed: Sequence[Premise] = ()
    """The equations above it in which an index is summed over silently."""

    @property
    def follows(self) -> bool:
        """Whether an equation is said to follow from those above it: by words, an arrow or a citation."""
        return self.beside.follows or bool(self.cited)


def ways_of(standing: Standing, statement: Statement, formula: Parsed, index: int) -> list[Way]:
    """Return the ways to take a link of a formula, the first one as it stands."""
    left, right = formula.sides[index], formula.sides[index + 1]
    known = standing.vocabulary
    ranged = sorted((known.letters_of(left) | known.letters_of(right)) & standing.survey.restricted)
    special = f"{known.name(ranged[0])} stands for the elements of a set" if ranged else ""
    if word := standing.survey.special:
        special = special or f"the word {word!r} may mean special values or products"
    doubt = special or doubt_of(standing.beside, formula, index, known)
    others = _others(standing, statement, formula, index)
    above = [each.gives for each in applicable(standing.premises, standing.part, standing.cited) if each.gives]
    told = extended(known, above)
    ways = [
        Way(left, right, known, doubt),
        *(Way(*each, known, reads=" = ".join(map(known.text, each))) for each in others),
        *(replace(each, doubt=special or each.doubt) for each in _with_premises(standing, formula, index)),
        *_under_equations(standing, left, right),
        *_as_its_sentence_supposes(standing, left, right),
        *_from_integrals(standing, left, right),
        *_raised(standing, formula, index),
        *_said_before(standing, left, right),
        *(at_others := [*_at_other_indices(standing, left, right)]),
        *_with_same_ends(standing, [Way(left, right, told), *(each for each in at_others if not each.under)]),
        *_without_arguments(standing, formula, index),
        *_with_columns(standing, formula, index),
        *_of_quaternions(standing, formula, index),
        *_with_components(standing, left, right, told),
        *_as_multiples(standing, left, right),
        *by_components(standing, left, right),
    ]
    ways += [
        replace(way, vocabulary=other, reads=f"{' = '.join(map(other.text, way.sides))}, where I is the identity")
        for way in ways
        if not way.reads and (other := way.vocabulary.with_identity(*way.sides)) is not None
    ]
    ways += [each for way in ways if not way.reads for each in along_directions_in(way)]
    if standing.survey.has_tensors_of_three_rows:
        ways += [_with_three_rows(way) for way in ways if _depends_on_size(way)]
    return ways + [each for way in ways if way.is_as_it_stands for each in _with_complex_numbers(way)]


def _depends_on_size(way: Way) -> bool:
    """Whether what a way asks may depend on how many rows its letters have, as the trace of the identity does."""
    used = used_by(way.vocabulary, *way.sides)
    trees = [*way.sides, *(each.tree for each in used)]
    letters = frozenset().union(*map(way.vocabulary.letters_of, trees))
    has_identity = any("identity" in way.vocabulary.properties_of(each) for each in letters)
    return depend_on_size(trees, has_identity=has_identity) and not any(each.parameters for each in used)


def _with_three_rows(way: Way) -> Way:
    """Return a way in which vectors and matrices have three rows, if nothing else says how many."""
    shown = way.reads or " = ".join(map(way.vocabulary.text, way.sides))
    known = way.vocabulary.with_rows(DIMENSIONS)
    return replace(way, vocabulary=known, doubt=A_VALUE, reads=f"{shown}, in three dimensions")


def along_directions_in(way: Way) -> Iterator[Way]:
    """Yield the ways in which a derivative by a vector, also of an equation above, is that along every direction."""
    shown = f"{' = '.join(map(way.vocabulary.text, way.sides))}, along every direction"
    with_identity = way.vocabulary.with_identity(*way.sides)
    readings = ((way.vocabulary, shown), (with_identity, f"{shown}, where I is the identity"))
    given = [side for each in way.under for side in (each.left, each.right)]
    for known, reads in readings:
        if known is not None and (found := along_directions(known, *way.sides, *given)) is not None:
            (left, right, *others), changed = found
            under = [
                replace(each, left=a, right=b) for each, a, b in zip(way.under, others[::2], others[1::2], strict=True)
            ]
            yield Way(left, right, changed, A_VALUE, reads, tuple(under))


def _others(standing: Standing, statement: Statement, formula: Parsed, index: int) -> Iterator[Sides]:
    """Yield a relation as LaTeX may mean it as well: the slash, and how far the argument of a function goes."""
    sides = formula.sides[index], formula.sides[index + 1]
    for otherwise in (regrouped, with_divided_angles):
        if (others := (otherwise(sides[0]), otherwise(sides[1]))) != sides:
            yield others
    if formula.chose:
        with suppress(UnreadableError):
            narrow = standing.survey.parsed(statement, wide=False)
            yield narrow.sides[index], narrow.sides[index + 1]


def _with_premises(standing: Standing, formula: Parsed, index: int) -> Iterator[Way]:
    """Yield the ways to take a relation that rest on equations above it, and on derivatives."""
    left, right = formula.sides[index], formula.sides[index + 1]
    seen = [tuple(map(id, used_by(standing.vocabulary, left, right)))]
    for known in _vocabularies(standing, left, right):
        used = used_by(known, left, right)
        if (ids := tuple(map(id, used))) not in seen:
            seen.append(ids)
            yield Way(left, right, known, doubt_of_premises(standing.beside, formula, index, known))
    yield from _with_given_values(standing, left, right)
    above = [each.gives for each in applicable(standing.premises, standing.part, standing.cited) if each.gives]
    yield from _with_computed(standing, formula, index, extended(standing.vocabulary, above))


def _with_computed(standing: Standing, formula: Parsed, index: int, told: Vocabulary) -> Iterator[Way]:
    r"""Yield a relation with what stands behind ``\frac{d}{dx}`` and ``\int_a^b`` computed, also in what is put in."""
    left, right = formula.sides[index], formula.sides[index + 1]
    occurring, own = standing.survey.occurring, free_symbols(left) | free_symbols(right)
    variables = variables_of(formula.sides)
    sides = [between_bounds(side, variables, told) for side in (left, right)] if variables else [left, right]
    (ours, made), (theirs, more) = (computed(side, told, occurring, own) for side in sides)
    put_in = [each for each in used_by(told, left, right) if any(map(is_integral, each.tree.iter_subtrees()))]
    worked = [computed(each.tree, told, occurring, own) for each in put_in]
    made = [*made, *more, *(each for _, further in worked for each in further)]
    if not (made or sides != [left, right]) or any(_rests_on_what_changes(each, standing.beside) for each in made):
        return
    given = [replace(each, tree=tree) for each, (tree, _) in zip(put_in, worked, strict=True)]
    known = extended(standing.vocabulary, [*made, *given])
    plain = not variables and not any(each.where.startswith(OVER) for each in made)
    doubt = doubt_of(standing.beside, formula, index, standing.vocabulary) if plain else A_VALUE
    yield Way(ours, theirs, known, doubt)
    yield Way(ours, theirs, extended(_with_rates(standing, (ours, theirs), told), [*made, *given]), A_VALUE)


def _with_same_ends(standing: Standing, ways: Sequence[Way]) -> Iterator[Way]:
    """Yield ways in which sums have the same ends, also in what is put in."""
    for way in ways:
        used = [each for each in used_by(way.vocabulary, *way.sides) if any(True for _ in each.tree.find_data("big"))]
        trees = [*way.sides, *(each.tree for each in used)]
        left, right, *others = with_same_ends(trees, standing.survey.indices)
        if [left, right, *others] != trees:
            given = [replace(each, tree=tree) for each, tree in zip(used, others, strict=True)]
            yield Way(left, right, extended(way.vocabulary, given), A_VALUE, way.reads)


def _from_integrals(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    """Yield a relation with a letter for which a near or cited equation of integrals is solved."""
    occurring, own = standing.survey.occurring, free_symbols(left) | free_symbols(right)
    for each in neighbours(standing.premises, standing.part, standing.cited):
        if not any(is_integral(part) for side in (each.left, each.right) for part in side.iter_subtrees()):
            continue
        sides = each.left, each.right
        (one, made), (other, more) = (computed(side, standing.vocabulary, occurring, own) for side in sides)
        trees = {letter.symbol: letter.tree for letter in (*made, *more)}
        one, other = (with_integrals(side, trees, standing.vocabulary) for side in (one, other))
        worked = replace(each, left=one, right=other)
        for solution in _solutions(worked, standing.vocabulary, {*symbols_in(left), *symbols_in(right)}):
            where = "; ".join((solution.where, *(letter.where for letter in (*made, *more))))
            yield Way(left, right, extended(standing.vocabulary, [replace(solution, where=where)]), A_VALUE)


def _with_given_values(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    """Yield a relation in which values that equations above give, such as E(X), stand for what they say.

    What gives one of its sides serves, or does not: ``s^2 = b`` may follow from other equations than ``s^2 = a``.
    """
    premises = applicable(standing.premises, standing.part, standing.cited)
    others = [each for each in premises if {left, right}.isdisjoint(value for value, _ in each.values)]
    given = [each.gives for each in premises if each.gives is not None]
    lone = {symbol for symbol in (defined_by(left)[0], defined_by(right)[0]) if symbol}
    for serving in (premises, others)[: 1 + (len(others) < len(premises))]:
        values = given_values(serving, standing.vocabulary, (left, right))
        if any(each.role != "definition" for each in values.values()):
            ours, theirs = (with_given(side, values) for side in (left, right))
            for plain in ([], [each for each in given if each.symbol not in lone]):
                yield Way(ours, theirs, extended(standing.vocabulary, [*plain, *values.values()]), A_VALUE)


def _under_equations(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    """Yield a relation under near or cited equations above it: those of its letters alone, or all tied to it.

    An equation of vectors is one for each component.
    All are taken together only where words, an arrow or a citation say that it follows.
    """
    if any(each.parameters for each in used_by(standing.vocabulary, left, right)):
        return
    letters = standing.vocabulary.letters_of(left) | standing.vocabulary.letters_of(right)
    near = neighbours(standing.premises, standing.part, standing.cited, MOST_TOGETHER)
    speaks = {
        each: standing.vocabulary.letters_of(each.left) | standing.vocabulary.letters_of(each.right) for each in near
    }
    asserted = [each for place, each in enumerate(near) if _is_asserted(standing, each, is_last=place < MOST_NEAR)]
    alone = tuple(each for each in asserted if not (each.gives or each.chained) and speaks[each] <= letters)
    supposed = _supposed(standing, left, right)
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
    if any(
        differ_in_one_letter((one.left, one.right), (other.left, other.right))
        for one, other in combinations(together, 2)
    ):
        return
    if together and tuple(together) != alone:
        yield Way(left, right, told, under=(*together, *own))
    yield from _with_given_letters(standing, left, right, [each for each in asserted if each.gives is None])


def _is_asserted(standing: Standing, premise: Premise, *, is_last: bool) -> bool:
    """Whether an equation holds where no case is spoken of: words cite it, or it is one of the last ones."""
    is_named = bool(premise.names & standing.cited) and not premise.context.kind
    is_near = is_last and premise.part == standing.part and _is_still_so(standing, premise)
    return not premise.special or is_named or is_near


def _is_still_so(standing: Standing, premise: Premise) -> bool:
    """Whether no letter of an equation was given since, but by a display that defines it; of a chain, if it is zero."""
    known = standing.vocabulary.definitions
    given = [each for each in premise.symbols if each not in known or known[each].explicit]
    is_zero = any(side.data == "number" and side.children[0] == "0" for side in (premise.left, premise.right))
    since = any(standing.given_at.get(symbol, -1) > premise.place for symbol in given)
    return (is_zero or not premise.chained) and not since


def _with_given_letters(standing: Standing, left: Formula, right: Formula, others: Sequence[Premise]) -> Iterator[Way]:
    """Yield a relation under an equation in which letters stand for what equations beside it say of them."""
    lone = {symbol for symbol in (defined_by(left)[0], defined_by(right)[0]) if symbol}
    above = applicable(standing.premises, standing.part, standing.cited)
    given = [each.gives for each in above if each.gives is not None and each.gives.symbol not in lone]
    told = extended(standing.vocabulary, given)
    letters = told.letters_of(left) | told.letters_of(right)
    tied = [each for each in others if (told.letters_of(each.left) | told.letters_of(each.right)) & letters]
    symbols = {letter.symbol for letter in given}
    own = {*symbols_in(left), *symbols_in(right)}
    changed = [each for each in tied if symbols & (each.symbols | own)]
    for under in dict.fromkeys(((changed[0],), (*tied,))) if changed else ():
        yield Way(left, right, told, A_VALUE, under=under)


def _has_components(premise: Premise, letters: Collection[str]) -> bool:
    """Whether an equation has a printed matrix, and some letters: it is one for each component."""
    sides = premise.left, premise.right
    return bool(letters) and any(_is_printed(part) for side in sides for part in side.iter_subtrees())


def _is_printed(tree: Formula) -> bool:
    """Whether a formula is a matrix, or a vector as ``(x, y)``."""
    inside = tree.children[0] if tree.data == "bracket" else tree
    return tree.data == "matrix" or (isinstance(inside, Tree) and inside.data == "items" and len(inside.children) > 1)


def _as_its_sentence_supposes(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    """Yield a relation with what its own sentence supposes put in, alone and with the equations above it."""
    own = _supposed(standing, left, right)
    supposed = [each.gives for each in own if each.gives is not None]
    used = (left, right, *(each.tree for each in used_by(standing.vocabulary, left, right)))
    bound = {symbol for side in used for part in side.find_data("big") for symbol in _bound_in(part, standing.survey)}
    places = {(each.symbol, each.place) for each in supposed}
    twice = len({symbol for symbol, _ in places}) < len(places)
    if not own or twice or bound.intersection(each.symbol for each in supposed):
        return
    above = applicable(standing.premises, standing.part, standing.cited)
    for premises in ([], above):
        given = [each.gives for each in premises if each.gives is not None]
        known = extended(standing.vocabulary, [*given, *supposed])
        yield Way(left, right, known, A_VALUE)
        values = given_values([*premises, *own], known, (left, right))
        if values:
            ours, theirs = (with_given(side, values) for side in (left, right))
            yield Way(ours, theirs, extended(known, values.values()), A_VALUE)
    last = neighbours(standing.premises, standing.part, standing.cited, 1)
    wanted = {*symbols_in(left), *symbols_in(right)}
    with_rates = _with_rates(standing, [side for each in own for side in (each.left, each.right)], standing.vocabulary)
    for each in (*neighbours(standing.premises, standing.part, standing.cited), *own):
        for solution in _solutions(each, with_rates, wanted):
            yield Way(left, right, extended(standing.vocabulary, [solution, *supposed]), A_VALUE)
    letters = {*symbols_in(left), *symbols_in(right)}.union(*(each.symbols for each in last))
    tied = tuple(each for each in own if each.gives is None or each.gives.symbol in letters)
    for under in dict.fromkeys(((*tied, *last), tied)):
        yield Way(left, right, with_rates, A_VALUE, under=under)


def _bound_in(big: Formula, survey: Survey) -> Collection[str]:
    """Return the letters of an integral or a sum into which nothing is put; in a sum, those that may change with it."""
    index = index_of(str(big.children[0]))
    varying = survey.dependence.related(index) | {index} if index else frozenset()
    return [each for each in symbols_in(big) if not index or varying & {each, *letters_of_symbol(each)}]


def _supposed(standing: Standing, left: Formula, right: Formula) -> list[Premise]:
    return [each for each in standing.own if (each.left, each.right) not in ((left, right), (right, left))]


def _raised(standing: Standing, formula: Parsed, index: int) -> Iterator[Way]:
    """Yield the powers of a letter and of a root that it is, as they rest on others.

    Both have one sign, or its degree is odd, or words speak of a root, or of what is never negative.
    """
    left, right = formula.sides[index : index + 2]
    several = _SEVERAL.fullmatch(defined_by(left)[0])
    alone = several is not None and not any(defined_by(left)[0] in each.symbols for each in standing.premises)
    powers = powers_of(left, right)
    if powers and powers.is_open and several and alone:
        powers = powers_of(letter_of(several[1]), right)
    if powers is None or standing.vocabulary.is_matrix(symbols_in(powers.left)[0]):
        return
    branches = ({"branch", "lower"}, {"branch", "negative"})
    below = any(words <= each.words for words in branches for each in standing.premises[-MOST_PREMISES:])
    certain = powers.is_open or powers.degree % 2 or (standing.beside.speaks_of_a_length and not below)
    if not (certain or (standing.beside.speaks_of_a_root and not below)):
        return
    of_powers = replace(formula, sides=(powers.left, powers.right), relations=("=",))
    shown = " = ".join(map(standing.vocabulary.text, formula.sides[index : index + 2]))
    reads = shown if powers.is_open else f"{shown}, where both sides have the same sign"
    plain = Way(powers.left, powers.right, standing.vocabulary)
    for way in (
        *[plain][: bool(certain)],
        *_with_premises(standing, of_powers, 0),
        *_under_equations(standing, *plain.sides),
    ):
        yield replace(way, reads=reads, doubt=A_VALUE)


def _said_before(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    """Yield a relation as one that stands above it in no case, or in its section: no letter of it was given since."""
    for each in standing.premises[-MOST_PREMISES:] if left != right else ():
        same = (each.left == left and each.right == right) or (each.left == right and each.right == left)
        elsewhere = each.part != standing.part
        if not same or (elsewhere and (each.special or standing.beside.is_conditional)):
            continue
        if all(standing.given_at.get(symbol, -1) <= each.place for symbol in each.symbols):
            said = each.said(f"{standing.vocabulary.text(left)} ", right)
            yield Way(letter_of(said.symbol), right, extended(standing.vocabulary, [said]), A_VALUE)
            return


def _at_other_indices(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    """Yield a relation with what equations above it say at another index: of a lone letter, and of all letters."""
    known, indices = standing.vocabulary, standing.survey.indices
    if not indices.counted or excludes(standing.beside.words):
        return
    given, others = sources_of(standing.premises, known, indices, standing.part, standing.cited)
    shown = " = ".join(map(known.text, (left, right)))
    told = extended(known, given)
    seen: list[tuple[Definition, str]] = []
    both: Formula = Tree("items", [left, right])
    for sides in ((left, right), (both,)):
        found = [*instances(given, told, indices, sides)]
        if found and found != seen:
            put = "; ".join(f"{how} in {each.where}" for each, how in found)
            yield Way(left, right, extended(told, [each for each, _ in found]), A_VALUE, f"{shown}, with {put}")
        seen = found
    for each in others[-MOST_TOGETHER:]:
        if (instance := instance_of(each, known, indices, {*symbols_in(left), *symbols_in(right)})) is not None:
            premise, how = instance
            yield Way(left, right, known, A_VALUE, f"{shown}, with {how} in {each.where}", under=(premise,))


def _without_arguments(standing: Standing, formula: Parsed, index: int) -> Iterator[Way]:
    """Yield a relation in which functions with and without their argument are the same letters."""
    survey = standing.survey
    known, omitted = standing.vocabulary, survey.omits_arguments
    functions = alike(survey.lone_arguments, survey.occurring, known, standing.premises, omitted=omitted)
    if functions:
        name = standing.vocabulary.name
        calls = {each: f"{name(each)}({', '.join(of.split())})" for each, of in sorted(functions.items())}
        changed = partial(without_arguments, functions=functions)
        yield from _changed(standing, formula, index, functions, changed, calls)


def _with_columns(standing: Standing, formula: Parsed, index: int) -> Iterator[Way]:
    """Yield a relation in which each printed column is a letter, also in the equations above it."""
    near = [side for each in standing.premises[-MOST_PREMISES:] for side in (each.left, each.right)]
    known = [each.tree for each in standing.vocabulary.definitions.values()]
    letters = columns_as_letters([*formula.sides[index : index + 2], *known, *near])
    names = {str(letter.children[0]): standing.vocabulary.text(column) for column, letter in letters.items()}
    if letters:
        yield from _changed(standing, formula, index, {}, partial(put_in, values=letters), names)


def _with_components(standing: Standing, left: Formula, right: Formula, told: Vocabulary) -> Iterator[Way]:
    """Yield a relation with the components of vectors, and the functions, that printed cross products tell."""
    place = standing.beside.place
    if standing.survey.shows_components(left, right, place):
        return
    above = [each for each in standing.survey.crossed if each.place < place]
    made = [each for each in above if each.symbol not in standing.vocabulary.definitions]
    functions = [each for each in made if each.parameters]
    for given in (functions, made):
        for known in (extended(standing.vocabulary, given), extended(told, given)):
            if any(each in made for each in used_by(known, left, right)):
                yield Way(left, right, known, A_VALUE)


def _of_quaternions(standing: Standing, formula: Parsed, index: int) -> Iterator[Way]:
    """Yield a relation of quaternions as one of their matrices, also the equations above it."""
    known, quaternions = standing.vocabulary, standing.survey.quaternions
    if not any({*symbols_in(each)} & quaternions for each in formula.sides[index : index + 2]):
        return
    is_number = lambda tree: not any(map(known.is_matrix, symbols_in(tree)))  # noqa: E731
    matrices = AsMatrices(quaternions, is_number, has_conjugates=standing.survey.has_conjugates)
    left, right = (matrices.turned(each) for each in formula.sides[index : index + 2])
    if left is None or right is None:
        return
    bare = known.copied()
    for each in known.definitions.values():
        if {each.symbol, *each.symbols} & quaternions:
            bare.definitions.pop(each.symbol)
            if each.symbol in quaternions and not each.parameters and (tree := matrices.turned(each.tree)) is not None:
                bare.define(replace(each, symbol=base_of(matrices.letter(each.symbol)), tree=tree, usable=each.holds))
    premises = []
    for premise in standing.premises:
        one, other = matrices.turned(premise.left), matrices.turned(premise.right)
        if not premise.symbols & quaternions:
            premises.append(premise)
        elif one is not None and other is not None:
            premises.append(replace(premise, left=one, right=other))
    units = {letter: ("orthogonal",) for of, letter in matrices.letters.items() if "unit" in known.properties_of(of)}
    bare = bare.with_properties(units)
    of_matrices = replace(formula, sides=(left, right), relations=("=",))
    there = replace(standing, vocabulary=bare, premises=premises, own=())
    shown = " = ".join(map(known.text, formula.sides[index : index + 2]))
    told = ", ".join(f"{bare.name(letter)} for {known.name(of)}" for of, letter in matrices.letters.items())
    for way in (Way(left, right, bare), *_with_premises(there, of_matrices, 0), *_under_equations(there, left, right)):
        yield replace(way, doubt=A_VALUE, reads=f"{shown}, with a matrix for each quaternion: {told}")


def by_components(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    """Yield a relation in index notation by its components, with the last that is given of each letter.

    Of what is given in the same section, the first serves as well.
    """
    survey = standing.survey
    if not survey.sums_over_indices or survey.is_flat:
        return
    above = applicable([*standing.premises, *standing.summed], standing.part, standing.cited)
    given = [*standing.vocabulary.definitions.values(), *(each.gives for each in (*above, *standing.own) if each.gives)]
    given.sort(key=lambda each: each.place)
    shown = " = ".join(map(standing.vocabulary.text, (left, right)))
    seen = []
    here, others = ([each for each in given if (each.part == standing.part) is same] for same in (True, False))
    for serving in (given, [*others, *here[::-1]]):
        found = in_components((left, right), serving, survey.tensor_indices, unit=survey.has_permutations)
        if found is None or found in seen:
            return
        seen.append(found)
        ours, theirs, known, components = found
        if components & {*standing.vocabulary.definitions} - {each.symbol for each in known}:
            return
        reads = f"{shown}, with sums from 1 to 3 over what stands twice in a term as an index"
        yield Way(ours, theirs, extended(standing.vocabulary, known), A_VALUE, reads)


def _as_multiples(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    """Yield a relation in which what is not computed is one letter, also in the equations above it."""
    above = applicable(standing.premises, standing.part, standing.cited)
    multiples = Multiples(extended(standing.vocabulary, [each.gives for each in above if each.gives]))
    if all(map(multiples.is_number, (left, right))):
        return
    try:
        sides = multiples.changed(left), multiples.changed(right)
    except UnreadableError:
        return
    flat = multiples.known(standing.vocabulary.definitions.values())
    own = [*multiples.premises(standing.own)]
    given = [each.gives for each in (*multiples.premises(above), *own) if each.gives is not None]
    others = [each for each in given if each.symbol not in map(lone_letter, sides)]
    wanted = {symbol for each in sides for symbol in symbols_in(each)}
    near = [*multiples.premises(neighbours(standing.premises, standing.part, standing.cited)), *own]
    solved = [one for each in near for one in _solutions(each, flat, wanted)]
    for letters in ([], others, given, *([one] for one in solved), *([*others, one] for one in solved)):
        known = extended(flat, letters)
        if multiples.are_sums(known, sides):
            made = {each: tree for each, tree in multiples.letters.items() if each in wanted}
            named = ", ".join(f"{known.name(each)} is {known.text(tree)}" for each, tree in made.items())
            yield Way(*sides, known, A_VALUE, f"{' = '.join(map(known.text, sides))}{named and ', where '}{named}")


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
    used = (left, right, *(each.tree for each in used_by(known, left, right)))
    made = {symbol for each in used for symbol in symbols_in(each)}
    told = ", ".join(f"{known.name(each)} is {what}" for each, what in stands_for.items() if each in made)
    if not told:
        return
    bare = replace(standing, vocabulary=known, premises=[premise_without(each, changed) for each in standing.premises])
    of_letters = replace(formula, sides=sides)
    for way in (
        Way(left, right, known),
        *_with_premises(bare, of_letters, index),
        *_under_equations(bare, left, right),
        *_as_its_sentence_supposes(bare, left, right),
    ):
        shown = " = ".join(map(known.text, way.sides))
        yield replace(way, doubt=A_VALUE, reads=f"{shown}, where {told}")


def gives_at_other_index(standing: Standing, left: Formula, right: Formula) -> bool:
    """Whether an equation above says what a letter is at another index, by letters that the right side has."""
    if excludes(standing.beside.words):
        return False
    given, _ = sources_of(
        standing.premises, standing.vocabulary, standing.survey.indices, standing.part, standing.cited
    )
    found = instances(given, standing.vocabulary, standing.survey.indices, (left,))
    return any({*each.symbols} & {*symbols_in(right)} for each, _ in found)


def _vocabularies(standing: Standing, left: Formula, right: Formula) -> Iterator[Vocabulary]:
    """Yield what letters stand for by the equations above a relation: those of lone letters, and then of others."""
    cited, part, serving = standing.cited, standing.part, standing.premises
    found = [each.gives for each in applicable(serving, part, cited) if each.gives is not None]
    lone = frozenset(symbol for symbol in (defined_by(left)[0], defined_by(right)[0]) if symbol)
    for given in ([], [each for each in found if each.symbol not in lone], found):
        known = extended(standing.vocabulary, given)
        yield known
        yield _with_rates(standing, (left, right), known)
    wanted = {*symbols_in(left), *symbols_in(right)}
    parameters = {symbol for each in used_by(standing.vocabulary, left, right) for symbol in each.parameters}
    supposed = frozenset().union(*(each.symbols for each in standing.own))
    for each in neighbours(serving, part, cited):
        tied = (parameters | supposed) & each.symbols
        for solution in [] if tied else _solutions(each, standing.vocabulary, wanted):
            yield extended(standing.vocabulary, [solution])


def _with_rates(standing: Standing, trees: Sequence[Formula], known: Vocabulary) -> Vocabulary:
    """Return a vocabulary with what the derivatives in some formulas stand for."""
    above = applicable(standing.premises, standing.part, standing.cited)
    at_vectors = [each.at_vector for each in above if each.at_vector is not None]
    rates = derivatives_in(trees, known, standing.survey.occurring, at_vectors)
    changing = {each.symbol for each in rates if _rests_on_what_changes(each, standing.beside)}
    others = {each.symbol for each in rates if standing.beside.variables - known.letters_of(each.tree) - _below(each)}
    return extended(known, [each for each in rates if each.symbol not in changing | others])


def _below(rate: Definition) -> set[str]:
    """Return the letter by which a derivative is."""
    return {rate.symbol.rpartition("/")[2].removeprefix(r"\partial").removeprefix("d").strip()}


def _rests_on_what_changes(rate: Definition, beside: Beside) -> bool:
    """Whether a derivative takes letters to be fixed though words say that something changes."""
    return rate.where.endswith(UNCHANGED) and not _CHANGES.isdisjoint(beside.words | {*rate.words})


def _solutions(premise: Premise, vocabulary: Vocabulary, wanted: Collection[str]) -> Iterator[Definition]:
    """Yield what an equation says of a number in which it is linear, or else of vectors and matrices."""
    if share_a_sum(premise.left, premise.right):
        return
    if (solution := premise.solved(vocabulary, wanted)) is not None:
        yield solution
        return
    factors = factors_of_zero(premise.left, premise.right)
    if are_lone(factors):
        return
    unknown = premise.symbols.intersection(wanted).difference(vocabulary.definitions)
    has_vectors = any(map(vocabulary.is_matrix, premise.symbols))
    factors = [each for each in factors if not vocabulary.is_matrix(base_of(each))]
    numbers = {each: not vocabulary.is_matrix(each) for each in sorted(unknown)}
    values = {
        each: solution_of(premise.left, premise.right, each, is_number=is_number)
        for each, is_number in numbers.items()
        if not is_number or (has_vectors and not leave_a_choice(factors, each))
    }
    yield from [premise.said(each, value) for each, value in values.items() if value is not None][:MOST_SOLVED]


def _with_complex_numbers(way: Way) -> Iterator[Way]:
    """Yield a way in which letters stand for complex numbers: all of them, or only those that complex ones give."""
    if not complex_letters_in(way.vocabulary, *way.sides):
        return
    shown, unit = " = ".join(map(way.vocabulary.text, way.sides)), way.vocabulary.imaginary
    unit = f", where {unit} is the imaginary unit" if unit else ", of complex numbers"
    kinds: tuple[tuple[Numbers, str], ...] = (
        ("complex", ""),
        ("some complex", ", and letters are real unless complex ones give them"),
    )
    for numbers, letters in kinds:
        known = way.vocabulary.with_complex_numbers(numbers)
        yield replace(way, vocabulary=known, reads=f"{shown}{unit}{letters}")

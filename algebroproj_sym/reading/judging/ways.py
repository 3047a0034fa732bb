"""The ways in which a relation may be meant, and on what of the document it may rest in each."""

import re
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace

from lark import Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import ANY, letters_of_symbol
from algebroproj_sym.reading.defining.domains import is_outside, range_in
from algebroproj_sym.reading.defining.premises import MOST_PREMISES, MOST_TOGETHER, extended, letter_of
from algebroproj_sym.reading.defining.recognising import defined_by
from algebroproj_sym.reading.defining.twists import tells_hat
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.deriving.angles import of_angle
from algebroproj_sym.reading.deriving.ends import with_same_ends
from algebroproj_sym.reading.deriving.indexed import instance_of, instances, sources_of
from algebroproj_sym.reading.deriving.indices import excludes
from algebroproj_sym.reading.deriving.induction import ends_in, steps_of
from algebroproj_sym.reading.deriving.instances import powers_of
from algebroproj_sym.reading.deriving.series import with_exponentials
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.judging.assuming import assumptions
from algebroproj_sym.reading.judging.components import by_components, with_printed_components
from algebroproj_sym.reading.judging.constraining import under_equations
from algebroproj_sym.reading.judging.doubts import doubt_of
from algebroproj_sym.reading.judging.fields import of_fields
from algebroproj_sym.reading.judging.quaternions import of_quaternions
from algebroproj_sym.reading.judging.questions import Sides, Way, complex_letters_in, used_by
from algebroproj_sym.reading.judging.renaming import as_multiples, with_columns_as_letters, with_functions_as_letters
from algebroproj_sym.reading.judging.sampling import is_somewhere_positive
from algebroproj_sym.reading.judging.solutions import of_solutions
from algebroproj_sym.reading.judging.standing import Standing
from algebroproj_sym.reading.judging.substituting import from_derivatives, from_worked_out, with_premises
from algebroproj_sym.reading.judging.supposing import as_its_sentence_supposes
from algebroproj_sym.reading.judging.survey import Survey
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import (
    Formula,
    Parsed,
    regrouped,
    symbols_in,
    with_divided_angles,
)

_SEVERAL = re.compile(r"(.+)_\{?(?:12|1,2|1/2|\\pm)\}?")
"""A letter for both roots of an equation."""


def ways_of(standing: Standing, statement: Statement, formula: Parsed, index: int) -> list[Way]:
    """Return the ways to take a link of a formula, the first one as it stands."""
    formula = replace(formula, sides=tuple(map(with_exponentials, formula.sides)))
    left, right = formula.sides[index], formula.sides[index + 1]
    if tells_hat(left, right):
        standing = replace(standing, vocabulary=_without_hats(standing.vocabulary))
    known = standing.vocabulary
    ranged = sorted(known.letters_of(left, right) & standing.survey.restricted)
    special = f"{known.name(ranged[0])} stands for the elements of a set" if ranged else ""
    if word := standing.survey.special:
        special = special or f"the word {word!r} may mean special values or products"
    doubt = special or doubt_of(standing.beside, formula, index, known)
    others = _others(standing, statement, formula, index)
    ways = [
        Way(left, right, known, doubt=doubt),
        *(Way(*each, known, reads=known.equation(*each)) for each in others),
        *(replace(each, doubt=special or each.doubt) for each in with_premises(standing, formula, index)),
        *under_equations(standing, left, right),
        *as_its_sentence_supposes(standing, left, right),
        *from_worked_out(standing, left, right),
        *from_derivatives(standing, left, right),
        *_raised(standing, formula, index),
        *_of_angle(standing, formula, index),
        *_said_before(standing, left, right),
        *(at_others := [*_at_other_indices(standing, left, right)]),
        *_with_same_ends(standing, [Way(left, right, standing.told), *(each for each in at_others if not each.under)]),
        *with_functions_as_letters(standing, formula, index),
        *with_columns_as_letters(standing, formula, index),
        *of_quaternions(standing, formula, index),
        *with_printed_components(standing, left, right),
        *as_multiples(standing, left, right),
        *by_components(standing, left, right),
        *of_fields(standing, left, right),
        *of_solutions(standing, left, right),
        *_by_induction(standing, left, right),
    ]
    ends = ends_in(left, right, *(each.tree for each in used_by(known, left, right)))
    for assumed in assumptions(standing, ends):
        ways += [each for way in ways for each in assumed(way)]
    return ways


def _without_hats(vocabulary: Vocabulary) -> Vocabulary:
    """Return a vocabulary in which the hat of six entries is not known."""
    return vocabulary.changed(kinds=replace(vocabulary.kinds, turning=None))


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


def _with_same_ends(standing: Standing, ways: Sequence[Way]) -> Iterator[Way]:
    """Yield ways in which sums have the same ends, also in what is put in."""
    for way in ways:
        used = [each for each in used_by(way.vocabulary, *way.sides) if any(True for _ in each.tree.find_data("big"))]
        trees = [*way.sides, *(each.tree for each in used)]
        left, right, *others = with_same_ends(trees, standing.survey.indices)
        if [left, right, *others] != trees:
            given = [replace(each, tree=tree) for each, tree in zip(used, others, strict=True)]
            yield Way(left, right, extended(way.vocabulary, given), way.reads)


def _raised(standing: Standing, formula: Parsed, index: int) -> Iterator[Way]:
    """Yield the powers of a letter and of a root that it is, as they rest on others.

    Both have one sign, or its degree is odd.  A root that is no multiple of letters has the plus sign, if the letter
    may have it; elsewhere words speak of a root, or of what is never negative.  A root on the left speaks for itself,
    of real letters that equations above give.
    """
    left, right = formula.sides[index : index + 2]
    several = _SEVERAL.fullmatch(defined_by(left)[0])
    alone = several is not None and not any(defined_by(left)[0] in each.symbols for each in standing.premises)
    powers = powers_of(left, right)
    if powers and powers.is_open and several and alone:
        powers = powers_of(letter_of(several[1]), right)
    is_root = powers is not None and not powers.is_open and not powers.is_of_left
    known = standing.vocabulary
    if is_root and (not used_by(known, left, right) or complex_letters_in(known, left, right)):
        return
    if powers is None or known.is_matrix(symbols_in(powers.left)[0]):
        return
    branches = ({"branch", "lower"}, {"branch", "negative"})
    below = any(words <= each.words for words in branches for each in standing.premises[-MOST_PREMISES:])
    certain = powers.is_open or powers.degree % 2 or is_root or (standing.beside.speaks_of_a_length and not below)
    positive = powers.is_positive and not (below or "negative" in standing.beside.words)
    if not (certain or positive or (standing.beside.speaks_of_a_root and not below)):
        return
    of_powers = replace(formula, sides=(powers.left, powers.right), relations=("=",))
    reads = f"{known.equation(left, right)}, as {known.equation(*of_powers.sides)}"
    same = f"{known.text(left)} >= 0" if positive else "both sides have the same sign"
    plain = Way(powers.left, powers.right, known)
    for way in (
        *[plain][: bool(certain or positive)],
        *with_premises(standing, of_powers, 0),
        *under_equations(standing, *plain.sides),
    ):
        if certain or not positive or is_somewhere_positive(way.vocabulary, left):
            yield replace(way, reads=reads, supposes=() if powers.is_open or powers.degree % 2 else (same,))


def _of_angle(standing: Standing, formula: Parsed, index: int) -> Iterator[Way]:
    """Yield what an equation with an inverse function says of its angle, which lies where such a function has values.

    Nothing above it gives the letters of the angle, and no range that is said of it is another one: it might differ by
    half a turn.
    """
    found, known = of_angle(*formula.sides[index : index + 2]), standing.vocabulary
    if found is None:
        return
    letters = lambda symbol: known.value(letter_of(symbol))  # noqa: E731
    if is_outside([*_ranges_of(standing.survey, found.angle), found.between], letters, letters):
        return
    low, angle, high = map(known.text, found.between.sides)
    between = f"{low} {found.between.relations[0]} {angle} {found.between.relations[1]} {high}"
    where = [between, *([f"{known.text(found.positive)} > 0"] if found.positive else [])]
    reads = f"{known.equation(*formula.sides[index : index + 2])}, as {known.equation(found.left, found.right)}"
    plain = Way(found.left, found.right, known)
    of_function = replace(formula, sides=plain.sides, relations=("=",))
    for way in (
        plain,
        *with_premises(standing, of_function, 0),
        *with_printed_components(standing, *plain.sides),
        *_raised(standing, of_function, 0),
    ):
        if not used_by(way.vocabulary, found.angle):
            yield replace(way, reads=reads, supposes=(*where, *way.supposes))


def _ranges_of(survey: Survey, angle: Formula) -> Iterator[Parsed]:
    """Yield the ranges in which a document says that an angle is."""
    for each in survey.statements:
        found = range_in(each, survey.formulas[id(each)])
        if found is not None and {*symbols_in(angle)} == {
            symbol for side in found.sides for symbol in symbols_in(side)
        } - {r"\pi"}:
            yield found


def _by_induction(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
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


def _said_before(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    """Yield a relation as one that stands above it in no case, or in its section: no letter of it was given since."""
    for each in standing.premises[-MOST_PREMISES:] if left != right else ():
        same = (each.left == left and each.right == right) or (each.left == right and each.right == left)
        elsewhere = each.part != standing.part
        if not same or (elsewhere and (each.special or standing.beside.is_conditional)):
            continue
        if all(standing.given_at.get(symbol, -1) <= each.place for symbol in each.symbols):
            said = each.said(f"{standing.vocabulary.text(left)} ", right)
            yield Way(letter_of(said.symbol), right, extended(standing.vocabulary, [said]))
            return


def _at_other_indices(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
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

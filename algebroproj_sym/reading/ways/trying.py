"""The ways in which a relation may be meant, and on what of the document it may rest in each."""

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

from algebroproj_sym.reading.asking.doubts import doubt_of
from algebroproj_sym.reading.asking.questions import Sides, Way
from algebroproj_sym.reading.defining.premises import MOST_PREMISES, extended, letter_of
from algebroproj_sym.reading.defining.twists import tells_hat
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.deriving.induction import ends_in
from algebroproj_sym.reading.deriving.series import with_exponentials
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, regrouped, with_divided_angles
from algebroproj_sym.reading.remembering.standing import Standing
from algebroproj_sym.reading.ways.assuming import assumptions
from algebroproj_sym.reading.ways.components import by_components, with_printed_components
from algebroproj_sym.reading.ways.constraining import under_equations
from algebroproj_sym.reading.ways.fields import of_fields
from algebroproj_sym.reading.ways.indexing import at_other_indices, by_induction, with_same_ends_in
from algebroproj_sym.reading.ways.inverting import of_inverse, raised
from algebroproj_sym.reading.ways.quaternions import of_quaternions
from algebroproj_sym.reading.ways.renaming import as_multiples, with_columns_as_letters, with_functions_as_letters
from algebroproj_sym.reading.ways.solutions import of_solutions
from algebroproj_sym.reading.ways.substituting import from_derivatives, from_worked_out, with_premises
from algebroproj_sym.reading.ways.supposing import as_its_sentence_supposes


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
        *raised(standing, formula, index),
        *of_inverse(standing, formula, index),
        *_said_before(standing, left, right),
        *(at_others := [*at_other_indices(standing, left, right)]),
        *with_same_ends_in(
            standing, [Way(left, right, standing.told), *(each for each in at_others if not each.under)]
        ),
        *with_functions_as_letters(standing, formula, index),
        *with_columns_as_letters(standing, formula, index),
        *of_quaternions(standing, formula, index),
        *with_printed_components(standing, left, right),
        *as_multiples(standing, left, right),
        *by_components(standing, left, right),
        *of_fields(standing, left, right),
        *of_solutions(standing, left, right),
        *by_induction(standing, left, right),
    ]
    ends = ends_in(left, right, *(each.tree for each in known.used_in(left, right)))
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

"""Relations that give a letter by a root or by an inverse function, as those of its power or of the function."""

import re
from collections.abc import Iterator
from dataclasses import replace

from algebroproj_sym.reading.asking.questions import Way, complex_letters_in
from algebroproj_sym.reading.asking.sampling import have_one_sign, is_somewhere_positive
from algebroproj_sym.reading.defining.domains import is_outside, range_in
from algebroproj_sym.reading.defining.premises import MOST_PREMISES, letter_of
from algebroproj_sym.reading.defining.recognising import defined_by
from algebroproj_sym.reading.deriving.angles import of_angle
from algebroproj_sym.reading.deriving.instances import powers_of
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, symbols_in, trees_in
from algebroproj_sym.reading.remembering.standing import Standing
from algebroproj_sym.reading.remembering.survey import Survey
from algebroproj_sym.reading.ways.components import with_printed_components
from algebroproj_sym.reading.ways.constraining import under_equations
from algebroproj_sym.reading.ways.substituting import with_premises

_SEVERAL = re.compile(r"(.+)_\{?(?:12|1,2|1/2|\\pm)\}?")
"""A letter for both roots of an equation."""


def raised(standing: Standing, formula: Parsed, index: int) -> Iterator[Way]:
    """Yield the powers of a letter and of a root that it is, as they rest on others.

    Both have one sign, which they may have, or its degree is odd.  A root that is no multiple of letters has the plus
    sign, if the letter may have it; elsewhere words speak of a root, or of what is never negative.  A root on the left
    speaks for itself, of real letters that equations above give.
    """
    left, right = formula.sides[index : index + 2]
    several = _SEVERAL.fullmatch(defined_by(left)[0])
    alone = several is not None and not any(defined_by(left)[0] in each.symbols for each in standing.premises)
    powers = powers_of(left, right)
    if powers and powers.is_open and several and alone:
        powers = powers_of(letter_of(several[1]), right)
    is_root = powers is not None and not powers.is_open and not powers.is_of_left
    known = standing.vocabulary
    if is_root and (not known.used_in(left, right) or complex_letters_in(known, left, right)):
        return
    outside = [each for side in (left, right) for each in _outside_of_roots(side)]
    if powers is None or any(map(known.is_matrix, outside if is_root else symbols_in(powers.left)[:1])):
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
    signed = not (powers.is_open or powers.degree % 2)
    for way in (
        *[plain][: bool(certain or positive)],
        *with_premises(standing, of_powers, 0),
        *under_equations(standing, *plain.sides),
    ):
        one_sign = have_one_sign(way.vocabulary, (left, right)) if signed else True
        if one_sign is False or (one_sign is None and is_root):
            continue
        if certain or not positive or is_somewhere_positive(way.vocabulary, left):
            yield replace(way, reads=reads, supposes=(same,) if signed else ())


def _outside_of_roots(tree: Formula) -> Iterator[str]:
    """Yield the symbols of a formula that stand in no root and in no length."""
    if tree.data in ("symbol", "opaque"):
        yield str(tree.children[0])
    for part in trees_in(tree) if tree.data not in ("root", "norm") else ():
        yield from _outside_of_roots(part)


def of_inverse(standing: Standing, formula: Parsed, index: int) -> Iterator[Way]:
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
        *raised(standing, of_function, 0),
    ):
        if not way.vocabulary.used_in(found.angle):
            yield replace(way, reads=reads, supposes=(*where, *way.supposes))


def _ranges_of(survey: Survey, angle: Formula) -> Iterator[Parsed]:
    """Yield the ranges in which a document says that an angle is."""
    for each in survey.statements:
        found = range_in(each, survey.formulas[id(each)])
        if found is not None and {*symbols_in(angle)} == {
            symbol for side in found.sides for symbol in symbols_in(side)
        } - {r"\pi"}:
            yield found

"""The ways in which a relation may be meant, and on what of the document it may rest in each."""

import re
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace

from lark import Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import ANY, letters_of_symbol
from algebroproj_sym.reading.defining.domains import is_outside, range_in
from algebroproj_sym.reading.defining.maps import DIMENSIONS
from algebroproj_sym.reading.defining.premises import MOST_PREMISES, MOST_TOGETHER, extended, letter_of
from algebroproj_sym.reading.defining.recognising import defined_by
from algebroproj_sym.reading.defining.tensors import depend_on_size
from algebroproj_sym.reading.defining.twists import tells_hat
from algebroproj_sym.reading.defining.vocabulary import Numbers
from algebroproj_sym.reading.deriving.angles import of_angle
from algebroproj_sym.reading.deriving.ends import with_same_ends
from algebroproj_sym.reading.deriving.gradients import along_directions
from algebroproj_sym.reading.deriving.indexed import instance_of, instances, sources_of
from algebroproj_sym.reading.deriving.indices import excludes
from algebroproj_sym.reading.deriving.induction import ends_in, steps_of
from algebroproj_sym.reading.deriving.instances import powers_of
from algebroproj_sym.reading.deriving.rooting import with_roots_apart
from algebroproj_sym.reading.deriving.series import with_exponentials
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.judging.components import by_components, with_printed_components
from algebroproj_sym.reading.judging.constraining import under_equations
from algebroproj_sym.reading.judging.doubts import A_VALUE, doubt_of
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
from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.factors import CAPITAL
from algebroproj_sym.reading.parsing.grammar import (
    Formula,
    Parsed,
    regrouped,
    symbols_in,
    with_divided_angles,
    without_brackets,
)
from algebroproj_sym.reading.parsing.writing import text_of

_SEVERAL = re.compile(r"(.+)_\{?(?:12|1,2|1/2|\\pm)\}?")
"""A letter for both roots of an equation."""


def ways_of(standing: Standing, statement: Statement, formula: Parsed, index: int) -> list[Way]:
    """Return the ways to take a link of a formula, the first one as it stands."""
    formula = replace(formula, sides=tuple(map(with_exponentials, formula.sides)))
    left, right = formula.sides[index], formula.sides[index + 1]
    if tells_hat(left, right):
        standing = replace(standing, vocabulary=standing.vocabulary.without_hats())
    known = standing.vocabulary
    ranged = sorted((known.letters_of(left) | known.letters_of(right)) & standing.survey.restricted)
    special = f"{known.name(ranged[0])} stands for the elements of a set" if ranged else ""
    if word := standing.survey.special:
        special = special or f"the word {word!r} may mean special values or products"
    doubt = special or doubt_of(standing.beside, formula, index, known)
    others = _others(standing, statement, formula, index)
    ways = [
        Way(left, right, known, doubt),
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
    ways += [each for way in ways for each in _with_usual_letters(way, standing.survey)]
    ways += [
        replace(
            way,
            vocabulary=other,
            reads=way.reads or other.equation(*way.sides),
            supposes=(*way.supposes, f"{_identity_of(way)} is the identity"),
        )
        for way in ways
        if (way.supposes or not way.reads) and (other := way.vocabulary.with_identity(*way.sides)) is not None
    ]
    ways += [each for way in ways if not way.reads for each in along_directions_in(way)]
    ways += [each for way in ways if not way.reads for each in _with_roots_apart(standing, way)]
    if standing.survey.has_tensors_of_three_rows:
        ways += [_with_three_rows(way) for way in ways if _depends_on_size(way)]
    ways += [each for way in ways if way.is_as_it_stands for each in _with_complex_numbers(way)]
    ends = ends_in(left, right, *(each.tree for each in used_by(known, left, right)))
    return ways + [each for way in ways if not way.under for each in _with_parities(way, ends)]


def _with_roots_apart(standing: Standing, way: Way) -> Iterator[Way]:
    """Yield a way in which roots of products are products of roots, of what may be positive; it is taken to be so."""
    known = way.vocabulary
    used = [each for each in used_by(known, *way.sides) if not each.parameters]
    (left, more), (right, others), *trees = map(with_roots_apart, (*way.sides, *(each.tree for each in used)))
    positive = dict.fromkeys([*more, *others, *(factor for _, factors in trees for factor in factors)])
    complex_ones = complex_letters_in(known, *way.sides)
    if not positive or complex_ones or "negative" in standing.beside.words:
        return
    if all(is_somewhere_positive(known, each) for each in positive):
        given = [replace(each, tree=tree) for each, (tree, _) in zip(used, trees, strict=True)]
        told = extended(known, given)
        supposes = (*way.supposes, *(f"{known.text(each)} > 0" for each in positive))
        yield replace(way, left=left, right=right, vocabulary=told, doubt=A_VALUE, supposes=supposes)


def _identity_of(way: Way) -> str:
    """Return the name of what is like an identity in a way: I, or a bold 1."""
    letters = frozenset().union(*map(way.vocabulary.letters_of, way.sides))
    like = {way.vocabulary.name(each) for each in letters if way.vocabulary.is_like_identity(each) and "1" in each}
    return min(like, default="I")


def _with_usual_letters(way: Way, survey: Survey) -> Iterator[Way]:
    """Yield a way in which letters are what they are called after, though nothing is said of them.

    R is a rotation where words speak of rigid motions, P is symmetric where they speak of covariances, and matrices in
    expected values are not random.
    """
    known, used = way.vocabulary, used_by(way.vocabulary, *way.sides)
    trees = [
        *way.sides,
        *(each.tree for each in used),
        *(side for each in way.under for side in (each.left, each.right)),
    ]
    symbols = {symbol for tree in trees for symbol in symbols_in(tree)}
    averages = known.kinds.averages
    plain = sorted(each for each in symbols if known.is_matrix(each) and CAPITAL.match(each))
    plain = [each for each in plain if not known.properties_of(each)]
    sure = [each for each in plain if each not in averages.random | averages.within and each not in known.definitions]
    properties: dict[str, tuple[str, ...]] = {}
    if survey.speaks_of_rotations:
        properties |= {each: ("rotation",) for each in plain if _ROTATION.fullmatch(each)}
    elif survey.speaks_of_covariances:
        named = survey.named_otherwise
        called = [each for each in plain if _is_covariance(each) and split_symbol(each)[0] not in named]
        properties |= dict.fromkeys(called, ("symmetric",))
    supposes = [f"{known.name(each)} is {_AS_SAID[said]}" for each, (said,) in properties.items()]
    if averages.operators & symbols and sure and (averages.random or survey.speaks_of_covariances):
        supposes += [f"{known.name(each)} is not random" for each in sure]
        known = known.with_fixed(frozenset(sure))
    if supposes:
        shown = way.reads or known.equation(*way.sides)
        known = known.with_properties(properties)
        yield replace(way, vocabulary=known, doubt=A_VALUE, reads=shown, supposes=(*way.supposes, *supposes))


_ROTATION = re.compile(r"(?:R|\\mathbf\{R\})(?:_.*)?")
_COVARIANCE = re.compile(r"(?:[PQRS]|\\Sigma|\\Lambda|\\mathbf\{(?:[PQRS]|\\Sigma)\})(_.*?)?(?:\^-)?")


def _is_covariance(symbol: str) -> bool:
    r"""Whether a letter is called as the covariance of one thing, as ``P_{k-1}`` and ``\Sigma_{xx}`` are."""
    match = _COVARIANCE.fullmatch(symbol)
    below = re.sub(r"[-+]\d", "", match[1] or "") if match else "xy"
    return len({*re.findall(r"[a-zA-Z]|\d", below)}) < 2


_AS_SAID = {"rotation": "a rotation", "symmetric": "symmetric"}


def _depends_on_size(way: Way) -> bool:
    """Whether what a way asks may depend on how many rows its letters have, as the trace of the identity does."""
    used = used_by(way.vocabulary, *way.sides)
    trees = [*way.sides, *(each.tree for each in used)]
    letters = frozenset().union(*map(way.vocabulary.letters_of, trees))
    has_identity = any("identity" in way.vocabulary.properties_of(each) for each in letters)
    return depend_on_size(trees, has_identity=has_identity) and not any(each.parameters for each in used)


def _with_three_rows(way: Way) -> Way:
    """Return a way in which vectors and matrices have three rows, if nothing else says how many."""
    shown = way.reads or way.vocabulary.equation(*way.sides)
    known = way.vocabulary.with_rows(DIMENSIONS)
    supposes = (*way.supposes, "space has three dimensions")
    return replace(way, vocabulary=known, doubt=A_VALUE, reads=shown, supposes=supposes)


def along_directions_in(way: Way) -> Iterator[Way]:
    """Yield the ways in which a derivative by a vector, also of an equation above, is that along every direction."""
    shown = f"{way.vocabulary.equation(*way.sides)}, along every direction"
    with_identity = way.vocabulary.with_identity(*way.sides)
    readings = ((way.vocabulary, shown), (with_identity, f"{shown}, where I is the identity"))
    given = [side for each in way.under for side in (each.left, each.right)]
    for known, reads in readings:
        if known is not None and (found := along_directions(known, *way.sides, *given)) is not None:
            (left, right, *others), meanings = found
            under = [
                replace(each, left=a, right=b) for each, a, b in zip(way.under, others[::2], others[1::2], strict=True)
            ]
            if not any(True for side in (left, right) for _ in side.find_data("direction")):
                reads = reads.replace("along every direction", "where what a letter gives changes with it")
            yield from (Way(left, right, each, A_VALUE, reads, tuple(under)) for each in meanings)


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
            yield Way(left, right, extended(way.vocabulary, given), A_VALUE, way.reads)


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
            yield replace(
                way, reads=reads, doubt=A_VALUE, supposes=() if powers.is_open or powers.degree % 2 else (same,)
            )


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
            yield replace(way, reads=reads, doubt=A_VALUE, supposes=(*where, *way.supposes))


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
            yield Way(found.left, found.right, known, A_VALUE, shown, supposes=supposes, last=found.last)


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
    shown = known.equation(left, right)
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


def gives_at_other_index(standing: Standing, left: Formula, right: Formula) -> bool:
    """Whether an equation above says what a letter is at another index, by letters that the right side has."""
    if excludes(standing.beside.words):
        return False
    given, _ = sources_of(
        standing.premises, standing.vocabulary, standing.survey.indices, standing.part, standing.cited
    )
    found = instances(given, standing.vocabulary, standing.survey.indices, (left,))
    return any({*each.symbols} & {*symbols_in(right)} for each, _ in found)


def _with_parities(way: Way, ends: frozenset[str]) -> Iterator[Way]:
    """Yield a way in which whole numbers are even or odd, where -1 has an exponent or pi a factor.

    So are the letters at which its sums end.
    """
    known = way.vocabulary
    wholes = (known.wholes | ends) - {*known.definitions}
    letters = (known.letters_of(way.left) | known.letters_of(way.right)) & wholes
    trees = [*way.sides, *(each.tree for each in used_by(known, *way.sides))]
    if letters and any(
        r"\pi" in symbols_in(each) or any(map(_is_of_minus_one, each.find_data("power"))) for each in trees
    ):
        shown = way.reads or known.equation(*way.sides)
        supposes = (*way.supposes, *(f"{known.name(each)} is a whole number" for each in sorted(letters)))
        yield replace(way, vocabulary=known.with_parities(letters), doubt=A_VALUE, reads=shown, supposes=supposes)


def _is_of_minus_one(power: Formula) -> bool:
    return text_of(without_brackets(power.children[0]), str) == "-1"


def _with_complex_numbers(way: Way) -> Iterator[Way]:
    """Yield a way in which letters stand for complex numbers: all of them, or only those that complex ones give.

    Where others give what words call complex, and no imaginary unit is known, some of these must be complex.
    """
    if not complex_letters_in(way.vocabulary, *way.sides):
        return
    shown, unit = way.vocabulary.equation(*way.sides), way.vocabulary.imaginary
    unit = f"{unit} is the imaginary unit" if unit else "letters are complex numbers"
    kinds: tuple[tuple[Numbers, tuple[str, ...]], ...] = (
        ("complex", ()),
        ("some complex", ("letters are real unless complex ones give them",)),
    )
    given = {each.symbol for each in used_by(way.vocabulary, *way.sides)} & way.vocabulary.complexes
    for numbers, letters in kinds[: 1 if given and not way.vocabulary.imaginary else None]:
        known = way.vocabulary.with_complex_numbers(numbers)
        yield replace(way, vocabulary=known, reads=shown, supposes=(*way.supposes, unit, *letters))

r"""What may be assumed of letters, though nothing says it: each assumption becomes a hypothesis."""

import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial

from algebroproj_sym.reading.asking.questions import A_VALUE, Way, complex_letters_in
from algebroproj_sym.reading.asking.sampling import is_somewhere_positive
from algebroproj_sym.reading.defining.maps import DIMENSIONS
from algebroproj_sym.reading.defining.premises import extended
from algebroproj_sym.reading.defining.tensors import depend_on_size
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.deriving.gradients import along_directions
from algebroproj_sym.reading.deriving.rooting import with_roots_apart
from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.parsing.factors import CAPITAL
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in, without_brackets
from algebroproj_sym.reading.parsing.writing import text_of
from algebroproj_sym.reading.remembering.standing import Standing
from algebroproj_sym.reading.remembering.survey import Survey

Assumed = Callable[[Way], Iterator[Way]]

_ROTATION = re.compile(r"(?:R|\\mathbf\{R\})(?:_.*)?")
_COVARIANCE = re.compile(r"(?:[PQRS]|\\Sigma|\\Lambda|\\mathbf\{(?:[PQRS]|\\Sigma)\})(_.*?)?(?:\^-)?")


def assumptions(standing: Standing, ends: frozenset[str]) -> list[Assumed]:
    """Return what yields a way with an assumption, one after the other; sums end at some letters."""
    survey = standing.survey
    return [
        partial(_with_usual_letters, survey),
        _with_identity,
        along_directions_in,
        partial(_with_roots_apart, standing),
        *([_with_three_rows] if survey.has_tensors_of_three_rows else []),
        _with_complex_numbers,
        partial(_with_parities, ends),
    ]


def _taken(way: Way, vocabulary: Vocabulary, *assumed: str) -> Way:
    """Return a way with other letters, and what is assumed of them."""
    reads = way.reads or vocabulary.equation(*way.sides)
    return replace(way, vocabulary=vocabulary, reads=reads, supposes=(*way.supposes, *assumed))


def _with_usual_letters(survey: Survey, way: Way) -> Iterator[Way]:
    """Yield a way in which letters are what they are called after.

    R is a rotation where words speak of rigid motions, P is symmetric where they speak of covariances, and matrices in
    expected values are not random.
    """
    known, used = way.vocabulary, way.vocabulary.used_in(*way.sides)
    trees = (*way.sides, *(each.tree for each in used), *way.given)
    symbols = {symbol for tree in trees for symbol in symbols_in(tree)}
    averages = known.kinds.averages
    plain = sorted(each for each in symbols if known.is_matrix(each) and CAPITAL.match(each))
    plain = [each for each in plain if not known.properties_of(each)]
    sure = [each for each in plain if each not in averages.random | averages.within and each not in known.definitions]
    called, property_ = list[str](), "rotation"
    if survey.speaks_of_rotations:
        called = [each for each in plain if _ROTATION.fullmatch(each)]
    elif survey.speaks_of_covariances:
        called, property_ = [each for each in plain if _is_covariance(each)], "symmetric"
        called = [each for each in called if split_symbol(each)[0] not in survey.named_otherwise]
    assumed = [f"{known.name(each)} is {'a ' * (property_ == 'rotation')}{property_}" for each in called]
    if averages.operators & symbols and sure and (averages.random or survey.speaks_of_covariances):
        assumed += [f"{known.name(each)} is not random" for each in sure]
        averages = replace(averages, fixed=averages.fixed.union(sure))
    if assumed:
        properties = known.properties | dict.fromkeys(called, (property_,))
        known = known.changed(properties=properties, kinds=replace(known.kinds, averages=averages))
        yield _taken(way, known, *assumed)


def _is_covariance(symbol: str) -> bool:
    r"""Whether a letter is called as the covariance of one thing, as ``P_{k-1}`` and ``\Sigma_{xx}`` are."""
    match = _COVARIANCE.fullmatch(symbol)
    below = re.sub(r"[-+]\d", "", match[1] or "") if match else "xy"
    return len({*re.findall(r"[a-zA-Z]|\d", below)}) < 2


def _with_identity(way: Way) -> Iterator[Way]:
    """Yield a way in which a letter such as I, or a bold 1, is the identity."""
    known = way.vocabulary.with_identity(*way.sides) if way.supposes or not way.reads else None
    if known is not None:
        letters = way.vocabulary.letters_of(*way.sides)
        like = {way.vocabulary.name(each) for each in letters if way.vocabulary.is_like_identity(each) and "1" in each}
        yield _taken(way, known, f"{min(like, default='I')} is the identity")


def along_directions_in(way: Way) -> Iterator[Way]:
    """Yield the ways in which a derivative by a vector, also of an equation above, is that along every direction."""
    shown = f"{way.vocabulary.equation(*way.sides)}, along every direction"
    with_identity = way.vocabulary.with_identity(*way.sides)
    readings = ((way.vocabulary, shown), (with_identity, f"{shown}, where I is the identity"))
    for known, reads in readings if not way.reads else ():
        if known is not None and (found := along_directions(known, *way.sides, *way.given)) is not None:
            (left, right, *others), meanings = found
            pairs = zip(way.under, others[::2], others[1::2], strict=True)
            under = tuple(replace(each, left=one, right=other) for each, one, other in pairs)
            if not any(True for side in (left, right) for _ in side.find_data("direction")):
                reads = reads.replace("along every direction", "where what a letter gives changes with it")
            yield from (Way(left, right, each, reads, under) for each in meanings)


def _with_roots_apart(standing: Standing, way: Way) -> Iterator[Way]:
    """Yield a way in which roots of products are products of roots, of what may be positive."""
    known = way.vocabulary
    used = [each for each in known.used_in(*way.sides) if not each.parameters]
    (left, more), (right, others), *trees = map(with_roots_apart, (*way.sides, *(each.tree for each in used)))
    positive = dict.fromkeys([*more, *others, *(factor for _, factors in trees for factor in factors)])
    excluded = way.reads or "negative" in standing.beside.words or complex_letters_in(known, *way.sides)
    if positive and not excluded and all(is_somewhere_positive(known, each) for each in positive):
        told = extended(known, [replace(each, tree=tree) for each, (tree, _) in zip(used, trees, strict=True)])
        supposes = (*way.supposes, *(f"{known.text(each)} > 0" for each in positive))
        yield replace(way, left=left, right=right, vocabulary=told, doubt=A_VALUE, supposes=supposes)


def _with_three_rows(way: Way) -> Iterator[Way]:
    """Yield a way in which vectors and matrices have three rows, if that may matter and nothing says how many."""
    known, used = way.vocabulary, way.vocabulary.used_in(*way.sides)
    trees = [*way.sides, *(each.tree for each in used)]
    letters = known.letters_of(*trees)
    has_identity = any("identity" in known.properties_of(each) for each in letters)
    if depend_on_size(trees, has_identity=has_identity) and not any(each.parameters for each in used):
        yield _taken(way, known.changed(rows=DIMENSIONS), "space has three dimensions")


def _with_complex_numbers(way: Way) -> Iterator[Way]:
    """Yield a way in which letters stand for complex numbers: all of them, or only those that complex ones give.

    Where others give what words call complex, and no imaginary unit is known, some of these must be complex.
    """
    known = way.vocabulary
    if not way.is_as_it_stands or not complex_letters_in(known, *way.sides):
        return
    unit = f"{known.imaginary} is the imaginary unit" if known.imaginary else "letters are complex numbers"
    yield _taken(way, known.changed(numbers="complex"), unit)
    if known.imaginary or not {each.symbol for each in known.used_in(*way.sides)} & known.complexes:
        some = known.changed(numbers="some complex")
        yield _taken(way, some, unit, "letters are real unless complex ones give them")


def _with_parities(ends: frozenset[str], way: Way) -> Iterator[Way]:
    """Yield a way in which whole numbers are even or odd, where -1 has an exponent or pi a factor.

    So are the letters at which sums end.
    """
    known = way.vocabulary
    wholes = (known.wholes | ends) - {*known.definitions}
    letters = known.letters_of(*way.sides) & wholes
    trees = known.with_used(*way.sides)
    alternate = any(r"\pi" in symbols_in(each) or any(map(_is_of_minus_one, each.find_data("power"))) for each in trees)
    if letters and alternate and not way.under:
        assumed = (f"{known.name(each)} is a whole number" for each in sorted(letters))
        yield _taken(way, known.changed(parities=letters), *assumed)


def _is_of_minus_one(power: Formula) -> bool:
    return text_of(without_brackets(power.children[0]), str) == "-1"

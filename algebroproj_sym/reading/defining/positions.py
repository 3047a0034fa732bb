"""What letters are by where they stand: numbers below a line, vectors beside a cross, matrices with an inverse."""

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import pairwise, permutations
from typing import Any

from lark import Token

from algebroproj_sym.reading.defining.composing import THIN_CAPITAL
from algebroproj_sym.reading.defining.notation import derivative_in
from algebroproj_sym.reading.lexing.commands import OF_ANGLES
from algebroproj_sym.reading.parsing.factors import (
    CAPITAL,
    base_of,
    factors_of,
    head_of,
    is_inverse,
    terms_of,
)
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, Sides, lone, symbols_in, trees_in, without_brackets

SMALL = re.compile(r"(?:\\(?:bar|hat|tilde|dot|ddot)\{)*[a-z]\}*(?:_.*)?'*|\\Delta [a-z](?:_.*)?")
BOLD = re.compile(r"\\(?:mathbf|mathsf|vec|overrightarrow)(?![a-z]{2})")
ACCENT = re.compile(r"\\(bar|underline|overline|tilde|hat|widehat|widetilde)(?![a-z]{2})")
_SCRIPT = re.compile(r"_(?:\{[^{}]*\}|.)")
_ONES = re.compile(r"\\(?:mathbf|mathbb|mathds|vec)\{1\}(?:_.*)?")
_OF_MATRICES = ("det", "tr", "Tr", "trace", "adj", "exp", "diag")
_OF_VECTORS = ("marked", "norm", "absolute", "inner", "call")


def is_cross(tree: Formula) -> bool:
    """Whether a formula is a product with a cross."""
    signs = [each for each in tree.children if isinstance(each, Token)]
    return tree.data == "product" and any(sign.type == "CROSS" for sign in signs)


def sums_in(sides: Sides) -> Iterator[list[Any]]:
    """Yield the terms that are added or equal: those of the sides, and those of sums within them."""
    yield [term for side in sides for term in terms_of(side)]
    for side in sides:
        yield from map(terms_of, side.find_data("sum"))


def angles_in(formulas: Iterable[Parsed]) -> frozenset[str]:
    r"""Return the letters that are angles, as in ``\cos(2 a + b)``: no capitals, and none as in ``\cos(n^T m)``."""
    parts = (part for formula in formulas for side in formula.sides for part in _angles_of(side))
    found = (part for part in parts if not any(each.data in _OF_VECTORS for each in part.iter_subtrees()))
    return frozenset(letter for part in found for letter in symbols_in(part) if not letter[0].isupper())


def _angles_of(side: Formula) -> Iterator[Formula]:
    for tree in side.iter_subtrees():
        if tree.data in ("function", "raised_function") and str(tree.children[0]) in OF_ANGLES:
            yield from trees_in(tree)[-1:]


def ones_in(side: Formula) -> Iterator[str]:
    r"""Yield what is a column of ones: a bold 1 that is transposed or stands behind a matrix, unlike the identity."""
    turned = (each.children[0] for each in side.find_data("marked") if each.children[1] == "T")
    mapped = (run.children[-1] for run in side.find_data("run") if CAPITAL.match(lone(run.children[-2])))
    yield from (letter for letter in map(lone, (*turned, *mapped)) if _ONES.fullmatch(letter))


def derived_in(equations: Sequence[Sides]) -> Iterator[str]:
    r"""Yield the letters of a derivative that is a multiple of an identity with a size: both are vectors."""
    for sides in equations:
        factors = [lone(each) for side in sides for term in terms_of(side) for each in (term, *trees_in(term))]
        if any(map(_SIZED_IDENTITY.fullmatch, factors)):
            slopes = (derivative_in(head) for side in sides if "/" in (head := head_of(side)))
            yield from (letter for slope in slopes if slope for letter in (slope.function, *slope.letters))


_SIZED_IDENTITY = re.compile(r"(?:I|\\math(?:bf|bb|rm)\{I\})_(?:[2-9]|\{([2-9])(?:\\times\1)?\})")


def stretched_in(equations: Iterable[Sides]) -> Iterator[str]:
    r"""Yield the letters of eigenvectors, as x in ``A x = \lambda x``: of numbers, nobody prints x twice."""
    for one, other in (pair for sides in equations for pair in permutations(sides, 2)):
        if one.data == other.data == "run" and len(one.children) == 2:
            capital, letter = map(lone, trees_in(one))
            if (
                THIN_CAPITAL.fullmatch(capital)
                and letter
                and not CAPITAL.match(letter)
                and lone(trees_in(other)[-1]) == letter
            ):
                yield from () if lone(trees_in(other)[0]) == capital else (letter,)


def acting_in(sides: Iterable[Formula]) -> Iterator[str]:
    r"""Yield the kets, and the capitals before them: operators, as A and B in ``A B |\psi\rangle``."""
    for *before, last in (trees_in(run) for side in sides for run in side.find_data("run")):
        if lone(last).startswith(r"\ket{"):
            yield from filter(CAPITAL.match, map(base_of, before))
            yield lone(last)


def measured_in(sides: Iterable[Formula]) -> Iterator[str]:
    r"""Yield the small letters of a vector of which there is a length, as x and b in ``\|A x - b\|``."""
    for norm in (norm for side in sides for norm in side.find_data("norm")):
        terms = [trees_in(each) if each.data == "run" else [each] for each in terms_of(trees_in(norm)[0])]
        if any(THIN_CAPITAL.fullmatch(lone(factors[0])) and len(factors) > 1 for factors in terms):
            yield from (letter for letter in (lone(factors[-1]) for factors in terms) if SMALL.fullmatch(letter))


def crossed_in(equations: Iterable[Sides], known: Collection[str]) -> Iterator[str]:
    r"""Yield the small letters beside a cross, as w and r in ``w \times (w \times r)``: vectors.

    The cross stands within another one, or beside a letter that is known to be one.
    """
    crosses = [each for sides in equations for side in sides for each in side.iter_subtrees() if is_cross(each)]
    nested = any(
        map(is_cross, (each for cross in crosses for part in trees_in(cross) for each in part.iter_subtrees()))
    )
    for parts in map(trees_in, crosses):
        ends = (trees_in(each)[-1] if each.data == "run" else each for part in parts for each in terms_of(part))
        letters = {*map(lone, ends)} - {""}
        letters = {each for each in letters if not CAPITAL.match(each)}
        yield from letters if nested or letters & {*known} else ()


def of_forms_in(sides: Iterable[Formula]) -> Iterator[str]:
    """Yield the small letters at both ends of a product of capitals, as l and v in ``l^T P v``: columns."""
    for first, *inner, last in (trees_in(run) for side in sides for run in side.find_data("run")):
        row = lone(first.children[0]) if first.data == "marked" and first.children[1] == "T" else ""
        ends = row, lone(last)
        if inner and all(map(SMALL.fullmatch, ends)) and all(THIN_CAPITAL.fullmatch(base_of(each)) for each in inner):
            yield from ends


def summed_with(columns: frozenset[str], known: Collection[str], equations: Sequence[Sides]) -> Iterator[str]:
    r"""Yield the letters that are added to a multiple of a column, as z and x in ``z - a \mathbf{1} - b x``."""
    for terms in (terms for sides in equations for terms in sums_in(sides)):
        ends = [trees_in(each) if each.data == "run" else [each] for each in terms]
        heads = {lone(factors[-1]) for factors in ends if not any(each.data == "marked" for each in factors)}
        if heads & columns:
            yield from (heads & {*known}) - columns


def marked_in(sides: Sequence[Formula], occurring: Sequence[str], vectors: frozenset[str]) -> set[str]:
    r"""Return the symbols that have a mark of matrices somewhere, or of which there is a determinant or a trace.

    An angle is none by the mark of a bracket, nor by a hat: ``[\phi]^\wedge`` is a matrix of a number in the plane.
    """
    found, unless = set[str](), set[str]()
    angles = set[str]()
    turned = (each.children[0] for side in sides for each in side.find_data("marked") if each.children[1] == "T")
    vectors |= frozenset(map(lone, turned)) - {""}
    for side in sides:
        angles |= {letter for part in _angles_of(side) for letter in symbols_in(part)}
        for tree in side.iter_subtrees():
            head = str(tree.children[-1 if tree.data == "marked" else 0]) if tree.children else ""
            if tree.data == "marked" and not head.startswith("_"):
                marked = tree.children[0]
                (found if lone(marked) and head == "T" else unless).update(_without_scales(marked, vectors))
            elif tree.data == "function" and head in ("det", "tr", "Tr", "trace", "adj"):
                found |= {*_without_scales(trees_in(tree)[0], vectors)}
    found |= unless - angles
    inverse = {each for each in occurring if r"\dagger" in each or r"\sharp" in each}
    return found | inverse | {re.sub(r"\^\{?\\(?:dagger|sharp)\}?", "", each) for each in inverse}


def _without_scales(tree: Any, vectors: frozenset[str]) -> Iterator[str]:
    r"""Yield the letters of a matrix: in `A - \lambda I`, and in `k A B`, no small letter before a capital.

    Beside a vector no other small letter is one, as b in ``(y - b x)^T x``, where x stands alone with the mark.
    """
    for term in terms_of(tree):
        letters = [*factors_of(term, deep=False)]
        capitals = [place for place, each in enumerate(letters) if CAPITAL.match(each)]
        if term.data == "run" and not capitals and not vectors.isdisjoint(letters):
            letters = [each for each in letters if each in vectors]
        yield from letters[capitals[0] if capitals and term.data == "run" else 0 :]


def tables_in(equations: Iterable[Sides]) -> Iterator[str]:
    """Yield the letters that are equal to a printed matrix."""
    for sides in equations:
        if any(map(is_table, sides)):
            yield from {head_of(side) for side in sides} - {""}


def is_table(side: Any) -> bool:
    """Whether a side is a printed matrix with more than one entry."""
    while side.data in ("marked", "group"):
        side = side.children[0]
    if side.data != "matrix" or "vmatrix" in side.children[0]:
        return False
    rows = trees_in(side)
    return len(rows) > 1 or len(rows[0].children) > 1


def numbers_in(side: Formula) -> Iterator[str]:
    """Yield the symbols that are numbers by where they stand: below a line, in a function, a root or an exponent."""
    for tree in side.iter_subtrees():
        if tree.data in ("fraction", "quotient", "power"):
            inside = trees_in(tree)[1:]
        elif tree.data in ("root", "nth_root", "factorial"):
            inside = trees_in(tree)
        else:
            named = tree.data == "function" and tree.children[0] not in _OF_MATRICES
            inside = trees_in(tree) if named else []
        for each in inside:
            yield from factors_of(each)


def divisors_in(side: Formula) -> Iterator[list[str]]:
    r"""Yield the letters that stand below each line as they are, as E and I in ``\frac{M}{2 E I}``.

    Those in a power, a function, or a product with a sign, such as ``b \cdot b``, are left out.
    """
    for tree in side.iter_subtrees():
        if tree.data in ("fraction", "quotient"):
            below = without_brackets(trees_in(tree)[1])
            yield [*filter(None, map(lone, trees_in(below) if below.data == "run" else [below]))]


def multiplied_in(side: Formula) -> Iterator[str]:
    r"""Yield the letters at a sign between two factors with letters: both may be vectors, as in ``a \cdot (b - c)``."""
    for product in side.find_data("product"):
        factors = trees_in(product)
        if len([each for each in factors if symbols_in(each)]) > 1:
            yield from (symbol for each in factors for symbol in symbols_in(each))


def inverted_in(side: Formula) -> Iterator[str]:
    """Yield the capitals that have an inverse or a determinant."""
    powers = (base_of(each) for each in side.find_data("power") if is_inverse(each))
    called = (lone(trees_in(each)[0]) for each in side.find_data("function") if each.children[0] == "det")
    yield from filter(CAPITAL.match, (*powers, *called))


def squared_in(side: Formula) -> Iterator[str]:
    """Yield the small letters of which there is a square: there is none of a column."""
    yield from filter(SMALL.fullmatch, (base_of(power) for power in side.find_data("power")))


def above_lines(side: Formula) -> Iterator[str]:
    r"""Yield the symbols above a line with letters below it, and before such a fraction, as in ``G \frac{M}{r^2}``."""
    for tree in side.iter_subtrees():
        if _is_quotient(tree):
            yield from factors_of(tree.children[0])
        elif tree.data == "run":
            for one, other in pairwise(trees_in(tree)):
                if _is_quotient(other):
                    yield from factors_of(one)


def _is_quotient(tree: Formula) -> bool:
    return tree.data in ("fraction", "quotient") and all(map(symbols_in, trees_in(tree)))


def accents_in(equations: Iterable[Sides], *, spoken: bool) -> frozenset[str]:
    r"""Return the accents that letters on both sides of a cross have, and that no number has.

    Where no words speak of vectors, a cross must stand within another one.  A line below a letter says enough.
    """
    found, others = set[str](), set[str]()
    for sides in equations:
        for side in sides:
            for product in filter(is_cross, side.iter_subtrees()):
                accents = frozenset.intersection(*map(_accents_of, trees_in(product)))
                nested = any(map(is_cross, (each for part in trees_in(product) for each in part.iter_subtrees())))
                found |= accents if spoken or nested else accents & {"underline"}
            for symbol in numbers_in(side):
                others |= accents_of_vectors(symbol)
            alone = [other for other in sides if other is not side]
            if alone and not any(_accents_of(each) or _may_be_vector(each) for each in alone):
                others |= accents_of_vectors(head_of(side))
    return frozenset(found - others)


def _accents_of(tree: Formula) -> frozenset[str]:
    return frozenset().union(*map(accents_of_vectors, symbols_in(tree)))


def accents_of_vectors(symbol: str) -> frozenset[str]:
    r"""Return the accents of a letter, or of the one of which it is the derivative by a number."""
    slope = derivative_in(symbol) if "/" in symbol else None
    above, below = (slope.function, slope.variable) if slope else (symbol, "")
    return frozenset(ACCENT.findall(_SCRIPT.sub("", above)) if not ACCENT.search(below) else ())


def _may_be_vector(tree: Formula) -> bool:
    """Whether a side may be a vector though it has no letter with an accent."""
    zero = tree.data == "number" and str(tree.children[0]) == "0"
    bold = any(BOLD.search(each) for each in symbols_in(tree))
    return zero or bold or any(each.data in ("matrix", "bracket", "call") for each in tree.iter_subtrees())

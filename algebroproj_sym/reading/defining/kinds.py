r"""Which letters are vectors or matrices, by all equations of a document: their order matters.

One is, if it has a mark of matrices, if words say so, or if it is added to one or equal to one.  In ``y = z - c`` all
of c, y, z are vectors if one is.  A thin capital beside a vector may be a matrix, as X in
``\mathbf{y} = X \mathbf{b}``.

An accent is that of vectors if letters that have it are multiplied with a cross, as in ``\bar\omega \times \bar r``.
"""

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace

from algebroproj_sym.reading.defining.averages import Averages, averages_in
from algebroproj_sym.reading.defining.closure import Closure
from algebroproj_sym.reading.defining.composing import composed_in
from algebroproj_sym.reading.defining.oblong import oblong_in
from algebroproj_sym.reading.defining.positions import (
    BOLD,
    above_lines,
    accents_in,
    accents_of_vectors,
    acting_in,
    crossed_in,
    derived_in,
    inverted_in,
    marked_in,
    measured_in,
    numbers_in,
    of_forms_in,
    ones_in,
    squared_in,
    stretched_in,
    summed_with,
    tables_in,
)
from algebroproj_sym.reading.defining.tensors import (
    contract_otherwise,
    fourth_in,
    scales_in,
    second_in,
    speaks_of_dyads,
    speaks_of_tensors,
)
from algebroproj_sym.reading.defining.twists import turning_in
from algebroproj_sym.reading.lexing.names import before_condition, split_symbol
from algebroproj_sym.reading.parsing.grammar import Parsed, Sides, symbols_in
from algebroproj_sym.reading.prose.inner import vectors_in

_OF_FRAMES = re.compile(r"[A-Z]_\{?\w+\^\}?\^")
"""A capital of two frames, as ``{}^A R^B``: it takes one into the other."""
_SAME = {"=", ":=", "=:", "≡", "≈"}
"""The relations whose sides are both numbers, or both none."""
_SPOKEN = re.compile(r"\b(?:vectors?|vectorial|cross[- ]products?)\b", re.IGNORECASE)


@dataclass(frozen=True)
class Kinds:
    """What the letters of a document are."""

    no_numbers: frozenset[str] = frozenset()
    """The symbols that are vectors or matrices."""
    columns: frozenset[str] = frozenset()
    """Those of them that have the accent of vectors, or that words call vectors."""
    open: frozenset[str] = frozenset()
    """The symbols that may be matrices, or numbers."""
    named: frozenset[str] = frozenset()
    """The letters I that words may call another thing than the identity."""
    oblong: frozenset[str] = frozenset()
    """Those of matrices that may have no inverse: a document inverts their product with what they are transposed."""
    inverted: frozenset[str] = frozenset()
    """The capitals that are no numbers, and have an inverse or a determinant somewhere: they are no vectors."""
    averages: Averages = field(default_factory=Averages)
    """What stands for expected values."""
    second: frozenset[str] = frozenset()
    """The letters that are tensors of the second order whatever their scripts are: they are no columns."""
    fourth: frozenset[str] = frozenset()
    """The symbols that are tensors of the fourth order."""
    scales: frozenset[str] = frozenset()
    """The thin letters that are numbers, because they stand before tensors and never behind one."""
    contracts: bool = False
    r"""Whether ``A : B`` is the sum of the products of their entries: no equation says otherwise."""
    turning: int | None = None
    """Which of two vectors in a column has a hat itself in the hat of both."""
    dyads: bool = False
    r"""Whether ``a \otimes b`` is ``a b^T``: words speak of tensors, and of no other product with this sign."""


def kinds_of(
    formulas: Iterable[Parsed], said: frozenset[str], words: str, columns: frozenset[str] = frozenset()
) -> Kinds:
    """Return what letters are by all equations of a document, and by what its words say of some.

    Words call some symbols vectors or matrices, and some of these columns.
    """
    every = [*formulas]
    equations = [sides for formula in every for sides in _equal_in(formula)]
    sides = [side for each in equations for side in each]
    occurring = sorted({symbol for side in sides for symbol in symbols_in(side)})
    accents = accents_in(equations, spoken=_SPOKEN.search(words) is not None)
    columns |= frozenset(each for each in occurring if accents & accents_of_vectors(each))
    columns |= frozenset(letter for side in sides for letter in ones_in(side))
    columns |= {*derived_in(equations)} & {*occurring}
    known = {*said, *columns, *marked_in(sides, occurring, said | columns), *tables_in(equations)}
    numbers = {symbol for side in sides for symbol in (*numbers_in(side), *above_lines(side), *squared_in(side))}
    crossed = crossed_in(equations, known)
    columns |= frozenset((*stretched_in(equations), *measured_in(sides), *of_forms_in(sides), *crossed)) - numbers
    known |= vectors_in(sides, words).union(acting_in(sides)) - numbers | columns
    known |= {*filter(_OF_FRAMES.match, occurring), *composed_in(equations, occurring, words, numbers)}
    known |= {each for each in occurring if BOLD.search(before_condition(each))}
    second = second_in(equations) if speaks_of_tensors(words) else frozenset[str]()
    scales = scales_in(equations, second) - known
    closure = Closure(known, equations, occurring, scales)
    while closure.grows():
        pass
    columns |= frozenset(summed_with(columns, closure.known, equations))
    square = {each for each in occurring if " " not in each and split_symbol(each)[0] in second}
    oblong = oblong_in(equations, occurring, words) - square
    inverted = frozenset(letter for side in sides for letter in inverted_in(side)) & closure.known
    averages = averages_in(equations, words)
    found = frozenset(closure.known), columns, frozenset(closure.open)
    fourth = fourth_in(equations, second)
    kinds = Kinds(*found, oblong=oblong, inverted=inverted, averages=averages, second=second, fourth=fourth)
    kinds = replace(kinds, scales=scales, contracts=not contract_otherwise(equations), dyads=speaks_of_dyads(words))
    return replace(kinds, turning=turning_in(formula.sides for formula in every))


def _equal_in(formula: Parsed) -> Iterator[Sides]:
    r"""Yield the sides that are equal to each other: ``a`` and ``b``, and ``V``, of ``a = b \in V``."""
    start = 0
    for place, relation in enumerate(formula.relations, 1):
        if relation not in _SAME:
            yield formula.sides[start:place]
            start = place
    yield formula.sides[start:]

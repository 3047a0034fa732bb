"""Relations of vector fields by components, also under equations near them and their derivatives."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial
from typing import Any

from algebroproj_sym.expressions import shape
from algebroproj_sym.reading.asking.questions import Sides, Way, rests_of
from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.premises import MOST_NEAR, Premise, sides_of
from algebroproj_sym.reading.defining.vocabulary import UNCOMPUTED, Vocabulary
from algebroproj_sym.reading.deriving.fields import (
    ALONG,
    COORDINATES,
    SPACE,
    Fields,
    components_of,
    operated,
    vectors_in,
    with_operators_apart,
)
from algebroproj_sym.reading.lexing.names import bare_name
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in
from algebroproj_sym.reading.parsing.operators import Applied
from algebroproj_sym.reading.remembering.standing import Standing
from algebroproj_sym.reading.ways.constraining import is_asserted

MOST_UNDER = 6
"""How many equations serve together with their derivatives."""
_BY_PLACE = frozenset(("div", "curl", "grad", "lap", *ALONG))
Apart = Callable[[Formula], Formula]


def of_fields(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    r"""Yield a relation with operators by components, also under equations near it and their derivatives.

    ``\nabla^2`` alone may be another thing: the matrix of second derivatives.  Words may hold other letters than
    coordinates.  What has a coordinate itself is differentiated elsewhere.
    """
    if standing.beside.variables - {*SPACE, "t"}:
        return
    applied, used = standing.survey.applied, standing.vocabulary.used_in(left, right)
    if not any(_may_act(each, applied) for each in (left, right, *(each.tree for each in used))):
        return
    symbols = {*standing.survey.occurring, *(one for each in applied.values() for one in symbols_in(each.body))}
    letters = {bare_name(each): each for each in sorted(symbols)}
    apart: Apart = partial(with_operators_apart, applied=applied, letters=letters)
    try:
        sides = apart(left), apart(right)
    except UnreadableError:
        return
    known = _with_definitions_apart(standing.vocabulary, apart)
    kinds = _kinds_in(*known.with_used(*sides))
    has_vectors = any(each.kind in ("div", "curl", *ALONG) for each in applied.values())
    if not kinds or ("lap" in kinds and not (has_vectors or kinds - _BY_PLACE)):
        return
    near = _near(standing, known, sides, apart)
    shown = known.equation(left, right)
    for under in dict.fromkeys(((), *((premise,) for premise in near[:2]), (*near,))):
        yield from _with_fields(known, sides, under, shown, applied)


def _may_act(tree: Formula, applied: Mapping[str, Applied]) -> bool:
    """Whether a formula has an operator, or a partial derivative."""
    names = (*symbols_in(tree), *(str(each.children[0]) for each in tree.find_data("big")))
    return any(each in applied or each.startswith(r"\partial") for each in names)


def _with_definitions_apart(vocabulary: Vocabulary, apart: Apart) -> Vocabulary:
    """Return a vocabulary with the definitions whose operators stand before what they are applied to."""
    found = dict[str, Definition]()
    for symbol, each in vocabulary.definitions.items():
        with suppress(UnreadableError):
            found[symbol] = replace(each, tree=apart(each.tree))
    return vocabulary.changed(definitions=found)


def _near(standing: Standing, known: Vocabulary, sides: Sides, apart: Apart) -> list[Premise]:
    """Return the last equations above a relation that hold there and share a letter with it."""
    own = known.letters_of(*sides)
    found = []
    for place, each in enumerate(standing.near(MOST_UNDER)):
        if not is_asserted(standing, each, is_last=place < MOST_NEAR):
            continue
        with suppress(UnreadableError):
            left, right = apart(each.left), apart(each.right)
            if own & known.letters_of(left, right):
                found.append(replace(each, left=left, right=right))
    return found


def _kinds_in(*trees: Formula) -> set[str]:
    """Return the operators in formulas."""
    return {str(each.children[0]) for tree in trees for each in tree.find_data("operated")}


def _with_fields(
    known: Vocabulary, sides: Sides, under: Sequence[Premise], shown: str, applied: Mapping[str, Applied]
) -> Iterator[Way]:
    """Yield a relation with its letters as fields; those that nothing derives may be constant."""
    trees = [*sides, *sides_of(under)]
    used = known.used_in(*trees)
    trees += [each.tree for each in used]
    kinds, letters = _kinds_in(*trees), known.letters_of(*trees)
    by = {kind[-1] for kind in kinds - _BY_PLACE}
    if any(each.parameters for each in used) or by & {*known.definitions}:
        return
    if by & letters or any(known.moves_with(by - {each}, each) for each in by):
        return
    vectors = {each for each in letters if known.is_matrix(each)}.union(*map(vectors_in, trees)) - {*known.definitions}
    values: dict[str, Any] = {}
    for vector in sorted(vectors):
        values |= components_of(vector, known.name(vector), letters)
    inside = [part for each in trees for part in each.find_data("operated")]
    inside += [each.body for each in applied.values()]
    still = letters - frozenset().union(vectors, *map(known.letters_of, inside))
    still = frozenset(each for each in still if not any(known.moves_with([each], letter) for letter in COORDINATES))
    said = letters & known.dependence.constant
    for fixed in dict.fromkeys((said | still,) if under else (said, said | still)):
        names = {f"{known.name(each)}{end}" for each in fixed for end in ("", *(f"__{letter}" for letter in SPACE))}
        fields = known.changed(uncomputed=Fields(frozenset(names)))
        fields.values |= values
        supposes = [
            f"letters are smooth functions of {', '.join(SPACE)} and t",
            *(f"{known.name(each)} is a component" for each in sorted(values.keys() - vectors)),
            *(f"{known.name(each)} does not change" for each in sorted(fixed)),
            *("nabla is by Cartesian coordinates" for _ in kinds & _BY_PLACE),
            *("nabla^2 is the divergence of the gradient" for _ in kinds & {"lap"}),
            *(f"{where} holds everywhere" for where in (*rests_of(known, *trees), *(each.where for each in under))),
            *("u.nabla v is (u.nabla) v" for _ in kinds & {ALONG[1]}),
        ]
        derived = (one for each in under for one in (each, *_derivatives_of(each, fields, kinds)))
        yield Way(*sides, fields, shown, tuple(derived), tuple(dict.fromkeys(supposes)))


def _derivatives_of(premise: Premise, fields: Vocabulary, kinds: set[str]) -> Iterator[Premise]:
    """Yield the derivatives of an equation by place, as a divergence, a curl or a gradient, and by time."""
    try:
        is_vector = any(shape(fields.value(each)) for each in premise.sides)
    except UNCOMPUTED:
        return
    by_place = kinds & _BY_PLACE
    operators = [kind for kind in sorted(kinds - _BY_PLACE) if not (by_place and kind[-1] in SPACE)]
    places = ("div", "curl") if is_vector else ("grad", *(kinds & {"lap"}))
    for kind in [*places, *operators] if by_place else operators:
        yield replace(premise, left=operated(kind, premise.left), right=operated(kind, premise.right))

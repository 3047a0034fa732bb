"""Relations of quaternions as those of their matrices."""

from collections.abc import Iterator
from dataclasses import replace

from algebroproj_sym.reading.asking.questions import Way
from algebroproj_sym.reading.deriving.quaternions import AsMatrices
from algebroproj_sym.reading.parsing.factors import base_of
from algebroproj_sym.reading.parsing.grammar import Parsed, symbols_in
from algebroproj_sym.reading.remembering.standing import Standing
from algebroproj_sym.reading.ways.constraining import under_equations
from algebroproj_sym.reading.ways.substituting import with_premises


def of_quaternions(standing: Standing, formula: Parsed, index: int) -> Iterator[Way]:
    """Yield a relation of quaternions as one of their matrices, also the equations above it."""
    known, quaternions = standing.vocabulary, standing.survey.quaternions
    if not any({*symbols_in(each)} & quaternions for each in formula.sides[index : index + 2]):
        return
    is_number = lambda tree: not any(map(known.is_matrix, symbols_in(tree)))  # noqa: E731
    matrices = AsMatrices(quaternions, is_number, has_conjugates=standing.survey.says(r"\b<conjugates>\b"))
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
    bare = bare.changed(properties=bare.properties | units)
    of_matrices = replace(formula, sides=(left, right), relations=("=",))
    there = replace(standing, vocabulary=bare, premises=premises, own=())
    shown = known.equation(*formula.sides[index : index + 2])
    told = ", ".join(f"{bare.name(letter)} for {known.name(of)}" for of, letter in matrices.letters.items())
    for way in (Way(left, right, bare), *with_premises(there, of_matrices, 0), *under_equations(there, left, right)):
        yield replace(way, reads=f"{shown}, with a matrix for each quaternion: {told}")

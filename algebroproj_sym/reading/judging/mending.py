"""The single changes after which a relation may follow: what a sieve of points leaves is asked of the prover."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from itertools import islice

from sympy import Symbol

from algebroproj_sym.expressions import NotRationalError, ParseError, evaluate, free_symbols, parse
from algebroproj_sym.proving import Outcome
from algebroproj_sym.reading.asking.questions import (
    OTHER_SHAPES,
    Way,
    asked_of,
    asked_under,
    is_lettered,
    values_of,
)
from algebroproj_sym.reading.asking.sampling import POINTS, agree, samples_of
from algebroproj_sym.reading.deriving.rates import ZERO
from algebroproj_sym.reading.judging.repairs import STRONG, WITHIN, Repair, repairs
from algebroproj_sym.reading.parsing.grammar import symbols_in
from algebroproj_sym.reading.ways.assuming import along_directions_in

_NO_SHAPES = ("the shapes", OTHER_SHAPES)
"""Why a relation cannot be asked that a missing or a wrong mark or power makes one of a number and a vector."""
Repaired = tuple[Repair, Way]
MOST_REPAIRS = 8
MOST_REPAIRS_OF_LETTERS = 40
MOST_ASKED = 16
"""How many changes of a relation are asked of the prover that no point refutes, in all the ways that prove and refute
nothing."""
MOST_APART = 2
"""How many letters may stand on one side alone for changes to be tried."""
MOST_CONSTRAINTS = 4
"""Under how many constraints a change is tried: under more, the proofs take too long."""
MOST_PUT_IN = 12
"""How many definitions are put in again for each change: with more, that takes too long."""
_SLIPS = STRONG | {"factor", "transpose"}


def likely_repairs(way: Way, *, chained: bool) -> list[Repaired]:
    """Return the changes after which the sides agree at some points.

    They are the same after it only in a chain, where the side before is given, and if the change is within a side.
    Nothing is changed if several letters stand on one side alone: no single change brings them to the other.
    """
    if (
        ZERO not in way.sides
        and len(way.vocabulary.letters_of(way.left) ^ way.vocabulary.letters_of(way.right)) > MOST_APART
    ):
        return []
    changed = [
        (each, other)
        for each, other in _changed(way)
        if other.left != other.right or (chained and each.kind in WITHIN and each.before not in way.sides)
    ]
    if is_lettered(way):
        return [] if _nests_lengths(way) else changed[:MOST_REPAIRS_OF_LETTERS]
    samples = [each for each in samples_of(way.vocabulary) if any(each.at(side) is not None for side in way.sides)]
    return [*islice((pair for pair in changed if agree(samples, pair[1].sides)), MOST_REPAIRS)]


def _changed(way: Way) -> list[Repaired]:
    """Return a way with single changes of its sides, those first that no special case makes."""
    trees = way.vocabulary.with_used(*way.sides, *way.given)
    symbols = {symbol for tree in trees for symbol in symbols_in(tree)}
    found = [(each, replace(way, right=each.formula)) for each in repairs(way.right, symbols)]
    found += [(each, replace(way, left=each.formula)) for each in repairs(way.left, symbols)]
    return sorted(found, key=lambda pair: pair[0].kind not in STRONG)


def repairs_in(way: Way, answer: Outcome) -> Iterator[Repaired]:
    """Yield likewise the changes in a way that refutes nothing."""
    if any(each.data in ("along", "direction", "applied") for tree in way.sides for each in tree.iter_subtrees()):
        return
    turned = next(along_directions_in(way), None) is not None
    is_open = answer.verdict != "refuted" and not answer.reason.startswith(_NO_SHAPES)
    if not turned and (is_open or _is_hard(way)):
        return
    changed = [(each, other) for each, other in _changed(way) if each.kind in _SLIPS and other.left != other.right]
    is_plain = not (way.under or _has_operators(way))
    if turned:
        for repair, other in changed:
            yield from ((repair, each) for each in islice(along_directions_in(other), 1))
    elif samples := samples_of(way.vocabulary, *way.sides) if answer.verdict == "refuted" and is_plain else []:
        yield from islice((pair for pair in changed if agree(samples, pair[1].sides)), MOST_REPAIRS)
    else:
        point = {name: value for name, value in (answer.counterexample or {}).items() if isinstance(value, str)}
        yield from (pair for pair in changed[:MOST_REPAIRS_OF_LETTERS] if not _differs(pair[1], point))


def _nests_lengths(way: Way) -> bool:
    """Whether lengths of vectors stand within each other: the proofs of single changes take too long then."""
    questions = asked_of(way.vocabulary, *way.sides)
    texts = [] if isinstance(questions, str) else [side for each in questions for side in (each.lhs, each.rhs)]
    return any(_begins_nested(text[match.end() :]) for text in texts for match in re.finditer(r"\bnorm\(", text))


def _begins_nested(text: str) -> bool:
    """Whether a length stands in text before its closing bracket."""
    depth = 1
    for match in re.finditer(r"\bnorm\(|[()]", text):
        if match[0].startswith("norm"):
            return True
        depth += 1 if match[0] == "(" else -1
        if not depth:
            return False
    return False


def _is_hard(way: Way) -> bool:
    if _nests_lengths(way):
        return True
    if len(way.vocabulary.used_in(*way.sides)) > MOST_PUT_IN:
        return True
    questions = asked_under(way) if way.under else ""
    return not isinstance(questions, str) and any(len(each.constraints) > MOST_CONSTRAINTS for each in questions)


def _differs(way: Way, point: Mapping[str, str]) -> bool:
    """Whether a way cannot be asked, or its sides differ at a point of the equations under which it is to hold."""
    questions = asked_under(way)
    if isinstance(questions, str) or questions[0].letters is not None:
        return isinstance(questions, str)
    try:
        sides = [(parse(each.lhs), parse(each.rhs)) for each in questions]
        numbers = {symbol: Fraction(point[symbol.name]) for symbol in map(Symbol, point)}
        for place, symbol in enumerate(
            sorted({one for pair in sides for side in pair for one in free_symbols(side)}, key=str)
        ):
            numbers.setdefault(symbol, Fraction(POINTS[place % len(POINTS)] + place))
        return any(evaluate(one, numbers) != evaluate(other, numbers) for one, other in sides)
    except (ParseError, ValueError, ZeroDivisionError, NotRationalError):
        return False


def _has_operators(way: Way) -> bool:
    return any(True for tree in way.sides for _ in tree.find_data("operated"))


def is_trivial(way: Way) -> bool:
    """Whether the sides are the same but for the order of their parts, with nothing put in."""
    if _has_operators(way):
        return False
    questions = asked_of(way.vocabulary, *way.sides)
    if isinstance(questions, str) or way.under or way.vocabulary.used_in(*way.sides) or values_of(questions):
        return False
    return all(each.lhs == each.rhs for each in questions)

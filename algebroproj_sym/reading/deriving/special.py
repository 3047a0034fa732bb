"""Whether sides that differ may be equal because values or products are special: ``y^2 = y``, or ``a b = -b a``.

A letter that is zero or one is its own square, and the units of quaternions anticommute.  No point of real numbers
refutes that.  So sides that have the same factors, but for their order, contradict nothing; nor do those of which one
has no powers.
"""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from typing import Any

from lark import Token

from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.parsing.grammar import Formula, trees_in, without_brackets

MOST_FACTORS = 200
"""How many factors of a side are compared."""
MOST_DEEP = 20
"""How many definitions are put into each other."""


@dataclass(frozen=True)
class _Term:
    """A product: its sign, and its factors in order, each with its power."""

    sign: int
    factors: tuple[tuple[Formula, int], ...]

    @property
    def bases(self) -> frozenset[tuple[Formula, bool]]:
        """Its factors without their powers and their order: which stand above a line, and which below."""
        return frozenset((base, power > 0) for base, power in self.factors)

    @property
    def total(self) -> tuple[int, frozenset[tuple[Formula, int]]]:
        """Its sign, and the power of each factor."""
        powers = Counter[Formula]()
        for base, power in self.factors:
            powers[base] += power
        return self.sign, frozenset(powers.items())

    @property
    def order(self) -> list[Formula]:
        """Its factors in order, without numbers."""
        return [base for base, _ in self.factors if base.data != "number"]


def doubt_of_special(left: Formula, right: Formula, vocabulary: Vocabulary) -> str:
    """Return why sides with the same factors may be equal; empty if they do not have the same ones."""
    ours, theirs = (_terms(each, vocabulary) for each in (left, right))
    if Counter(each.bases for each in ours) != Counter(each.bases for each in theirs):
        return ""
    pairs = [*zip(*(sorted(each, key=_by_bases(ours)) for each in (ours, theirs)), strict=True)]
    if any(one.order != other.order and Counter(one.order) == Counter(other.order) for one, other in pairs):
        return "the order of the factors may matter"
    same_sign = all(one.sign == other.sign for one, other in pairs)
    differ = same_sign and any(one.total != other.total for one, other in pairs)
    differ = differ and any(all(map(_has_no_powers, each)) for each in (ours, theirs))
    return "a letter may be zero or one, and so be its own square" if differ else ""


def _has_no_powers(term: _Term) -> bool:
    return all(abs(power) == 1 for _, power in term.total[1])


def _by_bases(terms: list[_Term]) -> Any:
    """Return by what terms are sorted so that those with the same factors stand side by side."""
    places = {each.bases: place for place, each in enumerate(terms)}
    return lambda each: places[each.bases]


def _terms(tree: Formula, vocabulary: Vocabulary) -> list[_Term]:
    tree = _put_in(tree, vocabulary)
    signed = [(1, tree)]
    if tree.data == "sum":
        signs = [str(each) for each in tree.children if isinstance(each, Token)]
        parts = trees_in(tree)
        signs = ["+"] * (len(parts) - len(signs)) + signs
        signed = [(-1 if sign == "-" else 1, part) for sign, part in zip(signs, parts, strict=True)]
    return [_Term(sign, tuple(islice(_factors(part, 1, vocabulary, 0), MOST_FACTORS))) for sign, part in signed]


def _put_in(tree: Formula, vocabulary: Vocabulary, depth: int = 0) -> Formula:
    """Return what a letter stands for, and what stands in brackets."""
    tree = without_brackets(tree)
    known = vocabulary.definitions.get(str(tree.children[0])) if tree.data == "symbol" else None
    if known is None or known.parameters or depth > MOST_DEEP:
        return tree
    return _put_in(known.tree, vocabulary, depth + 1)


def _factors(tree: Formula, power: int, vocabulary: Vocabulary, depth: int) -> Iterator[tuple[Formula, int]]:
    tree = _put_in(tree, vocabulary, depth)
    parts = trees_in(tree)
    if depth > MOST_DEEP:
        yield tree, power
    elif tree.data in ("run", "product"):
        for each in parts:
            yield from _factors(each, power, vocabulary, depth + 1)
    elif tree.data in ("fraction", "quotient"):
        yield from _factors(parts[0], power, vocabulary, depth + 1)
        yield from _factors(parts[1], -power, vocabulary, depth + 1)
    elif tree.data == "power" and parts[-1].data == "number" and str(parts[-1].children[0]).isdigit():
        yield from _factors(parts[0], power * int(str(parts[-1].children[0])), vocabulary, depth + 1)
    elif not (tree.data == "number" and str(tree.children[0]) == "1"):
        yield tree, power

"""Indices that stand more than once in a product: sums may run over them without a sign."""

import re
from collections.abc import Collection, Iterable, Iterator, Sequence

from lark import Tree

from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.parsing.factors import terms_of
from algebroproj_sym.reading.parsing.grammar import IN_BRACKETS, Formula, Sides, symbols_in, trees_in

_INDEX = re.compile(r"(?<![a-zA-Z\\])(?:[i-n]|\\(?:mu|nu|rho|sigma|alpha|beta|lambda|kappa))(?![a-zA-Z])")

_STEPS = re.compile(r"(?<!\w)([a-z])(?:[+-]\d+)?\|\1(?:[+-]\d+)?(?!\w)")
"""Two steps that name an estimate, as ``k+1|k``: they are no indices of components."""


def paired_in(equations: Iterable[Sides]) -> frozenset[str]:
    """Return the indices that a product has twice and no other side has, as in ``a = u_i v_i``.

    An index is counted, and not summed over, if a sum sign has it, or if it stands once on another side of such a
    product, as in ``p_i = m_i v_i``.
    """
    found, counted = set[str](), set[str]()
    for sides in equations:
        indices = [{index for symbol in symbols_in(side) for index in _indices_of(symbol)} for side in sides]
        for side in sides:
            others = {index for other, each in zip(sides, indices, strict=True) if other is not side for index in each}
            twice = {*repeated_in(side, 2)}
            found |= twice - others
            counted |= {index for other in sides for index in twice & others - {*repeated_in(other, 2)}}
            counted |= {str(each) for big in side.find_data("big") for each in _INDEX.findall(str(big.children[0]))}
    return frozenset(found - counted)


def twice_in(sides: Sequence[Formula]) -> str:
    r"""Return an index that a product, a power or a letter has twice, as in ``a_i (b_i + c)`` and ``a_i^2``."""
    for side in sides:
        for part in side.iter_subtrees():
            if part.data in ("run", "product", "fraction", "quotient"):
                found = [frozenset().union(*map(_indices_of, symbols_in(each))) for each in trees_in(part)]
            elif part.data == "power":
                found = [_indices_of(atom_of(part.children[0]))] * 2
            else:
                found = [frozenset(letter) for letter in _scripts_of(atom_of(part))]
            twice = [each for each in frozenset().union(*found) if sum(each in one for one in found) > 1]
            if twice:
                return min(twice)
    return ""


def summed_silently(sides: Sequence[Formula]) -> str:
    """Return an index that two factors of a product have, and another side has not; empty for none."""
    indices = [{each for symbol in symbols_in(side) for each in _indices_of(symbol)} for side in sides]
    for place, side in enumerate(sides):
        for product in side.find_data("run"):
            bound = {str(token) for big in side.find_data("big") for token in _INDEX.findall(str(big.children[0]))}
            factors = [_indices_of(atom_of(each)) for each in product.children]
            twice = {each for one in factors for each in one if sum(each in other for other in factors) == 2} - bound
            twice -= _labels_in(side, product, twice)
            for other, theirs in enumerate(indices):
                if other != place and (free := theirs) and (lone := twice - theirs) and free & indices[place]:
                    return min(lone)
    return ""


def repeated_in(side: Formula, times: int) -> Iterator[str]:
    """Yield the indices that a term has a number of times or more, as ``u_i^2 v_i`` has i three times."""
    for term in terms_of(side):
        found = [*_factors_indices(term)]
        yield from sorted(each for each in {*found} if found.count(each) >= times)


def _factors_indices(factor: Formula) -> list[str]:
    if factor.data == "power" and (exponent := atom_of(factor.children[1])).isdigit():
        return _factors_indices(trees_in(factor)[0]) * min(int(exponent), 3)
    if factor.data in ("run", "product", *IN_BRACKETS):
        return [index for each in trees_in(factor) for index in _factors_indices(each)]
    return _scripts_of(atom_of(factor))


def _labels_in(side: Formula, product: Formula, indices: Collection[str]) -> set[str]:
    """Return the indices of a product that are labels: another one has the same letters with another index."""
    heads = [_head_of(each) for each in product.children]
    others = [each for each in side.find_data("run") if each != product and [*map(_head_of, each.children)] == heads]
    theirs = [{index for factor in each.children for index in _indices_of(atom_of(factor))} for each in others]
    return {each for each in indices if any(found and each not in found for found in theirs)}


def _head_of(factor: object) -> str:
    symbol = atom_of(factor)
    return split_symbol(symbol)[0] if symbol and " " not in symbol and "/" not in symbol else ""


def _indices_of(symbol: str) -> frozenset[str]:
    return frozenset(_scripts_of(symbol))


def _scripts_of(symbol: str) -> list[str]:
    """Return the indices of a letter in their order."""
    if not symbol or " " in symbol or "/" in symbol:
        return []
    _, _, below, above = split_symbol(symbol)
    scripts = _STEPS.sub("", f"{below} {above}")
    return _INDEX.findall(scripts if "\\" in below + above else re.sub(r"(?<=[a-z])(?=[a-z])", " ", scripts))


def atom_of(tree: object) -> str:
    """Return the symbol or the number that a tree is; empty for another one."""
    if not isinstance(tree, Tree):
        return ""
    data, children = tree.data, tree.children
    if data in IN_BRACKETS and len(children) == 1:
        return atom_of(children[0])
    return str(children[0]) if data in ("symbol", "number") else ""

"""Which letters are tensors, of the second order or of the fourth, by equations and by words."""

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.parsing.factors import LIKE_IDENTITY, inner_of, terms_of
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, Sides, lone, symbols_in, trees_in, without_brackets
from algebroproj_sym.reading.prose.devices import says

CONTRACTS = (":", "colon")
"""The signs of ``A : B``, the sum of the products of their entries."""
_TENSOR = re.compile(r"\\math(?:bf|sf|bb)(?![a-z])")
_FOURTH = re.compile(r"\\mathbb(?![a-z])")
_OF_TENSORS = ("tr", "Tr", "trace", "det", "dev", "sym")


def speaks_of_tensors(words: str) -> bool:
    """Whether words speak of tensors, or of stresses and strains."""
    return says(r"\b<tensors>\b", words)


def speaks_of_dyads(words: str) -> bool:
    r"""Whether words speak of tensors, and of no quaternions or other products with the sign ``\otimes``."""
    return speaks_of_tensors(words) and not says(r"\b<other-circles>", words)


def with_traces(formula: Parsed) -> Parsed:
    r"""Return a formula in which ``I_1(\mathbf{A})``, the first invariant of a tensor, is a trace."""
    return replace(formula, sides=tuple(map(_with_traces, formula.sides)))


def _with_traces(tree: Any) -> Any:
    if not isinstance(tree, Tree):
        return tree
    items = trees_in(tree.children[1]) if tree.data == "call" and tree.children[0] == "I_1" else []
    if len(items) == 1 and _TENSOR.search(lone(items[0])):
        return Tree("function", [Token("FUNCTION", "tr"), tree.children[1]])
    return Tree(tree.data, [_with_traces(each) for each in tree.children])


def contract_otherwise(equations: Sequence[Sides]) -> bool:
    """Whether an equation says that ``A : B`` is the trace of a product of both, where none is transposed."""
    for sides in equations:
        pairs = [[lone(each) for each in trees_in(side)] for side in sides if any(True for _ in _operands(side))]
        traces = [each for side in sides for each in side.find_data("function") if str(each.children[0]) in _OF_TENSORS]
        products = [[lone(factor) for factor in trees_in(without_brackets(each.children[1]))] for each in traces]
        if any(all(pair) and pair in products for pair in pairs):
            return True
    return False


def second_in(equations: Sequence[Sides]) -> frozenset[str]:
    """Return the bold letters, without their scripts, that are matrices: beside ``:``, or of which there is a trace.

    So are those that are added or equal to one.
    """
    sides = [side for each in equations for side in each]
    operands = (each for side in sides for each in _operands(side))
    arguments = (trees_in(each)[0] for side in sides for each in side.find_data("function") if _is_of_tensors(each))
    found = {letter for part in (*operands, *arguments) for letter in _letters_of(part) if _TENSOR.search(letter)}
    sums = [[term for side in both for term in terms_of(side)] for both in equations]
    sums += [terms_of(each) for side in sides for each in side.find_data("sum")]
    related = [{letter for term in terms for letter in _letters_of(term) if _TENSOR.search(letter)} for terms in sums]
    while more := {letter for letters in related if not letters.isdisjoint(found) for letter in letters} - found:
        found |= more
    return frozenset(found)


def scales_in(equations: Sequence[Sides], second: Collection[str]) -> frozenset[str]:
    r"""Return the thin letters that stand before a tensor and never behind one: numbers, as G in ``2 G \mathbf{e}``."""
    before, behind = set[str](), set[str]()
    for run in (run for both in equations for side in both for run in side.find_data("run")):
        factors = trees_in(run)
        places = [place for place, each in enumerate(factors) if _has_second(each, second)]
        if places:
            before |= {symbol for each in factors[: places[0]] for symbol in symbols_in(each)}
            behind |= {symbol for each in factors[places[0] :] for symbol in symbols_in(each)}
    return frozenset(each for each in before - behind if not _TENSOR.search(each))


def _has_second(tree: Formula, second: Collection[str]) -> bool:
    return any(split_symbol(each)[0] in second for each in symbols_in(tree) if " " not in each and "/" not in each)


def depend_on_size(trees: Sequence[Formula], *, has_identity: bool) -> bool:
    """Whether formulas have a deviator or a determinant, or what may be a trace beside the identity."""
    functions = {str(each.children[0]) for tree in trees for each in tree.find_data("function")}
    if functions & {"dev", "det"}:
        return True
    return has_identity and (
        not functions.isdisjoint(_OF_TENSORS) or any(True for each in trees for _ in _operands(each))
    )


def _is_of_tensors(function: Formula) -> bool:
    return str(function.children[0]) in _OF_TENSORS


def _operands(side: Formula) -> Iterator[Formula]:
    for product in side.find_data("product"):
        signs = [str(each) for each in product.children if isinstance(each, Token)]
        if any(each in CONTRACTS for each in signs):
            yield from trees_in(product)


def _letters_of(part: Any) -> Iterator[str]:
    r"""Yield the letters of the terms of a matrix, without their scripts: the last one of a product.

    In ``\nabla \mathbf{u}`` the letter is that of a vector.
    """
    if part.data == "items":
        part = trees_in(part)[0]
    for term in terms_of(part):
        if r"\nabla" in symbols_in(term):
            continue
        maps = term.data == "product" and _FOURTH.match(_first_of(term))
        last = trees_in(term)[-1] if term.data == "run" or maps else term
        letter = lone(inner_of(last))
        if letter and " " not in letter and "/" not in letter:
            yield split_symbol(letter)[0]


def fourth_in(equations: Sequence[Sides], second: Collection[str]) -> frozenset[str]:
    r"""Return the letters that are tensors of the fourth order.

    A letter is one if it stands before ``:`` in what is equal to a matrix, or is added to ``A \otimes B`` of matrices,
    or to another one.
    """
    sums = [[term for side in sides for term in terms_of(side)] for sides in equations]
    sums += [terms_of(each) for sides in equations for side in sides for each in side.find_data("sum")]
    found = set[str]()
    for terms in sums:
        if any(_is_second(each, second) for each in terms):
            found |= {letter for each in terms if (letter := _first_of(each))}
    while (
        more := {
            letter
            for terms in sums
            if any(_is_fourth(each, found, second) for each in terms)
            for letter in map(_last_of, terms)
            if letter
        }
        - found
    ):
        found |= more
    return frozenset(found)


def _first_of(term: Any) -> str:
    """Return the letter before the only ``:`` of a term; empty if there is none."""
    term = without_brackets(term)
    is_one = term.data == "product" and len(term.children) == 3 and str(term.children[1]) in CONTRACTS
    return _last_of(trees_in(term)[0]) if is_one else ""


def _last_of(term: Any) -> str:
    term = inner_of(term)
    return lone(trees_in(term)[-1] if term.data == "run" else term)


def _is_second(term: Any, second: Collection[str]) -> bool:
    letter = _last_of(term)
    return (bool(letter) and split_symbol(letter)[0] in second) if " " not in letter and "/" not in letter else False


def _is_fourth(term: Any, found: Collection[str], second: Collection[str]) -> bool:
    inside = without_brackets(term)
    if inside.data == "product" and len(inside.children) == 3 and str(inside.children[1]) == "otimes":
        letters = [*map(_last_of, trees_in(inside))]
        return all(each and (LIKE_IDENTITY.fullmatch(each) or split_symbol(each)[0] in second) for each in letters)
    return _last_of(term) in found

r"""Matrices that may have no inverse: by words, by their sizes, or by the normal equations in which they stand."""

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import dropwhile
from typing import Any

from lark import Tree

from algebroproj_sym.reading.defining.composing import products_in
from algebroproj_sym.reading.lexing.names import bare_name
from algebroproj_sym.reading.parsing.factors import CAPITAL, base_of, head_of, is_inverse, terms_of
from algebroproj_sym.reading.parsing.grammar import Sides, lone, trees_in

_SQUARE = r"(?:square|invertible|non-?singular)"
_LETTERS = r"(\$[^$]+\$(?:(?:,? and |, ?)\$[^$]+\$)*)"
_ARE_SQUARE = re.compile(
    rf"{_LETTERS} (?:(?:is|are|be|being) )?(?:(?:an?|the|both|all|also|therefore|assumed|to|be) )*{_SQUARE}\b"
    r"(?!,? (?:if|when|where|only|unless|root|for|or)\b)"
    rf"|(?<!not )\b(?:an?|the|two|all|for|of|with) {_SQUARE} (?:[a-z]+ )?matri(?:x|ces) {_LETTERS}",
    re.IGNORECASE,
)
"""Words that call letters square: what they say of one letter they say of no other one."""
_HAS_NO_INVERSE = (
    r"(?:(?<!non)(?<!non-)singular(?! values?| vectors?)|not (?:be )?(?:square|invertible)|non-?(?:square|invertible)"
    r"|rank[- ]deficient|rectangular|wide|tall|fat|skinny|project(?:ion|or)|idempotent|nilpotent)"
)
_SINGULAR = re.compile(
    rf"\$([^$]+)\$ (?:(?:is|be|may be|are) (?:\w+ ){{0,2}}?{_HAS_NO_INVERSE}"
    r"|has an? (?:\w+ )?(?:null[- ]?space|kernel)|(?:has not|does not have|lacks) full rank"
    r"|has (?:only )?rank (?:one|two|\$?[12]\b))"
    rf"|\b{_HAS_NO_INVERSE} matri(?:x|ces) \$?([^$\s.,]+)",
    re.IGNORECASE,
)
_DECLARED = re.compile(
    r"((?:\\[a-zA-Z]+\s*\{?\s*)?[A-Za-z]\}?)\s*\\in\s*(?:\\mathbb\s*\{?\s*R\s*\}?|\\R\b)\s*"
    r"\^\s*\{\s*(\w+)\s*\\times\s*(\w+)\s*\}"
)
"""Words, and LaTeX, of matrices that have no inverse."""
_UNEVEN = re.compile(
    r"\b(?:fewer|more) (?:rows|equations|measurements|observations) than (?:columns|unknowns|parameters|states)\b"
    r"|\b(?:over|under)-?determined\b",
    re.IGNORECASE,
)
_FACTOR = re.compile(r"(?:\\mathbf)?L(?:_\w+)?")
_BOLDLY = re.compile(r"^\\(?:mathbf|boldsymbol|bm)\{?\s*")
_OF_SIZE = re.compile(r"\$(\w+) ?\\times ?(\w+)\$ (?:(?!while|whereas|and|but)[\w-]+ ){0,2}matri(?:x|ces) \$([^$]+)\$")
_ARE_OF_SIZE = re.compile(r"\$([^$]+)\$ (?:is|be|are|denotes?) (?:an? |the )?\$(\w+) ?\\times ?(\w+)\$")


def oblong_in(equations: Sequence[Sides], occurring: Iterable[str], words: str) -> frozenset[str]:
    """Return the letters of matrices that may not be square."""
    found = {*_inverted_squares_in(equations), *_normal_in(equations)}
    found |= {*_mapping_in(equations)} if _UNEVEN.search(words) else set()
    named = (re.findall(r"\$([^$]+)\$", letters) for said in _ARE_SQUARE.findall(words) for letters in said)
    square = {bare_name(each) for letters in named for each in letters}
    found = {each for each in found if bare_name(each) not in square}
    declared = {letter for letter, rows, width in _DECLARED.findall(words) if rows != width}
    declared |= {letter or other for letter, other in _SINGULAR.findall(words)}
    declared |= {letter for rows, width, letter in _OF_SIZE.findall(words) if rows != width}
    declared |= {letter for letter, rows, width in _ARE_OF_SIZE.findall(words) if rows != width}
    declared |= {*_one_sided_in(equations, {*map(bare_name, declared)})}
    bare = {*map(bare_name, declared)}
    return frozenset(found | {each for each in occurring if bare_name(each) in bare})


def _inverted_squares_in(equations: Sequence[Sides]) -> Iterator[str]:
    r"""Yield the letters of which a square is inverted, as X in ``(X^T X)^{-1}``, or in ``S = X^T X``, ``S^{-1}``.

    None is the L of ``L L^T``, the factor of Cholesky, whose transpose is inverted itself, as in ``L^{-T}``.
    """
    powers = (power for each in equations for side in each for power in side.find_data("power"))
    bases = [power.children[0] for power in powers if is_inverse(power)]
    inverted = {base_of(each) for each in bases if isinstance(each, Tree)} - {""}
    turned = {base_of(each) for each in bases if isinstance(each, Tree) and each.data == "marked"}
    factors = {each for each in turned if _FACTOR.fullmatch(bare_name(each))}
    sides = [side for both in equations if inverted & {head_of(side) for side in both} for side in both]
    yield from {letter for each in (*bases, *sides) for letter in _squared_in(each)} - factors


def _normal_in(equations: Sequence[Sides]) -> Iterator[str]:
    """Yield the letters of normal equations: A in ``A^T A x = A^T b``, or ``A^T (A x - b) = 0``.

    They are not invertible as a rule.
    """
    named = {
        head_of(one): {*_squared_in(other)} for both in equations for one in both for other in both if head_of(one)
    }
    for both in equations:
        terms = [factors for side in both for term in terms_of(side) for factors in _products_in(term)]
        turned = [(base_of(first), [lone(each) for each in rest]) for first, *rest in terms if first.data == "marked"]
        squares = {letter for letter, rest in turned if letter and letter in rest[:-1]}
        squares = squares.union(*(named.get(lone(first), ()) for first, *_ in terms))
        yield from squares & {letter for letter, rest in turned if letter not in rest}


def _products_in(term: Any) -> Iterator[list[Any]]:
    """Yield the factors of a product behind the numbers in it; of one with a sum at its end, for each of its terms."""
    if term.data == "run":
        *first, last = trees_in(term)
        for each in terms_of(last):
            factors = [*first, *(trees_in(each) if each.data == "run" else [each])]
            yield [*dropwhile(lambda factor: factor.data in ("number", "fraction"), factors)] or [last]


def _one_sided_in(equations: Iterable[Sides], oblong: Collection[str]) -> Iterator[str]:
    """Yield the letters whose product with an oblong one is the identity: they have no inverse either."""
    for one, other in products_in(equations):
        factors = [*map(lone, trees_in(other))]
        if lone(one)[-2:].strip("}") == "I" and all(factors) and not {*map(bare_name, factors)}.isdisjoint(oblong):
            yield from factors


def _mapping_in(equations: Iterable[Sides]) -> Iterator[str]:
    """Yield the capitals that take one letter into another one, as H in ``z = H x``."""
    for one, other in products_in(equations):
        factors = [*map(lone, trees_in(other))]
        if lone(one) and len(factors) == 2 and all(factors) and CAPITAL.match(_BOLDLY.sub("", factors[0])):
            yield factors[0]


def _squared_in(tree: Any) -> Iterator[str]:
    """Yield the letter that a product has at one end, and transposed at the other."""
    if not isinstance(tree, Tree):
        return
    for term in terms_of(tree):
        first, last = (trees_in(term)[0], trees_in(term)[-1]) if term.data == "run" else (term, term)
        if base_of(first) == base_of(last) and (first.data == "marked") != (last.data == "marked"):
            yield base_of(first)

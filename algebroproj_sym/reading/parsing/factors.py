"""The letters of which a formula is made: those of its terms and factors."""

import re
from collections.abc import Iterator
from typing import Any

from lark import Tree

from algebroproj_sym.reading.parsing.grammar import IN_BRACKETS, Formula, lone, tokens_in, trees_in, without_brackets

CAPITAL = re.compile(
    r"(?:\\(?:bar|hat|tilde|overline|widehat|widetilde|mathcal|mathbf|mathsf)\{)*"
    r"(?:[A-Z]|\\(?:Gamma|Theta|Lambda|Xi|Pi|Sigma|Phi|Psi|Omega))(?![a-zA-Z])"
)
LIKE_IDENTITY = re.compile(r"(?:I|\\math(?:bf|bb|rm)\{I\}|\\math(?:bf|bb)\{1\})(?:_[2-9n])?")
MEAN = re.compile(r"E|\\math(?:bb|ds|rm|sf)\{E\}")


def base_of(factor: Any) -> str:
    """Return the letter that a factor is, without its marks and powers; empty if it is more."""
    while isinstance(factor, Tree) and factor.data in ("marked", "power", "group"):
        factor = factor.children[0]
    return lone(factor)


def head_of(term: Any) -> str:
    """Return the letter, or the function, of which a term is a multiple or a sum; empty if it is more."""
    term = inner_of(term)
    if term.data == "run" and all(each.data == "number" for each in term.children[:-1]):
        term = inner_of(term.children[-1])
    return str(term.children[0]) if term.data in ("symbol", "opaque", "call") and not is_mean(term) else ""


def inner_of(term: Any) -> Any:
    """Return what stands in brackets, above a line or behind a sign of sums."""
    while term.data in ("big", "fraction", "quotient") or (term.data in IN_BRACKETS and len(term.children) == 1):
        term = trees_in(term)[0]
    return term


def is_inverse(power: Formula) -> bool:
    """Whether an exponent is -1."""
    exponent = power.children[1]
    return isinstance(exponent, Tree) and tokens_in(exponent) == ["-", "1"]


def is_row(factor: Any) -> bool:
    """Whether a factor is a small letter that is transposed."""
    return factor.data == "marked" and factor.children[1] == "T" and not CAPITAL.match(lone(factor.children[0]) or "A")


def is_mean(term: Formula) -> bool:
    """Whether a formula is an expected value: it has the shape of what stands within it."""
    name = str(term.children[0]) if term.data == "call" else ""
    return MEAN.fullmatch(name) is not None and len(trees_in(term)[0].children) == 1


def terms_of(side: Any) -> list[Any]:
    """Return the terms of a formula; itself if it is no sum."""
    side = without_brackets(side)
    return [term for each in trees_in(side) for term in terms_of(each)] if side.data == "sum" else [side]


def factors_of(tree: Any, *, deep: bool = True) -> Iterator[str]:
    """Yield the letters of a sum or product of letters, and of their powers if deep."""
    if tree.data == "symbol":
        yield str(tree.children[0])
    elif tree.data in ("marked", "power") and deep:
        yield from factors_of(tree.children[0], deep=deep)
    elif tree.data in ("run", "product", "sum", "group") or (
        tree.data in ("bracket", "items") and len(tree.children) == 1
    ):
        for part in trees_in(tree):
            yield from factors_of(part, deep=deep)

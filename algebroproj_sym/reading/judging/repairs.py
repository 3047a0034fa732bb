"""Single changes of a formula, of the sort that a misprint makes: by which of them an equation would follow."""

import re
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from itertools import islice
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.parsing.grammar import Formula

MOST = 250
STRONG = frozenset(("sign", "number", "exponent", "index", "fraction", "function"))
"""Changes that no special case makes: a factor or term that is missing may be one or zero in the author's mind."""
WITHIN = frozenset(("sign", "number", "function"))
"""Changes within a side that may make it the other side of a chain, word by word."""
MULTIPLE = "multiple"
"""A whole side doubled or halved: in a chain, no special case makes it but zero."""

_ORDER = ("sign", "number", "index", "exponent", "function", MULTIPLE, "letter", "fraction", "transpose", "factor")
_OTHERS = {"sin": "cos", "cos": "sin", "sinh": "cosh", "cosh": "sinh", "tan": "cot", "cot": "tan"}
_TABLE = re.compile(r"\\mathbf\{|[A-Z](?:_|$)")
"""How letters begin that may be vectors or matrices."""
_ZERO, _ONE, _TWO = (Tree("number", [Token("NUMBER", each)]) for each in "012")
_MINUS, _PLUS = Token("SIGN", "-"), Token("SIGN", "+")


@dataclass(frozen=True)
class Repair:
    """A changed formula: of what kind the change is, and what was there before and is there now."""

    kind: str
    before: Formula
    now: Formula
    formula: Formula


def repairs(formula: Formula, symbols: Collection[str]) -> list[Repair]:
    """Return single changes of a side of an equation, the smallest first.

    The symbols may take the place of one that differs in its index or its primes.
    """
    whole = [("sign", _negated(formula)), *((MULTIPLE, each) for each in _doubled(formula))]
    found = [Repair(kind, formula, now, now) for kind, now in whole]
    found += _changes(formula, sorted(symbols))
    ordered = sorted(islice(found, 4 * MOST), key=lambda each: _ORDER.index(each.kind))
    return ordered[:MOST]


def _changes(node: Any, symbols: list[str]) -> Iterator[Repair]:
    for kind, changed in _of(node, symbols):
        yield Repair(kind, node, changed, changed)
    if not isinstance(node, Tree) or node.data in ("big", "cases", "opaque"):
        return
    for place, child in enumerate(node.children):
        if isinstance(child, Tree):
            for each in _changes(child, symbols):
                yield Repair(each.kind, each.before, each.now, _with(node, place, each.formula))


def _of(node: Any, symbols: list[str]) -> Iterator[tuple[str, Formula]]:
    """Yield the changes of the top of a tree."""
    kind, parts = node.data, node.children
    if kind == "sum":
        if not isinstance(parts[0], Token):
            yield "sign", Tree("sum", [_MINUS, *parts])
        for place, part in enumerate(parts):
            if isinstance(part, Token) and str(part) in "+-":
                yield "sign", _with(node, place, _PLUS if part == "-" else _MINUS)
        terms = [place for place, part in enumerate(parts) if isinstance(part, Tree)]
        for place in terms:
            yield from (("factor", _with(node, place, changed)) for changed in _doubled(parts[place]))
    elif kind == "cell" and parts and parts[0].data != "sum":
        yield "sign", Tree("cell", [_negated(parts[0])])
        if parts[0] in (_ZERO, _ONE):
            yield "number", Tree("cell", [_ONE if parts[0] == _ZERO else _ZERO])
    elif kind == "number" and str(parts[0]).isdigit() and len(parts[0]) < 6:
        for value in (int(parts[0]) + 1, int(parts[0]) - 1):
            if value >= 0:
                dropped = "0" in (str(value), str(parts[0]))
                yield "factor" if dropped else "number", Tree("number", [Token("NUMBER", str(value))])
    elif kind == "symbol":
        siblings = _siblings(str(parts[0]), symbols)
        yield from (("index", Tree("symbol", [Token("SYMBOL", other)])) for other in siblings)
        others = (each for each in symbols if each not in (*siblings, str(parts[0])) and _is_letter(each))
        yield from (("letter", Tree("symbol", [Token("SYMBOL", other)])) for other in others)
        yield "exponent", Tree("power", [node, _TWO])
        if _TABLE.match(str(parts[0])):
            yield "transpose", Tree("marked", [node, Token("MARK", "T")])
    elif kind == "opaque":
        yield from (("index", Tree("opaque", [Token("SYMBOL", other)])) for other in _siblings(str(parts[0]), symbols))
    elif kind == "power":
        yield "exponent", parts[0]
        yield "exponent", Tree("power", [parts[0], _negated(parts[1])])
    elif kind == "marked":
        yield "transpose", parts[0]
    elif kind == "fraction":
        yield "fraction", Tree("fraction", parts[::-1])
        yield from (("factor", changed) for changed in _doubled(node))
    elif kind == "run":
        for place in range(len(parts)):
            rest = [part for i, part in enumerate(parts) if i != place]
            yield "factor", rest[0] if len(rest) == 1 else Tree("run", rest)
        yield from (("factor", changed) for changed in _doubled(node))
    elif kind in ("function", "raised_function") and str(parts[0]) in _OTHERS:
        yield "function", _with(node, 0, Token("FUNCTION", _OTHERS[str(parts[0])]))


def _doubled(term: Formula) -> Iterator[Formula]:
    yield Tree("run", [_TWO, term])
    yield Tree("fraction", [term, _TWO])


def _negated(formula: Formula) -> Formula:
    return Tree("sum", [_MINUS, formula])


def _with(node: Formula, place: int, child: Any) -> Formula:
    children = list(node.children)
    children[place] = child
    return Tree(node.data, children)


def _is_letter(symbol: str) -> bool:
    return " " not in symbol and "/" not in symbol and not split_symbol(symbol)[0].startswith(r"\math")


def _siblings(symbol: str, symbols: list[str]) -> list[str]:
    if " " in symbol:
        return [each for each in symbols if " " in each and _INDEX.fullmatch(_difference(symbol, each))]
    if "/" in symbol:
        return [each for each in symbols if "/" in each and _difference(symbol, each).isdigit()]
    letter, primes, below, above = split_symbol(symbol)
    found = []
    for other in symbols:
        if other != symbol and " " not in other and "/" not in other:
            theirs = split_symbol(other)
            if (
                theirs[0] == letter
                and sum(a != b for a, b in zip(theirs[1:], (primes, below, above), strict=True)) == 1
            ):
                found.append(other)
    return found


_INDEX = re.compile(r"[i-n]{2}|\d\d")


def _difference(one: str, other: str) -> str:
    """Return both characters in which two names differ, if it is but one in each; empty if it is not."""
    pairs = [a + b for a, b in zip(one, other, strict=False) if a != b]
    return pairs[0] if len(one) == len(other) and len(pairs) == 1 else ""

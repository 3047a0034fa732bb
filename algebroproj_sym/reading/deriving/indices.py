r"""Equations at another index: ``x_{k+1} = a x_k`` gives ``x_{k+2} = a x_{k+1}`` and ``x_1 = a x_0``.

A letter is an index only where the document counts with it: in ``x_{k+1}``, a sum over k, or ``k = 0, 1, \dots``.
"""

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import permutations
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.defining.dependence import WORDS, index_of
from algebroproj_sym.reading.lexing.names import split_symbol, written
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in
from algebroproj_sym.reading.prose.devices import heard

Item = tuple[str, int]
"""A letter and what is added to it; a number has no letter, and what is no index stands as it is, with zero."""
Script = tuple[Item, ...]

_ITEM = re.compile(r"([a-zA-Z])?(?:([+-]?)(\d{1,4}))?")
_SMALL = re.compile(r"((?:d|\\delta|\\Delta) |)(.*)", re.DOTALL)
"""A symbol, and the sign of a change before it, as in ``\\delta p_t``."""
_WORDS = WORDS | {"mn", "kl"}
_SHIFTED = re.compile(r"(?<![a-zA-Z\\])([a-zA-Z])[+-]\d(?!\w)")
_LETTERS = frozenset("ijklmnpqrstNT")
_COUNTED = re.compile(
    r"(?<![a-zA-Z\\])([a-zA-Z])\s*(?:=|\\in\s*\\\{)\s*(\d+)\s*,\s*(?:\\[,;]\s*)?"
    r"(?:\d+\s*,\s*)*(?:\d+|\\l?dots[a-z]?|\\cdots|\.\.\.|…)(?:\s*,\s*(\d+))?"
)
_FROM = re.compile(r"(?<![a-zA-Z\\_{])([a-zA-Z])\s*(\\geq?(?:slant)?|>=?|≥)\s*(\d+)")
_ABOVE = re.compile(r"(?<![a-zA-Z\\_{\d.])(\d+)\s*(\\leq?(?:slant)?|<=?|≤)\s*([a-zA-Z])(?![a-zA-Z])")
_UP_TO = re.compile(r"(?<![a-zA-Z\\_{])([a-zA-Z])\s*(\\leq?(?:slant)?|<=?|≤)\s*(\d+)")
_SUM = re.compile(r"\\(?:sum|prod)_\{?([a-zA-Z])=(\d+)\}?(?:\^\{?(\d+)(?!\w))?")
_LIMITED = re.compile(r"(\\sum_\{([a-z])=\d\}\^\{)([a-zA-Z])([+-]\d)?\}")
"""A sum up to a letter, and its parts."""
_UNEQUAL = re.compile(
    r"(?<![a-zA-Z\\])([a-zA-Z])\s*(?:\\neq?(?![a-z])|\\not\s*=|≠|<|>|\\[lg]t(?![a-z]))\s*([a-zA-Z0-9])(?![a-zA-Z])"
)
_HOLDS = frozenset({"hold", "holds", "valid", "true", "apply", "applies", "defined", "so", "case"})
_SOME = re.compile(r"\b(?:some|certain|one)\s+(?:index\s+)?\$\s*([a-zA-Z])(?![a-zA-Z])")


@dataclass(frozen=True)
class Indices:
    """What a document says of its indices."""

    text: str
    """The whole document."""
    symbols: frozenset[str]
    """All symbols of its formulas."""

    @cached_property
    def counted(self) -> frozenset[str]:
        """The letters that the document counts with."""
        shifted = {each for symbol in self.symbols if "/" not in symbol for each in _SHIFTED.findall(symbol)}
        sums = {each for each in map(index_of, re.findall(r"\\sum_\{[^{}]*\}", self.text)) if each}
        sums |= {*re.findall(r"\\sum_([a-z])(?![a-zA-Z])", self.text)}
        ranges = {match[1] for match in _COUNTED.finditer(self.text)}
        found = shifted | sums | ranges | {*self._exchanged} | {*self._turned}
        return frozenset(found - {*_SOME.findall(self.text)}) & _LETTERS

    @property
    def _exchanged(self) -> Iterator[str]:
        """Yield the letters from i to n that stand below two letters or more, each of which has another one as well.

        Neither stands alone, but where it is compared with another index.
        """
        below = [(letter, script) for letter, _, script, _ in map(split_symbol, filter(_is_plain, self.symbols))]
        heads = {index: {letter for letter, script in below if script == index} for index in "ijklmn"}
        for one, other in permutations(heads, 2):
            if len(heads[one] & heads[other]) > 1 and {one, other} & self.symbols <= self.apart:
                yield one

    @property
    def _turned(self) -> Iterator[str]:
        """Yield the letters from i to n of which two stand below a letter in both orders, as ``d_{ij} = -d_{ji}``."""
        names = map(split_symbol, filter(_is_plain, self.symbols))
        below = {(letter, script) for letter, _, script, _ in names}
        for letter, script in below:
            if re.fullmatch("[i-n]{2}", script) and script[0] != script[1] and (letter, script[::-1]) in below:
                yield from script

    @cached_property
    def least(self) -> Mapping[str, int]:
        """The smallest number that letters may be, where the document says it."""
        said = [(match[1], int(match[2])) for match in _COUNTED.finditer(self.text)]
        said += [(match[1], int(match[2])) for match in _SUM.finditer(self.text)]
        said += [(match[1], int(match[3]) + (match[2] == ">")) for match in _FROM.finditer(self.text)]
        said += [(match[3], int(match[1]) + (match[2] == "<")) for match in _ABOVE.finditer(self.text)]
        return {letter: max(number for one, number in said if one == letter) for letter, _ in said}

    @cached_property
    def greatest(self) -> Mapping[str, int]:
        """Likewise the greatest one."""
        said = [(match[1], int(match[3])) for match in _COUNTED.finditer(self.text) if match[3]]
        said += [(match[1], int(match[3])) for match in _SUM.finditer(self.text) if match[3]]
        said += [(match[1], int(match[3]) - (match[2] == "<")) for match in _UP_TO.finditer(self.text)]
        return {letter: min(number for one, number in said if one == letter) for letter, _ in said}

    @cached_property
    def apart(self) -> frozenset[str]:
        """The letters that the document compares with another index, or says not to be a number."""
        return frozenset(each for match in _UNEQUAL.finditer(self.text) for each in match.groups())

    def scripts(self, symbol: str, count: int = 0) -> tuple[str, Script, Script] | None:
        """Return the letter of a symbol, and its scripts item by item; None for what is no plain symbol."""
        small, symbol = _SMALL.fullmatch(symbol).groups()  # type: ignore[union-attr]  # it always matches
        if not _is_plain(symbol):
            return None
        letter, primes, below, above = split_symbol(symbol)
        inside = above[1:-1] if above[:1] == "(" and above[-1:] == ")" else above
        return f"{small}{letter}{chr(39) * primes}", self._items(below, count), self._items(inside, 0)

    def _items(self, script: str, count: int) -> Script:
        parts = re.split(r"\s*,\s*", script) if script else []
        together = len(parts) == 1 and len(script) > 1
        if together and (
            (script.isdigit() and len(script) == count)
            or (script not in _WORDS and all(each in self.counted for each in script))
        ):
            parts = [*script]
        return tuple(map(self._item, parts))

    def _item(self, part: str) -> Item:
        match = _ITEM.fullmatch(part.replace(" ", ""))
        if match is None or not part or (match[1] and match[3] and not match[2]):
            return part, 0
        letter, sign, number = match.groups()
        if letter and letter not in self.counted:
            return part, 0
        return letter or "", int(f"{sign or ''}{number or 0}")

    def put_for(self, pattern: str, symbol: str) -> dict[str, Item] | None:
        """Return what is put for the indices of a symbol so that it becomes another one; None if it never does."""
        ours = self.scripts(pattern)
        theirs = self.scripts(symbol, len(ours[1])) if ours else None
        if ours is None or theirs is None or ours[0] != theirs[0]:
            return None
        if [*map(len, ours[1:])] != [*map(len, theirs[1:])]:
            return None
        found: dict[str, Item] = {}
        for (letter, shift), (other, number) in zip(ours[1] + ours[2], theirs[1] + theirs[2], strict=True):
            if letter not in self.counted:
                if (letter, shift) != (other, number):
                    return None
            elif (other and other not in self.counted) or found.setdefault(letter, (other, number - shift)) != (
                other,
                number - shift,
            ):
                return None
        return found

    def allows(self, put: Mapping[str, Item], tree: Formula) -> bool:
        """Whether an equation holds where some items are put for its indices, as far as the document says.

        Numbers are in the range that the document states.  Where it states none, no index becomes less than one, or
        less than zero in an equation that steps from one index to the next.  No index becomes another one of it.
        """
        names = [each for symbol in symbols_in(tree) if (each := self.scripts(symbol))]
        items = [item for _, below, above in names for item in (*below, *above)]
        for letter, (other, number) in put.items():
            if other != letter and other not in put and any(other == each for each, _ in items):
                return False
            if other:
                continue
            shifts = {shift for each, shift in items if each == letter}
            least = self.least.get(letter, 0 if len(shifts) > 1 else 1)
            if number < least or number > self.greatest.get(letter, number) or letter in self.apart:
                return False
            if any(number + shift < 0 for shift in shifts):
                return False
        given = [*put.values()]
        return len({*given}) == len(given) or self.apart.isdisjoint(put)

    def at(self, tree: Formula, put: Mapping[str, Item]) -> Formula | None:
        """Return a formula with items put for its indices; None if an index stands where it cannot be replaced."""
        if tree.data == "symbol" and (item := put.get(str(tree.children[0]))) is not None:
            return _formula(item)
        parts: list[Any] = []
        for each in tree.children:
            part = self.at(each, put) if isinstance(each, Tree) else self._token(each, put)
            if part is None:
                return None
            parts.append(part)
        return Tree(tree.data, parts)

    def _token(self, token: Token, put: Mapping[str, Item]) -> Token | None:
        if (found := _LIMITED.fullmatch(token)) and token.type == "BIG" and found[2] not in put and found[3] in put:
            letter, number = put[found[3]]
            more = number + int(found[4] or 0)
            last = f"{letter}{more:+d}" if letter and more else letter or str(more)
            return Token("BIG", f"{found[1]}{last}}}") if letter or more > 0 else None
        if token.type not in ("SYMBOL", "CALLEE"):
            return None if any(re.search(rf"(?<![a-zA-Z\\]){each}(?![a-zA-Z])", token) for each in put) else token
        small, symbol = _SMALL.fullmatch(token).groups()  # type: ignore[union-attr]  # it always matches
        letter, primes, below, above = split_symbol(symbol)
        names = self.scripts(str(token))
        if names is None:
            return None if any(re.search(rf"(?<![a-zA-Z\\]){each}(?![a-zA-Z])", token) for each in put) else token
        if not put.keys() & {each for script in names[1:] for each, _ in script}:
            return token
        moved = [tuple(_moved(each, put) for each in script) for script in names[1:]]
        scripts = [_script(script, before) for script, before in zip(moved, (below, above), strict=True)]
        raised = f"({scripts[1]})" if above[:1] == "(" else scripts[1]
        return Token(token.type, small + written(letter, primes, scripts[0], raised))


def _is_plain(symbol: str) -> bool:
    """Whether a symbol is a letter with scripts, and no derivative or value."""
    return "/" not in symbol and " " not in symbol


def excludes(words: Collection[str]) -> bool:
    """Whether words say that an equation may not hold at every index."""
    return ("not" in words and not _HOLDS.isdisjoint(words)) or any(map(heard("<changes>").fullmatch, words))


def indices_in(symbols: Iterable[str], indices: Indices) -> frozenset[str]:
    """Return the indices in the scripts of symbols."""
    names = [each for symbol in symbols if (each := indices.scripts(symbol))]
    return frozenset(letter for _, below, above in names for letter, _ in (*below, *above)) & indices.counted


def told(put: Mapping[str, Item], name: Callable[[str], str]) -> str:
    """Return in words what is put for indices, as ``k + 1 for k``."""
    moved = {old: item for old, item in put.items() if item != (old, 0)}
    return " and ".join(
        f"{_sum(name(letter) if letter else '', number)} for {name(old)}" for old, (letter, number) in moved.items()
    )


def _sum(letter: str, number: int) -> str:
    return f"{letter} {'+-'[number < 0]} {abs(number)}" if letter and number else letter or str(number)


def is_moved(put: Mapping[str, Item]) -> bool:
    """Whether something else is put for an index than the index itself."""
    return any(item != (letter, 0) for letter, item in put.items())


def _moved(item: Item, put: Mapping[str, Item]) -> Item:
    letter, shift = item
    other, number = put.get(letter, (letter, 0))
    return (other, number + shift) if letter in put else item


def _script(script: Script, before: str) -> str:
    """Return scripts as text: letters without commas, where they had none before."""
    texts = [f"{letter}{number:+d}" if letter and number else letter or str(number) for letter, number in script]
    are_single = all(len(each) == 1 and (each.isdigit() or "," not in before) for each in texts)
    return "".join(texts) if are_single and len({*map(str.isdigit, texts)}) < 2 else ",".join(texts)


def _formula(item: Item) -> Formula:
    letter, number = item
    symbol: Formula = Tree("symbol", [Token("SYMBOL", letter)])
    added: Formula = Tree("number", [Token("NUMBER", str(abs(number)))])
    if not letter:
        return added
    return Tree("group", [Tree("sum", [symbol, Token("SIGN", "+-"[number < 0]), added])]) if number else symbol

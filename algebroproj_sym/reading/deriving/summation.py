r"""Index notation: an index that stands twice in a term is summed from 1 to 3, and one that stands once is any.

``t_i = a_{ij} n_j`` is three equations, the first one ``t_1 = a_{11} n_1 + a_{12} n_2 + a_{13} n_3``.  A formula is
read so only if each index stands at most twice in each term, and if all terms have the same ones once.
"""

import re
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from itertools import product
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import letters_of_symbol
from algebroproj_sym.reading.defining.notation import PARTIAL, derivative_in
from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.deriving.rates import ONE, TWO, ZERO
from algebroproj_sym.reading.lexing.names import split_symbol, written
from algebroproj_sym.reading.parsing.grammar import IN_BRACKETS, Formula, symbols_in, trees_in

MOST_PARTS = 20_000
"""How many components are read for one equation, with all that is put in."""
_VALUES = ("1", "2", "3")
_SEVERAL = re.compile(r"[i-np-s]{2,4}")
_AT_INDICES = re.compile(r"([^^]+)_([a-z]{1,3})(\^.*)?")
_DELTA = r"\delta"
_KRONECKER = ("letter", _DELTA, "0", "", "2")
_SIGNS = (r"\epsilon", r"\varepsilon", "e")
_SAME = ("root", "function", "items", *IN_BRACKETS)


class _OtherwiseError(Exception):
    """A formula is none in index notation."""


@dataclass(frozen=True)
class _Indexed:
    """A letter with indices."""

    head: tuple[str, ...]
    """What all of its components have in common."""
    indices: tuple[str, ...]
    """Its indices in their order."""

    def at(self, values: Sequence[str]) -> str:
        """Return a component as a symbol."""
        if self.head[0] == "slope":
            _, above, over, below = self.head
            return rf"\partial{above}_{{{''.join(values[:-1])}}}{over}/\partial{below}_{values[-1]}"
        _, letter, primes, above, counts = self.head
        own = int(counts.partition(",")[0])
        first, rest = values[:own], values[own:]
        return written(letter, int(primes), ",".join(filter(None, ("".join(first), "".join(rest)))), above)


@cache
def _indexed(symbol: str, letters: frozenset[str]) -> _Indexed | None:
    """Return a symbol with some letters for its indices, perhaps behind a comma; None if it has others or none."""
    if (slope := derivative_in(symbol)) is not None and slope.is_first and slope.sign == PARTIAL:
        of, by = map(_AT_INDICES.fullmatch, (slope.function, slope.variable))
        if of is None or by is None or by[3] or len(by[2]) > 1:
            return None
        found = _Indexed(("slope", of[1], of[3] or "", by[1]), (*of[2], by[2]))
        return found if letters.issuperset(found.indices) else None
    if " " in symbol or "/" in symbol:
        return None
    letter, primes, below, above = split_symbol(symbol)
    groups = [each.strip() for each in below.split(",")]
    if len(groups) > 2 or not all(groups) or not letters.issuperset("".join(groups)):
        return None
    counts = ",".join(str(len(each)) for each in groups)
    return _Indexed(("letter", letter, str(primes), above, counts), (*"".join(groups),))


def indices_in(symbols: Iterable[str]) -> frozenset[str]:
    """Return the letters that are indices: those of which a letter has two or more, as i and j in ``a_{ij}``."""
    scripts = [split_symbol(each)[2].replace(",", "") for each in symbols if " " not in each and "/" not in each]
    return frozenset(letter for each in scripts if _SEVERAL.fullmatch(each) for letter in each)


def is_in_index_notation(symbols: Iterable[str], letters: frozenset[str]) -> bool:
    """Whether some symbols are those of index notation: Kronecker's delta, and a letter that has an index twice."""
    found = [each for symbol in symbols if (each := _indexed(symbol, letters)) is not None]
    deltas = any(each.head[1] == _DELTA and len({*each.indices}) == 2 for each in found)
    return deltas and any(len({*each.indices}) < len(each.indices) for each in found)


def in_components(
    sides: tuple[Formula, Formula], given: Sequence[Definition], letters: frozenset[str], *, unit: bool
) -> tuple[Formula, Formula, list[Definition], frozenset[str]] | None:
    """Return both sides by components, what is known of these, and all components; None if it is no index notation.

    What is given serves as far as it is in index notation, and a later one before an earlier one.  Some letters are
    indices.  An epsilon with three indices is the sign of a permutation if `unit`.
    """
    reader = _Components(given, letters, unit=unit)
    try:
        counts = [reader.counts(side) for side in sides]
        free = [_once(each) for each in counts]
        free = [free[1 - place] if sides[place] == ZERO else each for place, each in enumerate(free)]
        if free[0] != free[1] or not (free[0] or any(counts)):
            return None
        values = [dict(zip(sorted(free[0]), each, strict=True)) for each in product(_VALUES, repeat=len(free[0]))]
        left, right = ([reader.put(side, each) for each in values] for side in sides)
        known = reader.known([*left, *right])
    except _OtherwiseError:
        return None
    return _column(left), _column(right), known, frozenset(reader.components)


def _column(entries: Sequence[Formula]) -> Formula:
    rows: list[Any] = [Tree("row", [Tree("cell", [each])]) for each in entries]
    return entries[0] if len(entries) == 1 else Tree("matrix", [Token("BEGIN", "("), *rows])


def _once(counts: Counter[str]) -> frozenset[str]:
    return frozenset(each for each, count in counts.items() if count == 1)


@dataclass
class _Components:
    """Reads formulas by their components."""

    given: Sequence[Definition]
    letters: frozenset[str]
    unit: bool
    components: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = field(default_factory=dict)
    parts: int = 0

    def counts(self, tree: Formula) -> Counter[str]:
        """Return how often each index stands in each term of a formula."""
        forms = {symbol: self._indexed(symbol) for symbol in symbols_in(tree)}
        used = {index for each in forms.values() if each is not None for index in each.indices}
        above = (form.head[3] if form.head[0] == "letter" else "" for form in forms.values() if form is not None)
        others = [*(symbol for symbol, form in forms.items() if form is None), *above]
        if any(used & letters_of_symbol(each) for each in others):
            raise _OtherwiseError
        return self._counts(tree)

    def _indexed(self, symbol: str) -> _Indexed | None:
        return _indexed(symbol, self.letters)

    def _counts(self, tree: Any) -> Counter[str]:
        """Return how often each index stands in each term: once, or twice where it is summed."""
        if tree.data in ("symbol", "opaque"):
            found = self._indexed(str(tree.children[0]))
            return _limited(Counter(() if found is None else found.indices))
        if tree.data == "number":
            return Counter()
        if tree.data == "sum":
            terms = [self._counts(each) for each in trees_in(tree)]
            if len({_once(each) for each in terms}) > 1:
                raise _OtherwiseError
            return Counter({index: count for each in terms for index, count in each.items()})
        if tree.data in ("run", "product"):
            if any(isinstance(each, Token) and each.type != "DOT" for each in tree.children):
                raise _OtherwiseError
            return _limited(sum(map(self._counts, trees_in(tree)), Counter[str]()))
        inside = [self._counts(each) for each in trees_in(tree)]
        if tree.data in ("fraction", "quotient") and len(inside) == 2 and not inside[1]:
            return inside[0]
        if tree.data == "power" and not inside[1] and (not inside[0] or trees_in(tree)[1] == TWO):
            return Counter(dict.fromkeys(inside[0], 2))
        if tree.data in _SAME and len(inside) == 1 and (tree.data not in ("root", "function") or not _once(inside[0])):
            return inside[0]
        raise _OtherwiseError

    def put(self, tree: Any, values: Mapping[str, str]) -> Formula:
        """Return a formula with values for its indices; sums are written out."""
        self.parts += 1
        if self.parts > MOST_PARTS:
            raise _OtherwiseError
        if tree.data in ("symbol", "opaque"):
            found = self._indexed(str(tree.children[0]))
            twice = [] if found is None else [each for each, count in Counter(found.indices).items() if count == 2]
            return tree if found is None else _sum(self._component(found, each) for each in _every(twice, values))
        if tree.data in ("run", "product"):
            inside = sum((Counter(_once(self._counts(each))) for each in trees_in(tree)), Counter[str]())
            twice = [each for each, count in inside.items() if count == 2]
            return _sum(_run([self.put(part, each) for part in trees_in(tree)]) for each in _every(twice, values))
        if tree.data == "power":
            base, exponent = trees_in(tree)
            twice = [each for each in _once(self._counts(base)) if each not in values]
            return _sum(
                Tree("power", [Tree("group", [self.put(base, each)]), exponent])
                for each in _every(sorted(twice), values)
            )
        if tree.data == "sum":
            first = [] if isinstance(tree.children[0], Token) else [Token("SIGN", "+")]
            signs = [*first, *(each for each in tree.children if isinstance(each, Token))]
            terms = zip(signs, [self.put(each, values) for each in trees_in(tree)], strict=True)
            kept: list[Any] = [part for sign, each in terms if each != ZERO for part in (sign, each)]
            return Tree("group", [Tree("sum", kept)]) if kept else ZERO
        parts: list[Any] = [self.put(each, values) if isinstance(each, Tree) else each for each in tree.children]
        return Tree(tree.data, parts)

    def _component(self, found: _Indexed, values: Mapping[str, str]) -> Formula:
        put = tuple(values[each] for each in found.indices)
        if found.head == _KRONECKER and not self._is_given(found.head):
            return ONE if put[0] == put[1] else ZERO
        if self.unit and found.head[0] == "letter" and found.head[1] in _SIGNS and found.head[2:] == ("0", "", "3"):
            sign = _sign_of(put)
            return ZERO if not sign else ONE if sign > 0 else Tree("group", [Tree("sum", [Token("SIGN", "-"), ONE])])
        symbol = found.at(put)
        self.components[symbol] = found.head, put
        return letter_of(symbol)

    def _is_given(self, head: tuple[str, ...]) -> bool:
        """Whether a letter has a value that is no distinction of cases."""
        forms = ((self._indexed(each.symbol), each.tree.data) for each in self.given)
        return any(form is not None and form.head == head and data != "cases" for form, data in forms)

    def known(self, trees: Iterable[Formula]) -> list[Definition]:
        """Return what is known of the letters in formulas, and of those in these."""
        found = dict[str, Definition]()
        waiting = [symbol for tree in trees for symbol in symbols_in(tree)]
        seen = set[str]()
        while waiting:
            symbol = waiting.pop()
            if symbol not in seen and (definition := self._known(symbol)) is not None:
                found[symbol] = definition
                waiting += definition.symbols
            seen.add(symbol)
        return [*found.values()]

    def _known(self, symbol: str) -> Definition | None:
        """Return what is given of a component, or of a letter without indices."""
        head, put = self.components.get(symbol, ((), ()))
        for each in self.given[::-1]:
            form = self._indexed(each.symbol)
            if each.parameters or (each.symbol != symbol if form is None else form.head != head):
                continue
            if form is not None and len({*form.indices}) < len(put):
                continue
            values = {} if form is None else dict(zip(form.indices, put, strict=True))
            try:
                if _once(self.counts(each.tree)) == frozenset(values):
                    return replace(each, symbol=symbol, tree=self.put(each.tree, values))
            except _OtherwiseError:
                continue
        return None


def _limited(counts: Counter[str]) -> Counter[str]:
    if any(count > 2 for count in counts.values()):
        raise _OtherwiseError
    return counts


def _every(indices: Sequence[str], values: Mapping[str, str]) -> Iterator[Mapping[str, str]]:
    """Yield values also for some indices over which a sum runs."""
    for each in product(_VALUES, repeat=len(indices)):
        yield {**values, **dict(zip(indices, each, strict=True))}


def _sign_of(values: Collection[str]) -> int:
    first, second, third = map(int, values)
    return (second - first) * (third - first) * (third - second)


def _run(parts: Sequence[Formula]) -> Formula:
    kept: list[Any] = [each for each in parts if each != ONE]
    return ZERO if ZERO in parts else Tree("run", kept) if len(kept) > 1 else kept[0] if kept else ONE


def _sum(terms: Iterable[Formula]) -> Formula:
    kept = [each for each in terms if each != ZERO]
    parts: list[Any] = [part for each in kept for part in (Token("SIGN", "+"), each)]
    return Tree("group", [Tree("sum", parts)]) if len(kept) > 1 else kept[0] if kept else ZERO

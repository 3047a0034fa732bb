"""On what letters may depend: on what stands in equations with them.

A letter that is alone on the left depends on what stands on the right.  Where none is, or where it was known before,
each letter of the equation may depend on each other one: ``c - k = 1`` gives c by k as well as k by c.
"""

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise

from lark import Tree

from algebroproj_sym.reading.lexing.commands import VECTOR_STYLE
from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.factors import terms_of
from algebroproj_sym.reading.parsing.grammar import Formula, lone, symbols_in

ANY = "any"
"""What stands for all letters on which a symbol may depend that is more than a letter with scripts."""
SUMMED = r"\bullet"
"""What stands for an index over which a symbol is summed."""
_BEGINNING = -1


@dataclass(frozen=True)
class Tie:
    """An equation, as far as it says on what letters may depend."""

    given: str
    """The letter that is alone on the left; empty for none."""
    others: frozenset[str]
    """The other symbols, without those that are indices of sums in it."""
    is_first: bool
    """Whether no equation before it has the letter on the left."""
    is_condition: bool = False
    """Whether it is a whole equation with no letter alone on the left."""
    hiding: frozenset[str] = frozenset()
    """The letters of such an equation that may depend on an index of the other ones."""


@dataclass(frozen=True)
class Dependence:
    """What a document says of the letters that may depend on each other."""

    ties: tuple[Tie, ...] = ()
    """What its equations say."""
    by_time: bool = False
    """Whether t is the time: a dot above a letter is the derivative by t."""
    constant: frozenset[str] = frozenset()
    """The letters that words call constant."""
    arguments: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """The functions that are taken at the same letters in the whole document, with these."""
    axes_turn: bool = False
    """Whether words speak of axes that turn or move."""
    _related: dict[tuple[str, str], frozenset[str]] = field(default_factory=dict, compare=False)

    @cached_property
    def equated(self) -> dict[str, frozenset[str]]:
        """Of each letter that is alone on the left somewhere, the symbols of these equations."""
        found: dict[str, frozenset[str]] = {}
        for tie in self.ties:
            if tie.given:
                found[tie.given] = found.get(tie.given, frozenset()) | tie.others
        return found

    @cached_property
    def hidden(self) -> dict[str, frozenset[str]]:
        """Of each letter that may depend on an index by an equation with no letter alone, the symbols of these."""
        found: dict[str, frozenset[str]] = {}
        for tie in self.ties:
            found |= {each: found.get(each, frozenset()) | tie.others for each in tie.hiding}
        return found

    @cached_property
    def _places(self) -> dict[str, list[int]]:
        found: dict[str, list[int]] = {}
        for place, tie in enumerate(self.ties):
            for symbol in tie.others | {tie.given}:
                found.setdefault(symbol, []).append(place)
        return found

    def related(self, index: str, last: str = "") -> frozenset[str]:
        """Return the symbols that may depend on an index, as far as equations in which it stands alone say so.

        The last value of the index depends on no value of it.
        """
        if (index, last) not in self._related:
            self._related[index, last] = self._closure(index, last)
        return self._related[index, last]

    def _closure(self, index: str, last: str) -> frozenset[str]:
        reasons: dict[str, set[int]] = {index: {_BEGINNING}}
        waiting = [index]
        while waiting:
            for place in self._places.get(waiting.pop(), ()):
                for symbol in self._reached(self.ties[place], place, index, reasons) - {last}:
                    known = reasons.setdefault(symbol, set())
                    if place not in known and len(known) < 2:
                        known.add(place)
                        waiting.append(symbol)
        return frozenset(reasons)

    def _reached(self, tie: Tie, place: int, index: str, reasons: dict[str, set[int]]) -> frozenset[str]:
        """Return what depends on the index by an equation, if what has other reasons does."""
        if not tie.given or not (tie.is_first or index in letters_of_symbol(tie.given)):
            return tie.others | ({tie.given} if tie.given else frozenset())
        found: frozenset[str] = frozenset((tie.given,)) if tie.others & reasons.keys() else frozenset()
        return found | tie.others if reasons.get(tie.given, {place}) - {place} else found


def ties_of(letter: str, parameters: Sequence[str], sides: Sequence[Formula], before: set[str]) -> Iterator[Tie]:
    """Yield what an equation or a chain says, with a letter or a function of parameters on its left, or with none.

    Before are the symbols of the equations before it; those of this one are added.
    """
    symbols = [free_symbols(each) - {letter, *parameters} for each in sides]
    is_condition = not letter and not any(map(_rates, sides))
    hiding = _hiding(sides, frozenset().union(*symbols)) if is_condition else frozenset()
    yield Tie(letter, frozenset().union(*symbols), letter not in before, is_condition, hiding)
    yield from (Tie("", one | other, True) for one, other in pairwise(symbols[1:]) if one != other)
    before.update({letter}, *symbols)


def _hiding(sides: Sequence[Formula], symbols: frozenset[str]) -> frozenset[str]:
    """Return the letters of an equation that may depend on an index of the others: all, where none has one.

    Where a single letter has it, all others may: ``c - a_i = 0``.  Where several have it, one that is a term may,
    unless one of those is: ``y_i - a x_i - b = 0`` gives y_i, and ``c - a_i b_i = 0`` gives c.
    """
    alone = {lone(term) for side in sides for term in terms_of(side)}
    found, indices = set[str](), {each for symbol in symbols for each in letters_of_symbol(symbol) if len(each) == 1}
    indices = {index for index in indices if any(has_index(each, index) for each in symbols)}
    for index in indices:
        own = {each for each in symbols if has_index(each, index)}
        others = symbols - own - {index}
        found |= others if len(own) == 1 else others & alone if own.isdisjoint(alone) else set()
    return frozenset(found) if indices else symbols


def _rates(tree: Formula) -> bool:
    """Whether a derivative stands in a formula: one with two dots makes an equation of motion of it."""
    rates = any("/" in each or each.startswith(r"\ddot") for each in symbols_in(tree))
    return rates or any(True for _ in tree.find_data("big"))


def free_symbols(tree: Formula) -> frozenset[str]:
    r"""Return the symbols of a formula, without the indices of the sums in which they stand.

    In a sum over i, ``x_{ij}`` becomes ``x_{\bullet j}``: all that differ in the first index alone.
    """
    found = frozenset().union(*(free_symbols(each) for each in tree.children if isinstance(each, Tree)))
    own = Tree(tree.data, [each for each in tree.children if not isinstance(each, Tree)])
    found |= frozenset(symbols_in(own))
    index = index_of(str(tree.children[0])) if tree.data == "big" else ""
    return frozenset(_summed(each, index) for each in found - {index}) if index else found


def _summed(symbol: str, index: str) -> str:
    letters = letters_of_symbol(symbol)
    if index not in letters or ANY in letters:
        return symbol
    letter = split_symbol(symbol)[0]
    return f"{letter}_{{{SUMMED}{''.join(f' {each}' for each in sorted(letters - {index, letter, SUMMED}))}}}"


def summed_like(pattern: str, letter: str, symbols: Iterable[str]) -> frozenset[str]:
    r"""Return what a letter with one index depends on, summed over it if it stands for all of them, ``x_{\bullet}``."""
    index, *others = letters_of_symbol(letter) - {split_symbol(letter)[0]} or ("",)
    is_sum = SUMMED in pattern and not others and len(letters_of_symbol(pattern)) == 2
    return frozenset(_summed(each, index) for each in {*symbols} - {index}) if is_sum else frozenset(symbols)


def is_among(letter: str, symbols: Iterable[str]) -> bool:
    """Whether a symbol is among others, or among those over which one of them is summed."""
    letter, own = split_symbol(letter)[0], letter
    return any(each == own or (SUMMED in each and split_symbol(each)[0] == letter) for each in symbols)


def index_of(name: str) -> str:
    """Return the index of a sum; empty for what is no sum over one index."""
    match = re.match(r"\\sum_\{([a-z])(?:=.*)?\}", name)
    return match[1] if match else ""


COUNTED = re.compile(r"\\sum_\{[a-z]=(0(?=.*-1)|[01](?!.*-1))\}\^\{([a-zA-Z](?:_\w)?)(-1)?\}")
"""From 1 to n, from 0 to n, or from 0 to n - 1: n is a number 0, 1, 2, ..."""


def is_number(limit: str, varying: frozenset[str], definitions: Collection[str]) -> bool:
    """Whether the upper limit of a sum is a letter that nothing gives, and that does not depend on the index."""
    return limit not in definitions and varying.isdisjoint({limit, *letters_of_symbol(limit)})


def letters_in(name: str) -> frozenset[str]:
    """Return the letters in the name of a sum, an integral or a function."""
    return frozenset(re.findall(r"(?<![a-zA-Z\\])[a-zA-Z](?![a-zA-Z])", name))


def letters_of_symbol(symbol: str) -> frozenset[str]:
    r"""Return a letter and its scripts, on which it depends; "any" for a symbol that may depend on others.

    Examples
    --------
    >>> sorted(letters_of_symbol("x_{ij}")), sorted(letters_of_symbol("d x"))
    (['i', 'j', 'x'], ['any'])
    """
    if " " in symbol or "/" in symbol or symbol == ANY:
        return frozenset((ANY,))
    letter, _, below, above = split_symbol(symbol)
    return frozenset((letter, *re.findall(r"\\[a-zA-Z]+|[a-zA-Z]", f"{below} {above}")))


_BOUND = re.compile(r"\\[a-zA-Z]+\*?_\{?([a-zA-Z])(?![a-zA-Z])")
WORDS = frozenset({"in", "min", "kin", "lin", "il", "nm", "ml", "mm", "km", "nil", "ink", "mil", "lim"})
"""Scripts that look like indices, and are words or units."""


def has_index(symbol: str, index: str) -> bool:
    r"""Whether a letter stands in the scripts of a symbol as an index, as i in ``a_{ij}`` and not in ``a_{in}``."""
    symbol = symbol.replace(f"{SUMMED} ", "")
    if " " in symbol or "/" in symbol:
        return False
    _, _, below, above = split_symbol(symbol)
    words = re.findall(r"(?<![a-zA-Z\\])[a-zA-Z]+", f"{below} {above}")
    return any(index == each or (index in each and _ARE_INDICES.fullmatch(each)) for each in {*words} - WORDS)


_ARE_INDICES = re.compile(r"[i-nst]{2,3}")


def captured_in(trees: Iterable[Formula], behind: Callable[[str], Collection[str]]) -> tuple[str, str]:
    r"""Return a letter under a sum, a product or a maximum that hides its index, and the index; empty if none does.

    With ``c = a_i``, no c stands for itself in ``\sum_i c``.  An integral is over what its functions depend on.
    """
    for part in (part for tree in trees for part in tree.find_data("big")):
        bound = _BOUND.match(str(part.children[0]))
        for symbol in symbols_in(part) if bound and not str(part.children[0]).startswith(r"\int") else ():
            index = bound[1] if bound else ""
            hidden = (each for each in behind(symbol) if has_index(each, index))
            if symbol != index and not has_index(symbol, index) and any(hidden):
                return symbol, index
    return "", ""


def require_no_value(name: str, symbols: Iterable[str], definitions: Collection[str]) -> None:
    """Refuse a sum, an integral or a limit whose index or variable is a letter with a value."""
    bound = re.findall(r"\\[a-zA-Z]+|[a-zA-Z]", re.sub(r"^\\[a-z]+|\^.*$|\\(?:in|to)(?![a-z])", "", name))
    bound += [each[2:] for each in symbols if each.startswith("d ")]
    if defined := [each for each in bound if each in definitions]:
        raise UnreadableError(f"{defined[0]} has a value, but it is also an index or a variable of {name}")


def stands_in(letter: str, symbol: str) -> bool:
    """Whether a letter is a part of a symbol."""
    if "/" in symbol:
        return re.sub(r"[{}]", "", letter) in re.sub(r"[{}]", "", symbol)
    return re.search(rf"(?<![a-zA-Z\\]){re.escape(letter)}(?![a-zA-Z])", symbol) is not None


def speaks_of(symbols: Iterable[str], letter: str) -> bool:
    r"""Whether a letter is one of some symbols, or stands in a derivative or an operator among them.

    Examples
    --------
    >>> [speaks_of([each], "h") for each in ("h", "D h/D t", "\\partialh/\\partialt", "div bold{u}", "d h")]
    [True, True, True, False, True]
    """
    bare = re.sub(VECTOR_STYLE, "bold", letter)
    alone = re.compile(rf"(?<![a-zA-Z\\]){re.escape(bare)}(?![a-zA-Z])")
    return any(
        each == letter
        or (
            (" " in each or "/" in each)
            and alone.search(_DIFFERENTIAL.sub(" ", re.sub(VECTOR_STYLE, "bold", each))) is not None
        )
        for each in symbols
    )


_DIFFERENTIAL = re.compile(r"\\partial|(?<![a-zA-Z\\])d(?=[a-zA-Z\\(])")


def stands_within(letter: str, symbols: Iterable[str]) -> bool:
    """Whether a letter stands in the brackets of a value with a condition, such as ``p(y|x)``."""
    return any(" " in each and stands_in(letter, each) for each in symbols)

r"""Expected values: which letters are those of the operator, and which ones do not change under it.

``\mathbb{E}`` is one in each document.  A plain E is one where words speak of expected values, and of no energy.
"""

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass

from algebroproj_sym.reading.defining.dependence import COUNTED, letters_in
from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.parsing.factors import MEAN
from algebroproj_sym.reading.parsing.grammar import Sides, lone, symbols_in, trees_in
from algebroproj_sym.reading.prose.devices import heard
from algebroproj_sym.reading.prose.phrases import symbols_in_list

_ALWAYS = re.compile(r"\\math(?:bb|ds)\{E\}")
_EXPECTED = heard(r"\b<averages>\b")
_OTHERWISE = heard("<no-average>")
_FORMULA = r"\$([^$]*)\$"
_BE = r"(?:is|are|be|being) (?:(?:an?|the|all|both|now|assumed) )*"
_RANDOM = heard(rf"\b<drawn>\b[^.$]{{0,40}}{_FORMULA}|{_FORMULA} {_BE}[^.$]{{0,30}}\b<drawn>")
_FIXED = heard(
    rf"\b<sure> (?:[a-z]+ ){{0,3}}{_FORMULA}|\bknown (?:[a-z]+ )?matri(?:x|ces) {_FORMULA}|{_FORMULA} {_BE}<sure>\b"
)


@dataclass(frozen=True)
class Averages:
    """What a document says of expected values."""

    operators: frozenset[str] = frozenset()
    """The symbols that stand for the expected value of what is in the bracket behind them."""
    letters: frozenset[tuple[str, str]] = frozenset()
    """The letters that are expected values themselves, each behind its operator."""
    random: frozenset[str] = frozenset()
    """The letters that words call random."""
    within: frozenset[str] = frozenset()
    """The letters that stand in an expected value."""
    fixed: frozenset[str] = frozenset()
    """The letters that words call deterministic, and those up to which sums go."""

    def is_fixed(self, operator: str, symbols: Iterable[str], constants: Collection[str]) -> bool:
        """Whether all of some letters are the same whatever is random, as constants and expected values are."""
        return all(
            (operator, each) in self.letters or (each not in self.random and (each in self.fixed or each in constants))
            for each in symbols
        )

    def counts(self, name: str) -> bool:
        """Whether a sum has as many terms whatever is random."""
        return "infty" not in name and letters_in(name).isdisjoint(self.random | self.within)


def averages_in(equations: Sequence[Sides], words: str) -> Averages:
    """Return what some equations and the words of a document say of expected values."""
    calls = [call for sides in equations for side in sides for call in side.find_data("call")]
    plain = _EXPECTED.search(words) is not None and _OTHERWISE.search(words) is None
    heads = {str(call.children[0]) for call in calls if len(trees_in(trees_in(call)[0])) == 1}
    operators = frozenset(each for each in heads if _is_mean(each, plain=plain))
    means = (trees_in(call)[0] for call in calls if str(call.children[0]) in operators)
    within = frozenset(symbol for each in means for symbol in symbols_in(each)) - operators
    random, fixed = (_named_in(pattern, words) for pattern in (_RANDOM, _FIXED))
    names = (str(each.children[0]) for sides in equations for side in sides for each in side.find_data("big"))
    counts = {match[2] for match in map(COUNTED.fullmatch, names) if match} - within
    return Averages(operators, frozenset(_given_in(equations, operators)), random, within, fixed | counts)


def _named_in(pattern: re.Pattern[str], words: str) -> frozenset[str]:
    return frozenset(
        symbol for found in pattern.findall(words) for each in found if each for symbol in symbols_in_list(each)
    )


def _is_mean(symbol: str, *, plain: bool) -> bool:
    letter = split_symbol(symbol)[0] if " " not in symbol else ""
    return MEAN.fullmatch(letter) is not None and (plain or _ALWAYS.fullmatch(letter) is not None)


def _given_in(equations: Iterable[Sides], operators: frozenset[str]) -> Iterator[tuple[str, str]]:
    """Yield the letters that are a side of an equation with an expected value, each behind its operator."""
    for sides in equations:
        means = {str(side.children[0]) for side in sides if side.data == "call"} & operators
        yield from ((each, letter) for each in means for letter in map(lone, sides) if letter)

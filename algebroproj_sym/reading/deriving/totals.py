r"""Total derivatives from the rates of letters, as that of ``m v`` is ``m \dot v``.

A rate is a derivative that stands in the document.  A letter without one does not change, which is said; so it must be
a constant, unless the formula has the letter itself by which it is derived.
"""

import re
from collections.abc import Iterable, Mapping
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.notation import (
    DOT,
    PARTIAL,
    TOTAL,
    Derivative,
    derivative_in,
    derivatives_among,
    names_in,
    quotient,
    with_dot,
)
from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.deriving.asking import Asked, slope_of
from algebroproj_sym.reading.deriving.rates import ONE, copies_in, rate_of
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in

AT_START = re.compile(r"_\{?0")
_AXIS = re.compile(r"\\(?:mathbf|vec|hat|overrightarrow)\{?(?:\\mathbf\{?)?(?:[ijkxyz]\}*$|e\}*_\{?[xyz123]\}?$)")


def as_dots(asked: Asked) -> Definition | None:
    r"""Return a derivative by t as the letter with dots, as in ``\frac{dx}{dt} = \dot x``."""
    derivative = asked.derivative
    dots = Derivative(DOT, derivative.function, derivative.letters).text
    rate = asked.names.get(dots) if (derivative.sign, derivative.variable) == (TOTAL, "t") else None
    where = "a dot as the derivative by t"
    return Definition(asked.symbol, (), letter_of(rate), where, -1, True) if rate else None


def by_rates(asked: Asked) -> Definition | None:
    """Return a total derivative of what a letter stands for, from the rates of the letters there."""
    derivative = asked.derivative
    given = asked.given(derivative.head if derivative.is_first else asked.above)
    if derivative.sign not in (TOTAL, DOT) or given is None:
        return None
    if given.parameters not in (() if derivative.sign == DOT else (asked.below,), ()):
        return None
    if given.role == "case" and derivative.is_quotient:
        return None
    vocabulary, variable = asked.vocabulary, asked.below
    own = {**rates_in(asked.occurring, variable), variable: ONE}
    try:
        rate, rates, letters = derived(given.tree, own, vocabulary)
    except UnreadableError:
        if derivative.is_quotient and not vocabulary.is_computed(given.tree):
            return None
        rates, letters = own, vocabulary.letters_of(given.tree)
        rate = _by_letters(given, {each: rates[each] for each in sorted(letters & rates.keys())})
    timed, letters = variable in letters, letters - {variable}
    unknown = {each for each in letters - rates.keys() if f"{each}({variable})" not in rates}
    constant = frozenset().union(*(vocabulary.letters_of(letter_of(each)) for each in unknown))
    slopes = {each: slope_of(letter_of(given.symbol), each) for each in constant if each.startswith(DOT)}
    constant -= {each for each, slope in slopes.items() if vocabulary.is_zero(slope)}
    if rate is None or asked.symbol in symbols_in(rate) or not constant.isdisjoint(rates):
        return None
    return asked.made(rate, given, sorted(constant)) if _are_fixed(constant, asked, given, timed=timed) else None


def _are_fixed(letters: frozenset[str], asked: Asked, given: Definition, *, timed: bool) -> bool:
    """Whether letters without a rate may be taken to be fixed in a formula, which may have the variable itself."""
    vocabulary, variable = asked.vocabulary, asked.below
    behind = vocabulary.behind(variable) if variable in vocabulary.definitions else frozenset[str]()
    unknown = any(" " in each or "/" in each or vocabulary.gives_letters(each) for each in letters)
    if unknown or letters & behind or vocabulary.moves_with(letters, variable):
        return False
    if timed:
        by_time = vocabulary.dependence.by_time or asked.derivative.is_quotient
        return by_time or not vocabulary.is_computed(given.tree)
    of_motion = variable == "t" and is_of_motion(asked.occurring) and not any(each.startswith(DOT) for each in letters)
    return of_motion or are_constant(letters, vocabulary)


def _by_letters(given: Definition, rates: Mapping[str, Formula]) -> Formula | None:
    """Return the sum of the derivatives of a letter by others, each times the rate of that."""
    terms: list[Any] = []
    for each, rate in rates.items():
        terms += Token("SIGN", "+"), Tree("run", [slope_of(letter_of(given.symbol), each), Tree("group", [rate])])
    return Tree("sum", terms) if terms else None


def is_of_motion(occurring: frozenset[str]) -> bool:
    r"""Whether a document has derivatives by ``\dot q``: all coordinates have dots, and nothing else changes."""
    partial = (each for each in derivatives_among(occurring) if each.sign == PARTIAL)
    return any(letter.startswith(DOT) for each in partial for letter in each.letters)


def are_constant(letters: Iterable[str], vocabulary: Vocabulary) -> bool:
    """Whether letters are numbers, or said to be constant, or may be fixed though nothing says so.

    What has the index of the start may be, and so may a vector of an axis.
    """
    known, axes_turn = vocabulary.dependence.constant, vocabulary.dependence.axes_turn
    return all(
        each in known
        or AT_START.search(each)
        or (_AXIS.search(each) and not axes_turn)
        or vocabulary.constant(each) is not None
        for each in letters
    )


def rates_in(occurring: frozenset[str], variable: str) -> dict[str, Formula]:
    """Return the letters, and values such as x(t), whose derivatives by a variable stand in a document, with these."""
    found: dict[str, Formula] = {}
    names = names_in(occurring)
    for each in sorted(occurring):
        slope, value = derivative_in(each), f"{each}({variable})"
        if slope is not None and (slope.sign, slope.letters) == (TOTAL, (variable,)):
            higher, dots = Derivative(TOTAL, slope.function, (variable, variable)).text, None
        else:
            higher, dots = quotient(TOTAL, each, variable), names.get(with_dot(each)) if variable == "t" else None
        if (rate := names.get(higher, dots)) is not None:
            found[each] = letter_of(rate)
            if rate == dots:
                of_time: Formula = Tree("call", [Token("CALLEE", rate), Tree("items", [letter_of(variable)])])
                found[value] = of_time
        if (whole := names.get(quotient(TOTAL, value, variable))) is not None:
            found[value] = found[each] = letter_of(whole)
    return found


def derived(
    tree: Formula, rates: Mapping[str, Formula], vocabulary: Vocabulary
) -> tuple[Formula | None, dict[str, Formula], frozenset[str]]:
    """Return the derivative of a formula from rates, also of letters that others give; None if nothing in it changes.

    Beside it are all rates, and the letters of the formula and of those that give others in it.  It raises
    `UnreadableError` as `rate_of` does.
    """
    found, letters = dict(rates), {*symbols_in(tree)}
    copies = dict.fromkeys(found, 1)
    for each in vocabulary.used_in(tree):
        known = each.symbol in found or each.parameters
        if not known and (rate := rate_of(each.tree, found, copies)) is not None:
            found[each.symbol] = Tree("group", [rate])
            copies[each.symbol] = copies_in(each.tree, copies)
            letters.update(each.symbols)
    return rate_of(tree, found, copies), found, frozenset(letters)

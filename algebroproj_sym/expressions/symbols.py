"""Symbols: which names can be written, and what SymPy's assumptions say of the numbers that they stand for.

An assumption is never used in a proof, except that a symbol which is not zero does not vanish: what is proved holds for
more numbers than were asked for.  A point, whether witness or counterexample, must satisfy every assumption.
"""

import re
from collections.abc import Iterable, Mapping
from fractions import Fraction
from functools import cache
from typing import Any

import sympy

from algebroproj_sym.expressions.bounds import MAX_NAME_LENGTH

NAME = re.compile(r"[^\W\d]\w*'*")

_ANY_REAL = sympy.Symbol("x", real=True).assumptions0.items()
_SAMPLES = [Fraction(p, q) for q in (1, 2, 3, 5) for n in range(61) for p in ((n, -n) if n else (0,))]


class SymbolError(ValueError):
    """A symbol cannot be written, stands for no number, or is another one of the same name."""


def is_name(text: str) -> bool:
    """Whether a text is the name of a symbol: a Python identifier, keywords too, with any number of primes.

    Examples
    --------
    >>> [is_name(text) for text in ("lambda", "α", "x'", "x y", "2x", "x+1")]
    [True, True, True, False, False, False]
    """
    return bool(NAME.fullmatch(text)) and text.rstrip("'").isidentifier() and len(text) <= MAX_NAME_LENGTH


def is_plain(symbol: sympy.Symbol) -> bool:
    """Whether a symbol stands for any number, or for any real one."""
    return bool(symbol.assumptions0.items() <= _ANY_REAL)


def admits(symbol: sympy.Symbol, value: Any) -> bool:
    """Whether every assumption about a symbol is known to hold for a number.

    Examples
    --------
    >>> n = sympy.Symbol("n", integer=True)
    >>> admits(n, Fraction(3)), admits(n, Fraction(1, 2)), admits(n, sympy.sqrt(2))
    (True, False, False)
    """
    number = sympy.Rational(value.numerator, value.denominator) if isinstance(value, Fraction) else value
    return all(getattr(number, f"is_{fact}") is holds for fact, holds in symbol.assumptions0.items())


@cache
def values_of(symbol: sympy.Symbol) -> tuple[Fraction, ...]:
    """Return some rational numbers that a symbol can stand for, small ones first."""
    return tuple(dict.fromkeys(value for value in _SAMPLES if admits(symbol, value)))


def assumption(symbol: sympy.Symbol) -> str:
    """Return what is assumed of a symbol, as text.

    Examples
    --------
    >>> assumption(sympy.Symbol("n", positive=True, integer=True, even=False))
    'n is positive, integer, not even'
    """
    given = getattr(symbol, "_assumptions_orig", None) or symbol.assumptions0
    parts = [fact if holds else f"not {fact}" for fact, holds in given.items() if (fact, holds) not in _ANY_REAL]
    return f"{symbol.name} is {', '.join(parts)}"


def assumed(symbols: Iterable[sympy.Symbol], argument: str) -> Mapping[sympy.Symbol, sympy.Symbol]:
    """Return the plain symbol for each of some symbols, in the order of their names.

    It raises `SymbolError` if a name cannot be written, two symbols share a name, or no rational number satisfies the
    assumptions.

    Examples
    --------
    >>> assumed([sympy.Symbol("x", positive=True)], "lhs")
    {x: x}
    >>> assumed([sympy.Symbol("x y")], "lhs")
    Traceback (most recent call last):
    ...
    algebroproj_sym.expressions.symbols.SymbolError: lhs: expected a name such as x, x_1, alpha or x', got 'x y'
    """
    named: dict[str, sympy.Symbol] = {}
    for symbol in sorted(set(symbols), key=lambda symbol: (symbol.name, assumption(symbol), str(symbol))):
        if not is_name(symbol.name):
            raise SymbolError(f"{argument}: expected a name such as x, x_1, alpha or x', got {symbol.name!r}")
        if symbol.name in named:
            raise SymbolError(
                f"{argument}: expected one symbol of the name {symbol.name}, got two with different assumptions"
            )
        if not is_plain(symbol) and not values_of(symbol):
            raise SymbolError(
                f"{argument}: expected symbols for numbers, got one of which no rational number is known "
                f"to satisfy what is assumed: {assumption(symbol)}"
            )
        named[symbol.name] = symbol
    return {symbol: sympy.Symbol(name) for name, symbol in named.items()}

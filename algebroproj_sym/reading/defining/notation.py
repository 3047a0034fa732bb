r"""How derivatives are written: as quotients after Leibniz, with dots after Newton, and with primes after Lagrange.

A derivative is one symbol of a document: ``d^2r/dt^2``, ``\dot{r}`` or ``f''``.  `derivative_in` takes it apart.  The
names in it are bare: they have no braces and no spaces.
"""

import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, lru_cache

from algebroproj_sym.reading.lexing.names import bare_name, split_symbol, written

SIGNS = TOTAL, PARTIAL, DOT, PRIME = "d", r"\partial", r"\dot", "'"
_QUOTIENT = re.compile(r"(d|\\partial|\\delta)(?:\^(\d))?([^/^][^/]*|)/\1([^/]+)")
_DOTS = re.compile(r"\\(d+)ot")


@dataclass(frozen=True)
class Derivative:
    """A derivative, taken apart."""

    sign: str
    r"""How it is written: with ``d``, ``\partial`` or ``\delta`` as a quotient, with dots, or with primes."""
    function: str
    r"""What is derived: ``r``, ``f(x)`` or ``\ln f``; empty in the operator ``d/dx``."""
    letters: tuple[str, ...]
    """The letters by which it is, each as often as it is: t for a dot, and an empty one for a prime."""

    @property
    def variable(self) -> str:
        """The letter by which it is; empty for several."""
        return self.letters[0] if len({*self.letters}) == 1 else ""

    @property
    def head(self) -> str:
        """The function without its arguments."""
        return re.sub(r"\(.*\)$", "", self.function)

    @property
    def is_quotient(self) -> bool:
        """Whether it is a total or a partial derivative, written as a quotient."""
        return self.sign in (TOTAL, PARTIAL)

    @property
    def is_first(self) -> bool:
        """Whether it is such a quotient of first order."""
        return self.is_quotient and len(self.letters) == 1

    @property
    def text(self) -> str:
        r"""How it is written.

        Examples
        --------
        >>> Derivative("d", "r", ("t", "t")).text, Derivative(r"\dot", "r", ("t", "t")).text
        ('d^2r/dt^2', '\\ddotr')
        """
        order = len(self.letters)
        if not order:
            return self.function
        if self.sign == DOT:
            return rf"\{'d' * order}ot{self.function}"
        if self.sign == PRIME:
            return self.function + PRIME * order
        times = {each: self.letters.count(each) for each in self.letters}
        below = "".join(f"{self.sign}{each}{_raised(count)}" for each, count in times.items())
        return f"{self.sign}{_raised(order)}{self.function}/{below}"

    @property
    def lower(self) -> tuple[str, ...]:
        """The function and its derivatives of lower orders, as they are written."""
        return tuple(replace(self, letters=self.letters[:order]).text for order in range(len(self.letters)))


def _raised(times: int) -> str:
    return f"^{times}" if times > 1 else ""


def quotient(sign: str, function: str, letter: str) -> str:
    """Return how a first derivative is written as a quotient."""
    return f"{sign}{bare(function)}/{sign}{bare(letter)}"


@cache
def derivative_in(symbol: str) -> Derivative | None:
    r"""Return the derivative that a symbol is, or an operator such as ``d/dx``; None if it is none.

    Examples
    --------
    >>> derivative_in(r"\partial^2f/\partial{x}\partial y")
    Derivative(sign='\\partial', function='f', letters=('x', 'y'))
    >>> derivative_in(r"\mathbf{\ddot r}_1").text, derivative_in("f_1''").letters, derivative_in("x/y")
    ('\\ddot\\mathbfr_1', ('', ''), None)
    """
    name = bare(symbol)
    if "/" in symbol:
        match = _QUOTIENT.fullmatch(name)
        letters = _letters(match[1], int(match[2] or 1), match[4]) if match else ()
        return Derivative(match[1], match[3], letters) if match and letters else None
    if PRIME in symbol:
        letter, primes, below, above = split_symbol(symbol)
        return Derivative(PRIME, bare(written(letter, 0, below, above)), ("",) * primes) if primes else None
    dots = _DOTS.match(name)
    return Derivative(DOT, name[dots.end() :], ("t",) * len(dots[1])) if dots else None


def _letters(sign: str, order: int, below: str) -> tuple[str, ...]:
    """Return the letters below the line of a derivative, each as often as it is; none if they are not so many."""
    if order == 1:
        return (below,)
    parts = [each.partition("^") for each in (below.split(sign) if sign == PARTIAL else [below])]
    if any(times and not times.isdigit() for *_, times in parts):
        return ()
    found = tuple(letter for letter, _, times in parts for _ in range(int(times or 1)))
    return found if len(found) == order else ()


@cache
def bare(symbol: str) -> str:
    r"""Return a symbol without braces and spaces, with its dots first, and with primes as such."""
    first = re.sub(r"\\mathbf\\(d*dot)", r"\\\1\\mathbf", bare_name(symbol))
    return re.sub(r"\^(?:\\prime)+", lambda primes: PRIME * primes[0].count("p"), first)


def by_bare(symbols: Iterable[str]) -> dict[str, str]:
    """Return symbols by their bare names."""
    return {bare(each): each for each in symbols}


@lru_cache(maxsize=16)
def names_in(occurring: frozenset[str]) -> Mapping[str, str]:
    """Return the symbols of a document by their bare names."""
    return by_bare(sorted(occurring))


def with_dot(symbol: str) -> str:
    r"""Return the bare name of the derivative by time, ``\ddotx`` of ``\dot{x}``."""
    name = bare(symbol)
    return rf"\d{name[1:]}" if _DOTS.match(name) else rf"{DOT}{name}"


def is_rate_of_one(symbol: str, letters: Iterable[str]) -> bool:
    """Whether a letter with dots is the derivative of one of some letters."""
    found = derivative_in(symbol)
    return found is not None and found.sign == DOT and not {*map(bare, letters)}.isdisjoint(found.lower)


def order_of(symbol: str, letter: str, variable: str) -> int | None:
    r"""Return how often a letter is derived by a variable in a symbol; None if the symbol is none of its derivatives.

    Examples
    --------
    >>> order_of(r"\dot{x}", "x", "t"), order_of("d^2y/dx^2", "y", "x"), order_of("x_1", "x", "t")
    (1, 2, None)
    """
    if bare(symbol) == bare(letter):
        return 0
    found = derivative_in(symbol)
    if found is None or found.sign == PARTIAL or bare(letter) not in found.lower:
        return None
    by = found.letters[found.lower.index(bare(letter)) :]
    return len(by) if {*by} <= {"", bare(variable)} else None


@lru_cache(maxsize=16)
def derivatives_among(occurring: frozenset[str]) -> Sequence[Derivative]:
    """Return the derivatives among the symbols of a document."""
    return [each for each in map(derivative_in, sorted(occurring)) if each is not None]


@lru_cache(maxsize=16)
def _derived_in(occurring: frozenset[str]) -> Collection[tuple[str, str]]:
    """Return what the derivatives among some symbols are of, and by which letters."""
    found = derivatives_among(occurring)
    whole = {(name, letter) for each in found for name in (each.function, each.head) for letter in each.letters}
    return whole.union(*(zip(each.lower, each.letters, strict=True) for each in found))


def has_rate(letter: str, variable: str, occurring: frozenset[str]) -> bool:
    """Whether a document has a derivative of a letter by a variable, also as dots where that is the time."""
    return (bare(letter), bare(variable)) in _derived_in(occurring)


def change(letters: Iterable[str], variable: str, occurring: frozenset[str], sign: str = TOTAL) -> bool:
    """Whether a document has a derivative of some letter, by a variable, or by time, or with a prime.

    The time does not matter to a partial derivative by another letter.
    """
    by = (variable, "t", "") if sign != PARTIAL or variable == "t" else (variable,)
    return any(has_rate(each, letter, occurring) for each in letters for letter in by)

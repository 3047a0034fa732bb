r"""Reading the expressions of a ledger: restricted grammars, read without evaluating anything.

Statements are rational expressions; their text shows every division::

    sum      = product { ("+" | "-") product }
    product  = factor { ("*" | "/") factor }
    factor   = ("-" | "+") factor | atom [ "**" exponent ]
    atom     = integer | name | "(" sum ")"
    exponent = factor                                                       of numbers alone, an integer

Certificates are polynomials with integer coefficients: there is no ``/``, and an exponent is a natural number.

A form is an expression, a matrix ``Matrix([[..., ...], ...])`` or factors ``(..., ...)``.
"""

import re
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import gcd
from typing import Any, NamedTuple

from algebroproj_sym.replaying.rejection import NotReplayable, Rejected, require

_TOKEN = re.compile(r" *(?:([0-9]+)|([^\W\d]\w*'*)|(\*\*|[-+*/(),\[\]]))")
_NAME = re.compile(r"[^\W\d]\w*'*")
_DECIMAL = re.compile(r"(?<![\w.])(?=[0-9]|\.[0-9])([0-9]*)\.([0-9]*)")
_NUMBER = re.compile(r"(-?)(0|[1-9][0-9]*)(?:/([1-9][0-9]*))?")
DEPTH = 200
LARGEST_EXPONENT = 10**6
MOST_DIGITS = 4000


class Operation(NamedTuple):
    """``number``, ``symbol``, or ``+ - * / ^`` of the results of earlier operations."""

    kind: str
    value: Any
    operands: tuple[int, ...]


@dataclass(frozen=True)
class Form:
    """A scalar, matrix or list of factors: its operations, each once, and the places of its entries among them."""

    shape: tuple[int, ...]
    operations: tuple[Operation, ...]
    entries: tuple[int, ...]

    def symbols(self) -> set[str]:
        """Return the names of all symbols."""
        return {operation.value for operation in self.operations if operation.kind == "symbol"}

    def entry(self, place: int) -> Operation:
        """Return the last operation of an entry."""
        return self.operations[self.entries[place]]


def parse(text: Any) -> Form:
    """Read an expression or a matrix; it raises `Rejected` if the text is not of the grammar.

    Examples
    --------
    >>> parse("Matrix([[x, 1/2], [0, -x**2]])").shape
    (2, 2)
    >>> parse("__import__('os')")
    Traceback (most recent call last):
    ...
    algebroproj_sym.replaying.rejection.Rejected: expected an expression, got "__import__('os')"
    """
    return _Reader(text).form()


def parse_polynomial(text: Any) -> Form:
    """Read a polynomial with integer coefficients, or a matrix of them.

    Examples
    --------
    >>> parse_polynomial("2*x**2 - y").symbols() == {"x", "y"}
    True
    >>> parse_polynomial("x/2")
    Traceback (most recent call last):
    ...
    algebroproj_sym.replaying.rejection.Rejected: expected a polynomial with integer coefficients, got "x/2"
    """
    return _Reader(text, polynomial=True).form()


def parse_statement(text: Any) -> Form:
    """Read a side, a constraint or a condition of an identity from elsewhere, as it was given.

    There are also ``^``, decimal numbers, ``[[..., ...], ...]`` for a matrix, and one ``=``, which is a difference.

    Examples
    --------
    >>> parse_statement("x^2 = 0.5").entry(0).kind, parse_statement("[[x, 1]]").shape
    ('+', (1, 2))
    """
    if not isinstance(text, str):
        raise Rejected(f"expected an expression or an equation as text, got {text!r}")
    plain = re.sub(r"[\t\n]", " ", text).replace("^", "**")
    left, equal, right = _DECIMAL.sub(_exact, plain).partition("=")
    if equal:
        require(not parse(left).shape and not parse(right).shape, "expected scalars on both sides of =")
    whole = f"({left}) - ({right})" if equal else left.strip()
    return parse(f"Matrix({whole})" if whole.startswith("[") else whole)


def _exact(match: re.Match[str]) -> str:
    whole, part = match.groups()
    digits = (part or "").rstrip("0")
    return f"({whole}{digits}/1{'0' * len(digits)})" if digits else f"({whole or '0'})"


def parse_factors(text: Any) -> Form:
    """Read factors in parentheses.

    Examples
    --------
    >>> parse_factors("(x, x + 1)").shape, parse_factors("(x,)").shape
    ((2,), (1,))
    """
    return _Reader(text).factors()


_ALIKE = str.maketrans("ΑΒΕΖΗΙΚΜΝΟΡΤΥΧονАВЕКМНОРСТУХЅІЈаеорсухѕіј", "ABEZHIKMNOPTYXovABEKMHOPCTYXSIJaeopcyxsij")


def require_distinct(text: str) -> None:
    """Reject a text with names that look alike, such as a Latin and a Greek o."""
    found = {*_NAME.findall(text)}
    require(
        len({unicodedata.normalize("NFKC", name).translate(_ALIKE) for name in found}) == len(found),
        "two names look alike",
    )


def is_name(text: str) -> bool:
    """Return whether a text is the name of a number, with nothing around it.

    Examples
    --------
    >>> is_name("x1"), is_name("x + y"), is_name(" x"), is_name("pi")
    (True, False, False, True)
    """
    return _NAME.fullmatch(text) is not None


def number(text: Any) -> Fraction:
    """Read a rational number in lowest terms, such as -3/4.

    Examples
    --------
    >>> number("-3/4")
    Fraction(-3, 4)
    """
    match = _NUMBER.fullmatch(text) if isinstance(text, str) else None
    if match is not None and text != "-0":
        sign, above, below = match.group(1), _natural(match.group(2)), _natural(match.group(3) or "1")
        if gcd(above, below) == 1 and match.group(3) != "1":
            return Fraction(-above if sign else above, below)
    raise Rejected(f"expected a rational number in lowest terms, got {text!r}")


def texts(value: Any) -> list[str]:
    """Return a list of texts; anything else is rejected."""
    listed = isinstance(value, list | tuple) and all(isinstance(text, str) for text in value)
    require(listed, f"expected a list of texts, got {value!r:.80}")
    return list(value)


def numbers(value: Any) -> list[Fraction]:
    """Read a list of rational numbers."""
    return [*map(number, texts(value))]


def integer(value: Any) -> int:
    """Return an integer; a truth value or a decimal number is none."""
    require(type(value) is int, f"expected an integer, got {value!r:.80}")
    return int(value)


def natural(value: Any) -> int:
    """Return a natural number."""
    require(integer(value) >= 0, "expected a whole number that is not negative")
    return int(value)


def decimal(text: Any) -> tuple[Fraction, Fraction]:
    """Read a decimal number: its value and the unit of its last digit.

    Examples
    --------
    >>> decimal("-0.50")
    (Fraction(-1, 2), Fraction(1, 100))
    """
    if not isinstance(text, str) or not re.fullmatch(r"-?[0-9]+(\.[0-9]+)?", text):
        raise Rejected(f"expected a decimal number, got {text!r}")
    return Fraction(text), Fraction(1, 10 ** len(text.partition(".")[2]))


def _natural(digits: str) -> int:
    """Read a natural number of any length."""
    if len(digits) <= MOST_DIGITS:
        return int(digits)
    half = len(digits) // 2
    shift: int = 10**half
    return _natural(digits[:-half]) * shift + _natural(digits[-half:])


class _Reader:
    def __init__(self, text: Any, polynomial: bool = False) -> None:
        self.expected = "a polynomial with integer coefficients" if polynomial else "an expression"
        if not isinstance(text, str):
            raise Rejected(f"expected the text of {self.expected}, got {text!r}")
        self.text = text
        self.polynomial = polynomial
        self.operations: list[Operation] = []
        self.places: dict[Operation, int] = {}
        self.tokens = self._tokens()
        self.place = 0
        self.depth = 0

    def form(self) -> Form:
        if self.tokens[:3] == ["Matrix", "(", "["]:
            self.place = 1
            rows = self.matrix()
            require(len({len(row) for row in rows}) == 1, f"expected rows of one length, got {self.shown}")
            shape: tuple[int, ...] = (len(rows), len(rows[0]))
            entries = [entry for row in rows for entry in row]
        else:
            shape, entries = (), [self.sum()]
        return self.ended(shape, entries)

    def factors(self) -> Form:
        found = self.sequence("(", ")")
        return self.ended((len(found),), found)

    def ended(self, shape: tuple[int, ...], entries: Sequence[int]) -> Form:
        if self.tokens[self.place]:
            raise self.wrong()
        return Form(shape, tuple(self.operations), tuple(entries))

    def _tokens(self) -> list[str]:
        tokens, start, text = [], 0, self.text.rstrip(" ")
        while start < len(text):
            match = _TOKEN.match(text, start)
            if match is None:
                raise self.wrong()
            tokens.append(match[match.lastindex or 0])
            start = match.end()
        return [*tokens, ""]

    @property
    def shown(self) -> str:
        return self.text if len(self.text) < 80 else f"{self.text[:77]}..."

    def wrong(self) -> Rejected:
        return Rejected(f'expected {self.expected}, got "{self.shown}"')

    def enter(self, kind: str, value: Any, *operands: int) -> int:
        """Return the place of an operation, which is entered if it is new."""
        operation = Operation(kind, value, operands)
        if operation not in self.places:
            self.places[operation] = len(self.operations)
            self.operations.append(operation)
        return self.places[operation]

    def skip(self, token: str) -> bool:
        found = self.tokens[self.place] == token
        self.place += found
        return found

    def expect(self, token: str) -> None:
        if not self.skip(token):
            raise self.wrong()

    def matrix(self) -> list[list[int]]:
        self.expect("(")
        self.expect("[")
        rows = [self.sequence("[", "]")]
        while self.skip(","):
            rows.append(self.sequence("[", "]"))
        self.expect("]")
        self.expect(")")
        return rows

    def sequence(self, opening: str, closing: str) -> list[int]:
        self.expect(opening)
        found = [self.sum()]
        while self.skip(","):
            if self.tokens[self.place] == closing:
                break
            found.append(self.sum())
        self.expect(closing)
        return found

    def sum(self) -> int:
        self.depth += 1
        if self.depth > DEPTH:
            raise NotReplayable("the expression is nested too deeply")
        terms = [self.product()]
        while self.tokens[self.place] in ("+", "-"):
            minus = self.skip("-") or not self.skip("+")
            term = self.product()
            terms.append(self.enter("-", None, term) if minus else term)
        self.depth -= 1
        return terms[0] if len(terms) == 1 else self.enter("+", None, *terms)

    def product(self) -> int:
        result = self.factor()
        while self.tokens[self.place] in ("*", "/"):
            divided = self.skip("/") or not self.skip("*")
            if divided and self.polynomial:
                raise self.wrong()
            result = self.enter("/" if divided else "*", None, result, self.factor())
        return result

    def factor(self) -> int:
        minus = False
        while self.tokens[self.place] in ("-", "+"):
            minus ^= self.skip("-") or not self.skip("+")
        atom = self.atom()
        if self.skip("**"):
            atom = self.enter("^", self.exponent(), atom)
        return self.enter("-", None, atom) if minus else atom

    def exponent(self) -> int:
        if self.polynomial and not self.tokens[self.place].isdecimal():
            raise self.wrong()
        value = self.constant(self.factor())
        if value is None or value.denominator != 1:
            raise self.wrong()
        if abs(value) > LARGEST_EXPONENT:
            raise NotReplayable(f"an exponent exceeds {LARGEST_EXPONENT}")
        return value.numerator

    def constant(self, place: int) -> Fraction | None:
        """Return the value of an exponent, which is written with numbers, signs, sums, products and powers."""
        kind, value, operands = self.operations[place]
        parts = [self.constant(operand) for operand in operands]
        known = [part for part in parts if part is not None]
        if kind in ("symbol", "/") or len(known) < len(parts):
            return None
        if kind == "^":
            small = abs(known[0]) <= LARGEST_EXPONENT and 0 <= value <= 20
            return known[0] ** value if small else None
        if kind == "number":
            return Fraction(value)
        return -known[0] if kind == "-" else sum(known, Fraction(0)) if kind == "+" else known[0] * known[1]

    def atom(self) -> int:
        token = self.tokens[self.place]
        self.place += 1
        if token.isdecimal():
            return self.enter("number", _natural(token))
        if token == "(":
            inner = self.sum()
            self.expect(")")
            return inner
        if not token.rstrip("'").isidentifier():
            raise self.wrong()
        return self.enter("symbol", token)

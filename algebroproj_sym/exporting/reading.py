r"""Reading the formulas of a ledger: the exporter's own reader, which shares nothing with that of the replay.

A form is an expression, a matrix ``Matrix([[..., ...], ...])`` or factors ``(..., ...)``.  Operators wait on a stack
until one that binds less tightly comes; nothing is evaluated, and no division is lost.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from algebroproj_sym.exporting.refusal import NotExportable
from algebroproj_sym.exporting.terms import Term, integer, name, negative, power, product, quotient, total

_TOKEN = re.compile(r"\s*(?:([0-9]+)|([^\W\d]\w*)|(\*\*|[-+*/(),\[\]]))")
_BINDS = {"(": 0, "+": 1, "-": 1, "*": 2, "/": 2, "sign": 3, "**": 4}
LARGEST_EXPONENT = 100_000
LONGEST_NUMBER = 4_000


@dataclass(frozen=True)
class Form:
    """A scalar, matrix or list of factors: its shape, and its entries row by row."""

    shape: tuple[int, ...]
    entries: tuple[Term, ...]


def form(text: Any) -> Form:
    """Read an expression, a matrix or factors.

    It raises `NotExportable` if the text is none.

    Examples
    --------
    >>> form("Matrix([[x, 1/2], [0, -x**2]])").shape, form("(x, x + 1)").shape, form("(x)").shape
    ((2, 2), (2,), ())
    >>> form("x) *) Axiom evil : False. (*")
    Traceback (most recent call last):
    ...
    algebroproj_sym.exporting.refusal.NotExportable: expected a formula, got 'x) *) Axiom evil : False. (*'
    """
    tokens = _tokens(text)
    if tokens[:3] == ["Matrix", "(", "["] and tokens[-2:] == ["]", ")"]:
        rows = [_listed(row, "[", "]", text) for row in _apart(tokens[3:-2], text)]
        if len({len(row) for row in rows}) > 1:
            raise _wrong(text)
        return Form((len(rows), len(rows[0]) if rows else 0), tuple(entry for row in rows for entry in row))
    if tokens[:1] == ["("] and tokens[-1:] == [")"] and "," in tokens:
        factors = tuple(_listed(tokens, "(", ")", text))
        return Form((len(factors),), factors)
    return Form((), (_expression(tokens, text),))


def formula_of(text: Any) -> Term:
    """Read an expression."""
    found = form(text)
    if found.shape:
        raise _wrong(text)
    return found.entries[0]


def symbol(text: Any) -> str:
    """Read a name.

    Examples
    --------
    >>> symbol("mu1")
    'mu1'
    """
    if not isinstance(text, str) or not re.fullmatch(r"[^\W\d]\w*", text):
        raise NotExportable(f"expected a name, got {_shown(text)}")
    return text


def natural(value: Any) -> int:
    """Read a natural number of a certificate."""
    if type(value) is not int or not 0 <= value <= LARGEST_EXPONENT:
        raise NotExportable(f"expected a natural number up to {LARGEST_EXPONENT}, got {_shown(value)}")
    return value


def rational(text: Any) -> Fraction:
    """Read a rational number.

    Examples
    --------
    >>> rational("-3/4")
    Fraction(-3, 4)
    """
    if not isinstance(text, str) or not re.fullmatch(r"-?[0-9]{1,4000}(/[0-9]{1,4000})?", text):
        raise NotExportable(f"expected a rational number, got {_shown(text)}")
    above, _, below = text.partition("/")
    if below and not int(below):
        raise NotExportable(f"expected a rational number, got {_shown(text)}")
    return Fraction(int(above), int(below or 1))


def decimal(text: Any) -> tuple[Fraction, Fraction]:
    """Read a decimal number: its value and the unit of its last digit.

    Examples
    --------
    >>> decimal("-0.50")
    (Fraction(-1, 2), Fraction(1, 100))
    """
    if not isinstance(text, str) or not re.fullmatch(r"-?[0-9]{1,1000}(\.[0-9]{1,1000})?", text):
        raise NotExportable(f"expected a decimal number, got {_shown(text)}")
    unit = 10 ** len(text.partition(".")[2])
    return Fraction(int(text.replace(".", "")), unit), Fraction(1, unit)


def _tokens(text: Any) -> list[str]:
    if not isinstance(text, str):
        raise _wrong(text)
    tokens, start, end = [], 0, len(text.rstrip())
    while start < end:
        match = _TOKEN.match(text, start)
        if match is None:
            raise _wrong(text)
        tokens.append(match.group().strip())
        start = match.end()
    return tokens


def _apart(tokens: Sequence[str], text: Any) -> list[list[str]]:
    """Return what stands between the commas that are in no parentheses; a comma may end the list."""
    parts: list[list[str]] = [[]]
    depth = 0
    for token in tokens:
        depth += (token in "([") - (token in ")]")
        if depth < 0:
            raise _wrong(text)
        if token == "," and depth == 0:
            parts.append([])
        else:
            parts[-1].append(token)
    return parts if parts[-1] else parts[:-1]


def _listed(tokens: Sequence[str], opening: str, closing: str, text: Any) -> list[Term]:
    if len(tokens) < 3 or tokens[0] != opening or tokens[-1] != closing:
        raise _wrong(text)
    return [_expression(part, text) for part in _apart(tokens[1:-1], text)]


def _expression(tokens: Sequence[str], text: Any) -> Term:
    operands: list[Term] = []
    operators: list[str] = []
    wanted = True
    for token in tokens:
        if wanted and token in "+-":
            operators.append("sign" if token == "-" else "plus")
        elif wanted and token == "(":
            operators.append(token)
        elif wanted and (token[0].isalnum() or token[0] == "_"):
            operands.append(_atom(token, text))
            wanted = False
        elif not wanted and token == ")":
            while operators and operators[-1] != "(":
                _apply(operands, operators.pop(), text)
            if not operators:
                raise _wrong(text)
            operators.pop()
        elif not wanted and token in ("+", "-", "*", "/", "**"):
            while operators and _waits_less(operators[-1], token):
                _apply(operands, operators.pop(), text)
            operators.append(token)
            wanted = True
        else:
            raise _wrong(text)
    if wanted:
        raise _wrong(text)
    while operators:
        _apply(operands, operators.pop(), text)
    (found,) = operands
    return found


def _waits_less(waiting: str, token: str) -> bool:
    """Whether an operator that waits binds its operand before one that comes; powers are read from the right."""
    ranks = _BINDS | {"plus": _BINDS["sign"]}
    return ranks[waiting] > ranks[token] or (ranks[waiting] == ranks[token] and token != "**")


def _atom(token: str, text: Any) -> Term:
    if token[0] in "0123456789":
        if len(token) > LONGEST_NUMBER:
            raise NotExportable(f"a number has more than {LONGEST_NUMBER} digits")
        return integer(int(token))
    return name(token)


def _apply(operands: list[Term], operator: str, text: Any) -> None:
    if operator in ("(",):
        raise _wrong(text)
    if operator in ("sign", "plus"):
        if operator == "sign":
            operands.append(negative(operands.pop()))
        return
    right, left = operands.pop(), operands.pop()
    if operator == "**":
        operands.append(power(left, _exponent(right)))
    elif operator == "*":
        operands.append(_signed_product(left, right))
    elif operator == "/":
        operands.append(quotient(left, right))
    else:
        operands.append(
            total([*(left.parts if left.kind == "+" else [left]), right if operator == "+" else negative(right)])
        )


def _exponent(term: Term) -> int:
    sign, inner = (-1, term.parts[0]) if term.kind == "-" else (1, term)
    if inner.kind != "int":
        raise NotExportable("expected an integer as an exponent")
    return sign * natural(inner.value)


def _signed_product(left: Term, right: Term) -> Term:
    """Return a product whose sign, if it is one of its first factor, is written in front of it."""
    if left.kind == "-":
        inner = left.parts[0]
        return negative(right if (inner.kind, inner.value) == ("int", 1) else _signed_product(inner, right))
    return product([*(left.parts if left.kind == "*" else [left]), right])


def _wrong(text: Any) -> NotExportable:
    return NotExportable(f"expected a formula, got {_shown(text)}")


def _shown(value: Any) -> str:
    shown = ascii(value)
    return shown if len(shown) < 80 else f"{shown[:77]}..."

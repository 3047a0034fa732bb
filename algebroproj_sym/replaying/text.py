r"""Reading the expressions of a ledger: a restricted grammar, read without evaluating anything.

::

    sum      = product { ("+" | "-") product }
    product  = factor { ("*" | "/") factor }
    factor   = ("-" | "+") factor | atom [ "**" exponent ]
    atom     = integer | name | "$" integer | "(" sum ")"
    exponent = factor                                                       of numbers alone, an integer

A form is an expression, a matrix ``Matrix([[..., ...], ...])`` or factors ``(..., ...)``.  ``$3`` is the fourth step
of a form that is written in steps.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from algebroproj_sym.replaying.rejection import NotReplayable, Rejected

_TOKEN = re.compile(r"\s*(?:(\d+)|([A-Za-z_]\w*)|(\$\d+)|(\*\*|[-+*/(),\[\]]))")
_DECIMAL = re.compile(r"(?<![\w.])(\d*)\.(\d*)")
DEPTH = 400
LARGEST_EXPONENT = 1000


@dataclass(frozen=True, eq=False)
class Node:
    """A node of an expression: number, symbol, step, or an operation on other nodes."""

    kind: str
    value: Any = None
    children: tuple[Node, ...] = ()


@dataclass(frozen=True, eq=False)
class Form:
    """A scalar, matrix or list of factors: its shape, its entries row by row, and the steps they are written in."""

    shape: tuple[int, ...]
    entries: tuple[Node, ...]
    steps: tuple[Node, ...] = ()

    def symbols(self) -> set[str]:
        """Return the names of all symbols."""
        return {node.value for node in _nodes((*self.steps, *self.entries)) if node.kind == "symbol"}


def _nodes(roots: Sequence[Node]) -> Iterator[Node]:
    waiting = list(roots)
    while waiting:
        node = waiting.pop()
        yield node
        waiting += node.children


def parse(text: Any) -> Form:
    """Read an expression or a matrix.

    Raises
    ------
    Rejected
        If the text is not of the grammar.

    Examples
    --------
    >>> parse("Matrix([[x, 1/2], [0, -x**2]])").shape
    (2, 2)
    >>> parse("__import__('os')")
    Traceback (most recent call last):
    ...
    algebroproj_sym.replaying.rejection.Rejected: expected an expression, got "__import__('os')"
    """
    reader = _Reader(text)
    if reader.skip("Matrix"):
        rows = reader.matrix()
        if len({len(row) for row in rows}) > 1:
            raise Rejected(f"expected rows of one length, got {text!r}")
        form = Form((len(rows), len(rows[0]) if rows else 0), tuple(entry for row in rows for entry in row))
    else:
        form = Form((), (reader.sum(),))
    reader.end()
    return form


def parse_statement(text: Any) -> Form:
    """Read a side, a constraint or a condition of an identity from elsewhere, as it was given.

    There are also ``^``, decimal numbers, ``[[..., ...], ...]`` for a matrix, and one ``=``, which is a difference.

    Examples
    --------
    >>> parse_statement("x^2 = 0.5").entries[0].kind, parse_statement("[[x, 1]]").shape
    ('+', (1, 2))
    """
    if not isinstance(text, str):
        raise Rejected(f"expected the text of a statement, got {text!r}")
    if "'" in text:
        raise NotReplayable("names with primes are not read")
    left, equal, right = _DECIMAL.sub(_exact, text.replace("^", "**")).partition("=")
    whole = f"({left}) - ({right})" if equal else left.strip()
    return parse(f"Matrix({whole})" if whole.startswith("[") else whole)


def _exact(match: re.Match[str]) -> str:
    whole, part = match.groups()
    return f"({int(whole + part or '0')}/{10 ** len(part)})"


def parse_factors(text: Any) -> Form:
    """Read factors in parentheses.

    Examples
    --------
    >>> parse_factors("(x, x + 1)").shape, parse_factors("(x,)").shape
    ((2,), (1,))
    """
    reader = _Reader(text)
    factors = reader.sequence("(", ")")
    reader.end()
    return Form((len(factors),), tuple(factors))


def parse_steps(steps: Any, entries: Any, shape: tuple[int, ...]) -> Form:
    """Read a form that is written in steps."""
    if not isinstance(steps, list) or not isinstance(entries, list):
        raise Rejected("expected lists of steps and entries")
    form = Form(shape, tuple(map(_expression, entries)), tuple(map(_expression, steps)))
    for place, step in enumerate((*form.steps, *form.entries)):
        known = min(place, len(form.steps))
        if any(node.kind == "step" and node.value >= known for node in _nodes([step])):
            raise Rejected("a step refers to one that does not come before it")
    return form


def _expression(text: Any) -> Node:
    reader = _Reader(text)
    node = reader.sum()
    reader.end()
    return node


def number(text: Any) -> Fraction:
    """Read a rational number such as -3/4.

    Examples
    --------
    >>> number("-3/4")
    Fraction(-3, 4)
    """
    if not isinstance(text, str) or not re.fullmatch(r"-?\d+(/[1-9]\d*)?", text) or str(Fraction(text)) != text:
        raise Rejected(f"expected a rational number in lowest terms, got {text!r}")
    return Fraction(text)


def decimal(text: Any) -> tuple[Fraction, Fraction]:
    """Read a decimal number: its value and the unit of its last digit.

    Examples
    --------
    >>> decimal("-0.50")
    (Fraction(-1, 2), Fraction(1, 100))
    """
    if not isinstance(text, str) or not re.fullmatch(r"-?\d+(\.\d+)?", text):
        raise Rejected(f"expected a decimal number, got {text!r}")
    return Fraction(text), Fraction(1, 10 ** len(text.partition(".")[2]))


class _Reader:
    def __init__(self, text: Any) -> None:
        if not isinstance(text, str):
            raise Rejected(f"expected the text of an expression, got {text!r}")
        self.text = text
        self.tokens = self._tokens()
        self.place = 0
        self.depth = 0

    def _tokens(self) -> list[str]:
        tokens, start, text = [], 0, self.text.rstrip()
        while start < len(text):
            match = _TOKEN.match(text, start)
            if match is None:
                raise self.wrong()
            tokens.append(match.group().strip())
            start = match.end()
        return [*tokens, ""]

    def wrong(self) -> Rejected:
        shown = self.text if len(self.text) < 80 else f"{self.text[:77]}..."
        return Rejected(f'expected an expression, got "{shown}"')

    def skip(self, token: str) -> bool:
        found = self.tokens[self.place] == token
        self.place += found
        return found

    def expect(self, token: str) -> None:
        if not self.skip(token):
            raise self.wrong()

    def end(self) -> None:
        if self.tokens[self.place]:
            raise self.wrong()

    def matrix(self) -> list[list[Node]]:
        self.expect("(")
        self.expect("[")
        rows = [self.sequence("[", "]")]
        while self.skip(","):
            rows.append(self.sequence("[", "]"))
        self.expect("]")
        self.expect(")")
        return rows

    def sequence(self, opening: str, closing: str) -> list[Node]:
        self.expect(opening)
        found = [self.sum()]
        while self.skip(","):
            if self.tokens[self.place] == closing:
                break
            found.append(self.sum())
        self.expect(closing)
        return found

    def sum(self) -> Node:
        self.depth += 1
        if self.depth > DEPTH:
            raise Rejected("the expression is nested too deeply")
        terms = [self.product()]
        while self.tokens[self.place] in ("+", "-"):
            minus = self.skip("-") or not self.skip("+")
            terms.append(_negative(self.product()) if minus else self.product())
        self.depth -= 1
        return terms[0] if len(terms) == 1 else Node("+", None, tuple(terms))

    def product(self) -> Node:
        result = self.factor()
        while self.tokens[self.place] in ("*", "/"):
            divided = self.skip("/") or not self.skip("*")
            right = self.factor()
            if divided and result.kind == right.kind == "number" and right.value:
                result = Node("number", result.value / right.value)
            else:
                result = Node("/" if divided else "*", None, (result, right))
        return result

    def factor(self) -> Node:
        if self.skip("-"):
            return _negative(self.factor())
        if self.skip("+"):
            return self.factor()
        atom = self.atom()
        return Node("^", self.exponent(), (atom,)) if self.skip("**") else atom

    def exponent(self) -> int:
        value = _constant(self.factor())
        if value is None or value.denominator != 1:
            raise self.wrong()
        return _bounded(int(value))

    def integer(self) -> int:
        token = self.tokens[self.place]
        if not token.isdecimal():
            raise self.wrong()
        self.place += 1
        return int(token)

    def atom(self) -> Node:
        token = self.tokens[self.place]
        if token.isdecimal():
            return Node("number", Fraction(self.integer()))
        self.place += 1
        if token == "(":
            inner = self.sum()
            self.expect(")")
            return inner
        if token.startswith("$"):
            return Node("step", int(token[1:]))
        if not token.isidentifier():
            raise self.wrong()
        return Node("symbol", token)


def _negative(node: Node) -> Node:
    if node.kind == "number":
        return Node("number", -node.value)
    return Node("-", None, (node,))


def _bounded(exponent: int) -> int:
    if abs(exponent) > LARGEST_EXPONENT:
        raise NotReplayable(f"an exponent exceeds {LARGEST_EXPONENT}")
    return exponent


def _constant(node: Node) -> Fraction | None:
    """Return the value of an exponent, which is written with numbers, signs, sums, products and powers."""
    if node.kind == "number":
        return Fraction(node.value)
    parts = [_constant(child) for child in node.children]
    values = [part for part in parts if part is not None]
    if not parts or len(values) < len(parts) or node.kind == "/":
        return None
    if node.kind == "^":
        return values[0] ** node.value if values[0] else None
    if node.kind == "-":
        return -values[0]
    return sum(values, Fraction(0)) if node.kind == "+" else values[0] * values[1]

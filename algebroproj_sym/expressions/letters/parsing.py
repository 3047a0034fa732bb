"""Text that stands for vectors and matrices: the grammar of expressions, with letters and functions of them.

::

    sum      = product {("+" | "-") product}
    product  = sign {("*" | "/") sign}
    sign     = {"+" | "-"} power
    power    = atom places [("**" | "^") ["-"] integer places]
    places   = {".T" | "[" integer "," integer "]"}
    atom     = number | name | function "(" sum {"," sum} ")" | "(" sum ")" | "eye(" size ")"
             | "zeros(" size "," size ")" | "block(" row {"," row} ")"
    row      = "[" sum {"," sum} "]"

Which names are letters, with their shapes, is given; other names are numbers.
"""

import re
from collections.abc import Mapping
from fractions import Fraction
from math import prod

from algebroproj_sym.expressions.bounds import MAX_CHARACTERS, MAX_DIGITS, MAX_NESTING
from algebroproj_sym.expressions.letters.terms import (
    FUNCTIONS,
    LetterError,
    Shape,
    Size,
    Term,
    made,
    number,
    require_no_number,
)

_TOKEN = re.compile(r"\s*(?:([0-9]+(?:\.[0-9]+)?)|([^\W\d]\w*'*)|(\*\*|\.T\b|[-+*/^()\[\],]))")


def parse_letters(text: str, letters: Mapping[str, Shape], argument: str = "text") -> Term:
    """Read a term from text.

    It raises `LetterError` if the text is not of the grammar, or parts do not fit.

    Examples
    --------
    >>> parse_letters("R.T*R", {"R": (3, 3)}).shape
    (3, 3)
    >>> parse_letters("R + t", {"R": (3, 3), "t": (2, 1)}, "t")
    Traceback (most recent call last):
    ...
    algebroproj_sym.expressions.letters.terms.LetterError: t: sum: expected terms of one shape, got shapes 3x3 and 2x1
    """
    if not isinstance(text, str) or len(text) > MAX_CHARACTERS:
        raise LetterError(f"{argument}: expected text of at most {MAX_CHARACTERS} characters, got {text!r:.80}")
    try:
        return _Parser(text, letters).whole()
    except LetterError as error:
        raise LetterError(f"{argument}{'' if str(error).startswith(',') else ': '}{error}") from None


class _Parser:
    def __init__(self, text: str, letters: Mapping[str, Shape]) -> None:
        self.letters = letters
        self.tokens: list[tuple[str, int]] = []
        start = 0
        while text[start:].strip():
            match = _TOKEN.match(text, start)
            if match is None or len(match[0]) > MAX_DIGITS:
                raise LetterError(f", position {start}: expected a number, a name or an operator, got {text[start]!r}")
            self.tokens.append((match[match.lastindex or 0], match.start(match.lastindex or 0)))
            start = match.end()
        self.tokens.append(("", len(text)))
        self.place = 0
        self.depth = 0

    def whole(self) -> Term:
        term = self.sum()
        if self.next:
            raise self.wrong("an operator")
        return term

    @property
    def next(self) -> str:
        return self.tokens[self.place][0]

    def take(self, *tokens: str) -> str:
        found = self.next
        if found not in tokens:
            return ""
        self.place += 1
        return found

    def expect(self, token: str) -> None:
        if not self.take(token):
            raise self.wrong(repr(token))

    def wrong(self, expected: str) -> LetterError:
        token, position = self.tokens[self.place]
        return LetterError(f", position {position}: expected {expected}, got {repr(token) if token else 'the end'}")

    def sum(self) -> Term:
        self.depth += 1
        if self.depth > MAX_NESTING:
            raise self.wrong(f"at most {MAX_NESTING} levels of nesting")
        terms = [self.product()]
        while sign := self.take("+", "-"):
            term = self.product()
            terms.append(_negative(term) if sign == "-" else term)
        self.depth -= 1
        return terms[0] if len(terms) == 1 else made("sum", *terms)

    def product(self) -> Term:
        factors = [self.sign()]
        while operator := self.take("*", "/"):
            factor = self.sign()
            if operator == "/":
                if factor.shape != (1, 1):
                    raise self.wrong("a number as divisor before this place")
                if factor == number(0):
                    raise self.wrong("a divisor that is not zero before this place")
                factor = number(1 / factor.value) if _is_number(factor) else made("power", factor, value=-1)
            factors.append(factor)
        if len(factors) > 1 and all(map(_is_number, factors)):
            return number(prod(factor.value for factor in factors))
        return factors[0] if len(factors) == 1 else made("product", *factors)

    def sign(self) -> Term:
        minus = False
        while sign := self.take("+", "-"):
            minus ^= sign == "-"
        return _negative(self.power()) if minus else self.power()

    def power(self) -> Term:
        base = self.places(self.atom())
        if not self.take("**", "^"):
            return base
        minus = self.take("-")
        exponent = self.integer()
        return self.places(made("power", base, value=-exponent if minus else exponent))

    def integer(self) -> int:
        if not self.next.isdecimal():
            raise self.wrong("an integer")
        self.place += 1
        return int(self.tokens[self.place - 1][0])

    def places(self, term: Term) -> Term:
        while found := self.take(".T", "["):
            if found == ".T":
                term = made("transpose", term)
                continue
            row = self.integer()
            self.expect(",")
            term = made("entry", term, value=(row, self.integer()))
            self.expect("]")
        return term

    def atom(self) -> Term:
        token = self.next
        if token[:1].isdigit():
            self.place += 1
            return number(Fraction(token))
        if self.take("("):
            inside = self.sum()
            self.expect(")")
            return inside
        if not token.rstrip("'").isidentifier():
            raise self.wrong("a number, a name or '('")
        self.place += 1
        if not self.take("("):
            return Term("letter", self.letters[token], (), token) if token in self.letters else _symbol(token)
        if token in ("eye", "zeros"):
            sizes = [self.size()]
            while self.take(","):
                sizes.append(self.size())
            self.expect(")")
            if len(sizes) != (1 if token == "eye" else 2):
                raise self.wrong(f"the sizes of {token} before this place")
            return made(token, value=tuple(sizes))
        term = self.block() if token == "block" else self.function(token)
        self.expect(")")
        return term

    def size(self) -> Size:
        token = self.next
        if not token.isidentifier():
            return self.integer()
        self.place += 1
        return token

    def function(self, name: str) -> Term:
        if name not in FUNCTIONS:
            raise LetterError(f"expected one of the functions {', '.join(sorted(FUNCTIONS))}, got {name!r}")
        arguments = [self.sum()]
        while self.take(","):
            arguments.append(self.sum())
        return made(name, *arguments)

    def block(self) -> Term:
        rows = [self.row()]
        while self.take(","):
            rows.append(self.row())
        return made("block", *(part for row in rows for part in row), value=tuple(map(len, rows)))

    def row(self) -> list[Term]:
        self.expect("[")
        parts = [self.sum()]
        while self.take(","):
            parts.append(self.sum())
        self.expect("]")
        return parts


def _symbol(name: str) -> Term:
    require_no_number(name)
    return Term("symbol", (1, 1), (), name)


def _is_number(term: Term) -> bool:
    return term.kind == "number"


def _negative(term: Term) -> Term:
    return number(-term.value) if _is_number(term) else made("product", number(-1), term)

"""Text that stands for a rational expression: a small grammar, read by hand, bounded in time and memory.

::

    matrix   = "[[" sum {"," sum} "]" {"," "[" sum {"," sum} "]"} "]"      also "Matrix(" matrix ")"
    sum      = product {("+" | "-") product}
    product  = sign {("*" | "/") sign}
    sign     = {"+" | "-"} power
    power    = atom [("**" | "^") sign]                                     the exponent is a constant integer
    atom     = number | name | "(" sum ")"
    zero     = sum ["=" sum]                                                what `parse_zero` reads

A number is an integer or a decimal, and a decimal is the exact rational it writes (``0.1`` is 1/10).  A name is any
identifier with any number of primes (``x'``); none has a meaning of its own: E, I, S, beta, gamma and lambda are
symbols.  There is no implicit multiplication and there are no functions.  Nothing is evaluated as a program.

Divisions are kept as `over`, and where one occurs sums and products are not evaluated either, so that ``1/x - 1/x``
still has the pole it was written with.
"""

import re
from dataclasses import dataclass

import sympy

from algebroproj_sym.expressions.bounds import (
    MAX_CHARACTERS,
    MAX_DIGITS,
    MAX_EXPONENT,
    MAX_NAME_LENGTH,
    MAX_NAMES,
    MAX_NESTING,
    MAX_TOKENS,
    ONE,
    VARIABLE,
    Extent,
    number,
    power,
    product,
    quotient,
    total,
)
from algebroproj_sym.expressions.grammar import Expression
from algebroproj_sym.expressions.quotient import over
from algebroproj_sym.expressions.symbols import NAME

_TOKEN = re.compile(r"\s*(?:([0-9]+(?:\.[0-9]*)?|\.[0-9]+)|(\*\*|[-+*/^()\[\],=]))")
_NAME = re.compile(rf"\s*({NAME.pattern})")
_MATRIX = re.compile(r"\A\s*Matrix\s*\(\s*\[")
_OPERATOR = "an operator"


class ParseError(ValueError):
    """A text is not an expression of the grammar, or is larger than it may be.

    Attributes
    ----------
    position : int
        Where, counted in characters from 0.
    expected, got : str
        What was expected there, and what was found.
    """

    def __init__(self, position: int, expected: str, got: str, argument: str = "text") -> None:
        super().__init__(f"{argument}, position {position}: expected {expected}, got {got}")
        self.position = position
        self.expected = expected
        self.got = got


def names_in(text: str) -> set[str]:
    """Return the names that occur in a text of the grammar, also those that cancel.

    Examples
    --------
    >>> sorted(names_in("Matrix([[x + y - y, z']])"))
    ['x', 'y', "z'"]
    """
    return {*_NAME.findall(_MATRIX.sub("[", text, count=1))}


@dataclass(frozen=True)
class _Token:
    kind: str
    text: str
    position: int


@dataclass(frozen=True)
class _Value:
    """An expression with bounds on what it becomes when it is multiplied out."""

    expression: sympy.Expr
    extent: Extent

    @property
    def divided(self) -> bool:
        return self.extent.divided


def parse(text: str, argument: str = "text") -> Expression:
    """Read an expression, or a matrix of expressions, from text.

    Parameters
    ----------
    text : str
        In the grammar of this module.
    argument : str
        The name of the text in error messages.

    Returns
    -------
    sympy.Expr or sympy.ImmutableDenseMatrix

    Raises
    ------
    ParseError
        If the text is not in the grammar, divides by the number zero, or is too large: longer than
        `MAX_CHARACTERS`, more than `MAX_TOKENS` tokens or `MAX_NAMES` names, nested deeper than `MAX_NESTING`,
        an integer of more than `MAX_DIGITS` digits, an exponent beyond `MAX_EXPONENT`, or, multiplied out, a degree
        beyond `MAX_DEGREE`, coefficients beyond `MAX_BITS` bits or a power or product of more than `MAX_TERMS` terms.

    Examples
    --------
    >>> parse("(x^2 - 1)/(x - 1)")
    over(x**2 - 1, x - 1)
    >>> parse("0.1*E + 1/3")
    E/10 + 1/3
    >>> parse("[[a, b'], [0, -2**-1]]")
    Matrix([
    [a,   b'],
    [0, -1/2]])
    >>> parse("2x")
    Traceback (most recent call last):
    ...
    algebroproj_sym.expressions.parsing.ParseError: text, position 1: expected an operator, got 'x'
    """
    if not isinstance(text, str):
        raise TypeError(f"{argument}: expected text, got {type(text).__name__}")
    return _Parser(text, argument).whole()


def parse_zero(text: str, argument: str = "text") -> sympy.Expr:
    """Return the scalar expression that a text says is zero: an expression, or left minus right of an equation.

    The arguments and the errors are those of `parse`; the text may contain one ``=``.

    Examples
    --------
    >>> parse_zero("x^2 + y^2 = 1")
    x**2 + y**2 - 1
    """
    if not isinstance(text, str):
        raise TypeError(f"{argument}: expected text, got {type(text).__name__}")
    return _Parser(text, argument).zero()


class _Parser:
    def __init__(self, text: str, argument: str) -> None:
        self._argument = argument
        self._symbols: dict[str, sympy.Symbol] = {}
        self._tokens = self._scan(text)
        self._place = 0
        self._depth = 0

    def whole(self) -> Expression:
        result = self._matrix() if self._starts_matrix() else self._sum().expression
        if self._next.kind != "end":
            raise self._unexpected(_OPERATOR)
        return result

    def zero(self) -> sympy.Expr:
        start = self._next.position
        value = self._sum()
        if self._take("="):
            value = self._added([value, self._negative(self._sum())], start)
        if self._next.kind != "end":
            raise self._unexpected(_OPERATOR)
        return value.expression

    # -- tokens

    def _scan(self, text: str) -> list[_Token]:
        if len(text) > MAX_CHARACTERS:
            raise self._error(MAX_CHARACTERS, f"at most {MAX_CHARACTERS} characters", f"{len(text)}")
        tokens: list[_Token] = []
        place, end = 0, len(text.rstrip())
        while place < end:
            match = _NAME.match(text, place) or _TOKEN.match(text, place)
            if match is None or (match.re is _NAME and not match.group(1).rstrip("'").isidentifier()):
                while text[place].isspace():
                    place += 1
                raise self._error(place, "a number, a name, an operator or a bracket", repr(text[place]))
            found = match.group(match.lastindex or 0)
            kind = "name" if match.re is _NAME else "number" if match.lastindex == 1 else found
            tokens.append(_Token(kind, found, match.end() - len(found)))
            self._check_token(tokens)
            place = match.end()
        return [*tokens, _Token("end", "the end", end)]

    def _check_token(self, tokens: list[_Token]) -> None:
        token = tokens[-1]
        if len(tokens) > MAX_TOKENS:
            raise self._error(token.position, f"at most {MAX_TOKENS} tokens", "more")
        if token.kind == "number" and len(token.text) > MAX_DIGITS:
            raise self._error(token.position, f"at most {MAX_DIGITS} digits", f"{len(token.text)}")
        if token.kind != "name":
            return
        if len(token.text) > MAX_NAME_LENGTH:
            raise self._error(token.position, f"a name of at most {MAX_NAME_LENGTH} characters", f"{len(token.text)}")
        if token.text not in self._symbols:
            self._symbols[token.text] = sympy.Symbol(token.text)
            if len(self._symbols) > MAX_NAMES:
                raise self._error(token.position, f"at most {MAX_NAMES} names", "more")

    @property
    def _next(self) -> _Token:
        return self._tokens[self._place]

    def _take(self, *kinds: str) -> _Token | None:
        token = self._next
        if token.kind not in kinds:
            return None
        self._place += 1
        return token

    def _require(self, kind: str, expected: str) -> None:
        if not self._take(kind):
            raise self._unexpected(expected)

    def _unexpected(self, expected: str) -> ParseError:
        token = self._next
        shown = token.text if token.kind == "end" else repr(token.text[:40])
        return self._error(token.position, expected, shown)

    def _error(self, position: int, expected: str, got: str) -> ParseError:
        return ParseError(position, expected, got, self._argument)

    # -- matrices

    def _starts_matrix(self) -> bool:
        kinds = [token.kind for token in self._tokens[:3]]
        return kinds[0] == "[" or (self._next.text == "Matrix" and kinds[1:] == ["(", "["])

    def _matrix(self) -> Expression:
        wrapped = self._take("name") and self._take("(")
        start = self._next.position
        self._require("[", "'['")
        rows = [self._row()]
        while self._take(","):
            rows.append(self._row())
        self._require("]", "',' or ']'")
        if wrapped:
            self._require(")", "')'")
        if len({len(row) for row in rows}) > 1:
            raise self._error(start, "rows of one length", f"lengths {sorted({len(row) for row in rows})}")
        return sympy.ImmutableDenseMatrix(rows)

    def _row(self) -> list[sympy.Expr]:
        self._require("[", "a row in brackets")
        entries = [self._sum().expression]
        while self._take(","):
            entries.append(self._sum().expression)
        self._require("]", "',' or ']'")
        return entries

    # -- scalars

    def _sum(self) -> _Value:
        start = self._next.position
        parts = [self._product()]
        while sign := self._take("+", "-"):
            part = self._product()
            parts.append(self._negative(part) if sign.kind == "-" else part)
        return parts[0] if len(parts) == 1 else self._added(parts, start)

    def _product(self) -> _Value:
        start = self._next.position
        above, below = [self._sign()], list[_Value]()
        while operator := self._take("*", "/"):
            position = self._next.position
            factor = self._sign()
            if operator.kind == "*":
                above.append(factor)
            else:
                self._require_nonzero(factor, position)
                below.append(factor)
        top = self._multiplied(above, start)
        return self._quotient(top, self._multiplied(below, start), start) if below else top

    def _sign(self) -> _Value:
        minus = False
        while sign := self._take("+", "-"):
            minus ^= sign.kind == "-"
        value = self._power()
        return self._negative(value) if minus else value

    def _power(self) -> _Value:
        start = self._next.position
        base = self._atom()
        if not self._take("**", "^"):
            return base
        position = self._next.position
        self._enter()
        exponent = self._sign().expression
        self._depth -= 1
        if not isinstance(exponent, sympy.Integer):
            raise self._error(position, "an integer as exponent", str(exponent)[:40])
        if abs(int(exponent)) > MAX_EXPONENT:
            raise self._error(position, f"an exponent of at most {MAX_EXPONENT}", str(exponent)[:40])
        if exponent < 0:
            self._require_nonzero(base, start)
        return self._raised(base, int(exponent), start)

    def _atom(self) -> _Value:
        token = self._next
        if self._take("number"):
            read = _number(token.text)
            return _Value(read, number(read))
        if self._take("name"):
            return _Value(self._symbols[token.text], Extent(VARIABLE))
        if self._take("("):
            self._enter()
            inside = self._sum()
            self._require(")", "an operator or ')'")
            self._depth -= 1
            return inside
        raise self._unexpected("a number, a name or '('")

    def _enter(self) -> None:
        self._depth += 1
        if self._depth > MAX_NESTING:
            raise self._error(self._next.position, f"at most {MAX_NESTING} levels of nesting", "more")

    def _require_nonzero(self, value: _Value, position: int) -> None:
        if value.expression.is_Integer and int(value.expression) == 0:
            raise self._error(position, "a divisor that is not zero", "0")

    # -- building, never larger than allowed

    def _negative(self, value: _Value) -> _Value:
        if value.divided:
            expression = sympy.Mul(sympy.Integer(-1), value.expression, evaluate=False)
        else:
            expression = -value.expression
        return _Value(expression, value.extent)

    def _added(self, parts: list[_Value], position: int) -> _Value:
        extent = total([part.extent for part in parts], len(self._symbols))
        self._check(extent, position)
        expression = sympy.Add(*(part.expression for part in parts), evaluate=not extent.divided)
        return _Value(expression, extent)

    def _multiplied(self, parts: list[_Value], position: int) -> _Value:
        if len(parts) == 1:
            return parts[0]
        extent = product([part.extent for part in parts], len(self._symbols))
        self._check(extent, position)
        expression = sympy.Mul(*(part.expression for part in parts), evaluate=not extent.divided)
        return _Value(expression, extent)

    def _quotient(self, top: _Value, bottom: _Value, position: int) -> _Value:
        self._require_nonzero(bottom, position)
        extent = quotient(top.extent, bottom.extent, len(self._symbols))
        self._check(extent, position)
        if bottom.expression.is_Rational:
            expression = sympy.Mul(top.expression, 1 / bottom.expression, evaluate=not top.divided)
            return _Value(expression, Extent(extent.above, top.extent.below, top.divided))
        return _Value(over(top.expression, bottom.expression), extent)

    def _raised(self, base: _Value, exponent: int, position: int) -> _Value:
        extent = power(base.extent, abs(exponent), len(self._symbols))
        self._check(extent, position)
        raised = _Value(sympy.Pow(base.expression, abs(exponent), evaluate=not base.divided), extent)
        return raised if exponent >= 0 else self._quotient(_Value(sympy.Integer(1), Extent(ONE)), raised, position)

    def _check(self, extent: Extent, position: int) -> None:
        excess = extent.excess()
        if excess is not None:
            raise self._error(position, *excess)


def _number(text: str) -> sympy.Rational:
    whole, _, decimals = text.partition(".")
    return sympy.Rational(int((whole + decimals) or "0"), 10 ** len(decimals))

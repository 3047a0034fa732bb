"""Terms with real functions: read from text into a tree in which nothing is evaluated, and written back.

::

    sum      = product {("+" | "-") product}
    product  = sign {("*" | "/") sign}
    sign     = {"+" | "-"} power
    power    = atom [("**" | "^") sign]
    atom     = number | name | function "(" sum {"," sum} ")" | "(" sum ")"

``pi`` is the number.  A power has a rational exponent, or is ``exp(b*log(a))``.  A derivative is
``diff(f, x)``, or ``diff(f, x, 2, y)`` for one of higher order.  An integral is ``integrate(f, x)``, or
``integrate(f, (x, a, b))``; it is in no other integral, and in no derivative.  ``taylor(f, x, n)``, or
``taylor(f, (x, y), n)``, is f up to degree n in x, or in x and y together, about zero; f has no derivative in it.
``re``, ``im``, ``conjugate`` and ``arg`` are for statements about complex numbers.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any, NamedTuple

from algebroproj_sym.replaying.rejection import Rejected, require

MOST_TOKENS = 4_000
MOST_CHARACTERS = 40_000
MOST_DIGITS = 400
MOST_LEVELS = 48
MOST_FACTORS = 100
LARGEST_EXPONENT = 100
MOST_DERIVATIVES = 12

_TOKEN = re.compile(r"\s*(?:([0-9]+(?:\.[0-9]*)?|\.[0-9]+)|([^\W\d]\w*'*)|(\*\*|[-+*/^(),]))")

ALIASES = {
    "Abs": "abs",
    "ln": "log",
    "arcsin": "asin",
    "arccos": "acos",
    "arctan": "atan",
    "arctan2": "atan2",
    "arcsec": "asec",
    "arccsc": "acsc",
    "arsinh": "asinh",
    "arcosh": "acosh",
    "artanh": "atanh",
    "sgn": "sign",
    "Derivative": "diff",
    "Integral": "integrate",
}
ONE = (
    "sqrt abs sign exp log sin cos tan cot sec csc asin acos atan asec acsc "
    "sinh cosh tanh coth sech csch asinh acosh atanh acoth asech acsch"
)
ARITY = dict.fromkeys(ONE.split(), 1) | {"atan2": 2}
CALCULUS = frozenset({"diff", "integrate", "taylor"})
COMPLEX = frozenset({"re", "im", "conjugate", "arg"})
FUNCTIONS = frozenset({*ARITY, *ALIASES, *CALCULUS, *COMPLEX})


_CALL = re.compile(rf"(?<![\w'])(?:{'|'.join(sorted(FUNCTIONS))})\s*\(")
_PART = re.compile(rf"(?<![\w'])(?:{'|'.join(sorted(COMPLEX))})\s*\(")
_POWER = re.compile(r"(?:\*\*|\^)\s*[-+]?\s*(?:\(|[^\W\d]|[0-9]*\.)")


def has_functions(text: str) -> bool:
    """Whether a text has a function, or a power whose exponent may not be an integer.

    Examples
    --------
    >>> [has_functions(text) for text in ("sin (x)", "x^(1/2)", "x*y^2", "f(x)")]
    [True, True, False, False]
    """
    return bool(_CALL.search(text) or _POWER.search(text))


def has_parts(text: str) -> bool:
    """Whether a text has a real or imaginary part, a conjugate or an argument of a complex number.

    Examples
    --------
    >>> has_parts("conjugate(z)*z"), has_parts("I*z")
    (True, False)
    """
    return bool(_PART.search(text))


class UnreadableError(Rejected):
    """A text is not a term: where, what was expected there, and what was found."""

    def __init__(self, position: int, expected: str, got: str) -> None:
        super().__init__(f"position {position}: expected {expected}, got {got}")
        self.position, self.expected, self.got = position, expected, got


class Term(NamedTuple):
    """A number, a symbol, an operation, or a function of terms.

    The kind is ``number``, ``symbol``, ``+ * / -``, ``^`` with a rational exponent, ``diff`` by a symbol, ``integrate``
    over a symbol, perhaps from one term to another, ``taylor`` with symbols and a degree, or the name of a function.
    """

    kind: str
    value: Any = None
    args: tuple[Term, ...] = ()

    def symbols(self) -> frozenset[str]:
        """Return the names that occur, but not the variable of an integral from one term to another."""
        if self.kind == "integrate" and len(self.args) == 3:
            inside, *ends = (part.symbols() for part in self.args)
            return (inside - {self.value}).union(*ends)
        own = frozenset[str]()
        if self.kind in _NAMING:
            own = frozenset(self.value[0] if self.kind == "taylor" else [self.value])
        return own.union(*(part.symbols() for part in self.args))

    def parts(self) -> Iterator[Term]:
        """Yield it and all terms in it."""
        yield self
        for part in self.args:
            yield from part.parts()

    def size(self) -> int:
        """Return the number of its parts."""
        return 1 + sum(part.size() for part in self.args)

    def integrals(self) -> Iterator[Term]:
        """Yield the integrals in it."""
        return (part for part in self.parts() if part.kind == "integrate")

    def order(self) -> int:
        """Return how many derivatives are within one another."""
        return (self.kind == "diff") + max((part.order() for part in self.args), default=0)


_NAMING = CALCULUS | {"symbol"}
PI = Term("pi")


def constant(value: Fraction | int) -> Term:
    """Return a number as a term."""
    return Term("number", Fraction(value))


ONE_HALF = constant(Fraction(1, 2))


def power(base: Term, exponent: Fraction | int) -> Term:
    """Return a power with a rational exponent."""
    return Term("^", Fraction(exponent), (base,))


def function(name: str, *args: Term) -> Term:
    """Return a function of terms."""
    return Term(name, None, args)


def negative(term: Term) -> Term:
    """Return minus a term."""
    return Term("-", None, (term,))


def plus(*terms: Term) -> Term:
    """Return a sum."""
    return Term("+", None, terms)


def times(left: Term, right: Term) -> Term:
    """Return a product."""
    return Term("*", None, (left, right))


def over(above: Term, below: Term) -> Term:
    """Return a quotient."""
    return Term("/", None, (above, below))


def read(text: Any) -> Term:
    """Read a term; what is no text of one is rejected.

    Examples
    --------
    >>> read("sqrt(x^2)").kind, written(read("2*sin(x)^2/3 - x**(1/2)"))
    ('sqrt', '2*sin(x)**2/3 - x**(1/2)')
    >>> read("sin x")
    Traceback (most recent call last):
    ...
    algebroproj_sym.replaying.reals.terms.UnreadableError: position 4: expected '(', got 'x'
    """
    require(isinstance(text, str), "expected the text of a term")
    return _Reader(text).whole()


class _Reader:
    def __init__(self, text: str) -> None:
        if len(text) > MOST_CHARACTERS:
            raise UnreadableError(MOST_CHARACTERS, f"at most {MOST_CHARACTERS} characters", str(len(text)))
        self.tokens = [*_tokens(text), ("end", "the end", len(text.rstrip()))]
        if len(self.tokens) > MOST_TOKENS:
            raise UnreadableError(self.tokens[MOST_TOKENS][2], f"at most {MOST_TOKENS} tokens", "more")
        self.place = self.depth = 0

    def whole(self) -> Term:
        found = self.sum()
        if self.tokens[self.place][0] != "end":
            raise self.wrong("an operator")
        return found

    def wrong(self, expected: str) -> UnreadableError:
        kind, text, position = self.tokens[self.place]
        return UnreadableError(position, expected, text if kind == "end" else repr(text[:40]))

    def take(self, *texts: str) -> str:
        kind, text, _ = self.tokens[self.place]
        if kind != "operator" or text not in texts:
            return ""
        self.place += 1
        return text

    def expect(self, text: str) -> None:
        if not self.take(text):
            raise self.wrong(repr(text))

    def inner(self, part: Callable[[], Term]) -> Term:
        self.depth += 1
        if self.depth > MOST_LEVELS:
            raise self.wrong(f"at most {MOST_LEVELS} levels of nesting")
        found = part()
        self.depth -= 1
        return found

    def sum(self) -> Term:
        parts = [self.product()]
        while sign := self.take("+", "-"):
            part = self.product()
            parts.append(negative(part) if sign == "-" else part)
        return parts[0] if len(parts) == 1 else plus(*parts)

    def product(self) -> Term:
        found, count = self.sign(), 1
        while operator := self.take("*", "/"):
            count += 1
            if count > MOST_FACTORS:
                raise self.wrong(f"at most {MOST_FACTORS} factors")
            found = (times if operator == "*" else over)(found, self.sign())
        return found

    def sign(self) -> Term:
        minus = False
        while sign := self.take("+", "-"):
            minus ^= sign == "-"
        found = self.power()
        return negative(found) if minus else found

    def power(self) -> Term:
        base = self.atom()
        if not self.take("**", "^"):
            return base
        where = self.place
        exponent = self.inner(self.sign)
        value = _rational(exponent)
        if value is None:
            return function("exp", times(exponent, function("log", base)))
        if max(abs(value.numerator), value.denominator) > LARGEST_EXPONENT:
            self.place = where
            raise self.wrong(f"an exponent of numbers up to {LARGEST_EXPONENT}")
        return power(base, value)

    def atom(self) -> Term:
        kind, text, _ = self.tokens[self.place]
        self.place += kind in ("number", "name")
        if kind == "number":
            whole, _, decimals = text.partition(".")
            return constant(Fraction(int(whole + decimals or "0"), 10 ** len(decimals)))
        if kind == "name":
            return PI if text == "pi" else self.application(text) if text in FUNCTIONS else Term("symbol", text)
        self.place -= kind in ("number", "name")
        if self.take("("):
            found = self.inner(self.sum)
            self.expect(")")
            return found
        raise self.wrong("a number, a name or '('")

    def application(self, name: str) -> Term:
        name = ALIASES.get(name, name)
        self.expect("(")
        args = [self.inner(self.sum)]
        if name in CALCULUS:
            if any(args[0].integrals()):
                raise self.wrong(f"no integral inside {name}")
            return {"diff": self.derivative, "integrate": self.integral, "taylor": self.expansion}[name](args[0])
        while len(args) < ARITY.get(name, 1):
            self.expect(",")
            args.append(self.inner(self.sum))
        self.expect(")")
        return function(name, *args)

    def integral(self, whole: Term) -> Term:
        self.expect(",")
        between = self.take("(")
        name = self.symbol("a symbol over which to integrate")
        ends = []
        for _ in range(2 if between else 0):
            self.expect(",")
            ends.append(self.inner(self.sum))
            if any(ends[-1].integrals()) or name in ends[-1].symbols():
                raise self.wrong("an end without the variable and without integrals")
        if between:
            self.expect(")")
        self.expect(")")
        return Term("integrate", name, (whole, *ends))

    def symbol(self, expected: str) -> str:
        kind, name, _ = self.tokens[self.place]
        if kind != "name" or name == "pi" or name in FUNCTIONS:
            raise self.wrong(expected)
        self.place += 1
        return name

    def expansion(self, whole: Term) -> Term:
        if CALCULUS & {part.kind for part in whole.parts()}:
            raise self.wrong("no derivative and no expansion inside taylor")
        self.expect(",")
        several = self.take("(")
        names = [self.symbol("a symbol in which to expand")]
        while several and self.take(","):
            names.append(self.symbol("a symbol in which to expand"))
        if several:
            self.expect(")")
        self.expect(",")
        kind, text, _ = self.tokens[self.place]
        if kind != "number" or not text.isdecimal() or len(text) > 2 or int(text) > MOST_DERIVATIVES:
            raise self.wrong(f"a degree from 0 to {MOST_DERIVATIVES}")
        self.place += 1
        self.expect(")")
        return Term("taylor", (tuple(dict.fromkeys(names)), int(text)), (whole,))

    def derivative(self, found: Term) -> Term:
        count, whole = found.order(), found
        while self.take(","):
            name, order = self.symbol("a symbol by which to differentiate"), 1
            kind, text, _ = self.tokens[self.place + 1]
            if self.tokens[self.place][1] == "," and kind == "number":
                order = int(text) if text.isdecimal() and len(text) < 3 else 0
                self.place += 2
            count += order
            if not 0 < order <= count <= MOST_DERIVATIVES:
                self.place -= 1
                raise self.wrong(f"an order from 1 to {MOST_DERIVATIVES}")
            for _ in range(order):
                found = Term("diff", name, (found,))
        if found is whole:
            raise self.wrong("','")
        self.expect(")")
        return found


def _tokens(text: str) -> Iterator[tuple[str, str, int]]:
    place, end = 0, len(text.rstrip())
    while place < end:
        match = _TOKEN.match(text, place)
        if match is None or (match.lastindex == 2 and not match[2].rstrip("'").isidentifier()):
            place += len(text[place:]) - len(text[place:].lstrip())
            raise UnreadableError(place, "a number, a name, an operator or a bracket", repr(text[place]))
        found = match[match.lastindex or 0]
        if match.lastindex == 1 and len(found) > MOST_DIGITS:
            raise UnreadableError(match.end() - len(found), f"at most {MOST_DIGITS} digits", str(len(found)))
        yield ("number", "name", "operator")[(match.lastindex or 1) - 1], found, match.end() - len(found)
        place = match.end()


def _rational(term: Term) -> Fraction | None:
    """Return the value of an exponent that is written with numbers, signs, sums, products and quotients."""
    if term.kind == "number":
        return Fraction(term.value)
    parts = [_rational(part) for part in term.args] if term.kind in ("+", "-", "*", "/") else [None]
    known = [part for part in parts if part is not None]
    if len(known) < len(parts):
        return None
    if term.kind == "+":
        return sum(known, Fraction(0))
    if term.kind == "-":
        return -known[0]
    if term.kind == "/" and known[1] == 0:
        return None
    return known[0] * known[1] if term.kind == "*" else known[0] / known[1]


def written(term: Term) -> str:
    """Return a term as text that is read as the same term."""
    return _written(term)[0]


def _written(term: Term) -> tuple[str, int]:
    """Return the text, and how strongly it holds together: 1 sum, 2 product, 3 sign, 4 power, 5 atom."""
    if term.kind == "number":
        value = term.value
        return str(value), 5 if value >= 0 and value.denominator == 1 else 2 if value >= 0 else 1
    if term.kind in ("symbol", "pi"):
        return term.value or "pi", 5
    if term.kind == "+":
        first, *others = term.args
        text = _within(first, 2)
        for part in others:
            minus = part.kind == "-"
            text += f" - {_within(part.args[0], 3)}" if minus else f" + {_within(part, 3)}"
        return text, 1
    if term.kind == "-":
        return f"-{_within(term.args[0], 4)}", 2
    if term.kind in ("*", "/"):
        return f"{_within(term.args[0], 2)}{term.kind}{_within(term.args[1], 4)}", 2
    if term.kind == "^":
        exponent = str(term.value)
        plain = term.value.denominator == 1 and term.value >= 0
        return f"{_within(term.args[0], 5)}**{exponent if plain else f'({exponent})'}", 4
    if term.kind == "integrate":
        whole, *ends = map(written, term.args)
        over = f"({', '.join([term.value, *ends])})" if ends else term.value
        return f"integrate({whole}, {over})", 5
    if term.kind == "taylor":
        names, degree = term.value
        symbols = names[0] if len(names) == 1 else f"({', '.join(names)})"
        return f"taylor({written(term.args[0])}, {symbols}, {degree})", 5
    by = f", {term.value}" if term.kind == "diff" else ""
    return f"{term.kind}({', '.join(map(written, term.args))}{by})", 5


def _within(term: Term, level: int) -> str:
    text, own = _written(term)
    if level == 3:  # after a sign a product needs none, and another sign does
        return text if own >= 2 and not text.startswith("-") else f"({text})"
    return text if own >= level else f"({text})"

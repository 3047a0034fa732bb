"""Reading statements in letters: a tree, each part with its shape.

::

    sum     = product {("+" | "-") product}
    product = signed {("*" | "/") signed}
    signed  = {"+" | "-"} power
    power   = atom places [("**" | "^") ["-"] integer places]
    places  = {".T" | "[" integer "," integer "]"}

An atom is a number, a name, a sum in parentheses, or a function of some; ``eye`` and ``zeros`` have sizes, and
``block`` has rows in brackets.
"""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction
from math import prod
from typing import Any, NamedTuple, TypeAlias

from algebroproj_sym.replaying.rejection import NotReplayable, Rejected, require

Size: TypeAlias = int | str
Shape: TypeAlias = tuple[Size, Size]
NUMBER: Shape = (1, 1)

MOST_CHARACTERS = 100_000
DEPTH = 100
LARGEST_EXPONENT = 1000
_TOKEN = re.compile(r"\s*(?:([0-9]+(?:\.[0-9]+)?)|([^\W\d]\w*'*)|(\*\*|\.T\b|[-+*/^()\[\],]))")
_DECLARED = re.compile(r"([1-9][0-9]*|[a-wyz])x([1-9][0-9]*|[a-wyz])(?: (.+))?")

PROPERTIES: Mapping[str, set[str]] = {
    "rotation": {"rotation", "orthogonal"},
    "orthogonal": {"orthogonal"},
    "symmetric": {"symmetric"},
    "skew": {"skew"},
    "unit": {"unit"},
    "positive definite": {"positive definite", "symmetric"},
    "diagonal": {"diagonal", "symmetric"},
    "idempotent": {"idempotent"},
    **{f"rank {rank}": {f"rank {rank}"} for rank in range(1, 7)},
}
"""What a letter may be, with what follows from it."""


class Node(NamedTuple):
    """A part of a statement: its kind, its shape, its parts, and a number, a name, an exponent, sizes or places."""

    kind: str
    shape: Shape
    parts: tuple[Any, ...] = ()
    value: Any = None


class Letter(NamedTuple):
    """A vector or matrix that is named, and what it is."""

    shape: Shape
    properties: frozenset[str]


def declared(text: Any) -> Letter:
    """Read what a letter is.

    Examples
    --------
    >>> sorted(declared("3x3 rotation").properties)
    ['orthogonal', 'rotation']
    """
    match = _DECLARED.fullmatch(text) if isinstance(text, str) else None
    if match is None:
        raise Rejected(f"expected a shape and properties, got {text!r:.80}")
    shape, listed = (_size(match[1]), _size(match[2])), match[3].split(", ") if match[3] else []
    require({*listed} <= PROPERTIES.keys(), "there is no such property")
    for name in listed:
        rank = rank_in((name,))
        if rank is not None:
            fits = all(size >= rank for size in shape if isinstance(size, int))
        else:
            fits = shape[1] == 1 if name == "unit" else shape[0] == shape[1]
        require(fits, f"a letter of this shape is not {name}")
    return Letter(shape, frozenset(part for name in listed for part in PROPERTIES[name]))


def rank_in(properties: Iterable[str]) -> int | None:
    """Return the rank that is among properties; None if there is none."""
    return next((int(name[5:]) for name in properties if name.startswith("rank ")), None)


def _size(text: str) -> Size:
    return int(text) if text.isdecimal() else text


def parts_of(node: Node) -> Iterator[Node]:
    """Yield a node and all its parts."""
    yield node
    for part in node.parts:
        yield from parts_of(part)


def changed(node: Node, change: Callable[[Node], Node | None]) -> Node:
    """Return a node in which some parts are replaced."""
    other = change(node)
    if other is not None or not node.parts:
        return node if other is None else other
    return made(node.kind, *(changed(part, change) for part in node.parts), value=node.value)


def made(kind: str, *parts: Node, value: Any = None) -> Node:
    """Return a node, whose parts must fit together."""
    return Node(kind, _shape(kind, [part.shape for part in parts], value), parts, value)


def constant(value: Fraction | int) -> Node:
    """Return a rational number as a node."""
    return Node("number", NUMBER, (), Fraction(value))


def negative(node: Node) -> Node:
    """Return a node with the other sign."""
    return constant(-node.value) if node.kind == "number" else made("product", constant(-1), node)


_OF_VECTORS: Mapping[str, tuple[list[Shape], Shape]] = {
    "cross": ([(3, 1), (3, 1)], (3, 1)),
    "skew": ([(3, 1)], (3, 3)),
    "vee": ([(3, 3)], (3, 1)),
    "qmul": ([(4, 1), (4, 1)], (4, 1)),
    "conj": ([(4, 1)], (4, 1)),
    "rotation": ([(4, 1)], (3, 3)),
    "pure": ([(3, 1)], (4, 1)),
    "imag": ([(4, 1)], (3, 1)),
    "sin": ([NUMBER], NUMBER),
    "cos": ([NUMBER], NUMBER),
    "hat": ([(6, 1)], (4, 4)),
    "ad": ([(6, 1)], (6, 6)),
    "Ad": ([(4, 4)], (6, 6)),
}


def _shape(kind: str, shapes: list[Shape], value: Any) -> Shape:
    wrong = f"{kind}: the parts do not fit together"
    if kind in _OF_VECTORS:
        expected, result = _OF_VECTORS[kind]
        require(shapes == expected, wrong)
        return result
    if kind in ("sum", "dot"):
        require(len({*shapes}) == 1 and (kind == "sum" or (len(shapes) == 2 and shapes[0][1] == 1)), wrong)
        return shapes[0] if kind == "sum" else NUMBER
    if kind == "product":
        return _product(shapes)
    if kind in ("power", "trace", "det", "adj", "exp"):
        require(len(shapes) == 1 and shapes[0][0] == shapes[0][1], wrong)
        return shapes[0] if kind in ("power", "adj", "exp") else NUMBER
    if kind in ("diff", "ldiff", "rdiff"):
        moves = len(shapes) == 3 and (shapes[1] == shapes[2] if kind == "diff" else shapes[1:] == [(3, 3), (3, 1)])
        require(moves, wrong)
        return shapes[0]
    if kind in ("jl", "jr"):
        require(shapes in ([(3, 1)], [(6, 1)]), wrong)
        return shapes[0][0], shapes[0][0]
    if kind in ("norm", "diag"):
        require(len(shapes) == 1 and shapes[0][1] == 1, wrong)
        return NUMBER if kind == "norm" else (shapes[0][0], shapes[0][0])
    if kind == "outer":
        require(len(shapes) == 2 and shapes[0][1] == shapes[1][1] == 1, wrong)
        return shapes[0][0], shapes[1][0]
    if kind == "transpose":
        return shapes[0][1], shapes[0][0]
    if kind in ("eye", "zeros"):
        return value[0], value[-1]
    if kind == "entry":
        inside = all(isinstance(size, str) or place < size for place, size in zip(value, shapes[0], strict=True))
        require(inside, wrong)
        return NUMBER
    sizes = [size for shape in shapes for size in shape]
    if kind not in ("kron", "vec", "block") or not all(isinstance(size, int) for size in sizes):
        raise Rejected(wrong)
    return _fixed_shape(kind, [(int(rows), int(columns)) for rows, columns in shapes], value, wrong)


def _product(shapes: list[Shape]) -> Shape:
    result = NUMBER
    for shape in shapes:
        if shape == NUMBER or result == NUMBER:
            result = shape if result == NUMBER else result
            continue
        require(result[1] == shape[0], "product: the parts do not fit together")
        result = (result[0], shape[1])
    return result


def _fixed_shape(kind: str, shapes: list[tuple[int, int]], value: Any, wrong: str) -> Shape:
    if kind == "vec":
        require(len(shapes) == 1, wrong)
        return shapes[0][0] * shapes[0][1], 1
    if kind == "kron":
        return prod(height for height, _ in shapes), prod(width for _, width in shapes)
    require(len({*value}) == 1, wrong)
    lines = [shapes[place : place + value[0]] for place in range(0, len(shapes), value[0])]
    for line in lines:
        require(len({height for height, _ in line}) == 1, wrong)
        require([width for _, width in line] == [width for _, width in lines[0]], wrong)
    return sum(line[0][0] for line in lines), sum(width for _, width in lines[0])


FUNCTIONS = (
    *_OF_VECTORS, "dot", "trace", "det", "adj", "norm", "diag", "outer", "kron", "vec", "exp", "jl", "jr", "diff",
    "ldiff", "rdiff",
)  # fmt: skip


def read(text: Any, letters: Mapping[str, Shape]) -> Node:
    """Read a statement, in which some names are letters.

    Examples
    --------
    >>> read("R.T*R - eye(3)", {"R": (3, 3)}).shape
    (3, 3)
    >>> read("R*t", {"R": (3, 3), "t": (2, 1)})
    Traceback (most recent call last):
    ...
    algebroproj_sym.replaying.rejection.Rejected: product: the parts do not fit together
    """
    known = isinstance(text, str) and len(text) <= MOST_CHARACTERS
    require(known, f"expected the text of a statement in letters, got {text!r:.80}")
    reader = _Reader(text, letters)
    node = reader.sum()
    require(reader.token == "", f"expected a statement in letters, got {text!r:.80}")
    return node


class _Reader:
    def __init__(self, text: str, letters: Mapping[str, Shape]) -> None:
        self.letters = letters
        self.text = text
        self.tokens = [*self._tokens(), ""]
        self.place = 0
        self.depth = 0

    def _tokens(self) -> Iterator[str]:
        start, end = 0, len(self.text.rstrip())
        while start < end:
            match = _TOKEN.match(self.text, start)
            if match is None:
                raise self.wrong()
            yield match[match.lastindex or 0]
            start = match.end()

    @property
    def token(self) -> str:
        return self.tokens[self.place]

    def wrong(self) -> Rejected:
        return Rejected(f"expected a statement in letters, got {self.text!r:.80}")

    def skip(self, *tokens: str) -> str:
        found = self.token
        if not found or found not in tokens:
            return ""
        self.place += 1
        return found

    def expect(self, token: str) -> None:
        if not self.skip(token):
            raise self.wrong()

    def listed(self, read: Callable[[], Any], closing: str) -> list[Any]:
        found = [read()]
        while self.skip(","):
            found.append(read())
        self.expect(closing)
        return found

    def sum(self) -> Node:
        self.depth += 1
        if self.depth > DEPTH:
            raise NotReplayable("the statement is nested too deeply")
        terms = [self.product()]
        while sign := self.skip("+", "-"):
            terms.append(negative(self.product()) if sign == "-" else self.product())
        self.depth -= 1
        return terms[0] if len(terms) == 1 else made("sum", *terms)

    def product(self) -> Node:
        factors = [self.signed()]
        while operator := self.skip("*", "/"):
            factor = self.signed()
            if operator == "/":
                require(factor.shape == NUMBER and factor != constant(0), "a divisor is not a number, or zero")
                inverse = constant(1 / factor.value) if factor.kind == "number" else None
                factor = inverse or made("power", factor, value=-1)
            factors.append(factor)
        if len(factors) == 1:
            return factors[0]
        if all(factor.kind == "number" for factor in factors):
            return constant(prod(factor.value for factor in factors))
        return made("product", *factors)

    def signed(self) -> Node:
        minus = False
        while sign := self.skip("+", "-"):
            minus ^= sign == "-"
        node = self.power()
        return negative(node) if minus else node

    def power(self) -> Node:
        base = self.places(self.atom())
        if not self.skip("**", "^"):
            return base
        sign = -1 if self.skip("-") else 1
        exponent = self.integer()
        if exponent > LARGEST_EXPONENT:
            raise NotReplayable("an exponent is too large")
        return self.places(made("power", base, value=sign * exponent))

    def places(self, node: Node) -> Node:
        while found := self.skip(".T", "["):
            if found == ".T":
                node = made("transpose", node)
            else:
                node = made("entry", node, value=tuple(self.listed(self.integer, "]")))
        return node

    def integer(self) -> int:
        if not self.token.isdecimal() or len(self.token) > 9:
            raise self.wrong()
        return int(self.skip(self.token))

    def size(self) -> Size:
        return self.skip(self.token) if self.token.isidentifier() else self.integer()

    def row(self) -> list[Node]:
        self.expect("[")
        return self.listed(self.sum, "]")

    def atom(self) -> Node:
        token = self.skip(self.token)
        if token[:1].isdigit():
            return constant(Fraction(token))
        if token == "(":
            node = self.sum()
            self.expect(")")
            return node
        if not token.rstrip("'").isidentifier():
            raise self.wrong()
        if not self.skip("("):
            shape = self.letters.get(token)
            require(token != "pi" or shape is not None, "pi is a number, and no symbol of a statement in letters")
            return Node("symbol", NUMBER, (), token) if shape is None else Node("letter", shape, (), token)
        if token in ("eye", "zeros"):
            sizes = tuple(self.listed(self.size, ")"))
            require(len(sizes) == (1 if token == "eye" else 2), "expected one size of eye, two of zeros")
            return made(token, value=sizes)
        if token == "block":
            rows = self.listed(self.row, ")")
            return made(token, *(part for row in rows for part in row), value=tuple(map(len, rows)))
        if token not in FUNCTIONS:
            raise self.wrong()
        return made(token, *self.listed(self.sum, ")"))

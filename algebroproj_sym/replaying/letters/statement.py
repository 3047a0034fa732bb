"""A statement in letters, with squares of lengths and the definitions among its constraints put in."""

from __future__ import annotations

from collections.abc import Mapping, Set
from dataclasses import dataclass, replace
from typing import Any

from algebroproj_sym.replaying.letters.reading import (
    Letter,
    Node,
    changed,
    constant,
    declared,
    made,
    negative,
    parts_of,
    read,
)
from algebroproj_sym.replaying.rejection import require
from algebroproj_sym.replaying.text import texts


@dataclass(frozen=True)
class Statement:
    """Two sides that are equal where some things are zero, and some numbers are not."""

    left: Node
    right: Node
    letters: Mapping[str, Letter]
    constraints: tuple[Node, ...]
    nonzero: tuple[Node, ...]

    @property
    def nodes(self) -> tuple[Node, ...]:
        """All forms."""
        return self.left, self.right, *self.constraints, *self.nonzero

    @property
    def sizes(self) -> set[str]:
        """The names of sizes."""
        shapes = [letter.shape for letter in self.letters.values()]
        shapes += [part.shape for node in self.nodes for part in parts_of(node)]
        return {size for shape in shapes for size in shape if isinstance(size, str)}

    def every(self, change: Any) -> Statement:
        """Return the statement with a change of all its forms."""
        left, right = change(self.left), change(self.right)
        return Statement(left, right, self.letters, (*map(change, self.constraints),), (*map(change, self.nonzero),))


def stated(record: Mapping[str, Any]) -> Statement:
    """Return the statement of a record, as it is given."""
    require(isinstance(record["letters"], Mapping), "letters: expected what each letter is")
    letters = {name: declared(text) for name, text in record["letters"].items()}
    require("pi" not in letters, "pi is a number, and no letter")
    shapes = {name: letter.shape for name, letter in letters.items()}

    def zero(text: str) -> Node:
        left, equal, right = text.partition("=")
        first, second = read(left, shapes), read(right, shapes) if equal else constant(0)
        return first if second == constant(0) else made("sum", first, negative(second))

    left, right = read(record["lhs"], shapes), read(record["rhs"], shapes)
    if right == constant(0):
        right = made("zeros", value=left.shape) if left.shape != (1, 1) else right
    elif left == constant(0):
        left = made("zeros", value=right.shape) if right.shape != (1, 1) else left
    require(left.shape == right.shape, "the two sides have not the same shape")
    constraints = (*map(zero, texts(record["constraints"])),)
    nonzero = tuple(read(text, shapes) for text in texts(record["nonzero"]))
    require(all(unit.shape == (1, 1) for unit in nonzero), "expected a number that is not zero")
    statement = Statement(left, right, letters, constraints, nonzero)
    require(not statement.sizes & letters.keys(), "a letter has the name of a size")
    return statement


def read_alone(setting: Mapping[str, Any], *texts: str) -> None:
    """Reject texts that are not matrices of one shape by themselves, before they become parts of another text."""
    letters = {name: declared(text).shape for name, text in setting["letters"].items()}
    shapes = {read(text, letters).shape for text in texts}
    require(len(shapes) == 1, "the two sides have not the same shape")
    require(shapes != {(1, 1)}, "two single numbers always have a common factor")


def without_lengths(statement: Statement) -> Statement:
    """Put scalar products for squares of lengths; sides that are lengths or positive numbers are squared."""
    unit = {name for name, letter in statement.letters.items() if "unit" in letter.properties}

    def square(node: Node) -> Node | None:
        if node.kind == "power" and node.value % 2 == 0 and _length(node.parts[0]) is not None:
            (vector,) = node.parts[0].parts
            inner = changed(vector, square)
            dot = made("dot", inner, inner)
            return dot if node.value == 2 else made("power", dot, value=node.value // 2)
        is_unit = node.kind == "norm" and node.parts[0].kind == "letter" and node.parts[0].value in unit
        return constant(1) if is_unit else None

    def _length(node: Node) -> Node | None:
        return node if node.kind == "norm" and changed(node, square).kind == "norm" else None

    rest = statement.every(lambda node: changed(node, square))
    left, right = _square_of_length(rest.left), _square_of_length(rest.right)
    has_length = any(part.kind == "norm" for side in (rest.left, rest.right) for part in parts_of(side))
    return rest if left is None or right is None or not has_length else replace(rest, left=left, right=right)


def _square_of_length(node: Node) -> Node | None:
    """Return the square of a number that cannot be negative: a length, a constant, or a product of such."""
    if node.kind == "norm":
        return made("dot", node.parts[0], node.parts[0])
    if node.kind == "number":
        return constant(node.value**2) if node.value >= 0 else None
    if node.kind == "dot":
        return made("power", node, value=2) if node.parts[0] == node.parts[1] else None
    if node.kind not in ("product", "power"):
        return None
    squares = [square for part in node.parts if (square := _square_of_length(part)) is not None]
    return made(node.kind, *squares, value=node.value) if len(squares) == len(node.parts) else None


def without_definitions(statement: Statement, sizes: Set[str] | None = None) -> Statement:
    """Put for each letter without properties, or number, that a constraint defines what it is; sizes are kept."""
    sizes = statement.sizes if sizes is None else sizes
    for place, constraint in enumerate(statement.constraints):
        for name, value in _definitions(constraint):
            if name.kind == "letter" and statement.letters[name.value].properties:
                continue
            if name.value in sizes:
                continue
            others = statement.constraints[:place] + statement.constraints[place + 1 :]
            letters = {other: letter for other, letter in statement.letters.items() if other != name.value}
            rest = replace(statement, constraints=others, letters=letters)
            return without_definitions(rest.every(lambda node, n=name, v=value: _put(node, n, v)), sizes)
    return statement


def _put(node: Node, name: Node, value: Node) -> Node:
    return changed(node, lambda part: value if part == name else None)


def _definitions(constraint: Node) -> list[tuple[Node, Node]]:
    """Return each letter or number that is a term of a sum, and nowhere else in it, with what it then is."""
    found = []
    parts = constraint.parts if constraint.kind == "sum" else ()
    for place, part in enumerate(parts):
        minus = part.kind == "product" and len(part.parts) == 2 and part.parts[0] == constant(-1)
        name = part.parts[1] if minus else part
        others = [*parts[:place], *parts[place + 1 :]]
        if name.kind in ("letter", "symbol") and not any(
            inner == name for other in others for inner in parts_of(other)
        ):
            value = others[0] if len(others) == 1 else made("sum", *others)
            found.append((name, value if minus else _opposite(value)))
    return found


def _opposite(node: Node) -> Node:
    """Return a node with the other sign, where a sign that it has is dropped."""
    if node.kind == "sum":
        return made("sum", *map(_opposite, node.parts))
    if node.kind == "product" and node.parts[0] == constant(-1):
        return node.parts[1] if len(node.parts) == 2 else made("product", *node.parts[1:])
    return negative(node)


def conditions(statement: Statement) -> set[Node]:
    """Return what must not be zero for a statement to be defined: determinants of what is inverted, and divisors."""
    found = set()
    for part in {part for node in statement.nodes for part in parts_of(node)}:
        if part.kind == "rotation":
            found.add(made("dot", *part.parts, *part.parts))
        if part.kind != "power" or part.value >= 0:
            continue
        (base,) = part.parts
        regular = {"orthogonal", "positive definite"}
        if base.kind == "letter" and regular & statement.letters[base.value].properties:
            continue
        if base.kind != "number":
            found.add(base if base.shape == (1, 1) else made("det", base))
    return found

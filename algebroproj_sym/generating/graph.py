"""Expressions as a graph of sums, products and quotients, in which equal subexpressions are one node.

Signs are kept apart from the nodes, so that a - b and b - a are one node with two signs.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, TypeAlias

import sympy

from algebroproj_sym.expressions import over

Kind = Literal["input", "number", "sum", "product", "quotient"]
Signed: TypeAlias = tuple[int, int]


@dataclass(frozen=True)
class Node:
    """A node of the graph."""

    kind: Kind
    """An input, a non-negative integer, a sum, a product (a power is a repeated factor) or a quotient."""
    operands: tuple[Signed, ...] = ()
    """The operands, those of a sum in the order of their places; only they have signs, the first a positive one."""
    value: str | int = 0
    """The name of an input, or an integer."""


@dataclass
class Graph:
    """The nodes of some expressions; a node is referred to by its place.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> graph = Graph()
    >>> known = {x: graph.input("x"), y: graph.input("y")}
    >>> graph.add(x - y, known), graph.add(y - x, known)
    ((1, 3), (-1, 3))
    """

    nodes: list[Node] = field(default_factory=list)
    _places: dict[Node, int] = field(default_factory=dict)

    def place(self, node: Node) -> int:
        """Return the place of a node, entering it if it is new."""
        if node not in self._places:
            self._places[node] = len(self.nodes)
            self.nodes.append(node)
        return self._places[node]

    def input(self, name: str) -> Signed:
        """Return an input as a signed node."""
        return 1, self.place(Node("input", value=name))

    def number(self, value: int) -> Signed:
        """Return an integer as a signed node."""
        return (1 if value >= 0 else -1), self.place(Node("number", value=abs(value)))

    def add(self, expression: sympy.Expr, known: Mapping[sympy.Symbol, Signed]) -> Signed:
        """Return a rational expression as a signed node."""
        if isinstance(expression, sympy.Symbol):
            return known[expression]
        if isinstance(expression, sympy.Rational):
            return self.quotient(self.number(int(expression.p)), self.number(int(expression.q)))
        if isinstance(expression, over):
            numerator, denominator = (self.add(argument, known) for argument in expression.args)
            return self.quotient(numerator, denominator)
        if isinstance(expression, sympy.Add):
            if not expression.as_coeff_Add()[0].is_Integer:
                content, primitive = expression.primitive()
                product = self.product([self.number(int(content.p)), self.add(primitive, known)])
                return self.quotient(product, self.number(int(content.q)))
            return self.sum([self.add(term, known) for term in expression.args])
        above, below = list[Signed](), list[Signed]()
        for factor in sympy.Mul.make_args(expression):
            self._add_power(factor, known, above, below)
        return self.quotient(self.product(above), self.product(below))

    def _add_power(
        self, factor: Any, known: Mapping[sympy.Symbol, Signed], above: list[Signed], below: list[Signed]
    ) -> None:
        if isinstance(factor, sympy.Rational):
            above.append(self.number(int(factor.p)))
            below.append(self.number(int(factor.q)))
        elif isinstance(factor, sympy.Pow):
            side = above if factor.exp > 0 else below
            side.extend([self.add(factor.base, known)] * abs(int(factor.exp)))
        else:
            above.append(self.add(factor, known))

    def sum(self, terms: Sequence[Signed]) -> Signed:
        """Return a sum of signed nodes; a sum within a sum stays a node of its own."""
        kept = [term for term in terms if self.nodes[term[1]] != Node("number")]
        if len(kept) < 2:
            return kept[0] if kept else self.number(0)
        ordered = sorted(kept, key=lambda term: term[1])
        sign = ordered[0][0]
        return sign, self.place(Node("sum", tuple((s * sign, place) for s, place in ordered)))

    def product(self, factors: Sequence[Signed]) -> Signed:
        """Return a product of signed nodes; a product within a product is flattened."""
        sign, places = 1, list[Signed]()
        for factor_sign, place in factors:
            sign *= factor_sign
            node = self.nodes[place]
            places.extend(node.operands if node.kind == "product" else [(1, place)])
        if any(self.nodes[place] == Node("number") for _, place in places):
            return self.number(0)
        kept = tuple(factor for factor in places if self.nodes[factor[1]] != Node("number", value=1))
        if len(kept) < 2:
            return sign, (kept[0] if kept else self.number(1))[1]
        return sign, self.place(Node("product", kept))

    def quotient(self, numerator: Signed, denominator: Signed) -> Signed:
        """Return a quotient of signed nodes."""
        sign = numerator[0] * denominator[0]
        if self.nodes[denominator[1]] == Node("number", value=1):
            return sign, numerator[1]
        return sign, self.place(Node("quotient", ((1, numerator[1]), (1, denominator[1]))))

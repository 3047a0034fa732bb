"""Common subexpressions: sums and products that share terms or factors are built from shared pairs.

The most frequent pair becomes a node of its own, again and again, until no pair occurs twice.  Quotients that share a
divisor can be made products with its reciprocal.
"""

from collections import Counter
from collections.abc import Sequence
from functools import lru_cache
from itertools import combinations
from typing import TypeAlias

from algebroproj_sym.expressions.walking import parts_first
from algebroproj_sym.generating.graph import Graph, Kind, Node, Signed

Pair: TypeAlias = tuple[Kind, Signed, Signed]


def share_pairs(graph: Graph, outputs: Sequence[Signed]) -> None:
    """Rewrite the sums and products below some outputs, so that common pairs are nodes of their own.

    The graph is changed in place; the places of its nodes stay what they are.

    Examples
    --------
    >>> import sympy
    >>> symbols = sympy.symbols("a b c d")
    >>> graph = Graph()
    >>> known = {symbol: graph.input(symbol.name) for symbol in symbols}
    >>> a, b, c, d = symbols
    >>> outputs = [graph.add(a + b - c, known), graph.add(c - a + d, known)]
    >>> share_pairs(graph, outputs)
    >>> [graph.nodes[place].operands for _, place in outputs]
    [((1, 7), (1, 1)), ((1, 7), (-1, 3))]
    """
    while True:
        counts = _pair_counts(graph, outputs)
        best = max(counts.values(), default=0)
        if best < 2:
            return
        pair = next(pair for pair, count in counts.items() if count == best)
        kind, first, second = pair
        joined = graph.place(Node(kind, (first, second)))
        for place in below(graph, outputs):
            if place != joined:
                graph.nodes[place] = _with_pair(graph.nodes[place], pair, joined)


def share_reciprocals(graph: Graph, outputs: Sequence[Signed]) -> None:
    """Rewrite the quotients below some outputs whose divisor is that of others as products with its reciprocal.

    Examples
    --------
    >>> import sympy
    >>> symbols = sympy.symbols("a b c")
    >>> graph = Graph()
    >>> known = {symbol: graph.input(symbol.name) for symbol in symbols}
    >>> a, b, c = symbols
    >>> outputs = [graph.add(a / c, known), graph.add(b / c, known)]
    >>> share_reciprocals(graph, outputs)
    >>> [graph.nodes[place].kind for _, place in outputs]
    ['product', 'product']
    """
    one, zero = Node("number", value=1), Node("number")
    quotients = [place for place in below(graph, outputs) if graph.nodes[place].kind == "quotient"]
    dividends = {place: graph.nodes[graph.nodes[place].operands[0][1]] for place in quotients}
    divisors = Counter(graph.nodes[place].operands[1] for place in quotients if dividends[place] != zero)
    for place in quotients:
        dividend, divisor = graph.nodes[place].operands
        is_integer = graph.nodes[divisor[1]].kind == "number"
        if divisors[divisor] > 1 and not is_integer and dividends[place] not in (one, zero):
            reciprocal = graph.quotient(graph.number(1), divisor)
            graph.nodes[place] = graph.nodes[graph.product([dividend, reciprocal])[1]]


def below(graph: Graph, outputs: Sequence[Signed]) -> tuple[int, ...]:
    """Return the places of all nodes below some outputs, operands before the nodes that use them."""
    roots = (place for _, place in outputs)
    return tuple(parts_first(roots, lambda place: [operand for _, operand in graph.nodes[place].operands]))


def _pair_counts(graph: Graph, outputs: Sequence[Signed]) -> Counter[Pair]:
    """Count in how many nodes each pair occurs that could be taken out of at least one of them."""
    nodes = [graph.nodes[place] for place in below(graph, outputs)]
    long = [node for node in nodes if node.kind in ("sum", "product") and len(node.operands) > 2]
    counts: Counter[Pair] = Counter()
    for node in long:
        counts.update(dict.fromkeys((pair for _, pair in _pairs(node)), 1))
    for node in nodes:
        if node.kind in ("sum", "product") and len(node.operands) == 2:
            counts.update(pair for _, pair in _pairs(node) if pair in counts)
    return counts


@lru_cache(maxsize=4096)
def _pairs(node: Node) -> tuple[tuple[tuple[Signed, Signed], Pair], ...]:
    return tuple((pair, _normal(node.kind, *pair)) for pair in combinations(node.operands, 2))


def _normal(kind: Kind, first: Signed, second: Signed) -> Pair:
    (s, a), (t, b) = (first, second) if first[1] <= second[1] else (second, first)
    return kind, (1, a), (s * t, b)


def _with_pair(node: Node, wanted: Pair, joined: int) -> Node:
    if len(node.operands) < 3:
        return node
    for (first, second), pair in _pairs(node):
        if pair == wanted:
            rest = list(node.operands)
            rest.remove(first)
            rest.remove(second)
            sign = min((first, second), key=lambda term: term[1])[0]
            return Node(node.kind, ((sign, joined), *rest))
    return node

"""Sharing leaves every value and every place what it was, and leaves no pair to be shared."""

from collections import Counter
from fractions import Fraction
from itertools import combinations

import sympy
from cases import for_each
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym.generating.graph import Graph
from algebroproj_sym.generating.sharing import below, share_pairs

SYMBOLS = sympy.symbols("a b c d e f")
a, b, c, d, e, f = SYMBOLS
POINT = {symbol.name: Fraction(prime, 7) for symbol, prime in zip(SYMBOLS, (2, 3, 5, 11, 13, 17), strict=True)}


def entered(*expressions):
    graph = Graph()
    known = {symbol: graph.input(symbol.name) for symbol in SYMBOLS}
    return graph, [graph.add(expression, known) for expression in expressions]


def value(graph, signed):
    sign, place = signed
    node = graph.nodes[place]
    if node.kind in ("input", "number"):
        return sign * Fraction(POINT.get(node.value, node.value))
    result = Fraction(0 if node.kind == "sum" else 1)
    for operand in node.operands:
        result = result + value(graph, operand) if node.kind == "sum" else result * value(graph, operand)
    return sign * result


def operations(graph, outputs):
    return sum(len(graph.nodes[place].operands) - 1 for place in below(graph, outputs) if graph.nodes[place].operands)


def pairs_that_occur_twice(graph, outputs):
    """Pairs in two nodes, of which at least one has more operands; a pair of terms and its negative are one."""
    counts, in_longer = Counter(), set()
    for place in below(graph, outputs):
        node = graph.nodes[place]
        pairs = set()
        for (s, first), (t, second) in combinations(node.operands, 2):
            pairs.add((node.kind, *sorted((first, second)), s * t))
        if node.kind in ("sum", "product"):
            counts.update(pairs)
            in_longer |= pairs if len(node.operands) > 2 else set()
    return {pair for pair, count in counts.items() if count > 1 and pair in in_longer}


terms = st.builds(lambda sign, symbol: sign * symbol, st.sampled_from((1, -1)), st.sampled_from(SYMBOLS))
sums = st.lists(terms, min_size=2, max_size=6).map(lambda parts: sympy.Add(*parts))
products = st.lists(st.sampled_from(SYMBOLS), min_size=2, max_size=6).map(lambda factors: sympy.Mul(*factors))
mixed = st.lists(sums | products, min_size=2, max_size=3).map(lambda parts: sympy.Mul(*parts))
expressions = st.lists(sums | products | mixed, min_size=1, max_size=6)


@given(expressions)
def test_values_and_places_stay_what_they_are(several):
    graph, outputs = entered(*several)
    at = {symbol: sympy.Rational(str(POINT[symbol.name])) for symbol in SYMBOLS}
    share_pairs(graph, outputs)
    assert [value(graph, output) for output in outputs] == [Fraction(str(s.xreplace(at))) for s in several]


@given(expressions)
def test_no_shared_pair_is_left(several):
    graph, outputs = entered(*several)
    share_pairs(graph, outputs)
    assert pairs_that_occur_twice(graph, outputs) == set()


@given(expressions)
def test_sharing_never_adds_an_operation(several):
    graph, outputs = entered(*several)
    before = operations(graph, outputs)
    share_pairs(graph, outputs)
    assert operations(graph, outputs) <= before


@given(expressions)
def test_sharing_again_changes_nothing(several):
    graph, outputs = entered(*several)
    share_pairs(graph, outputs)
    nodes = list(graph.nodes)
    share_pairs(graph, outputs)
    assert graph.nodes == nodes


@given(expressions)
def test_operands_stand_below_the_nodes_that_use_them(several):
    graph, outputs = entered(*several)
    share_pairs(graph, outputs)
    order = below(graph, outputs)
    assert len(set(order)) == len(order)
    assert {place for _, place in outputs} <= set(order)
    for position, place in enumerate(order):
        assert all(operand in order[:position] for _, operand in graph.nodes[place].operands)


@for_each(
    ("expressions", "count"),
    [
        ((a + b + c, a + b + d), 3),
        ((a + b + c, a + b), 2),
        ((a * b * c, a * b * d), 3),
        ((a * b * c, a * b), 2),
        ((a - b + c, b - a + d), 3),
        ((a + b, c + d), 2),
        ((a + b + c, a - b + d), 4),
        ((a * b * c * d, a * b * e, c * d * f), 5),
        ((a + b + c + d, a + b + c + e, a + b + c + f), 5),
        ((a * (b + c), d * (b + c)), 3),
    ],
)
def test_what_is_common_is_computed_once(expressions, count):
    graph, outputs = entered(*expressions)
    share_pairs(graph, outputs)
    assert operations(graph, outputs) == count


def test_what_is_not_to_be_computed_is_not_shared():
    graph, outputs = entered(a + b + c, a + b + d)
    share_pairs(graph, outputs[:1])
    assert operations(graph, outputs[:1]) == 2
    assert len(graph.nodes[outputs[0][1]].operands) == 3

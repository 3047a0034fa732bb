"""A graph means what its expressions mean, and holds equal subexpressions once."""

from fractions import Fraction

import pytest
import sympy
from cases import for_each
from hypothesis import assume, given
from hypothesis import strategies as st

from algebroproj_sym.expressions import over
from algebroproj_sym.generating.graph import Graph, Node

SYMBOLS = sympy.symbols("a b c d")
a, b, c, d = SYMBOLS


def entered(*expressions):
    graph = Graph()
    known = {symbol: graph.input(symbol.name) for symbol in SYMBOLS}
    return graph, [graph.add(sympy.sympify(expression), known) for expression in expressions]


def meaning(graph, signed, point):
    """Return the value of a signed node, read off the definition of the kinds of nodes."""
    sign, place = signed
    node = graph.nodes[place]
    values = [meaning(graph, operand, point) for operand in node.operands]
    if node.kind == "input":
        return sign * point[node.value]
    if node.kind == "number":
        return sign * Fraction(node.value)
    if node.kind == "sum":
        return sign * sum(values)
    if node.kind == "quotient":
        numerator, denominator = values
        return sign * (numerator / denominator)
    result = Fraction(sign)
    for value in values:
        result *= value
    return result


numbers = st.fractions(-6, 6, max_denominator=4).map(lambda value: sympy.Rational(value.numerator, value.denominator))


def combined(parts):
    pairs = st.tuples(parts, parts)
    return st.one_of(
        pairs.map(lambda pair: pair[0] + pair[1]),
        pairs.map(lambda pair: pair[0] - pair[1]),
        pairs.map(lambda pair: pair[0] * pair[1]),
        pairs.map(lambda pair: pair[0] if pair[1].is_number else over(pair[0], pair[1])),
        pairs.map(lambda pair: pair[0] / (pair[1] if pair[1] != 0 else 1)),
        st.tuples(parts, st.integers(-3, 3)).map(lambda pair: pair[0] ** pair[1] if pair[0] != 0 else pair[0]),
    )


expressions = st.recursive(st.sampled_from(SYMBOLS) | numbers, combined, max_leaves=8)
points = st.fixed_dictionaries({s.name: st.integers(-99, 99).map(lambda n: Fraction(2 * n + 1, 64)) for s in SYMBOLS})


def sympy_value(expression, point):
    try:
        value = expression.xreplace({s: sympy.Rational(str(point[s.name])) for s in SYMBOLS}).doit()
    except ZeroDivisionError:
        return None
    return Fraction(int(value.p), int(value.q)) if value.is_Rational else None


@given(expressions, points)
def test_a_graph_has_the_value_of_its_expression(expression, point):
    expected = sympy_value(expression, point)
    assume(expected is not None)
    graph, (signed,) = entered(expression)
    try:
        value = meaning(graph, signed, point)
    except ZeroDivisionError:
        assume(False)
    assert value == expected


@given(st.lists(expressions, min_size=1, max_size=3))
def test_no_node_occurs_twice_and_operands_come_first(several):
    graph, _ = entered(*several)
    assert len(set(graph.nodes)) == len(graph.nodes)
    for place, node in enumerate(graph.nodes):
        assert all(operand < place for _, operand in node.operands)


@given(st.lists(expressions, min_size=1, max_size=3))
def test_only_terms_of_sums_have_signs_and_the_first_is_positive(several):
    graph, signed = entered(*several)
    for node in graph.nodes:
        signs = [sign for sign, _ in node.operands]
        assert set(signs) <= ({1, -1} if node.kind == "sum" else {1})
        assert signs[:1] in ([], [1])
    assert all(sign in (1, -1) for sign, _ in signed)


@given(st.lists(expressions, min_size=1, max_size=3))
def test_numbers_are_non_negative_integers(several):
    graph, _ = entered(*several)
    for node in graph.nodes:
        if node.kind == "number":
            assert type(node.value) is int
            assert node.value >= 0


@given(expressions)
def test_the_same_expression_is_entered_once(expression):
    graph, (first,) = entered(expression)
    size = len(graph.nodes)
    known = {symbol: graph.input(symbol.name) for symbol in SYMBOLS}
    assert graph.add(expression, known) == first
    assert len(graph.nodes) == size


@given(expressions)
def test_an_expression_and_its_negative_are_one_node(expression):
    graph, ((sign, place), (other_sign, other_place)) = entered(expression, -expression)
    assert place == other_place
    assert sign == -other_sign or graph.nodes[place] == Node("number")


@for_each(
    ("first", "second"),
    [
        (a - b, b - a),
        (a - b - c, b + c - a),
        ((a - b) * c, (b - a) * c),
        (over(a, b - c), over(a, c - b)),
        (over(a - b, c), over(b - a, c)),
        (-(a + b), a + b),
        (sympy.Integer(-3), sympy.Integer(3)),
        (-a / 2, a / 2),
    ],
)
def test_opposite_expressions_are_one_node_with_two_signs(first, second):
    _, ((sign, place), (other_sign, other_place)) = entered(first, second)
    assert (place, sign) == (other_place, -other_sign)


@pytest.mark.parametrize(
    ("first", "second"),
    [
        (a + b + c, c + b + a),
        ((a - b) ** 2, (b - a) ** 2),
        (over(a, b), a / b),
        (a * b**2 * c**-1, over(b * a * b, c)),
        (a * a, a**2),
    ],
    ids=str,
)
def test_expressions_that_differ_in_order_or_notation_are_one_node(first, second):
    _, (one, other) = entered(first, second)
    assert one == other


def test_a_division_that_cancels_stays_a_division():
    graph, ((_, place),) = entered(over(a, a))
    assert graph.nodes[place].kind == "quotient"


def test_neutral_elements_leave_no_nodes():
    graph, _ = entered()
    size = len(graph.nodes)
    zero, one, first = graph.number(0), graph.number(1), (1, 0)
    assert graph.sum([zero, first]) == first
    assert graph.product([one, first]) == first
    assert graph.product([graph.number(-1), first]) == (-1, 0)
    assert graph.quotient(first, one) == first
    assert set(graph.nodes[size:]) == {Node("number", value=0), Node("number", value=1)}


def test_a_product_of_products_is_one_product():
    graph, (first, second) = entered(a * b, c * d)
    assert graph.product([first, second]) == entered(a * b, c * d, a * b * c * d)[1][2]
    assert graph.nodes[graph.product([first, second])[1]].operands == ((1, 0), (1, 1), (1, 2), (1, 3))


def test_empty_sums_and_products_are_numbers():
    graph = Graph()
    assert meaning(graph, graph.sum([]), {}) == 0
    assert meaning(graph, graph.product([]), {}) == 1
    assert meaning(graph, graph.product([graph.input("a"), graph.number(0)]), {}) == 0


def test_an_unknown_symbol_is_an_error():
    with pytest.raises(KeyError):
        entered(sympy.Symbol("unknown") + a)

"""What is reasoned about is rational over Q, and nothing else gets in."""

import decimal
import operator
from fractions import Fraction

import pytest
import sympy
from cases import for_each
from hypothesis import assume, given
from hypothesis import strategies as st

from algebroproj_sym.expressions import NotRationalError, divided, entries, over, rational, shape, symbols_of, text

x, y, z = sympy.symbols("x y z")
A, B = sympy.symbols("A B", commutative=False)
f = sympy.Function("f")

NUMBERS = {
    "0.5": 0.5,
    "0.500000000000000": sympy.Float("0.5"),
    "sqrt(2)": sympy.sqrt(2),
    "pi": sympy.pi,
    "GoldenRatio": sympy.GoldenRatio,
    "E": sympy.E,
    "I": sympy.I,
    "oo": sympy.oo,
    "-oo": -sympy.oo,
    "zoo": sympy.zoo,
    "nan": sympy.nan,
    "inf": float("inf"),
    "1j": 1j,
    "Decimal('0.5')": decimal.Decimal("0.5"),
}
EXPRESSIONS = {
    "sqrt(x)": sympy.sqrt(x),
    "x**y": x**y,
    "2**x": 2**x,
    "x**1.5": x**1.5,
    "sin(x)": sympy.sin(x),
    "f(x)": f(x),
    "Abs(x)": sympy.Abs(x),
    "conjugate(x)": sympy.conjugate(x),
    "Derivative(f(x), x)": f(x).diff(x),
    "M": sympy.MatrixSymbol("M", 2, 2),
    "A*B": A * B,
}
OTHERS = {
    "'x'": "x",
    "True": True,
    "None": None,
    "BooleanTrue": sympy.true,
    "Eq(x, 1)": sympy.Eq(x, 1),
    "[x]": [x],
    "<class 'int'>": int,
}


@for_each(("shown", "value"), [*NUMBERS.items(), *EXPRESSIONS.items(), *OTHERS.items()])
def test_what_is_not_rational_is_rejected_by_name(shown, value):
    with pytest.raises(NotRationalError) as caught:
        rational(value, "the left side")
    assert str(caught.value).startswith("the left side: expected ")
    assert shown in str(caught.value).partition("got ")[2]


@for_each(
    "inside",
    [
        lambda bad: x + bad,
        lambda bad: (x + bad) ** -3,
        lambda bad: over(x, y + bad),
        lambda bad: over(bad, y),
        lambda bad: sympy.Matrix([[x, y], [z, over(x, bad + y)]]),
    ],
)
@for_each("bad", [sympy.Float("0.5"), sympy.sqrt(2), sympy.pi, sympy.I, sympy.sin(x), sympy.sqrt(x)])
def test_what_is_not_rational_is_found_inside(inside, bad):
    with pytest.raises(NotRationalError, match="rhs: expected a rational expression over Q") as caught:
        rational(inside(bad), "rhs")
    assert str(bad) in str(caught.value)


def test_a_float_exponent_is_rejected_even_if_whole():
    with pytest.raises(NotRationalError):
        rational(sympy.Pow(x, sympy.Float(2)), "lhs")


@pytest.mark.parametrize(
    ("number", "expected"),
    [
        (3, sympy.Integer(3)),
        (-(10**40), sympy.Integer(-(10**40))),
        (Fraction(-2, 6), sympy.Rational(-1, 3)),
        (sympy.Rational(7, 3), sympy.Rational(7, 3)),
        (sympy.Integer(0), sympy.Integer(0)),
    ],
)
def test_exact_numbers_are_accepted(number, expected):
    accepted = rational(number, "lhs")
    assert isinstance(accepted, sympy.Rational)
    assert accepted == expected


@for_each("expression", [x, x + y, x - y * z, x**5 / y, (x + 1) ** -2, over(x, over(y, z)), sympy.Dummy("d"), x / 3])
def test_rational_expressions_are_accepted_as_they_are(expression):
    assert rational(expression, "lhs") == expression


@pytest.mark.parametrize("kind", [sympy.Matrix, sympy.SparseMatrix, sympy.ImmutableDenseMatrix])
def test_matrices_become_immutable(kind):
    accepted = rational(kind([[x, 1], [over(x, x), 0]]), "lhs")
    assert isinstance(accepted, sympy.ImmutableDenseMatrix)
    assert entries(accepted) == (x, 1, over(x, x), 0)


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        (x, ()),
        (sympy.Matrix([x, y, z]), (3,)),
        (sympy.Matrix([[x, y, z]]), (1, 3)),
        (sympy.Matrix([x]), (1,)),
        (sympy.Matrix([[x, y], [y, z]]), (2, 2)),
    ],
)
def test_the_shape_tells_rows_from_columns_and_vectors_from_scalars(expression, expected):
    assert shape(expression) == expected


def test_the_entries_of_a_matrix_come_row_by_row():
    assert entries(sympy.Matrix([[x, y], [z, 1]])) == (x, y, z, 1)
    assert entries(x + y) == (x + y,)


def test_the_symbols_come_sorted_by_name():
    assert symbols_of([z + over(1, y), sympy.Matrix([x, z])]) == (x, y, z)
    assert symbols_of([sympy.Integer(1)]) == ()
    assert symbols_of([]) == ()


@pytest.mark.parametrize("other", [sympy.Symbol("y", positive=True), sympy.Symbol("y", real=True), sympy.Dummy("y")])
def test_two_symbols_of_one_name_are_rejected(other):
    with pytest.raises(ValueError, match="one symbol of the name y"):
        symbols_of([x + y, z * other])


def test_divided_carries_every_division_out():
    assert divided(1 + over(x, over(x, y))) == 1 + y
    result = divided(sympy.ImmutableDenseMatrix([[over(x, x), over(6, 4)]]))
    assert isinstance(result, sympy.ImmutableDenseMatrix)
    assert result == sympy.Matrix([[1, sympy.Rational(3, 2)]])


trees = st.recursive(
    st.sampled_from("xyz") | st.integers(-5, 5),
    lambda part: st.tuples(st.sampled_from("+-*/"), part, part),
    max_leaves=10,
)


def compute(tree, leaves, number, divide=operator.truediv):
    if isinstance(tree, str):
        return leaves[tree]
    if isinstance(tree, int):
        return number(tree)
    left, right = (compute(part, leaves, number, divide) for part in tree[1:])
    return {"+": operator.add, "-": operator.sub, "*": operator.mul, "/": divide}[tree[0]](left, right)


@given(trees)
def test_text_is_parsed_back_to_the_same_function(tree):
    point = {"x": Fraction(7, 3), "y": Fraction(-11, 5), "z": Fraction(13, 2)}
    try:
        value = compute(tree, point, Fraction)
    except ZeroDivisionError:
        assume(False)
    expression = compute(tree, {"x": x, "y": y, "z": z}, sympy.Integer, over)
    parsed = sympy.sympify(text(expression))
    assert sympy.cancel(parsed - divided(expression)) == 0
    assert parsed.subs({name: sympy.Rational(v.numerator, v.denominator) for name, v in point.items()}) == value


def test_text_of_a_matrix_is_parsed_back():
    matrix = sympy.ImmutableDenseMatrix([[x, over(x, y)], [sympy.Rational(1, 3), x**2 - 1]])
    assert sympy.sympify(text(matrix)) == sympy.Matrix([[x, x / y], [sympy.Rational(1, 3), x**2 - 1]])


def test_text_of_a_reserved_name_is_parsed_back_where_the_names_are_given():
    e, s, n = map(sympy.Symbol, "ESN")
    expression = over(e + s, n) - e
    assert sympy.sympify(text(expression), locals={"E": e, "S": s, "N": n}) == (e + s) / n - e

"""Text becomes expressions, hostile text becomes an error that says where, and nothing is ever evaluated."""

import time
from fractions import Fraction

import pytest
import sympy
from cases import for_each
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from algebroproj_sym import prove
from algebroproj_sym.expressions import ParseError, evaluate, over, parse, parse_zero, text
from algebroproj_sym.expressions.parsing import MAX_NESTING

x, y, z = sympy.symbols("x y z")

READ = {
    "1": 1,
    "x": x,
    "x + y - z": x + y - z,
    "x-(y-z)": x - y + z,
    "2*x**2*y^3": 2 * x**2 * y**3,
    "-x^2": -(x**2),
    "(-x)^2": x**2,
    "x^-2": over(1, x**2),
    "x^(-2)": over(1, x**2),
    "2^3^2": 512,
    "x^(2*3)": x**6,
    "a*-b": -sympy.Symbol("a") * sympy.Symbol("b"),
    "--+-x": -x,
    "6/4": sympy.Rational(3, 2),
    "1/2/3": sympy.Rational(1, 6),
    "x/2": x / 2,
    "x/y/z": over(x, y * z),
    "x/y*z": over(x * z, y),
    "x/(y/z)": over(x, over(y, z)),
    "0.25": sympy.Rational(1, 4),
    ".5 + 1.": sympy.Rational(3, 2),
    "0.1": sympy.Rational(1, 10),
    " x\n+\ty ": x + y,
    "(((x)))": x,
}


@for_each(("written", "expected"), READ.items())
def test_text_is_read_as_mathematics(written, expected):
    point = {s: Fraction(n, 7) for n, s in enumerate([x, y, z, *sympy.symbols("a b")], 3)}
    assert evaluate(parse(written), point) == evaluate(sympy.sympify(expected), point)


NAMES = ["E", "I", "S", "N", "O", "Q", "pi", "oo", "nan", "zoo", "beta", "gamma", "zeta", "lambda", "None", "Matrix"]
NAMES += ["x'", "x''", "x_1", "_", "λ", "α1", "exec", "__import__", "True", "import", "symbols", "sqrt"]


@for_each("name", NAMES)
def test_every_name_is_a_plain_symbol(name):
    assert parse(name) == sympy.Symbol(name)
    assert parse(f"{name}*2 + 1") == 2 * sympy.Symbol(name) + 1


@pytest.mark.parametrize("written", ["1/x - 1/x", "0*(1/x)", "(1/x)^0", "0/x", "x/x", "(1/x)/(1/x)", "x*(1/x)"])
def test_a_pole_that_cancels_is_still_met(written):
    assert prove(written, parse(written)).hypotheses == (x,)
    with pytest.raises(ZeroDivisionError):
        evaluate(parse(written), {x: Fraction(0)})


def test_matrices():
    assert parse("[[x, 1], [0, x/y]]") == sympy.ImmutableDenseMatrix([[x, 1], [0, over(x, y)]])
    assert parse("Matrix([[x], [y]])") == sympy.ImmutableDenseMatrix([x, y])


def test_equations_are_differences():
    assert parse_zero("x^2 = y") == x**2 - y
    assert parse_zero("x - 1") == x - 1


HOSTILE = {
    "": (0, "a number, a name or '('", "the end"),
    "x +": (3, "a number, a name or '('", "the end"),
    "2x": (1, "an operator", "'x'"),
    "x y": (2, "an operator", "'y'"),
    "f(x)": (1, "an operator", "'('"),
    "(x": (2, "an operator or ')'", "the end"),
    "x)": (1, "an operator", "')'"),
    "x = y": (2, "an operator", "'='"),
    "x; y": (1, "a number, a name, an operator or a bracket", "';'"),
    "x.real": (1, "a number, a name, an operator or a bracket", "'.'"),
    "'x'": (0, "a number, a name, an operator or a bracket", '"\'"'),
    "__import__('os')": (10, "an operator", None),
    "1e5": (1, "an operator", "'e5'"),
    "x^y": (2, "an integer as exponent", "y"),
    "x^(1/2)": (2, "an integer as exponent", "1/2"),
    "x^1001": (2, "an exponent of at most 1000", "1001"),
    "9^9^9": (2, "an exponent of at most 1000", "387420489"),
    "x/0": (2, "a divisor that is not zero", "0"),
    "1/(2 - 2)": (2, "a divisor that is not zero", "0"),
    "0^-1": (0, "a divisor that is not zero", "0"),
    "((x^1000)^1000)": (1, "a degree of at most 5000 when multiplied out", "up to 1000000"),
    "(a+b+c+d+e+f+g)^100": (0, "at most 300000 terms when multiplied out", None),
    "((9^999)^999)^999": (None, "coefficients of at most 14000 bits", None),
    "[[x, y], [z]]": (0, "rows of one length", "lengths [1, 2]"),
    "[[x]] + 1": (6, "an operator", "'+'"),
    "[x]": (1, "a row in brackets", "'x'"),
    "²": (0, "a number, a name, an operator or a bracket", "'²'"),
    "(" * 60 + "x" + ")" * 60: (49, "at most 48 levels of nesting", "more"),
    "1/(1+" * 60 + "x" + ")" * 60: (243, "at most 48 levels of nesting", "more"),
    "x" + "^1" * 60: (98, "at most 48 levels of nesting", "more"),
    "-" * 30_000 + "x": (20_000, "at most 20000 tokens", "more"),
    "7" * 1001: (0, "at most 1000 digits", "1001"),
    "x" * 101: (0, "a name of at most 100 characters", "101"),
    "+".join(f"x{i}" for i in range(401)): (None, "at most 400 names", "more"),
    "x" * 200_001: (200_000, "at most 200000 characters", "200001"),
}


@for_each(("written", "error"), HOSTILE.items())
def test_hostile_text_is_an_error_that_says_where_what_was_expected_and_what_was_found(written, error):
    position, expected, got = error
    start = time.monotonic()
    if "__import__" in written:
        position, expected = 11, "a number, a name, an operator or a bracket"
    with pytest.raises(ParseError, match="lhs, position ") as caught:
        parse(written, "lhs")
    assert time.monotonic() - start < 2
    assert position is None or caught.value.position == position
    assert caught.value.expected == expected
    assert got is None or caught.value.got == got


def test_deep_expressions_can_be_proved():
    deep = "1/(1+" * (MAX_NESTING - 1) + "x" + ")" * (MAX_NESTING - 1)
    assert prove(deep, deep).verdict == "proved"


@given(st.text(max_size=60) | st.text(alphabet="xyEI01239.+-*/^()[], ='", max_size=60))
@settings(max_examples=4 * settings.default.max_examples)
def test_any_text_is_an_expression_or_a_parse_error(written):
    try:
        result = parse(written)
    except ParseError as error:
        result, place = x, error.position
    else:
        place = 0
    assert 0 <= place <= len(written)
    assert isinstance(result, sympy.Expr | sympy.ImmutableDenseMatrix)


trees = st.recursive(
    st.sampled_from(["x", "y", "E", "beta"]) | st.fractions(-9, 9, max_denominator=7),
    lambda part: st.tuples(st.sampled_from("+-*/"), part, part) | st.tuples(st.just("^"), part, st.integers(-3, 3)),
    max_leaves=8,
)
POINT = dict(zip(sympy.symbols("x y E beta"), map(Fraction, ("17/3", "-23/7", "29/11", "3")), strict=True))


def built(tree):
    if isinstance(tree, str):
        return sympy.Symbol(tree)
    if isinstance(tree, Fraction):
        return sympy.Rational(tree.numerator, tree.denominator)
    left = built(tree[1])
    if tree[0] == "^":
        return left ** tree[2]
    right = built(tree[2])
    return {"+": left + right, "-": left - right, "*": left * right, "/": left / right if right != 0 else left}[tree[0]]


@given(trees)
def test_what_the_ledger_prints_is_read_back(tree):
    expression = built(tree)
    assume(not expression.has(sympy.zoo, sympy.nan))
    try:
        value = evaluate(expression, POINT)
    except ZeroDivisionError:
        assume(False)
    assert evaluate(parse(text(expression)), POINT) == value


@given(st.lists(trees, min_size=4, max_size=4))
def test_matrices_of_the_ledger_are_read_back(entries):
    matrix = sympy.ImmutableDenseMatrix(2, 2, [built(entry) for entry in entries])
    assume(not matrix.has(sympy.zoo, sympy.nan))
    assert parse(text(matrix)).shape == (2, 2)


def test_text_that_is_no_text_is_a_type_error():
    with pytest.raises(TypeError, match="lhs: expected text, got int"):
        parse(3, "lhs")
    with pytest.raises(TypeError, match="constraints: expected a sequence"):
        prove("x", "x", constraints="x - y")

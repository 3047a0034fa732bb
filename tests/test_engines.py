"""Both polynomial arithmetics compute the same, and what plain fractions say."""

from collections import Counter
from fractions import Fraction

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym.proving.engines import ENGINES, ring
from algebroproj_sym.proving.rational_function import RationalFunctionField

NAMES = ["x", "y", "z"]
SYMBOLS = sympy.symbols(NAMES)
each_engine = pytest.mark.parametrize("engine", ["flint", "sympy"])

coefficients = st.fractions(-50, 50, max_denominator=9).filter(bool)
powers = st.tuples(*[st.integers(0, 3)] * 3)
polynomials = st.dictionaries(powers, coefficients, max_size=5)
factors = st.dictionaries(st.tuples(*[st.integers(0, 1)] * 3), coefficients, min_size=1, max_size=3)


def product(left, right):
    result = Counter()
    for a, p in left.items():
        for b, q in right.items():
            result[tuple(i + j for i, j in zip(a, b, strict=True))] += p * q
    return {key: value for key, value in result.items() if value}


def total(left, right):
    result = Counter(left)
    for key, value in right.items():
        result[key] += value
    return {key: value for key, value in result.items() if value}


def as_poly(terms):
    return sympy.Poly({key: sympy.Rational(v.numerator, v.denominator) for key, v in terms.items()}, *SYMBOLS)


def normalised(terms):
    """The factor over the rationals that has leading coefficient one."""
    leading = terms[max(terms)]
    return tuple(sorted((key, value / leading) for key, value in terms.items()))


def test_there_are_two_engines():
    assert set(ENGINES) == {"flint", "sympy"}


@pytest.mark.parametrize("name", ["singular", "", "Flint", None])
def test_an_unknown_engine_is_refused_by_name(name):
    with pytest.raises(ValueError, match=f"flint, sympy, got {name!r}"):
        ring(name, NAMES)


@each_engine
@given(polynomials)
def test_terms_are_what_a_polynomial_is_made_of(engine, terms):
    names = ring(engine, NAMES)
    assert names.terms(names.polynomial(terms)) == terms


@each_engine
@given(polynomials, polynomials)
def test_arithmetic_is_that_of_plain_dictionaries(engine, left, right):
    names = ring(engine, NAMES)
    a, b = names.polynomial(left), names.polynomial(right)
    assert names.terms(a * b) == product(left, right)
    assert names.terms(a + b) == total(left, right)
    assert names.terms(a - b) == total(left, {key: -value for key, value in right.items()})
    assert names.terms(a - a) == {}
    assert names.terms(a**3) == product(left, product(left, left))


@each_engine
def test_generators_come_in_the_order_of_the_names(engine):
    names = ring(engine, ["b", "a"])
    assert [names.terms(generator) for generator in names.generators] == [{(1, 0): 1}, {(0, 1): 1}]


@each_engine
@given(st.fractions())
def test_constants_are_exact(engine, value):
    names = ring(engine, NAMES)
    assert names.terms(names.constant(value)) == ({(0, 0, 0): value} if value else {})


@each_engine
def test_large_numbers_are_exact(engine):
    value = Fraction(3**200, 7**150)
    names = ring(engine, ["x"])
    x = names.generators[0]
    assert names.terms((x + names.constant(value)) * (x - names.constant(value))) == {(2,): 1, (0,): -(value**2)}


@each_engine
@given(st.lists(st.tuples(factors, st.integers(1, 2)), min_size=1, max_size=3))
def test_factors_multiply_back_and_are_irreducible(engine, parts):
    names = ring(engine, NAMES)
    polynomial = names.constant(Fraction(1))
    for terms, multiplicity in parts:
        polynomial = polynomial * names.polynomial(terms) ** multiplicity
    content, found = names.factor(polynomial)
    product_of_all = {(0, 0, 0): content}
    for factor, multiplicity in found:
        assert as_poly(names.terms(factor)).is_irreducible
        for _ in range(multiplicity):
            product_of_all = product(product_of_all, names.terms(factor))
    assert product_of_all == names.terms(polynomial)


@given(st.lists(factors, min_size=1, max_size=3))
def test_both_engines_find_the_same_factors(parts):
    found = []
    for engine in ENGINES:
        names = ring(engine, NAMES)
        polynomial = names.constant(Fraction(1))
        for terms in parts:
            polynomial = polynomial * names.polynomial(terms)
        found.append(Counter({normalised(names.terms(f)): n for f, n in names.factor(polynomial)[1]}))
    assert found[0] == found[1]


@given(st.lists(factors, min_size=1, max_size=3))
def test_normalised_factors_are_primitive_positive_and_the_same_in_both_engines(parts):
    found = []
    for engine in ENGINES:
        field = RationalFunctionField(SYMBOLS, engine)
        polynomial = field.ring.constant(Fraction(1))
        for terms in parts:
            polynomial = polynomial * field.ring.polynomial(terms)
        content, irreducible = field.irreducible(polynomial)
        for factor, _ in irreducible:
            values = as_poly(field.ring.terms(factor))
            assert values.primitive()[0] == 1
            assert values.LC() > 0
        found.append((content, Counter({str(field.expression(factor)): n for factor, n in irreducible})))
    assert found[0] == found[1]


@each_engine
@given(st.lists(st.tuples(factors, st.integers(1, 3)), min_size=1, max_size=2))
def test_normalised_factors_and_content_multiply_back(engine, parts):
    field = RationalFunctionField(SYMBOLS, engine)
    polynomial = field.ring.constant(Fraction(1))
    for terms, multiplicity in parts:
        polynomial = polynomial * field.ring.polynomial(terms) ** multiplicity
    content, irreducible = field.irreducible(polynomial)
    product_of_all = {(0, 0, 0): content}
    for factor, multiplicity in irreducible:
        for _ in range(multiplicity):
            product_of_all = product(product_of_all, field.ring.terms(factor))
    assert product_of_all == field.ring.terms(polynomial)


@each_engine
@pytest.mark.parametrize(
    ("names", "value"), [([], Fraction(-3, 4)), (["x"], Fraction(5)), (NAMES, Fraction(1)), (NAMES, Fraction(-6, 7))]
)
def test_a_constant_is_its_own_content(engine, names, value):
    over_names = ring(engine, names)
    assert over_names.factor(over_names.constant(value)) == (value, [])


@each_engine
def test_a_ring_without_variables_is_the_rationals(engine):
    rationals = ring(engine, [])
    a, b = rationals.constant(Fraction(2, 3)), rationals.constant(Fraction(-1, 6))
    assert rationals.generators == ()
    assert rationals.terms(a * b + a) == {(): Fraction(5, 9)}
    assert rationals.terms(a - a) == {}


@each_engine
@pytest.mark.parametrize(
    "name", ["E", "I", "N", "O", "Q", "S", "beta", "gamma", "zeta", "lambda", "gens", "ngens", "one"]
)
def test_reserved_names_are_variables_like_any_other(engine, name):
    names = ring(engine, [name, "x"])
    a, x = names.generators
    assert names.terms((a - x) * (a + x)) == {(2, 0): 1, (0, 2): -1}


@each_engine
@pytest.mark.parametrize("name", ["x_1", "x'", "y_{0,1}", "a b", "x:3", "\\alpha", "(a)"])
def test_names_with_punctuation_are_one_variable(engine, name):
    names = ring(engine, ["c", name])
    assert len(names.generators) == 2
    assert names.terms(names.generators[1] ** 2) == {(0, 2): 1}

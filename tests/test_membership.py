"""Cofactors of an ideal member, found without Groebner bases and never believed unless they multiply out."""

from fractions import Fraction

import pytest
import sympy
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from algebroproj_sym.proving.engines import ring
from algebroproj_sym.proving.membership import cofactors

x, y, z = SYMBOLS = sympy.symbols("x y z")
each_engine = pytest.mark.parametrize("engine", ["flint", "sympy"])

coefficients = st.fractions(-6, 6, max_denominator=3).filter(bool)
powers = st.tuples(*[st.integers(0, 2)] * 3).filter(lambda p: sum(p) <= 2)
polynomials = st.dictionaries(powers, coefficients, min_size=1, max_size=3).map(
    lambda terms: sympy.Add(
        *(
            sympy.Rational(v.numerator, v.denominator) * sympy.Mul(*(s**n for s, n in zip(SYMBOLS, p, strict=True)))
            for p, v in terms.items()
        )
    )
)
through_the_origin = polynomials.map(lambda g: g - g.subs({x: 0, y: 0, z: 0})).filter(bool)


def find(engine, polynomial, generators):
    """The cofactors as SymPy expressions, or None."""
    names = ring(engine, [symbol.name for symbol in SYMBOLS])

    def into(expression):
        poly = sympy.Poly(expression, *SYMBOLS)
        return names.polynomial({p: Fraction(int(c.p), int(c.q)) for p, c in poly.terms() if c})

    found = cofactors(names, into(polynomial), [into(generator) for generator in generators])
    if found is None:
        return None
    return [
        sympy.Poly.from_dict(
            {p: sympy.Rational(c.numerator, c.denominator) for p, c in names.terms(part).items()} or {(0, 0, 0): 0},
            *SYMBOLS,
        ).as_expr()
        for part in found
    ]


def combined(parts, generators):
    return sympy.expand(sympy.Add(*(c * g for c, g in zip(parts, generators, strict=True))))


MEMBERS = {
    "a generator": (x**2 - 1, [x**2 - 1]),
    "a multiple": (x**3 - x, [x**2 - 1]),
    "a parameter": (z * x**2 - z, [x**2 - 1]),
    "two generators": (x**2 * y - x, [x * y - 1, y**2 - x]),
    "one": (sympy.Integer(1), [x, x - 1]),
    "one of a constant": (sympy.Integer(1), [sympy.Integer(3)]),
    "cancelling": (x - y, [x * z - y * z, z - 1]),
    "higher cofactors": (sympy.Integer(1), [x * y - 1, x]),
    "zero": (sympy.Integer(0), [x, y]),
    "beside zero": (x * y, [sympy.Integer(0), x]),
    "fractions": (x / 3 + y / 7, [x / 5, y / 2]),
}
OTHERS = {
    "another variable": (y, [x]),
    "a root": (x, [x**2]),
    "a factor": (x - 1, [x**2 - 1]),
    "one at a common zero": (sympy.Integer(1), [x, y, x * y - z]),
    "a real zero": (x, [x**2 + y**2]),
    "no generator": (x, []),
    "a zero generator": (x, [sympy.Integer(0)]),
    "a constant": (sympy.Integer(1), [sympy.Integer(0)]),
}


@each_engine
@pytest.mark.parametrize(("polynomial", "generators"), MEMBERS.values(), ids=MEMBERS)
def test_members_have_cofactors(engine, polynomial, generators):
    parts = find(engine, polynomial, generators)
    assert parts is not None
    assert combined(parts, generators) == sympy.expand(polynomial)


@each_engine
@pytest.mark.parametrize(("polynomial", "generators"), OTHERS.values(), ids=OTHERS)
def test_others_have_none(engine, polynomial, generators):
    assert find(engine, polynomial, generators) is None


@each_engine
def test_zero_is_the_empty_combination(engine):
    assert find(engine, sympy.Integer(0), []) == []


@each_engine
@given(polynomials, polynomials)
@settings(max_examples=15)
def test_every_multiple_of_one_generator_is_found(engine, cofactor, generator):
    parts = find(engine, sympy.expand(cofactor * generator), [generator])
    assert parts == [sympy.expand(cofactor)]


@each_engine
@given(st.lists(polynomials, min_size=2, max_size=2), st.lists(polynomials, min_size=2, max_size=2))
@settings(max_examples=15)
def test_whatever_is_found_multiplies_out(engine, parts, generators):
    polynomial = combined(parts, generators)
    found = find(engine, polynomial, generators)
    if found is not None:
        assert combined(found, generators) == polynomial


@each_engine
@given(st.lists(polynomials, min_size=2, max_size=2), st.lists(through_the_origin, min_size=2, max_size=2))
@settings(max_examples=15)
def test_what_does_not_vanish_at_a_common_zero_is_no_member(engine, parts, generators):
    assert find(engine, combined(parts, generators) + 1, generators) is None


@given(polynomials, polynomials, st.lists(through_the_origin, min_size=2, max_size=2))
@settings(max_examples=15)
def test_both_engines_decide_alike(first, second, generators):
    polynomial = sympy.expand(first * generators[0] + second * generators[1])
    assume(polynomial != 0)
    assert find("flint", polynomial, generators) == find("sympy", polynomial, generators)

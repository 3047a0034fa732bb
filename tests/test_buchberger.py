"""Groebner bases: which monomials divide which, and how much may be spent."""

import flint
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym.proving.buchberger import MAX_LENGTH, EffortExceededError, GroebnerBasis, Work

CONTEXT = flint.fmpq_mpoly_ctx.get(("x", "y", "z"), flint.Ordering.degrevlex)
LARGEST = 2**16
exponent = st.one_of(st.integers(0, 3), st.integers(0, LARGEST // 3), st.sampled_from([255, 256, 257, LARGEST // 3]))
powers = st.tuples(exponent, exponent, exponent)


def monomial(*exponents):
    return CONTEXT.from_dict({exponents: 1})


@given(powers, powers)
def test_a_monomial_lies_in_the_ideal_of_another_exactly_if_that_divides_it(left, right):
    divides = all(a <= b for a, b in zip(left, right, strict=True))
    assert (GroebnerBasis([monomial(*left)]).remainder(monomial(*right)) == 0) is divides


@given(st.lists(powers, min_size=2, max_size=4, unique=True))
def test_the_basis_of_monomials_is_that_of_those_that_no_other_divides(generators):
    basis = GroebnerBasis([monomial(*generator) for generator in generators])
    for generator in generators:
        assert basis.remainder(monomial(*generator)) == 0
        below = (max(generator[0] - 1, 0), *generator[1:])
        member = any(all(a <= b for a, b in zip(other, below, strict=True)) for other in generators)
        assert (basis.remainder(monomial(*below)) == 0) is member


@pytest.mark.parametrize("large", [2**15, 2**16, 2**40])
def test_exponents_may_be_large_but_steps_may_not_be_many(large):
    x, y, _ = CONTEXT.gens()
    assert GroebnerBasis([monomial(large, 0, 0)]).remainder(monomial(large, 1, 0)) == 0
    assert GroebnerBasis([y]).remainder(monomial(large, 0, 0)) == monomial(large, 0, 0)
    with pytest.raises(EffortExceededError):
        GroebnerBasis([monomial(large, 0, 0), x * y - 1])


polynomial = st.dictionaries(st.tuples(*[st.integers(0, 2)] * 3), st.integers(-3, 3), max_size=4).map(CONTEXT.from_dict)


@given(st.lists(polynomial.filter(bool), min_size=2, max_size=2), st.tuples(polynomial, polynomial))
def test_the_cofactors_of_what_lies_in_the_ideal_multiply_out(generators, parts):
    member = sum(part * generator for part, generator in zip(parts, generators, strict=True))
    try:
        cofactors = GroebnerBasis(generators, 500).cofactors(member)
    except EffortExceededError:
        return
    assert sum(part * generator for part, generator in zip(cofactors, generators, strict=True)) == member


def test_the_cofactors_of_every_generator_are_added_up():
    x, y, z = CONTEXT.gens()
    generators = [x * y - z, y**2 - x, x * z - y]
    basis = GroebnerBasis(generators)
    for parts in ([x, y, z], [z - 1, 2 * x, y**2], [y * z, x - z, 1 - x * y]):
        member = sum(part * generator for part, generator in zip(parts, generators, strict=True))
        cofactors = basis.cofactors(member)
        assert sum(part * generator for part, generator in zip(cofactors, generators, strict=True)) == member


def test_the_effort_is_bounded_in_steps_and_in_length():
    x, y, z = CONTEXT.gens()
    basis = GroebnerBasis([x - y], steps=3)
    assert basis.remainder(x**3) == y**3
    with pytest.raises(EffortExceededError):
        basis.remainder(x)
    long = (1 + x + y + z) ** 25
    assert len(long) > MAX_LENGTH
    with pytest.raises(EffortExceededError):
        GroebnerBasis([x - y]).remainder(long)
    assert GroebnerBasis([x**26 - y]).remainder(long) == long


def test_bases_share_what_they_may_cost_together():
    x, y, z = CONTEXT.gens()
    generators = [x * y - z, y**2 - x, x * z - y]
    once, together = Work(), Work()
    GroebnerBasis(generators, work=once)
    cost = Work().left - once.left
    together.left = 2 * cost
    for _ in range(2):
        GroebnerBasis(generators, work=together)
    with pytest.raises(EffortExceededError):
        GroebnerBasis(generators, work=together)


def test_the_reduced_basis_is_that_of_sympy():
    x, y, z = CONTEXT.gens()
    a, b, c = sympy.symbols("x y z")
    generators = [x**2 * y - z, y**2 * z - x, z**2 * x - y]
    basis = GroebnerBasis(generators)
    known = sympy.groebner([a**2 * b - c, b**2 * c - a, c**2 * a - b], a, b, c, order="grevlex")
    for element in known.exprs:
        terms = {p: int(v) for p, v in sympy.Poly(element, a, b, c).terms()}
        assert basis.remainder(CONTEXT.from_dict(terms)) == 0
    assert (basis.remainder(x * y * z - 1) == 0) is bool(known.contains(a * b * c - 1))

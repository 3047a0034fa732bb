"""Sums of squares are found where they exist, and what is found is exact."""

from fractions import Fraction

import flint
import pytest
import sympy
from hypothesis import assume, given
from hypothesis import strategies as st

from algebroproj_sym import prove
from algebroproj_sym.proving.buchberger import GroebnerBasis
from algebroproj_sym.proving.semidefinite import squares_in_ideal
from algebroproj_sym.proving.squares import sum_of_squares, vanishing_squares
from algebroproj_sym.proving.varieties import real_points, value_at
from algebroproj_sym.replaying import replay_identity

CONTEXT = flint.fmpq_mpoly_ctx.get(("x", "y", "z", "spare"), flint.Ordering.degrevlex)
x, y, z, _ = CONTEXT.gens()

coefficients = st.integers(-3, 3)
forms = st.lists(st.tuples(*[coefficients] * 3), min_size=1, max_size=4)


def total(squares):
    return sum(weight * root**2 for weight, root in squares)


def is_integral(polynomial):
    return all(value.q == 1 for value in polynomial.coeffs())


DEFINITE = {
    "fourth powers": x**4 + y**4,
    "cyclotomic": x**4 + x**3 * y + x**2 * y**2 + x * y**3 + y**4,
    "means of three": x**6 + y**6 + z**6 - 3 * x**2 * y**2 * z**2,
    "Motzkin": x**4 * y**2 + x**2 * y**4 + z**6 - 3 * x**2 * y**2 * z**2,
    "positive": x**4 + y**4 + z**4 - 4 * x * y * z + x + y + z + 3,
    "Lagrange": (x**2 + y**2) * (z**2 + 1) - (x * z + y) ** 2,
}


@pytest.mark.parametrize("polynomial", DEFINITE.values(), ids=DEFINITE)
def test_squares_add_up_to_a_multiple(polynomial):
    squares, (factor,) = vanishing_squares([polynomial], 1)
    assert all(weight > 0 and is_integral(root) for weight, root in squares)
    assert total(squares) == factor * polynomial


@pytest.mark.parametrize("polynomial", [x**2 - y**2, x**3 + y, x * y, x**4 + y**4 - 3 * x**2 * y**2])
def test_what_changes_its_sign_is_no_sum_of_squares(polynomial):
    assert vanishing_squares([polynomial], 1) is None
    assert sum_of_squares(polynomial) is None


@given(st.tuples(*[coefficients] * 6))
def test_completed_squares_have_positive_weights_and_add_up(chosen):
    """A quadratic polynomial is a sum of squares if it is not negative anywhere, and no other is."""
    a, b, c, d, e, f = chosen
    polynomial = a * x**2 + b * x * y + c * y**2 + d * x + e * y + f + 0 * z
    gram = sympy.Matrix([[2 * a, b, d], [b, 2 * c, e], [d, e, 2 * f]])
    squares = sum_of_squares(polynomial)
    assert (squares is not None) == gram.is_positive_semidefinite
    assert all(weight > 0 for weight, _ in squares or ())
    assert squares is None or total(squares) == polynomial


@given(forms)
def test_squares_of_quadratic_forms_are_found_again(chosen):
    polynomial = sum((a * x**2 + b * x * y + c * y**2) ** 2 for a, b, c in chosen)
    assume(polynomial != 0)
    squares, (factor,) = vanishing_squares([polynomial], 1)
    assert all(weight > 0 for weight, _ in squares)
    assert total(squares) == factor * polynomial


@given(st.lists(st.tuples(*[coefficients] * 6), min_size=1, max_size=3))
def test_what_is_found_in_an_ideal_lies_in_it_and_its_roots_do_not(chosen):
    monomials = (x**2, x * y, y**2, x, y, CONTEXT.constant(1))
    generators = [sum(c * m for c, m in zip(row, monomials, strict=True)) for row in chosen]
    assume(all(generator != 0 for generator in generators))
    basis = GroebnerBasis(generators)
    squares = squares_in_ideal(basis, 2, []) or []
    assert basis.normal_form(CONTEXT.constant(0) + total(squares)) == 0
    assert all(weight > 0 and basis.normal_form(root) != 0 for weight, root in squares)


REAL = {
    "odd powers": ("x", "y", ["x^7 = y^7"]),
    "a factor that never vanishes": ("x", "0", ["x*(y^4 + y^3 + y^2 + y + 1) = 0"]),
    "cases in cases": ("x", "y", ["(x - y)*(x^2 + y^2 + 1)*(x^4 + y^4) = 0"]),
    "an ideal": ("a", "c", ["a^2 + b^2 = 1", "c^2 + d^2 = 1", "a*c + b*d = 1"]),
    "a named product": ("(x + y)^2", "5 + 2*z", ["z = x*y", "x^2 = 2", "y^2 = 3"]),
}


@pytest.mark.parametrize(("lhs", "rhs", "constraints"), REAL.values(), ids=REAL)
def test_what_holds_over_the_reals_is_proved_and_replayed(lhs, rhs, constraints):
    proof = prove(lhs, rhs, constraints=constraints)
    assert proof.verdict == "proved"
    certificate = dict(proof.certificate)
    record = {"lhs": lhs, "rhs": rhs, "constraints": constraints, "nonzero": [], "verdict": "proved", "name": "real"}
    record |= {"file": "real.json", "hypotheses": [], "counterexample": None, "certificate": certificate}
    record |= {"expected": None, "method": certificate["method"], "reason": None}
    assert replay_identity(record).status == "replayed"


@pytest.mark.parametrize(
    ("lhs", "rhs", "constraints"),
    [
        ("x", "y", ["x^6 = y^6"]),
        ("x", "0", ["x^4 - y^4 = 0"]),
        ("x*y", "z*w", ["x^2 + y^2 + z^2 + w^2 = 1"]),
        ("(x + y)^2", "5 - 2*z", ["z = x*y", "x^2 = 2", "y^2 = 3"]),
        ("x", "y", ["x^2 + y^2 + z^2 + w^2 + v^2 = 1/7"]),
    ],
)
def test_what_does_not_is_refuted(lhs, rhs, constraints):
    assert prove(lhs, rhs, constraints=constraints).verdict == "refuted"


def test_two_roots_that_one_does_not_give_are_taken_together():
    members = [x**2 - 2, y**2 - 3, z - x * y]
    point = next(real_points(members, CONTEXT, 1, 40, extension=True, further=True))
    assert all(value_at(member, point) == 0 for member in members)
    assert point[0].field.polynomial.degree() == 4


@pytest.mark.parametrize("members", [(y**2 - 2, x**2 - 8), (x**2 - 2, y**2 - 8), (y**2 - 2, x**2 - 2 * x * y - 6)])
def test_a_second_root_is_found_in_the_field_of_the_first(members):
    """Whichever variable has the root that makes the field."""
    point = next(real_points(members, CONTEXT, 1, 9, extension=True))
    assert all(value_at(member, point) == 0 for member in members)


def test_small_values_are_tried_on_small_spheres():
    sphere = x**2 + y**2 + z**2 - flint.fmpq(1, 50)
    point = next(real_points([sphere], CONTEXT, 1, 40, extension=True, further=True))
    assert value_at(sphere, point) == Fraction(0)

"""Generated functions in any arithmetic: against exact fractions, and each other."""

from fractions import Fraction

import flint
import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import algebroproj
from algebroproj_sym.study.arithmetics import (
    arb,
    double_double,
    double_double_balls,
    float64,
    float64_balls,
    mpmath_digits,
    rational,
)
from algebroproj_sym.study.precision import apply, lift, nearest, radius

Z = [[0, -0.975, -0.125], [1, -0.025, 0.075], [0.125, -0.08, 0.001]]
INEXACT = (float64(), double_double(), float64_balls(), double_double_balls(), mpmath_digits(50), arb(200))
BALLS = (float64_balls(), double_double_balls(), arb(120))


def names(arithmetic):
    return arithmetic.name


def left_epipole(matrix):
    """The left epipole as the cross product of two rows of the transposed matrix, in fractions."""
    z = [[Fraction(entry) for entry in row] for row in matrix]
    a, b = ([row[k] for row in z] for k in (1, 2))
    cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    return [cross[1] / cross[0], cross[2] / cross[0]]


@pytest.mark.parametrize("arithmetic", INEXACT, ids=names)
def test_every_arithmetic_has_the_digits_it_says(arithmetic):
    left, _ = apply(arithmetic, algebroproj.correlation.epipoles, lift(arithmetic, Z))
    found = nearest(arithmetic, left)
    wanted = left_epipole(Z)
    tolerance = Fraction(10) ** -min(30, int(arithmetic.digits) - 2)
    for high, low, exact in zip(found.hi, found.lo, wanted, strict=True):
        assert abs(Fraction(float(high)) + Fraction(float(low)) - exact) <= tolerance * abs(exact)


def test_rational_numbers_are_exact():
    left, _ = apply(rational(), algebroproj.correlation.epipoles, lift(rational(), Z))
    assert [Fraction(int(x.p), int(x.q)) for x in left[0]] == left_epipole(Z)


@given(st.lists(st.floats(-4, 4), min_size=9, max_size=9), st.sampled_from(BALLS))
def test_balls_enclose_the_exact_value(entries, arithmetic):
    matrix = np.reshape(entries, (3, 3))
    try:
        exact = left_epipole(matrix.tolist())
    except ZeroDivisionError:
        exact = None
    left, _ = apply(arithmetic, algebroproj.correlation.epipoles, lift(arithmetic, matrix))
    found, off = nearest(arithmetic, left), radius(arithmetic, left)
    if exact is None:
        assert not np.isfinite(off).any()
        return
    for high, low, bound, value in zip(found.hi, found.lo, off, exact, strict=True):
        if np.isfinite(bound):
            assert abs(Fraction(float(high)) + Fraction(float(low)) - value) <= Fraction(float(bound))


@pytest.mark.parametrize("arithmetic", BALLS, ids=names)
def test_balls_of_uncertain_input_enclose_what_any_input_in_them_gives(arithmetic):
    generator = np.random.default_rng(5)
    off = 1e-6
    left, _ = apply(arithmetic, algebroproj.correlation.epipoles, lift(arithmetic, Z, off))
    centre, bound = nearest(arithmetic, left).hi, radius(arithmetic, left)
    assert (bound < 0.1).all()
    for moved in np.array(Z) + off * generator.uniform(-1, 1, (200, 3, 3)):
        exact = left_epipole(moved.tolist())
        assert all(abs(float(e) - c) <= b for e, c, b in zip(exact, centre, bound, strict=True))


@pytest.mark.parametrize("arithmetic", [*INEXACT, rational()], ids=names)
def test_leading_dimensions_broadcast(arithmetic):
    points = np.arange(12.0).reshape(2, 3, 2) / 8
    lines = apply(arithmetic, algebroproj.correlation.epipolar_line_left, lift(arithmetic, Z), lift(arithmetic, points))
    assert lines.shape == (arithmetic.parts, 2, 3, 3)
    one = apply(
        arithmetic, algebroproj.correlation.epipolar_line_left, lift(arithmetic, Z), lift(arithmetic, points[1, 2])
    )
    assert nearest(arithmetic, lines).hi[1, 2].tolist() == nearest(arithmetic, one).hi.tolist()


@pytest.mark.parametrize("arithmetic", INEXACT, ids=names)
def test_a_singular_member_does_not_spoil_the_others(arithmetic):
    generator = np.random.default_rng(1)
    left, right = generator.uniform(-1, 1, (2, 3, 5, 2))
    left[1], right[1] = left[1, :1], right[1, :1]
    found = apply(
        arithmetic, algebroproj.correlation.correlation_matrix, lift(arithmetic, left), lift(arithmetic, right)
    )
    alone = apply(
        arithmetic, algebroproj.correlation.correlation_matrix, lift(arithmetic, left[2]), lift(arithmetic, right[2])
    )
    assert nearest(arithmetic, found).hi[2].tolist() == nearest(arithmetic, alone).hi.tolist()
    if arithmetic.encloses:
        assert not np.isfinite(radius(arithmetic, found)[1][1:, 1]).any()
        assert np.isfinite(radius(arithmetic, found)[[0, 2]]).all()
    else:
        assert not np.isfinite(nearest(arithmetic, found).hi[1][1:, 1]).any()


def test_null_vectors_agree():
    generator = np.random.default_rng(2)
    left, right = generator.uniform(-1, 1, (2, 4, 8, 2))
    function = algebroproj.correlation.general_correlation_matrix
    found = {a.name: nearest(a, apply(a, function, lift(a, left), lift(a, right))).hi for a in INEXACT}
    for values in found.values():
        np.testing.assert_allclose(values, found["arb 200 bits"], rtol=1e-10)
    bounded = apply(arb(200), function, lift(arb(200), left), lift(arb(200), right))
    assert (radius(arb(200), bounded) < 1e-30).all()


def test_angles_in_every_arithmetic():
    with mpmath.workdps(60):
        wanted = mpmath.cos(mpmath.mpf(0.5)), mpmath.sin(mpmath.mpf(0.5))
    for arithmetic in INEXACT:
        rotation = apply(arithmetic, algebroproj.metric.rotation_left, lift(arithmetic, 0.0), lift(arithmetic, 0.5))
        found = nearest(arithmetic, rotation)
        with mpmath.workdps(60):
            sums = [
                abs(mpmath.mpf(float(h)) + mpmath.mpf(float(r)))
                for h, r in zip(found.hi.flat, found.lo.flat, strict=True)
            ]
            for value in wanted:
                assert min(abs(entry - value) for entry in sums) < mpmath.mpf(10) ** -min(30, arithmetic.digits - 1)


def test_precision_is_a_matter_of_the_context_alone():
    before = flint.ctx.prec, mpmath.mp.dps
    for arithmetic in (arb(300), mpmath_digits(70)):
        apply(arithmetic, algebroproj.correlation.epipoles, lift(arithmetic, Z))
    assert (flint.ctx.prec, mpmath.mp.dps) == before


def test_bad_input_is_named():
    with pytest.raises(ValueError, match="expected Z of shape"):
        apply(float64(), algebroproj.correlation.epipoles, lift(float64(), [1.0, 2.0]))
    with pytest.raises(TypeError, match="expected a generated function"):
        apply(float64(), abs, lift(float64(), 1.0))
    with pytest.raises(TypeError, match="epipoles: expected the arguments Z, got 2"):
        apply(float64(), algebroproj.correlation.epipoles, lift(float64(), Z), lift(float64(), Z))
    with pytest.raises(ValueError, match="finite values, got nan"):
        lift(arb(100), [1.0, np.nan])
    with pytest.raises(ValueError, match="off to be 0 for float64"):
        lift(float64(), [1.0], 0.5)
    with pytest.raises(ValueError, match="at least 0"):
        lift(arb(100), [1.0], -0.5)

"""Nearness to criticality: geometric facts, and a bound that no image within it breaks."""

from dataclasses import replace
from fractions import Fraction

import flint
import numpy as np
import pytest

from algebroproj import DoubleDouble, correlation, critical
from algebroproj_derivations.studies.stereo.accuracy import matrix_error
from algebroproj_derivations.studies.stereo.chain import images
from algebroproj_derivations.studies.stereo.configurations import critical_quadric, near_critical, ordinary
from algebroproj_derivations.studies.stereo.indicators import (
    _singular_values,
    diagnosis,
    eight_point_matrix,
    indicators,
)
from algebroproj_derivations.studies.stereo.rounding import bound_of_correlation, bound_of_epipoles
from algebroproj_derivations.studies.stereo.scenes import TETRAHEDRON
from algebroproj_sym.study.arithmetics import arb, float64, rational
from algebroproj_sym.study.precision import apply, lift


def test_the_critical_quadric_goes_through_centers_and_points():
    scene = ordinary(50, seed=2)
    quadric = critical_quadric(scene)
    for points in (TETRAHEDRON[None], scene.centers, scene.points[:, 4:7]):
        homogeneous = np.insert(np.broadcast_to(points, (50, *points.shape[1:])), 0, 1.0, axis=-1)
        values = np.einsum("nai,nij,naj->na", homogeneous, quadric, homogeneous)
        assert abs(values / (homogeneous**2).sum(axis=-1)).max() < 1e-12


@pytest.mark.parametrize("distance", [1e-3, 1e-5, 1e-8])
def test_scenes_are_as_near_as_asked_for(distance):
    scene = near_critical(40, seed=3, farthest=distance, nearest=distance)
    found = indicators(scene)
    np.testing.assert_allclose(found.sampson, distance, rtol=30 * distance + 1e-4)
    both = images(float64(), scene)
    assert (abs(critical.determinant(both.left[0], both.right[0])) < 100 * distance).all()


def test_members_are_functions_of_seed_and_index():
    whole = near_critical(20, seed=5)
    part = near_critical([13, 4], seed=5)
    np.testing.assert_array_equal(part.points, whole.points[[13, 4]])
    assert (near_critical(20, seed=6).points != whole.points).any()
    with pytest.raises(ValueError, match=r"0 < nearest <= farthest, got 1 and 0\.1"):
        near_critical(3, farthest=0.1, nearest=1)


def test_indicators_are_invariant_or_grow_as_they_should():
    near, nearer = (indicators(near_critical(30, 4, d, d)) for d in (1e-4, 1e-7))
    for name in ("algebraic", "sampson", "sigma_5", "determinant", "relative_sigma_8"):
        ratio = np.median(getattr(nearer, name) / getattr(near, name))
        assert ratio == pytest.approx(1e-3, rel=0.2), name
    for name in ("z_mixed", "z_mean", "epipole_mixed", "epipole_mean"):
        ratio = np.median(getattr(nearer, name) / getattr(near, name))
        assert ratio == pytest.approx(1e3, rel=0.2), name


def test_eight_equations_hold_for_the_correlation():
    both = images(float64(), ordinary(5))
    z = correlation.correlation_matrix(both.left[0], both.right[0]).reshape(5, 9)
    left_over = np.einsum("nij,nj->ni", eight_point_matrix(both.left[0], both.right[0]), z)
    assert abs(left_over).max() < 1e-12


def test_a_fault_of_normalisation_is_not_taken_for_criticality():
    """With both centers and G0, G1 in one plane z10 vanishes, and the five equations are singular, the eight not."""
    scene = ordinary(30, seed=7)
    centers = scene.centers.copy()
    centers[:, 1, 1:] = centers[:, 0, 1:] * np.linspace(0.8, 1.2, 30)[:, None]
    coplanar = replace(scene, centers=centers)
    both = images(rational(), coplanar[np.array([3])])
    exact = apply(rational(), critical.determinant, both.left, both.right)
    assert float(abs(Fraction(int(exact[0, 0].p), int(exact[0, 0].q)))) < 1e-15
    assert set(diagnosis(images(float64(), coplanar))) == {"normalisation"}
    assert set(diagnosis(images(float64(), near_critical(30, 7, 1e-9, 1e-9)))) == {"critical"}
    assert (diagnosis(images(float64(), scene), 1e-9) == "regular").all()
    with pytest.raises(ValueError, match="tolerance between 0 and 1, got 2"):
        diagnosis(both, 2)


@pytest.mark.parametrize("size", [2.0**-53, 1e-9, 1e-5])
def test_no_images_within_the_bounds_break_the_bound(size):
    scene = near_critical(60, seed=9, farthest=1e-1, nearest=1e-6)
    left, right = (u[0] for u in images(float64(), scene))
    off = size * abs(left), size * abs(right)
    matrix, bound = bound_of_correlation(left, right, *off)
    assert np.isfinite(bound).mean() > 0.5
    generator, tight = np.random.default_rng(1), 0.0
    balls = arb(300)
    for kind in range(6):
        signs = [generator.choice([-1.0, 1.0], u.shape) if kind else np.zeros(u.shape) for u in off]
        with flint.ctx.workprec(300):
            moved = [lift(balls, u) + lift(balls, s * o) for u, s, o in zip((left, right), signs, off, strict=True)]
            exact = apply(balls, correlation.correlation_matrix, *moved)[0]
            for place in zip(*np.nonzero(np.isfinite(bound)), strict=True):
                distance = abs(exact[place] - float(matrix[place]))
                assert distance <= flint.arb(float(bound[place]))
                if bound[place] > 0:
                    tight = max(tight, float(distance) / bound[place])
    assert tight > 0.3


@pytest.mark.parametrize("size", [2.0**-53, 1e-9, 1e-5])
def test_no_images_within_the_bounds_turn_an_epipole_farther(size):
    scene = near_critical(40, seed=10, farthest=1e-1, nearest=1e-6)
    left, right = (u[0] for u in images(float64(), scene))
    off = size * abs(left), size * abs(right)
    bounds = bound_of_epipoles(left, right, *off)
    assert np.isfinite(bounds).mean() > 0.1
    computed = correlation.epipoles(correlation.correlation_matrix(left, right))
    generator, tight = np.random.default_rng(2), 0.0
    balls = arb(300)
    for kind in range(8):
        signs = [generator.choice([-1.0, 1.0], u.shape) if kind else np.zeros(u.shape) for u in off]
        with flint.ctx.workprec(300):
            moved = [lift(balls, u) + lift(balls, s * o) for u, s, o in zip((left, right), signs, off, strict=True)]
            exact = apply(balls, correlation.epipoles, apply(balls, correlation.correlation_matrix, *moved))
            for bound, epipole, true in zip(bounds, computed, exact, strict=True):
                for k in np.flatnonzero(np.isfinite(bound)):
                    a = [flint.arb(1), *(flint.arb(float(x)) for x in epipole[k])]
                    b = [flint.arb(1), *true[0, k]]
                    cross = [a[i] * b[j] - a[j] * b[i] for i, j in ((1, 2), (2, 0), (0, 1))]
                    lengths = [sum((x * x for x in v), flint.arb(0)).sqrt() for v in (a, b, cross)]
                    angle = (lengths[2] / lengths[0] / lengths[1]).asin()
                    assert angle <= flint.arb(float(bound[k]))
                    tight = max(tight, float(angle) / bound[k])
    assert tight > 0.2


def test_the_bound_is_the_mixed_condition_to_first_order():
    found = indicators(near_critical(200, 1, 1e-1, 1e-5))
    ratio = found.z_bound / found.z_mixed
    assert np.median(ratio) == pytest.approx(1, abs=0.6)
    assert (ratio > 0.99).all()


def test_singular_values_of_what_is_no_number_are_none_and_spoil_no_others():
    left, right = np.random.default_rng(6).uniform(-1, 1, (2, 3, 5, 2))
    left[1], right[1], left[2] = left[1, :1], right[1, :1], np.nan
    smallest, relative, eighth = _singular_values(left, right)
    for values in (smallest, relative, eighth):
        assert np.isnan(values).tolist() == [False, False, True]
    assert relative[1] < 1e-15


def test_a_singular_pair_has_no_bound():
    scene = ordinary(3, seed=1)
    left, right = (u[0].copy() for u in images(float64(), scene))
    left[1, 4], right[1, 4] = left[1, 3], right[1, 3]
    _, bound = bound_of_correlation(left, right, 0 * left, 0 * right)
    assert np.isinf(bound[1]).any()
    assert np.isfinite(bound[[0, 2]]).all()


def test_measured_errors_do_not_depend_on_the_layout_of_memory():
    """A compiled function returns its matrices row by row, the NumPy source entry by entry."""
    matrices = np.random.default_rng(4).normal(size=(2000, 3, 3))
    reference = DoubleDouble(matrices * (1 + 1e-9 * matrices), np.zeros_like(matrices))
    by_entry = np.moveaxis(np.moveaxis(matrices, 0, -1).copy(), -1, 0)
    assert by_entry.strides != matrices.strides
    np.testing.assert_array_equal(matrix_error(by_entry, reference), matrix_error(matrices, reference))

"""Solutions of linear systems with twice the digits and with bounds, held against exact fractions."""

from fractions import Fraction

import flint
import numpy as np
import pytest

from algebroproj_sym.generating.runtime.arctan2 import arctan2
from algebroproj_sym.generating.runtime.bounded_systems import null_vector_with_bounds, solution_with_bounds
from algebroproj_sym.generating.runtime.cos_sin import cos_sin
from algebroproj_sym.generating.runtime.elimination import null_vector_of, solution_of
from algebroproj_sym.generating.runtime.error_bounds import Bounded
from algebroproj_sym.generating.runtime.pairs import DoubleDouble
from algebroproj_sym.generating.runtime.systems import null_vector, solve

BATCH = 12
nearness = pytest.mark.parametrize("nearness", [1.0, 1e-4, 1e-9])


def systems(height, nearness):
    """Return systems whose last row is near a combination of the first two."""
    rng = np.random.default_rng(height)
    rows = rng.normal(size=(height, height + 1, BATCH))
    rows[-1] = rows[0] + rows[1] + nearness * rng.normal(size=(height + 1, BATCH))
    return rows


def exact_solution(matrix, right):
    entries = flint.fmpq_mat(
        len(matrix), len(matrix), [flint.fmpq(*v.as_integer_ratio()) for row in matrix for v in row]
    )
    column = flint.fmpq_mat(len(matrix), 1, [flint.fmpq(*v.as_integer_ratio()) for v in right])
    return [Fraction(int(v.p), int(v.q)) for v in entries.solve(column).entries()]


def exact_null_vector(matrix, one):
    columns = [j for j in range(len(matrix) + 1) if j != one]
    values = exact_solution([[row[j] for j in columns] for row in matrix], [-row[one] for row in matrix])
    return dict(zip(columns, values, strict=True)) | {one: Fraction(1)}


def value_of(pair, member):
    return Fraction(float(pair.hi[member])) + Fraction(float(pair.lo[member]))


@nearness
def test_solutions_of_pairs_have_twice_the_digits_less_those_of_the_condition(nearness):
    rows = systems(5, nearness)
    unknowns = solution_of([[DoubleDouble(entry) for entry in row] for row in rows])
    for member in range(BATCH):
        exact = exact_solution(rows[:, :-1, member].tolist(), rows[:, -1, member].tolist())
        largest = max(map(abs, exact))
        for unknown, truth in zip(unknowns, exact, strict=True):
            assert abs(value_of(unknown, member) - truth) <= Fraction(1e-27 / nearness) * largest


@nearness
def test_null_vectors_of_pairs(nearness):
    rows = systems(6, nearness)
    vector = null_vector_of([[DoubleDouble(entry) for entry in row] for row in rows])
    for member in range(BATCH):
        one = next(j for j, component in enumerate(vector) if value_of(component, member) == 1)
        exact = exact_null_vector(rows[:, :, member].tolist(), one)
        for place, component in enumerate(vector):
            assert abs(value_of(component, member)) <= 1
            assert abs(value_of(component, member) - exact[place]) <= Fraction(1e-27 / nearness)


@nearness
def test_bounds_of_solutions_hold_and_are_near(nearness):
    rows = systems(5, nearness)
    unknowns = solution_with_bounds([[Bounded(entry, np.zeros(BATCH)) for entry in row] for row in rows], solve)
    ratios = []
    for member in range(BATCH):
        exact = exact_solution(rows[:, :-1, member].tolist(), rows[:, -1, member].tolist())
        for unknown, truth in zip(unknowns, exact, strict=True):
            error = abs(Fraction(float(unknown.value[member])) - truth)
            assert error <= Fraction(float(unknown.error[member]))
            ratios += [float(Fraction(float(unknown.error[member])) / error)] if error else []
    assert np.median(ratios) < 100


def test_bounds_of_solutions_cover_uncertain_entries():
    rows, moved = systems(5, 1.0), systems(5, 1.0)
    uncertainty = 1e-3
    rng = np.random.default_rng(3)
    moved += rng.choice([-uncertainty, uncertainty], size=moved.shape)
    entries = [[Bounded(entry, np.full(BATCH, uncertainty)) for entry in row] for row in rows]
    unknowns = solution_with_bounds(entries, solve)
    finite = [member for member in range(BATCH) if np.isfinite(unknowns[0].error[member])]
    assert len(finite) > BATCH / 2
    for member in finite:
        exact = exact_solution(moved[:, :-1, member].tolist(), moved[:, -1, member].tolist())
        for unknown, truth in zip(unknowns, exact, strict=True):
            assert abs(float(unknown.value[member]) - truth) <= unknown.error[member]


@nearness
def test_bounds_of_null_vectors_hold(nearness):
    rows = systems(8, nearness)
    entries = [[Bounded(entry, np.zeros(BATCH)) for entry in row] for row in rows]
    vector = null_vector_with_bounds(entries, null_vector, solve)
    for member in range(BATCH):
        one = next(j for j, component in enumerate(vector) if component.value[member] == 1)
        exact = exact_null_vector(rows[:, :, member].tolist(), one)
        for place, component in enumerate(vector):
            error = abs(Fraction(float(component.value[member])) - exact[place])
            assert error <= Fraction(float(component.error[member]))


def test_two_largest_components_have_no_bound():
    entries = [[Bounded(np.array([1.0]), np.zeros(1)), Bounded(np.array([-1.0]), np.zeros(1))]]
    assert all(np.isinf(component.error[0]) for component in null_vector_with_bounds(entries, null_vector, solve))


def test_a_singular_system_has_no_bound_and_spoils_no_other():
    rows = systems(3, 1.0)
    rows[2, :, 0] = 2 * rows[1, :, 0]
    with np.errstate(all="ignore"):
        unknowns = solution_with_bounds([[Bounded(entry, np.zeros(BATCH)) for entry in row] for row in rows], solve)
    assert all(np.isinf(unknown.error[0]) and np.isfinite(unknown.error[1:]).all() for unknown in unknowns)


def test_bounds_of_angles_cover_uncertain_points():
    rng = np.random.default_rng(8)
    y, x = rng.normal(size=(2, 400))
    radius = rng.uniform(0, 0.5, 400)
    turn = rng.uniform(0, 2 * np.pi, 400)
    angle = arctan2(Bounded(y, radius), Bounded(x, radius))
    moved = np.arctan2(y + radius * np.sin(turn), x + radius * np.cos(turn))
    assert (abs(moved - angle.value) <= angle.error + 1e-15).all()
    assert np.isfinite(angle.error).mean() > 0.5
    cosine, sine = cos_sin(Bounded(y, radius))
    assert (abs(np.cos(y + radius) - cosine.value) <= cosine.error + 1e-15).all()
    assert (abs(np.sin(y - radius) - sine.value) <= sine.error + 1e-15).all()

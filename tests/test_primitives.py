"""Primitive functions: exact on exact numbers, accurate on others, and not finite where there is no answer."""

from fractions import Fraction
from math import prod

import mpmath
import numpy as np
import pytest
import sympy
from cases import for_each
from hypothesis import assume, given
from hypothesis import strategies as st

from algebroproj_sym.generating.runtime.arctan2 import arctan2
from algebroproj_sym.generating.runtime.cos_sin import cos_sin
from algebroproj_sym.generating.runtime.systems import least_pivot, null_vector, solve

FLOATS = [np.float32, np.float64, np.longdouble, np.complex64, np.complex128]
every_dtype = pytest.mark.parametrize("dtype", FLOATS)
silently = pytest.mark.filterwarnings("ignore::RuntimeWarning")


def rows_of(matrix):
    """Return the rows of an array (..., m, n) as lists of arrays (...)."""
    return [[matrix[..., i, j] for j in range(matrix.shape[-1])] for i in range(matrix.shape[-2])]


def joined(results):
    return np.stack(results, axis=-1)


def exact(matrix):
    return sympy.Matrix(len(matrix), len(matrix[0]), lambda i, j: sympy.Rational(str(matrix[i][j])))


def fractions_of(vector):
    return [Fraction(int(value.p), int(value.q)) for value in vector]


def tables(height, entries):
    return st.lists(st.lists(entries, min_size=height + 1, max_size=height + 1), min_size=height, max_size=height)


small_fractions = st.fractions(-5, 5, max_denominator=4)
systems = st.integers(1, 4).flatmap(lambda height: tables(height, small_fractions))


def drawn(*shape, dtype=np.float64, seed=3):
    """Return matrices that are far from singular: the diagonal dominates."""
    generator = np.random.default_rng(seed)
    values = generator.uniform(-1, 1, shape) + 4 * np.eye(shape[-2], shape[-1])
    if np.issubdtype(dtype, np.complexfloating):
        values = values + 1j * generator.uniform(-1, 1, shape)
    return values.astype(dtype)


# Linear systems


@given(systems)
def test_fractions_are_solved_exactly(system):
    matrix, right_side = exact(system)[:, :-1], exact(system)[:, -1]
    if matrix.det() == 0:
        with pytest.raises(ZeroDivisionError):
            solve(*system)
        return
    unknowns = list(solve(*system))
    assert all(isinstance(value, Fraction) for value in unknowns)
    assert unknowns == fractions_of(matrix.LUsolve(right_side))


@given(st.lists(tables(2, small_fractions), min_size=1, max_size=4))
def test_a_batch_of_fractions_is_solved_member_by_member_by_the_rule_of_cramer(members):
    determinants = [p[0] * q[1] - p[1] * q[0] for p, q in members]
    assume(all(determinants))
    first, second = solve(*rows_of(np.array(members, dtype=object)))
    assert first.tolist() == [(p[2] * q[1] - p[1] * q[2]) / d for (p, q), d in zip(members, determinants, strict=True)]
    assert second.tolist() == [(p[0] * q[2] - p[2] * q[0]) / d for (p, q), d in zip(members, determinants, strict=True)]


@pytest.mark.parametrize("size", [1, 2, 3, 5, 8])
@every_dtype
def test_every_kind_of_number_is_solved_to_its_precision(size, dtype):
    system = drawn(7, size, size + 1, dtype=dtype)
    unknowns = joined(solve(*rows_of(system)))
    residual = (system[..., :-1] @ unknowns[..., None])[..., 0] - system[..., -1]
    assert unknowns.dtype == dtype
    assert np.abs(residual).max() <= 60 * size * np.finfo(dtype).eps * max(1, np.abs(unknowns).max())


@given(tables(3, st.integers(-8, 8)))
def test_floats_fractions_and_long_doubles_agree(table):
    fractions = [[Fraction(entry) for entry in row] for row in table]
    determinant = exact(table)[:, :-1].det()
    assume(determinant != 0)
    expected = [float(value) for value in solve(*fractions)]
    for dtype in (np.float64, np.longdouble):
        unknowns = joined(solve(*rows_of(np.array(table, dtype=dtype))))
        np.testing.assert_allclose(unknowns.astype(float), expected, rtol=1e-11, atol=1e-11)


def test_numbers_of_many_digits_keep_them():
    with mpmath.workdps(50):
        root = mpmath.sqrt(2)
        first, second = solve([root, mpmath.mpf(1), mpmath.mpf(3)], [mpmath.mpf(1), root, mpmath.mpf(5)])
        assert abs(first - (3 * root - 5)) < mpmath.mpf(10) ** -47
        assert abs(second - (5 * root - 3)) < mpmath.mpf(10) ** -47


@every_dtype
def test_a_permutation_is_undone_exactly(dtype):
    order = [2, 0, 3, 1]
    system = np.concatenate([np.eye(4)[order], np.array([[5.0], [-1.0], [0.5], [3.0]])], axis=-1).astype(dtype)
    unknowns = joined(solve(*rows_of(system)))
    assert unknowns[order].tolist() == [5.0, -1.0, 0.5, 3.0]


@pytest.mark.parametrize("dtype", [np.float64, np.longdouble])
def test_entries_of_very_different_size_are_no_obstacle(dtype):
    first, second = solve(*rows_of(np.array([[1e-20, 1, 1], [1, 1, 2]], dtype=dtype)))
    np.testing.assert_allclose([float(first), float(second)], [1, 1], rtol=1e-15)


# A singular member of a batch


@st.composite
def singular_tables(draw):
    """Return small systems without a unique solution, such that no rounding can hide it: a zero row or column."""
    size = draw(st.integers(1, 3))
    table = np.array(draw(tables(size, st.integers(-4, 4))), dtype=float)
    if draw(st.booleans()):
        table[draw(st.integers(0, size - 1)), :-1] = 0
    else:
        table[:, draw(st.integers(0, size - 1))] = 0
    return table


@silently
@given(singular_tables(), st.data())
def test_only_the_singular_member_is_not_finite(singular, data):
    size = len(singular)
    batch = drawn(4, size, size + 1)
    place = data.draw(st.integers(0, 3))
    regular = joined(solve(*rows_of(np.delete(batch, place, axis=0))))
    batch[place] = singular
    unknowns = joined(solve(*rows_of(batch)))
    assert np.isfinite(unknowns).all(axis=-1).tolist() == [k != place for k in range(4)]
    np.testing.assert_allclose(np.delete(unknowns, place, axis=0), regular, rtol=1e-13, atol=1e-14)


@silently
@every_dtype
def test_a_singular_system_of_any_floating_kind_is_not_finite(dtype):
    system = np.array([[[2, 1, 5], [1, -1, 1]], [[1, 2, 1], [2, 4, 3]]], dtype=dtype)
    unknowns = joined(solve(*rows_of(system)))
    assert unknowns.dtype == dtype
    np.testing.assert_allclose(unknowns[0], [2, 1], rtol=1e-5)
    assert not np.isfinite(unknowns[1]).any()


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_equal_equations_are_singular_whatever_their_entries():
    assert not np.isfinite(solve([1.0, 49.0, 1.0], [1.0, 49.0, 2.0])).any()
    assert not np.isfinite(null_vector([1.0, 49.0, 3.0], [1.0, 49.0, 3.0])).all()


def test_integers_are_numbers():
    assert [float(v) for v in solve([2, 1, 4], [1, 3, 1])] == pytest.approx([2.2, -0.4])
    assert [float(v) for v in null_vector([2, 3])] == pytest.approx([1, -2 / 3])


@pytest.mark.parametrize("right_side", [(0.0, 0.0), (1.0, 2.0), (1.0, 3.0)])
def test_a_singular_system_warns_and_can_be_made_to_raise(right_side):
    rows = [1.0, 2.0, right_side[0]], [2.0, 4.0, right_side[1]]
    with pytest.warns(RuntimeWarning):
        unknowns = solve(*rows)
    assert not np.isfinite(unknowns).any()
    with np.errstate(all="raise"), pytest.raises(FloatingPointError):
        solve(*rows)


@silently
def test_a_member_that_is_not_a_number_leaves_the_others_alone():
    batch = drawn(3, 2, 3)
    alone = joined(solve(*rows_of(batch[::2])))
    batch[1, 0, 1] = np.nan
    unknowns = joined(solve(*rows_of(batch)))
    assert np.isfinite(unknowns).all(axis=-1).tolist() == [True, False, True]
    np.testing.assert_allclose(unknowns[::2], alone, rtol=1e-14)


def test_integers_among_fractions_are_not_divided_as_floats():
    third = Fraction(1, 3)
    assert solve([3, 1, 1], [1, third + 1, 1]) == (Fraction(1, 9), Fraction(2, 3))
    assert null_vector([3, 1, third], [0, 3, 1]) == (0, -third, 1)
    assert all(isinstance(v, Fraction) for v in (*solve([3, 1, 1], [1, third + 1, 1]), *null_vector([3, third])))


def test_one_singular_member_among_fractions_raises():
    members = [[[1, 2, 3], [4, 5, 6]], [[1, 2, 3], [2, 4, 6]]]
    with pytest.raises(ZeroDivisionError):
        solve(*rows_of(np.vectorize(Fraction, otypes=[object])(members)))


# Null spaces


def is_scaled(vector):
    """Whether the largest component is 1, exactly."""
    return max(map(abs, vector)) == 1 and 1 in vector


@given(systems)
def test_the_null_vector_of_fractions_has_no_residual_and_the_largest_component_one(system):
    matrix = exact(system)
    if matrix.rank() < matrix.rows:
        with pytest.raises(ZeroDivisionError):
            null_vector(*system)
        return
    components = list(null_vector(*system))
    assert all(isinstance(value, Fraction) for value in components)
    assert all(sum(a * v for a, v in zip(row, components, strict=True)) == 0 for row in system)
    assert is_scaled(components)


@given(st.lists(tables(2, small_fractions), min_size=1, max_size=4))
def test_two_equations_are_solved_by_the_cross_product(members):
    crosses = [(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]) for p, q in members]
    assume(all(any(cross) for cross in crosses))
    components = joined(null_vector(*rows_of(np.array(members, dtype=object)))).tolist()
    for cross, vector in zip(crosses, components, strict=True):
        scale = next(c / v for c, v in zip(cross, vector, strict=True) if v != 0)
        assert [scale * v for v in vector] == list(cross)
        assert is_scaled(vector)


@pytest.mark.parametrize("size", [1, 2, 3, 5, 8])
@every_dtype
def test_the_null_vector_of_every_kind_of_number_has_a_small_residual(size, dtype):
    matrix = drawn(7, size, size + 1, dtype=dtype)
    components = joined(null_vector(*rows_of(matrix)))
    assert components.dtype == dtype
    residual = np.abs((matrix @ components[..., None])[..., 0])
    assert residual.max() <= 60 * size * np.finfo(dtype).eps
    np.testing.assert_allclose(np.abs(components).max(axis=-1), 1, rtol=4 * np.finfo(dtype).eps)


@silently
@given(tables(3, st.floats(-8, 8).filter(lambda value: abs(value) > 1e-3)))
def test_the_largest_component_of_floats_is_exactly_one(table):
    components = joined(null_vector(*rows_of(np.array(table))))
    assume(np.isfinite(components).all())
    assert is_scaled(components.tolist())


@pytest.mark.parametrize("place", range(4))
@every_dtype
def test_a_coordinate_axis_is_found_wherever_it_is(place, dtype):
    matrix = np.delete(np.eye(4), place, axis=0)[[2, 0, 1]].astype(dtype)
    assert joined(null_vector(*rows_of(matrix))).tolist() == np.eye(4)[place].tolist()


def test_numbers_of_many_digits_keep_them_in_null_vectors():
    with mpmath.workdps(50):
        root = mpmath.sqrt(2)
        first, second = null_vector([mpmath.mpf(1), root])
        assert first == 1
        assert abs(second + 1 / root) < mpmath.mpf(10) ** -48


@st.composite
def deficient_tables(draw):
    """Return matrices whose null spaces have more than one dimension, such that no rounding can hide it."""
    size = draw(st.integers(1, 3))
    table = np.array(draw(tables(size, st.integers(-4, 4))), dtype=float)
    if draw(st.booleans()):
        table[draw(st.integers(0, size - 1))] = 0
    else:
        table[:, draw(st.lists(st.integers(0, size), min_size=2, max_size=2, unique=True))] = 0
    return table


@silently
@given(deficient_tables(), st.data())
def test_only_the_member_of_deficient_rank_is_not_finite(deficient, data):
    size = len(deficient)
    batch = drawn(4, size, size + 1)
    place = data.draw(st.integers(0, 3))
    regular = joined(null_vector(*rows_of(batch)))
    batch[place] = deficient
    components = joined(null_vector(*rows_of(batch)))
    finite = np.isfinite(components)
    assert finite.all(axis=-1).tolist() == [k != place for k in range(4)]
    np.testing.assert_array_equal(np.delete(components, place, axis=0), np.delete(regular, place, axis=0))


@silently
@every_dtype
def test_proportional_equations_have_no_null_vector(dtype):
    matrix = np.array([[1, 2, -4], [2, 4, -8]], dtype=dtype)
    assert not np.isfinite(joined(null_vector(*rows_of(matrix)))).all()


@pytest.mark.parametrize("dtype", [np.complex64, np.complex128])
@pytest.mark.parametrize("scale", [2.0**-100, 1.0, 2.0**30])
@pytest.mark.parametrize("height", [2, 3, 5, 8])
@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_complex_numbers_decide_the_rank_by_a_bound(height, scale, dtype):
    """Rows that depend on each other are refused, up to rounding in double precision; those that do not are solved."""
    generator = np.random.default_rng(height)

    def drawn(whole, *shape):
        parts = generator.integers(-3, 4, (2, *shape)) if whole else generator.standard_normal((2, *shape))
        return parts[0] + 1j * parts[1]

    for whole in (True, False) if dtype == np.complex128 else (True,):
        dependent = drawn(whole, 400, height, height - 1) @ drawn(whole, 400, height - 1, height + 1)
        for function in (solve, null_vector):
            lost = joined(function(*rows_of((scale * dependent).astype(dtype))))
            assert not np.isfinite(lost).all(axis=-1).any()
            assert lost.dtype == dtype
    for function in (solve, null_vector):
        found = joined(function(*rows_of((scale * drawn(False, 400, height, height + 1)).astype(dtype))))
        assert np.isfinite(found).all(axis=-1).mean() > 0.99


def test_deficient_rank_warns_and_can_be_made_to_raise():
    with pytest.warns(RuntimeWarning):
        null_vector([0.0, 0.0])
    with np.errstate(all="raise"), pytest.raises(FloatingPointError):
        null_vector([0.0, 0.0])


# Batches


@pytest.mark.parametrize("function", [solve, null_vector])
@pytest.mark.parametrize("dtype", [np.float64, np.longdouble, object])
def test_entries_broadcast_and_a_batch_is_a_loop(function, dtype):
    number = Fraction if dtype is object else dtype
    spread = np.array([number(k) for k in range(1, 5)], dtype=dtype)
    matrix = [[spread.reshape(4, 1), number(1), number(7)], [number(-3), spread[:3] * 2, number(1)]]
    results = function(*matrix)
    assert [result.shape for result in results] == [(4, 3)] * len(results)
    for i in range(4):
        for j in range(3):
            alone = function([spread[i], number(1), number(7)], [number(-3), spread[j] * 2, number(1)])
            for whole, part in zip(results, alone, strict=True):
                assert abs(whole[i, j] - part) <= 1e-15 * abs(part)


@pytest.mark.parametrize("function", [solve, null_vector])
@pytest.mark.parametrize("dtype", [np.float64, object])
def test_operands_are_not_changed(function, dtype):
    system = drawn(5, 3, 4).round(3).astype(dtype)
    rows = rows_of(system)
    before = system.copy()
    function(*rows)
    np.testing.assert_array_equal(system, before)


@pytest.mark.parametrize("function", [solve, null_vector])
def test_scalars_give_scalars_of_their_kind(function):
    for number in (np.float32, np.float64, np.longdouble):
        results = function([number(2), number(1), number(5)], [number(1), number(-1), number(1)])
        assert all(np.shape(result) == () and result.dtype == number for result in results)


@for_each("function", [solve, null_vector])
@for_each("dtype", [np.float64, np.longdouble, np.complex64, object])
def test_an_empty_batch_gives_empty_results(function, dtype):
    empty = np.ones((0, 3), dtype=dtype)
    results = function([empty, empty, empty], [empty, empty[:, :1], empty])
    assert {(result.shape, result.dtype) for result in results} == {((0, 3), np.dtype(dtype))}


@pytest.mark.parametrize("shape", [(2, 3), (3, 1), (1, 1, 2)])
def test_large_batches_have_the_shape_of_their_entries(shape):
    matrix = drawn(*shape, 3, 4)
    for function, count in ((solve, 3), (null_vector, 4)):
        results = function(*rows_of(matrix))
        assert len(results) == count
        assert {result.shape for result in results} == {shape}
    assert prod(shape) == solve(*rows_of(matrix))[0].size


# Angles


@given(st.floats(-1e6, 1e6))
def test_cosine_and_sine_are_those_of_the_angle(angle):
    cosine, sine = cos_sin(angle)
    with mpmath.workdps(40):
        assert abs(cosine - mpmath.cos(angle)) <= 2**-52
        assert abs(sine - mpmath.sin(angle)) <= 2**-52


def test_a_quarter_turn_leads_from_cosine_to_sine():
    cosine, sine = cos_sin(np.array([0, np.pi / 2, np.pi, -np.pi / 2]))
    np.testing.assert_allclose(cosine, [1, 0, -1, 0], atol=1e-15)
    np.testing.assert_allclose(sine, [0, 1, 0, -1], atol=1e-15)


@every_dtype
def test_angles_keep_their_dtype_and_shape(dtype):
    results = cos_sin(np.linspace(0, 1, 6).astype(dtype).reshape(2, 3))
    assert [(result.dtype, result.shape) for result in results] == [(dtype, (2, 3))] * 2


QUADRANTS = {
    (0.0, 1.0): 0.0,
    (1.0, 1.0): 0.25,
    (1.0, 0.0): 0.5,
    (1.0, -1.0): 0.75,
    (0.0, -1.0): 1.0,
    (-1.0, -1.0): -0.75,
    (-1.0, 0.0): -0.5,
    (-1.0, 1.0): -0.25,
}


@for_each(("direction", "half_turns"), QUADRANTS.items())
@for_each("length", [1e-200, 1.0, 3.7, 1e200])
def test_the_angle_is_in_the_quadrant_of_the_direction(direction, half_turns, length):
    y, x = (component * length for component in direction)
    assert abs(arctan2(y, x) - half_turns * np.pi) <= 1e-15


@given(st.floats(-3.14159, 3.14159), st.floats(1e-3, 1e3))
def test_the_angle_of_a_direction_is_the_angle_that_gave_it(angle, length):
    cosine, sine = cos_sin(angle)
    assert abs(arctan2(length * sine, length * cosine) - angle) <= 1e-15 * max(1, abs(angle)) * 4


def test_directions_broadcast():
    angles = arctan2(np.ones((3, 1)), np.array([1.0, -1.0]))
    np.testing.assert_allclose(angles, np.tile([np.pi / 4, 3 * np.pi / 4], (3, 1)), rtol=1e-15)


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.longdouble])
def test_directions_keep_their_dtype(dtype):
    assert arctan2(np.ones(3, dtype), np.ones(3, dtype)).dtype == dtype


@for_each("right", [(0, 0), (5, -7e9)])
@for_each(
    ("matrix", "least"), [([[3, 0], [0, 2]], 1), ([[2, 1], [1, 1]], 0.5), ([[1, 2], [2, 4]], 0), ([[0, 5], [7, 0]], 1)]
)
def test_the_least_pivot_of_a_system_is_that_of_its_left_side_beside_the_largest_of_the_column(matrix, least, right):
    rows = [[*map(float, row), float(last)] for row, last in zip(matrix, right, strict=True)]
    assert least_pivot("solve", rows) == least

"""Minimal solvers: all solutions, and no others, on problems whose solutions are known exactly."""

from fractions import Fraction

import flint
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from algebroproj import collinearity, minimal, solvers

LEFT = [[-3, -3], [3, 3], [1, 2], [-3, 0], [4, -1], [-1, 2], [1, -3]]


def exactly(form):
    return np.vectorize(Fraction, otypes=[object])(np.asarray(form, dtype=object))


def determinant(form):
    a, b, c = form
    return sum(a[i] * (b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2]) for i in range(3))


def pairs_of(first, second, left=LEFT):
    """Return seven pairs that satisfy two conditions: a right point is where its two lines meet."""
    u = exactly([[*point, 1] for point in left])
    lines = u @ exactly(first), u @ exactly(second)
    meets = [np.cross(a, b) for a, b in zip(*lines, strict=True)]
    if any(point[2] == 0 for point in meets):
        return None
    return u[:, :2], np.array([point[:2] / point[2] for point in meets])


def equations(left, right):
    """Return the seven equations as a matrix of fractions of FLINT."""

    def rational(x):
        return flint.fmpq(*(int(part) for part in x.as_integer_ratio()))

    rows = [
        [rational(a) * rational(b) for a in (*u, Fraction(1)) for b in (*v, Fraction(1))]
        for u, v in zip(np.asarray(left).tolist(), np.asarray(right).tolist(), strict=True)
    ]
    return flint.fmpq_mat(rows)


def oracle(left, right):
    """Return the number of different real solutions and their multiplicities, by FLINT; -1 for infinitely many."""
    reduced, rank = equations(left, right).rref()
    if rank < 7:
        return -1, []
    columns = [next(j for j in range(9) if reduced[i, j] != 0) for i in range(7)]
    kernel = []
    for free in sorted({*range(9)} - {*columns}):
        vector = [flint.fmpq(0)] * 9
        vector[free] = flint.fmpq(1)
        for i, column in enumerate(columns):
            vector[column] = -reduced[i, free]
        kernel.append(np.array(vector, dtype=object).reshape(3, 3))
    at = [determinant(kernel[0] + flint.fmpq(k) * kernel[1]) for k in range(4)]
    half, sixth = flint.fmpq(1, 2), flint.fmpq(1, 6)
    c = [
        at[0],
        -11 * sixth * at[0] + 3 * at[1] - 3 * half * at[2] + at[3] / 3,
        at[0] - 5 * half * at[1] + 2 * at[2] - half * at[3],
        (-at[0] + 3 * at[1] - 3 * at[2] + at[3]) * sixth,
    ]
    polynomial = flint.fmpq_poly(c)
    if polynomial == 0:
        return -1, []
    multiplicities = [3 - polynomial.degree()] if polynomial.degree() < 3 else []
    for factor, multiplicity in flint.fmpz_poly((polynomial * polynomial.denom()).numer().coeffs()).factor()[1]:
        real = sum(root.imag == 0 for root, _ in factor.complex_roots())
        multiplicities += [multiplicity] * real
    return len(multiplicities), sorted(multiplicities)


def contains(found, form):
    """Return whether a multiple of an exact condition is within the bounds of one of the solutions."""
    for k in range(int(found.count)):
        value, error = exactly(found.F[k]), exactly(found.error[k])
        largest = np.unravel_index(np.argmax(np.abs(found.F[k])), (3, 3))
        if form[largest] == 0:
            continue
        # A multiple m form with |m form - F| <= error in all elements: the intervals of m have a common number.
        low, high = None, None
        fits = True
        for f, v, e in zip(exactly(form).flat, value.flat, error.flat, strict=True):
            if f == 0:
                fits &= abs(v) <= e
                continue
            ends = sorted([(v - e) / f, (v + e) / f])
            low = ends[0] if low is None else max(low, ends[0])
            high = ends[1] if high is None else min(high, ends[1])
        if fits and low <= high:
            return True
    return False


small = st.integers(-4, 4)
vectors = st.lists(small, min_size=3, max_size=3).map(np.array)


@st.composite
def singular(draw):
    """Return a matrix of integers of rank 2 or less."""
    a, b, c, d = (draw(vectors) for _ in range(4))
    return np.outer(a, b) + np.outer(c, d)


@given(singular(), singular())
def test_planted_conditions_are_found_with_all_others(first, second):
    pairs = pairs_of(first, second)
    if pairs is None:
        return
    found = minimal.seven_pairs(*pairs)
    count, multiplicities = oracle(*pairs)
    assert int(found.count) == count
    if count > 0:
        assert sorted(m for m in found.multiplicity.tolist() if m) == multiplicities
        assert contains(found, exactly(first))
        assert contains(found, exactly(second))


def with_double_root(generator):
    """Return pairs of floating-point numbers whose cubic has a root that is nearly, or exactly, double."""
    a, b, c, d = generator.integers(-8, 9, (4, 3))
    form = np.outer(a, b) + np.outer(c, d)
    left_null, right_null = np.cross(a, c), np.cross(b, d)
    other = generator.integers(-8, 9, (3, 3)).astype(object)
    # b' G a' = 0 for the null vectors makes the root double.
    size = int(left_null @ left_null) * int(right_null @ right_null)
    if size == 0:
        return None
    other = other * size - int(left_null @ other @ right_null) * np.outer(left_null, right_null).astype(object)
    return pairs_of(form, other, generator.integers(-64, 65, (7, 2)).tolist())


def test_exact_double_roots_are_told_from_near_ones():
    generator = np.random.default_rng(11)
    exact, rounded = [], []
    while len(exact) < 40:
        pairs = with_double_root(generator)
        if pairs is not None and oracle(*pairs)[0] > 0:
            exact.append(pairs)
            rounded.append(tuple(points.astype(float) for points in pairs))
    found = [minimal.seven_pairs(*pairs) for pairs in exact]
    assert all(2 in each.multiplicity or 3 in each.multiplicity for each in found)
    together = minimal.seven_pairs(*(np.stack(side) for side in zip(*rounded, strict=True)))
    for k, pairs in enumerate(rounded):
        count, multiplicities = oracle(*pairs)
        assert together.count[k] == count
        assert sorted(m for m in together.multiplicity[k].tolist() if m) == multiplicities


def scenes(generator, count):
    """Return image points of random points, seen by two cameras near to each other."""
    points = generator.uniform((-1, -1, 3), (1, 1, 5), (count, 7, 3))
    axes = generator.normal(size=(count, 3)) * 0.3
    base = generator.normal(size=(count, 1, 3)) * 0.5
    turned = points - base + np.cross(axes[:, None, :], points)
    return tuple(p[..., :2] / p[..., 2:] * 1000 + 500 for p in (points, turned))


def test_bounds_and_integers_agree_and_enclose_each_other():
    left, right = scenes(np.random.default_rng(5), 60)
    left[::7] = np.round(left[::7] / 256) * 256
    many = minimal.seven_pairs(left, right)
    for k in range(len(left)):
        one = minimal.seven_pairs(left[k], right[k])
        assert many.count[k] == one.count == oracle(left[k], right[k])[0]
        for i in range(max(int(one.count), 0)):
            apart = np.abs(many.F[k, : one.count] - one.F[i]) - many.error[k, : one.count] - one.error[i]
            assert apart.max(axis=(1, 2)).min() <= 1e-15
    assert np.nanmax(many.error) < 1e-12


def test_large_integers_are_taken_as_they_are():
    left, right = np.random.default_rng(12).integers(-(2**62), 2**62, (2, 20, 7, 2))
    many = minimal.seven_pairs(left, right)
    for k in range(len(left)):
        one = minimal.seven_pairs(left[k], right[k])
        assert many.count[k] == one.count
        for i in range(int(one.count)):
            apart = np.abs(many.F[k, : one.count] - one.F[i]) - many.error[k, : one.count] - one.error[i]
            assert apart.max(axis=(1, 2)).min() <= 0


def test_ordinary_problems_need_no_integers(monkeypatch):
    left, right = scenes(np.random.default_rng(6), 500)
    asked = []
    solve = solvers._solve_exactly
    monkeypatch.setattr(solvers, "_solve_exactly", lambda *parts: asked.append(1) or solve(*parts))
    minimal.seven_pairs(left, right)
    assert len(asked) <= 5


@pytest.mark.parametrize(
    "roots", [(0, 1, -1), (Fraction(1, 2), Fraction(1, 4), 1), (0, Fraction(1, 2), 2), (3, -5, -1)]
)
def test_roots_on_the_boundaries_of_bisection_are_found_once(roots):
    a, b, c = map(Fraction, roots)
    form = [-a * b * c, a * b + b * c + c * a, -(a + b + c), Fraction(1)]
    scale = np.lcm.reduce([x.denominator for x in form])
    found = [t / s for s, t, ds, dt in solvers._simple_roots([int(x * scale) for x in form]) if s]
    assert len(found) == 3
    assert [round(float(x), 12) for x in sorted(found)] == sorted(map(float, roots))


def test_dependent_equations_are_singular():
    twice = [*LEFT[:6], LEFT[0]]
    found = minimal.seven_pairs(twice, twice)
    assert (int(found.count), int(found.independent)) == (-1, 6)
    assert np.isnan(found.F).all()
    many = minimal.seven_pairs(np.stack([twice] * 20), np.stack([twice] * 20))
    assert (many.count == -1).all()


def test_a_pencil_of_singular_matrices_is_told():
    # All right points on a line: the matrices u'^T (w l^T) u'' with any w are conditions, and three are independent.
    line = [[k, 0] for k in range(7)]
    found = minimal.seven_pairs(LEFT, line)
    assert int(found.count) == -1
    assert oracle(exactly(LEFT), exactly(line))[0] == -1


def test_scaling_by_powers_of_two_changes_no_count():
    left, right = scenes(np.random.default_rng(8), 3)
    known = minimal.seven_pairs(left, right)
    for exponent in (-900, -200, 300, 900):
        found = minimal.seven_pairs(np.ldexp(left, exponent), right)
        assert found.count.tolist() == known.count.tolist()


def test_what_is_no_problem_is_refused_by_name():
    with pytest.raises(ValueError, match=r"x_left: expected the shape \(\.\.\., 7, 2\), got \(6, 2\)"):
        minimal.seven_pairs(LEFT[:6], LEFT)
    with pytest.raises(ValueError, match="x_right: expected finite numbers, got nan"):
        minimal.seven_pairs(LEFT, [*LEFT[:6], [np.nan, 0]])
    with pytest.raises(ValueError, match="expected leading shapes that broadcast"):
        minimal.seven_pairs(np.zeros((2, 7, 2)), np.zeros((3, 7, 2)))
    with pytest.raises(ValueError, match="x_left: expected real numbers"):
        minimal.seven_pairs(np.zeros((7, 2)) * 1j, LEFT)
    with pytest.raises(TypeError, match="without a mask"):
        minimal.seven_pairs(np.ma.masked_array(LEFT, mask=False), LEFT)
    with pytest.raises(ValueError, match=r"X: expected the shape \(\.\.\., 5, 3\)"):
        minimal.orientations(LEFT, LEFT, LEFT)


def test_no_problems_have_no_solutions():
    found = minimal.seven_pairs(np.zeros((0, 7, 2)), np.zeros((0, 7, 2)))
    assert found.F.shape == (0, 3, 3, 3)


def okamotos():
    first = [[-2, 0, 1], [1, -2, -2], [0, -4, -3]]
    second = [[2, 2, 0], [-2, 0, 2], [1, 2, 1]]
    return pairs_of(first, second), [first, second, (np.array(first) + second).tolist()]


OBJECT = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 2, 3]]


def test_the_three_photographs_of_seven_pairs_and_five_points():
    from algebroproj_derivations.okamoto1981.s3_unique_determination import solutions

    (left, right), forms = okamotos()
    conditions = minimal.seven_pairs(left, right)
    assert conditions.multiplicity.tolist() == [1, 1, 1]
    assert all(contains(conditions, exactly(form)) for form in forms)
    found = minimal.orientations(left, right, OBJECT)
    assert int(found.count) == 3
    assert max(found.error_left.max(), found.error_right.max()) < 1e-11
    for exact in solutions:
        apart = [
            max(
                abs(Fraction(x) - Fraction(int(y.p), int(y.q))) - Fraction(e)
                for x, y, e in zip([*a, *b], [*exact[0], *exact[1]], [*ea, *eb], strict=True)
            )
            for a, b, ea, eb in zip(found.A_left, found.A_right, found.error_left, found.error_right, strict=True)
        ]
        assert min(apart) <= 0


def test_orientations_satisfy_what_is_measured():
    left, right = scenes(np.random.default_rng(9), 30)
    control = np.random.default_rng(10).uniform(-1, 1, (30, 5, 3))
    found = minimal.orientations(left / 1000, right / 1000, control)
    for k in range(3):
        sure = np.maximum(found.error_left[:, k].max(axis=1), found.error_right[:, k].max(axis=1)) < 1e-6
        assert sure.sum() > 10
        seen = collinearity.project(found.A_left[sure, None, k], control[sure])
        assert np.abs(seen - left[sure, :5] / 1000).max() < 1e-6
        rest = collinearity.coplanarity_determinant(
            found.A_left[sure, None, k], found.A_right[sure, None, k], left[sure] / 1000, right[sure] / 1000
        )
        size = np.linalg.norm(found.A_left[sure, k], axis=1) * np.linalg.norm(found.A_right[sure, k], axis=1)
        assert (np.abs(rest) / size[:, None] ** 2).max() < 1e-6

"""Five pairs of calibrated images: all real essential matrices, or none are told; the truth is exact arithmetic."""

import re
import sys
from pathlib import Path

import mpmath
import numpy as np
import pytest

from algebroproj import a_priori, isolating, minimal, plain
from algebroproj import five_pairs as module
from algebroproj._runtime.evaluation import parts_of

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "benchmarks"))
from exact_counts import count_of_five as oracle
from exact_counts import scenes


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("base", "depth"), [(0.5, 1), (4e-3, 0), (0.5, 1e-3), (4e-3, 1), (0.5, 0), (1e-5, 1)])
def test_counts_are_those_of_exact_arithmetic(base, depth):
    left, right = scenes(np.random.default_rng(5), 15, 5, base, depth)
    found = minimal.five_pairs(left, right)
    assert (found.case == "counted").all()
    assert found.count.tolist() == [oracle(*each) for each in zip(left, right, strict=True)]
    assert np.nanmax(found.error) < 1e-12
    assert (np.isfinite(found.E).all(axis=(2, 3)).sum(axis=1) == found.count).all()
    assert (found.multiplicity.sum(axis=1) == found.count).all()


def test_integers_and_floating_point_numbers_agree_and_enclose_each_other():
    left, right = scenes(np.random.default_rng(6), 6)
    many = minimal.five_pairs(left, right)
    for k, count in enumerate(many.count):
        groups = isolating.isolated(left[k], right[k])
        assert len(groups) == count
        for group in groups:
            signs = np.array([1, -1])[:, None, None, None]
            apart = np.abs(signs * many.E[k, :count] - group.E) - many.error[k, :count] - group.error
            assert apart.max(axis=(2, 3)).min() <= 0


def test_what_rounding_changes_in_the_conditions_is_no_more_than_what_is_known_beforehand():
    """Of base and quaternion of length 1, no term, as a share of the lengths of the rays, is above that of ones."""
    sizes = {"abs": lambda _: 1}
    bounds = a_priori(minimal.conditions)

    def at_ones(text):
        return eval(re.sub(r"\|\w+\|", "1", text), {}, sizes)

    for name, text in bounds[0].where.items():
        if name.startswith("m"):
            sizes[name] = at_ones(text)
    assert all(bound.roundings == 1 and len(bound.terms) == 1 for bound in bounds)
    for ((coefficient, kappa),) in (bound.terms for bound in bounds[18:]):
        assert coefficient * at_ones(kappa.split("/|s")[0]) * 2.0**-106 <= module.RESIDUAL


class Size:
    """The sum of the absolute values of terms, and how often one of them is rounded at most."""

    def __init__(self, total, roundings=0):
        self.total, self.roundings = total, roundings

    def __add__(self, other):
        return Size(self.total + other.total, max(self.roundings, other.roundings) + 1)

    def __mul__(self, other):
        other = other if isinstance(other, Size) else Size(other)
        return Size(self.total * other.total, self.roundings + other.roundings + 1)

    def __neg__(self):
        return self

    __sub__, __rmul__ = __add__, __mul__


@pytest.mark.parametrize("moved", ["base", "quaternion"])
def test_what_rounding_changes_in_derivatives_is_no_more_than_what_is_assumed(moved):
    """Entries of numbers of length 1 are at most 1; a direction is rounded less than 32 times."""
    body = parts_of(plain(minimal.differential), "test")[1]
    changes = [Size(size, 32) for size in [int(moved == "base")] * 6 + [int(moved == "quaternion")] * 8]
    elements = body(*[Size(1)] * 14, *changes)
    by_pairs = np.linalg.norm([element.total for element in elements])
    roundings = max(element.roundings for element in elements) + 9
    of_five = np.sqrt(25 * 2) * by_pairs * roundings
    of_product = 32 * np.sqrt(5) * 8
    assert of_five + of_product < module.DERIVATIVES / module.ROUNDOFF


def test_directions_are_at_right_angles():
    generator = np.random.default_rng(8)
    for size in (3, 4):
        units = module._unit(generator.normal(size=(99, size)) + 1j * generator.normal(size=(99, size)))
        units[0] = np.eye(size)[1]
        units[1] = np.eye(size)[0]
        whole = np.concatenate([units[:, None], module._at_right_angles(units)], axis=1)
        assert np.abs(whole @ whole.conj().swapaxes(1, 2) - np.eye(size)).max() < 16 * module.ROUNDOFF
    assert not module._at_right_angles(units.real + 0j).imag.any()


def cross_matrix(b):
    return np.array([[0, -b[2], b[1]], [b[2], 0, -b[0]], [-b[1], b[0], 0]])


def turn(q):
    a, b, c, d = q
    return np.array(
        [
            [a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)],
            [2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)],
            [2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d],
        ]
    )


def integer_pairs(forms, generator, exactly=True):
    """Return five pairs of numbers that satisfy one condition, or two, of which the right points are integers."""
    left, right = [], []
    while len(left) < 5:
        u = generator.integers(-40, 41, 2)
        lines = [np.array([*u, 1]) @ form for form in forms]
        if len(lines) == 1:
            lines.append(generator.integers(-6, 7, 3))
        v = np.cross(*lines)
        if v[2] != 0 and (not exactly or (v % v[2] == 0).all()):
            left.append(u)
            right.append(v[:2] / v[2])
    return np.array(left, float), np.array(right)


def contains(found, form):
    """Return whether a multiple of an exact matrix is within the bounds of one of the solutions."""
    largest = np.unravel_index(np.argmax(np.abs(form.astype(float))), (3, 3))
    for value, error in zip(found.E[: int(found.count)], found.error[: int(found.count)], strict=True):
        low, high = -mpmath.inf, mpmath.inf
        if value[largest] < 0:
            value = -value
        fits = True
        for f, v, e in zip((form / form[largest]).flat, value.flat, error.flat, strict=True):
            ends = [mpmath.mpf(float(v)) - float(e), mpmath.mpf(float(v)) + float(e)]
            if f == 0:
                fits &= bool(ends[0] <= 0 <= ends[1])
            else:
                ends = sorted(mpmath.mpf(end) / f for end in ends)
                low, high = max(low, ends[0]), min(high, ends[1])
        if fits and low <= high:
            return True
    return False


def exact(matrix):
    return np.vectorize(lambda x: mpmath.mpf(int(x)), otypes=[object])(matrix)


def test_planted_matrices_are_found_and_enclosed():
    generator = np.random.default_rng(7)
    told = 0
    with mpmath.workdps(60):
        for _ in range(25):
            form = cross_matrix(generator.integers(-4, 5, 3)) @ turn(generator.integers(-2, 3, 4))
            if not form.any():
                continue
            pairs = integer_pairs([form], generator)
            found = minimal.five_pairs(*pairs)
            if found.count < 0:
                continue
            told += 1
            assert found.count == oracle(*pairs)
            assert contains(found, exact(form))
    assert told >= 15


def tangent_forms(generator):
    """Return an essential matrix, and a change of it that keeps it essential to the first order."""
    b, q = generator.integers(-2, 3, 3), generator.integers(-2, 3, 4)
    form = cross_matrix(b) @ turn(q)
    other = cross_matrix(generator.integers(-2, 3, 3)) @ turn(q) + cross_matrix(b) @ cross_matrix(
        generator.integers(-2, 3, 3)
    ) @ turn(q)
    return form, other


def double_roots(exactly):
    """Return problems with a solution that is double, or was before the right points were rounded."""
    generator = np.random.default_rng(3)
    found = []
    while len(found) < 6:
        forms = tangent_forms(generator)
        crossed = np.cross(
            np.array([[1, 2, 1], [3, -1, 1], [-2, 5, 1]]) @ forms[0], [[1, 2, 1], [3, -1, 1], [-2, 5, 1]] @ forms[1]
        )
        if not crossed.any(axis=1).all() or (exactly and not many_integers(forms)):
            continue
        pairs = integer_pairs(forms, generator, exactly)
        if len({tuple(u) for u in pairs[0]}) == 5:
            found.append((*pairs, forms[0]))
    return found


def many_integers(forms):
    grid = np.stack([*np.meshgrid(np.arange(-40, 41), np.arange(-40, 41)), np.ones((81, 81), int)], axis=-1)
    v = np.cross(grid @ forms[0], grid @ forms[1])
    whole = v[..., 2] != 0
    whole[whole] = (v[whole] % v[whole][:, 2:] == 0).all(axis=1)
    return whole.sum() > 30


def test_exact_double_solutions_are_a_cluster_or_singular():
    cases = []
    for left, right, form in double_roots(exactly=True):
        found = minimal.five_pairs(left, right)
        assert found.count == -1
        assert oracle(left, right) is None
        cases.append(str(found.case))
        if found.case == "cluster":
            assert found.multiplicity.max() == 2
            # The double solution is within the bounds of the cluster.
            place = int(found.multiplicity.argmax())
            assert contains(found._replace(count=1, E=found.E[place:], error=found.error[place:]), exact(form))
    assert set(cases) == {"cluster", "singular"}


def test_near_double_solutions_are_counted_rightly():
    for left, right, _ in double_roots(exactly=False):
        for step in (0, 1e-15, 1e-7):
            moved = right + step * np.arange(10).reshape(5, 2)
            assert minimal.five_pairs(left, moved).count == oracle(left, moved)


def test_radii_hold_for_solutions_that_are_far_from_what_newton_would_find(monkeypatch):
    """Solutions that are moved on purpose have a larger radius, or none, and never a wrong one."""
    left, right = scenes(np.random.default_rng(8), 1)
    known = isolating.isolated(left[0], right[0])
    approximate = isolating._approximate
    for bits in (60, 120, 200):

        def moved(*arguments, bits=bits):
            found = approximate(*arguments)
            found.real[1, 3] += 1 << (isolating.BITS - bits)
            return found

        monkeypatch.setattr(isolating, "_approximate", moved)
        found = isolating.isolated(left[0], right[0])
        assert (found is None) == (bits == 60)
        if found is not None:
            assert [group.multiplicity for group in found] == [group.multiplicity for group in known]


def test_counts_of_small_integers_with_all_their_coincidences():
    left, right = np.random.default_rng(0).integers(-2, 3, (2, 60, 5, 2))
    counts = minimal.five_pairs(left, right).count
    known = [oracle(*each) for each in zip(left, right, strict=True)]
    assert all(known[k] in (counts[k], None) for k in np.flatnonzero(counts >= 0))
    assert sum(counts[k] == known[k] for k in range(60)) > 20


def test_counts_are_right_on_both_sides_of_a_double_solution():
    """Halve the way between problems with different numbers of solutions, until the numbers cannot be told."""
    left, right = scenes(np.random.default_rng(11), 30)
    counts = minimal.five_pairs(left, right).count
    for k in range(2):
        other = next(j for j in range(k + 1, 30) if counts[j] != counts[k])
        ends, told = [0.0, 1.0], []
        for _ in range(60):
            middle = (ends[0] + ends[1]) / 2
            way = [(1 - middle) * points[k] + middle * points[other] for points in (left, right)]
            count = int(minimal.five_pairs(*way).count)
            if count < 0:
                break
            told.append((way, count))
            ends[int(count != counts[k])] = middle
        assert ends[1] - ends[0] < 2.0**-16
        assert all(count == oracle(*way) for way, count in told[-8:])


def refined(value, left, right):
    """Return a solution with fifty digits, by Newton's method for all sixteen equations."""
    e = mpmath.matrix(value.ravel().tolist())
    pairs = [
        [x * y for x in (*map(mpmath.mpf, u), 1) for y in (*map(mpmath.mpf, v), 1)]
        for u, v in zip(left, right, strict=True)
    ]

    def equations(e):
        m = mpmath.matrix(3, 3)
        for k in range(9):
            m[k // 3, k % 3] = e[k]
        square = m * m.T
        rest = 2 * square * m - (square[0, 0] + square[1, 1] + square[2, 2]) * m
        return [
            *(mpmath.fdot(row, e) for row in pairs),
            *rest,
            mpmath.det(m),
            sum(x * float(y) for x, y in zip(e, value.flat, strict=True)) - 1,
        ]

    for _ in range(4):
        here, h = equations(e), mpmath.mpf(10) ** -30
        jacobian = mpmath.matrix(len(here), 9)
        for k in range(9):
            there = e.copy()
            there[k] += h
            for i, (a, b) in enumerate(zip(equations(there), here, strict=True)):
                jacobian[i, k] = (a - b) / h
        e = e - mpmath.qr_solve(jacobian, mpmath.matrix(here))[0]
    assert max(abs(x) for x in equations(e)) < mpmath.mpf(10) ** -45
    return np.array(list(e), dtype=object).reshape(3, 3)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("base", [0.5, 4e-3])
def test_enclosures_hold_the_solutions(base):
    left, right = scenes(np.random.default_rng(8), 3, base=base)
    found = minimal.five_pairs(left, right)
    with mpmath.workdps(60):
        for k in range(3):
            one = module.FivePairs(*(part[k] for part in found))
            for n in range(max(int(one.count), 0)):
                assert contains(one, refined(one.E[n], left[k].tolist(), right[k].tolist()))


def test_swapped_images_have_the_transposed_matrices():
    left, right = scenes(np.random.default_rng(9), 20)
    one, other = minimal.five_pairs(left, right), minimal.five_pairs(right, left)
    assert (one.count >= 0).all()
    assert (one.count == other.count).all()
    for k, count in enumerate(one.count):
        for n in range(count):
            transposed = other.E[k, :count].swapaxes(-1, -2)
            apart = np.minimum(*(np.abs(sign * transposed - one.E[k, n]).max(axis=(1, 2)) for sign in (1, -1)))
            assert apart.min() < 1e-12


LEFT = [[0, 0], [0.5, 0.25], [-0.5, 0.5], [0.25, -0.5], [-0.25, -0.25]]
RIGHT = [[0.25, 0], [0.5, 0.5], [-0.25, 0.5], [0.5, -0.5], [0.125, -0.375]]


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (LEFT, LEFT),  # no base
        ([*LEFT[:4], LEFT[0]], [*RIGHT[:4], RIGHT[0]]),  # one pair twice
        ([[0, 0]] * 5, RIGHT),
        (np.zeros((5, 2)), np.zeros((5, 2))),
        ([[k, 0] for k in range(5)], [[k * k, 0] for k in range(5)]),  # lines in both images
    ],
)
def test_degenerate_problems_have_no_count(left, right):
    found = minimal.five_pairs(left, right)
    assert (found.count, found.case) == (-1, "singular")
    assert np.isnan(found.E).all()
    together = minimal.five_pairs(np.stack([left, LEFT]), np.stack([right, RIGHT]))
    assert together.count.tolist() == [-1, oracle(LEFT, RIGHT)]


def test_numbers_of_any_size_are_taken_as_they_are():
    for size in (1e300, 1e-8):
        left, right = np.multiply(LEFT, size), np.multiply(RIGHT, 1 / size)
        assert minimal.five_pairs(left, RIGHT).count in (-1, oracle(left, RIGHT))
        assert minimal.five_pairs(left, right).count in (-1, oracle(left, right))
    assert minimal.five_pairs(np.multiply(LEFT, 1e8), RIGHT).count >= 0


def test_a_turned_image_has_no_base():
    left = np.array([[0, 0], [1, 2], [3, -1], [-2, 5], [4, 1]], float)
    for turned in (left @ [[0, 1], [-1, 0]], -left):
        assert minimal.five_pairs(left, turned).case == "singular"
    assert minimal.five_pairs(left, left @ [[0, 1], [-2, 0]]).case != "singular"


def test_what_is_no_problem_is_refused_by_name():
    with pytest.raises(ValueError, match=r"x_left: expected the shape \(\.\.\., 5, 2\), got \(4, 2\)"):
        minimal.five_pairs(LEFT[:4], RIGHT)
    with pytest.raises(ValueError, match="x_right: expected numbers that float64 holds, got 9007199254740993"):
        minimal.five_pairs(LEFT, [[2**53 + 1, 0], *[[1, 2]] * 4])
    with pytest.raises(ValueError, match="five_pairs: expected leading shapes that broadcast"):
        minimal.five_pairs(np.zeros((2, 5, 2)), np.zeros((3, 5, 2)))
    assert minimal.five_pairs(np.zeros((0, 5, 2)), np.zeros((0, 5, 2))).E.shape == (0, 10, 3, 3)

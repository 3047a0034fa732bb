"""The ladder: what is certified is true, whichever rung a member stays on."""

from fractions import Fraction

import numpy as np
import pytest

from algebroproj import correlation, metric, optics
from algebroproj_derivations.studies.stereo.chain import simulated
from algebroproj_derivations.studies.stereo.scenes import affine_scene
from algebroproj_sym.study.ladder import SINGULAR, certified, climb


def exact_z(left, right):
    """Solve the five equations by Cramer's rule in fractions; None if they are singular."""
    rows, rhs = [], []
    for (a1, a2), (b1, b2) in zip(left.tolist(), right.tolist(), strict=True):
        a1, a2, b1, b2 = map(Fraction, (a1, a2, b1, b2))
        rows.append([b1 * (a1 - 1), a1 * b2, a2 - b2, a2 * b1, b2 * (a2 - 1)])
        rhs.append(b1 - a1)
    whole = determinant(rows)
    if whole == 0:
        return None
    z11, z12, z20, z21, z22 = (
        determinant([[*row[:k], value, *row[k + 1 :]] for row, value in zip(rows, rhs, strict=True)]) / whole
        for k in range(5)
    )
    return [[0, -1 - z11, -z20 - z22], [1, z11, z12], [z20, z21, z22]]


def determinant(rows):
    if not rows:
        return Fraction(1)
    minors = ([row[:k] + row[k + 1 :] for row in rows[1:]] for k in range(len(rows)))
    return sum((-1) ** k * rows[0][k] * determinant(minor) for k, minor in enumerate(minors))


@pytest.fixture(scope="module")
def points():
    """Image points of ever smaller spread about a singular system, and one that is singular."""
    generator = np.random.default_rng(3)
    left, right = generator.uniform(-1, 1, (2, 60, 5, 2))
    for k in range(1, 60):
        spread = 2.0 ** -(0.85 * k)
        left[k, 4], right[k, 4] = left[k, 3] + spread * left[k, 4], right[k, 3] + spread * right[k, 4]
    left[59, 4], right[59, 4] = left[59, 3], right[59, 3]
    return left, right


@pytest.mark.parametrize("accuracy", [1e-6, 1e-12, 1e-25])
def test_certified_values_are_as_near_as_they_say(points, accuracy):
    found = certified(correlation.correlation_matrix, *points, accuracy=accuracy)
    values, radii = found.values["result0"], found.radii["result0"]
    assert found.rung[-1] == SINGULAR
    assert np.isnan(values.hi[-1]).all()
    assert np.isinf(radii[-1]).all()
    assert len({*found.rung}) >= 3
    for k in range(59):
        exact = exact_z(points[0][k], points[1][k])
        largest = max(abs(entry) for row in exact for entry in row)
        assert radii[k].max() <= accuracy * float(largest)
        for place in np.ndindex(3, 3):
            value = Fraction(float(values.hi[k][place])) + Fraction(float(values.lo[k][place]))
            assert abs(value - exact[place[0]][place[1]]) <= Fraction(float(radii[k][place]))


def test_a_value_that_is_exactly_zero_is_no_obstacle():
    found = certified(optics.scale, [0.0, 2.0], [3.0, 0.0], accuracy=1e-20)
    assert found.values["result0"].hi.tolist() == [0.0, 1.0]
    assert found.radii["result0"].max() < 1e-20


def test_angles_have_no_rational_rung_but_are_certified():
    angle = np.linspace(-3, 3, 7)

    def pipeline(arithmetic, members):
        from algebroproj_sym.study.precision import apply, lift

        rotation = apply(arithmetic, metric.rotation_left, lift(arithmetic, angle[members]), lift(arithmetic, 0.5))
        return {"R": rotation}

    found = climb(pipeline, 7, 1e-28, exact=False)
    assert found.counts()["undecided"] == 0
    np.testing.assert_allclose(found.values["R"].hi, metric.rotation_left(angle, 0.5), rtol=0, atol=1e-15)


def test_the_result_of_the_chain_does_not_depend_on_the_rungs():
    generator = np.random.default_rng(4)
    y = np.array([[0.576, 0.149, 0.128], [0.392, 0.624, 0.209], [0.733, 0.865, 0.148], [0.998, 0.835, 0.121]])
    centers, planes = [[0.171, 0.395, 3.99], [0.68, 0.41, 4.07]], [[0.3, 0.1], [0.3, -0.2]]
    batch = affine_scene(y + 0.05 * generator.standard_normal((40, 4, 3)), [centers] * 40, [planes] * 40)

    def pipeline(arithmetic, members):
        return simulated(arithmetic, batch[members])._asdict()

    coarse = climb(pipeline, 40, 1e-3)
    fine = climb(pipeline, 40, 1e-20)
    for name, value in coarse.values.items():
        distance = abs((value.hi - fine.values[name].hi) + (value.lo - fine.values[name].lo))
        assert (distance <= (coarse.radii[name] + fine.radii[name]) * (1 + 1e-12)).all()


def test_bad_input_is_named():
    with pytest.raises(ValueError, match="accuracy from 1e-30 to 1, got 1e-40"):
        certified(optics.scale, [1.0], [2.0], accuracy=1e-40)
    with pytest.raises(ValueError, match="one leading dimension, got"):
        certified(optics.scale, [1.0], [2.0, 3.0])
    with pytest.raises(ValueError, match="finite values, got nan"):
        certified(optics.scale, [np.nan], [2.0])
    with pytest.raises(ValueError, match="at least one member, got 0"):
        climb(lambda arithmetic, members: {}, 0)

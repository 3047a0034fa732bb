"""Real input: the generated functions reproduce items a) and b) of the numerical example of fundamentals1996.

The tables are taken from the derivation as printed; the cells that must not reproduce are listed here by hand.
"""

from decimal import Decimal

import mpmath
import numpy as np
import pytest

from algebroproj import affine, projection
from algebroproj_derivations.fundamentals1996 import s4_a_coordinates as example
from algebroproj_sym.declaring import judge, select

HALF_UNIT = 0.5e-7
NOISE = 1e-12

SLIPS = {
    "4/a#6.y2",
    "4/a#O1.y1",
    "4/a#O2.y1",
    "4/b#12.left.y",
    "4/b#16.left.u2",
    "4/b#14.right.y",
    "4/b#4.right.u2",
    "4/b#right.R21",
}
CUT_OFF = {"4/b#6.right.u2", "4/b#8.right.u2", "4/b#11.right.u2"}
LATER_SLIPS = {
    "4/g#2.right.u2",
    "4/g#12.left.u1",
    "4/g#15.left.u2",
    "4/i#left.tau2",
    "4/i#left.t22",
    "4/i#right.tau1",
    "4/i#right.t11",
    "4/i#right.tau2",
    "4/i#right.t22",
    "4/i#1.p",
    "4/i/shift",
}

MODEL = np.array([[float(c) for c in row] for row in example.CARTESIAN.values()])
NAMES = list(example.CARTESIAN)
BASIC = MODEL[[NAMES.index(name) for name in ("1", "4", "5", "2")]]


def reproduced(printed, computed):
    return bool(abs(float(printed) - computed) <= HALF_UNIT + NOISE)


def test_the_slips_are_exactly_these_cells():
    cells = [claim for claim in select(["fundamentals1996:4"]) if claim.kind == "numeric"]
    found = {claim.number for claim in cells if judge(claim).verdict == "misprint"}
    assert found == SLIPS | LATER_SLIPS


def test_generated_affine_coordinates_reproduce_the_model():
    computed = affine.space_coordinates(MODEL, BASIC)
    for name, row in zip(NAMES, computed, strict=True):
        for component, value in enumerate(row):
            number = f"4/a#{name}.y{component + 1}"
            assert reproduced(example.AFFINE[name][component], value) is (number not in SLIPS), number


def test_mpmath_gives_the_same_affine_coordinates():
    with mpmath.workdps(40):
        frame = mpmath.matrix([[mpmath.mpf(v) for v in row] for row in (BASIC[1:] - BASIC[0]).T.tolist()])
        for position, row in zip(MODEL, affine.space_coordinates(MODEL, BASIC), strict=True):
            exact = mpmath.lu_solve(frame, mpmath.matrix([mpmath.mpf(v) for v in (position - BASIC[0]).tolist()]))
            assert [float(v) for v in exact] == pytest.approx(row.tolist(), rel=1e-12, abs=1e-12)


@pytest.mark.parametrize(("side", "center"), [("left", "O1"), ("right", "O2")])
def test_image_coordinates_follow_from_center_and_fourth_image_alone(side, center):
    """No principal distance and no rotation: model, center and the image of G3 determine all other images."""
    table, _ = example.PICTURES[side]
    model = dict(zip(NAMES, affine.space_coordinates(MODEL, BASIC), strict=True))
    fourth = np.array([float(u) for u in example.cells(example.picture(example.FULL_ROTATIONS[side], center), "2")[2:]])
    mu = projection.mu_from_center(model[center], fourth)
    for name, printed in table.items():
        image = projection.project(model[name], mu, fourth)
        for component in range(2):
            number = f"4/b#{name}.{side}.u{component + 1}"
            assert reproduced(printed[2 + component], image[component]) is (number not in SLIPS | CUT_OFF), number


@pytest.mark.parametrize("side", ["left", "right"])
def test_affine_image_coordinates_follow_from_the_measured_ones(side):
    table = example.LEFT if side == "left" else example.RIGHT
    points = {name: np.array([float(row[0]), float(row[1])]) for name, row in table.items()}
    frame = np.array([points[name] for name in ("1", "4", "5")])
    for name, printed in table.items():
        if name.startswith("O") or any(n.startswith(f"4/b#{name}.{side}") for n in SLIPS):
            continue
        computed = affine.plane_coordinates(points[name], frame)
        assert computed.tolist() == pytest.approx([float(printed[2]), float(printed[3])], abs=3e-7)


@pytest.mark.parametrize(("side", "center"), [("left", "O1"), ("right", "O2")])
def test_the_printed_rotation_and_principal_distance_give_the_pictures_in_mpmath(side, center):
    table, printed_matrix = (example.LEFT, example.R_LEFT) if side == "left" else (example.RIGHT, example.R_RIGHT)
    with mpmath.workdps(40):
        rotation = mpmath.matrix([[mpmath.mpf(cell) for cell in row] for row in printed_matrix])
        for name, printed in table.items():
            ray = mpmath.matrix(
                [mpmath.mpf(v) for v in (MODEL[NAMES.index(name)] - MODEL[NAMES.index(center)]).tolist()]
            )
            v = rotation * ray
            for place in range(2):
                if f"4/b#{name}.{side}.{'xy'[place]}" not in SLIPS:
                    difference = mpmath.mpf(printed[place]) + mpmath.mpf("2.5") * v[place] / v[2]
                    assert abs(difference) < 5e-7


def test_the_printed_matrices_are_rotations_to_their_last_digit():
    for matrix in (example.R_LEFT, example.R_RIGHT):
        rotation = np.array([[float(cell) for cell in row] for row in matrix])
        np.testing.assert_allclose(rotation.T @ rotation, np.eye(3), atol=2e-8)
        digits = min(-int(Decimal(cell).as_tuple().exponent) for row in matrix for cell in row)
        assert digits == 8

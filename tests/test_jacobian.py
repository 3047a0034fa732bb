"""Jacobians: their entries are the exact derivatives of what their kernels derive."""

from fractions import Fraction

import numpy as np
import pytest
import sympy

from algebroproj_sym import Section
from algebroproj_sym.declaring import (
    DeclarationError,
    arctan2,
    cos_sin,
    exp,
    hypot,
    kernels,
    let,
    log,
    null_vector,
    solution,
    sqrt,
)  # fmt: skip
from algebroproj_sym.declaring.jacobian import derivative
from algebroproj_sym.expressions import Matrix, derivatives, divided, evaluate, over, vector
from algebroproj_sym.generating.backends.numpy import render
from algebroproj_sym.generating.choosing import lower
from algebroproj_sym.generating.writing import PACKAGE, write
from algebroproj_sym.proving import RationalFunctionField
from algebroproj_sym.verifying.proof_of_source import source_is_proved
from algebroproj_sym.verifying.shipped import call, function_of, load_package

x, y, u, v, c, s, w = sympy.symbols("x y u v c s w")
DECLARED = {kernel.qualified_name: kernel for kernel in kernels()}
PARTS = {"first": x * y, "second": vector(x, over(y, x))}
SYSTEM = solution([u, v], Matrix([[x, c], [s, y]]), vector(w, 1))
JACOBIANS = [name for name in DECLARED if name.endswith("_jacobian") and name.removesuffix("_jacobian") in DECLARED]
RATIONAL = [name for name in JACOBIANS if not DECLARED[name].stages]


def declared(derived, through=(), **options):
    section = Section("demo", "1", "D")
    section.kernel(
        "demo.f",
        "A.",
        arguments={"x": x, "y": y},
        derived=derived,
        through=through,
        claims=["1.1"],
        example={"x": "0.5", "y": "0.25"},
        describe={"x": "A number.", "y": "A number."},
        jacobian=True,
        **options,
    )
    return section.kernels


def shipped(folder, pair):
    write(render([lower(kernel) for kernel in pair]), folder / PACKAGE)
    return load_package(folder)


def test_kernels_have_jacobians():
    assert {"projection.projection_matrix_jacobian", "metric.reconstruct_jacobian"} <= {*JACOBIANS}


@pytest.mark.parametrize("name", RATIONAL)
def test_every_entry_is_the_derivative_by_dual_numbers(name):
    jacobian, kernel = DECLARED[name], DECLARED[name.removesuffix("_jacobian")]
    symbols = kernel.symbols
    field = RationalFunctionField(symbols, "flint")
    zero, one = (field.lift(Fraction(value)) for value in (0, 1))
    for before, after in zip(kernel.results, jacobian.results, strict=True):
        directions = [[one if k == j else zero for k in range(len(symbols))] for j in range(len(symbols))]
        columns = [derivatives(before.derived, field.variables, symbols, d, field.lift) for d in directions]
        assert after.shape == ((len(columns[0]), len(columns)) if before.shape else (len(columns),))
        expected = [entry for row in zip(*columns, strict=True) for entry in row]
        computed = evaluate(after.derived, field.variables, field.lift)
        assert all((a - b).is_zero for a, b in zip(computed, expected, strict=True))


def test_divisions_stay_recorded():
    slope = derivative(over(x * y, y), {x: sympy.Integer(1)})
    assert slope.has(over)
    assert sympy.simplify(divided(slope) - 1) == 0
    assert derivative(over(1, y), {x: sympy.Integer(1)}) == 0


@pytest.mark.parametrize(
    ("derived", "options"),
    [
        (over(x, y) + x**3 * y, {}),
        (vector(x * y, over(1, x - y)), {"form": vector(x * y, over(1, w)), "where": {w: x - y}}),
        (Matrix([[x, 1], [y**2, x * y]]), {}),
        (PARTS, {"form": PARTS}),
        (vector(u * c, v * s), {"through": [let({w: x * y + 1}), cos_sin(c, s, w), SYSTEM]}),
        (vector(u * v, s), {"through": [hypot(u, x, x * y), log(w, u + x), exp(v, w - y), sqrt(s, v + 1)]}),
        (s * u, {"through": [arctan2(u, y, x), sqrt(s, over(x, y))]}),
        (u * y + x, {"through": [solution([u], Matrix([[x + 2]]), vector(y * x))]}),
    ],
)
def test_jacobians_agree_with_differences_and_their_source_is_proved(derived, options, tmp_path):
    pair = declared(derived, **options)
    package = shipped(tmp_path, pair)
    kernel, jacobian = pair
    assert source_is_proved(jacobian, package)
    at, step = np.array([0.75, 0.375]), 1e-6
    rows = call(function_of(jacobian, package), jacobian, {"x": at[0], "y": at[1]}).reshape(-1, 2)
    for place in range(2):
        shift = step * np.eye(2)[place]
        points = [dict(zip("xy", at + d, strict=True)) for d in (shift, -shift)]
        ahead, behind = (call(function_of(kernel, package), kernel, point) for point in points)
        np.testing.assert_allclose(rows[:, place], (ahead - behind) / (2 * step), rtol=1e-7, atol=1e-7)


def test_null_spaces_have_no_jacobian():
    with pytest.raises(DeclarationError, match="jacobian: expected stages that can be differentiated, got null_vector"):
        declared(u + v, [null_vector([u, v], Matrix([[x, y]]))])

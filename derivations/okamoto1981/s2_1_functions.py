# %% [markdown]
# # 2.1 Functions
#
# The condition of coplanarity and the intersection of two rays as functions.

# %%
import sympy

from algebroproj_derivations.okamoto1981.notation import *
from algebroproj_derivations.okamoto1981.s2_1_algebraic_consideration import (
    PARTNERS,
    PLACES,
    A_left,
    A_right,
    P_left,
    P_right,
    Ray,
    coefficient_rows,
    coplanarity,
    from_three,
    moment,
    ray_of,
    right_sides,
    wedge,
    with_ray,
    with_right_sides,
    x_left,
    x_right,
)
from algebroproj_sym import Section
from algebroproj_sym.declaring import let
from algebroproj_sym.expressions import Matrix, Scalar, columns, dot, over, vector

section = Section("okamoto1981", "2.1", "General orientation problem, algebraic consideration: functions")

# %% [markdown]
# ## Rays as intermediate results
#
# The coordinates of both rays get symbols of their own.  Their values are minors of two equations; computed are the
# forms that are linear in the image point.

# %%
symbols_left, symbols_right = (dict(zip(PLACES, sympy.symbols(f"ray{k}_1:7"), strict=True)) for k in (1, 2))
rows_of_equations = columns(coefficient_rows, right_sides)
ray_values, ray_forms = {}, {}
for symbols_of_ray, matrix, measured, first in (
    (symbols_left, P_left, x_left, 0),
    (symbols_right, P_right, x_right, 2),
):
    values = wedge(rows_of_equations.row(first), rows_of_equations.row(first + 1))
    linear = ray_of(matrix, measured)
    ray_values |= {symbol: values[place] for place, symbol in symbols_of_ray.items()}
    ray_forms |= {symbol: linear[place] for place, symbol in symbols_of_ray.items()}


def equation_with_ray(matrix: Matrix, measured: Matrix, i: int, ray: Ray, unknown: int) -> Scalar:
    """Return the determinant of equation i of a photograph and a ray."""
    signed_rows = with_right_sides(matrix)
    first, last = (with_ray(signed_rows.row(k), ray, unknown) for k in (i, 2))
    return measured[i] * last - first


# %% [markdown]
# ## Functions

# %%
with_images = {
    "arguments": {"A_left": A_left, "A_right": A_right, "x_left": x_left, "x_right": x_right},
    "describe": {
        "A_left": f"Left photograph: {ABOUT_A}",
        "A_right": f"Right photograph: {ABOUT_A}",
        "x_left": f"Left photograph: {ABOUT_IMAGE}",
        "x_right": f"Right photograph: {ABOUT_IMAGE}",
    },
    "example": {
        "A_left": (
            *("1.25", "0.125", "0.25", "10.5", "-0.125", "1.375"),
            *("0.0625", "20.25", "0.0025", "-0.00125", "0.005"),
        ),
        "A_right": (
            *("1.125", "-0.0625", "0.375", "-8.5", "0.0625", "1.25"),
            *("-0.125", "18.75", "-0.00375", "0.0025", "0.00625"),
        ),
        "x_left": ("26.75", "9.5"),
        "x_right": ("15.25", "5.125"),
    },
}
section.kernel(
    "collinearity.coplanarity_determinant",
    "Determinant of the condition of coplanarity, zero for homologous image points.",
    **with_images,
    derived=coplanarity,
    form=moment(symbols_left, symbols_right),
    where=ray_forms,
    claims=["18#1", "18#2", "18#3", "18#4", "19", "2.1/beyond/moment"],
)
denominator = sympy.Symbol("D")
with_left_ray = [equation_with_ray(P_right, x_right, 0, symbols_left, j) for j in range(4)]
section.kernel(
    "collinearity.intersect_three",
    "Object point from both coordinates of the left and the first coordinate of the right image point.",
    **with_images,
    derived=from_three,
    form=vector(*(with_left_ray[j] / denominator for j in range(3))),
    where={symbol: ray_forms[symbol] for symbol in symbols_left.values()} | {denominator: with_left_ray[3]},
    claims=["18#1", "18#2", "18#3", "19#sufficient", "2.1/beyond/rays"],
)
minors_of_four = Matrix(4, 4, sympy.symbols("d1:5(1:5)"))
own = (
    (P_left, x_left, 1, symbols_right),
    (P_left, x_left, 0, symbols_right),
    (P_right, x_right, 1, symbols_left),
    (P_right, x_right, 0, symbols_left),
)
minor_values = {
    minors_of_four[i, j]: with_ray(rows_of_equations.row(PARTNERS[i][0]), own[i][3], j)
    for i in range(4)
    for j in range(4)
}
minor_forms = {minors_of_four[i, j]: equation_with_ray(*own[i], j) for i in range(4) for j in range(4)}
squares = dot(minors_of_four.col(3), minors_of_four.col(3))
section.kernel(
    "collinearity.intersect",
    "Object point from four linear equations by least squares with equal weights of the equations.",
    **with_images,
    through=[let(ray_values, form=ray_forms), let(minor_values, form=minor_forms)],
    derived=vector(*(over(dot(minors_of_four.col(3), minors_of_four.col(j)), squares) for j in range(3))),
    claims=[
        *("18#1", "18#2", "18#3", "18#4"),
        *("2.1/beyond/normal-equations", "2.1/beyond/exact", "2.1/beyond/rays"),
    ],
    normwise=True,
)

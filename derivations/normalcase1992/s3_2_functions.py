# %% [markdown]
# # 3.2 Functions
#
# Derivatives and dispersion of the normal case coordinates as functions, in forms that do not cancel.

# %%
import sympy

from algebroproj_derivations.inserting import given
from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_derivations.normalcase1992.s3_2_propagation import (
    B_a,
    B_a_any,
    B_x,
    B_x_any,
    row1,
    row2,
    row3,
    xn,
    yn,
)
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, dot, over, vector

section = Section("normalcase1992", "3.2", "Propagation of errors concerning transformation: functions")

# %%
S_a = sympy.MatrixSymbol("S_a", 3, 3)
variance_of_image = sympy.Symbol("variance")
x_normal = vector(xn, yn)
image_and_orientation = {"R": R_any, "x": vector(x, y), "c": c}
about_image = {"R": ABOUT_R, "x": ABOUT_X, "c": ABOUT_C}
EXAMPLE = {
    "R": (("0.96", "0", "-0.28"), ("0", "1", "0"), ("0.28", "0", "0.96")),
    "x": ("-10.62", "1.694"),
    "c": "51.18",
}

depth, slope_x, slope_y = sympy.symbols("depth slope_x slope_y")
SLOPES = {
    depth: dot(row3, x_vector),
    slope_x: dot(row1, x_vector) / depth,
    slope_y: dot(row2, x_vector) / depth,
}
B_a_of_slopes = c * Matrix(
    [[slope_x * slope_y, -1 - slope_x**2, slope_y], [1 + slope_y**2, -slope_x * slope_y, -slope_x]]
)


def shifts_of(row: Matrix) -> Matrix:
    """Return the derivatives of one coordinate, with products in which no terms are left that cancel."""
    (ij, ik), jk = (row[0] * row3[k] - row[k] * row3[0] for k in (1, 2)), row[1] * row3[2] - row[2] * row3[1]
    return c / depth**2 * Matrix([[ik * c - ij * y, ij * x + jk * c]])


B_x_of_minors = shifts_of(row1).col_join(shifts_of(row2))

section.kernel(
    "metric.jacobian_angles",
    "Derivatives of normal case coordinates with respect to small rotations (dOmega, dphi, dkappa).",
    arguments={"x_n": x_normal, "c": c},
    describe={
        "x_n": "Image point (xN, yN) of the normal case, in the unit of c.",
        "c": ABOUT_C + "  The derivatives have this unit per radian.",
    },
    derived=Matrix([[over(xn * yn, c), -c - over(xn**2, c), -yn], [c + over(yn**2, c), -over(xn * yn, c), xn]]),
    claims=["3.2/beyond/B_a", "3.2.1"],
    example={"x_n": ("5.5", "-12.25"), "c": "51.18"},
)
section.kernel(
    "metric.jacobian_image",
    "Derivatives of normal case coordinates with respect to the image coordinates.",
    arguments=image_and_orientation,
    describe=about_image,
    derived=B_x,
    form=B_x_of_minors,
    where=SLOPES,
    claims=["3.2.1#B_x", "3.2.1"],
    example=EXAMPLE,
)
section.kernel(
    "metric.normal_covariance",
    "Dispersion of normal case coordinates from those of the rotations and of the image coordinates.",
    arguments={**image_and_orientation, "S_a": S_a, "variance": variance_of_image},
    describe={
        **about_image,
        "S_a": "Dispersion of the rotations (dOmega, dphi, dkappa), in radians squared.",
        "variance": "Variance of an image coordinate, in the square of the unit of c.",
    },
    properties={S_a: "symmetric"},
    derived=B_a * S_a * B_a.T + variance_of_image * B_x * B_x.T,
    form=B_a_any * S_a * B_a_any.T + variance_of_image * B_x_any * B_x_any.T,
    where=SLOPES | given((*B_a_any, *B_x_any), (*B_a_of_slopes, *B_x_of_minors)),
    claims=["3.2.2", "3.2.1", "3.2/beyond/B_a"],
    example={
        **EXAMPLE,
        "S_a": (("0.00004", "0.00001", "0"), ("0.00001", "0.00006", "0.00002"), ("0", "0.00002", "0.00003")),
        "variance": "0.000004",
    },
)

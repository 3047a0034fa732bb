# %% [markdown]
# # 2.2 Determination and utilization of the matrix of correlation: functions
#
# The formulas of the section as functions.

# %%
import sympy

from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s1_3_functions import delta
from algebroproj_derivations.fundamentals1996.s2_2_correlation import (
    C_of_cameras,
    D,
    D_printed,
    Z,
    c,
    delta_left,
    delta_right,
    differences,
    equation,
    polynomials,
    primed,
    reduced,
    remaining,
    u_left,
    u_right,
    up1,
    up2,
    upp1,
    upp2,
    z,
    z01,
    z02,
    z10,
    z11,
    z12,
    z20,
    z21,
    z22,
)
from algebroproj_sym import Section
from algebroproj_sym.declaring import null_vector, solution
from algebroproj_sym.expressions import Matrix, diff, linear_system, solve, vector

section = Section("fundamentals1996", "2.2", "Determination and utilization of the matrix of correlation: functions")

# %% [markdown]
# ## Forms
#
# $\mathbf Z$ may be any matrix of correlation, $\mathbf C$ or a multiple of it.

# %%
image_left, image_right = vector(up1, up2), vector(upp1, upp2)
ABOUT_IMAGE = "affine coordinates, referred to the images of the basic points G0, G1, G2; dimensionless."
ABOUT_Z = "Matrix of correlation, up to a common factor; dimensionless."
with_points = {
    "arguments": {"u_left": image_left, "u_right": image_right},
    "describe": {
        "u_left": f"Image point (u1', u2') of the left image in {ABOUT_IMAGE}",
        "u_right": f"Homologous point (u1'', u2'') of the right image in {ABOUT_IMAGE}",
    },
    "example": {"u_left": ("0.625", "0.125"), "u_right": ("0.65", "0.1")},
}
EXAMPLE_Z = (("0", "-0.975", "-0.125"), ("1", "-0.025", "0.075"), ("0.125", "-0.08", "0"))

section.kernel(
    "correlation.design_row",
    "Coefficients of one equation for the elements (z11, z12, z20, z21, z22) of the matrix of correlation.",
    **with_points,
    derived=reduced[0, :5].T,
    form=vector(upp1 * (up1 - 1), up1 * upp2, up2 - upp2, up2 * upp1, upp2 * (up2 - 1)),
    claims=["2.2.4"],
)
section.kernel(
    "correlation.rhs",
    "Right side of one equation for the elements of the matrix of correlation.",
    **with_points,
    derived=reduced[0, 5],
    form=upp1 - up1,
    claims=["2.2.4"],
)
section.kernel(
    "correlation.epipolar_line_left",
    "Epipolar line h' in the left image of a point of the right image.",
    arguments={"Z": z, "u_right": image_right},
    describe={"Z": ABOUT_Z, "u_right": f"Image point (u1'', u2'') of the right image in {ABOUT_IMAGE}"},
    derived=z * u_right,
    claims=["2.1/lines", "2.2.5#left"],
    example={"Z": EXAMPLE_Z, "u_right": ("0.65", "0.1")},
)
section.kernel(
    "correlation.epipolar_line_right",
    "Epipolar line h'' in the right image of a point of the left image.",
    arguments={"Z": z, "u_left": image_left},
    describe={"Z": ABOUT_Z, "u_left": f"Image point (u1', u2') of the left image in {ABOUT_IMAGE}"},
    derived=z.T * u_left,
    claims=["2.1/lines", "2.2.5#right"],
    example={"Z": EXAMPLE_Z, "u_left": ("0.625", "0.125")},
)
section.kernel(
    "correlation.correlation_from_cameras",
    "Matrix of correlation C from the projective parameters of both images.",
    arguments={
        "mu_left": primed(mu, "p"),
        "u3_left": primed(fourth_image, "p"),
        "mu_right": primed(mu, "pp"),
        "u3_right": primed(fourth_image, "pp"),
    },
    describe={
        "mu_left": f"Left image: {ABOUT_MU}",
        "u3_left": f"Left image: {ABOUT_U3}",
        "mu_right": f"Right image: {ABOUT_MU}",
        "u3_right": f"Right image: {ABOUT_U3}",
    },
    derived=Matrix(3, 3, [0, *C_of_cameras[1:]]),
    form=polynomials / (delta_left * delta_right),
    where=differences | {delta_left: primed(delta, "p"), delta_right: primed(delta, "pp")},
    claims=["2.1.4", "2.1.4#components", "2.2.3#cameras", "2.2/beyond/cameras"],
    example={
        "mu_left": ("0.625", "0.75", "0.5"),
        "u3_left": ("0.25", "0.125"),
        "mu_right": ("0.75", "0.625", "0.875"),
        "u3_right": ("0.3125", "-0.25"),
    },
)

# %% [markdown]
# Five homologous points give five equations; eight in any image coordinates, the nine elements but for a factor, which
# makes the largest one 1.  The epipoles are those of (2.2.6) and (2.2.7), of any multiple of $\mathbf Z$.

# %%
EXAMPLE_LEFT = (
    ("0.2718578", "0.0577379"),
    ("0.6355182", "0.1372296"),
    ("0.3708332", "0.6469605"),
    ("0.6721215", "0.8655064"),
    ("0.9987487", "0.8349783"),
)
EXAMPLE_RIGHT = (
    ("0.3094497", "-0.2327183"),
    ("0.6442013", "0.1043779"),
    ("0.3638478", "0.7763496"),
    ("0.6670692", "1.0009998"),
    ("1.0056120", "0.6733497"),
)
five_left, five_right = (Matrix(5, 2, sympy.symbols(f"{name}(3:8)(1:3)")) for name in ("up", "upp"))
factored_row = Matrix([[upp1 * (up1 - 1), up1 * upp2, up2 - upp2, up2 * upp1, upp2 * (up2 - 1), upp1 - up1]])


def of_points(row: Matrix, left: Matrix, right: Matrix) -> Matrix:
    """Return the equations of homologous points, one below the other."""
    one_pair = (*image_left, *image_right)
    pairs = zip(left.tolist(), right.tolist(), strict=True)
    return Matrix.vstack(*(row.xreplace(dict(zip(one_pair, (*a, *b), strict=True))) for a, b in pairs))


five_equations = of_points(reduced, five_left, five_right)
factored_equations = of_points(factored_row, five_left, five_right)
with_five_points = {
    "arguments": {"u_left": five_left, "u_right": five_right},
    "describe": {
        "u_left": f"Five image points (u1', u2') of the left image in {ABOUT_IMAGE}",
        "u_right": f"Homologous points (u1'', u2'') of the right image in {ABOUT_IMAGE}",
    },
    "example": {"u_left": EXAMPLE_LEFT, "u_right": EXAMPLE_RIGHT},
}
section.kernel(
    "correlation.system",
    "Matrix and right side of the five equations for the elements (z11, z12, z20, z21, z22).",
    **with_five_points,
    derived={"matrix": five_equations[:, :5], "right_side": five_equations[:, 5]},
    form={"matrix": factored_equations[:, :5], "right_side": factored_equations[:, 5]},
    claims=["2.2.4"],
)
section.kernel(
    "correlation.correlation_matrix",
    "Matrix of correlation Z, with z10 = 1, from five points beside the three basic points.",
    **with_five_points,
    through=[solution(remaining, five_equations[:, :5], five_equations[:, 5], form=factored_equations)],
    derived=Z,
    claims=["2.2.2", "2.2.3", "2.2.4"],
    normwise=True,
)
eight_left, eight_right = (Matrix(8, 2, sympy.symbols(f"{name}(:8)(1:3)")) for name in ("vp", "vpp"))
any_row = Matrix([[diff(equation(c), element) for element in c]])
section.kernel(
    "correlation.general_correlation_matrix",
    "Matrix of correlation, from eight homologous points in any image coordinates, scaled to its largest element.",
    arguments={"v_left": eight_left, "v_right": eight_right},
    describe={
        "v_left": "Eight image points (v1', v2') of the left image, in any affine coordinates of it, in any unit; "
        "coordinates of the order of 1 keep the system well conditioned.",
        "v_right": "Homologous points (v1'', v2'') of the right image, in any affine coordinates of it.",
    },
    through=[null_vector(list(c), of_points(any_row, eight_left, eight_right))],
    derived=c,
    claims=["2.2.1", "2.2/row", "2.2/C-bar", "2.2/eight-points"],
    example={
        "v_left": (("0", "0"), ("1", "0"), ("0", "1"), *EXAMPLE_LEFT),
        "v_right": (("0", "0"), ("1", "0"), ("0", "1"), *EXAMPLE_RIGHT),
    },
    normwise=True,
)
any_line_left, any_line_right = z * u_right, z.T * u_left
any_epipoles = {
    "left": solve(*linear_system([any_line_right[1], any_line_right[2]], (up1, up2))),
    "right": solve(*linear_system([any_line_left[1], any_line_left[2]], (upp1, upp2))),
}
section.kernel(
    "correlation.epipoles",
    "Epipoles (u01', u02') and (u01'', u02'') of the left and of the right image.",
    arguments={"Z": z},
    describe={"Z": ABOUT_Z},
    derived=any_epipoles,
    form={
        "left": vector((z02 * z21 - z01 * z22) / D, (z01 * z12 - z02 * z11) / D),
        "right": vector((z12 * z20 - z10 * z22) / D, (z10 * z21 - z11 * z20) / D),
    },
    where={D: D_printed},
    claims=["2.2.6", "2.2.7", "2.2/D"],
    example={"Z": EXAMPLE_Z},
)

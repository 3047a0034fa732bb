# %% [markdown]
# # 1.1 Functions
#
# The general collinearity equations, their derivatives and their coefficients as functions.

# %%
import sympy

from algebroproj_derivations.inserting import given
from algebroproj_derivations.okamoto1981.notation import *
from algebroproj_derivations.okamoto1981.s1_1_general_collinearity import (
    A,
    by_coefficients,
    by_point,
    coefficient_jacobian,
    denominator,
    e,
    point_jacobian,
    projected,
    w,
)
from algebroproj_sym import Section
from algebroproj_sym.declaring import cos_sin
from algebroproj_sym.expressions import dot, vector

section = Section("okamoto1981", "1.1", "Characteristics of the general collinearity equations: functions")

# %% [markdown]
# ## Coefficients of a camera
#
# The coefficients come from the eleven parameters of the text, $\gamma = 0$, with cosine and sine of every angle.

# %%
phi, omega, kappa = sympy.symbols("phi omega kappa")
alpha, beta = sympy.symbols("alpha beta_")
cosines_and_sines = {angle: sympy.symbols(f"c_{angle} s_{angle}") for angle in (phi, omega, kappa, alpha, beta)}
turns_of_camera = [
    (axis, *cosines_and_sines[angle])
    for axis, angle in zip((ABOUT_Y, ABOUT_X, ABOUT_Z), (phi, omega, kappa), strict=True)
]
turns_of_comparator = [
    (axis, *cosines_and_sines[angle]) for axis, angle in zip((ABOUT_Y, ABOUT_X), (alpha, beta), strict=True)
]
rotation_of_camera, rotation_of_comparator = rotation(*turns_of_camera).T, rotation(*turns_of_comparator)
camera_of_angles = camera(
    seen_by_comparator(rotation_of_comparator[:2, :], c, comparator_center), rotation_of_camera, center
)

# %% [markdown]
# With $\mathbf r = \mathbf E\, (X_o, Y_o, Z_o)^T$ the constants of the numerators are $x_{co}$ and $y_{co}$ and a
# remainder, which does not lose digits where $r_3$ is small.

# %%
principal_distance = sympy.Symbol("principal_distance")
r = vector(*sympy.symbols("r1:4"))
picture_rows = rotation_of_comparator[:2, :] * e
coefficient_form = vector(
    *(
        entry
        for i in range(2)
        for entry in (
            *((c * picture_rows[i, j] - comparator_center[i] * e[2, j]) / r[2] for j in range(3)),
            comparator_center[i] - c * dot(rotation_of_comparator.row(i).T, r) / r[2],
        )
    ),
    *(-e[2, j] / r[2] for j in range(3)),
)
EXAMPLE_A = ("1.25", "0.125", "0.25", "10.5", "-0.125", "1.375", "0.0625", "20.25", "0.0025", "-0.00125", "0.005")
with_point = {
    "arguments": {"A": A, "X": point},
    "describe": {"A": ABOUT_A, "X": ABOUT_POINT},
    "example": {"A": EXAMPLE_A, "X": ("12.5", "-7.25", "31.75")},
}

section.kernel(
    "collinearity.coefficients",
    "Coefficients (A1, ..., A11) of the general collinearity equations from eleven orientation parameters.",
    arguments={
        "angles": vector(phi, omega, kappa),
        "center": center,
        "principal_distance": principal_distance,
        "comparator_angles": vector(alpha, beta),
        "comparator_center": comparator_center,
    },
    through=[cos_sin(*values, angle) for angle, values in cosines_and_sines.items()],
    derived=coefficients_of(camera_of_angles).xreplace({c: principal_distance}),
    form=coefficient_form.xreplace({c: principal_distance}),
    where=given((*e, *r), (*rotation_of_camera, *(e * center))),
    claims=["6", "7"],
    describe={
        "angles": "Rotations (phi, omega, kappa) of the picture about Y, X and Z; radians.",
        "center": "Projection center (Xo, Yo, Zo) in the object system; any unit of length.  The plane through it "
        "parallel to the picture must not contain the origin.",
        "principal_distance": "Principal distance c of the picture; unit of the image coordinates.",
        "comparator_angles": "Inclinations (alpha, beta) of the picture about the comparator axes yc and xc; radians.",
        "comparator_center": "Projection center (xco, yco) in the system of the comparator; unit of the image "
        "coordinates.",
    },
    example={
        "angles": ("0.125", "-0.25", "0.5"),
        "center": ("12.5", "-7.25", "101.75"),
        "principal_distance": "152.25",
        "comparator_angles": ("0.0625", "-0.03125"),
        "comparator_center": ("110.5", "95.25"),
    },
)
section.kernel(
    "collinearity.project",
    "Measured image point of an object point by the general collinearity equations.",
    **with_point,
    derived=projected,
    claims=["7", "1#matrix"],
)
section.kernel(
    "collinearity.project_jacobian_parameters",
    "Derivatives of the measured image point with respect to the coefficients (A1, ..., A11).",
    **with_point,
    derived=by_coefficients,
    form=coefficient_jacobian,
    where={w: denominator},
    claims=["1#matrix", "7/beyond/by-coefficients"],
)
section.kernel(
    "collinearity.project_jacobian_point",
    "Derivatives of the measured image point with respect to the object point.",
    **with_point,
    derived=by_point,
    form=point_jacobian,
    where={w: denominator},
    claims=["1#matrix", "7/beyond/by-point"],
)

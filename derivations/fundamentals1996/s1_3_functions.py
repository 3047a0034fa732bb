# %% [markdown]
# # 1.3 Functions
#
# The formulas of section 1.3 as functions.

# %%
import sympy

from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s1_3_properties_of_projection import (
    Delta,
    Delta_of_y0,
    P,
    P_of_y0,
    P_star,
    P_star_of_y0,
    mu_of_y0,
    point,
    u_of_y,
    y0_of_mu,
)
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, vector

section = Section("fundamentals1996", "1.3", "Properties of the matrix of projection: functions")

# %% [markdown]
# ## Forms that do not cancel
#
# Center and image enter through the barycentric abbreviations $y_{00}$ and $u_{30}$.  In differences such as
# $u_{31} y_{00} - u_{30} y_{01}$ the product $u_{31} y_{01}$ cancels; left in, it costs any number of digits where it
# is large.  The forms below have it taken out, and keep what remains, $a_j = y_{00} + y_{0j}$ and
# $b_j = u_{30} + u_{3j}$, common to numerator and denominator, where the rounding of one offsets the other.

# %%
A1, A2, B1, B2, W1, W2, N1, N2 = sympy.symbols("a1 a2 b1 b2 w1 w2 n1 n2")
D, D1, D2 = sympy.symbols("delta d1 d2")
SHARED = {A1: 1 - y02 - y03, A2: 1 - y01 - y03, B1: 1 - u32, B2: 1 - u31}
DIFFERENCES = SHARED | {W1: u31 * A1 - B1 * y01, W2: u32 * A2 - B2 * y02}
with_center = {"arguments": {"y0": center, "u3": fourth_image}, "describe": {"y0": ABOUT_Y0, "u3": ABOUT_U3}}
with_mu = {"arguments": {"mu": mu, "u3": fourth_image}, "describe": {"mu": ABOUT_MU, "u3": ABOUT_U3}}
EXAMPLE_CENTER = {"y0": ("-1.0679613", "-0.2268166", "4.1115155"), "u3": ("0.2718578", "0.0577379")}
EXAMPLE_MU = {"mu": ("0.625", "0.75", "0.5"), "u3": ("0.25", "0.125")}

section.kernel(
    "projection.mu_from_center",
    "Projective parameters from the center of projection.",
    **with_center,
    derived=mu_of_y0,
    form=vector(u31 * y00 / (u30 * y01), u32 * y00 / (u30 * y02), -y00 / (u30 * y03)),
    where=BARYCENTRIC,
    claims=["1.3.5#mu1", "1.3.5#mu2", "1.3.5#mu3"],
    example=EXAMPLE_CENTER,
    jacobian=True,
)
delta = mu1 * mu2 * (mu3 - 1) - mu3 * (u31 * mu2 * (mu1 - 1) + u32 * mu1 * (mu2 - 1))
section.kernel(
    "projection.center_from_mu",
    "Center of projection from the projective parameters.",
    **with_mu,
    derived=y0_of_mu,
    form=vector(u31 * mu2 * mu3 / D, u32 * mu1 * mu3 / D, -mu1 * mu2 / D),
    where={D: delta},
    claims=["1.3/y01", "1.3/y02", "1.3/y03"],
    example=EXAMPLE_MU,
)
section.kernel(
    "projection.projection_matrix",
    "Matrix of projection P* from the center of projection.",
    **with_center,
    derived=P_star_of_y0,
    form=Matrix(
        [
            [
                W1 / ((B1 - u31) * y01),
                W2 / ((B2 - u32) * y02),
                ((u31 + u32) * y03 - (1 - y01 - y02)) / ((1 - (u31 + u32)) * y03),
            ],
            [u31 * y00 / (u30 * y01), 0, -u31 * y00 / (u30 * y03)],
            [0, u32 * y00 / (u30 * y02), -u32 * y00 / (u30 * y03)],
        ]
    ),
    where=BARYCENTRIC | DIFFERENCES,
    alternatives=[
        {
            "form": Matrix(
                [
                    [
                        (u31 * y00 - u30 * y01) / (u30 * y01),
                        (u32 * y00 - u30 * y02) / (u30 * y02),
                        -(y00 + u30 * y03) / (u30 * y03),
                    ],
                    [u31 * y00 / (u30 * y01), 0, -u31 * y00 / (u30 * y03)],
                    [0, u32 * y00 / (u30 * y02), -u32 * y00 / (u30 * y03)],
                ]
            ),
            "where": BARYCENTRIC,
        },
    ],
    claims=["1.3.6#row0", "1.3.6#rows12"],
    example=EXAMPLE_CENTER,
    jacobian=True,
)
section.kernel(
    "projection.projection_matrix_from_mu",
    "Matrix of projection P* from the projective parameters.",
    **with_mu,
    derived=P_star,
    claims=["1.3.2"],
    example=EXAMPLE_MU,
)
section.kernel(
    "projection.projection_determinant",
    "Determinant of the matrix of projection from the center of projection.",
    **with_center,
    derived=Delta_of_y0,
    form=-u31 * u32 * y00**2 / (u30**2 * y01 * y02 * y03),
    where=BARYCENTRIC,
    claims=["1.3.8"],
    example=EXAMPLE_CENTER,
)
section.kernel(
    "projection.projection_determinant_from_mu",
    "Determinant of the matrix of projection from the projective parameters.",
    **with_mu,
    derived=Delta,
    form=delta,
    claims=["1.3.3"],
    example=EXAMPLE_MU,
)
section.kernel(
    "projection.reconstruction_matrix",
    "Matrix of reconstruction P from the center of projection.",
    **with_center,
    derived=P_of_y0,
    form=Matrix(
        [
            [-y01, y01 * (B1 * (1 - y01) - u31 * (y02 + y03)) / D1, y01 * W2 / D2],
            [-y02, y02 * W1 / D1, y02 * (B2 * (1 - y02) - u32 * (y01 + y03)) / D2],
            [-y03, y03 * W1 / D1, y03 * W2 / D2],
        ]
    ),
    where=DIFFERENCES | {D1: u31 * (A1 - y01), D2: u32 * (A2 - y02)},
    alternatives=[
        {
            "form": Matrix(
                [
                    [-y01, y01 * (D1 + u30 * (1 - y01)) / D1, y01 * W2 / D2],
                    [-y02, y02 * W1 / D1, y02 * (D2 + u30 * (1 - y02)) / D2],
                    [-y03, y03 * W1 / D1, y03 * W2 / D2],
                ]
            ),
            "where": BARYCENTRIC | {D1: u31 * y00, D2: u32 * y00, W1: D1 - u30 * y01, W2: D2 - u30 * y02},
        },
    ],
    claims=["1.3.7"],
    example=EXAMPLE_CENTER,
)
section.kernel(
    "projection.reconstruction_matrix_from_mu",
    "Matrix of reconstruction P from the projective parameters.",
    **with_mu,
    derived=P,
    form=Matrix(
        [
            [-mu2 * mu3 * u31 / D1, N1 / D1, (mu2 - 1) * mu3 * u31 / D1],
            [-mu1 * mu3 * u32 / D1, (mu1 - 1) * mu3 * u32 / D1, N2 / D2],
            [mu1 * mu2 / D1, -(mu1 - 1) * mu2 / D1, -mu1 * (mu2 - 1) / D1],
        ]
    ),
    where={
        N1: mu2 * (mu3 - 1) - (mu2 - 1) * mu3 * u32,
        N2: mu1 * (mu3 - 1) - (mu1 - 1) * mu3 * u31,
        D1: mu1 * N1 - u31 * (mu1 - 1) * mu2 * mu3,
        D2: mu2 * N2 - u32 * mu1 * (mu2 - 1) * mu3,
    },
    claims=["1.3/P", "1.3/PP*"],
    example=EXAMPLE_MU,
)
section.kernel(
    "projection.project",
    "Affine image coordinates of a point.",
    arguments={"y": point, **with_mu["arguments"]},
    describe={"y": "Point (y1, y2, y3) in affine coordinates; dimensionless.", **with_mu["describe"]},
    derived=u_of_y.subs(mu0, 1),
    form=vector((y1 * mu1 + y3 * u31 * mu3) / D, (y2 * mu2 + y3 * u32 * mu3) / D),
    where={D: 1 + y1 * (mu1 - 1) + y2 * (mu2 - 1) + y3 * (mu3 - 1)},
    claims=["1.3.1"],
    example={"y": ("0.5756072", "0.1487681", "0.1279697"), **EXAMPLE_MU},
)

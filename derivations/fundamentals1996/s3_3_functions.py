# %% [markdown]
# # 3.3 Functions
#
# Inserted one after the other, $\mu_3$ would cancel again in $\mu_1$ and $\mu_2$ where it is large.  The forms below
# are quotients with the products that cancel taken out.

# %%
import sympy

from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s3_1_normal_case_transformation import normal_fourth_image
from algebroproj_derivations.fundamentals1996.s3_2_normal_case import AXIS, right_fourth, y_a, ya0, ya1, ya2, ya3, z_n
from algebroproj_derivations.fundamentals1996.s3_3_less_complicated_transformation import (
    mu_left,
    mu_right,
    parameters_of_z,
    r31,
    r32,
    sum_n,
    sum_r,
    z01,
    z02,
    z12,
    z20,
    z_of_12,
)
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, over, vector

section = Section("fundamentals1996", "3.3", "A less complicated transformation: functions")

# %%
ABOUT_AXIS = "Point (yA1, yA2, yA3) of the epipolar axis in affine coordinates; dimensionless."
ABOUT_ZN = "Factor z_N of the normal case correlation; dimensionless."
weighted, difference, common, s0, s1, sz = sympy.symbols("weighted difference common s0 s1 sz")
EXAMPLE_AXIS = {"y_a": ("-1.0", "0.5", "3.5")}

section.kernel(
    "normal_case.mu_left",
    "Projective parameters of the left image of a normal case, with mu1 = mu2.",
    arguments={"y_a": y_a, "u3": normal_fourth_image, "z_n": z_n},
    describe={
        "y_a": ABOUT_AXIS,
        "u3": "Image (uN31, uN32) of the fourth basic point in the left normal case image; dimensionless.",
        "z_n": ABOUT_ZN,
    },
    derived=mu_left,
    form=vector(
        -ya0 * weighted / difference,
        -ya0 * weighted / difference,
        ya0 * (ya1 + z_n * ya2) / (ya3 * difference),
    ),
    where=AXIS | {weighted: sum_n, difference: (ya1 + ya2) * weighted - (ya1 + z_n * ya2)},
    claims=["3.3.8", "3.3.8#mu1", "3.3.8#mu3"],
    example={**EXAMPLE_AXIS, "u3": ("0.270614", "0.062048"), "z_n": "0.1214564"},
)
section.kernel(
    "normal_case.mu_right",
    "Projective parameters of the right image of a normal case.",
    arguments={"y_a": y_a, "y0": center, "u3": right_fourth, "z_n": z_n},
    describe={
        "y_a": ABOUT_AXIS,
        "y0": "Center of projection (y01, y02, y03) of the left image in affine coordinates; dimensionless.",
        "u3": "Image (uppN31, uppN32) of the fourth basic point in the right normal case image; dimensionless.",
        "z_n": ABOUT_ZN,
    },
    derived=mu_right,
    form=vector(
        (
            z_n * s1 * ya2 * ((1 - ya1 - ya2) * y03 + y02 * ya3)
            + s0 * (1 - z_n) * ya3 * ((1 - ya1 - ya3) * y02 + y03 * ya2)
            - sz * ya2 * ya3 * (1 - y01)
        )
        / ((1 - z_n) * s1 * common * ya1),
        ((1 - ya1 - ya2) * y03 - (1 - y01 - y02) * ya3) / ((z_n - 1) * common),
        ((1 - y01 - y03) * ya2 - (1 - ya1 - ya3) * y02) / (s1 * common),
    ),
    where={
        s0: sum_r,
        s1: z_n * r32 - (1 - r31),
        sz: r31 - z_n * (1 - r32),
        common: ya2 * y03 - y02 * ya3,
    },
    claims=["3.3.9", "3.3.9#mu1(yA)", "3.3.9#mu2(yA)", "3.3.9#mu3-second"],
    example={
        **EXAMPLE_AXIS,
        "y0": ("-1.1281689", "-0.2586740", "4.3209568"),
        "u3": ("0.309509", "-0.258189"),
        "z_n": "0.1214564",
    },
)

# %% [markdown]
# The second solution for any multiple of $\mathbf Z$: $z_N$ from entry (1, 2) and the parameters (3.3.5).  With
# $z_N$ inserted, the parameters of the right image lose the divisors $z_N$ and $z_{02}$.

# %%
z_any = Matrix(3, 3, sympy.symbols("z:3:3"))
z10 = z_any[1, 0]
DIVIDED = {element: over(element, z10) for element in (z01, z02, z12, z20)}
second_solution = vector(z_of_12, *parameters_of_z.xreplace({z_n: z_of_12})).xreplace(DIVIDED)
section.kernel(
    "normal_case.from_correlation",
    "Factor z_N and parameters (tau1, tau2) of both images for the normal case, from the matrix of correlation alone.",
    arguments={"Z": z_any},
    describe={"Z": "Singular matrix of correlation referred to the basic points, up to a factor; dimensionless."},
    derived={
        "z_N": second_solution[0],
        "tau_left": vector(second_solution[1], second_solution[2]),
        "tau_right": vector(second_solution[3], second_solution[4]),
    },
    form={
        "z_N": -z02 / (z10 + z12),
        "tau_left": vector(1, -z20 * (z10 + z12) / (z10 * z02)),
        "tau_right": vector(-z01 / z10, (z10 + z12) / z10),
    },
    claims=["3.3.5", "3.3.6#12", "3.3.7#left", "3.3.7#right", "3.3/manifold#second"],
    example={"Z": (("0", "-0.975", "-0.125"), ("1", "-0.025", "0.075"), ("0.125", "-0.083333", "0"))},
)

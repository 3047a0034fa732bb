# %% [markdown]
# # 3.1 Functions
#
# The formulas of section 3.1 as functions.

# %%
import sympy

from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s3_1_normal_case_transformation import (
    FOURTH,
    T,
    mapped_u,
    normal_fourth_image,
    tau1,
    tau2,
    tau_of_fourth_points,
    tau_printed,
    u,
)
from algebroproj_sym import Section
from algebroproj_sym.expressions import vector

section = Section("fundamentals1996", "3.1", "Principles of the transformation to the normal case: functions")

# %%
ABOUT_TAU = "Parameters (tau1, tau2) of the transformation to the normal case for tau0 = 1; dimensionless."
with_tau = {"arguments": {"tau": vector(tau1, tau2)}, "describe": {"tau": ABOUT_TAU}}
EXAMPLE_TAU = {"tau": ("1.0063775", "1.0804274")}
weight = sympy.Symbol("weight")

section.kernel(
    "normal_case.tau",
    "Parameters of the transformation to the normal case from the images of the fourth basic point.",
    arguments={"u3": fourth_image, "u3_normal": normal_fourth_image},
    describe={
        "u3": ABOUT_U3,
        "u3_normal": "Image (uN31, uN32) of the fourth basic point in the normal case plane; dimensionless.",
    },
    derived=tau_of_fourth_points,
    form=vector(*tau_printed),
    where=FOURTH,
    claims=["3.1.2#tau", "3.1.2#fourth-points"],
    example={"u3": ("0.2718578", "0.0577379"), "u3_normal": ("0.2718578", "0.0619863")},
    jacobian=True,
)
section.kernel(
    "normal_case.transform",
    "Matrix T of the transformation to the normal case.",
    **with_tau,
    derived=T,
    claims=["3.1.2"],
    example=EXAMPLE_TAU,
)
section.kernel(
    "normal_case.map_points",
    "Normal case coordinates of image points.",
    arguments={**with_tau["arguments"], "u": u},
    describe={**with_tau["describe"], "u": "Image point (u1, u2) in affine coordinates; dimensionless."},
    derived=mapped_u,
    form=vector(tau1 * u1 / weight, tau2 * u2 / weight),
    where={weight: 1 + (tau1 - 1) * u1 + (tau2 - 1) * u2},
    claims=["3.1.3"],
    example={**EXAMPLE_TAU, "u": ("0.6355182", "0.1372296")},
)

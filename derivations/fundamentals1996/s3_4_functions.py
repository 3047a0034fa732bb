# %% [markdown]
# # 3.4 Functions
#
# The transformation of section 3.4 as a function.

# %%
from algebroproj_derivations.fundamentals1996.s3_1_functions import ABOUT_TAU, EXAMPLE_TAU
from algebroproj_derivations.fundamentals1996.s3_1_normal_case_transformation import tau1, tau2
from algebroproj_derivations.fundamentals1996.s3_2_normal_case import z_n
from algebroproj_derivations.fundamentals1996.s3_4_output_images import A_of_lines
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, vector

section = Section("fundamentals1996", "3.4", "Representation of output images: functions")

section.kernel(
    "normal_case.frame",
    "Matrix A of the affine transformation from the normal case to rectangular coordinates.",
    arguments={"z_n": z_n, "tau": vector(tau1, tau2)},
    describe={"z_n": "Factor z_N of the normal case correlation; dimensionless.", "tau": ABOUT_TAU},
    derived=A_of_lines,
    form=Matrix([[1, 0, 0], [0, 1, z_n], [0, (tau1 - 1) / (tau2 - 1), 1]]),
    claims=["3.4.1#matrix", "3.4/beyond/frame-lines"],
    example={"z_n": "0.1221364", **EXAMPLE_TAU},
)

# %% [markdown]
# # 1.2 Functions
#
# The matrix of section 1.2 as a function.

# %%
from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s1_2_determination_of_projection import M_star
from algebroproj_sym import Section
from algebroproj_sym.expressions import vector

section = Section("fundamentals1996", "1.2", "Determination of the matrix of projection: functions")

section.kernel(
    "projection.camera_matrix",
    "Singular projective matrix M*, without its zero row.",
    arguments={"mu": vector(mu1, mu2, mu3), "u3": vector(u31, u32)},
    derived=M_star[:3, :].subs(mu0, 1),
    claims=["1.2.3", "1.2.3#base"],
    describe={"mu": ABOUT_MU, "u3": ABOUT_U3},
    example={"mu": ("0.625", "0.75", "0.5"), "u3": ("0.25", "0.125")},
)

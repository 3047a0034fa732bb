# %% [markdown]
# # 1.3 Functions
#
# # The left center of projection is the origin of the model, the base its unit of length.

# %%
from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_sym import Section
from algebroproj_sym.expressions import over, vector

section = Section("normalcase1992", "1.3", "Reconstruction of the model: functions")

# %%
section.kernel(
    "metric.reconstruct",
    "Model point from homologous points of the normal case, with the left center as origin and the base as unit.",
    arguments={"x_left": vector(xp, yp), "x_right": vector(xpp, ypp), "c": c},
    describe={
        "x_left": "Left image point (x', y') of the normal case, in the unit of c.",
        "x_right": "Right image point (x'', y'') of the normal case, in the unit of c; y'' = y' is not used.",
        "c": ABOUT_C,
    },
    derived=over(1, xp - xpp) * x_left,
    claims=["1.3.1#left", "1.3.2", "1.3.3"],
    example={"x_left": ("12.5", "-3.25"), "x_right": ("-7.5", "-3.25"), "c": "50"},
    jacobian=True,
)

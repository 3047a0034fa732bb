# %% [markdown]
# # 3.1 Functions
#
# The transformation to the normal case and back as functions.

# %%
from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_sym import Section
from algebroproj_sym.expressions import vector

section = Section("normalcase1992", "3.1", "Transformation: functions")

# %%
image_and_orientation = {"arguments": {"R": R_any, "x": vector(x, y), "c": c}}
EXAMPLE_R = (("0.96", "0", "-0.28"), ("0", "1", "0"), ("0.28", "0", "0.96"))
section.kernel(
    "metric.to_normal",
    "Normal case coordinates of an image point.",
    **image_and_orientation,
    describe={"R": ABOUT_R, "x": ABOUT_X, "c": ABOUT_C},
    derived=image_of(R_any * x_vector),
    claims=["1.1.4", "1.1.5#x", "1.1.5#y"],
    example={"R": EXAMPLE_R, "x": ("-10.62", "1.694"), "c": "51.18"},
    jacobian=True,
)
section.kernel(
    "metric.from_normal",
    "Image point of a point of the normal case.",
    **image_and_orientation,
    describe={"R": ABOUT_R, "x": "Image point (xN, yN) of the normal case, in the unit of c.", "c": ABOUT_C},
    derived=image_of(R_any.T * x_vector),
    claims=["3.1/inverse", "3.1.1"],
    example={"R": EXAMPLE_R, "x": ("-25.3", "1.75"), "c": "51.18"},
    jacobian=True,
)

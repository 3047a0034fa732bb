# %% [markdown]
# # 1.6 Functions
#
# The formulas of section 1.6 as functions.

# %%
import sympy

from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s1_6_optical_projection import (
    M_f,
    M_star,
    f,
    factors,
    g,
    image,
    mapped_u,
    object_point,
    scale,
    u,
    xi,
    xi3,
    xi_prime,
    xip3,
)
from algebroproj_sym import Section
from algebroproj_sym.expressions import vector

section = Section("fundamentals1996", "1.6", "Optical projection: functions")

# %%
with_f = {"arguments": {"f": f}, "describe": {"f": "Focal length; in the unit of the coordinates."}}
EXAMPLE_F = {"f": "0.15"}
magnification = sympy.Symbol("magnification")
x3 = sympy.Symbol("x3")
AXES = "with the optical axis as third axis and the center of the lens as origin; in any unit of length."

section.kernel(
    "optics.lens_matrix",
    "Projective matrix M_f of an ideal lens.",
    **with_f,
    derived=M_f,
    claims=["1.6/M_f"],
    example=EXAMPLE_F,
)
section.kernel(
    "optics.image_point",
    "Image point of an ideal lens.",
    arguments={**with_f["arguments"], "x": xi},
    describe={**with_f["describe"], "x": f"Object point (xi1, xi2, xi3), {AXES}"},
    derived=image,
    form=magnification * xi,
    where={magnification: f / (f + xi3)},
    claims=["1.6.1", "1.6.1#scalar"],
    example={**EXAMPLE_F, "x": ("0.4", "-0.25", "-1.2")},
)
section.kernel(
    "optics.object_point",
    "Object point that an ideal lens maps to a given image point.",
    arguments={**with_f["arguments"], "x": xi_prime},
    describe={**with_f["describe"], "x": f"Image point (xip1, xip2, xip3), {AXES}"},
    derived=object_point,
    form=magnification * xi_prime,
    where={magnification: f / (f - xip3)},
    claims=["1.6.2", "1.6.2#scalar"],
    example={**EXAMPLE_F, "x": ("-0.06", "0.0375", "0.175")},
)
section.kernel(
    "optics.scale",
    "Image scale of an ideal lens.",
    arguments={**with_f["arguments"], "x3": x3},
    describe={**with_f["describe"], "x3": f"Third coordinate xi3 of the object point, {AXES}"},
    derived=scale.subs(xi3, x3),
    form=f / (f + x3),
    claims=["1.6/scale"],
    example={**EXAMPLE_F, "x3": "-1.2"},
)
with_mu = {
    "arguments": {"mu": vector(*factors)},
    "describe": {"mu": "Projective parameters (mu0, mu1, mu2), up to a common factor; dimensionless."},
}
EXAMPLE_MU = {"mu": ("1", "0.75", "1.25")}
section.kernel(
    "optics.plane_homography",
    "Matrix M* of the optical projection from plane to plane, in affine coordinates.",
    **with_mu,
    derived=M_star,
    claims=["1.6/M*", "1.6.5"],
    example=EXAMPLE_MU,
)
weighted = sympy.Symbol("weighted")
section.kernel(
    "optics.map_plane_points",
    "Affine coordinates of the optical projection of points of a plane.",
    arguments={**with_mu["arguments"], "u": u},
    describe={**with_mu["describe"], "u": "Point (u1, u2) in affine coordinates of the plane; dimensionless."},
    derived=mapped_u,
    form=vector(mu1 * u1 / weighted, mu2 * u2 / weighted),
    where={weighted: mu0 * (1 - u1 - u2) + mu1 * u1 + mu2 * u2},
    claims=["1.6/M*", "1.6.5", "1.6.5#lens"],
    example={**EXAMPLE_MU, "u": ("0.5", "0.25")},
)
section.kernel(
    "optics.vanishing_line",
    "Vanishing line g of the plane E, in affine coordinates.",
    **with_mu,
    derived=g,
    claims=["1.6/g", "1.6/g#V"],
    example=EXAMPLE_MU,
)

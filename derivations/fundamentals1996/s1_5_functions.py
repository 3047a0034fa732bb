# %% [markdown]
# # 1.5 Functions
#
# The inverse of the core is a core with the factors $1/\mu_j$, therefore
# $a'_0 = a_0/\mu_0$ and $a'_j = (a_0 + a_j)/\mu_j - a_0/\mu_0$.

# %%
import sympy

from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s1_5_space_to_space import (
    M_star,
    a,
    factors,
    fifth_image,
    fifth_point,
    image,
    mu4,
    mu_of_fifth,
    point,
    u0,
    u40,
    u41,
    u42,
    u43,
    y0,
    y40,
    y41,
    y42,
    y43,
)
from algebroproj_sym import Section
from algebroproj_sym.expressions import inverse, vector

section = Section("fundamentals1996", "1.5", "Projection from space to space: functions")

# %%
with_mu = {
    "arguments": {"mu": vector(*factors)},
    "describe": {"mu": "Projective parameters (mu0, mu1, mu2, mu3), up to a common factor; dimensionless."},
}
EXAMPLE_MU = {"mu": ("1", "0.625", "0.75", "1.25")}

section.kernel(
    "space.homography",
    "Matrix M* of the regular projective transformation of space.",
    **with_mu,
    derived=M_star,
    claims=["1.5.2", "1.5/core"],
    example=EXAMPLE_MU,
)
section.kernel(
    "space.mu_from_fifth_point",
    "Projective parameters of the regular transformation of space from a fifth point, with mu4 = 1.",
    arguments={"y4": fifth_point, "u4": fifth_image},
    describe={
        "y4": "Fifth point (y41, y42, y43) in affine coordinates; dimensionless.",
        "u4": "Its image (u41, u42, u43) in affine coordinates; dimensionless.",
    },
    derived=mu_of_fifth.subs(mu4, 1),
    form=vector(u0 / y0, u41 / y41, u42 / y42, u43 / y43),
    where={y0: y40, u0: u40},
    claims=["1.5.3", "1.5.4#mu0", "1.5.4#mu1", "1.5.4#mu2", "1.5.4#mu3"],
    example={"y4": ("0.5", "0.25", "0.75"), "u4": ("0.375", "0.25", "0.5")},
)
weighted = sympy.Symbol("weighted")
section.kernel(
    "space.map_points",
    "Image points of the regular projective transformation of space.",
    arguments={**with_mu["arguments"], "y": point},
    describe={**with_mu["describe"], "y": "Point (y1, y2, y3) in affine coordinates; dimensionless."},
    derived=image,
    form=vector(mu1 * y1 / weighted, mu2 * y2 / weighted, mu3 * y3 / weighted),
    where={weighted: mu0 * (1 - y1 - y2 - y3) + mu1 * y1 + mu2 * y2 + mu3 * y3},
    claims=["1.5.2", "1.5.5"],
    example={**EXAMPLE_MU, "y": ("0.5", "0.25", "0.75")},
)
first = sympy.Symbol("first")
section.kernel(
    "space.map_plane",
    "Coefficients of the image of a plane under the regular projective transformation of space.",
    arguments={**with_mu["arguments"], "a": a},
    describe={
        **with_mu["describe"],
        "a": "Plane a0 + a1 y1 + a2 y2 + a3 y3 = 0 as (a0, a1, a2, a3), up to a common factor; dimensionless.",
    },
    derived=inverse(M_star).T * a,
    form=vector(first, *((a[0] + a[j]) / factors[j] - first for j in (1, 2, 3))),
    where={first: a[0] / mu0},
    claims=["1.5.2", "1.5.7"],
    example={**EXAMPLE_MU, "a": ("-1", "0.5", "0.75", "2")},
)

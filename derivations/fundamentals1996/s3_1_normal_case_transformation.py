# %% [markdown]
# # 3.1 Principles of the transformation to the normal case
#
# A second image plane $P_N$ cuts the bundle of rays that belongs to an image $P$: the center stays, and so do the
# basic points $G_0, G_1, G_2$ as unit points of either plane.  Only the image of $G_3$ changes, from $\mathbf u_3$ to
# $\mathbf u_{N3}$.

# %%
import sympy

from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s1_3_properties_of_projection import (
    P,
    P_of_y0,
    P_star,
    P_star_of_y0,
    factor,
    mu_of_y0,
    point,
)
from algebroproj_derivations.fundamentals1996.s1_6_optical_projection import M_star as optical_M_star
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    columns,
    determinant,
    homogeneous,
    inverse,
    linear_system,
    over,
    solve,
    vector,
)

section = Section("fundamentals1996", "3.1", "Principles of the transformation to the normal case")

# %%
un30, un31, un32 = sympy.symbols("uN30 uN31 uN32")
tau1, tau2 = sympy.symbols("tau1 tau2")
normal_fourth_image = vector(un31, un32)
IN_NORMAL_CASE = {u31: un31, u32: un32}
FOURTH = {u30: BARYCENTRIC[u30], un30: 1 - un31 - un32}

PN_star_of_y0 = P_star_of_y0.xreplace(IN_NORMAL_CASE)
normal_mu_of_y0 = mu_of_y0.xreplace(IN_NORMAL_CASE)

# %% [markdown]
# ## Two bundles, one point
#
# A point $\mathbf y$ seen in an image gives $\mu\, \mathbf u = \mathbf P^* (\mathbf y - \mathbf y_0)$.  Reconstruction
# leads back to the same point from either image.

# %%
bundle = (*center, *mu, *fourth_image)
other_bundle = sympy.symbols("ypp01 ypp02 ypp03 mupp1 mupp2 mupp3 upp31 upp32")
RIGHT = dict(zip(bundle, other_bundle, strict=True))


def seen(projection: Matrix) -> tuple[sympy.Expr, Matrix]:
    """Return the factor and the quasihomogeneous image of the point."""
    ray = projection * (point - center)
    return ray[0], vector(1, over(ray[1], ray[0]), over(ray[2], ray[0]))


mu_seen, u_seen = seen(P_star)
reconstructed = center + mu_seen * P * u_seen
section.identity(
    "3.1/y",
    "the point from the left and from the right image",
    printed=columns(reconstructed, reconstructed.xreplace(RIGHT)),
    derived=columns(point, point),
    note="The images u', u'' and the factors are those of the projection (1.1.5) of the point.",
)

# %% [markdown]
# ## The matrix T
#
# The new image of the point is $\mu_N \mathbf u_N = \mathbf P_N^* (\mathbf y - \mathbf y_0)$.

# %%
mu_normal = sympy.symbols("muN1 muN2 muN3")
PN_star = P_star.xreplace(IN_NORMAL_CASE | dict(zip(mu, mu_normal, strict=True)))
normal_factor, normal_image = seen(PN_star)
section.identity(
    "3.1.1#muN",
    "normal case coordinates through the reconstructed ray",
    printed=PN_star * (reconstructed - center),
    derived=normal_factor * normal_image,
)
tau_symbol = sympy.Symbol("tau")
section.identity(
    "3.1.1",
    "normal case coordinates from image coordinates",
    printed=tau_symbol * normal_image,
    where={tau_symbol: over(normal_factor, mu_seen)},
    derived=PN_star * P * u_seen,
    note="With tau = mu_N/mu and T = P_N* P.",
)

# %% [markdown]
# The structure can be foreseen.  $\mathbf P$ carries $\mathbf e'_j$ to the ray $(\mathbf e_j - \mathbf y_0)/\mu_j$,
# and $\mathbf P_N^*$ carries it on to $\tau_j \mathbf e'_j$ with $\tau_j = \mu_{Nj}/\mu_j$ and $\tau_0 = 1$.

# %%
T = columns(image_e0, tau1 * image_e1 - image_e0, tau2 * image_e2 - image_e0)
T_of_y0 = PN_star_of_y0 * P_of_y0
ratios = vector(1, *(over(normal_mu_of_y0[j], mu_of_y0[j]) for j in range(2)))
tau_printed = [u30 * n / (un30 * u) for u, n in ((u31, un31), (u32, un32))]
T_printed = Matrix([[1, tau1 - 1, tau2 - 1], [0, tau1, 0], [0, 0, tau2]])

section.identity(
    "3.1.2",
    "matrix of the transformation to the normal case",
    printed=T_printed,
    where={tau1: ratios[1], tau2: ratios[2]},
    derived=T_of_y0,
    note="The product P_N* P of (1.3.6) and (1.3.7) itself, without a factor.",
)
section.identity(
    "3.1.2#tau",
    "parameters of the transformation",
    printed=vector(over(u30 * un30, un30 * u30), *tau_printed),
    where=FOURTH,
    derived=ratios,
    note="i = 0 gives tau_0 = 1.",
)
section.identity(
    "3.1.2#product",
    "the product, in terms of the fourth points",
    printed=T_printed.subs({tau1: tau_printed[0], tau2: tau_printed[1]}),
    where=FOURTH,
    derived=T_of_y0,
)
section.identity(
    "3.1/regular#det",
    "determinant of the transformation",
    printed=tau1 * tau2,
    derived=determinant(T),
)

# %% [markdown]
# ## Only the fourth points count
#
# No center is left in $\mathbf T$.  It can be had without one: a plane projectivity that keeps the three unit points
# and carries $\mathbf u_3$ to $\mathbf u_{N3}$ satisfies $\mathbf T \mathbf u_3 = \tau_3 \mathbf u_{N3}$, three linear
# equations for $\tau_1, \tau_2, \tau_3$.

# %%
other_center = dict(zip(center, sympy.symbols("x01 x02 x03"), strict=True))
section.identity(
    "3.1/exclusively",
    "the transformation depends on the fourth points alone",
    printed=T_of_y0.xreplace(other_center),
    derived=T_of_y0,
    note="The printed side has another center of projection.",
)
tau3 = sympy.Symbol("tau3")
fourth_points = T * homogeneous(fourth_image) - tau3 * homogeneous(normal_fourth_image)
tau_of_fourth_points = vector(*solve(*linear_system(list(fourth_points), [tau1, tau2, tau3]))[:2, 0])
at_fourth_points = dict(zip((tau1, tau2), tau_of_fourth_points, strict=True))
section.identity(
    "3.1.2#fourth-points",
    "parameters from the correspondence of the fourth points",
    printed=vector(*tau_printed),
    where=FOURTH,
    derived=tau_of_fourth_points,
    note="u_N3 corresponds to u3 by T itself.",
)

section.vanishing(
    "3.1/regular",
    "the transformation is regular",
    printed=(u30, un31, un32),
    where=FOURTH,
    derived=determinant(T.subs(at_fourth_points)),
    note="Regular but where one of these vanishes: G3 on a side of the triangle of the basic points, in P or in P_N.  "
    "The divisors u31, u32 and uN30 are the remaining sides.",
)

# %% [markdown]
# ## Coordinates

# %%
u = vector(u1, u2)
mapped = T * homogeneous(u)
mapped_u = vector(over(mapped[1], mapped[0]), over(mapped[2], mapped[0]))
section.identity(
    "3.1.3",
    "inhomogeneous coordinates of the transformed image",
    printed=vector(*(t * x / (1 + (tau1 - 1) * u1 + (tau2 - 1) * u2) for t, x in ((tau1, u1), (tau2, u2)))),
    derived=mapped_u,
)
section.identity(
    "3.1.3#u3",
    "the fourth point of the image becomes that of the normal case",
    printed=normal_fourth_image,
    derived=mapped_u.subs({**at_fourth_points, u1: u31, u2: u32}),
)
section.identity(
    "3.1/1.6.5",
    "correspondence with the optical projection from plane to plane",
    printed=optical_M_star,
    where={mu0: sympy.Integer(1), mu1: tau1, mu2: tau2},
    derived=T,
)

# %% [markdown]
# The explanation by the common center: whatever the two planes, their matrices of projection are
# $\mathbf P^* = (\mathbf B \mathbf U)^{-1}$, and the rays do not notice a common factor.

# %%
section.identity(
    "3.1/projectivity",
    "two planes that cut one bundle are related by a regular projectivity",
    printed=E3,
    derived=T_of_y0 * (P_star_of_y0 * inverse(PN_star_of_y0)),
    note="The inverse of P_N* P is P* P_N: the relation of the planes with their roles exchanged.",
)
section.up_to_scale(
    "3.1/beyond/scale",
    "a common factor of the parameters of either plane does not change the projectivity",
    printed=T_of_y0,
    derived=PN_star_of_y0 * inverse(factor * P_star_of_y0),
    note="Not in the paper: the plane P may be displaced in parallel, with k for the factor.",
)

# %% [markdown]
# ## Code

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

# %% [markdown]
# # 3.1 Principles of the transformation to the normal case
#
# What happens to an image if its plane is exchanged for another one?  A second image plane $P_N$ cuts the bundle of
# rays that belongs to an image $P$.  The center stays, and so do the basic points $G_0, G_1, G_2$ as unit points of
# either plane.  Only the image of $G_3$ changes, from $\mathbf u_3$ to $\mathbf u_{N3}$.

# %%
import sympy
from sympy import BlockMatrix, Eq, MatrixSymbol

from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s1_3_properties_of_projection import (
    P_of_y0,
    P_star_of_y0,
    factor,
    mu_of_y0,
)
from algebroproj_derivations.fundamentals1996.s1_6_optical_projection import M_star as optical_M_star
from algebroproj_derivations.inserting import given
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
# **Definition.**  A point $\mathbf y$ seen in an image gives $\mu\, \mathbf u = \mathbf P^* (\mathbf y - \mathbf y_0)$,
# (1.1.5).  Reconstruction leads back to the same point from either image.

# %%
mup, mupp, mu_seen, mu_normal, tau_symbol = sympy.symbols("mup mupp mu muN tau")
names = ("y", "y0", "yp0", "ypp0", "u", "up", "upp", "uN")
y, y0, yp0, ypp0, u, up, upp, u_normal = (MatrixSymbol(name, 3, 1) for name in names)
P_bold, Pp, Ppp, PN_bold = (MatrixSymbol(name, 3, 3) for name in ("P", "Pp", "Ppp", "PsN"))

section.identity(
    "3.1/y",
    "the point from the left and from the right image",
    constraints=[Eq(up, Pp.I * (y - yp0) / mup), Eq(upp, Ppp.I * (y - ypp0) / mupp)],
    derived=BlockMatrix([[y, y]]),
)

# %% [markdown]
# ## The matrix T
#
# **Definition.**  The new image of the point is $\mu_N \mathbf u_N = \mathbf P_N^* (\mathbf y - \mathbf y_0)$.  The
# ray comes from the old image.  So $\tau \mathbf u_N = \mathbf T \mathbf u$ with $\tau = \mu_N / \mu$ and
# $\mathbf T = \mathbf P_N^* \mathbf P$.

# %%
images = [Eq(u, P_bold.I * (y - y0) / mu_seen), Eq(u_normal, PN_bold * (y - y0) / mu_normal)]
section.identity(
    "3.1.1#muN",
    "normal case coordinates through the reconstructed ray",
    constraints=images,
    derived=BlockMatrix([[mu_normal * u_normal, mu_normal * u_normal]]),
)
section.identity(
    "3.1.1",
    "normal case coordinates from image coordinates",
    constraints=[*images, Eq(tau_symbol, mu_normal / mu_seen)],
    derived=PN_bold * P_bold * u,
)

# %% [markdown]
# **What does $\mathbf T$ look like?**  $\mathbf P$ carries $\mathbf e'_j$ to the ray $(\mathbf e_j - \mathbf
# y_0)/\mu_j$, and $\mathbf P_N^*$ carries it on to $\tau_j \mathbf e'_j$ with $\tau_j = \mu_{Nj}/\mu_j$ and $\tau_0 =
# 1$.

# %%
T = columns(image_e0, tau1 * image_e1 - image_e0, tau2 * image_e2 - image_e0)
T

# %% [markdown]
# **Print.**  This is the product of (1.3.6) and (1.3.7) itself, without a factor, and its parameters are quotients of
# the fourth points.

# %%
T_of_y0 = PN_star_of_y0 * P_of_y0
ratios = vector(1, *(over(normal_mu_of_y0[j], mu_of_y0[j]) for j in range(2)))
tau_printed = [u30 * n / (un30 * u) for u, n in ((u31, un31), (u32, un32))]
T_printed = Matrix([[1, tau1 - 1, tau2 - 1], [0, tau1, 0], [0, 0, tau2]])

section.identity(
    "3.1.2",
    "matrix of the transformation to the normal case",
    where={tau1: ratios[1], tau2: ratios[2]},
    derived=T_of_y0,
)
section.identity("3.1.2#tau", "parameters of the transformation", where=FOURTH, derived=ratios)

# %%
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
# No center is left in $\mathbf T$: another one gives the same.  It can be had without any.  A plane projectivity that
# keeps the three unit points and carries $\mathbf u_3$ to $\mathbf u_{N3}$ satisfies $\mathbf T \mathbf u_3 = \tau_3
# \mathbf u_{N3}$, three linear equations for $\tau_1, \tau_2, \tau_3$.

# %%
other_center = given(center, sympy.symbols("x01 x02 x03"))
section.identity(
    "3.1/exclusively",
    "the transformation depends on the fourth points alone",
    printed=T_of_y0.xreplace(other_center),
    derived=T_of_y0,
)
tau3 = sympy.Symbol("tau3")
fourth_points = T * homogeneous(fourth_image) - tau3 * homogeneous(normal_fourth_image)
tau_of_fourth_points = vector(*solve(*linear_system(list(fourth_points), [tau1, tau2, tau3]))[:2, 0])
at_fourth_points = given((tau1, tau2), tau_of_fourth_points)
section.identity(
    "3.1.2#fourth-points",
    "parameters from the correspondence of the fourth points",
    where=FOURTH,
    derived=tau_of_fourth_points,
)

# %% [markdown]
# **When is it regular?**  Unless $G_3$ is on a side of the triangle of the basic points, in $P$ or in $P_N$.  The
# divisors $u_{31}$, $u_{32}$ and $u_{N30}$ are the remaining sides.

# %%
section.vanishing(
    "3.1/regular",
    "the transformation is regular",
    printed=(u30, un31, un32),
    where=FOURTH,
    derived=determinant(T.subs(at_fourth_points)),
)

# %% [markdown]
# ## Coordinates
#
# Where does a point of the image go?

# %%
u = vector(u1, u2)
mapped = T * homogeneous(u)
mapped_u = vector(over(mapped[1], mapped[0]), over(mapped[2], mapped[0]))
section.identity("3.1.3", "inhomogeneous coordinates of the transformed image", derived=mapped_u)
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
# **Meaning.**  Two planes that cut one bundle are related by a regular projectivity.  With their roles exchanged it is
# $\mathbf P^* \mathbf P_N$, the inverse.  A common factor of the parameters of a plane displaces it in parallel, and
# changes nothing.

# %%
section.identity(
    "3.1/projectivity",
    "two planes that cut one bundle are related by a regular projectivity",
    printed=E3,
    derived=T_of_y0 * (P_star_of_y0 * inverse(PN_star_of_y0)),
)
section.up_to_scale(
    "3.1/beyond/scale",
    "a common factor of the parameters of either plane does not change the projectivity",
    printed=T_of_y0,
    derived=PN_star_of_y0 * inverse(factor * P_star_of_y0),
)

# %% [markdown]
# **An example.**  For $\tau_1 = 3/2$ and $\tau_2 = 5/4$ the image point $(1/4, 1/2)$ goes to

# %%
TAUS = {tau1: sympy.Rational(3, 2), tau2: sympy.Rational(5, 4)}
corners = [vector(-1, -1, 2), vector(1, -1, 2), vector(0, 1, 2)]
normal_corners = [corners[0], corners[1] / TAUS[tau1], corners[2] / TAUS[tau2]]
before = vector(sympy.Rational(1, 4), sympy.Rational(1, 2))
after = mapped_u.xreplace(TAUS | given(u, before)).doit()
after


# %%
def in_plane(basic: list[Matrix], image: Matrix) -> Matrix:
    return columns(basic[0], basic[1] - basic[0], basic[2] - basic[0]) * homogeneous(image)


SpaceDrawing(
    "Two image planes cut the bundle of rays of a center C.  The basic points and a point p have their images GN and "
    "pN on the same rays.",
    {"C": vector(0, 0, 0), "p": in_plane(corners, before), "pN": in_plane(normal_corners, after)}
    | {f"G'{j}": corner for j, corner in enumerate(corners)}
    | {f"GN{j}": normal_corners[j] for j in (1, 2)},
    segments=[("C", "p"), *(("C", f"G'{j}") for j in range(3))],
    triangles=[("G'0", "G'1", "G'2"), ("G'0", "GN1", "GN2")],
)

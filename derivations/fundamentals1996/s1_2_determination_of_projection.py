# %% [markdown]
# # 1.2 Determination of P*
#
# How much must be known to determine a projection?  The basic points $G_0, \dots, G_3$ of the object are projected
# from the center $\mathbf y_0$.  Three images fix the affine system of the image plane.  What remains of $\mathbf
# P^*$ are the four factors $\mu_j$ and the image $\mathbf u_3$ of $G_3$.

# %%
import sympy

from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.inserting import given
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, columns, determinant, homogeneous, inverse, solve, vector

section = Section("fundamentals1996", "1.2", "Determination of the matrix of projection")

# %% [markdown]
# ## The unit points
#
# **Definition.**  An image point $\mathbf p = \mathbf b_0 + u_1 (\mathbf b_1 - \mathbf b_0) + u_2 (\mathbf b_2 -
# \mathbf b_0)$ is $G'_j$ itself where $\mathbf p = \mathbf b_j$.  So the quasihomogeneous coordinates of the basic
# points solve $\mathbf B \mathbf U \mathbf u = \mathbf b_j$.  The print has a 1 too many in the first of them.

# %%
b0, b1, b2 = (vector(*sympy.symbols(f"b{j}0 b{j}1 b{j}2")) for j in range(3))
B = columns(b0, b1, b2)


def image_coordinates(direction: Matrix) -> Matrix:
    return solve(B * U, direction)


section.definition("1.2/e", "unit points of space")
section.identity(
    "1.2/e'0",
    "image of the origin",
    derived=image_coordinates(b0),
    expect="misprint",
    corrected=vector(1, 0, 0),
    note="Case j = 0 of (1.2.1) prints (1, 0, 0).  A slip of the scan cannot be told from one of the print.",
)

# %% [markdown]
# The others are right.

# %%
section.identity("1.2/e'1", "image of the first unit point", derived=image_coordinates(b1))
section.identity("1.2/e'2", "image of the second unit point", derived=image_coordinates(b2))
section.definition("1.2/e'3", "image of the third unit point, a general point")

# %% [markdown]
# Four points can be unit points of space, unless they are coplanar.

# %%
any_points = columns(*(homogeneous(vector(*sympy.symbols(f"g{j}1 g{j}2 g{j}3"))) for j in range(4)))
section.rank(
    "1.2/four-points",
    "in general four points establish an affine coordinate system of space",
    derived=any_points,
)

# %% [markdown]
# ## The equations of projection
#
# **Definition.**  The rays are $\mathbf e_j - \mathbf y_0 = \mu_j \mathbf p_j$, and $\mathbf p_j = \mathbf b_j$ for
# $j = 0, 1, 2$.  Center and $\mu_0, \mu_1, \mu_2$ therefore fix the base, the base fixes $\mathbf P^* = (\mathbf B
# \mathbf U)^{-1}$, and $\mathbf P^*$ fixes $\mu_3$ and $\mathbf u_3$.  Everything below is checked against this
# construction.

# %%
rays = [e - center for e in (e0, e1, e2, e3)]
base = columns(rays[0] / mu0, rays[1] / mu1, rays[2] / mu2)
P_star_of_rays = inverse(base * U)
fourth = P_star_of_rays * rays[3]
seen = {mu3: fourth[0], u31: fourth[1] / fourth[0], u32: fourth[2] / fourth[0]}

# %% [markdown]
# The three images are collinear where the three rays are coplanar.  So the center must not be in the plane of $G_0,
# G_1, G_2$, a restriction that the paper does not state; $y_{03}$ is a divisor of (1.3.8).

# %%
section.vanishing(
    "1.2/image-system",
    "the images of G0, G1, G2 define an affine system, but where the center is in the plane of these points",
    printed=(y03,),
    derived=determinant(columns(*rays[:3])),
)
section.identity(
    "1.2.1",
    "equations of projection of the basic points",
    where=seen,
    derived=P_star_of_rays * columns(*rays),
)

# %% [markdown]
# The four cases, with $p^i_j$ for the elements of $\mathbf P^*$: row $i$, column $j$.

# %%
p = Matrix(3, 3, sympy.symbols("p:3:3"))
elements = given(p, P_star_of_rays)
section.identity("1.2/j=0", "case of the origin", derived=P_star_of_rays * center)
section.identity(
    "1.2/j=1",
    "case of the first unit point",
    printed=columns(vector(p[0, 0] + mu0, p[1, 0], p[2, 0]), vector(mu1 - mu0, mu1, 0)),
    where=elements,
    derived=columns(P_star_of_rays * rays[1], P_star_of_rays * e1),
)
section.identity(
    "1.2/j=2#vector", "case of the second unit point, the vector", where=elements, derived=P_star_of_rays * rays[2]
)

# %% [markdown]
# Of the second unit point the print interchanges the last two elements.

# %%
section.identity(
    "1.2/j=2",
    "case of the second unit point, the elements",
    derived=P_star_of_rays * e2,
    expect="misprint",
    corrected=vector(mu2 - mu0, 0, mu2),
    note="The left side (1, 0, 1) of this case and (1.2.2) have them right.",
)
section.identity(
    "1.2/j=3",
    "case of the third unit point",
    printed=columns(vector(p[0, 2] + mu0, p[1, 2], p[2, 2]), vector(mu3 - mu0, mu3 * u31, mu3 * u32)),
    where=elements | seen,
    derived=columns(P_star_of_rays * rays[3], P_star_of_rays * e3),
)

# %% [markdown]
# ## The matrices
#
# **Definition.**  By linearity $\mathbf P^* \mathbf e_j = \mathbf P^* (\mathbf e_j - \mathbf y_0) - \mathbf P^*
# (\mathbf e_0 - \mathbf y_0) = \mu_j \mathbf e'_j - \mu_0 \mathbf e'_0$.  These are the columns of $\mathbf P^*$ as
# functions of $\mu_j$ and $\mathbf u_3$.

# %%
image_units = (image_e1, image_e2, image_e3)
P_star = columns(*(m * e - mu0 * image_e0 for m, e in zip((mu1, mu2, mu3), image_units, strict=True)))
M_star = columns(mu0 * image_e0, P_star).col_join(Matrix.zeros(1, 4))
M_star

# %% [markdown]
# **Print.**  Both matrices, in these terms and from center and base.

# %%

section.identity("1.2.2", "matrix of projection", derived=P_star)
section.identity("1.2.2#base", "matrix of projection, from center and base", where=seen, derived=P_star_of_rays)

# %%
section.identity("1.2.3", "singular projective matrix", derived=M_star)
section.identity(
    "1.2.3#base",
    "singular projective matrix, from center and base by (1.1.6)",
    where=seen,
    derived=columns(-P_star_of_rays * center, P_star_of_rays).col_join(Matrix.zeros(1, 4)),
)

# %% [markdown]
# **An example.**  From the center $(1/2, 1/2, 3)$, with $\mu_0 = 2$, $\mu_1 = 3$ and $\mu_2 = 5/2$, $G_3$ has this
# $\mu_3$ and these coordinates $\mathbf u_3$:

# %%
EYE = vector(sympy.Rational(1, 2), sympy.Rational(1, 2), 3)
EXAMPLE = given((mu0, mu1, mu2, *center), (*map(sympy.Rational, ("2", "3", "5/2")), *EYE))
example_fourth = vector(*(seen[symbol].xreplace(EXAMPLE).doit() for symbol in (mu3, u31, u32)))
example_fourth

# %%
SpaceDrawing(
    "The basic points G, the center C, and the images G' of the basic points where the rays pierce the image plane.",
    {"C": EYE, **{f"G{j}": e for j, e in enumerate((e0, e1, e2, e3))}}
    | {
        f"G'{j}": EYE + rays[j].xreplace(EXAMPLE) / factor
        for j, factor in enumerate((*(EXAMPLE[m] for m in (mu0, mu1, mu2)), example_fourth[0]))
    },
    segments=[("C", f"G{j}") for j in range(4)],
    triangles=[("G'0", "G'1", "G'2"), ("G0", "G1", "G2")],
)

# %% [markdown]
# **Meaning.**  This is the *core* of every singular projective transformation: a general projective matrix $\mathbf
# S$ (3 by 4) of full rank differs from it by the affine systems alone.  With the images $\mathbf s_j = \mathbf S
# \mathbf x_j$ of any four object points $\mathbf x_j$, both coordinate systems referred to the points, the core
# remains.

# %%
images = Matrix(3, 4, sympy.symbols("s:3:4"))
depths = [images[0, j] for j in range(4)]
plane_system = columns(
    images.col(0) / depths[0], *(images.col(j) / depths[j] - images.col(0) / depths[0] for j in (1, 2))
)
core = inverse(plane_system) * columns(images.col(0), *(images.col(j) - images.col(0) for j in (1, 2, 3)))
fourth_point = inverse(plane_system) * images.col(3)
parameters = {mu0: depths[0], mu1: depths[1], mu2: depths[2], mu3: depths[3]}
seen_fourth = {u31: fourth_point[1] / depths[3], u32: fourth_point[2] / depths[3]}
section.identity(
    "1.2/core",
    "every projection has this form, referred to its basic points",
    printed=M_star[:3, :],
    where=parameters | seen_fourth,
    derived=core,
)

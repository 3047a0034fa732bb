# %% [markdown]
# # 1 Calibrated images
#
# The paper of 1992 describes calibrated images by rotations, that of 1996 projective ones by their basic points.  Do
# they agree where both apply?  They do: the calibrated image is an affine change of coordinates away.
#
# 1992: image vector $\mathbf x = (x, y, -c)^T$, projector $\mathbf p = \mathbf R \mathbf x$, base $\mathbf b$ from the
# left center to the right one.  1996: $\mathbf p = \mathbf P \mathbf u$ with $\mathbf u = (1, u_1, u_2)^T$.

# %%
import sympy

from algebroproj_derivations.figures import ImageDrawing
from algebroproj_derivations.fundamentals1996.notation import u1, u2
from algebroproj_derivations.fundamentals1996.s1_4_orthonormalized_systems import (
    frame,
    point_at,
    rotation,
)
from algebroproj_derivations.fundamentals1996.s2_1_spatial_intersection import C as C_1996
from algebroproj_derivations.fundamentals1996.s2_1_spatial_intersection import P_left, P_right, d
from algebroproj_derivations.fundamentals1996.s2_2_correlation import (
    C_normal,
    abscissas_left,
    abscissas_right,
    base_length,
    distance,
    ordinates,
)
from algebroproj_derivations.fundamentals1996.s3_1_normal_case_transformation import T, tau1, tau2
from algebroproj_derivations.inserting import given
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, columns, cross, dot, homogeneous, over, rows, solve, vector

section = Section("bridges", "1", "Calibrated images")

# %% [markdown]
# ## What is an image vector in affine coordinates?
#
# **Definition.**  $\mathbf K$ takes rectangular coordinates with a leading 1 to the image vector of 1992, and the
# affine frame $\mathbf A_v$ takes affine coordinates to rectangular ones.  Rows of $g$ are the images of the basic
# points.

# %%
c = sympy.Symbol("c")
K = Matrix([[0, 1, 0], [0, 0, 1], [-c, 0, 0]])


def image_vector(point: Matrix) -> Matrix:
    return vector(*point, -c)


u = vector(u1, u2)
g_left, g_right = (Matrix(3, 2, sympy.symbols(f"{name}:3:2")) for name in ("gp", "gpp"))
A_left, A_right = frame(g_left), frame(g_right)
R_left, R_right = (Matrix(3, 3, sympy.symbols(f"{name}:3:3")) for name in ("rp", "rpp"))

section.identity(
    "1/image-vector",
    "the image vector from affine coordinates",
    printed=K * A_left * homogeneous(u),
    derived=image_vector(point_at(u, g_left)),
)


# %% [markdown]
# **Result.**  $\mathbf P$ of 1996 is $\mathbf R$ of 1992 after the affine change $\mathbf K \mathbf A_v$.


# %%
def reconstruction(orientation: Matrix, points: Matrix) -> Matrix:
    """Return the matrix of reconstruction of 1996 of a calibrated image: its base vectors are projectors."""
    b0, b1, b2 = (orientation * image_vector(points.row(n).T) for n in range(3))
    return columns(b0, b1 - b0, b2 - b0)


section.identity(
    "1/reconstruction",
    "matrix of reconstruction of a calibrated image",
    printed=R_left * K * A_left,
    derived=reconstruction(R_left, g_left),
)

# %% [markdown]
# ## Have both papers one matrix of correlation?
#
# **Definition.**  Both papers form $(\mathbf p' \times \mathbf b) \cdot \mathbf p''$.  As a bilinear form in $\mathbf
# x'$ and $\mathbf x''$ it has the matrix $\mathbf C = \mathbf R'^T \mathbf B \mathbf R''$ of 1992, as one in $\mathbf
# u'$ and $\mathbf u''$ the matrix of 1996.


# %%
def correlation(first: Matrix, second: Matrix, base: Matrix) -> Matrix:
    return Matrix(3, 3, lambda i, j: dot(cross(first.col(i), base), second.col(j)))


def for_images(first: Matrix, second: Matrix) -> dict[sympy.Symbol, sympy.Expr]:
    return given((*P_left, *P_right), (*first, *second))


B = columns(*(cross(d, Matrix.eye(3).col(j)) for j in range(3)))
C_1992 = correlation(R_left, R_right, d)
of_calibrated = for_images(reconstruction(R_left, g_left), reconstruction(R_right, g_right))


# %% [markdown]
# **Result.**  They are the same but for the affine change: without a factor, and for any matrices $\mathbf R$.

# %%
section.identity(
    "1/correlation-1992",
    "matrix of correlation of calibrated images",
    printed=R_left.T * B * R_right,
    derived=C_1992,
)
section.identity(
    "1/normal-case-correlation",
    "the matrices of correlation of 1992 and of 1996",
    printed=(K * A_left).T * C_1992 * (K * A_right),
    derived=C_1996.xreplace(of_calibrated),
)

# %% [markdown]
# **An example.**  The left image in both coordinates, with the lines on which it shows three points of the right image.
# Each line is computed twice: by $\mathbf C$ of 1992, and by $\mathbf C$ of 1996.

# %%
BASIC = rows(vector(-1, -1), vector(2, 0), vector(0, 2))
TIPPED = Matrix([[24, 0, 7], [0, 25, 0], [-7, 0, 24]]) / 25
EXAMPLE = given((*g_left, *g_right, *R_left, *R_right, *d, c), (*BASIC, *BASIC, *Matrix.eye(3), *TIPPED, 1, 0, 0, 2))
K_example, C_1992_example, C_1996_example = (
    matrix.xreplace(EXAMPLE).doit() for matrix in (K, C_1992, C_1996.xreplace(of_calibrated))
)
POINTS = {"G0": vector(0, 0), "G1": vector(1, 0), "G2": vector(0, 1)}
SEEN = [vector(0, 0), vector(1, 0), vector(0, 1)]
ImageDrawing(
    "The left image in the rectangular coordinates of 1992 and in the affine ones of 1996, with the same lines.",
    {
        "1992": (
            {name: point_at(point, BASIC) for name, point in POINTS.items()},
            [K_example.T * C_1992_example * K_example * frame(BASIC) * homogeneous(point) for point in SEEN],
        ),
        "1996": (POINTS, [C_1996_example * homogeneous(point) for point in SEEN]),
    },
    axes=(r"x \mathrm{\ and\ } u_1", r"y \mathrm{\ and\ } u_2"),
)

# %% [markdown]
# In the normal case $\mathbf R' = \mathbf R'' = \mathbf E$ and $\mathbf C$ of 1992 is $\mathbf B$ itself.  The basic
# points of section 2.2 of 1996 have equal ordinates in both images, and $f$ there is $-c$ here.

# %%
images_left, images_right = (
    rows(*(vector(x, y) for x, y in zip(abscissas, ordinates, strict=True)))
    for abscissas in (abscissas_left, abscissas_right)
)
along_base = given(d, (base_length, sympy.Integer(0), sympy.Integer(0)))
section.identity(
    "1/normal-case",
    "matrix of correlation of the normal case",
    printed=(K * frame(images_left)).T * B.xreplace(along_base) * (K * frame(images_right)),
    derived=C_normal.xreplace({distance: -c}),
)

# %% [markdown]
# **Which element is the divisor?**  The papers choose different ones: 1992 by $c_{32}$, counted from 1, in the order
# $x, y, -c$; 1996 by $c_{10}$, counted from 0, in the order $1, u_1, u_2$.  That of 1996 needs affine coordinates whose
# first axis is not parallel to the base: in rectangular ones it vanishes in the normal case.

# %%
rectangular = K.T * C_1992 * K
section.identity(
    "1/divisor",
    "the divisors of both papers, in rectangular coordinates",
    printed=-c * vector(C_1992[2, 1], C_1992[0, 2]),
    derived=vector(rectangular[0, 2], rectangular[1, 0]),
)
section.identity(
    "1/divisor#normal-case",
    "in rectangular coordinates the divisor of 1996 vanishes in the normal case",
    printed=0,
    derived=(K.T * B.xreplace(along_base) * K)[1, 0],
)

# %% [markdown]
# ## Have they the same epipoles?
#
# **Definition.**  1992 has $\lambda_0' \mathbf x_0' = \mathbf R'^T \mathbf b$, 1996 the solution of
# $\mathbf P' \mathbf u_0' = \mathbf d$.  Here $\mathbf R$ must be a rotation: the quaternion of section 1.4 of 1996.
# Shown is the left image; the right one has $-\mathbf b$.

# %%
section.up_to_scale(
    "1/epipole",
    "the epipoles of both papers",
    printed=rotation.T * d,
    derived=K * A_left * solve(reconstruction(rotation, g_left), d),
)

# %% [markdown]
# ## And the same rectification?
#
# **Definition.**  1992: $\tau \mathbf x_N = \mathbf R \mathbf x$.  1996: $\tau \mathbf u_N = \mathbf T \mathbf u$,
# where both images are referred to the basic points.  The images of these in the normal case have the factors $\tau_j$
# of their own.  Divided by that of $G_0$, they are $\tau_1$ and $\tau_2$ of 1996.

# %%
rotated = [R_left * image_vector(g_left.row(n).T) for n in range(3)]
factors = [over(point[2], -c) for point in rotated]
g_normal = rows(*(vector(over(p[0], t), over(p[1], t)) for p, t in zip(rotated, factors, strict=True)))

section.up_to_scale(
    "1/rectification",
    "the transformations to the normal case of both papers",
    printed=K * frame(g_normal) * T,
    where={tau1: over(factors[1], factors[0]), tau2: over(factors[2], factors[0])},
    derived=R_left * K * A_left,
)

# %% [markdown]
# # 1.4 Connection with orthonormalized systems
#
# Analytical photogrammetry has cartesian coordinates of the object and rectangular coordinates of the image.  What do
# they have to do with the affine ones?  What it calls a camera is a projection of section 1.2 between two affine
# transformations.

# %%
from fractions import Fraction

import sympy
from sympy import BlockMatrix, Eq, Identity, MatrixSymbol, ZeroMatrix

from algebroproj_derivations.figures import ImageDrawing
from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s1_1_projection import quaternion
from algebroproj_derivations.fundamentals1996.s1_1_projection import rotation as scaled_rotation
from algebroproj_derivations.fundamentals1996.s1_2_determination_of_projection import M_star as core
from algebroproj_derivations.inserting import given
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    columns,
    cross,
    dot,
    homogeneous,
    inverse,
    linear_system,
    over,
    rounded,
    rows,
    solve,
    vector,
)

section = Section("fundamentals1996", "1.4", "Connection with orthonormalized systems")

# %% [markdown]
# ## Base and rotation
#
# **Definition.**  The image plane has the distance 1 from the center.  $\mathbf k$ is its normal, $\mathbf i$ and
# $\mathbf j$ are the directions of its rectangular coordinates, $\mathbf R = [\mathbf k, \mathbf i, \mathbf j]$.  Seen
# from the principal point, $G'_j$ stands at $(x_j - x_C, y_j - y_C)$.

# %%
x_center, y_center = sympy.symbols("xC yC")
xs, ys = sympy.symbols("x0 x1 x2"), sympy.symbols("y0 y1 y2")
R = Matrix(3, 3, sympy.symbols("r:3:3"))
k, i, j = (R.col(n) for n in range(3))
internal = [vector(1, xj - x_center, yj - y_center) for xj, yj in zip(xs, ys, strict=True)]
external = [k + (xj - x_center) * i + (yj - y_center) * j for xj, yj in zip(xs, ys, strict=True)]

section.definition(
    "1.4/b",
    "base vectors in the system of the image",
)
section.identity(
    "1.4/b#external",
    "base vectors in the system of the object",
    derived=columns(*external),
)

# %% [markdown]
# Six equations make $\mathbf R$ orthogonal, $\mathbf R^T \mathbf R = \mathbf E$.  Where a formula is better tried on a
# rotation itself, a quaternion, divided by its length, keeps it rational.

# %%
orthogonal = [(R.T * R - E3)[row, column] for row in range(3) for column in range(row, 3)]
unrotated = given(R, (1, 0, 0, 0, 1, 0, 0, 0, 1))

rotation = scaled_rotation.applyfunc(lambda entry: over(entry, sum(q**2 for q in quaternion)))

section.identity(
    "1.4/beyond/rotation",
    "a quaternion gives an orthogonal matrix",
    printed=E3,
    derived=rotation.T * rotation,
)

# %% [markdown]
# ## The image point
#
# **Definition.**  The image point $\mathbf p = \mathbf b_0 + u_1 (\mathbf b_1 - \mathbf b_0) + u_2 (\mathbf b_2 -
# \mathbf b_0)$ is the rotated vector that has the same coordinates in the system of the image.  That vector is linear
# in $(1, u_1, u_2)$, with the matrix $\mathbf A_v$:

# %%
u = vector(u1, u2)


def image_point(base: list[Matrix]) -> Matrix:
    return base[0] + u1 * (base[1] - base[0]) + u2 * (base[2] - base[0])


linear, constant = linear_system(list(image_point(internal)), list(u))
A_v = columns(-constant, linear)
A_v

# %% [markdown]
# **Print.**  The sum of the base vectors, rotated, in four forms.

# %%

section.identity("1.4.1#sum", "image point, rotated sum of the internal base", derived=image_point(external))
section.reference(
    "1.4/ref-1.1.3",
    "equation into which the rotated base vectors are inserted",
    meant="1.1.4",
    note="(1.1.3) gives the reciprocal vectors; inserted there, R would rotate them and not give p.  (1.1.4) is the "
    "first number that contains p = B U u.",
)

# %% [markdown]
# As products of matrices:

# %%
section.identity("1.4.1#base", "image point, barycentric", derived=image_point(external))
section.identity("1.4.1#U", "image point, affine", derived=image_point(external))

# %% [markdown]
# The matrix $\mathbf A_v$ itself is printed with the coordinates of $G'_1$ and $G'_2$ in its second and third column.
# They must be differences to $G'_0$, as in $\mathbf A_X$ below.

# %%
section.identity(
    "1.4.1#A_v",
    "matrix of the affine image coordinates",
    derived=A_v,
    expect="misprint",
    corrected=Matrix(
        [
            [1, 0, 0],
            [xs[0] - x_center, xs[1] - xs[0], xs[2] - xs[0]],
            [ys[0] - y_center, ys[1] - ys[0], ys[2] - ys[0]],
        ]
    ),
    note="Ruled out: the matrix of the base itself, which has the first row 1 1 1; a transposition; G'0 in the "
    "principal point, which would give the first column 1 0 0.  The scan alone cannot tell a slip of the scan "
    "from one of the print.",
)
section.identity("1.4.1", "image point from its affine coordinates", derived=image_point(external))

# %% [markdown]
# ## Affine frames
#
# **Definition.**  $\mathbf A_v$ for the plane and $\mathbf A_X$ for space are the same thing: the frame of some
# points, with the first one as origin.  A point has the coordinates $y_i$ if $\mathbf X = \mathbf X_{G_0} + \sum y_i
# (\mathbf X_{G_i} - \mathbf X_{G_0})$.  These are linear equations for $y_i$.


# %%
def frame(points: Matrix) -> Matrix:
    origin, *others = (points.row(n).T for n in range(points.rows))
    return columns(homogeneous(origin), *(vector(0, *(other - origin)) for other in others))


def point_at(affine: Matrix, points: Matrix) -> Matrix:
    origin, *others = (points.row(n).T for n in range(points.rows))
    return origin + columns(*(other - origin for other in others)) * affine


def coordinates(point: Matrix, points: Matrix) -> Matrix:
    unknown = vector(*sympy.symbols(f"t:{points.cols}"))
    return solve(*linear_system(list(point_at(unknown, points) - point), list(unknown)))


# %% [markdown]
# **In the image.**  The rows of $g$ are the points $G'_j$ in coordinates $v_1, v_2$.  Measured from the principal point
# they are $(x_j - x_C, y_j - y_C)$, but any origin serves.  The paper prints $\mathbf v = \mathbf A_v \mathbf u$; its
# inverse is what one needs to begin with.

# %%
g = Matrix(3, 2, sympy.symbols("g:3:2"))
v = vector(*sympy.symbols("v1 v2"))
x, y = sympy.symbols("x y")

section.identity(
    "1.4/v",
    "from affine to rectangular image coordinates",
    where=given((x, y), point_at(u, g)),
    derived=frame(g) * homogeneous(u),
)
section.identity(
    "1.4/plane-coordinates",
    "from rectangular to affine image coordinates",
    printed=inverse(frame(g)) * homogeneous(v),
    derived=homogeneous(coordinates(v, g)),
)

# %% [markdown]
# **An example.**  In the left image of section 4 the basic points and the point 2 have these rectangular coordinates,
# and point 2 these affine ones:

# %%
EXAMPLE_IMAGE = (("-0.0451870", "-0.6343754"), ("0.0202372", "0.8297962"), ("0.9728948", "-0.4654293"))
corners = [vector(*map(sympy.Rational, corner)) for corner in EXAMPLE_IMAGE]
seen = vector(sympy.Rational("0.0313810"), sympy.Rational("-0.2265744"))
example_u = coordinates(seen, rows(*corners)).doit()
[str(rounded(Fraction(int(number.p), int(number.q)), 7)) for number in example_u]


# %%
def grid_line(first: Matrix, second: Matrix) -> Matrix:
    """Return the line through two points in affine coordinates."""
    return cross(*(homogeneous(point_at(end, rows(*corners))) for end in (first, second)))


quarters = [sympy.Rational(n, 4) for n in range(5)]
ImageDrawing(
    "The left image of section 4: the basic points, point 2, and the lines on which one affine coordinate is 0, 1/4, "
    "1/2, 3/4 or 1.",
    {
        "rectangular coordinates": (
            {f"G'{j}": corner for j, corner in enumerate(corners)} | {"2": seen},
            [grid_line(vector(n, 0), vector(n, 1)) for n in quarters]
            + [grid_line(vector(0, n), vector(1, n)) for n in quarters],
        )
    },
    axes=("v_1", "v_2"),
)

# %% [markdown]
# ## The distances
#
# How far is an object point?  The ray is $\mathbf X - \mathbf X_0 = \lambda \mathbf p$, and a rotation does not
# change the length of $\mathbf p = \mathbf R \mathbf A_v \mathbf u$.

# %%
lam = sympy.Symbol("lam")
X = vector(*sympy.symbols("X1 X2 X3"))
X0 = vector(*sympy.symbols("X01 X02 X03"))
p = vector(*sympy.symbols("p1 p2 p3"))
plane_point = frame(g) * homogeneous(u)


def on_the_ray(direction: Matrix) -> dict[sympy.Symbol, sympy.Expr]:
    return given(X, X0 + lam * direction)


section.definition("1.4/lambda", "ray to an object point")
section.identity("1.4.2#p", "factor of the ray, from the image point", where=on_the_ray(p), derived=lam**2)
section.identity(
    "1.4.2",
    "factor of the ray, from the affine image coordinates",
    where=on_the_ray(R * plane_point),
    derived=lam**2,
    constraints=orthogonal,
    witness=unrotated,
)

# %% [markdown]
# **Meaning.**  The factor is the ratio of the distances of object and image point, $s$ and $s'$, from the center.

# %%
object_distance, image_distance = sympy.symbols("s sp")
section.identity(
    "1.4/ratio",
    "the factor is the ratio of the distances",
    printed=over(object_distance, image_distance) ** 2,
    derived=lam**2,
    constraints=[object_distance**2 - lam**2 * dot(p, p), image_distance**2 - dot(p, p)],
    witness=given((*p, lam, image_distance, object_distance), (1, 2, 2, 2, 3, 6)),
    note="The sentence follows the formula for the square of the factor and is read of the factor itself: the square "
    "is the ratio of the squared distances.",
)

# %% [markdown]
# ## The basic points in space
#
# **In space.**  The rows of $G$ are the basic points.  $\mathbf A_X$ takes the unit points to them.

# %%
G = Matrix(4, 3, sympy.symbols("G:4:3"))
basic_points = columns(*(homogeneous(G.row(n).T) for n in range(4)))
unit_points = columns(*(homogeneous(e) for e in (e0, e1, e2, e3)))
axes = [sympy.symbols(f"{axis}:4") for axis in "XYZ"]

section.identity(
    "1.4.3",
    "from cartesian to affine coordinates of space",
    derived=homogeneous(coordinates(X, G)),
)
section.identity(
    "1.4/A_X",
    "matrix of the affine coordinates of space",
    where=given(Matrix(axes).T, G),
    derived=basic_points * inverse(unit_points),
)
section.identity(
    "1.4.4",
    "the unit points become the basic points",
    derived=basic_points,
)

# %% [markdown]
# With center and point in affine coordinates the ray is $\mathbf A_X \mathbf z$, and the factor follows from both
# frames.

# %%
point = vector(y1, y2, y3)
section.identity(
    "1.4/ray", "cartesian and affine ray", derived=homogeneous(point_at(point, G)) - homogeneous(point_at(center, G))
)
z = vector(*sympy.symbols("z1 z2 z3"))
object_ray = point_at(point, G) - point_at(center, G)
rotated_point = rotation * plane_point
section.identity(
    "1.4/lambda2",
    "factor of the ray, affine",
    where=given(z, point - center),
    derived=over(dot(object_ray, object_ray), dot(rotated_point, rotated_point)),
)

# %% [markdown]
# ## Projection between cartesian systems
#
# To invert $\mathbf P = \mathbf B \mathbf U = \mathbf R \mathbf A_v$ takes no more than the inverse of $\mathbf A_v$.
# The result acts on the cartesian ray; on the affine one of section 1.1 it acts with $\mathbf A_X$ on its right.
# From here on the edges $G_j - G_0$ and $G'_j - G'_0$ are the symbols, which keeps determinants short.

# %%
origin, edges = vector(*sympy.symbols("G00 G01 G02")), Matrix(3, 3, sympy.symbols("a:3:3"))
plane_origin, plane_edges = vector(*sympy.symbols("g00 g01")), Matrix(2, 2, sympy.symbols("c:2:2"))
space_points = rows(origin, *(origin + edges.row(n).T for n in range(3)))
plane_points = rows(plane_origin, *(plane_origin + plane_edges.row(n).T for n in range(2)))
A_X, A_v = frame(space_points), frame(plane_points)

R_bold, A_v_bold = MatrixSymbol("R", 3, 3), MatrixSymbol("A_v", 3, 3)
section.identity(
    "1.4.6",
    "matrix of projection, rotation and affine transformation",
    derived=(R_bold * A_v_bold).I,
    properties={R_bold: "rotation"},
)

# %% [markdown]
# **What becomes of the normal case?**  There $\mathbf R = \mathbf E$, and the matrix has the first row $1, 0, 0$.  A
# quasihomogeneous vector keeps its leading 1: that is what affine means.  In rectangular coordinates $\mathbf X -
# \mathbf X_0$ is a multiple of $(1, x, y)$, and the transformation a similarity.

# %%
section.structure(
    "1.4/normal-case",
    "the normal case is an affine transformation",
    printed=Matrix([[1, 0, 0], sympy.symbols("a10 a11 a12"), sympy.symbols("a20 a21 a22")]),
    derived=inverse((R * A_v).xreplace(unrotated)),
)

section.identity(
    "1.4/normal-case#similarity",
    "the normal case of analytical photogrammetry is a similarity transformation",
    printed=lam * homogeneous(plane_point[1:, 0]),
    derived=(lam * R * plane_point).xreplace(unrotated),
)

# %% [markdown]
# **Are these the collinearity equations?**  Seen from the image system the ray is $\mathbf R^T (\mathbf X - \mathbf
# X_0)$, and its first component is the factor of the quasihomogeneous image vector $\mathbf v$.  On the other side
# $\mathbf M$ is put together by (1.1.6), with (1.4.6) and $\mathbf X - \mathbf X_0 = \mathbf A_X \mathbf z$.  The
# affine frame has the first basic point $\mathbf g$ as its origin, and the edges as columns of $\mathbf F$.  Of
# $\mathbf A_v$ nothing is needed but its inverse.

# %%
F, P_star, M = MatrixSymbol("F", 3, 3), MatrixSymbol("Ps", 3, 3), MatrixSymbol("M", 3, 4)
A_X_bold, X_homogeneous = MatrixSymbol("A_X", 4, 4), MatrixSymbol("X", 4, 1)
g_bold, y0_bold, x_bold = (MatrixSymbol(name, 3, 1) for name in ("g", "y0", "x"))
section.identity(
    "1.4.5",
    "projection between cartesian systems",
    derived=R_bold.T * (x_bold - (g_bold + F * y0_bold)),
    constraints=[
        Eq(P_star, A_v_bold.I * R_bold.T * F),
        Eq(M, BlockMatrix([[-P_star * y0_bold, P_star]])),
        Eq(A_X_bold, BlockMatrix([[Identity(1), ZeroMatrix(1, 3)], [g_bold, F]])),
        Eq(X_homogeneous, BlockMatrix([[Identity(1)], [x_bold]])),
    ],
    properties={R_bold: "rotation"},
)

# %% [markdown]
# **And conversely?**  A general projection takes the basic points to any images $\mathbf s_j$.  It is a core (1.2.3)
# between two affine transformations.  Image points and parameters of the core are read off the $\mathbf s_j$.

# %%
images = Matrix(3, 4, sympy.symbols("s:3:4"))
depths = images.row(0)
seen_points = rows(*(vector(over(images[1, n], depths[n]), over(images[2, n], depths[n])) for n in range(4)))
seen_u3 = coordinates(seen_points.row(3).T, seen_points[:3, :])
general = images * inverse(columns(*(homogeneous(space_points.row(n).T) for n in range(4))))
section.identity(
    "1.4/type",
    "every projection is of type (1.2.3) between affine transformations",
    printed=frame(seen_points[:3, :]) * core[:3, :] * inverse(A_X),
    where=given((mu0, mu1, mu2, mu3, u31, u32), (*depths, *seen_u3)),
    derived=general,
)

# %% [markdown]
# ## Must the measuring device be calibrated?
#
# No.  Other image coordinates $\mathbf v' = \mathbf C \mathbf v$, oblique and in any scale, change $\mathbf A_v$ to
# $\mathbf C \mathbf A_v$.  They leave $\mathbf u$ and $\mathbf M$ alone.

# %%
device = Matrix(2, 2, sympy.symbols("d11 d12 d21 d22"))
shift = vector(*sympy.symbols("d10 d20"))
C = columns(homogeneous(shift), Matrix([[0, 0]]).col_join(device))


def read(point: Matrix) -> Matrix:
    return shift + device * point


other_points = rows(*(read(g.row(n).T) for n in range(3)))
section.identity(
    "1.4/uncalibrated",
    "affine image coordinates need no calibration",
    printed=coordinates(v, g),
    derived=coordinates(read(v), other_points),
)
section.identity(
    "1.4/uncalibrated#A_v",
    "change of the affine frame with the measuring device",
    printed=C * frame(g),
    derived=frame(other_points),
)

# %% [markdown]
# # 4 The fundamental matrix
#
# Hartley and Zisserman, *Multiple View Geometry*, write $\mathbf x''^T \mathbf F \mathbf x' = 0$ for homologous points:
# first the right image, then the left one.  The equation of correlation is $\mathbf u'^T \mathbf C \mathbf u'' = 0$,
# hence $\mathbf F = \mathbf C^T$.  This section compares what the textbook does with $\mathbf F$.  (Their points have
# the 1 last; the order of components changes nothing in what follows.)

# %%
import sympy

from algebroproj_derivations.bridges.s3_coplanarity import M_left, M_right, minors
from algebroproj_derivations.figures import ImageDrawing
from algebroproj_derivations.fundamentals1996.s1_3_properties_of_projection import M_star
from algebroproj_derivations.fundamentals1996.s2_2_correlation import C_of_cameras, Z_general, design, primed, unknowns
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    adjugate,
    columns,
    cross,
    determinant,
    dot,
    homogeneous,
    linear_system,
    vector,
)

section = Section("bridges", "4", "The fundamental matrix")

# %% [markdown]
# ## What is $\mathbf F$ of two cameras?
#
# **Definition.**  Minors of the stacked rows of two cameras, four rows each: $f_{ji} = (-1)^{i+j} \det(\dots)$ without
# row $i$ of the left and row $j$ of the right camera.
#
# Shown are two images that are referred to the same basic points; for any cameras see 3/factor.

# %%
F = minors(M_left, M_right).T
F_of_core = minors(primed(M_star, "p")[:3, :], primed(M_star, "pp")[:3, :]).T

section.up_to_scale(
    "4/F",
    "the fundamental matrix is the transposed matrix of correlation",
    printed=F_of_core,
    derived=C_of_cameras.T,
)
point = vector(*sympy.symbols("y:4"))
section.identity(
    "4/F#homologous",
    "homologous points satisfy the equation",
    printed=0,
    derived=dot(M_right * point, F * (M_left * point)),
)

# %% [markdown]
# ## Where are centers and epipoles?
#
# **Definition.**  The center of a camera is its null vector; the epipole is the image of the other center.


# %%
def center_of(camera: Matrix) -> Matrix:
    """Return the null vector of a camera (3 by 4): its signed minors."""
    kept = [columns(*(camera.col(j) for j in range(4) if j != column)) for column in range(4)]
    return vector(*((-1) ** column * determinant(matrix) for column, matrix in enumerate(kept)))


center_left, center_right = center_of(M_left), center_of(M_right)
epipole_left, epipole_right = M_left * center_right, M_right * center_left

section.rank(
    "4/center",
    "the center of projection is the null vector of the camera",
    printed=3,
    derived=M_left,
    kernel=[center_left],
)
section.identity(
    "4/epipoles",
    "the epipoles are the null vectors of the fundamental matrix",
    printed=Matrix.zeros(3, 2),
    derived=columns(F * epipole_left, F.T * epipole_right),
)


# %% [markdown]
# ## Which lines does it make?
#
# **Result.**  $\mathbf F \mathbf x'$ is the line that joins the epipole and the homologous point.  For all points at
# once: $\mathbf F \mathbf M' = [\mathbf e'']_\times \mathbf M''$, where the matrix of the vector product replaces the
# product.  $\mathbf M'$ has a right inverse $\mathbf M'^+$, which gives the formula of the textbook, $\mathbf F =
# [\mathbf e'']_\times \mathbf M'' \mathbf M'^+$, but for the determinant of $\mathbf M' \mathbf M'^T$.


# %%
def matrix_of(axis: Matrix) -> Matrix:
    """Return the skew-symmetric matrix of the vector product with a vector."""
    return columns(*(cross(axis, Matrix.eye(3).col(j)) for j in range(3)))


section.identity(
    "4/epipolar-line",
    "the epipolar line joins the epipole and the homologous point",
    printed=matrix_of(epipole_right) * M_right,
    derived=F * M_left,
)
core_left, core_right = primed(M_star, "p")[:3, :], primed(M_star, "pp")[:3, :]
pseudo_inverse = core_left.T * adjugate(core_left * core_left.T)
epipole_of_core = core_right * center_of(core_left)
section.up_to_scale(
    "4/pseudo-inverse",
    "the fundamental matrix by the pseudo-inverse of the left camera",
    printed=matrix_of(epipole_of_core) * core_right * pseudo_inverse,
    derived=C_of_cameras.T,
)

# %% [markdown]
# **An example.**  Two cameras with small numbers, and three points that they see.

# %%
EXAMPLE_LEFT = Matrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]])
EXAMPLE_RIGHT = Matrix([[1, 0, 1, 1], [-1, 1, 0, 2], [0, 0, 1, 2]])
F_example = minors(EXAMPLE_LEFT, EXAMPLE_RIGHT).T
SPACE = {"1": vector(1, 1, 1, 1), "2": vector(1, 2, 0, 1), "3": vector(2, -1, 1, 1)}


def seen_by(camera: Matrix, point: Matrix) -> Matrix:
    image = camera * point
    return (image / image[0])[1:, :]


left_seen, right_seen = (
    {name: seen_by(camera, point) for name, point in SPACE.items()} for camera in (EXAMPLE_LEFT, EXAMPLE_RIGHT)
)
left_center, right_center = center_of(EXAMPLE_LEFT), center_of(EXAMPLE_RIGHT)
ImageDrawing(
    "Each point of the left image gives a line of the right one, which contains its partner, and the other way round.  "
    "All lines meet in the epipole E.",
    {
        "left image": (
            {"E": seen_by(EXAMPLE_LEFT, right_center), **left_seen},
            [F_example.T * homogeneous(point) for point in right_seen.values()],
        ),
        "right image": (
            {"E": seen_by(EXAMPLE_RIGHT, left_center), **right_seen},
            [F_example * homogeneous(point) for point in left_seen.values()],
        ),
    },
    axes=("x_1", "x_2"),
)

# %% [markdown]
# ## Which cameras belong to $\mathbf F$?
#
# **Definition.**  With $\mathbf M' = [\mathbf E\; \mathbf 0]$ and $\mathbf M'' = [\mathbf Q\; \mathbf q]$ the
# fundamental matrix is $[\mathbf q]_\times \mathbf Q$.  Conversely $\mathbf F$ alone gives such a pair, but for a
# projective transformation of space: the relative model of 1996.  $\mathbf F$ has rank 2, and its columns are
# orthogonal to the epipole.

# %%
Q, q = Matrix(3, 3, sympy.symbols("f:3:3")), vector(*sympy.symbols("e:3"))
canonical = columns(*(Matrix.eye(3).col(j) for j in range(3)), vector(0, 0, 0))
section.up_to_scale(
    "4/canonical",
    "the fundamental matrix of canonical cameras",
    printed=matrix_of(q) * Q,
    derived=minors(canonical, columns(Q, q)).T,
)

first, second = vector(*sympy.symbols("a:3")), vector(*sympy.symbols("b:3"))
s, t = sympy.symbols("s t")
F_singular = columns(first, second, s * first + t * second)
epipole = cross(first, second)
section.up_to_scale(
    "4/canonical#model",
    "a pair of cameras from the fundamental matrix",
    printed=minors(canonical, columns(matrix_of(epipole) * F_singular, epipole)).T,
    derived=F_singular,
)

# %% [markdown]
# Any projective transformation $\mathbf H$ of space changes $\mathbf F$ by the factor $\det \mathbf H$ alone.  Shown is
# one element for all: each has two rows of either camera.

# %%
H = Matrix(4, 4, sympy.symbols("h:4:4"))
section.identity(
    "4/projective-ambiguity",
    "projective transformations of space do not change the fundamental matrix",
    printed=determinant(H) * F[2, 2],
    derived=minors(M_left * H, M_right * H)[2, 2],
)

# %% [markdown]
# ## Which eight equations?
#
# **Definition.**  The textbook solves $\mathbf A \mathbf f = \mathbf 0$, one row a point, for the nine elements of
# $\mathbf F$.  The system of eight unknowns of 1996 is the same with $c_{10} = f_{01} = 1$: eight columns, and the
# ninth on the right.
#
# The elements of $\mathbf F$ are taken row by row, right coordinates first; $\mathbf F$ is the transposed $\mathbf Z$.

# %%
up1, up2, upp1, upp2 = sympy.symbols("up1 up2 upp1 upp2")
u_left, u_right = vector(1, up1, up2), vector(1, upp1, upp2)
f = Matrix(3, 3, sympy.symbols("f:3:3"))
homogeneous_row, _ = linear_system([dot(u_right, f * u_left)], tuple(f))

section.identity(
    "4/eight-points",
    "the row of the homogeneous system",
    printed=Matrix([[a * b for a in u_right for b in u_left]]),
    derived=homogeneous_row,
)
section.identity(
    "4/eight-points#1996",
    "the row of the system of eight unknowns",
    printed=columns(*linear_system([dot(u_right, Z_general.T * u_left)], unknowns)),
    derived=design,
    note="The textbook fixes the length of f instead of one element, and needs no element to differ from zero.",
)

# %% [markdown]
# # 1.1 General linear homogeneous transformation
#
# A matrix $\mathbf P$ (4 by 4) takes homogeneous vectors of space, with components of index 0 to 3, to homogeneous
# vectors.  What do the images fill, a space, a plane or a line?  Its rank tells.  How many points have to be seen to
# know it?  Its elements, but for a common factor, are its parameters, and "noncoplanar" is not enough.

# %%
from itertools import combinations

import sympy
from sympy import MatrixSymbol

from algebroproj_derivations.cameras import inhomogeneous
from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.inserting import inserted
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, columns, determinant, dot, inverse, over, vector

section = Section("rhodos1990", "1.1", "General linear homogeneous transformation")

# %% [markdown]
# **Definition.**  The components are printed as $\mathbf p_i^T \mathbf y$, with the rows $\mathbf p_i^T$ of $\mathbf
# P$; no letter for the image survives.

# %%
P = Matrix(4, 4, sympy.symbols("p:4:4"))
y = vector(*sympy.symbols("y:4"))

section.identity(
    "1.1.1",
    "the transformation, row by row",
    printed=vector(*(P[i, 0] * y[0] + P[i, 1] * y[1] + P[i, 2] * y[2] + P[i, 3] * y[3] for i in range(4))),
    derived=P * y,
)

# %% [markdown]
# ## What do the images fill?
#
# **Definition.**  The images of all points fill what their inhomogeneous coordinates fill: as many dimensions as
# independent functions are among them.  Nothing changes along $\mathbf y$ itself, which is the free factor of a
# homogeneous vector, nor along a vector that $\mathbf P$ annihilates.


# %% [markdown]
# **Rank 4.**  A regular matrix relates two spaces of three dimensions, in both directions.

# %%
section.rank("1.1/regular#rank", "a general matrix is regular", derived=MatrixSymbol("P", 4, 4))
section.identity(
    "1.1/regular#inverse",
    "a regular transformation relates the two spaces in both directions",
    printed=y,
    derived=inverse(P) * (P * y),
)
section.count(
    "1.1/regular",
    "a regular matrix relates two spaces of three dimensions",
    printed=3,
    derived=inhomogeneous(P * y),
    variables=tuple(y),
    kernel=[y],
)

# %% [markdown]
# **A smaller rank.**  A matrix of rank $r$ is a product of a matrix with $r$ columns and one with $r$ rows.  The
# vectors it annihilates, and the planes in which all images lie, are vectors of minors.


# %%
def of_rank(r: int) -> tuple[Matrix, Matrix]:
    """Return two general factors of a matrix of rank r."""
    return Matrix(4, r, sympy.symbols(f"a:4:{r}")), Matrix(r, 4, sympy.symbols(f"b:{r}:4"))


def annihilated(matrix: Matrix, kept: tuple[int, ...]) -> Matrix:
    """Return the vector of signed minors of r + 1 columns, which a matrix with r rows takes to zero."""
    components = [sympy.Integer(0)] * matrix.cols
    for place, column in enumerate(kept):
        others = columns(*(matrix.col(j) for j in kept if j != column))
        components[column] = (-1) ** place * determinant(others)
    return vector(*components)


left3, right3 = of_rank(3)
left2, right2 = of_rank(2)
center = annihilated(right3, (0, 1, 2, 3))
axis = [annihilated(right2, kept) for kept in ((0, 1, 2), (1, 2, 3))]
plane = annihilated(left3.T, (0, 1, 2, 3))
planes = [annihilated(left2.T, kept) for kept in ((0, 1, 2), (1, 2, 3))]


# %% [markdown]
# **Rank 3.**  One point is annihilated, the center of the projection.  The images fill a plane.

# %%
section.rank("1.1/plane#rank", "rank 3", derived=left3 * right3, kernel=[center])
section.identity(
    "1.1/plane#incident",
    "with rank 3 all images lie in a plane",
    printed=0,
    derived=dot(plane, left3 * (right3 * y)),
)
section.count(
    "1.1/plane",
    "with rank 3 the images fill a plane",
    printed=2,
    derived=inhomogeneous(left3 * (right3 * y)),
    variables=tuple(y),
    kernel=[y, center],
)

# %% [markdown]
# **Rank 2.**  The points of an axis are annihilated.  The images fill a straight line.

# %%
section.rank("1.1/line#rank", "rank 2", derived=left2 * right2, kernel=axis)
section.identity(
    "1.1/line#incident",
    "with rank 2 all images lie in two planes, and in their line",
    printed=vector(0, 0),
    derived=vector(*(dot(a, left2 * (right2 * y)) for a in planes)),
)
section.count(
    "1.1/line",
    "with rank 2 the images fill a straight line",
    printed=1,
    derived=inhomogeneous(left2 * (right2 * y)),
    variables=tuple(y),
    kernel=[y, *axis],
)

# %% [markdown]
# ## How many parameters are there?
#
# **Definition.**  Sixteen elements, with a common factor that no quotient of elements and no image point notices.

# %%
section.count(
    "1.1/parameters",
    "the transformation contains 15 independent parameters",
    derived=vector(*(over(element, P[0, 0]) for element in P[1:])),
    variables=tuple(P),
    kernel=[vector(*P)],
)

# %% [markdown]
# **And as seen from images of points**, which is what one can observe?  Five points show all fifteen parameters, four
# points only twelve.  The unit vectors and the unit point stand for any five points of which no four are coplanar, by a
# change of coordinates.

# %%
units = columns(*(vector(*(int(i == j) for i in range(4))) for j in range(4)))
unit_point = vector(1, 1, 1, 1)


def observed(*points: Matrix) -> Matrix:
    return Matrix.vstack(*(inhomogeneous(P * point) for point in points))


four_points = [units.col(j) for j in range(4)]
section.count(
    "1.1/parameters#five-points",
    "the images of five points depend on all 15 parameters",
    derived=observed(*four_points, unit_point),
    variables=tuple(P),
    kernel=[vector(*P)],
)
section.count(
    "1.1/beyond/four-points",
    "the images of four points depend on 12 parameters",
    printed=12,
    derived=observed(*four_points),
    variables=tuple(P),
    kernel=[vector(*(P * Matrix.diag(*unit))) for unit in four_points],
)

# %% [markdown]
# ## How many points define the relation?
#
# **Definition.**  A point and its image, $\mathbf P \mathbf y \sim \mathbf y'$, give $n$ linear equations for the
# elements of $\mathbf P$, in a space of $n$ dimensions: $y'_0\, (\mathbf P \mathbf y)_k = y'_k\, (\mathbf P \mathbf
# y)_0$.


# %%
def equations(point: Matrix, image: Matrix) -> Matrix:
    """Return the coefficients of the elements of P, row by row of P, in the equations of one pair of points."""
    size = len(point)
    rows = []
    for k in range(1, size):
        factors = [image[0] * int(i == k) - image[k] * int(i == 0) for i in range(size)]
        rows.append([factor * component for factor in factors for component in point])
    return Matrix(rows)


# %% [markdown]
# **Print.**  $n + 2$ points.  They have as many coordinates as there are parameters, and the equations of general
# points and their images leave the multiples of the matrix alone.

# %%
dimension = sympy.Symbol("n")
section.identity(
    "1.1/n+2-points#count",
    "n + 2 points have as many coordinates as the transformation has parameters",
    printed=(dimension + 2) * dimension,
    derived=(dimension + 1) ** 2 - 1,
)
for n, parameters in ((1, 3), (2, 8), (3, 15)):
    size = n + 1
    general = Matrix(size, size, sympy.symbols(f"p:{size}:{size}"))
    points = [vector(*sympy.symbols(f"y{k}_:{size}")) for k in range(n + 2)]
    section.rank(
        f"1.1/n+2-points#{n}",
        f"n + 2 points in general position define the relation for n = {n}",
        printed=parameters,
        derived=Matrix.vstack(*(equations(point, general * point) for point in points)),
        kernel=[vector(*general)],
    )

# %% [markdown]
# ## What position is general?
#
# **Derivation.**  Four points of which no plane contains all become the unit vectors by a change of
# coordinates, in the space of the object and in that of the image.  The transformation is a diagonal matrix then, and
# the fifth point $(e_0, e_1, e_2, e_3)$ relates the elements of the diagonal in pairs, but only where both components
# are different from zero.

# %%
fifth = vector(*sympy.symbols("e:4"))
unit_frame = [*four_points, fifth]
coplanar = fifth.xreplace({fifth[3]: sympy.Integer(0)})


def fixed(point: Matrix) -> Matrix:
    """Return all equations of a point that is its own image, none of its components being preferred."""
    rows = []
    for i, j in combinations(range(4), 2):
        row = [sympy.Integer(0)] * 16
        for column in range(4):
            row[4 * i + column] += point[j] * point[column]
            row[4 * j + column] -= point[i] * point[column]
        rows.append(row)
    return Matrix(rows)


def diagonal(*elements: int) -> Matrix:
    return vector(*Matrix.diag(*elements))


# %% [markdown]
# If no component is zero, only the multiples of the unit matrix leave the five points alone.  A component is zero
# exactly if the fifth point is coplanar with three others.

# %%
section.rank(
    "1.1/beyond/general-position",
    "five points define the relation if no four of them are coplanar",
    printed=15,
    derived=Matrix.vstack(*map(fixed, unit_frame)),
    kernel=[diagonal(1, 1, 1, 1)],
)
for j in range(4):
    others = [point for i, point in enumerate(four_points) if i != j]
    section.vanishing(
        f"1.1/beyond/general-position#e{j}",
        f"component {j} of the fifth point is zero exactly if it is coplanar with the three others",
        printed=(fifth[j],),
        derived=determinant(columns(*others, fifth)),
    )

# %% [markdown]
# **Print.**  "Noncoplanar" points.  Here are five that do not lie in one plane, four of which do:

# %%
AFFINE = columns(*(vector(1, *place) for place in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))))


def place_of(homogeneous_point: Matrix) -> Matrix:
    return inhomogeneous(AFFINE * homogeneous_point).doit()


SpaceDrawing(
    "Five points.  The fifth lies in the plane of the first three, and nothing ties the fourth one to it.",
    {
        **{f"{j}": place_of(point) for j, point in enumerate(four_points)},
        "E": place_of(inserted(coplanar, fifth[:3, :], (1, 1, 1))),
    },
    triangles=[("0", "1", "2")],
    axes=("x_1", "x_2", "x_3"),
)

# %%
section.rank(
    "1.1/n+2-points#noncoplanar",
    "five noncoplanar points define the relation",
    printed=15,
    derived=Matrix.vstack(*map(fixed, [*four_points, coplanar])),
    kernel=[diagonal(1, 1, 1, 0), diagonal(0, 0, 0, 1)],
    expect="false",
    instead="1.1/beyond/general-position",
    note="'Noncoplanar' read as: not all five in one plane.  With four coplanar points among them a whole pencil of "
    "transformations leaves the five points alone.  Read as 'no four of them coplanar', as the unit point of the next "
    "sentence needs it, the sentence is true: 1.1/n+2-points#3 and 1.1/beyond/general-position.",
)

# %% [markdown]
# **The pencil.**  Column by column both sides are the same points, for any $k$: different transformations have the same
# images of the five points.

# %%
k = sympy.Symbol("k")
section.up_to_scale(
    "1.1/beyond/pencil",
    "different transformations with the same images of five noncoplanar points",
    printed=columns(*four_points[:3], k * four_points[3], coplanar),
    derived=Matrix.diag(1, 1, 1, k) * columns(*four_points, coplanar),
)

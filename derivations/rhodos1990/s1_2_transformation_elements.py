# %% [markdown]
# # 1.2 Determination of transformation elements
#
# How are coordinates given to points that have none?  Four points $\mathbf y_0, \dots, \mathbf y_3$ and a unit point
# $\mathbf y_E$ define the base of a projective coordinate system.  The right column of the page is cut at its left
# edge; its beginnings of lines are all that survives there.

# %%
from itertools import combinations

import sympy

from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.inserting import given
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, columns, determinant, dot, inverse, linear_system, over, solve, vector

section = Section("rhodos1990", "1.2", "Determination of transformation elements")

# %% [markdown]
# ## What is a base?
#
# **Definition.**  A homogeneous vector has a free factor.  The base vectors are those multiples of the four vectors
# whose sum is the unit point.

# %%
mu = vector(*sympy.symbols("mu:4"))
Y = Matrix(4, 4, sympy.symbols("y:4:4"))
points = [Y.col(i) for i in range(4)]
unit_point = vector(*sympy.symbols("yE:4"))
base = [mu[i] * points[i] for i in range(4)]
B = columns(*base)

section.definition("1.2.1", "base vectors and matrix of the base", printed=B)

system, right_side = linear_system(list(B * vector(1, 1, 1, 1) - unit_point), list(mu))
mu_of_points = solve(system, right_side)
solved = given(mu, mu_of_points)

# %% [markdown]
# **Print.**  The sum of the base vectors is the product $\mathbf Y \boldsymbol\mu$ with the matrix of the points, and
# the unit point.  For general points the base is regular.

# %%
section.identity(
    "1.2/unit-point",
    "the base vectors add up to the unit point",
    printed=columns(sum(base[1:], start=base[0]), Y * mu),
    where=solved,
    derived=columns(unit_point, unit_point),
)
section.identity(
    "1.2/Y",
    "the coefficients of the conditions are the matrix of the points",
    printed=Y,
    derived=system,
)

section.rank(
    "1.2/base",
    "four points and a unit point yield a base",
    printed=4,
    derived=B.xreplace(solved),
)

# %% [markdown]
# **A figure.**  In a plane there are three points and vectors of three components.  The base vectors are the edges of a
# box whose diagonal is the unit point.

# %%
PLANE = [vector(1, 0, 0), vector(sympy.Rational(1, 2), 1, 0), vector(sympy.Rational(1, 4), sympy.Rational(1, 4), 1)]
DIAGONAL = vector(2, sympy.Rational(3, 2), 1)
lengths = solve(columns(*PLANE), DIAGONAL)
EDGES = {f"b{i}": (length * point).doit() for i, (length, point) in enumerate(zip(lengths, PLANE, strict=True))}
CORNERS = {
    "+".join(names) or "O": sum((EDGES[name] for name in names), start=vector(0, 0, 0))
    for count in range(3)
    for names in combinations(EDGES, count)
} | {"E": DIAGONAL}
SpaceDrawing(
    "Three base vectors b0, b1, b2 and their sum E.",
    CORNERS,
    segments=[(a, b) for a, b in combinations(CORNERS, 2) if CORNERS[b] - CORNERS[a] in EDGES.values()] + [("O", "E")],
    axes=("y_0", "y_1", "y_2"),
)

# %% [markdown]
# **By reciprocal vectors.**  They are the rows $\mathbf y^i$ of $\mathbf Y^{-1}$: their products with the points are 1
# for equal indices, and 0 for any others.  The solution by Cramer's rule is the same.

# %%
r = Matrix(4, 4, sympy.symbols("r:4:4"))
reciprocal = given(r, inverse(Y))

section.identity(
    "1.2/mu",
    "the unknowns by inversion",
    printed=r * unit_point,
    where=reciprocal,
    derived=mu_of_points,
)
section.identity(
    "1.2/reciprocal",
    "scalar products of the points and the reciprocal vectors",
    printed=Matrix.eye(4),
    where=reciprocal,
    derived=Matrix(4, 4, lambda i, j: dot(inverse(Y).row(i), points[j])),
)
section.identity(
    "1.2.2",
    "the unknowns by reciprocal vectors",
    printed=vector(*(sum(r[i, j] * unit_point[j] for j in range(4)) for i in range(4))),
    where=reciprocal,
    derived=mu_of_points,
)

# %% [markdown]
# **Where is there no base?**  "Arbitrary" points have to be independent.  Each $\mu_i$ is a quotient of determinants:
# zero where the unit point is coplanar with the other three points.  Four unit vectors for the points keep the
# statement short; $\mathbf y_E$ are the coordinates of the unit point in them.

# %%
simple = given(Y, Matrix.eye(4))
section.vanishing(
    "1.2/beyond/base",
    "where the base is singular",
    printed=tuple(unit_point),
    derived=determinant(B.xreplace(solved).xreplace(simple)),
    note="'yE mus' at the margin may be the beginning of this restriction.",
)
for i in range(4):
    replaced = [unit_point if j == i else points[j] for j in range(4)]
    section.identity(
        f"1.2/beyond/mu{i}",
        f"the unknown mu{i} as a quotient of determinants",
        printed=over(determinant(columns(*replaced)), determinant(Y)),
        derived=dot(inverse(Y).row(i), unit_point),
    )

# %% [markdown]
# ## What are coordinates?
#
# **Definition.**  Any vector is a combination of the base vectors.

# %%
any_vector = vector(*sympy.symbols("v:4"))
x = vector(*sympy.symbols("x:4"))
coordinates = solve(B, any_vector)

section.identity(
    "1.2.3",
    "a vector by its coordinates in the base",
    printed=columns(sum((x[i] * base[i] for i in range(1, 4)), start=x[0] * base[0]), B * x),
    where=given(x, coordinates),
    derived=columns(any_vector, any_vector),
)
section.identity(
    "1.2/x",
    "the coordinates of a vector",
    printed=None,
    derived=coordinates,
    where=reciprocal,
    expect="illegible",
    corrected=vector(*(over(sum(r[i, j] * any_vector[j] for j in range(4)), mu[i]) for i in range(4))),
    note="The margin has 'x^i =' and the beginning of a sum, after 'where ... coord[inates] ... of B'.  What the sum "
    "equals is determined, for (1.2.3) has one solution.  In which letters it was printed is not: reconstructed with "
    "the reciprocal vectors y^i of (1.2.2), which the next lines of the margin name, divided by mu_i.",
)

# %% [markdown]
# **What is the unit point for?**  Its coordinates are $(1, 1, 1, 1)$, and those of the four points are multiples of the
# unit vectors.

# %%
section.identity(
    "1.2/beyond/unit-coordinates",
    "coordinates of the unit point and of the four points",
    printed=columns(vector(1, 1, 1, 1), inverse(Matrix.diag(*mu))),
    derived=columns(
        solve(B, unit_point).xreplace(solved).xreplace(simple),
        *(solve(B, point).xreplace(simple) for point in points),
    ),
)

# %% [markdown]
# ## How do affine coordinates come in?
#
# **Definition.**  With the base vectors as points, a point of the affine system with origin $\mathbf b_0$ and units
# $\mathbf b_i - \mathbf b_0$ is $\mathbf b_0 + \sum u_i (\mathbf b_i - \mathbf b_0)$.

# %%
u = vector(1, *sympy.symbols("u1 u2 u3"))


def affine_point(base: list[Matrix]) -> Matrix:
    b0, *others = base
    return sum((u[i] * (b - b0) for i, b in enumerate(others, start=1)), start=b0)


unit_vectors = [Matrix.eye(4).col(i) for i in range(4)]
linear, constant = linear_system(list(affine_point(unit_vectors)), list(u[1:, 0]))
U = columns(-constant, linear)
U_reconstructed = Matrix([[1, -1, -1, -1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])

section.identity(
    "1.2/U",
    "matrix of the affine coordinates",
    printed=None,
    derived=U,
    expect="illegible",
    corrected=U_reconstructed,
    note="The margin has 'U =', the product B U u and the column 1, u1, u2, u3, which agree with p = B U u in the "
    "paper of 1996, (1.1.4) there, for the plane.  In space U is this matrix, if u are affine coordinates in the same "
    "sense.",
)
section.identity(
    "1.2/BUu",
    "affine point, with base and matrix U",
    printed=None,
    derived=affine_point(base),
    expect="illegible",
    corrected=B * (U_reconstructed * u),
    note="'B U u =' survives, the other side is lost.  Derived is the affine point; the reading is that of 1.2/U.",
)

# %% [markdown]
# **And inhomogeneous ones?**  A homogeneous vector $\mathbf w$ has one multiple with a leading 1.

# %%
w = vector(*sympy.symbols("w:4"))
factor = sympy.Symbol("t")
scale = solve(*linear_system([factor * w[0] - 1], [factor]))[0]
section.identity(
    "1.2/w",
    "inhomogeneous coordinates of an image point",
    printed=None,
    derived=scale * w,
    expect="illegible",
    corrected=vector(1, w[1] / w[0], w[2] / w[0], w[3] / w[0]),
    note="The margin has w0, w0, w2, the end '= u3' and the divisor w0: w_i / w0 = u_i for i = 1, 2, 3, the only "
    "multiple of w that has a leading 1.",
)

# %% [markdown]
# **What cannot be restored:** the expression of $\mathbf w$ itself.  The line above it begins with 'In ordi', 'Image s'
# and 'by Its', which fits an image space, an image system and a matrix of its own base, with or without the matrix
# $\mathbf P$ of section 1.1; no sign of a formula survives that would decide between them.  The sentence with
# 'recipr', 'vector' and 'systerr' names the reciprocal vectors of (1.2.2); its predicate is lost.

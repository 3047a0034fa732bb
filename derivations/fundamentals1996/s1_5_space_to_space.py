# %% [markdown]
# # 1.5 Projection from space to space
#
# A matrix $\mathbf M^*$ with a last row of its own maps space to space.  How many points does it take to know it?  As
# before, both coordinate systems are referred to the basic points and to their images.  What remains are four factors
# $\mu_j$, and a fifth point fixes them.

# %%
import sympy
from sympy import ImmutableMatrix, MatrixSymbol

from algebroproj_derivations.cameras import inhomogeneous
from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.inserting import given
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    columns,
    determinant,
    dot,
    homogeneous,
    inverse,
    linear_system,
    over,
    solve,
    vector,
)
from algebroproj_sym.expressions.letters import Dot

section = Section("fundamentals1996", "1.5", "Projection from space to space, the regular projective transformation")

# %% [markdown]
# ## When is the matrix regular?
#
# **Definition.**  Below the three rows $[-\mathbf P^* \mathbf y_0 \;\; \mathbf P^*]$ of a projection to a plane,
# (1.1.6), now stands a general row $\mathbf m_3^T$ instead of zeros.

# %%
p = Matrix(3, 3, sympy.symbols("p:3:3"))
last_row = vector(*sympy.symbols("m30 m31 m32 m33"))
extended = columns(-p * center, p).col_join(last_row.T)
extended

# %% [markdown]
# **Print.**  The paper explains 'regular' by one component of the last row not being zero.  That is necessary.  It is
# not sufficient, not even where $\mathbf P^*$ is regular, as is required here.

# %%

section.identity(
    "1.5/regular#necessary",
    "with a last row of zeros the matrix is singular",
    printed=sympy.Integer(0),
    derived=determinant(extended),
    constraints=list(last_row),
)
section.identity(
    "1.5/regular",
    "the matrix is singular only with a last row of zeros",
    printed=Matrix.zeros(4, 1),
    derived=last_row,
    constraints=[determinant(extended)],
    nonzero=[determinant(p)],
    expect="false",
    instead="1.5/beyond/regular",
)

# %% [markdown]
# **What is true.**  The three upper rows map the center $\mathbf y_0$ alone to zero.  The last row makes the matrix
# regular exactly if it does not do the same: $\mathbf m_3^T \mathbf y_0 \neq 0$, with quasihomogeneous $\mathbf y_0$.

# %%
section.identity(
    "1.5/beyond/regular",
    "the last row must not map the center of projection to zero",
    printed=-determinant(p) * dot(last_row, homogeneous(center)),
    derived=determinant(extended),
)

# %% [markdown]
# ## The transformation
#
# **Definition.**  A regular matrix $\mathbf M^*$ with rows $\mathbf m_i^T$ maps the point $\mathbf y$, with a leading
# 1, to $\mu \mathbf u$.

# %%
m = sympy.symbols("m:4:4")
M_general = Matrix(4, 4, m)
point = vector(y1, y2, y3)
y = homogeneous(point)

section.identity("1.5.1", "regular projective transformation, row by row", derived=M_general * y)

# %% [markdown]
# ## The core
#
# **Definition.**  Object and image have unit points of the same coordinates, and $\mu_j \mathbf e'_j = \mathbf M^*
# \mathbf e_j$ for all four.  So the matrix is

# %%
units = columns(*(homogeneous(e) for e in (e0, e1, e2, e3)))
factors = (mu0, mu1, mu2, mu3)
images_of_units = columns(*(factor * units.col(j) for j, factor in enumerate(factors)))
M_star = images_of_units * inverse(units)
M_star

# %%

section.definition(
    "1.5/e",
    "quasihomogeneous unit points of both systems",
)
section.identity(
    "1.5/images",
    "images of the unit points",
    derived=M_star * units,
)
section.identity("1.5.2", "matrix of the regular projective transformation", derived=M_star)

# %% [markdown]
# **Meaning.**  It is the *core*.  Any regular matrix $\mathbf S$ takes this form as soon as both systems are referred
# to four points $\mathbf x_j$ and to their images $\mathbf s_j = \mathbf S \mathbf x_j$.  The factors are the first
# components of $\mathbf s_j$.

# %%
images = Matrix(4, 4, sympy.symbols("s:4:4"))
depths = [images[0, j] for j in range(4)]
image_points = [images.col(j).applyfunc(lambda entry, d=depth: over(entry, d)) for j, depth in enumerate(depths)]
image_system = columns(image_points[0], *(image_point - image_points[0] for image_point in image_points[1:]))

section.identity(
    "1.5/core",
    "every regular projective transformation has this form, referred to its basic points",
    printed=image_system * M_star,
    where=given(factors, depths),
    derived=columns(images.col(0), *(images.col(j) - images.col(0) for j in (1, 2, 3))),
)

# %% [markdown]
# It is singular exactly if one of the factors is zero.

# %%
section.vanishing(
    "1.5/beyond/det",
    "the core is singular exactly if one of the factors is zero",
    printed=factors,
    derived=determinant(M_star),
)

# %% [markdown]
# **An example.**  With $\mu = (1, 5/8, 3/4, 5/4)$ a cube goes over into this body.

# %%
EXAMPLE = given(factors, map(sympy.Rational, ("1", "5/8", "3/4", "5/4")))
BASIC = {"000": "G0", "100": "G1", "010": "G2", "001": "G3"}
vertices = {f"{i}{j}{k}": vector(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)}
edges = [(a, b) for a in vertices for b in vertices if a < b and sum(x != y for x, y in zip(a, b, strict=True)) == 1]


def mapped_vertex(vertex: Matrix) -> Matrix:
    seen = M_star.xreplace(EXAMPLE) * homogeneous(vertex)
    return (seen[1:, :] / seen[0]).doit()


SpaceDrawing(
    "A cube and its image, with primes.  The basic points G0 to G3 stay.  Planes remain planes, but parallel edges do "
    "not remain parallel.",
    {BASIC.get(name, name): vertex for name, vertex in vertices.items()}
    | {f"{name}'": mapped_vertex(vertex) for name, vertex in vertices.items() if name not in BASIC},
    segments=[(BASIC.get(a, a), BASIC.get(b, b)) for a, b in edges]
    + [(BASIC.get(a, f"{a}'"), BASIC.get(b, f"{b}'")) for a, b in edges],
)

# %% [markdown]
# ## The fifth point
#
# **How are the factors found?**  One more pair of points, $\mu_4 \mathbf u_4 = \mathbf M^* \mathbf y_4$, is a linear
# system for $\mu_0, \dots, \mu_3$.

# %%
mu4 = sympy.Symbol("mu4")
y41, y42, y43 = sympy.symbols("y41 y42 y43")
u41, u42, u43 = sympy.symbols("u41 u42 u43")
y40, u40 = 1 - y41 - y42 - y43, 1 - u41 - u42 - u43
fifth_point, fifth_image = vector(y41, y42, y43), vector(u41, u42, u43)

fifth_equations = M_star * homogeneous(fifth_point) - mu4 * homogeneous(fifth_image)
fifth_matrix, fifth_right_side = linear_system(list(fifth_equations), factors)
mu_of_fifth = solve(fifth_matrix, fifth_right_side)
mu_of_fifth

# %%
fitted = given(factors, mu_of_fifth)

section.identity(
    "1.5.3",
    "the solution maps the fifth point to its image",
    derived=M_star.xreplace(fitted) * homogeneous(fifth_point),
)

# %% [markdown]
# **Print.**  The paper leaves out the index 4 of the point in the solution; $y_0$ and $u_0$ are the barycentric
# coordinates that complete the others to 1.

# %%
y0, u0 = sympy.symbols("y0 u0")
of_fifth = {y0: y40, y1: y41, y2: y42, y3: y43, u0: u40, u1: u41, u2: u42, u3: u43}
section.identity(
    "1.5.4#mu0", "the first factor, in both forms", where=of_fifth, derived=vector(mu_of_fifth[0], mu_of_fifth[0])
)

# %%
section.identity("1.5.4#mu1", "the second factor", where=of_fifth, derived=mu_of_fifth[1])
section.identity("1.5.4#mu2", "the third factor", where=of_fifth, derived=mu_of_fifth[2])
section.identity("1.5.4#mu3", "the fourth factor", where=of_fifth, derived=mu_of_fifth[3])

# %% [markdown]
# The fifth point must not lie in a plane through three basic points: there the system is singular.

# %%
section.vanishing(
    "1.5/beyond/fifth-point",
    "the fifth point must not lie in a plane through three basic points",
    printed=(y40, y41, y42, y43),
    derived=determinant(fifth_matrix),
)

# %% [markdown]
# ## Points
#
# Where is the image of a point?  Its inhomogeneous coordinates are components divided by the first one.  The fourth
# factor cancels: it may have any value but zero.


# %%
section.identity(
    "1.5.5#rows",
    "image coordinates as quotients of rows",
    derived=inhomogeneous(M_general * y),
)
image = inhomogeneous(M_star * y)
section.identity("1.5.5", "image coordinates", derived=image)
section.identity(
    "1.5/mu4",
    "the image coordinates do not depend on the fourth factor",
    printed=image.xreplace({factor: value.subs(mu4, 1) for factor, value in fitted.items()}),
    derived=image.xreplace(fitted),
)

# %% [markdown]
# ## How many control points?
#
# In $V^n$ the matrix has $(n+1)^2$ elements, of which a common factor is free, and each point gives $n$ equations.
#
# Are they independent?  After $n+1$ unit points a further point determines the remaining factors if none of its $n+1$
# barycentric coordinates is zero: their product is the determinant.  This is shown for $n = 1$ to 4.

# %%
n = sympy.Symbol("n")
section.identity(
    "1.5/control-points",
    "number of control points in a space of n dimensions",
    derived=over((n + 1) ** 2 - 1, n),
)


def system_of_further_point(weights: tuple[sympy.Expr, ...]) -> Matrix:
    """Return the matrix of the system for the factors, given the barycentric coordinates of one further point."""
    unknowns = sympy.symbols(f"mu:{len(weights)}")
    size = len(weights)
    unit_points = [vector(1, *(int(i == j) for i in range(1, size))) for j in range(size)]
    mapped = sum(
        (w * unknown * unit for w, unknown, unit in zip(weights, unknowns, unit_points, strict=True)),
        Matrix.zeros(size, 1),
    )
    return linear_system(list(mapped), unknowns)[0]


def weights_in(dimension: int) -> tuple[sympy.Expr, ...]:
    coordinates = sympy.symbols(f"y1:{dimension + 1}")
    return (1 - sympy.Add(*coordinates), *coordinates)


section.identity(
    "1.5/beyond/control-points",
    "a further point determines the factors in spaces of one to four dimensions",
    printed=vector(*(sympy.Mul(*weights_in(dimension)) for dimension in (1, 2, 3, 4))),
    derived=vector(*(determinant(system_of_further_point(weights_in(dimension))) for dimension in (1, 2, 3, 4))),
)

# %% [markdown]
# ## Planes
#
# **Definition.**  A plane of the image space, $\mathbf a'^T \mathbf u = 0$, consists of the images of the points with
# $\mathbf a'^T \mathbf M^* \mathbf y = 0$.  The coefficients of this form are those of the plane in object space.
# The paper omits the factor $\mu$, as the form is to be zero.

# %%
a = vector(*sympy.symbols("a:4"))
a_image = vector(*sympy.symbols("ap:4"))
mapped = M_general * y


def coefficients(form: sympy.Expr, unknowns: tuple[sympy.Symbol, ...]) -> Matrix:
    """Return the coefficients of a linear form."""
    return linear_system([form], unknowns)[0].T


section.identity(
    "1.5/plane",
    "equation of a plane of the image space, in coordinates of the object space",
    derived=mapped[0] * dot(a_image, homogeneous(inhomogeneous(mapped))),
)
Y = sympy.symbols("Y:4")
section.identity(
    "1.5.6#column",
    "coefficients of a plane in object space from those in image space",
    derived=coefficients(dot(a_image, M_general * vector(*Y)), Y),
)

# %% [markdown]
# **And from object to image?**  Given $\mathbf a$, this is a linear system for $\mathbf a'$.  The print exchanges the
# primes: $\mathbf a^T = \mathbf a'^T \mathbf M^*$ is right, and so is $\mathbf a'^T = \mathbf a^T \mathbf M$.  The
# core for $\mathbf M^*$ keeps the solution short; what it refutes is refuted for $\mathbf M^*$ in general.

# %%
section.up_to_scale(
    "1.5.6",
    "coefficients of a plane in image space from those in object space",
    derived=solve(M_star.T, a),
    expect="misprint",
    corrected=inverse(M_star).T * a,
    note="Ruled out: rows for columns (the second relation and the display before fix them), M* for the inverse "
    "((1.5.7) calls that M), a factor (refuted up to scale).  The scan alone cannot tell a slip of the scan from "
    "one of the print.",
)

# %% [markdown]
# For a general matrix it is easier to start from its inverse $\mathbf M$.  $\mathbf y = \mu \mathbf M \mathbf u$,
# inserted in $\mathbf a^T \mathbf y$, gives a linear form in $\mathbf u$.

# %%
M_inverse = Matrix(4, 4, sympy.symbols("n:4:4"))
section.identity(
    "1.5.7",
    "coefficients of a plane in image space, by the inverse",
    derived=coefficients(dot(a, M_inverse * vector(*Y)), Y),
)

# %% [markdown]
# ## Quadrics
#
# The same substitution $\mathbf y = \mu \mathbf M \mathbf u$ in $\mathbf y^T \mathbf A \mathbf y$ gives a quadratic
# form in $\mathbf u$; the elements of its symmetric matrix are the values of the bilinear form at unit vectors.

# %%
A, M = MatrixSymbol("A", 4, 4), MatrixSymbol("M", 4, 4)
units = [ImmutableMatrix(sympy.eye(4)[:, i]) for i in range(4)]

section.identity(
    "1.5/conics",
    "symmetric matrix of the image of a quadric",
    derived=ImmutableMatrix(4, 4, lambda i, j: Dot(M * units[i], A * (M * units[j]))),
    properties={A: "symmetric"},
)

# %% [markdown]
# # 1.5 Projection from space to space
#
# With a last row of its own the matrix $\mathbf M^*$ (4 by 4) maps space to space.  As before, both coordinate systems
# are referred to the basic points and to their images, and what remains are four factors $\mu_j$; a fifth point fixes
# them.

# %%
import sympy

from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    columns,
    determinant,
    diff,
    dot,
    homogeneous,
    inverse,
    linear_system,
    over,
    solve,
    vector,
)

section = Section("fundamentals1996", "1.5", "Projection from space to space, the regular projective transformation")

# %% [markdown]
# ## When the matrix is regular
#
# Below the three rows $[-\mathbf P^* \mathbf y_0 \;\; \mathbf P^*]$ of a projection to a plane, (1.1.6), now stands a
# general row $\mathbf m_3^T$ instead of zeros.

# %%
p = Matrix(3, 3, sympy.symbols("p:3:3"))
last_row = vector(*sympy.symbols("m30 m31 m32 m33"))
extended = columns(-p * center, p).col_join(last_row.T)

section.identity(
    "1.5/regular#necessary",
    "with a last row of zeros the matrix is singular",
    printed=sympy.Integer(0),
    derived=determinant(extended),
    constraints=list(last_row),
    note="The half of the sentence that is true: if the matrix is regular, the last row is not zero.",
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
    note="The paper explains 'regular' by one component of the last row not being zero.  That is necessary "
    "(1.5/regular#necessary) but not sufficient, not even where P* is regular, as is required here.",
)

# %% [markdown]
# The three upper rows map the center $\mathbf y_0$ alone to zero.  The last row makes the matrix regular exactly if it
# does not do the same: $\mathbf m_3^T \mathbf y_0 \neq 0$, with quasihomogeneous $\mathbf y_0$.

# %%
section.identity(
    "1.5/beyond/regular",
    "the last row must not map the center of projection to zero",
    printed=-determinant(p) * dot(last_row, homogeneous(center)),
    derived=determinant(extended),
    note="Not in the paper: the condition that takes the place of 1.5/regular.",
)

# %% [markdown]
# ## The transformation
#
# A regular matrix $\mathbf M^*$ with rows $\mathbf m_i^T$ maps the point $\mathbf y$, with a leading 1, to
# $\mu \mathbf u$.

# %%
m = sympy.symbols("m:4:4")
M_general = Matrix(4, 4, m)
point = vector(y1, y2, y3)
y = homogeneous(point)

section.identity(
    "1.5.1",
    "regular projective transformation, row by row",
    printed=vector(*(m[4 * i] + m[4 * i + 1] * y1 + m[4 * i + 2] * y2 + m[4 * i + 3] * y3 for i in range(4))),
    derived=M_general * y,
)

# %% [markdown]
# ## The core
#
# Object and image have unit points of the same coordinates, and $\mu_j \mathbf e'_j = \mathbf M^* \mathbf e_j$ for all
# four.

# %%
units = columns(*(homogeneous(e) for e in (e0, e1, e2, e3)))
factors = (mu0, mu1, mu2, mu3)
images_of_units = columns(*(factor * units.col(j) for j, factor in enumerate(factors)))
M_star = images_of_units * inverse(units)

section.definition(
    "1.5/e",
    "quasihomogeneous unit points of both systems",
    printed=Matrix([[1, 0, 0, 0], [1, 1, 0, 0], [1, 0, 1, 0], [1, 0, 0, 1]]),
)
section.identity(
    "1.5/images",
    "images of the unit points",
    printed=columns(vector(mu0, 0, 0, 0), vector(mu1, mu1, 0, 0), vector(mu2, 0, mu2, 0), vector(mu3, 0, 0, mu3)),
    derived=M_star * units,
)
section.identity(
    "1.5.2",
    "matrix of the regular projective transformation",
    printed=Matrix([[mu0, mu1 - mu0, mu2 - mu0, mu3 - mu0], [0, mu1, 0, 0], [0, 0, mu2, 0], [0, 0, 0, mu3]]),
    derived=M_star,
)

# %% [markdown]
# It is the *core*: any regular matrix $\mathbf S$ takes this form as soon as both systems are referred to four points
# $\mathbf x_j$ and to their images $\mathbf s_j = \mathbf S \mathbf x_j$.  The factors are the first components of
# $\mathbf s_j$.

# %%
images = Matrix(4, 4, sympy.symbols("s:4:4"))
depths = [images[0, j] for j in range(4)]
image_points = [images.col(j).applyfunc(lambda entry, d=depth: over(entry, d)) for j, depth in enumerate(depths)]
image_system = columns(image_points[0], *(image_point - image_points[0] for image_point in image_points[1:]))

section.identity(
    "1.5/core",
    "every regular projective transformation has this form, referred to its basic points",
    printed=image_system * M_star,
    where=dict(zip(factors, depths, strict=True)),
    derived=columns(images.col(0), *(images.col(j) - images.col(0) for j in (1, 2, 3))),
    note="Both sides are the images of the affine unit vectors, in the coordinates of the image space.",
)
section.vanishing(
    "1.5/beyond/det",
    "the core is singular exactly if one of the factors is zero",
    printed=factors,
    derived=determinant(M_star),
    note="Not in the paper: the condition for the core, in place of one on its last row.",
)

# %% [markdown]
# ## The fifth point
#
# One more pair of points, $\mu_4 \mathbf u_4 = \mathbf M^* \mathbf y_4$, is a linear system for $\mu_0, \dots, \mu_3$.

# %%
mu4 = sympy.Symbol("mu4")
y41, y42, y43 = sympy.symbols("y41 y42 y43")
u41, u42, u43 = sympy.symbols("u41 u42 u43")
y40, u40 = 1 - y41 - y42 - y43, 1 - u41 - u42 - u43
fifth_point, fifth_image = vector(y41, y42, y43), vector(u41, u42, u43)

fifth_equations = M_star * homogeneous(fifth_point) - mu4 * homogeneous(fifth_image)
fifth_matrix, fifth_right_side = linear_system(list(fifth_equations), factors)
mu_of_fifth = solve(fifth_matrix, fifth_right_side)
fitted = dict(zip(factors, mu_of_fifth, strict=True))

section.identity(
    "1.5.3",
    "the solution maps the fifth point to its image",
    printed=mu4 * homogeneous(fifth_image),
    derived=M_star.xreplace(fitted) * homogeneous(fifth_point),
)

# %% [markdown]
# The paper leaves out the index 4 of the point in the solution; $y_0$ and $u_0$ are the barycentric coordinates that
# complete the others to 1.

# %%
y0, u0 = sympy.symbols("y0 u0")
of_fifth = {y0: y40, y1: y41, y2: y42, y3: y43, u0: u40, u1: u41, u2: u42, u3: u43}
section.identity(
    "1.5.4#mu0",
    "the first factor, in both forms",
    printed=vector(mu4 * (1 - u1 - u2 - u3) / (1 - y1 - y2 - y3), mu4 * u0 / y0),
    where=of_fifth,
    derived=vector(mu_of_fifth[0], mu_of_fifth[0]),
)
section.identity("1.5.4#mu1", "the second factor", printed=mu4 * u1 / y1, where=of_fifth, derived=mu_of_fifth[1])
section.identity("1.5.4#mu2", "the third factor", printed=mu4 * u2 / y2, where=of_fifth, derived=mu_of_fifth[2])
section.identity("1.5.4#mu3", "the fourth factor", printed=mu4 * u3 / y3, where=of_fifth, derived=mu_of_fifth[3])
section.vanishing(
    "1.5/beyond/fifth-point",
    "the fifth point must not lie in a plane through three basic points",
    printed=(y40, y41, y42, y43),
    derived=determinant(fifth_matrix),
    note="Not in the paper: where the system for the factors is singular.",
)

# %% [markdown]
# ## Points
#
# The inhomogeneous coordinates of the image are components divided by the first one.


# %%
def inhomogeneous(vector_: Matrix) -> Matrix:
    return vector(*(over(component, vector_[0]) for component in vector_[1:, 0]))


row_times_y = sympy.symbols("my:4")
section.identity(
    "1.5.5#rows",
    "image coordinates as quotients of rows",
    printed=vector(*(row_times_y[i] / row_times_y[0] for i in (1, 2, 3))),
    where={row_times_y[i]: dot(M_general.row(i), y) for i in range(4)},
    derived=inhomogeneous(M_general * y),
)
divisor = mu0 + (mu1 - mu0) * y1 + (mu2 - mu0) * y2 + (mu3 - mu0) * y3
image = inhomogeneous(M_star * y)
section.identity(
    "1.5.5",
    "image coordinates",
    printed=vector(mu1 * y1 / divisor, mu2 * y2 / divisor, mu3 * y3 / divisor),
    derived=image,
)
section.identity(
    "1.5/mu4",
    "the image coordinates do not depend on the fourth factor",
    printed=image.xreplace({factor: value.subs(mu4, 1) for factor, value in fitted.items()}),
    derived=image.xreplace(fitted),
    note="mu4 may have any value but zero: with mu4 and with 1 in its place the image is the same.",
)

# %% [markdown]
# ## How many control points
#
# In $V^n$ the matrix has $(n+1)^2$ elements, of which a common factor is free, and each point gives $n$ equations.
# That the equations are independent shows in the structure: after $n+1$ unit points a further point determines the
# remaining factors if none of its $n+1$ barycentric coordinates is zero.

# %%
n = sympy.Symbol("n")
section.identity(
    "1.5/control-points",
    "number of control points in a space of n dimensions",
    printed=n + 2,
    derived=over((n + 1) ** 2 - 1, n),
    note="The count of equations; 1.5/beyond/control-points shows for n = 1 to 4 that they are independent.",
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
    note="Not in the paper: the determinant of the system is the product of the barycentric coordinates.",
)

# %% [markdown]
# ## Planes
#
# A plane of the image space, $\mathbf a'^T \mathbf u = 0$, consists of the images of the points with
# $\mathbf a'^T \mathbf M^* \mathbf y = 0$: the coefficients of this form are those of the plane in object space.

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
    printed=dot(a_image, M_general * y),
    derived=mapped[0] * dot(a_image, homogeneous(inhomogeneous(mapped))),
    note="The paper omits the factor mu, which is the first component of the mapped point: the form is to be zero.",
)
Y = sympy.symbols("Y:4")
section.identity(
    "1.5.6#column",
    "coefficients of a plane in object space from those in image space",
    printed=M_general.T * a_image,
    derived=coefficients(dot(a_image, M_general * vector(*Y)), Y),
    note="The second of the two relations of (1.5.6).",
)

# %% [markdown]
# Given $\mathbf a$, this is a linear system for $\mathbf a'$; here with the core for $\mathbf M^*$, which keeps the
# solution short.

# %%
section.up_to_scale(
    "1.5.6",
    "coefficients of a plane in image space from those in object space",
    printed=M_star.T * a,
    derived=solve(M_star.T, a),
    expect="misprint",
    corrected=inverse(M_star).T * a,
    note="The first of the two relations prints a'^T = a^T M*.  The primes are exchanged: a^T = a'^T M* is the "
    "transpose of the second relation; solved for a' it is the corrected form, a'^T = a^T M.  Ruled out: rows for "
    "columns (the second relation and the display before fix them), M* for the inverse ((1.5.7) calls that M), a "
    "factor (refuted up to scale).  What the core refutes is refuted for M* in general, and (1.5.7) proves the "
    "corrected form for a general M.  The scan alone cannot tell a slip of the scan from one of the print.",
)

# %% [markdown]
# For a general matrix it is easier to start from its inverse $\mathbf M$: inserting
# $\mathbf y = \mu \mathbf M \mathbf u$ in $\mathbf a^T \mathbf y$ gives a linear form in $\mathbf u$.

# %%
M_inverse = Matrix(4, 4, sympy.symbols("n:4:4"))
section.identity(
    "1.5.7",
    "coefficients of a plane in image space, by the inverse",
    printed=M_inverse.T * a,
    derived=coefficients(dot(a, M_inverse * vector(*Y)), Y),
)

# %% [markdown]
# ## Quadrics
#
# The same substitution $\mathbf y = \mu \mathbf M \mathbf u$ in $\mathbf y^T \mathbf A \mathbf y$ gives a quadratic
# form in $\mathbf u$; the elements of its symmetric matrix are half its second derivatives.

# %%
A = Matrix(4, 4, lambda i, j: sympy.Symbol(f"a{min(i, j)}{max(i, j)}"))
substituted = M_inverse * vector(*Y)
quadratic_form = dot(substituted, A * substituted)

section.identity(
    "1.5/conics",
    "symmetric matrix of the image of a quadric",
    printed=M_inverse.T * A * M_inverse,
    derived=Matrix(4, 4, lambda i, j: diff(quadratic_form, Y[i], Y[j]) / 2),
)

# %% [markdown]
# ## Code
#
# The inverse of the core is a core with the factors $1/\mu_j$, therefore
# $a'_0 = a_0/\mu_0$ and $a'_j = (a_0 + a_j)/\mu_j - a_0/\mu_0$.

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

# %% [markdown]
# # 1.1 Projection from space to plane
#
# An image plane is given by the center of projection $\mathbf y_0$ and three points $\mathbf y_0 + \mathbf b_j$.
# Everything is affine: neither lengths nor angles occur.

# %%
import sympy

from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    adjugate,
    columns,
    cross,
    determinant,
    dot,
    homogeneous,
    inverse,
    linear_system,
    over,
    rows,
    solve,
    vector,
)

section = Section("fundamentals1996", "1.1", "Projection from space to plane")

# %% [markdown]
# ## The base
#
# The ray to a point $\mathbf y$ is $\mathbf z = \mathbf y - \mathbf y_0$.  Its coordinates $x^j$ refer to the base
# $\mathbf b_0, \mathbf b_1, \mathbf b_2$; the coefficients of the $x^j$ are the matrix $\mathbf B$.

# %%
point = vector(y1, y2, y3)
ray = point - center
base = [vector(*sympy.symbols(f"b{j}0 b{j}1 b{j}2")) for j in range(3)]
b0, b1, b2 = base
x = vector(*sympy.symbols("x0 x1 x2"))
reconstruction = x[0] * b0 + x[1] * b1 + x[2] * b2
B, _ = linear_system(list(reconstruction), list(x))

section.definition("1.1/z", "ray from the center to a point", printed=ray)
section.definition("1.1.1", "coordinates related to the base, equation of reconstruction", printed=reconstruction)
section.identity(
    "1.1.2",
    "matrix of the base",
    printed=Matrix([[b0[0], b0[1], b0[2]], [b0[1], b1[1], b2[1]], [b0[2], b1[2], b2[2]]]),
    derived=B,
    expect="misprint",
    corrected=columns(b0, b1, b2),
    note="The first row prints b00 b01 b02.  With the base vectors as rows the second row would have to read "
    "b10 b11 b12, with columns the first one b00 b10 b20: no convention gives the whole matrix, and the next display "
    "has it right, by columns.  The scan alone cannot tell a slip of the scan from one of the print.",
)

# %% [markdown]
# The coordinates of a given ray solve this system.  With $b^i_j$ for the elements of $\mathbf B^* = \mathbf B^{-1}$
# (row $i$, column $j$):

# %%
r = Matrix(3, 3, sympy.symbols("r:3:3"))
inverse_elements = dict(zip(r, inverse(B), strict=True))

section.identity(
    "1.1/projection",
    "equation of projection",
    printed=r * ray,
    where=inverse_elements,
    derived=solve(B, ray),
)
section.identity(
    "1.1/inverse",
    "inversion of the base",
    printed=r * columns(b0, b1, b2),
    where=inverse_elements,
    derived=E3,
    note="r10 stands for the element with upper index 1 and lower index 0.",
)

# %% [markdown]
# The rows of $\mathbf B^*$ are cross products, with $i, j, k$ cyclic: $\mathbf b^j$ is orthogonal to the other two
# base vectors, and $D = \det \mathbf B = \mathbf b_j \cdot (\mathbf b_k \times \mathbf b_i)$.

# %%
D = sympy.Symbol("D")
cyclic = [((j - 1) % 3, j, (j + 1) % 3) for j in range(3)]


def components(k: int, i: int) -> Matrix:
    bk, bi = base[k], base[i]
    return vector(bk[1] * bi[2] - bk[2] * bi[1], bk[2] * bi[0] - bk[0] * bi[2], bk[0] * bi[1] - bk[1] * bi[0])


section.identity(
    "1.1.3#components",
    "reciprocal vectors, by components",
    printed=rows(*((-1) ** i * components(k, i) / D for i, j, k in cyclic)),
    where={D: determinant(B)},
    derived=inverse(B),
    expect="error",
    corrected=rows(*(components(k, i) / D for i, j, k in cyclic)),
    note="The three vectors are compared as rows of one matrix.  The factor (-1)^i does not belong here: the cyclic "
    "order has taken care of the sign.  Taken modulo 3, i = 2, 0, 1 gives the signs + + -, not reduced, i = -1, 0, 1, "
    "it gives - + -; the signs proved are + + +.  The order of k and i and the handedness of the base are no way out, "
    "they change all three signs or none.  The two forms of (1.1.3) contradict each other, too: the sign is wrong "
    "in both, which no single slip of the press explains.",
    follows="The factor of the sign makes three of the nine elements of the inverse wrong, in either form. For "
    "cyclic indices there is no sign at all.",
)
section.identity(
    "1.1.3#cross",
    "reciprocal vectors, as cross products",
    printed=rows(*((-1) ** j * cross(base[k], base[i]) / D for i, j, k in cyclic)),
    where={D: determinant(B)},
    derived=inverse(B),
    expect="error",
    corrected=rows(*(cross(base[k], base[i]) / D for i, j, k in cyclic)),
    note="The second and the third form of (1.1.3).  The factor (-1)^j, that is + - +, belongs to the other two "
    "indices in ascending order, k < i, but the text says cyclic, i = j - 1 and k = j + 1; an interchange of k and i, "
    "or of rows and columns of B, changes all three signs or none.  The factor stands in both forms, which "
    "no single slip of the press explains.",
    same_as="1.1.3#components",
)

# %% [markdown]
# These *reciprocal vectors* give the coordinates by scalar products.

# %%
reciprocal = [cross(base[k], base[i]).applyfunc(lambda entry: over(entry, determinant(B))) for i, j, k in cyclic]

section.identity(
    "1.1/reciprocal",
    "scalar products of base and reciprocal vectors",
    printed=E3,
    derived=Matrix(3, 3, lambda j, k: dot(base[j], reciprocal[k])),
    note="All pairs at once: 1 for equal indices, 0 for any others.",
)
section.identity(
    "1.1/coordinates",
    "coordinates as scalar products",
    printed=vector(*(dot(r.row(j), ray) for j in range(3))),
    where=dict(zip(r, rows(*reciprocal), strict=True)),
    derived=solve(B, ray),
)

# %% [markdown]
# ## Change of base
#
# With a new base $\mathbf B' = \mathbf B \mathbf A$ the coordinates and the reciprocal vectors change by
# $\mathbf A^{-1}$: they are contravariant.  New coordinates are right if they reconstruct the same ray, new reciprocal
# vectors if they invert the new base.

# %%
A = Matrix(3, 3, sympy.symbols("a:3:3"))

section.identity(
    "1.1/contravariant",
    "the coordinates are contravariant",
    printed=(B * A) * solve(A, x),
    derived=reconstruction,
    note="The sentence, made precise: where the base vectors change by A, the coordinates of a fixed ray change by "
    "the inverse of A.",
)
section.identity(
    "1.1/contravariant-tensor",
    "the matrix of the reciprocal vectors is contravariant",
    printed=(inverse(A) * inverse(B)) * (B * A),
    derived=E3,
    note="The sentence, made precise: where the columns of B change by A, the rows of its inverse change by the "
    "inverse of A.",
)
section.identity(
    "1.1/cross-product",
    "cross product in affine coordinates",
    printed=adjugate(A).T * cross(b0, b1),
    derived=cross(A * b0, A * b1),
    note="The sentence, made precise: if the coordinates of two vectors change by any matrix A, their cross product "
    "changes by the matrix of cofactors, as the coefficients of a plane do.",
)

# %% [markdown]
# ## The image point
#
# The images $G'_0, G'_1, G'_2$ of the basic points are the origin and the unit points of an affine system of the
# image plane.

# %%
unit1, unit2 = b1 - b0, b2 - b0
u = vector(u1, u2)
p = b0 + u1 * unit1 + u2 * unit2

section.definition("1.1/e", "units of the image plane", printed=columns(unit1, unit2))
section.definition("1.1/u", "affine coordinates of an image point", printed=u1 * unit1 + u2 * unit2)
section.definition("1.1/quasihomogeneous", "quasihomogeneous vector of an image point", printed=homogeneous(u))
section.identity("1.1/p", "image point from the base", printed=(1 - u1 - u2) * b0 + u1 * b1 + u2 * b2, derived=p)
section.identity(
    "1.1/p#base", "image point, barycentric", printed=columns(b0, b1, b2) * vector(1 - u1 - u2, u1, u2), derived=p
)
section.identity(
    "1.1/p#U",
    "image point, affine",
    printed=columns(b0, b1, b2) * Matrix([[1, -1, -1], [0, 1, 0], [0, 0, 1]]) * vector(1, u1, u2),
    derived=p,
)

# %% [markdown]
# ## Projection
#
# The image point of $\mathbf y$ is where the ray meets the plane: $\tau \mathbf z = \mathbf p$ are three equations,
# linear in $u_1$, $u_2$ and $\tau = 1/\mu$.

# %%
factor, tau = sympy.symbols("mu tau")
intersection = solve(*linear_system(list(tau * ray - p), [tau, u1, u2]))
seen = {factor: over(1, intersection[0]), u1: intersection[1], u2: intersection[2]}

section.identity("1.1/ray", "the image point is on the ray", printed=factor * p, where=seen, derived=ray)
section.identity(
    "1.1/beyond/mu",
    "the factor is the sum of the coordinates",
    printed=x[0] + x[1] + x[2],
    where=dict(zip(x, solve(B, ray), strict=True)),
    derived=over(1, intersection[0]),
    note="Not in the paper: the factor vanishes exactly if the ray is parallel to the image plane.",
)
section.identity(
    "1.1.4",
    "equation of reconstruction",
    printed=factor * (columns(b0, b1, b2) * U * vector(1, u1, u2)),
    where=seen,
    derived=ray,
)
section.identity("1.1.4#P", "matrix of reconstruction", printed=columns(b0, b1 - b0, b2 - b0), derived=B * U)

# %% [markdown]
# $\mathbf P = \mathbf B \mathbf U$ takes the image point to the ray; its inverse
# $\mathbf P^* = \mathbf U^* \mathbf B^*$ takes the ray to the image point.

# %%
P = columns(b0, unit1, unit2)
P_star = inverse(P)

section.identity(
    "1.1.5",
    "equation of projection",
    printed=factor * vector(1, u1, u2),
    where=seen,
    derived=P_star * ray,
)
section.identity(
    "1.1.5#U*",
    "from barycentric to affine coordinates",
    printed=Matrix([[1, 1, 1], [0, 1, 0], [0, 0, 1]]) * x,
    derived=solve(U, x),
    note="The inverse of U, applied to any vector.",
)
section.identity(
    "1.1.5#P*",
    "structure of the matrix of projection",
    printed=Matrix(
        [
            [r[0, 0] + r[1, 0] + r[2, 0], r[0, 1] + r[1, 1] + r[2, 1], r[0, 2] + r[1, 2] + r[2, 2]],
            [r[1, 0], r[1, 1], r[1, 2]],
            [r[2, 0], r[2, 1], r[2, 2]],
        ]
    ),
    where=inverse_elements,
    derived=P_star,
)

# %% [markdown]
# ## The singular projective matrix
#
# $\mathbf P^* (\mathbf y - \mathbf y_0)$ is linear in the quasihomogeneous vector of $\mathbf y$.  With $p^i_j$ for the
# elements of $\mathbf P^*$ and a fourth row of zeros:

# %%
elements = Matrix(3, 3, sympy.symbols("p:3:3"))
linear, constant = linear_system(list(elements * ray), list(point))
M_star = columns(-constant, linear).col_join(Matrix.zeros(1, 4))

section.identity(
    "1.1.6",
    "singular projective matrix",
    printed=columns(-elements * center, elements).col_join(Matrix([[0, 0, 0, 0]])),
    derived=M_star,
)
section.identity(
    "1.1.6#equation",
    "equation of projection, quasihomogeneous",
    printed=factor * vector(1, u1, u2, 0),
    where=seen,
    derived=M_star.xreplace(dict(zip(elements, P_star, strict=True))) * homogeneous(point),
)
section.identity("1.1/singular", "the matrix is singular", printed=0, derived=determinant(M_star))
section.identity("1.1.7", "the center has no image", printed=vector(0, 0, 0, 0), derived=M_star * homogeneous(center))

# %% [markdown]
# Conversely the three equations $\mathbf M^* \mathbf y = \mathbf 0$ have the center as their only solution, where
# $\det \mathbf P^*$ is not zero.  With a finite center and a base it never is.

# %%
center_of_matrix = solve(*linear_system(list((M_star * homogeneous(point))[:3]), list(point)))

section.identity("1.1/center", "center of projection from the matrix", printed=center, derived=center_of_matrix)
section.identity(
    "1.1/beyond/determinant",
    "determinant of the matrix of projection",
    printed=1 / D,
    where={D: determinant(B)},
    derived=determinant(P_star),
    note="Not in the paper: the center follows uniquely from the matrix, whatever the base is.",
)

# %% [markdown]
# ## How general the definition is
#
# The usual definition of the image plane has a normal $\mathbf k$ and a distance $c$; with
# $\mathbf R = [\mathbf k, \mathbf i, \mathbf j]$ the ray $\mathbf R^T \mathbf z$ has the direction
# $(c, x - x_C, y - y_C)$, for a principal point $(x_C, y_C)$.  An unnormalised quaternion gives $\mathbf R$ but for a
# factor, which a matrix of projection does not notice.

# %%
c, x_center, y_center = sympy.symbols("c xC yC")
q0, q1, q2, q3 = quaternion = sympy.symbols("q:4")
rotation = Matrix(
    [
        [q0**2 + q1**2 - q2**2 - q3**2, 2 * (q1 * q2 - q0 * q3), 2 * (q1 * q3 + q0 * q2)],
        [2 * (q1 * q2 + q0 * q3), q0**2 - q1**2 + q2**2 - q3**2, 2 * (q2 * q3 - q0 * q1)],
        [2 * (q1 * q3 - q0 * q2), 2 * (q2 * q3 + q0 * q1), q0**2 - q1**2 - q2**2 + q3**2],
    ]
)


def projection_from(center: Matrix, matrix: Matrix) -> Matrix:
    return columns(-matrix * center, matrix)


def ratios(matrix: Matrix) -> Matrix:
    """Return the elements of a matrix divided by the first one: what a common factor leaves."""
    first, *others = matrix
    return vector(*(over(element, first) for element in others))


usual_projection = projection_from(center, Matrix([[1, 0, 0], [x_center, c, 0], [y_center, 0, c]]) * rotation.T)
usual_parameters = (*quaternion, c, x_center, y_center, *center)

section.count(
    "1.1/general",
    "center and base have eleven independent parameters",
    printed=11,
    derived=ratios(projection_from(center, adjugate(P))),
    variables=(*b0, *b1, *b2, *center),
    kernel=[vector(*b0, *b1, *b2, 0, 0, 0)],
    note="The sentence, made precise: the projective matrix, without its zero row and but for a common factor, has all "
    "of the eleven parameters that a matrix of this size can have.  The usual definition has nine: 1.1/general#usual.",
)
section.count(
    "1.1/general#usual",
    "center, normal, distance and principal point have nine independent parameters",
    printed=9,
    derived=ratios(usual_projection),
    variables=usual_parameters,
    kernel=[vector(*quaternion, *(0,) * 6)],
    note="Three each for the center, the rotation and the interior orientation.  With c = 1 and the principal point as "
    "origin there are six.",
)

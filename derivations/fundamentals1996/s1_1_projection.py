# %% [markdown]
# # 1.1 Projection from space to plane
#
# How is a point of space projected to a plane, and what can an image give back?  An image plane is given by the
# center of projection $\mathbf y_0$ and three points $\mathbf y_0 + \mathbf b_j$.  Everything is affine: neither
# lengths nor angles occur.

# %%
import sympy
from sympy import Identity, MatMul, MatrixSymbol

from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.inserting import given
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
from algebroproj_sym.expressions.letters import Adjugate, Cross

section = Section("fundamentals1996", "1.1", "Projection from space to plane")

# %% [markdown]
# ## The base
#
# **Definition.**  The ray to a point $\mathbf y$ is $\mathbf z = \mathbf y - \mathbf y_0$.  Its coordinates $x^j$
# refer to the base $\mathbf b_0, \mathbf b_1, \mathbf b_2$; the coefficients of the $x^j$ are the matrix $\mathbf B$.

# %%
point = vector(y1, y2, y3)
ray = point - center
base = [vector(*sympy.symbols(f"b{j}0 b{j}1 b{j}2")) for j in range(3)]
b0, b1, b2 = base
x = vector(*sympy.symbols("x0 x1 x2"))
reconstruction = x[0] * b0 + x[1] * b1 + x[2] * b2
B, _ = linear_system(list(reconstruction), list(x))
B

# %%

section.definition("1.1/z", "ray from the center to a point")
section.definition("1.1.1", "coordinates related to the base, equation of reconstruction")

# %% [markdown]
# **Print.**  The base vectors are the columns of $\mathbf B$.  In its first row the print has $b_{01}$ and $b_{02}$
# for $b_{10}$ and $b_{20}$.

# %%
section.identity(
    "1.1.2",
    "matrix of the base",
    derived=B,
    expect="misprint",
    corrected=columns(b0, b1, b2),
    note="Ruled out: with the base vectors as rows the second row would have to read b10 b11 b12.  The scan alone "
    "cannot tell a slip of the scan from one of the print.",
)

# %% [markdown]
# **How are the coordinates of a given ray found?**  They solve this system.  Let $b^i_j$ be the elements of $\mathbf
# B^* = \mathbf B^{-1}$, in row $i$ and column $j$.

# %%
r = Matrix(3, 3, sympy.symbols("r:3:3"))
inverse_elements = given(r, inverse(B))

section.identity("1.1/projection", "equation of projection", where=inverse_elements, derived=solve(B, ray))
section.identity("1.1/inverse", "inversion of the base", where=inverse_elements, derived=E3)

# %% [markdown]
# ## The reciprocal vectors
#
# **Definition.**  The rows $\mathbf b^j$ of $\mathbf B^*$.  Each is orthogonal to the other two base vectors.  So it
# is a cross product, $\mathbf b^j = \mathbf b_k \times \mathbf b_i / D$ for cyclic $i, j, k$, with $D = \det \mathbf
# B$.
#
# **Print.**  The paper gives a sign in addition: $(-1)^i$ by components, $(-1)^j$ for the cross product.  Such signs
# belong to indices in ascending order.  The cyclic order has taken care of them, and all three signs are $+$.

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
    note="Taken modulo 3, i = 2, 0, 1 gives the signs + + -; not reduced, i = -1, 0, 1 gives - + -.  Ruled out: the "
    "order of k and i, the handedness of the base, and rows for columns change all three signs or none.  The "
    "sign is wrong in both forms of (1.1.3), which no single slip of the press explains.",
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
    note="The factor (-1)^j, that is + - +, would be right for k < i, but the text says cyclic, i = j - 1 and k = j + "
    "1.",
    same_as="1.1.3#components",
)

# %% [markdown]
# **Meaning.**  The reciprocal vectors give the coordinates by scalar products.

# %%
reciprocal = [cross(base[k], base[i]).applyfunc(lambda entry: over(entry, determinant(B))) for i, j, k in cyclic]

section.identity(
    "1.1/reciprocal",
    "scalar products of base and reciprocal vectors",
    printed=E3,
    derived=Matrix(3, 3, lambda j, k: dot(base[j], reciprocal[k])),
)
section.identity(
    "1.1/coordinates",
    "coordinates as scalar products",
    where=given(r, rows(*reciprocal)),
    derived=solve(B, ray),
)

# %% [markdown]
# ## Change of base
#
# What happens to a fixed ray if the base changes to $\mathbf B' = \mathbf B \mathbf A$?  The paper says that
# coordinates and reciprocal vectors are contravariant: they change by $\mathbf A^{-1}$.  New coordinates are right if
# they reconstruct the same ray, new reciprocal vectors if they invert the new base.

# %%
A, B_bold = MatrixSymbol("A", 3, 3), MatrixSymbol("B", 3, 3)
x_bold, *base_bold = (MatrixSymbol(name, 3, 1) for name in ("x", "b0", "b1", "b2"))

section.identity(
    "1.1/contravariant",
    "the coordinates are contravariant",
    printed=MatMul(B_bold * A, A.I * x_bold),
    derived=B_bold * x_bold,
)
section.identity(
    "1.1/contravariant-tensor",
    "the matrix of the reciprocal vectors is contravariant",
    printed=MatMul(A.I * B_bold.I, B_bold * A),
    derived=Identity(3),
)

# %% [markdown]
# A cross product is neither.  If two vectors change by $\mathbf A$, theirs changes by the matrix of cofactors, as the
# coefficients of a plane do.

# %%
section.identity(
    "1.1/cross-product",
    "cross product in affine coordinates",
    printed=Adjugate(A).T * Cross(*base_bold[:2]),
    derived=Cross(A * base_bold[0], A * base_bold[1]),
)

# %% [markdown]
# ## The image point
#
# **Definition.**  The images $G'_0, G'_1, G'_2$ of the basic points are the origin and the unit points of an affine
# system of the image plane.

# %%
unit1, unit2 = b1 - b0, b2 - b0
u = vector(u1, u2)
p = b0 + u1 * unit1 + u2 * unit2

section.definition("1.1/e", "units of the image plane")
section.definition("1.1/u", "affine coordinates of an image point")
section.definition("1.1/quasihomogeneous", "quasihomogeneous vector of an image point", printed=homogeneous(u))

# %% [markdown]
# **Print.**  The same point as a weighted mean of the base vectors, and as a product of matrices.

# %%
origin, *others = base_bold
section.identity(
    "1.1/p",
    "image point from the base",
    derived=origin + u1 * (others[0] - origin) + u2 * (others[1] - origin),
)
section.identity("1.1/p#base", "image point, barycentric", derived=p)
section.identity("1.1/p#U", "image point, affine", derived=p)

# %% [markdown]
# ## Projection
#
# **Definition.**  The image point of $\mathbf y$ is where the ray meets the plane.  $\tau \mathbf z = \mathbf p$ are
# three equations, linear in $u_1$, $u_2$ and $\tau = 1/\mu$.

# %%
factor, tau = sympy.symbols("mu tau")
intersection = solve(*linear_system(list(tau * ray - p), [tau, u1, u2]))
seen = {factor: over(1, intersection[0]), u1: intersection[1], u2: intersection[2]}

section.identity("1.1/ray", "the image point is on the ray", where=seen, derived=ray)

# %% [markdown]
# **What is the factor?**  The sum of the coordinates of the ray.  It vanishes exactly if the ray is parallel to the
# image plane.

# %%
section.identity(
    "1.1/beyond/mu",
    "the factor is the sum of the coordinates",
    printed=x[0] + x[1] + x[2],
    where=given(x, solve(B, ray)),
    derived=over(1, intersection[0]),
)

# %% [markdown]
# **Print.**  So the ray is reconstructed from its image point, but for the factor that the image has lost.

# %%
section.identity("1.1.4", "equation of reconstruction", where=seen, derived=ray)
section.identity("1.1.4#P", "matrix of reconstruction", derived=B * U)

# %% [markdown]
# **An example.**  This base sees the point $(2, 2, 4)$ at the affine image coordinates

# %%
EXAMPLE_BASE = [vector(1, -1, 1), vector(-1, 1, 1), vector(2, 2, 1)]
SEEN = vector(2, 2, 4)
numbers = given((*b0, *b1, *b2, *point, *center), (*columns(*EXAMPLE_BASE).T, *SEEN, 0, 0, 0))
example_image = intersection[1:, :].xreplace(numbers).doit()
example_image

# %%
SpaceDrawing(
    "The center C, the base vectors to G'0, G'1 and G'2, and a ray to a point P.  It meets the image plane in p.",
    {"C": vector(0, 0, 0), "P": SEEN, "p": p.xreplace(numbers | given(u, example_image))}
    | {f"G'{j}": corner for j, corner in enumerate(EXAMPLE_BASE)},
    segments=[("C", "P"), *(("C", f"G'{j}") for j in range(3))],
    triangles=[("G'0", "G'1", "G'2")],
)

# %% [markdown]
# ## Both directions
#
# $\mathbf P = \mathbf B \mathbf U$ takes the image point to the ray.  Its inverse $\mathbf P^* = \mathbf U^* \mathbf
# B^*$ takes the ray to the image point.

# %%
P = columns(b0, unit1, unit2)
P_star = inverse(P)

section.identity("1.1.5", "equation of projection", where=seen, derived=P_star * ray)
section.identity(
    "1.1.5#U*",
    "from barycentric to affine coordinates",
    derived=inverse(U),
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
# **Definition.**  $\mathbf P^* (\mathbf y - \mathbf y_0)$ is linear in the quasihomogeneous vector of $\mathbf y$.
# Its matrix, with a fourth row of zeros, is $\mathbf M^*$:

# %%
elements = Matrix(3, 3, sympy.symbols("p:3:3"))
linear, constant = linear_system(list(elements * ray), list(point))
M_star = columns(-constant, linear).col_join(Matrix.zeros(1, 4))
M_star

# %%

section.identity("1.1.6", "singular projective matrix", derived=M_star)
section.identity(
    "1.1.6#equation",
    "equation of projection, quasihomogeneous",
    where=seen,
    derived=M_star.xreplace(given(elements, P_star)) * homogeneous(point),
)

# %% [markdown]
# **Meaning.**  $\mathbf M^*$ is singular, and takes the center to zero: the center has no image.

# %%
section.identity("1.1/singular", "the matrix is singular", printed=0, derived=determinant(M_star))
section.identity("1.1.7", "the center has no image", derived=M_star * homogeneous(center))

# %% [markdown]
# Is the center the only such point?  The three equations $\mathbf M^* \mathbf y = \mathbf 0$ have no other solution
# where $\det \mathbf P^*$ is not zero.  It is $1 / D$: with a finite center and a base it never vanishes.

# %%
center_of_matrix = solve(*linear_system(list((M_star * homogeneous(point))[:3]), list(point)))

section.identity("1.1/center", "center of projection from the matrix", printed=center, derived=center_of_matrix)
section.identity(
    "1.1/beyond/determinant",
    "determinant of the matrix of projection",
    printed=1 / D,
    where={D: determinant(B)},
    derived=determinant(P_star),
)

# %% [markdown]
# ## How general the definition is
#
# The usual definition of the image plane has a normal $\mathbf k$ and a distance $c$.  With
# $\mathbf R = [\mathbf k, \mathbf i, \mathbf j]$ the ray $\mathbf R^T \mathbf z$ has the direction
# $(c, x - x_C, y - y_C)$, for a principal point $(x_C, y_C)$.  An unnormalised quaternion gives $\mathbf R$ but for a
# factor, which a matrix of projection does not notice.  What is more general about center and base?

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

# %% [markdown]
# **The count.**  The projective matrix has twelve elements and a free factor.  Center and base have all of the eleven
# parameters.  The usual definition has nine: three each for the center, the rotation and the interior orientation.

# %%
section.count(
    "1.1/general",
    "center and base have eleven independent parameters",
    printed=11,
    derived=ratios(projection_from(center, adjugate(P))),
    variables=(*b0, *b1, *b2, *center),
    kernel=[vector(*b0, *b1, *b2, 0, 0, 0)],
)
section.count(
    "1.1/general#usual",
    "center, normal, distance and principal point have nine independent parameters",
    printed=9,
    derived=ratios(usual_projection),
    variables=usual_parameters,
    kernel=[vector(*quaternion, *(0,) * 6)],
)

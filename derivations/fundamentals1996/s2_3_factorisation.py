# %% [markdown]
# # 2.3 Critical situations: what is true
#
# When exactly do the five equations fail?  Their determinant is a product.  One factor vanishes where the element that
# the equations are divided by does.  The other one vanishes where ten points lie on a quadric, of any type.  Are the
# images themselves ambiguous then, or is it the linear equations alone that fail?  The sign of one determinant tells.
# None of this is in the paper.

# %%
from itertools import combinations

import sympy

from algebroproj_derivations.figures import QuadricDrawing
from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s2_2_correlation import differences, q2
from algebroproj_derivations.fundamentals1996.s2_3_critical_situations import (
    C0,
    GENERAL,
    D,
    M_left,
    M_right,
    basic_points,
    center_left,
    center_right,
    dependence,
    diagonal,
    equations,
    forms_at,
    homologous,
    in_space,
    minors_of,
    monomials,
    mup1,
    mup2,
    mup3,
    mupp1,
    mupp2,
    mupp3,
    named,
    on_quadric,
    points_on,
    quadric,
    six_forms,
    up32,
    upp32,
)
from algebroproj_derivations.inserting import given
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, adjugate, columns, determinant, dot, homogeneous, over, vector

section = Section("fundamentals1996", "2.3", "Critical situations: what is true")

# %% [markdown]
# ## Quadrics through the basic points
#
# **Definition.**  A quadric has ten coefficients, one for each product of two homogeneous coordinates $h_i h_j$.
# $G_0$, $G_1$ and $G_2$ impose three independent conditions.  Seven products that vanish there remain, the row
# $\mathbf q(\mathbf h)$:

# %%
any_point = vector(*sympy.symbols("h0:4"))


def seven_products(y: Matrix) -> Matrix:
    h0, h1, h2, h3 = y
    return Matrix([[h1 * (h1 - h0), h2 * (h2 - h0), h3 * h3, h0 * h3, h1 * h2, h1 * h3, h2 * h3]])


seven_products(any_point)

# %% [markdown]
# The seven products are the kernel of the three conditions.

# %%
section.rank(
    "2.3/beyond/basic-conditions",
    "the basic points impose three conditions on a quadric",
    printed=3,
    derived=Matrix.vstack(*map(monomials, basic_points)),
    kernel=[
        Matrix(10, 1, [sympy.Poly(product, *any_point).coeff_monomial(one) for one in monomials(any_point)])
        for product in seven_products(any_point)
    ],
)

# %% [markdown]
# The equations for all six elements are quadrics of this kind: their forms are $\mathbf q(\mathbf h) \mathbf W$, with
# a matrix $\mathbf W$ of the cameras alone.  All six vanish at both centers.


# %%
def coefficients(form: sympy.Expr) -> Matrix:
    """Return the coefficients of a quadratic form that vanishes at the basic points."""
    h0, h1, h2, h3 = any_point
    polynomial = sympy.Poly(form, *any_point)
    leading = (h1**2, h2**2, h3**2, h0 * h3, h1 * h2, h1 * h3, h2 * h3)
    return vector(*(polynomial.coeff_monomial(product) for product in leading))


forms = six_forms.xreplace(homologous(any_point))
W = columns(*map(coefficients, forms))
section.identity(
    "2.3/beyond/forms",
    "the six forms in terms of the seven products",
    printed=seven_products(any_point) * W,
    derived=forms,
)
base = Matrix.vstack(seven_products(center_left), seven_products(center_right))
section.identity(
    "2.3/beyond/base",
    "all six forms vanish at both centers",
    printed=Matrix.zeros(2, 6),
    derived=base * W,
)

# %% [markdown]
# **How many quadrics are these?**  Not six.  The true matrix of correlation $\mathbf C_0$ gives the zero form, as
# $\mathbf M'^T \mathbf C_0 \mathbf M''$ is skew-symmetric.

# %%
skew = M_left.T * C0 * M_right
elements = vector(*(C0[i, j] for i, j in ((1, 1), (1, 2), (2, 0), (2, 1), (2, 2), (1, 0))))
section.identity(
    "2.3/beyond/skew",
    "the true matrix of correlation gives no quadric",
    printed=Matrix.zeros(4, 4),
    derived=skew + skew.T,
)

# %% [markdown]
# **Meaning.**  Five of ten dimensions remain.  As many quadrics go through the three basic points and both centers.
# So the equations know all of these, and nothing else.

# %%
section.rank(
    "2.3/beyond/forms-rank",
    "the quadrics through the centers and the basic points",
    printed=5,
    derived=W,
    kernel=[elements],
)
section.identity(
    "2.3/beyond/skew#singular",
    "the true matrix of correlation is singular",
    printed=0,
    derived=determinant(C0),
)

# %% [markdown]
# ## The determinant is a product
#
# **Claim.**  $\mu'_1 \mu'_2 \mu''_1 \mu''_2 \det \mathbf A_5 = c_{10}\, T$, with the denominators of $\mathbf A_5$
# cleared.  $T$ is a determinant of ten points: both centers, $G_0, G_1, G_2$ and the points 3 to 7.  It is zero
# exactly if they lie on a quadric.
#
# **Proof.**  The equations of five points are $\mathbf V \mathbf W$, with the seven products of each point in a row of
# $\mathbf V$.  Let $S$ be five of the seven products, and $\mathbf V_S$, $\mathbf W_S$ the columns and rows that belong
# to them.  By Cauchy and Binet $\det \mathbf V \mathbf W$ is the sum of $\det \mathbf V_S \det \mathbf W_S$ over the 21
# sets $S$.  By Laplace $T$ is the sum of $\pm \det \mathbf V_S$ times the minor of the centers with the two other
# products.  The two sums agree term by term, wherever the points are.

# %%
FIVES = list(combinations(range(7), 5))
scale = mup1 * mup2 * mupp1 * mupp2


def minor_of_centers(five: tuple[int, ...]) -> sympy.Expr:
    """Return the signed minor of the centers that belongs to five products in the expansion by Laplace."""
    two = [product for product in range(7) if product not in five]
    return (-1) ** (sum(two) + 1) * determinant(base[:, two])


def minor_of_forms(five: tuple[int, ...], skipped: int) -> sympy.Expr:
    return determinant(W[list(five), [column for column in range(6) if column != skipped]])


def is_product(number: str, title: str, skipped: int) -> None:
    section.identity(
        number,
        title,
        printed=(-1) ** (skipped + 1) * elements[skipped] * vector(*map(minor_of_centers, FIVES)),
        derived=scale * vector(*(minor_of_forms(five, skipped) for five in FIVES)),
    )


is_product("2.3/beyond/theorem", "the determinant of the five equations is a product", skipped=5)

# %% [markdown]
# **Would another divisor help?**  With $c_{11}$ or any other element in the place of $c_{10}$ the same is true.  On a
# quadric all six minors vanish, and no choice of the divisor helps.

# %%
for skipped, element in enumerate(("c11", "c12", "c20", "c21", "c22")):
    is_product(f"2.3/beyond/theorem#{element}", f"the determinant after division by {element} is a product", skipped)

# %% [markdown]
# ## The other factors
#
# When is $c_{10} = 0$?  Where the centers are coplanar with $G_0$ and $G_1$.

# %%
section.vanishing(
    "2.3/beyond/divisor",
    "where c10 vanishes",
    printed=(mupp1, q2),
    where=differences,
    derived=elements[5],
)
section.vanishing(
    "2.3/beyond/divisor#plane",
    "where the centers, G0 and G1 are coplanar",
    printed=(mup1, mupp1, q2),
    where=differences,
    derived=determinant(columns(center_left, center_right, *basic_points[:2])),
)

# %% [markdown]
# The base may be parallel to the line from $G_0$ to $G_1$, for instance, as in a raster that is aligned with it.

# %%
distance = sympy.Symbol("distance")
section.identity(
    "2.3/beyond/divisor#parallel",
    "the base is parallel to the line from G0 to G1",
    printed=0,
    derived=determinant(columns(homogeneous(center), homogeneous(center + distance * e1), *basic_points[:2])),
)

# %% [markdown]
# **Meaning.**  This is a fault of the normalisation alone.  $\mathbf C_0$ cannot be divided by this element, but the
# six homogeneous equations still determine it.

# %%
coplanar = {upp32: over(mupp2 * mup3 * up32, mup2 * mupp3)}
six_rows = Matrix.vstack(*(six_forms.xreplace(homologous(in_space(k))) for k in GENERAL)).xreplace(coplanar)
section.rank(
    "2.3/beyond/normalisation",
    "rank of the six equations where c10 vanishes",
    printed=5,
    derived=six_rows,
    kernel=[elements.xreplace(coplanar)],
)
section.rank(
    "2.3/beyond/normalisation#A5",
    "rank of the five equations where c10 vanishes",
    printed=4,
    derived=six_rows[:, :5],
    kernel=[elements[:5, :].xreplace(coplanar)],
)

# %% [markdown]
# The factors $\mu_1$ and $\mu_2$ vanish where a center coincides with a basic point.

# %%
for index, (parameter, basic_point) in enumerate(((mup1, e1), (mup2, e2)), start=1):
    section.up_to_scale(
        f"2.3/beyond/mu#{index}",
        f"the center for mu{index} = 0",
        printed=homogeneous(basic_point),
        derived=center_left.xreplace({parameter: sympy.Integer(0)}),
    )

# %% [markdown]
# ## Linear failure and true ambiguity
#
# Where the equations fail, another solution $\mathbf C_1$ spans a pencil of solutions with $\mathbf C_0$, and
# $\mathbf M'^T \mathbf C_1 \mathbf M''$ gives the quadric.  But a matrix of correlation must be singular.  Which
# members of the pencil are?  The determinant of $\mathbf C_1 + t \mathbf C_0$ is of second degree in $t$ only, as
# $\mathbf C_0$ is singular itself.

# %%
t = sympy.Symbol("t")
C1 = Matrix(3, 3, sympy.symbols("c:3:3"))


def mixed(a: Matrix, b: Matrix) -> sympy.Expr:
    """Return the derivative of the determinant of a in the direction b."""
    return (adjugate(a) * b).trace()


lowest, linear, quadratic = determinant(C1), mixed(C1, C0), mixed(C0, C1)
section.identity(
    "2.3/beyond/pencil",
    "the determinant of a pencil of solutions",
    printed=lowest + t * linear + t**2 * quadratic,
    derived=determinant(C1 + t * C0),
)

# %% [markdown]
# Its discriminant is the determinant of the quadric, here of $2 \mathbf Q$, for any matrix $\mathbf C_1$.

# %%
double_quadric = M_left.T * C1 * M_right + (M_left.T * C1 * M_right).T
section.identity(
    "2.3/beyond/discriminant",
    "the discriminant of the pencil is the determinant of the quadric",
    printed=determinant(double_quadric),
    derived=linear**2 - 4 * lowest * quadratic,
)

# %% [markdown]
# **Meaning.**  The sign of $\det 2 \mathbf Q$ tells the quadrics that carry two families of real lines from those
# with none.
#
# * $\det 2 \mathbf Q > 0$: one-sheeted hyperboloids, hyperbolic paraboloids.  There are two other singular matrices,
#   and the images are ambiguous.
# * $\det 2 \mathbf Q < 0$: ellipsoids, two-sheeted hyperboloids, elliptic paraboloids.  There is no other real one.
#   The linear method alone fails, and $\det \mathbf C = 0$ still selects the true solution.
# * $\det 2 \mathbf Q = 0$: cones, cylinders, pairs of planes.  There is a double one.  For a pair of planes it may
#   have rank 1, and then is no matrix of correlation.

# %%
hyperboloid = diagonal(1, 1, -1)
QuadricDrawing(
    "Both centers, the basic points and the points P3 to P7 on a hyperboloid of one sheet, which two families of lines "
    "cover.  Here the images themselves are ambiguous: nothing in them tells the true correlation from two others.",
    hyperboloid,
    named([y[1:, :] for y in points_on(hyperboloid)]),
)

# %% [markdown]
# So the ruled quadrics are those on which the images are ambiguous, as Krames and Wunderlich found for relative
# orientation.
#
# ## Invariants of a quadric
#
# How can one tell of which type a quadric is?  A symmetric matrix has real eigenvalues.  By the rule of Descartes the
# signs of the coefficients of its characteristic polynomial count the positive and the negative ones exactly: rank and
# signature.  Those of the matrix and of its block at infinity, the conic at infinity, are the affine type.

# %%
Q = Matrix(4, 4, sympy.symbols("q:4:4"))
symmetric = Matrix(4, 4, lambda i, j: Q[min(i, j), max(i, j)])
at_infinity = symmetric[1:, 1:]


def characteristic(matrix: Matrix) -> Matrix:
    """Return the coefficients of the characteristic polynomial below the leading one: sums of principal minors."""
    size = matrix.shape[0]
    return vector(
        *(
            (-1) ** order
            * sum(determinant(matrix[list(chosen), list(chosen)]) for chosen in combinations(range(size), order))
            for order in range(1, size + 1)
        )
    )


for name, matrix in (("whole", symmetric), ("at-infinity", at_infinity)):
    size = matrix.shape[0]
    section.identity(
        f"2.3/beyond/invariants#{name}",
        "the characteristic polynomial",
        printed=t**size + dot(characteristic(matrix), vector(*(t ** (size - k) for k in range(1, size + 1)))),
        derived=determinant(t * Matrix.eye(size) - matrix),
    )

# %% [markdown]
# Do they depend on the coordinates?  Both matrices change by congruence, and the law of inertia says that rank and
# signature stay.

# %%
affine = Matrix(3, 3, sympy.symbols("a:3:3"))
change = columns(homogeneous(vector(*sympy.symbols("b1:4"))), Matrix.zeros(1, 3).col_join(affine))
section.identity(
    "2.3/beyond/invariants#affine",
    "the block at infinity in other affine coordinates",
    printed=affine.T * at_infinity * affine,
    derived=(change.T * symmetric * change)[1:, 1:],
)

# %% [markdown]
# ## Every type of quadric is critical
#
# The paper names hyperbolic paraboloid, cone and cylinder.  For each type here are two regular cameras with their
# centers on such a quadric, and five points of it, $G_3$ first.  The basic points lie on all of them.  The rank is 4,
# and the quadric that the minors of four points give is the one that was chosen.  The invariants are the coefficients
# of the characteristic polynomials below the leading 1.  The fourth one is the determinant.

# %%
ELLIPTIC_PARABOLOID = Matrix([[0, -1, -1, -1], [-1, 2, 0, -2], [-1, 0, 2, 0], [-1, -2, 0, 2]])
HYPERBOLIC_PARABOLOID = Matrix([[0, -1, 2, -1], [-1, 2, 0, -2], [2, 0, -4, 0], [-1, -2, 0, 2]])
PARABOLIC_CYLINDER = Matrix([[0, -1, -1, -4], [-1, 2, 2, 4], [-1, 2, 2, 4], [-4, 4, 4, 8]])
TYPES = {
    "beyond/critical/ellipsoid": (diagonal(1, 1, 1), (-6, 9, 4, -12), (-6, 12, -8)),
    "beyond/critical/two-sheets": (diagonal(1, 1, -3), (2, -31, 52, -12), (2, -20, 24)),
    "beyond/critical/elliptic-paraboloid": (ELLIPTIC_PARABOLOID, (-6, 5, 16, -16), (-6, 8, 0)),
    "beyond/critical/one-sheet": (diagonal(1, 1, -1), (-2, -7, 12, 4), (-2, -4, 8)),
    "critical/hyperbolic-paraboloid": (HYPERBOLIC_PARABOLOID, (0, -22, 16, 32), (0, -16, 0)),
    "critical/cone": (diagonal(1, 1, -2), (0, -18, 28, 0), (0, -12, 16)),
    "critical/elliptic-cylinder": (diagonal(0, 1, 1), (-4, 2, 4, 0), (-4, 4, 0)),
    "beyond/critical/hyperbolic-cylinder": (diagonal(0, 1, -3), (4, -22, 12, 0), (4, -12, 0)),
    "beyond/critical/parabolic-cylinder": (PARABOLIC_CYLINDER, (-12, -18, 16, 0), (-12, 0, 0)),
}
for slug, (chosen, whole, infinite) in TYPES.items():
    name = slug.rpartition("/")[2].replace("-", " ")
    camera_left, camera_right, points = on_quadric(chosen)
    numbers = equations(camera_left, camera_right, points)
    section.rank(
        f"2.3/{slug}#rank",
        f"rank of the five equations, {name}",
        printed=4,
        derived=numbers,
        kernel=[dependence(numbers)],
    )
    section.up_to_scale(
        f"2.3/{slug}#surface",
        f"the critical surface of four of the points, {name}",
        printed=chosen,
        derived=quadric(camera_left, camera_right).xreplace(given(D, minors_of(numbers[:4, :]))),
    )
    section.identity(
        f"2.3/{slug}#type",
        f"invariants, {name}",
        printed=vector(*whole, *infinite),
        derived=vector(*characteristic(chosen), *characteristic(chosen[1:, 1:])),
    )

# %% [markdown]
# Pairs of planes are critical as well, 2.3/gruber.  On the sphere, the determinant as a function of the last point has
# no linear factor: the determinant of ten points does not split any further.

# %%
camera_left, camera_right, points = on_quadric(diagonal(1, 1, 1))
section.vanishing(
    "2.3/beyond/irreducible",
    "the determinant for two cameras and four points on a sphere",
    printed=(y1**2 + y2**2 + y3**2 - y1 - y2 - y3,),
    derived=determinant(equations(camera_left, camera_right, [*points[:4], homogeneous(vector(y1, y2, y3))])),
)

# %% [markdown]
# ## The vertices of a parallelepiped
#
# Which points should one avoid?  Through the vertices of a cube there are three independent quadrics, $y_j^2 = y_j$.
# The two centers impose two more conditions, and one quadric is left.  So eight points in the vertices of a
# parallelepiped are critical for *all* cameras.  Two congruent squares of points in two levels are such a raster.

# %%
vertices = [vector(0, 0, 1), vector(1, 1, 0), vector(1, 0, 1), vector(0, 1, 1), vector(1, 1, 1)]
section.identity(
    "2.3/beyond/parallelepiped",
    "the basic points, G3 and the other vertices of their parallelepiped",
    printed=0,
    derived=determinant(Matrix.vstack(*(forms_at(homogeneous(vertex)) for vertex in vertices))),
)

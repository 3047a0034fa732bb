# %% [markdown]
# # 2.3 Critical situations: what is true
#
# The determinant of the five equations is a product, but for factors that vanish only where a center coincides with a
# basic point: one factor vanishes where the element that the equations are divided by does, the other one where ten
# points lie on a quadric.  The quadric may be of any type.  Whether the images themselves are ambiguous, and not the
# linear equations alone, depends on the sign of its determinant.  None of this is in the paper.

# %%
from itertools import combinations

import sympy

from algebroproj_derivations.drivers import classify
from algebroproj_derivations.figures import QuadricDrawing
from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s2_2_correlation import differences, primed, q2
from algebroproj_derivations.fundamentals1996.s2_3_critical_situations import (
    C0,
    GENERAL,
    D,
    M_left,
    M_right,
    Q,
    Q_of_minors,
    basic_points,
    center_left,
    center_right,
    dependence,
    diagonal,
    equations,
    forms_at,
    four_points,
    homologous,
    in_space,
    minors_of,
    minors_of_points,
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
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, adjugate, columns, determinant, dot, homogeneous, over, vector

section = Section("fundamentals1996", "2.3", "Critical situations: what is true")

# %% [markdown]
# ## Quadrics through the basic points
#
# Ten products of two homogeneous coordinates give a quadric its ten coefficients.  $G_0$, $G_1$ and $G_2$ impose three
# independent conditions; seven products that vanish there remain.  $\mathbf q(\mathbf y)$ is the row of the seven
# products, and the forms of the equations for all six elements are $\mathbf q(\mathbf y) \mathbf W$.

# %%
any_point = vector(*sympy.symbols("h0:4"))


def seven_products(y: Matrix) -> Matrix:
    h0, h1, h2, h3 = y
    return Matrix([[h1 * (h1 - h0), h2 * (h2 - h0), h3 * h3, h0 * h3, h1 * h2, h1 * h3, h2 * h3]])


def coefficients(form: sympy.Expr) -> Matrix:
    """Return the coefficients of a quadratic form that vanishes at the basic points."""
    h0, h1, h2, h3 = any_point
    polynomial = sympy.Poly(form, *any_point)
    leading = (h1**2, h2**2, h3**2, h0 * h3, h1 * h2, h1 * h3, h2 * h3)
    return vector(*(polynomial.coeff_monomial(product) for product in leading))


forms = six_forms.xreplace(homologous(any_point))
W = columns(*map(coefficients, forms))

section.rank(
    "2.3/beyond/basic-conditions",
    "the basic points impose three conditions on a quadric",
    printed=3,
    derived=Matrix.vstack(*map(monomials, basic_points)),
    kernel=[
        Matrix(10, 1, [sympy.Poly(product, *any_point).coeff_monomial(one) for one in monomials(any_point)])
        for product in seven_products(any_point)
    ],
    note="The kernel vectors are the seven products.",
)
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
# The sixth form is no new one: the true matrix of correlation $\mathbf C_0$ gives the zero form, as
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
section.rank(
    "2.3/beyond/forms-rank",
    "the quadrics through the centers and the basic points",
    printed=5,
    derived=W,
    kernel=[elements],
    note="Five of ten dimensions: the forms of the equations are all quadrics through the five points.",
)
section.identity(
    "2.3/beyond/skew#singular",
    "the true matrix of correlation is singular",
    printed=0,
    derived=determinant(C0),
)

# %% [markdown]
# ## The factorisation
#
# The equations of five points are $\mathbf V \mathbf W$, with the seven products of each point in a row of
# $\mathbf V$.  Let $S$ be five of the seven products, and $\mathbf V_S$, $\mathbf W_S$ the columns and rows that belong
# to them.  By Cauchy and Binet, a minor of $\mathbf V \mathbf W$ is the sum of $\det \mathbf V_S \det \mathbf W_S$ over
# the 21 sets $S$.  By Laplace, the determinant of the seven products at both centers and at the five points is the sum
# of $\pm \det \mathbf V_S$ times the minor of the centers with the two other products.  The two sums agree term by
# term, but for the factor in the claim: wherever the points are, a minor is the determinant $T$ of ten points times an
# element of $\mathbf C_0$.

# %%
FIVES = list(combinations(range(7), 5))
scale = mup1 * mup2 * mupp1 * mupp2


def minor_of_centers(five: tuple[int, ...]) -> sympy.Expr:
    """Return the signed minor of the centers that belongs to five products in the expansion by Laplace."""
    two = [product for product in range(7) if product not in five]
    return (-1) ** (sum(two) + 1) * determinant(base[:, two])


def minor_of_forms(five: tuple[int, ...], skipped: int) -> sympy.Expr:
    return determinant(W[list(five), [column for column in range(6) if column != skipped]])


def is_product(number: str, title: str, skipped: int, note: str) -> None:
    section.identity(
        number,
        title,
        printed=(-1) ** (skipped + 1) * elements[skipped] * vector(*map(minor_of_centers, FIVES)),
        derived=scale * vector(*(minor_of_forms(five, skipped) for five in FIVES)),
        note=note,
    )


is_product(
    "2.3/beyond/theorem",
    "the determinant of the five equations is a product",
    skipped=5,
    note="Term by term, for the 21 choices of five products: mu1' mu2' mu1'' mu2'' det(A5) times all d'_k d''_k is "
    "c10 T.  T vanishes exactly where both centers, G0, G1, G2 and the points 3 to 7 lie on a quadric.  For cameras "
    "with nonzero mu, A5 is singular in this case, where c10 = 0, and nowhere else.",
)
for skipped, element in enumerate(("c11", "c12", "c20", "c21", "c22")):
    is_product(
        f"2.3/beyond/theorem#{element}",
        f"the determinant after division by {element} is a product",
        skipped,
        note=f"As in 2.3/beyond/theorem, with {element} in the place of c10.  On a quadric all six minors vanish: no "
        "choice of the divisor helps.",
    )

# %% [markdown]
# ## The other factors
#
# $c_{10} = 0$ is a fault of normalisation alone: $\mathbf C_0$ cannot be divided by this element, but the six
# homogeneous equations still determine it.  It means that $G_0$ and $G_1$ are coplanar with the base, for instance
# parallel to it, as in a raster that is aligned with the base.

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
distance = sympy.Symbol("distance")
section.identity(
    "2.3/beyond/divisor#parallel",
    "the base is parallel to the line from G0 to G1",
    printed=0,
    derived=determinant(columns(homogeneous(center), homogeneous(center + distance * e1), *basic_points[:2])),
)
coplanar = {upp32: over(mupp2 * mup3 * up32, mup2 * mupp3)}
six_rows = Matrix.vstack(*(six_forms.xreplace(homologous(in_space(k))) for k in GENERAL)).xreplace(coplanar)
section.rank(
    "2.3/beyond/normalisation",
    "rank of the six equations where c10 vanishes",
    printed=5,
    derived=six_rows,
    kernel=[elements.xreplace(coplanar)],
    note="The matrix of correlation is determined, with c10 = 0.",
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
# Where the equations fail, any other solution $\mathbf C_1$ spans with $\mathbf C_0$ a pencil of solutions, and
# $\mathbf M'^T \mathbf C_1 \mathbf M''$ gives the quadric.  But a matrix of correlation must be singular.  The
# determinant of $\mathbf C_1 + t \mathbf C_0$ is of second degree in $t$, as $\mathbf C_0$ is singular itself, and its
# discriminant is the determinant of the quadric.  A negative one leaves no other real matrix of correlation, a positive
# one leaves two; among the quadrics with real points the sign tells those with two families of real lines from those
# with none.  The images are ambiguous on ruled quadrics, as Krames and Wunderlich found for relative orientation; on
# the others it is the linear method alone that fails, and $\det \mathbf C = 0$ still selects the true solution.

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
double_quadric = M_left.T * C1 * M_right + (M_left.T * C1 * M_right).T
section.identity(
    "2.3/beyond/discriminant",
    "the discriminant of the pencil is the determinant of the quadric",
    printed=determinant(double_quadric),
    derived=linear**2 - 4 * lowest * quadratic,
    note="For any matrix C1, 2Q being the symmetric matrix.  det(2Q) > 0 on hyperboloids of one sheet and hyperbolic "
    "paraboloids: two other singular matrices of the pencil.  det(2Q) < 0 on ellipsoids, hyperboloids of two sheets "
    "and elliptic paraboloids: none.  det(2Q) = 0 on cones, cylinders and pairs of planes: a double one, which for a "
    "pair of planes may have rank 1 and then is no matrix of correlation.",
)

hyperboloid = diagonal(1, 1, -1)
QuadricDrawing(
    "Both centers, the basic points and the points P3 to P7 on a hyperboloid of one sheet, which two families of lines "
    "cover.  Here the images themselves are ambiguous: nothing in them tells the true correlation from two others.",
    hyperboloid,
    named([y[1:, :] for y in points_on(hyperboloid)]),
)

# %% [markdown]
# ## Invariants of a quadric
#
# A symmetric matrix has real eigenvalues.  By the rule of Descartes the signs of the coefficients of its
# characteristic polynomial then count the positive and the negative ones exactly: rank and signature.  The matrix gives
# them for the quadric, its block at infinity for the conic at infinity; both together are the affine type.

# %%
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


def coefficients_of(polynomial: sympy.Expr, degree: int) -> Matrix:
    """Return the coefficients of a polynomial of t below the leading one."""
    return vector(*(sympy.Poly(polynomial, t).coeff_monomial(t ** (degree - k)) for k in range(1, degree + 1)))


affine = Matrix(3, 3, sympy.symbols("a:3:3"))
change = columns(homogeneous(vector(*sympy.symbols("b1:4"))), Matrix.zeros(1, 3).col_join(affine))
section.identity(
    "2.3/beyond/invariants#affine",
    "the block at infinity in other affine coordinates",
    printed=affine.T * at_infinity * affine,
    derived=(change.T * symmetric * change)[1:, 1:],
    note="By the law of inertia, rank and signature of both matrices do not depend on the affine coordinates.",
)

# %% [markdown]
# ## Every type of quadric is critical
#
# For each quadric two regular cameras with their centers on it, and five points of it, $G_3$ first; the basic points
# lie on all of them.  The quadric that the minors of four points give is compared with the chosen one; the paper
# names hyperbolic paraboloid, cone and cylinder.

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
        derived=quadric(camera_left, camera_right).xreplace(dict(zip(D, minors_of(numbers[:4, :]), strict=True))),
    )
    section.identity(
        f"2.3/{slug}#type",
        f"invariants, {name}",
        printed=vector(*whole, *infinite),
        derived=vector(*characteristic(chosen), *characteristic(chosen[1:, 1:])),
        note="Coefficients of the characteristic polynomials of the matrix and of its block at infinity, below the "
        "leading 1.  The fourth one is the determinant.",
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
# Through the vertices of a cube there are three independent quadrics, $y_j^2 = y_j$.  The two centers impose two more
# conditions, and one quadric is left: eight points in the vertices of a parallelepiped are critical for all cameras.

# %%
vertices = [vector(0, 0, 1), vector(1, 1, 0), vector(1, 0, 1), vector(0, 1, 1), vector(1, 1, 1)]
section.identity(
    "2.3/beyond/parallelepiped",
    "the basic points, G3 and the other vertices of their parallelepiped",
    printed=0,
    derived=determinant(Matrix.vstack(*(forms_at(homogeneous(vertex)) for vertex in vertices))),
    note="For any two cameras.  Two congruent squares of points in two levels are a raster to avoid.",
)

# %% [markdown]
# ## Code
#
# Computed from the minors of four equations, as in (2.3.3), the quadric loses all digits where cameras or points are
# badly scaled: the forms share what the factorisation takes out.  The code has it from the ten points instead.  In
# barycentric coordinates $b_j$ the basic points are unit vectors, and the seven products are those of two different
# coordinates, and $b_3^2$.  The coordinates of a center are polynomials, whose products have the factor $\mu_1 \mu_2$;
# without it, and with $c_{10}$, the signed minors of six rows are the coefficients of the quadric.

# %%
PAIRS = ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3), (3, 3))
SHARED: dict[sympy.Symbol, sympy.Expr] = {}


def named(name: str, expression: sympy.Expr) -> sympy.Symbol:
    """Return the symbol of an abbreviation."""
    symbol = sympy.Symbol(name)
    SHARED[symbol] = expression
    return symbol


def row_of_point(k: int) -> list[sympy.Symbol]:
    b1, b2, b3 = in_space(k)[1:, :]
    b = (named(f"b{k}", 1 - b1 - b2 - b3), b1, b2, b3)
    return [named(f"f{k}_{i}{j}", b[i] * b[j]) for i, j in PAIRS]


def row_of_center(primes: str) -> list[sympy.Symbol]:
    m1, m2, m3 = primed(mu, primes)
    v1, v2 = primed(fourth_image, primes)
    v0 = named(f"u{primes}30", 1 - v1 - v2)
    b = (v0 * m1 * m2 * m3, v1 * m2 * m3, v2 * m1 * m3, -m1 * m2)
    return [named(f"f{primes}_{i}{j}", b[i] * b[j] / (m1 * m2)) for i, j in PAIRS]


six_points = Matrix([*(row_of_point(k) for k in range(3, 7)), row_of_center("p"), row_of_center("pp")])
minors = {(j,): six_points[5, j] for j in range(7)}
for row in reversed(range(5)):
    for chosen in combinations(range(7), 6 - row):
        terms = [
            (-1) ** place * six_points[row, j] * minors[chosen[:place] + chosen[place + 1 :]]
            for place, j in enumerate(chosen)
        ]
        minors[chosen] = named("m" + "".join(map(str, chosen)), sympy.Add(*terms))

divisor = named("c10", elements[5])
cofactors = {
    pair: named(f"r{pair[0]}{pair[1]}", (-1) ** place * divisor * minors[tuple(j for j in range(7) if j != place)])
    for place, pair in enumerate(PAIRS)
}


def coefficient(i: int, j: int) -> sympy.Expr:
    """Return twice an element of the quadric in barycentric coordinates."""
    return cofactors.get((min(i, j), max(i, j)), sympy.Integer(0)) * (1 + int(i == j))


def element(i: int, j: int) -> sympy.Expr:
    """Return an element of the quadric in affine coordinates."""
    if i == j == 3:
        return cofactors[3, 3] - cofactors[0, 3]
    if i == j:
        return -coefficient(0, i)
    if 0 in (i, j):
        return over(coefficient(i, j), 2)
    return over(coefficient(i, j) - coefficient(0, i) - coefficient(0, j), 2)


section.kernel(
    "critical.quadric",
    "Quadric of the points that, with four given points, make the five equations singular.",
    arguments={
        "mu_left": primed(mu, "p"),
        "u3_left": primed(fourth_image, "p"),
        "mu_right": primed(mu, "pp"),
        "u3_right": primed(fourth_image, "pp"),
        "y": Matrix.vstack(*(y[1:, :].T for y in four_points)),
    },
    describe={
        "mu_left": f"Left image: {ABOUT_MU}",
        "u3_left": f"Left image: {ABOUT_U3}",
        "mu_right": f"Right image: {ABOUT_MU}",
        "u3_right": f"Right image: {ABOUT_U3}",
        "y": "Four points (y1, y2, y3) in affine coordinates; dimensionless.",
    },
    derived=Q_of_minors.xreplace(minors_of_points),
    form=Matrix(4, 4, element),
    where=SHARED,
    claims=["2.3.3", "2.3/X", "2.3/Q", "2.3/beyond/theorem"],
    example={
        "mu_left": ("0.625", "0.75", "0.5"),
        "u3_left": ("0.25", "0.125"),
        "mu_right": ("0.75", "0.625", "0.875"),
        "u3_right": ("0.3125", "-0.25"),
        "y": (
            ("0.625", "0.75", "0.25"),
            ("-0.5", "0.875", "0.125"),
            ("1.25", "-0.375", "-0.25"),
            ("0.75", "1.5", "0.375"),
        ),
    },
    normwise=True,
)
section.kernel(
    "critical.invariants",
    "Coefficients below the leading ones in the characteristic polynomials of a quadric and its block at infinity.",
    arguments={"Q": Q},
    describe={
        "Q": "Symmetric matrix of a quadric in homogeneous coordinates (1, y1, y2, y3); the upper triangle is used."
    },
    derived={
        "whole": coefficients_of(determinant(t * Matrix.eye(4) - symmetric), 4),
        "at_infinity": coefficients_of(determinant(t * Matrix.eye(3) - at_infinity), 3),
    },
    form={"whole": characteristic(symmetric), "at_infinity": characteristic(at_infinity)},
    claims=["2.3/beyond/invariants#whole", "2.3/beyond/invariants#at-infinity", "2.3/beyond/invariants#affine"],
    example={"Q": (("0", "-1", "-1", "-1"), ("-1", "2", "0", "0"), ("-1", "0", "2", "0"), ("-1", "0", "0", "2"))},
)
section.driver("critical.classify", classify)

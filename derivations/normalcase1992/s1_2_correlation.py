# %% [markdown]
# # 1.2 Orientation from image correlation
#
# Two projectors meet in a point of the model, and lie in one plane with the base.  In image coordinates this is a
# bilinear equation.  Its matrix $\mathbf C$ is the correlation of the two images.  What does it know, and how many
# points determine it?

# %%
from itertools import combinations, product

import sympy
from sympy import Eq, ImmutableMatrix, MatrixSymbol

from algebroproj_derivations.figures import QuadricDrawing
from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, columns, cross, determinant, dot, over, vector
from algebroproj_sym.expressions.letters import Adjugate, Cross, Dot, Skew

section = Section("normalcase1992", "1.2", "Orientation from image correlation")

# %% [markdown]
# ## When do two projectors meet?
#
# **Definition.**  A point of the model is on both: $\mathbf X - \mathbf X'_0 = \lambda' \mathbf p'$ by (1.1.1), and so
# for the right image.

# %%
lam_p, lam_pp = sympy.symbols("lam_p lam_pp")
pp, ppp, X, X0p, X0pp, b_bold = (MatrixSymbol(name, 3, 1) for name in ("pp", "ppp", "X", "X0p", "X0pp", "b"))
on_both_rays = [Eq(X, X0p + lam_p * pp), Eq(X0pp, X - lam_pp * ppp), Eq(b_bold, X0pp - X0p)]

section.identity("1.2.1", "condition of intersection with the base", constraints=on_both_rays, derived=X - X0p)

# %% [markdown]
# **Print.**  $\mathbf p' \times \mathbf b$ has no component along $\mathbf p''$.  Conversely, where base and projectors
# are linearly dependent, $\mathbf p'$ and $\mathbf p''$ meet or are parallel.

# %%
triple = Dot(Cross(pp, b_bold), ppp)
section.identity("1.2/perpendicular", "a product that vanishes", derived=Dot(Cross(ppp, b_bold), ppp))
section.identity("1.2.2", "condition of coplanarity", constraints=on_both_rays, nonzero=[lam_p], derived=triple)
p_left, p_right = (vector(*sympy.symbols(f"p1{primes} p2{primes} p3{primes}")) for primes in ("p", "pp"))
section.identity(
    "1.2/beyond/coplanarity",
    "the condition is that base and projectors are linearly dependent",
    printed=determinant(columns(p_left, b, p_right)),
    derived=dot(cross(p_left, b), p_right),
)

# %% [markdown]
# The vector product is a product with a matrix, from the right: as a product from the left, $\mathbf B \mathbf p =
# \mathbf b \times \mathbf p$, it has the opposite sign.

# %%
b1, b2, b3 = b
section.identity(
    "1.2/B",
    "matrix of the base",
    printed=p_left.T * Matrix([[0, -b3, b2], [b3, 0, -b1], [-b2, b1, 0]]),
    derived=cross(p_left, b).T,
)

# %% [markdown]
# **In image coordinates** $\mathbf p = \mathbf R \mathbf x$, and $\mathbf B = [\mathbf b]_\times$:

# %%
Rp, Rpp, B_bold, C_bold = (MatrixSymbol(name, 3, 3) for name in ("Rp", "Rpp", "B", "C"))
xp_bold, xpp_bold = MatrixSymbol("xp", 3, 1), MatrixSymbol("xpp", 3, 1)
in_images = [Eq(pp, Rp * xp_bold), Eq(ppp, Rpp * xpp_bold), Eq(B_bold, Skew(b_bold)), Eq(C_bold, Rp.T * B_bold * Rpp)]
section.identity(
    "1.2.3",
    "condition of coplanarity in image coordinates",
    constraints=in_images,
    derived=ImmutableMatrix([[triple] * 3]),
)

# %% [markdown]
# **How many parameters?**  Rinner's conjunction of successive images, of which the introduction speaks, has five: two
# components of the base $(1, b_2, b_3)^T$, and three rotations of the right image.  In whichever way relative
# orientation is described, the correlation determines as many.

# %%
turn = sympy.symbols("q0:4")
of_successive_images = correlation(E3, rotation(*turn), vector(1, b2, b3))
section.count(
    "0/five",
    "two components of the base and three rotations",
    printed=5,
    derived=of_successive_images.applyfunc(lambda element: over(element, of_successive_images[2, 1])),
    variables=(b2, b3, *turn),
    kernel=[vector(0, 0, *turn)],
)

# %% [markdown]
# ## What are its elements?
#
# **Print.**  Triple products of the base and one axis of each image.

# %%
C = correlation(R_left, R_right, b)
section.identity(
    "1.2.4",
    "matrix of correlation by triple products",
    derived=C,
)

# %% [markdown]
# ## First property: which points does it take to zero?
#
# **Definition.**  The epipole is the image of the other center.  As rotations keep products of vectors, $\mathbf C$
# takes the epipole of $P''$ to zero, $\mathbf C^T$ that of $P'$; the other image may then have any matrix of
# orientation.

# %%
k = sympy.Symbol("k")
x0p, x0pp = MatrixSymbol("x0p", 3, 1), MatrixSymbol("x0pp", 3, 1)
C_of_images = Rp.T * Skew(b_bold) * Rpp
section.identity(
    "1.2.5#left",
    "epipole of the left image",
    constraints=[Eq(C_bold, C_of_images), Eq(x0p, Rp.T * b_bold / k)],
    properties={Rp: "rotation"},
    derived=C_bold.T * x0p,
)
section.identity(
    "1.2.5#right",
    "epipole of the right image",
    constraints=[Eq(C_bold, C_of_images), Eq(x0pp, Rpp.T * b_bold / k)],
    properties={Rpp: "rotation"},
    derived=C_bold * x0pp,
)
section.rank(
    "1.2/rank",
    "rank of the matrix of correlation",
    derived=C_of_images,
    properties={Rp: "rotation", Rpp: "rotation"},
    kernel=[Rpp.T * b_bold],
)

# %% [markdown]
# **And both at once?**  The adjugate is the product of both epipoles.  For rotations the factors are $\mathbf R''^T
# \mathbf b$ and $\mathbf R'^T \mathbf b$, with the sign of the base in both.

# %%
section.identity(
    "1.2/beyond/cofactors",
    "the adjugate of a rotation is its transpose",
    printed=Rp.T,
    derived=Adjugate(Rp),
    properties={Rp: "rotation"},
)
section.identity(
    "1.2/beyond/adjugate",
    "the adjugate is the product of both epipoles",
    printed=(Adjugate(Rpp) * b_bold) * (Adjugate(Rp) * b_bold).T,
    derived=Adjugate(C_of_images),
)

# %% [markdown]
# ## Second property: which lines does it make?
#
# **Definition.**  The epipolar line of a point joins the epipole and the image of the projector of the other point.

# %%
section.definition("1.2.6", "dualistic transformations", printed=columns(C * x_right, C.T * x_left))
section.identity(
    "1.2.6#incidence",
    "the lines contain the homologous points where the condition of coplanarity holds",
    printed=ImmutableMatrix([Dot(C_bold * xpp_bold, xp_bold), Dot(C_bold.T * xp_bold, xpp_bold)]),
    constraints=in_images,
    derived=ImmutableMatrix([triple] * 2),
)

# %% [markdown]
# They are lines through the epipoles: derived is the line that joins the epipole and the image of the other projector.

# %%
section.up_to_scale(
    "1.2.6#left",
    "epipolar line in the left image",
    printed=C_of_images * xpp_bold,
    derived=Cross(Rp.T * b_bold, Rp.T * Rpp * xpp_bold),
    properties={Rp: "rotation"},
)
section.up_to_scale(
    "1.2.6#right",
    "epipolar line in the right image",
    printed=C_of_images.T * xp_bold,
    derived=Cross(Rpp.T * b_bold, Rpp.T * Rp * xp_bold),
    properties={Rpp: "rotation"},
)

# %% [markdown]
# ## Which element is a divisor?
#
# **Definition.**  Only the ratios of the elements count.  The paper divides by $c_{32}$, so that $z_{32} = 1$.

# %%
c_any = Matrix(3, 3, lambda row, column: sympy.Symbol(f"c{row + 1}{column + 1}"))
z_any = Matrix(3, 3, lambda row, column: sympy.Symbol(f"z{row + 1}{column + 1}"))
c32 = c_any[2, 1]
OF_C = {z_any[place]: over(c_any[place], c32) for place in product(range(3), repeat=2)}
Z = z_any.xreplace(OF_C)
section.identity(
    "1.2.7",
    "division by one element",
    printed=columns(c32 * z_any, vector(z_any[2, 1], 0, 0)),
    where=OF_C,
    derived=columns(c_any, vector(1, 0, 0)),
)

# %% [markdown]
# It is "probably biggest" because in the normal case it is $b_1$, beside $-b_1, b_2, b_3$ and their opposites.
# Rotations can make it vanish (2.1/beyond/c32).

# %%
section.identity(
    "1.2/beyond/c32",
    "in the normal case the divisor is the first component of the base",
    printed=matrix_of_base(b),
    derived=correlation(E3, E3, b),
)

# %% [markdown]
# Lines and epipoles do not notice the division.

# %%
section.up_to_scale(
    "1.2/homogeneous#h'",
    "the homogeneous matrix gives the same lines in the left image",
    printed=Z * x_right,
    derived=c_any * x_right,
)
section.up_to_scale(
    "1.2/homogeneous#h''",
    "the homogeneous matrix gives the same lines in the right image",
    printed=Z.T * x_left,
    derived=c_any.T * x_left,
)
null = vector(*sympy.symbols("n1:4"))
section.identity(
    "1.2/homogeneous#epipoles",
    "the homogeneous matrix gives the same epipoles",
    printed=columns(c32 * (Z * null), c32 * (Z.T * null)),
    derived=columns(c_any * null, c_any.T * null),
)

# %% [markdown]
# ## How many points are needed?
#
# **Definition.**  Each pair of homologous points gives one equation, linear in the elements of $\mathbf C$: the row of
# the products of coordinates.  Eight rows that are independent fix $\mathbf C$ but for a factor.


# %%
def equation(left: Matrix, right: Matrix) -> Matrix:
    """Return the coefficients of the nine elements of C, row by row."""
    return Matrix(1, 9, [p * q for p in left for q in right])


def design(left: list[Matrix], right: list[Matrix]) -> Matrix:
    return Matrix.vstack(*(equation(p, q) for p, q in zip(left, right, strict=True)))


section.identity(
    "1.2/row",
    "one equation for the elements of the matrix of correlation",
    printed=dot(x_left, c_any * x_right),
    derived=(equation(x_left, x_right) * vector(*c_any))[0],
)

# %% [markdown]
# A common rotation of all projectors of an image is a regular transformation of the elements of $\mathbf C$ and leaves
# the rank as it is: projectors instead of image points will do.  Take eight points in general position, in the system
# of the left projectors, with the base as unit.

# %%
points = [vector(*sympy.symbols(f"X1_{n} X2_{n} X3_{n}")) for n in range(1, 9)]
correlation_of_projectors = vector(*matrix_of_base(unit_base))


def design_of_points(model_points: list[Matrix]) -> Matrix:
    return design(model_points, [point - unit_base for point in model_points])


section.rank(
    "1.2/eight",
    "eight points determine the matrix of correlation but for a factor",
    derived=design_of_points(points),
    kernel=[correlation_of_projectors],
)

# %% [markdown]
# ## When is the system singular?
#
# **Print.**  The model must be spatial.  A plane model gives a plane projectivity $\mathbf x' \sim \mathbf H \mathbf
# x''$ between the images, and not eight but six independent equations.

# %%
H = Matrix(3, 3, sympy.symbols("h:3:3"))
plane_right = [image_vector(*sympy.symbols(f"x{n} y{n}")) for n in range(1, 9)]
section.rank(
    "1.2/spatial",
    "a plane model does not determine the matrix of correlation",
    printed=6,
    derived=design([H * point for point in plane_right], plane_right),
    kernel=[vector(*(matrix_of_base(axis) * H)) for axis in (e1, e2, e3)],
)

# %% [markdown]
# **Is it enough that no four points lie in one plane?**  The paper advises to keep every point away from the planes of
# three others.  All points for which a second matrix
# $\mathbf F \ne \mathbf C$ satisfies $\mathbf p'^T \mathbf F \mathbf p'' = 0$ lie on a quadric through both centers.
# With $\mathbf p' = \mathbf X$ and $\mathbf p'' = \mathbf X - \mathbf b$, one such quadric is
# $X_1 (X_1 - 1) + X_2 X_3 = 0$.

# %%
on_quadric = [point.xreplace({point[2]: over(point[0] * (1 - point[0]), point[1])}) for point in points]
second_solution = vector(1, 0, 0, 0, 0, 1, 0, 0, 0)
CRITICAL = "-5 5 -6, 5 1 -20, -6 7 -6, -3 3 -4, -5 3 -10, 4 1 -12, 3 2 -3, 3 6 -1"
critical_points = [vector(*map(int, point.split())) for point in CRITICAL.split(",")]
# %% [markdown]
# Eight points of it, of which no four are coplanar, do not determine $\mathbf C$: the advice does not avoid the
# critical quadrics.

# %%

coplanar = [
    four for four in combinations(critical_points, 4) if determinant(Matrix([[1, *point] for point in four])) == 0
]
section.numeric(
    "1.2/beyond/no-four-coplanar",
    "number of coplanar quadruples among eight points of the quadric",
    printed="0",
    derived=len(coplanar),
)
section.rank(
    "1.2/beyond/no-four-coplanar#rank",
    "eight points of which no four are coplanar can give a singular system",
    printed=7,
    derived=design_of_points(critical_points),
    kernel=[correlation_of_projectors, second_solution],
)

# %%
half = sympy.Rational(1, 2)
QuadricDrawing(
    "The quadric, both centers and the eight points, of which no four are coplanar.",
    Matrix([[0, -half, 0, 0], [-half, 1, 0, 0], [0, 0, 0, half], [0, 0, half, 0]]),
    {"C'": vector(0, 0, 0), "C''": unit_base} | {f"{k}": point for k, point in enumerate(critical_points, 1)},
    axes=("X_1", "X_2", "X_3"),
)

# %% [markdown]
# The same holds for any eight points of the quadric.

# %%
section.rank(
    "1.2/beyond/critical",
    "points of a quadric through both centers do not determine the matrix of correlation",
    printed=7,
    derived=design_of_points(on_quadric),
    kernel=[correlation_of_projectors, second_solution],
)

# %% [markdown]
# **Is it necessary?**  No.  Here the first four points have the same third coordinate, and the system is regular.

# %%
FOUR_COPLANAR = "0 1 -5, 1 -1 -5, 2 1 -5, -1 2 -5, 1 3 -7, 2 -2 -4, -2 -1 -6, 3 2 -4"
four_coplanar = [vector(*map(int, point.split())) for point in FOUR_COPLANAR.split(",")]
section.rank(
    "1.2/beyond/four-coplanar",
    "four coplanar points need not make the system singular",
    printed=8,
    derived=design_of_points(four_coplanar),
)

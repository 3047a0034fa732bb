# %% [markdown]
# # 2.1 General orientation problem: algebraic consideration
#
# A photograph takes one number from space: of a point it keeps two coordinates out of three.  Two photographs give
# four equations, one more than is needed.  What does the extra equation say?  It is the condition that homologous rays
# meet.  This section asks what the condition knows of the two photographs, and what more is needed to know the object.

# %%
import sympy

from algebroproj_derivations.cameras import PLACES, Ray, minors_of_cameras, wedge, with_ray
from algebroproj_derivations.figures import ImageDrawing, SpaceDrawing
from algebroproj_derivations.inserting import given, inserted
from algebroproj_derivations.okamoto1981.notation import *
from algebroproj_derivations.okamoto1981.s1_1_general_collinearity import by_point
from algebroproj_derivations.okamoto1981.s1_2_space_correspondence import B, collineation, images_of_five
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    Scalar,
    adjugate,
    columns,
    cross,
    determinant,
    diff,
    dot,
    linear_system,
    over,
    solve,
    vector,
)

section = Section("okamoto1981", "2.1", "General orientation problem, algebraic consideration")

# %% [markdown]
# ## Why two photographs?
#
# **Definition.**  The derivatives of the two image coordinates by the three coordinates of the object point are a
# matrix of two rows.  The cross product of the rows is a direction in which neither image coordinate changes.

# %%
ray_direction = cross(by_point.row(0).T, by_point.row(1).T)

# %% [markdown]
# **Print.**  The general collinearity equations have no inverse.

# %%
section.rank(
    "2.1/inverse",
    "the general collinearity equations have no inverse",
    printed=2,
    derived=by_point,
    kernel=[ray_direction],
)

# %% [markdown]
# **Meaning.**  The direction is that of the ray.  All points of a ray have one image.

# %% [markdown]
# ## Four equations
#
# **Definition.**  Both photographs have general collinearity equations.  The letters of the left one have the index 1,
# those of the right one the index 2.

# %%
A_left, A_right = vector(*sympy.symbols("A1_1:12")), vector(*sympy.symbols("A2_1:12"))
xc1, yc1, xc2, yc2 = sympy.symbols("xc1 yc1 xc2 yc2")
x_left, x_right = vector(xc1, yc1), vector(xc2, yc2)
P_left, P_right = matrix_of(A_left), matrix_of(A_right)


def general_collinearity(a: Matrix) -> Matrix:
    """Return the general collinearity equations, as printed, with given coefficients."""
    denominator = a[8] * X + a[9] * Y + a[10] * Z + 1
    return vector(*((a[k] * X + a[k + 1] * Y + a[k + 2] * Z + a[k + 3]) / denominator for k in (0, 4)))


section.definition("16", "left photograph")
section.definition("17", "right photograph")

# %% [markdown]
# Multiplied by its denominator, each equation is linear in $X, Y, Z$.  This is the first of the four:

# %%
homogeneous_point = vector(*point, 1)


def linear_equations(matrix: Matrix, measured: Matrix) -> list[sympy.Expr]:
    """Return the two equations of one photograph: zero for the object points with this image."""
    first, second, denominator = matrix * homogeneous_point
    return [measured[0] * denominator - first, measured[1] * denominator - second]


equations = linear_equations(P_left, x_left) + linear_equations(P_right, x_right)
equations[0]

# %% [markdown]
# **Print.**  The paper writes the coefficients of $X$, $Y$, $Z$ and the constant.


# %%
for number, equation in enumerate(equations, start=1):
    section.identity(f"18#{number}", f"linear equation {number}", derived=equation)

# %% [markdown]
# ## When do the four equations agree?
#
# **Definition.**  Four equations with three unknowns agree if the determinant of coefficients and constants is zero.

# %%
coefficient_rows, right_sides = linear_system(equations, tuple(point))
coplanarity = determinant(columns(coefficient_rows, -right_sides))

# %% [markdown]
# **Print.**  The paper prints this determinant as the condition.  It is necessary: the images of any object point
# satisfy it.

# %%
section.identity("19", "condition of coplanarity", derived=coplanarity)
section.identity(
    "19#holds",
    "the images of an object point satisfy it",
    printed=0,
    derived=inserted(coplanarity, (*x_left, *x_right), (*image(P_left, point), *image(P_right, point))),
)

# %% [markdown]
# **Is it sufficient?**  The first three equations determine an object point, where their own determinant is not zero.
# At this point the fourth equation has the value of the large determinant, divided by the small one.  So the condition
# makes the fourth equation hold.

# %%
three_rows, three_right_sides = coefficient_rows[:3, :], right_sides[:3, :]
from_three = solve(three_rows, three_right_sides)
section.identity(
    "19#sufficient",
    "with the condition the fourth equation holds where the first three do",
    printed=coplanarity / determinant(three_rows),
    derived=inserted(equations[3], point, from_three),
)

# %% [markdown]
# **What does it look like?**  The determinant is linear in the homogeneous image point of either photograph, $\mathbf
# u_1^T \mathbf F \mathbf u_2$.  Each element of $\mathbf F$ is made of two rows of each matrix of projection.  Today
# $\mathbf F$ is called the fundamental matrix.


# %%
F = minors_of_cameras(P_left, P_right)
section.identity(
    "19/beyond/bilinear",
    "the condition as a bilinear form",
    printed=dot(vector(xc1, yc1, 1), F * vector(xc2, yc2, 1)),
    derived=coplanarity,
)

# %% [markdown]
# **An example.**  Two photographs look at five points, the corners $O$, $P$, $Q$, $R$ of a tetrahedron and a point $S$.
# Given a point of one photograph, the condition is the equation of a line in the other one.  It passes through the
# homologous point.

# %%
EXAMPLE_LEFT, EXAMPLE_RIGHT = (
    vector(*map(sympy.Rational, entries.split()))
    for entries in ("4 0 1 1  0 4 1/2 0  1/2 0 1/4", "4 0 1 -2  0 4 1/2 -1  -1/2 0 1/4")
)
F_example = minors_of_cameras(matrix_of(EXAMPLE_LEFT), matrix_of(EXAMPLE_RIGHT))
OBJECT = {"O": (0, 0, 0), "P": (1, 0, 0), "Q": (0, 1, 0), "R": (0, 0, 1), "S": (1, 1, 1)}
seen_left, seen_right = (
    {name: image(matrix_of(a), vector(*p)).doit() for name, p in OBJECT.items()} for a in (EXAMPLE_LEFT, EXAMPLE_RIGHT)
)


def drawn(line: Matrix) -> Matrix:
    """Return a line of an image with its constant first."""
    return vector(line[2], line[0], line[1])


ImageDrawing(
    "Five points in two photographs.  Each line is what the condition of coplanarity makes of one point of the other "
    "photograph; the lines of one photograph meet in the image of the other center.",
    {
        "left": (seen_left, [drawn(F_example * vector(*u, 1)) for u in seen_right.values()]),
        "right": (seen_right, [drawn(F_example.T * vector(*u, 1)) for u in seen_left.values()]),
    },
    axes=("x_c", "y_c"),
)

# %% [markdown]
# ## What does the condition know of the photographs?
#
# It has nine coefficients and a free factor: eight ratios, functions of the 22 coefficients of both photographs.  How
# many of them are independent?
#
# **A collineation changes nothing.**  Apply one to the object, and to both photographs its inverse.  The image points
# stay, and the condition stays.  An infinitesimal collineation is $\mathbf 1 + \varepsilon \mathbf G$, with fifteen
# independent $\mathbf G$; it changes each coefficient at a rate.

# %%
both = (*A_left, *A_right)
generators = [Matrix(4, 4, lambda i, j, k=k: int((i, j) == divmod(k, 4))) for k in range(15)]


def moved(matrix: Matrix, generator: Matrix) -> list[sympy.Expr]:
    """Return the rates of the eleven coefficients under an infinitesimal collineation."""
    rate = matrix * generator
    return list(rate - rate[2, 3] * matrix)[:11]


collineations = [vector(*moved(P_left, generator), *moved(P_right, generator)) for generator in generators]
section.rank(
    "2.1/beyond/fifteen",
    "fifteen parameters are not determined by the condition",
    printed=15,
    derived=columns(*collineations),
)

# %% [markdown]
# The fifteen directions are independent: none leaves both photographs as they are.  The rest is determined, and it is
# $22 - 15 = 7$, as printed.

# %%
ratios = coefficients_of(F)
section.count(
    "2.1/seven",
    "the condition has seven independent parameters",
    derived=ratios,
    variables=both,
    kernel=collineations,
)

# %% [markdown]
# **Meaning.**  However many pairs of points are measured, a model that satisfies the condition is known but for a
# collineation.

# %% [markdown]
# ## Can three image coordinates stand for the point?
#
# **Definition.**  The paper takes three of the four coordinates, $x_{c1}, y_{c1}, x_{c2}$.

# %%
three_coordinates = vector(*general_collinearity(A_left), general_collinearity(A_right)[0])
section.definition("20", "three of the four equations")

# %% [markdown]
# It says that $(X, Y, Z)$ and $(x_{c1}, y_{c1}, x_{c2})$ differ by a collineation.  Every collineation takes the points
# of a line to points of a line.  The test: where do three points of the $X$-axis go?

# %%
origin_image, *others = (
    vector(*image(P_left, p), image(P_right, p)[0]) for p in (vector(0, 0, 0), vector(1, 0, 0), vector(2, 0, 0))
)
bend = cross(others[0] - origin_image, others[1] - origin_image)

# %% [markdown]
# If they were collinear, this vector would be zero.  It is not.  The condition of coplanarity is no help: it restricts
# $y_{c2}$, which does not occur.

# %%
NO_COLLINEATION = (
    "Tested is what every collineation does: the images of the collinear points (0, 0, 0), (1, 0, 0) and (2, 0, 0) are "
    "collinear, which is the vanishing of the derived vector.  The condition (19) is no help: it does not restrict "
    "xc1, yc1 and xc2.  "
)
section.identity(
    "21",
    "the solution is a collineation of the three image coordinates",
    printed=vector(0, 0, 0),
    derived=bend,
    expect="false",
    instead="2.1/beyond/denominator",
    note=NO_COLLINEATION + "The inverse of a collineation is one: (21) holds exactly if (22) does.",
    grade="results",
    follows="A reconstruction by fifteen coefficients fits no general pair of photographs. It is right if both have "
    "the same denominator.",
)
section.identity(
    "22",
    "the three equations as a collineation",
    printed=vector(0, 0, 0),
    derived=bend,
    expect="false",
    instead="2.1/beyond/denominator",
    note=NO_COLLINEATION + "It is one if both photographs have the same denominator, 2.1/beyond/common-denominator.",
    same_as="21",
)

# %% [markdown]
# **In the example.**  Nine points of a straight line of the object, from $O$ to $S$, drawn with their three
# coordinates:

# %%
on_the_line = {
    ("O" if k == 0 else "S" if k == 8 else f"{k}"): inserted(
        three_coordinates, (*point, *both), (*[sympy.Rational(k, 8)] * 3, *EXAMPLE_LEFT, *EXAMPLE_RIGHT)
    )
    for k in range(9)
}
SpaceDrawing(
    "The segment from O to S in the three image coordinates: its points lie on a curve, and the chord is the line on "
    "which a collineation would put them.",
    on_the_line,
    segments=[("O", "S"), *zip(on_the_line, [*on_the_line][1:], strict=False)],
    axes=("x_{c1}", "y_{c1}", "x_{c2}"),
)

# %% [markdown]
# **What is true?**  The three equations are solved by Cramer's rule.  With $\mathbf l_i$ and $\mathbf r_i$ for the
# first three elements of row $i$ of the matrices of projection, the denominator has products of image coordinates.

# %%
l1, l2, l3 = (P_left[i, :3] for i in range(3))
r1, r2, r3 = (P_right[i, :3] for i in range(3))


def triple(*three: Matrix) -> sympy.Expr:
    return determinant(Matrix.vstack(*three))


section.identity(
    "2.1/beyond/denominator",
    "the denominator of the solution of three equations",
    printed=-triple(l1, l2, r1)
    + triple(l3, l2, r1) * xc1
    + triple(l1, l3, r1) * yc1
    + triple(l1, l2, r3) * xc2
    - triple(l3, l2, r3) * xc1 * xc2
    - triple(l1, l3, r3) * yc1 * xc2,
    derived=determinant(three_rows),
)

# %% [markdown]
# So the solution has $4 \cdot 6$ coefficients and not $4 \cdot 4$.  Of their 23 ratios as many are independent as the
# three equations have coefficients, 18.

# %%
numerators_and_denominator = [
    determinant(columns(*(three_right_sides if k == j else three_rows.col(k) for k in range(3)))) for j in range(4)
]
products = ((), (xc1,), (yc1,), (xc2,), (xc1, xc2), (yc1, xc2))
first_coefficient, *other_coefficients = [
    inserted(diff(form, *product) if product else form, (xc1, yc1, xc2), (0, 0, 0))
    for form in reversed(numerators_and_denominator)
    for product in products
]
section.count(
    "2.1/beyond/coefficients",
    "of the 23 coefficients of the solution of three equations 18 are independent",
    printed=18,
    derived=vector(*(over(coefficient, first_coefficient) for coefficient in other_coefficients)),
    variables=(*A_left, *A_right[:4], *A_right[8:]),
)

# %% [markdown]
# **When is the paper right?**  If both photographs have the same denominator, the products vanish.  Then both centers
# lie in one plane, and both pictures are parallel to it: the normal case is of this kind.

# %%
stacked = Matrix.vstack(P_left[:2, :], P_right[:1, :], P_left[2:, :])
section.identity(
    "2.1/beyond/common-denominator",
    "with a common denominator the solution is a collineation",
    printed=collineation(B, vector(xc1, yc1, xc2)),
    where=given(B, coefficients_of(adjugate(stacked))),
    derived=inserted(from_three, A_right[8:], A_left[8:]),
)
section.count(
    "21#independent",
    "the fifteen coefficients of (21) are independent",
    derived=coefficients_of(adjugate(stacked)),
    variables=(*A_left, *A_right[:4]),
    note="Favourable reading, for photographs with the same denominator: there the solution is a collineation, "
    "2.1/beyond/common-denominator, and its coefficients are independent functions of fifteen of the photographs.  In "
    "general it has more coefficients, which are not independent: 2.1/beyond/coefficients.",
)
section.count(
    "2.1/fifteen",
    "five points determine the fifteen parameters of (21)",
    derived=images_of_five,
    variables=B,
    note="Of (21) as a collineation, whose fifteen coefficients five points determine; that the solution of (20) is "
    "one is false, 21.",
)

# %% [markdown]
# ## How do model and object differ?
#
# **Question.**  Seven numbers are known of two photographs.  Which models have the same seven?  The paper says: the
# collineations of the object, (23).  Today this is the theorem of projective reconstruction.
#
# **Proof.**  Choose coordinates in object and model such that the left photograph has the matrix
# $[\mathbf 1\; \mathbf 0]$.  The right one has $[\mathbf A\; \mathbf a]$ in the object and $[\mathbf C\; \mathbf c]$ in
# the model.  The condition is $(\mathbf a \times \mathbf A)^T$.  It takes $\mathbf a$ to zero; if both have the same
# condition, $\mathbf c = \lambda \mathbf a$, and with the free factor of $\mathbf C$, $\mathbf a \times \mathbf C =
# \mathbf a \times \mathbf A$.  The product with $\mathbf a$ hides multiples of $\mathbf a$ and nothing else: $\mathbf C
# = \mathbf A - \mathbf a \mathbf v^T$.

# %%
XM, YM, ZM = sympy.symbols("XM YM ZM")
model = vector(XM, YM, ZM)
E_ = vector(*sympy.symbols("E_1:16"))
Ep = vector(*sympy.symbols("Ep_1:16"))
A_object, C_model = Matrix(3, 3, sympy.symbols("a1:4(1:4)")), Matrix(3, 3, sympy.symbols("c1:4(1:4)"))
a, lam = vector(*sympy.symbols("a1:4")), sympy.Symbol("lam")
v_of_cameras = vector(*(over(dot(a, A_object.col(j) - C_model.col(j)), dot(a, a)) for j in range(3)))
section.identity(
    "23#cameras",
    "two right photographs with the same condition differ by a multiple of the epipole in each column",
    printed=C_model + a * v_of_cameras.T,
    derived=A_object,
    constraints=[component for j in range(3) for component in cross(a, A_object.col(j) - C_model.col(j))],
    witness=given((*A_object, *C_model, *a), (*(2, 1, 0, 0, 1, 0, 0, 0, 1), *(1, 0, 0, 0, 1, 0, 0, 0, 1), 1, 0, 0)),
)

# %% [markdown]
# The model point is where the two rays meet, seen by the photographs of the model: three of their linear equations
# give it.

# %%
v = vector(*sympy.symbols("v1:4"))
left_of_model, right_of_model = columns(E3, vector(0, 0, 0)), columns(A_object - a * v.T, lam * a)
of_left = [
    inserted(form, (*point, *x_left), (*model, over(X, Z), over(Y, Z)))
    for form in linear_equations(left_of_model, x_left)
]
of_right = inserted(
    linear_equations(right_of_model, x_right)[0],
    (*point, *x_right),
    (*model, *image(columns(A_object, a), point)),
)
model_of_object = solve(*linear_system([*of_left, of_right], tuple(model)))
model_of_object

# %% [markdown]
# **Print.**  Equation (23) is a collineation with fifteen coefficients $E_i$.  It is right, with $\lambda$ on the
# diagonal and $\mathbf v$ in the denominator.  Conversely, any collineation $\mathbf H$ of space in front of both
# photographs leaves the condition as it is.

# %%
diagonal_and_denominator = (lam, 0, 0, 0, 0, lam, 0, 0, 0, 0, lam, 0, *v)
section.identity(
    "23",
    "model as a collineation of the object",
    where=given(E_, map(sympy.sympify, diagonal_and_denominator)),
    derived=model_of_object,
)
H = Matrix(4, 4, sympy.symbols("h1:5(1:5)"))
section.identity(
    "23#converse",
    "whatever is a collineation of the object satisfies the condition",
    printed=determinant(H) * F,
    derived=minors_of_cameras(P_left * H, P_right * H),
)

# %% [markdown]
# **And back?**  (23) is solved for $X, Y, Z$.

# %%
M = matrix_of(E_)
object_of_model = solve(
    *linear_system(
        [model[i] * (M[3, :] * homogeneous_point)[0] - (M[i, :] * homogeneous_point)[0] for i in range(3)],
        tuple(point),
    )
)
section.identity(
    "24",
    "object as a collineation of the model",
    where=given(Ep, coefficients_of(adjugate(M))),
    derived=object_of_model,
    expect="misprint",
    corrected=collineation(Ep, model),
    note="In the first two denominators the prime of E13 is missing, while all their other coefficients have theirs; "
    "the same slip twice.  As the coefficient of (23) E13 is wrong.",
)

# %% [markdown]
# ## Are seven pairs and five object points enough?
#
# Seven pairs of image points give seven conditions.  Five object points give fifteen equations more.  Are the 22
# equations independent?
#
# **Derivation.**  Let the object points of the seven pairs be unknown.  Seven pairs and five object points have $28 +
# 15$ image coordinates, functions of 22 coefficients and of the 21 coordinates of seven points.  Eliminate the 21; the
# rates of what is left by the 22 coefficients have full rank.

# %%
tie_points = [vector(*sympy.symbols(f"X_{k} Y_{k} Z_{k}")) for k in range(1, 8)]
control_points = [vector(*p) for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 2, 3))]
of_pairs = [image(matrix, p) for p in tie_points for matrix in (P_left, P_right)]
of_control = [vector(*image(P_left, p), image(P_right, p)[0]) for p in control_points]
section.rank(
    "2.1/twenty-two",
    "seven pairs of image points and five object points give 22 independent equations",
    derived=rates_of_equations(Matrix.vstack(*of_pairs, *of_control), both, tie_points),
)

# %% [markdown]
# **Meaning.**  The count is local: near a solution there is no other.  Elsewhere there can be two more (3/unique).

# %% [markdown]
# ## Where do rays meet that do not meet?
#
# Measured points do not satisfy the condition.  Least squares treat the four linear equations $\mathbf M \mathbf y =
# \mathbf b$ alike.
#
# **Derivation.**  Let $D_i$ be the determinant of the equations other than equation $i$, and $N_{ij}$ the same with
# $\mathbf b$ in the place of column $j$.  By the theorem of Cauchy and Binet the determinant of the normal equations is
# $\sum_i D_i^2$, and the numerators of Cramer's rule are $\sum_i D_i N_{ij}$.

# %%
M4, b = Matrix(4, 3, sympy.symbols("m1:5(1:4)")), vector(*sympy.symbols("b1:5"))


def without(matrix: Matrix, i: int) -> Matrix:
    return Matrix.vstack(*(matrix.row(k) for k in range(matrix.rows) if k != i))


def replaced(matrix: Matrix, j: int, column: Matrix) -> Matrix:
    return columns(*(column if k == j else matrix.col(k) for k in range(matrix.cols)))


def minors(matrix: Matrix) -> Matrix:
    return vector(*(determinant(without(matrix, i)) for i in range(4)))


D = minors(M4)
sum_of_squares = dot(D, D)
numerators = vector(*(dot(D, minors(replaced(M4, j, b))) for j in range(3)))
normal_matrix, normal_right_side = M4.T * M4, M4.T * b

section.identity(
    "2.1/beyond/normal-determinant",
    "determinant of the normal equations",
    printed=sum_of_squares,
    derived=determinant(normal_matrix),
)
section.identity(
    "2.1/beyond/normal-numerators",
    "numerators of Cramer's rule for the normal equations",
    printed=numerators,
    derived=vector(*(determinant(replaced(normal_matrix, j, normal_right_side)) for j in range(3))),
)

# %% [markdown]
# So $y_j = \sum_i D_i N_{ij} / \sum_i D_i^2$ solves the normal equations.  Where the equations agree it is the object
# point itself.

# %%
least_squares = numerators.applyfunc(lambda entry: over(entry, sum_of_squares))
section.identity(
    "2.1/beyond/normal-equations",
    "the quotients solve the normal equations",
    printed=normal_right_side,
    derived=normal_matrix * least_squares,
)
section.identity(
    "2.1/beyond/exact",
    "the solution is the object point where the four equations agree",
    printed=point,
    derived=inserted(least_squares, b, M4 * point),
)

# %% [markdown]
# **Meaning.**  The residuals are proportional to the $D_i$, with alternating signs, and to the large determinant.
# Their sum of squares is its square, divided by $\sum_i D_i^2$: (19) measures by how much the rays miss each other.

# %%
disagreement = determinant(columns(M4, b))
section.identity(
    "2.1/beyond/residuals",
    "residuals of the four equations",
    printed=vector(*((-1) ** (i + 1) * D[i] * disagreement / sum_of_squares for i in range(4))),
    derived=b - M4 * least_squares,
)

# %% [markdown]
# ## The determinants as rays
#
# Each determinant contains both equations of one photograph.  Their own minors are the six coordinates of a line: the
# ray.  They are linear in the image point, as
# $(x \mathbf p_3 - \mathbf p_1) \wedge (y \mathbf p_3 - \mathbf p_2) = \mathbf p_1 \wedge \mathbf p_2 + x\, \mathbf p_2
# \wedge \mathbf p_3 + y\, \mathbf p_3 \wedge \mathbf p_1$.  The product $x y$ does not arise.


# %%
def moment(left: Ray, right: Ray) -> Scalar:
    """Return the combination of two rays that vanishes where they meet, with the sign of (19)."""
    opposite = {place: tuple(k for k in range(4) if k not in place) for place in PLACES}
    return sympy.Add(*((-1) ** (i + j) * left[i, j] * right[opposite[i, j]] for i, j in PLACES))


# %% [markdown]
# All sixteen determinants come from an equation of one photograph and the ray of the other.  Row $i$ is without
# equation $i$; the last column has the $D_i$, the others the $N_{ij}$.

# %%
augmented = columns(M4, b)
left_ray, right_ray = wedge(augmented.row(0), augmented.row(1)), wedge(augmented.row(2), augmented.row(3))
PARTNERS = ((1, right_ray), (0, right_ray), (3, left_ray), (2, left_ray))
section.identity(
    "2.1/beyond/rays",
    "the determinants from an equation of one photograph and the ray of the other",
    printed=Matrix(4, 4, lambda i, j: with_ray(augmented.row(PARTNERS[i][0]), PARTNERS[i][1], j)),
    derived=columns(*(minors(replaced(M4, j, b)) for j in range(3)), D),
)

# %% [markdown]
# The large determinant is the moment of the two rays.  (19) has the constants, not the right sides, in its last column:
# hence the sign.

# %%
section.identity(
    "2.1/beyond/moment",
    "the determinant of the four equations from the two rays",
    printed=moment(left_ray, right_ray),
    derived=-disagreement,
)

# %% [markdown]
# **Print.**  The paper calls (19) the condition that corresponding rays meet.  With the rays of the measured points:


# %%
def with_right_sides(matrix: Matrix) -> Matrix:
    """Return a matrix of projection with the signs of coefficients and right side."""
    return columns(matrix[:, :3], -matrix[:, 3])


def ray_of(matrix: Matrix, measured: Matrix) -> Ray:
    """Return the ray of an image point, linear in its coordinates."""
    p1, p2, p3 = (with_right_sides(matrix).row(i) for i in range(3))
    wedges = (wedge(p1, p2), wedge(p2, p3), wedge(p3, p1))
    return {
        place: wedges[0][place] + measured[0] * wedges[1][place] + measured[1] * wedges[2][place] for place in PLACES
    }


section.identity(
    "2.1/rays",
    "(19) is the condition that corresponding rays meet",
    printed=coplanarity,
    derived=moment(ray_of(P_left, x_left), ray_of(P_right, x_right)),
)

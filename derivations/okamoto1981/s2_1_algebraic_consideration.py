# %% [markdown]
# # 2.1 General orientation problem: algebraic consideration
#
# Two photographs give four linear equations for the three coordinates of an object point.  That they agree is one
# condition for each pair of image points; what this condition leaves open is a collineation of space.

# %%
from itertools import combinations

import sympy

from algebroproj_derivations.okamoto1981.notation import *
from algebroproj_derivations.okamoto1981.s1_1_general_collinearity import by_point
from algebroproj_derivations.okamoto1981.s1_2_space_correspondence import B, collineation, images_of_five
from algebroproj_sym import Section
from algebroproj_sym.declaring import let
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
    rows,
    solve,
    vector,
)

section = Section("okamoto1981", "2.1", "General orientation problem, algebraic consideration")

# %% [markdown]
# ## Two photographs
#
# One photograph does not determine an object point: along the ray the image does not change.

# %%
section.rank(
    "2.1/inverse",
    "the general collinearity equations have no inverse",
    printed=2,
    derived=by_point,
    kernel=[cross(by_point.row(0).T, by_point.row(1).T)],
    note="The derivatives of two image coordinates with respect to three object coordinates.",
)

# %% [markdown]
# The letters of the left photograph have the index 1, those of the right one the index 2.

# %%
A_left, A_right = vector(*sympy.symbols("A1_1:12")), vector(*sympy.symbols("A2_1:12"))
xc1, yc1, xc2, yc2 = sympy.symbols("xc1 yc1 xc2 yc2")
x_left, x_right = vector(xc1, yc1), vector(xc2, yc2)
P_left, P_right = matrix_of(A_left), matrix_of(A_right)


def general_collinearity(a: Matrix) -> Matrix:
    """Return the general collinearity equations, as printed, with given coefficients."""
    denominator = a[8] * X + a[9] * Y + a[10] * Z + 1
    return vector(*((a[k] * X + a[k + 1] * Y + a[k + 2] * Z + a[k + 3]) / denominator for k in (0, 4)))


section.definition("16", "left photograph", printed=general_collinearity(A_left))
section.definition("17", "right photograph", printed=general_collinearity(A_right))

# %% [markdown]
# Multiplied by its denominator, each equation is linear in the object coordinates.

# %%
homogeneous_point = vector(*point, 1)


def linear_equations(matrix: Matrix, measured: Matrix) -> list[sympy.Expr]:
    """Return the two equations of one photograph: zero for the object points with this image."""
    first, second, denominator = matrix * homogeneous_point
    return [measured[0] * denominator - first, measured[1] * denominator - second]


equations = linear_equations(P_left, x_left) + linear_equations(P_right, x_right)


def printed_row(coordinate: sympy.Symbol, a: Matrix, first: int) -> Matrix:
    """Return the coefficients of one linear equation as printed: those of X, Y, Z and the constant."""
    linear = (coordinate * a[8 + k] - a[first + k] for k in range(3))
    return vector(*linear, coordinate - a[first + 3])


printed_rows = [
    printed_row(coordinate, a, first)
    for coordinate, a, first in ((xc1, A_left, 0), (yc1, A_left, 4), (xc2, A_right, 0), (yc2, A_right, 4))
]
for number, (equation, row) in enumerate(zip(equations, printed_rows, strict=True), start=1):
    section.identity(
        f"18#{number}",
        f"linear equation {number}",
        printed=dot(row, homogeneous_point),
        derived=equation,
    )

# %% [markdown]
# ## The coplanarity condition
#
# Four equations with three unknowns agree if the determinant of coefficients and constants is zero.

# %%
coefficient_rows, right_sides = linear_system(equations, tuple(point))
system = columns(coefficient_rows, -right_sides)
coplanarity = determinant(system)
section.identity("19", "condition of coplanarity", printed=determinant(rows(*printed_rows)), derived=coplanarity)
section.identity(
    "19#holds",
    "the images of an object point satisfy it",
    printed=0,
    derived=coplanarity.xreplace(
        dict(zip((xc1, yc1, xc2, yc2), (*image(P_left, point), *image(P_right, point)), strict=True))
    ),
)

# %% [markdown]
# Conversely, the first three equations determine the object point.  There the fourth one has the value of the
# determinant, divided by the determinant of the three.

# %%
three_rows, three_right_sides = coefficient_rows[:3, :], right_sides[:3, :]
from_three = solve(three_rows, three_right_sides)
section.identity(
    "19#sufficient",
    "with the condition the fourth equation holds where the first three do",
    printed=coplanarity / determinant(three_rows),
    derived=equations[3].xreplace(dict(zip(point, from_three, strict=True))),
    note="The solution is unique where the determinant of the three equations is not zero.",
)

# %% [markdown]
# The determinant is linear in the homogeneous image points of either photograph.  An element of this bilinear form is
# made of two rows of each matrix of projection.


# %%
def bilinear_form(left: Matrix, right: Matrix) -> Matrix:
    """Return the matrix F of the condition of coplanarity: u_left^T F u_right = 0."""

    def element(i: int, j: int) -> sympy.Expr:
        other_rows = [matrix.row(k) for matrix, left_out in ((left, i), (right, j)) for k in range(3) if k != left_out]
        return (-1) ** (i + j) * determinant(Matrix.vstack(*other_rows))

    return Matrix(3, 3, element)


F = bilinear_form(P_left, P_right)
section.identity(
    "19/beyond/bilinear",
    "the condition as a bilinear form",
    printed=dot(vector(xc1, yc1, 1), F * vector(xc2, yc2, 1)),
    derived=coplanarity,
    note="Not in the paper: today F is called the fundamental matrix.",
)

# %% [markdown]
# ## What the condition determines
#
# All the condition knows of the photographs are the eight ratios of the elements of $\mathbf F$.  A collineation of the
# object space, $\mathbf P (\mathbf 1 + \varepsilon \mathbf G)$ for both photographs and divided by the last element
# again, changes none of them: fifteen directions.

# %%
both = (*A_left, *A_right)
generators = [Matrix(4, 4, lambda i, j, k=k: int((i, j) == divmod(k, 4))) for k in range(15)]


def moved(matrix: Matrix, generator: Matrix) -> list[sympy.Expr]:
    """Return the rates of the eleven coefficients under an infinitesimal collineation."""
    rate = matrix * generator
    return list(rate - rate[2, 3] * matrix)[:11]


collineations = [vector(*moved(P_left, generator), *moved(P_right, generator)) for generator in generators]
ratios = coefficients_of(F)
section.count(
    "2.1/seven",
    "the condition has seven independent parameters",
    printed=7,
    derived=ratios,
    variables=both,
    kernel=collineations,
    note="22 - 15 = 7, as in today's theory, where the fundamental matrix has seven degrees of freedom.",
)
section.rank(
    "2.1/beyond/fifteen",
    "fifteen parameters are not determined by the condition",
    printed=15,
    derived=columns(*collineations),
    note="Not in the paper.  No infinitesimal collineation leaves both photographs as they are: the stereo model "
    "differs from the object by any of the collineations (8), which five points determine by 2.1/fifteen.",
)

# %% [markdown]
# ## Three image coordinates
#
# The paper takes the map of $(X, Y, Z)$ to $(x_{c1}, y_{c1}, x_{c2})$ for a collineation.  The denominators of the two
# photographs are different, however, and collinear points do not stay collinear.

# %%
three_coordinates = vector(*general_collinearity(A_left), general_collinearity(A_right)[0])
section.definition(
    "20",
    "three of the four equations",
    printed=three_coordinates,
    note="Read as the first three of (16) and (17): the scan has mu for the index 1, loses the index 2, and has A, I "
    "and A_1 for X, Y and A_11.",
)

on_a_line = [
    vector(*image(P_left, p), image(P_right, p)[0]) for p in (vector(0, 0, 0), vector(1, 0, 0), vector(2, 0, 0))
]
origin_image, *others = on_a_line
bend = cross(others[0] - origin_image, others[1] - origin_image)
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

section.count(
    "2.1/fifteen",
    "five points determine the fifteen parameters of (21)",
    printed=15,
    derived=images_of_five,
    variables=B,
    note="Of (21) as a collineation, whose fifteen coefficients five points determine; that the solution of (20) is "
    "one is false, 21.",
)
section.count(
    "21#independent",
    "the fifteen coefficients of (21) are independent",
    printed=15,
    derived=coefficients_of(adjugate(Matrix.vstack(P_left[:2, :], P_right[:1, :], P_left[2:, :]))),
    variables=(*A_left, *A_right[:4]),
    note="Favourable reading, for photographs with the same denominator: there the solution is a collineation, "
    "2.1/beyond/common-denominator, and its coefficients are independent functions of fifteen of the photographs.  In "
    "general it has more coefficients, which are not independent: 2.1/beyond/coefficients.",
)

# %% [markdown]
# The denominator of the solution contains the products $x_{c1} x_{c2}$ and $y_{c1} x_{c2}$.  With $\mathbf l_i$ and
# $\mathbf r_i$ for the first three elements of row $i$ of the matrices of projection:

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
    note="Not in the paper: the solution is a quotient of forms that are linear in the image point of either "
    "photograph, not in the three coordinates together.",
)
forms_of_solution = [
    determinant(columns(*(three_right_sides if k == j else three_rows.col(k) for k in range(3)))) for j in range(4)
]
at_origin = dict.fromkeys((xc1, yc1, xc2), sympy.Integer(0))
monomials_of_solution = ((), (xc1,), (yc1,), (xc2,), (xc1, xc2), (yc1, xc2))
first_coefficient, *other_coefficients = [
    (diff(form, *monomial) if monomial else form).xreplace(at_origin)
    for form in reversed(forms_of_solution)
    for monomial in monomials_of_solution
]
section.count(
    "2.1/beyond/coefficients",
    "of the 23 coefficients of the solution of three equations 18 are independent",
    printed=18,
    derived=vector(*(over(coefficient, first_coefficient) for coefficient in other_coefficients)),
    variables=(*A_left, *A_right[:4], *A_right[8:]),
    note="Not in the paper: as many as the three equations have.  Divided by the constant of the denominator.",
)
same_denominator = dict(zip(A_right[8:], A_left[8:], strict=True))
stacked = Matrix.vstack(P_left[:2, :], P_right[:1, :], P_left[2:, :])
section.identity(
    "2.1/beyond/common-denominator",
    "with a common denominator the solution is a collineation",
    printed=collineation(B, vector(xc1, yc1, xc2)),
    where=dict(zip(B, coefficients_of(adjugate(stacked)), strict=True)),
    derived=from_three.xreplace(same_denominator),
    note="Not in the paper: (21) is true if A9, A10, A11 are the same for both photographs, that is, if both "
    "projection centers lie in one plane to which both pictures are parallel.",
)

# %% [markdown]
# ## Model and object
#
# Whatever stereo model satisfies the condition is a collineation of the object, and fifteen parameters are left to it.

# %%
XM, YM, ZM = sympy.symbols("XM YM ZM")
model = vector(XM, YM, ZM)
E_ = vector(*sympy.symbols("E_1:16"))
Ep = vector(*sympy.symbols("Ep_1:16"))

# %% [markdown]
# Let object and model coordinates be such that the left photograph has the matrix $[\mathbf 1\; \mathbf 0]$; stacked on
# any plane, $\mathbf P_1$ is the collineation that makes it so.  The right photograph has $[\mathbf A\; \mathbf a]$ in
# the object and $[\mathbf C\; \mathbf c]$ in the model.  The condition is $(\mathbf a \times \mathbf A)^T$; if both
# have the same one, $\mathbf c$, which it takes to zero, is
# $\lambda \mathbf a$, and $\mathbf C$, with its free factor, has
# $\mathbf a \times \mathbf C = \mathbf a \times \mathbf A$.

# %%
A_object, C_model = Matrix(3, 3, sympy.symbols("a1:4(1:4)")), Matrix(3, 3, sympy.symbols("c1:4(1:4)"))
a, lam = vector(*sympy.symbols("a1:4")), sympy.Symbol("lam")
same_condition = [component for j in range(3) for component in cross(a, A_object.col(j) - C_model.col(j))]
v_of_cameras = vector(*(over(dot(a, A_object.col(j) - C_model.col(j)), dot(a, a)) for j in range(3)))
section.identity(
    "23#cameras",
    "two right photographs with the same condition differ by a multiple of the epipole in each column",
    printed=C_model + a * v_of_cameras.T,
    derived=A_object,
    constraints=same_condition,
    witness=dict(
        zip(
            (*A_object, *C_model, *a),
            (*(2, 1, 0, 0, 1, 0, 0, 0, 1), *(1, 0, 0, 0, 1, 0, 0, 0, 1), 1, 0, 0),
            strict=True,
        )
    ),
    note="The vector product with a leaves nothing but multiples of a.",
)

# %% [markdown]
# So $\mathbf C = \mathbf A - \mathbf a \mathbf v^T$.  The model point of an object point is where the rays of its two
# images meet, seen by the photographs of the model: the first three of four linear equations.

# %%
v = vector(*sympy.symbols("v1:4"))
left_image = vector(over(X, Z), over(Y, Z))
right_image = image(columns(A_object, a), point)
LEFT_OF_MODEL, RIGHT_OF_MODEL = columns(E3, vector(0, 0, 0)), columns(A_object - a * v.T, lam * a)
in_model = dict(zip(point, model, strict=True))
model_rows = [
    form.xreplace(in_model).xreplace(measured)
    for form, measured in (
        *((form, dict(zip(x_left, left_image, strict=True))) for form in linear_equations(LEFT_OF_MODEL, x_left)),
        (linear_equations(RIGHT_OF_MODEL, x_right)[0], dict(zip(x_right, right_image, strict=True))),
    )
]
model_of_object = solve(*linear_system(model_rows, tuple(model)))
explicit = {symbol: sympy.Integer(0) for symbol in E_} | {E_[0]: lam, E_[5]: lam, E_[10]: lam}
explicit |= dict(zip(E_[12:], v, strict=True))
section.identity(
    "23",
    "model as a collineation of the object",
    printed=collineation(E_, point),
    where=explicit,
    derived=model_of_object,
    note="Every stereo model that satisfies the condition, by 23#cameras, with its collineation: lam on the diagonal "
    "and v in the denominator.  Today this is the theorem of projective reconstruction.",
)
H = Matrix(4, 4, sympy.symbols("h1:5(1:5)"))
section.identity(
    "23#converse",
    "whatever is a collineation of the object satisfies the condition",
    printed=determinant(H) * F,
    derived=bilinear_form(P_left * H, P_right * H),
    note="The converse: any collineation of space, followed by the photographs, gives the same condition.",
)

printed_inverse = collineation(Ep, model)
printed_denominator = E_[12] * XM + Ep[13] * YM + Ep[14] * ZM + 1
denominator = Ep[12] * XM + Ep[13] * YM + Ep[14] * ZM + 1
M = matrix_of(E_)
back_rows, back_right_sides = linear_system(
    [model[i] * (M[3, :] * homogeneous_point)[0] - (M[i, :] * homogeneous_point)[0] for i in range(3)], tuple(point)
)
section.identity(
    "24",
    "object as a collineation of the model",
    printed=vector(*(form * denominator / printed_denominator for form in printed_inverse[:2]), printed_inverse[2]),
    where=dict(zip(Ep, coefficients_of(adjugate(M)), strict=True)),
    derived=solve(back_rows, back_right_sides),
    expect="misprint",
    corrected=printed_inverse,
    note="In the first two denominators the prime of E13 is missing, while all their other coefficients have theirs; "
    "the same slip twice.  As the coefficient of (23) E13 is wrong.",
)

# %% [markdown]
# ## Seven pairs of image points and five object points
#
# Seven pairs of image points give seven conditions (19), five object points fifteen equations (20).  To see that the 22
# equations are independent, let the object points of the seven pairs be unknown: seven pairs and five object points
# together have $28 + 15$ image coordinates, functions of the $22$ coefficients and of the $21$ coordinates of seven
# points.  Without these points 22 equations are left.

# %%
tie_points = [vector(*sympy.symbols(f"X_{k} Y_{k} Z_{k}")) for k in range(1, 8)]
control_points = [vector(*p) for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 2, 3))]
of_pairs = [image(matrix, p) for p in tie_points for matrix in (P_left, P_right)]
of_control = [vector(*image(P_left, p), image(P_right, p)[0]) for p in control_points]
section.rank(
    "2.1/twenty-two",
    "seven pairs of image points and five object points give 22 independent equations",
    printed=22,
    derived=rates_of_equations(Matrix.vstack(*of_pairs, *of_control), both, tie_points),
    note="The rates of the equations by the 22 coefficients.  Local: near a solution there is no other; elsewhere "
    "there can be two more, see 3/unique.",
)

# %% [markdown]
# ## Intersection from four equations
#
# Measured image points do not satisfy (19).  Least squares treat the four linear equations
# $\mathbf M \mathbf y = \mathbf b$ alike.  With $D_i$ for the determinant of the equations other than equation $i$, and
# $N_{ij}$ for the numerators of Cramer's rule, the theorem of Cauchy and Binet writes the solution of the normal
# equations as
# $y_j = \sum_i D_i N_{ij} / \sum_i D_i^2$.

# %%
M4, b = Matrix(4, 3, sympy.symbols("m1:5(1:4)")), vector(*sympy.symbols("b1:5"))


def without(matrix: Matrix, i: int) -> Matrix:
    return Matrix.vstack(*(matrix.row(k) for k in range(matrix.rows) if k != i))


def replaced(matrix: Matrix, j: int, column: Matrix) -> Matrix:
    return columns(*(column if k == j else matrix.col(k) for k in range(matrix.cols)))


def minors(matrix: Matrix) -> Matrix:
    return vector(*(determinant(without(matrix, i)) for i in range(4)))


def cauchy_binet(matrix: Matrix, right_side: Matrix) -> Matrix:
    """Return the sums over i of D_i N_ij."""
    D = minors(matrix)
    return vector(*(dot(D, minors(replaced(matrix, j, right_side))) for j in range(3)))


D = minors(M4)
sum_of_squares = dot(D, D)
least_squares = cauchy_binet(M4, b).applyfunc(lambda entry: over(entry, sum_of_squares))
normal_matrix, normal_right_side = M4.T * M4, M4.T * b

section.identity(
    "2.1/beyond/normal-determinant",
    "determinant of the normal equations",
    printed=sum_of_squares,
    derived=determinant(normal_matrix),
    note="Not in the paper: the theorem of Cauchy and Binet.",
)
section.identity(
    "2.1/beyond/normal-numerators",
    "numerators of Cramer's rule for the normal equations",
    printed=cauchy_binet(M4, b),
    derived=vector(*(determinant(replaced(normal_matrix, j, normal_right_side)) for j in range(3))),
    note="Not in the paper: the theorem of Cauchy and Binet.",
)
section.identity(
    "2.1/beyond/normal-equations",
    "the quotients solve the normal equations",
    printed=normal_right_side,
    derived=normal_matrix * least_squares,
    note="Not in the paper: where the rank is 3 the sum of squares is positive.",
)

# %% [markdown]
# The residuals are proportional to the $D_i$ with alternating signs and to the determinant of the whole system: where
# the equations agree, that is, by (19), they are zero.

# %%
disagreement = determinant(columns(M4, b))
signed = vector(*((-1) ** (i + 1) * D[i] for i in range(4)))
section.identity(
    "2.1/beyond/residuals",
    "residuals of the four equations",
    printed=signed.applyfunc(lambda entry: entry * disagreement / sum_of_squares),
    derived=b - M4 * least_squares,
    note="Not in the paper: their sum of squares is the square of the determinant, divided by the sum of squares of D.",
)
section.identity(
    "2.1/beyond/exact",
    "the solution is the object point where the four equations agree",
    printed=point,
    derived=least_squares.xreplace(dict(zip(b, M4 * point, strict=True))),
    note="Not in the paper.",
)

# %% [markdown]
# ### Rays
#
# Each determinant has both equations of one photograph: their own minors are the coordinates of the ray, which are
# linear in the image point, as $(x \mathbf p_3 - \mathbf p_1) \wedge (y \mathbf p_3 - \mathbf p_2) = \mathbf p_1 \wedge
# \mathbf p_2 + x\, \mathbf p_2 \wedge \mathbf p_3 + y\, \mathbf p_3 \wedge \mathbf p_1$.  The product $x y$ does not
# arise.

# %%
PLACES = list(combinations(range(4), 2))
Ray = dict[tuple[int, int], Scalar]


def wedge(first: Matrix, second: Matrix) -> Ray:
    return {(i, j): first[i] * second[j] - first[j] * second[i] for i, j in PLACES}


def with_ray(row: Matrix, ray: Ray, unknown: int) -> Scalar:
    """Return the determinant of an equation and a ray, the right side in place of an unknown; for 3, without it."""
    i, j, k = sorted({0, 1, 2, 3} - {unknown})
    sign = (1, -1, 1, 1)[unknown]
    return sign * (row[i] * ray[j, k] - row[j] * ray[i, k] + row[k] * ray[i, j])


augmented = columns(M4, b)
all_minors = columns(*(minors(replaced(M4, j, b)) for j in range(3)), D)
left_ray, right_ray = wedge(augmented.row(0), augmented.row(1)), wedge(augmented.row(2), augmented.row(3))
PARTNERS = ((1, right_ray), (0, right_ray), (3, left_ray), (2, left_ray))
section.identity(
    "2.1/beyond/rays",
    "the determinants from an equation of one photograph and the ray of the other",
    printed=Matrix(4, 4, lambda i, j: with_ray(augmented.row(PARTNERS[i][0]), PARTNERS[i][1], j)),
    derived=all_minors,
    note="Not in the paper.  Row i is without equation i; the last column has D, the others the numerators.",
)


def moment(left: Ray, right: Ray) -> Scalar:
    """Return the combination of two rays that vanishes where they meet, with the sign of (19)."""
    opposite = {place: tuple(k for k in range(4) if k not in place) for place in PLACES}
    return sympy.Add(*((-1) ** (i + j) * left[i, j] * right[opposite[i, j]] for i, j in PLACES))


section.identity(
    "2.1/beyond/moment",
    "the determinant of the four equations from the two rays",
    printed=moment(left_ray, right_ray),
    derived=-disagreement,
    note="Not in the paper.  The determinant (19) has the constants, not the right sides, in the last column: hence "
    "the sign.",
)


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


def equation_with_ray(matrix: Matrix, measured: Matrix, i: int, ray: Ray, unknown: int) -> Scalar:
    """Return the determinant of equation i of a photograph and a ray."""
    signed_rows = with_right_sides(matrix)
    first, last = (with_ray(signed_rows.row(k), ray, unknown) for k in (i, 2))
    return measured[i] * last - first


section.identity(
    "2.1/rays",
    "(19) is the condition that corresponding rays meet",
    printed=coplanarity,
    derived=moment(ray_of(P_left, x_left), ray_of(P_right, x_right)),
)
symbols_left, symbols_right = (dict(zip(PLACES, sympy.symbols(f"ray{k}_1:7"), strict=True)) for k in (1, 2))
rows_of_equations = columns(coefficient_rows, right_sides)
ray_values, ray_forms = {}, {}
for symbols_of_ray, matrix, measured, first in (
    (symbols_left, P_left, x_left, 0),
    (symbols_right, P_right, x_right, 2),
):
    values = wedge(rows_of_equations.row(first), rows_of_equations.row(first + 1))
    linear = ray_of(matrix, measured)
    ray_values |= {symbol: values[place] for place, symbol in symbols_of_ray.items()}
    ray_forms |= {symbol: linear[place] for place, symbol in symbols_of_ray.items()}

# %% [markdown]
# ## Code

# %%
with_images = {
    "arguments": {"A_left": A_left, "A_right": A_right, "x_left": x_left, "x_right": x_right},
    "describe": {
        "A_left": f"Left photograph: {ABOUT_A}",
        "A_right": f"Right photograph: {ABOUT_A}",
        "x_left": f"Left photograph: {ABOUT_IMAGE}",
        "x_right": f"Right photograph: {ABOUT_IMAGE}",
    },
    "example": {
        "A_left": (
            *("1.25", "0.125", "0.25", "10.5", "-0.125", "1.375"),
            *("0.0625", "20.25", "0.0025", "-0.00125", "0.005"),
        ),
        "A_right": (
            *("1.125", "-0.0625", "0.375", "-8.5", "0.0625", "1.25"),
            *("-0.125", "18.75", "-0.00375", "0.0025", "0.00625"),
        ),
        "x_left": ("26.75", "9.5"),
        "x_right": ("15.25", "5.125"),
    },
}
section.kernel(
    "collinearity.coplanarity_determinant",
    "Determinant of the condition of coplanarity, zero for homologous image points.",
    **with_images,
    derived=coplanarity,
    form=moment(symbols_left, symbols_right),
    where=ray_forms,
    claims=["18#1", "18#2", "18#3", "18#4", "19", "2.1/beyond/moment"],
)
denominator = sympy.Symbol("D")
with_left_ray = [equation_with_ray(P_right, x_right, 0, symbols_left, j) for j in range(4)]
section.kernel(
    "collinearity.intersect_three",
    "Object point from both coordinates of the left and the first coordinate of the right image point.",
    **with_images,
    derived=from_three,
    form=vector(*(with_left_ray[j] / denominator for j in range(3))),
    where={symbol: ray_forms[symbol] for symbol in symbols_left.values()} | {denominator: with_left_ray[3]},
    claims=["18#1", "18#2", "18#3", "19#sufficient", "2.1/beyond/rays"],
)
minors_of_four = Matrix(4, 4, sympy.symbols("d1:5(1:5)"))
own = (
    (P_left, x_left, 1, symbols_right),
    (P_left, x_left, 0, symbols_right),
    (P_right, x_right, 1, symbols_left),
    (P_right, x_right, 0, symbols_left),
)
minor_values = {
    minors_of_four[i, j]: with_ray(rows_of_equations.row(PARTNERS[i][0]), own[i][3], j)
    for i in range(4)
    for j in range(4)
}
minor_forms = {minors_of_four[i, j]: equation_with_ray(*own[i], j) for i in range(4) for j in range(4)}
squares = dot(minors_of_four.col(3), minors_of_four.col(3))
section.kernel(
    "collinearity.intersect",
    "Object point from four linear equations by least squares with equal weights of the equations.",
    **with_images,
    through=[let(ray_values, form=ray_forms), let(minor_values, form=minor_forms)],
    derived=vector(*(over(dot(minors_of_four.col(3), minors_of_four.col(j)), squares) for j in range(3))),
    claims=[
        *("18#1", "18#2", "18#3", "18#4"),
        *("2.1/beyond/normal-equations", "2.1/beyond/exact", "2.1/beyond/rays"),
    ],
    normwise=True,
)

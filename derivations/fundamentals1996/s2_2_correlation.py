# %% [markdown]
# # 2.2 Determination and utilization of the matrix of correlation
#
# Two images of one object: which points of them belong together?  The equation $\mathbf u'^T \mathbf C \mathbf
# u'' = 0$ says it, and it is linear in the elements of $\mathbf C$.  This section asks how many homologous points
# determine $\mathbf C$, and what $\mathbf C$ says about the geometry: lines, and the points where they meet.  In
# the names of symbols a letter `p` stands for one prime and `pp` for two.

# %%
from itertools import product

import sympy
from sympy import ImmutableMatrix, MatrixSymbol

from algebroproj_derivations.figures import ImageDrawing
from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s1_1_projection import quaternion, ratios
from algebroproj_derivations.fundamentals1996.s1_1_projection import rotation as scaled_rotation
from algebroproj_derivations.fundamentals1996.s1_3_properties_of_projection import Delta, P, y0_of_mu
from algebroproj_derivations.fundamentals1996.s2_1_spatial_intersection import (
    C,
    at_basic_points,
    correlation_matrix,
    units,
)
from algebroproj_derivations.inserting import given
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    adjugate,
    columns,
    cross,
    determinant,
    divided,
    dot,
    homogeneous,
    inverse,
    linear_system,
    over,
    solve,
    vector,
)
from algebroproj_sym.expressions.letters import Dot

section = Section("fundamentals1996", "2.2", "Determination and utilization of the matrix of correlation")

# %% [markdown]
# ## How many numbers is a matrix of correlation?
#
# **Definition.**  $\mathbf C$ has nine elements and a free factor.  Division by $c_{10}$, which must not vanish,
# leaves the eight quotients $z_{jk}$ of $\mathbf Z$.  As unknowns of linear equations they are eight.  That the
# determinant makes one of them depend on the others is not used yet.

# %%
c = Matrix(3, 3, sympy.symbols("c:3:3"))
z = Matrix(3, 3, sympy.symbols("z:3:3"))
z00, z01, z02, z10, z11, z12, z20, z21, z22 = z
Z_general = Matrix([[z00, z01, z02], [1, z11, z12], [z20, z21, z22]])

section.identity(
    "2.2.1",
    "division by one element",
    where={z[j, k]: over(c[j, k], c[1, 0]) for j, k in product(range(3), repeat=2)},
    derived=c,
)
section.count(
    "2.2/eight-unknowns",
    "of nine elements with a free factor eight are unknown",
    derived=c.applyfunc(lambda element: over(element, c[1, 0])),
    variables=tuple(c),
    kernel=[vector(*c)],
)

# %% [markdown]
# **Which element can be the divisor?**  In the normal case the base is parallel to the first axis of both image
# planes, and homologous points agree in their ordinates.  The base vectors of the basic points are $(x_j, y_j, f)$.
# Four elements of $\mathbf C$ remain, and $c_{01} = -c_{10}$ is a divisor unless $G_0$ and $G_1$ have the same
# ordinate.

# %%
distance, base_length = sympy.symbols("f d1")
abscissas_left, abscissas_right, ordinates = (sympy.symbols(f"{name}:3") for name in ("xp", "xpp", "y"))


def normal_case(abscissas: tuple[sympy.Symbol, ...]) -> Matrix:
    b0, b1, b2 = (vector(x, y, distance) for x, y in zip(abscissas, ordinates, strict=True))
    return columns(b0, b1 - b0, b2 - b0)


C_normal = correlation_matrix(normal_case(abscissas_left), normal_case(abscissas_right), vector(base_length, 0, 0))
section.structure(
    "2.2/normal-case",
    "the matrix of correlation in the normal case",
    printed=Matrix([[0, -z10, -z20], [z10, 0, 0], [z20, 0, 0]]),
    derived=C_normal,
)
section.vanishing(
    "2.2/normal-case#divisor",
    "c10 and c01 are divisors in the normal case",
    printed=(base_length, distance, ordinates[1] - ordinates[0]),
    derived=C_normal[1, 0],
)

# %% [markdown]
# **Which element is the largest?**  That depends on the ordinates of the basic points, and on nothing else.  $c_{10}$
# and $c_{01}$ are, if the ordinates of $G_0$ and $G_1$ differ at least as much as those of $G_0$ and $G_2$.  Two
# normal cases with the ordinates 0, 2, 1 and 0, 1, 2 show both.

# %%
section.identity(
    "2.2/beyond/largest",
    "quotient of the elements in the normal case",
    printed=(ordinates[2] - ordinates[0]) / (ordinates[1] - ordinates[0]),
    derived=over(C_normal[2, 0], C_normal[1, 0]),
)


def normal_case_at(*values: int) -> Matrix:
    """Return C of the normal case with f = 1 and d1 = 1 for given ordinates of the basic points."""
    origin_of_abscissas = dict.fromkeys((*abscissas_left, *abscissas_right), 0)
    return C_normal.subs(origin_of_abscissas | given(ordinates, values) | {distance: 1, base_length: 1})


def largest_square(matrix: Matrix) -> sympy.Expr:
    return max(element**2 for element in matrix)


C_with_c10, C_with_c20 = normal_case_at(0, 2, 1), normal_case_at(0, 1, 2)
section.identity(
    "2.2/no-prediction",
    "the largest element cannot be predicted",
    printed=vector(largest_square(C_with_c10), largest_square(C_with_c20)),
    derived=vector(C_with_c10[1, 0] ** 2, C_with_c20[2, 0] ** 2),
    note="That c01 or c10 is the largest is advice for an approximate normal case, and not judged; it holds for basic "
    "points like those of Fig. 1.2/1, where G1 has the ordinate that differs most from that of G0.",
)

# %% [markdown]
# ## Which equations do the points give?
#
# **Definition.**  Each pair of homologous points gives one equation, (2.1.3) divided by $c_{10}$.  It is linear in
# the eight unknowns.

# %%
up1, up2, upp1, upp2 = sympy.symbols("up1 up2 upp1 upp2")
u_left, u_right = homogeneous(vector(up1, up2)), homogeneous(vector(upp1, upp2))
unknowns = (z00, z01, z02, z11, z12, z20, z21, z22)


def equation(matrix: Matrix) -> sympy.Expr:
    return dot(u_left, matrix * u_right)


def row_of(form: sympy.Expr, variables: tuple[sympy.Symbol, ...]) -> Matrix:
    """Return the coefficients of one linear equation, and its right side, in a row."""
    coefficients, right_side = linear_system([form], variables)
    return columns(coefficients, right_side)


section.identity(
    "2.2/equation",
    "the equation of a pair of homologous points",
    where={z[j, k]: over(c[j, k], c[1, 0]) for j, k in product(range(3), repeat=2)},
    derived=over(dot(u_left, c * u_right), c[1, 0]),
)

# %% [markdown]
# Its coefficients, in the order $z_{00}, z_{01}, z_{02}, z_{11}, z_{12}, z_{20}, z_{21}, z_{22}$, and its right side:

# %%
design = row_of(equation(Z_general), unknowns)
design

# %% [markdown]
# **Print.**

# %%
section.identity("2.2/row", "one row of the system of eight unknowns", derived=design)

# %% [markdown]
# **How many points?**  Conventional photogrammetry knows the interior orientation: $\mathbf C$ is made of a rotation
# and a base, in a system of coordinates in which the left image is not rotated.  Five independent parameters need
# five points.  Without the interior orientation there are seven; the eighth point is the price of linear equations.

# %%
base_of_rotation = vector(*sympy.symbols("d1 d2 d3"))
section.count(
    "2.2/conventional",
    "conventional relative orientation needs five homologous points",
    derived=ratios(correlation_matrix(E3, scaled_rotation, base_of_rotation)),
    variables=(*quaternion, *base_of_rotation),
    kernel=[vector(*quaternion, 0, 0, 0), vector(0, 0, 0, 0, *base_of_rotation)],
)
a, b = vector(*sympy.symbols("a:3")), vector(*sympy.symbols("b:3"))
s, t = sympy.symbols("s t")
section.count(
    "2.2/beyond/seven-parameters",
    "a singular matrix has seven independent parameters but for its factor",
    printed=7,
    derived=ratios(columns(a, b, s * a + t * b)),
    variables=(*a, *b, s, t),
    kernel=[vector(*a, *b, 0, 0)],
)

# %% [markdown]
# ## What do the basic points give?
#
# Basic points that are homologous have the coordinates $(0, 0)$, $(1, 0)$ and $(0, 1)$ in both images.  So the first
# three rows of the system are numbers.  Of the rows 3 to 7 the table shows one; its last column is the right side.


# %%
def at(row: Matrix, left: tuple[int, int], right: tuple[int, int]) -> Matrix:
    return row.xreplace(given((up1, up2, upp1, upp2), map(sympy.Integer, (*left, *right))))


basic_rows = Matrix.vstack(*(at(design, unit, unit) for unit in ((0, 0), (1, 0), (0, 1))))
section.identity("table:2.2", "coefficients of the system", derived=basic_rows.col_join(design))

# %% [markdown]
# The three numerical rows are solved for three of the unknowns.  What remains is the matrix of five elements:

# %%
numbers, values = basic_rows[:, :8], basic_rows[:, 8]
basic_solution = solve(*linear_system(list(numbers * vector(*unknowns) - values), (z00, z01, z02)))
eliminated = given((z00, z01, z02), basic_solution)
Z = divided(Z_general.xreplace(eliminated))
Z

# %%
section.identity("2.2.2", "three unknowns from the basic points", derived=basic_solution)

# %% [markdown]
# Do eight points fix the eight unknowns?  Take five pairs beside the basic points, with $u''_2$ as the equation has it,
# for a matrix with $\det \mathbf Z = 0$, as section 2.1 demands.  The determinant is linear in $z_{12}$, which is
# eliminated.  The matrix and its right side together have rank 8.  The one kernel vector is the solution, with $-1$ for
# the right side, so that the matrix itself is regular.

# %%
determinant_of_correlation = determinant(Z)
singular = {z12: solve(*linear_system([determinant_of_correlation], [z12]))[0]}
Z_singular = Z.xreplace(singular)
partner = solve(*linear_system([equation(Z_singular)], [upp2]))[0]


def homologous_row(row: Matrix, index: int) -> Matrix:
    point = given((up1, up2, upp1), sympy.symbols(f"up{index}1 up{index}2 upp{index}1"))
    return row.xreplace({upp2: partner.xreplace(point), **point})


eight_rows = basic_rows.col_join(Matrix.vstack(*(homologous_row(design, index) for index in range(3, 8))))
section.rank(
    "2.2/eight-points",
    "eight points determine the eight unknowns",
    derived=eight_rows,
    kernel=[vector(*unknowns, -1).xreplace(eliminated).xreplace(singular)],
)

# %% [markdown]
# $\mathbf Z$ differs from $\mathbf C$ by a factor, which neither lines nor epipoles notice.

# %%
divided_by_c10 = c.applyfunc(lambda element: over(element, c[1, 0]))
section.up_to_scale(
    "2.2/Z-for-C#lines",
    "epipolar lines by Z in place of C",
    printed=columns(divided_by_c10 * u_right, divided_by_c10.T * u_left),
    derived=columns(c * u_right, c.T * u_left),
)
section.up_to_scale(
    "2.2/Z-for-C#epipoles",
    "epipoles by Z in place of C",
    printed=columns(
        cross(divided_by_c10.col(1), divided_by_c10.col(2)), cross(divided_by_c10.row(1).T, divided_by_c10.row(2).T)
    ),
    derived=columns(cross(c.col(1), c.col(2)), cross(c.row(1).T, c.row(2).T)),
)

# %% [markdown]
# ## Change of coordinates
#
# Must $\mathbf u$ be the coordinates?  With any homogeneous transformation $\mathbf u = \mathbf A \mathbf v$ of both
# images the equation keeps its form.  The elements of the new matrix are its values at unit vectors.  The scan
# has lost the prime of $\mathbf v'^T$.  The paper refers to section 1.4 here, by wrong numbers.

# %%
Ap, App, C_bold = (MatrixSymbol(name, 3, 3) for name in ("Ap", "App", "C"))
section.identity(
    "2.2/C-bar",
    "correlation in other coordinates",
    derived=ImmutableMatrix(3, 3, lambda i, j: Dot(Ap * units[i], C_bold * (App * units[j]))),
)
AFFINE_REFERENCE = (
    "Subsection 1.3 has nothing of the kind.  'Again' takes up subsection 1.4, where (1.4.5) holds for image "
    "coordinates of any affine system, and both references point there with one and the same digit changed.  By its "
    "content "
)
section.reference(
    "2.2/ref-1.3.5",
    "equation for the affine transformation of image coordinates",
    meant="1.4.5",
    note=AFFINE_REFERENCE + "(1.4.3), the affine transformation of space, would serve as well; (1.3.5) gives mu.",
)
section.reference(
    "2.2/ref-1.3.6",
    "equation to which the transformed correlation is analogous",
    meant="1.4.6",
    note=AFFINE_REFERENCE + "(1.4.5), the core between two affine transformations, would serve as well; (1.3.6) gives "
    "P* in y0 and u3.",
    same_as="2.2/ref-1.3.5",
)

# %% [markdown]
# Centered cartesian coordinates have $\mathbf v = \mathbf A_v \mathbf u$ and
# $\mathbf P = \mathbf R \mathbf A_v$, (1.4.1).

# %%
frames = [
    Matrix([[1, 0, 0], *(sympy.symbols(f"{name}{i}0 {name}{i}1 {name}{i}2") for i in (1, 2))]) for name in ("ap", "app")
]
rotations = [Matrix(3, 3, sympy.symbols(f"{name}:3:3")) for name in ("rp", "rpp")]
P_cartesian = [R * frame for R, frame in zip(rotations, frames, strict=True)]
section.identity(
    "2.2/C-bar#cartesian",
    "in centered cartesian coordinates it is the projective correlation matrix",
    printed=inverse(frames[0]).T * c * inverse(frames[1]),
    where=given(c, correlation_matrix(*P_cartesian, base_of_rotation)),
    derived=correlation_matrix(*rotations, base_of_rotation),
    note="The projective correlation matrix is taken to be R'^T D R'', made of the rotations of both images and the "
    "base; the papers cited for it are not available.  The orthogonality of R is not needed.",
)

# %% [markdown]
# ## The matrix referred to the basic points
#
# Five unknowns remain.  The equation of a further pair of points has these coefficients, and this right side:

# %%
remaining = (z11, z12, z20, z21, z22)
reduced = row_of(equation(Z), remaining)
reduced

# %% [markdown]
# **Print.**

# %%
Z_printed = Matrix([[0, -1 - z11, -z20 - z22], [1, z11, z12], [z20, z21, z22]])

section.identity("2.2.3", "matrix of correlation referred to the basic points", derived=Z)
section.identity("2.2.4", "one equation of the reduced system", derived=reduced)

# %% [markdown]
# **Meaning.**  Five further points determine the five unknowns.  That is not the five of conventional
# photogrammetry: the five pairs come in addition to those of the three basic points.

# %%
section.rank(
    "2.2/five-equations",
    "five further points determine the five unknowns",
    derived=Matrix.vstack(*(homologous_row(reduced, index) for index in range(3, 8))),
    kernel=[vector(*remaining, -1).xreplace(singular)],
)
section.rank(
    "2.2/five-rays",
    "five pairs of rays determine the eight unknowns",
    printed=8,
    derived=Matrix.vstack(*(homologous_row(design, index) for index in range(3, 8))),
    expect="false",
    instead="2.2/five-equations",
    note="The sentence taken literally.  It is true of conventional photogrammetry, 2.2/conventional.",
    grade="results",
    follows="Five pairs of rays leave two parameters open: without knowledge of the cameras there are "
    "{2.2/beyond/seven-parameters}. See docs/findings/seven-parameters.md.",
)

# %% [markdown]
# Are five elements five parameters?  The determinant of $\mathbf Z$ is zero, and $z_{12}$ follows from the
# others.  Four further points would do, at the cost of a cubic equation.

# %%
section.count(
    "2.2/five-parameters",
    "five elements are left of the matrix referred to the basic points",
    derived=Z_printed,
    variables=remaining,
)
section.count(
    "2.2/beyond/four-parameters",
    "the determinant leaves four of the five elements independent",
    printed=4,
    derived=Z_singular,
    variables=(z11, z20, z21, z22),
)

# %% [markdown]
# **A check.**  The three relations hold for the matrix $\mathbf C = c_{10} \mathbf Z$ of any two images that are
# referred to the same basic points, with the matrices of reconstruction and the base of (2.1.13).

# %%
C_of_basic_points = C.xreplace(at_basic_points)
elements_of_basic_points = {
    z[j, k]: over(C_of_basic_points[j, k], C_of_basic_points[1, 0]) for j, k in ((1, 1), (1, 2), (2, 0), (2, 1), (2, 2))
}
section.identity(
    "2.2.3#cameras",
    "matrix of correlation of two images",
    where={c[1, 0]: C_of_basic_points[1, 0], **elements_of_basic_points},
    derived=C_of_basic_points,
)

# %% [markdown]
# ## On which line does the partner of a point lie?
#
# **Definition.**  By (2.1.5), $\mathbf h' = \mathbf Z \mathbf u''$ and $\mathbf h'' = \mathbf Z^T \mathbf
# u'$.  The left line of a right point has the coefficients

# %%
h_left, h_right = Z * u_right, Z.T * u_left
h_left

# %% [markdown]
# **Print.**

# %%
section.identity("2.2.5#left", "epipolar line in P', as a product", derived=h_left)
section.identity("2.2.5#left-components", "epipolar line in P', by components", derived=h_left)

# %%
section.identity("2.2.5#right", "epipolar line in P'', as a product", derived=h_right)
section.identity("2.2.5#right-components", "epipolar line in P'', by components", derived=h_right)

# %% [markdown]
# ## Where do the lines meet?
#
# **Definition.**  The epipole of $P'$ makes $\mathbf h''$ vanish and the epipole of $P''$ makes $\mathbf h'$
# vanish: three equations each for two coordinates.  The second and the third have this solution, first for the
# left image:

# %%
system_left = linear_system([h_right[1], h_right[2]], (up1, up2))
system_right = linear_system([h_left[1], h_left[2]], (upp1, upp2))
epipole_left, epipole_right = solve(*system_left), solve(*system_right)
epipole_left

# %%
epipole_right

# %% [markdown]
# **Print.**  Both systems have the same determinant, and the print has it right.

# %%
D = sympy.Symbol("D")
D_printed = z11 * z22 - z12 * z21
section.identity(
    "2.2/D", "identical determinants", derived=vector(determinant(system_left[0]), determinant(system_right[0]))
)

# %% [markdown]
# Each of the four numerators has the opposite sign.  With $-D$ all four would be right, but $D$ is printed as it
# is.  The example of section 4, item c), has the signs of the corrected form: its $\mathbf Z$ gives $u'_{01} =
# 1.647$.

# %%
SIGN = (
    "Ruled out: an interchange of Z and its transpose or of the two images, which would change the letters and not the "
    "sign, and a free sign of the epipole, whose leading 1 fixes it.  No single slip of the press gives four wrong "
    "signs."
)
printed_left = vector(-z22 * (1 + z11) + z21 * (z20 + z22), -z11 * (z20 + z22) + z12 * (1 + z11))
printed_right = vector(z22 - z12 * z20, z11 * z20 - z21)
section.identity(
    "2.2.6",
    "epipole in P'",
    where={D: D_printed},
    derived=epipole_left,
    expect="error",
    corrected=-printed_left / D,
    note=SIGN,
    follows="All four numerators of (2.2.6) and (2.2.7) have the wrong sign: each epipole is mirrored in the origin. "
    "In the example the left one is at ({4/c#left.u01}, {4/c#left.u02}). The printed formula gives "
    "({4/c/beyond/as-printed#left.u01}, {4/c/beyond/as-printed#left.u02}). See "
    "docs/findings/signs-of-the-epipoles.md.",
)
section.identity(
    "2.2.7",
    "epipole in P''",
    where={D: D_printed},
    derived=epipole_right,
    expect="error",
    corrected=-printed_right / D,
    note=SIGN,
    same_as="2.2.6",
)

# %% [markdown]
# **Meaning.**  The first equation was not used.  At the solution of the other two it has the value $\det \mathbf
# Z / D$: only where $\det \mathbf Z = 0$ is there an epipole.  Five measured points do not ensure that.

# %%
first_left = h_right[0].xreplace(given((up1, up2), epipole_left))
first_right = h_left[0].xreplace(given((upp1, upp2), epipole_right))
section.identity(
    "2.2/beyond/first-equation",
    "what the first equations need",
    printed=vector(determinant_of_correlation / D, determinant_of_correlation / D),
    where={D: D_printed},
    derived=vector(first_left, first_right),
)
section.identity(
    "2.2/epipoles",
    "the epipoles solve all the equations",
    printed=Matrix.zeros(3, 2),
    derived=columns(Z.T * homogeneous(epipole_left), Z * homogeneous(epipole_right)),
    constraints=[determinant_of_correlation],
    nonzero=[D_printed],
)

# %% [markdown]
# **An example.**  A matrix with small numbers and $\det \mathbf Z = 0$.  Its epipoles are

# %%
EXAMPLE = {z11: sympy.Rational(1, 2), z20: sympy.Integer(1), z21: sympy.Integer(-1), z22: sympy.Rational(1, 4)}
Z_example = divided(divided(Z_singular).xreplace(EXAMPLE))
elements = given(Z_general, Z_example)
left_pole, right_pole = (divided(divided(pole).xreplace(elements)) for pole in (epipole_left, epipole_right))
columns(left_pole, right_pole)

# %%
SEEN = {"P1": vector(0, 1), "P2": vector(1, 1), "P3": vector(1, 2), "P4": vector(-1, 1)}
ImageDrawing(
    "Points P1 to P4 of each image, and in each image the lines on which the partners of the other image's points "
    "lie.  All lines of an image meet in its epipole E.",
    {
        "left image": ({"E": left_pole, **SEEN}, [Z_example * homogeneous(point) for point in SEEN.values()]),
        "right image": ({"E": right_pole, **SEEN}, [Z_example.T * homogeneous(point) for point in SEEN.values()]),
    },
)

# %% [markdown]
# **Why the second and the third equation?**  Any two would do: where $\det \mathbf Z = 0$ the adjugate has rank 1,
# every column of it is the epipole of $P''$ and every row the epipole of $P'$.

# %%
minors = adjugate(Z_singular)
for row in range(3):
    section.up_to_scale(
        f"2.2/beyond/two-equations#right{row}",
        f"epipole in P'' from the equations other than equation {row}",
        printed=minors.col(row),
        derived=homogeneous(epipole_right).xreplace(singular),
    )
    section.up_to_scale(
        f"2.2/beyond/two-equations#left{row}",
        f"epipole in P' from the equations other than equation {row}",
        printed=minors.row(row).T,
        derived=homogeneous(epipole_left).xreplace(singular),
    )

# %% [markdown]
# ## The line from one image alone
#
# **Definition.**  $\mathbf K \mathbf u = \boldsymbol\kappa \times \mathbf u$ by the pattern of (2.1.9), and the
# vector product changes its sign when the factors are interchanged: the same line is a product with a matrix of
# the point.  Up to a factor $\boldsymbol\kappa$ is the epipole, as $\mathbf K \mathbf u_0 = \mathbf 0$ by (2.1.11).

# %%
u = homogeneous(vector(u1, u2))
u01, u02 = sympy.symbols("u01 u02")
epipole = homogeneous(vector(u01, u02))
kappa = vector(*sympy.symbols("kappa:3"))
line = cross(kappa, u)

section.identity("2.2.8#K", "epipolar line as a product with K", derived=line)
section.identity("2.2.8", "epipolar line as a product with a matrix of the point", derived=line)

# %%
section.identity("2.2/kappa", "the matrix of the epipole, applied to kappa", derived=cross(kappa, epipole))
section.rank(
    "2.2/kappa#epipole",
    "the epipole gives kappa but for a factor",
    printed=2,
    derived=linear_system(list(cross(kappa, epipole)), tuple(kappa))[0],
    kernel=[epipole],
)

# %% [markdown]
# With the epipole for $\boldsymbol\kappa$ the line is $\mathbf u_0 \times \mathbf u$, which joins the epipole and the
# point.

# %%
joining = cross(epipole, u)
joining

# %% [markdown]
# **Print.**  In each of the two matrices one sign is wrong; the last member of (2.2.9) has the right ones.

# %%
section.identity(
    "2.2.9#u",
    "epipolar line from the epipole and the point, with the matrix of the point",
    derived=joining,
    expect="misprint",
    corrected=Matrix([[0, u2, -u1], [-u2, 0, 1], [u1, -1, 0]]) * epipole,
    note="The same matrix in (2.2.8) has the right sign.  A free factor of the line changes all three rows.  The scan "
    "alone cannot tell a slip of the scan from one of the print.",
)
section.identity(
    "2.2.9#u0",
    "epipolar line from the epipole and the point, with the matrix of the epipole",
    derived=joining,
    expect="misprint",
    corrected=Matrix([[0, -u02, u01], [u02, 0, -1], [-u01, 1, 0]]) * u,
    note="The matrix is K with (1, u01, u02) for kappa and must be skew-symmetric.  A free factor changes all "
    "elements.  The scan alone cannot tell a slip of the scan from one of the print.",
)

# %%
section.identity("2.2.9", "epipolar line from the epipole and the point, by components", derived=joining)
section.identity(
    "2.2.9#line",
    "the line joins the epipole and the point",
    printed=vector(0, 0),
    derived=vector(dot(joining, epipole), dot(joining, u)),
)

# %% [markdown]
# **Meaning.**  The line joins the epipole and the point.  For homologous points it is the line of (2.2.5).

# %%
section.up_to_scale(
    "2.2/beyond/two-ways",
    "the line through the epipole is the line of the homologous point",
    printed=cross(homogeneous(epipole_left), homogeneous(vector(up1, up2))).xreplace(singular),
    where={up1: solve(*linear_system([equation(Z_singular)], [up1]))[0]},
    derived=Z_singular * u_right,
)

# %% [markdown]
# ## The matrix of correlation from the parameters of orientation
#
# With $\mathbf P$ and $\mathbf y_0$ of section 1.3 for both images, $\mathbf C$ is a matrix of polynomials divided by
# the two determinants $\Delta'$ and $\Delta''$.  The polynomials are made of differences between the images, and
# satisfy (2.2.2).


# %%
def primed(expression: Matrix, primes: str) -> Matrix:
    """Return an expression for one of the images: mu1 becomes mup1 or mupp1, u31 becomes up31 or upp31."""
    names = {symbol: symbol.name.rstrip("0123456789") for symbol in expression.free_symbols}
    return expression.xreplace(
        {symbol: sympy.Symbol(symbol.name.replace(name, name + primes)) for symbol, name in names.items()}
    )


base = primed(y0_of_mu, "pp") - primed(y0_of_mu, "p")
C_of_cameras = correlation_matrix(primed(P, "p"), primed(P, "pp"), base)

mup1, mup2, mup3 = primed(mu, "p")
mupp1, mupp2, mupp3 = primed(mu, "pp")
up31, up32 = primed(fourth_image, "p")
upp31, upp32 = primed(fourth_image, "pp")
delta_left, delta_right, q1, q2 = sympy.symbols("deltap deltapp q1 q2")
differences = {
    q1: mupp1 * mup3 * up31 - mup1 * mupp3 * upp31,
    q2: mupp2 * mup3 * up32 - mup2 * mupp3 * upp32,
}
c12 = mup2 * mupp1 * (mup3 - mupp3) + mupp1 * mup3 * up32 * (mupp2 - mup2) + mup2 * mupp3 * upp31 * (mupp1 - mup1)
c21 = mup1 * mupp2 * (mupp3 - mup3) + mup1 * mupp3 * upp32 * (mup2 - mupp2) + mupp2 * mup3 * up31 * (mup1 - mupp1)
polynomials = Matrix(
    [
        [0, mup1 * q2, -mup2 * q1],
        [-mupp1 * q2, (mupp1 - mup1) * q2, c12],
        [mupp2 * q1, c21, (mup2 - mupp2) * q1],
    ]
)
section.identity(
    "2.2/beyond/cameras",
    "matrix of correlation from the parameters of orientation",
    printed=polynomials / (delta_left * delta_right),
    where=differences | {delta_left: primed(Delta, "p"), delta_right: primed(Delta, "pp")},
    derived=C_of_cameras,
)

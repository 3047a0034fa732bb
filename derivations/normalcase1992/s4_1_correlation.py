# %% [markdown]
# # 4 Numerical example: the correlation
#
# Eight homologous points of two images with the principal distance $c = 51.18$ mm.  From them follows the matrix of
# correlation $\mathbf Z$, from $\mathbf Z$ the epipoles, and from these approximate rotations.  The scan has lost one
# coordinate, three elements of a matrix and some signs.  Can the example still be computed again?  Yes: eight points
# say so much that a lost number can be found, and a lost sign shown.
#
# What is rational is computed exactly, and the rest with fifty digits: see `arithmetic`.  Angles are in gon.

# %%
from itertools import product

import sympy

from algebroproj_derivations.figures import ImageDrawing
from algebroproj_derivations.inserting import given
from algebroproj_derivations.normalcase1992.arithmetic import (
    arctangent,
    arctangent_of_quotient,
    cosine_and_sine,
    exact,
    rounded,
    square_root,
)
from algebroproj_derivations.normalcase1992.notation import (
    matrix_of_base,
    turn_kappa,
    turn_omega,
    turn_phi,
    unit_base,
)
from algebroproj_derivations.normalcase1992.printed_tables import LEFT, RIGHT_X, RIGHT_Y, Z_PRINTED
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    at_most,
    chosen,
    cross,
    determinant,
    divided,
    linear_system,
    solve,
    vector,
)

section = Section("normalcase1992", "4", "Numerical example: correlation")

# %% [markdown]
# ## Which points?
#
# **Print.**  Coordinates in millimeters.  In the column of $x''$ the scan has seven numbers for eight points, and the
# number of the fourth row is lost as well.

# %%
c = sympy.Rational("51.18")
lost_x = sympy.Symbol("x8pp")
left_coordinates = exact(LEFT)
right_x = [sympy.Rational(cell) for cell in RIGHT_X]
right_y = [sympy.Rational(cell) for cell in RIGHT_Y]

section.definition("4/coordinates#left", "coordinates in P', in millimeters", printed=left_coordinates)
section.definition(
    "4/coordinates#right",
    "coordinates in P'', in millimeters",
    printed=Matrix([[*right_x, lost_x], right_y]).T,
)

# %% [markdown]
# **How closely must they fit?**  The equation of correlation is $\mathbf x'^T \mathbf Z \mathbf x'' = 0$, $z_{32} = 1$.
# The printed elements have five decimals.  This allows each point an error, and no more.

# %%
HALF_UNIT = sympy.Rational("0.000005")


def image_vector(x: sympy.Expr, y: sympy.Expr) -> Matrix:
    return vector(x, y, -c)


def correlation_is_met(matrix: Matrix, left: Matrix, right: Matrix) -> sympy.Integer:
    """Return 1 if a point meets the equation of correlation as closely as the rounding of Z lets it, else 0."""
    return at_most(abs((left.T * matrix * right)[0]), sum(map(abs, left)) * sum(map(abs, right)) * HALF_UNIT)


left_points = [image_vector(*left_coordinates.row(i)) for i in range(8)]

# %% [markdown]
# ### Which sign is lost?
#
# As printed, $\mathbf Z$ is missed by every complete point.  The equation is $c^2 z_{33}$ and terms that do not contain
# $z_{33}$: the sign of this element alone repairs all of them.

# %%
Z_as_printed = exact(Z_PRINTED)
Z_rounded = Matrix(3, 3, [*Z_as_printed[:8], -Z_as_printed[8]])
complete_points = [(left_points[i], image_vector(right_x[i], right_y[i])) for i in range(7)]


def met_by(matrix: Matrix) -> sympy.Integer:
    """Return how many of the seven complete points meet the equation of correlation."""
    return sum(correlation_is_met(matrix, *pair) for pair in complete_points)


section.identity(
    "4/beyond/sign-of-z33#printed",
    "complete points that meet the equation of correlation, Z as printed",
    printed=0,
    derived=met_by(Z_as_printed),
)
section.identity(
    "4/beyond/sign-of-z33#other-sign",
    "complete points that meet the equation of correlation, Z with the other sign of z33",
    printed=7,
    derived=met_by(Z_rounded),
)

# %% [markdown]
# ### Which number is lost?
#
# The seven numbers of the column could belong to any seven of the eight points, in their order.  Only the first seven
# fit $\mathbf Z$.


# %%
def seven_points_fit(lost: int) -> sympy.Integer:
    kept = [i for i in range(8) if i != lost]
    fitting = sum(
        correlation_is_met(Z_rounded, left_points[i], image_vector(x, right_y[i]))
        for i, x in zip(kept, right_x, strict=True)
    )
    return at_most(sympy.Integer(7), fitting)


section.identity(
    "4/beyond/lost-number#place",
    "points whose x'' can be the lost number",
    printed=vector(8),
    derived=chosen(vector(*map(seven_points_fit, range(8))), vector(*range(1, 9))),
)

# %% [markdown]
# ### What was it?
#
# **Derivation.**  Seven points and one element of $\mathbf Z$ give $\mathbf Z$, and the equation of the eighth point is
# linear in $x''_8$.  The element $z_{12}$ fixes it most sharply.  As a function of $z_{12}$ it is a quotient of two
# linear functions, and its value for $0.26581$ lies between those at the two ends of the interval that is rounded to
# this number: there is no pole between the ends, the values at the ends bound all others, and both are rounded to
# $-4.346$.

# %%
z = Matrix(3, 3, sympy.symbols("z11 z12 z13 z21 z22 z23 z31 z32 z33"))
UNKNOWN = tuple(element for element in z if element != z[2, 1])


def elements_from(
    equations: list[sympy.Expr], unknowns: tuple[sympy.Symbol, ...]
) -> dict[sympy.Symbol, sympy.Rational]:
    return given(unknowns, divided(solve(*linear_system(equations, unknowns))))


def correlation_equation(left: Matrix, right: Matrix) -> sympy.Expr:
    return (left.T * z * right)[0].subs(z[2, 1], 1)


seven_equations = [correlation_equation(*pair) for pair in complete_points]
eighth_equation = correlation_equation(left_points[7], image_vector(lost_x, right_y[7]))


def lost_number(z12: sympy.Rational) -> sympy.Rational:
    known = {z[0, 1]: z12}
    others = tuple(element for element in UNKNOWN if element not in known)
    elements = known | elements_from([equation.subs(known) for equation in seven_equations], others)
    return divided(solve(*linear_system([eighth_equation.subs(elements)], [lost_x])))[0]


x8 = sympy.Rational("-4.346")
section.identity(
    "4/coordinates#8.xpp",
    "point 8, x''",
    printed=None,
    derived=rounded(lost_number(Z_rounded[0, 1]), 3),
    expect="illegible",
    corrected=x8,
    note="Solved from the printed z12 and the other coordinates, then rounded to three decimals as printed: "
    "-4.34602.  The eight other numbers of Z, its determinant to seven decimals, and the whole eighth error equation "
    "follow from -4.346 and confirm it.",
)

# %% [markdown]
# No other number with three decimals gives the printed $z_{12}$:

# %%
for end, offset in (("lower", -HALF_UNIT), ("upper", HALF_UNIT)):
    section.numeric(
        f"4/beyond/lost-number#{end}",
        f"x'' of point 8 at the {end} end of the rounding of z12",
        printed="-4.346",
        derived=lost_number(Z_rounded[0, 1] + offset),
    )

right_points = [image_vector(x, y) for x, y in zip([*right_x, x8], right_y, strict=True)]

# %% [markdown]
# ### Are the other signs right?
#
# The coordinates have kept their signs: of the 32 choices of the signs of $z_{33}$ and of the four coordinates of a
# point, one meets the equation of correlation, the one that is used.  All are tried out exactly; 1 keeps the sign.


# %%
def sign_choices(left: Matrix, right: Matrix) -> Matrix:
    choices = [*product((1, -1), repeat=5)]
    met = (
        correlation_is_met(
            Matrix(3, 3, [*Z_rounded[:8], signs[0] * Z_rounded[8]]),
            vector(signs[1] * left[0], signs[2] * left[1], left[2]),
            vector(signs[3] * right[0], signs[4] * right[1], right[2]),
        )
        for signs in choices
    )
    return chosen(vector(*met), Matrix(choices))


for i, (left, right) in enumerate(zip(left_points, right_points, strict=True), start=1):
    section.identity(
        f"4/beyond/signs#{i}",
        f"signs of z33, x', y', x'', y'' of point {i} that meet the equation of correlation",
        printed=Matrix([[1, 1, 1, 1, 1]]),
        derived=sign_choices(left, right),
    )

# %% [markdown]
# ## What is the correlation?
#
# **Definition.**  Eight equations, linear in the eight unknown elements.  **Print**, with the lost sign:

# %%
elements = elements_from([correlation_equation(*pair) for pair in zip(left_points, right_points, strict=True)], UNKNOWN)
Z = z.xreplace(elements | {z[2, 1]: sympy.Integer(1)})
LOST_SIGN = (
    "A lost sign: with the printed sign no point meets the equation of correlation, see 4/beyond/sign-of-z33#printed, "
    "while the determinant, both epipoles and the tilt of the right image follow with the other one.  The scan alone "
    "cannot tell a slip of the scan from one of the print."
)

for i, j in product(range(3), repeat=2):
    lost = (i, j) == (2, 2)
    section.numeric(
        f"4/Z#z{i + 1}{j + 1}",
        f"matrix of correlation, row {i + 1}, column {j + 1}",
        derived=Z[i, j],
        **({"expect": "misprint", "corrected": "0.01313", "note": LOST_SIGN} if lost else {}),
    )

# %% [markdown]
# **The determinant** is small, but not zero.

# %%
section.numeric(
    "4/det",
    "determinant of Z",
    derived=determinant(Z),
)

# %% [markdown]
# **Why is it not zero?**  The paper traces it to the conditions of orthonormalization, which are neglected.  They are;
# but already the correlation of two affine systems has the determinant zero, as $\det \mathbf B = 0$.  The eight
# equations do not ask for that either.

# %%
B = matrix_of_base(unit_base)
any_left, any_right = (Matrix(3, 3, sympy.symbols(f"{name}:9")) for name in ("r", "t"))
section.identity(
    "4/beyond/det",
    "determinant of the correlation of two systems, orthonormal or not",
    printed=0,
    derived=determinant(any_left.T * B * any_right),
)

# %% [markdown]
# ## Where are the epipoles?
#
# **Definition.**  $\mathbf Z^T \mathbf x'_0 = 0$ and $\mathbf Z \mathbf x''_0 = 0$ are three equations each, and $\det
# \mathbf Z \ne 0$:  there is no solution.  Two of the three give a point, their vector product.  Only the first and the
# second equation give the printed ones.


# %%
def epipole(matrix: Matrix, first: int, second: int) -> Matrix:
    """Return the point that meets two of the three equations matrix * x = 0."""
    direction = cross(matrix.row(first).T, matrix.row(second).T)
    return -c / direction[2] * direction


EPIPOLES = {"left": ("P'", Z.T), "right": ("P''", Z)}
FIRST_TWO = "From the first and the second of the three equations; the other pairs do not give it."
LAST_DIGIT = {
    "expect": "misprint",
    "corrected": "1.477",
    "note": f"{FIRST_TWO}  The unrounded Z gives 1.47654.  The Z with five decimals gives 1.47646, but misses the "
    "three other coordinates, and x would have another last digit if it were cut off: an arithmetic of about seven "
    "digits has lost the last one.",
}
for side, (image, matrix) in EPIPOLES.items():
    for component, name in enumerate(("x", "y")):
        section.numeric(
            f"4/epipole#{side}.{name}",
            f"provisional epipole in {image}, {name}",
            derived=epipole(matrix, 0, 1)[component],
            **(LAST_DIGIT if (side, name) == ("left", "y") else {"note": FIRST_TWO}),
        )


# %% [markdown]
# **What do the other choices give?**  As $\det \mathbf Z$ is not zero, they differ by up to 31 mm.

# %%
OTHER_PAIRS = {
    ("left", 0, 2): ("161.761", "1.057"),
    ("left", 1, 2): ("192.462", "1.385"),
    ("right", 0, 2): ("-167.267", "-0.408"),
    ("right", 1, 2): ("-178.269", "-0.479"),
}
for (side, first, second), values in OTHER_PAIRS.items():
    image, matrix = EPIPOLES[side]
    for component, name in enumerate(("x", "y")):
        section.numeric(
            f"4/beyond/epipole#{side}{first + 1}{second + 1}.{name}",
            f"epipole in {image} from the equations {first + 1} and {second + 1}, {name}",
            printed=values[component],
            derived=epipole(matrix, first, second)[component],
        )

# %% [markdown]
# **Meaning.**  The epipoles are far outside the images, and the epipolar lines are nearly parallel.

# %%
ImageDrawing(
    "The eight points in both images, with the epipolar lines that the correlation makes of the points of the other "
    "image.  Coordinates in millimeters.",
    {
        title: (
            {f"{i}": point[:2, :] for i, point in enumerate(points, 1)},
            [vector(-c * line[2], line[0], line[1]) for line in (matrix * point for point in other_points)],
        )
        for title, points, matrix, other_points in (
            ("P'", left_points, Z, right_points),
            ("P''", right_points, Z.T, left_points),
        )
    },
    axes=("x", "y"),
)

# %% [markdown]
# ## Which rotations belong to the epipoles?
#
# **Definition.**  With $\mathbf b = (1, 0, 0)^T$ the epipoles are images of the base: $\mathbf R^T \mathbf b =
# (\cos\varphi \cos\kappa, -\cos\varphi \sin\kappa, \sin\varphi)^T$ has the direction of $(x_0, y_0, -c)^T$, or the
# opposite one where $x_0 < 0$, as the images are turned by less than a right angle.  The sign of (2.3.1) is that of the
# left image.


# %%
def base_angles(point: Matrix) -> tuple[sympy.Rational, sympy.Rational]:
    """Return phi and kappa from an epipole."""
    first, second, third = point * sympy.sign(point[0])
    return arctangent(third, square_root(first**2 + second**2)), arctangent(-second, first)


epipole_left, epipole_right = epipole(Z.T, 0, 1), epipole(Z, 0, 1)
phi_left, kappa_left = base_angles(epipole_left)
phi_right, kappa_right = base_angles(epipole_right)

# %% [markdown]
# Rotations about the three axes, $\mathbf R' = \mathbf Y \mathbf Z$ and $\mathbf R'' = \mathbf X \mathbf Y \mathbf Z$
# by (2.1.1) and (2.1.2).


# %%
def turns(omega: sympy.Rational, phi: sympy.Rational, kappa: sympy.Rational) -> tuple[Matrix, Matrix, Matrix]:
    return turn_omega(*cosine_and_sine(omega)), turn_phi(*cosine_and_sine(phi)), turn_kappa(*cosine_and_sine(kappa))


def rotation(omega: sympy.Rational, phi: sympy.Rational, kappa: sympy.Rational) -> Matrix:
    about_x, about_y, about_z = turns(omega, phi, kappa)
    return about_x * about_y * about_z


R_left = rotation(sympy.Integer(0), phi_left, kappa_left)

# %% [markdown]
# **And the tilt?**  With the columns $\mathbf i, \mathbf j, \mathbf k$ of $\mathbf R'$, the third column of
# $\mathbf R'^T \mathbf B \mathbf R''$ is $-\cos\varphi'' (i_2 \cos\Omega + i_3 \sin\Omega)$ and so on, with $k_2 = 0$.
# Two of its elements give $\tan\Omega$; the paper has the choice between $z_{13}$ and $z_{23}$ beside $z_{33}$.

# %%
k = R_left.col(2)


def tilt(row: int) -> sympy.Rational:
    m = R_left.col(row)
    return arctangent_of_quotient(Z[2, 2] * m[1] / (Z[row, 2] * k[2] - Z[2, 2] * m[2]))


omega = tilt(1)


# %% [markdown]
# **Print.**  The paper has used $z_{23}$.

# %%
APPROXIMATE = {
    "phip": ("phi'", phi_left),
    "kappap": ("kappa'", kappa_left),
    "phipp": ("phi''", phi_right),
    "kappapp": ("kappa''", kappa_right),
    "omega": ("Omega''", omega),
}
for slug, (name, derived) in APPROXIMATE.items():
    section.numeric(f"4/approximate#{slug}", f"approximate {name}, in gon", derived=derived)

# %% [markdown]
# The other choice differs by 0.057 gon: $\mathbf Z$ is not the correlation of two calibrated images.

# %%
section.numeric(
    "4/beyond/tilt",
    "Omega'' from z13 and z33, in gon",
    printed="-0.925",
    derived=tilt(0),
)

# %% [markdown]
# ## What correlation do these rotations have?
#
# **Definition.**  $\mathbf R'^T \mathbf B \mathbf R''$, divided by $c_{32}$.  It is near $\mathbf Z$, and its
# determinant is zero.  The scan has lost three of its elements.

# %%
R_right = rotation(omega, phi_right, kappa_right)
C = R_left.T * B * R_right

RECONSTRUCTED = {(1, 0): "0.28548", (1, 1): "0.01706", (2, 2): "0.01310"}
for i, j in product(range(3), repeat=2):
    title = f"(1 / c32) R'^T B R'', row {i + 1}, column {j + 1}"
    if (i, j) not in RECONSTRUCTED:
        section.numeric(f"4/C#c{i + 1}{j + 1}", title, derived=C[i, j] / C[2, 1])
        continue
    section.identity(
        f"4/C#c{i + 1}{j + 1}",
        title,
        printed=None,
        derived=rounded(C[i, j] / C[2, 1], 5),
        expect="illegible",
        corrected=sympy.Rational(RECONSTRUCTED[i, j]),
        note="The scan has run the second and the third row into one and keeps the first two elements of the third and "
        "the last of the second.  Determined from the approximate rotations, rounded to five decimals as printed.",
    )

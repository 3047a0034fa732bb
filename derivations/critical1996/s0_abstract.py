# %% [markdown]
# # 0 Abstract, introduction and notation
#
# Of the paper only the title page survives.  What it says can be decided nevertheless: how many parameters stereo
# correlation has, what it means that the determinant of the eight equations vanishes, and how the critical
# configurations of eight points are related to those of five.
#
# Homologous points satisfy $\mathbf u'^T \mathbf C \mathbf u'' = 0$.  All vectors are homogeneous, with the leading
# component 1 where the image coordinates themselves are meant.

# %%
from itertools import product

import sympy

from algebroproj_derivations.fundamentals1996.notation import e0, e1, e2, image_e0, image_e1, image_e2, mu0, mu1, mu2
from algebroproj_derivations.fundamentals1996.s1_2_determination_of_projection import M_star as core
from algebroproj_derivations.fundamentals1996.s1_3_properties_of_projection import M_star, y0_of_mu
from algebroproj_derivations.fundamentals1996.s1_4_orthonormalized_systems import rotation
from algebroproj_derivations.fundamentals1996.s2_2_correlation import homologous_row, reduced, remaining
from algebroproj_derivations.fundamentals1996.s2_2_correlation import singular as singular_z
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    adjugate,
    columns,
    cross,
    determinant,
    diff,
    dot,
    homogeneous,
    linear_system,
    minors_of,
    over,
    rows,
    vector,
)

section = Section("critical1996", "0", "Abstract, introduction and notation")

# %% [markdown]
# ## The parameters of stereo correlation
#
# $\mathbf C$ has nine elements and a free factor.

# %%
C_general = Matrix(3, 3, sympy.symbols("c:3:3"))


def ratios(matrix: Matrix) -> Matrix:
    """Return the eight quotients of the elements by the element (1, 0)."""
    return vector(*(over(element, matrix[1, 0]) for place, element in enumerate(matrix) if place != 3))


section.count(
    "0/introduction-eight-components",
    "a 3 by 3 matrix has eight significant components",
    printed=8,
    derived=ratios(C_general),
    variables=tuple(C_general),
    kernel=[vector(*C_general)],
    note="As components of any matrix but for a common factor, which is what eight linear equations can determine.",
)

# %% [markdown]
# But $\det \mathbf C = 0$: the third column is a combination of the other two.

# %%
first, second = vector(*sympy.symbols("a:3")), vector(*sympy.symbols("b:3"))
s, t = sympy.symbols("s t")
C_singular = columns(first, second, s * first + t * second)
of_singular = (*first, *second, s, t)

section.identity("0/beyond/determinant", "the determinant is zero", printed=0, derived=determinant(C_singular))
EIGHT = {"derived": ratios(C_singular), "variables": of_singular, "kernel": [vector(*first, *second, 0, 0)]}
section.count(
    "0/introduction-eight-parameters",
    "stereo correlation determines eight parameters",
    printed=8,
    **EIGHT,
    expect="false",
    instead="0/beyond/seven-parameters",
    note="Eight independent parameters, the usual set of five and three others, as the sentence goes on: the usual "
    "five are those of calibrated images, 0/introduction-usual-set, and here they are four, 0/beyond/four-and-three.  "
    "Favourable reading, of the components that the linear system determines: 0/introduction-eight-components.",
    grade="results",
    follows="The eight quotients satisfy det(C) = 0, so that {0/beyond/seven-parameters} of them are independent. "
    "Seven pairs of points are enough, at the price of a cubic equation. See "
    "docs/findings/seven-parameters.md.",
)
section.count(
    "0/beyond/seven-parameters",
    "stereo correlation has seven independent parameters",
    printed=7,
    **EIGHT,
    note="Not in the paper: one of the eight components follows from det(C) = 0, which the linear system does not use.",
)

# %% [markdown]
# The usual relative orientation of calibrated images has five parameters.  Its matrix of correlation is the product of
# the matrix of the base and a rotation, given by a quaternion.

# %%
quaternion = sorted(rotation.free_symbols, key=str)
base = vector(*sympy.symbols("d:3"))


def matrix_of(axis: Matrix) -> Matrix:
    """Return the skew-symmetric matrix of the vector product with a vector."""
    return columns(*(cross(axis, Matrix.eye(3).col(j)) for j in range(3)))


section.count(
    "0/introduction-usual-set",
    "the usual set of relative orientation",
    printed=5,
    derived=ratios(matrix_of(base) * rotation),
    variables=(*base, *quaternion),
    kernel=[vector(*base, 0, 0, 0, 0), vector(0, 0, 0, *quaternion)],
    note="Calibrated images: base and rotation, but for the length of the base.",
)

# %% [markdown]
# The affine systems of three homologous points make three components of $\mathbf Z$ known, equation (2.2.3) of the
# *Fundamentals*.  What remains are five components, tied by $\det \mathbf Z = 0$.

# %%
remaining_singular = vector(*remaining).xreplace(singular_z)
free = tuple(symbol for symbol in remaining if symbol not in singular_z)
section.count(
    "0/beyond/four-and-three",
    "beside the three affine parameters there are four others",
    printed=4,
    derived=remaining_singular,
    variables=free,
    note="Not in the paper: 7 = 4 + 3.  Five of the components of Z remain, tied by det(Z) = 0.",
)

# %% [markdown]
# The three points are $(0, 0)$, $(1, 0)$, $(0, 1)$ in both images: images of the unit points in the plane $y_3 = 0$.

# %%
section.identity(
    "0/introduction-coordinate-plane",
    "the affine systems of the images are images of the first coordinate plane",
    printed=columns(mu0 * image_e0, mu1 * image_e1, mu2 * image_e2),
    derived=core[:3, :] * columns(*map(homogeneous, (e0, e1, e2))),
    note="The origin and the unit points of the plane y3 = 0 become origin and unit points of the image.  Between them "
    "the image of the plane is projective, not affine: see (1.3.1) of the Fundamentals.",
)
y1, y2 = sympy.symbols("y1 y2")
plane_image = M_star[:3, :] * vector(1, y1, y2, 0)
section.vanishing(
    "0/beyond/coordinate-plane",
    "where the coordinates of the plane and of its image agree",
    printed=(y1, mu1 - 1 + (1 - mu1) * y1 + (1 - mu2) * y2),
    derived=over(plane_image[1], plane_image[0]) - y1,
    note="Not in the paper: u1 = y1 on two lines only, unless mu1 = mu2 = 1.",
)

# %% [markdown]
# ## The eight equations
#
# The coefficients of the elements of $\mathbf C$ are the products of the image coordinates, and nothing else.

# %%
u_left, u_right = (homogeneous(vector(*sympy.symbols(f"{name}1 {name}2"))) for name in ("up", "upp"))


def coefficients(left: Matrix, right: Matrix) -> list[sympy.Expr]:
    return [left[i] * right[j] for i, j in product(range(3), repeat=2)]


coplanarity = dot(u_left, C_general * u_right)
section.identity(
    "0/introduction-coefficients",
    "the coefficients are composed of the image coordinates",
    printed=vector(*coefficients(u_left, u_right)),
    derived=linear_system([coplanarity], list(C_general))[0].T,
)

# %% [markdown]
# Two cameras, $\mathbf M'$ and $\mathbf M''$ (3 by 4).  By a projective change of the object coordinates, which no
# image notices, the left one becomes $[\mathbf E\; \mathbf 0]$ and the right one $[\mathbf F\; \mathbf f]$: the images
# of $\mathbf y = (\mathbf v, w)$ are $\mathbf v$ and $\mathbf F \mathbf v + w \mathbf f$.  They are coplanar with
# $\mathbf f$, hence $\mathbf C = ([\mathbf f]_\times \mathbf F)^T$.

# %%
F, f = Matrix(3, 3, sympy.symbols("f:3:3")), vector(*sympy.symbols("g:3"))
M_left = columns(*(Matrix.eye(3).col(j) for j in range(3)), vector(0, 0, 0))
M_right = columns(F, f)
C = (matrix_of(f) * F).T
model = [vector(*sympy.symbols(f"y{k}_:4")) for k in range(8)]


def equations(points: list[Matrix], left: Matrix = M_left, right: Matrix = M_right) -> Matrix:
    """Return the coefficients of the homogeneous system, a row for each point."""
    return Matrix([coefficients(left * point, right * point) for point in points])


section.rank(
    "0/abstract-eight-equations",
    "eight irregularly distributed points determine the components",
    printed=8,
    derived=equations(model),
    kernel=[vector(*C)],
    note="Eight general points and two general cameras: the solutions are the multiples of C alone.",
)

# %% [markdown]
# ## What is critical
#
# A second solution $\mathbf G$ of the eight equations is a quadric $\mathbf y^T \mathbf M'^T \mathbf G \mathbf M''
# \mathbf y = 0$ that contains the eight points.  It contains the centers as well, where $\mathbf M' \mathbf y'_0$ and
# $\mathbf M'' \mathbf y''_0$ vanish.

# %%
G = Matrix(3, 3, sympy.symbols("h:3:3"))
y = vector(*sympy.symbols("y:4"))
pairs = [(i, j) for i in range(4) for j in range(i, 4)]
monomials = vector(*(y[i] * y[j] for i, j in pairs))


def quadric(matrix: Matrix) -> Matrix:
    """Return the ten coefficients of the quadric that belongs to a matrix G."""
    doubled = M_left.T * matrix * M_right + M_right.T * matrix.T * M_left
    return vector(*(doubled[i, j] / 2 if i == j else doubled[i, j] for i, j in pairs))


center_left = vector(0, 0, 0, 1)
center_right = vector(*(adjugate(F) * f), -determinant(F))

section.identity(
    "0/beyond/quadric#form",
    "the equation of a solution, in object coordinates, is a quadric",
    printed=dot(quadric(G), monomials),
    derived=dot(M_left * y, G * (M_right * y)),
)
section.identity(
    "0/beyond/quadric#centers",
    "the quadric contains both centers of projection",
    printed=vector(0, 0),
    derived=vector(*(dot(M_left * o, G * (M_right * o)) for o in (center_left, center_right))),
)
section.rank(
    "0/beyond/quadric#independent",
    "the nine elements of G give eight independent quadrics",
    printed=8,
    derived=Matrix.hstack(*(diff(quadric(G), element) for element in G)),
    kernel=[vector(*C)],
    note="C alone gives no quadric: its equation holds for all points.",
)
section.rank(
    "0/beyond/quadric#all",
    "of ten coefficients of a quadric the two centers leave eight",
    printed=2,
    derived=rows(*(monomials.xreplace(dict(zip(y, o, strict=True))) for o in (center_left, center_right))),
    note="Together with 0/beyond/quadric#centers and #independent: every quadric through both centers belongs to a "
    "matrix G.  Hence eight equations have rank less than eight exactly if the eight points and both centers lie on a "
    "quadric, whatever its kind.  It need not be ruled: that is necessary only if G has to be a matrix of correlation "
    "itself, det(G) = 0.",
)

# %% [markdown]
# ## The determinant
#
# The linear system divides by one component, $c_{10}$, and its 8 by 8 matrix lacks that column.  The nine minors of the
# 8 by 9 matrix, with alternating signs, are a solution of the eight equations.  Either they are all zero, and the
# configuration is critical, or they are a multiple of $\mathbf C$: the determinant of the system is zero in critical
# configurations and where $c_{10} = 0$.
#
# An example with seven points and two cameras that are given, and a free eighth point.

# %%
CAMERA = dict(zip((*F, *f), map(sympy.Integer, (1, 2, 0, 1, 1, 1, 0, 1, 2, 3, 1, 2)), strict=True))
SEVEN = ((1, 0, 0, 1), (1, 1, 0, 2), (1, 0, 1, 3), (2, 1, 1, 1), (1, 2, 3, -1), (3, 1, -1, 2), (1, -1, 2, 1))
seven_points = [vector(*map(sympy.Integer, point)) for point in SEVEN]


def signed_minors(matrix: Matrix) -> Matrix:
    """Return the vector of signed minors, which a matrix with one column more than rows takes to zero."""
    minor, everything = minors_of(matrix), tuple(range(matrix.cols))
    return vector(*((-1) ** j * minor(everything[:-1], everything[:j] + everything[j + 1 :]) for j in everything))


def on_quadric(point: Matrix) -> Matrix:
    return monomials.xreplace(dict(zip(y, point, strict=True)))


minors = signed_minors(equations([*seven_points, y], right=M_right.xreplace(CAMERA)))
C_example = C.xreplace(CAMERA)
nine_points = [*seven_points, center_left, center_right.xreplace(CAMERA)]
through_nine = signed_minors(rows(*map(on_quadric, nine_points)))

section.identity(
    "0/beyond/divisor",
    "the minors of the eight equations are a multiple of the components",
    printed=C_example[1, 0] * minors,
    derived=minors[3] * vector(*C_example),
    note="Not in the paper.  The minor of index 3 is the determinant of the 8 by 8 system, but for its sign.  It is "
    "zero in critical configurations and where c10 = 0.  For any points and cameras this follows from "
    "0/abstract-eight-equations: with all coordinates as variables the solutions are the multiples of C, and the "
    "minors are one of them.",
)
section.vanishing(
    "0/abstract-determinant",
    "critical configurations are characterized by the vanishing of the determinant",
    printed=(dot(through_nine, monomials),),
    derived=minors[3],
    note="The determinant as a function of the eighth point is zero exactly on the quadric through the other seven "
    "points and both centers, if c10 is not zero, as in this example.",
)

# %% [markdown]
# With the base parallel to the first axis of both images $c_{10} = 0$: let homogeneous points of the object be
# $(z, x, y, w)$ and $x$ the direction of the base.

# %%
base_direction = vector(0, 1, 0)
M_normal = columns(*(Matrix.eye(3).col(j) for j in range(3)), -base_direction)
C_normal = matrix_of(base_direction)
eight_of_normal = equations(model, right=M_normal)
LACKING = [j for j in range(9) if j != 3]

section.structure(
    "0/beyond/normal-case",
    "matrix of correlation for a base parallel to the first axis",
    printed=Matrix([[0, 0, 1], [0, 0, 0], [-1, 0, 0]]),
    derived=C_normal,
    note="Not in the paper: c10 and c01 are zero, c20 and c02 are not.",
)
section.rank(
    "0/beyond/divisor#zero",
    "the 8 by 8 system of eight general points is singular for this divisor",
    printed=7,
    derived=eight_of_normal.extract(list(range(8)), LACKING),
    kernel=[vector(*(C_normal[j] for j in LACKING))],
    note="Not in the paper.",
)
section.rank(
    "0/beyond/divisor#regular",
    "the eight equations of the same points are independent",
    printed=8,
    derived=eight_of_normal,
    kernel=[vector(*C_normal)],
    note="Not in the paper: the determinant of the system is zero, 0/beyond/divisor#zero, and the configuration is not "
    "critical; another divisor would do.",
)

# %% [markdown]
# ## Five points
#
# The five orientation points of the abstract are those of calibrated images.  Five equations of coplanarity for two
# components of the base and three rotations are singular, to first order, in critical configurations.  The right image
# may have been rotated before: take the base parallel to the $x$-axis and no rotation.

# %%
db0, db2 = sympy.symbols("db0 db2")
turn = vector(*sympy.symbols("turn:3"))
changes = (db0, db2, *turn)
unchanged = dict.fromkeys(changes, sympy.Integer(0))
changed = matrix_of(base_direction + vector(db0, 0, db2)) * (Matrix.eye(3) + matrix_of(turn))
derivatives = [diff(changed, change).xreplace(unchanged) for change in changes]


def orientation_row(point: Matrix) -> list[sympy.Expr]:
    """Return the derivatives of the condition of coplanarity with respect to the five parameters."""
    return [dot(M_left * point, derivative * (M_normal * point)) for derivative in derivatives]


pz, px, py, pw = point = vector(*sympy.symbols("z x y w"))
section.identity(
    "0/beyond/five-points",
    "the five derivatives",
    printed=vector(-py * pw, pz * pw, pz * (px - pw), -(py**2) - pz**2, py * (px - pw)),
    derived=vector(*orientation_row(point)),
    note="Not in the paper.  Five points are critical exactly if they lie on a quadric with the terms y w, z w, x z, "
    "x y and y^2 + z^2 alone: both centers lie on it, (0, 0, 0, 1) and (0, 1, 0, 1), but it is no general quadric "
    "through them.",
)

# %% [markdown]
# The dangerous cylinder $y^2 + z^2 = z w$ contains the base.  A point of it is
# $(1,\; x,\; t,\; 1 + t^2)$ with any $x$ and $t$.

# %%
CYLINDER = (0, -1, 0, -1, 0)
G_cylinder = sum((step * D for step, D in zip(CYLINDER, derivatives, strict=True)), Matrix.zeros(3, 3))
on_cylinder = [vector(1, x, t, 1 + t**2) for x, t in zip(sympy.symbols("x:8"), sympy.symbols("t:8"), strict=True)]

section.identity(
    "0/beyond/cylinder",
    "the cylinder is a critical surface of five points",
    printed=py**2 + pz**2 - pz * pw,
    derived=dot(M_left * point, G_cylinder * (M_normal * point)),
    note="Not in the paper: the classical example.",
)
section.rank(
    "0/abstract-five-points#five",
    "five points of the cylinder are critical for five parameters",
    printed=4,
    derived=Matrix([orientation_row(p) for p in on_cylinder[:5]]),
    kernel=[vector(*CYLINDER)],
    note="The well-known critical configuration, by example.",
)
section.rank(
    "0/abstract-five-points",
    "the critical surface of five points is critical for eight points",
    printed=7,
    derived=equations(on_cylinder, right=M_normal),
    kernel=[vector(*C_normal), vector(*G_cylinder)],
    note="All eight points are on the surface.  In general: a change of C that leaves five "
    "coplanarities alone is a matrix G as above, and its quadric goes through both centers.",
)
section.rank(
    "0/beyond/five-among-eight",
    "five points of the cylinder and three others are not critical",
    printed=8,
    derived=equations([*on_cylinder[:5], *model[5:]], right=M_normal),
    kernel=[vector(*C_normal)],
    note="Not in the paper: the configuration of five points is critical for eight if all eight are on its surface, "
    "0/abstract-five-points.",
)

# %% [markdown]
# The additional conditions: eight points on the elliptic paraboloid $x^2 - x w + y^2 = z w$, which contains both
# centers and is not ruled.

# %%
G_paraboloid = Matrix([[0, 1, 0], [-1, 1, 0], [0, 0, 1]])
on_paraboloid = [
    vector(x**2 - x + t**2, x, t, 1) for x, t in zip(sympy.symbols("x:8"), sympy.symbols("t:8"), strict=True)
]

section.identity(
    "0/beyond/paraboloid",
    "the quadric of the second solution",
    printed=px**2 - px * pw + py**2 - pz * pw,
    derived=dot(M_left * point, G_paraboloid * (M_normal * point)),
    note="Not in the paper.  det(G) = 1: the second solution is no matrix of correlation, and still the linear system "
    "is singular.",
)
doubled = M_left.T * G_paraboloid * M_normal + M_normal.T * G_paraboloid.T * M_left
section.identity(
    "0/beyond/paraboloid#ruled",
    "the determinant of the quadric is negative",
    printed=-4,
    derived=determinant(doubled),
    note="Not in the paper: a ruled quadric has no negative determinant.  The matrix is twice that of the quadric.",
)
section.rank(
    "0/abstract-additional",
    "eight points have critical configurations of their own",
    printed=7,
    derived=equations(on_paraboloid, right=M_normal),
    kernel=[vector(*C_normal), vector(*G_paraboloid)],
    note="The eight equations are dependent.",
)
section.rank(
    "0/abstract-additional#five",
    "their points are not critical for five parameters",
    printed=5,
    derived=Matrix([orientation_row(p) for p in on_paraboloid[:5]]),
    note="Five of the eight points of 0/abstract-additional.",
)

# %% [markdown]
# ## Notation
#
# The list of symbols has lost most of its indices.

# %%
section.definition(
    "0/notation-vectors", "quasihomogeneous vectors", printed=homogeneous(vector(*sympy.symbols("y1:4")))
)
section.definition(
    "0/notation-center",
    "center of projection",
    printed=homogeneous(y0_of_mu),
    note="Read as y_0, a quasihomogeneous vector as the points have; given here by the parameters of the "
    "Fundamentals, 1.3.",
)
section.rank(
    "0/notation-P",
    "a regular projective matrix",
    printed=4,
    derived=Matrix(4, 4, sympy.symbols("p:4:4")),
    note="Indices 0 to 3 for rows and columns.",
)
section.rank(
    "0/notation-M",
    "a singular projective matrix",
    printed=3,
    derived=M_star[:3, :],
    kernel=[homogeneous(y0_of_mu)],
    note="Rows 0 to 2, as far as the damaged indices tell; columns 0 to 3, for it acts on y.  Singular means that it "
    "annihilates a point, the center of projection.  The matrix is that of (1.2.3) of the Fundamentals.",
)
section.definition("0/notation-C", "matrix of correlation", printed=C_general, note="Indices 0 to 2.")
section.rank(
    "0/notation-A",
    "the matrix of coefficients has the indices 3 to 7",
    printed=5,
    derived=Matrix.vstack(*(homologous_row(reduced, k) for k in range(3, 8)))[:, :5],
    note="Five rows and columns: the equations of the points 3 to 7 for the five components that the basic points 0 to "
    "2 leave, (2.2.4) of the Fundamentals.  The matrix of the eight equations of the abstract has eight.",
)
Q = Matrix(4, 4, lambda i, j: sympy.Symbol(f"q{min(i, j)}{max(i, j)}"))
section.count(
    "0/notation-Q",
    "a quadric surface",
    printed=9,
    derived=vector(*(over(Q[i, j], Q[0, 0]) for i, j in pairs[1:])),
    variables=tuple(Q[i, j] for i, j in pairs),
    kernel=[vector(*(Q[i, j] for i, j in pairs))],
    note="A symmetric matrix, indices 0 to 3, but for a common factor: nine points determine a quadric.",
)
factor = sympy.Symbol("mu")
section.definition(
    "0/notation-mu",
    "local stretching coefficient",
    printed=factor * vector(1, *sympy.symbols("u1 u2")),
    note="The letter is lost; the Fundamentals have mu.",
)

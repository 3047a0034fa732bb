# %% [markdown]
# # 0 Abstract, introduction and notation
#
# When do eight points fail?  Stereo correlation determines the relation of two images from eight pairs of points, by
# linear equations, and sometimes their determinant vanishes.  Of the paper only the title page survives.  What it says
# can be decided nevertheless: how many parameters there are, what a vanishing determinant means, and what eight points
# have to do with the five of classical photogrammetry.
#
# Homologous points satisfy $\mathbf u'^T \mathbf C \mathbf u'' = 0$.  All vectors are homogeneous; where the image
# coordinates themselves are meant, the leading component is 1.

# %%
from itertools import product

import sympy

from algebroproj_derivations.cameras import signed_minors, skew
from algebroproj_derivations.figures import QuadricDrawing
from algebroproj_derivations.fundamentals1996.notation import e0, e1, e2, image_e0, image_e1, image_e2, mu0, mu1, mu2
from algebroproj_derivations.fundamentals1996.s1_2_determination_of_projection import M_star as core
from algebroproj_derivations.fundamentals1996.s1_3_properties_of_projection import M_star, y0_of_mu
from algebroproj_derivations.fundamentals1996.s1_4_orthonormalized_systems import rotation
from algebroproj_derivations.fundamentals1996.s2_2_correlation import homologous_row, reduced, remaining
from algebroproj_derivations.fundamentals1996.s2_2_correlation import singular as singular_z
from algebroproj_derivations.inserting import given, inserted
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    adjugate,
    columns,
    determinant,
    diff,
    dot,
    homogeneous,
    linear_system,
    over,
    rows,
    vector,
)

section = Section("critical1996", "0", "Abstract, introduction and notation")

# %% [markdown]
# ## How many parameters has stereo correlation?
#
# **Definition.**  $\mathbf C$ has nine elements and a free factor.  Divided by $c_{10}$ it has eight quotients.  As
# components of any matrix they are independent, and eight linear equations can determine them.

# %%
C_general = Matrix(3, 3, sympy.symbols("c:3:3"))


def ratios(matrix: Matrix) -> Matrix:
    """Return the eight quotients of the elements by the element (1, 0)."""
    return vector(*(over(element, matrix[1, 0]) for place, element in enumerate(matrix) if place != 3))


section.count(
    "0/introduction-eight-components",
    "a 3 by 3 matrix has eight significant components",
    derived=ratios(C_general),
    variables=tuple(C_general),
    kernel=[vector(*C_general)],
)

# %% [markdown]
# **But $\mathbf C$ is not any matrix.**  Its determinant is zero: the third column is a combination of the other two.

# %%
first, second = vector(*sympy.symbols("a:3")), vector(*sympy.symbols("b:3"))
s, t = sympy.symbols("s t")
C_singular = columns(first, second, s * first + t * second)
of_singular = (*first, *second, s, t)

section.identity("0/beyond/determinant", "the determinant is zero", printed=0, derived=determinant(C_singular))

# %% [markdown]
# **Print.**  "Eight parameters", the usual set of five and three others.  Seven are independent: one of the eight
# quotients follows from the rest, which the linear system does not use.

# %%
EIGHT = {"derived": ratios(C_singular), "variables": of_singular, "kernel": [vector(*first, *second, 0, 0)]}
section.count(
    "0/introduction-eight-parameters",
    "stereo correlation determines eight parameters",
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
)

# %% [markdown]
# **Which are the usual five?**  Those of calibrated images.  There $\mathbf C$ is the product of the matrix of the
# base, whose length is free, and a rotation, given by a quaternion.

# %%
quaternion = sorted(rotation.free_symbols, key=str)
base = vector(*sympy.symbols("d:3"))


section.count(
    "0/introduction-usual-set",
    "the usual set of relative orientation",
    printed=5,
    derived=ratios(skew(base) * rotation),
    variables=(*base, *quaternion),
    kernel=[vector(*base, 0, 0, 0, 0), vector(0, 0, 0, *quaternion)],
)

# %% [markdown]
# **And the three others?**  The affine systems of three homologous points make three components of $\mathbf Z$ known:
# equation (2.2.3) of the *Fundamentals*.  Five remain.  They are tied by $\det \mathbf Z = 0$, so that $7 = 4 + 3$.

# %%
remaining_singular = vector(*remaining).xreplace(singular_z)
free = tuple(symbol for symbol in remaining if symbol not in singular_z)
section.count(
    "0/beyond/four-and-three",
    "beside the three affine parameters there are four others",
    printed=4,
    derived=remaining_singular,
    variables=free,
)

# %% [markdown]
# The paper calls these systems images of the first coordinate plane.  The three points are $(0, 0)$, $(1, 0)$, $(0, 1)$
# in both images, and images of the origin and the unit points of the plane $y_3 = 0$.

# %%
section.identity(
    "0/introduction-coordinate-plane",
    "the affine systems of the images are images of the first coordinate plane",
    printed=columns(mu0 * image_e0, mu1 * image_e1, mu2 * image_e2),
    derived=core[:3, :] * columns(*map(homogeneous, (e0, e1, e2))),
)

# %% [markdown]
# Between the three points the image of the plane is projective, not affine.  $u_1 = y_1$ on two lines only, unless
# $\mu_1 = \mu_2 = 1$.

# %%
y1, y2 = sympy.symbols("y1 y2")
plane_image = M_star[:3, :] * vector(1, y1, y2, 0)
section.vanishing(
    "0/beyond/coordinate-plane",
    "where the coordinates of the plane and of its image agree",
    printed=(y1, mu1 - 1 + (1 - mu1) * y1 + (1 - mu2) * y2),
    derived=over(plane_image[1], plane_image[0]) - y1,
)

# %% [markdown]
# ## Which eight equations?
#
# **Definition.**  The coefficients of the elements of $\mathbf C$ are the products of the image coordinates, and
# nothing else.

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
# **Do they have one solution?**  Take two cameras, $\mathbf M'$ and $\mathbf M''$ (3 by 4).  By a projective change of
# the object coordinates, which no image notices, the left one becomes $[\mathbf E\; \mathbf 0]$ and the right one
# $[\mathbf F\; \mathbf f]$: the images of $\mathbf y = (\mathbf v, w)$ are $\mathbf v$ and $\mathbf F \mathbf v + w
# \mathbf f$.  They are coplanar with $\mathbf f$, hence $\mathbf C = ([\mathbf f]_\times \mathbf F)^T$.  For eight
# general points and two general cameras the solutions are the multiples of $\mathbf C$ alone.

# %%
F, f = Matrix(3, 3, sympy.symbols("f:3:3")), vector(*sympy.symbols("g:3"))
M_left = columns(*(Matrix.eye(3).col(j) for j in range(3)), vector(0, 0, 0))
M_right = columns(F, f)
C = (skew(f) * F).T
model = [vector(*sympy.symbols(f"y{k}_:4")) for k in range(8)]


def equations(points: list[Matrix], left: Matrix = M_left, right: Matrix = M_right) -> Matrix:
    """Return the coefficients of the homogeneous system, a row for each point."""
    return Matrix([coefficients(left * point, right * point) for point in points])


section.rank(
    "0/abstract-eight-equations",
    "eight irregularly distributed points determine the components",
    derived=equations(model),
    kernel=[vector(*C)],
)

# %% [markdown]
# ## When is there a second solution?
#
# **Derivation.**  Let $\mathbf G$ be one.  Then $\mathbf y^T \mathbf M'^T \mathbf G \mathbf M'' \mathbf y = 0$ for the
# eight points: they lie on a quadric.  It contains both centers as well, where $\mathbf M' \mathbf y'_0$ and $\mathbf
# M'' \mathbf y''_0$ vanish.

# %%
G = Matrix(3, 3, sympy.symbols("h:3:3"))
y = vector(*sympy.symbols("y:4"))
pairs = [(i, j) for i in range(4) for j in range(i, 4)]
monomials = vector(*(y[i] * y[j] for i, j in pairs))


def quadric(matrix: Matrix) -> Matrix:
    """Return the ten coefficients of the quadric that belongs to a matrix G."""
    doubled = M_left.T * matrix * M_right + M_right.T * matrix.T * M_left
    return vector(*(doubled[i, j] / 2 if i == j else doubled[i, j] for i, j in pairs))


def on_quadric(point: Matrix) -> Matrix:
    """Return the products of the coordinates of a point, the coefficients of its equation for a quadric."""
    return inserted(monomials, y, point)


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

# %% [markdown]
# **Is every quadric through both centers such a one?**  $\mathbf C$ alone gives no quadric: its equation holds for all
# points.  The nine elements of $\mathbf G$ give eight independent quadrics.  Of the ten coefficients of a quadric the
# two centers leave eight.  So it is.

# %%
section.rank(
    "0/beyond/quadric#independent",
    "the nine elements of G give eight independent quadrics",
    printed=8,
    derived=Matrix.hstack(*(diff(quadric(G), element) for element in G)),
    kernel=[vector(*C)],
)
section.rank(
    "0/beyond/quadric#all",
    "of ten coefficients of a quadric the two centers leave eight",
    printed=2,
    derived=rows(*(on_quadric(o) for o in (center_left, center_right))),
)

# %% [markdown]
# **Meaning.**  Eight equations have rank less than eight exactly if the eight points and both centers lie on a quadric,
# whatever its kind.  It need not be ruled: that is necessary only if $\mathbf G$ has to be a matrix of correlation
# itself, $\det \mathbf G = 0$.

# %% [markdown]
# ## Does the determinant tell?
#
# **Derivation.**  The linear system divides by one component, $c_{10}$, and its 8 by 8 matrix lacks that column.  The
# nine minors of the 8 by 9 matrix, with alternating signs, are a solution of the eight equations.  Either they are all
# zero, and the configuration is critical, or they are a multiple of $\mathbf C$.  So the determinant of the system is
# zero in critical configurations, and where $c_{10} = 0$.
#
# **An example**: seven points and two cameras are given, and an eighth point is free.

# %%
CAMERA = given((*F, *f), map(sympy.Integer, (1, 2, 0, 1, 1, 1, 0, 1, 2, 3, 1, 2)))
SEVEN = ((1, 0, 0, 1), (1, 1, 0, 2), (1, 0, 1, 3), (2, 1, 1, 1), (1, 2, 3, -1), (3, 1, -1, 2), (1, -1, 2, 1))
seven_points = [vector(*map(sympy.Integer, point)) for point in SEVEN]


minors = signed_minors(equations([*seven_points, y], right=M_right.xreplace(CAMERA)))
C_example = C.xreplace(CAMERA)
nine_points = [*seven_points, center_left, center_right.xreplace(CAMERA)]
through_nine = signed_minors(rows(*map(on_quadric, nine_points)))

section.identity(
    "0/beyond/divisor",
    "the minors of the eight equations are a multiple of the components",
    printed=C_example[1, 0] * minors,
    derived=minors[3] * vector(*C_example),
)

# %% [markdown]
# The minor of index 3 is the determinant of the system, but for its sign.  For any points and cameras the same follows
# from 0/abstract-eight-equations: the solutions are the multiples of $\mathbf C$, and the minors are one of them.
#
# **Print.**  Critical configurations are characterized by the vanishing of the determinant.  In the example $c_{10}$ is
# not zero, and this is right: as a function of the eighth point the determinant is zero exactly on the quadric through
# the other seven points and both centers.

# %%
section.vanishing(
    "0/abstract-determinant",
    "critical configurations are characterized by the vanishing of the determinant",
    printed=(dot(through_nine, monomials),),
    derived=minors[3],
)

# %% [markdown]
# **And where $c_{10} = 0$?**  This is so in the normal case, where the base is parallel to the first axis of both
# images.  Let homogeneous points of the object be $(z, x, y, w)$, and $x$ the direction of the base.

# %%
base_direction = vector(0, 1, 0)
M_normal = columns(*(Matrix.eye(3).col(j) for j in range(3)), -base_direction)
C_normal = skew(base_direction)
eight_of_normal = equations(model, right=M_normal)
LACKING = [j for j in range(9) if j != 3]

section.structure(
    "0/beyond/normal-case",
    "matrix of correlation for a base parallel to the first axis",
    printed=Matrix([[0, 0, 1], [0, 0, 0], [-1, 0, 0]]),
    derived=C_normal,
)

# %% [markdown]
# Eight general points make the system singular, although their eight equations are independent.  The configuration is
# not critical; another divisor, such as $c_{20}$, would do.

# %%
section.rank(
    "0/beyond/divisor#zero",
    "the 8 by 8 system of eight general points is singular for this divisor",
    printed=7,
    derived=eight_of_normal.extract(list(range(8)), LACKING),
    kernel=[vector(*(C_normal[j] for j in LACKING))],
)
section.rank(
    "0/beyond/divisor#regular",
    "the eight equations of the same points are independent",
    printed=8,
    derived=eight_of_normal,
    kernel=[vector(*C_normal)],
)

# %% [markdown]
# ## What are the critical configurations of five points?
#
# **Definition.**  The five orientation points of the abstract are those of calibrated images.  Unknown are two
# components of the base and three rotations.  Five equations of coplanarity are singular, to first order, in critical
# configurations.  The right image may have been rotated before: take the base parallel to the $x$-axis and no rotation.

# %%
db0, db2 = sympy.symbols("db0 db2")
turn = vector(*sympy.symbols("turn:3"))
changes = (db0, db2, *turn)
unchanged = dict.fromkeys(changes, sympy.Integer(0))
changed = skew(base_direction + vector(db0, 0, db2)) * (Matrix.eye(3) + skew(turn))
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
)

# %% [markdown]
# So five points are critical exactly if they lie on a quadric with the terms $y w$, $z w$, $x z$, $x y$ and $y^2 + z^2$
# alone.  Both centers, $(0, 0, 0, 1)$ and $(0, 1, 0, 1)$, lie on it; but it is no general quadric through them.
#
# **The classical example** is the dangerous cylinder $y^2 + z^2 = z w$.  It contains the base.  A point of it is $(1,\;
# x,\; t,\; 1 + t^2)$ with any $x$ and $t$.

# %%
CYLINDER = (0, -1, 0, -1, 0)
G_cylinder = sum((step * D for step, D in zip(CYLINDER, derivatives, strict=True)), Matrix.zeros(3, 3))
on_cylinder = [vector(1, x, t, 1 + t**2) for x, t in zip(sympy.symbols("x:8"), sympy.symbols("t:8"), strict=True)]

section.identity(
    "0/beyond/cylinder",
    "the cylinder is a critical surface of five points",
    printed=py**2 + pz**2 - pz * pw,
    derived=dot(M_left * point, G_cylinder * (M_normal * point)),
)

# %%
PLACES = ((-1, -1), (0, 1), (1, -2), (2, 2), (3, 0))


def quadric_drawing(caption: str, matrix: Matrix, points: list[Matrix]) -> QuadricDrawing:
    """Return the drawing of the quadric of a matrix G, with homogeneous points (z, x, y, w) and both centers."""
    order = [3, 1, 2, 0]
    doubled = M_left.T * matrix * M_normal + M_normal.T * matrix.T * M_left
    named = {"C'": center_left, "C''": vector(0, 1, 0, 1)} | {f"{k}": p for k, p in enumerate(points, 1)}
    places = {name: vector(*(p[k] / p[3] for k in order[1:])) for name, p in named.items()}
    return QuadricDrawing(caption, doubled.extract(order, order), places, axes=("x", "y", "z"))


quadric_drawing(
    "The dangerous cylinder, with both centers, which lie on one of its lines, and five points.",
    G_cylinder,
    [vector(1, x * (1 + t**2), t, 1 + t**2) for x, t in PLACES],
)

# %% [markdown]
# **Print.**  The well-known critical surface of five points is critical for eight points as well, if all eight lie on
# it.  In general: a change of $\mathbf C$ that leaves five coplanarities alone is a matrix $\mathbf G$ as above, and
# its quadric goes through both centers.

# %%
section.rank(
    "0/abstract-five-points#five",
    "five points of the cylinder are critical for five parameters",
    printed=4,
    derived=Matrix([orientation_row(p) for p in on_cylinder[:5]]),
    kernel=[vector(*CYLINDER)],
)
section.rank(
    "0/abstract-five-points",
    "the critical surface of five points is critical for eight points",
    printed=7,
    derived=equations(on_cylinder, right=M_normal),
    kernel=[vector(*C_normal), vector(*G_cylinder)],
)

# %% [markdown]
# Five points on the cylinder and three elsewhere are not critical.

# %%
section.rank(
    "0/beyond/five-among-eight",
    "five points of the cylinder and three others are not critical",
    printed=8,
    derived=equations([*on_cylinder[:5], *model[5:]], right=M_normal),
    kernel=[vector(*C_normal)],
)

# %% [markdown]
# ## Have eight points critical configurations of their own?
#
# **Example.**  The elliptic paraboloid $x^2 - x w + y^2 = z w$ contains both centers.  It has other terms than the
# quadrics above, and it is not ruled: the determinant of its matrix is negative.  (The matrix below is twice that of
# the quadric.)  $\det \mathbf G = 1$, so the second solution is no matrix of correlation; still the linear system is
# singular.

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
)
doubled = M_left.T * G_paraboloid * M_normal + M_normal.T * G_paraboloid.T * M_left
section.identity(
    "0/beyond/paraboloid#ruled",
    "the determinant of the quadric is negative",
    printed=-4,
    derived=determinant(doubled),
)

# %%
quadric_drawing(
    "The paraboloid with both centers and eight points, which are critical for eight points and not for five.",
    G_paraboloid,
    [vector(x**2 - x + y**2, x, y, 1) for x, y in product((-1, 1, 2), repeat=2) if (x, y) != (1, 1)],
)

# %% [markdown]
# **Print.**  There are additional conditions for eight points.  Eight points of the paraboloid have dependent
# equations; five of them are not critical for five parameters.

# %%
section.rank(
    "0/abstract-additional",
    "eight points have critical configurations of their own",
    printed=7,
    derived=equations(on_paraboloid, right=M_normal),
    kernel=[vector(*C_normal), vector(*G_paraboloid)],
)
section.rank(
    "0/abstract-additional#five",
    "their points are not critical for five parameters",
    printed=5,
    derived=Matrix([orientation_row(p) for p in on_paraboloid[:5]]),
)

# %% [markdown]
# ## What the symbols stand for
#
# The list of symbols has lost most of its indices.  Points are $\mathbf y$ with the indices 0 to 3, and the center is
# one of them, given here by the parameters of the *Fundamentals*, 1.3.  A regular projective matrix has four rows, and
# a singular one annihilates a point: the center.

# %%
section.definition(
    "0/notation-vectors", "quasihomogeneous vectors", printed=homogeneous(vector(*sympy.symbols("y1:4")))
)
section.definition(
    "0/notation-center",
    "center of projection",
    printed=homogeneous(y0_of_mu),
)
section.rank(
    "0/notation-P",
    "a regular projective matrix",
    printed=4,
    derived=Matrix(4, 4, sympy.symbols("p:4:4")),
)
section.rank(
    "0/notation-M",
    "a singular projective matrix",
    printed=3,
    derived=M_star[:3, :],
    kernel=[homogeneous(y0_of_mu)],
    note="Rows 0 to 2, as far as the damaged indices tell; columns 0 to 3, for it acts on y.",
)

# %% [markdown]
# $\mathbf A$ has the indices 3 to 7: the equations of the points 3 to 7 for the five components that the basic points 0
# to 2 leave, (2.2.4) of the *Fundamentals*.  The matrix of the eight equations of the abstract has eight.

# %%
section.definition("0/notation-C", "matrix of correlation", printed=C_general)
section.rank(
    "0/notation-A",
    "the matrix of coefficients has the indices 3 to 7",
    printed=5,
    derived=Matrix.vstack(*(homologous_row(reduced, k) for k in range(3, 8)))[:, :5],
)

# %% [markdown]
# A quadric is a symmetric matrix but for a factor.  Nine points determine one.

# %%
Q = Matrix(4, 4, lambda i, j: sympy.Symbol(f"q{min(i, j)}{max(i, j)}"))
section.count(
    "0/notation-Q",
    "a quadric surface",
    printed=9,
    derived=vector(*(over(Q[i, j], Q[0, 0]) for i, j in pairs[1:])),
    variables=tuple(Q[i, j] for i, j in pairs),
    kernel=[vector(*(Q[i, j] for i, j in pairs))],
)
factor = sympy.Symbol("mu")
section.definition(
    "0/notation-mu",
    "local stretching coefficient",
    printed=factor * vector(1, *sympy.symbols("u1 u2")),
    note="The letter is lost; the Fundamentals have mu.",
)

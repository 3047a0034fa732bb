# %% [markdown]
# # 2.2 General orientation problem: geometrical consideration
#
# Section 2.1 made a model of the object from four equations.  Here it is built: from two cameras with centers, angles
# and comparators, whose rays meet.  Distances then do what five points did there: they make the model similar to the
# object.

# %%
from collections.abc import Callable
from itertools import combinations

import sympy
from sympy import MatrixSymbol, cos, sin, sqrt

from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.inserting import given
from algebroproj_derivations.okamoto1981.notation import *
from algebroproj_derivations.okamoto1981.s1_1_general_collinearity import d, of_angles
from algebroproj_derivations.okamoto1981.s2_1_algebraic_consideration import model
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    Scalar,
    adjugate,
    columns,
    cross,
    determinant,
    dot,
    inverse,
    linear_system,
    over,
    solve,
    vector,
)

section = Section("okamoto1981", "2.2", "General orientation problem, geometrical consideration")

# %% [markdown]
# ## The two rays of a model point
#
# **Definition.**  The origin of the model is the left center, and its first axis is the base.  The rays start at $(0,
# 0, 0)$ and $(B, 0, 0)$, in the directions $\mathbf g_i = (l_i, m_i, n_i)$.

# %%
B = sympy.Symbol("B")
l1, m1, n1, l2, m2, n2 = sympy.symbols("l1 m1 n1 l2 m2 n2")
rho1, rho2 = sympy.symbols("rho1 rho2")
g1, g2 = vector(l1, m1, n1), vector(l2, m2, n2)
base = vector(B, 0, 0)
on_left_ray, on_right_ray = rho1 * g1, base + rho2 * g2

# %% [markdown]
# **Print.**  Divided by the directions, the coordinates of a point of a ray are one number.


# %%
def quotients(of: Matrix, by: Matrix) -> Matrix:
    return vector(*(over(a, b) for a, b in zip(of, by, strict=True)))


section.identity("25", "the left ray", where=given(model, on_left_ray), derived=vector(rho1, rho1, rho1))
section.identity("26", "the right ray", where=given(model, on_right_ray), derived=vector(rho2, rho2, rho2))

# %% [markdown]
# ## What is the direction of a ray?
#
# **Definition.**  By (2) the picture point is $\mathbf D_\phi \mathbf D_\omega \mathbf D_\kappa (x, y, -c)^T$ away from
# the center.  The left picture is not turned by an $\omega$: that would turn the model about its base.


# %%
section.definition("27", "transformed picture coordinates of the left picture")
section.definition("28", "transformed picture coordinates of the right picture")

# %% [markdown]
# Without the base they are *reduced*.  With a bar in print, here $\bar X_1$ and so on.

# %%
D_phi, D_omega, D_kappa = (MatrixSymbol(f"D_{angle}", 3, 3) for angle in ("phi", "omega", "kappa"))
section.definition("29", "reduced transformed picture coordinates")

# %% [markdown]
# **Print.**  Divided by their length $A$, the root of the sum of their squares, they are direction cosines: their
# squares have the sum 1.

# %%
X1, Y1, Z1 = sympy.symbols("Xbar1 Ybar1 Zbar1")
X2, Y2, Z2 = sympy.symbols("Xbar2 Ybar2 Zbar2")
reduced_left, reduced_right = vector(X1, Y1, Z1), vector(X2, Y2, Z2)
length1, length2 = sympy.symbols("A1 A2")
direction_left = reduced_left.applyfunc(lambda component: over(component, length1))
direction_right = reduced_right.applyfunc(lambda component: over(component, length2))
section.identity(
    "30",
    "direction cosines",
    printed=1,
    derived=dot(direction_left, direction_left),
    constraints=[length1 - sqrt(dot(reduced_left, reduced_left))],
)

# %% [markdown]
# ## From the comparator to the ray
#
# **Question.**  Measured are $x_c, y_c$.  What are the picture coordinates $x, y$?
#
# **Definition.**  The equations (5) of section 1.1 are linear in $x$ and $y$.

# %%
(d11, d12, d13), (d21, d22, d23) = d[0, :], d[1, :]
xc_of_picture = xco + d11 * x + d12 * y - d13 * c
yc_of_picture = yco + d21 * x + d22 * y - d23 * c
section.identity(
    "31",
    "the equations (5), rearranged",
    where={xc: xc_of_picture, yc: yc_of_picture},
    derived=vector(d11 * x + d12 * y, d21 * x + d22 * y),
)

# %% [markdown]
# **Print.**  They are solved with the inverse of two rows and columns of $\mathbf D$; its elements are the $h_{ij}$.

# %%
picture_of_measured = solve(*linear_system([xc - xc_of_picture, yc - yc_of_picture], (x, y)))
inverse_of_d = inverse(d[:2, :2])
section.identity("32", "picture coordinates", derived=picture_of_measured)
section.definition("33#h", "the coefficients h")

# %% [markdown]
# The picture coordinates go into (29).

# %%
section.identity(
    "33",
    "reduced transformed picture coordinates of a measured point",
    constraints=[*(Matrix(2, 2, sympy.symbols("h1:3(1:3)")) - inverse_of_d)],
    derived=D_phi * D_omega * D_kappa * vector(*picture_of_measured, -c),
)

# %% [markdown]
# **Meaning.**  A matrix takes the homogeneous measured point to the direction of its ray: the adjugate of the affine
# map of the comparator, turned.  A free factor does not change a direction.  Any matrix may stand for the product of
# the three rotations.


# %%
def ray_matrix(orientation: Matrix, inner: Matrix) -> Matrix:
    """Return the matrix that takes homogeneous measured points to the direction of their rays."""
    return orientation * adjugate(inner)


rotation_matrix = Matrix(3, 3, sympy.symbols("r1:4(1:4)"))
reduced = rotation_matrix * vector(*picture_of_measured, -c)
inner_general = seen_by_comparator(d[:2, :], c, comparator_center)
section.up_to_scale(
    "33/beyond/ray-matrix",
    "direction of the ray of a measured point",
    printed=ray_matrix(rotation_matrix, inner_general) * vector(xc, yc, 1),
    derived=reduced,
)

# %% [markdown]
# ## When do the rays meet?
#
# **Definition.**  They meet where $\rho_1 \mathbf g_1 - \rho_2 \mathbf g_2 = (B, 0, 0)^T$: three equations for two
# unknowns.  They agree if base and directions are coplanar.

# %%
meeting, base_vector = linear_system(list(on_left_ray - on_right_ray), (rho1, rho2))
section.vanishing("34", "condition of coplanarity", derived=determinant(columns(meeting, base_vector)))

# %% [markdown]
# **Print.**  The base is not zero, and the lengths by which the coordinates are divided drop out.  Two rows are left.

# %%
reduced_condition = determinant(Matrix([[Y1, Y2], [Z1, Z2]]))
section.vanishing(
    "35",
    "condition of coplanarity, reduced",
    printed=(B, reduced_condition),
    derived=dot(base, cross(direction_left, direction_right)),
)

# %% [markdown]
# **What does this condition know of the cameras?**  With the ray matrices $\mathbf G_i$ it is a bilinear form of the
# measured points, $\mathbf G_1^T \mathbf W \mathbf G_2$.  $\mathbf W$ is singular, and with it the form: seven of its
# eight ratios determine the eighth, for a determinant is linear in each element.

# %%
W = Matrix([[0, 0, 0], [0, 0, 1], [0, -1, 0]])
G1, G2 = Matrix(3, 3, sympy.symbols("g1_1:4(1:4)")), Matrix(3, 3, sympy.symbols("g2_1:4(1:4)"))
section.identity(
    "35/beyond/determinant",
    "the determinant of the bilinear form is zero",
    printed=0,
    derived=determinant(G1.T * W * G2),
)
section.identity(
    "35/beyond/bilinear",
    "the condition as a bilinear form",
    printed=reduced_condition,
    derived=dot(reduced_left, W * reduced_right),
)

# %% [markdown]
# **Print.**  Fifteen parameters enter: $\phi_1, \kappa_1, \phi_2, \omega_2, \kappa_2$ and, for either picture, $x_{co},
# y_{co}, c$, $\alpha$ and $\beta$.  Seven functions of them are independent, as many as in section 2.1.

# %%
angles_left = sympy.symbols("t_phi1 t_kappa1")
angles_right = sympy.symbols("t_phi2 t_omega2 t_kappa2")
inner_left = sympy.symbols("xco1 yco1 c1 t_alpha1 t_beta1")
inner_right = sympy.symbols("xco2 yco2 c2 t_alpha2 t_beta2")
fifteen = (*angles_left, *inner_left, *angles_right, *inner_right)


def inner_of(parameters: tuple[sympy.Symbol, ...]) -> Matrix:
    """Return the affine map of an inclined comparator, or of a parallel one without the two angles."""
    first, second, distance, *inclinations = parameters
    return seen_by_comparator(of_angles(*inclinations)[:2, :], distance, vector(first, second))


left_rotation = of_angles(angles_left[0], sympy.Integer(0), angles_left[1])
right_rotation = of_angles(*angles_right)


def coplanarity_of(left: Matrix, right: Matrix) -> Matrix:
    """Return the matrix of the bilinear form of (35)."""
    return ray_matrix(left_rotation, left).T * W * ray_matrix(right_rotation, right)


def seven_ratios(form: Matrix) -> Matrix:
    """Return ratios of elements; the one that is left out follows from the determinant."""
    return coefficients_of(form)[1:, :]


section.count(
    "2.2/seven",
    "the condition has seven independent parameters among fifteen",
    derived=seven_ratios(coplanarity_of(inner_of(inner_left), inner_of(inner_right))),
    variables=fifteen,
)

# %% [markdown]
# ## What do distances say?
#
# Seven conditions leave eight of the fifteen parameters open.  What can be measured in the object without any system of
# coordinates?  Distances: they do not change when the points move as a rigid body.  Their ratios do not change in a
# similarity either.


# %%
def squared_distances(points: list[Matrix]) -> list[Scalar]:
    """Return the squared lengths of all line segments between the points."""
    return [dot(a - b, a - b) for a, b in combinations(points, 2)]


def ratios_to_first(values: list[Scalar]) -> Matrix:
    return vector(*(over(value, values[0]) for value in values[1:]))


def free_points(count: int) -> list[Matrix]:
    return [vector(*sympy.symbols(f"X_{k} Y_{k} Z_{k}")) for k in range(1, count + 1)]


Movement = Callable[[Matrix], Matrix]
axes = [E3.col(i) for i in range(3)]
movements: list[Movement] = [lambda p, a=a: a for a in axes] + [lambda p, a=a: cross(a, p) for a in axes]
similarities: list[Movement] = [*movements, lambda p: p]


def rates(points: list[Matrix], movement: Movement) -> Matrix:
    return Matrix.vstack(*(movement(p) for p in points))


# %% [markdown]
# **Definition.**  Each segment of the model is $m$ times that of the object, with one $m$ for all.

# %%
segment_of_model, segment_of_object = sympy.symbols("L_M L_o")
section.definition(
    "2.2/scale",
    "the similarity condition of one line segment",
    printed=segment_of_model / segment_of_object,
)

# %% [markdown]
# **Print.**  Five points have ten segments.  Fifteen coordinates, less six movements, are nine: one segment follows
# from the others.  With an unknown scale eight ratios are left.  (Counted are squares of distances.)

# %%
five = free_points(5)
coordinates_of_five = tuple(coordinate for p in five for coordinate in p)
section.count(
    "2.2/nine",
    "five points have nine independent line segments",
    derived=vector(*squared_distances(five)),
    variables=coordinates_of_five,
    kernel=[rates(five, movement) for movement in movements],
)
section.count(
    "2.2/eight",
    "the similarity of five points has eight independent equations",
    derived=ratios_to_first(squared_distances(five)),
    variables=coordinates_of_five,
    kernel=[rates(five, similarity) for similarity in similarities],
)

# %% [markdown]
# ### Are seven and eight enough?
#
# **Derivation.**  Take seven pairs of image points, five of them those of the control points, and eight ratios of
# segments of the latter.  These are 28 image coordinates and 8 ratios, functions of 15 parameters and of the 21
# coordinates of seven model points.  Eliminate the points: the rates of what is left by the parameters have full rank.

# %%
unit_base = vector(1, 0, 0)
seven = free_points(7)


def images_in_model(points: list[Matrix], left_inner: Matrix, right_inner: Matrix) -> Matrix:
    """Return the measured coordinates of model points in both photographs; the base is the unit of length."""
    left = camera(left_inner, left_rotation.T, vector(0, 0, 0))
    right = camera(right_inner, right_rotation.T, unit_base)
    return Matrix.vstack(*(image(matrix, p) for p in points for matrix in (left, right)))


nine_segments = squared_distances(seven[:5])[:9]
equations_of_fifteen = Matrix.vstack(
    images_in_model(seven, inner_of(inner_left), inner_of(inner_right)), ratios_to_first(nine_segments)
)
section.rank(
    "2.2/fifteen",
    "seven conditions of coplanarity and eight of similarity are fifteen independent equations",
    derived=rates_of_equations(equations_of_fifteen, fifteen, seven),
)

# %% [markdown]
# **Meaning.**  Near a solution there is no other, as in 2.1/twenty-two.  No coordinate of the object is used: distances
# alone calibrate both cameras (section 5).

# %% [markdown]
# ### Why eight?
#
# The model differs from the object by a collineation, of fifteen parameters.  A similarity behind it does not change
# the ratios of distances.  It has seven parameters, and $15 = 8 + 7$.

# %%
B_ = vector(*sympy.symbols("B1:16"))
collineation_matrix = matrix_of(B_)
fixed_points = [vector(*p) for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 2, 3))]
mapped_points = [image(collineation_matrix, p) for p in fixed_points]


def infinitesimal(movement: Movement) -> Matrix:
    """Return the 4 by 4 matrix of an infinitesimal similarity."""
    origin = movement(vector(0, 0, 0))
    return columns(*(movement(a) - origin for a in axes), origin).col_join(Matrix.zeros(1, 4))


# %% [markdown]
# **Print.**  Five points give all fifteen; their ratios of distances give eight, and are blind for the seven.

# %%
mapped_ratios = ratios_to_first(squared_distances(mapped_points))
followed_by_similarities = [vector(*(infinitesimal(s) * collineation_matrix)[:15]) for s in similarities]
section.count(
    "2.2/five-points",
    "fifteen parameters are obtained from the correspondence if five points are given",
    derived=Matrix.vstack(*mapped_points),
    variables=B_,
)
section.count(
    "2.2/divided",
    "the correspondence is divided into the similarity condition and a similarity",
    printed=8,
    derived=mapped_ratios,
    variables=B_,
    kernel=followed_by_similarities,
)

# %% [markdown]
# ## Where is the model point?
#
# **Definition.**  $\rho_1$ from the first two of the three equations, and $\rho_1 \mathbf g_1$.

# %%
rho = solve(meeting[:2, :], base_vector[:2, :])
model_point = rho[0] * g1
model_point

# %% [markdown]
# **Print.**

# %%
section.identity("36#rho", "factor of the left ray", derived=rho[0])
section.identity("36#directions", "model point from direction cosines", derived=model_point)

# %% [markdown]
# The directions are the reduced coordinates, divided by $A_1$ and $A_2$, which cancel.  The scan destroys the letters
# of the printed members and keeps their shape.

# %%
of_reduced = given((*g1, *g2), (*direction_left, *direction_right))
model_point_of_reduced = model_point.xreplace(of_reduced)
reconstructed = vector(*(component * Y2 * B / (X1 * Y2 - Y1 * X2) for component in reduced_left))
section.identity(
    "36",
    "model point from reduced transformed picture coordinates",
    printed=None,
    derived=model_point_of_reduced,
    expect="illegible",
    corrected=reconstructed,
    note="The scan destroys the letters of the last members, not their shape: a product with B over a difference of "
    "two products.  The directions are the coordinates divided by A1 and A2, which cancel; (43) has the same form.",
)

# %% [markdown]
# **And by the right ray?**  It gives the same first two coordinates.  The third ones agree if the rays are coplanar.

# %%
section.identity(
    "36/beyond/right",
    "the right ray gives the same point but for its third coordinate",
    printed=vector(model_point[0], model_point[1]),
    derived=(base + rho[1] * g2)[:2, :],
)

# %% [markdown]
# **An example.**  The left ray in the direction $(1, 1, -3)$ and the right one in the direction $(-1, 1, -4)$, with the
# base 1.  The rays miss each other.  The formula takes the point of the left ray that lies above or below the right
# one.

# %%
crossing = {B: 1, **given((*g1, *g2), (1, 1, -3, -1, 1, -4))}
EXAMPLE = {
    "C1": vector(0, 0, 0),
    "C2": vector(1, 0, 0),
    "P": model_point.subs(crossing).doit(),
    "Q": (base + rho[1] * g2).subs(crossing).doit(),
}
SpaceDrawing(
    "The model point P on the left ray, and the point Q of the right ray with the same first two coordinates.  The "
    "distance of P and Q is a parallax along the third axis.",
    EXAMPLE,
    segments=[("C1", "C2"), ("C1", "P"), ("C2", "Q"), ("P", "Q")],
    axes=("X_M", "Y_M", "Z_M"),
)

# %% [markdown]
# ## From the model to the object
#
# **Definition.**  Three rotations $\Phi$, $\Omega$ and $K$, a scale $m$ and a translation.

# %%
Phi, Omega, Kappa = sympy.symbols("Phi Omega Kappa")
m = sympy.Symbol("m")
turns = zip((ABOUT_Y, ABOUT_X, ABOUT_Z), (Phi, Omega, Kappa), strict=True)
of_model = rotation(*((axis, cos(angle), sin(angle)) for axis, angle in turns))
object_of_model = m * of_model * model + center

# %% [markdown]
# **Print.**  The three matrices are the rotations about $Y$, $X$ and $Z$, and their product is a rotation.

# %%
section.identity("38", "similarity transformation", derived=object_of_model)
section.identity("38#rotation", "the three matrices are a rotation", printed=E3, derived=of_model.T * of_model)

# %% [markdown]
# ## Two letters $m$
#
# **Question.**  The quotient of distances is the same for all pairs of points, and (37) calls it $m$.  Is it the $m$ of
# (38)?
#
# **Definition.**  A similar model, here not turned, as a rotation does not change distances.

# %%
first_model, second_model = vector(*sympy.symbols("XM_i YM_i ZM_i")), vector(*sympy.symbols("XM_k YM_k ZM_k"))
first_object, second_object = vector(*sympy.symbols("X_i Y_i Z_i")), vector(*sympy.symbols("X_k Y_k Z_k"))
difference, object_difference = first_model - second_model, first_object - second_object
object_segment = dot(object_difference, object_difference)
scale = sympy.Symbol("s")
similar = list(difference - scale * object_difference)

# %% [markdown]
# **Print.**  The numerator of (37) subtracts a point from itself.

# %%
section.identity(
    "37",
    "quotient of the line segments of model and object",
    derived=scale,
    constraints=similar,
    nonzero=[object_segment],
    assumptions=[scale > 0],
    expect="misprint",
    corrected=sqrt(dot(difference, difference) / object_segment),
    note="For a model that is not turned, which does not change distances (38#rotation).  The numerator is printed "
    "with the index Mi twice; the second must be Mk, as the denominator shows.  The scan alone cannot tell a slip of "
    "the scan from one of the print.",
)

# %% [markdown]
# In (37) $m$ is model over object.  In (38) it multiplies the model to give the object: it is the reciprocal.

# %%
section.identity(
    "38#m",
    "the scale of (38) in the quotient of (37)",
    derived=sqrt(dot(difference, difference) / dot(m * difference, m * difference)),
    assumptions=[m > 0],
    expect="misprint",
    corrected=1 / m,
    note="(37) defines m as model over object, (38) multiplies the model by m to get the object: one of the two is the "
    "reciprocal of the other.  Without the rotation, as in 37.  Read as two different numbers with one "
    "letter both equations are right.",
)

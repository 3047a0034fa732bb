# %% [markdown]
# # 1.1 Characteristics of the general collinearity equations
#
# A general projection of space into a plane has eleven coefficients.  A camera has nine elements of orientation: six of
# the exterior, three of the interior.  Where do the other two come from?  The paper's answer is a comparator whose
# plane is inclined to the picture.

# %%
import sympy

from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.inserting import given, inserted
from algebroproj_derivations.okamoto1981.notation import *
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, Scalar, diff, over, vector

section = Section("okamoto1981", "1.1", "Characteristics of the general collinearity equations")

# %% [markdown]
# ## What is a general projection?
#
# **Definition.**  Two quotients of linear forms with one denominator.

# %%
A = vector(*sympy.symbols("A1:12"))
A1, A2, A3, A4, A5, A6, A7, A8, A9, A10, A11 = A
denominator = A9 * X + A10 * Y + A11 * Z + 1
projected = image(matrix_of(A), point)


# %% [markdown]
# The same is a product with a matrix of three rows and four columns, divided by its last component.

# %%
section.definition("1", "general collinearity equations")
section.identity("1#matrix", "the same as the product with a 3 by 4 matrix", derived=projected)

# %% [markdown]
# **Are the coefficients independent?**  The images of six points in general position are twelve functions of them.
# Eleven of these are independent, as many as there are coefficients.

# %%
six_points = [vector(*p) for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 2), (2, -1, 1))]
images_of_six = Matrix.vstack(*(image(matrix_of(A), p) for p in six_points))
section.count(
    "1#independent",
    "the eleven coefficients are independent",
    derived=images_of_six,
    variables=A,
)

# %% [markdown]
# ## What does a camera do?
#
# **Definition.**  The picture point $(x, y, -c)$ and the object point lie on one ray through the projection center.
# $\mathbf E = (e_{ij})$ is the transposed matrix of rotation.

# %%
e = Matrix(3, 3, sympy.symbols("e1:4(1:4)"))
e31, e32, e33 = e[6:]
ray = e * (point - center)

section.definition("2", "central projection")

section.definition("3#rotation", "elements of the transposed rotation of the picture")

# %% [markdown]
# The third component must be $-c$.  This is the scale, and the collinearity equations follow.

# %%
scale = over(-c, ray[2])
picture = scale * ray
section.identity("3", "collinearity equations", derived=picture[:2, :])
section.identity(
    "3a",
    "collinearity equations as a vector",
    derived=picture,
)

# %% [markdown]
# ## What does an inclined comparator measure?
#
# **Definition.**  In its system the picture point is $\mathbf D (x, y, -c)^T$ plus the projection center.  What is
# measured are the first two components: the foot of the perpendicular in the plane of the comparator.

# %%
d = Matrix(3, 3, sympy.symbols("d1:4(1:4)"))
zco = sympy.Symbol("zco")
in_comparator = d * vector(x, y, -c) + vector(xco, yco, zco)

section.definition("4", "picture point in the system of the comparator")
section.definition("5#rotation", "elements of the rotation to the comparator")

# %% [markdown]
# **Print.**

# %%
section.identity("5", "measured coordinates", derived=in_comparator[:2, :] - comparator_center)
section.identity("5a", "measured coordinates as a product", derived=in_comparator[:2, :] - comparator_center)
section.identity(
    "5#projection",
    "the picture point is projected orthogonally into the plane of the comparator",
    printed=vector(0, 0),
    derived=(in_comparator - vector(*in_comparator[:2, :], 0))[:2, :],
)

# %% [markdown]
# **And of an object point?**  Equation (3) is put into (5).

# %%
measured = comparator_center + d[:2, :] * picture
section.identity(
    "6",
    "measured coordinates of an object point",
    derived=measured - comparator_center,
)

# %% [markdown]
# Both numerators and the denominator are linear in the coordinates of the object point.  So this *is* a general
# projection: its coefficients are the elements of a matrix of projection, divided by the last one.

# %%
inner = seen_by_comparator(d[:2, :], c, comparator_center)
A_of_orientation = coefficients_of(camera(inner, e, center))
section.identity(
    "7",
    "general collinearity equations of the measured coordinates",
    where=given(A, A_of_orientation),
    derived=measured,
)

# %% [markdown]
# **Where does this fail?**  The last element is $-(e_{31} X_o + e_{32} Y_o + e_{33} Z_o)$.  The constant 1 of the
# denominator excludes that the origin of the object lies in the plane through the center that is parallel to the
# picture.

# %%
section.vanishing(
    "7/beyond/origin",
    "where the coefficients do not exist",
    printed=(e31 * Xo + e32 * Yo + e33 * Zo,),
    derived=camera(inner, e, center)[2, 3],
)

# %% [markdown]
# **An example.**  A picture, inclined to the plane of the comparator by the angle whose tangent is $3/4$, and an object
# point $P$.  $p$ is the picture point, and $p_c$ the foot of its perpendicular.

# %%
inclined = rotation((ABOUT_Y, sympy.Rational(4, 5), sympy.Rational(3, 5)))
in_picture = {"C": vector(0, 0, 0), "H": vector(0, 0, -1), "p": vector(1, 1, -1), "P": vector(1, 1, -1) * 3 / 2}
EXAMPLE = {name: vector(0, 0, 2) + inclined * place for name, place in in_picture.items()}
SpaceDrawing(
    "Center C, ray, picture point p and measured point p_c in the system of the comparator.  H is the principal point "
    "of the picture; p_c lies in the plane of the comparator, at height 0.",
    EXAMPLE | {"p_c": vector(*EXAMPLE["p"][:2, :], 0)},
    segments=[("C", "P"), ("C", "H"), ("H", "p"), ("p", "p_c")],
    axes=("x_c", "y_c", "z_c"),
)

# %% [markdown]
# ## Are twelve parameters too many?
#
# **Definition.**  They are $\phi, \omega, \kappa$, the center, $\alpha, \beta, \gamma$, $x_{co}, y_{co}$ and $c$.

# %%
t_phi, t_omega, t_kappa = sympy.symbols("t_phi t_omega t_kappa")
t_alpha, t_beta, t_gamma = sympy.symbols("t_alpha t_beta t_gamma")
exterior_angles = (t_phi, t_omega, t_kappa)
comparator_angles = (t_alpha, t_beta, t_gamma)


def of_angles(*tangents: sympy.Symbol) -> Matrix:
    """Return the product of rotations about the second, the first and the third axis, in this order."""
    axes = (ABOUT_Y, ABOUT_X, ABOUT_Z)
    return rotation(*((axis, *of_half_angle(t)) for axis, t in zip(axes, tangents, strict=False)))


comparator_rotation = of_angles(*comparator_angles)
exterior = of_angles(*exterior_angles).T
camera_of_twelve = camera(seen_by_comparator(comparator_rotation[:2, :], c, comparator_center), exterior, center)
A_of_twelve = coefficients_of(camera_of_twelve)
twelve = (*exterior_angles, *center, *comparator_angles, *comparator_center, c)

# %% [markdown]
# **What is superfluous?**  $\mathbf D_\kappa^T$ is the last rotation of the ray, and $\mathbf D_\gamma$ the first of
# the picture.  Increase both angles by the same amount: nothing changes.

# %%
rates = {t_kappa: angle_rate(t_kappa), t_gamma: angle_rate(t_gamma)}
turn_of_picture = vector(*(rates.get(parameter, 0) for parameter in twelve))


# %% [markdown]
# **Print.**  One of twelve is dependent.  The paper infers it from the numbers, twelve and eleven.  That alone would
# not show it: it also needs that all eleven coefficients are independent functions of the twelve.

# %%
section.count(
    "1.1/twelve",
    "eleven of the twelve parameters of (6) are independent",
    derived=A_of_twelve,
    variables=twelve,
    kernel=[turn_of_picture],
)

# %% [markdown]
# **Which one can be chosen?**  The paper chooses $\gamma = 0$.  Eleven parameters are left, as many as there are
# coefficients: every general projection near that of such a camera is that of such a camera.

# %%
A_of_eleven = inserted(A_of_twelve, (t_gamma,), (0,))
eleven = tuple(parameter for parameter in twelve if parameter != t_gamma)
section.count(
    "1.1/gamma",
    "with gamma = 0 the remaining eleven parameters are independent",
    derived=A_of_eleven,
    variables=eleven,
)

# %% [markdown]
# But "one of the 12 arbitrarily" is too much.  The dependence is between $\kappa$ and $\gamma$ alone.  With the
# principal distance given, say, one degree of freedom is missing.

# %%
without_c = tuple(parameter for parameter in twelve if parameter != c)
section.count(
    "1.1/arbitrary",
    "any one of the twelve parameters can be chosen",
    printed=11,
    derived=A_of_twelve,
    variables=without_c,
    kernel=[vector(*(rates.get(parameter, 0) for parameter in without_c))],
    expect="false",
    instead="1.1/beyond/gauge",
    note="Read as: whichever of the twelve is given a value, the other eleven still reach all coefficients.  With a "
    "given principal distance c they are ten independent ones only.  Read as a reason for gamma = 0 alone it is true: "
    "1.1/gamma.",
)
section.count(
    "1.1/beyond/gauge",
    "with a given principal distance the coefficients have one degree of freedom less",
    printed=10,
    derived=A_of_twelve,
    variables=without_c,
    kernel=[vector(*(rates.get(parameter, 0) for parameter in without_c))],
)

# %% [markdown]
# ## And with a parallel comparator?
#
# $\mathbf D$ is the unit matrix, and nine parameters remain: six of exterior and three of interior orientation.  They
# are independent, and do not reach all of eleven coefficients.

# %%
nine = (*exterior_angles, *center, *comparator_center, c)
A_of_nine = inserted(A_of_twelve, comparator_angles, (0, 0, 0))
section.count(
    "1.1/nine",
    "a camera has nine independent parameters",
    derived=A_of_nine,
    variables=nine,
)

# %% [markdown]
# ## How does the image point move?
#
# **Derivation.**  With $w$ for the denominator, the derivative of a quotient $p/w$ of linear forms is $(p' - (p/w)\,
# w') / w$.  By a coordinate of the point it is $(p' w - p\, w') / w^2$, in which the products with this coordinate
# cancel.

# %%
w = sympy.Symbol("w")
by_coefficients = Matrix(2, 11, lambda i, j: diff(projected[i], A[j]))
by_point = Matrix(2, 3, lambda i, j: diff(projected[i], point[j]))
numerator_row = vector(X, Y, Z, 1).T / w
nothing = Matrix.zeros(1, 4)
denominator_rows = Matrix(2, 3, lambda i, j: -projected[i] * point[j] / w)
coefficient_jacobian = Matrix.hstack(
    Matrix.vstack(numerator_row, nothing), Matrix.vstack(nothing, numerator_row), denominator_rows
)
P = matrix_of(A)
homogeneous_point = vector(*point, 1)


def slope(i: int, j: int) -> Scalar:
    """Return the derivative of coordinate i by coordinate j, without the terms that cancel."""
    others = [k for k in range(4) if k != j]
    return sympy.Add(*((P[i, j] * P[2, k] - P[i, k] * P[2, j]) * homogeneous_point[k] for k in others)) / w**2


point_jacobian = Matrix(2, 3, slope)


# %%
section.identity(
    "7/beyond/by-coefficients",
    "derivatives with respect to the coefficients",
    printed=coefficient_jacobian,
    where={w: denominator},
    derived=by_coefficients,
)
section.identity(
    "7/beyond/by-point",
    "derivatives with respect to the object point",
    printed=point_jacobian,
    where={w: denominator},
    derived=by_point,
)

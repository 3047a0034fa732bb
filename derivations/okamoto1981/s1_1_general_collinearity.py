# %% [markdown]
# # 1.1 Characteristics of the general collinearity equations
#
# Eleven coefficients describe a projection of space into a plane.  Six elements of exterior and three of interior
# orientation are too few for them; a comparator whose plane is inclined to the picture adds what is missing.

# %%
import sympy

from algebroproj_derivations.okamoto1981.notation import *
from algebroproj_sym import Section
from algebroproj_sym.declaring import cos_sin
from algebroproj_sym.expressions import Matrix, Scalar, diff, dot, over, vector

section = Section("okamoto1981", "1.1", "Characteristics of the general collinearity equations")

# %% [markdown]
# ## The general collinearity equations

# %%
A = vector(*sympy.symbols("A1:12"))
A1, A2, A3, A4, A5, A6, A7, A8, A9, A10, A11 = A
denominator = A9 * X + A10 * Y + A11 * Z + 1
collinearity = vector(
    (A1 * X + A2 * Y + A3 * Z + A4) / denominator,
    (A5 * X + A6 * Y + A7 * Z + A8) / denominator,
)
projected = image(matrix_of(A), point)

section.definition("1", "general collinearity equations", printed=collinearity)
section.identity(
    "1#matrix",
    "the same as the product with a 3 by 4 matrix",
    printed=collinearity,
    derived=projected,
)

# %% [markdown]
# The images of six points are twelve functions of the coefficients.  As many of them are independent as there are
# coefficients.

# %%
six_points = [vector(*p) for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 2), (2, -1, 1))]
images_of_six = Matrix.vstack(*(image(matrix_of(A), p) for p in six_points))
section.count(
    "1#independent",
    "the eleven coefficients are independent",
    printed=11,
    derived=images_of_six,
    variables=A,
    note="The images of six points in general position determine all of them.",
)

# %% [markdown]
# ## The central projection
#
# A picture point and the projection center span the ray to the object point; $\mathbf E = (e_{ij})$ is the transposed
# matrix of rotation.

# %%
e = Matrix(3, 3, sympy.symbols("e1:4(1:4)"))
e11, e12, e13, e21, e22, e23, e31, e32, e33 = e
lam = sympy.Symbol("lam")
ray = e * (point - center)

section.definition("2", "central projection", printed=lam * ray)

section.definition("3#rotation", "elements of the transposed rotation of the picture", printed=e)
scale = over(-c, ray[2])
picture = scale * ray
divisor = e31 * (X - Xo) + e32 * (Y - Yo) + e33 * (Z - Zo)
printed_picture = vector(
    -c * (e11 * (X - Xo) + e12 * (Y - Yo) + e13 * (Z - Zo)) / divisor,
    -c * (e21 * (X - Xo) + e22 * (Y - Yo) + e23 * (Z - Zo)) / divisor,
)
section.identity("3", "collinearity equations", printed=printed_picture, derived=picture[:2, :])
section.identity(
    "3a",
    "collinearity equations as a vector",
    printed=vector(*printed_picture, -c),
    derived=picture,
    note="The third component of the left side is printed as z; it is -c, as in (2).  The scan loses the lines of the "
    "fractions.",
)

# %% [markdown]
# ## The comparator
#
# In the system of the comparator the picture point is $\mathbf D (x, y, -c)^T$ plus the projection center; its first
# two components are what is measured.

# %%
d = Matrix(3, 3, sympy.symbols("d1:4(1:4)"))
d11, d12, d13, d21, d22, d23, d31, d32, d33 = d
zco = sympy.Symbol("zco")
in_comparator = d * vector(x, y, -c) + vector(xco, yco, zco)

section.definition("4", "picture point in the system of the comparator", printed=in_comparator)
section.definition("5#rotation", "elements of the rotation to the comparator", printed=d)
section.identity(
    "5",
    "measured coordinates",
    printed=vector(d11 * x + d12 * y - d13 * c, d21 * x + d22 * y - d23 * c),
    derived=in_comparator[:2, :] - comparator_center,
)
section.identity(
    "5a",
    "measured coordinates as a product",
    printed=Matrix([[d11, d12, d13], [d21, d22, d23]]) * vector(x, y, -c),
    derived=in_comparator[:2, :] - comparator_center,
)
section.identity(
    "5#projection",
    "the picture point is projected orthogonally into the plane of the comparator",
    printed=vector(0, 0),
    derived=(in_comparator - vector(*in_comparator[:2, :], 0))[:2, :],
    note="The line from the picture point to the measured point is parallel to the axis zc.",
)

# %% [markdown]
# Equation (3) put into (5):

# %%
measured = comparator_center + d[:2, :] * picture
section.identity(
    "6",
    "measured coordinates of an object point",
    printed=-c * d[:2, :] * vector(printed_picture[0] / -c, printed_picture[1] / -c, 1),
    derived=measured - comparator_center,
    note="The scan loses the lines of the fractions, as in (3a).",
)

# %% [markdown]
# Both numerators and the denominator are linear in the coordinates of the object point: a matrix of projection, divided
# by its last entry $-(e_{31} X_o + e_{32} Y_o + e_{33} Z_o)$.

# %%
inner = seen_by_comparator(d[:2, :], c, comparator_center)
A_of_orientation = coefficients_of(camera(inner, e, center))
section.identity(
    "7",
    "general collinearity equations of the measured coordinates",
    printed=collinearity,
    where=dict(zip(A, A_of_orientation, strict=True)),
    derived=measured,
)
section.vanishing(
    "7/beyond/origin",
    "where the coefficients do not exist",
    printed=(e31 * Xo + e32 * Yo + e33 * Zo,),
    derived=camera(inner, e, center)[2, 3],
    note="Not in the paper: the coefficient 1 of the denominator excludes that the origin of the object system lies in "
    "the plane through the projection center that is parallel to the picture.",
)

# %% [markdown]
# ## Twelve parameters, eleven coefficients
#
# The twelve parameters are $\phi, \omega, \kappa$, the center, $\alpha, \beta, \gamma$, $x_{co}, y_{co}$ and $c$.

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
# $\mathbf D_\kappa^T$ is the last rotation of the ray, $\mathbf D_\gamma$ the first of the picture: $\kappa + \delta$
# together with $\gamma + \delta$ changes nothing.

# %%
rates = {t_kappa: angle_rate(t_kappa), t_gamma: angle_rate(t_gamma)}
turn_of_picture = vector(*(rates.get(parameter, 0) for parameter in twelve))

section.count(
    "1.1/twelve",
    "eleven of the twelve parameters of (6) are independent",
    printed=11,
    derived=A_of_twelve,
    variables=twelve,
    kernel=[turn_of_picture],
    note="All eleven coefficients of (7) are independent functions of the twelve parameters.  The number of parameters "
    "alone, which is the reason the paper gives, would not show it.",
)

# %% [markdown]
# The dependence is between $\kappa$ and $\gamma$ alone.  One of these two can be chosen, and $\gamma = 0$ is such a
# choice; none of the other ten can.

# %%
A_of_eleven = A_of_twelve.xreplace({t_gamma: sympy.Integer(0)})
eleven = tuple(parameter for parameter in twelve if parameter != t_gamma)
section.count(
    "1.1/gamma",
    "with gamma = 0 the remaining eleven parameters are independent",
    printed=11,
    derived=A_of_eleven,
    variables=eleven,
    note="As many as there are coefficients: (7), and with it (1), is met by a camera with an inclined comparator, in "
    "general and near every such camera.",
)
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
    note="Not in the paper: only kappa or gamma can be chosen, for the free direction of 1.1/twelve has no other "
    "component.",
)

# %% [markdown]
# ## The camera of nine parameters
#
# If the plane of the comparator is parallel to the picture, $\mathbf D$ is the unit matrix and nine parameters remain.

# %%
nine = (*exterior_angles, *center, *comparator_center, c)
parallel = dict.fromkeys(comparator_angles, sympy.Integer(0))
A_of_nine = A_of_twelve.xreplace(parallel)
section.count(
    "1.1/nine",
    "a camera has nine independent parameters",
    printed=9,
    derived=A_of_nine,
    variables=nine,
    note="Six of exterior and three of interior orientation; nine do not reach all of eleven independent coefficients.",
)

# %% [markdown]
# ## Derivatives
#
# With $w$ for the denominator, the derivative of a quotient $p/w$ of linear forms is $(p' - (p/w)\, w') / w$.  By a
# coordinate of the point it is $(p' w - p\, w') / w^2$, in which the products with this coordinate cancel.

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

section.identity(
    "7/beyond/by-coefficients",
    "derivatives with respect to the coefficients",
    printed=coefficient_jacobian,
    where={w: denominator},
    derived=by_coefficients,
    note="Not in the paper.",
)
section.identity(
    "7/beyond/by-point",
    "derivatives with respect to the object point",
    printed=point_jacobian,
    where={w: denominator},
    derived=by_point,
    note="Not in the paper.",
)

# %% [markdown]
# ## Code
#
# The coefficients come from the eleven parameters of the text, $\gamma = 0$, with cosine and sine of every angle.

# %%
phi, omega, kappa = sympy.symbols("phi omega kappa")
alpha, beta = sympy.symbols("alpha beta_")
cosines_and_sines = {angle: sympy.symbols(f"c_{angle} s_{angle}") for angle in (phi, omega, kappa, alpha, beta)}
turns_of_camera = [
    (axis, *cosines_and_sines[angle])
    for axis, angle in zip((ABOUT_Y, ABOUT_X, ABOUT_Z), (phi, omega, kappa), strict=True)
]
turns_of_comparator = [
    (axis, *cosines_and_sines[angle]) for axis, angle in zip((ABOUT_Y, ABOUT_X), (alpha, beta), strict=True)
]
rotation_of_camera, rotation_of_comparator = rotation(*turns_of_camera).T, rotation(*turns_of_comparator)
camera_of_angles = camera(
    seen_by_comparator(rotation_of_comparator[:2, :], c, comparator_center), rotation_of_camera, center
)

# %% [markdown]
# With $\mathbf r = \mathbf E\, (X_o, Y_o, Z_o)^T$ the constants of the numerators are $x_{co}$ and $y_{co}$ and a
# remainder, which does not lose digits where $r_3$ is small.

# %%
principal_distance = sympy.Symbol("principal_distance")
r = vector(*sympy.symbols("r1:4"))
picture_rows = rotation_of_comparator[:2, :] * e
coefficient_form = vector(
    *(
        entry
        for i in range(2)
        for entry in (
            *((c * picture_rows[i, j] - comparator_center[i] * e[2, j]) / r[2] for j in range(3)),
            comparator_center[i] - c * dot(rotation_of_comparator.row(i).T, r) / r[2],
        )
    ),
    *(-e[2, j] / r[2] for j in range(3)),
)
EXAMPLE_A = ("1.25", "0.125", "0.25", "10.5", "-0.125", "1.375", "0.0625", "20.25", "0.0025", "-0.00125", "0.005")
with_point = {
    "arguments": {"A": A, "X": point},
    "describe": {"A": ABOUT_A, "X": ABOUT_POINT},
    "example": {"A": EXAMPLE_A, "X": ("12.5", "-7.25", "31.75")},
}

section.kernel(
    "collinearity.coefficients",
    "Coefficients (A1, ..., A11) of the general collinearity equations from eleven orientation parameters.",
    arguments={
        "angles": vector(phi, omega, kappa),
        "center": center,
        "principal_distance": principal_distance,
        "comparator_angles": vector(alpha, beta),
        "comparator_center": comparator_center,
    },
    through=[cos_sin(*values, angle) for angle, values in cosines_and_sines.items()],
    derived=coefficients_of(camera_of_angles).xreplace({c: principal_distance}),
    form=coefficient_form.xreplace({c: principal_distance}),
    where=dict(zip((*e, *r), (*rotation_of_camera, *(e * center)), strict=True)),
    claims=["6", "7"],
    describe={
        "angles": "Rotations (phi, omega, kappa) of the picture about Y, X and Z; radians.",
        "center": "Projection center (Xo, Yo, Zo) in the object system; any unit of length.  The plane through it "
        "parallel to the picture must not contain the origin.",
        "principal_distance": "Principal distance c of the picture; unit of the image coordinates.",
        "comparator_angles": "Inclinations (alpha, beta) of the picture about the comparator axes yc and xc; radians.",
        "comparator_center": "Projection center (xco, yco) in the system of the comparator; unit of the image "
        "coordinates.",
    },
    example={
        "angles": ("0.125", "-0.25", "0.5"),
        "center": ("12.5", "-7.25", "101.75"),
        "principal_distance": "152.25",
        "comparator_angles": ("0.0625", "-0.03125"),
        "comparator_center": ("110.5", "95.25"),
    },
)
section.kernel(
    "collinearity.project",
    "Measured image point of an object point by the general collinearity equations.",
    **with_point,
    derived=projected,
    claims=["7", "1#matrix"],
)
section.kernel(
    "collinearity.project_jacobian_parameters",
    "Derivatives of the measured image point with respect to the coefficients (A1, ..., A11).",
    **with_point,
    derived=by_coefficients,
    form=coefficient_jacobian,
    where={w: denominator},
    claims=["1#matrix", "7/beyond/by-coefficients"],
)
section.kernel(
    "collinearity.project_jacobian_point",
    "Derivatives of the measured image point with respect to the object point.",
    **with_point,
    derived=by_point,
    form=point_jacobian,
    where={w: denominator},
    claims=["1#matrix", "7/beyond/by-point"],
)

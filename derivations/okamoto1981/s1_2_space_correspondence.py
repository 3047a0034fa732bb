# %% [markdown]
# # 1.2 General central projective one-to-one correspondence between two three-dimensional spaces
#
# A collineation of space has fifteen coefficients.  The paper reads it as a central projection in a space of four
# dimensions, from the hyperplane $T = 0$ of the object into a fictitious picture of three dimensions, followed by an
# orthogonal projection into the three-dimensional comparator.

# %%
import sympy

from algebroproj_derivations.okamoto1981.notation import *
from algebroproj_derivations.okamoto1981.s1_1_general_collinearity import comparator_angles, exterior_angles
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, Scalar, columns, over, vector

section = Section("okamoto1981", "1.2", "Central projective one-to-one correspondence between two spaces")

# %% [markdown]
# ## The correspondence

# %%
B = vector(*sympy.symbols("B1:16"))
B1, B2, B3, B4, B5, B6, B7, B8, B9, B10, B11, B12, B13, B14, B15 = B


def collineation(coefficients: Matrix, of: Matrix) -> Matrix:
    """Return the three quotients of linear forms with a common denominator."""
    *linear, p, q, r = coefficients
    u, v, w = of
    denominator = p * u + q * v + r * w + 1
    rows = (linear[0:4], linear[4:8], linear[8:12])
    return vector(*((a * u + b * v + c * w + d) / denominator for a, b, c, d in rows))


X2, Y2, Z2 = sympy.symbols("X2 Y2 Z2")
second_point = vector(X2, Y2, Z2)
mapped = image(matrix_of(B), second_point)

section.definition(
    "8",
    "general central projective one-to-one correspondence",
    printed=collineation(B, second_point),
)
section.identity(
    "8#matrix",
    "the same as the product with a 4 by 4 matrix",
    printed=collineation(B, second_point),
    derived=mapped,
)

# %% [markdown]
# Five points have fifteen coordinates.

# %%
five_points = [vector(*p) for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 2, 3))]
images_of_five = Matrix.vstack(*(image(matrix_of(B), p) for p in five_points))
section.count(
    "8#independent",
    "the fifteen coefficients are independent",
    printed=15,
    derived=images_of_five,
    variables=B,
    note="Five points determine them.",
)

# %% [markdown]
# ## The central projection in four dimensions
#
# The center is $(X_o, Y_o, Z_o, T_o)$, the object point $(X, Y, Z, 0)$; the picture point $(x, y, z)$ has the fourth
# coordinate $-c$.  $\mathbf E = (e_{ij})$ is the transposed matrix of rotation, of four rows now.

# %%
To = sympy.Symbol("To")
lam = sympy.Symbol("lam")
e = Matrix(4, 4, sympy.symbols("e1:5(1:5)"))
ray = e * vector(*(point - center), -To)

section.definition("9", "central projection in four dimensions", printed=lam * ray)

picture = over(-c, ray[3]) * ray
forms = [e[i, 0] * (X - Xo) + e[i, 1] * (Y - Yo) + e[i, 2] * (Z - Zo) + e[i, 3] * (0 - To) for i in range(4)]
section.definition("10#rotation", "elements of the transposed rotation of the picture", printed=e)
section.identity(
    "10",
    "picture coordinates",
    printed=vector(*(-c * forms[i] / forms[3] for i in range(3))),
    derived=picture[:3, :],
)
xi, eta, zet = sympy.symbols("xi eta zet")
quotients = {xi: forms[0] / forms[3], eta: forms[1] / forms[3], zet: forms[2] / forms[3]}
section.identity(
    "11",
    "picture coordinates as a vector",
    printed=-c * vector(xi, eta, zet, 1),
    where=quotients,
    derived=picture,
    note="The number (11) stands beside (13) in the scan; (14a) shows that this display is meant.",
)
section.definition("1.2/quotients", "the quotients xi, eta and zeta", printed=vector(*quotients.values()))

# %% [markdown]
# ## The comparator in four dimensions

# %%
d = Matrix(4, 4, sympy.symbols("d1:5(1:5)"))
z, zco, tco = sympy.symbols("z zco tco")
spatial_center = vector(xco, yco, zco)
in_comparator = d * vector(x, y, z, -c) + vector(*spatial_center, tco)

section.definition("12", "picture point in the system of the comparator", printed=in_comparator)
section.definition("13#rotation", "elements of the rotation to the comparator", printed=d)
section.identity(
    "13",
    "measured coordinates",
    printed=vector(*(d[i, 0] * x + d[i, 1] * y + d[i, 2] * z - d[i, 3] * c for i in range(3))),
    derived=in_comparator[:3, :] - spatial_center,
)
section.identity(
    "13#projection",
    "the picture point is projected orthogonally into the hyperplane of the comparator",
    printed=vector(0, 0, 0),
    derived=(in_comparator - vector(*in_comparator[:3, :], 0))[:3, :],
)
section.identity(
    "14",
    "measured coordinates as a product",
    printed=d[:3, :] * vector(x, y, z, -c),
    derived=in_comparator[:3, :] - spatial_center,
)
measured = spatial_center + d[:3, :] * picture
section.identity(
    "14a",
    "measured coordinates of an object point",
    printed=-c * d[:3, :] * vector(xi, eta, zet, zet),
    where=quotients,
    derived=measured - spatial_center,
    expect="misprint",
    corrected=-c * d[:3, :] * vector(xi, eta, zet, 1),
    note="The fourth component of the vector must be 1, as in (11); it repeats the third.  The scan alone cannot tell "
    "a slip of the scan from one of the print.",
)

# %% [markdown]
# Numerators and denominator are linear in $(X, Y, Z)$ again; the common divisor is now the last entry of a matrix of
# four rows.


# %%
def camera_of_space(inner_map: Matrix, orientation: Matrix) -> Matrix:
    """Return the matrix of the central projection of the hyperplane T = 0."""
    hyperplane = columns(E3, -center).col_join(Matrix([[0, 0, 0, -To]]))
    return inner_map * orientation * hyperplane


A = vector(*sympy.symbols("A1:16"))
general_camera = camera_of_space(seen_by_comparator(d[:3, :], c, spatial_center), e)
section.identity(
    "15",
    "the projection is a collineation of space",
    printed=collineation(A, point),
    where=dict(zip(A, coefficients_of(general_camera), strict=True)),
    derived=measured,
)

# %% [markdown]
# ## Which rotations
#
# A rotation of a space of four dimensions has six angles, one for each pair of axes, and it turns a plane: there is no
# rotation *about an axis* with a single angle.  The paper counts one angle for each of the four axes $Y, X, Z, T$, that
# is 16 parameters in (14a): four for $\mathbf E$, four for $\mathbf D$, the center, its image and $c$.  How many of the
# fifteen coefficients are independent depends on which planes are turned.

# %%
t_mu, t_theta = sympy.symbols("t_mu t_theta")
of_plane = sympy.symbols("t13 t23")
Plane = tuple[int, int]
picture_parameters = (*center, To, *spatial_center, c)


def turned(planes: tuple[Plane, ...], tangents: tuple[sympy.Symbol, ...]) -> Matrix:
    """Return the product of rotations of four-space."""
    return rotation(*((plane, *of_half_angle(t)) for plane, t in zip(planes, tangents, strict=True)), size=4)


def camera_of_planes(
    planes: tuple[Plane, ...], of_object: tuple[sympy.Symbol, ...], of_comparator: tuple[sympy.Symbol, ...] = ()
) -> Matrix:
    """Return the matrix of projection; without angles of the comparator this is parallel to the picture."""
    to_comparator = turned(planes, of_comparator) if of_comparator else Matrix.eye(4)
    inner_map = seen_by_comparator(to_comparator[:3, :], c, spatial_center)
    return camera_of_space(inner_map, turned(planes, of_object).T)


four_of_object, four_of_comparator = (*exterior_angles, t_mu), (*comparator_angles, t_theta)
sixteen = (*four_of_object, *picture_parameters, *four_of_comparator)

section.count(
    "1.2/about-axes",
    "a rotation about a coordinate axis of four dimensions has one element",
    printed=1,
    derived=turned(((0, 1), (0, 2), (1, 2)), (t_mu, *of_plane)),
    variables=(t_mu, *of_plane),
    expect="false",
    instead="1.2/beyond/about-axes",
    note="Equation (9) has one matrix and one angle for each of the axes Y, X, Z and T.  Around the axis T all "
    "rotations of the space X, Y, Z are possible.  The words do not say which rotations are meant: what follows "
    "depends on it.",
)
section.count(
    "1.2/beyond/about-axes",
    "a rotation that leaves an axis of four dimensions where it is has three elements",
    printed=3,
    derived=turned(((0, 1), (0, 2), (1, 2)), (t_mu, *of_plane)),
    variables=(t_mu, *of_plane),
    note="Not in the paper.  By the plane that is turned one element would be enough, and there are six planes.",
)

# %% [markdown]
# If each angle turns a plane that does not contain its axis, there are planes for which the statement of the paper
# holds: let $\phi, \omega, \kappa$ turn $Z, Y, X$ towards $T$ and $\mu$ turn $X$ towards $Y$, and $\alpha, \beta,
# \gamma, \theta$ likewise.

# %%
other_planes = ((2, 3), (1, 3), (0, 3), (0, 1))
section.count(
    "1.2/independent",
    "the fifteen coefficients are independent functions of sixteen parameters",
    printed=15,
    derived=coefficients_of(camera_of_planes(other_planes, four_of_object, four_of_comparator)),
    variables=sixteen,
    note="Favourable reading, with the planes that are named above; the paper does not say which planes its rotations "
    "turn.  Of the 81 ways to turn a plane without the named axis 9 give fifteen at a rational point.  The number of "
    "parameters, which is the reason the paper gives, does not prove it: with the rotations of (2) there are thirteen, "
    "1.2/beyond/ordinary-rotations, and without a rotation of T there is no perspective, 1.2/beyond/literal.  With "
    "general rotations it is true, 1.2/beyond/rotations-of-space.",
)

# %% [markdown]
# Taken literally, $\mathbf D_\mu$ leaves the axis $T$ where it is.  If $\mathbf D_\phi$, $\mathbf D_\omega$ and
# $\mathbf D_\kappa$ are the rotations of (2), so do they, and (10) is no perspective at all: its denominator is
# constant.

# %%
literal = (ABOUT_Y, ABOUT_X, ABOUT_Z, ABOUT_Z)
of_object, of_comparator = (
    rotation(*((plane, *sympy.symbols(f"cos{k} sin{k}")) for k, plane in enumerate(literal, first)), size=4)
    for first in (1, 5)
)
section.identity(
    "1.2/beyond/literal",
    "without a rotation that turns T the denominator does not depend on the object point",
    printed=vector(0, 0, 0, -To).T,
    derived=camera_of_space(seen_by_comparator(of_comparator[:3, :], c, spatial_center), of_object.T)[3, :],
    note="Not in the paper: mu must turn a plane that contains the axis T.",
)

# %% [markdown]
# So let $\phi, \omega, \kappa$ be those of (2) and $\mu$ turn $Z$ towards $T$, and $\theta$ likewise.  In the system of
# the picture, with $(u, v, w) = \mathbf R^T (\mathbf X - \mathbf X_o)$, the measured point is, but for a constant,
# $\left(u,\ v,\ -\frac{T_o \cos\theta}{\sin\mu}\right)$ times $\frac{c}{\sin\mu}$ over $w + T_o \cot\mu$, turned by
# $\mathbf D$.  Three changes of the parameters change nothing: a common turn about the axis of $w$, and two that keep
# the two factors and $T_o \cot\mu - w_o$.

# %%
Z_TO_T = (2, 3)
ordinary = (ABOUT_Y, ABOUT_X, ABOUT_Z, Z_TO_T)
camera_of_sixteen = camera_of_planes(ordinary, four_of_object, four_of_comparator)

(cos_mu, sin_mu), (cos_theta, sin_theta) = of_half_angle(t_mu), of_half_angle(t_theta)
axis_of_picture = turned(ordinary[:3], exterior_angles)[:3, 2]
axis_of_comparator = turned(ordinary[:3], comparator_angles)[:3, 2]


def change(along_picture: Scalar, shift_of_image: Scalar, rates: dict[sympy.Symbol, Scalar]) -> Matrix:
    """Return a direction in the sixteen parameters: shifts of the center and of its image, and rates of the others."""
    shifts = dict(
        zip(
            (*center, *spatial_center),
            (*(along_picture * axis_of_picture), *(shift_of_image * axis_of_comparator)),
            strict=True,
        )
    )
    all_rates = shifts | {
        name: rate * angle_rate(name) if name.name.startswith("t_") else rate for name, rate in rates.items()
    }
    return vector(*(all_rates.get(parameter, 0) for parameter in sixteen))


constant_by_theta = cos_theta * sin_mu - sin_theta * cos_mu
constant_by_mu = cos_mu * sin_theta * (cos_theta * cos_mu + sin_theta * sin_mu) - cos_theta * sin_theta
free_changes = [
    change(0, 0, {exterior_angles[2]: 1, comparator_angles[2]: 1}),
    change(
        To * sin_theta * cos_mu,
        -c * cos_theta * constant_by_theta,
        {To: To * sin_theta * sin_mu, t_theta: cos_theta * sin_mu},
    ),
    change(
        -To * sin_theta,
        -c * (constant_by_mu - cos_theta * cos_mu * constant_by_theta),
        {t_mu: sin_theta * sin_mu**2, t_theta: -cos_theta * cos_mu * sin_mu, c: c * sin_theta * cos_mu * sin_mu},
    ),
]
entries_of_sixteen = camera_of_sixteen.applyfunc(lambda entry: over(entry, sin_mu))
section.count(
    "1.2/beyond/ordinary-rotations",
    "with the rotations of (2) thirteen of sixteen parameters are independent",
    printed=13,
    derived=entries_of_sixteen,
    variables=sixteen,
    kernel=free_changes,
    note="Not in the paper: such a projection is no general collineation.  Counted are the entries of the matrix of "
    "projection, divided by sin(mu); the coefficients are quotients of them and cannot be more.",
)
section.count(
    "1.2/beyond/ordinary-rotations#coefficients",
    "with the rotations of (2) thirteen coefficients are independent",
    printed=13,
    derived=vector(*coefficients_of(camera_of_sixteen)[2:15]),
    variables=sixteen,
    note="Not in the paper.  All but A1 and A2 are independent; more there are not, by 1.2/beyond/ordinary-rotations.",
)
all_planes = ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))
six_of_object, six_of_comparator = sympy.symbols("t1:7"), sympy.symbols("t7:13")
A_of_twenty = coefficients_of(camera_of_planes(all_planes, six_of_object, six_of_comparator))
section.count(
    "1.2/beyond/rotations-of-space",
    "general rotations reach all fifteen coefficients",
    printed=15,
    derived=A_of_twenty,
    variables=(*six_of_object, *picture_parameters, *six_of_comparator),
    note="Not in the paper: six angles for each rotation, twenty parameters.",
)
section.count(
    "15#independent",
    "the coefficients of (15) are independent, as those of (8)",
    printed=15,
    derived=A_of_twenty,
    variables=(*six_of_object, *picture_parameters, *six_of_comparator),
    note="For general rotations.  A general collineation is a central and an orthogonal projection in four dimensions; "
    "the count shows it in general and near every such projection.",
)

# %% [markdown]
# ## Code

# %%
section.kernel(
    "collinearity.space_map",
    "Image of a point under the general central projective one-to-one correspondence of two spaces.",
    arguments={"B": B, "X": second_point},
    derived=mapped,
    claims=["8#matrix"],
    describe={
        "B": "Coefficients (B1, ..., B15); their units follow from those of the coordinates of both spaces.",
        "X": "Point (X2, Y2, Z2) of the second space; any unit of length.",
    },
    example={
        "B": (
            *("1.25", "0.125", "-0.25", "3.5", "-0.125", "1.375", "0.0625", "-2.25"),
            *("0.375", "-0.0625", "1.125", "0.75", "0.0125", "-0.005", "0.0025"),
        ),
        "X": ("12.5", "-7.25", "31.75"),
    },
)

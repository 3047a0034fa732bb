# %% [markdown]
# # 1.2 General central projective one-to-one correspondence between two three-dimensional spaces
#
# A model and its object, both of three dimensions, differ by a collineation with fifteen coefficients.  Can that be a
# photograph as well?  The paper takes one in a space of four dimensions: its "picture" has three, and so has its
# comparator.  The idea is right.  What is a rotation there, and how many angles has it?

# %%
from itertools import combinations, product

import sympy

from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.inserting import given, inserted
from algebroproj_derivations.okamoto1981.notation import *
from algebroproj_derivations.okamoto1981.s1_1_general_collinearity import comparator_angles, exterior_angles
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, Scalar, columns, over, vector

section = Section("okamoto1981", "1.2", "Central projective one-to-one correspondence between two spaces")

# %% [markdown]
# ## What is the correspondence?
#
# **Definition.**  Three quotients of linear forms with one denominator.

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


# %% [markdown]
# **Print.**  It is a product with a matrix of four rows, divided by its last component.

# %%
section.definition(
    "8",
    "general central projective one-to-one correspondence",
)
section.identity(
    "8#matrix",
    "the same as the product with a 4 by 4 matrix",
    derived=mapped,
)

# %% [markdown]
# **Are the coefficients independent?**  Five points have fifteen coordinates; their images depend on all of them.

# %%
five_points = [vector(*p) for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 2, 3))]
images_of_five = Matrix.vstack(*(image(matrix_of(B), p) for p in five_points))
section.count(
    "8#independent",
    "the fifteen coefficients are independent",
    derived=images_of_five,
    variables=B,
)

# %% [markdown]
# **An example.**  A collineation takes a cube to a body with plane faces.  Edges that were parallel meet.

# %%
CUBE = list(product(range(2), repeat=3))
FRUSTUM = inserted(mapped, B, (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, sympy.Rational(1, 2)))
corners = {f"{i}{j}{k}": vector(i - sympy.Rational(1, 2), j - sympy.Rational(1, 2), k) for i, j, k in CUBE}
SpaceDrawing(
    "The image of a cube under a collineation with the denominator Z/2 + 1.  The four edges that were parallel to the "
    "third axis would meet in one point.",
    {name: inserted(FRUSTUM, second_point, corner).doit() for name, corner in corners.items()},
    segments=[(a, b) for a, b in combinations(corners, 2) if sum(p != q for p, q in zip(a, b, strict=True)) == 1],
    axes=("X_1", "Y_1", "Z_1"),
)

# %% [markdown]
# ## How does one photograph in four dimensions?
#
# **Definition.**  The center is $(X_o, Y_o, Z_o, T_o)$, the object point $(X, Y, Z, 0)$; the picture point $(x, y, z)$
# has the fourth coordinate $-c$.  $\mathbf E = (e_{ij})$ is the transposed matrix of rotation, of four rows now.

# %%
To = sympy.Symbol("To")
e = Matrix(4, 4, sympy.symbols("e1:5(1:5)"))
ray = e * vector(*(point - center), -To)

section.definition("9", "central projection in four dimensions")


# %% [markdown]
# **Print.**  As in three dimensions, with one form more.

# %%
picture = over(-c, ray[3]) * ray
forms = [e[i, 0] * (X - Xo) + e[i, 1] * (Y - Yo) + e[i, 2] * (Z - Zo) + e[i, 3] * (0 - To) for i in range(4)]
section.definition("10#rotation", "elements of the transposed rotation of the picture")
section.identity("10", "picture coordinates", derived=picture[:3, :])

# %% [markdown]
# The quotients of the forms have the names $\xi, \eta, \zeta$.

# %%
xi, eta, zet = sympy.symbols("xi eta zet")
quotients = {xi: forms[0] / forms[3], eta: forms[1] / forms[3], zet: forms[2] / forms[3]}
section.identity(
    "11",
    "picture coordinates as a vector",
    where=quotients,
    derived=picture,
    note="The number (11) stands beside (13) in the scan; (14a) shows that this display is meant.",
)
section.definition("1.2/quotients", "the quotients xi, eta and zeta")

# %% [markdown]
# ## And the comparator?
#
# **Definition.**  It turns the picture and keeps three of four coordinates: an orthogonal projection.

# %%
d = Matrix(4, 4, sympy.symbols("d1:5(1:5)"))
z, zco, tco = sympy.symbols("z zco tco")
spatial_center = vector(xco, yco, zco)
in_comparator = d * vector(x, y, z, -c) + vector(*spatial_center, tco)

section.definition("12", "picture point in the system of the comparator")
section.definition("13#rotation", "elements of the rotation to the comparator")

# %% [markdown]
# **Print.**

# %%
section.identity("13", "measured coordinates", derived=in_comparator[:3, :] - spatial_center)
section.identity(
    "13#projection",
    "the picture point is projected orthogonally into the hyperplane of the comparator",
    printed=vector(0, 0, 0),
    derived=(in_comparator - vector(*in_comparator[:3, :], 0))[:3, :],
)
section.identity("14", "measured coordinates as a product", derived=in_comparator[:3, :] - spatial_center)

# %% [markdown]
# Equation (11) put into (14).  The last component is 1.

# %%
measured = spatial_center + d[:3, :] * picture
section.identity(
    "14a",
    "measured coordinates of an object point",
    where=quotients,
    derived=measured - spatial_center,
    expect="misprint",
    corrected=-c * d[:3, :] * vector(xi, eta, zet, 1),
    note="The fourth component of the vector must be 1, as in (11); it repeats the third.  The scan alone cannot tell "
    "a slip of the scan from one of the print.",
)

# %% [markdown]
# **Is it a collineation?**  Numerators and denominator are linear in $(X, Y, Z)$ again.  The common divisor is the last
# element of a matrix of four rows.


# %%
def camera_of_space(inner_map: Matrix, orientation: Matrix) -> Matrix:
    """Return the matrix of the central projection of the hyperplane T = 0."""
    hyperplane = columns(E3, -center).col_join(Matrix([[0, 0, 0, -To]]))
    return inner_map * orientation * hyperplane


A = vector(*sympy.symbols("A1:16"))
general_camera = camera_of_space(seen_by_comparator(d[:3, :], c, spatial_center), e)
section.identity(
    "15", "the projection is a collineation of space", where=given(A, coefficients_of(general_camera)), derived=measured
)

# %% [markdown]
# ## Is every collineation such a photograph?
#
# The paper counts one angle for each of the four axes $Y, X, Z, T$.  These are 16 parameters in (14a): four for
# $\mathbf E$, four for $\mathbf D$, the center, its image and $c$.  Sixteen are more than fifteen, so it concludes that
# all coefficients are reached.
#
# **But what is a rotation about an axis?**  A rotation of four dimensions turns planes.  It has six angles, one for
# each pair of axes.  Around the axis $T$ all rotations of the space $X, Y, Z$ are possible: three angles, and not one.

# %%
t_mu, t_theta = sympy.symbols("t_mu t_theta")
of_plane = sympy.symbols("t13 t23")
Plane = tuple[int, int]


def turned(planes: tuple[Plane, ...], tangents: tuple[sympy.Symbol, ...]) -> Matrix:
    """Return the product of rotations of four-space."""
    return rotation(*((plane, *of_half_angle(t)) for plane, t in zip(planes, tangents, strict=True)), size=4)


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
)

# %% [markdown]
# So the answer depends on the planes that are turned.


# %%
picture_parameters = (*center, To, *spatial_center, c)
four_of_object, four_of_comparator = (*exterior_angles, t_mu), (*comparator_angles, t_theta)
sixteen = (*four_of_object, *picture_parameters, *four_of_comparator)


def camera_of_planes(
    planes: tuple[Plane, ...], of_object: tuple[sympy.Symbol, ...], of_comparator: tuple[sympy.Symbol, ...] = ()
) -> Matrix:
    """Return the matrix of projection; without angles of the comparator this is parallel to the picture."""
    to_comparator = turned(planes, of_comparator) if of_comparator else Matrix.eye(4)
    inner_map = seen_by_comparator(to_comparator[:3, :], c, spatial_center)
    return camera_of_space(inner_map, turned(planes, of_object).T)


# %% [markdown]
# ### Planes for which the paper is right
#
# Let $\phi, \omega, \kappa$ turn $Z, Y, X$ towards $T$ and $\mu$ turn $X$ towards $Y$, and $\alpha, \beta, \gamma,
# \theta$ likewise.  None of these planes contains its axis.

# %%
other_planes = ((2, 3), (1, 3), (0, 3), (0, 1))
section.count(
    "1.2/independent",
    "the fifteen coefficients are independent functions of sixteen parameters",
    derived=coefficients_of(camera_of_planes(other_planes, four_of_object, four_of_comparator)),
    variables=sixteen,
    note="Favourable reading, with the planes that are named above; the paper does not say which planes its rotations "
    "turn.  Of the 81 ways to turn a plane without the named axis 9 give fifteen at a rational point.  The number of "
    "parameters, which is the reason the paper gives, does not prove it: with the rotations of (2) there are thirteen, "
    "1.2/beyond/ordinary-rotations, and without a rotation of T there is no perspective, 1.2/beyond/literal.  With "
    "general rotations it is true, 1.2/beyond/rotations-of-space.",
)

# %% [markdown]
# ### The rotations of section 1.1
#
# Taken literally, $\mathbf D_\mu$ leaves the axis $T$ where it is.  $\mathbf D_\phi$, $\mathbf D_\omega$ and $\mathbf
# D_\kappa$ of (2) do as well.  Then (10) has a constant denominator: there is no perspective at all, and $\mu$ must
# turn a plane that contains the axis $T$.

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
)

# %% [markdown]
# So let $\phi, \omega, \kappa$ be those of (2) and $\mu$ turn $Z$ towards $T$, and $\theta$ likewise.
#
# **Derivation.**  In the system of the picture, with $(u, v, w) = \mathbf R^T (\mathbf X - \mathbf X_o)$, the measured
# point is, but for a constant, $\left(u,\ v,\ -\frac{T_o \cos\theta}{\sin\mu}\right)$ times $\frac{c}{\sin\mu}$ over
# $w + T_o \cot\mu$, turned by $\mathbf D$.  Three changes of the parameters change nothing: a common turn about the
# axis of $w$, and two that keep the two factors and $T_o \cot\mu - w_o$.

# %%
Z_TO_T = (2, 3)
ordinary = (ABOUT_Y, ABOUT_X, ABOUT_Z, Z_TO_T)
camera_of_sixteen = camera_of_planes(ordinary, four_of_object, four_of_comparator)

(cos_mu, sin_mu), (cos_theta, sin_theta) = of_half_angle(t_mu), of_half_angle(t_theta)
axis_of_picture = turned(ordinary[:3], exterior_angles)[:3, 2]
axis_of_comparator = turned(ordinary[:3], comparator_angles)[:3, 2]


def change(along_picture: Scalar, shift_of_image: Scalar, rates: dict[sympy.Symbol, Scalar]) -> Matrix:
    """Return a direction in the sixteen parameters: shifts of the center and of its image, and rates of the others."""
    shifts = given(
        (*center, *spatial_center), (*(along_picture * axis_of_picture), *(shift_of_image * axis_of_comparator))
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

# %% [markdown]
# Thirteen are left of sixteen: such a photograph is no general collineation.  Counted are the elements of the matrix of
# projection, divided by $\sin \mu$; the coefficients are quotients of them and cannot be more.  All of them but $A_1$
# and $A_2$ are independent.

# %%
entries_of_sixteen = camera_of_sixteen.applyfunc(lambda entry: over(entry, sin_mu))
section.count(
    "1.2/beyond/ordinary-rotations",
    "with the rotations of (2) thirteen of sixteen parameters are independent",
    printed=13,
    derived=entries_of_sixteen,
    variables=sixteen,
    kernel=free_changes,
)
section.count(
    "1.2/beyond/ordinary-rotations#coefficients",
    "with the rotations of (2) thirteen coefficients are independent",
    printed=13,
    derived=vector(*coefficients_of(camera_of_sixteen)[2:15]),
    variables=sixteen,
)

# %% [markdown]
# ### General rotations
#
# With six angles for each rotation there are twenty parameters, and they reach all fifteen coefficients.

# %%
all_planes = ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))
six_of_object, six_of_comparator = sympy.symbols("t1:7"), sympy.symbols("t7:13")
A_of_twenty = coefficients_of(camera_of_planes(all_planes, six_of_object, six_of_comparator))
section.count(
    "1.2/beyond/rotations-of-space",
    "general rotations reach all fifteen coefficients",
    printed=15,
    derived=A_of_twenty,
    variables=(*six_of_object, *picture_parameters, *six_of_comparator),
)

# %% [markdown]
# **Meaning.**  For these the paper's theorem holds: a general collineation is a central and an orthogonal projection in
# four dimensions.  The count shows it in general, and near every such projection.

# %%
section.count(
    "15#independent",
    "the coefficients of (15) are independent, as those of (8)",
    derived=A_of_twenty,
    variables=(*six_of_object, *picture_parameters, *six_of_comparator),
    note="For general rotations, 1.2/beyond/rotations-of-space.",
)

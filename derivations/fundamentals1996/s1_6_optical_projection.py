# %% [markdown]
# # 1.6 Optical projection
#
# An ideal lens maps space to space, and does so projectively.  The axes $\xi_1, \xi_2$ span the principal plane $H$ of
# the lens, $\xi_3$ is the optical axis, $f$ the focal length; primes denote the image space.

# %%
import sympy

from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    columns,
    cross,
    determinant,
    diff,
    divided,
    dot,
    homogeneous,
    inverse,
    linear_system,
    over,
    rows,
    solve,
    vector,
)

section = Section("fundamentals1996", "1.6", "Optical projection")


def coefficients(form: sympy.Expr, coordinates: Matrix) -> Matrix:
    """Return the coefficients (constant first) of an equation, form = 0, of a plane or a line."""
    linear, right_side = linear_system([form], tuple(coordinates))
    return vector(-right_side[0], *linear)


# %% [markdown]
# ## The lens
#
# Two rays leave a point $\boldsymbol\xi$ of object space.  The one parallel to the axis meets $H$ in
# $(\xi_1, \xi_2, 0)$ and goes on through the focal point $(0, 0, f)$; the one through the center of the lens goes
# straight on.  They meet in the image point: $(1 - t)\, \xi_i = s\, \xi_i$ for $i = 1, 2$ and $t f = s\, \xi_3$.

# %%
f, s, t = sympy.symbols("f s t")
xi1, xi2, xi3 = sympy.symbols("xi1 xi2 xi3")
xi = vector(xi1, xi2, xi3)

forward_matrix, forward_right_side = linear_system([s + t - 1, t * f - s * xi3], [s, t])
scale = solve(forward_matrix, forward_right_side)[0]
image = vector(*(scale * component for component in xi))

# %% [markdown]
# Backwards: the ray parallel to the axis in image space came through the focal point $(0, 0, -f)$ of object space, so
# that $(1 + t)\, \xi'_i = s\, \xi'_i$ and $t f = s\, \xi'_3$.

# %%
xip1, xip2, xip3 = sympy.symbols("xip1 xip2 xip3")
xi_prime = vector(xip1, xip2, xip3)

backward_matrix, backward_right_side = linear_system([s - t - 1, t * f - s * xip3], [s, t])
backward_scale = solve(backward_matrix, backward_right_side)[0]
object_point = vector(*(backward_scale * component for component in xi_prime))

# %% [markdown]
# The quasihomogeneous image, multiplied by the divisor $\tau = f + \xi_3$, is linear in $\boldsymbol\xi$: its
# coefficients are the matrix $\mathbf M_f$.

# %%
tau_of_xi = determinant(forward_matrix)
tau_of_image = determinant(backward_matrix)
image_vector = divided(tau_of_xi * homogeneous(image))
object_vector = divided(tau_of_image * homogeneous(object_point))
M_f = rows(*(coefficients(component, xi) for component in image_vector))

M_f_printed = f * Matrix([[1, 0, 0, 1 / f], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
M_f_inverse_printed = Matrix([[1, 0, 0, -1 / f], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) / f
section.identity("1.6/M_f", "projective matrix of the lens", printed=M_f_printed, derived=M_f)
section.identity("1.6/M_f#inverse", "its inverse", printed=M_f_inverse_printed, derived=inverse(M_f))
section.up_to_scale(
    "1.6/M_f#backward",
    "the inverse maps backwards",
    printed=M_f_inverse_printed,
    derived=rows(*(coefficients(component, xi_prime) for component in object_vector)),
)

# %% [markdown]
# ## Points
#
# From object to image, with Gauss' law for the distances.

# %%
tau = sympy.Symbol("tau")
section.identity(
    "1.6.1",
    "from object to image",
    printed=M_f_printed * homogeneous(xi),
    derived=tau_of_xi * homogeneous(image),
    note="The left side of the print, tau z', is the derived one, with tau = f + xi3.",
)
section.identity(
    "1.6.1#scalar",
    "image coordinates",
    printed=vector(*(f * component / (f + xi3) for component in xi)),
    derived=image,
)
section.identity(
    "1.6.1#gauss",
    "Gauss' law",
    printed=1 / f,
    derived=over(1, image[2]) - over(1, xi3),
    note="Derived from the two rays.  In these coordinates an object in front of the lens has a negative xi3.",
)

# %% [markdown]
# From image to object; $\tau$ is the same number, $f + \xi_3$, expressed by the image.

# %%
section.identity(
    "1.6.2",
    "from image to object",
    printed=tau * M_f_inverse_printed * homogeneous(xi_prime),
    where={tau: f + object_point[2]},
    derived=homogeneous(object_point),
    note="tau = f + xi3 as in (1.6.1).",
)
section.identity(
    "1.6.2#scalar",
    "object coordinates",
    printed=vector(*(f * component / (f - xip3) for component in xi_prime)),
    derived=object_point,
)
section.identity(
    "1.6.2#gauss",
    "Gauss' law, backwards",
    printed=-1 / f,
    derived=over(1, object_point[2]) - over(1, xip3),
)

# %% [markdown]
# The scale of the image is the same for all three coordinates.

# %%
section.identity(
    "1.6/scale",
    "image scale, from the distance of the object",
    printed=vector(*(f / (f + xi3) for _ in xi)),
    derived=vector(*(over(image[i], xi[i]) for i in range(3))),
)
section.identity(
    "1.6/scale#image",
    "image scale, from the distance of the image",
    printed=vector(*((f - xip3) / f for _ in xi)),
    where={xip3: image[2]},
    derived=vector(*(over(image[i], xi[i]) for i in range(3))),
)
section.identity(
    "1.6/scale#gauss",
    "that the two forms of the scale are equal is Gauss' law",
    printed=1 / f,
    derived=over(1, xip3) - over(1, xi3),
    constraints=[f**2 - (f + xi3) * (f - xip3)],
    note="The constraint is f/(f + xi3) = (f - xip3)/f, multiplied by both divisors.",
)

# %% [markdown]
# ## Planes
#
# A plane $E$ with the coefficients $\mathbf a$ is mapped to a plane $E'$: its equation holds for the object points that
# belong to $\boldsymbol\xi'$.

# %%
a = vector(*sympy.symbols("a:4"))
a_image = inverse(M_f).T * a
E_form = dot(a, homogeneous(xi))
E_image_form = dot(a, object_vector)

section.identity(
    "1.6/a'",
    "coefficients of the image plane, by (1.5.7)",
    printed=vector(a[0] / f, a[1] / f, a[2] / f, (-a[0] / f + a[3]) / f),
    derived=a_image,
)
E_image_printed = f * a[0] + f * a[1] * xip1 + f * a[2] * xip2 + (f * a[3] - a[0]) * xip3
section.up_to_scale(
    "1.6/E'",
    "equation of the image plane",
    printed=coefficients(E_image_printed, xi_prime),
    derived=coefficients(E_image_form, xi_prime),
)

# %% [markdown]
# The equation of $E$ itself and the sentence around it are lost in the scan.  What survives fixes it: it is the plane
# whose image satisfies the surviving equation of $E'$.

# %%
pulled_back = dot(coefficients(E_image_printed, xi_prime), image_vector)
section.up_to_scale(
    "1.6/plane-E",
    "equation of the object plane",
    printed=None,
    derived=coefficients(pulled_back, xi),
    expect="illegible",
    corrected=a,
    note="Coefficients of 1, xi1, xi2, xi3.  The scan has a gap between the scale m' and the coefficients of E'.  "
    "Reconstructed is E: a0 + a1 xi1 + a2 xi2 + a3 xi3 = 0, the preimage of the surviving equation of E'; the "
    "equations of S and V presuppose it.",
)

# %% [markdown]
# ## The Scheimpflug line
#
# $E$ and $E'$ meet the principal plane in the same line $S$, because the points of $H$ are their own images.

# %%
in_plane, in_image_plane = vector(xi1, xi2), vector(xip1, xip2)
S_line = coefficients(E_form.subs(xi3, 0), in_plane)
S_image_line = coefficients(E_image_form.subs(xip3, 0), in_image_plane)

section.up_to_scale("1.6/S", "line of E in the principal plane", printed=vector(*a[:3, 0]), derived=S_line)
section.up_to_scale(
    "1.6/S'",
    "line of E' in the principal plane",
    printed=vector(f * a[0], f * a[1], f * a[2]),
    derived=S_image_line,
)
section.up_to_scale("1.6/S#identical", "the two lines are identical", printed=S_line, derived=S_image_line)
section.identity(
    "1.6/beyond/principal-plane",
    "the points of the principal plane are their own images",
    printed=vector(xi1, xi2, 0),
    derived=image.subs(xi3, 0),
    note="Not in the paper: why S and its image coincide point by point.",
)

# %% [markdown]
# Three planes share a line if their matrix of coefficients (3 by 4) has rank 2.

# %%
principal_plane = vector(0, 0, 0, 1)
pencil = rows(a, a_image, principal_plane)
section.identity(
    "1.6/scheimpflug",
    "object plane, image plane and principal plane meet in one line",
    printed=Matrix.zeros(4, 1),
    derived=vector(*(determinant(columns(*(pencil.col(j) for j in range(4) if j != omitted))) for omitted in range(4))),
    note="The minors of the three planes.  A plane through the center of the lens, a0 = 0, is its own image.",
)

# %% [markdown]
# ## The vanishing lines

# %%
V_line = coefficients(E_form.subs(xi3, -f), in_plane)
V_image_line = coefficients(E_image_form.subs(xip3, f), in_image_plane)
section.up_to_scale("1.6.3", "vanishing line in E", printed=vector(a[0] - f * a[3], a[1], a[2]), derived=V_line)
section.up_to_scale(
    "1.6.4", "vanishing line in E', the horizon", printed=vector(f * a[3], a[1], a[2]), derived=V_image_line
)

# %% [markdown]
# The points at infinity of a plane are its directions, spanned by that of $S$, at right angles to the axis and to the
# normal of the plane, and by the one at right angles to $S$.  The line through the images of these two points is the
# image of the line at infinity.  As it lies at a constant distance from $H$, the coordinates $\xi_1, \xi_2$ suffice.


# %%
def directions(normal: Matrix) -> tuple[Matrix, Matrix]:
    """Return the direction of S in a plane with the given normal, and the one at right angles to it."""
    along = cross(normal, vector(0, 0, 1))
    return along, cross(normal, along)


def line_of_images(matrix: Matrix, normal: Matrix) -> Matrix:
    first, second = (matrix * vector(0, *direction) for direction in directions(normal))
    return cross(vector(*first[:3, 0]), vector(*second[:3, 0]))


normal, image_normal = vector(*a[1:, 0]), vector(*a_image[1:, 0])
section.up_to_scale(
    "1.6/remote#V",
    "the vanishing line in E is the preimage of the line at infinity of E'",
    printed=vector(a[0] - f * a[3], a[1], a[2]),
    derived=line_of_images(inverse(M_f), image_normal),
)
section.up_to_scale(
    "1.6/remote#V'",
    "the horizon is the image of the line at infinity of E",
    printed=vector(f * a[3], a[1], a[2]),
    derived=line_of_images(M_f, normal),
)


def parallel(first: Matrix, second: Matrix) -> sympy.Expr:
    """Return what is zero if two lines, at constant distances from the principal plane, are parallel."""
    return determinant(columns(first[1:, :], second[1:, :]))


section.identity(
    "1.6/parallel",
    "the vanishing lines are parallel to the Scheimpflug line",
    printed=vector(0, 0),
    derived=vector(parallel(V_line, S_line), parallel(V_image_line, S_image_line)),
)

# %% [markdown]
# ## Affine coordinates in the planes
#
# With basic points in $E$ and their images in $E'$ the regular transformation of section 1.5 has its counterpart in the
# plane: $\mu_j \mathbf e'_j = \mathbf M^* \mathbf e_j$ for three unit points.

# %%
factors = (mu0, mu1, mu2)
units = columns(image_e0, image_e1, image_e2)
M_star = columns(*(factor * units.col(j) for j, factor in enumerate(factors))) * inverse(units)
M = inverse(M_star)

M_star_printed = Matrix([[mu0, mu1 - mu0, mu2 - mu0], [0, mu1, 0], [0, 0, mu2]])
M_printed = Matrix([[1 / mu0, 1 / mu1 - 1 / mu0, 1 / mu2 - 1 / mu0], [0, 1 / mu1, 0], [0, 0, 1 / mu2]])
section.identity("1.6/M*", "matrix from E to E'", printed=M_star_printed, derived=M_star)
section.identity("1.6/M", "matrix from E' to E", printed=M_printed, derived=M)

# %% [markdown]
# The lens itself gives the factors.  A point of $E$ with the affine coordinates $u_1, u_2$ is
# $G_0 + u_1 (G_1 - G_0) + u_2 (G_2 - G_0)$, and the first component of $\mathbf M_f \mathbf z$ at a basic point is
# $\mu_j = f + \xi_3(G_j)$.

# %%
u = vector(u1, u2)
basic_points = [vector(*sympy.symbols(f"g{j}1 g{j}2 g{j}3")) for j in range(3)]


def affine_point(points: list[Matrix], coordinates: Matrix) -> Matrix:
    return points[0] + coordinates[0] * (points[1] - points[0]) + coordinates[1] * (points[2] - points[0])


def imaged(point: Matrix) -> Matrix:
    return image.xreplace(dict(zip(xi, point, strict=True)))


image_basic_points = [imaged(point) for point in basic_points]
E_point = affine_point(basic_points, u)
mapped = M_star * homogeneous(u)
mapped_u = vector(over(mapped[1], mapped[0]), over(mapped[2], mapped[0]))
mu_of_lens = {factor: f + point[2] for factor, point in zip(factors, basic_points, strict=True)}

section.identity(
    "1.6.5#lens",
    "the affine coordinates belong to the image that the lens produces",
    printed=affine_point(image_basic_points, mapped_u),
    where=mu_of_lens,
    derived=imaged(E_point),
    note="With mu_j = f + xi3 at the basic point G_j.",
)

# %% [markdown]
# Conversely the lens determines $\mathbf u'$: its image point is a combination of the three image points $G'_j$ as
# vectors, with weights that add up to 1.

# %%
up1, up2, mu_symbol = sympy.symbols("up1 up2 mu")
weights = solve(columns(*image_basic_points), imaged(E_point))
section.up_to_scale(
    "1.6.5",
    "affine coordinates from E to E'",
    printed=M_star_printed * homogeneous(u),
    where=mu_of_lens,
    derived=vector(sum(weights), weights[1], weights[2]),
    note="The derived side is u' itself, and the factor is mu.",
)
section.identity(
    "1.6.5#backward",
    "affine coordinates from E' to E",
    printed=mu_symbol * M_printed * homogeneous(vector(up1, up2)),
    where={mu_symbol: mapped[0], up1: mapped_u[0], up2: mapped_u[1]},
    derived=homogeneous(u),
    note="mu is the same factor as in the other direction.",
)

# %% [markdown]
# ## The vanishing lines in affine coordinates
#
# A point is mapped to infinity where the first component vanishes.  In terms of lines this is the line at infinity,
# $(1, 0, 0)$, of the other plane, carried over as in (1.5.6) and (1.5.7).

# %%
at_infinity = vector(1, 0, 0)
g = M_star.T * at_infinity
g_image = M.T * at_infinity

section.identity("1.6/g", "line of E with its image at infinity", printed=vector(mu0, mu1 - mu0, mu2 - mu0), derived=g)
section.identity(
    "1.6/g'",
    "image of the line at infinity of E",
    printed=vector(1 / mu0, 1 / mu1 - 1 / mu0, 1 / mu2 - 1 / mu0),
    derived=g_image,
)

# %% [markdown]
# Do they coincide with $V$ and $V'$?  The plane $E$ passes through the basic points; (1.6.3), taken at a point of $E$,
# is a linear form in $u_1, u_2$.


# %%
def plane_through(points: list[Matrix]) -> Matrix:
    normal = cross(points[1] - points[0], points[2] - points[0])
    return vector(-dot(normal, points[0]), *normal)


def in_affine_coordinates(line: Matrix, points: list[Matrix], coordinates: Matrix) -> Matrix:
    """Return the coefficients of a line, given in the first two coordinates of space, in affine coordinates."""
    return coefficients(dot(line, homogeneous(vector(*affine_point(points, coordinates)[:2, 0]))), coordinates)


E_through = dict(zip(a, plane_through(basic_points), strict=True))
section.up_to_scale(
    "1.6/g#V",
    "g coincides with the vanishing line in E",
    printed=g,
    where=mu_of_lens,
    derived=in_affine_coordinates(V_line.xreplace(E_through), basic_points, u),
    note="With mu_j = f + xi3(G_j), in agreement with 1.6.5#lens; the form g is f + xi3 of the point.",
)

# %% [markdown]
# On the side of the image the points $G'_j$ are given, the basic points are their preimages, and the coefficients of
# $E$ follow from those of $E'$ by (1.5.6).

# %%
u_prime = vector(up1, up2)
given_images = [vector(*sympy.symbols(f"gp{j}1 gp{j}2 gp{j}3")) for j in range(3)]
preimages = [object_point.xreplace(dict(zip(xi_prime, point, strict=True))) for point in given_images]
mu_of_images = {factor: f + point[2] for factor, point in zip(factors, preimages, strict=True)}
E_of_images = dict(zip(a, M_f.T * plane_through(given_images), strict=True))
section.up_to_scale(
    "1.6/g'#V'",
    "g' coincides with the horizon in E'",
    printed=g_image,
    where=mu_of_images,
    derived=in_affine_coordinates(V_image_line.xreplace(E_of_images), given_images, u_prime),
    note="With the same mu_j = f + xi3(G_j), where G_j is the preimage of the given G'_j.",
)

# %% [markdown]
# ## One more control point
#
# Where the basic points correspond, the line $\mathbf g$ alone fixes the parameters but for a common factor.

# %%
g_given = vector(*sympy.symbols("g0 g1 g2"))
k = sympy.Symbol("k")
section.up_to_scale(
    "1.6/control-point#g",
    "the vanishing line fixes the parameters but for a common factor",
    printed=vector(g_given[0], g_given[0] + g_given[1], g_given[0] + g_given[2]),
    derived=solve(*linear_system(list(k * g - g_given), factors)),
    note="Favourable reading of the sentence of 1.6/control-point, with basic points that correspond: mu0, mu1, mu2 "
    "solved from k g = given line; the projection of one more point is a check.",
)

# %% [markdown]
# Without basic points, let the axes of $E$ be $V$ and the principal normal, the line at right angles to $V$ that meets
# the optical axis (see below), and those of $E'$ be $V'$ and the principal normal there.  Turn the system about the
# axis until $V$ is parallel to $\xi_1$: with $(0, p_2, p_3)$ for the direction of the principal normal, $E$ has the
# points $(x, v + y\, p_2, -f + y\, p_3)$.  Their images are $(x', v' + y' q_2, f + y' q_3)$ with $x' = k x/y$ and
# $y' = c/y$; one control point fixes $k$ and $c$.

# %%
x, y, v, p2, p3 = sympy.symbols("x y v p2 p3")
x4, y4, c = sympy.symbols("x4 y4 c")


def image_in_axes(abscissa: sympy.Expr, ordinate: sympy.Expr) -> Matrix:
    return imaged(vector(abscissa, v + ordinate * p2, -f + ordinate * p3))


foot, slope = vector(0, over(f * p2, p3), f), vector(0, v, -f)
control = image_in_axes(x4, y4)
control_x, control_y = control[0], over(control[2] - foot[2], slope[2])
section.identity(
    "1.6/control-point#normals",
    "vanishing lines and principal normals coincide: one control point fixes the projection of all",
    printed=foot + vector(k * x / y, 0, 0) + c / y * slope,
    where={k: over(control_x * y4, x4), c: control_y * y4},
    derived=image_in_axes(x, y),
    note="Favourable reading of the sentence of 1.6/control-point, together with the end of the section, where the "
    "principal normals are brought to coincidence as well.  k and c come from the coordinates of one control point and "
    "its image.",
)

# %% [markdown]
# If $E$ is displaced along $V$ by $\delta$, and $E'$ along $V'$ so that the control point keeps its image, the
# vanishing lines still coincide; but points of other ordinates $y$ move.

# %%
delta = sympy.Symbol("delta")
displacement = image_in_axes(x4 + delta, y4)[0] - control_x
displaced = image_in_axes(x + delta, y)[0] - displacement
section.identity(
    "1.6/control-point",
    "where the vanishing lines coincide, one control point ensures the projection of all",
    printed=displaced,
    derived=image_in_axes(x, y)[0],
    expect="false",
    instead="1.6/beyond/control-point",
    note="Planes that are displaced along their vanishing lines meet what the sentence asks: the vanishing lines "
    "coincide, E and E' intersect in the principal plane, and the control point has its image.  Favourable readings: "
    "1.6/control-point#g with basic points that correspond, 1.6/control-point#normals with principal normals that "
    "coincide.",
)
section.vanishing(
    "1.6/beyond/control-point",
    "after a displacement along the vanishing lines, one control point vouches for its own ordinate alone",
    printed=(f, delta, y - y4),
    derived=displaced - image_in_axes(x, y)[0],
    note="Not in the paper: how far a point is displaced that should not be; f = 0 is no lens.",
)

# %% [markdown]
# ## Parallels through the origins
#
# The line through $G_0$ that meets $\mathbf g$ at infinity joins the origin, $(1, 0, 0)$, with the direction
# $(0, -g_2, g_1)$.


# %%
def parallel_through_origin(line: Matrix) -> Matrix:
    return cross(vector(1, 0, 0), vector(0, -line[2], line[1]))


g_origin_printed, g_image_origin_printed = (
    vector(0, mu1 - mu0, mu2 - mu0),
    vector(0, 1 / mu1 - 1 / mu0, 1 / mu2 - 1 / mu0),
)
g_origin, g_image_origin = parallel_through_origin(g), parallel_through_origin(g_image)
section.up_to_scale("1.6.6", "parallel to g through the origin", printed=g_origin_printed, derived=g_origin)
section.up_to_scale(
    "1.6.6#image",
    "parallel to g' through the origin of the image",
    printed=g_image_origin_printed,
    derived=g_image_origin,
)
section.up_to_scale(
    "1.6/g0'",
    "the two parallels correspond",
    printed=M_printed.T * g_origin_printed,
    derived=g_image_origin,
    note="With the coefficients as printed in (1.6.6), M^T g0 is -mu0 times g0': equal as homogeneous coordinates.",
)
section.identity(
    "1.6/beyond/g0'",
    "the factor between the two sides",
    printed=-mu0 * g_image_origin_printed,
    derived=M.T * g_origin_printed,
    note="Not in the paper: M^T g0 = -mu0 g0' with the coefficients of (1.6.6).",
)

# %% [markdown]
# ## Principal normals
#
# The plane through the optical axis at right angles to $S$ has the direction of $S$ for its normal; it cuts $E$ and
# $E'$ in the principal normals $\mathbf h_p$ and $\mathbf h'_p$.  Such a plane is its own image.

# %%
S_direction, h_direction = directions(normal)
h_image_direction = directions(image_normal)[1]
meridian = vector(0, *S_direction)
section.up_to_scale(
    "1.6/beyond/meridian",
    "the plane of the principal normals is its own image",
    printed=meridian,
    derived=inverse(M_f).T * meridian,
    note="Not in the paper: why the two principal normals correspond.",
)
h_p = in_affine_coordinates(vector(*meridian[:3, 0]).xreplace(E_through), basic_points, u)
h_p_image = in_affine_coordinates(vector(*meridian[:3, 0]).xreplace(E_through), image_basic_points, u_prime)
section.up_to_scale(
    "1.6/h_p'",
    "the principal normals correspond",
    printed=M_printed.T * h_p,
    where=mu_of_lens,
    derived=h_p_image,
    note="In affine coordinates of E and E', with mu_j = f + xi3(G_j).",
)

# %% [markdown]
# The principal normals are at right angles to the vanishing lines and to $S$, and therefore to the parallels of
# (1.6.6).


# %%
def line_direction(line: Matrix) -> Matrix:
    """Return the direction of a line at constant distance from the principal plane."""
    return vector(line[2], -line[1], 0)


section.identity(
    "1.6/h_p#right-angles",
    "the principal normals are at right angles to S, V and V'",
    printed=Matrix.zeros(4, 1),
    derived=vector(
        dot(h_direction, line_direction(S_line)),
        dot(h_direction, line_direction(V_line)),
        dot(h_image_direction, line_direction(S_image_line)),
        dot(h_image_direction, line_direction(V_image_line)),
    ),
)


def affine_direction(line: Matrix, points: list[Matrix]) -> Matrix:
    """Return the direction in space of a line given in affine coordinates."""
    return line[2] * (points[1] - points[0]) - line[1] * (points[2] - points[0])


section.identity(
    "1.6/natural-axes",
    "principal normals and parallels form right angles",
    printed=vector(0, 0),
    derived=vector(
        dot(h_direction.xreplace(E_through), affine_direction(g_origin.xreplace(mu_of_lens), basic_points)),
        dot(
            h_image_direction.xreplace(E_through),
            affine_direction(g_image_origin.xreplace(mu_of_lens), image_basic_points),
        ),
    ),
)

# %% [markdown]
# Of all directions $\mathbf h + t\, \mathbf s$ of a plane, $\mathbf s$ the direction of $S$, the principal normal
# $t = 0$ is inclined most to $H$: the squared sine of the inclination is stationary there and nowhere else, and goes to
# zero for large $t$.

# %%
for name, plane_normal in (("E", normal), ("E'", image_normal)):
    along_s, steepest = directions(plane_normal)
    inclined = steepest + t * along_s
    squared = dot(inclined, inclined)
    section.vanishing(
        f"1.6/maximum-inclination#{name}",
        f"the principal normal is the line of maximum inclination of {name}",
        printed=(t,),
        derived=over(-(inclined[2] ** 2) * diff(squared, t), squared**2),
        note="The derivative of the squared sine with respect to t.",
    )

# %% [markdown]
# ## Code

# %%
with_f = {"arguments": {"f": f}, "describe": {"f": "Focal length; in the unit of the coordinates."}}
EXAMPLE_F = {"f": "0.15"}
magnification = sympy.Symbol("magnification")
x3 = sympy.Symbol("x3")
AXES = "with the optical axis as third axis and the center of the lens as origin; in any unit of length."

section.kernel(
    "optics.lens_matrix",
    "Projective matrix M_f of an ideal lens.",
    **with_f,
    derived=M_f,
    claims=["1.6/M_f"],
    example=EXAMPLE_F,
)
section.kernel(
    "optics.image_point",
    "Image point of an ideal lens.",
    arguments={**with_f["arguments"], "x": xi},
    describe={**with_f["describe"], "x": f"Object point (xi1, xi2, xi3), {AXES}"},
    derived=image,
    form=magnification * xi,
    where={magnification: f / (f + xi3)},
    claims=["1.6.1", "1.6.1#scalar"],
    example={**EXAMPLE_F, "x": ("0.4", "-0.25", "-1.2")},
)
section.kernel(
    "optics.object_point",
    "Object point that an ideal lens maps to a given image point.",
    arguments={**with_f["arguments"], "x": xi_prime},
    describe={**with_f["describe"], "x": f"Image point (xip1, xip2, xip3), {AXES}"},
    derived=object_point,
    form=magnification * xi_prime,
    where={magnification: f / (f - xip3)},
    claims=["1.6.2", "1.6.2#scalar"],
    example={**EXAMPLE_F, "x": ("-0.06", "0.0375", "0.175")},
)
section.kernel(
    "optics.scale",
    "Image scale of an ideal lens.",
    arguments={**with_f["arguments"], "x3": x3},
    describe={**with_f["describe"], "x3": f"Third coordinate xi3 of the object point, {AXES}"},
    derived=scale.subs(xi3, x3),
    form=f / (f + x3),
    claims=["1.6/scale"],
    example={**EXAMPLE_F, "x3": "-1.2"},
)
with_mu = {
    "arguments": {"mu": vector(*factors)},
    "describe": {"mu": "Projective parameters (mu0, mu1, mu2), up to a common factor; dimensionless."},
}
EXAMPLE_MU = {"mu": ("1", "0.75", "1.25")}
section.kernel(
    "optics.plane_homography",
    "Matrix M* of the optical projection from plane to plane, in affine coordinates.",
    **with_mu,
    derived=M_star,
    claims=["1.6/M*", "1.6.5"],
    example=EXAMPLE_MU,
)
weighted = sympy.Symbol("weighted")
section.kernel(
    "optics.map_plane_points",
    "Affine coordinates of the optical projection of points of a plane.",
    arguments={**with_mu["arguments"], "u": u},
    describe={**with_mu["describe"], "u": "Point (u1, u2) in affine coordinates of the plane; dimensionless."},
    derived=mapped_u,
    form=vector(mu1 * u1 / weighted, mu2 * u2 / weighted),
    where={weighted: mu0 * (1 - u1 - u2) + mu1 * u1 + mu2 * u2},
    claims=["1.6/M*", "1.6.5", "1.6.5#lens"],
    example={**EXAMPLE_MU, "u": ("0.5", "0.25")},
)
section.kernel(
    "optics.vanishing_line",
    "Vanishing line g of the plane E, in affine coordinates.",
    **with_mu,
    derived=g,
    claims=["1.6/g", "1.6/g#V"],
    example=EXAMPLE_MU,
)

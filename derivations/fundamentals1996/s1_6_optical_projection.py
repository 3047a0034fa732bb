# %% [markdown]
# # 1.6 Optical projection
#
# An ideal lens maps space to space, and does so projectively.  Which planes does it make sharp, and how must they be
# placed to rectify an image?
#
# The axes $\xi_1, \xi_2$ span the principal plane $H$ of the lens, $\xi_3$ is the optical axis, $f$ the focal length.
# Primes denote the image space.

# %%
import sympy

from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.inserting import given
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


# %%
def coefficients(form: sympy.Expr, coordinates: Matrix) -> Matrix:
    """Return the coefficients (constant first) of an equation, form = 0, of a plane or a line."""
    linear, right_side = linear_system([form], tuple(coordinates))
    return vector(-right_side[0], *linear)


# %% [markdown]
# ## The lens
#
# **Definition.**  Two rays leave a point $\boldsymbol\xi$ of object space.  The one parallel to the axis meets $H$ in
# $(\xi_1, \xi_2, 0)$ and goes on through the focal point $(0, 0, f)$.  The one through the center of the lens goes
# straight on.  They meet in the image point: $(1 - t)\, \xi_i = s\, \xi_i$ for $i = 1, 2$ and $t f = s\, \xi_3$.

# %%
f, s, t = sympy.symbols("f s t")
xi1, xi2, xi3 = sympy.symbols("xi1 xi2 xi3")
xi = vector(xi1, xi2, xi3)

forward_matrix, forward_right_side = linear_system([s + t - 1, t * f - s * xi3], [s, t])
scale = solve(forward_matrix, forward_right_side)[0]
image = vector(*(scale * component for component in xi))
image

# %% [markdown]
# **Backwards.**  The ray parallel to the axis in image space came through the focal point $(0, 0, -f)$ of object
# space.  So $(1 + t)\, \xi'_i = s\, \xi'_i$ and $t f = s\, \xi'_3$.

# %%
xip1, xip2, xip3 = sympy.symbols("xip1 xip2 xip3")
xi_prime = vector(xip1, xip2, xip3)

backward_matrix, backward_right_side = linear_system([s - t - 1, t * f - s * xip3], [s, t])
backward_scale = solve(backward_matrix, backward_right_side)[0]
object_point = vector(*(backward_scale * component for component in xi_prime))

# %% [markdown]
# **The matrix of a lens.**  The quasihomogeneous image, multiplied by the divisor $\tau = f + \xi_3$, is linear in
# $\boldsymbol\xi$.  Its coefficients are the matrix $\mathbf M_f$:

# %%
tau_of_xi = determinant(forward_matrix)
tau_of_image = determinant(backward_matrix)
image_vector = divided(tau_of_xi * homogeneous(image))
object_vector = divided(tau_of_image * homogeneous(object_point))
M_f = rows(*(coefficients(component, xi) for component in image_vector))
M_f

# %%
section.identity("1.6/M_f", "projective matrix of the lens", derived=M_f)
section.identity("1.6/M_f#inverse", "its inverse", derived=inverse(M_f))
section.up_to_scale(
    "1.6/M_f#backward",
    "the inverse maps backwards",
    derived=rows(*(coefficients(component, xi_prime) for component in object_vector)),
)

# %% [markdown]
# ## Points
#
# From object to image, by matrix and by coordinates.  Gauss' law for the distances comes with it.  In these coordinates
# an object in front of the lens has a negative $\xi_3$.

# %%
tau = sympy.Symbol("tau")
section.identity("1.6.1", "from object to image", derived=tau_of_xi * homogeneous(image))
section.identity("1.6.1#scalar", "image coordinates", derived=image)
section.identity("1.6.1#gauss", "Gauss' law", derived=over(1, image[2]) - over(1, xi3))

# %% [markdown]
# From image to object.  $\tau$ is the same number, $f + \xi_3$.

# %%
section.identity("1.6.2", "from image to object", where={tau: f + object_point[2]}, derived=homogeneous(object_point))
section.identity("1.6.2#scalar", "object coordinates", derived=object_point)
section.identity("1.6.2#gauss", "Gauss' law, backwards", derived=over(1, object_point[2]) - over(1, xip3))

# %% [markdown]
# **How large is the image?**  Its scale is the same for all three coordinates.  The paper has it by the distance of the
# object, and by that of the image.  That the two agree is Gauss' law again.

# %%
section.identity(
    "1.6/scale",
    "image scale, from the distance of the object",
    derived=vector(*(over(image[i], xi[i]) for i in range(3))),
)
section.identity(
    "1.6/scale#image",
    "image scale, from the distance of the image",
    where={xip3: image[2]},
    derived=vector(*(over(image[i], xi[i]) for i in range(3))),
)
section.identity(
    "1.6/scale#gauss",
    "that the two forms of the scale are equal is Gauss' law",
    derived=over(1, xip3) - over(1, xi3),
    constraints=[f**2 - (f + xi3) * (f - xip3)],
)

# %% [markdown]
# ## Planes
#
# **Definition.**  A plane $E$ with the coefficients $\mathbf a$ is mapped to a plane $E'$.  Its equation holds for the
# object points that belong to $\boldsymbol\xi'$.

# %%
a = vector(*sympy.symbols("a:4"))
a_image = inverse(M_f).T * a
E_form = dot(a, homogeneous(xi))
E_image_form = dot(a, object_vector)

section.identity("1.6/a'", "coefficients of the image plane, by (1.5.7)", derived=a_image)
E_image_printed = f * a[0] + f * a[1] * xip1 + f * a[2] * xip2 + (f * a[3] - a[0]) * xip3
section.up_to_scale("1.6/E'", "equation of the image plane", derived=coefficients(E_image_form, xi_prime))

# %% [markdown]
# **Print.**  The equation of $E$ itself and the sentence around it are lost in the scan.  What survives fixes it: $E$
# is the plane whose image satisfies the surviving equation of $E'$.

# %%
pulled_back = dot(coefficients(E_image_printed, xi_prime), image_vector)
section.up_to_scale(
    "1.6/plane-E",
    "equation of the object plane",
    printed=None,
    derived=coefficients(pulled_back, xi),
    expect="illegible",
    corrected=a,
    note="The scan has a gap between the scale m' and the coefficients of E'.  Reconstructed is E: a0 + a1 xi1 + a2 "
    "xi2 + a3 xi3 = 0; the equations of S and V presuppose it.",
)

# %% [markdown]
# ## The Scheimpflug line
#
# Where do $E$ and $E'$ meet?  In a line $S$ of the principal plane, for the points of $H$ are their own images.

# %%
in_plane, in_image_plane = vector(xi1, xi2), vector(xip1, xip2)
S_line = coefficients(E_form.subs(xi3, 0), in_plane)
S_image_line = coefficients(E_image_form.subs(xip3, 0), in_image_plane)

section.up_to_scale("1.6/S", "line of E in the principal plane", derived=S_line)
section.up_to_scale("1.6/S'", "line of E' in the principal plane", derived=S_image_line)

# %%
section.up_to_scale("1.6/S#identical", "the two lines are identical", printed=S_line, derived=S_image_line)
section.identity(
    "1.6/beyond/principal-plane",
    "the points of the principal plane are their own images",
    printed=vector(xi1, xi2, 0),
    derived=image.subs(xi3, 0),
)

# %% [markdown]
# **Meaning.**  Object plane, image plane and principal plane meet in one line: the minors of their three rows of
# coefficients vanish.  A plane through the center of the lens, $a_0 = 0$, is its own image.

# %%
principal_plane = vector(0, 0, 0, 1)
pencil = rows(a, a_image, principal_plane)
section.identity(
    "1.6/scheimpflug",
    "object plane, image plane and principal plane meet in one line",
    printed=Matrix.zeros(4, 1),
    derived=vector(*(determinant(columns(*(pencil.col(j) for j in range(4) if j != omitted))) for omitted in range(4))),
)

# %% [markdown]
# **An example.**  For $f = 1$ the point $A$ of a plane $E$ is imaged to

# %%
A, S1, S2 = vector(sympy.Rational(1, 2), 0, -3), vector(2, -1, 0), vector(2, 1, 0)
A_image = image.xreplace({f: sympy.Integer(1), **given(xi, A)}).doit()
A_image

# %%
SpaceDrawing(
    "A plane E through A, and its image E' through A', meet in the line S1 S2 of the principal plane.  Two rays lead "
    "from A to A': one through the center C of the lens, one parallel to the axis to K and on.",
    {"C": vector(0, 0, 0), "A": A, "K": vector(A[0], A[1], 0), "A'": A_image, "S1": S1, "S2": S2},
    segments=[("A", "A'"), ("A", "K"), ("K", "A'")],
    triangles=[("S1", "S2", "A"), ("S1", "S2", "A'"), ("S1", "S2", "C")],
    axes=(r"\xi_1", r"\xi_2", r"\xi_3"),
)

# %% [markdown]
# ## The vanishing lines
#
# **Definition.**  $V$ is the line of $E$ whose image is at infinity, where $\xi_3 = -f$.  $V'$, the horizon, is the
# image of the line at infinity, where $\xi'_3 = f$.

# %%
V_line = coefficients(E_form.subs(xi3, -f), in_plane)
V_image_line = coefficients(E_image_form.subs(xip3, f), in_image_plane)
section.up_to_scale("1.6.3", "vanishing line in E", derived=V_line)
section.up_to_scale("1.6.4", "vanishing line in E', the horizon", derived=V_image_line)

# %% [markdown]
# **Are these the images of the lines at infinity?**  The points at infinity of a plane are its directions.  One is
# that of $S$, at right angles to the axis and to the normal of the plane; another is at right angles to $S$.  The
# line through the images of these two points lies at a constant distance from $H$, so that $\xi_1, \xi_2$ suffice for
# it.


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

# %% [markdown]
# Both vanishing lines are parallel to $S$.


# %%
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
# **Definition.**  With basic points in $E$ and their images in $E'$ the regular transformation of section 1.5 has its
# counterpart in the plane: $\mu_j \mathbf e'_j = \mathbf M^* \mathbf e_j$ for three unit points.

# %%
factors = (mu0, mu1, mu2)
units = columns(image_e0, image_e1, image_e2)
M_star = columns(*(factor * units.col(j) for j, factor in enumerate(factors))) * inverse(units)
M = inverse(M_star)

M_printed = Matrix([[1 / mu0, 1 / mu1 - 1 / mu0, 1 / mu2 - 1 / mu0], [0, 1 / mu1, 0], [0, 0, 1 / mu2]])
section.identity("1.6/M*", "matrix from E to E'", derived=M_star)
section.identity("1.6/M", "matrix from E' to E", derived=M)

# %% [markdown]
# **What are the factors of a lens?**  A point of $E$ with the affine coordinates $u_1, u_2$ is
# $G_0 + u_1 (G_1 - G_0) + u_2 (G_2 - G_0)$.  The first component of $\mathbf M_f \mathbf z$ at a basic point is
# $\mu_j = f + \xi_3(G_j)$.  With these factors the image of the point has the transformed coordinates.

# %%
u = vector(u1, u2)
basic_points = [vector(*sympy.symbols(f"g{j}1 g{j}2 g{j}3")) for j in range(3)]


def affine_point(points: list[Matrix], coordinates: Matrix) -> Matrix:
    return points[0] + coordinates[0] * (points[1] - points[0]) + coordinates[1] * (points[2] - points[0])


def imaged(point: Matrix) -> Matrix:
    return image.xreplace(given(xi, point))


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
)

# %% [markdown]
# Conversely the lens determines $\mathbf u'$.  Its image point is a combination of the three image points $G'_j$, as
# vectors, with weights that add up to 1.

# %%
up1, up2, mu_symbol = sympy.symbols("up1 up2 mu")
weights = solve(columns(*image_basic_points), imaged(E_point))
section.up_to_scale(
    "1.6.5", "affine coordinates from E to E'", where=mu_of_lens, derived=vector(sum(weights), weights[1], weights[2])
)
section.identity(
    "1.6.5#backward",
    "affine coordinates from E' to E",
    where={mu_symbol: mapped[0], up1: mapped_u[0], up2: mapped_u[1]},
    derived=homogeneous(u),
)

# %% [markdown]
# ## The vanishing lines in affine coordinates
#
# **Definition.**  A point is mapped to infinity where the first component vanishes.  In terms of lines this is the
# line at infinity, $(1, 0, 0)$, of the other plane, carried over as in (1.5.6) and (1.5.7).

# %%
at_infinity = vector(1, 0, 0)
g = M_star.T * at_infinity
g_image = M.T * at_infinity

section.identity("1.6/g", "line of E with its image at infinity", derived=g)
section.identity("1.6/g'", "image of the line at infinity of E", derived=g_image)

# %% [markdown]
# **Do they coincide with $V$ and $V'$?**  The plane $E$ passes through the basic points.  (1.6.3), taken at a point
# of $E$, is a linear form in $u_1, u_2$: the form $f + \xi_3$ of the point.


# %%
def plane_through(points: list[Matrix]) -> Matrix:
    normal = cross(points[1] - points[0], points[2] - points[0])
    return vector(-dot(normal, points[0]), *normal)


def in_affine_coordinates(line: Matrix, points: list[Matrix], coordinates: Matrix) -> Matrix:
    """Return the coefficients of a line, given in the first two coordinates of space, in affine coordinates."""
    return coefficients(dot(line, homogeneous(vector(*affine_point(points, coordinates)[:2, 0]))), coordinates)


E_through = given(a, plane_through(basic_points))
section.up_to_scale(
    "1.6/g#V",
    "g coincides with the vanishing line in E",
    printed=g,
    where=mu_of_lens,
    derived=in_affine_coordinates(V_line.xreplace(E_through), basic_points, u),
)

# %% [markdown]
# On the side of the image the points $G'_j$ are given.  The basic points are their preimages, with the same $\mu_j$,
# and the coefficients of $E$ follow from those of $E'$ by (1.5.6).

# %%
u_prime = vector(up1, up2)
given_images = [vector(*sympy.symbols(f"gp{j}1 gp{j}2 gp{j}3")) for j in range(3)]
preimages = [object_point.xreplace(given(xi_prime, point)) for point in given_images]
mu_of_images = {factor: f + point[2] for factor, point in zip(factors, preimages, strict=True)}
E_of_images = given(a, M_f.T * plane_through(given_images))
section.up_to_scale(
    "1.6/g'#V'",
    "g' coincides with the horizon in E'",
    printed=g_image,
    where=mu_of_images,
    derived=in_affine_coordinates(V_image_line.xreplace(E_of_images), given_images, u_prime),
)

# %% [markdown]
# ## Is one control point enough?
#
# **The paper's answer.**  Where the vanishing lines coincide, one control point ensures the projection of all others.
# That depends on what else is known.
#
# *If basic points correspond*, the line $\mathbf g$ alone fixes the parameters but for a common factor.  One more
# point is a check.

# %%
g_given = vector(*sympy.symbols("g0 g1 g2"))
k = sympy.Symbol("k")
section.up_to_scale(
    "1.6/control-point#g",
    "the vanishing line fixes the parameters but for a common factor",
    printed=vector(g_given[0], g_given[0] + g_given[1], g_given[0] + g_given[2]),
    derived=solve(*linear_system(list(k * g - g_given), factors)),
    note="Favourable reading of the sentence of 1.6/control-point, with basic points that correspond.",
)

# %% [markdown]
# *If principal normals correspond*, one control point is enough.  Let the axes of $E$ be $V$ and the principal
# normal, the line at right angles to $V$ that meets the optical axis (see below), and those of $E'$ be $V'$ and the
# principal normal there.  Turn the system about the axis until $V$ is parallel to $\xi_1$.  With $(0, p_2, p_3)$ for
# the direction of the principal normal, $E$ has the points $(x, v + y\, p_2, -f + y\, p_3)$.  Their images are $(x',
# v' + y' q_2, f + y' q_3)$ with $x' = k x/y$ and $y' = c/y$.  One control point and its image fix $k$ and $c$.

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
    "principal normals are brought to coincidence as well.",
)

# %% [markdown]
# *If nothing else is known*, it is not enough.  Displace $E$ along $V$ by $\delta$, and $E'$ along $V'$ so that the
# control point keeps its image.  The vanishing lines still coincide, and the planes still meet in $H$.  But points of
# other ordinates $y$ move: one control point vouches for its own ordinate alone.

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
    note="Favourable readings: 1.6/control-point#g with basic points that correspond, 1.6/control-point#normals with "
    "principal normals that coincide.",
)
section.vanishing(
    "1.6/beyond/control-point",
    "after a displacement along the vanishing lines, one control point vouches for its own ordinate alone",
    printed=(f, delta, y - y4),
    derived=displaced - image_in_axes(x, y)[0],
)

# %% [markdown]
# ## Parallels through the origins
#
# **Definition.**  The line through $G_0$ that meets $\mathbf g$ at infinity joins the origin, $(1, 0, 0)$, with the
# direction $(0, -g_2, g_1)$.


# %%
def parallel_through_origin(line: Matrix) -> Matrix:
    return cross(vector(1, 0, 0), vector(0, -line[2], line[1]))


g_origin_printed, g_image_origin_printed = (
    vector(0, mu1 - mu0, mu2 - mu0),
    vector(0, 1 / mu1 - 1 / mu0, 1 / mu2 - 1 / mu0),
)
g_origin, g_image_origin = parallel_through_origin(g), parallel_through_origin(g_image)
section.up_to_scale("1.6.6", "parallel to g through the origin", derived=g_origin)
section.up_to_scale("1.6.6#image", "parallel to g' through the origin of the image", derived=g_image_origin)

# %% [markdown]
# **Do the two parallels correspond?**  Yes.  With the coefficients as printed, $\mathbf M^T \mathbf g_0 = -\mu_0
# \mathbf g'_0$.

# %%
section.up_to_scale("1.6/g0'", "the two parallels correspond", derived=g_image_origin)
section.identity(
    "1.6/beyond/g0'",
    "the factor between the two sides",
    printed=-mu0 * g_image_origin_printed,
    derived=M.T * g_origin_printed,
)

# %% [markdown]
# ## Principal normals
#
# **Definition.**  The plane through the optical axis at right angles to $S$ cuts $E$ and $E'$ in the principal normals
# $\mathbf h_p$ and $\mathbf h'_p$.  It is its own image.  So the principal normals correspond.

# %%
S_direction, h_direction = directions(normal)
h_image_direction = directions(image_normal)[1]
meridian = vector(0, *S_direction)
section.up_to_scale(
    "1.6/beyond/meridian",
    "the plane of the principal normals is its own image",
    printed=meridian,
    derived=inverse(M_f).T * meridian,
)
h_p = in_affine_coordinates(vector(*meridian[:3, 0]).xreplace(E_through), basic_points, u)
h_p_image = in_affine_coordinates(vector(*meridian[:3, 0]).xreplace(E_through), image_basic_points, u_prime)
section.up_to_scale(
    "1.6/h_p'",
    "the principal normals correspond",
    printed=M_printed.T * h_p,
    where=mu_of_lens,
    derived=h_p_image,
)

# %% [markdown]
# **Meaning.**  The principal normals are at right angles to the vanishing lines and to $S$, and therefore to the
# parallels of (1.6.6): natural axes of both planes.


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
# They are also the lines of maximum inclination.  Of all directions $\mathbf h + t\, \mathbf s$ of a plane, $\mathbf
# s$ the direction of $S$, the principal normal $t = 0$ is inclined most to $H$.  The squared sine of the inclination
# is stationary there and nowhere else, as its derivative shows, and goes to zero for large $t$.

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
    )

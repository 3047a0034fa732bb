# %% [markdown]
# # 3.2 The normal case
#
# Two images form a normal case if their planes coincide and are parallel to the base.  What does this mean for the
# correlation, for the projective parameters and for the images of $G_3$?  One prime denotes the left image, two the
# right one.

# %%
import sympy

from algebroproj_derivations.cameras import skew
from algebroproj_derivations.figures import ImageDrawing
from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s1_1_projection import ratios, usual_parameters, usual_projection
from algebroproj_derivations.fundamentals1996.s1_3_properties_of_projection import (
    P,
    P_star,
    center_equations,
    mu_of_y0,
    point,
    u_of_y,
    y0_of_mu,
)
from algebroproj_derivations.fundamentals1996.s2_1_spatial_intersection import correlation_matrix
from algebroproj_derivations.fundamentals1996.s2_2_correlation import (
    C_of_cameras,
    Z,
    differences,
    q2,
    reduced,
    remaining,
)
from algebroproj_derivations.fundamentals1996.s2_4_relative_orientation import mu_left as orientation_left
from algebroproj_derivations.fundamentals1996.s2_4_relative_orientation import mu_right as orientation_right
from algebroproj_derivations.fundamentals1996.s3_1_normal_case_transformation import (
    FOURTH,
    tau_of_fourth_points,
    un30,
    un31,
    un32,
)
from algebroproj_derivations.inserting import given
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    adjugate,
    columns,
    cross,
    diff,
    dot,
    homogeneous,
    linear_system,
    over,
    solve,
    vector,
)

section = Section("fundamentals1996", "3.2", "The normal case")

# %% [markdown]
# ## The correlation matrix
#
# **Definition.**  In the coordinates of the basic points $\mathbf Z$ has five elements (2.2.3).  It gives the epipolar
# lines $\mathbf h' = \mathbf Z \mathbf u''$ and $\mathbf h'' = \mathbf Z^T \mathbf u'$.

# %%
z_n = sympy.Symbol("z_n")
z11, z12, z20, z21, z22 = remaining

u_left = vector(*sympy.symbols("upN1 upN2"))
u_right = vector(*sympy.symbols("uppN1 uppN2"))
h_left = Z * homogeneous(u_right)
h_right = Z.T * homogeneous(u_left)

section.definition(
    "3.2/line",
    "equation of an epipolar line",
)

# %% [markdown]
# **When are all lines of an image parallel?**  The paper asks that $b_1$ and $b_2$ do not depend on the point of the
# other image.  Their derivatives by that point are the four elements $z_{11}, z_{12}, z_{21}, z_{22}$, which must
# vanish.


# %%
def jacobian(form: Matrix, variables: Matrix) -> Matrix:
    return Matrix(len(form), len(variables), lambda i, j: diff(form[i], variables[j]))


section.identity(
    "3.2/constant",
    "the coefficients are constant if and only if four elements are zero",
    printed=columns(Matrix([[z11, z12], [z21, z22]]), Matrix([[z11, z21], [z12, z22]])),
    derived=columns(
        jacobian(vector(*h_left[1:, 0]), u_right),
        jacobian(vector(*h_right[1:, 0]), u_left),
    ),
)

# %% [markdown]
# **Print.**  One element is left of the five.

# %%
FOUR_ZEROS = dict.fromkeys((z11, z12, z21, z22), 0)
Z_N = Z.subs(FOUR_ZEROS).subs(z20, z_n)
Z_N

# %%
section.identity("3.2.1", "correlation matrix of the normal case", derived=Z_N)
section.identity("3.2.1#skewsymmetric", "it is skewsymmetric", derived=Z_N)

# %% [markdown]
# **Is that not too much?**  Constant coefficients are more than parallel lines.  Both epipoles, $(0, -z_{20}, 1)$ and
# $(0, -z_{12}, z_{11})$, are at infinity also for the following matrices, one for every $z_{12}$ and $z_{20}$: image
# planes that are parallel to the base, but do not coincide.  The paper asks for parallel *and identic* lines, and needs
# both words.

# %%
z11_of_z12 = over(z12, z20 + z20 * z12 - z12)
parallel_planes = Z.subs({z21: z20 * z11, z22: z20 * z12}).xreplace({z11: z11_of_z12})
parallel_planes

# %%
section.identity(
    "3.2/beyond/parallel",
    "epipoles at infinity do not make the four elements zero",
    printed=Matrix.zeros(3, 2),
    derived=columns(parallel_planes.T * vector(0, -z20, 1), parallel_planes * vector(0, -z12, z11_of_z12)),
)

# %% [markdown]
# ## Epipolar lines
#
# **Print.**  Of the right line the first term has the wrong sign.

# %%
section.identity("3.2.2#left", "epipolar line in the left image", derived=Z_N * homogeneous(u_right))
section.identity(
    "3.2.2#right",
    "epipolar line in the right image",
    derived=Z_N.T * homogeneous(u_left),
    expect="misprint",
    corrected=vector(u_left[0] + z_n * u_left[1], -1, -z_n),
    note="As a homogeneous vector it is not right either, for the other two components have the sign of Z_N^T u', and "
    "(3.2.3) needs the plus.  A slip of the scan cannot be told from one of the print.",
)

# %% [markdown]
# **Meaning.**  Homologous points have the same value of $u_1 + z_N u_2$.  All lines of both images have one
# direction, and one pair of points gives it.

# %%
coplanarity = dot(homogeneous(u_left), Z_N * homogeneous(u_right))
section.identity("3.2.3", "epipolar lines of both images", derived=coplanarity)
section.identity("3.2/zN", "the factor from one pair of points", derived=solve(*linear_system([coplanarity], [z_n]))[0])

# %% [markdown]
# **An example.**  For $z_N = 1/4$ homologous points lie on these lines.

# %%
QUARTER = sympy.Rational(1, 4)
SEEN = {"P1": vector(0, QUARTER), "P2": vector(QUARTER, 3 * QUARTER), "P3": vector(1, -QUARTER)}
PARTNERS = {
    "P1": vector(-2 * QUARTER**2, 3 * QUARTER),
    "P2": vector(QUARTER**2, 6 * QUARTER),
    "P3": vector(1 - QUARTER, 3 * QUARTER),
}
of_seen = [Z_N.xreplace({z_n: QUARTER}).T * homogeneous(seen) for seen in SEEN.values()]
ImageDrawing(
    "Three points of the left image and their partners of the right image in a normal case: the lines are the same in "
    "both images.",
    {title: ({"G0": vector(0, 0), **points}, of_seen) for title, points in (("left", SEEN), ("right", PARTNERS))},
)

# %% [markdown]
# ## Epipoles at infinity
#
# **Definition.**  A point $\mathbf y_A$ of the epipolar axis is projected to the epipole.  When is the epipole at
# infinity?  Where the common denominator of its coordinates vanishes.

# %%
y_a = vector(*sympy.symbols("yA1 yA2 yA3"))
ya0, ya1, ya2, ya3 = sympy.Symbol("yA0"), *y_a
AXIS = {ya0: 1 - sum(y_a)}
AT_AXIS = given(point, y_a)
IN_NORMAL_CASE = {u31: un31, u32: un32}

homogeneous_image = P_star * point + image_e0
epipole = u_of_y.subs(mu0, 1).xreplace(AT_AXIS | IN_NORMAL_CASE)
common_denominator = ya0 + ya1 * mu1 + ya2 * mu2 + ya3 * mu3
section.identity("3.2.4", "projection of a point of the epipolar axis", where=AXIS, derived=epipole)
epipole_weights = homogeneous_image.xreplace(AT_AXIS | IN_NORMAL_CASE)
for name, numerator in (("uN01", epipole_weights[1]), ("uN02", epipole_weights[2])):
    section.vanishing(
        f"3.2.5#{name}",
        f"{name} is infinite where the denominator vanishes",
        where=AXIS,
        derived=over(epipole_weights[0], numerator),
        note="The derived side is 1/u; where the numerator vanishes as well, the coordinate is 0/0.",
    )

# %% [markdown]
# So one of the four parameters is a linear combination of the others, here $\mu_3$; $\mu_0 = 1$ has the coefficient
# $y_{A0}$.

# %%
section.identity(
    "3.2/linear-combination",
    "one of the parameters is a linear combination of the other three",
    printed=-(ya0 + ya1 * mu1 + ya2 * mu2) / ya3,
    where=AXIS,
    derived=solve(*linear_system([epipole_weights[0]], [mu3]))[0],
)

# %% [markdown]
# **Meaning.**  In space the image plane of $\mu$, $\mu_0 = 1$, passes through $G_0$ and has the equation
# $\sum (\mu_j - 1)\, y_j = 0$, which the points $\mathbf y_0 + \mathbf P \mathbf u$ satisfy for every $\mathbf u$.

# %%
plane = vector(mu1 - 1, mu2 - 1, mu3 - 1)
section.identity(
    "3.2/beyond/plane",
    "equation of the image plane in space",
    printed=0,
    derived=dot(plane, y0_of_mu + P * homogeneous(vector(u1, u2))),
)

# %% [markdown]
# Condition (3.2.5) says that the base is parallel to this plane.  For let $\mathbf u'_{N3}$, $\mathbf u''_{N3}$ be the
# images of $G_3$.  The centers follow from the parameters, and $\mathbf y_A = \mathbf y'_0 + t\, (\mathbf y''_0 -
# \mathbf y'_0)$.

# %%
k, t = sympy.symbols("k t")
left_fourth = vector(*sympy.symbols("upN31 upN32"))
right_fourth = vector(*sympy.symbols("uppN31 uppN32"))
LEFT_FOURTH = given(fourth_image, left_fourth)
RIGHT_FOURTH = given(fourth_image, right_fourth)
MU_RIGHT = given(mu, sympy.symbols("mupp1 mupp2 mupp3"))

y0_left = y0_of_mu.xreplace(LEFT_FOURTH)
y0_right = y0_of_mu.xreplace(RIGHT_FOURTH)
general_base = y0_right.xreplace(MU_RIGHT) - y0_left
section.identity(
    "3.2.5#parallel",
    "the condition says that the base is parallel to the image plane",
    printed=common_denominator.xreplace(AXIS),
    where=given(y_a, y0_left + t * general_base),
    derived=t * dot(plane, general_base),
)

# %% [markdown]
# ## Are the parameters of both images equal?
#
# Yes.  Planes that coincide have proportional coefficients, $\mu''_j - 1 = k\, (\mu'_j - 1)$.  If the base is
# parallel to them, $k = 1$.

# %%
coincident = {mu[j]: 1 + k * plane[j] for j in range(3)}
section.vanishing(
    "3.2/equal-mu",
    "the base is parallel to coincident planes exactly where the parameters are equal",
    printed=(k - 1,),
    derived=dot(plane, y0_right.xreplace(coincident) - y0_left),
)

# %% [markdown]
# The paper gives another reason: (3.2.5) holds in both images for the same point.  But one linear equation for each
# image does not make three parameters equal.

# %%
section.identity(
    "3.2/equal-mu#inference",
    "the parameters are equal because (3.2.5) holds in both images for the same point",
    printed=mu1,
    derived=MU_RIGHT[mu1],
    constraints=[common_denominator.xreplace(AXIS), common_denominator.xreplace(AXIS).xreplace(MU_RIGHT)],
    expect="false",
    instead="3.2/equal-mu",
)

# %% [markdown]
# **A check.**  With equal parameters the correlation matrix of (2.1.4) must be $\mathbf Z_N$, but for a factor, with
# $z_N = c_{20}/c_{10}$.

# %%
base = y0_left - y0_right
P_left, P_right = P.xreplace(LEFT_FOURTH), P.xreplace(RIGHT_FOURTH)
C_N = correlation_matrix(P_left, P_right, base)
z_of_pair = over(C_N[2, 0], C_N[1, 0])
section.up_to_scale(
    "3.2.1#mu",
    "images with equal parameters have the correlation matrix of the normal case",
    where={z_n: z_of_pair},
    derived=C_N,
)

# %% [markdown]
# **And conversely?**  Where the four elements of $\mathbf Z$ are zero, the parameters are equal: one after the other,
# the elements vanish with the differences of the parameters only.  The difference $q_2$ of section 2.2 is a factor of
# $c_{10}$, which is not zero by (2.2.1).  So the planes coincide and are parallel to the base.

# %%
mup1, mup2, mup3, mupp1, mupp2, mupp3 = sympy.symbols("mup1 mup2 mup3 mupp1 mupp2 mupp3")
section.vanishing(
    "3.2/equivalent#z11",
    "z11 is zero exactly where the first parameters are equal",
    printed=(mupp1 - mup1, differences[q2]),
    derived=C_of_cameras[1, 1],
)
section.vanishing(
    "3.2/equivalent#z12,z21",
    "z12 and z21 are then zero only where the second parameters are equal",
    printed=(mupp2 - mup2, mup1, differences[q2]),
    derived=(mupp2 * C_of_cameras[1, 2] + mup2 * C_of_cameras[2, 1]).xreplace({mupp1: mup1}),
)
section.vanishing(
    "3.2/equivalent#z12",
    "z12 is then zero exactly where the third parameters are equal",
    printed=(mupp3 - mup3, mup1, mup2),
    derived=C_of_cameras[1, 2].xreplace({mupp1: mup1, mupp2: mup2}),
)

# %% [markdown]
# ## Conditions for the fourth points
#
# Given the centers, which images of $G_3$ make the parameters equal?  The parameters are those of (1.3.5), in both
# images.  Each line is left side less right side; that of $\mu_3$ is multiplied by $-1$.

# %%
y00_left, y00_right = sympy.symbols("yp00 ypp00")
u30_left, u30_right = sympy.symbols("upN30 uppN30")
center_left = vector(*sympy.symbols("yp01 yp02 yp03"))
center_right = vector(*sympy.symbols("ypp01 ypp02 ypp03"))
LEFT = LEFT_FOURTH | given(center, center_left)
RIGHT = RIGHT_FOURTH | given(center, center_right)
BARYCENTRIC_BOTH = {
    y00_left: 1 - sum(center_left),
    y00_right: 1 - sum(center_right),
    u30_left: 1 - sum(left_fourth),
    u30_right: 1 - sum(right_fourth),
}
mu_left, mu_right = mu_of_y0.xreplace(LEFT), mu_of_y0.xreplace(RIGHT)

for j in range(3):
    section.identity(
        f"3.2.6#mu{j + 1}",
        f"equality of the parameters mu{j + 1}",
        where=BARYCENTRIC_BOTH,
        derived=(1, 1, -1)[j] * (mu_left[j] - mu_right[j]),
    )
section.definition("3.2/u'N31", "choice of the first coordinate of the fourth point")

# %% [markdown]
# (3.2.5), multiplied by $u_{N30}$, is linear in the coordinates of the fourth point.  For each image the form, and its
# coefficients as printed: constant, first and second coordinate.


# %%
def condition(axis_point: Matrix, center: Matrix, fourth: Matrix) -> sympy.Expr:
    """Return u_N30 times the left side of (3.2.5), as a sum of terms that are linear in the fourth point."""
    barycentric = 1 - sum(center)
    return (
        (1 - sum(axis_point)) * (1 - sum(fourth))
        + axis_point[0] * fourth[0] * over(barycentric, center[0])
        + axis_point[1] * fourth[1] * over(barycentric, center[1])
        - axis_point[2] * over(barycentric, center[2])
    )


def coefficients(form: sympy.Expr, variables: Matrix) -> Matrix:
    linear, right_side = linear_system([sympy.expand(form)], list(variables))
    return vector(-right_side[0], *linear)


for number, title, center_printed, fourth, parameters in (
    ("3.2.7", "condition for the fourth point, left image", center_left, left_fourth, mu_left),
    (
        "3.2.10#parallel",
        "condition for the fourth point, right image",
        center_right,
        right_fourth,
        mu_right,
    ),
):
    linear_form = condition(y_a, center_printed, fourth)
    section.identity(
        f"{number}-form" if "#" in number else f"{number}#form",
        f"{title}: (3.2.5) with the parameters inserted",
        derived=(1 - sum(fourth)) * (1 - sum(y_a) + dot(y_a, parameters)),
    )
    section.identity(number, title, where=AXIS | BARYCENTRIC_BOTH, derived=coefficients(linear_form, fourth))

# %% [markdown]
# **Meaning.**  This is one linear condition for two coordinates.  With the choice of the first one the plane is
# determined, where the coefficient of the second one is not zero.

# %%
left_condition = sympy.expand(condition(y_a, center_left, left_fourth))
section.rank(
    "3.2/one-coordinate",
    "parallelism to the base defines one coordinate of the fourth point",
    derived=linear_system([left_condition], list(left_fourth))[0],
)
section.rank(
    "3.2/unique-plane",
    "with the first coordinate given the plane is uniquely defined",
    printed=2,
    derived=linear_system([left_condition, left_fourth[0] - u31], list(left_fourth))[0],
)

# %% [markdown]
# **Does the choice of $\mathbf y_A$ matter?**  No.  On the base the conditions are multiples of the one with the other
# center for $\mathbf y_A$.  Only the center of the same image will not do: it makes the condition empty.

# %%
on_axis = center_left + t * (center_right - center_left)
for number, side, scale, other, center_printed, fourth in (
    ("3.2/beyond/any-point", "left", t, center_right, center_left, left_fourth),
    ("3.2/beyond/any-point#right", "right", 1 - t, center_left, center_right, right_fourth),
):
    section.identity(
        number,
        f"every point of the base gives the same condition, {side} image",
        printed=scale * coefficients(condition(other, center_printed, fourth), fourth),
        derived=coefficients(condition(on_axis, center_printed, fourth), fourth),
    )

# %% [markdown]
# **The right image.**  $\mathbf y_0$ and $\mathbf u'_{N31}$ now give $u'_{N32}$, and the parameters of the left image.
# Those of the right image are to be the same.  The last two equations for its center, (1.3.4), give its fourth point.

# %%
common_mu = given(mu, mu_left)
right_equations = [equation.xreplace(common_mu | given(center, center_right)) for equation in center_equations]
fourth_of_right = solve(*linear_system([*right_equations[1:]], [u31, u32]))
fourth_of_right

# %%
section.identity("3.2.8", "fourth point of the right image", derived=fourth_of_right)

# %% [markdown]
# The text refers to (3.3.6) here, the formula for $z_N$ from $\mathbf Z$.  The conditions between the fourth points
# are (3.2.6).

# %%
section.reference(
    "3.2/ref-3.3.6",
    "conditions on which (3.2.8) is based",
    meant="3.2.6",
)

# %% [markdown]
# **Must the parameters of the right image then be equivalent?**  Given any $\mu$, the first equation for the right
# center, (3.2.5) with $\mathbf y''_0$ for $\mathbf y_A$, leaves two coordinates free, and the other two equations are
# (3.2.8).  The parameters of that center and that fourth point, by (1.3.5):

# %%
first_equation, *last_equations = center_equations
on_plane = {y03: solve(*linear_system([first_equation], [y03]))[0]}
fourth_on_plane = solve(*linear_system(last_equations, [u31, u32])).xreplace(on_plane)
section.identity(
    "3.2/mu''",
    "the parameters of the right image are equivalent to those of the left",
    printed=mu,
    derived=mu_of_y0.xreplace(on_plane | given(fourth_image, fourth_on_plane)),
)

# %% [markdown]
# ## The direction of the epipolar lines
#
# What is $z_N$ in terms of the cameras?
#
# **Definition.**  The homogeneous coordinates of the epipole are the denominator and the numerators of (3.2.4), for
# images with equal parameters and $\mathbf y_A$ on the base.


# %%
def epipole_of(axis_point: Matrix, fourth: Matrix) -> Matrix:
    return homogeneous_image.xreplace(given(point, axis_point) | given(fourth_image, fourth))


axis_of_mu = y0_left + t * (y0_right - y0_left)
w_left, w_right = epipole_of(axis_of_mu, left_fourth), epipole_of(axis_of_mu, right_fourth)
ON_AXIS = given(y_a, axis_of_mu)
section.identity("3.2/w0'", "homogeneous coordinates of the epipole", where=ON_AXIS, derived=w_left)

# %% [markdown]
# The line from the origin to the epipole has the direction of all lines, $\mathbf h'^T_{N0} \mathbf w'_0 = 0$.  So
# $z_N$ follows from the parameters, or from center and fourth point, in either image.

# %%
section.up_to_scale(
    "3.2/h'N0", "line from the origin to the epipole", where={z_n: z_of_pair}, derived=cross(image_e0, w_left).T
)
section.identity("3.2.9#mu", "z_N from the parameters", where=ON_AXIS, derived=z_of_pair)

# %%
section.identity(
    "3.2.9",
    "z_N from the center of projection",
    where=ON_AXIS | given(center_left, y0_left),
    derived=z_of_pair,
)
section.identity(
    "3.2.9#right",
    "the condition with respect to the right image",
    printed=-(ya1 * mu1 + ya3 * right_fourth[0] * mu3) / (ya2 * mu2 + ya3 * right_fourth[1] * mu3),
    where=ON_AXIS,
    derived=z_of_pair,
)
section.identity("3.2.10#epipolar", "the fourth points lie on one epipolar line", where={z_n: z_of_pair}, derived=0)

# %% [markdown]
# **Another way to the right image.**  $\mathbf u''_{N3}$ lies on the epipolar line of $\mathbf u'_{N3}$, and
# satisfies the condition (3.2.7) of the right image.  These are two linear equations with one solution, that of
# (3.2.8).

# %%
matrix, right_side = linear_system(
    [
        dot(vector(1, z_n), right_fourth - left_fourth),
        sympy.expand(condition(y_a, center_right, right_fourth)),
    ],
    list(right_fourth),
)
PAIR = {z_n: z_of_pair} | given((*y_a, *center_right), (*y0_left, *y0_right))
section.identity(
    "3.2.10",
    "the fourth point satisfies both linear equations",
    printed=matrix * right_fourth,
    where=PAIR,
    derived=right_side.xreplace(PAIR),
)
section.rank(
    "3.2.10#unique",
    "the two linear equations have one solution",
    printed=2,
    derived=matrix.xreplace(PAIR),
)

# %% [markdown]
# ## The transformation
#
# The choice $u'_{N31} = u'_{31}$ in (3.1.2).

# %%
section.identity(
    "3.2/tau1'",
    "first parameter of the left transformation",
    where={u30: FOURTH[u30], un30: FOURTH[un30].xreplace({un31: u31})},
    derived=tau_of_fourth_points[0].xreplace({un31: u31}),
)

# %% [markdown]
# The fourth points that belong to $\mathbf T'$ and $\mathbf T''$ are the images of $G_3$ in $P'_N$ and $P''_N$.

# %%
image_of_e3 = u_of_y.subs(mu0, 1).xreplace(given(point, e3))
section.identity(
    "3.2/fourth-points",
    "the fourth points of both images",
    printed=columns(left_fourth, right_fourth),
    derived=columns(image_of_e3.xreplace(LEFT_FOURTH), image_of_e3.xreplace(RIGHT_FOURTH)),
)

# %% [markdown]
# ## The part of the fourth point
#
# The paper gives $\mathbf u_3$ a part like that of tip and tilt.  On how many coordinates of the image of $G_3$ do the
# parameters depend, when everything else is given?

# %%
section.count(
    "3.2/G3#parameters",
    "with the centers given, the parameters depend on both coordinates of the fourth point",
    printed=2,
    derived=mu_of_y0,
    variables=tuple(fourth_image),
)
section.count(
    "3.2/G3#orientation-left",
    "the left bundle depends on both coordinates of the fourth point",
    printed=2,
    derived=orientation_left,
    variables=tuple(fourth_image),
)

# %% [markdown]
# The right bundle depends on one combination of them.  The other one is given by the epipolar line of $G_3$ through
# the epipole $(u_{01}, u_{02})$.

# %%
u01, u02 = sympy.symbols("u01 u02")
section.count(
    "3.2/G3#orientation-right",
    "the right bundle depends on the fourth point",
    printed=1,
    derived=orientation_right,
    variables=tuple(fourth_image),
    kernel=[vector(1 - u01, -u02)],
)

# %% [markdown]
# With the center given, the fourth point determines both directions of the image plane.

# %%
section.count(
    "3.2/G3#plane",
    "with the center given, the fourth point determines both directions of the image plane",
    printed=2,
    derived=ratios(plane.xreplace(given(mu, mu_of_y0))),
    variables=tuple(fourth_image),
)
section.reference(
    "3.2/ref-2.3",
    "subsection with the procedure of relative orientation",
    meant="2.4",
    note="See 2.4/ref-2.3; subsection 2.3 is on critical situations.",
    same_as="2.4/ref-2.3",
)

# %% [markdown]
# ## Flat models
#
# If all object points lie in the plane $G_0 G_1 G_2$, then $\mathbf u' \sim \mathbf M' \mathbf Y$ and
# $\mathbf u'' \sim \mathbf M'' \mathbf Y$ with plane matrices.  The equation
# $\mathbf u'^T \mathbf Z \mathbf u'' = 0$ holds for all of these points if $\mathbf M'^T \mathbf Z \mathbf M''$ is
# any skew-symmetric matrix.

# %%
PLANE_LEFT = given(mu, (mup1, mup2, mup3))
PLANE_RIGHT = given(mu, (mupp1, mupp2, mupp3))
flat_image = u_of_y.subs(mu0, 1).subs(point[2], 0)
flat_matrix = columns(image_e0, P_star.col(0), P_star.col(1))


def flat_row(index: int) -> Matrix:
    """Return one row of (2.2.4), right side included, for a point of the plane."""
    place = given(point[:2, 0], sympy.symbols(f"y{index}1 y{index}2"))
    seen = [*flat_image.xreplace(place | PLANE_LEFT), *flat_image.xreplace(place | PLANE_RIGHT)]
    return reduced.xreplace(given(sympy.symbols("up1 up2 upp1 upp2"), seen))


def flat_correlation(axis: Matrix) -> Matrix:
    """Return a matrix of correlation of the images of a plane."""
    return adjugate(flat_matrix.xreplace(PLANE_LEFT)).T * skew(axis) * adjugate(flat_matrix.xreplace(PLANE_RIGHT))


def flat_solution(axis: Matrix) -> Matrix:
    """Return what satisfies all rows: five elements of Z, and minus the element z10."""
    solution = flat_correlation(axis)
    return vector(solution[1, 1], solution[1, 2], solution[2, 0], solution[2, 1], solution[2, 2], -solution[1, 0])


# %% [markdown]
# Five points in this plane give equations (2.2.4) of rank 3 for five unknowns.  All matrices of a two-parameter
# family satisfy them.

# %%
section.rank(
    "3.2/flat-model",
    "a flat model does not determine the correlation",
    printed=3,
    derived=Matrix.vstack(*(flat_row(index) for index in range(3, 8))),
    kernel=[flat_solution(axis) for axis in (e1, e2, e3)],
)

# %% [markdown]
# **The comparison with autocalibration.**  An image of the plane $y_3 = 0$, in cartesian coordinates, is a plane
# projectivity, which has eight parameters.  A camera has nine.  So interior and exterior orientation cannot be
# determined at the same time.

# %%
section.count(
    "3.2/autocalibration",
    "the image of a flat model has eight parameters",
    printed=8,
    derived=ratios(usual_projection[:, :3]),
    variables=usual_parameters,
    note="This holds for one image, of which the sentence is understood; several images with one interior orientation "
    "are not considered.",
)

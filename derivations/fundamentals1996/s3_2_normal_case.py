# %% [markdown]
# # 3.2 The normal case
#
# Two images form a normal case if their planes coincide and are parallel to the base.  What this means for the
# correlation, for the projective parameters and for the images of $G_3$ is the subject of this section.  One prime
# denotes the left image, two the right one.

# %%
import sympy

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
# In the coordinates of the basic points $\mathbf Z$ has five elements (2.2.3); it gives the epipolar lines
# $\mathbf h' = \mathbf Z \mathbf u''$ and $\mathbf h'' = \mathbf Z^T \mathbf u'$.

# %%
z_n = sympy.Symbol("z_n")
z11, z12, z20, z21, z22 = remaining

u_left = vector(*sympy.symbols("upN1 upN2"))
u_right = vector(*sympy.symbols("uppN1 uppN2"))
h_left = Z * homogeneous(u_right)
h_right = Z.T * homogeneous(u_left)

b_normal = vector(*sympy.symbols("bN0:3"))
section.definition(
    "3.2/line",
    "equation of an epipolar line",
    printed=dot(b_normal, homogeneous(u_left)),
)

# %% [markdown]
# The lines of one image are parallel with the same coefficients throughout, if $b_1$ and $b_2$ do not depend on the
# point of the other image.


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
    note="The derivatives of b1 and b2, left and right, with respect to the point of the other image: these are the "
    "four elements, so that the lines are constant exactly where they vanish.",
)
FOUR_ZEROS = dict.fromkeys((z11, z12, z21, z22), 0)
Z_N = Z.subs(FOUR_ZEROS).subs(z20, z_n)
Z_N_printed = Matrix([[0, -1, -z_n], [1, 0, 0], [z_n, 0, 0]])
section.identity("3.2.1", "correlation matrix of the normal case", printed=Z_N_printed, derived=Z_N)
section.identity("3.2.1#skewsymmetric", "it is skewsymmetric", printed=-Z_N_printed.T, derived=Z_N)

# %% [markdown]
# Constant coefficients are more than parallel lines.  Both epipoles are at infinity also for the following matrices,
# one for every $z_{12}$ and $z_{20}$: image planes that are parallel to the base, but do not coincide.

# %%
z11_of_z12 = over(z12, z20 + z20 * z12 - z12)
parallel_planes = Z.subs({z21: z20 * z11, z22: z20 * z12}).xreplace({z11: z11_of_z12})
section.identity(
    "3.2/beyond/parallel",
    "epipoles at infinity do not make the four elements zero",
    printed=Matrix.zeros(3, 2),
    derived=columns(parallel_planes.T * vector(0, -z20, 1), parallel_planes * vector(0, -z12, z11_of_z12)),
    note="Not in the paper: (0, -z20, 1) and (0, -z12, z11) are the epipoles.  Of the postulate of parallel and "
    "identic epipolar lines, the second adjective is needed as well.",
)

# %% [markdown]
# ## Epipolar lines

# %%
section.identity(
    "3.2.2#left",
    "epipolar line in the left image",
    printed=vector(-u_right[0] - z_n * u_right[1], 1, z_n),
    derived=Z_N * homogeneous(u_right),
)
section.identity(
    "3.2.2#right",
    "epipolar line in the right image",
    printed=vector(-u_left[0] + z_n * u_left[1], -1, -z_n),
    derived=Z_N.T * homogeneous(u_left),
    expect="misprint",
    corrected=vector(u_left[0] + z_n * u_left[1], -1, -z_n),
    note="The sign of the first term.  As a homogeneous vector it is not right either, for the other two components "
    "have the sign of Z_N^T u', and the following equation (3.2.3) needs the plus.  A slip of the scan cannot be told "
    "from one of the print.",
)
coplanarity = dot(homogeneous(u_left), Z_N * homogeneous(u_right))
section.identity(
    "3.2.3",
    "epipolar lines of both images",
    printed=(u_left[0] + z_n * u_left[1]) - (u_right[0] + z_n * u_right[1]),
    derived=coplanarity,
    note="Left side less right side: the condition of coplanarity u'^T Z_N u'' = 0.",
)
section.identity(
    "3.2/zN",
    "the factor from one pair of points",
    printed=-(u_left[0] - u_right[0]) / (u_left[1] - u_right[1]),
    derived=solve(*linear_system([coplanarity], [z_n]))[0],
)

# %% [markdown]
# ## Epipoles at infinity
#
# A point $\mathbf y_A$ of the epipolar axis is projected to the epipole.

# %%
y_a = vector(*sympy.symbols("yA1 yA2 yA3"))
ya0, ya1, ya2, ya3 = sympy.Symbol("yA0"), *y_a
AXIS = {ya0: 1 - sum(y_a)}
AT_AXIS = dict(zip(point, y_a, strict=True))
IN_NORMAL_CASE = {u31: un31, u32: un32}

homogeneous_image = P_star * point + image_e0
epipole = u_of_y.subs(mu0, 1).xreplace(AT_AXIS | IN_NORMAL_CASE)
common_denominator = ya0 + ya1 * mu1 + ya2 * mu2 + ya3 * mu3
section.identity(
    "3.2.4",
    "projection of a point of the epipolar axis",
    printed=vector(*(ya * m + ya3 * un * mu3 for ya, m, un in ((ya1, mu1, un31), (ya2, mu2, un32))))
    / common_denominator,
    where=AXIS,
    derived=epipole,
    note="The scan shows y as a script J here and below, and u as mu in places.",
)
epipole_weights = homogeneous_image.xreplace(AT_AXIS | IN_NORMAL_CASE)
for name, numerator in (("uN01", epipole_weights[1]), ("uN02", epipole_weights[2])):
    section.vanishing(
        f"3.2.5#{name}",
        f"{name} is infinite where the denominator vanishes",
        printed=(common_denominator,),
        where=AXIS,
        derived=over(epipole_weights[0], numerator),
        note="The derived side is 1/u; where the numerator vanishes as well, the coordinate is 0/0.",
    )

section.identity(
    "3.2/linear-combination",
    "one of the parameters is a linear combination of the other three",
    printed=-(ya0 + ya1 * mu1 + ya2 * mu2) / ya3,
    where=AXIS,
    derived=solve(*linear_system([epipole_weights[0]], [mu3]))[0],
    note="Here mu3; mu0 = 1 is the parameter with the coefficient yA0.",
)

# %% [markdown]
# In space: the image plane of $\mu$, $\mu_0 = 1$, passes through $G_0$ and has the equation
# $\sum (\mu_j - 1)\, y_j = 0$.  The condition (3.2.5) says that the base is parallel to it.

# %%
plane = vector(mu1 - 1, mu2 - 1, mu3 - 1)
section.identity(
    "3.2/beyond/plane",
    "equation of the image plane in space",
    printed=0,
    derived=dot(plane, y0_of_mu + P * homogeneous(vector(u1, u2))),
    note="Not in the paper: satisfied by the points y0 + P u for every u.",
)

# %% [markdown]
# Now the two images.  Let $\mathbf u'_{N3}$, $\mathbf u''_{N3}$ be the images of $G_3$; the centers follow from the
# parameters, and $\mathbf y_A = \mathbf y'_0 + t\, (\mathbf y''_0 - \mathbf y'_0)$.

# %%
k, t = sympy.symbols("k t")
left_fourth = vector(*sympy.symbols("upN31 upN32"))
right_fourth = vector(*sympy.symbols("uppN31 uppN32"))
LEFT_FOURTH = dict(zip(fourth_image, left_fourth, strict=True))
RIGHT_FOURTH = dict(zip(fourth_image, right_fourth, strict=True))
MU_RIGHT = dict(zip(mu, sympy.symbols("mupp1 mupp2 mupp3"), strict=True))

y0_left = y0_of_mu.xreplace(LEFT_FOURTH)
y0_right = y0_of_mu.xreplace(RIGHT_FOURTH)
general_base = y0_right.xreplace(MU_RIGHT) - y0_left
section.identity(
    "3.2.5#parallel",
    "the condition says that the base is parallel to the image plane",
    printed=common_denominator.xreplace(AXIS),
    where=dict(zip(y_a, y0_left + t * general_base, strict=True)),
    derived=t * dot(plane, general_base),
)

# %% [markdown]
# Planes that coincide have proportional coefficients, $\mu''_j - 1 = k\, (\mu'_j - 1)$.  If the base is parallel to
# them, $k = 1$: this is why $\mu'_{Ni} = \mu''_{Ni}$.

# %%
coincident = {mu[j]: 1 + k * plane[j] for j in range(3)}
section.vanishing(
    "3.2/equal-mu",
    "the base is parallel to coincident planes exactly where the parameters are equal",
    printed=(k - 1,),
    derived=dot(plane, y0_right.xreplace(coincident) - y0_left),
    note="Two images with coincident planes, mu''_j - 1 = k (mu'_j - 1).",
)
section.identity(
    "3.2/equal-mu#inference",
    "the parameters are equal because (3.2.5) holds in both images for the same point",
    printed=mu1,
    derived=MU_RIGHT[mu1],
    constraints=[common_denominator.xreplace(AXIS), common_denominator.xreplace(AXIS).xreplace(MU_RIGHT)],
    expect="false",
    instead="3.2/equal-mu",
    note="The reason that the sentence gives: one linear equation for each image does not make three parameters "
    "equal.  The conclusion is right by the definition of the normal case.",
)

# %% [markdown]
# With equal parameters the correlation matrix must be $\mathbf Z_N$, but for a factor.

# %%
base = y0_left - y0_right
P_left, P_right = P.xreplace(LEFT_FOURTH), P.xreplace(RIGHT_FOURTH)
C_N = Matrix(3, 3, lambda i, j: dot(cross(P_left[:, i], base), P_right[:, j]))
z_of_pair = over(C_N[2, 0], C_N[1, 0])
section.up_to_scale(
    "3.2.1#mu",
    "images with equal parameters have the correlation matrix of the normal case",
    printed=Z_N_printed,
    where={z_n: z_of_pair},
    derived=C_N,
    note="C = P'^T D P'' as in (2.1.4), with z_N = c20/c10.  This is also the final check of the section.",
)

# %% [markdown]
# And conversely: where the four elements of $\mathbf Z$ are zero, the parameters are equal.  The difference $q_2$ of
# section 2.2 is a factor of $c_{10}$, by which $\mathbf Z$ is divided.

# %%
mup1, mup2, mup3, mupp1, mupp2, mupp3 = sympy.symbols("mup1 mup2 mup3 mupp1 mupp2 mupp3")
EQUALITY = "The planes coincide and are parallel to the base where all three parameters are equal: 3.2/equal-mu."
section.vanishing(
    "3.2/equivalent#z11",
    "z11 is zero exactly where the first parameters are equal",
    printed=(mupp1 - mup1, differences[q2]),
    derived=C_of_cameras[1, 1],
    note="The factor that is not mu''1 - mu'1 is that of c10, which is not zero by (2.2.1).  " + EQUALITY,
)
section.vanishing(
    "3.2/equivalent#z12,z21",
    "z12 and z21 are then zero only where the second parameters are equal",
    printed=(mupp2 - mup2, mup1, differences[q2]),
    derived=(mupp2 * C_of_cameras[1, 2] + mup2 * C_of_cameras[2, 1]).xreplace({mupp1: mup1}),
    note="The first parameters are equal; derived is the sum that does not contain the third ones' difference.",
)
section.vanishing(
    "3.2/equivalent#z12",
    "z12 is then zero exactly where the third parameters are equal",
    printed=(mupp3 - mup3, mup1, mup2),
    derived=C_of_cameras[1, 2].xreplace({mupp1: mup1, mupp2: mup2}),
    note="The first and the second parameters are equal; a parameter of a projection is not zero.  z22 is zero as well "
    "then, by 3.2.1#mu.",
)

# %% [markdown]
# ## Conditions for the fourth points
#
# The parameters as functions of center and fourth image, (1.3.5), in both images.

# %%
y00_left, y00_right = sympy.symbols("yp00 ypp00")
u30_left, u30_right = sympy.symbols("upN30 uppN30")
center_left = vector(*sympy.symbols("yp01 yp02 yp03"))
center_right = vector(*sympy.symbols("ypp01 ypp02 ypp03"))
LEFT = LEFT_FOURTH | dict(zip(center, center_left, strict=True))
RIGHT = RIGHT_FOURTH | dict(zip(center, center_right, strict=True))
BARYCENTRIC_BOTH = {
    y00_left: 1 - sum(center_left),
    y00_right: 1 - sum(center_right),
    u30_left: 1 - sum(left_fourth),
    u30_right: 1 - sum(right_fourth),
}
mu_left, mu_right = mu_of_y0.xreplace(LEFT), mu_of_y0.xreplace(RIGHT)

for j in range(3):
    numerator_left, numerator_right = (1, 1) if j == 2 else (left_fourth[j], right_fourth[j])
    section.identity(
        f"3.2.6#mu{j + 1}",
        f"equality of the parameters mu{j + 1}",
        printed=numerator_left * y00_left / (u30_left * center_left[j])
        - numerator_right * y00_right / (u30_right * center_right[j]),
        where=BARYCENTRIC_BOTH,
        derived=(1, 1, -1)[j] * (mu_left[j] - mu_right[j]),
        note="Left side less right side" + (" of the equation multiplied by -1." if j == 2 else "."),
    )
section.definition("3.2/u'N31", "choice of the first coordinate of the fourth point", printed=LEFT_FOURTH[u31])

# %% [markdown]
# (3.2.5) multiplied by $u_{N30}$ is linear in the coordinates of the fourth point.  For each image:


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


for number, title, y00_printed, center_printed, fourth, parameters, note in (
    ("3.2.7", "condition for the fourth point, left image", y00_left, center_left, left_fourth, mu_left, ""),
    (
        "3.2.10#parallel",
        "condition for the fourth point, right image",
        y00_right,
        center_right,
        right_fourth,
        mu_right,
        " Read as y''01, y''02, y''03, which the scan has without primes beside y''00 with two.",
    ),
):
    linear_form = condition(y_a, center_printed, fourth)
    section.identity(
        f"{number}-form" if "#" in number else f"{number}#form",
        f"{title}: (3.2.5) with the parameters inserted",
        printed=linear_form,
        derived=(1 - sum(fourth)) * (1 - sum(y_a) + dot(y_a, parameters)),
        note="The left side of (3.2.5), multiplied by u_N30, as a form linear in the fourth point.",
    )
    section.identity(
        number,
        title,
        printed=vector(
            -(ya3 / center_printed[2] * y00_printed - ya0),
            ya1 / center_printed[0] * y00_printed - ya0,
            ya2 / center_printed[1] * y00_printed - ya0,
        ),
        where=AXIS | BARYCENTRIC_BOTH,
        derived=coefficients(linear_form, fourth),
        note="Coefficients of the equation, all terms on the left: constant, first, second coordinate." + note,
    )

# %% [markdown]
# One linear condition for two coordinates; with the choice of the first one the plane is determined.

# %%
left_condition = sympy.expand(condition(y_a, center_left, left_fourth))
section.rank(
    "3.2/one-coordinate",
    "parallelism to the base defines one coordinate of the fourth point",
    printed=1,
    derived=linear_system([left_condition], list(left_fourth))[0],
)
section.rank(
    "3.2/unique-plane",
    "with the first coordinate given the plane is uniquely defined",
    printed=2,
    derived=linear_system([left_condition, left_fourth[0] - u31], list(left_fourth))[0],
    note="The condition determines u'_N32 where its coefficient in (3.2.7) is not zero.",
)

# %% [markdown]
# The conditions do not depend on the choice of $\mathbf y_A$, unless it is the center of the same image: on the base
# they are multiples of the condition with the other center for $\mathbf y_A$.

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
        note="Not in the paper.  With the center of the same image for y_A the condition is empty.",
    )

# %% [markdown]
# With $\mathbf y_0$ and $\mathbf u'_{N31}$ this gives $u'_{N32}$, and the parameters of the left image.  Those of the
# right image are to be the same: the last two equations for its center, (1.3.4), give its fourth point.

# %%
common_mu = dict(zip(mu, mu_left, strict=True))
right_equations = [
    equation.xreplace(common_mu | dict(zip(center, center_right, strict=True))) for equation in center_equations
]
fourth_of_right = solve(*linear_system([*right_equations[1:]], [u31, u32]))
section.identity(
    "3.2.8",
    "fourth point of the right image",
    printed=vector(
        *(center_right[j] * center_left[2] / (center_left[j] * center_right[2]) * left_fourth[j] for j in (0, 1))
    ),
    derived=fourth_of_right,
)
section.reference(
    "3.2/ref-3.3.6",
    "conditions on which (3.2.8) is based",
    printed="3.3.6",
    meant="3.2.6",
    note="(3.3.6) is the formula for z_N from the elements of Z; the conditions between the fourth points of both "
    "images are (3.2.6).",
)

# %% [markdown]
# Must the parameters of the right image then be equivalent?  Given any $\mu$, the first equation for the right
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
    derived=mu_of_y0.xreplace(on_plane | dict(zip(fourth_image, fourth_on_plane, strict=True))),
    note="For every center that satisfies (3.2.5) and the fourth point of (3.2.8).  It does not matter which point of "
    "the base is y_A in (3.2.7), see 3.2/beyond/any-point.",
)

# %% [markdown]
# ## The direction of the epipolar lines
#
# The homogeneous coordinates of the epipole are the numerators and the denominator of (3.2.4).


# %%
def epipole_of(axis_point: Matrix, fourth: Matrix) -> Matrix:
    return homogeneous_image.xreplace(
        dict(zip(point, axis_point, strict=True)) | dict(zip(fourth_image, fourth, strict=True))
    )


axis_of_mu = y0_left + t * (y0_right - y0_left)
w_left, w_right = epipole_of(axis_of_mu, left_fourth), epipole_of(axis_of_mu, right_fourth)
ON_AXIS = dict(zip(y_a, axis_of_mu, strict=True))
section.identity(
    "3.2/w0'",
    "homogeneous coordinates of the epipole",
    printed=vector(
        0,
        ya1 * mu1 + ya3 * left_fourth[0] * mu3,
        ya2 * mu2 + ya3 * left_fourth[1] * mu3,
    ),
    where=ON_AXIS,
    derived=w_left,
    note="Images with equal parameters; y_A on the base.",
)
section.up_to_scale(
    "3.2/h'N0",
    "line from the origin to the epipole",
    printed=vector(0, 1, z_n),
    where={z_n: z_of_pair},
    derived=cross(image_e0, w_left),
    note="The condition h'_N0^T w'_0 = 0; z_N is the element of the correlation matrix.",
)
section.identity(
    "3.2.9#mu",
    "z_N from the parameters",
    printed=-(ya1 * mu1 + ya3 * left_fourth[0] * mu3) / (ya2 * mu2 + ya3 * left_fourth[1] * mu3),
    where=ON_AXIS,
    derived=z_of_pair,
    note="The derived side is the element c20/c10 of the correlation matrix of two images with equal parameters.",
)
section.identity(
    "3.2.9",
    "z_N from the center of projection",
    printed=-(left_fourth[0] * center_left[1] * (ya1 * center_left[2] - center_left[0] * ya3))
    / (left_fourth[1] * center_left[0] * (ya2 * center_left[2] - center_left[1] * ya3)),
    where=ON_AXIS | dict(zip(center_left, y0_left, strict=True)),
    derived=z_of_pair,
)
section.identity(
    "3.2.9#right",
    "the condition with respect to the right image",
    printed=-(ya1 * mu1 + ya3 * right_fourth[0] * mu3) / (ya2 * mu2 + ya3 * right_fourth[1] * mu3),
    where=ON_AXIS,
    derived=z_of_pair,
)
section.identity(
    "3.2.10#epipolar",
    "the fourth points lie on one epipolar line",
    printed=(right_fourth[0] + z_n * right_fourth[1]) - (left_fourth[0] + z_n * left_fourth[1]),
    where={z_n: z_of_pair},
    derived=0,
    note="Left side less right side.",
)

# %% [markdown]
# The second way to $\mathbf u''_{N3}$: the epipolar line of $\mathbf u'_{N3}$, and the condition (3.2.7) for the right
# image.

# %%
matrix, right_side = linear_system(
    [
        dot(vector(1, z_n), right_fourth - left_fourth),
        sympy.expand(condition(y_a, center_right, right_fourth)),
    ],
    list(right_fourth),
)
PAIR = {z_n: z_of_pair} | dict(zip((*y_a, *center_right), (*y0_left, *y0_right), strict=True))
section.identity(
    "3.2.10",
    "the fourth point satisfies both linear equations",
    printed=matrix * right_fourth,
    where=PAIR,
    derived=right_side.xreplace(PAIR),
    note="Images with equal parameters, with y0' for y_A; any other point of the base gives the same equations, see "
    "3.2/beyond/any-point#right.",
)
section.rank(
    "3.2.10#unique",
    "the two linear equations have one solution",
    printed=2,
    derived=matrix.xreplace(PAIR),
    note="So that it is the same fourth point as that of (3.2.8).",
)

# %% [markdown]
# ## The transformation
#
# The choice $u'_{N31} = u'_{31}$ in (3.1.2).

# %%
section.identity(
    "3.2/tau1'",
    "first parameter of the left transformation",
    printed=u30 / un30,
    where={u30: FOURTH[u30], un30: FOURTH[un30].xreplace({un31: u31})},
    derived=tau_of_fourth_points[0].xreplace({un31: u31}),
)

# %% [markdown]
# The fourth points that belong to $\mathbf T'$ and $\mathbf T''$ are the images of $G_3$ in $P'_N$ and $P''_N$.

# %%
image_of_e3 = u_of_y.subs(mu0, 1).xreplace(dict(zip(point, e3, strict=True)))
section.identity(
    "3.2/fourth-points",
    "the fourth points of both images",
    printed=columns(left_fourth, right_fourth),
    derived=columns(image_of_e3.xreplace(LEFT_FOURTH), image_of_e3.xreplace(RIGHT_FOURTH)),
)

# %% [markdown]
# ## The part of the fourth point
#
# Three counts: on how many coordinates of the images of $G_3$ the parameters depend when everything else is given.

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
u01, u02 = sympy.symbols("u01 u02")
section.count(
    "3.2/G3#orientation-right",
    "the right bundle depends on the fourth point",
    printed=1,
    derived=orientation_right,
    variables=tuple(fourth_image),
    kernel=[vector(1 - u01, -u02)],
    note="On one combination of the coordinates, the other being given by the epipolar line of G3; (u01, u02) is the "
    "epipole.",
)
section.count(
    "3.2/G3#plane",
    "with the center given, the fourth point determines both directions of the image plane",
    printed=2,
    derived=ratios(plane.xreplace(dict(zip(mu, mu_of_y0, strict=True)))),
    variables=tuple(fourth_image),
    note="The quotients of the coefficients of 3.2/beyond/plane: two, as tip and tilt are.",
)
section.reference(
    "3.2/ref-2.3",
    "subsection with the procedure of relative orientation",
    printed="2.3",
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
PLANE_LEFT = dict(zip(mu, (mup1, mup2, mup3), strict=True))
PLANE_RIGHT = dict(zip(mu, (mupp1, mupp2, mupp3), strict=True))
flat_image = u_of_y.subs(mu0, 1).subs(point[2], 0)
flat_matrix = columns(image_e0, P_star.col(0), P_star.col(1))


def flat_row(index: int) -> Matrix:
    """Return one row of (2.2.4), right side included, for a point of the plane."""
    place = dict(zip(point[:2, 0], sympy.symbols(f"y{index}1 y{index}2"), strict=True))
    seen = [*flat_image.xreplace(place | PLANE_LEFT), *flat_image.xreplace(place | PLANE_RIGHT)]
    return reduced.xreplace(dict(zip(sympy.symbols("up1 up2 upp1 upp2"), seen, strict=True)))


def flat_solution(axis: Matrix) -> Matrix:
    """Return what satisfies all rows: five elements of Z, and minus the element z10."""
    skew = columns(*(cross(axis, unit) for unit in (e1, e2, e3)))
    solution = adjugate(flat_matrix.xreplace(PLANE_LEFT)).T * skew * adjugate(flat_matrix.xreplace(PLANE_RIGHT))
    return vector(solution[1, 1], solution[1, 2], solution[2, 0], solution[2, 1], solution[2, 2], -solution[1, 0])


section.rank(
    "3.2/flat-model",
    "a flat model does not determine the correlation",
    printed=3,
    derived=Matrix.vstack(*(flat_row(index) for index in range(3, 8))),
    kernel=[flat_solution(axis) for axis in (e1, e2, e3)],
    note="The sentence, made precise: five points in the plane of G0, G1, G2 give equations (2.2.4) of rank 3 for five "
    "unknowns; all matrices of a two-parameter family satisfy them.",
)

# %% [markdown]
# The comparison with autocalibration: an image of the plane $y_3 = 0$, in cartesian coordinates, is a plane
# projectivity, which has eight parameters; the camera has nine, 1.1/general#usual.

# %%
section.count(
    "3.2/autocalibration",
    "the image of a flat model has eight parameters",
    printed=8,
    derived=ratios(usual_projection[:, :3]),
    variables=usual_parameters,
    note="One less than interior and exterior orientation together: they cannot be determined at the same time.  This "
    "holds for one image, of which the sentence is understood; several images with one interior orientation are not "
    "considered.",
)

# %% [markdown]
# ## Code
#
# (3.2.7) gives $u'_{N32}$ for the choice $u'_{N31} = u'_{31}$, (3.2.8) the fourth point of the right image, (3.2.9) the
# factor $z_N$.  In $y_{00} y_{Aj} - y_{0j} y_{A0}$ the product $y_{0j} y_{Aj}$ cancels and is left out.

# %%
constant, first, second = coefficients(condition(y_a, center_left, left_fourth), left_fourth)
left_of_choice = vector(u31, -over(constant + first * u31, second))
CHOICE = dict(zip(left_fourth, left_of_choice, strict=True))
z_of_centers = over(
    -left_fourth[0] * center_left[1] * (y_a[0] * center_left[2] - center_left[0] * y_a[2]),
    left_fourth[1] * center_left[0] * (y_a[1] * center_left[2] - center_left[1] * y_a[2]),
)
right_of_left = vector(
    *(over(center_right[j] * center_left[2] * left_fourth[j], center_left[j] * center_right[2]) for j in (0, 1))
)
P01, P02, P03, A13, A23 = sympy.symbols("p01 p02 p03 a13 a23")
un32_left, numerator, quotient = sympy.symbols("uN32 numerator quotient")
yp01, yp02, yp03 = center_left
ypp01, ypp02, ypp03 = center_right
section.kernel(
    "normal_case.from_orientation",
    "Factor z_N and fourth image points of the normal case, with uN31 = u31 in the left image.",
    arguments={"y_a": y_a, "y0_left": center_left, "y0_right": center_right, "u3_left": fourth_image},
    describe={
        "y_a": "Point (yA1, yA2, yA3) of the epipolar axis other than the left center, in affine coordinates; "
        "dimensionless.",
        "y0_left": "Left center of projection in affine coordinates; dimensionless.",
        "y0_right": "Right center of projection in affine coordinates; dimensionless.",
        "u3_left": f"Left image: {ABOUT_U3}",
    },
    derived={
        "z_N": z_of_centers.xreplace(CHOICE),
        "u3_normal_left": left_of_choice,
        "u3_normal_right": right_of_left.xreplace(CHOICE),
    },
    form={
        "z_N": -u31 * yp03 * P02 * A13 / (numerator * A23),
        "u3_normal_left": vector(u31, un32_left),
        "u3_normal_right": vector(u31 * ypp01 * quotient / yp01, un32_left * ypp02 * quotient / yp02),
    },
    where={
        P01: (1 - yp02 - yp03) * ya1 - yp01 * (1 - ya2 - ya3),
        P02: (1 - yp01 - yp03) * ya2 - yp02 * (1 - ya1 - ya3),
        P03: (1 - yp01 - yp02) * ya3 - yp03 * (1 - ya1 - ya2),
        A13: ya1 * yp03 - yp01 * ya3,
        A23: ya2 * yp03 - yp02 * ya3,
        numerator: yp01 * P03 - yp03 * P01 * u31,
        un32_left: yp02 * numerator / (yp01 * yp03 * P02),
        quotient: yp03 / ypp03,
    },
    claims=["3.2.7", "3.2.8", "3.2.9"],
    example={
        "y_a": ("-0.9009221", "0.8325803", "3.7908794"),
        "y0_left": ("-0.8871075", "-0.2253355", "4.2692516"),
        "y0_right": ("-0.9009221", "0.8325803", "3.7908794"),
        "u3_left": ("0.2718578", "0.0577379"),
    },
)

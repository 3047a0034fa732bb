# %% [markdown]
# # 2.4 Relative orientation
#
# How are the two bundles of rays tied together, so that they make a model?  Both already see the basic
# points.  What ties them together is the epipolar axis, the line of the two centers: its images are the epipoles,
# known from correlation.  A point $\mathbf y_A$ chosen on the axis gives the parameters of the left bundle,
# $\mathbf y_A$ and the left center those of the right one.

# %%
import sympy

from algebroproj_derivations.cameras import inhomogeneous, minors_of_cameras
from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s1_2_determination_of_projection import M_star as M_star_any
from algebroproj_derivations.fundamentals1996.s1_3_properties_of_projection import M_star, P, y0_of_mu
from algebroproj_derivations.fundamentals1996.s1_5_space_to_space import M_star as core
from algebroproj_derivations.fundamentals1996.s2_1_spatial_intersection import correlation_matrix
from algebroproj_derivations.fundamentals1996.s2_2_correlation import Z, remaining
from algebroproj_derivations.inserting import given, inserted
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

section = Section("fundamentals1996", "2.4", "Relative orientation")

# %% [markdown]
# **Print.**  The paper numbers the equations of this section (2.3.0) to (2.3.4), as if it were 2.3.  Three of these
# numbers occur there as well.  Here they are 2.4/2.3.0 and so on.

# %%
section.reference(
    "2.4/ref-2.3",
    "number of the subsection in its equations, its figure and its table",
    printed="2.3",
    meant="2.4",
    note="The equations are numbered (2.3.0) to (2.3.4); the figure and the table are 2.3, too.  Later references to "
    "'subsection 2.3' mean this one.",
)

# %% [markdown]
# Primes are left out where one bundle alone is concerned.  The epipole is $\mathbf u_0 = (u_{01}, u_{02})$; the
# coordinates $y_{A0}$, $u_{00}$ complete the others to 1.

# %%
ya0, ya1, ya2, ya3 = sympy.symbols("yA0 yA1 yA2 yA3")
u00, u01, u02 = sympy.symbols("u00 u01 u02")
axis_point = vector(ya1, ya2, ya3)
epipole = vector(u01, u02)
image_epipole = homogeneous(epipole)
COMPLETED = BARYCENTRIC | {ya0: 1 - ya1 - ya2 - ya3, u00: 1 - u01 - u02}

M = M_star[:3, :]

# %% [markdown]
# **An example.**  The centers and basic points of two cameras, the axis through the centers, and a point A on it.

# %%
LEFT, RIGHT = (
    divided(y0_of_mu.xreplace(given((mu1, mu2, mu3, u31, u32), map(sympy.Rational, values))))
    for values in (("1/2", "1/2", "2/3", "1/4", "1/8"), ("2/3", "1/2", "2/3", "1/3", "-1/8"))
)
SpaceDrawing(
    "The left center C', the right center C'', the axis through them with a point A, and the basic points.  The rays "
    "to the basic points meet whatever the parameters are; the axis ties the bundles together.",
    {"C'": LEFT, "C''": RIGHT, "A": 2 * RIGHT - LEFT, "G0": e0, "G1": e1, "G2": e2, "G3": e3},
    segments=[("C'", "A"), *((name, f"G{j}") for name in ("C'", "C''") for j in range(4))],
)

# %% [markdown]
# ## The epipoles
#
# **Definition.**  $\mathbf C$ is the matrix of (2.1.4).  It takes the images of the base $\mathbf d$ to zero.

# %%
p_left, p_right = Matrix(3, 3, sympy.symbols("p:3:3")), Matrix(3, 3, sympy.symbols("q:3:3"))
base = vector(*sympy.symbols("d1 d2 d3"))
C = correlation_matrix(p_left, p_right, base)
section.identity("2.4/epipoles", "the epipole of the left image", derived=C.T * inverse(p_left) * base)
section.identity("2.4/epipoles#right", "the epipole of the right image", derived=C * inverse(p_right) * base)

# %% [markdown]
# **Which point of the axis is it?**  Any.  On a line through the center all points have the same image.

# %%
t = sympy.Symbol("t")
section.up_to_scale(
    "2.4/axis",
    "all points of a line through the center have one image",
    printed=M * homogeneous(axis_point),
    derived=M * homogeneous(y0_of_mu + t * (axis_point - y0_of_mu)),
)

# %% [markdown]
# ## The projection of a point of the axis
#
# **Definition.**  $\mathbf M^* (1, \mathbf y_A) = \mu_A (1, \mathbf u_0)$, three equations.
#
# **Print.**  Row 2 of the matrix is $(0, \mu_1, 0, u_{31} \mu_3)$, row 3 is $(0, 0, \mu_2, u_{32} \mu_3)$.  Of the
# second equation the print has a term in $\mu_2$ too many, and both factors of $\mu_3$ are missing.

# %%
image_of_axis = M * homogeneous(axis_point)
section.identity(
    "2.4/2.3.0#1", "projection of a point of the axis, first component", where=COMPLETED, derived=image_of_axis[0]
)
section.identity(
    "2.4/2.3.0#2",
    "projection of a point of the axis, second component",
    derived=image_of_axis[1],
    expect="misprint",
    corrected=ya1 * mu1 + ya3 * u31 * mu3,
    note="(2.3.1), as printed, follows from the corrected equation only.  No exchange of rows and columns gives the "
    "printed form; whether the scan or the print is at fault cannot be told.",
)
section.identity(
    "2.4/2.3.0#3",
    "projection of a point of the axis, third component",
    derived=image_of_axis[2],
    expect="misprint",
    corrected=ya2 * mu2 + ya3 * u32 * mu3,
    same_as="2.4/2.3.0#2",
)

# %% [markdown]
# The first equation gives $\mu_A$.  Inserted into the others, it leaves two linear equations for three unknowns.

# %%
mu_a = image_of_axis[0]
image_of_axis_point = vector(*(over(component, mu_a) for component in image_of_axis[1:, 0]))
axis_equations = [mu_a * u01 - image_of_axis[1], mu_a * u02 - image_of_axis[2]]
vector(*axis_equations)

# %% [markdown]
# **Print.**  The equations are compared by their coefficients.


# %%
def as_form(equation: sympy.Expr, *unknowns: sympy.Symbol) -> Matrix:
    """Return the coefficients of a linear equation, then its right side."""
    left_side, right_side = linear_system([equation], unknowns)
    return vector(*left_side, right_side[0])


section.up_to_scale(
    "2.4/2.3.1#1",
    "first equation for the parameters",
    where=COMPLETED,
    derived=as_form(axis_equations[0], mu1, mu2, mu3),
)
section.up_to_scale(
    "2.4/2.3.1#2",
    "second equation for the parameters",
    where=COMPLETED,
    derived=as_form(axis_equations[1], mu1, mu2, mu3),
)

section.rank(
    "2.4/underdetermined",
    "two equations for three unknowns",
    printed=2,
    derived=linear_system(axis_equations, [mu1, mu2, mu3])[0],
)

# %% [markdown]
# ## a) Which left bundle?
#
# **Definition.**  Unit points and $\mathbf y_A$ leave one degree of freedom, which $\mu'_1 = \mu'_2$ takes up: two
# equations, two unknowns.  The parameters are

# %%
left_equations = [equation.subs(mu1, mu2) for equation in axis_equations]
left_matrix, left_right_side = linear_system(left_equations, [mu2, mu3])
left_solution = solve(left_matrix, left_right_side)
mu_left = vector(left_solution[0], *left_solution)
D_left = determinant(left_matrix)
mu_left

# %% [markdown]
# **Print.**

# %%
D = sympy.Symbol("D")
section.up_to_scale(
    "2.4/left#1", "first equation of the left bundle", where=COMPLETED, derived=as_form(left_equations[0], mu2, mu3)
)
section.up_to_scale(
    "2.4/left#2", "second equation of the left bundle", where=COMPLETED, derived=as_form(left_equations[1], mu2, mu3)
)
section.identity("2.4/2.3.2#D", "determinant of the left bundle", derived=D_left)

# %%
section.identity(
    "2.4/2.3.2#mu2", "first and second parameter of the left bundle", where=COMPLETED | {D: D_left}, derived=mu_left[1]
)
section.identity(
    "2.4/2.3.2#mu3", "third parameter of the left bundle", where=COMPLETED | {D: D_left}, derived=mu_left[2]
)

# %% [markdown]
# **Meaning.**  Where on the axis $\mathbf y_A$ is assumed does not matter: take any bundle with $\mu_1 = \mu_2$,
# any axis through its center, and another point of the axis with the same epipole.

# %%
of_equal = [formula.subs(mu1, mu2) for formula in (y0_of_mu, image_of_axis_point)]
other_point = of_equal[0] + t * (axis_point - of_equal[0])
section.identity(
    "2.4/anywhere",
    "the point may be assumed everywhere on the axis",
    printed=vector(0, 0),
    derived=inserted(vector(*left_equations), (*axis_point, *epipole), (*other_point, *of_equal[1])),
)

# %% [markdown]
# ### When does $D'$ vanish?
#
# In each of the three cases of the paper:

# %%
for number, title, conditions in (
    ("1", "in the plane of e1 and e2", [ya3]),
    ("2", "on the axis of e3", [ya1, ya2]),
    ("3", "for an epipole in the image of G3", [u01 - u31, u02 - u32]),
):
    section.identity(
        f"2.4/singular#{number}",
        f"the left bundle is singular {title}",
        printed=0,
        derived=D_left,
        constraints=conditions,
    )

# %% [markdown]
# What the cases are in space: the first one is the plane of $\mathbf e_1$ and $\mathbf e_2$, and the third one says
# that $G_3$ lies on the axis.

# %%
section.vanishing(
    "2.4/singular#plane",
    "the plane of e1 and e2",
    derived=determinant(columns(*map(homogeneous, (e0, e1, e2, axis_point)))),
)
section.up_to_scale(
    "2.4/singular#G3",
    "the epipole is the image of G3 if G3 lies on the axis",
    printed=image_e3,
    derived=M * homogeneous(y0_of_mu + t * (e3 - y0_of_mu)),
)
section.up_to_scale(
    "2.4/singular#G3-only",
    "the axis goes through G3 if the epipole is the image of G3",
    printed=e3 - y0_of_mu,
    derived=P * image_e3,
)

# %% [markdown]
# But these are not all the cases.  Two of them take two conditions, while $D' = 0$ is a single equation: beside
# $y_{A3}$ it has one irreducible factor, of which they are special points.

# %%
section.identity(
    "2.4/singular",
    "the left bundle is singular in these three cases only",
    printed=Matrix.zeros(4, 1),
    derived=vector(ya1 * (u01 - u31), ya1 * (u02 - u32), ya2 * (u01 - u31), ya2 * (u02 - u32)),
    constraints=[D_left],
    nonzero=[ya3],
    expect="false",
    instead="2.4/beyond/singular",
    note="'In other words' read as: D' = 0 exactly if yA3 = 0, or yA1 = yA2 = 0, or u0 = u3.  Read as a list of "
    "examples the sentence is true: 2.4/singular#1 to #3.",
)

# %% [markdown]
# **When exactly?**  The plane of $\mathbf y_A$ and the $\mathbf e_3$-axis meets the line $G_1 G_2$ in a point.  Its
# image, for $\mu_1 = \mu_2$, is $(y_{A1} + y_{A2}, y_{A1}, y_{A2})$.  The epipole, $G'_3$ and this image must not be
# collinear.

# %%
pierced = ya1 * image_e1 + ya2 * image_e2
section.vanishing(
    "2.4/beyond/singular",
    "where the left bundle is singular",
    printed=(ya3, determinant(columns(pierced, image_epipole, image_e3))),
    derived=D_left,
)

# %% [markdown]
# Nor may a parameter vanish, or the solution is no projection.  So $\mathbf y_A$ must not lie in the plane of $G_1,
# G_2, G_3$.  And neither $G'_3$ nor the point above may be collinear with $G'_0$ and the epipole.

# %%
section.vanishing(
    "2.4/beyond/no-projection#mu2",
    "where the first and second parameter of the left bundle are zero",
    printed=(ya0, determinant(columns(image_e0, image_epipole, image_e3))),
    where=COMPLETED,
    derived=mu_left[1],
)
section.vanishing(
    "2.4/beyond/no-projection#mu3",
    "where the third parameter of the left bundle is zero",
    printed=(ya0, determinant(columns(image_e0, image_epipole, pierced))),
    where=COMPLETED,
    derived=mu_left[2],
)

# %% [markdown]
# ## b) The right bundle
#
# **Definition.**  The epipole is now the image of two known points, $\mathbf y_A$ and the left center $\mathbf y'_0$,
# here $(y_{01}, y_{02}, y_{03})$ as in print.  Of each pair of equations, $\mu''_1$ and $\mu''_2$ follow from
# $\mu''_3$.

# %%
AT_CENTER = given(axis_point, center)
center_pair = [equation.subs(AT_CENTER) for equation in axis_equations]

for number, equation in zip("12", axis_equations, strict=False):
    section.up_to_scale(
        f"2.4/2.3.3#{number}",
        f"equation {number} of the right bundle, rearranged",
        where=COMPLETED,
        derived=as_form(equation, mu1, mu2),
    )

# %% [markdown]
# Both points lie on the axis: what a bundle maps to the epipole is collinear with its center.

# %%
section.up_to_scale(
    "2.4/collinear",
    "the axis point and the center define the direction of the base",
    printed=axis_point - y0_of_mu,
    derived=P * homogeneous(image_of_axis_point),
)
pair_matrix, pair_right_side = linear_system(axis_equations, [mu1, mu2])
mu12_of_axis_point = solve(pair_matrix, pair_right_side)
mu12_of_center = vector(*(component.subs(AT_CENTER) for component in mu12_of_axis_point))

# %% [markdown]
# The two parameters, from either point:

# %%
section.identity("2.4/D''", "determinant of the right bundle", where=COMPLETED, derived=determinant(pair_matrix))
first_braces = u01 * (1 - u32) - u31 * (1 - u02)
second_braces = u02 * (1 - u31) - u32 * (1 - u01)
for name, source, derived in (
    ("yA", "the point of the axis", mu12_of_axis_point),
    ("y0", "the left center", mu12_of_center),
):
    section.identity(
        f"2.4/mu1({name})", f"first parameter of the right bundle, from {source}", where=COMPLETED, derived=derived[0]
    )
    section.identity(
        f"2.4/mu2({name})", f"second parameter of the right bundle, from {source}", where=COMPLETED, derived=derived[1]
    )

# %% [markdown]
# ### When does $D''$ vanish?
#
# The paper has two cases, $\mathbf y_A$ or the left center on the axis of $\mathbf e_3$, and $u_{00} = 0$.

# %%
section.identity(
    "2.4/b#e3-axis",
    "the right bundle is singular for a point on the axis of e3",
    printed=0,
    derived=determinant(pair_matrix),
    constraints=[ya1, ya2],
)
section.identity(
    "2.4/b#u00",
    "the right bundle is singular where u00 = 0",
    printed=0,
    derived=determinant(pair_matrix),
    constraints=[COMPLETED[u00]],
)
section.reference(
    "2.4/ref-1.3.6",
    "equation with the restrictions that are extended to the epipole",
    meant="1.3.8",
    note="The restrictions a) and b) follow (1.3.8) and refer to it; for (1.3.6) the paper states none.",
)

# %% [markdown]
# The first one is too narrow.  The points must avoid both *planes* $y_1 = 0$ and $y_2 = 0$, or $\mu_1$ and $\mu_2$ do
# not follow from $\mu_3$.

# %%
section.vanishing(
    "2.4/beyond/D''",
    "where the right bundle is singular",
    printed=(ya1, ya2, u00),
    where=COMPLETED,
    derived=determinant(pair_matrix),
)

# %% [markdown]
# The line $u_{00} = 0$ goes through $G'_1$ and $G'_2$.  On it are the images of the plane of $G_1$, $G_2$ and the
# center.

# %%
section.up_to_scale(
    "2.4/b#line",
    "the line that the epipole must avoid",
    printed=None,
    derived=cross(image_e1, image_e2),
    expect="illegible",
    corrected=vector(1, -1, -1),
    note="The scan reads '-mu_1 - mu_2 = -10': most likely 1 - u1 - u2 = 0, that is u00 = 0.",
)
point = vector(y1, y2, y3)
section.up_to_scale(
    "2.4/b#plane",
    "on the line are the images of the plane of G1, G2 and the center",
    printed=as_form(dot(vector(1, -1, -1), M * homogeneous(point)), y1, y2, y3),
    derived=as_form(determinant(columns(*map(homogeneous, (point, y0_of_mu, e1, e2)))), y1, y2, y3),
)

# %% [markdown]
# But there the bundle is not lost.  The sum of the two equations contains $\mu_3$ alone, which follows at once.

# %%
section.identity(
    "2.4/beyond/u00",
    "on the line the third parameter follows at once",
    printed=-ya0 / (u30 * ya3),
    where=COMPLETED,
    derived=mu3,
    constraints=[COMPLETED[u00], *axis_equations],
    nonzero=[ya3],
)

# %% [markdown]
# ### The third parameter
#
# Both points must give the same $\mu''_1$, and the same $\mu''_2$: two equations for $\mu''_3$.

# %%
equal_mu1 = mu12_of_axis_point[0] - mu12_of_center[0]
equal_mu2 = mu12_of_axis_point[1] - mu12_of_center[1]
section.up_to_scale(
    "2.4/mu3#1", "first equation for the third parameter", where=COMPLETED, derived=as_form(equal_mu1, mu3)
)
section.up_to_scale(
    "2.4/mu3#2", "second equation for the third parameter", where=COMPLETED, derived=as_form(equal_mu2, mu3)
)

# %% [markdown]
# Each is solved for $\mu''_3$, and its solution, inserted above, gives $\mu''_1$ and $\mu''_2$ without $\mu''_3$.

# %%
mu1_and_mu3 = solve(*linear_system([mu12_of_axis_point[0] - mu1, mu12_of_center[0] - mu1], [mu1, mu3]))
mu2_and_mu3 = solve(*linear_system([mu12_of_axis_point[1] - mu2, mu12_of_center[1] - mu2], [mu2, mu3]))

# %% [markdown]
# **Print.**  The text inserts into (2.2.3), which is the matrix $\mathbf Z$.  It means (2.3.3) of this section.

# %%
section.reference(
    "2.4/ref-2.2.3",
    "equations into whose solutions the third parameter is inserted",
    meant="2.3.3",
)
section.identity(
    "2.4/beyond/mu1,mu2",
    "first and second parameter of the right bundle, without the third",
    printed=vector(
        (y00 * ya3 - y03 * ya0) * u01 / ((y01 * ya3 - y03 * ya1) * u00),
        (y00 * ya3 - y03 * ya0) * u02 / ((y02 * ya3 - y03 * ya2) * u00),
    ),
    where=COMPLETED,
    derived=vector(mu1_and_mu3[0], mu2_and_mu3[0]),
)

# %% [markdown]
# **Can divisors be saved?**  Yes.  Sums of the four equations leave one parameter out, so that it may be set to zero.
# $y_{A1}, y_{A2}, y_{01}, y_{02}$ are no divisors any longer.

# %%
without_mu3 = [y03 * a - ya3 * b for a, b in zip(axis_equations, center_pair, strict=True)]
without_mu1 = [u02 * first + (1 - u01) * second for first, second in (axis_equations, center_pair)]
mu1_mu2 = solve(*linear_system([equation.subs(mu3, 0) for equation in without_mu3], [mu1, mu2]))
mu3_right = solve(*linear_system([equation.subs(mu1, 0) for equation in without_mu1], [mu2, mu3]))[1]
mu_right = vector(*mu1_mu2, mu3_right)
mu_right

# %%
section.identity(
    "2.4/beyond/left-out",
    "the sums are free of the parameter that they leave out",
    printed=Matrix.zeros(4, 1),
    derived=vector(*(diff(e, mu3) for e in without_mu3), *(diff(e, mu1) for e in without_mu1)),
)
section.identity(
    "2.4/beyond/right-bundle",
    "parameters of the right bundle in closed form",
    printed=vector(
        (y00 * ya3 - y03 * ya0) * u01 / ((y01 * ya3 - y03 * ya1) * u00),
        (y00 * ya3 - y03 * ya0) * u02 / ((y02 * ya3 - y03 * ya2) * u00),
        (y00 * ya2 - y02 * ya0) * u02 / ((y02 * ya3 - y03 * ya2) * second_braces),
    ),
    where=COMPLETED,
    derived=mu_right,
)

# %% [markdown]
# **When do the equations for $\mu''_3$ fail?**  The first one if the axis meets the line $G_0 G_2$, or if the epipole
# is collinear with $G''_2$ and $G''_3$.  The second one likewise, with $G_1$ for $G_2$.

# %%
section.vanishing(
    "2.4/beyond/mu3#1",
    "where the first equation does not give the third parameter",
    printed=(
        determinant(columns(*map(homogeneous, (center, axis_point, e0, e2)))),
        determinant(columns(image_epipole, image_e2, image_e3)),
    ),
    derived=as_form(equal_mu1, mu3)[0],
)
section.vanishing(
    "2.4/beyond/mu3#2",
    "where the second equation does not give the third parameter",
    printed=(
        determinant(columns(*map(homogeneous, (center, axis_point, e0, e1)))),
        determinant(columns(image_epipole, image_e1, image_e3)),
    ),
    derived=as_form(equal_mu2, mu3)[0],
)

# %% [markdown]
# ### Two equations, one solution?
#
# **The paper's answer.**  Two products are equal, and so are both solutions.  This is true for an epipole that is the
# image of the whole axis.  Take any right bundle, $\mathbf y_A$ anywhere, and $\mathbf y'_0 = \mathbf y''_0 +
# t (\mathbf y_A - \mathbf y''_0)$ on the line through $\mathbf y_A$ and the right center.

# %%
left_product = (y01 * ya3 - y03 * ya1) * (y00 * ya2 - y02 * ya0) * first_braces * u02
right_product = (y02 * ya3 - y03 * ya2) * (y00 * ya1 - y01 * ya0) * second_braces * u01
left_center = y0_of_mu + t * (axis_point - y0_of_mu)
ON_AXIS = given(epipole, image_of_axis_point) | given(center, left_center)
ON_AXIS |= {symbol: COMPLETED[symbol].subs(ON_AXIS) for symbol in (y00, u00)} | {ya0: COMPLETED[ya0]}

section.identity("2.4/equality", "the two products are equal", where=ON_AXIS, derived=0)
section.identity(
    "2.4/equality#mu3",
    "both solutions are the third parameter of the right bundle",
    printed=vector(
        (y00 * ya1 - y01 * ya0) * u01 / ((y01 * ya3 - y03 * ya1) * first_braces),
        (y00 * ya2 - y02 * ya0) * u02 / ((y02 * ya3 - y03 * ya2) * second_braces),
    ),
    where=ON_AXIS,
    derived=vector(mu3, mu3),
)

# %% [markdown]
# **Where exactly does it hold?**  It is no identity.  The four equations, two for each point, have three unknowns.
# They agree only if the determinant of coefficients and right sides is zero.  This is the difference of the two
# products.

# %%
four_forms = [as_form(equation, mu1, mu2, mu3) for equation in axis_equations + center_pair]
section.identity(
    "2.4/beyond/consistent",
    "the equality is the condition that the four equations agree",
    printed=left_product - right_product,
    where=COMPLETED,
    derived=determinant(rows(*four_forms)),
)

# %% [markdown]
# **Meaning.**  With $p_{jk} = y_{0j} y_{Ak} - y_{0k} y_{Aj}$, the quotient
# $\kappa = p_{13}\, p_{02} : p_{23}\, p_{01}$ is a cross ratio of the four planes that join the axis to the basic
# points.  In the image the planes appear as the epipolar lines of the basic points, whose cross ratio is the rest of
# the equality.

# %%
cross_ratio = sympy.Symbol("kappa")
section.identity(
    "2.4/beyond/cross-ratio",
    "the products are equal if planes and epipolar lines have one cross ratio",
    printed=left_product,
    derived=right_product,
    constraints=[
        (y01 * ya3 - y03 * ya1) * (y00 * ya2 - y02 * ya0)
        - cross_ratio * (y02 * ya3 - y03 * ya2) * (y00 * ya1 - y01 * ya0),
        second_braces * u01 - cross_ratio * first_braces * u02,
    ],
)

# %% [markdown]
# The left bundle satisfies the equality with its own epipole: `2.4/equality` for $t = 0$.  Hence the right one does
# exactly if the epipolar lines of the basic points have the same cross ratio in both images.  And this is what
# correlation is about.  Epipoles and $G_0, G_1, G_2$ determine $\mathbf Z$, (2.2.3): five equations for five
# elements.

# %%
up01, up02, up31, up32 = sympy.symbols("up01 up02 up31 up32")
left_image = {u01: up01, u02: up02, u31: up31, u32: up32}
epipole_equations = [*(Z.T * homogeneous(vector(up01, up02))), *(Z[1:, :] * image_epipole)]
Z_of_epipoles = Z.subs(given(remaining, solve(*linear_system(epipole_equations, remaining))))
in_left_image = (second_braces * u01).subs(left_image), (first_braces * u02).subs(left_image)

section.identity(
    "2.4/beyond/epipoles",
    "the three basic points and the epipoles determine the correlation",
    printed=Matrix.zeros(9, 1),
    derived=vector(
        *(Z_of_epipoles.T * homogeneous(vector(up01, up02))),
        *(Z_of_epipoles * image_epipole),
        *(dot(image, Z_of_epipoles * image) for image in (image_e0, image_e1, image_e2)),
    ),
)

# %% [markdown]
# The images of $G_3$ are homologous exactly if the cross ratios agree.  With measured image coordinates they do so
# only approximately, and the two solutions for $\mu''_3$ differ.

# %%
section.vanishing(
    "2.4/beyond/homologous",
    "the images of G3 are homologous exactly if the cross ratios of both images agree",
    printed=(in_left_image[0] * first_braces * u02 - in_left_image[1] * second_braces * u01,),
    derived=dot(homogeneous(vector(up31, up32)), Z_of_epipoles * image_e3),
)

# %% [markdown]
# ## c) The relative model
#
# How is the model computed?  Both bundles map the model point $\bar{\mathbf y}$, here $\mathbf y$, by a matrix
# (1.2.3) of their own.  Each image coordinate gives one equation for the point, with the rows $\mathbf m_i$ of the
# matrix.

# %%
mu_p, mu_pp = (sympy.symbols(f"{name}1:4") for name in ("mup", "mupp"))
u3_p, u3_pp = (sympy.symbols(f"{name}31:33") for name in ("up", "upp"))
mup1, mup2, mup3 = mu_p
mupp1, mupp2, mupp3 = mu_pp
up1, up2, upp1, upp2 = image_coordinates = sympy.symbols("up1 up2 upp1 upp2")
y = homogeneous(point)


def of_bundle(factors: tuple[sympy.Symbol, ...], fourth: tuple[sympy.Symbol, ...]) -> Matrix:
    return M.subs(given((mu1, mu2, mu3, u31, u32), (*factors, *fourth)), simultaneous=True)


M_left, M_right = of_bundle(mu_p, u3_p), of_bundle(mu_pp, u3_pp)
HOMOLOGOUS = given(image_coordinates, (*inhomogeneous(M_left * y), *inhomogeneous(M_right * y)))
intersection = [
    coordinate * matrix.row(0).T - matrix.row(i).T
    for matrix, pair in ((M_left, (up1, up2)), (M_right, (upp1, upp2)))
    for i, coordinate in enumerate(pair, start=1)
]
section.identity(
    "2.4/2.3.4",
    "the four equations of a model point",
    where=HOMOLOGOUS,
    derived=Matrix.zeros(4, 1),
)
section.rank(
    "2.4/four-equations",
    "four equations for three unknown components",
    derived=rows(*intersection).xreplace(HOMOLOGOUS),
    kernel=[y],
)

# %% [markdown]
# One of the four equations is redundant, and three determine the point.  **Print.**  The table has the coefficients
# alone; the right sides are the image coordinates.

# %%
forms_of_point = [dot(form, y) for form in intersection]
section.identity(
    "table:2.3", "coefficients of relative reconstruction", derived=linear_system(forms_of_point, point)[0]
)
section.identity(
    "2.4/beyond/right-sides",
    "right sides of relative reconstruction",
    printed=-vector(*image_coordinates),
    derived=linear_system(forms_of_point, point)[1],
)

# %% [markdown]
# **How does the model lie in the object?**  The original bundles have parameters of their own.  Both become those of
# the relative model if they are divided by the same $\tau_j$.  The matrix that takes the model to the object is a
# core (1.5.2).  The model is affine to the object only if all $\tau_j$ are equal.

# %%
all_mu, tau = (mu0, mu1, mu2, mu3), sympy.symbols("tau:4")
section.identity(
    "2.4/transition",
    "with the basic points as control points the model is transformed by (1.5.2)",
    printed=M_star_any.subs({m: m / factor for m, factor in zip(all_mu, tau, strict=True)}, simultaneous=True)
    * core.subs(given(all_mu, tau), simultaneous=True),
    derived=M_star_any,
)

# %% [markdown]
# ### How many parameters do the images determine?
#
# Not all five.  The coplanarity of two rays, $\mathbf M' \mathbf y = \mu' \mathbf u'$ and $\mathbf M'' \mathbf y =
# \mu'' \mathbf u''$, is $\mathbf u'^T \mathbf C \mathbf u'' = 0$ with four-rowed minors for elements of $\mathbf C$.
# Up to its factor it changes with three combinations of the five.  The other two multiply both bundles by $\tau_1 =
# \tau_2$ and by $\tau_3$: the choice of $\mathbf y_A$ fixes them.


# %%
five = (mup2, mup3, *mu_pp)
C_of_five = minors_of_cameras(M_left.subs(mup1, mup2), M_right)
minors = vector(*C_of_five)
changes = columns(*(diff(minors, parameter) for parameter in five))
section.rank(
    "2.4/beyond/parameters",
    "the images alone determine three of the five parameters",
    printed=4,
    derived=columns(minors, changes),
    kernel=[vector(-2, mup2, 0, mupp1, mupp2, 0), vector(-1, 0, mup3, 0, 0, mupp3)],
)

# %% [markdown]
# The paper says that five parameters are necessary.  Of the six $\mu$, the intersection of rays determines three.

# %%
C_of_six = minors_of_cameras(M_left, M_right)
section.count(
    "2.4/five-parameters",
    "five parameters are necessary for relative orientation",
    derived=C_of_six.applyfunc(lambda element: over(element, C_of_six[1, 0])),
    variables=(*mu_p, *mu_pp),
    kernel=[
        vector(mup1, 0, 0, mupp1, 0, 0),
        vector(0, mup2, 0, 0, mupp2, 0),
        vector(0, 0, mup3, 0, 0, mupp3),
    ],
    expect="false",
    instead="2.4/beyond/parameters",
    note="Read as the number of parameters that the intersection of rays determines, for given images of G3.  Five is "
    "the number of conventional orientation, 2.2/conventional, and the number of mu that remain when one is "
    "assumed.",
    same_as="2.2/five-rays",
)

# %% [markdown]
# ### How many rays?
#
# The rays of the basic points meet whatever the parameters are.  Each further pair of homologous points $\mathbf u'$,
# $\mathbf u''$ gives one row $u'_i u''_j$ that the elements of $\mathbf C$ take to zero, and the changes of
# $\mathbf C$ that it does not allow.

# %%
fourth_left, fourth_right = (homogeneous(vector(*fourth)) for fourth in (u3_p, u3_pp))
section.identity(
    "2.4/four-rays",
    "the rays of the four basic points meet for all parameters",
    printed=Matrix.zeros(4, 1),
    derived=vector(
        *(dot(image, C_of_six * image) for image in (image_e0, image_e1, image_e2)),
        dot(fourth_left, C_of_six * fourth_right),
    ),
)


def homologous_row(index: int) -> Matrix:
    """Return the products of the coordinates of homologous points, of which u''_2 follows from C."""
    left = homogeneous(vector(*sympy.symbols(f"up{index}1 up{index}2")))
    first, second = sympy.symbols(f"upp{index}1 upp{index}2")
    coplanarity = dot(left, C_of_five * homogeneous(vector(first, second)))
    right = homogeneous(vector(first, solve(*linear_system([coplanarity], [second]))[0]))
    return Matrix(1, 9, [a * b for a in left for b in right])


# %% [markdown]
# After four rays three parameters are open.  One more ray gives one condition, three more give three.  So it takes
# seven.

# %%
further_rows = [homologous_row(index) for index in (4, 5, 6)]
section.rank(
    "2.4/five-rays",
    "a fifth ray determines the relative orientation",
    printed=3,
    derived=further_rows[0] * changes,
    expect="false",
    instead="2.4/beyond/seven-rays",
    note="The first sentence of the section, read of any five rays.  It is true of conventional orientation, "
    "2.2/conventional, and of the epipolar axis as fifth ray, whose two known images are four data: "
    "2.4/beyond/epipoles.",
    same_as="2.2/five-rays",
)
section.rank(
    "2.4/beyond/seven-rays",
    "seven rays determine the relative orientation",
    printed=3,
    derived=Matrix.vstack(*further_rows) * changes,
)

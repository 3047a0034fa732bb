# %% [markdown]
# # 3.4 Representation of output images
#
# The normal case coordinates are affine.  A device needs rectangular ones.  Which affine transformation gives them
# without vertical parallax?  The paper takes a frame of two pairs of parallel lines, epipolar lines and lines
# $\mathbf g_N$, for a rectangle with the sides 1.

# %%
import sympy

from algebroproj_derivations.figures import ImageDrawing
from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s1_6_optical_projection import parallel_through_origin
from algebroproj_derivations.fundamentals1996.s3_1_normal_case_transformation import (
    T,
    tau1,
    tau2,
)
from algebroproj_derivations.fundamentals1996.s3_2_normal_case import Z_N, z_n
from algebroproj_derivations.inserting import given
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    columns,
    cross,
    determinant,
    dot,
    homogeneous,
    inverse,
    linear_system,
    over,
    rows,
    solve,
    vector,
)

section = Section("fundamentals1996", "3.4", "Representation of output images")

# %%
un1, un2 = sympy.symbols("uN1 uN2")
u_normal = vector(un1, un2)
origin, unit1, unit2 = vector(0, 0), vector(1, 0), vector(0, 1)


def line_through(direction: Matrix, point: Matrix) -> Matrix:
    """Return the line of a family of parallels, given by its last two coefficients, through a point."""
    return vector(-dot(direction, point), *direction)


def equation(line: Matrix) -> sympy.Expr:
    return dot(line, homogeneous(u_normal))


# %% [markdown]
# ## The families of parallels
#
# **Definition.**  By (3.2.2) the coefficients $b_{N1} : b_{N2}$ of all epipolar lines are $1 : z_N$.  The line that
# $\mathbf T$ sends to infinity is $\mathbf g = \mathbf T^T (1, 0, 0)^T$.  Its coefficients refer to the coordinates
# of the *original* image.

# %%
at_infinity = vector(1, 0, 0)
any_epipolar_line = Z_N * homogeneous(vector(*sympy.symbols("uppN1 uppN2")))
epipolar_direction = vector(*any_epipolar_line[1:, 0])
g = T.T * at_infinity
g_direction = vector(*g[1:, 0])
constant_g, constant_h = sympy.symbols("gN0 hN0")

section.identity(
    "3.4/gN",
    "coefficients of the family of the vanishing line, as used",
    derived=vector(constant_g, *g_direction),
    note="The numbers are those of the vanishing line g, (1.6/g) with mu0 = 1, mu_i = tau_i.  As lines of the normal "
    "case plane they are not parallels to its vanishing line: 3.4/gN#parallels.",
)
section.identity(
    "3.4/hN", "the family of the epipolar lines", where={constant_h: any_epipolar_line[0]}, derived=any_epipolar_line
)

# %% [markdown]
# **Are they parallels to the vanishing line?**  In the normal case plane that line is the image of the line at
# infinity of $P$, $\mathbf g' = \mathbf T^{-T} (1, 0, 0)^T$, with $1/\tau_i - 1$ for $\tau_i - 1$.  So the printed
# coefficients are right for the coordinates $\mathbf u$ of the original image, and wrong for $\mathbf u_N$, for which
# the display uses them.  The rest of this section is checked with them all the same.

# %%
g_normal = inverse(T).T * at_infinity
g_origin = parallel_through_origin(g)
printed_family = vector(0, tau1 - 1, tau2 - 1)
section.up_to_scale(
    "3.4/gN#parallels",
    "the lines gN are parallels to the vanishing line of the normal case plane",
    printed=printed_family,
    derived=parallel_through_origin(g_normal),
    expect="false",
    instead="3.4/beyond/gN",
    note="No slip of print: Table 3.4, (3.4.1) and the matrix A'' of section 4 i (a21 = -0.333615) follow the printed "
    "coefficients.",
)
section.up_to_scale(
    "3.4/gN#original",
    "the same lines in the coordinates of the original image",
    printed=printed_family,
    derived=g_origin,
)
section.up_to_scale(
    "3.4/beyond/gN",
    "the parallel to the vanishing line in the normal case plane",
    printed=vector(0, 1 / tau1 - 1, 1 / tau2 - 1),
    derived=inverse(T).T * g_origin,
)

# %% [markdown]
# ## Right angles
#
# **Are the two families at right angles?**  The paper says so.  An image frame is rectangular if the affine
# coordinates of the device are declared to be.  The directions on the normal case plane are not at right angles.  Let
# the basic points have any positions in that plane, $\xi_3 = 0$, and let the center of projection be anywhere.  Then
# $P$ passes through the points $\mathbf y_0 + \tau_j (G_{Nj} - \mathbf y_0)$, and the base has the direction of the
# epipolar lines.

# %%
g_points = [vector(*sympy.symbols(f"gN{j}1 gN{j}2"), 0) for j in range(3)]
eye = vector(*sympy.symbols("c1 c2 c3"))
factors = (sympy.Integer(1), tau1, tau2)
P_points = [eye + factor * (point - eye) for point, factor in zip(g_points, factors, strict=True)]
P_normal = cross(P_points[1] - P_points[0], P_points[2] - P_points[0])
intersection = cross(P_normal, vector(0, 0, 1))


def metric_direction(direction: Matrix) -> Matrix:
    """Return the direction in space of the lines with the given last two coefficients."""
    return direction[1] * (g_points[1] - g_points[0]) - direction[0] * (g_points[2] - g_points[0])


section.identity(
    "3.4/right-angles",
    "the lines gN and hN form a right-angled frame",
    printed=0,
    derived=dot(metric_direction(g_direction), metric_direction(epipolar_direction)),
    expect="false",
    instead="3.4/beyond/right-angles",
    note="The parallels to the vanishing line of 3.4/beyond/gN are not at right angles to the epipolar lines either, "
    "in general.",
)

# %% [markdown]
# **What is true.**  The parallels to the vanishing line have the direction in which $P$ cuts the normal case plane.
# With them the frame has right angles exactly where this intersection is at right angles to the base.

# %%
section.up_to_scale(
    "3.4/beyond/right-angles",
    "the parallels to the vanishing line have the direction of the intersection of P and the normal case plane",
    printed=metric_direction(vector(1 / tau1 - 1, 1 / tau2 - 1)),
    derived=intersection,
)

# %% [markdown]
# ## The four lines
#
# **Definition.**  The frame consists of the epipolar lines through $G_{N0}$ and $G_{N1}$ and the lines of the other
# family through $G_{N0}$ and $G_{N2}$.

# %%
h_lines = [line_through(epipolar_direction, point) for point in (origin, unit1)]
g_lines = [line_through(g_direction, point) for point in (origin, unit2)]
section.reference(
    "3.4/ref-4.2",
    "figure of the frame lines",
    meant="3.4",
    note="There is no Fig. 4.2.",
)
for name, line in (
    ("hN0", h_lines[0]),
    ("hN1", h_lines[1]),
    ("gN0", g_lines[0]),
    ("gN2", g_lines[1]),
):
    section.identity(f"3.4/{name}", f"frame line {name}", derived=line)

# %% [markdown]
# **Where do they meet?**  Four corners follow.

# %%
delta = sympy.Symbol("delta")
DELTA_PRINTED = z_n * (tau1 - 1) - (tau2 - 1)


def meet(first: Matrix, second: Matrix) -> Matrix:
    return solve(*linear_system([equation(first), equation(second)], [un1, un2]))


corners = {
    "U0": meet(g_lines[0], h_lines[0]),
    "U1": meet(g_lines[0], h_lines[1]),
    "unit": meet(g_lines[1], h_lines[1]),
    "U2": meet(g_lines[1], h_lines[0]),
}
section.vanishing(
    "3.4/delta",
    "the lines intersect where delta is not zero",
    derived=determinant(rows(g_direction, epipolar_direction)),
)
for name, corner in corners.items():
    section.identity(
        f"table:3.4#{name}",
        f"corner {name} of the frame",
        where={delta: DELTA_PRINTED},
        derived=corner,
    )

# %% [markdown]
# **On what do the corners depend?**  On the three parameters that the sentence names, and on nothing else.  Of
# $\tau_1$ and $\tau_2$ only the quotient of $\tau_1 - 1$ and $\tau_2 - 1$ matters.

# %%
section.count(
    "3.4/exclusively",
    "of the parameters of the transformation the corners depend on no more than two quantities",
    printed=2,
    derived=vector(*(coordinate for corner in corners.values() for coordinate in corner)),
    variables=(tau1, tau2, z_n),
    kernel=[vector(tau1 - 1, tau2 - 1, 0)],
)

# %% [markdown]
# ## The affine transformation
#
# **Definition.**  $\mathbf A$ carries $U_0$, $U_1$, $U_2$ to $(0, 0)$, $(1, 0)$, $(0, 1)$: six linear equations for
# the last two rows.

# %%
a = Matrix(2, 3, sympy.symbols("a1:3(0:3)"))
a10, a11, a12, a20, a21, a22 = a
requirements = [
    row[0] + row[1] * corners[name][0] + row[2] * corners[name][1] - target[i]
    for i, row in enumerate((a[0, :], a[1, :]))
    for name, target in (("U0", origin), ("U1", unit1), ("U2", unit2))
]
solution = solve(*linear_system(requirements, list(a)))
elements = given(a, solution)
A = Matrix.vstack(Matrix([[1, 0, 0]]), a.xreplace(elements))
A

# %%

section.definition("3.4/A", "form of the affine transformation")
section.identity("3.4/a10", "no translation", derived=vector(elements[a10], elements[a20]))

# %% [markdown]
# **Print.**  The conditions at $U_1$ and $U_2$, multiplied by $\delta$, and what follows from them.

# %%
for row in (1, 2):
    for place in range(2):
        required = requirements[3 * (row - 1) + 1 + place].xreplace({a10: sympy.Integer(0), a20: sympy.Integer(0)})
        section.identity(
            f"3.4/equations#{row}{place + 1}",
            f"condition of row {row} at U{place + 1}",
            where={delta: DELTA_PRINTED},
            derived=DELTA_PRINTED * required,
        )
section.identity("3.4/a11,a12", "elements of the first row", derived=vector(elements[a11], elements[a12]))
section.identity("3.4/a21,a22", "elements of the second row", derived=vector(elements[a21], elements[a22]))

# %% [markdown]
# The matrix, the coordinates, and a control: the fourth corner was not used, and becomes the unit point.

# %%
section.identity("3.4.1#matrix", "matrix of the transformation to the output system", derived=A)
section.identity("3.4.1", "rectangular coordinates", derived=A * homogeneous(u_normal))
section.identity("3.4/control", "the fourth corner becomes the unit point", derived=A * homogeneous(corners["unit"]))

# %% [markdown]
# **An example.**  The frame of the left image, with $z_N$ and $\tau$ of section 4 f and g:

# %%
EXAMPLE = {z_n: sympy.Rational("0.1221364"), tau1: sympy.Rational("1.0063775"), tau2: sympy.Rational("1.0804274")}
A_example = A.xreplace(EXAMPLE).doit()
frame_points = {name: corner.xreplace(EXAMPLE).doit() for name, corner in corners.items()}
frame_lines = [line.xreplace(EXAMPLE) for line in (*h_lines, *g_lines)]
ImageDrawing(
    "The frame of two pairs of parallels in the left normal case image, and the rectangle that it becomes.",
    {
        "normal case": (frame_points, frame_lines),
        "output": (
            {name: (A_example * homogeneous(corner))[1:, :] for name, corner in frame_points.items()},
            [solve(A_example.T, line).doit() for line in frame_lines],
        ),
    },
)

# %% [markdown]
# **Are the corners needed?**  No.  The rows of $\mathbf A$ are the frame lines through the origin themselves, scaled
# to 1 at the basic point on the opposite side: $x_1 = \mathbf h_{N0}^T \mathbf u_N$ and $x_2 = \mathbf g_{N0}^T
# \mathbf u_N / (\tau_2 - 1)$.  The corners need $\delta$, the lines do not.


# %%
def scaled(line: Matrix, point: Matrix) -> Matrix:
    value = dot(line, homogeneous(point))
    return line.applyfunc(lambda entry: over(entry, value))


A_of_lines = rows(vector(1, 0, 0), scaled(h_lines[0], unit1), scaled(g_lines[0], unit2))
section.identity(
    "3.4/beyond/frame-lines",
    "the rows of the transformation are the frame lines through the origin",
    printed=A,
    derived=A_of_lines,
)

# %% [markdown]
# Where $\delta = 0$ the two families are parallel, and the frame degenerates.  $\tau_2 = 1$ is excluded as well, for
# then the line through $G_{N2}$ is the line through $G_{N0}$.

# %%
section.vanishing(
    "3.4/beyond/regular",
    "the frame degenerates where delta is zero",
    printed=(DELTA_PRINTED,),
    derived=determinant(A_of_lines),
)

# %% [markdown]
# ## No vertical parallax
#
# Left and right image have matrices $\mathbf A$ of their own, with the same $z_N$.  **Is $x'_1 = x''_1$?**  Under the
# condition (3.2.3) it is, for the first coordinate does not depend on $\tau$.

# %%
LEFT = given((un1, un2, tau1, tau2), sympy.symbols("upN1 upN2 taup1 taup2"))
RIGHT = given((un1, un2, tau1, tau2), sympy.symbols("uppN1 uppN2 taupp1 taupp2"))
x_left, x_right = ((A_of_lines * homogeneous(u_normal)).xreplace(side) for side in (LEFT, RIGHT))
section.identity(
    "3.4/x1",
    "the normal case condition in rectangular coordinates",
    derived=x_left[1],
    constraints=[dot(vector(1, z_n), vector(LEFT[un1] - RIGHT[un1], LEFT[un2] - RIGHT[un2]))],
    nonzero=[1 - side[tau2] for side in (LEFT, RIGHT)],
)
section.identity(
    "3.4/x1#condition",
    "the difference of the first coordinates is the normal case condition",
    derived=x_left[1] - x_right[1],
)

# %% [markdown]
# In which sense is the scale in the direction of $x_2$ arbitrary?  Another point $U_2$ on the same epipolar line,
# $k$ times as far from the origin, changes nothing but this scale.

# %%
k = sympy.Symbol("k")
stretched = [
    a[1, 0] + a[1, 1] * point[0] + a[1, 2] * point[1] - value
    for point, value in ((corners["U0"], 0), (corners["U1"], 0), (k * corners["U2"], 1))
]
section.identity(
    "3.4/scale",
    "another unit point on the horizontal axis changes the scale of the second coordinate",
    printed=a[1, :].xreplace(elements).T / k,
    derived=solve(*linear_system(stretched, list(a[1, :]))),
)

# %% [markdown]
# **Does that distort the model?**  No.  Whatever is done to the image by an affine transformation, the coordinates that
# refer to the images of the basic points are $\mathbf u_N$ again.  So the reconstruction is the same, and its
# transformation to the object as well.

# %%
unit_images = columns(image_e0, image_e1, image_e2)
output = Matrix([[1, 0, 0], *(sympy.symbols(f"b{i}0 b{i}1 b{i}2") for i in (1, 2))])
section.identity(
    "3.4/distortion",
    "an affine distortion of the output does not concern the model",
    printed=homogeneous(u_normal),
    derived=unit_images * solve(output * unit_images, output * homogeneous(u_normal)),
)

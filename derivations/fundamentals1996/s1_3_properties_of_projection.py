# %% [markdown]
# # 1.3 Properties of P*
#
# A camera sees four basic points.  Their images leave five numbers of it open: three parameters $\mu_1, \mu_2, \mu_3$
# and the image $\mathbf u_3$ of the fourth point.  Or is it the center $\mathbf y_0$ and $\mathbf u_3$?  This section
# goes from one description to the other.  It ends with the question when they fail.

# %%
import sympy

from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s1_2_determination_of_projection import B, M_star, P_star
from algebroproj_derivations.inserting import given
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    columns,
    determinant,
    homogeneous,
    inverse,
    linear_system,
    over,
    solve,
    vector,
)

section = Section("fundamentals1996", "1.3", "Properties of the matrix of projection")

# %%
DELTA = sympy.Symbol("Delta")

# %% [markdown]
# ## Where is the image of a point?
#
# **Definition.**  The quasihomogeneous image of $\mathbf y$ is $\mathbf M^* (1, \mathbf y)$ divided by its first
# component.

# %%
point = vector(y1, y2, y3)
image = M_star[:3, :] * homogeneous(point)
u_of_y = vector(over(image[1], image[0]), over(image[2], image[0]))
u_of_y

# %% [markdown]
# **Print.**  The paper has the same, with $y_0$ short for $1 - y_1 - y_2 - y_3$.

# %%
y0 = sympy.Symbol("y0")
section.identity("1.3.1", "affine image coordinates", where={y0: 1 - y1 - y2 - y3}, derived=u_of_y)

# %% [markdown]
# **Meaning.**  The coordinates are weighted means of the images of the basic points: $\mu_j$ is the weight that
# the camera gives to $G_j$.  A common factor of all weights cancels, so one of them may be made 1.

# %%
factor = sympy.Symbol("k")
section.identity(
    "1.3/factor",
    "a common factor of the matrix cancels out",
    printed=u_of_y,
    derived=u_of_y.subs({m: factor * m for m in (mu0, mu1, mu2, mu3)}, simultaneous=True),
)

# %% [markdown]
# The paper makes $p_{00} = \mu_0$ equal to 1.  But $p$ with two zeros is an element of $\mathbf P^*$, and it is
# $\mu_1 - \mu_0$.  What is made 1 is the factor of the image of the origin, the element $m_{00}$ of $\mathbf M^*$.

# %%
section.identity(
    "1.3/p00",
    "the component that is made 1",
    derived=(M_star * homogeneous(e0))[0],
    expect="misprint",
    corrected=M_star[0, 0],
    note="The scan alone cannot tell a slip of the scan from one of the print.",
)

# %% [markdown]
# Five numbers remain.  With the six coordinates of the images of $G_0, G_1, G_2$ they are the eleven parameters of a
# general projection (1.1/general).

# %%
section.count(
    "1.3/parameters",
    "of the parameters of the projection five are independent",
    printed=5,
    derived=vector(*(over(element, mu0) for element in M_star[:3, :])),
    variables=(mu0, mu1, mu2, mu3, u31, u32),
    kernel=[vector(mu0, mu1, mu2, mu3, 0, 0)],
)

# %% [markdown]
# ## The matrix and its inverse
#
# **Definition.**  From here on $\mu_0 = 1$.

# %%
P_star, M_star = P_star.subs(mu0, 1), M_star.subs(mu0, 1)
P_star

# %% [markdown]
# **Print.**

# %%
section.identity("1.3.2", "matrix of projection for mu0 = 1", derived=P_star)
section.structure(
    "1.3.2#structure",
    "the structure of the matrix",
    printed=Matrix(3, 3, sympy.symbols("p00 p01 p02 p10 zero p12 zero p21 p22")).subs(sympy.Symbol("zero"), 0),
    derived=P_star,
)

# %% [markdown]
# **When is there an inverse?**  The determinant decides.

# %%
Delta = determinant(P_star)
section.identity("1.3.3", "determinant of the matrix of projection", derived=Delta)
Delta

# %% [markdown]
# $\mathbf P \mathbf P^* = \mathbf E$ are nine linear equations for the nine elements of the matrix of reconstruction
# $\mathbf P$.  Their determinant vanishes with $\Delta$ and nowhere else.

# %%
unknown = Matrix(3, 3, sympy.symbols("x:3:3"))
section.vanishing(
    "1.3/PP*",
    "P P* = E determines the matrix of reconstruction except where the determinant vanishes",
    printed=(DELTA,),
    where={DELTA: Delta},
    derived=determinant(linear_system(list(unknown * P_star - E3), list(unknown))[0]),
)
P = inverse(P_star)
section.identity("1.3/P", "matrix of reconstruction in mu and u3", where={DELTA: Delta}, derived=P)

# %% [markdown]
# ## Where is the center?
#
# **Definition.**  The origin is projected to $G'_0$ with $\mu_0 = 1$, so that $\mathbf P^* \mathbf y_0 + \mathbf e'_0 =
# \mathbf 0$.  These are three linear equations for the center $\mathbf y_0$, and this is their solution.

# %%
center_equations = P_star * center + image_e0
system, right_side = linear_system(list(center_equations), list(center))
y0_of_mu = solve(system, right_side)
y0_of_mu

# %% [markdown]
# **Print.**  First the equations.  Each is compared as a linear form in $(1, y_{01}, y_{02}, y_{03})$, for an equation
# means the same after multiplication by $-1$.

# %%
for row in range(3):
    section.up_to_scale(
        f"1.3.4#{row + 1}",
        f"equation {row + 1} for the center of projection",
        derived=columns(-right_side, system)[row, :].T,
    )

# %% [markdown]
# The second and third equation give $y_{01}$ and $y_{02}$ in terms of $y_{03}$.

# %%
y01_of_y03 = solve(*linear_system([center_equations[1]], [y01]))[0]
y02_of_y03 = solve(*linear_system([center_equations[2]], [y02]))[0]
section.identity(
    "1.3/y01,y02#y03", "the first two components of the center, from the third", derived=vector(y01_of_y03, y02_of_y03)
)

# %% [markdown]
# Insertion into the first equation leaves $y_{03}$ alone.  The last bracket must be the coefficient $\mu_3 - 1$ of
# $y_{03}$ in (1.3.4).  The print repeats $\mu_2 - 1$, and goes on with the right one.

# %%
inserted = center_equations[0].subs({y01: y01_of_y03, y02: y02_of_y03}) - 1
braces = -u31 * (mu1 - 1) * mu3 / mu1 - u32 * (mu2 - 1) * mu3 / mu2
section.identity(
    "1.3/insertion",
    "the first equation after insertion",
    derived=inserted,
    expect="misprint",
    corrected=y03 * (braces + (mu3 - 1)),
    note="No exchange of the numbering makes it right.",
)
section.identity(
    "1.3/insertion#Delta",
    "the first equation after insertion, through the determinant",
    where={DELTA: Delta},
    derived=inserted,
)

# %% [markdown]
# The components of the center, as printed:

# %%
for name, component in (("y03", 2), ("y02", 1), ("y01", 0)):
    section.identity(f"1.3/{name}", f"center of projection, {name}", where={DELTA: Delta}, derived=y0_of_mu[component])

# %% [markdown]
# **Meaning.**  The center is the point that has no image: $\mathbf M^*$ takes it to zero.  Its four barycentric
# coordinates are proportional to $u_{30}\, \mu_1 \mu_2 \mu_3$, $u_{31}\, \mu_2 \mu_3$, $u_{32}\, \mu_1 \mu_3$ and
# $-\mu_1 \mu_2$.

# %%
at_mu = given(center, y0_of_mu)
section.identity(
    "1.3/from-1.1.7",
    "the center is annihilated by the singular matrix",
    printed=Matrix.zeros(4, 1),
    derived=M_star * homogeneous(y0_of_mu),
)
section.identity(
    "1.3/y00",
    "fourth barycentric coordinate of the center",
    where={DELTA: Delta, u30: BARYCENTRIC[u30], **at_mu},
    derived=vector(BARYCENTRIC[y00].subs(at_mu), 1 - sum(y0_of_mu)),
)

# %% [markdown]
# **An example.**  $\mu_1 = \mu_2 = 1/2$, $\mu_3 = 2/3$ and $\mathbf u_3 = (1/4, 1/8)$ put the center here, by the
# formula:

# %%
EXAMPLE = {mu1: "1/2", mu2: "1/2", mu3: "2/3", u31: "1/4", u32: "1/8"}
example_center = y0_of_mu.xreplace({symbol: sympy.Rational(value) for symbol, value in EXAMPLE.items()}).doit()
example_center

# %%
SpaceDrawing(
    "The center C of the example, the rays from it to the basic points, and the plane of G1, G2 and G3, in which the "
    "center must not lie.",
    {"C": example_center, "G0": e0, "G1": e1, "G2": e2, "G3": e3},
    segments=[("C", f"G{j}") for j in range(4)],
    triangles=[("G1", "G2", "G3")],
)

# %% [markdown]
# ## Which parameters belong to a center?
#
# The same three equations are linear in $\mu_1, \mu_2, \mu_3$ as well, when $\mathbf y_0$ and $\mathbf u_3$ are given.

# %%
parameter_system = linear_system(list(center_equations), [mu1, mu2, mu3])
mu_of_y0 = solve(*parameter_system)
at_center = given((mu1, mu2, mu3), mu_of_y0)
mu_of_y0

# %% [markdown]
# **Print.**  The paper adds the equations, which leaves $\mu_3$ alone.  In the sum the second and the third
# equation have the sign that they have in (1.3.4).

# %%
first_equation, second_equation, third_equation = center_equations
section.identity(
    "1.3/sum",
    "the sum of the equations contains the third parameter alone",
    printed=y00 + u30 * y03 * mu3,
    where=BARYCENTRIC,
    derived=first_equation - second_equation - third_equation,
)

# %%
section.identity("1.3.5#mu3", "third parameter", where=BARYCENTRIC, derived=mu_of_y0[2])
section.identity("1.3.5#mu2", "second parameter", where=BARYCENTRIC, derived=mu_of_y0[1])
section.identity("1.3.5#mu1", "first parameter", where=BARYCENTRIC, derived=mu_of_y0[0])

# %% [markdown]
# **Meaning.**  The determinant of this system is $y_{01} y_{02} y_{03} u_{30}$.  The center must not lie in a
# face of the basic tetrahedron through the origin, nor may the images of the other three basic points be
# collinear.

# %%
section.vanishing(
    "1.3/beyond/mu-from-center",
    "where the parameters cannot be had from the center",
    printed=(y01, y02, y03, u30),
    where=BARYCENTRIC,
    derived=determinant(parameter_system[0]),
)

# %% [markdown]
# ## The matrices as functions of center and fourth image
#
# Inserted into the matrix, the parameters give the second description.

# %%
P_star_of_y0 = P_star.subs(at_center)
P_star_of_y0

# %% [markdown]
# **Print.**  The scan has four entries in the first row of a matrix of three columns: it took differences of
# fractions for fractions of differences.

# %%
printed_scale = y00 / u30
section.identity(
    "1.3.6#row0",
    "matrix of projection in y0 and u3, first row",
    printed=None,
    where=BARYCENTRIC,
    derived=P_star_of_y0[0, :].T,
    expect="illegible",
    corrected=printed_scale * vector(u31 / y01 - u30 / y00, u32 / y02 - u30 / y00, -1 / y03 - u30 / y00),
    note="(u31 - u30)/y01 was read for u31/y01 - u30/y00, and the last entry was split in two.",
)
section.identity(
    "1.3.6#rows12",
    "matrix of projection in y0 and u3, second and third row",
    where=BARYCENTRIC,
    derived=P_star_of_y0[1:, :],
)

# %% [markdown]
# It depends on center and fourth image alone, and on all five of their coordinates.

# %%
section.count(
    "1.3/exclusively",
    "the matrix of projection depends on center and fourth image, and on all of their coordinates",
    printed=5,
    derived=P_star_of_y0,
    variables=(*center, *fourth_image),
)

# %% [markdown]
# The inverse takes an image point to the direction of its ray.

# %%
P_of_y0 = inverse(P_star_of_y0)
section.identity("1.3.7", "matrix of reconstruction in y0 and u3", where=BARYCENTRIC, derived=P_of_y0)

# %% [markdown]
# The base follows, but for a common factor: with $\mu_0$ left free, $\mathbf P^*$ and $\mathbf B^*$ carry it.

# %%
section.identity("1.3/B*", "the contravariant base from P*", printed=U * P_star, derived=inverse(P * inverse(U)))
section.identity("1.3/B", "the base from P*", printed=inverse(U * P_star), derived=P * inverse(U))

# %%
section.identity(
    "1.3/B#U*",
    "the base from the matrix of reconstruction",
    derived=(B * U) * Matrix([[1, 1, 1], [0, 1, 0], [0, 0, 1]]),
)
section.up_to_scale(
    "1.3/B#scale",
    "the base is determined but for a common factor",
    printed=P * inverse(U),
    derived=inverse(U * (factor * P_star)),
)

# %% [markdown]
# ## When is the matrix regular?
#
# **The paper's answer.**  It takes $\mathbf y_0$ and $\mathbf u_3$ as independent.  In these terms the determinant is

# %%
Delta_of_y0 = Delta.subs(at_center)
Delta_of_y0

# %% [markdown]
# and (1.3.8) is right: it vanishes exactly where $u_{31} u_{32} y_{00} = 0$.  The divisors $u_{30}, y_{01}, y_{02},
# y_{03}$ are poles, about which the restrictions a) and b) say nothing.

# %%
section.identity("1.3.8", "determinant in y0 and u3", where=BARYCENTRIC, derived=Delta_of_y0)
section.vanishing(
    "1.3/a,b", "restrictions a) and b), for y0 and u3 as independent variables", where=BARYCENTRIC, derived=Delta_of_y0
)

# %% [markdown]
# ### In the image
#
# A vanishing coordinate of $\mathbf u_3$ means three collinear image points.  Restriction a) speaks of $G'_1$ and
# $G'_2$ "respectively".  As two lines through $G'_0$ it is right.

# %%
section.vanishing(
    "1.3/a#collinear-u31",
    "G'3 is collinear with G'0 and G'2 where u31 = 0",
    printed=(u31,),
    derived=determinant(columns(image_e0, image_e2, image_e3)),
    note="Favourable reading of restriction a); the words as they stand are 1.3/a#literal.",
)
section.vanishing(
    "1.3/a#collinear-u32",
    "G'3 is collinear with G'0 and G'1 where u32 = 0",
    printed=(u32,),
    derived=determinant(columns(image_e0, image_e1, image_e3)),
    note="Favourable reading of restriction a); the words as they stand are 1.3/a#literal.",
)

# %% [markdown]
# As it stands it is false: with $G'_1$ and $G'_2$ the image of $G_3$ is collinear where $u_{30} = 0$.

# %%
section.vanishing(
    "1.3/a#literal",
    "G'3 is collinear with G'1 and G'2 where u31 u32 = 0",
    printed=(u31, u32),
    derived=determinant(columns(image_e1, image_e2, image_e3)),
    expect="false",
    instead="1.3/beyond/collinear-u30",
    note="The words as they stand.  Favourable reading, with 'respectively' as two lines through G'0: "
    "1.3/a#collinear-u31 and 1.3/a#collinear-u32.",
)
section.vanishing(
    "1.3/beyond/collinear-u30",
    "G'3 is collinear with G'1 and G'2 where u30 = 0",
    printed=(u30,),
    where=BARYCENTRIC,
    derived=determinant(columns(image_e1, image_e2, image_e3)),
)

# %% [markdown]
# ### In space
#
# A vanishing coordinate of $\mathbf y_0$ means four coplanar object points.

# %%
section.vanishing(
    "1.3/a#coplanar-y02",
    "G3 lies in the plane G0, O, G1 where y02 = 0",
    printed=(y02,),
    derived=determinant(columns(*map(homogeneous, (e0, center, e1, e3)))),
)
section.vanishing(
    "1.3/a#coplanar-y01",
    "G3 lies in the plane G0, O, G2 where y01 = 0",
    printed=(y01,),
    derived=determinant(columns(*map(homogeneous, (e0, center, e2, e3)))),
)
section.vanishing(
    "1.3/b#plane",
    "the center lies in the plane of G1, G2, G3 where y00 = 0",
    where=BARYCENTRIC,
    derived=determinant(columns(*map(homogeneous, (center, e1, e2, e3)))),
)

# %% [markdown]
# ### But center and fourth image are not independent
#
# Both follow from $\mu$ and $\mathbf u_3$.  As polynomials the four coordinates of $\Delta\, \mathbf y_0$ share their
# factors with $\mathbf u_3$.  Where $u_{31} = 0$ the center lies in the plane $y_1 = 0$ *as well*: (1.3.8) reads
# $0/0$, and $\mathbf P^*$ stays regular.

# %%
section.identity(
    "1.3/beyond/dependence",
    "center and fourth image vanish together",
    printed=vector(u31 * mu2 * mu3, u32 * mu1 * mu3, -mu1 * mu2, u30 * mu1 * mu2 * mu3),
    where=BARYCENTRIC,
    derived=vector(*(Delta * coordinate for coordinate in (*y0_of_mu, 1 - sum(y0_of_mu)))),
)

# %% [markdown]
# So the restrictions, read as conditions for a regular $\mathbf P^*$, are false: none of them is necessary.

# %%
section.identity(
    "1.3/a#mu-u31",
    "P* is singular where u31 = 0",
    printed=0,
    derived=Delta,
    constraints=[u31],
    nonzero=[mu1, mu2, mu3],
    expect="false",
    instead="1.3/beyond/parallel-projection",
    note="The restriction as a condition on P*, on whose regularity all relations of the section depend.",
    follows="A camera that sees G3 on the line of G0 and G2, or whose center lies in the plane of G1, G2 and G3, need "
    "not be excluded: its matrix can be inverted. Only the formulas in y0 and u3 fail.",
)
section.identity(
    "1.3/a#mu-u32",
    "P* is singular where u32 = 0",
    printed=0,
    derived=Delta,
    constraints=[u32],
    nonzero=[mu1, mu2, mu3],
    expect="false",
    instead="1.3/beyond/parallel-projection",
    same_as="1.3/a#mu-u31",
)

# %% [markdown]
# The plane of $G_1, G_2, G_3$ goes through the center exactly where their images are collinear, $u_{30} = 0$.  There
# the parameters cannot be had from (1.3.5), but $\mathbf P^*$ is regular.

# %%
section.identity(
    "1.3/b#mu",
    "P* is singular where the center lies in the plane of G1, G2, G3",
    printed=0,
    derived=Delta,
    constraints=[1 - sum(y0_of_mu)],
    nonzero=[mu1, mu2, mu3],
    witness={u31: 2, u32: -1},
    expect="false",
    instead="1.3/beyond/parallel-projection",
    same_as="1.3/a#mu-u31",
)

# %% [markdown]
# ### What is true
#
# The homogeneous center spans the kernel of $\mathbf M^*$.  Its components are the signed minors of three rows:


# %%
def without_column(matrix: Matrix, column: int) -> Matrix:
    return columns(*(matrix.col(j) for j in range(matrix.shape[1]) if j != column))


homogeneous_center = vector(*((-1) ** j * determinant(without_column(M_star[:3, :], j)) for j in range(4)))
section.identity(
    "1.3/beyond/homogeneous-center",
    "the homogeneous center spans the kernel of M*",
    printed=Matrix.zeros(4, 1),
    derived=M_star * homogeneous_center,
)
homogeneous_center

# %% [markdown]
# $\Delta$ is the first component.  The matrix is singular exactly where the center is at infinity: for parallel
# projection, and for nothing else.

# %%
section.vanishing(
    "1.3/beyond/parallel-projection",
    "P* is singular exactly where the center is at infinity",
    printed=(homogeneous_center[0],),
    derived=Delta,
)

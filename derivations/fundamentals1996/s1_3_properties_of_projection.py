# %% [markdown]
# # 1.3 Properties of P*
#
# With $\mu_0 = 1$ the matrix of projection depends on $\mu_1, \mu_2, \mu_3$ and $\mathbf u_3$, or as well on the center
# $\mathbf y_0$ and $\mathbf u_3$.  This section goes from one description to the other, inverts the matrix, and asks
# when it is regular.

# %%
import sympy

from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s1_2_determination_of_projection import B, M_star, P_star
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

# %% [markdown]
# ## Image coordinates
#
# The quasihomogeneous image of $\mathbf y$ is $\mathbf M^* (1, \mathbf y)$ divided by its first component.  Here, and
# only here, $y_0$ is short for $1 - y_1 - y_2 - y_3$.

# %%
point = vector(y1, y2, y3)
y0 = sympy.Symbol("y0")
image = M_star[:3, :] * homogeneous(point)
u_of_y = vector(over(image[1], image[0]), over(image[2], image[0]))

printed_denominator = y0 * mu0 + y1 * mu1 + y2 * mu2 + y3 * mu3
section.identity(
    "1.3.1",
    "affine image coordinates",
    printed=vector(
        (y1 * mu1 + y3 * u31 * mu3) / printed_denominator,
        (y2 * mu2 + y3 * u32 * mu3) / printed_denominator,
    ),
    where={y0: 1 - y1 - y2 - y3},
    derived=u_of_y,
)

factor = sympy.Symbol("k")
section.identity(
    "1.3/factor",
    "a common factor of the matrix cancels out",
    printed=u_of_y,
    derived=u_of_y.subs({m: factor * m for m in (mu0, mu1, mu2, mu3)}, simultaneous=True),
    note="The derived side has every mu_j multiplied by k: division by one component of P* changes mu alone.",
)
section.identity(
    "1.3/p00",
    "the component that is made 1",
    printed=P_star[0, 0],
    derived=(M_star * homogeneous(e0))[0],
    expect="misprint",
    corrected=M_star[0, 0],
    note="The print has p00 = mu0, but p with two zeros is an element of P*, mu1 - mu0.  Derived is the factor of the "
    "image of the origin, which is made 1; it is the element m00 of M*.  The scan alone cannot tell a slip of the scan "
    "from one of the print.",
)
section.count(
    "1.3/parameters",
    "of the parameters of the projection five are independent",
    printed=5,
    derived=vector(*(over(element, mu0) for element in M_star[:3, :])),
    variables=(mu0, mu1, mu2, mu3, u31, u32),
    kernel=[vector(mu0, mu1, mu2, mu3, 0, 0)],
    note="That mu0 may be made 1, as a count: mu1, mu2, mu3, u31 and u32 remain.  With the six coordinates of the "
    "images of G0, G1, G2 they are the eleven of 1.1/general.",
)

# %% [markdown]
# ## The matrix, its determinant and its inverse

# %%
P_star = P_star.subs(mu0, 1)
M_star = M_star.subs(mu0, 1)
Delta = determinant(P_star)
P = inverse(P_star)
DELTA = sympy.Symbol("Delta")

section.identity(
    "1.3.2",
    "matrix of projection for mu0 = 1",
    printed=Matrix([[mu1 - 1, mu2 - 1, mu3 - 1], [mu1, 0, u31 * mu3], [0, mu2, u32 * mu3]]),
    derived=P_star,
)
section.structure(
    "1.3.2#structure",
    "the structure of the matrix",
    printed=Matrix(3, 3, sympy.symbols("p00 p01 p02 p10 zero p12 zero p21 p22")).subs(sympy.Symbol("zero"), 0),
    derived=P_star,
)
section.identity(
    "1.3.3",
    "determinant of the matrix of projection",
    printed=mu1 * mu2 * (mu3 - 1) - u31 * (mu1 - 1) * mu2 * mu3 - u32 * mu1 * (mu2 - 1) * mu3,
    derived=Delta,
)
unknown = Matrix(3, 3, sympy.symbols("x:3:3"))
section.vanishing(
    "1.3/PP*",
    "P P* = E determines the matrix of reconstruction except where the determinant vanishes",
    printed=(DELTA,),
    where={DELTA: Delta},
    derived=determinant(linear_system(list(unknown * P_star - E3), list(unknown))[0]),
    note="Derived is the determinant of the nine linear equations for the nine elements of P.",
)
section.identity(
    "1.3/P",
    "matrix of reconstruction in mu and u3",
    printed=Matrix(
        [
            [-mu2 * mu3 * u31, mu2 * (mu3 - 1) - (mu2 - 1) * mu3 * u32, (mu2 - 1) * mu3 * u31],
            [-mu1 * mu3 * u32, (mu1 - 1) * mu3 * u32, mu1 * (mu3 - 1) - (mu1 - 1) * mu3 * u31],
            [mu1 * mu2, -(mu1 - 1) * mu2, -mu1 * (mu2 - 1)],
        ]
    )
    / DELTA,
    where={DELTA: Delta},
    derived=P,
)

# %% [markdown]
# ## The center of projection
#
# The origin is projected to $G'_0$ with $\mu_0 = 1$: $\mathbf P^* \mathbf y_0 + \mathbf e'_0 = \mathbf 0$, three
# equations for $\mathbf y_0$.  Each is compared with the printed one as a linear form in $(1, y_{01}, y_{02}, y_{03})$,
# for an equation means the same after multiplication by $-1$.

# %%
center_equations = P_star * center + image_e0
system, right_side = linear_system(list(center_equations), list(center))
forms = columns(-right_side, system)
y0_of_mu = solve(system, right_side)

printed_forms = (
    vector(1, mu1 - 1, mu2 - 1, mu3 - 1),
    vector(0, -mu1, 0, -u31 * mu3),
    vector(0, 0, -mu2, -u32 * mu3),
)
for row, printed_form in enumerate(printed_forms):
    section.up_to_scale(
        f"1.3.4#{row + 1}",
        f"equation {row + 1} for the center of projection",
        printed=printed_form,
        derived=forms[row, :].T,
    )

# %% [markdown]
# The second and third equation give $y_{01}$ and $y_{02}$ in terms of $y_{03}$; the first equation then gives $y_{03}$.

# %%
y01_of_y03 = solve(*linear_system([center_equations[1]], [y01]))[0]
y02_of_y03 = solve(*linear_system([center_equations[2]], [y02]))[0]
section.identity(
    "1.3/y01,y02#y03",
    "the first two components of the center, from the third",
    printed=vector(-u31 * mu3 / mu1 * y03, -u32 * mu3 / mu2 * y03),
    derived=vector(y01_of_y03, y02_of_y03),
)

inserted = center_equations[0].subs({y01: y01_of_y03, y02: y02_of_y03}) - 1
braces = -u31 * (mu1 - 1) * mu3 / mu1 - u32 * (mu2 - 1) * mu3 / mu2
section.identity(
    "1.3/insertion",
    "the first equation after insertion",
    printed=y03 * (braces + (mu2 - 1)),
    derived=inserted,
    expect="misprint",
    corrected=y03 * (braces + (mu3 - 1)),
    note="The last bracket is the coefficient of y03 in (1.3.4), mu_3 - 1; the print repeats mu_2 - 1.  No exchange of "
    "the numbering makes it right, and the next expression of the same line needs mu_3 - 1.",
)
section.identity(
    "1.3/insertion#Delta",
    "the first equation after insertion, through the determinant",
    printed=y03 / (mu1 * mu2) * DELTA,
    where={DELTA: Delta},
    derived=inserted,
)
for name, component, printed_component in (
    ("y03", 2, -mu1 * mu2 / DELTA),
    ("y02", 1, u32 * mu3 * mu1 / DELTA),
    ("y01", 0, u31 * mu2 * mu3 / DELTA),
):
    section.identity(
        f"1.3/{name}",
        f"center of projection, {name}",
        printed=printed_component,
        where={DELTA: Delta},
        derived=y0_of_mu[component],
    )
section.identity(
    "1.3/from-1.1.7",
    "the center is annihilated by the singular matrix",
    printed=Matrix.zeros(4, 1),
    derived=M_star * homogeneous(y0_of_mu),
)
at_mu = dict(zip(center, y0_of_mu, strict=True))
section.identity(
    "1.3/y00",
    "fourth barycentric coordinate of the center",
    printed=vector(1 - y01 - y02 - y03, u30 * mu1 * mu2 * mu3 / DELTA),
    where={DELTA: Delta, u30: BARYCENTRIC[u30], **at_mu},
    derived=vector(BARYCENTRIC[y00].subs(at_mu), 1 - sum(y0_of_mu)),
)

# %% [markdown]
# ## The parameters from the center
#
# The same three equations are linear in $\mu_1, \mu_2, \mu_3$ when $\mathbf y_0$ and $\mathbf u_3$ are given.  The
# determinant of that system is $y_{01} y_{02} y_{03} u_{30}$: these four factors must not vanish.

# %%
parameter_system = linear_system(list(center_equations), [mu1, mu2, mu3])
mu_of_y0 = solve(*parameter_system)
at_center = dict(zip((mu1, mu2, mu3), mu_of_y0, strict=True))

first_equation, second_equation, third_equation = center_equations
section.identity(
    "1.3/sum",
    "the sum of the equations contains the third parameter alone",
    printed=y00 + u30 * y03 * mu3,
    where=BARYCENTRIC,
    derived=first_equation - second_equation - third_equation,
    note="The sum is that of (1.3.4) as printed, where the second and the third equation have the opposite sign.",
)
section.identity("1.3.5#mu3", "third parameter", printed=-y00 / (u30 * y03), where=BARYCENTRIC, derived=mu_of_y0[2])
section.identity(
    "1.3.5#mu2", "second parameter", printed=u32 * y00 / (u30 * y02), where=BARYCENTRIC, derived=mu_of_y0[1]
)
section.identity(
    "1.3.5#mu1", "first parameter", printed=u31 * y00 / (u30 * y01), where=BARYCENTRIC, derived=mu_of_y0[0]
)
section.vanishing(
    "1.3/beyond/mu-from-center",
    "where the parameters cannot be had from the center",
    printed=(y01, y02, y03, u30),
    where=BARYCENTRIC,
    derived=determinant(parameter_system[0]),
    note="Not in the paper: the center must not lie in a face of the basic tetrahedron through the origin, nor may the "
    "images of the other three basic points be collinear.",
)

# %% [markdown]
# ## The matrices as functions of center and fourth image

# %%
P_star_of_y0 = P_star.subs(at_center)
P_of_y0 = inverse(P_star_of_y0)

printed_scale = y00 / u30
section.identity(
    "1.3.6#row0",
    "matrix of projection in y0 and u3, first row",
    printed=None,
    where=BARYCENTRIC,
    derived=P_star_of_y0[0, :].T,
    expect="illegible",
    corrected=printed_scale * vector(u31 / y01 - u30 / y00, u32 / y02 - u30 / y00, -1 / y03 - u30 / y00),
    note="The scan has four entries in this row of a matrix of three columns: differences of fractions were read as "
    "fractions of differences, (u31 - u30)/y01 for u31/y01 - u30/y00, and the last entry was split in two.",
)
section.identity(
    "1.3.6#rows12",
    "matrix of projection in y0 and u3, second and third row",
    printed=printed_scale * Matrix([[u31 / y01, 0, -u31 / y03], [0, u32 / y02, -u32 / y03]]),
    where=BARYCENTRIC,
    derived=P_star_of_y0[1:, :],
)
section.count(
    "1.3/exclusively",
    "the matrix of projection depends on center and fourth image, and on all of their coordinates",
    printed=5,
    derived=P_star_of_y0,
    variables=(*center, *fourth_image),
)
section.identity(
    "1.3.7",
    "matrix of reconstruction in y0 and u3",
    printed=Matrix(
        [
            [
                -y01,
                y01 / (u31 * y00) * (y00 * (1 - u32) + u30 * (y02 + y03)),
                y01 / (u32 * y00) * (u32 * y00 - u30 * y02),
            ],
            [
                -y02,
                y02 / (u31 * y00) * (u31 * y00 - u30 * y01),
                y02 / (u32 * y00) * (y00 * (1 - u31) + u30 * (y01 + y03)),
            ],
            [
                -y03,
                y03 / (u31 * y00) * (u31 * y00 - u30 * y01),
                y03 / (u32 * y00) * (u32 * y00 - u30 * y02),
            ],
        ]
    ),
    where=BARYCENTRIC,
    derived=P_of_y0,
    note="Read as y where the scan shows a script J, throughout (1.3.6) to (1.3.8).",
)

# %% [markdown]
# The base follows, but for a common factor: with $\mu_0$ left free, $\mathbf P^*$ and $\mathbf B^*$ carry it.

# %%
section.identity("1.3/B*", "the contravariant base from P*", printed=U * P_star, derived=inverse(P * inverse(U)))
section.identity("1.3/B", "the base from P*", printed=inverse(U * P_star), derived=P * inverse(U))
section.identity(
    "1.3/B#U*",
    "the base from the matrix of reconstruction",
    printed=B,
    derived=(B * U) * Matrix([[1, 1, 1], [0, 1, 0], [0, 0, 1]]),
)
section.up_to_scale(
    "1.3/B#scale",
    "the base is determined but for a common factor",
    printed=P * inverse(U),
    derived=inverse(U * (factor * P_star)),
)

# %% [markdown]
# ## Regularity
#
# (1.3.8) takes $\mathbf y_0$ and $\mathbf u_3$ as independent, and in these terms the two restrictions are right: the
# determinant vanishes exactly where $u_{31} u_{32} y_{00} = 0$.

# %%
Delta_of_y0 = Delta.subs(at_center)
section.identity(
    "1.3.8",
    "determinant in y0 and u3",
    printed=-u31 * u32 * y00**2 / (u30**2 * y01 * y02 * y03),
    where=BARYCENTRIC,
    derived=Delta_of_y0,
)
section.vanishing(
    "1.3/a,b",
    "restrictions a) and b), for y0 and u3 as independent variables",
    printed=(u31, u32, y00),
    where=BARYCENTRIC,
    derived=Delta_of_y0,
    note="Poles apart: u30, y01, y02 and y03 are divisors of (1.3.8), about which the restrictions say nothing.",
)

# %% [markdown]
# The geometry of the restrictions.  A vanishing coordinate means three collinear image points, or four coplanar
# object points.

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
    note="Not in the paper.",
)
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
    printed=(y00,),
    where=BARYCENTRIC,
    derived=determinant(columns(*map(homogeneous, (center, e1, e2, e3)))),
)

# %% [markdown]
# But center and fourth image are not independent: both follow from $\mu$ and $\mathbf u_3$, by
# $y_{01} \Delta = u_{31} \mu_2 \mu_3$, and so on.  Where $u_{31} = 0$ the center lies in the plane
# $y_1 = 0$ *as well*, and (1.3.8) reads $0/0$ while $\mathbf P^*$ stays regular.  As conditions for the regularity of
# $\mathbf P^*$ the restrictions are false: none of them is necessary.

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
    note="The same finding as 1.3/a#mu-u31, for the other coordinate.",
    same_as="1.3/a#mu-u31",
)
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
    note="The plane of G1, G2, G3 goes through the center exactly where their images are collinear, u30 = 0: there the "
    "parameters cannot be had from (1.3.5), but P* is regular.",
    same_as="1.3/a#mu-u31",
)
section.identity(
    "1.3/beyond/dependence",
    "center and fourth image vanish together",
    printed=vector(u31 * mu2 * mu3, u32 * mu1 * mu3, -mu1 * mu2, u30 * mu1 * mu2 * mu3),
    where=BARYCENTRIC,
    derived=vector(*(Delta * coordinate for coordinate in (*y0_of_mu, 1 - sum(y0_of_mu)))),
    note="Not in the paper: Delta y0 as polynomials, which is why (1.3.8) hides regular matrices behind 0/0.",
)

# %% [markdown]
# What is true of $\Delta$ as a function of $\mu$ and $\mathbf u_3$: the homogeneous center, the kernel of
# $\mathbf M^*$, is $(\Delta, u_{31} \mu_2 \mu_3, u_{32} \mu_1 \mu_3, -\mu_1 \mu_2)$.  $\mathbf P^*$ is singular
# exactly where the center is at infinity: for parallel projection.


# %%
def without_column(matrix: Matrix, column: int) -> Matrix:
    return columns(*(matrix.col(j) for j in range(matrix.shape[1]) if j != column))


homogeneous_center = vector(*((-1) ** j * determinant(without_column(M_star[:3, :], j)) for j in range(4)))
section.identity(
    "1.3/beyond/homogeneous-center",
    "the homogeneous center spans the kernel of M*",
    printed=Matrix.zeros(4, 1),
    derived=M_star * homogeneous_center,
    note="Not in the paper: the components are the signed minors of the three rows.",
)
section.vanishing(
    "1.3/beyond/parallel-projection",
    "P* is singular exactly where the center is at infinity",
    printed=(homogeneous_center[0],),
    derived=Delta,
    note="Not in the paper: this is what regularity means in terms of mu and u3.  Restrictions a) and b) concern the "
    "description by y0 and u3, which fails where the center lies in a face of the basic tetrahedron.",
)

# %% [markdown]
# ## Code
#
# Center and image enter through the barycentric abbreviations $y_{00}$ and $u_{30}$.  In differences such as
# $u_{31} y_{00} - u_{30} y_{01}$ the product $u_{31} y_{01}$ cancels; left in, it costs any number of digits where it
# is large.  The forms below have it taken out, and keep what remains, $a_j = y_{00} + y_{0j}$ and
# $b_j = u_{30} + u_{3j}$, common to numerator and denominator, where the rounding of one offsets the other.

# %%
A1, A2, B1, B2, W1, W2, N1, N2 = sympy.symbols("a1 a2 b1 b2 w1 w2 n1 n2")
D, D1, D2 = sympy.symbols("delta d1 d2")
SHARED = {A1: 1 - y02 - y03, A2: 1 - y01 - y03, B1: 1 - u32, B2: 1 - u31}
DIFFERENCES = SHARED | {W1: u31 * A1 - B1 * y01, W2: u32 * A2 - B2 * y02}
with_center = {"arguments": {"y0": center, "u3": fourth_image}, "describe": {"y0": ABOUT_Y0, "u3": ABOUT_U3}}
with_mu = {"arguments": {"mu": mu, "u3": fourth_image}, "describe": {"mu": ABOUT_MU, "u3": ABOUT_U3}}
EXAMPLE_CENTER = {"y0": ("-1.0679613", "-0.2268166", "4.1115155"), "u3": ("0.2718578", "0.0577379")}
EXAMPLE_MU = {"mu": ("0.625", "0.75", "0.5"), "u3": ("0.25", "0.125")}

section.kernel(
    "projection.mu_from_center",
    "Projective parameters from the center of projection.",
    **with_center,
    derived=mu_of_y0,
    form=vector(u31 * y00 / (u30 * y01), u32 * y00 / (u30 * y02), -y00 / (u30 * y03)),
    where=BARYCENTRIC,
    claims=["1.3.5#mu1", "1.3.5#mu2", "1.3.5#mu3"],
    example=EXAMPLE_CENTER,
    jacobian=True,
)
delta = mu1 * mu2 * (mu3 - 1) - mu3 * (u31 * mu2 * (mu1 - 1) + u32 * mu1 * (mu2 - 1))
section.kernel(
    "projection.center_from_mu",
    "Center of projection from the projective parameters.",
    **with_mu,
    derived=y0_of_mu,
    form=vector(u31 * mu2 * mu3 / D, u32 * mu1 * mu3 / D, -mu1 * mu2 / D),
    where={D: delta},
    claims=["1.3/y01", "1.3/y02", "1.3/y03"],
    example=EXAMPLE_MU,
)
section.kernel(
    "projection.projection_matrix",
    "Matrix of projection P* from the center of projection.",
    **with_center,
    derived=P_star_of_y0,
    form=Matrix(
        [
            [
                W1 / ((B1 - u31) * y01),
                W2 / ((B2 - u32) * y02),
                ((u31 + u32) * y03 - (1 - y01 - y02)) / ((1 - (u31 + u32)) * y03),
            ],
            [u31 * y00 / (u30 * y01), 0, -u31 * y00 / (u30 * y03)],
            [0, u32 * y00 / (u30 * y02), -u32 * y00 / (u30 * y03)],
        ]
    ),
    where=BARYCENTRIC | DIFFERENCES,
    alternatives=[
        {
            "form": Matrix(
                [
                    [
                        (u31 * y00 - u30 * y01) / (u30 * y01),
                        (u32 * y00 - u30 * y02) / (u30 * y02),
                        -(y00 + u30 * y03) / (u30 * y03),
                    ],
                    [u31 * y00 / (u30 * y01), 0, -u31 * y00 / (u30 * y03)],
                    [0, u32 * y00 / (u30 * y02), -u32 * y00 / (u30 * y03)],
                ]
            ),
            "where": BARYCENTRIC,
        },
    ],
    claims=["1.3.6#row0", "1.3.6#rows12"],
    example=EXAMPLE_CENTER,
    jacobian=True,
)
section.kernel(
    "projection.projection_matrix_from_mu",
    "Matrix of projection P* from the projective parameters.",
    **with_mu,
    derived=P_star,
    claims=["1.3.2"],
    example=EXAMPLE_MU,
)
section.kernel(
    "projection.projection_determinant",
    "Determinant of the matrix of projection from the center of projection.",
    **with_center,
    derived=Delta_of_y0,
    form=-u31 * u32 * y00**2 / (u30**2 * y01 * y02 * y03),
    where=BARYCENTRIC,
    claims=["1.3.8"],
    example=EXAMPLE_CENTER,
)
section.kernel(
    "projection.projection_determinant_from_mu",
    "Determinant of the matrix of projection from the projective parameters.",
    **with_mu,
    derived=Delta,
    form=delta,
    claims=["1.3.3"],
    example=EXAMPLE_MU,
)
section.kernel(
    "projection.reconstruction_matrix",
    "Matrix of reconstruction P from the center of projection.",
    **with_center,
    derived=P_of_y0,
    form=Matrix(
        [
            [-y01, y01 * (B1 * (1 - y01) - u31 * (y02 + y03)) / D1, y01 * W2 / D2],
            [-y02, y02 * W1 / D1, y02 * (B2 * (1 - y02) - u32 * (y01 + y03)) / D2],
            [-y03, y03 * W1 / D1, y03 * W2 / D2],
        ]
    ),
    where=DIFFERENCES | {D1: u31 * (A1 - y01), D2: u32 * (A2 - y02)},
    alternatives=[
        {
            "form": Matrix(
                [
                    [-y01, y01 * (D1 + u30 * (1 - y01)) / D1, y01 * W2 / D2],
                    [-y02, y02 * W1 / D1, y02 * (D2 + u30 * (1 - y02)) / D2],
                    [-y03, y03 * W1 / D1, y03 * W2 / D2],
                ]
            ),
            "where": BARYCENTRIC | {D1: u31 * y00, D2: u32 * y00, W1: D1 - u30 * y01, W2: D2 - u30 * y02},
        },
    ],
    claims=["1.3.7"],
    example=EXAMPLE_CENTER,
)
section.kernel(
    "projection.reconstruction_matrix_from_mu",
    "Matrix of reconstruction P from the projective parameters.",
    **with_mu,
    derived=P,
    form=Matrix(
        [
            [-mu2 * mu3 * u31 / D1, N1 / D1, (mu2 - 1) * mu3 * u31 / D1],
            [-mu1 * mu3 * u32 / D1, (mu1 - 1) * mu3 * u32 / D1, N2 / D2],
            [mu1 * mu2 / D1, -(mu1 - 1) * mu2 / D1, -mu1 * (mu2 - 1) / D1],
        ]
    ),
    where={
        N1: mu2 * (mu3 - 1) - (mu2 - 1) * mu3 * u32,
        N2: mu1 * (mu3 - 1) - (mu1 - 1) * mu3 * u31,
        D1: mu1 * N1 - u31 * (mu1 - 1) * mu2 * mu3,
        D2: mu2 * N2 - u32 * mu1 * (mu2 - 1) * mu3,
    },
    claims=["1.3/P", "1.3/PP*"],
    example=EXAMPLE_MU,
)
section.kernel(
    "projection.project",
    "Affine image coordinates of a point.",
    arguments={"y": point, **with_mu["arguments"]},
    describe={"y": "Point (y1, y2, y3) in affine coordinates; dimensionless.", **with_mu["describe"]},
    derived=u_of_y.subs(mu0, 1),
    form=vector((y1 * mu1 + y3 * u31 * mu3) / D, (y2 * mu2 + y3 * u32 * mu3) / D),
    where={D: 1 + y1 * (mu1 - 1) + y2 * (mu2 - 1) + y3 * (mu3 - 1)},
    claims=["1.3.1"],
    example={"y": ("0.5756072", "0.1487681", "0.1279697"), **EXAMPLE_MU},
)

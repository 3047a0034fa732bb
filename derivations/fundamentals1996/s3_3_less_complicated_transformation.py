# %% [markdown]
# # 3.3 A less complicated transformation to the normal case
#
# Must the cameras be known to transform two images to the normal case?  No: the two plane projectivities of section 3.1
# can be had from the elements of the correlation matrix $\mathbf Z$ alone.  One prime denotes the left image, two the
# right one.

# %%
import sympy

from algebroproj_derivations.figures import ImageDrawing
from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s1_3_properties_of_projection import P_star, point
from algebroproj_derivations.fundamentals1996.s2_1_spatial_intersection import correlation_matrix
from algebroproj_derivations.fundamentals1996.s2_2_correlation import (
    SEEN,
    Z_example,
    Z_general,
    z00,
    z01,
    z02,
    z11,
    z12,
    z20,
    z21,
    z22,
)
from algebroproj_derivations.fundamentals1996.s3_1_normal_case_transformation import (
    FOURTH,
    T,
    mapped_u,
    normal_fourth_image,
    tau1,
    tau2,
    tau_of_fourth_points,
    un30,
    un31,
    un32,
)
from algebroproj_derivations.fundamentals1996.s3_2_normal_case import (
    AXIS,
    LEFT_FOURTH,
    RIGHT_FOURTH,
    Z_N,
    axis_of_mu,
    base,
    right_fourth,
    w_left,
    y0_left,
    y_a,
    ya0,
    ya1,
    ya2,
    ya3,
    z_n,
    z_of_pair,
)
from algebroproj_derivations.inserting import given
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    adjugate,
    columns,
    determinant,
    divided,
    dot,
    homogeneous,
    linear_system,
    over,
    solve,
    vector,
)

section = Section("fundamentals1996", "3.3", "A less complicated transformation to the normal case")

# %% [markdown]
# ## The correlation matrix through the normal case
#
# **Definition.**  Each image has a matrix $\mathbf T$ with two parameters, (3.1.2).  Its coordinates follow by (3.1.3).

# %%
taup1, taup2, taupp1, taupp2 = sympy.symbols("taup1 taup2 taupp1 taupp2")
up1, up2, upp1, upp2 = sympy.symbols("up1 up2 upp1 upp2")
LEFT = {tau1: taup1, tau2: taup2, u1: up1, u2: up2}
RIGHT = {tau1: taupp1, tau2: taupp2, u1: upp1, u2: upp2}
T_left, T_right = T.xreplace(LEFT), T.xreplace(RIGHT)
u_left, u_right = homogeneous(vector(up1, up2)), homogeneous(vector(upp1, upp2))
normal_left, normal_right = homogeneous(mapped_u.xreplace(LEFT)), homogeneous(mapped_u.xreplace(RIGHT))

taup, taupp = sympy.symbols("taup taupp")
FACTORS = {taup: (T_left * u_left)[0], taupp: (T_right * u_right)[0]}
section.identity(
    "3.3.1",
    "transformation of both images",
    printed=columns(taup * normal_left, taupp * normal_right),
    where=FACTORS,
    derived=columns(T_left * u_left, T_right * u_right),
)

# %% [markdown]
# Homologous points lie on one line of the family: the condition is the difference of the two sides of (3.2.3).

# %%
section.identity(
    "3.3/coplanarity",
    "condition of coplanarity of two normal case images",
    printed=dot(normal_left, Z_N * normal_right),
    derived=normal_left[1] + z_n * normal_left[2] - normal_right[1] - z_n * normal_right[2],
)

# %%
product = T_left.T * Z_N * T_right
section.identity(
    "3.3.2",
    "coplanarity in the coordinates of the original images",
    derived=FACTORS[taup] * FACTORS[taupp] * dot(normal_left, Z_N * normal_right),
)

# %% [markdown]
# **Is this the matrix of correlation of the original images?**  $\mathbf T = \mathbf P_N^* \mathbf P$, hence
# $\mathbf P = \mathbf P_N \mathbf T$, and $\mathbf C$ of (2.1.4) changes by $\mathbf T'$ and $\mathbf T''$.  This holds
# for the correlation of any two planes of the bundles.

# %%
P_any_left, P_any_right = Matrix(3, 3, sympy.symbols("pp:3:3")), Matrix(3, 3, sympy.symbols("ppp:3:3"))
any_base = vector(*sympy.symbols("d1 d2 d3"))
section.identity(
    "3.3.3#C",
    "correlation of the original images from that of the normal case",
    printed=T_left.T * correlation_matrix(P_any_left, P_any_right, any_base) * T_right,
    derived=correlation_matrix(P_any_left * T_left, P_any_right * T_right, any_base),
)
C_normal = correlation_matrix(*(adjugate(P_star.xreplace(side)) for side in (LEFT_FOURTH, RIGHT_FOURTH)), base)
section.up_to_scale(
    "3.3.3",
    "relation of the correlation matrices",
    where={z_n: over(C_normal[2, 0], C_normal[1, 0])},
    derived=T_left.T * C_normal * T_right,
)

# %% [markdown]
# **Meaning.**  $\mathbf T'^T \mathbf Z_N \mathbf T'' = \tau'_1 \mathbf Z$.  As an equation without a factor (3.3.3)
# is a choice, $\tau'_1 = 1$.

# %%
section.identity(
    "3.3/beyond/factor",
    "the factor of the relation is the first parameter of the left image",
    printed=product,
    derived=taup1 * product.applyfunc(lambda entry: over(entry, product[1, 0])),
)

# %% [markdown]
# ## The product, entry by entry
#
# **Print.**  One entry is lost.  In the four of the inner block primes of $\tau$ are missing, so that the parameters
# of the right image read like those of the left.

# %%
product

# %%
section.identity(
    "3.3.4#factors",
    "the three factors",
    derived=columns(T_left.T, Z_N, T_right),
)
for row, column in ((0, 0), (0, 2), (1, 0), (2, 0)):
    section.identity(f"3.3.4#{row}{column}", f"entry ({row}, {column})", derived=product[row, column])

# %%
section.identity(
    "3.3.4#01",
    "entry (0, 1)",
    printed=None,
    derived=product[0, 1],
    expect="illegible",
    corrected=-taupp1,
    note="(3.3.5) confirms it: tau1'' = -z01.",
)

# %%
PRIMES = (
    "In each of the four entries the factor before the second bracket lacks a prime, while the brackets keep theirs: "
    "the scan did not lose them one by one.  (3.3.5) and (3.3.6) follow from the right entries."
)
for (row, column), corrected in {
    (1, 1): taup1 * (taupp1 - 1) - taupp1 * (taup1 - 1),
    (1, 2): taup1 * (taupp2 - 1) - taupp2 * (taup1 - 1) * z_n,
    (2, 1): taup2 * z_n * (taupp1 - 1) - taupp1 * (taup2 - 1),
    (2, 2): taup2 * z_n * (taupp2 - 1) - taupp2 * (taup2 - 1) * z_n,
}.items():
    section.identity(
        f"3.3.4#{row}{column}",
        f"entry ({row}, {column})",
        derived=product[row, column],
        expect="misprint",
        corrected=corrected,
        note={(1, 1): PRIMES, (2, 2): "Beside the prime, the bracket has tau1' for tau2'."}.get((row, column), ""),
        same_as="" if (row, column) == (1, 1) else "3.3.4#11",
    )

# %% [markdown]
# ## The parameters
#
# **How do they follow from $\mathbf Z$?**  The first row and the first column of the equation are linear in the four
# parameters.

# %%
Z = Z_general.xreplace({z00: sympy.Integer(0)})
parameters = vector(taup1, taup2, taupp1, taupp2)
border = ((1, 0), (2, 0), (0, 1), (0, 2))
parameters_of_z = solve(*linear_system([product[place] - Z[place] for place in border], list(parameters)))
parameters_of_z

# %%
section.identity("3.3.5", "the four parameters from the elements of Z", derived=parameters_of_z)

# %% [markdown]
# With these parameters the diagonal of the product gives two conditions, in agreement with (2.2.2), and the other two
# entries give $z_N$.

# %%
inner = product.xreplace(given(parameters, parameters_of_z))
section.identity(
    "3.3/a",
    "conditions of the principal diagonal",
    where={z11: inner[1, 1], z22: inner[2, 2]},
    derived=vector(z01, z02),
)


# %%
def solved(place: tuple[int, int]) -> sympy.Expr:
    """Return z_N from one entry of the equation, multiplied by z_N."""
    equation = sympy.expand(z_n * divided(inner[place] - Z[place]))
    return solve(*linear_system([equation], [z_n]))[0]


z_of_12, z_of_21 = solved((1, 2)), solved((2, 1))
form_21 = z01 * z20 / (z01 + z20 + z21 + z01 * z20)
section.identity("3.3.6#12", "z_N from entry (1, 2)", derived=z_of_12)
section.identity("3.3.6#21", "z_N from entry (2, 1)", derived=z_of_21)

# %% [markdown]
# **Two forms of one number?**  They are equal on $\det \mathbf Z = 0$.  Of this determinant the last term is
# misprinted: it must be $z_{22} z_{01}$, from $z_{01} z_{10} z_{22}$.

# %%
section.identity(
    "3.3/det",
    "determinant of the correlation matrix",
    derived=determinant(Z),
    expect="misprint",
    corrected=z01 * z12 * z20 + z02 * z21 - z20 * z11 * z02 - z22 * z01,
    note="Ruled out: a product of z01 and z12 without a third element occurs in no arrangement with the same other "
    "three terms.  A slip of the scan cannot be told from one of the print.",
)

# %% [markdown]
# Cleared of denominators, the difference of the two forms is the determinant.

# %%
CONDITIONS_A = {z11: -1 - z01, z22: -z20 - z02}
determinant_of_z = determinant(Z).subs(CONDITIONS_A)
section.identity(
    "3.3.6",
    "the two forms of z_N are identical",
    derived=form_21,
    constraints=[determinant_of_z],
    nonzero=[z02, z01, z20],
)
section.identity(
    "3.3/beyond/det",
    "the determinant is the difference of the two forms, cleared of denominators",
    printed=z01 * z20 * (1 + z12) + z02 * (z01 + z20 + z21 + z01 * z20),
    derived=determinant_of_z,
)

# %% [markdown]
# **The second parameters.**  $\tau'_2 = z_{20} / z_N$ and $\tau''_2 = -z_{02} / z_N$.  Both fractions of (3.3.7) are
# printed upside down.  The example of section 4 i has 1.079591 and 1.07973, the values of the corrected forms.

# %%
section.identity(
    "3.3.7#left",
    "second parameter of the left image",
    derived=parameters_of_z[1].xreplace({z_n: z_of_21}),
    expect="error",
    corrected=(z01 + z20 + z21 + z01 * z20) / z01,
    note="Ruled out: the inverse transformation, from P_N to P, which is not that of (3.3.1) and (3.3.5); an exchange "
    "of the two images, or of rows and columns.  Both fractions are inverted, which no slip of the press "
    "explains.",
    same_as="3.3.7#right",
)
section.identity(
    "3.3.7#right",
    "second parameter of the right image",
    derived=parameters_of_z[3].xreplace({z_n: z_of_12}),
    expect="error",
    corrected=1 + z12,
    note="Both fractions of (3.3.7) are inverted, which no slip of the press explains.",
    follows="Both fractions of (3.3.7) are upside down. In the example the second parameter of the right image is "
    "{4/i#right.tau2}. The printed formula gives {4/i/beyond/as-printed#right.tau2}, and the images are not in the "
    "normal case. See docs/findings/inverted-parameters.md.",
)

# %% [markdown]
# The text eliminates $z_N$ in (3.3.4) by (3.3.5).  With $\tau'_2 z_N = z_{20}$ and $\tau'_1 = 1$, the entries (2, 1)
# and (1, 2) contain one parameter each.  The result is the same, so the references are right.

# %%
without_z_n = {taup1: parameters_of_z[0], taupp1: parameters_of_z[2], z_n: over(z20, taup2)}
tau2_of_entries = [
    solve(*linear_system([divided((product[place] - Z[place]).xreplace(without_z_n))], [unknown]))[0]
    for place, unknown in (((2, 1), taup2), ((1, 2), taupp2))
]
section.identity(
    "3.3/elimination",
    "elimination of z_N in (3.3.4) gives what (3.3.6), inserted in (3.3.5), gives",
    printed=vector(parameters_of_z[1].xreplace({z_n: z_of_21}), parameters_of_z[3].xreplace({z_n: z_of_12})),
    derived=vector(*tau2_of_entries),
)

# %% [markdown]
# **An example.**  The matrix $\mathbf Z$ of the example of section 2.2 has these parameters $\tau'_1, \tau'_2,
# \tau''_1, \tau''_2$, with $z_N = -z_{02} / (1 + z_{12})$:

# %%
numbers = {Z[place]: Z_example[place] for place in ((0, 1), (0, 2), (1, 2), (2, 0))}
example_z_n = z_of_12.xreplace(numbers).doit()
example_parameters = parameters_of_z.xreplace(numbers | {z_n: example_z_n}).doit()
example_parameters

# %%
TAUS = given(parameters, example_parameters)
lines = [Z_example * homogeneous(seen) for seen in SEEN.values()]
to_normal = T_left.xreplace(TAUS)
moved = {
    name: mapped_u.xreplace(LEFT).xreplace(TAUS | {up1: seen[0], up2: seen[1]}).doit() for name, seen in SEEN.items()
}
ImageDrawing(
    "The left image of section 2.2 before and after the transformation: the epipolar lines of the points P1 to P4 of "
    "the right image become parallel.",
    {"original": (SEEN, lines), "normal case": (moved, [adjugate(to_normal).T * line for line in lines])},
)

# %% [markdown]
# ## All solutions
#
# **Is the solution unique?**  $\mathbf Z$ is known but for a factor.  With $\tau'_1 = k$ the product is $k \mathbf
# Z$, and every $k$ gives a solution: a simple infinite manifold.

# %%
k = sympy.Symbol("k")
scaled_border = [product[place] - k * Z[place] for place in ((1, 0), (2, 0), (0, 1))]
first_three = solve(*linear_system(scaled_border, [taup1, taup2, taupp1]))
fourth_equation = (product[1, 2] - k * z12).xreplace({taup1: k, z_n: over(-k * z02, taupp2)})
fourth = solve(*linear_system([sympy.expand(divided(fourth_equation))], [taupp2]))[0]
z_of_k = over(-k * z02, fourth)
family = given((*parameters, z_n), (*(f.xreplace({z_n: z_of_k}) for f in first_three), fourth, z_of_k))
at_one = {symbol: value.xreplace({k: sympy.Integer(1)}) for symbol, value in family.items()}
z21_of_det = {z21: solve(*linear_system([determinant_of_z], [z21]))[0]}
Z_regular = Z.subs(CONDITIONS_A).xreplace(z21_of_det)

section.identity(
    "3.3/manifold",
    "the solutions are a simple infinite manifold",
    printed=k * Z_regular,
    derived=product.xreplace(family),
)
section.identity(
    "3.3/manifold#second",
    "the second solution is the one with tau1' = 1",
    printed=vector(*parameters_of_z, z_n).xreplace({z_n: z_of_12}),
    derived=vector(*(at_one[symbol] for symbol in (*parameters, z_n))),
)

# %% [markdown]
# **The first solution**, with $u'_{N31} = u'_{31}$ in (3.1.2), has $\tau'_1 = u_{30}/u_{N30}$ in place (1, 0).  It is
# 1 only if $u_{N32} = u_{32}$ as well.

# %%
SAME_31 = {un31: u31}
section.vanishing(
    "3.3/z10",
    "the first solution has an element z10 that is not 1",
    printed=(un32 - u32,),
    derived=product[1, 0].xreplace({taup1: tau_of_fourth_points[0].xreplace(SAME_31)}) - 1,
)

# %% [markdown]
# Its parameters are those of the method (1.5.4), but for a factor.  In the print of that method numerator and
# denominator are alike.

# %%
fourth_ratio = vector(u30, u31, u32)
fourth_ratio_normal = vector(un30, un31, un32)
tau0, tau3 = sympy.symbols("tau0 tau3")
core = columns(tau0 * image_e0, tau1 * image_e1 - tau0 * image_e0, tau2 * image_e2 - tau0 * image_e0)
by_1_5_4 = solve(
    *linear_system(list(core * homogeneous(fourth_image) - homogeneous(normal_fourth_image)), [tau0, tau1, tau2])
)
section.identity(
    "3.3/method-1.5.4",
    "parameters by the method (1.5.4)",
    printed=vector(over(un31, un31), over(un32, un32)),
    derived=vector(*by_1_5_4[1:, 0]),
    expect="misprint",
    corrected=vector(un31 / u31, un32 / u32),
    note="Without the N in the denominator it is (1.5.4) with mu4 = 1.  In this method tau0 = u_N30/u30 is not 1.",
)
section.up_to_scale(
    "3.3/method-1.5.4#scale",
    "the method (1.5.4) gives the parameters of (3.1.2), but for a factor",
    printed=vector(un30 / u30, un31 / u31, un32 / u32),
    where=FOURTH,
    derived=vector(1, *tau_of_fourth_points),
)

# %% [markdown]
# **The second solution** has $\tau'_1 = 1$.  The paper says that it keeps $u'_{31}$.  But the table of section 4 i
# has 0.270614 for point 2, and $u'_{31}$ is 0.2718578.  What is kept is the ratio of the first two barycentric
# coordinates.

# %%
section.identity(
    "3.3/u'N31",
    "in the second solution the first coordinate of the fourth point is kept",
    derived=mapped_u[0].xreplace({tau1: sympy.Integer(1), u1: u31, u2: u32}),
    expect="false",
    instead="3.3/beyond/u'N31",
)
kept = mapped_u.xreplace({tau1: sympy.Integer(1), u1: u31, u2: u32})
section.identity(
    "3.3/beyond/u'N31",
    "in the second solution the ratio of the first two barycentric coordinates is kept",
    printed=u31 / u30,
    where=FOURTH,
    derived=over(kept[0], 1 - kept[0] - kept[1]),
)

# %% [markdown]
# **How do the solutions follow from one another?**  Divided by $z_{10} = \tau'_1$, the correlation matrix of the first
# solution is that of the second.  The parameters are not.  In section 4 the first solution has $z_N = 0.1221364$ and
# $\tau'_1 = 1.0063775$, hence 0.121362; the second one has 0.121456.

# %%
section.identity(
    "3.3/divided",
    "the parameters of the second solution are those of the first divided by z10",
    printed=vector(*(over(family[symbol], k) for symbol in (*parameters, z_n))),
    derived=vector(*(at_one[symbol] for symbol in (*parameters, z_n))),
    expect="false",
    instead="3.3/beyond/relation",
    note="True for tau1' and tau1'', 3.3/divided#tau1.  If the sentence means the components of the matrix (3.3.4), "
    "it is true: 3.3/manifold.",
)
section.identity(
    "3.3/divided#tau1",
    "the first parameters are divided by z10",
    printed=vector(over(family[taup1], k), over(family[taupp1], k)),
    derived=vector(at_one[taup1], at_one[taupp1]),
)

# %% [markdown]
# What is true: one projectivity for both images takes the second solution to the first.  Its divisor
# $1 + (k - 1)(u_1 + z_N u_2)$ is constant on every epipolar line.

# %%
relation = T.xreplace({tau1: k, tau2: 1 + (k - 1) * at_one[z_n]})
section.identity(
    "3.3/beyond/relation",
    "the first solution is the second one followed by one projectivity for both images",
    printed=columns(relation * T_left.xreplace(at_one), relation * T_right.xreplace(at_one)),
    derived=columns(T_left.xreplace(family), T_right.xreplace(family)),
)

section.reference(
    "3.3/ref-3.5",
    "subsection with the numerical example",
    meant="4",
    note="There is no subsection 3.5.  The example is section 4, items f and i; its figure is still numbered 3.5.",
)

# %% [markdown]
# ## Relative orientation from normal case images
#
# **What becomes of section 2.4 in the normal case?**  There the point $\mathbf y_A$ of the epipolar axis is projected
# to the epipole, the equations (2.3.0).  Now the epipole goes to infinity, in the direction $u_{01} : u_{02} = -z_N$.
#
# **Definition.**  $u_{01} = -z_N/\varepsilon + b_1$ and $u_{02} = 1/\varepsilon + b_2$, with $\varepsilon$ going to
# zero.

# %%
eps, b1, b2 = sympy.symbols("eps b1 b2")
u01, u02 = over(-z_n, eps) + b1, over(1, eps) + b2
NORMAL_FOURTH = {u31: un31, u32: un32}
image_of_point = (P_star * point + image_e0).xreplace(NORMAL_FOURTH)


def weights_of(axis_point: Matrix) -> Matrix:
    return image_of_point.xreplace(given(point, axis_point))


section.identity(
    "3.3/quotient",
    "quotient of the coordinates of the epipole",
    where={z_n: z_of_pair},
    derived=over(w_left[1], w_left[2]),
)

# %% [markdown]
# The text refers to the display of this limit, and to formulas of other sections, by wrong numbers.

# %%
section.reference(
    "3.3/ref-2.3",
    "subsection with the parameters of relative orientation",
    meant="2.4",
    same_as="2.4/ref-2.3",
)
section.reference(
    "3.3/ref-2.3#expressions",
    "subsection with the explicit expressions for mu",
    meant="2.4",
    same_as="2.4/ref-2.3",
)
section.reference(
    "3.3/ref-2.3.9",
    "equation for the quotient of the coordinates of the epipole",
    meant="3.2.9",
    note="There is no (2.3.9), neither in 2.3 nor in 2.4; (3.2.9) gives z_N as this quotient.",
)

# %% [markdown]
# In the limit the coordinates keep their quotient.

# %%
section.limit("3.3/quotient#limit", "the quotient in the limit", derived=over(u01, u02), variable=eps)
section.reference(
    "3.3/ref-3.3.7",
    "display with the limiting process",
    meant="3.3",
    note="Meant is the display of subsection 3.3 with the limit of u01/u02, which has no number: 3.3/quotient#limit.",
)

# %% [markdown]
# In the limit the left side of the first equation of (2.3.0) vanishes against the others: so does the first component
# of the epipole $(1, u_{01}, u_{02})$, the third being 1.

# %%
section.limit(
    "3.3/first-equation",
    "the first equation equals zero",
    printed=vector(0, -z_n),
    derived=vector(over(1, u02), over(u01, u02)),
    variable=eps,
)

# %% [markdown]
# **a) Left bundle**, with $\mu_1 = \mu_2$: two equations for two unknowns.  The print is the limit of their solution.

# %%
weights = weights_of(y_a).subs(mu2, mu1)
epipole_symbols = sympy.symbols("u01 u02")
AT_EPIPOLE = given(epipole_symbols, (u01, u02))


def epipole_equations(weights: Matrix) -> list[sympy.Expr]:
    """Return (2.3.0) without the factor: second and third component less the coordinate times the first."""
    return [weights[i] - epipole_symbols[i - 1] * weights[0] for i in (1, 2)]


left_system = linear_system(epipole_equations(weights), [mu1, mu3])
left_solution = solve(*left_system)
sum_n = un31 + z_n * un32
D_left = ya3 * ((ya1 + ya2) * sum_n - ya1 - z_n * ya2)
section.limit(
    "3.3.8#D",
    "divisor of the left bundle",
    where=AXIS,
    derived=over(determinant(left_system[0]), epipole_symbols[1]).xreplace(AT_EPIPOLE),
    variable=eps,
)
section.limit(
    "3.3.8#mu1",
    "first and second parameter of the left bundle",
    where=AXIS,
    derived=left_solution[0].xreplace(AT_EPIPOLE),
    variable=eps,
)
section.limit(
    "3.3.8#mu3",
    "third parameter of the left bundle",
    where=AXIS,
    derived=left_solution[1].xreplace(AT_EPIPOLE),
    variable=eps,
)

# %% [markdown]
# The same without a limit: the epipole has the homogeneous coordinates $(0, -z_N, 1)$.


# %%
def infinite_equations(weights: Matrix) -> list[sympy.Expr]:
    return [weights[0], weights[1] + z_n * weights[2]]


mu_left = vector(*(solve(*linear_system(infinite_equations(weights), [mu1, mu3]))[i] for i in (0, 0, 1)))
mu_left

# %%
mu_left_printed = vector(-ya0 * ya3 * sum_n, -ya0 * ya3 * sum_n, ya0 * (ya1 + z_n * ya2)) / D_left
section.identity(
    "3.3.8",
    "parameters of the left bundle, from the epipole at infinity",
    printed=mu_left_printed,
    where=AXIS,
    derived=mu_left,
)

# %% [markdown]
# **b) Right bundle.**  $\mathbf y_A$ and the left center $\mathbf y_0$ are projected to the epipole.  Each gives
# $\mu_1$ and $\mu_2$ in terms of $\mu_3$.

# %%
u00 = 1 - epipole_symbols[0] - epipole_symbols[1]
section.limit(
    "3.3.9#u00", "the quotient u00/u02", derived=over(u00, epipole_symbols[1]).xreplace(AT_EPIPOLE), variable=eps
)
FOURTH_RIGHT = given((un31, un32), right_fourth)
systems = {
    name: linear_system(epipole_equations(weights_of(axis_point).xreplace(FOURTH_RIGHT)), [mu1, mu2])
    for name, axis_point in (("yA", y_a), ("y0", center))
}
solutions = {name: solve(*system) for name, system in systems.items()}
section.limit(
    "3.3.9#D",
    "divisor of the right bundle",
    derived=over(determinant(systems["yA"][0]), epipole_symbols[1]).xreplace(AT_EPIPOLE),
    variable=eps,
)
r31, r32 = right_fourth
sum_r = r31 + z_n * r32
BOTH = AXIS | BARYCENTRIC
for name in ("yA", "y0"):
    for i in range(2):
        section.limit(
            f"3.3.9#mu{i + 1}({name})",
            f"parameter mu{i + 1} of the right bundle, from {name}",
            where=BOTH,
            derived=solutions[name][i].xreplace(AT_EPIPOLE),
            variable=eps,
        )

# %% [markdown]
# Equating the two expressions of $\mu_1$, or those of $\mu_2$, gives $\mu_3$.

# %%
for i, name, factor_printed, right_side in (
    (0, "first", (y01 * ya3 - ya1 * y03) * (sum_r - z_n), -z_n * (y00 * ya1 - y01 * ya0)),
    (1, "second", (y02 * ya3 - ya2 * y03) * (sum_r - 1), -(y00 * ya2 - y02 * ya0)),
):
    (numerator_a, divisor_a), (numerator_0, divisor_0) = (solutions[axis][i].args for axis in ("yA", "y0"))
    equated = sympy.expand(numerator_a * divisor_0 - numerator_0 * divisor_a)
    mu3_found = solve(*linear_system([equated], [mu3]))[0]
    section.limit(
        f"3.3.9#mu3-{name}",
        f"parameter mu3 of the right bundle, {name} equation",
        printed=right_side / factor_printed,
        where=BOTH,
        derived=mu3_found.xreplace(AT_EPIPOLE),
        variable=eps,
    )

# %% [markdown]
# **Are these the parameters of the left image again?**  In the normal case they must be.  Without a limit, the
# homogeneous coordinates $(w_0, w_1, w_2)$ of the images of $\mathbf y_A$ and $\mathbf y_0$ satisfy $w_0 = 0$ and
# $w_1 + z_N w_2 = 0$.  These are four equations for three unknowns, and the parameters of the left image satisfy
# them.

# %%
right_weights = {name: weights_of(p).xreplace(FOURTH_RIGHT) for name, p in (("yA", y_a), ("y0", center))}
section.identity(
    "3.3/equal-mu",
    "the parameters of both bundles are equal",
    printed=Matrix.zeros(4, 1),
    derived=vector(*(equation for w in right_weights.values() for equation in infinite_equations(w))).xreplace(
        {z_n: z_of_pair} | given((*y_a, *center), (*axis_of_mu, *y0_left))
    ),
)

# %% [markdown]
# (3.3.9) with the second equation for $\mu_3$ uses both equations of $\mathbf y_A$ and the difference of those of
# $\mathbf y_0$.  The first equation for $\mu_3$ reads $0 = 0$ where $z_N = 0$, the second does not.

# %%
of_axis, of_center = (infinite_equations(w) for w in right_weights.values())
mu_right = solve(*linear_system([*of_axis, of_center[1] - of_center[0]], [mu1, mu2, mu3]))
mu3_second = -(y00 * ya2 - y02 * ya0) / ((y02 * ya3 - ya2 * y03) * (sum_r - 1))
section.identity(
    "3.3.9",
    "parameters of the right bundle, from the epipole at infinity",
    printed=vector(
        (ya3 * (sum_r - z_n) * mu3_second - z_n * ya0) / (ya1 * (z_n - 1)),
        (ya3 * (1 - sum_r) * mu3_second + ya0) / (ya2 * (z_n - 1)),
        mu3_second,
    ),
    where=BOTH,
    derived=mu_right,
)

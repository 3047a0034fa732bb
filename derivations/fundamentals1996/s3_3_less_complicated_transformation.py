# %% [markdown]
# # 3.3 A less complicated transformation to the normal case
#
# The two plane projectivities of section 3.1 can be had from the elements of the correlation matrix $\mathbf Z$ alone.
# One prime denotes the left image, two the right one.

# %%
import sympy

from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s1_3_properties_of_projection import P_star, point
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
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    adjugate,
    columns,
    cross,
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
# Each image has a matrix $\mathbf T$ with two parameters.

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
    note="With the inhomogeneous coordinates of (3.1.3).",
)
section.identity(
    "3.3/coplanarity",
    "condition of coplanarity of two normal case images",
    printed=dot(normal_left, Z_N * normal_right),
    derived=normal_left[1] + z_n * normal_left[2] - normal_right[1] - z_n * normal_right[2],
    note="Derived is the difference of the two sides of (3.2.3): homologous points lie on one line of the family.",
)
product = T_left.T * Z_N * T_right
section.identity(
    "3.3.2",
    "coplanarity in the coordinates of the original images",
    printed=dot(u_left, product * u_right),
    derived=FACTORS[taup] * FACTORS[taupp] * dot(normal_left, Z_N * normal_right),
    note="Zero where u'_N^T Z_N u''_N is zero; the scan has no N with u' in the preceding display.",
)

# %% [markdown]
# Independently of coordinates: $\mathbf T = \mathbf P_N^* \mathbf P$, hence $\mathbf P = \mathbf P_N \mathbf T$, and
# $\mathbf C = \mathbf P'^T \mathbf D \mathbf P''$ has the elements
# $(\mathbf p'_j \times \mathbf d) \cdot \mathbf p''_k$.  The elements of $\mathbf Z$ are those of $\mathbf C$
# divided by $c_{10}$.


# %%
def correlation(first: Matrix, second: Matrix, base: Matrix) -> Matrix:
    return Matrix(3, 3, lambda j, k: dot(cross(first[:, j], base), second[:, k]))


P_any_left, P_any_right = Matrix(3, 3, sympy.symbols("pp:3:3")), Matrix(3, 3, sympy.symbols("ppp:3:3"))
any_base = vector(*sympy.symbols("d1 d2 d3"))
section.identity(
    "3.3.3#C",
    "correlation of the original images from that of the normal case",
    printed=T_left.T * correlation(P_any_left, P_any_right, any_base) * T_right,
    derived=correlation(P_any_left * T_left, P_any_right * T_right, any_base),
)
C_normal = correlation(*(adjugate(P_star.xreplace(side)) for side in (LEFT_FOURTH, RIGHT_FOURTH)), base)
section.up_to_scale(
    "3.3.3",
    "relation of the correlation matrices",
    printed=product,
    where={z_n: over(C_normal[2, 0], C_normal[1, 0])},
    derived=T_left.T * C_normal * T_right,
    note="Two normal case images with equal parameters and the correlation of any two other planes of their bundles, "
    "see 3.3.3#C.  The adjugates of P_N* are P_N but for a factor.",
)
section.identity(
    "3.3/beyond/factor",
    "the factor of the relation is the first parameter of the left image",
    printed=product,
    derived=taup1 * product.applyfunc(lambda entry: over(entry, product[1, 0])),
    note="Not in the paper: T'^T Z_N T'' = tau1' Z.  As an equation without a factor (3.3.3) is a choice, tau1' = 1, "
    "which the comparison of components below makes.",
)

# %% [markdown]
# ## The product, entry by entry

# %%
T_transposed_printed = Matrix([[1, 0, 0], [taup1 - 1, taup1, 0], [taup2 - 1, 0, taup2]])
section.identity(
    "3.3.4#factors",
    "the three factors",
    printed=columns(
        T_transposed_printed,
        Matrix([[0, -1, -z_n], [1, 0, 0], [z_n, 0, 0]]),
        Matrix([[1, taupp1 - 1, taupp2 - 1], [0, taupp1, 0], [0, 0, taupp2]]),
    ),
    derived=columns(T_left.T, Z_N, T_right),
)
for (row, column), printed in {
    (0, 0): 0,
    (0, 2): -taupp2 * z_n,
    (1, 0): taup1,
    (2, 0): taup2 * z_n,
}.items():
    section.identity(f"3.3.4#{row}{column}", f"entry ({row}, {column})", printed=printed, derived=product[row, column])
section.identity(
    "3.3.4#01",
    "entry (0, 1)",
    printed=None,
    derived=product[0, 1],
    expect="illegible",
    corrected=-taupp1,
    note="The scan has lost this entry.  (3.3.5) confirms it: tau1'' = -z01.",
)
PRIMES = (
    "  Primes of tau are lost in the whole matrix of the scan, where the parameters of the right image read like those "
    "of the left; a slip of the scan cannot be told from one of the print."
)
for (row, column), printed, corrected, note in (
    (
        (1, 1),
        taup1 * (taupp1 - 1) - taup1 * (taup1 - 1),
        taup1 * (taupp1 - 1) - taupp1 * (taup1 - 1),
        "The factor before the second bracket must be tau1''.",
    ),
    (
        (1, 2),
        taup1 * (taupp2 - 1) - taup2 * (taup1 - 1) * z_n,
        taup1 * (taupp2 - 1) - taupp2 * (taup1 - 1) * z_n,
        "The factor before the second bracket must be tau2''.",
    ),
    (
        (2, 1),
        taup2 * z_n * (taupp1 - 1) - taup1 * (taup2 - 1),
        taup2 * z_n * (taupp1 - 1) - taupp1 * (taup2 - 1),
        "The factor before the second bracket must be tau1''.",
    ),
    (
        (2, 2),
        taup2 * z_n * (taupp2 - 1) - taup2 * (taup1 - 1) * z_n,
        taup2 * z_n * (taupp2 - 1) - taupp2 * (taup2 - 1) * z_n,
        "The second term must be tau2'' (tau2' - 1) z_N: a prime and, in the bracket, an index.",
    ),
):
    section.identity(
        f"3.3.4#{row}{column}",
        f"entry ({row}, {column})",
        printed=printed,
        derived=product[row, column],
        expect="misprint",
        corrected=corrected,
        note=note + PRIMES,
        same_as="" if (row, column) == (1, 1) else "3.3.4#11",
    )

# %% [markdown]
# ## The parameters
#
# The first row and the first column of the equation are linear in the four parameters.

# %%
z01, z02, z11, z12, z20, z21, z22 = sympy.symbols("z01 z02 z11 z12 z20 z21 z22")
Z = Matrix([[0, z01, z02], [1, z11, z12], [z20, z21, z22]])
parameters = vector(taup1, taup2, taupp1, taupp2)
border = ((1, 0), (2, 0), (0, 1), (0, 2))
parameters_of_z = solve(*linear_system([product[place] - Z[place] for place in border], list(parameters)))
section.identity(
    "3.3.5",
    "the four parameters from the elements of Z",
    printed=vector(1, z20 / z_n, -z01, -z02 / z_n),
    derived=parameters_of_z,
)
inner = product.xreplace(dict(zip(parameters, parameters_of_z, strict=True)))
section.identity(
    "3.3/a",
    "conditions of the principal diagonal",
    printed=vector(-1 - z11, -z20 - z22),
    where={z11: inner[1, 1], z22: inner[2, 2]},
    derived=vector(z01, z02),
    note="z11 and z22 are the entries (1, 1) and (2, 2) of the product with the parameters (3.3.5): in agreement with "
    "(2.2.2).",
)


def solved(place: tuple[int, int]) -> sympy.Expr:
    """Return z_N from one entry of the equation, multiplied by z_N."""
    equation = sympy.expand(z_n * divided(inner[place] - Z[place]))
    return solve(*linear_system([equation], [z_n]))[0]


z_of_12, z_of_21 = solved((1, 2)), solved((2, 1))
form_12, form_21 = -z02 / (1 + z12), z01 * z20 / (z01 + z20 + z21 + z01 * z20)
section.identity("3.3.6#12", "z_N from entry (1, 2)", printed=form_12, derived=z_of_12)
section.identity("3.3.6#21", "z_N from entry (2, 1)", printed=form_21, derived=z_of_21)

# %% [markdown]
# The two forms are equal on $\det \mathbf Z = 0$.

# %%
determinant_printed = z01 * z12 * z20 + z02 * z21 - z20 * z11 * z02
section.identity(
    "3.3/det",
    "determinant of the correlation matrix",
    printed=determinant_printed - z12 * z01,
    derived=determinant(Z),
    expect="misprint",
    corrected=determinant_printed - z22 * z01,
    note="The last term must be z22 z01, from z01 z10 z22.  A product of z01 and z12 without a third element occurs "
    "neither in the determinant nor in that of another arrangement with the same other three terms.  A slip of the "
    "scan cannot be told from one of the print.",
)
CONDITIONS_A = {z11: -1 - z01, z22: -z20 - z02}
determinant_of_z = determinant(Z).subs(CONDITIONS_A)
section.identity(
    "3.3.6",
    "the two forms of z_N are identical",
    printed=form_12,
    derived=form_21,
    constraints=[determinant_of_z],
    nonzero=[z02, z01, z20],
    note="Constraint: det Z = 0 under the conditions of item a.",
)
section.identity(
    "3.3/beyond/det",
    "the determinant is the difference of the two forms, cleared of denominators",
    printed=z01 * z20 * (1 + z12) + z02 * (z01 + z20 + z21 + z01 * z20),
    derived=determinant_of_z,
    note="Not in the paper.",
)
section.identity(
    "3.3.7#left",
    "second parameter of the left image",
    printed=z01 / (z01 + z20 + z21 + z01 * z20),
    derived=parameters_of_z[1].xreplace({z_n: z_of_21}),
    expect="error",
    corrected=(z01 + z20 + z21 + z01 * z20) / z01,
    note="The fraction is inverted: tau2' = z20/z_N.  The example of section 4 i has 1.079591, in agreement with the "
    "corrected form.  The printed value would belong to the inverse transformation, from P_N to P, which is not that "
    "of (3.3.1) and (3.3.5); an exchange of the two images, or of rows and columns, does not give it.  Both fractions "
    "of (3.3.7) are inverted, which no slip of the press explains.",
    same_as="3.3.7#right",
)
section.identity(
    "3.3.7#right",
    "second parameter of the right image",
    printed=1 / (1 + z12),
    derived=parameters_of_z[3].xreplace({z_n: z_of_12}),
    expect="error",
    corrected=1 + z12,
    note="The fraction is inverted: tau2'' = -z02/z_N.  The example of section 4 i has 1.07973 = 1 + z12.  "
    "Both fractions of (3.3.7) are inverted, which no slip of the press explains.",
    follows="Both fractions of (3.3.7) are upside down. In the example tau''2 is {4/i#right.tau2}. The printed "
    "formula gives {4/i/beyond/as-printed#right.tau2}, and the images are not in the normal case. See "
    "docs/findings/inverted-parameters.md.",
)

# %% [markdown]
# The text eliminates $z_N$ in (3.3.4) by (3.3.5): with $\tau'_2 z_N = z_{20}$ and $\tau'_1 = 1$, the entries (2, 1) and
# (1, 2) contain one parameter each.

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
    note="So that the references to (3.3.4) and (3.3.5) are right; (3.3.6) is not needed.  What is printed for the "
    "result is the inverse of it: 3.3.7#left and 3.3.7#right.",
)

# %% [markdown]
# ## All solutions
#
# $\mathbf Z$ is known but for a factor.  With $\tau'_1 = k$ the product is $k \mathbf Z$; every $k$ gives a solution.

# %%
k = sympy.Symbol("k")
scaled_border = [product[place] - k * Z[place] for place in ((1, 0), (2, 0), (0, 1))]
first_three = solve(*linear_system(scaled_border, [taup1, taup2, taupp1]))
fourth_equation = (product[1, 2] - k * z12).xreplace({taup1: k, z_n: over(-k * z02, taupp2)})
fourth = solve(*linear_system([sympy.expand(divided(fourth_equation))], [taupp2]))[0]
z_of_k = over(-k * z02, fourth)
family = dict(zip((*parameters, z_n), (*(f.xreplace({z_n: z_of_k}) for f in first_three), fourth, z_of_k), strict=True))
at_one = {symbol: value.xreplace({k: sympy.Integer(1)}) for symbol, value in family.items()}
z21_of_det = {z21: solve(*linear_system([determinant_of_z], [z21]))[0]}
Z_regular = Z.subs(CONDITIONS_A).xreplace(z21_of_det)

section.identity(
    "3.3/manifold",
    "the solutions are a simple infinite manifold",
    printed=k * Z_regular,
    derived=product.xreplace(family),
    note="One solution for every k = tau1'; z21 from det Z = 0.",
)
section.identity(
    "3.3/manifold#second",
    "the second solution is the one with tau1' = 1",
    printed=vector(*parameters_of_z, z_n).xreplace({z_n: z_of_12}),
    derived=vector(*(at_one[symbol] for symbol in (*parameters, z_n))),
)

# %% [markdown]
# The first solution, with $u'_{N31} = u'_{31}$ in (3.1.2), has $\tau'_1 = u_{30}/u_{N30}$ in place (1, 0).

# %%
SAME_31 = {un31: u31}
section.vanishing(
    "3.3/z10",
    "the first solution has an element z10 that is not 1",
    printed=(un32 - u32,),
    derived=product[1, 0].xreplace({taup1: tau_of_fourth_points[0].xreplace(SAME_31)}) - 1,
    note="1 exactly where u_N32 = u32 as well.",
)
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
    note="Numerator and denominator are printed alike; without the N in the denominator it is (1.5.4) with mu4 = 1.  "
    "In this method tau0 = u_N30/u30 is not 1.",
)
section.up_to_scale(
    "3.3/method-1.5.4#scale",
    "the method (1.5.4) gives the parameters of (3.1.2), but for a factor",
    printed=vector(un30 / u30, un31 / u31, un32 / u32),
    where=FOURTH,
    derived=vector(1, *tau_of_fourth_points),
    note="So that, for the same fourth points, it gives the same transformation.",
)
section.identity(
    "3.3/u'N31",
    "in the second solution the first coordinate of the fourth point is kept",
    printed=u31,
    derived=mapped_u[0].xreplace({tau1: sympy.Integer(1), u1: u31, u2: u32}),
    expect="false",
    instead="3.3/beyond/u'N31",
    note="The second solution has tau1' = 1 together with tau0' = 1, which is not u'_N31 = u'_31: the table of section "
    "4 i has u'_N1 = 0.270614 for point 2, and u'_1 = 0.2718578.",
)
kept = mapped_u.xreplace({tau1: sympy.Integer(1), u1: u31, u2: u32})
section.identity(
    "3.3/beyond/u'N31",
    "in the second solution the ratio of the first two barycentric coordinates is kept",
    printed=u31 / u30,
    where=FOURTH,
    derived=over(kept[0], 1 - kept[0] - kept[1]),
    note="Not in the paper: what tau1' = 1 means for the fourth point.",
)

# %% [markdown]
# How do the solutions follow from one another?  Divided by $z_{10} = \tau'_1$, the correlation matrix of the first
# solution is that of the second: this is 3.3/manifold.  The parameters are not.

# %%
section.identity(
    "3.3/divided",
    "the parameters of the second solution are those of the first divided by z10",
    printed=vector(*(over(family[symbol], k) for symbol in (*parameters, z_n))),
    derived=vector(*(at_one[symbol] for symbol in (*parameters, z_n))),
    expect="false",
    instead="3.3/beyond/relation",
    note="True for tau1' and tau1'' (3.3/divided#tau1), not for tau2', tau2'' and z_N: in section 4, z_N = 0.1221364 "
    "and tau1' = 1.0063775 of the first solution give 0.121362, the second solution is 0.121456.  If the sentence "
    "means the components of the matrix (3.3.4), it is true: 3.3/manifold.",
)
section.identity(
    "3.3/divided#tau1",
    "the first parameters are divided by z10",
    printed=vector(over(family[taup1], k), over(family[taupp1], k)),
    derived=vector(at_one[taup1], at_one[taupp1]),
)
relation = T.xreplace({tau1: k, tau2: 1 + (k - 1) * at_one[z_n]})
section.identity(
    "3.3/beyond/relation",
    "the first solution is the second one followed by one projectivity for both images",
    printed=columns(relation * T_left.xreplace(at_one), relation * T_right.xreplace(at_one)),
    derived=columns(T_left.xreplace(family), T_right.xreplace(family)),
    note="Not in the paper: the projectivity has the parameters k and 1 + (k - 1) z_N, z_N of the second solution.  "
    "Its divisor 1 + (k - 1)(u1 + z_N u2) is constant on every epipolar line.",
)

section.reference(
    "3.3/ref-3.5",
    "subsection with the numerical example",
    printed="3.5",
    meant="4",
    note="There is no subsection 3.5.  The example is section 4, items f and i; its figure is still numbered 3.5.",
)

# %% [markdown]
# ## Relative orientation from normal case images
#
# The point $\mathbf y_A$ of the epipolar axis is projected to the epipole, the equations (2.3.0).  Now the epipole goes
# to infinity, in the direction $u_{01} : u_{02} = -z_N$.  In the following
# $u_{01} = -z_N/\varepsilon + b_1$ and $u_{02} = 1/\varepsilon + b_2$.

# %%
eps, b1, b2 = sympy.symbols("eps b1 b2")
u01, u02 = over(-z_n, eps) + b1, over(1, eps) + b2
NORMAL_FOURTH = {u31: un31, u32: un32}
image_of_point = (P_star * point + image_e0).xreplace(NORMAL_FOURTH)


def weights_of(axis_point: Matrix) -> Matrix:
    return image_of_point.xreplace(dict(zip(point, axis_point, strict=True)))


section.identity(
    "3.3/quotient",
    "quotient of the coordinates of the epipole",
    printed=-z_n,
    where={z_n: z_of_pair},
    derived=over(w_left[1], w_left[2]),
)
section.reference(
    "3.3/ref-2.3",
    "subsection with the parameters of relative orientation",
    printed="2.3",
    meant="2.4",
    note="The same finding as 2.4/ref-2.3.",
    same_as="2.4/ref-2.3",
)
section.reference(
    "3.3/ref-2.3#expressions",
    "subsection with the explicit expressions for mu",
    printed="2.3",
    meant="2.4",
    note="The same finding as 2.4/ref-2.3.",
    same_as="2.4/ref-2.3",
)
section.reference(
    "3.3/ref-2.3.9",
    "equation for the quotient of the coordinates of the epipole",
    printed="2.3.9",
    meant="3.2.9",
    note="There is no (2.3.9), neither in 2.3 nor in 2.4; (3.2.9) gives z_N as this quotient.",
)
section.limit(
    "3.3/quotient#limit",
    "the quotient in the limit",
    printed=-z_n,
    derived=over(u01, u02),
    variable=eps,
)
section.reference(
    "3.3/ref-3.3.7",
    "display with the limiting process",
    printed="3.3.7",
    meant="3.3",
    note="(3.3.7) gives tau'2 and tau''2, without any limit.  Meant is the display of subsection 3.3 with the limit of "
    "u01/u02, which has no number: 3.3/quotient#limit.",
)
section.limit(
    "3.3/first-equation",
    "the first equation equals zero",
    printed=vector(0, -z_n),
    derived=vector(over(1, u02), over(u01, u02)),
    variable=eps,
    note="The first and second component of the epipole (1, u01, u02), the third being 1: the left side of the first "
    "equation of (2.3.0) vanishes against the others.",
)

# %% [markdown]
# a) Left bundle, with $\mu_1 = \mu_2$: two equations for two unknowns, before the limit.

# %%
weights = weights_of(y_a).subs(mu2, mu1)
epipole_symbols = sympy.symbols("u01 u02")
AT_EPIPOLE = dict(zip(epipole_symbols, (u01, u02), strict=True))


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
    printed=D_left,
    where=AXIS,
    derived=over(determinant(left_system[0]), epipole_symbols[1]).xreplace(AT_EPIPOLE),
    variable=eps,
)
section.limit(
    "3.3.8#mu1",
    "first and second parameter of the left bundle",
    printed=-ya0 * ya3 * sum_n / D_left,
    where=AXIS,
    derived=left_solution[0].xreplace(AT_EPIPOLE),
    variable=eps,
)
section.limit(
    "3.3.8#mu3",
    "third parameter of the left bundle",
    printed=ya0 * (ya1 + z_n * ya2) / D_left,
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
mu_left_printed = vector(-ya0 * ya3 * sum_n, -ya0 * ya3 * sum_n, ya0 * (ya1 + z_n * ya2)) / D_left
section.identity(
    "3.3.8",
    "parameters of the left bundle, from the epipole at infinity",
    printed=mu_left_printed,
    where=AXIS,
    derived=mu_left,
)

# %% [markdown]
# b) Right bundle: $\mathbf y_A$ and the left center $\mathbf y_0$ are projected to the epipole.  Each gives $\mu_1$ and
# $\mu_2$ in terms of $\mu_3$.

# %%
u00 = 1 - epipole_symbols[0] - epipole_symbols[1]
section.limit(
    "3.3.9#u00",
    "the quotient u00/u02",
    printed=z_n - 1,
    derived=over(u00, epipole_symbols[1]).xreplace(AT_EPIPOLE),
    variable=eps,
)
FOURTH_RIGHT = dict(zip((un31, un32), right_fourth, strict=True))
systems = {
    name: linear_system(epipole_equations(weights_of(axis_point).xreplace(FOURTH_RIGHT)), [mu1, mu2])
    for name, axis_point in (("yA", y_a), ("y0", center))
}
solutions = {name: solve(*system) for name, system in systems.items()}
section.limit(
    "3.3.9#D",
    "divisor of the right bundle",
    printed=ya1 * ya2 * (z_n - 1),
    derived=over(determinant(systems["yA"][0]), epipole_symbols[1]).xreplace(AT_EPIPOLE),
    variable=eps,
)
r31, r32 = right_fourth
sum_r = r31 + z_n * r32
BOTH = AXIS | BARYCENTRIC
for name, (c0, c1, c2, c3) in (("yA", (ya0, ya1, ya2, ya3)), ("y0", (y00, y01, y02, y03))):
    for i, printed in enumerate(
        (
            (c3 * (sum_r - z_n) * mu3 - z_n * c0) / (c1 * (z_n - 1)),
            (c3 * (1 - sum_r) * mu3 + c0) / (c2 * (z_n - 1)),
        )
    ):
        section.limit(
            f"3.3.9#mu{i + 1}({name})",
            f"parameter mu{i + 1} of the right bundle, from {name}",
            printed=printed,
            where=BOTH,
            derived=solutions[name][i].xreplace(AT_EPIPOLE),
            variable=eps,
            note="" if name == "yA" else "y0 is the center of the left image.",
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
        note="The printed equation, solved for mu3.",
    )

# %% [markdown]
# Without a limit: the homogeneous coordinates $(w_0, w_1, w_2)$ of the images of $\mathbf y_A$ and $\mathbf y_0$
# satisfy $w_0 = 0$ and $w_1 + z_N w_2 = 0$.  These are four equations for three unknowns, consistent because the base
# passes through both points; the parameters of the left image satisfy them.

# %%
right_weights = {name: weights_of(p).xreplace(FOURTH_RIGHT) for name, p in (("yA", y_a), ("y0", center))}
section.identity(
    "3.3/equal-mu",
    "the parameters of both bundles are equal",
    printed=Matrix.zeros(4, 1),
    derived=vector(*(equation for w in right_weights.values() for equation in infinite_equations(w))).xreplace(
        {z_n: z_of_pair} | dict(zip((*y_a, *center), (*axis_of_mu, *y0_left), strict=True))
    ),
    note="The equations for the parameters of the right bundle are satisfied by the parameters of the left one.",
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

# %% [markdown]
# ## Code
#
# Inserted one after the other, $\mu_3$ would cancel again in $\mu_1$ and $\mu_2$ where it is large.  The forms below
# are quotients with the products that cancel taken out.

# %%
ABOUT_AXIS = "Point (yA1, yA2, yA3) of the epipolar axis in affine coordinates; dimensionless."
ABOUT_ZN = "Factor z_N of the normal case correlation; dimensionless."
weighted, difference, common, s0, s1, sz = sympy.symbols("weighted difference common s0 s1 sz")
EXAMPLE_AXIS = {"y_a": ("-1.0", "0.5", "3.5")}

section.kernel(
    "normal_case.mu_left",
    "Projective parameters of the left image of a normal case, with mu1 = mu2.",
    arguments={"y_a": y_a, "u3": normal_fourth_image, "z_n": z_n},
    describe={
        "y_a": ABOUT_AXIS,
        "u3": "Image (uN31, uN32) of the fourth basic point in the left normal case image; dimensionless.",
        "z_n": ABOUT_ZN,
    },
    derived=mu_left,
    form=vector(
        -ya0 * weighted / difference,
        -ya0 * weighted / difference,
        ya0 * (ya1 + z_n * ya2) / (ya3 * difference),
    ),
    where=AXIS | {weighted: sum_n, difference: (ya1 + ya2) * weighted - (ya1 + z_n * ya2)},
    claims=["3.3.8", "3.3.8#mu1", "3.3.8#mu3"],
    example={**EXAMPLE_AXIS, "u3": ("0.270614", "0.062048"), "z_n": "0.1214564"},
)
section.kernel(
    "normal_case.mu_right",
    "Projective parameters of the right image of a normal case.",
    arguments={"y_a": y_a, "y0": center, "u3": right_fourth, "z_n": z_n},
    describe={
        "y_a": ABOUT_AXIS,
        "y0": "Center of projection (y01, y02, y03) of the left image in affine coordinates; dimensionless.",
        "u3": "Image (uppN31, uppN32) of the fourth basic point in the right normal case image; dimensionless.",
        "z_n": ABOUT_ZN,
    },
    derived=mu_right,
    form=vector(
        (
            z_n * s1 * ya2 * ((1 - ya1 - ya2) * y03 + y02 * ya3)
            + s0 * (1 - z_n) * ya3 * ((1 - ya1 - ya3) * y02 + y03 * ya2)
            - sz * ya2 * ya3 * (1 - y01)
        )
        / ((1 - z_n) * s1 * common * ya1),
        ((1 - ya1 - ya2) * y03 - (1 - y01 - y02) * ya3) / ((z_n - 1) * common),
        ((1 - y01 - y03) * ya2 - (1 - ya1 - ya3) * y02) / (s1 * common),
    ),
    where={
        s0: sum_r,
        s1: z_n * r32 - (1 - r31),
        sz: r31 - z_n * (1 - r32),
        common: ya2 * y03 - y02 * ya3,
    },
    claims=["3.3.9", "3.3.9#mu1(yA)", "3.3.9#mu2(yA)", "3.3.9#mu3-second"],
    example={
        **EXAMPLE_AXIS,
        "y0": ("-1.1281689", "-0.2586740", "4.3209568"),
        "u3": ("0.309509", "-0.258189"),
        "z_n": "0.1214564",
    },
)

# %% [markdown]
# The second solution for any multiple of $\mathbf Z$: $z_N$ from entry (1, 2) and the parameters (3.3.5).  With
# $z_N$ inserted, the parameters of the right image lose the divisors $z_N$ and $z_{02}$.

# %%
z_any = Matrix(3, 3, sympy.symbols("z:3:3"))
z10 = z_any[1, 0]
DIVIDED = {element: over(element, z10) for element in (z01, z02, z12, z20)}
second_solution = vector(z_of_12, *parameters_of_z.xreplace({z_n: z_of_12})).xreplace(DIVIDED)
section.kernel(
    "normal_case.from_correlation",
    "Factor z_N and parameters (tau1, tau2) of both images for the normal case, from the matrix of correlation alone.",
    arguments={"Z": z_any},
    describe={"Z": "Singular matrix of correlation referred to the basic points, up to a factor; dimensionless."},
    derived={
        "z_N": second_solution[0],
        "tau_left": vector(second_solution[1], second_solution[2]),
        "tau_right": vector(second_solution[3], second_solution[4]),
    },
    form={
        "z_N": -z02 / (z10 + z12),
        "tau_left": vector(1, -z20 * (z10 + z12) / (z10 * z02)),
        "tau_right": vector(-z01 / z10, (z10 + z12) / z10),
    },
    claims=["3.3.5", "3.3.6#12", "3.3.7#left", "3.3.7#right", "3.3/manifold#second"],
    example={"Z": (("0", "-0.975", "-0.125"), ("1", "-0.025", "0.075"), ("0.125", "-0.083333", "0"))},
)

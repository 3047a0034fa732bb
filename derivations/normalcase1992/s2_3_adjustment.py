# %% [markdown]
# # 2.3 Adjustment
#
# Small rotations improve the approximate matrices of orientation.  The condition of coplanarity, linear in the
# rotations and in the residuals of the coordinates, is an observation equation of its own for each point.

# %%
import sympy

from algebroproj_derivations.drivers import adjust
from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, determinant, diff, dot, inverse, linear_system, over, vector

section = Section("normalcase1992", "2.3", "Adjustment")

# %% [markdown]
# ## Small rotations
#
# The exact derivatives of $\mathbf R(\Omega, \varphi, \kappa)$ where all angles are zero.

# %%
NO_TURN = {cosine: sympy.Integer(1) for cosine, _ in (OMEGA, PHI_RIGHT, KAPPA_RIGHT)}
NO_TURN |= {sine: sympy.Integer(0) for _, sine in (OMEGA, PHI_RIGHT, KAPPA_RIGHT)}
turn = turn_omega(*OMEGA) * turn_phi(*PHI_RIGHT) * turn_kappa(*KAPPA_RIGHT)
d_turn = sum(
    (
        change * derivative(turn, angle).xreplace(NO_TURN)
        for change, angle in ((domega, OMEGA), (dphi, PHI_RIGHT), (dkappa, KAPPA_RIGHT))
    ),
    Matrix.zeros(3, 3),
)
section.identity(
    "2.3/dA",
    "matrix of small rotations",
    printed=Matrix([[0, -dkappa, dphi], [dkappa, 0, -domega], [-dphi, domega, 0]]),
    derived=d_turn,
    note="The first order of dR - E, with the matrices of section 2.1.",
)

# %% [markdown]
# ## Linearisation
#
# The left image has no tilt.  The condition $\mathbf x'^T \mathbf R'^T \mathbf B \mathbf R'' \mathbf x'' = 0$ with
# $\mathbf R = (\mathbf E + d\mathbf A) (\mathbf R)$ and with residuals: a parameter $\varepsilon$ multiplies all that
# is small, and what is of first order is the derivative for $\varepsilon = 0$.

# %%
dphi_p, dkappa_p = sympy.symbols("dphip dkappap")
domega_pp, dphi_pp, dkappa_pp = sympy.symbols("domegapp dphipp dkappapp")
unknowns = (dphi_p, dkappa_p, domega_pp, dphi_pp, dkappa_pp)
small_left, small_right = (
    small_rotation(sympy.Integer(0), dphi_p, dkappa_p),
    small_rotation(domega_pp, dphi_pp, dkappa_pp),
)
vxp, vyp, vxpp, vypp = residuals = sympy.symbols("vxp vyp vxpp vypp")
v_left, v_right = vector(vxp, vyp, 0), vector(vxpp, vypp, 0)
B = matrix_of_base(unit_base)

section.identity(
    "2.3/dA'B",
    "product of the small rotations of the left image and B",
    printed=Matrix([[0, -dphi_p, -dkappa_p], [0, 0, 0], [0, 0, 0]]),
    derived=small_left.T * B,
    note="The scan lists the elements column by column.  As rows they would be the transpose, which is not the "
    "product.",
)
section.identity(
    "2.3/BdA''",
    "product of B and the small rotations of the right image",
    printed=Matrix([[0, 0, 0], [dphi_pp, -domega_pp, 0], [dkappa_pp, 0, -domega_pp]]),
    derived=B * small_right,
    note="The scan lists the elements column by column, as in 2.3/dA'B.",
)

small = sympy.Symbol("epsilon")
turned_left, turned_right = (E3 + small * small_left) * R_left, (E3 + small * small_right) * R_right
condition = dot(turned_left * (x_left + small * v_left), B * turned_right * (x_right + small * v_right))
first_order = diff(condition, small).subs(small, 0)
C = correlation(R_left, R_right, unit_base)
p_left, p_right = R_left * x_left, R_right * x_right
section.identity(
    "2.3/expansion",
    "condition of coplanarity without quantities of second order",
    printed=None,
    derived=condition.subs(small, 0) + first_order,
    expect="illegible",
    corrected=dot(x_left, C * x_right)
    + dot(v_left, C * x_right)
    + dot(x_left, C * v_right)
    + dot(p_left, small_left.T * B * p_right)
    + dot(p_left, B * small_right * p_right),
    note="The scan breaks off after the equals sign.  The products and substitutions that the text explains "
    "afterwards are the terms of this sum, and there is no other one.",
)
h_left, h_right = C * x_right, C.T * x_left
section.identity(
    "2.3/substitutions",
    "residuals with the epipolar lines",
    printed=vector(dot(h_left, v_left), dot(h_right, v_right)),
    derived=vector(dot(v_left, C * x_right), dot(x_left, C * v_right)),
)

# %% [markdown]
# ## The linearised equation
#
# $\delta p + \mathbf h' \mathbf v' + \mathbf h'' \mathbf v''$ on the left, the rotations on the right.

# %%
p1p, p2p, p3p = projector_left = vector(*sympy.symbols("p1p p2p p3p"))
p1pp, p2pp, p3pp = projector_right = vector(*sympy.symbols("p1pp p2pp p3pp"))
IN_IMAGES = dict(zip((*projector_left, *projector_right), (*p_left, *p_right), strict=True))
PRINTED = {
    dphi_p: ("dphi'", p1p * p2pp),
    dkappa_p: ("dkappa'", p1p * p3pp),
    domega_pp: ("dOmega''", -(p2pp * p2p + p3pp * p3p)),
    dphi_pp: ("dphi''", -p1pp * p2p),
    dkappa_pp: ("dkappa''", -p1pp * p3p),
}
SIGN = (
    "The sign is wrong: -dOmega'' stands twice in B dA'', and it changes on the way to the right side, as the signs of "
    "the other coefficients do.  Ruled out: a tilt of the other sense, for dA and B dA'' of the same page have the "
    "sense of (2.1.1).  It is no slip of the scan: all eight error equations of section 4 have the negative sign "
    "(first row -2545.03), so that the correction of the tilt found there has the wrong sign."
)
FOLLOWS = (
    "The correction of the tilt goes in the wrong direction, in all eight error equations of the example. See "
    "docs/findings/small-rotations.md."
)
for unknown, (name, coefficient) in PRINTED.items():
    verdict = (
        {"expect": "error", "corrected": -coefficient, "note": SIGN, "follows": FOLLOWS} if unknown == domega_pp else {}
    )
    section.identity(
        f"2.3/linear#{name}",
        f"coefficient of {name} in the linearised equation",
        printed=coefficient,
        where=IN_IMAGES,
        derived=-diff(first_order, unknown),
        **verdict,
    )
section.identity(
    "2.3/linear#left",
    "left side of the linearised equation",
    printed=dot(x_left, C * x_right) + dot(h_left, v_left) + dot(h_right, v_right),
    derived=(condition.subs(small, 0) + first_order).subs(dict.fromkeys(unknowns, 0)),
    note="The second line is h''; the scan shows h' twice.",
)
p_rotated = turn_phi(*PHI_LEFT) * turn_kappa(*KAPPA_LEFT) * projector_left, turn * projector_right
rotated = dot(p_rotated[0], B * p_rotated[1])
NO_TURN_LEFT = {c_phip: 1, c_kappap: 1, s_phip: 0, s_kappap: 0}
coefficients_of_projectors = vector(p1p * p2pp, p1p * p3pp, p2p * p2pp + p3p * p3pp, -p1pp * p2p, -p1pp * p3p)
section.identity(
    "2.3/beyond/finite",
    "the coefficients from finite rotations",
    printed=coefficients_of_projectors,
    derived=vector(
        *(
            (linear_system([rotated], angle)[0] * vector(angle[1], -angle[0])).xreplace(NO_TURN).subs(NO_TURN_LEFT)[0]
            for angle in (PHI_LEFT, KAPPA_LEFT, OMEGA, PHI_RIGHT, KAPPA_RIGHT)
        )
    ),
    note="Not in the paper: exact derivatives of the condition with dR in place of E + dA, at dR = E; the corrected "
    "sign of dOmega'' again.",
)

# %% [markdown]
# ## Fictitious residuals
#
# Residuals have no third component, nor do the products with the lines.

# %%
h1p, h2p, h3p = line_left = vector(*sympy.symbols("h1p h2p h3p"))
h1pp, h2pp, h3pp = line_right = vector(*sympy.symbols("h1pp h2pp h3pp"))
fictitious = dot(line_left.col_join(line_right), v_left.col_join(v_right))
section.identity(
    "2.3/w",
    "fictitious residual",
    printed=h1p * vxp + h2p * vyp + h1pp * vxpp + h2pp * vypp,
    derived=fictitious,
)


def variance_of(linear_form: sympy.Expr, variables: tuple[sympy.Symbol, ...], dispersion: Matrix) -> sympy.Expr:
    """Return the variance of a linear form of stochastic variables."""
    gradient = vector(*(diff(linear_form, variable) for variable in variables))
    return dot(gradient, dispersion * gradient)


gxp, gyp, gxpp, gypp = weights = sympy.symbols("gxp gyp gxpp gypp")
sigma = sympy.Symbol("sigma")
section.identity(
    "2.3/weight",
    "weight of a fictitious residual",
    printed=h1p**2 / gxp + h2p**2 / gyp + h1pp**2 / gxpp + h2pp**2 / gypp,
    derived=variance_of(fictitious, residuals, Matrix.diag(*(over(1, weight) for weight in weights))),
    note="The reciprocal weight is the variance, for uncorrelated coordinates with the variances 1/g.",
)
equal_variances = sigma**2 * Matrix.eye(4)
section.identity(
    "2.3.1",
    "weight of a fictitious residual for coordinates of equal variance",
    printed=sigma**2 * (h1p**2 + h2p**2 + h1pp**2 + h2pp**2),
    derived=variance_of(fictitious, residuals, equal_variances),
)

# %% [markdown]
# Each equation has residuals of its own: the scheme of the eight equations, and the dispersion of their fictitious
# residuals, which is diagonal.

# %%
numbers = range(1, 9)
all_residuals = [symbol for n in numbers for symbol in sympy.symbols(f"vxp_{n} vyp_{n} vxpp_{n} vypp_{n}")]


def of_point(expression: sympy.Expr, number: int) -> sympy.Expr:
    """Return an expression for one of the points: every symbol but those of the unknowns gets its number."""
    return expression.xreplace(
        {s: sympy.Symbol(f"{s.name}_{number}") for s in expression.free_symbols if s not in unknowns}
    )


equations = [of_point(fictitious - dot(coefficients_of_projectors, vector(*unknowns)), n) for n in numbers]
scheme = Matrix(8, 37, lambda i, j: diff(equations[i], (*all_residuals, *unknowns)[j]))
stars = Matrix(8, 37, lambda i, j: sympy.Symbol(f"s{i}_{j}") if j // 4 == i or j >= 32 else sympy.Integer(0))
section.structure(
    "table:2.3",
    "scheme of the linearised equations",
    printed=stars,
    derived=scheme,
    note="Coefficients of the 32 residuals and the five unknowns in eight equations.",
)
coefficients = scheme[:, :32]
section.identity(
    "2.3/uncorrelated",
    "the fictitious residuals of different points are not correlated",
    printed=Matrix.diag(*(of_point(sigma**2 * (h1p**2 + h2p**2 + h1pp**2 + h2pp**2), n) for n in numbers)).xreplace(
        {sympy.Symbol(f"sigma_{n}"): sigma for n in numbers}
    ),
    derived=sigma**2 * coefficients * coefficients.T,
    note="Why conditions with unknowns become observation equations with the weights (2.3.1).",
)

# %% [markdown]
# ## The determinant

# %%
section.identity(
    "2.3/det",
    "determinant of a matrix of correlation",
    printed=0,
    derived=determinant(C),
    note="For any matrices of orientation; eight measured points do not ensure it.",
)

# %% [markdown]
# ## Dispersion of the rotations
#
# Conditions with unknowns, $\mathbf B_v \mathbf v + \mathbf A\, d\mathbf a = \mathbf l$ with the dispersion
# $\sigma^2 \mathbf E$ of all coordinates.  The estimate is linear in the observed parallaxes $\mathbf l$; its
# dispersion follows by propagation.  Three equations with two unknowns show the general rule.

# %%
design = Matrix(3, 2, sympy.symbols("a:3:2"))
squares = sympy.symbols("w1:4")
weight_matrix = Matrix.diag(*(over(1, square) for square in squares))
normal = design.T * weight_matrix * design
Q = inverse(normal)
estimator = Q * design.T * weight_matrix
section.identity(
    "2.3/dispersion",
    "dispersion of the estimated rotations",
    printed=sigma**2 * Q,
    derived=estimator * (sigma**2 * Matrix.diag(*squares)) * estimator.T,
    note="w are the sums of squares in (2.3.1), Q is the inverse matrix of normal equations with the weights 1/w.",
)
section.identity(
    "2.3/beyond/unbiased",
    "the estimator reproduces the unknowns",
    printed=Matrix.eye(2),
    derived=estimator * design,
    note="Not in the paper.",
)
Q_all = Matrix(5, 5, lambda i, j: sympy.Symbol(f"Q{min(i, j) + 1}_{max(i, j) + 1}"))
Q11, Q12, Q22 = Q_all[:2, :2], Q_all[:2, 2:], Q_all[2:, 2:]
section.identity(
    "2.3.2",
    "dispersion by images",
    printed=sigma**2 * Q11.row_join(Q12).col_join(Q12.T.row_join(Q22)),
    derived=sigma**2 * Q_all,
    note="A dispersion is symmetric: the lower block is the transpose of the upper one.",
)

# %% [markdown]
# The left image is not tilted: its three rotations are $(0, d\varphi', d\kappa')$.

# %%
of_left = Matrix.zeros(1, 5).col_join(Matrix.eye(2).row_join(Matrix.zeros(2, 3)))
of_right = Matrix.zeros(3, 2).row_join(Matrix.eye(3))
S_a = sigma**2 * Q_all
s_phiphi, s_phikappa, s_kappakappa = sympy.symbols("s_phiphi s_phikappa s_kappakappa")
s_omegaomega, s_omegaphi, s_omegakappa = sympy.symbols("s_omegaomega s_omegaphi s_omegakappa")
IN_Q_LEFT = dict(zip((s_phiphi, s_phikappa, s_kappakappa), (S_a[0, 0], S_a[0, 1], S_a[1, 1]), strict=True))
section.identity(
    "2.3/S_a'",
    "dispersion of the rotations of the left image",
    printed=Matrix.hstack(
        sigma**2 * Matrix.diag(0, Q11), Matrix([[0, 0, 0], [0, s_phiphi, s_phikappa], [0, s_phikappa, s_kappakappa]])
    ),
    where=IN_Q_LEFT,
    derived=Matrix.hstack(*(of_left * S_a * of_left.T,) * 2),
    note="Both members: by blocks, and element by element.",
)
IN_Q_RIGHT = dict(
    zip(
        (s_omegaomega, s_omegaphi, s_omegakappa, s_phiphi, s_phikappa, s_kappakappa),
        (S_a[2, 2], S_a[2, 3], S_a[2, 4], S_a[3, 3], S_a[3, 4], S_a[4, 4]),
        strict=True,
    )
)
section.identity(
    "2.3/S_a''",
    "dispersion of the rotations of the right image",
    printed=(sigma**2 * Q22).row_join(
        Matrix([[s_omegaphi, s_omegakappa], [s_phiphi, s_phikappa], [s_phikappa, s_kappakappa]])
    ),
    where=IN_Q_RIGHT,
    derived=(of_right * S_a * of_right.T).row_join(of_right * S_a * of_right[1:, :].T),
    note="The first member, and the last two columns of the matrix of variances; the scan has lost the first one, and "
    "lists the others as rows.",
)
section.identity(
    "2.3/S_a''#first-column",
    "the lost column of the dispersion of the rotations of the right image",
    printed=None,
    where=IN_Q_RIGHT,
    derived=of_right * S_a * of_right[0, :].T,
    expect="illegible",
    corrected=vector(s_omegaomega, s_omegaphi, s_omegakappa),
    note="By the symmetry of the matrix.",
)

# %% [markdown]
# ## Code
#
# The row of one point; the right side is its parallax $\delta p$.

# %%
coefficients_of_rotations = vector(*(-diff(first_order, unknown) for unknown in unknowns))
section.kernel(
    "metric.coplanarity_row",
    "Coefficients of the small rotations (dphi', dkappa', dOmega'', dphi'', dkappa'') in the equation of coplanarity.",
    arguments={
        "x_left": vector(xp, yp),
        "x_right": vector(xpp, ypp),
        "R_left": R_left,
        "R_right": R_right,
        "c": c,
    },
    describe={
        "x_left": "Left image point (x', y'), centered at the principal point, in the unit of c.",
        "x_right": "Homologous right image point (x'', y''), centered at the principal point, in the unit of c.",
        "R_left": ABOUT_R_LEFT,
        "R_right": ABOUT_R_RIGHT,
        "c": ABOUT_C + "  The coefficients, for rotations in radians, have the square of this unit.",
    },
    derived=coefficients_of_rotations,
    form=coefficients_of_projectors,
    where=IN_IMAGES,
    claims=[*(f"2.3/linear#{name}" for name, _ in PRINTED.values()), "2.3/beyond/finite"],
    example={
        "x_left": ("-10.62", "1.694"),
        "x_right": ("-1.851", "2.316"),
        "R_left": (("0.96", "0", "-0.28"), ("0", "1", "0"), ("0.28", "0", "0.96")),
        "R_right": (("0.96", "0", "0.28"), ("0", "1", "0"), ("-0.28", "0", "0.96")),
        "c": "51.18",
    },
)
section.driver("metric.adjust", adjust)

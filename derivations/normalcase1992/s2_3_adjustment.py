# %% [markdown]
# # 2.3 Adjustment
#
# Eight measured points determine $\mathbf Z$, and not quite two rotations.  How are the five angles found that fit all
# points best?  Small rotations improve approximate matrices.  The condition of coplanarity, linear in the rotations and
# in the residuals of the coordinates, becomes an observation equation of its own for each point.

# %%
import sympy
from sympy import cos, sin

from algebroproj_derivations.figures import ImageDrawing
from algebroproj_derivations.inserting import given, inserted
from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    determinant,
    diff,
    dot,
    homogeneous,
    inverse,
    over,
    taylor,
    vector,
)

section = Section("normalcase1992", "2.3", "Adjustment")

# %% [markdown]
# ## What is a small rotation?
#
# **Definition.**  What is of first order in $\mathbf R(d\Omega, d\varphi, d\kappa) - \mathbf E$, with the rotations of
# section 2.1.

# %%
angles = (domega, dphi, dkappa)
about_x, about_y, about_z = (
    turn(cos(angle), sin(angle)) for turn, angle in zip((turn_omega, turn_phi, turn_kappa), angles, strict=True)
)
d_turn = (about_x * about_y * about_z - E3).applyfunc(lambda entry: taylor(entry, angles, 1))
d_turn

# %% [markdown]
# **Print.**

# %%
section.identity(
    "2.3/dA",
    "matrix of small rotations",
    printed=Matrix([[0, -dkappa, dphi], [dkappa, 0, -domega], [-dphi, domega, 0]]),
    derived=d_turn,
)

# %% [markdown]
# ## How does the condition change?
#
# **Definition.**  The left image has no tilt.  The condition $\mathbf x'^T \mathbf R'^T \mathbf B \mathbf R'' \mathbf
# x'' = 0$ with $\mathbf R = (\mathbf E + d\mathbf A) (\mathbf R)$ and with residuals: a parameter $\varepsilon$
# multiplies all that is small, and what is of first order is the derivative for $\varepsilon = 0$.

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


# %% [markdown]
# **Print.**  Two products that the paper needs.  The scan lists their elements column by column; as rows they would be
# the transposes.

# %%
section.identity(
    "2.3/dA'B",
    "product of the small rotations of the left image and B",
    printed=Matrix([[0, -dphi_p, -dkappa_p], [0, 0, 0], [0, 0, 0]]),
    derived=small_left.T * B,
)
section.identity(
    "2.3/BdA''",
    "product of B and the small rotations of the right image",
    printed=Matrix([[0, 0, 0], [dphi_pp, -domega_pp, 0], [dkappa_pp, 0, -domega_pp]]),
    derived=B * small_right,
)

# %% [markdown]
# **Derivation.**  The condition with all that is small, and its derivative.  The scan breaks off after the equals sign.
# The products and substitutions that the text explains afterwards are the terms of this sum, and there is no other one.

# %%
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

# %% [markdown]
# The residuals enter through the epipolar lines.

# %%
h_left, h_right = C * x_right, C.T * x_left
section.identity(
    "2.3/substitutions",
    "residuals with the epipolar lines",
    printed=vector(dot(h_left, v_left), dot(h_right, v_right)),
    derived=vector(dot(v_left, C * x_right), dot(x_left, C * v_right)),
)

# %% [markdown]
# ## Which equation is linear in the rotations?
#
# **Print.**  $\delta p + \mathbf h' \mathbf v' + \mathbf h'' \mathbf v''$ on the left, the rotations on the right.

# %%
p1p, p2p, p3p = projector_left = vector(*sympy.symbols("p1p p2p p3p"))
p1pp, p2pp, p3pp = projector_right = vector(*sympy.symbols("p1pp p2pp p3pp"))
IN_IMAGES = given((*projector_left, *projector_right), (*p_left, *p_right))
NAMES = {
    dphi_p: "dphi'",
    dkappa_p: "dkappa'",
    domega_pp: "dOmega''",
    dphi_pp: "dphi''",
    dkappa_pp: "dkappa''",
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
for unknown, name in NAMES.items():
    verdict = (
        {"expect": "error", "corrected": p2pp * p2p + p3pp * p3p, "note": SIGN, "follows": FOLLOWS}
        if unknown == domega_pp
        else {}
    )
    section.identity(
        f"2.3/linear#{name}",
        f"coefficient of {name} in the linearised equation",
        where=IN_IMAGES,
        derived=-diff(first_order, unknown),
        **verdict,
    )
section.identity(
    "2.3/linear#left",
    "left side of the linearised equation",
    printed=dot(x_left, C * x_right) + dot(h_left, v_left) + dot(h_right, v_right),
    derived=(condition.subs(small, 0) + first_order).subs(dict.fromkeys(unknowns, 0)),
)

# %% [markdown]
# **Which sign has $d\Omega''$?**  A second derivation decides: exact derivatives of the condition with finite rotations
# $d\mathbf R$ in place of $\mathbf E + d\mathbf A$, at $d\mathbf R = \mathbf E$.  The sign is plus.

# %%
turn = turn_omega(*OMEGA) * turn_phi(*PHI_RIGHT) * turn_kappa(*KAPPA_RIGHT)
p_rotated = turn_phi(*PHI_LEFT) * turn_kappa(*KAPPA_LEFT) * projector_left, turn * projector_right
rotated = dot(p_rotated[0], B * p_rotated[1])
coefficients_of_projectors = vector(p1p * p2pp, p1p * p3pp, p2p * p2pp + p3p * p3pp, -p1pp * p2p, -p1pp * p3p)
section.identity(
    "2.3/beyond/finite",
    "the coefficients from finite rotations",
    printed=dot(projector_left, B * projector_right) - dot(coefficients_of_projectors, vector(*ANGLES)),
    derived=taylor(rotated, ANGLES, 1),
)

# %% [markdown]
# ## With which weight?
#
# **Definition.**  The residuals of one equation are put together to a single one, the fictitious residual.  They have
# no third component, nor do the products with the lines.

# %%
h1p, h2p, h3p = line_left = vector(*sympy.symbols("h1p h2p h3p"))
h1pp, h2pp, h3pp = line_right = vector(*sympy.symbols("h1pp h2pp h3pp"))
fictitious = dot(line_left.col_join(line_right), v_left.col_join(v_right))
section.identity(
    "2.3/w",
    "fictitious residual",
    derived=fictitious,
)


# %% [markdown]
# **Print.**  Its reciprocal weight is its variance, for coordinates that are not correlated.


# %%
def variance_of(linear_form: sympy.Expr, variables: tuple[sympy.Symbol, ...], dispersion: Matrix) -> sympy.Expr:
    """Return the variance of a linear form of stochastic variables."""
    gradient = vector(*(diff(linear_form, variable) for variable in variables))
    return dot(gradient, dispersion * gradient)


weights = sympy.symbols("gxp gyp gxpp gypp")
sigma = sympy.Symbol("sigma")
section.identity(
    "2.3/weight",
    "weight of a fictitious residual",
    derived=variance_of(fictitious, residuals, Matrix.diag(*(over(1, weight) for weight in weights))),
)
equal_variances = sigma**2 * Matrix.eye(4)
section.identity(
    "2.3.1",
    "weight of a fictitious residual for coordinates of equal variance",
    derived=variance_of(fictitious, residuals, equal_variances),
)

# %% [markdown]
# **An example.**  The left image has a tip, and the right one a swing, both of the sine $7/25$.  The line of the right
# point misses the left point $p$; the residuals move $p$ to the foot $q$, the nearest point of the line.

# %%
TIP, SWING = (about(sympy.Rational(24, 25), sympy.Rational(7, 25)) for about in (turn_phi, turn_kappa))
line = of_rectangular(2).T * correlation(TIP, SWING, unit_base) * inserted(x_right, (xpp, ypp, c), (1, 1, 2))
measured = vector(1, 1)
direction = line[1:, :]
misclosure = dot(line, homogeneous(measured)) / dot(direction, direction)
ImageDrawing(
    "A measured point p of the left image, the line on which it should lie, and the foot q.  Here the right image has "
    "no error.",
    {"left image": ({"p": measured, "q": measured - misclosure * direction, "H": vector(0, 0)}, [line])},
    axes=("x", "y"),
)

# %% [markdown]
# **Why is each equation an observation equation?**  Each has residuals of its own.  In the scheme of the eight
# equations, 32 residuals and five unknowns, no two rows share one.  So the dispersion of the fictitious residuals is
# diagonal, and conditions with unknowns become observation equations with the weights (2.3.1).

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
)
coefficients = scheme[:, :32]
section.identity(
    "2.3/uncorrelated",
    "the fictitious residuals of different points are not correlated",
    printed=Matrix.diag(*(of_point(sigma**2 * (h1p**2 + h2p**2 + h1pp**2 + h2pp**2), n) for n in numbers)).xreplace(
        {sympy.Symbol(f"sigma_{n}"): sigma for n in numbers}
    ),
    derived=sigma**2 * coefficients * coefficients.T,
)

# %% [markdown]
# **And the determinant?**  That of a matrix of correlation is zero for any matrices of orientation.  Eight measured
# points do not ensure it; the adjustment does.

# %%
section.identity(
    "2.3/det",
    "determinant of a matrix of correlation",
    derived=determinant(C),
)

# %% [markdown]
# ## How uncertain are the rotations?
#
# **Definition.**  Conditions with unknowns, $\mathbf B_v \mathbf v + \mathbf A\, d\mathbf a = \mathbf l$ with the
# dispersion $\sigma^2 \mathbf E$ of all coordinates.  The estimate is linear in the observed parallaxes $\mathbf l$;
# its dispersion follows by propagation.  Three equations with two unknowns show the general rule: $w$ are the sums of
# squares in (2.3.1), and $\mathbf Q$ is the inverse of the normal equations with the weights $1 / w$.

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
)
section.identity(
    "2.3/beyond/unbiased",
    "the estimator reproduces the unknowns",
    printed=Matrix.eye(2),
    derived=estimator * design,
)

# %% [markdown]
# **Print.**  By images, two rotations of the left one and three of the right one.  A dispersion is symmetric.

# %%
Q_all = Matrix(5, 5, lambda i, j: sympy.Symbol(f"Q{min(i, j) + 1}_{max(i, j) + 1}"))
Q11, Q12, Q22 = Q_all[:2, :2], Q_all[:2, 2:], Q_all[2:, 2:]
section.identity(
    "2.3.2",
    "dispersion by images",
    printed=sigma**2 * Q11.row_join(Q12).col_join(Q12.T.row_join(Q22)),
    derived=sigma**2 * Q_all,
)

# %% [markdown]
# **With three rotations of each image.**  The left image is not tilted: its three rotations are $(0, d\varphi',
# d\kappa')$.

# %%
of_left = Matrix.zeros(1, 5).col_join(Matrix.eye(2).row_join(Matrix.zeros(2, 3)))
of_right = Matrix.zeros(3, 2).row_join(Matrix.eye(3))
S_a = sigma**2 * Q_all
s_phiphi, s_phikappa, s_kappakappa = sympy.symbols("s_phiphi s_phikappa s_kappakappa")
s_omegaomega, s_omegaphi, s_omegakappa = sympy.symbols("s_omegaomega s_omegaphi s_omegakappa")
IN_Q_LEFT = given((s_phiphi, s_phikappa, s_kappakappa), (S_a[0, 0], S_a[0, 1], S_a[1, 1]))
section.identity(
    "2.3/S_a'",
    "dispersion of the rotations of the left image",
    printed=Matrix.hstack(
        sigma**2 * Matrix.diag(0, Q11), Matrix([[0, 0, 0], [0, s_phiphi, s_phikappa], [0, s_phikappa, s_kappakappa]])
    ),
    where=IN_Q_LEFT,
    derived=Matrix.hstack(*(of_left * S_a * of_left.T,) * 2),
)

# %% [markdown]
# **And of the right image.**  The scan has lost the first column of the matrix of variances and lists the others as
# rows.

# %%
IN_Q_RIGHT = given(
    (s_omegaomega, s_omegaphi, s_omegakappa, s_phiphi, s_phikappa, s_kappakappa),
    (S_a[2, 2], S_a[2, 3], S_a[2, 4], S_a[3, 3], S_a[3, 4], S_a[4, 4]),
)
section.identity(
    "2.3/S_a''",
    "dispersion of the rotations of the right image",
    printed=(sigma**2 * Q22).row_join(
        Matrix([[s_omegaphi, s_omegakappa], [s_phiphi, s_phikappa], [s_phikappa, s_kappakappa]])
    ),
    where=IN_Q_RIGHT,
    derived=(of_right * S_a * of_right.T).row_join(of_right * S_a * of_right[1:, :].T),
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

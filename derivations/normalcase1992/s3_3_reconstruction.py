# %% [markdown]
# # 3.3 Propagation of errors concerning reconstruction
#
# How uncertain is a point of the model?  It is a function of three coordinates of the normal case, $x'_N$, $y'_N$ and
# $x''_N$.  Its exact Jacobian matrix takes their dispersion to that of the point.

# %%
import sympy
from sympy import BlockMatrix, Eq, MatrixSymbol

from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_derivations.normalcase1992.s3_2_propagation import estimator, parallax_rows
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, columns, diff, dot, linear_system, solve, vector
from algebroproj_sym.expressions.letters import Directional

section = Section("normalcase1992", "3.3", "Propagation of errors concerning reconstruction")

# %%
section.reference(
    "3.3/ref-S_N",
    "the dispersion of the image coordinates",
    meant="3.2.2",
    note="(3.3.2) is the differential of the factor, further down.",
)

# %% [markdown]
# ## How does a point of the model change?
#
# **Definition.**  $\mathbf X = \mathbf X'_0 + \lambda_N \mathbf x'_N$ with $\lambda_N = 1 / (x'_N - x''_N)$, sections
# 1.3 and 3.1; the center and the principal distance do not vary.  The factor takes both images to the same abscissa of
# the model.

# %%
lam_n, dlam, dxp, dyp, dxpp, dypp = sympy.symbols("lam_n dlam dxp dyp dxpp dypp")
X0_left = vector(*sympy.symbols("X01 X02 X03"))
(factor,) = solve(*linear_system([(lam_n * x_left - unit_base - lam_n * x_right)[0]], [lam_n]))
point = X0_left + factor * x_left
coordinates, shifts = (xp, yp, xpp), (dxp, dyp, dxpp)


def differential(expression):
    zero = expression * 0
    return sum((diff(expression, q) * dq for q, dq in zip(coordinates, shifts, strict=True)), zero)


# %% [markdown]
# **Print.**  The factor decreases with $x'$.

# %%
X_bold, X0_bold, normal_bold, d_normal_bold = (MatrixSymbol(name, 3, 1) for name in ("X", "X0", "xN", "dxN"))
section.identity(
    "3.3.1",
    "differential of a model point",
    printed=dlam * normal_bold + lam_n * d_normal_bold,
    constraints=[Eq(X_bold, X0_bold + lam_n * normal_bold)],
    derived=Directional(X_bold, lam_n, dlam) + Directional(X_bold, normal_bold, d_normal_bold),
)
section.identity(
    "3.3.2",
    "differential of the factor",
    printed=None,
    where={lam_n: factor},
    derived=columns(*(Matrix([differential(factor)]),) * 2),
    expect="illegible",
    corrected=columns(Matrix([(dxpp - dxp) / (xp - xpp) ** 2]), Matrix([lam_n**2 * (dxpp - dxp)])),
    note="The scan has lost all primes, in 'dx - dx' as well.  The minuend must be dx'': the factor decreases with x'.",
)

# %% [markdown]
# ## What is the dispersion?
#
# **Definition.**  The dispersion $\boldsymbol\Sigma$ of the coordinates $x'_N, y'_N, x''_N, y''_N$ of both images.  The
# expectation of a product of two differentials is the bilinear form of $\boldsymbol\Sigma$ with their derivatives.

# %%
names = ("xp", "yp", "xpp", "ypp")
Sigma = Matrix(4, 4, lambda r, s: sympy.Symbol(f"s_{names[min(r, s)]}_{names[max(r, s)]}"))
all_shifts = (dxp, dyp, dxpp, dypp)


def expectation(first: sympy.Expr, second: sympy.Expr) -> sympy.Expr:
    """Return the expectation of the product of two linear forms of the differentials."""
    gradients = (vector(*(diff(form, shift) for shift in all_shifts)) for form in (first, second))
    left, right = gradients
    return dot(left, Sigma * right)


d_factor, d_left, d_right = differential(factor), vector(dxp, dyp, 0), vector(dxpp, dypp, 0)
d_point = differential(point)
of_factor = expectation(d_factor, d_factor)
of_factor_and_image = vector(*(expectation(d_factor, component) for component in d_left))
of_image = Matrix(3, 3, lambda r, s: expectation(d_left[r], d_left[s]))
S_M = Matrix(3, 3, lambda r, s: expectation(d_point[r], d_point[s]))

s_xx, s_xy, s_yy = Sigma[0, 0], Sigma[0, 1], Sigma[1, 1]
s_xxpp, s_yxpp, s_xppxpp = Sigma[0, 2], Sigma[1, 2], Sigma[2, 2]
WITH_FACTOR = {lam_n: factor}

# %% [markdown]
# **Print.**  The dispersion of a point is made of four expectations, which follow one by one.

# %%
v_factor, r_mixed, S_image = sympy.Symbol("v"), MatrixSymbol("r", 3, 1), MatrixSymbol("S", 3, 3)
of_factor_and_image_point = BlockMatrix([[sympy.ImmutableMatrix([[v_factor]]), r_mixed.T], [r_mixed, S_image]])
differential_of_point = BlockMatrix([[normal_bold, lam_n * sympy.Identity(3)]])
section.identity(
    "3.3/dispersion",
    "dispersion of a model point, by expectations",
    printed=v_factor * normal_bold * normal_bold.T
    + lam_n * (normal_bold * r_mixed.T + r_mixed * normal_bold.T)
    + lam_n**2 * S_image,
    properties={S_image: "symmetric"},
    derived=differential_of_point * of_factor_and_image_point * differential_of_point.T,
)
section.identity(
    "3.3/E#dlambda2",
    "variance of the factor",
    where=WITH_FACTOR,
    derived=of_factor,
)
section.identity(
    "3.3/E#dlambda-dx-row",
    "covariances of the factor and the left image point, as a row",
    printed=None,
    where=WITH_FACTOR,
    derived=of_factor_and_image.T,
    expect="illegible",
    corrected=lam_n**2 * Matrix([[s_xxpp - s_xx, s_yxpp - s_xy, 0]]),
    note="The scan leaves the pattern lambda_N^2 [s - s, s + s, 0] and no primes.  The second sign must be a minus as "
    "the first one is: both come from dx'' - dx'.",
)
section.identity(
    "3.3/E#dlambda-dx-column",
    "covariances of the factor and the left image point, as a column",
    printed=None,
    where=WITH_FACTOR,
    derived=of_factor_and_image,
    expect="illegible",
    corrected=lam_n**2 * vector(s_xxpp - s_xx, s_yxpp - s_xy, 0),
    note="The scan shows four of the indices without the signs between them; it is the transpose of the row.",
)
section.identity(
    "3.3/E#dx-dx",
    "dispersion of the left image point",
    derived=of_image,
)

# %% [markdown]
# ## How are the two images correlated?
#
# **Definition.**  The covariances come from the rotations alone: $\mathbf B_a$ and $\mathbf B_x$ of section 3.2 for
# each image, dispersions of the rotations as in section 2.3, image coordinates not correlated with anything but
# themselves.

# %%
sigma = sympy.Symbol("sigma")
Q12 = Matrix(2, 3, sympy.symbols("q:2:3"))
Ba_left, Ba_right = (Matrix(2, 3, lambda r, s, n=n: sympy.Symbol(f"Ba{r + 1}{s + 1}{n}")) for n in ("p", "pp"))
Bx_left, Bx_right = (Matrix(2, 2, lambda r, s, n=n: sympy.Symbol(f"Bx{r + 1}{s + 1}{n}")) for n in ("p", "pp"))
Q_left = Matrix(2, 2, lambda r, s: sympy.Symbol(f"ql{min(r, s)}{max(r, s)}"))
Q_right = Matrix(3, 3, lambda r, s: sympy.Symbol(f"qr{min(r, s)}{max(r, s)}"))
rotations = sigma**2 * Q_left.row_join(Q12).col_join(Q12.T.row_join(Q_right))
joint = Matrix.diag(rotations, sigma**2 * Matrix.eye(4))
untilted = Matrix.zeros(1, 2).col_join(Matrix.eye(2))
jacobian_left = Matrix.hstack(Ba_left * untilted, Matrix.zeros(2, 3), Bx_left, Matrix.zeros(2, 2))
jacobian_right = Matrix.hstack(Matrix.zeros(2, 2), Ba_right, Matrix.zeros(2, 2), Bx_right)
covariances = jacobian_left * joint * jacobian_right.T
Q_mixed = Matrix.zeros(1, 3).col_join(Q12)
errors = sigma**2 * Matrix.eye(16)
of_left, of_right = (Matrix(16, 2, lambda r, s, first=first: int(r == first + s)) for first in (12, 14))

# %% [markdown]
# **Print.**  The left image is not tilted, and has a row of zeros.  For points that are not used in the adjustment
# image coordinates are independent of the rotations, as in section 3.2.

# %%
section.identity(
    "3.3/Q_a'''",
    "cofactors of the rotations of both images",
    printed=sigma**2 * Q_mixed,
    derived=Matrix.diag(untilted, Matrix.eye(3))[:3, :] * rotations * Matrix.zeros(2, 3).col_join(Matrix.eye(3)),
)
section.identity(
    "3.3/independent",
    "image coordinates are correlated neither with the rotations nor with those of the other image",
    printed=Matrix.zeros(2, 6),
    derived=((estimator * parallax_rows).row_join(Matrix.zeros(2, 4)) * errors * of_left.row_join(of_right)).row_join(
        of_left.T * errors * of_right
    ),
)
section.identity(
    "3.3/S_N'''",
    "covariances of the coordinates of both images",
    printed=sigma**2 * Ba_left * Q_mixed * Ba_right.T,
    derived=covariances,
    note="Q12 is that of the second pair of equations (2.3.1), (2.3.2), in section 2.3.",
)
section.identity(
    "3.3/S_N'''#elements",
    "elements of the covariances of both images",
    printed=None,
    derived=Matrix(2, 2, lambda r, s: expectation(d_left[r], d_right[s])),
    expect="illegible",
    corrected=Sigma[:2, 2:],
    note="The scan has a sign of transposition behind the matrix, whose rows belong to x', y' already, as those of "
    "E{dx' dx''^T}.  It may as well be the end of a bracket.",
)

# %% [markdown]
# **A sentence of section 2.3**: the dispersion of each image does not depend on the correlation $\mathbf Q_{12}$ of
# both.

# %%
section.identity(
    "3.3/separate",
    "the correlation of the images does not influence the transformations into the normal case",
    printed=Matrix.zeros(2, 24),
    derived=Matrix.hstack(
        *(
            diff(jacobian * joint * jacobian.T, element)
            for jacobian in (jacobian_left, jacobian_right)
            for element in Q12
        )
    ),
)

# %% [markdown]
# ## Which term dominates?
#
# **Print.**  The scan has lost the formula of the dispersion.  Put together from the expectations it is a sum of powers
# of $\lambda_N$, the first of which is the fourth.

# %%
first_term = lam_n**4 * (s_xppxpp + s_xx - 2 * s_xxpp) * x_left * x_left.T
row = Matrix([[s_xxpp - s_xx, s_yxpp - s_xy, 0]])
section.identity(
    "3.3/S_M",
    "dispersion of a model point",
    printed=None,
    where=WITH_FACTOR,
    derived=S_M,
    expect="illegible",
    corrected=first_term
    + lam_n**3 * (x_left * row + row.T * x_left.T)
    + lam_n**2 * Matrix([[s_xx, s_xy, 0], [s_xy, s_yy, 0], [0, 0, 0]]),
    note="The scan has lost the whole formula.  The text before it determines the form: the expectations in powers of "
    "lambda_N, of which the first term has the highest.  Derived is the exact propagation of first order, the "
    "quadratic form of the Jacobian matrix of X.",
)

# %% [markdown]
# **For small parallaxes** the first term is all: divided by $\lambda_N^4$, the dispersion tends to the variance of the
# parallax, times $\mathbf x' \mathbf x'^T$.

# %%
parallax = sympy.Symbol("parallax")
section.limit(
    "3.3/dominating",
    "the first term dominates for small parallaxes",
    printed=(s_xppxpp + s_xx - 2 * s_xxpp) * x_left * x_left.T,
    derived=(parallax**4 * S_M).subs(xpp, xp - parallax),
    variable=parallax,
)

# %% [markdown]
# **Meaning.**  A distant point is uncertain along its ray, and its standard error grows with the square of the
# distance:  half the parallax, four times the error.


# %%
CENTER, STEP = vector(0, 0, 4), sympy.Rational(1, 20)
RAY = {"P": vector(sympy.Rational(1, 2), 0, -1), "Q": vector(sympy.Rational(1, 2), 1, -1)}
DISTANCE = {"P": 2, "Q": 4}
places = {name: CENTER + DISTANCE[name] * RAY[name] for name in RAY}
SpaceDrawing(
    "Two points seen from two centers with c = 1, Q with half the parallax of P.  The pieces of the rays are what an "
    "uncertain parallax, of 1/20, makes of them: four times as long for Q.",
    {"C'": CENTER, "C''": CENTER + unit_base, **places}
    | {f"{name}-": places[name] - STEP * DISTANCE[name] ** 2 * RAY[name] for name in RAY}
    | {f"{name}+": places[name] + STEP * DISTANCE[name] ** 2 * RAY[name] for name in RAY},
    segments=[("C'", "P"), ("C'", "Q"), ("C''", "P"), ("C''", "Q"), ("P-", "P+"), ("Q-", "Q+"), ("C'", "C''")],
    axes=("X_1", "X_2", "X_3"),
)

# %% [markdown]
# The factor itself is printed with the wrong sign.

# %%
section.identity(
    "3.3/lambda",
    "the dominating factor",
    derived=factor,
    expect="misprint",
    corrected=1 / (xp - xpp),
    note="(1.3.2) has x' - x''.  A slip of the scan, which is unsure of primes, cannot be told from one of the print.",
)

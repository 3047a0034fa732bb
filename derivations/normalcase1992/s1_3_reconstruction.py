# %% [markdown]
# # 1.3 Reconstruction of the model
#
# In the normal case both matrices of orientation are $\mathbf E$.  What remains of the condition of intersection is
# linear in the two factors.  Where is the point?

# %%
import sympy
from sympy import Eq, MatrixSymbol

from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.inserting import given
from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_sym import Section
from algebroproj_sym.expressions import columns, cross, dot, linear_system, over, solve, vector
from algebroproj_sym.expressions.letters import Cross, Dot

section = Section("normalcase1992", "1.3", "Reconstruction of the model")

# %% [markdown]
# ## Which equation is left?
#
# **Definition.**  The point on both rays: $\mathbf X'_0 + \lambda' \mathbf x' = \mathbf X''_0 + \lambda'' \mathbf x''$.

# %%
lam_n, lam_p, lam_pp = sympy.symbols("lam_n lam_p lam_pp")
X0_left = vector(*sympy.symbols("X01 X02 X03"))
X0_right = X0_left + b
X = vector(*sympy.symbols("X1 X2 X3"))
PROJECTED = given((xp, yp, xpp, ypp), (*image_of(X - X0_left), *image_of(X - X0_right)))
PROJECTED |= {lam_p: over((X0_left - X)[2], c), lam_pp: over((X0_right - X)[2], c)}
section.identity(
    "1.3/difference",
    "difference of the two formulas of reconstruction",
    printed=None,
    where=PROJECTED,
    derived=b,
    expect="illegible",
    corrected=lam_p * x_left - lam_pp * x_right,
    note="The scan leaves 'lambda x - lambda x = -b' without primes, with remains of the multiplication by y_N behind "
    "it. The images of a point satisfy lambda' x' - lambda'' x'' = b; the other sign goes with the other order of the "
    "terms.  (1.3.1) follows from either.",
)
difference = (X0_left + lam_p * x_left) - (X0_right + lam_pp * x_right)

# %% [markdown]
# ## What are the factors?
#
# **Definition.**  A vector $\mathbf y_N = (c, 0, x_N)^T$ is $\mathbf x_N \times \mathbf e_2$, and
# perpendicular to $\mathbf x_N$.  The printed factors hold for any vector in the place of $\mathbf e_2$.  The factors
# follow without it as well, from the first and third component.

# %%
y_left, y_right = vector(c, 0, xp), vector(c, 0, xpp)
b1, b2, b3 = b
section.identity(
    "1.3/y",
    "the auxiliary vectors are perpendicular to the image vectors",
    printed=vector(0, 0),
    derived=vector(dot(x_left, y_left), dot(x_right, y_right)),
)
factor_left, factor_right = solve(*linear_system([difference[0], difference[2]], [lam_p, lam_pp]))
factor_left

# %% [markdown]
# **Print.**

# %%
xp_bold, xpp_bold, yp_bold, ypp_bold, b_bold, e2_bold = (
    MatrixSymbol(name, 3, 1) for name in ("xN_p", "xN_pp", "yN_p", "yN_pp", "b", "e2")
)
ON_BOTH = Eq(b_bold, lam_p * xp_bold - lam_pp * xpp_bold)
section.identity(
    "1.3.1#left",
    "factor of the left image",
    printed=over(Dot(b_bold, ypp_bold), Dot(xp_bold, ypp_bold)),
    constraints=[ON_BOTH, Eq(ypp_bold, Cross(xpp_bold, e2_bold))],
    derived=lam_p,
)
section.identity(
    "1.3.1#right",
    "factor of the right image",
    printed=-over(Dot(b_bold, yp_bold), Dot(xpp_bold, yp_bold)),
    constraints=[ON_BOTH, Eq(yp_bold, Cross(xp_bold, e2_bold))],
    derived=lam_pp,
)

# %% [markdown]
# ## And with the base $(1, 0, 0)^T$?
#
# **Definition.**  In rotational relative orientation the base is $(1, 0, 0)^T$, and both factors are the reciprocal of
# the parallax.

# %%
AT_UNIT_BASE = given(b, unit_base)
section.identity(
    "1.3/products#b",
    "product with the base",
    derived=vector(dot(unit_base, y_left), dot(unit_base, y_right)),
)
section.identity(
    "1.3/products#left", "product of the left image vector and the right auxiliary vector", derived=dot(x_left, y_right)
)
section.identity(
    "1.3/products#right",
    "product of the right image vector and the left auxiliary vector",
    derived=dot(x_right, y_left),
    expect="misprint",
    corrected=c * (xpp - xp),
    note="The scan repeats the right side of the product before, and reads x''.y'' on the left, which would be zero.  "
    "The denominator of lambda'' in (1.3.1) is x''.y', and only c (x'' - x') leads to (1.3.2).  A slip of the scan "
    "cannot be told from one of the print.",
)

# %% [markdown]
# **Print.**  The common factor:

# %%
section.identity(
    "1.3.2",
    "factor of reconstruction, the same for both images",
    derived=vector(factor_left, factor_right).subs(AT_UNIT_BASE),
)
factor = factor_left.subs(AT_UNIT_BASE)

# %% [markdown]
# **Where does it fail?**  For equal abscissas its reciprocal goes to zero.  Homologous points have equal ordinates,
# (3.1.2): then the projectors are parallel.

# %%
parallax = sympy.Symbol("parallax")
section.limit(
    "1.3/infinity",
    "the factor is infinite for equal abscissas",
    printed=0,
    derived=over(1, factor).subs(xpp, xp - parallax),
    variable=parallax,
)
section.identity(
    "1.3/parallel",
    "equal abscissas indicate parallel projectors",
    printed=vector(0, 0, 0),
    derived=cross(x_left, x_right),
    constraints=[xp - xpp, yp - ypp],
)

# %% [markdown]
# ## Where is the point?
#
# **Test.**  A point, projected into both images of the normal case, is reconstructed from them.

# %%
X0_right = X0_left + unit_base
IMAGES = {symbol: PROJECTED[symbol].subs(AT_UNIT_BASE) for symbol in (xp, yp, xpp, ypp)}
IN_NORMAL_CASE = IMAGES | {lam_n: factor.xreplace(IMAGES)}
section.identity(
    "1.3.3",
    "reconstruction from either image",
    printed=columns(X0_left + lam_n * x_left, X0_right + lam_n * x_right),
    where=IN_NORMAL_CASE,
    derived=columns(X, X),
)

# %% [markdown]
# **A check.**  Both images give a point.  The two results agree exactly if the ordinates do, whatever the abscissas
# are.

# %%
section.identity(
    "1.3/check",
    "the double determination is a check of the ordinates",
    printed=factor * vector(0, yp - ypp, 0),
    derived=(X0_left + factor * x_left) - (X0_right + factor * x_right),
)

# %% [markdown]
# **As a ratio of distances**, in squares, the factor is positive where the parallax is: for points in front of both
# cameras, whose third coordinate is below the centers.

# %%
section.identity(
    "1.3.4",
    "factor as the ratio of two distances",
    printed=vector(
        over(dot(X - X0_left, X - X0_left), dot(x_left, x_left)),
        over(dot(X - X0_right, X - X0_right), dot(x_right, x_right)),
    ),
    where=IMAGES,
    derived=vector(factor**2, factor**2).xreplace(IMAGES),
)
section.identity(
    "1.3/beyond/sign",
    "sign of the factor",
    printed=over(-X[2] + X0_left[2], c),
    derived=factor.xreplace(IMAGES),
)

# %% [markdown]
# **An example.**  A point, seen with $c = 1$ from $(0, 0, 4)$ and $(1, 0, 4)$.

# %%
CENTER, POINT = vector(0, 0, 4), vector(sympy.Rational(3, 2), 1, 0)
rays = {"C'": CENTER, "C''": CENTER + unit_base}
seen = {name + "p": C0 + (POINT - C0) / 4 for name, C0 in rays.items()}
SpaceDrawing(
    "A point P, the two centers and its images p' and p'', here in front of the centers at the distance 1.",
    rays | {"P": POINT, "p'": seen["C'p"], "p''": seen["C''p"]},
    segments=[("C'", "P"), ("C''", "P"), ("C'", "C''")],
    axes=("X_1", "X_2", "X_3"),
)

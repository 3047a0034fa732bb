# %% [markdown]
# # 3.2 Propagation of errors concerning transformation
#
# The coordinates of the normal case depend on the rotations and on the image coordinates, and both are uncertain.  How
# uncertain are they?  Along $\mathbf R = (\mathbf E + \varepsilon\, d\mathbf A) \mathbf R$, $\mathbf x + \varepsilon\,
# d\mathbf x$ their exact derivatives for $\varepsilon = 0$ are the differentials.  The propagation of variances
# follows.

# %%
import sympy
from sympy import BlockMatrix, Eq, MatrixSymbol, ZeroMatrix

from algebroproj_derivations.figures import ImageDrawing
from algebroproj_derivations.inserting import given, inserted
from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, columns, diff, dot, linear_system, over, vector
from algebroproj_sym.expressions.letters import Directional, LeftPerturbed, Skew

section = Section("normalcase1992", "3.2", "Propagation of errors concerning transformation")

# %% [markdown]
# ## How do the coordinates change?
#
# **Definition.**

# %%
dx, dy, small = sympy.symbols("dx dy epsilon")
d_image, d_angles = vector(dx, dy, 0), (domega, dphi, dkappa)
small_turn = small_rotation(*d_angles)
projector = R_any * x_vector
moved = (E3 + small * small_turn) * R_any * (x_vector + small * d_image)


def rate(expression):
    """Return the differential: the derivative where nothing has moved yet."""
    return diff(expression, small).subs(small, 0)


xn, yn, tau, dtau, dxn, dyn = sympy.symbols("xN yN tau dtau dxN dyN")
coordinates, factor = image_of(projector), over(-projector[2], c)
d_coordinates, d_factor = rate(image_of(moved)), rate(over(-moved[2], c))
OF_IMAGE = given((xn, yn, tau), (*coordinates, factor))
DIFFERENTIALS = OF_IMAGE | given((dxn, dyn, dtau), (*d_coordinates, d_factor))

# %% [markdown]
# **Print.**  First the differential of the projective transformation (1.1.4), as vectors.

# %%
R, turn_of_axes = MatrixSymbol("R", 3, 3), MatrixSymbol("dA", 3, 3)
a_bold, x_bold, dx_bold, normal_bold, d_normal_bold = (
    MatrixSymbol(name, 3, 1) for name in ("a", "x", "dx", "xN", "dxN")
)
changes = (
    LeftPerturbed(normal_bold, R, a_bold)
    + Directional(normal_bold, x_bold, dx_bold)
    + Directional(normal_bold, tau, dtau)
)
section.identity(
    "3.2/implicit",
    "small variations of the projective transformation",
    printed=dtau * normal_bold + tau * d_normal_bold,
    constraints=[Eq(normal_bold, R * x_bold / tau), Eq(d_normal_bold, changes), Eq(turn_of_axes, Skew(a_bold))],
    properties={R: "rotation"},
    derived=tau * turn_of_axes * normal_bold + R * dx_bold,
)

# %% [markdown]
# Then its three components, left minus right side.  The third gives the factor: $-\tau c = \mathbf e_3 \cdot \mathbf
# x$.

# %%
row1, row2, row3 = (R_any.row(place).T for place in range(3))
for place, left_side, right_side in (
    (1, tau * (dxn + yn * dkappa + c * dphi), dot(row1, d_image) - xn * dtau),
    (2, tau * (dyn - xn * dkappa - c * domega), dot(row2, d_image) - yn * dtau),
    (3, tau * (xn * dphi - yn * domega), dot(row3, d_image) + c * dtau),
):
    section.identity(
        f"3.2/scalar#{place}",
        f"equation {place} in scalar notation",
        printed=left_side - right_side,
        where=DIFFERENTIALS,
        derived=0,
    )
section.identity(
    "3.2/tau",
    "the factor from the third component",
    derived=over((R_any * x_vector)[2], -c),
)

# %% [markdown]
# ## By rotations?
#
# **Print.**  The derivatives with respect to $d\Omega, d\varphi, d\kappa$.  The display is scanned as a table without
# brackets.

# %%
B_a = columns(*(diff(d_coordinates, angle) for angle in d_angles))
TABLE = "The display is scanned as a table without brackets: "
BAR = TABLE + "the minus sign before 'xN yN' may be the bar of 1/c.  With it, the element would be wrong."
BRACKETS = TABLE + "it shows -c^2 + xN^2, which is right in brackets after the minus sign and wrong without them."
CELLS = (
    ("11", None, xn * yn / c, BAR),
    ("12", None, -(c**2 + xn**2) / c, BRACKETS),
    ("13", -yn, None, ""),
    ("21", (c**2 + yn**2) / c, None, ""),
    ("22", -xn * yn / c, None, ""),
    ("23", xn, None, ""),
)
for name, printed, corrected, note in CELLS:
    verdict = {"expect": "illegible", "corrected": corrected} if corrected else {}
    section.identity(
        f"3.2.1#B_a{name}",
        f"element {name[0]}, {name[1]} of the matrix of small rotations",
        printed=printed,
        where=OF_IMAGE,
        derived=B_a[int(name[0]) - 1, int(name[1]) - 1],
        **verdict,
        note=note,
    )

# %% [markdown]
# The six elements put together:

# %%
B_a_of_normal = Matrix([[xn * yn, -(c**2 + xn**2), -c * yn], [c**2 + yn**2, -xn * yn, c * xn]]) / c
section.identity(
    "3.2/beyond/B_a",
    "the whole matrix of small rotations",
    printed=B_a_of_normal,
    where=OF_IMAGE,
    derived=B_a,
)

# %% [markdown]
# **An example.**  What a small tip does to nine points of an image with $c = 2$, to the first order.

# %%
NINE = {f"{i}{j}": vector(i - 1, j - 1) for i in range(3) for j in range(3)}
of_tip = {
    name: place + inserted(B_a_of_normal, (xn, yn, c), (*place, 2)) * vector(0, sympy.Rational(1, 10), 0)
    for name, place in NINE.items()
}
ImageDrawing(
    "A grid before and after a tip of 1/10.  All points move to the left, those at the sides most, and the corners "
    "move up or down as well.",
    {"before": (NINE, []), "after": (of_tip, [])},
    axes=("x_N", "y_N"),
)

# %% [markdown]
# ## By shifts in the image?
#
# **Print.**  The derivatives with respect to $dx, dy$ have the divisor $\mathbf e_3 \cdot \mathbf x$, and a wrong sign.

# %%
i1, j1, _, i2, j2, _, i3, j3, _ = R_any
B_x = columns(*(diff(d_coordinates, shift) for shift in (dx, dy)))
B_x_printed = Matrix([[xn * i3 + c * i1, xn * j3 + c * j1], [yn * i3 + c * i2, yn * j3 + c * j2]])
section.identity(
    "3.2.1#B_x",
    "matrix of small shifts in the image",
    where=OF_IMAGE,
    derived=B_x,
    expect="error",
    corrected=-B_x_printed / dot(row3, x_vector),
    note="The sign is wrong: tau = -e3.x/c is the divisor.  The paper's own special case, B_x = E with e3.x = -c, "
    "needs the minus sign.  The dispersion, quadratic in B_x, is not affected.",
    follows="All four elements have the wrong sign. The dispersion, which is quadratic in them, does not notice it.",
)

# %% [markdown]
# Together they are the differential, linear in rotations and shifts.

# %%
section.identity(
    "3.2.1",
    "differential of the transformation",
    printed=B_a * vector(*d_angles) + B_x * vector(dx, dy),
    derived=d_coordinates,
)

# %% [markdown]
# ## What is the dispersion?
#
# **Definition.**  The exact Jacobian matrix of the coordinates with respect to rotations and image coordinates, applied
# to their joint dispersion, in which rotations and image coordinates are not correlated.

# %%
sigma = sympy.Symbol("sigma")
Q_a = Matrix(3, 3, lambda r, s: sympy.Symbol(f"Q{min(r, s) + 1}{max(r, s) + 1}"))
jacobian = columns(*(diff(d_coordinates, variable) for variable in (*d_angles, dx, dy)))
joint = sigma**2 * Matrix.diag(Q_a, Matrix.eye(2))
S_N = jacobian * joint * jacobian.T
B_a_any = Matrix(2, 3, lambda r, s: sympy.Symbol(f"Ba{r + 1}{s + 1}"))
B_x_any = Matrix(2, 2, lambda r, s: sympy.Symbol(f"Bx{r + 1}{s + 1}"))
COEFFICIENTS = given((*B_a_any, *B_x_any), (*B_a, *B_x))
B_A, B_X, S_A, Q_A = (MatrixSymbol(*of) for of in (("B_a", 2, 3), ("B_x", 2, 2), ("S_a", 3, 3), ("Q_a", 3, 3)))
of_image_coordinates = sigma**2 * sympy.Identity(2)
of_both = BlockMatrix([[S_A, ZeroMatrix(3, 2)], [ZeroMatrix(2, 3), of_image_coordinates]])
dispersion = BlockMatrix([[B_A, B_X]]) * of_both * BlockMatrix([[B_A, B_X]]).T
section.identity(
    "3.2.2",
    "dispersion of the normal case coordinates",
    printed=BlockMatrix(
        [
            [
                B_A * S_A * B_A.T + B_X * of_image_coordinates * B_X.T,
                sigma**2 * (B_A * Q_A * B_A.T + B_X * B_X.T),
            ]
        ]
    ),
    constraints=[Eq(S_A, sigma**2 * Q_A)],
    derived=BlockMatrix([[dispersion, dispersion]]),
)

# %% [markdown]
# **Are rotations and image coordinates independent?**  The paper says so.  If they are not, and $\mathbf m$ are their
# covariances, two terms are missing:

# %%
mixed = Matrix(3, 2, sympy.symbols("m:3:2"))
section.identity(
    "3.2/beyond/mixed",
    "what the independence of rotations and image coordinates leaves out",
    printed=B_a_any * mixed * B_x_any.T + (B_a_any * mixed * B_x_any.T).T,
    where=COEFFICIENTS,
    derived=jacobian * Matrix.zeros(3, 3).row_join(mixed).col_join(mixed.T.row_join(Matrix.zeros(2, 2))) * jacobian.T,
)

# %% [markdown]
# The rotations are linear functions of the observed parallaxes, and a parallax contains the errors of its own point.
# So a point of the adjustment is correlated with the rotations.  Shown are three points for all: the estimator $\mathbf
# k$ takes parallaxes to rotations, and $\mathbf h$ are the epipolar lines of each point.

# %%
estimator = Matrix(2, 3, sympy.symbols("k:2:3"))
h = Matrix(3, 4, sympy.symbols("h:3:4"))
parallax_rows = Matrix.diag(*(h.row(n) for n in range(3)))
of_first_point = Matrix.eye(4).col_join(Matrix.zeros(8, 4))
section.identity(
    "3.2/beyond/dependent",
    "covariance of the rotations and the coordinates of a point of the adjustment",
    printed=sigma**2 * estimator.col(0) * h.row(0),
    derived=estimator * parallax_rows * (sigma**2 * Matrix.eye(12)) * of_first_point,
)

# %% [markdown]
# For a point that is not used in the adjustment the paper is right.

# %%
section.identity(
    "3.2/independent",
    "rotations and image coordinates are independent",
    printed=Matrix.zeros(2, 4),
    derived=(estimator * parallax_rows).row_join(Matrix.zeros(2, 4))
    * (sigma**2 * Matrix.eye(16))
    * Matrix.zeros(12, 4).col_join(Matrix.eye(4)),
)

# %% [markdown]
# ## And close to the normal case?
#
# **Definition.**  Without rotation $\mathbf e_3 \cdot \mathbf x = -c$ and $\mathbf B_x = \mathbf E$: uncertain
# rotations aside, the dispersion of the coordinates stays as it is.

# %%
NO_ROTATION = given(R_any, E3)
section.identity(
    "3.2/normal#e3.x",
    "divisor without rotation",
    derived=dot(row3, x_vector).xreplace(NO_ROTATION),
)
section.identity(
    "3.2/normal#B_x",
    "matrix of small shifts without rotation",
    derived=Matrix.hstack(*(B_x.xreplace(NO_ROTATION),) * 2),
)
section.identity(
    "3.2/normal#add",
    "the uncertainties of the coordinates add directly",
    printed=sigma**2 * Matrix.eye(2),
    derived=S_N.xreplace(NO_ROTATION | dict.fromkeys(Q_a, sympy.Integer(0))),
)

# %% [markdown]
# ## Which points have the greatest weight?
#
# **Definition.**  A fictitious residual is the change of the parallax $\mathbf x'^T \mathbf C_N \mathbf x''$; its
# variance follows from the derivatives with respect to the four coordinates.

# %%
parallax = dot(x_left, correlation(E3, E3, unit_base) * x_right)
slopes, _ = linear_system([parallax], (xp, yp, xpp, ypp))
variance = dot(sigma * slopes.T, sigma * slopes.T)
variance

# %% [markdown]
# **Print.**  The paper has $y$ in it, and concludes that the weights decrease with $y$.  They do not depend on it.

# %%
section.identity(
    "3.2.3",
    "weight of a fictitious residual in the normal case",
    derived=variance,
    expect="error",
    corrected=2 * sigma**2 * c**2,
    note="The parallax is c (y' - y''), so that its variance is 2 c^2 sigma^2.  The printed form also counts the "
    "third components y of the lines (0, c, y) and -(0, c, y), to which no residual belongs: (2.3.1) has h1 and h2 "
    "only.  Ruled out: other lines, as (3.1.2) and (3.1.3) are right.  No slip of the scan, as the text draws a "
    "conclusion from y.",
    follows="In the normal case all points have the same weight.",
)
section.identity(
    "3.2/decrease",
    "in the normal case the weights depend on the ordinate",
    printed=4 * sigma**2 * y,
    derived=diff(variance, yp) + diff(variance, ypp),
    expect="false",
    instead="3.2.3",
    note="The sentence that the weights decrease strictly with y: 1/g would have the derivative 4 sigma^2 y.  In fact "
    "all weights are equal.",
    same_as="3.2.3",
)

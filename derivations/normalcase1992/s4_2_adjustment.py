# %% [markdown]
# # 4 Numerical example: the adjustment
#
# Each of the eight points gives an error equation for five small rotations.  The printed numbers follow to the last
# digit, and with them three slips of the adjustment itself: the sign of the coefficients of $d\Omega''$, weights that
# are the reciprocals of what (2.3.1) defines, and rotations about fixed axes that are added to angles.

# %%
from collections.abc import Callable, Sequence
from itertools import product

import sympy

from algebroproj_derivations.normalcase1992.s4_1_correlation import (
    GON,
    B,
    C,
    R_left,
    R_right,
    kappa_left,
    kappa_right,
    left_points,
    omega,
    phi_left,
    phi_right,
    right_points,
    rotation,
    rounded,
    square_root,
    turns,
)
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, cross, divided, dot, inverse, rows, vector

section = Section("normalcase1992", "4", "Numerical example: adjustment")

e1, e2, e3 = (Matrix.eye(3).col(i) for i in range(3))
base = e1
UNKNOWNS = {"phip": "phi'", "kappap": "kappa'", "omega": "Omega''", "phipp": "phi''", "kappapp": "kappa''"}

# %% [markdown]
# ## Error equations
#
# The left side of the condition of coplanarity is $F = \mathbf p' \cdot (\mathbf b \times \mathbf p'') =
# \mathbf x'^T \mathbf C \mathbf x''$, with $\mathbf C = \mathbf R'^T \mathbf B \mathbf R''$ not divided by $c_{32}$.
# A small rotation about an axis $\mathbf a$ changes $\mathbf p$ by $\mathbf a \times \mathbf p$.  From $\delta p + w +
# \sum (\partial F / \partial \alpha)\, d\alpha = 0$ follow the coefficients $-\partial F / \partial \alpha$ of the
# equation $\delta p + w = \dots$

# %%
LEFT_AXES, RIGHT_AXES = (e2, e3), (e1, e2, e3)


def coefficients(p_left: Matrix, p_right: Matrix) -> Matrix:
    by_left = [-dot(cross(axis, p_left), cross(base, p_right)) for axis in LEFT_AXES]
    by_right = [-dot(p_left, cross(base, cross(axis, p_right))) for axis in RIGHT_AXES]
    return vector(*by_left, *by_right)


def parallaxes(correlation: Matrix) -> Matrix:
    pairs = zip(left_points, right_points, strict=True)
    return vector(*((left.T * correlation * right)[0] for left, right in pairs))


projectors = [(R_left * left, R_right * right) for left, right in zip(left_points, right_points, strict=True)]
design = rows(*(coefficients(*pair) for pair in projectors))
delta_p = parallaxes(C)

# %% [markdown]
# ### Weights
#
# By (2.3.1) $1 / g = \sigma^2 (h_1'^2 + h_2'^2 + h_1''^2 + h_2''^2)$, with the epipolar lines $\mathbf h' = \mathbf C
# \mathbf x''$ and $\mathbf h'' = \mathbf C^T \mathbf x'$.  The sums are about 5000 mm², hence $\sigma^2 = 1 / 5000$ for
# weights about 1.

# %%
SCALE = 5000


def epipolar_lines(correlation: Matrix) -> list[tuple[Matrix, Matrix]]:
    pairs = zip(left_points, right_points, strict=True)
    return [(correlation * right, correlation.T * left) for left, right in pairs]


def weights(correlation: Matrix) -> Matrix:
    return vector(
        *(
            SCALE / sum(component**2 for line in lines for component in line[:2])
            for lines in epipolar_lines(correlation)
        )
    )


def reciprocal_weights(correlation: Matrix) -> Matrix:
    return vector(*(sum(dot(line, line) for line in lines) / SCALE for lines in epipolar_lines(correlation)))


weights_used = reciprocal_weights(C)

# %% [markdown]
# ### The table
#
# The coefficients of $d\Omega''$ are printed with the sign of the linearized equation of section 2.3.  It is wrong:
# $\partial F / \partial \Omega'' = -(p_2' p_2'' + p_3' p_3'')$, and the coefficient is its opposite, about $+c^2$.  The
# weights above 1 where (2.3.1) gives weights below 1, and below 1 where it gives weights above, are not weights but
# their reciprocals; section 3.2 says itself that weights decrease with $|y|$.

# %%
TABLE = (
    ("4.81", "-141.38", "-2545.03", "28.22", "-829.52", "0.0500", "1.0"),
    ("17.77", "-1129.97", "-2524.54", "-0.18", "11.25", "0.0118", "1.0"),
    ("-36.4", "132.58", "-2731.04", "314.63", "-1147.66", "-1.0271", "1.1"),
    ("511.63", "-1679.62", "-2736.65", "-106.82", "351.20", "-1.1611", "1.1"),
    ("-1.71", "-73.60", "-2359.54", "-35.51", "-1525.32", "-0.0885", "1.0"),
    ("-71.63", "-1360.76", "-2274.17", "-29.84", "-566.33", "-0.1081", "0.9"),
    ("-45.25", "348.39", "-2479.64", "224.47", "-1731.91", "-0.6591", "1.0"),
    ("7.05", "-41.83", "-2608.91", "162.05", "-963.52", "-0.6622", "1.0"),
)
LOST_SIGN = (
    "A lost sign: the solutions, the standard error and the recomputed correlation need the negative parallax.  The "
    "scan alone cannot tell a slip of the scan from one of the print."
)
SIGN_OF_TILT = (
    "Wrong sign in all eight rows, as in the linearized equation of section 2.3: dF/dOmega'' = -(p2' p2'' + p3' p3''), "
    "and the other four coefficients have the sign opposite to that of dF.  No slip of the scan: the solution dOmega'' "
    "and the elements of Q have the sign that follows from the column as printed."
)
RECIPROCAL = (
    "The reciprocal of a weight: the table has (h'.h' + h''.h'') / 5000, with all three components of the lines, see "
    "4/beyond/weights; (2.3.1) defines 5000 / (h1'^2 + h2'^2 + h1''^2 + h2''^2)."
)
RECIPROCAL_FOLLOWS = "It hardly matters: no angle moves by 0.001 gon, phi' by {4/beyond/reciprocal#phip} gon."
SLIPS = {
    (0, 5): ("-0.0500", LOST_SIGN),
    (2, 6): ("1.0", RECIPROCAL),
    (3, 6): ("1.0", RECIPROCAL),
    (5, 6): ("1.1", RECIPROCAL),
    **{(i, 2): (row[2].removeprefix("-"), SIGN_OF_TILT) for i, row in enumerate(TABLE)},
}
FIRST_WEIGHT = "4/errors#3.g"
SAME_FINDING = {"omega": "2.3/linear#dOmega''", "g": FIRST_WEIGHT}
NOTES = {(2, 0): "The second decimal, a zero, is not printed."}

table = design.row_join(delta_p).row_join(weights(C))
HEADS = {slug: f"coefficient of d{name}" for slug, name in UNKNOWNS.items()} | {"deltap": "parallax", "g": "weight"}
for i, printed in enumerate(TABLE):
    for j, (slug, head) in enumerate(HEADS.items()):
        slip = SLIPS.get((i, j))
        section.numeric(
            f"4/errors#{i + 1}.{slug}",
            f"error equation {i + 1}, {head}",
            printed=printed[j],
            derived=table[i, j],
            **(
                {
                    "expect": "misprint" if slip[1] is LOST_SIGN else "error",
                    "corrected": slip[0],
                    "note": slip[1],
                    "same_as": ""
                    if (number := f"4/errors#{i + 1}.{slug}") == FIRST_WEIGHT
                    else SAME_FINDING.get(slug, ""),
                    "follows": RECIPROCAL_FOLLOWS if number == FIRST_WEIGHT else "",
                }
                if slip
                else {"note": NOTES.get((i, j), "")}
            ),
        )
for i, printed in enumerate(TABLE):
    section.numeric(
        f"4/beyond/weights#{i + 1}",
        f"reciprocal weight that is used, equation {i + 1}",
        printed=printed[6],
        derived=weights_used[i],
        note="Not in the paper: (h'.h' + h''.h'') / 5000 with all three components gives the column g and, with its "
        "full digits, all of Q; the two components of (2.3.1) do not.",
    )

# %% [markdown]
# ## Solution
#
# $w = \mathbf A\, d\mathbf a - \delta p$, hence $\mathbf Q = (\mathbf A^T \mathbf G \mathbf A)^{-1}$ and $d\mathbf a =
# \mathbf Q \mathbf A^T \mathbf G\, \delta p$.  The results are judged as what follows from the paper's own error
# equations, with the slips in signs and weights, without rounding.


# %%
class Adjustment:
    """Least squares for A da = delta p + w with weights g."""

    def __init__(self, A: Matrix, delta_p: Matrix, g: Matrix) -> None:  # noqa: N803
        G = Matrix.diag(*g)
        self.Q = divided(inverse(A.T * G * A))
        self.da = self.Q * A.T * G * delta_p
        self.w = A * self.da - delta_p
        self.s0 = square_root((self.w.T * G * self.w)[0] / (A.rows - A.cols))

    def standard_error(self, unknown: int) -> sympy.Rational:
        return self.s0 * square_root(self.Q[unknown, unknown])


DECIMALS = 45
design_used = (design * Matrix.diag(1, 1, -1, 1, 1)).applyfunc(lambda cell: rounded(cell, DECIMALS))
unrounded = Adjustment(
    design_used, *(column.applyfunc(lambda cell: rounded(cell, DECIMALS)) for column in (delta_p, weights_used))
)

# %% [markdown]
# $\mathbf Q$ in units of $10^{-6}$.  The right sign of the coefficients of $d\Omega''$ would change the signs of the
# third row and of the third column, but for the diagonal.

# %%
Q_PRINTED = (
    ("8.484", "0.902", "1.076", "4.334", "-1.887"),
    ("0.902", "1.768", "-0.871", "-4.126", "1.276"),
    ("1.076", "-0.871", "0.521", "2.128", "-0.812"),
    ("4.334", "-4.126", "2.128", "20.392", "-2.079"),
    ("-1.887", "1.276", "-0.812", "-2.079", "1.517"),
)
MILLION = 10**6
for i, j in product(range(5), repeat=2):
    section.numeric(
        f"4/Q#{i + 1}{j + 1}",
        f"inverse matrix of the error equations as printed, row {i + 1}, column {j + 1}, in 10^-6",
        printed=Q_PRINTED[i][j],
        derived=unrounded.Q[i, j] * MILLION,
        **(
            {
                "expect": "misprint",
                "corrected": "-0.902",
                "note": "A lost sign, in both places of the symmetric matrix; the error equations give the other sign.",
                "same_as": "4/Q#12" if i else "",
            }
            if {i, j} == {0, 1}
            else {}
        ),
    )

# %% [markdown]
# The standard error and the solutions, in gon.

# %%
squares_of_residuals = [(row[6], w**2) for row, w in zip(TABLE, unrounded.w, strict=True)]
s0 = square_root(sum(sympy.Rational(g) * square for g, square in squares_of_residuals) / 3)
section.numeric(
    "4/s0",
    "standard error of adjustment",
    printed="0.117",
    derived=s0,
    note="0.1171, from the residuals without rounding and the weights with one decimal, as the table prints them; the "
    "weights without rounding give 0.1184, 4/beyond/s0.  Read as plus or minus, where the scan has +.",
)
section.numeric(
    "4/beyond/s0",
    "standard error of the same residuals, with the weights without rounding",
    printed="0.1184",
    derived=unrounded.s0,
    note="Not in the paper.",
)
MICROMETERS = 1000
average_weight = sum(SCALE * g for g in weights_used) / len(left_points)
section.identity(
    "4/s#weights",
    "average of the fictitious weights as used, rounded to thousands",
    printed=5000,
    derived=rounded(average_weight, -3),
    note="5119, of the sums h'.h' + h''.h'' that the column g has in units of 5000.  These are reciprocals of weights, "
    "see 4/beyond/weights#1; those of (2.3.1) have the average 4983.",
)


def micrometers(s0: sympy.Rational, weight: sympy.Rational) -> sympy.Rational:
    """Return the standard error of a coordinate: s0 divided by the root of a weight."""
    return s0 / square_root(weight) * MICROMETERS


section.numeric(
    "4/s",
    "standard error of measured coordinates, in micrometers",
    printed="1.6",
    derived=micrometers(s0, average_weight),
    note="1.64, with the average 5119 of the weights; the rounded weight 5000 would give 1.66.",
)

SOLUTIONS = {
    "phip": ("-0.182", "0.022"),
    "kappap": ("0.025", "0.010"),
    "omega": ("-0.010", "0.005"),
    "phipp": ("-0.237", "0.034"),
    "kappapp": ("0.023", "0.009"),
}
for index, (slug, (solution, error)) in enumerate(SOLUTIONS.items()):
    name = UNKNOWNS[slug]
    section.numeric(
        f"4/solutions#{slug}",
        f"solution d{name} of the error equations as printed, in gon",
        printed=solution,
        derived=unrounded.da[index] / GON,
    )
    section.numeric(
        f"4/solutions#{slug}.error",
        f"standard error of d{name}, in gon",
        printed=error,
        derived=unrounded.standard_error(index) / GON,
    )

# %% [markdown]
# ## Definitive rotations
#
# The paper adds the solutions to the approximate angles.

# %%
APPROXIMATE = dict(zip(UNKNOWNS, (phi_left, kappa_left, omega, phi_right, kappa_right), strict=True))
DEFINITIVE = {"phip": "-16.728", "kappap": "-0.463", "omega": "-0.878", "phipp": "17.561", "kappapp": "-0.180"}

sums = {slug: APPROXIMATE[slug] + unrounded.da[index] / GON for index, slug in enumerate(UNKNOWNS)}
for slug, name in UNKNOWNS.items():
    section.numeric(
        f"4/definitive#{slug}",
        f"sum of the approximate {name} and its solution, in gon",
        printed=DEFINITIVE[slug],
        derived=sums[slug],
    )

R_PRINTED = (
    ("0.965449", "0.007025", "-0.259756"),
    ("-0.007275", "0.999974", "0.000000"),
    ("0.259749", "0.001890", "0.965674"),
)
R_definitive = rotation(sympy.Integer(0), sums["phip"], sums["kappap"])
R_OPTIONS = {
    (0, 0): {
        "expect": "misprint",
        "corrected": "0.965649",
        "note": "One digit: with the corrected element the row and the column have length 1, and the other eight "
        "elements hold.",
    },
    (0, 2): {
        "expect": "misprint",
        "corrected": "-0.259755",
        "note": "Without rounding -0.25975548.  The paper's arithmetic has lost the seventh digit, as in y of the left "
        "epipole; from the angles with three decimals follows -0.259750.",
    },
}
for i, j in product(range(3), repeat=2):
    section.numeric(
        f"4/R#{i + 1}{j + 1}",
        f"definitive matrix R', row {i + 1}, column {j + 1}",
        printed=R_PRINTED[i][j],
        derived=R_definitive[i, j],
        **R_OPTIONS.get((i, j), {}),
    )

# %% [markdown]
# ## What the definitive rotations leave
#
# The adjustment minimizes $\sum g w^2$; after it the conditions must hold but for the residuals $w$, with the standard
# error 0.117.  Put into the condition of coplanarity, the definitive rotations leave nearly five times as much, with
# one sign in all eight points.


# %%
def correlation(angles: Sequence[sympy.Rational]) -> Matrix:
    phi_left, kappa_left, omega, phi_right, kappa_right = angles
    return rotation(sympy.Integer(0), phi_left, kappa_left).T * B * rotation(omega, phi_right, kappa_right)


def standard_error(matrix: Matrix) -> sympy.Rational:
    """Return the standard error that a correlation leaves, with the weights of (2.3.1)."""
    squares = zip(parallaxes(matrix), weights(matrix), strict=True)
    return square_root(sum(g * F**2 for F, g in squares) / (len(left_points) - len(UNKNOWNS)))


definitive = correlation([sympy.Rational(angle) for angle in DEFINITIVE.values()])
section.numeric(
    "4/beyond/definitive",
    "standard error that the definitive rotations leave",
    printed="0.561",
    derived=standard_error(definitive),
    note="Not in the paper: 7.9 micrometers in the image.  Two slips: the sign of dOmega'', and the small rotations "
    "about fixed axes, R = (E + dA)(R), that are added to angles; see 4/beyond/repaired#both.  The weights matter "
    "little, see 4/beyond/reciprocal#phip to #kappapp.",
)
LEFT_OVER = ("0.350", "0.386", "0.336", "0.290", "0.318", "0.233", "0.507", "0.255")
for i, printed in enumerate(LEFT_OVER):
    section.numeric(
        f"4/beyond/left-over#{i + 1}",
        f"coplanarity that the definitive rotations leave, point {i + 1}, in mm^2",
        printed=printed,
        derived=parallaxes(definitive)[i],
        note="Not in the paper.",
    )

# %% [markdown]
# A change of $\kappa'$ turns the image not about the third axis, but about $\mathbf k = (\sin\varphi, 0,
# \cos\varphi)^T$: $d\mathbf R\, \mathbf R^T = \mathbf Y \mathbf E_3 \mathbf Y^T d\kappa$ with the skew-symmetric
# $\mathbf E_3$ of the third axis.  Its part about the first axis counts as tilt: with $\varphi$ about 17 gon it is as
# large as $d\Omega''$ itself.


# %%
def skew(axis: Matrix) -> Matrix:
    return Matrix([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])


cos_phi, sin_phi = sympy.symbols("c_phi s_phi")
about_y = Matrix([[cos_phi, 0, sin_phi], [0, 1, 0], [-sin_phi, 0, cos_phi]])
section.identity(
    "4/beyond/axis",
    "the rotation that a change of kappa makes",
    printed=skew(vector(sin_phi, 0, cos_phi)),
    derived=about_y * skew(e3) * about_y.T,
    note="Not in the paper: dA of section 2.3 has the axis (0, 0, 1) for dkappa, which is right for R = (E + dA)(R), "
    "not for the angle kappa of (2.1.2).",
)

# %% [markdown]
# The solution put into $\mathbf R = (\mathbf E + d\mathbf A)(\mathbf R)$, with the sign of $d\Omega''$ that the
# condition demands, leaves the standard error of the adjustment.  One of the two repairs alone makes it worse.


# %%
def composed(da: Matrix) -> Matrix:
    left = Matrix.eye(3) + skew(vector(0, da[0], da[1]))
    right = Matrix.eye(3) + skew(vector(da[2], da[3], da[4]))
    return (left * R_left).T * B * (right * R_right)


def added(da: Matrix) -> Matrix:
    return correlation([angle + step / GON for angle, step in zip(APPROXIMATE.values(), da, strict=True)])


solution = unrounded.da
with_sign = Matrix.diag(1, 1, -1, 1, 1) * solution
for slug, title, matrix, printed in (
    ("nothing", "unrounded, with both slips", added(solution), "0.567"),
    ("sign", "with the sign of dOmega'' repaired", added(with_sign), "0.811"),
    ("composition", "with rotations composed", composed(solution), "1.355"),
    ("both", "with both repaired", composed(with_sign), "0.117"),
):
    section.numeric(
        f"4/beyond/repaired#{slug}",
        f"standard error that the printed solution leaves, {title}",
        printed=printed,
        derived=standard_error(matrix),
        note="Not in the paper.",
    )

# %% [markdown]
# ## The adjustment, without the slips
#
# Unknowns are the five angles themselves, with the weights of (2.3.1).  With the turns about the three axes and their
# generators, $d\mathbf R'' = \mathbf E_1 \mathbf X \mathbf Y \mathbf Z\, d\Omega'' + \mathbf X \mathbf E_2 \mathbf Y
# \mathbf Z\, d\varphi'' + \mathbf X \mathbf Y \mathbf E_3 \mathbf Z\, d\kappa''$.  Coefficients, parallaxes and weights
# are computed anew until the corrections vanish; all numbers keep 45 decimals.  The standard error of $\Omega''$ is
# smaller than that of $d\Omega''$ above, which is another quantity: a rotation beside rotations about fixed axes.

# %%
E1, E2, E3 = map(skew, (e1, e2, e3))


def derivatives_of_correlation(angles: Sequence[sympy.Rational]) -> list[Matrix]:
    """Return the derivatives of C with respect to the five angles."""
    phi_left, kappa_left, omega, phi_right, kappa_right = angles
    _, Y, Z = turns(sympy.Integer(0), phi_left, kappa_left)
    left, left_derivatives = Y * Z, (E2 * Y * Z, Y * E3 * Z)
    X, Y, Z = turns(omega, phi_right, kappa_right)
    right, right_derivatives = X * Y * Z, (E1 * X * Y * Z, X * E2 * Y * Z, X * Y * E3 * Z)
    by_left = [derivative.T * B * right for derivative in left_derivatives]
    return by_left + [left.T * B * derivative for derivative in right_derivatives]


def adjustment(angles: Sequence[sympy.Rational], weights_of: Callable[[Matrix], Matrix] = weights) -> Adjustment:
    matrix = correlation(angles)
    jacobian = Matrix.hstack(*(parallaxes(derivative) for derivative in derivatives_of_correlation(angles)))
    system = (-jacobian, parallaxes(matrix), weights_of(matrix))
    return Adjustment(*(part.applyfunc(lambda cell: rounded(cell, DECIMALS)) for part in system))


STEPS = 6


def adjusted_angles(weights_of: Callable[[Matrix], Matrix]) -> list[sympy.Rational]:
    """Return the angles to which the adjustment converges, in gon."""
    angles = list(APPROXIMATE.values())
    for _ in range(STEPS):
        step = adjustment(angles, weights_of).da
        angles = [rounded(angle + correction / GON, DECIMALS) for angle, correction in zip(angles, step, strict=True)]
    return angles


angles = adjusted_angles(weights)
adjusted = adjustment(angles)

BY_WEIGHTS = ("-0.0006", "-0.0006", "0.0001", "-0.0007", "-0.0005")
ADJUSTED = {
    "phip": ("-16.7281", "0.0223"),
    "kappap": ("-0.4617", "0.0099"),
    "omega": ("-0.8698", "0.0015"),
    "phipp": ("17.5613", "0.0343"),
    "kappapp": ("-0.1824", "0.0093"),
}
for index, (slug, (angle, error)) in enumerate(ADJUSTED.items()):
    name = UNKNOWNS[slug]
    section.numeric(
        f"4/beyond/adjusted#{slug}",
        f"adjusted {name}, in gon",
        printed=angle,
        derived=angles[index],
        note="Not in the paper.",
    )
    section.numeric(
        f"4/beyond/adjusted#{slug}.error",
        f"standard error of {name}, adjusted, in gon",
        printed=error,
        derived=adjusted.standard_error(index) / GON,
        note="Not in the paper.",
    )
    section.numeric(
        f"4/beyond/adjusted#{slug}.step",
        f"what another step would add to {name}, in gon",
        printed="0.000000000000",
        derived=adjusted.da[index] / GON,
        note="Not in the paper: the iteration has converged.",
    )
section.numeric(
    "4/definitive",
    "the definitive tilt, in gon",
    printed=DEFINITIVE["omega"],
    derived=angles[list(UNKNOWNS).index("omega")],
    expect="false",
    instead="4/beyond/adjusted#omega",
    note="The definitive rotations are those of the adjustment, section 2.3.  The printed ones are sums, "
    "4/definitive#phip to #kappapp, of angles and of small rotations about fixed axes, one of which has the wrong "
    "sign: see 4/beyond/definitive for what they leave.",
    grade="results",
    follows="The definitive rotations leave the standard error {4/beyond/definitive}, where the adjustment promises "
    "{4/s0}. With the sign of dOmega'' repaired alone it is {4/beyond/repaired#sign}, with the rotations "
    "composed alone {4/beyond/repaired#composition}, with both {4/beyond/repaired#both}. See "
    "docs/findings/small-rotations.md.",
)
for (slug, name), angle, with_reciprocal, printed in zip(
    UNKNOWNS.items(), angles, adjusted_angles(reciprocal_weights), BY_WEIGHTS, strict=True
):
    section.numeric(
        f"4/beyond/reciprocal#{slug}",
        f"by how much the reciprocal weights move {name}, in gon",
        printed=printed,
        derived=with_reciprocal - angle,
        note="Not in the paper: the weights that are used, in place of those of (2.3.1), move no angle by 0.001 gon.",
    )
section.numeric(
    "4/beyond/adjusted#s0",
    "standard error of the adjustment without the slips",
    printed="0.117",
    derived=adjusted.s0,
    note="Not in the paper: 0.11703, which is also what the conditions at the adjusted angles leave.",
)
section.numeric(
    "4/beyond/adjusted#s",
    "standard error of measured coordinates, in micrometers",
    printed="1.66",
    derived=micrometers(adjusted.s0, sympy.Integer(SCALE)),
    note="Not in the paper.",
)
ADJUSTED_RESIDUALS = ("0.0069", "0.0968", "-0.0486", "-0.0006", "-0.0294", "-0.0422", "0.1272", "-0.1034")
for i, printed in enumerate(ADJUSTED_RESIDUALS):
    section.numeric(
        f"4/beyond/adjusted#F{i + 1}",
        f"coplanarity at the adjusted angles, point {i + 1}, in mm^2",
        printed=printed,
        derived=parallaxes(correlation(angles))[i],
        note="Not in the paper.",
    )

# %% [markdown]
# # 4 Numerical example, a) and b)
#
# Cartesian coordinates of object points and of the two centers of projection
# are given; affine coordinates with respect to the points 1, 4, 5, 2 and image coordinates follow.  Every printed cell
# is a claim of its own, compared with the exact rational number that follows from the given data.

# %%
from decimal import Decimal
from fractions import Fraction
from math import comb, factorial

import sympy

from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    Rounding,
    at_most,
    chosen,
    columns,
    decimals,
    divided,
    rounded,
    solve,
    vector,
)

section = Section("fundamentals1996", "4", "Numerical example")

BASIC = ("1", "4", "5", "2")


def exact(*decimals: str) -> Matrix:
    return vector(*(sympy.Rational(decimal) for decimal in decimals))


# %% [markdown]
# ## The tables, as printed
#
# O1 and O2 are the centers $O'$ and $O''$.

# %%
CARTESIAN = {
    "1": ("292.50", "202.50", "120.00"),
    "2": ("435.00", "900.00", "990.00"),
    "3": ("660.00", "1537.50", "312.00"),
    "4": ("577.50", "2295.00", "91.50"),
    "5": ("1537.50", "480.00", "772.50"),
    "6": ("1357.50", "1057.50", "138.00"),
    "7": ("1717.50", "1695.00", "247.50"),
    "8": ("1462.50", "2115.00", "975.00"),
    "O1": ("367.50", "1261.50", "3712.50"),
    "O2": ("1612.50", "1192.50", "3987.00"),
    "11": ("300.00", "225.00", "142.50"),
    "12": ("532.50", "999.00", "517.50"),
    "13": ("1048.50", "684.00", "867.00"),
    "14": ("1359.00", "1267.50", "417.00"),
    "15": ("1660.50", "1509.00", "799.50"),
    "16": ("1504.50", "2068.50", "648.00"),
}

AFFINE = {
    "1": ("-0.0000000", "-0.0000000", "0.0000000"),
    "2": ("-0.0000000", "0.0000000", "1.0000000"),
    "3": ("0.5756072", "0.1487681", "0.1279697"),
    "4": ("1.0000000", "0.0000000", "0.0000000"),
    "5": ("-0.0000000", "1.0000000", "0.0000000"),
    "6": ("0.4912043", "0.8981410", "-0.5693249"),
    "7": ("0.7775096", "1.0358235", "-0.6048458"),
    "8": ("0.6654715", "0.7355879", "0.4528676"),
    "O1": ("0.8871075", "-0.2253355", "4.2692516"),
    "O2": ("0.9009221", "0.8325803", "3.7908794"),
    "11": ("0.0024264", "0.0027341", "0.0238910"),
    "12": ("0.2367270", "0.0934168", "0.3945888"),
    "13": ("0.0088907", "0.5544832", "0.4430495"),
    "14": ("0.4805426", "0.7720203", "-0.2218940"),
    "15": ("0.4742924", "0.9834730", "0.0589669"),
    "16": ("0.7739665", "0.7919375", "0.0382975"),
}

# %% [markdown]
# The image tables: $x, y$ in decimeters, $u_1, u_2$; in the row of a center of projection the epipole, its image in the
# other picture.

# %%
LEFT = {
    "1": ("-0.0451870", "-0.6343754", "0.0000000", "0.0000000"),
    "2": ("0.0313810", "-0.2265744", "0.2718578", "0.0577379"),
    "3": ("0.1361022", "0.3193167", "0.6355182", "0.1372296"),
    "4": ("0.0202372", "0.8297962", "1.0000000", "0.0000000"),
    "5": ("0.9728948", "-0.4654293", "0.0000000", "1.0000000"),
    "6": ("0.6377332", "0.0178894", "0.3708332", "0.6469605"),
    "7": ("0.8799424", "0.4959498", "0.6721215", "0.8655064"),
    "8": ("0.8702316", "0.9690304", "0.9987487", "0.8349783"),
    "O2": ("-12.7287969", "-0.3448844", "1.6474603", "-12.5642098"),
    "11": ("-0.0413327", "-0.6230778", "0.0073336", "0.0033146"),
    "12": ("0.0866752", "-0.09553180", "0.3558592", "0.1066519"),
    "13": ("0.5743628", "-0.3492243", "0.1254647", "0.6004836"),
    "14": ("0.6849534", "0.1691064", "0.4694911", "0.6870021"),
    "15": ("1.0209872", "0.4074610", "0.5951289", "1.0089939"),
    "16": ("0.8075429", "0.8400414", "0.9171517", "0.7796466"),
}

RIGHT = {
    "1": ("-0.8130548", "-0.6290877", "0.0000000", "0.0000000"),
    "2": ("-0.9164214", "-0.2281625", "0.3094497", "-0.2327183"),
    "3": ("-0.5609002", "0.2279833", "0.6442013", "0.1043779"),
    "4": ("-0.5502266", "0.6951777", "1.0000000", "1.0000000"),
    "5": ("-0.0193972", "-0.5909803", "0.0000000", "1.0000000"),
    "6": ("-0.1012696", "-0.1176720", "0.3638478", "0.7763495"),
    "7": ("0.1567209", "0.2924344", "0.6670692", "1.0009998"),
    "8": ("-0.0143426", "0.7282690", "1.0056120", "0.6733496"),
    "O1": ("-9.9141575", "1.0549357", "1.6170618", "-12.0027987"),
    "11": ("-0.8125383", "-0.6182340", "0.0082560", "-0.0020832"),
    "12": ("-0.7102699", "-0.1357322", "0.3723722", "0.0061928"),
    "13": ("-0.4033963", "-0.4207995", "0.1438029", "0.4685434"),
    "14": ("-0.1055003", "0.0228084", "0.4711043", "0.7354998"),
    "15": ("0.1195522", "0.2066799", "0.6030505", "0.9753681"),
    "16": ("0.0231421", "0.6175757", "0.9198471", "0.7489819"),
}

# %% [markdown]
# ## a. Affine coordinates of the model
#
# $\mathbf y$ solves $\mathbf X - \mathbf X_{G_0} = \sum_i y_i (\mathbf X_{G_i} - \mathbf X_{G_0})$.

# %%
object_points = {name: exact(*row) for name, row in CARTESIAN.items()}


def affine(points: dict[str, Matrix], basic: tuple[str, ...], name: str) -> Matrix:
    origin, *units = (points[key] for key in basic)
    return divided(solve(columns(*(unit - origin for unit in units)), points[name] - origin))


DIGIT = "One digit of the cell: the other two cells of the point hold, and item e) repeats the coordinate as corrected."
SIGN = "A lost sign: the matrix of item e) takes the center of item d) to the corrected value, whose other cells hold."
AFFINE_SLIPS = {
    ("6", 1): ("0.8081410", DIGIT),
    ("O1", 0): ("-0.8871075", SIGN),
    ("O2", 0): ("-0.9009221", SIGN),
}

for name, printed in AFFINE.items():
    for component, coordinate in enumerate(affine(object_points, BASIC, name)):
        slip = AFFINE_SLIPS.get((name, component))
        section.numeric(
            f"4/a#{name}.y{component + 1}",
            f"point {name}, affine coordinate y{component + 1}",
            printed=printed[component],
            derived=coordinate,
            **({"expect": "misprint", "corrected": slip[0], "note": slip[1]} if slip else {}),
            same_as="4/a#O1.y1" if (name, component) == ("O2", 0) else "",
        )

# %% [markdown]
# ## b. Image coordinates
#
# The paper gives no principal distance.  The printed matrices take the object system to the image system, in the order
# of axes $\mathbf i, \mathbf j, \mathbf k$: the transpose of the $\mathbf R$ of section 1.4, whose columns are
# $\mathbf k, \mathbf i, \mathbf j$.  With $\mathbf v = \mathbf R (\mathbf X - \mathbf X_O)$ and
# $x = -c\, v_1 / v_3$, $y = -c\, v_2 / v_3$, both pictures reproduce for $c = 2.5$ dm and a principal point at the
# origin; neither the transposed matrices, nor the other sign, nor another order of the axes do.

# %%
R_LEFT = (
    ("0.99564508", "-0.09007407", "0.02403194"),
    ("0.09096120", "0.99509814", "-0.03880383"),
    ("-0.02041892", "0.04082082", "0.99895782"),
)
R_RIGHT = (
    ("0.99817506", "0.05377542", "-0.0274727873"),
    ("-0.05336033", "0.99845306", "0.0156255137"),
    ("0.02827056", "-0.01413104", "0.9995004198"),
)
Printed = tuple[tuple[str, str, str], ...]
MATRICES: dict[str, Printed] = {"left": R_LEFT, "right": R_RIGHT}
MATRIX_NAMES = {"left": "R'", "right": "R''"}
PICTURES = {"left": (LEFT, "O1"), "right": (RIGHT, "O2")}
PRINCIPAL_DISTANCE = sympy.Rational(5, 2)

section.definition(
    "4/b/c",
    "principal distance of both pictures, in decimeters",
    printed=PRINCIPAL_DISTANCE,
    note="Not printed: found as the one value for which the cells of the table reproduce.",
)

# %% [markdown]
# ### Round angles
#
# The matrices are rotations $\mathbf R = \mathbf R_z(\kappa) \mathbf R_y(\varphi) \mathbf R_x(\omega)$ with
# $\tan\omega = r_{32} / r_{33}$, $\sin\varphi = -r_{31}$, $\tan\kappa = r_{21} / r_{11}$.  Their angles are round: to
# five decimals of a gon they have one digit after the point.  Here one gon is $3.14159159 / 200$.

# %%
HALF_TURN = Fraction("3.14159159")
TRUE_HALF_TURN = Fraction("3.14159265358979323846264338327950288")
ANGLES = {"left": ("2.6", "1.3", "5.8"), "right": ("-0.9", "-1.8", "-3.4")}
TERMS = 12


def arctangent(tangent: Fraction) -> Fraction:
    return sum((-1) ** n * tangent ** (2 * n + 1) / (2 * n + 1) for n in range(TERMS))


def arcsine(sine: Fraction) -> Fraction:
    return sum(comb(2 * n, n) * sine ** (2 * n + 1) / (4**n * (2 * n + 1)) for n in range(TERMS))


def angles_of(printed: Printed) -> tuple[Fraction, Fraction, Fraction]:
    """Return omega, phi and kappa of a rotation matrix, in gon."""
    (r11, _, _), (r21, _, _), (r31, r32, r33) = ([Fraction(cell) for cell in row] for row in printed)
    radians = arctangent(r32 / r33), -arcsine(r31), arctangent(r21 / r11)
    return tuple(angle * 200 / HALF_TURN for angle in radians)


for side, printed_matrix in MATRICES.items():
    for name, angle, derived in zip(("omega", "phi", "kappa"), ANGLES[side], angles_of(printed_matrix), strict=True):
        section.numeric(
            f"4/b/beyond/angles#{side}.{name}",
            f"{name} of {MATRIX_NAMES[side]} as printed, in gon",
            printed=f"{angle}0000",
            derived=sympy.Rational(derived.numerator, derived.denominator),
            note="Not in the paper, which gives no angles.  From the printed matrix; the eight decimals of a matrix "
            "determine an angle to about 1e-6 gon.",
        )

# %% [markdown]
# From the round angles the matrices follow with as many digits as one likes; thirty decimals are kept.  All unrounded
# numbers of the items b) to i) start from these two matrices: matrices that agree with the printed ones, and pictures
# that are exactly homologous.

# %%
DECIMALS = 30


def cosine_and_sine(angle: Fraction) -> tuple[Fraction, Fraction]:
    terms = [angle**n / factorial(n) * (-1) ** (n // 2) for n in range(2 * TERMS)]
    return sum(terms[0::2]), sum(terms[1::2])


def rotation(angles: tuple[str, str, str], half_turn: Fraction) -> Matrix:
    """Return the rotation by omega, phi and kappa, in gon, to thirty decimals."""
    (co, so), (cp, sp), (ck, sk) = (cosine_and_sine(Fraction(angle) * half_turn / 200) for angle in angles)
    about_z_and_y = ((ck * cp, -sk, ck * sp), (sk * cp, ck, sk * sp), (-sp, Fraction(0), cp))
    entries = [entry for a, b, c in about_z_and_y for entry in (a, b * co + c * so, c * co - b * so)]
    return Matrix(3, 3, [sympy.Rational(f"{rounded(entry, DECIMALS):f}") for entry in entries])


def rotations(half_turn: Fraction) -> dict[str, Matrix]:
    return {side: rotation(angles, half_turn) for side, angles in ANGLES.items()}


FULL_ROTATIONS = rotations(HALF_TURN)

# %% [markdown]
# The elements of $\mathbf R'$ are cut off, all nine.  Those of $\mathbf R''$ are rounded, but for one.

# %%
ROUNDING = {"left": "cut", "right": "nearest"}
CUT_OFF_ALONE = {
    ("right", 1, 0): {
        "expect": "misprint",
        "corrected": "-0.05336034",
        "note": "Without rounding -0.05336033547: cut off instead of rounded, alone among the elements of R''; three "
        "of the others would have another last digit if they were cut off.",
    }
}
ELEMENTS = [(i, j) for i in range(3) for j in range(3)]
for side, printed_matrix in MATRICES.items():
    for i, j in ELEMENTS:
        section.numeric(
            f"4/b#{side}.R{i + 1}{j + 1}",
            f"{MATRIX_NAMES[side]}, row {i + 1}, column {j + 1}",
            printed=printed_matrix[i][j],
            derived=FULL_ROTATIONS[side][i, j],
            rounding=ROUNDING[side],
            **CUT_OFF_ALONE.get((side, i, j), {}),
        )

# %% [markdown]
# ### The gon
#
# A gon is $\pi / 200$, but $\pi$ does not give the printed matrices.  Of the numbers with eight decimals only
# $3.14159159$ does; of those with nine decimals it and its neighbours from $3.141591586$ to $3.141591592$.


# %%
def follows(printed: str, exact: sympy.Rational, rounding: Rounding = "nearest") -> sympy.Integer:
    """Return 1 if a printed number is the exact one, rounded, else 0."""
    number, digit = sympy.Rational(printed), sympy.Rational(1, 10 ** decimals(Decimal(printed)))
    least = abs(number) - (digit / 2 if rounding == "nearest" else 0)
    size = exact * sympy.sign(number) if number else abs(exact)
    return at_most(least, size) * (1 - at_most(least + digit, size))


def elements_that_follow(half_turn: Fraction, sides: tuple[str, ...] = ("left", "right")) -> sympy.Integer:
    matrices = {side: rotation(ANGLES[side], half_turn) for side in sides}
    return sum(follows(MATRICES[s][i][j], matrices[s][i, j], ROUNDING[s]) for s in sides for i, j in ELEMENTS)


section.identity(
    "4/b/beyond/gon#true",
    "the matrices R' and R'' are rotations by round angles in gon of pi/200: how many of their 18 elements follow",
    printed=4,
    derived=elements_that_follow(TRUE_HALF_TURN),
    note="Not in the paper, which gives no angles: with the true pi most elements do not follow.  The constant for pi "
    "was 3.14159159, see 4/b/beyond/gon; how much rests on it is said in 4/i/beyond/gon.",
)
section.identity(
    "4/b/beyond/gon",
    "how many of the 18 elements follow with 3.14159158, 3.14159159, 3.14159160 for pi",
    printed=vector(14, 17, 15),
    derived=vector(*(elements_that_follow(HALF_TURN + step * Fraction(1, 10**8)) for step in (-1, 0, 1))),
    note="Not in the paper.  The element that does not follow is r''21, see 4/b#right.R21.",
)
NINE_DECIMALS = [Fraction(3141591580 + step, 10**9) for step in range(20)]
section.identity(
    "4/b/beyond/gon#nine-decimals",
    "numbers for pi from 3.141591580 to 3.141591599 with which eight elements of R'' follow: the last two digits",
    printed=vector(*range(86, 93)),
    derived=chosen(
        vector(*(at_most(sympy.Integer(8), elements_that_follow(each, ("right",))) for each in NINE_DECIMALS)),
        vector(*range(80, 100)),
    ),
    note="Not in the paper.  Three elements of R'' have ten decimals.",
)

# %% [markdown]
# ### The cells
#
# The epipoles, far outside the pictures, are the most sensitive to the rotations.  The last column, $u''_2$, has been
# cut off: its seven decimals are the first seven of the eight with which item g) prints such numbers.  What does not
# follow is a slip.

# %%
SAME_PLACE = "the affine coordinates of the point, which follow from x and y, hold"
IMAGE_SLIPS = {
    ("left", "12", 1): ("-0.0953180", f"A doubled digit: {SAME_PLACE}."),
    ("right", "14", 1): ("0.0228074", f"One digit: {SAME_PLACE}."),
    ("left", "16", 3): (
        "0.7786466",
        "One digit: x and y of the point hold, and items g) and i) confirm the correction.",
    ),
    ("right", "4", 3): ("0.0000000", "Point 4 is the first unit point, u = (1, 0); items g) and i) print the zero."),
}
COLUMNS = ("x", "y", "u1", "u2")
EIGHT_DECIMALS = (
    "The last column of the table: the eighth decimal is missing.  The derived number is the unrounded one with eight "
    "decimals, of which the last is cut off.  Three cells of the column show it, the points 6, 8 and 11; in all other "
    "columns the last digit is rounded."
)


def picture(rotation_matrix: Matrix, center: str) -> dict[str, Matrix]:
    directions = {
        name: rotation_matrix * (X - object_points[center]) for name, X in object_points.items() if name != center
    }
    return {name: -PRINCIPAL_DISTANCE * vector(v[0], v[1]) / v[2] for name, v in directions.items()}


def cells(points: dict[str, Matrix], name: str) -> tuple[sympy.Rational, ...]:
    return (*points[name], *affine(points, BASIC[:3], name))


def item_b(matrices: dict[str, Matrix]) -> dict[str, sympy.Rational]:
    """Return the exact numbers of the item, from two rotation matrices."""
    values = {f"{side}.R{i + 1}{j + 1}": matrices[side][i, j] for side in MATRICES for i, j in ELEMENTS}
    for side, (table, center) in PICTURES.items():
        points = picture(matrices[side], center)
        for name in table:
            values |= {f"{name}.{side}.{c}": v for c, v in zip(COLUMNS, cells(points, name), strict=True)}
            last = values[f"{name}.{side}.u2"]
            if side == "right":
                values[f"{name}.{side}.u2"] = sympy.Rational(f"{rounded(Fraction(int(last.p), int(last.q)), 8):f}")
    return values


full_values = item_b(FULL_ROTATIONS)
for side, (table, _) in PICTURES.items():
    for name, printed in table.items():
        for place, (column, cell) in enumerate(zip(COLUMNS, printed, strict=True)):
            slip = IMAGE_SLIPS.get((side, name, place))
            cut = (side, column) == ("right", "u2")
            section.numeric(
                f"4/b#{name}.{side}.{column}",
                f"point {name}, {side} picture, {column}",
                printed=cell,
                derived=full_values[f"{name}.{side}.{column}"],
                rounding="cut" if cut else "nearest",
                **(
                    {"expect": "misprint", "corrected": slip[0], "note": slip[1]}
                    if slip
                    else {"note": EIGHT_DECIMALS if cut else ""}
                ),
            )

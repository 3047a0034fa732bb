# %% [markdown]
# # 2 Coordinates without divisions
#
# A point of $y^2 = x^3 + a x + b$ in homogeneous coordinates is $(X/Z, Y/Z)$, in Jacobian ones $(X/Z^2, Y/Z^3)$.  The
# formulas are held against chord and tangent in affine coordinates.

# %%
import sympy

from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, Scalar, over, vector
from elliptic_curves.notation import *

section = Section("elliptic_curves", "2", "Homogeneous and Jacobian coordinates")
weierstrass = y**2 - (x**3 + a * x + b)
X, Y, Z, X1, X2, Y1, Y2, Z1, Z2, c = sympy.symbols("X Y Z X1 X2 Y1 Y2 Z1 Z2 c")


def affine(point: Matrix) -> Matrix:
    """Return the affine coordinates of a point in Jacobian coordinates."""
    return vector(over(point[0], point[2] ** 2), over(point[1], point[2] ** 3))


J, J1, J2 = vector(X, Y, Z), vector(X1, Y1, Z1), vector(X2, Y2, Z2)

section.identity(
    "2.1",
    "the curve in Jacobian coordinates",
    printed=Y**2 - (X**3 + a * X * Z**4 + b * Z**6),
    derived=Z**6 * at(weierstrass, affine(J)),
)
section.identity(
    "2.1/weights",
    "Jacobian coordinates may be scaled by the square, the cube and the number itself",
    printed=affine(J),
    derived=affine(vector(c**2 * X, c**3 * Y, c * Z)),
)

# %% [markdown]
# ## Doubling

# %%
S_, M = sympy.symbols("s_n m_n")
steps = {S_: 4 * X * Y**2, M: 3 * X**2 + a * Z**4}
X3 = M**2 - 2 * S_
doubled = vector(X3, M * (S_ - X3) - 8 * Y**4, 2 * Y * Z)
twice = double_of(weierstrass, affine(J))
section.identity("2.2", "doubling in Jacobian coordinates", printed=affine(doubled), where=steps, derived=twice)
section.identity(
    "2.2#Y",
    "ordinate of the double",
    printed=M * (S_ - X3) - 8 * Y**2,
    where=steps,
    derived=twice[1] * (2 * Y * Z) ** 3,
    expect="misprint",
    corrected=M * (S_ - X3) - 8 * Y**4,
    note="An exponent is lost; the weights 6 of all terms tell.",
)
section.identity(
    "2.2/a=-3",
    "the factor M where a is -3",
    printed=3 * (X - Z**2) * (X + Z**2),
    derived=steps[M].subs(a, -3),
)

# %% [markdown]
# ## Addition

# %%
H, R, U1, S1 = sympy.symbols("h_n r_n u_n v_n")


def abbreviations(p: Matrix, q: Matrix) -> dict[sympy.Symbol, Scalar]:
    """Return both points on one denominator: U1, S1, and what the other point differs by."""
    first, second = (vector(r[0] * s[2] ** 2, r[1] * s[2] ** 3) for r, s in ((p, q), (q, p)))
    return {U1: first[0], S1: first[1], H: second[0] - first[0], R: second[1] - first[1]}


X3_sum = R**2 - H**3 - 2 * U1 * H**2
added = vector(X3_sum, R * (U1 * H**2 - X3_sum) - S1 * H**3, H * Z1 * Z2)
section.identity(
    "2.3",
    "addition in Jacobian coordinates",
    printed=affine(added),
    where=abbreviations(J1, J2),
    derived=sum_of(weierstrass, affine(J1), affine(J2)),
)
section.identity(
    "2.3/mixed",
    "addition of an affine point",
    printed=affine(added.subs(Z2, 1)),
    where=abbreviations(J1, vector(X2, Y2, 1)),
    derived=sum_of(weierstrass, affine(J1), vector(X2, Y2)),
)
same = abbreviations(J, J)
section.identity(
    "2.3/equal-points",
    "the formulas of addition give the double of a point that is added to itself",
    printed=doubled.xreplace(steps),
    derived=added.subs({Z1: Z, Z2: Z}).xreplace(same),
    expect="false",
    instead="2.3/equal-points#zero",
    note="The case must be told apart, or the result is not a point at all.",
)
section.identity(
    "2.3/equal-points#zero",
    "for equal points all three coordinates are zero",
    printed=vector(0, 0, 0),
    derived=added.subs({Z1: Z, Z2: Z}).xreplace(same),
)

# %% [markdown]
# ## Homogeneous coordinates

# %%
u, v, w, s = sympy.symbols("u v w s")
long = u**2 * Z1 * Z2 - v**3 - 2 * v**2 * X1 * Z2
section.up_to_scale(
    "2.4",
    "addition in homogeneous coordinates",
    printed=vector(v * long, u * (v**2 * X1 * Z2 - long) - v**3 * Y1 * Z2, v**3 * Z1 * Z2),
    where={u: Y2 * Z1 - Y1 * Z2, v: X2 * Z1 - X1 * Z2},
    derived=vector(*sum_of(weierstrass, vector(over(X1, Z1), over(Y1, Z1)), vector(over(X2, Z2), over(Y2, Z2))), 1),
)
short = w**2 - 8 * X * Y * s
section.up_to_scale(
    "2.5",
    "doubling in homogeneous coordinates",
    printed=vector(2 * short * s, w * (4 * X * Y * s - short) - 8 * Y**2 * s**2, 8 * s**3),
    where={w: a * Z**2 + 3 * X**2, s: Y * Z},
    derived=vector(*double_of(weierstrass, vector(over(X, Z), over(Y, Z))), 1),
)

# %% [markdown]
# ## Code

# %%
section.kernel(
    "weierstrass.double_jacobian",
    "Double of a point in Jacobian coordinates, without a division.",
    arguments={"p": J, "a": a},
    derived=doubled.xreplace(steps),
    form=doubled,
    where=steps,
    claims=["2.2"],
    describe={"p": "Jacobian coordinates of a point of the curve.", "a": "Coefficient of the curve."},
    example={"p": ("3.0", "5.0", "1.0"), "a": "0.0"},
)

# %% [markdown]
# # 4 Edwards curves
#
# $a x^2 + y^2 = 1 + d x^2 y^2$, with the neutral element $(0, 1)$: one formula adds any two points, equal ones too.
# It is derived from chord and tangent of the Montgomery curve to which the Edwards curve is mapped.

# %%
import sympy

from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, over, vector
from elliptic_curves.notation import *

section = Section("elliptic_curves", "4", "Edwards curves")
edwards = a * x**2 + y**2 - (1 + d * x**2 * y**2)

section.definition("4.1", "twisted Edwards form, zero on the curve", printed=edwards)

# %% [markdown]
# ## The map to a Montgomery curve

# %%
montgomery = B * y**2 - (x**3 + A * x**2 + x)
coefficients = {A: over(2 * (a + d), a - d), B: over(4, a - d)}


def to_montgomery(p: Matrix) -> Matrix:
    abscissa = over(1 + p[1], 1 - p[1])
    return vector(abscissa, over(abscissa, p[0]))


def to_edwards(p: Matrix) -> Matrix:
    return vector(over(p[0], p[1]), over(p[0] - 1, p[0] + 1))


P = vector(x, y)
section.identity(
    "4.2",
    "the image of the curve is a Montgomery curve",
    printed=over(-4 * (1 + y) * edwards, (a - d) * x**2 * (1 - y) ** 3),
    derived=at(montgomery, to_montgomery(P)).xreplace(coefficients),
    note="Both equations vanish together, but for the points that the map does not reach.",
)
section.identity("4.2/inverse", "the map and its inverse", printed=P, derived=to_edwards(to_montgomery(P)))

# %% [markdown]
# ## Addition

# %%


def added(p: Matrix, q: Matrix) -> Matrix:
    product = d * p[0] * q[0] * p[1] * q[1]
    return vector(
        over(p[0] * q[1] + p[1] * q[0], 1 + product),
        over(p[1] * q[1] - a * p[0] * q[0], 1 - product),
    )


both = through(edwards, (a, d), P1, P2)
image = sum_of(montgomery.xreplace(coefficients), to_montgomery(P1), to_montgomery(P2))
total = to_edwards(image).xreplace(both)
section.identity("4.3", "sum of two points", printed=added(P1, P2), where=both, derived=total)
section.identity(
    "4.3#sign",
    "ordinate of the sum",
    printed=over(y1 * y2 + a * x1 * x2, 1 - d * x1 * x2 * y1 * y2),
    where=both,
    derived=total[1],
    expect="misprint",
    corrected=over(y1 * y2 - a * x1 * x2, 1 - d * x1 * x2 * y1 * y2),
    note="Often met with the sign of the abscissa; as on the circle, it is that of the cosine.",
)
section.identity(
    "4.3/closed",
    "the sum is a point of the curve",
    printed=0,
    derived=at(edwards, added(P1, P2)).xreplace(both),
)
section.identity("4.3/neutral", "the neutral element", printed=P1, derived=added(P1, vector(0, 1)))
one = through(edwards, (a,), P1)
section.identity(
    "4.3/inverse", "the inverse of a point", printed=vector(0, 1), derived=added(P1, vector(-x1, y1)).xreplace(one)
)
section.identity(
    "4.3/circle",
    "on the circle: sine and cosine of a sum",
    printed=vector(x1 * y2 + y1 * x2, y1 * y2 - x1 * x2),
    derived=added(P1, P2).subs({a: 1, d: 0}),
)

# %% [markdown]
# The formula is *unified*: with the tangent of the Montgomery curve it is the same.

# %%
tangential = to_edwards(double_of(montgomery.xreplace(coefficients), to_montgomery(P1))).xreplace(one)
section.identity(
    "4.4", "double of a point by the formula of addition", printed=added(P1, P1), where=one, derived=tangential
)
section.identity(
    "4.4#short",
    "double of a point, without d",
    printed=vector(over(2 * x1 * y1, a * x1**2 + y1**2), over(y1**2 - a * x1**2, 2 - a * x1**2 - y1**2)),
    where=one,
    derived=tangential,
)

# %% [markdown]
# ## Completeness
#
# The denominators vanish where $\varepsilon = d x_1 x_2 y_1 y_2$ is $\pm 1$.  On $x^2 + y^2 = 1 + d x^2 y^2$ this makes
# $d$ a square: where both points are on the curve and $\varepsilon^2 = 1$, every term on the left of (4.5/square) is
# zero.  And if $d$ is a square, there are such points.

# %%
circular = edwards.subs(a, 1)
epsilon = d * x1 * x2 * y1 * y2
section.vanishing(
    "4.5",
    "where the sum of two points has no finite coordinates",
    printed=(1 + epsilon, 1 - epsilon),
    derived=sympy.expand((1 + epsilon) * (1 - epsilon)),
)
section.identity(
    "4.5/square",
    "where a denominator vanishes, d is a square",
    printed=at(circular, P1) - d * x1**2 * y1**2 * at(circular, P2) + (y1**2 - 1) * (epsilon**2 - 1),
    derived=(x1 + epsilon * y1) ** 2 - d * x1**2 * y1**2 * (x2 + y2) ** 2,
)
e = sympy.Symbol("e_n")
partner = vector(over(1, e * y1), over(1, e * x1))
section.identity(
    "4.5/exceptional#curve",
    "a point whose partner, for d = e^2, is on the curve as well",
    printed=over(at(circular, P1), e**2 * x1**2 * y1**2).subs(d, e**2),
    derived=at(circular, partner).subs(d, e**2),
)
section.identity(
    "4.5/exceptional#denominator",
    "a denominator of their sum is zero",
    printed=0,
    derived=1 - e**2 * x1 * y1 * partner[0] * partner[1],
)

# %% [markdown]
# ## Coordinates without divisions

# %%
X1, X2, Y1, Y2, Z1, Z2 = sympy.symbols("X1 X2 Y1 Y2 Z1 Z2")
first, second = vector(over(X1, Z1), over(Y1, Z1)), vector(over(X2, Z2), over(Y2, Z2))
F, G, K, L = sympy.symbols("f_n g_n k_n l_n")
steps = {K: Z1 * Z2, L: d * X1 * X2 * Y1 * Y2}
section.up_to_scale(
    "4.6",
    "addition in homogeneous coordinates",
    printed=vector(
        K * (K**2 - L) * (X1 * Y2 + Y1 * X2),
        K * (K**2 + L) * (Y1 * Y2 - a * X1 * X2),
        (K**2 - L) * (K**2 + L),
    ),
    where=steps,
    derived=vector(*added(first, second), 1),
)
T1, T2 = over(X1 * Y1, Z1), over(X2 * Y2, Z2)
low, high = (Y1 - X1) * (Y2 - X2), (Y1 + X1) * (Y2 + X2)
minus, plus = 2 * Z1 * Z2 - 2 * d * T1 * T2, 2 * Z1 * Z2 + 2 * d * T1 * T2
twisted = added(first, second).subs(a, -1)
section.up_to_scale(
    "4.7",
    "addition in extended coordinates, a = -1",
    printed=vector(F * (high - low), G * (high + low), F * G, (high - low) * (high + low)),
    where={F: minus, G: plus},
    derived=vector(*twisted, 1, twisted[0] * twisted[1]),
)

# %% [markdown]
# ## Code

# %%
section.kernel(
    "edwards.add",
    "Sum of two points, equal or not, of a twisted Edwards curve.",
    arguments={"p": P1, "q": P2, "a": a, "d": d},
    derived=added(P1, P2),
    claims=["4.3", "4.4"],
    describe={
        "p": "Affine coordinates of a point of the curve.",
        "q": "The same, of another or the same point.",
        "a": "Coefficient of x^2.",
        "d": "Coefficient of x^2 y^2.",
    },
    example={"p": ("0.0", "1.0"), "q": ("0.5", "0.25"), "a": "1.0", "d": "-44.0"},
)

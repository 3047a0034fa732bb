# %% [markdown]
# # 3 Montgomery curves
#
# $B y^2 = x^3 + A x^2 + x$: abscissas can be added and doubled without ordinates.

# %%
import sympy

from algebroproj_sym import Section
from algebroproj_sym.expressions import over, vector
from elliptic_curves.notation import *

section = Section("elliptic_curves", "3", "Montgomery curves")
montgomery = B * y**2 - (x**3 + A * x**2 + x)

section.definition("3.1", "Montgomery form, zero on the curve", printed=montgomery)

# %% [markdown]
# ## The short Weierstrass form
#
# The square term is removed by a translation, $B$ by a scale.

# %%
short = {a: over(3 - A**2, 3 * B**2), b: over(2 * A**3 - 9 * A, 27 * B**3)}
mapped = vector(over(x, B) + over(A, 3 * B), over(y, B))
section.identity(
    "3.2",
    "coefficients of the short Weierstrass form",
    printed=at(y**2 - (x**3 + a * x + b), mapped),
    where=short,
    derived=over(montgomery, B**3),
)
j_invariant = over(6912 * a**3, 4 * a**3 + 27 * b**2).xreplace(short)
section.identity(
    "3.3",
    "j-invariant",
    printed=over(256 * (A**2 - 3) ** 3, A**2 - 4),
    derived=j_invariant,
)
section.vanishing(
    "3.3/singular",
    "where the curve is singular",
    printed=(A - 2, A + 2),
    derived=(4 * a**3 + 27 * b**2).xreplace(short),
)

# %% [markdown]
# ## Sum and difference

# %%
total = sum_of(montgomery, P1, P2)
section.identity(
    "3.4",
    "abscissa of the sum",
    printed=B * m**2 - A - x1 - x2,
    where={m: chord(P1, P2)},
    derived=total[0],
)
both = through(montgomery, (A, B), P1, P2)
section.identity(
    "3.5",
    "product of the abscissas of sum and difference",
    printed=over((x1 * x2 - 1) ** 2, (x1 - x2) ** 2),
    derived=(total[0] * sum_of(montgomery, P1, mirrored(P2))[0]).xreplace(both),
)

# %% [markdown]
# ## The double

# %%
one = through(montgomery, (B,), P1)
double = double_of(montgomery, P1).xreplace(one)
section.identity(
    "3.6",
    "abscissa of the double",
    printed=over((x1**2 - 1) ** 2, 4 * x1 * (x1**2 + A * x1 + 1)),
    derived=double[0],
)
section.identity(
    "3.6/order-four",
    "the double of a point with abscissa 1 is (0, 0)",
    printed=vector(0, 0),
    derived=double.subs(x1, 1),
)

X, Z, E_ = sympy.symbols("X Z e_n")
ratio = double[0].subs({x1: over(X, Z)})
step = {E_: (X + Z) ** 2 - (X - Z) ** 2}
section.identity("3.7/difference", "difference of the squares", printed=4 * X * Z, derived=step[E_])
denominator = over((X**2 - Z**2) ** 2, ratio)
section.identity(
    "3.7",
    "denominator of the double",
    printed=E_ * ((X - Z) ** 2 + over(A - 2, 4) * E_),
    where=step,
    derived=denominator,
    expect="misprint",
    corrected=E_ * ((X - Z) ** 2 + over(A + 2, 4) * E_),
    note="Two forms are in use, with (A + 2)/4 beside (X - Z)^2 and (A - 2)/4 beside (X + Z)^2; this one mixes them.",
)
section.identity(
    "3.7#other",
    "denominator of the double, the other form",
    printed=E_ * ((X + Z) ** 2 + over(A - 2, 4) * E_),
    where=step,
    derived=denominator,
)

# %% [markdown]
# ## Code
#
# The scale of the ordinates is free: $y_1 = 1$.

# %%
section.kernel(
    "montgomery.double",
    "Abscissa of the double of a point of a Montgomery curve.",
    arguments={"x1": x1, "A": A},
    derived=double[0].subs(y1, 1),
    form=over((x1**2 - 1) ** 2, 4 * x1 * (x1 * (x1 + A) + 1)),
    claims=["3.6"],
    describe={"x1": "Abscissa of the point.", "A": "Coefficient of the curve."},
    example={"x1": "2.0", "A": "3.0"},
)

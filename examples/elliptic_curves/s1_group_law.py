# %% [markdown]
# # 1 The group law of a cubic
#
# $y^2 = x^3 + a x + b$.  A line meets the cubic in three points, and three points of a line have the sum zero; the
# neutral element is the point at infinity, so that $-(x, y) = (x, -y)$.

# %%
import sympy

from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, determinant, over, vector
from elliptic_curves.notation import *

section = Section("elliptic_curves", "1", "The group law")
weierstrass = y**2 - (x**3 + a * x + b)

section.definition("1.1", "short Weierstrass form, zero on the curve", printed=weierstrass)

# %% [markdown]
# ## The sum of two points
#
# On the line of slope $m$ the abscissas are the roots of a cubic polynomial; their sum is minus its second coefficient.

# %%
total = sum_of(weierstrass, P1, P2)
section.identity(
    "1.2/third",
    "abscissa of the third point of a line of slope m",
    printed=m**2 - x1 - x2,
    derived=third_intersection(weierstrass, m, P1, P2)[0],
)
section.identity(
    "1.2",
    "sum of two points",
    printed=vector(m**2 - x1 - x2, m * (x1 - t) - y1),
    where={m: chord(P1, P2), t: chord(P1, P2) ** 2 - x1 - x2},
    derived=total,
)
section.identity(
    "1.2#mirror",
    "ordinate of the sum",
    printed=y1 + m * (t - x1),
    where={m: chord(P1, P2), t: chord(P1, P2) ** 2 - x1 - x2},
    derived=total[1],
    expect="misprint",
    corrected=-(y1 + m * (t - x1)),
    note="Often met: the third point of the line is taken for the sum, and not mirrored.",
)

# %% [markdown]
# ## The group
#
# Two points lie on one curve $y^2 = x^3 + a x + b$, three on one curve $y^2 = x^3 + A x^2 + a x + b$; with these
# coefficients the points are free, and every law is an identity of rational functions.

# %%
both = through(weierstrass, (a, b), P1, P2)
section.identity(
    "1.3/closed",
    "the sum is a point of the curve",
    printed=(x**3 + a * x + b).subs({x: total[0]}),
    where=both,
    derived=total[1] ** 2,
)
section.identity(
    "1.3/commutative", "the order of two points does not matter", printed=total, derived=sum_of(weierstrass, P2, P1)
)
section.identity(
    "1.3/cancel",
    "adding and subtracting a point changes nothing",
    printed=P1,
    derived=sum_of(weierstrass, total, mirrored(P2)),
    note="The curve through both points is not needed: the two lines are mirror images.",
)

general = y**2 - (x**3 + A * x**2 + a * x + b)
all_three = through(general, (A, a, b), P1, P2, P3)
cubic = general.subs(A, all_three[A])
section.identity(
    "1.3/associative",
    "the sum of three points, in general position, does not depend on the order of the additions",
    printed=sum_of(cubic, sum_of(cubic, P1, P2), P3),
    derived=sum_of(cubic, P1, sum_of(cubic, P2, P3)),
    note="Any three points with different abscissas lie on a curve of this form: nothing else is assumed.",
)

# %% [markdown]
# ## The double of a point

# %%
double = double_of(weierstrass, P1)
slope = over(3 * x1**2 + a, 2 * y1)
section.identity("1.4/slope", "slope of the tangent", printed=slope, derived=tangent(weierstrass, P1))
section.identity(
    "1.4",
    "double of a point",
    printed=vector(m**2 - 2 * x1, m * (x1 - t) - y1),
    where={m: slope, t: slope**2 - 2 * x1},
    derived=double,
)
on_curve = y1**2 - (x1**3 + a * x1 + b)
section.identity(
    "1.4#x",
    "abscissa of the double, from the abscissa alone",
    printed=over(x1**4 - 2 * a * x1**2 - 8 * b * x1 + a**2, 4 * (x1**3 + a * x1 + b)),
    derived=double[0],
    constraints=[on_curve],
)
section.identity(
    "1.4/x",
    "abscissa of the double of a point of y^2 = x^3 - 2",
    printed=over(x1 * (x1**3 + 16), 4 * (x1**3 - 2)),
    derived=double[0].subs(a, 0),
    constraints=[y1**2 - x1**3 + 2],
    witness={x1: 3, y1: 5},
)
bachet = {a: 0, x1: 3, y1: 5}
section.numeric("1.4/bachet#x", "double of (3, 5) on y^2 = x^3 - 2", printed="1.29", derived=double[0].subs(bachet))
section.numeric("1.4/bachet#y", "double of (3, 5) on y^2 = x^3 - 2", printed="-0.383", derived=double[1].subs(bachet))

# %% [markdown]
# ## One slope for both cases

# %%
unified = over(x1**2 + x1 * x2 + x2**2 + a, y1 + y2)
section.identity(
    "1.5",
    "slope of the chord of two points of the curve",
    printed=unified,
    derived=chord(P1, P2),
    constraints=[on_curve, on_curve.subs({x1: x2, y1: y2})],
    witness={x1: 0, y1: 1, x2: 1, y2: 2, a: 2, b: 1},
)
section.identity(
    "1.5/tangent",
    "in equal points it is the tangent's",
    printed=unified.subs({x2: x1, y2: y1}),
    derived=tangent(weierstrass, P1),
)
section.identity(
    "1.5/anywhere",
    "slope of the chord of any two points",
    printed=unified,
    derived=chord(P1, P2),
    expect="false",
    instead="1.5",
    note="The slope is that of the chord for points of the curve only.",
)

# %% [markdown]
# ## Torsion and invariants

# %%
abscissa = over(x**4 - 2 * a * x**2 - 8 * b * x + a**2, 4 * (x**3 + a * x + b))
section.vanishing(
    "1.6",
    "points of order three: the double has the same abscissa",
    printed=(3 * x**4 + 6 * a * x**2 + 12 * b * x - a**2,),
    derived=abscissa - x,
)
sylvester = Matrix([[1, 0, a, b, 0], [0, 1, 0, a, b], [3, 0, a, 0, 0], [0, 3, 0, a, 0], [0, 0, 3, 0, a]])
discriminant = -16 * determinant(sylvester)
section.identity("1.7", "discriminant", printed=-16 * (4 * a**3 + 27 * b**2), derived=discriminant)
j_invariant = over((-48 * a) ** 3, discriminant)
section.identity(
    "1.8",
    "j-invariant",
    printed=over(1728 * a**3, 4 * a**3 + 27 * b**2),
    derived=j_invariant,
    expect="misprint",
    corrected=over(1728 * 4 * a**3, 4 * a**3 + 27 * b**2),
    note="Often met without the factor 4, with which j = 1728 for b = 0.",
)
u = sympy.Symbol("u")
section.identity(
    "1.8/scaling",
    "curves that differ by a change of scale have the same j-invariant",
    printed=j_invariant,
    derived=j_invariant.subs({a: u**4 * a, b: u**6 * b}, simultaneous=True),
)

# %% [markdown]
# ## Code

# %%
ABOUT_POINT = "Affine coordinates of a point of the curve."
section.kernel(
    "weierstrass.add",
    "Sum of two points with different abscissas of a curve y^2 = x^3 + a x + b.",
    arguments={"p": P1, "q": P2},
    derived=total,
    form=vector(m**2 - x1 - x2, m * (2 * x1 + x2 - m**2) - y1),
    where={m: chord(P1, P2)},
    claims=["1.2", "1.3/closed"],
    describe={"p": ABOUT_POINT, "q": "Another one."},
    example={"p": ("3.0", "5.0"), "q": ("1.29", "-0.383")},
)
section.kernel(
    "weierstrass.double",
    "Double of a point of a curve y^2 = x^3 + a x + b.",
    arguments={"p": P1, "a": a},
    derived=double,
    form=vector(m**2 - 2 * x1, m * (3 * x1 - m**2) - y1),
    where={m: slope},
    claims=["1.4"],
    describe={"p": ABOUT_POINT, "a": "Coefficient of the curve."},
    example={"p": ("3.0", "5.0"), "a": "0.0"},
)

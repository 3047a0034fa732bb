# %% [markdown]
# # 2.3 Functions
#
# The determinant of the five equations, and the quadric on which it vanishes.

# %%
from itertools import combinations

import sympy

from algebroproj_derivations.drivers import classify
from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s2_2_correlation import primed
from algebroproj_derivations.fundamentals1996.s2_2_functions import factored_equations, five_left, five_right
from algebroproj_derivations.fundamentals1996.s2_3_critical_situations import (
    A8,
    Q_of_minors,
    four_points,
    in_space,
    minors_of_points,
    point,
)
from algebroproj_derivations.fundamentals1996.s2_3_factorisation import (
    Q,
    at_infinity,
    characteristic,
    elements,
    symmetric,
    t,
)
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, determinant, dot, over, vector

section = Section("fundamentals1996", "2.3", "Critical situations: functions")

# %% [markdown]
# ## The determinant
#
# It stays a nested product of shared minors.

# %%
ABOUT_IMAGES = "five points (u1, u2) in affine coordinates, referred to the images of G0, G1, G2; dimensionless."
section.kernel(
    "critical.determinant",
    "Determinant of the five equations for the matrix of correlation.",
    arguments={"u_left": five_left, "u_right": five_right},
    describe={"u_left": f"Left image: {ABOUT_IMAGES}", "u_right": f"Right image: {ABOUT_IMAGES}"},
    derived=determinant(A8),
    form=determinant(factored_equations[:, :5]),
    claims=["2.3/A7", "2.3/A5"],
    example={
        "u_left": (("0.25", "0.125"), ("0.625", "0.75"), ("-0.5", "0.875"), ("1.25", "-0.375"), ("0.75", "1.5")),
        "u_right": (("0.3125", "-0.25"), ("0.5", "0.875"), ("-0.625", "0.75"), ("1.125", "-0.25"), ("0.875", "1.25")),
    },
    normwise=True,
)
section.kernel(
    "critical.algebraic_distance",
    "Value of the quadratic form of a quadric at a point; zero on the quadric.",
    arguments={"Q": Q, "y": vector(y1, y2, y3)},
    describe={
        "Q": "Quadric in homogeneous coordinates (1, y1, y2, y3), as critical.quadric gives it; all entries are used.",
        "y": "Point (y1, y2, y3) in affine coordinates; dimensionless.",
    },
    derived=dot(point, Q * point),
    claims=["2.3/Q"],
    example={
        "Q": (("0", "-1", "-1", "-1"), ("-1", "2", "0", "0"), ("-1", "0", "2", "0"), ("-1", "0", "0", "2")),
        "y": ("0.625", "0.75", "0.25"),
    },
)

# %% [markdown]
# ## The quadric
#
# Computed from the minors of four equations, as in (2.3.3), the quadric loses all digits where cameras or points are
# badly scaled: the forms share what the factorisation takes out.  The code has it from the ten points instead.  In
# barycentric coordinates $b_j$ the basic points are unit vectors, and the seven products are those of two different
# coordinates, and $b_3^2$.  The coordinates of a center are polynomials, whose products have the factor $\mu_1 \mu_2$;
# without it, and with $c_{10}$, the signed minors of six rows are the coefficients of the quadric.

# %%
PAIRS = ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3), (3, 3))
SHARED: dict[sympy.Symbol, sympy.Expr] = {}


def named(name: str, expression: sympy.Expr) -> sympy.Symbol:
    """Return the symbol of an abbreviation."""
    symbol = sympy.Symbol(name)
    SHARED[symbol] = expression
    return symbol


def row_of_point(k: int) -> list[sympy.Symbol]:
    b1, b2, b3 = in_space(k)[1:, :]
    b = (named(f"b{k}", 1 - b1 - b2 - b3), b1, b2, b3)
    return [named(f"f{k}_{i}{j}", b[i] * b[j]) for i, j in PAIRS]


def row_of_center(primes: str) -> list[sympy.Symbol]:
    m1, m2, m3 = primed(mu, primes)
    v1, v2 = primed(fourth_image, primes)
    v0 = named(f"u{primes}30", 1 - v1 - v2)
    b = (v0 * m1 * m2 * m3, v1 * m2 * m3, v2 * m1 * m3, -m1 * m2)
    return [named(f"f{primes}_{i}{j}", b[i] * b[j] / (m1 * m2)) for i, j in PAIRS]


six_points = Matrix([*(row_of_point(k) for k in range(3, 7)), row_of_center("p"), row_of_center("pp")])
minors = {(j,): six_points[5, j] for j in range(7)}
for row in reversed(range(5)):
    for chosen in combinations(range(7), 6 - row):
        terms = [
            (-1) ** place * six_points[row, j] * minors[chosen[:place] + chosen[place + 1 :]]
            for place, j in enumerate(chosen)
        ]
        minors[chosen] = named("m" + "".join(map(str, chosen)), sympy.Add(*terms))

divisor = named("c10", elements[5])
cofactors = {
    pair: named(f"r{pair[0]}{pair[1]}", (-1) ** place * divisor * minors[tuple(j for j in range(7) if j != place)])
    for place, pair in enumerate(PAIRS)
}


def coefficient(i: int, j: int) -> sympy.Expr:
    """Return twice an element of the quadric in barycentric coordinates."""
    return cofactors.get((min(i, j), max(i, j)), sympy.Integer(0)) * (1 + int(i == j))


def element(i: int, j: int) -> sympy.Expr:
    """Return an element of the quadric in affine coordinates."""
    if i == j == 3:
        return cofactors[3, 3] - cofactors[0, 3]
    if i == j:
        return -coefficient(0, i)
    if 0 in (i, j):
        return over(coefficient(i, j), 2)
    return over(coefficient(i, j) - coefficient(0, i) - coefficient(0, j), 2)


section.kernel(
    "critical.quadric",
    "Quadric of the points that, with four given points, make the five equations singular.",
    arguments={
        "mu_left": primed(mu, "p"),
        "u3_left": primed(fourth_image, "p"),
        "mu_right": primed(mu, "pp"),
        "u3_right": primed(fourth_image, "pp"),
        "y": Matrix.vstack(*(y[1:, :].T for y in four_points)),
    },
    describe={
        "mu_left": f"Left image: {ABOUT_MU}",
        "u3_left": f"Left image: {ABOUT_U3}",
        "mu_right": f"Right image: {ABOUT_MU}",
        "u3_right": f"Right image: {ABOUT_U3}",
        "y": "Four points (y1, y2, y3) in affine coordinates; dimensionless.",
    },
    derived=Q_of_minors.xreplace(minors_of_points),
    form=Matrix(4, 4, element),
    where=SHARED,
    claims=["2.3.3", "2.3/X", "2.3/Q", "2.3/beyond/theorem"],
    example={
        "mu_left": ("0.625", "0.75", "0.5"),
        "u3_left": ("0.25", "0.125"),
        "mu_right": ("0.75", "0.625", "0.875"),
        "u3_right": ("0.3125", "-0.25"),
        "y": (
            ("0.625", "0.75", "0.25"),
            ("-0.5", "0.875", "0.125"),
            ("1.25", "-0.375", "-0.25"),
            ("0.75", "1.5", "0.375"),
        ),
    },
    normwise=True,
)

# %% [markdown]
# ## Its type
#
# The invariants count signs; `classify` names the type.


# %%
def coefficients_of(polynomial: sympy.Expr, degree: int) -> Matrix:
    """Return the coefficients of a polynomial of t below the leading one."""
    return vector(*(sympy.Poly(polynomial, t).coeff_monomial(t ** (degree - k)) for k in range(1, degree + 1)))


section.kernel(
    "critical.invariants",
    "Coefficients below the leading ones in the characteristic polynomials of a quadric and its block at infinity.",
    arguments={"Q": Q},
    describe={
        "Q": "Symmetric matrix of a quadric in homogeneous coordinates (1, y1, y2, y3); the upper triangle is used."
    },
    derived={
        "whole": coefficients_of(determinant(t * Matrix.eye(4) - symmetric), 4),
        "at_infinity": coefficients_of(determinant(t * Matrix.eye(3) - at_infinity), 3),
    },
    form={"whole": characteristic(symmetric), "at_infinity": characteristic(at_infinity)},
    claims=["2.3/beyond/invariants#whole", "2.3/beyond/invariants#at-infinity", "2.3/beyond/invariants#affine"],
    example={"Q": (("0", "-1", "-1", "-1"), ("-1", "2", "0", "0"), ("-1", "0", "2", "0"), ("-1", "0", "0", "2"))},
)
section.driver("critical.classify", classify)

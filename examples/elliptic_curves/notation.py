"""What all sections share: points, chord and tangent, and the curve through given points.

Everything is rational: instead of asking that points satisfy the equation of a given curve, the free coefficients of
the curve are computed from the points.
"""

import sympy

from algebroproj_sym.expressions import Matrix, Scalar, over, solve, vector

x, x1, x2, x3, y, y1, y2, y3 = sympy.symbols("x x1 x2 x3 y y1 y2 y3")
a, b, d, A, B, m, t = sympy.symbols("a b d A B m t")
P1, P2, P3 = vector(x1, y1), vector(x2, y2), vector(x3, y3)


def chord(p: Matrix, q: Matrix) -> Scalar:
    """Return the slope of the line through two points."""
    return over(q[1] - p[1], q[0] - p[0])


def tangent(curve: Scalar, p: Matrix) -> Scalar:
    """Return the slope of the tangent of a curve, given by an expression in x and y that is zero on it."""
    slope = over(-sympy.diff(curve, x), sympy.diff(curve, y))
    return slope.xreplace({x: p[0], y: p[1]})


def third_intersection(curve: Scalar, slope: Scalar, p: Matrix, q: Matrix) -> Matrix:
    """Return where the line through p and q meets a cubic again, by the sum of the roots."""
    on_line = sympy.Poly(sympy.expand(curve.subs(y, m * x)), x)
    cubic, square = (on_line.coeff_monomial(x**k) for k in (3, 2))
    abscissa = over(-square, cubic).subs(m, slope) - p[0] - q[0]
    return vector(abscissa, p[1] + slope * (abscissa - p[0]))


def mirrored(p: Matrix) -> Matrix:
    """Return the inverse of a point of a cubic whose neutral element is the point at infinity."""
    return vector(p[0], -p[1])


def sum_of(curve: Scalar, p: Matrix, q: Matrix) -> Matrix:
    """Return the sum of two points: the mirror image of the third point of their line."""
    return mirrored(third_intersection(curve, chord(p, q), p, q))


def double_of(curve: Scalar, p: Matrix) -> Matrix:
    """Return the double of a point, by the tangent."""
    return mirrored(third_intersection(curve, tangent(curve, p), p, p))


def at(curve: Scalar, p: Matrix) -> Scalar:
    """Return the value of the expression of a curve at a point."""
    return curve.xreplace({x: p[0], y: p[1]})


def through(curve: Scalar, coefficients: tuple[sympy.Symbol, ...], *points: Matrix) -> dict[sympy.Symbol, Scalar]:
    """Return the coefficients, in which the curve is affine, of the curve through as many points."""
    equations = [at(curve, p) for p in points]
    origin = dict.fromkeys(coefficients, 0)
    matrix = Matrix([[sympy.diff(equation, c) for c in coefficients] for equation in equations])
    right_side = vector(*(-equation.subs(origin) for equation in equations))
    return dict(zip(coefficients, solve(matrix, right_side), strict=True))

# %% [markdown]
# # 4 Numerical example: arithmetic
#
# What is rational is computed exactly.  Square roots, arctangents, sines and cosines are computed with 60 digits and
# then are rational numbers of 50 digits, far beyond the seven that are printed.  Angles are in gon.

# %%
from collections.abc import Callable
from typing import NamedTuple

import mpmath
import sympy

from algebroproj_sym.expressions import Matrix, divided, floor, inverse

WORKING_DIGITS, DIGITS = 60, 50


def to_fifty_digits(function: Callable[..., mpmath.mpf], *arguments: sympy.Rational) -> sympy.Rational:
    with mpmath.workdps(WORKING_DIGITS):
        value = function(*(mpmath.mpf(int(argument.p)) / int(argument.q) for argument in arguments))
        return sympy.Rational(mpmath.nstr(value, DIGITS))


GON = to_fifty_digits(lambda: mpmath.pi / 200)


def cosine_and_sine(angle: sympy.Rational) -> tuple[sympy.Rational, sympy.Rational]:
    return to_fifty_digits(mpmath.cos, angle * GON), to_fifty_digits(mpmath.sin, angle * GON)


def arctangent(opposite: sympy.Rational, adjacent: sympy.Rational) -> sympy.Rational:
    return to_fifty_digits(mpmath.atan2, opposite, adjacent) / GON


def arctangent_of_quotient(quotient: sympy.Rational) -> sympy.Rational:
    return to_fifty_digits(mpmath.atan, quotient) / GON


def square_root(radicand: sympy.Rational) -> sympy.Rational:
    return to_fifty_digits(mpmath.sqrt, radicand)


def exact(table: tuple[tuple[str, ...], ...]) -> Matrix:
    return Matrix([[sympy.Rational(cell) for cell in row] for row in table])


def rounded(value: sympy.Rational, decimals: int) -> sympy.Rational:
    unit = sympy.Integer(10) ** -decimals
    return floor(value / unit + sympy.Rational(1, 2)) * unit


# %% [markdown]
# Least squares: $w = \mathbf A\, d\mathbf a - \delta p$ with weights $g$.  All numbers that enter keep 45 decimals.

# %%
DECIMALS = 45


class Adjustment(NamedTuple):
    """Cofactors Q, solution da, residuals w and standard error s0 of a coordinate of weight 1."""

    Q: Matrix
    da: Matrix
    w: Matrix
    s0: sympy.Rational

    def standard_error(self, unknown: int) -> sympy.Rational:
        return self.s0 * square_root(self.Q[unknown, unknown])


def least_squares(*system: Matrix) -> Adjustment:
    """Adjust the equations A da = delta p + w with the weights g, given A, delta p and g."""
    A, delta_p, g = (part.applyfunc(lambda cell: rounded(cell, DECIMALS)) for part in system)
    G = Matrix.diag(*g)
    Q = divided(inverse(A.T * G * A))
    da = Q * A.T * G * delta_p
    w = A * da - delta_p
    return Adjustment(Q, da, w, square_root((w.T * G * w)[0] / (A.rows - A.cols)))

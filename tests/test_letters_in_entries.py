"""Claims about ranks, zeros and structure take vectors and matrices as letters, which are written out."""

import pytest
import sympy
from sympy import Determinant, MatrixSymbol

from algebroproj_sym import Section
from algebroproj_sym.declaring import DeclarationError, judge
from algebroproj_sym.expressions.letters import Dot, Norm, Skew

R, A, B = (MatrixSymbol(name, 3, 3) for name in "RAB")
P, Q = MatrixSymbol("P", 2, 2), MatrixSymbol("Q", 2, 2)
t, n = MatrixSymbol("t", 3, 1), MatrixSymbol("n", 3, 1)
a, b, c = sympy.symbols("a b c")
OPPOSITE = sympy.Matrix([[0, -c, b], [c, 0, -a], [-b, a, 0]])


def verdict(kind, printed, derived, **options):
    section = Section("mine", "1", "Mine")
    claim = getattr(section, kind)("1.1", "a claim", printed=printed, derived=derived, expect="proved", **options)
    return judge(claim).verdict


@pytest.mark.parametrize(
    ("kind", "printed", "derived", "options", "expected"),
    [
        ("rank", 2, Skew(t) * R, {"kernel": [R.T * t], "properties": {R: "rotation"}}, "proved"),
        ("rank", 1, A, {"kernel": [], "properties": {A: "rank 2"}}, "false"),
        ("rank", 2, sympy.Identity(3) - n * n.T, {"kernel": [n], "properties": {n: "unit"}}, "proved"),
        ("structure", OPPOSITE, Skew(t), {}, "proved"),
        ("structure", OPPOSITE, A, {"properties": {A: "skew"}}, "proved"),
        ("structure", OPPOSITE, A, {"properties": {A: "symmetric"}}, "false"),
        ("structure", OPPOSITE, A - A.T, {}, "proved"),
        ("vanishing", (Determinant(P), Determinant(Q)), Determinant(P * Q), {}, "proved"),
        ("vanishing", (Determinant(P),), Determinant(P * Q), {}, "false"),
        ("vanishing", (Dot(t, n),), Determinant(sympy.Identity(3) - t * n.T) - 1, {}, "proved"),
    ],
)
def test_letters_are_written_out(kind, printed, derived, options, expected):
    found = verdict(kind, printed, derived, **options)
    assert (found == "proved") is (expected == "proved")


@pytest.mark.parametrize(
    ("derived", "properties", "message"),
    [
        (R * t, {R: "orthogonal"}, "R: expected one with free coordinates, .* got orthogonal"),
        (P, {P: "positive definite"}, "P: expected one with free coordinates, .* got positive definite"),
        (P, {P: "idempotent"}, "P: expected one with free coordinates, .* got idempotent"),
        (Norm(t) * t, {}, "norm"),
        (P, {A: "skew"}, r"expected letters that occur \(P\), got A"),
    ],
)
def test_what_has_no_coordinates_is_refused(derived, properties, message):
    with pytest.raises(DeclarationError, match=message):
        verdict("rank", 1, derived, properties=properties)

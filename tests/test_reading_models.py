"""Documents made at random, each with a model: exact values of its letters for which all equations but the last hold.

What is wrong in the model never follows, and what is right there is never called contradicting.
"""

from fractions import Fraction
from functools import reduce
from operator import mul
from random import Random
from typing import Any, NamedTuple

import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")
HENCE = ("Hence", "It follows that", "Therefore", "So", "We obtain")
randoms = st.integers(0, 2**32).map(Random)


def verdict(latex: str) -> str:
    return read_document(document_of(latex), seconds=4)[-1].verdict


def assert_sound(latex: str, holds: bool) -> None:
    assert verdict(latex) != ("contradicts" if holds else "follows"), latex


def value(random: Random) -> Fraction:
    return Fraction(random.choice((-1, 1)) * random.randint(20, 99), random.choice((7, 11, 13)))


# Matrices: each formula has a twin, which the laws of matrices allow, or which they do not.


class Side(NamedTuple):
    latex: str
    level: int
    value: Any


Twins = tuple[Side, Side]


def within(side: Side, level: int) -> str:
    return side.latex if side.level >= level else f"({side.latex})"


def times(*factors: Side) -> Side:
    latex = " ".join(within(each, 2) for each in factors)
    return Side(latex, 2, reduce(mul, (each.value for each in factors)))


def plus(one: Side, other: Side) -> Side:
    return Side(f"{one.latex} + {other.latex}", 1, one.value + other.value)


def turned(side: Side) -> Side:
    return Side(rf"{within(side, 4)}^\top", 3, side.value.T)


def inverse(side: Side) -> Side:
    return Side(f"{within(side, 4)}^{{-1}}", 3, side.value.inv())


def matrices(random: Random, letters: dict[str, Any], depth: int) -> Twins:
    if depth == 0 or random.random() < 0.2:
        name = random.choice(sorted(letters))
        letter = Side(rf"\mathbf{{{name}}}", 4, letters[name])
        return letter, letter
    (a, a2), (b, b2) = (matrices(random, letters, depth - 1) for _ in range(2))
    kind = random.choice(
        ("product", "sum", "turned product", "turned sum", "inverse", "distributed", "inverse of turned")
    )
    if kind == "product":
        return times(a, b), random.choice((times(a2, b2), times(b2, a2)))
    if kind == "sum":
        return plus(a, b), random.choice((plus(b2, a2), plus(a2, turned(b2))))
    if kind == "turned product":
        return turned(times(a, b)), times(*random.choice(((turned(b2), turned(a2)), (turned(a2), turned(b2)))))
    if kind == "turned sum":
        return turned(plus(a, b)), plus(turned(a2), random.choice((turned(b2), b2)))
    if kind == "inverse":
        return inverse(times(a, b)), times(*random.choice(((inverse(b2), inverse(a2)), (inverse(a2), inverse(b2)))))
    if kind == "distributed":
        return times(a, plus(a, b)), random.choice(
            (plus(times(a2, a2), times(a2, b2)), plus(times(a2, a2), times(b2, a2)))
        )
    return inverse(turned(a)), random.choice((turned(inverse(a2)), inverse(a2)))


def forms(random: Random, letters: dict[str, Any], depth: int) -> Twins:
    """Return twins that are numbers: forms in two vectors."""
    x, y = (Side(rf"\mathbf{{{name}}}", 4, sympy.Matrix([value(random), value(random)])) for name in "xy")
    m, m2 = matrices(random, letters, depth)
    other = random.choice((times(turned(y), turned(m2), x), times(turned(y), m2, x), times(turned(x), turned(m2), y)))
    return times(turned(x), m, y), other


@settings(max_examples=settings.default.max_examples // 2)
@given(randoms, st.sampled_from((matrices, forms)), st.integers(1, 2))
def test_what_is_wrong_of_matrices_does_not_follow(random, kind, depth):
    letters = {name: sympy.Matrix(2, 2, [value(random) for _ in range(4)]) for name in "ABC"}
    one, other = kind(random, letters, depth)
    given_letter = r"\mathbf{P}" if kind is matrices else "s"
    start = random.choice(("We set", "Let", "We have"))
    assert_sound(
        rf"{start} \[ {given_letter} = {one.latex} \] {random.choice(HENCE)} \[ {given_letter} = {other.latex}. \]",
        one.value == other.value,
    )


# Derivatives of what is given by letters that are given in turn.


def expression(random: Random, letters: list[sympy.Symbol], depth: int) -> sympy.Expr:
    if depth == 0 or random.random() < 0.2:
        return random.choice(letters)
    one, other = (expression(random, letters, depth - 1) for _ in range(2))
    return random.choice((one + other, one * other, one**2, one / (1 + other**2), sympy.sin(one), sympy.exp(other)))


@settings(max_examples=settings.default.max_examples // 3)
@given(randoms, st.sampled_from((r"\frac{dL}{dt}", r"\dot{L}", r"\frac{\partial L}{\partial t}")))
def test_a_wrong_derivative_does_not_follow(random, how):
    t, u, a, b = sympy.symbols("t u a b")
    inner, outer = expression(random, [t, t, a], 2), expression(random, [u, u, b], 2)
    right = outer.subs(u, inner).diff(t)
    wrong = (outer.diff(u).subs(u, inner), -right, right + inner, right * inner.diff(t), outer.subs(u, inner).diff(a))
    claimed = random.choice((right, sympy.expand(right), *wrong))
    point = {t: Fraction(3, 7), a: Fraction(5, 11), b: Fraction(-2, 13)}
    holds = abs(sympy.N((claimed - right).subs(point), 40)) < Fraction(1, 10**25)
    latex = [sympy.latex(each) for each in (inner, outer, claimed)]
    assert_sound(
        rf"Here $t$ is the time. We have \[ u = {latex[0]} \] and \[ L = {latex[1]}, \] where $a$, $b$ are constants. "
        rf"{random.choice(HENCE)} \[ {how} = {latex[2]}. \]",
        holds,
    )

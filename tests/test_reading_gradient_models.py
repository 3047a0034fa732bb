"""Gradients of functions made at random: what is wrong at a point must not follow, and what is right may be derived.

The functions are made of forms, lengths, roots, logarithms and exponentials of a vector.  Their gradients are compared
with difference quotients: the truth is known without the reader.
"""

import random
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

X = r"\mathbf{x}"
CHANGES = [("2 ", "3 "), (" + ", " - "), (" - ", " + "), (r"}^T", "}"), ("^2", ""), (r"\mathbf{b}", r"\mathbf{c}")]
STEP = 1e-6


class Function(NamedTuple):
    """A function of a vector and its gradient, as LaTeX and as numbers."""

    latex: str
    value: Callable
    gradient: str
    slope: Callable


def made(draw, depth):
    """Return a function made at random."""
    numbers = np.random.default_rng(draw.randrange(10**9))
    matrix, vector, scale = numbers.normal(size=(3, 3)), numbers.normal(size=3), abs(numbers.normal()) + 0.5
    a, b, k = (
        draw.choice(letters) for letters in ([r"\mathbf{A}", r"\mathbf{B}"], [r"\mathbf{b}", r"\mathbf{c}"], "kmw")
    )
    square = rf"{X}^T {X} + {k}^2"
    plain = [
        Function(rf"{X}^T {a} {X}", lambda x: x @ matrix @ x, rf"({a} + {a}^T) {X}", lambda x: (matrix + matrix.T) @ x),
        Function(rf"{b}^T {X}", lambda x: vector @ x, b, lambda x: vector),
        Function(
            rf"\| {a} {X} - {b} \|^2",
            lambda x: np.sum((matrix @ x - vector) ** 2),
            rf"2 {a}^T ({a} {X} - {b})",
            lambda x: 2 * matrix.T @ (matrix @ x - vector),
        ),
        Function(
            rf"\sqrt{{{square}}}",
            lambda x: np.sqrt(x @ x + scale**2),
            rf"\frac{{{X}}}{{\sqrt{{{square}}}}}",
            lambda x: x / np.sqrt(x @ x + scale**2),
        ),
        Function(
            rf"\ln({square})",
            lambda x: np.log(x @ x + scale**2),
            rf"\frac{{2 {X}}}{{{square}}}",
            lambda x: 2 * x / (x @ x + scale**2),
        ),
        Function(
            rf"e^{{{b}^T {X}}}",
            lambda x: np.exp(vector @ x),
            rf"e^{{{b}^T {X}}} {b}",
            lambda x: np.exp(vector @ x) * vector,
        ),
    ]
    if depth == 0:
        return draw.choice(plain)
    one, other = made(draw, depth - 1), made(draw, depth - 1)
    if draw.random() < 0.5:
        return Function(
            rf"\left({one.latex}\right) \left({other.latex}\right)",
            lambda x: one.value(x) * other.value(x),
            rf"\left({one.latex}\right) \left({other.gradient}\right) "
            rf"+ \left({other.latex}\right) \left({one.gradient}\right)",
            lambda x: one.value(x) * other.slope(x) + other.value(x) * one.slope(x),
        )
    return Function(
        rf"\frac{{{one.latex}}}{{{square}}}",
        lambda x: one.value(x) / (x @ x + scale**2),
        rf"\frac{{{one.gradient}}}{{{square}}} - \frac{{2 \left({one.latex}\right) {X}}}{{({square})^2}}",
        lambda x: one.slope(x) / (x @ x + scale**2) - 2 * one.value(x) * x / (x @ x + scale**2) ** 2,
    )


def changed(draw, latex):
    """Return a gradient with one change, by which it is another one."""
    before, after = draw.choice([pair for pair in CHANGES if pair[0] in latex])
    place = draw.choice([i for i in range(len(latex)) if latex.startswith(before, i)])
    return latex[:place] + after + latex[place + len(before) :]


def verdict(function, gradient):
    latex = rf"\[ f = {function.latex} \] Hence \[ \nabla_{{{X}}} f = {gradient} \]"
    return read_document(document_of(latex), seconds=5)[-1].verdict


@pytest.mark.parametrize("seed", range(16))
def test_gradients_follow_and_no_others_do(seed):
    draw = random.Random(seed)
    function = made(draw, seed % 2)
    point = np.random.default_rng(seed).normal(size=3)
    quotients = [(function.value(point + s) - function.value(point - s)) / (2 * STEP) for s in STEP * np.eye(3)]
    assert np.allclose(quotients, function.slope(point), rtol=1e-4, atol=1e-5)
    assert verdict(function, function.gradient) == "follows"
    if any(before in function.gradient for before, _ in CHANGES):
        assert verdict(function, changed(draw, function.gradient)) != "follows"

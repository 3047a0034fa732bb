"""Derivatives of functions that nothing computes, through their arguments: the chain rule."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

TWO = r"We have \[ y = g(x) \] \[ z = f(y) \] By the chain rule, "
VECTORS = r"We have \[ \mathbf y = \mathbf g(\mathbf x) \] \[ \mathbf z = \mathbf f(\mathbf y) \] By the chain rule, "
NESTED = r"The function is \[ f(x) = c(b(a(x))) \] The derivative is "
OF_BOTH = r"The temperature $T(x, y)$ is given. Hence "
FOLLOWS = {
    "two functions": TWO + r"\[ \frac{dz}{dx} = \frac{dz}{dy} \frac{dy}{dx} \]",
    "partial derivatives": TWO
    + r"\[ \frac{\partial z}{\partial x} = \frac{\partial z}{\partial y} \frac{\partial y}{\partial x} \]",
    "vectors": VECTORS + r"\[ \frac{\partial\mathbf z}{\partial\mathbf x} "
    r"= \frac{\partial\mathbf z}{\partial\mathbf y} \frac{\partial\mathbf y}{\partial\mathbf x} \]",
    "three functions": (
        r"We have \[ y = g(x) \] \[ z = f(y) \] \[ w = h(z) \] Hence "
        r"\[ \frac{dw}{dx} = \frac{dw}{dz} \frac{dz}{dy} \frac{dy}{dx} \]"
    ),
    "nested": NESTED + r"\[ \frac{df}{dx} = \frac{dc}{db} \frac{db}{da} \frac{da}{dx} \]",
    "a total derivative": OF_BOTH + r"\[ \frac{dT}{dt} = \frac{\partial T}{\partial x} \frac{dx}{dt} "
    r"+ \frac{\partial T}{\partial y} \frac{dy}{dt} \]",
    "dots": r"The function $V(x)$ is given. Hence \[ \dot V = \frac{\partial V}{\partial x} \dot x \]",
    "with time itself": (
        r"The density $r(x, t)$ is known. Hence \[ \frac{dr}{dt} = \frac{\partial r}{\partial t} "
        r"+ \frac{\partial r}{\partial x} \dot x \]"
    ),
    "a value of its own": (
        r"We have \[ L = f(u, v) \] \[ u = g(w) \] \[ v = h(w) \] Hence \[ \frac{dL}{dw} = "
        r"\frac{\partial L}{\partial u} \frac{du}{dw} + \frac{\partial L}{\partial v} \frac{dv}{dw} \]"
    ),
}
MISLEADING = {
    "another factor": TWO + r"\[ \frac{dz}{dx} = \frac{dz}{dy} \frac{dx}{dy} \]",
    "one factor alone": TWO + r"\[ \frac{dz}{dx} = \frac{dz}{dy} \]",
    "a sign": TWO + r"\[ \frac{dz}{dx} = -\frac{dz}{dy} \frac{dy}{dx} \]",
    "the other order": VECTORS + r"\[ \frac{\partial\mathbf z}{\partial\mathbf x} "
    r"= \frac{\partial\mathbf y}{\partial\mathbf x} \frac{\partial\mathbf z}{\partial\mathbf y} \]",
    "a second order": TWO + r"\[ \frac{d^2z}{dx^2} = \frac{d^2z}{dy^2} \frac{d^2y}{dx^2} \]",
    "a function that has the letter itself": (
        r"We have \[ y = g(x) \] \[ z = f(y, x) \] Hence \[ \frac{dz}{dx} = \frac{dz}{dy} \frac{dy}{dx} \]"
    ),
    "a term that is missing": OF_BOTH + r"\[ \frac{dT}{dt} = \frac{\partial T}{\partial x} \frac{dx}{dt} \]",
    "the time that is missing": (
        r"The density $r(x, t)$ is known. Hence \[ \frac{dr}{dt} = \frac{\partial r}{\partial x} \dot x \]"
    ),
    "a function of more elsewhere": (
        r"The function $V(x)$ is given, and so is $V(x, y)$. Hence \[ \dot V = \frac{\partial V}{\partial x} \dot x \]"
    ),
    "a parameter that moves": (
        r"We have \[ z = f_q(y) \] \[ q = x^2 \] \[ y = g(x) \] Hence \[ \frac{dz}{dx} = \frac{dz}{dy} \frac{dy}{dx} \]"
    ),
    "a function that depends on the letter": (
        r"We have \[ z = f(y) \] where $f$ depends on $x$. \[ y = g(x) \] "
        r"Hence \[ \frac{dz}{dx} = \frac{dz}{dy} \frac{dy}{dx} \]"
    ),
    "a partial derivative that holds a letter": (
        r"We have \[ L = f(u, w) \] \[ u = g(w) \] Hence \[ \frac{\partial L}{\partial w} = "
        r"\frac{\partial L}{\partial u} \frac{\partial u}{\partial w} \]"
    ),
    "the other variable depends on it": (
        r"The function $f(x, y)$ is given where $y$ depends on $x$. Hence "
        r"\[ \frac{df}{dx} = \frac{\partial f}{\partial x} \]"
    ),
    "a partial derivative through one of two": (
        r"The entropy $S(U, V)$ and the volume $V(T)$ are given. Hence \[ \frac{\partial S}{\partial T} = "
        r"\frac{\partial S}{\partial V} \frac{\partial V}{\partial T} \]"
    ),
    "a term too many": (
        r"The field $T(x)$ is given. Hence "
        r"\[ \frac{dT}{dt} = \frac{dT}{dx} \frac{dx}{dt} + \frac{\partial T}{\partial t} \]"
    ),
    "something else is given": (
        r"We have \[ y = g(x) \] \[ z = f(y) + x \] Hence \[ \frac{dz}{dx} = \frac{dz}{dy} \frac{dy}{dx} \]"
    ),
    "an equation ties them": (
        r"We have \[ z = f(u) \] \[ u = g(w) \] \[ v = h(w) \] Hence \[ \frac{dz}{dw} = \frac{dz}{dv} \frac{dv}{dw} \]"
    ),
    "nested in the other order": NESTED + r"\[ \frac{df}{dx} = \frac{db}{dc} \frac{db}{da} \frac{da}{dx} \]",
    "nested without one": NESTED + r"\[ \frac{df}{dx} = \frac{dc}{db} \frac{da}{dx} \]",
    "a product of functions": (
        r"The function is \[ f(x) = c(x) b(x) \] Hence \[ \frac{df}{dx} = \frac{dc}{db} \frac{db}{dx} \]"
    ),
}


@pytest.mark.parametrize("document", FOLLOWS.values(), ids=FOLLOWS)
def test_follows(document):
    assert read_document(document_of(document))[-1].verdict == "follows"


@pytest.mark.parametrize("document", MISLEADING.values(), ids=MISLEADING)
def test_does_not_follow(document):
    assert read_document(document_of(document))[-1].verdict not in ("follows", "contradicts")

r"""Derivatives by the chain rule: what follows from what letters stand for, and what only looks so."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

LOSS = r"The loss is \[ L = \frac12 (y - t)^2 \] where \[ y = w h. \] "
FOLLOWS = {
    "a rate of what the time gives": r"Here $t$ is the time. \[ x = a t^2 + b \] Hence \[ \dot{x} = 2 a t. \]",
    "a rate through an angle": r"At time $t$ the angle is \[ \theta = \omega t \] and \[ x = r \cos\theta. \] "
    r"So \[ \dot{x} = -r \omega \sin(\omega t). \]",
    "partial derivatives": LOSS + r"Then \[ \frac{\partial L}{\partial w} = \frac{\partial L}{\partial y} "
    r"\frac{\partial y}{\partial w} = (y - t) h. \]",
    "by a letter with a value": LOSS + r"Then \[ \frac{\partial L}{\partial y} = y - t. \]",
    "two steps back": r"\[ L = - t \ln y - (1 - t) \ln(1 - y) \] \[ y = \frac{1}{1 + e^{-z}} \] \[ z = w x + b \] "
    r"Then \[ \frac{\partial L}{\partial z} = y - t \]",
    "a sum": r"\[ S = \sum_{i=1}^n e_i^2 \] with \[ e_i = y_i - a x_i - b. \] "
    r"Then \[ \frac{\partial S}{\partial a} = -2 \sum_{i=1}^n x_i e_i. \]",
    "a total derivative": r"\[ V = \frac43 \pi r^3 \] and \[ r = c T \] so "
    r"\[ \frac{dV}{dT} = \frac{dV}{dr} \frac{dr}{dT} = 4 \pi r^2 c. \]",
    "a derivative of one with a prime": r"\[ s(r) = b r^{-a} \] \[ s' = \frac{ds}{dr} = -\frac{a}{r} s(r) \] "
    r"\[ s'' = \frac{d^2 s}{dr^2} = \frac{ds'}{dr} = a (a + 1) b r^{-a - 2} \]",
    "a prime as a command": r"\[ b = r^2 b^\prime \] Hence \[ \frac{db}{db^\prime} = r^2. \]",
}
STAYS_OPEN = {
    "a drive that turns faster": r"At time $t$ the angle is \[ \theta = \omega t. \] The drive turns faster. "
    r"So \[ \dot{\theta} = \omega. \]",
    "a letter with a rate": r"At time $t$ the angle is \[ \theta = \omega t. \] \[ \dot\omega = \alpha \] "
    r"So \[ \dot{\theta} = \omega. \]",
    "a letter that stands there twice": r"\[ L = y^2 + k w^2 \] where \[ y = w h. \] "
    r"Hence \[ \frac{\partial L}{\partial w} = 2 k w. \]",
    "likewise, through the other one": r"\[ L = y^2 + k w^2 \] where \[ y = w h. \] "
    r"Hence \[ \frac{\partial L}{\partial w} = 2 y h + 2 k w. \]",
    "a factor that is given later": LOSS
    + r"The gate is \[ h = w + 1. \] Hence \[ \frac{\partial L}{\partial w} = (y - t) h. \]",
    "a target that is tied to it": LOSS
    + r"The target is \[ t - w = 1. \] Hence \[ \frac{\partial L}{\partial w} = (y - t) h. \]",
    "a total derivative": r"\[ U = x y \] with \[ y = x^2. \] Hence \[ \frac{dU}{dx} = y. \]",
    "what does not stay when y changes": r"\[ U = x y \] with \[ y = x^2. \] Hence \[ \frac{dU}{dy} = x. \]",
    "a mass that changes": r"\[ p = m v \] with \[ v = g t \] and \[ \frac{dm}{dt} = -k. \] "
    r"Hence \[ \frac{dp}{dt} = m g. \]",
    "behind an operator, what changes with a prime": r"The slope of the flow $U$ is $U'$. \[ q = U' w \] "
    r"Hence \[ \frac{\partial}{\partial y} (U w y) = U w. \]",
    "a prime of another frame": r"\[ s(r) = b r^3 \] \[ \frac{ds}{dr} = 3 b r^2 \] The new length is "
    r"\[ s' = c s(r). \] Hence \[ \frac{ds'}{dr} = 6 b r. \]",
    "a derivative of one with a prime, once": r"\[ s(r) = b r^3 \] \[ s' = \frac{ds}{dr} \] "
    r"Hence \[ \frac{ds'}{dr} = 3 b r^2. \]",
    "what is zero in one case alone": r"\[ L = a p^2 - b p \] At the optimum \[ \frac{dL}{dp} = 0. \] "
    r"Hence \[ \frac{d^2 L}{dp^2} = 0. \]",
    "the energy of a gas": r"\[ p = R T / V \] \[ U = p V \] Hence \[ \frac{\partial U}{\partial V} = p. \]",
    "a gate that is a function": r"\[ L = y^2 \] where \[ y = w h(w). \] "
    r"Hence \[ \frac{\partial L}{\partial w} = 2 y h(w). \]",
    "one of many letters": r"\[ L = \sum_{i=1}^n y_i \] where \[ y_i = w x_i \] and \[ x_i = w + i. \] "
    r"Hence \[ \frac{\partial L}{\partial w} = \sum_{i=1}^n x_i. \]",
    "in one case": r"If $w > 0$, the output is \[ y = w h. \] Otherwise \[ y = 0. \] The loss is \[ L = y^2. \] "
    r"Hence \[ \frac{\partial L}{\partial w} = 2 y h. \]",
}


@pytest.mark.parametrize("name", FOLLOWS)
def test_a_derivative_follows_by_the_chain_rule(name):
    last = read_document(document_of(FOLLOWS[name]))[-1]
    assert (last.read is not None, last.verdict) == (True, "follows")


@pytest.mark.parametrize("name", STAYS_OPEN)
def test_nothing_follows_where_a_letter_may_depend_on_another(name):
    last = read_document(document_of(STAYS_OPEN[name]))[-1]
    assert last.read is not None
    assert last.verdict in ("independent", "not decided")

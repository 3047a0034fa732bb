r"""Mechanics as textbooks print it: velocities, values at a place, fixed letters, roots of products."""

import pytest
from cases import for_each

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

POINT = r"The position of the mass is \[ z = x + l \sin\theta, \] where $\dot x$ and $\dot\theta$ are given. "
FLOW = r"The velocity is \[ u(r) = \frac{G}{4 \mu} (R^2 - r^2). \] "
GAS = r"The equation of state is \[ p V = n R T. \] "
ENERGY = r"The free energy is \[ A = - N k T \ln \frac{V}{b}. \] "
SPRING = r"The frequency is \[ w = \sqrt{\frac{k}{m}}. \] "
SWING = (
    r"The energies are \[ V = - m g l \cos\theta \] and \[ T = \frac12 m l^2 \dot\theta^2. \] The Lagrangian is "
    r"$L = T - V$, and the equation of motion is \[ \frac{d}{dt} \frac{\partial L}{\partial\dot\theta} - "
    r"\frac{\partial L}{\partial\theta} = 0. \] This gives "
)
PLANAR = (
    r"The energies are \[ T = \frac12 m (\dot r^2 + r^2 \dot\phi^2) \] and \[ V = \frac12 k r^2. \] The Lagrangian is "
    r"$L = T - V$, and Lagrange's equation is \[ \frac{d}{dt} \frac{\partial L}{\partial\dot r} = "
    r"\frac{\partial L}{\partial r}. \] This gives "
)
FALL = r"Conservation of energy gives \[ l \dot\phi^2 = 3 g \sin\phi. \] "
RELATIVE = r"The position is \[ z = x - y. \] Differentiating twice gives "
TURNED = r"The position is \[ z = a x. \] Differentiating twice gives "
SLOPE = r"The direction is given by \[ \tan b = \frac uw. \] Differentiating gives "
DISC = r"The moment of inertia is \[ J = \int_0^l \frac{m}{l} x^2 \, dx = \frac13 m l^2. \] "
UNIT = (
    r"The pressure is \[ p = \frac13 \operatorname{tr} \boldsymbol\sigma. \] The stress deviator is \[ \boldsymbol s = "
    r"\boldsymbol\sigma - p \boldsymbol 1, \] where $\boldsymbol 1$ denotes the second-order unit tensor. Hence "
)
PIPE = r"The density is $\rho$. The pressure is \[ p = \rho (a^2 - b^2). \] Hence "
ELASTIC = r"The strain is \[ e = a b. \] The stress is $s = 2 G e$. "


def last(latex):
    return read_document(document_of(latex))[-1]


@for_each(
    ("latex", "supposes"),
    [
        (POINT + r"Its velocity is \[ \dot z = \dot x + l \dot\theta \cos\theta. \]", "l does not change"),
        (
            r"Let $R$ be a rotation matrix. Then \[ R R^T = I. \] Differentiating this gives "
            r"\[ \dot R R^T + R \dot R^T = 0. \]",
            "I does not change",
        ),
        (FLOW + r"Its slope is \[ \frac{du}{dr} \Big|_{r=R} = - \frac{G R}{2 \mu}. \]", "G, R, mu do not change"),
        (GAS + r"Hence \[ \left( \frac{\partial V}{\partial T} \right)_p = \frac{V}{T}. \]", "R, n do not change"),
        (ENERGY + r"Hence \[ \left( \frac{\partial A}{\partial V} \right)_T = -\frac{N k T}{V}. \]", "do not change"),
        (SPRING + r"Hence \[ m w = \sqrt{k m}. \]", "k > 0"),
        (SWING + r"\[ l \ddot\theta + g \sin\theta = 0. \]", "g, l, m do not change"),
        (PLANAR + r"\[ m \ddot r = m r \dot\phi^2 - k r. \]", "k, m do not change"),
        (FALL + r"Differentiation gives \[ \ddot\phi = \frac{3 g}{2 l} \cos\phi. \]", "2*l*phi_dot != 0"),
        (RELATIVE + r"\[ \ddot z = \ddot x - \ddot y. \]", "line 1 holds for every t"),
        (TURNED + r"\[ \frac{d^2 z}{dt^2} = a \frac{d^2 x}{dt^2}. \]", "a does not change"),
        (SLOPE + r"\[ \dot b = \frac{\dot u w - u \dot w}{u^2 + w^2}. \]", "line 1 holds for every t"),
        (DISC + r"With the energy \[ E = \frac12 J w^2 \] we have \[ E = \frac16 m l^2 w^2. \]", ""),
        (UNIT + r"\[ \operatorname{tr} \boldsymbol s = 0. \]", "space has three dimensions"),
        (PIPE + r"\[ p = \rho (a - b) (a + b). \]", ""),
        (ELASTIC + r"Hence \[ s = 2 G a b. \]", ""),
    ],
)
def test_what_mechanics_derives_follows_and_says_what_it_takes_for_fixed(latex, supposes):
    found = last(latex)
    assert found.verdict == "follows", latex
    assert supposes in "; ".join((*found.links[-1].rests_on, *found.links[-1].hypotheses)), latex


@for_each(
    "latex",
    [
        POINT + r"Its velocity is \[ \dot z = \dot x - l \dot\theta \cos\theta. \]",
        POINT + r"The rod melts. Its velocity is \[ \dot z = \dot x + l \dot\theta \cos\theta. \]",
        POINT + r"Hence \[ \dot z = \dot x + l \dot\theta \cos\theta. \]",
        FLOW + r"Its slope is \[ \frac{du}{dr} \Big|_{r=0} = - \frac{G R}{2 \mu}. \]",
        FLOW + r"Here $G$ is a function of $r$. Its slope is \[ \frac{du}{dr} \Big|_{r=R} = - \frac{G R}{2 \mu}. \]",
        GAS + r"Hence \[ \left( \frac{\partial V}{\partial T} \right)_p = \frac{T}{V}. \]",
        GAS + r"Hence \[ \left( \frac{\partial V}{\partial T} \right)_S = \frac{V}{T}. \]",
        GAS + r"Here we have \[ T = c V. \] Hence \[ \left( \frac{\partial V}{\partial T} \right)_p = 0. \]",
        r"The energy is \[ U = \frac32 n T. \] With \[ T = p V \] we have "
        r"\[ \left( \frac{\partial U}{\partial T} \right)_V = 0. \]",
        SPRING + r"With a negative $m$ we have \[ m w = \sqrt{k m}. \]",
        r"The root is \[ x = \sqrt{a^2 b^2}. \] Hence \[ x = a b. \]",
        SWING + r"\[ l \ddot\theta - g \sin\theta = 0. \]",
        SWING.replace("The energies", "The mass $m$ leaks. The energies")
        + r"\[ 2 l \ddot\theta + g \sin\theta = 0. \]",
        PLANAR + r"\[ m \ddot r = m r \dot\phi^2 + k r. \]",
        PLANAR.replace(r"\dot\phi^2)", r"\dot\phi^2) + c \dot r \dot\phi") + r"\[ m \ddot r = m r \dot\phi^2 - k r. \]",
        FALL + r"Differentiation gives \[ \ddot\phi = \frac{3 g}{l} \cos\phi. \]",
        FALL + r"The string $l$ shrinks. Differentiation gives \[ \ddot\phi = \frac{3 g}{2 l} \cos\phi. \]",
        RELATIVE + r"\[ \ddot z = \ddot x + \ddot y. \]",
        TURNED + r"\[ \frac{d^2 z}{dt^2} = a \frac{dx}{dt}. \]",
        TURNED + r"\[ \frac{d^2 z}{dt^2} = a \frac{d^2 x}{dt^2} + 2 \frac{da}{dt} x. \]",
        SLOPE + r"\[ \dot b = \frac{u \dot w - \dot u w}{u^2 + w^2}. \]",
        DISC.replace(r"\frac13", r"\frac12") + r"With the energy \[ E = J w^2 \] we have \[ E = \frac12 m l^2 w^2. \]",
        UNIT.replace("second-order unit tensor", "stress at the wall") + r"\[ \operatorname{tr} \boldsymbol s = 0. \]",
        UNIT + r"\[ \operatorname{tr} \boldsymbol s = p. \]",
        ELASTIC + r"Hence \[ s = G a b. \]",
        ELASTIC.replace("The stress is", "Without load the stress is") + r"In water, \[ s = 2 G a b. \]",
        ELASTIC.replace("The stress is", "We ask whether the stress is") + r"Hence \[ s = 2 G a b. \]",
        r"The strain is \[ e = a b. \] It is not so that the stress is $s = 2 G e$. Hence \[ s = 2 G a b. \]",
        r"The strain is \[ e = a b. \] The old rule for the stress is $s = 2 G e$. Hence \[ s = 2 G a b. \]",
    ],
)
def test_what_only_looks_like_mechanics_does_not_follow(latex):
    assert last(latex).verdict not in ("follows", "contradicts"), latex


def test_a_value_at_a_place_serves_below_it():
    found = last(
        GAS + r"The coefficient is \[ a = \frac1V \left( \frac{\partial V}{\partial T} \right)_p. \] Hence "
        r"\[ a = \frac1T. \]"
    )
    assert found.verdict == "follows"

"""Integrals between bounds, and what equations of them give."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("decided_here")

WORK = r"The work is \[ W = \int_0^L k x \, dx. \] "
FALL = r"Integrating \[ \int_0^t dt = \int_0^v \frac{dv}{g - \frac{b}{m} v} \] gives "
ROCKET = r"Integrating \[ \int_{u_o}^{u} du = - \int_{m_o}^{m} \frac{I g}{m} dm \] gives "


LAYER = (
    r"\[ z = \frac{R}{g} \left[ \int_{P_1}^{P_2} \frac{b}{P} dP + \int_{P_1}^{P_2} \frac{k \ln P}{P} dP \right] "
    r"= \frac{R}{g} \left[ b \ln P + \frac{k}{2} \ln^2 P \right]_{P_1}^{P_2} "
)
DRAG = r"\[ t = \int_0^v \frac{du}{g - c u} = -\frac{1}{c} \left. \ln(g - c u) \right|_0^v "


def last_of(latex):
    return read_document(document_of(latex, latex=True))[-1].links[-1]


@pytest.mark.parametrize(
    ("latex", "rests_on"),
    [
        (WORK + r"Hence \[ W = \frac12 k L^2. \]", "the integral over x, where k does not change"),
        (r"\[ F = k x \] \[ W = \int_0^L F \, dx. \] Hence \[ W = \frac12 k L^2. \]", "where k does not change"),
        (
            r"\[ Q = \int_0^T I_0 e^{-t/\tau} \, dt = I_0 \tau (1 - e^{-T/\tau}). \]",
            "the integral over t, where I_0, tau do not change",
        ),
        (r"\[ m = \frac{1}{b-a} \int_a^b x \, dx = \frac{a+b}{2}. \]", "the integral over x"),
        (r"\[ S = \int_5^\infty \frac{dx}{x^2} = \frac15. \]", "the integral over x"),
        (r"\[ V = \int_0^\infty A e^{-\lambda t} \, dt = \frac{A}{\lambda}. \]", "with -lam negative"),
        (r"\[ A = \int_0^a \int_0^b x y \, dx \, dy = \frac14 a^2 b^2. \]", "the integral over y"),
        (
            r"\[ A = \int_0^{2\pi} \sin(n \theta) \, d\theta = \frac{1 - \cos(2 \pi n)}{n}. \]",
            "where n does not change",
        ),
        (
            r"\[ v(t) = v_0 + a t \] \[ s = \int_0^T v(t) \, dt = v_0 T + \frac12 a T^2. \]",
            "where a, v_0 do not change",
        ),
        (ROCKET + r"\[ u - u_o = - I g \ln \frac{m}{m_o}. \]", "with m positive, where I, g do not change"),
        (FALL + r"\[ t = - \frac{m}{b} \ln \left( 1 - \frac{b v}{m g} \right). \]", "positive, where b, g, m do not"),
        (LAYER + r"\]", "where k does not change"),
        (
            LAYER + r"= \frac{R}{g} \left\{ b \ln \frac{P_2}{P_1} + \frac{k}{2} [ \ln^2 P_2 - \ln^2 P_1 ] \right\} \]",
            "",
        ),
        (DRAG + r"\]", "with -c*u + g positive, where c, g do not change"),
        (DRAG + r"= -\frac{1}{c} \ln \left( 1 - \frac{c v}{g} \right) \]", ""),
    ],
)
def test_an_integral_between_bounds_is_computed(latex, rests_on):
    found = last_of(latex)
    assert found.verdict == "follows"
    assert rests_on in "; ".join(found.rests_on)


@pytest.mark.parametrize(
    ("latex", "suggestion"),
    [
        (WORK + r"Hence \[ W = k L^2. \]", "k*L**2/2 instead of k*L**2"),
        (r"\[ W = \int_0^L k x \, dx = -\frac12 k L^2. \]", "-(-1/2*k*L**2) instead of -1/2*k*L**2"),
        (r"\[ W = \int_L^0 k x \, dx = \frac12 k L^2. \]", "-1/2*k*L**2 instead of 1/2*k*L**2"),
        (ROCKET + r"\[ u - u_o = I g \ln \frac{m}{m_o}. \]", "-I*g*log(m/m_o) instead of I*g*log(m/m_o)"),
        (FALL + r"\[ t = - \frac{m}{b} \ln \left( 1 + \frac{b v}{m g} \right). \]", ""),
        (r"\[ W = \int_0^L F \, dx = F L. \]", ""),
        (r"\[ k = a x \] \[ W = \int_0^L k x \, dx = \frac12 k L^2. \]", ""),
        (r"\[ \frac{dk}{dx} = 1 \] \[ W = \int_0^L k x \, dx = \frac12 k L^2. \]", ""),
        (r"\[ x + k = 1 \] \[ W = \int_0^L k x \, dx = \frac12 k L^2. \]", ""),
        (r"\[ T = T_0 + c h \] \[ p = \int_0^H \frac{g h}{T} \, dh = \frac{g H^2}{2 T}. \]", ""),
        (r"\[ W = \int_0^L k(x) x \, dx = \frac12 k(x) L^2. \]", ""),
        (r"\[ V = \int_{-1}^1 \frac{dx}{x^2} = -2. \]", ""),
        (r"\[ V = \int_{-1}^1 \frac{dx}{x} = 0. \]", ""),
        (r"\[ \int_{-1}^2 \frac{dv}{v + 1} = T \] gives \[ T = \ln 3. \]", ""),
        (r"\[ V = \int_0^\infty A e^{\lambda t} \, dt = -\frac{A}{\lambda}. \]", ""),
        (r"\[ V = \int_0^\infty \sin(k x) \, dx = \frac1k. \]", ""),
        (LAYER.replace(r"\frac{k}{2}", "k") + r"\]", ""),
        (
            LAYER + r"= \frac{R}{g} \left\{ b \ln \frac{P_1}{P_2} + \frac{k}{2} [ \ln^2 P_2 - \ln^2 P_1 ] \right\} \]",
            None,
        ),
        (
            DRAG + r"= \frac{1}{c} \ln \left( 1 - \frac{c v}{g} \right) \]",
            "-1/c*log(1 - c*v/g) instead of 1/c*log(1 - c*v/g)",
        ),
        (r"\[ y = \int_0^1 x dx \int_0^1 u du + \left. x u \right|_0^1 = \frac14 + x \]", None),
        (r"\[ y = \left[ a \right]_i^2 = a_i^2 \]", ""),
        (r"\[ v = \frac{dx}{dt} \] \[ s = \int_0^T v t \, dt = \frac12 v T^2. \]", ""),
        (r"The spring melts. \[ W = \int_0^L k x \, dx = \frac12 k L^2. \]", ""),
    ],
)
def test_a_wrong_one_does_not_follow(latex, suggestion):
    found = last_of(latex)
    assert found.verdict not in ("follows", "contradicts")
    assert suggestion is None or found.suggestion == suggestion


def test_an_empty_entry_beside_an_integral_is_no_bound():
    found = last_of(r"\[ \begin{pmatrix} a & \\ & b \end{pmatrix} x = \int_a^b t \, dt \]")
    assert found.verdict == "not decided"

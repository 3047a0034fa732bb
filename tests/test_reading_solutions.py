r"""Solutions of differential equations: ``\dot x = -k x`` and ``x(0) = c`` give ``x(t) = c e^{-k t}``."""

import pytest
import sympy
from cases import for_each
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def verdict(latex):
    return read_document(document_of(latex))[-1].verdict


@for_each(
    "latex",
    [
        r"The amount decays: \[ \frac{dC}{dt} = -k C. \] With $C(0) = C_0$ the solution is \[ C(t) = C_0 e^{-k t}. \]",
        r"A body falls with \[ \dot v = g - \frac{c}{m} v, \qquad v(0) = 0. \] Hence \[ v(t) = \frac{m g}{c} \left(1 - "
        r"e^{-c t/m}\right). \]",
        r"The voltage obeys \[ R C \frac{dU}{dt} + U = U_0 \] with $U(0) = 0$. The solution is \[ U(t) = U_0 (1 - "
        r"e^{-t/(R C)}). \]",
        r"The body is thrown: \[ \ddot y = -g. \] With $y(0) = h$ and $\dot y(0) = u$ we find \[ y(t) = h + u t - "
        r"\frac12 g t^2. \]",
        r"The spring gives \[ m \ddot x + k x = 0. \] With $x(0) = a$ and $\dot x(0) = 0$ the motion is \[ x(t) = a "
        r"\cos \left(\sqrt{\frac{k}{m}} t\right). \]",
        r"The beam bends by \[ E I \frac{d^2 w}{dx^2} = P (L - x). \] With $w(0) = 0$ and $w'(0) = 0$ we get \[ w(x) = "
        r"\frac{P x^2}{6 E I} (3 L - x). \]",
        r"The number grows by \[ \dot n = r n - s n^2. \] With $n(0) = r/s$ it is \[ n(t) = \frac{r}{s}. \]",
        r"The motion starts at $t_0$: \[ \dot x = u. \] With $x(t_0) = x_0$ it is \[ x(t) = x_0 + u (t - t_0). \]",
    ],
)
def test_what_satisfies_an_equation_and_its_initial_values_follows(latex):
    assert verdict(latex) == "follows"


@for_each(
    "latex",
    [
        # It has other solutions with the same initial values.
        r"\[ \dot x = \sqrt{x}, \qquad x(0) = 0. \] Hence \[ x(t) = \frac{t^2}{4}. \]",
        r"\[ x \dot x = 2 x, \qquad x(0) = 0. \] Hence \[ x(t) = 2 t. \]",
        r"\[ t \dot x = 2 x, \qquad x(0) = 0. \] Hence \[ x(t) = a t^2. \]",
        r"\[ \dot x^2 = 4 x, \qquad x(0) = 0. \] Hence \[ x(t) = t^2. \]",
        r"\[ \dot x = \frac{2 x}{t}, \qquad x(0) = 0. \] Hence \[ x(t) = a t^2. \]",
        # An initial value is missing, another one, of another point or of another section.
        r"\[ \ddot y = -g. \] With $y(0) = h$ we find \[ y(t) = h - \frac12 g t^2. \]",
        r"\[ \dot x = -k x, \qquad x(0) = a. \] Hence \[ x(t) = b e^{-k t}. \]",
        r"\[ \ddot y = 0. \] With $y(0) = 0$ and $\dot y(1) = u$ we find \[ y(t) = u t. \]",
        r"\section{One} With $x(0) = a$. \section{Two} Here \[ \dot x = -k x. \] Hence \[ x(t) = a e^{-k t}. \]",
        r"\[ \dot x = -k x. \] Hence \[ x(t) = a e^{-k t}. \]",
        # A wrong sign, factor or exponent.
        r"\[ \dot x = -k x, \qquad x(0) = a. \] Hence \[ x(t) = a e^{k t}. \]",
        r"\[ \ddot x + k x = 0. \] With $x(0) = a$ and $\dot x(0) = 0$, \[ x(t) = a \cos k t. \]",
        r"\[ \ddot y = -g. \] With $y(0) = h$ and $\dot y(0) = u$ we find \[ y(t) = h + u t - g t^2. \]",
        # k changes.
        r"\[ \dot k = -b. \] \[ \dot x = -k x, \qquad x(0) = a. \] Hence \[ x(t) = a e^{-k t}. \]",
        r"\[ k = b t. \] \[ \dot x = -k x, \qquad x(0) = a. \] Hence \[ x(t) = a e^{-k t}. \]",
        r"With $x(0) = 0$. Since $y = 2 x$: \[ \dot x = y. \] Hence \[ x(t) = y t. \]",
        r"The rate $k$ varies with time. \[ \dot x = -k x, \qquad x(0) = a. \] Hence \[ x(t) = a e^{-k t}. \]",
        # The equation holds in a case.
        r"If there is no friction, \[ \ddot y = -g. \] With friction \[ \ddot y = -g - c \dot y. \] Now let $y(0) = h$ "
        r"and $\dot y(0) = u$. In general \[ y(t) = h + u t - \frac12 g t^2. \]",
        # The function is taken elsewhere, too.
        r"\[ \dot x(t) = -k x(t - T). \] With $x(0) = a$ we get \[ x(t) = a e^{-k t}. \]",
        r"\[ f'(x) = -k f(1 - x). \] With $f(0) = a$ we get \[ f(x) = a e^{-k x}. \]",
        r"\[ \dot x(t) = x(2 t), \qquad x(0) = a. \] Hence \[ x(t) = a e^{t}. \]",
        # It changes with another letter, too.
        r"The string has \[ \ddot y = c^2 y''. \] With $y(0) = h$ and $\dot y(0) = u$ we get \[ y(t) = h + u t. \]",
        r"With $\rho(x, t)$ \[ \frac{d\rho}{dt} = -k \rho. \] As $\rho(0) = a$, we get \[ \rho(t) = a e^{-k t}. \]",
        r"The boost is \[ x' = x - u t, \quad t' = t. \] With $x(0) = u$ we have \[ x(t) = u + u t. \]",
        # Another letter hides the function.
        r"\[ \dot x = y, \qquad y = x^2, \qquad x(0) = 0. \] Hence \[ x(t) = y t. \]",
        # The initial values of two problems.
        r"A ball falls: \[ \ddot y = -g. \] The first has $y(0) = h$ and $\dot y(0) = u$. A second one has $y(0) = H$. "
        r"Hence \[ y(t) = H + u t - \frac12 g t^2. \]",
        # The derivative is by something else.
        r"\[ \frac{dx}{ds} = -k x. \] With $x(0) = a$, \[ x(t) = a e^{-k t}. \]",
    ],
)
def test_nothing_else_follows(latex):
    assert verdict(latex) != "follows"


@for_each(
    "latex, follows",
    [
        (r"\[ w(x) = a x^2 (3 L - x). \] Hence \[ d = w(L) = 2 a L^3. \]", True),
        # The density of another letter is another one, and so may be the transform of a function.
        (r"\[ p(x) = a (x - m)^2. \] Hence \[ d = p(m) = 0. \]", False),
        (r"\[ \hat p(x) = a (x - m)^2. \] Hence \[ d = \hat p(m) = 0. \]", False),
        (r"\[ \rho(x) = a (x - m)^2. \] Hence \[ d = \rho(m) = 0. \]", False),
        (r"\[ E(x) = a \cos(k x). \] Hence \[ d = E(k) = a \cos(k^2). \]", False),
    ],
)
def test_a_function_has_the_value_of_what_is_added_to_its_parameter(latex, follows):
    assert (read_document(document_of(latex))[-1].links[-1].verdict == "follows") is follows


def test_a_proof_tells_what_it_rests_on_and_what_does_not_change():
    latex = r"\[ m \dot v = -c v, \qquad v(0) = u. \] Hence \[ v(t) = u e^{-c t/m}. \]"
    (link,) = read_document(document_of(latex))[-1].links
    assert any("holds for every t, where c, m, u do not change" in each for each in link.hypotheses)
    assert "m != 0" in link.hypotheses
    assert {"v_dot is a derivative by t", "v(0) = u, by line 1"} <= {*link.hypotheses}
    assert link.rests_on == ("line 1",)


@given(st.lists(st.integers(-3, 3), min_size=3, max_size=3), st.integers(-3, 3), st.integers(-2, 2))
def test_a_polynomial_follows_if_it_is_the_solution_that_sympy_finds(slopes, start, change):
    t = sympy.Symbol("t")
    rate = sum(factor * t**power for power, factor in enumerate(slopes))
    solution = sympy.expand(sympy.integrate(rate, t) + start) + change * t
    if solution == 0 or rate == 0:
        return
    text = rf"\[ \dot x = {sympy.latex(rate)}. \] With $x(0) = {start}$ we get \[ x(t) = {sympy.latex(solution)}. \]"
    assert (verdict(text) == "follows") is (change == 0)

r"""Functions with and without their argument: where x is x(t), and where the letter is another thing."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

LEVEL = (
    r"The level is \[ S(x, t) = N(x, t) - U(x, t) \] and \[ N(x, t) = G(x, t) + c(t) \] We drop the "
    r"dependence on $(x, t)$. Hence "
)
FOLLOWS = {
    "two arguments that are left out": LEVEL + r"\[ S = G - U + c \]",
    "two arguments with derivatives by both": (
        r"The wave is \[ \partial_t u + c \, \partial_x u = 0 \] Let \[ u(x, t) = 2 w(x, t) + a \] and "
        r"\[ w(x, t) = v(x, t) + b \] Hence \[ u = 2 v(x, t) + 2 b + a \]"
    ),
    "functions of an angle": (
        r"The reflection and transmission are \[ r = \frac{\cos\theta - m}{\cos\theta + m} \] \[ t = "
        r"\frac{2\cos\theta}{\cos\theta + m} \] Then \[ t(\theta) - r(\theta) = 1 \]"
    ),
    "a position and its speed": (
        r"The position is \[ x(t) = a t^2 \] The speed is \[ \dot x = 2 a t \] The energy is \[ E = k x \] "
        r"so that \[ E = k a t^2 \]"
    ),
    "a differential equation": (
        r"The balance is \[ \frac{dv}{dt} = g - \frac{c}{m} v \] In our example \[ \frac{dv}{dt} = g - "
        r"\frac{c}{m} v(t) \]"
    ),
    "a rate of time": r"The mass is \[ \dot m = - k u \] \[ \dot u = - u \] so \[ \dot m = - k u(t) \]",
}
MISLEADING = {
    "two arguments and another sign": LEVEL + r"\[ S = G - U - c \]",
    "two arguments of which nothing is said": (
        LEVEL.replace("We drop the dependence on $(x, t)$. ", "") + r"\[ S = G - U + c \]"
    ),
    "one of two arguments": LEVEL.replace("S(x, t)", "S(x, 0)") + r"\[ S = G - U + c \]",
    "the speed of sound": (
        r"The speed of sound is \[ v = \lambda f \] The car moves with \[ v(t) = a t \] \[ \dot v = a \] "
        r"Hence \[ a t = \lambda f \]"
    ),
    "a variable of the transform": (
        r"The signal is \[ s(t) = a \sin t \] The Laplace variable is \[ s = w + b \] Hence \[ \dot s = a "
        r"\cos t \] \[ a \sin t = w + b \]"
    ),
    "a focal length": (
        r"The function is \[ f(x) = x^2 \] The focal length is \[ f = 2 c \] with $\frac{df}{dx} = 2x$. "
        r"Hence \[ x^2 = 2 c \]"
    ),
    "a product": (
        r"The force is the product \[ F = m a \] and \[ p = m(a) \] with $\frac{dm}{da} = 1$. Hence \[ F = p "
        r"a \]"
    ),
    "an amplitude": (
        r"The amplitude is $u$. The wave is \[ u(t) = u \sin t \] \[ \dot u = u \cos t \] and \[ E = k u \] "
        r"Hence \[ E = k u(t) \]"
    ),
    "a value at the start": (
        r"The temperature at the start is \[ T = a + b \] It falls: \[ \frac{dT}{dt} = - k \] \[ Q = c T \] "
        r"At a later time \[ Q = c T(t) \]"
    ),
    "a mean value": (
        r"The mean is $x$ and the value is $x(t)$ at the time $t$: \[ x(t) = c + d t \] \[ \dot x = d \] \[ "
        r"x = c \] \[ y = x^2 \] Then \[ y = (c + d t)^2 \]"
    ),
    "an initial height": (
        r"The initial height is $h$. It falls with \[ \frac{dh}{dt} = - v \] The energy is \[ E = m g h \] "
        r"and later \[ E = m g h(t) \]"
    ),
    "a circle on an orbit": (
        r"The orbit is \[ r(\theta) = \frac{p}{1 + \cos\theta} \] The circle has the radius $r$. The circle "
        r"has the area \[ A = \pi r^2 \] so \[ A = \pi \frac{p^2}{(1 + \cos\theta)^2} \]"
    ),
    "a probability": (
        r"The density is \[ p(x) = e^{-x} \] where $p$ is a probability, and the odds are \[ q = p / (1 - p) "
        r"\] so \[ q = e^{-x} / (1 - e^{-x}) \]"
    ),
    "the depth of a well": (
        r"The height is \[ h(x) = a x^2 \] The well has the depth $h$ below. Its pressure is \[ P = g h \] "
        r"Thus \[ P = g a x^2 \]"
    ),
    "a moment of inertia": (
        r"The current is \[ I(t) = a t \] The moment of inertia $I$ gives \[ L = I w \] Hence \[ L = a t w "
        r"\]"
    ),
    "a force": (
        r"The distribution function is \[ F(x) = 1 - e^{-x} \] The force is \[ W = F s \] Thus \[ W = (1 - "
        r"e^{-x}) s \]"
    ),
    "a number of samples": (
        r"A growth law is \[ N(t) = a + b t \] With $N$ samples we have \[ m = S / N \] Hence \[ m = S / (a "
        r"+ b t) \]"
    ),
}


@pytest.mark.parametrize("name", FOLLOWS)
def test_a_function_is_the_same_without_its_argument(name):
    last = read_document(document_of(FOLLOWS[name]))[-1]
    assert (last.read is not None, last.verdict) == (True, "follows")


@pytest.mark.parametrize("name", MISLEADING)
def test_a_letter_may_be_another_thing_than_the_function(name):
    last = read_document(document_of(MISLEADING[name]))[-1]
    assert last.read is not None
    assert last.verdict in ("independent", "not decided", "definition")


FLIGHT = r"The abscissa is \[ x(t) = u t c. \] The flight takes the time \[ T = \frac{2 w}{g}. \] "
PATH = FLIGHT + r"The ordinate is \[ y(t) = w t - \frac12 g t^2. \] "
LIKELIHOOD = r"""The log-likelihood is \[ \ell(\mu, \sigma^2) = -\frac N2 \ln(2 \pi \sigma^2)
- \frac{1}{2 \sigma^2} \sum_{i=1}^N (x_i - \mu)^2. \] """


@pytest.mark.parametrize(
    "latex",
    [
        FLIGHT + r"The range is \[ r = x(T) = \frac{2 u w c}{g}. \]",
        PATH + r"Eliminating the time $t$ yields \[ y = \frac{w x}{u c} - \frac{g x^2}{2 u^2 c^2}. \]",
        PATH + r"Eliminating the time $t$ yields the curve \[ y = a x - b x^2. \] The summit is at "
        r"\[ h = y(T/2) = \frac{w^2}{2 g}. \]",
        LIKELIHOOD + r"Its derivative is \[ \frac{\partial \ell}{\partial \mu} = \frac{1}{\sigma^2} "
        r"\sum_{i=1}^N (x_i - \mu). \]",
    ],
)
def test_a_function_is_taken_at_a_letter_that_is_given_or_at_a_square(latex):
    assert read_document(document_of(latex))[-1].links[-1].verdict == "follows"


@pytest.mark.parametrize(
    "latex",
    [
        PATH + r"Eliminating the time $t$ yields \[ y = \frac{w x}{u c} - \frac{g x^2}{u^2 c^2}. \]",
        PATH + r"Hence \[ y = \frac{w x}{u c} - \frac{g x^2}{2 u^2 c^2}. \]",
        PATH + r"Eliminating the speed $u$ yields \[ y = \frac{w x}{u c} - \frac{g x^2}{2 u^2 c^2}. \]",
        r"The density is \[ p(x) = e^{-x}. \] Let \[ y = 2 x. \] Hence \[ p(y) = e^{-y}. \]",
        r"The path is \[ x(t) = a \cos(w t), \] where \[ q = w t. \] Hence \[ x(q) = a \cos q. \]",
        r"The sum is \[ f(x^1, x^2) = x^1 + x^2. \] Hence \[ \frac{\partial f}{\partial x} = 2. \]",
        r"The sum is \[ f(x, x^2) = x + x^2. \] Hence \[ \frac{\partial f}{\partial x} = 1. \]",
        r"The sum is \[ f(a, x^2) = a + x^2. \] Hence \[ f(a, 3) = a + 9. \]",
        LIKELIHOOD + r"Hence \[ \ell(\mu, \sigma) = -\frac N2 \ln(2 \pi \sigma^2) - \frac{1}{2 \sigma^2} "
        r"\sum_{i=1}^N (x_i - \mu)^2. \]",
    ],
)
def test_a_function_at_another_argument_may_be_another_one(latex):
    assert read_document(document_of(latex))[-1].verdict not in ("follows", "contradicts")

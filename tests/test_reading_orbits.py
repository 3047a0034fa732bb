"""Definitions and derivations as technical notes on orbits and on navigation have them."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

MEAN = r"The mean anomaly is \[ M = E - e \sin E. \] The radius is \[ r = a (1 - e \cos E). \] "
FIELD = r"The potential is \[ U = \frac{\mu}{r}, \] with \[ r = \sqrt{x^2 + y^2 + z^2}. \] The second derivative is "
BEARING = r"The bearing is \[ b = \operatorname{atan2}(y, x). \] "
TURNS = (
    r"The turns about two axes are \[ R_1(t) = \begin{bmatrix} 1 & 0 & 0 \\ 0 & \cos t & \sin t \\ "
    r"0 & -\sin t & \cos t \end{bmatrix}, \quad R_3(t) = \begin{bmatrix} \cos t & \sin t & 0 \\ "
    r"-\sin t & \cos t & 0 \\ 0 & 0 & 1 \end{bmatrix}. \] "
)
TURNED = (
    r"\[ R_3(p) R_1(q) = \begin{bmatrix} \cos p & \sin p \cos q & \sin p \sin q \\ "
    r"-\sin p & \cos p \cos q & \cos p \sin q \\ 0 & %s\sin q & \cos q \end{bmatrix} \]"
)
FOLLOWS = {
    "the partial derivative of a letter that is tied": MEAN
    + r"The derivatives are \[ \frac{\partial E}{\partial e} = \frac{a \sin E}{r} \] "
    r"\[ \frac{\partial E}{\partial M} = \frac{a}{r} \]",
    "a second derivative through another letter": FIELD
    + r"\[ \frac{\partial^2 U}{\partial x^2} = \frac{3 \mu x^2}{r^5} - \frac{\mu}{r^3} \]",
    "one by two letters": FIELD + r"\[ \frac{\partial^2 U}{\partial x \partial y} = \frac{3 \mu x y}{r^5} \]",
    "the derivative of an angle": BEARING + r"Hence \[ \frac{\partial b}{\partial x} = -\frac{y}{x^2 + y^2} \]",
    "the rate of an angle": BEARING + r"Its rate is \[ \dot b = \frac{x \dot y - y \dot x}{x^2 + y^2} \]",
    "turns by other angles": TURNS + TURNED % "-",
    "what is related to another thing": (
        r"The energy is \[ \epsilon = \frac{v^2}{2} - \frac{\mu}{r}. \] It is related to the semimajor axis by "
        r"\[ \epsilon = -\frac{\mu}{2a}. \] Solving for the speed gives "
        r"\[ v = \sqrt{\mu \left(\frac2r - \frac1a\right)} \]"
    ),
    "a square behind an equation": (
        r"The height is \[ z = (N (1 - e^2) + h) \sin p, \] where $e^2 = 2 f - f^2$. Hence "
        r"\[ z = (N (1 - f)^2 + h) \sin p \]"
    ),
    "a derivative behind an angle": (
        r"The height is \[ h = k \cos E \] where $k$ is constant. Hence "
        r"\[ \frac{dh}{dt} = -k \sin E \frac{dE}{dt} \]"
    ),
}
MISLEADING = {
    "points with a square": (
        r"The height is \[ z = (N (1 - e^2) + h) \sin p. \] There are points where $e^2 = 2 f - f^2$. In general "
        r"\[ z = (N (1 - f)^2 + h) \sin p \]"
    ),
    "a square in a case": (
        r"The height is \[ z = (N (1 - e^2) + h) \sin p, \] where $e^2 = 2 f - f^2$ if the shell is cut. Hence "
        r"\[ z = (N (1 - f)^2 + h) \sin p \]"
    ),
    "what is related to a thing of another one": (
        r"The force is \[ F = m a. \] It is related to the stretch of the spring by \[ F = -k x. \] "
        r"The damper has \[ F = -c v. \] Hence \[ k x = c v \]"
    ),
    "roots of opposite numbers": (
        r"The rate of the ellipse is \[ q := -\frac{\sqrt{m a}}{r} \sin E. \] Hence "
        r"\[ q = -\frac{\sqrt{-m a}}{r} \sinh H \]"
    ),
    "the inverse of a derivative": MEAN
    + r"The derivatives are \[ \frac{\partial E}{\partial e} = \frac{a \sin E}{r} \] "
    r"\[ \frac{\partial E}{\partial M} = \frac{r}{a} \]",
    "a letter of which the document says not that it is free": MEAN
    + r"At the same radius the derivative is \[ \frac{\partial E}{\partial e} = \frac{a \sin E}{r} \]",
    "a letter that two equations tie": (
        r"The mean anomaly is \[ M = E - e \sin E. \] The other one is \[ N = E + e \sin E. \] We have "
        r"\[ \frac{\partial E}{\partial M} = 1, \quad \frac{\partial E}{\partial N} = 2, \quad "
        r"\frac{\partial E}{\partial e} = \frac{\sin E}{1 - e \cos E} \]"
    ),
    "a second derivative with another sign": FIELD
    + r"\[ \frac{\partial^2 U}{\partial x^2} = \frac{3 \mu x^2}{r^5} + \frac{\mu}{r^3} \]",
    "one by two other letters": FIELD + r"\[ \frac{\partial^2 U}{\partial x \partial y} = \frac{3 \mu x z}{r^5} \]",
    "one of a letter that stands there itself": (
        r"The potential is \[ U = x r, \] with \[ r = \sqrt{x^2 + y^2}. \] Then "
        r"\[ \frac{\partial^2 U}{\partial x \partial y} = \frac{y}{r} \]"
    ),
    "turns with another sign": TURNS + TURNED % "",
    "a function that is no turn": (
        r"The density is \[ P_1(t) = \begin{bmatrix} t & \sin t \\ 0 & 1 \end{bmatrix}. \] Its product is "
        r"\[ P_1(p) P_1(q) = \begin{bmatrix} p q & p \sin q + \sin p \\ 0 & 1 \end{bmatrix} \]"
    ),
}


@pytest.mark.parametrize("document", FOLLOWS.values(), ids=FOLLOWS)
def test_follows(document):
    assert read_document(document_of(document))[-1].verdict == "follows"


@pytest.mark.parametrize("document", MISLEADING.values(), ids=MISLEADING)
def test_does_not_follow(document):
    assert read_document(document_of(document))[-1].verdict != "follows"


def test_a_wrong_sign_in_the_derivative_of_an_angle_is_found():
    found = read_document(document_of(BEARING + r"Hence \[ \frac{\partial b}{\partial x} = \frac{y}{x^2 + y^2} \]"))
    assert found[-1].verdict == "contradicts"


def test_a_letter_that_is_set_to_zero_where_it_is_given_is_defined_there():
    given, follows = read_document(document_of(r"The residual is \[ r := y - a x = 0 \] Hence \[ y = a x \]"))
    assert (given.verdict, [each.verdict for each in given.links]) == ("definition", ["definition", "independent"])
    assert follows.verdict == "follows"
    assert read_document(document_of(r"The residual is \[ r := y - a x = 2 \]"))[-1].verdict == "independent"


def test_slanted_capitals_are_letters():
    given, found = read_document(document_of(r"The rate is \[ \varOmega = 2 n \] Hence \[ r \varOmega = 2 n r \]"))
    assert (given.read, given.verdict, found.verdict, found.formula.chose) == (
        "varOmega = 2*n",
        "definition",
        "follows",
        "",
    )


def test_a_factorial_that_is_not_computed_ends_no_document():
    latex = r"The norm is \[ N_{l,m} = \sqrt{(2 - d_m) (2 l + 1) \frac{(l - m)!}{(l + m)!}} \]"
    assert read_document(document_of(latex))[-1].verdict == "definition"


APART = r"\[ c^2 + s^2 = 1 \] Further, \[ u v = 1 \] \[ v w = 2 \] \[ p q = 4 \] Thus \[ c^4 - s^4 = c^2 - s^2 \]"


@pytest.mark.parametrize(
    "words", ["The angle is not known yet. The letters satisfy", "Both solutions serve. The relation of both is"]
)
def test_an_earlier_sentence_limits_no_equation_to_a_case(words):
    assert read_document(document_of(f"{words} {APART}"))[-1].verdict == "follows"


@pytest.mark.parametrize(
    "words",
    [
        "The letters satisfy, if the lid is shut,",
        "The circle is not the only curve. There",
        "Suppose that the lid is shut. The letters satisfy",
        "The wind is neglected. The letters satisfy",
        "If the lid is shut, the heat stays. The letters satisfy",
        "For small angles, the lid is shut. The letters satisfy",
        "This is a special one. The letters satisfy",
    ],
)
def test_a_case_that_goes_on_limits_an_equation(words):
    assert read_document(document_of(f"{words} {APART}"))[-1].verdict != "follows"

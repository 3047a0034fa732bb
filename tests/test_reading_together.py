r"""Equations that follow from several others together, sums and their derivatives, and the words beside them."""

import pytest

from algebroproj_sym.reading import Reading, document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

NORMAL = r"Let \[ n a + b s = t \] \[ a s + b q = p \] "
WAVES = r"Let \[ p \cos a = q \] \[ p \sin a = s \] Hence "
PRODUCTS = r"We have \[ \sin a \sin b = - \sin u \sin v \] \[ \cos a \cos b = \cos u \cos v \] Hence "
LINE = r"\[ S = \sum_{i=1}^n (y_i - a_0 - a_1 x_i)^2 \] "


def last(latex: str) -> Reading:
    return read_document(document_of(latex))[-1]


@pytest.mark.parametrize(
    "latex",
    [
        NORMAL + r"Hence \[ b (q n - s^2) = p n - s t \]",
        r"\[ a s + b t = 0 \] \[ a = y - b x \] Substituting gives \[ (y - b x) s + b t = 0 \]",
        r"\[ u v = w \tag{1} \] \[ v = u + c \tag{2} \] \[ z = 7 \] If we put (2) into (1), \[ u^2 + c u = w \]",
        r"\[ v \sum_{i=1}^n x_i = w \] \[ \sum_{i=1}^n x_i + c = u \] Therefore \[ v (u - c) = w \]",
        WAVES + r"\[ p \cos(a + b) = q \cos b - s \sin b \]",
        WAVES + r"\[ p \sin(a - b) = s \cos b - q \sin b \]",
        PRODUCTS + r"\[ \cos(a - b) = \cos(u + v) \]",
        r"\[ p q = r \] \begin{align} q &= s + t \\ \therefore\; p s + p t &= r \end{align}",
    ],
)
def test_what_several_equations_say_together_follows(latex: str) -> None:
    assert last(latex).verdict == "follows"


@pytest.mark.parametrize(
    "latex",
    [
        NORMAL + r"Hence \[ b (q n + s^2) = p n - s t \]",
        WAVES + r"\[ p \cos(a + b) = q \cos b + s \sin b \]",
        WAVES + r"\[ p \sin(b - a) = s \cos b - q \sin b \]",
        PRODUCTS + r"\[ \cos(a - b) = \cos(u - v) \]",
        r"\[ u v = w \] \[ u v = w + 1 \] Hence \[ w = c u \]",
        r"At the top \[ u v = w \] At the bottom \[ u + v = c \] Hence at the bottom \[ u (c - u) = w \]",
        r"If the beam is clamped, \[ u v = w \] In general \[ u + v = c \] Hence \[ u (c - u) = w \]",
        r"\[ u v = w \tag{1} \] If we put $v = 0$ into (1), \[ w = 0 \] In general \[ u v = 0 \]",
        r"\[ v \sum_{i=1}^n x_i = w \] \[ \sum_{j=1}^m x_j + c = u \] Therefore \[ v (u - c) = w \]",
    ],
)
def test_what_they_do_not_say_together_does_not_follow(latex: str) -> None:
    assert last(latex).verdict in ("independent", "not decided")


@pytest.mark.parametrize(
    "latex",
    [
        LINE + r"\[ \frac{\partial S}{\partial a_0} = -2 \sum_{i=1}^n (y_i - a_0 - a_1 x_i) \]",
        LINE + r"\[ \frac{\partial S}{\partial a_1} = 2 a_0 \sum_{i=1}^n x_i + 2 a_1 \sum_{i=1}^n x_i^2"
        r"- 2 \sum_{i=1}^n x_i y_i \]",
        r"\[ f(t) = \sum_{k=1}^n c_k (t + k)^2 \] \[ \frac{df}{dt} = 2 \sum_{k=1}^n c_k (t + k) \]",
        r"\[ S = \sum_{i=1}^n x_i \sum_{j=1}^n a x_j \] "
        r"\[ \frac{\partial S}{\partial a} = \sum_{i=1}^n x_i \sum_{j=1}^n x_j \]",
        r"\[ \bar x = \frac1n \sum_{i=1}^n x_i \] \[ s = \sum_{i=1}^n (x_i - \bar x) \] \[ s = 0 \]",
    ],
)
def test_a_sum_has_the_derivatives_of_its_terms(latex: str) -> None:
    assert last(latex).verdict == "follows"


@pytest.mark.parametrize(
    "latex",
    [
        LINE + r"\[ \frac{\partial S}{\partial a_0} = 2 \sum_{i=1}^n (y_i - a_0 - a_1 x_i) \]",
        # The letter is one of those that are summed, or changes with the index, or stands in the limits.
        r"\[ S = \sum_{i=1}^n x_i^2 \] \[ \frac{\partial S}{\partial x_j} = 0 \]",
        r"\[ S = \sum_{i=1}^n x_i^2 \] \[ \frac{\partial S}{\partial x_1} = 0 \]",
        r"\[ S = \sum_{i=1}^n x_i^2 \] \[ \frac{\partial S}{\partial x_i} = 2 \sum_{i=1}^n x_i \]",
        r"\[ S = \sum_{i=1}^n a x_i \] \[ \frac{\partial S}{\partial n} = 0 \]",
        r"\[ f_i = a x_i \] \[ S = \sum_{i=1}^n (y_i - f_i)^2 \] \[ \frac{\partial S}{\partial a} = 0 \]",
        r"\[ S = \sum_{i=1}^n (y_i - f(x_i))^2 \] \[ \frac{\partial S}{\partial a} = 0 \]",
        # What is summed depends on its terms, and on what they depend on.
        r"\[ m = \frac1n \sum_{i=1}^n x_i \] \[ q = m x_1 \] \[ \frac{dq}{dx_1} = m \]",
        r"\[ x_i = a + b_i \] \[ m = \frac1n \sum_{i=1}^n x_i \] \[ q = m a \] \[ \frac{dq}{da} = m \]",
        r"\[ a = \sum_{j=1}^n x_{ij} \] \[ s = \sum_{i=1}^n a x_i \] \[ s = a \sum_{i=1}^n x_i \]",
    ],
)
def test_no_other_derivative_of_a_sum_follows(latex: str) -> None:
    assert last(latex).verdict != "follows"


@pytest.mark.parametrize("space", ["~~~~", r"\qquad ", r"\hfill"])
def test_a_number_behind_a_wide_space_is_that_of_the_equation(space: str) -> None:
    (first, second) = read_document(document_of(rf"\[ a = b c {space}(4) \] By (4) \[ 2 a = 2 b c {space}(5) \]"))
    assert (first.read, first.number, second.number) == ("a = b*c", "4", "5")
    assert (second.verdict, second.links[0].rests_on) == ("follows", ("(4), line 1",))


_COLUMNS = (
    r"\[ c_1 \begin{bmatrix} 0 \\ 1 \\ 1 \end{bmatrix} + c_2 \begin{bmatrix} 1 \\ 0 \\ 1 \end{bmatrix} "
    r"+ c_3 \begin{bmatrix} 1 \\ 1 \\ 0 \end{bmatrix} = \begin{bmatrix} x \\ y \\ z \end{bmatrix} \] "
)


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (r"\[ c_2 + c_3 = x \]", True),
        (r"\[ 2 c_1 = 2 y - 2 c_3 \]", True),
        (r"\[ x - y = c_2 - c_1 \]", True),
        (r"\[ c_1 + c_3 = x \]", False),
        (r"\[ c_1 + c_2 + c_3 = x \]", False),
        (r"\[ x + y = c_1 + c_2 + c_3 \]", False),
        (r"\section{Another vector} \[ c_2 + c_3 = x \]", False),
    ],
)
def test_an_equation_of_vectors_is_one_for_each_component(latex, follows):
    assert (read_document(document_of(_COLUMNS + latex))[-1].verdict == "follows") == follows


FORCE = r"The force is \[ \mathbf{F} = - k \mathbf{r}. \] "
LAW = r"Newton's second law is \[ \mathbf{F} = m \frac{d^2 \mathbf{r}}{dt^2}. \] "
RATE = r"Hence \[ \frac{d^2 \mathbf{r}}{dt^2} = - \frac{k}{m} \mathbf{r}. \]"


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (FORCE + LAW + RATE, True),
        (FORCE + LAW + RATE.replace("- ", ""), False),
        (FORCE + LAW.replace("law is", "law for the other body is") + RATE, False),
        (FORCE + LAW.replace("Newton's second law is", "In water, the law is") + RATE, False),
        (FORCE + LAW.replace("Newton's second law is", "The drag is") + RATE, False),
        (r"The force is \[ F = - k x. \] By the second law, \[ F = m a. \] Hence \[ a = - \frac{k x}{m}. \]", True),
        (r"The force is \[ F = - k x. \] The second force is \[ F = m a. \] Hence \[ a = - \frac{k x}{m}. \]", False),
    ],
)
def test_a_law_holds_beside_what_else_is_said_of_its_letter(latex, follows):
    found = read_document(document_of(latex), seconds=5)
    assert (found[-1].verdict == "follows") == follows

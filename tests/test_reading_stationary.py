"""What follows where derivatives are set to zero, and from equations of vectors that give no letter."""

import pytest
from textbooks import follow, plain, with_misprint

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

PARABOLA = r"The derivative is \[ \frac{dE}{dx} = k x - m g. \] "
GRADIENT = r"The gradient is \[ \nabla f(\mathbf{x}) = 2 \mathbf{A}^T (\mathbf{A} \mathbf{x} - \mathbf{b}). \] "
LINE = (
    r"We minimize \[ S(a, b) = \sum_{i=1}^n (y_i - a - b x_i)^2. \] The derivatives are "
    r"\[ \frac{\partial S}{\partial a} = -2 \sum_{i=1}^n (y_i - a - b x_i) \] and "
    r"\[ \frac{\partial S}{\partial b} = -2 \sum_{i=1}^n x_i (y_i - a - b x_i). \] "
)
NORMAL = r"\mathbf{A}^T \mathbf{A} \mathbf{x} = \mathbf{A}^T \mathbf{b}"
SQUARES = r"The cost is \[ J = \|\mathbf{A} \mathbf{x} - \mathbf{b}\|^2. \] "
PROFIT = r"The profit is \[ P = p q - c q^2. \] "
BOWL = (
    r"The minimum is where \[ \frac{\partial}{\partial \mathbf{x}} "
    r"(\mathbf{x}^T \mathbf{A}^T \mathbf{A} \mathbf{x} - 2 \mathbf{x}^T \mathbf{A}^T \mathbf{b}) = 0. \] "
)
FIRST = r"n a + b \sum_{i=1}^n x_i = \sum_{i=1}^n y_i"
SECOND = r"a \sum_{i=1}^n x_i + b \sum_{i=1}^n x_i^2 = \sum_{i=1}^n x_i y_i"


def last(latex):
    return read_document(document_of(latex))[-1]


@pytest.mark.parametrize(
    ("above", "words", "claim"),
    [
        (PARABOLA, "Setting it to zero gives", r"x = \frac{m g}{k}"),
        (PARABOLA, "Equating the derivative to $0$ gives the equilibrium", r"k x = m g"),
        (PARABOLA, "Setting this derivative equal to zero, we find", r"\hat x = \frac{m g}{k}"),
        (PARABOLA, "Setting the derivative of $E$ with respect to $x$ to zero gives", r"x^* = \frac{m g}{k}"),
        (
            GRADIENT,
            "Setting the gradient to zero gives",
            r"\mathbf{A}^T \mathbf{A} \mathbf{x} = \mathbf{A}^T \mathbf{b}",
        ),
        (
            GRADIENT,
            "Setting this to zero gives",
            r"\hat{\mathbf{x}} = (\mathbf{A}^T \mathbf{A})^{-1} \mathbf{A}^T \mathbf{b}",
        ),
        (LINE, "Setting the derivative with respect to $a$ to zero gives", FIRST),
        (PROFIT, "Setting the derivative of $P$ with respect to $q$ to zero gives", r"q = \frac{p}{2 c}"),
        (PROFIT, r"Setting $\frac{dP}{dq} = 0$ gives", r"q = \frac{p}{2 c}"),
        (SQUARES, r"We set the derivative of $J$ with respect to $\mathbf{x}$ to zero and obtain", NORMAL),
        (SQUARES, r"We set $\frac{\partial J}{\partial \mathbf{x}} = 0$ and obtain", NORMAL),
        (BOWL, "Applying this derivative gives", NORMAL),
        (LINE, "Setting the derivatives to zero gives", SECOND),
    ],
)
def test_what_a_derivative_that_is_set_to_zero_gives_follows(above, words, claim):
    assert last(rf"{above}{words} \[ {claim}. \]").verdict == "follows"


@pytest.mark.parametrize(
    ("above", "words", "claim"),
    [
        (PARABOLA, "Setting it to zero gives", r"x = \frac{k}{m g}"),
        (PARABOLA, "The temperature $T$ is free. Setting it to zero gives", r"x = \frac{m g}{k}"),
        (PARABOLA + r"Then \[ y = k x. \] ", "Setting it to zero gives", r"x = \frac{m g}{k}"),
        (
            PARABOLA + r"The start is \[ \hat x = h. \] ",
            "Setting the derivative to zero gives",
            r"\hat x = \frac{m g}{k}",
        ),
        (PARABOLA, "For the loaded spring, setting the derivative to zero gives", r"x = \frac{m g}{k}"),
        (PARABOLA, "The friction adds $c$ to this derivative. Setting the derivative to zero gives", r"k x = m g"),
        (PROFIT, "With a tax, setting the derivative of $P$ with respect to $q$ to zero gives", r"2 c q = p"),
        (PARABOLA, "Setting the second derivative to zero gives", r"x = \frac{m g}{k}"),
        (PARABOLA, "Without setting the derivative to zero we have", r"x = \frac{m g}{k}"),
        (PARABOLA, "Setting the derivative to zero gives a minimum, and in general", r"x = \frac{m g}{k}"),
        (PARABOLA, "Setting the derivative of $T$ to zero gives", r"x = \frac{m g}{k}"),
        (PARABOLA, "Setting the derivative with respect to $z$ to zero gives", r"x = \frac{m g}{k}"),
        (GRADIENT, "Setting the gradient to zero gives", r"\mathbf{A} \mathbf{x} = \mathbf{b}"),
        (LINE, "Setting the derivative with respect to $b$ to zero gives", FIRST),
        (PROFIT, "Setting the derivative of $P$ with respect to $p$ to zero gives", r"q = \frac{p}{2 c}"),
        (PROFIT, r"Setting $\frac{dP}{dq} = p$ gives", r"q = \frac{p}{2 c}"),
        (SQUARES, r"We set the derivative of $J$ with respect to $\mathbf{b}$ to zero and obtain", NORMAL),
        (
            SQUARES,
            r"We set $\frac{\partial J}{\partial \mathbf{x}} = 0$ and obtain",
            r"\mathbf{A} \mathbf{x} = \mathbf{b}",
        ),
        (BOWL, "Applying this derivative gives", r"\mathbf{A} \mathbf{x} = \mathbf{b}"),
        (BOWL, "Applying this derivative gives", r"\mathbf{A} \mathbf{A}^T \mathbf{x} = \mathbf{A} \mathbf{b}"),
        (LINE, "Setting the derivative with respect to the first parameter to zero gives", SECOND),
    ],
)
def test_nothing_follows_where_words_set_another_thing_to_zero(above, words, claim):
    assert last(rf"{above}{words} \[ {claim}. \]").verdict != "follows"


ENERGY = r"The energy is \[ E = c (x - a)^2. \] "
SLOPE = r"\frac{dE}{dx}"


@pytest.mark.parametrize(
    ("above", "words", "chain"),
    [
        (ENERGY, "We set its derivative to zero:", rf"{SLOPE} = 2 c (x - a) = 0"),
        (ENERGY, "It is at its minimum where", rf"{SLOPE} = 0 = 2 c (x - a)"),
        (ENERGY, r"Equating the slope to $0$,", rf"{SLOPE} = 2 c (x - a) = 2 c x - 2 a c = 0"),
        (
            r"We minimize \[ S(a, b) = \sum_{i=1}^n (y_i - a - b x_i)^2. \]",
            "This is straightforward:",
            r"\frac{\partial S}{\partial b} = -2 \sum_{i=1}^n x_i (y_i - a - b x_i) = 0",
        ),
        (
            r"The likelihood is \[ L(p) = p^k (1-p)^m. \]",
            "We equate its derivative to zero:",
            r"\frac{d \ln L}{dp} = \frac{k}{p} - \frac{m}{1-p} = 0",
        ),
    ],
)
def test_a_derivative_that_words_set_to_zero_is_zero_as_a_condition(above, words, chain):
    found = last(rf"{above} {words} \[ {chain}. \]")
    assert {link.verdict for link in found.links[:-1]} == {"follows"}
    assert found.links[-1].verdict == "definition"


@pytest.mark.parametrize(
    ("words", "chain"),
    [
        ("The force is", rf"{SLOPE} = 2 c (x - a) = 0"),
        ("We do not set the derivative to zero, as in", rf"{SLOPE} = 2 c (x - a) = 0"),
        ("We set its derivative to zero:", rf"{SLOPE} = 2 c (x + a) = 0"),
        ("We set its derivative to zero:", rf"{SLOPE} = 2 c (x - a) = 1"),
        ("We set its derivative to zero:", rf"{SLOPE} = 0 = 2 c (x + a)"),
        ("The energy is at its minimum, and hence", r"\frac{dE}{dt} = 2 c (x - a) \dot x = 0"),
    ],
)
def test_a_derivative_is_no_condition_by_itself(words, chain):
    found = last(rf"{ENERGY} {words} \[ {chain}. \]")
    assert {link.verdict for link in found.links} - {"definition", "follows"}


def test_what_is_set_to_zero_is_not_mended_by_a_zero():
    found = last(rf"{ENERGY} We set its derivative to zero: \[ {SLOPE} = 2 c (x - a) = 0. \]")
    assert not any(link.suggestion for link in found.links)


BOLD = {letter: rf"\mathbf{{{letter}}}" for letter in "AFKxyuvbRPQ"}


@pytest.mark.parametrize(
    ("above", "claim", "follows"),
    [
        (r"%(x)s'^T %(F)s %(x)s = 0", r"%(x)s^T %(F)s^T %(x)s' = 0", True),
        (r"%(x)s'^T %(F)s %(x)s = 0", r"%(x)s^T %(F)s %(x)s' = 0", False),
        (r"%(A)s %(x)s = %(b)s - %(u)s", r"%(A)s^T %(A)s %(x)s = %(A)s^T (%(b)s - %(u)s)", True),
        (r"%(A)s^T %(A)s %(x)s = %(A)s^T (%(b)s - %(u)s)", r"%(A)s %(x)s = %(b)s - %(u)s", False),
        (
            r"%(A)s^T %(P)s + %(P)s %(A)s = -%(Q)s",
            r"%(x)s^T (%(A)s^T %(P)s + %(P)s %(A)s) %(x)s = -%(x)s^T %(Q)s %(x)s",
            True,
        ),
        (r"%(A)s^T %(P)s + %(P)s %(A)s = -%(Q)s", r"2 %(x)s^T %(P)s %(A)s %(x)s = -%(x)s^T %(Q)s %(x)s", False),
        (r"%(A)s %(P)s - %(P)s %(A)s = %(Q)s", r"%(A)s^2 %(P)s - %(P)s %(A)s^2 = %(A)s %(Q)s + %(Q)s %(A)s", True),
        (r"%(A)s %(P)s - %(P)s %(A)s = %(Q)s", r"%(A)s^2 %(P)s - %(P)s %(A)s^2 = 2 %(A)s %(Q)s", False),
        (r"%(A)s^T (%(A)s %(x)s - %(b)s) = 0", r"%(A)s^T %(A)s %(x)s = %(A)s^T %(b)s", True),
        (r"%(A)s^T (%(A)s %(x)s - %(b)s) = 0", r"%(A)s %(x)s = %(b)s", False),
        (r"m %(u)s + q %(v)s = m %(x)s + q %(y)s", r"m (%(u)s - %(x)s) = q (%(y)s - %(v)s)", True),
        (r"m %(u)s + q %(v)s = m %(x)s + q %(y)s", r"m (%(u)s - %(x)s) = q (%(v)s - %(y)s)", False),
    ],
)
def test_an_equation_of_vectors_that_gives_no_letter_serves_as_a_whole(above, claim, follows):
    found = last(rf"We have \[ {above % BOLD}. \] Hence \[ {claim % BOLD}. \]")
    assert (found.verdict == "follows") == follows


REGRESSION = r"""The model is \[ y_i = a + b x_i + e_i. \] We minimize \[ S = \sum_{i=1}^n (y_i - a - b x_i)^2. \] The
partial derivatives are |>\[ \frac{\partial S}{\partial a} = -2 \sum_{i=1}^n (y_i - a - b x_i) \] |>\[ \frac{\partial
S}{\partial b} = -2 \sum_{i=1}^n x_i (y_i - a - b x_i). \] Setting them to zero gives |>\[ n a + b \sum_{i=1}^n x_i =
\sum_{i=1}^n y_i \] |>\[ a \sum_{i=1}^n x_i + b \sum_{i=1}^n x_i^2 = \sum_{i=1}^n x_i y_i. \]"""


@pytest.mark.parametrize(
    ("printed", "wrong"),
    [
        (r"= -2 \sum_{i=1}^n (y_i", r"= 2 \sum_{i=1}^n (y_i"),
        (r"x_i (y_i - a - b x_i). \]", r"x_i (y_i - a + b x_i). \]"),
        (r"n a + b", r"a + b"),
        (r"a \sum_{i=1}^n x_i + b", r"b \sum_{i=1}^n x_i + b"),
    ],
)
def test_what_is_observed_does_not_change_with_the_letters_of_its_model(printed, wrong):
    found = [each.verdict == "follows" for each in read_document(document_of(plain(REGRESSION)))]
    assert found == follow(REGRESSION)
    text, place = with_misprint(REGRESSION, printed, wrong)
    assert read_document(document_of(plain(text)))[place].verdict != "follows"


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ u = x^2 + c \] \[ S = x u \] Hence \[ \frac{\partial S}{\partial x} = u. \]",
        r"\[ u = x^2 + c \] \[ S = (u - x)^2 \] Hence \[ \frac{\partial S}{\partial x} = -2 (u - x). \]",
    ],
)
def test_what_is_no_residual_of_a_model_changes_with_its_letters(latex):
    assert read_document(document_of(latex))[-1].verdict != "follows"

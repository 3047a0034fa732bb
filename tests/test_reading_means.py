"""Expected values: they are linear, and constants stand before them."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

VARIANCE = r"The variance is the expected value \[ V = \mathbb{E}((X - \mu)^2) \] where $\mu = \mathbb{E}(X)$. Hence "
OF_FUNCTION = r"The variance is defined as the expected value \[ \mathrm{Var}(X) = E[(X - E[X])^2] \] "
FOLLOWS = {
    "the variance": VARIANCE + r"\[ V = \mathbb{E}(X^2) - \mu^2 \]",
    "a chain": (
        r"The variance is the expected value \[ \mathrm{Var}(X) = E[(X-E[X])^2] = E[X^2 - 2 X E[X] + E[X]^2] "
        r"= E[X^2] - 2 E[X] E[X] + E[X]^2 = E[X^2] - E[X]^2 \]"
    ),
    "a command that nothing defines": (
        r"The matrix $A$ is constant. \[ P = \E[\mathbf e \mathbf e^T] \] \[ \mathbf e = A \mathbf d \] Hence "
        r"\[ P = A \E[\mathbf d \mathbf d^T] A^T \]"
    ),
    "the covariance of a letter with itself": (
        OF_FUNCTION
        + r"The covariance is \[ C(X, Y) = E[(X - E[X]) (Y - E[Y])] \] Hence \[ C(X, X) = \mathrm{Var}(X) \]"
    ),
    "an expected value that is given": (
        r"The expected value is \[ \mathbb{E}(x) = \sum_i x_i \Pr(x_i) \] The variance is defined as "
        r"\[ \mathbb{V}(x) = \mathbb{E}((x - \mathbb{E}(x))^2) \] Hence "
        r"\[ \mathbb{V}(y) = \mathbb{E}(y^2) - \mathbb{E}(y)^2 \]"
    ),
    "the covariance": (
        r"The covariance is the expected value \[ C(X, Y) = E[(X - E[X]) (Y - E[Y])] = E[X Y] - E[X] E[Y] \]"
    ),
    "a constant factor": (
        r"The constants $a$ and $b$ are known. The expected value is \[ y = a x + b \] \[ E[y] = a E[x] + b \]"
    ),
    "the variance with constants": (
        OF_FUNCTION + r"With the constants $a$ and $b$ we have \[ \mathrm{Var}(a Y + b) = a^2 \mathrm{Var}(Y) \]"
    ),
    "the mean of means": (
        r"The expected values are \[ \mathbb{E}(x_i) = m \] \[ s = \frac1n \sum_{i=1}^n x_i \] Hence "
        r"\[ \mathbb{E}(s) = \frac1n \sum_{i=1}^n \mathbb{E}(x_i) \]"
    ),
    "noise without a mean": (
        r"The noise has no bias: \[ \mathbb{E}(e) = 0 \] With \[ y = x + e \] we get "
        r"\[ \mathbb{E}(y) = \mathbb{E}(x) \]"
    ),
    "vectors": (
        r"The covariance is \[ \mathbf P = \mathbb{E}[(\mathbf x - \mathbf m) (\mathbf x - \mathbf m)^T] \] with "
        r"$\mathbf m = \mathbb{E}[\mathbf x]$. Hence "
        r"\[ \mathbf P = \mathbb{E}[\mathbf x \mathbf x^T] - \mathbf m \mathbf m^T \]"
    ),
    "the square of a vector": (
        r"The variance is defined as \[ \mathbb{V}(\mathbf x) = \mathbb{E}((\mathbf x - \mathbb{E}(\mathbf x))^2) "
        r"= \mathbb{E}(\mathbf x^2) - \mathbb{E}(\mathbf x)^2 \]"
    ),
    "a matrix that is constant": (
        r"The matrix $\mathbf A$ is constant. We have \[ \mathbf y = \mathbf A \mathbf x \] Hence "
        r"\[ \mathbb{E}[\mathbf y \mathbf y^T] = \mathbf A \mathbb{E}[\mathbf x \mathbf x^T] \mathbf A^T \]"
    ),
}
MISLEADING = {
    "a command that nothing defines, of what may be random": (
        r"\[ P = \E[\mathbf e \mathbf e^T] \] \[ \mathbf e = A \mathbf d \] Hence "
        r"\[ P = A \E[\mathbf d \mathbf d^T] A^T \]"
    ),
    "a wrong sign": VARIANCE + r"\[ V = \mathbb{E}(X^2) + \mu^2 \]",
    "the square of the mean": VARIANCE + r"\[ V = \mathbb{E}(X^2) - \mathbb{E}(X^2)^2 \]",
    "a factor that is not constant": r"The expected value is \[ y = a x \] \[ E[y] = a E[x] \]",
    "a factor that is random": (
        r"The gain $a$ is random, and $b$ is constant. The expected value is \[ y = a x \] \[ E[y] = a E[x] \]"
    ),
    "a matrix that may change": (
        r"We have \[ \mathbf y = \mathbf A \mathbf x \] Hence "
        r"\[ \mathbb{E}[\mathbf y \mathbf y^T] = \mathbf A \mathbb{E}[\mathbf x \mathbf x^T] \mathbf A^T \]"
    ),
    "independence": r"The expected value is \[ z = x y \] Hence \[ E[z] = E[x] E[y] \]",
    "an energy": r"The energy has an expected size. We have \[ y = 2 x \] Hence \[ E(y) = 2 E(x) \]",
    "an error function": (
        r"Random data have an error function \[ E(w) = \sum_i (t_i - w x_i)^2 \] Hence \[ E(2 w) = 2 E(w) \]"
    ),
    "a modulus": r"Young's modulus at the expected temperature has \[ E(T + T) = 2 E(T) \]",
    "without words": r"\[ E(x + x) = 2 E(x) \]",
    "given otherwise": (
        r"The expected value is not linear here: \[ E(x) = \sum_i p_i x^2 \] Hence \[ E(2 x) = 2 E(x) \]"
    ),
    "two operators": (
        r"The expected value is \[ z = \mathbb{E}_p(x) \] Hence \[ \mathbb{E}_q(z y) = z \mathbb{E}_q(y) \]"
    ),
    "a given letter is random": (
        r"The estimate is \[ z = \mathbb{E}(x | y) \] Hence \[ \mathbb{E}(z y) = z \mathbb{E}(y) \]"
    ),
    "an infinite sum": (
        r"The series is \[ s = \sum_{i=1}^\infty x_i \] Hence \[ \mathbb{E}(s) = \sum_{i=1}^\infty \mathbb{E}(x_i) \]"
    ),
    "a quotient": r"The expected value is \[ r = \frac{x}{y} \] Hence \[ E[r] = \frac{E[x]}{E[y]} \]",
    "a random number of terms": (
        r"The number $n$ is random. \[ s = \sum_{i=1}^n x_i \] Hence \[ \mathbb{E}(s) = \sum_{i=1}^n \mathbb{E}(x_i) \]"
    ),
    "a random weight in a sum": (
        r"We have \[ s = \sum_{i=1}^m w_i x_i \] Hence \[ \mathbb{E}(s) = \sum_{i=1}^m w_i \mathbb{E}(x_i) \]"
    ),
    "a number of terms that is drawn": (
        r"We have \[ s = \sum_{i=1}^N x_i \] where $N$ is a Poisson variable. Hence "
        r"\[ \mathbb{E}(s) = \sum_{i=1}^N \mathbb{E}(x_i) \]"
    ),
    "a random constant": r"The bias $b$ is a random constant. \[ y = x + b \] \[ \mathbb{E}(y) = \mathbb{E}(x) + b \]",
    "rows and columns": (
        r"We have $\mathbf m = \mathbb{E}[\mathbf x]$ and "
        r"\[ \mathbf P = \mathbb{E}[(\mathbf x - \mathbf m) (\mathbf x - \mathbf m)^T] \] Hence "
        r"\[ \mathbf P = \mathbb{E}[\mathbf x^T \mathbf x] - \mathbf m^T \mathbf m \]"
    ),
    "a function of a mean": r"We have \[ y = \sqrt{x} \] Hence \[ \mathbb{E}(y) = \sqrt{\mathbb{E}(x)} \]",
    "an operator of another distribution": (
        r"The mean is \[ z = \mathbb{E}_{x|y}[x] \] Hence \[ \mathbb{E}_{y}[z x] = z \mathbb{E}_{y}[x] \]"
    ),
    "a constant that changes": (
        r"The gain $a$ is constant within a trial, and changes with the trial. \[ y = a x \] "
        r"\[ \mathbb{E}(y) = a \mathbb{E}(x) \]"
    ),
}


@pytest.mark.parametrize("document", FOLLOWS.values(), ids=FOLLOWS)
def test_follows(document):
    reading = read_document(document_of(document))[-1]
    assert {link.verdict for link in reading.links} <= {"follows", "definition"}
    assert reading.links[-1].verdict == "follows"


@pytest.mark.parametrize("document", MISLEADING.values(), ids=MISLEADING)
def test_does_not_follow(document):
    assert read_document(document_of(document))[-1].links[-1].verdict not in ("follows", "contradicts")


def test_an_expected_value_in_square_brackets_has_no_index():
    latex = r"\[ m = \mathbb{E}[x] \] \[ y = K_k [a - b] \] \[ z = K_k (a - b) \]"
    assert read_document(document_of(latex))[-1].read == "z = K_k*(a - b)"

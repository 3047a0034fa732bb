"""Primes that transpose, and primes that do not."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

SQUARES = r"The least squares estimate is \[ b = (X'X)^{-1} X'y \] "
GAIN = (
    r"The covariance of the estimate is $P_{t|t-1}$. The gain is \[ K_t = P_{t|t-1} H_t' S_t^{-1} \] with "
    r"\[ S_t = H_t P_{t|t-1} H_t' + R_t \] and \[ P_{t|t} = P_{t|t-1} - K_t H_t P_{t|t-1} \] The Joseph form gives "
)
FOLLOWS = {
    "regression": SQUARES + r"With $y = X\beta + e$ we get \[ b = \beta + (X'X)^{-1} X'e \]",
    "the Joseph form": GAIN + r"\[ P_{t|t} = [I - K_t H_t] P_{t|t-1} [I - K_t H_t]' + K_t R_t K_t^{'} \]",
    "said in words": r"A prime denotes the transpose. \[ C = A B \] Hence \[ C' = B' A' \]",
    "a projection": SQUARES + r"With \[ M = X (X'X)^{-1} X' \] it follows that \[ M M = M \]",
}
MISLEADING = {
    "another order": SQUARES + r"Hence \[ b = y (X'X)^{-1} X' \]",
    "no inverse": SQUARES + r"Hence \[ b = X^{-1} y \]",
    "a projection that is none": SQUARES + r"With \[ M = X (X'X)^{-1} X' \] it follows that \[ M = X X' (X'X)^{-1} \]",
    "no transpose": GAIN + r"\[ P_{t|t} = [I - K_t H_t] P_{t|t-1} [I - K_t H_t] + K_t R_t K_t' \]",
    "a wrong sign": GAIN + r"\[ P_{t|t} = [I - K_t H_t] P_{t|t-1} [I - K_t H_t]' - K_t R_t K_t' \]",
    "the same order": r"A prime denotes the transpose. \[ C = A B \] Hence \[ C' = A' B' \]",
    "rotations": r"The estimate of the rotation is \[ T = R S R' \] where \[ R' = R_1 R_2 \] Hence \[ T = R S R^T \]",
    "without words": r"We have \[ T = A B C A' \] Hence \[ T' = A C' B' A' \]",
    "derivatives": (
        r"The prime is the derivative. The estimate is \[ b = (X'X)^{-1} X'y \] Hence \[ (X' y)' = y' X \]"
    ),
    "a function": (r"The estimate is \[ b = (X'X)^{-1} X' y \] with \[ f'(t) = X'(t) \] Hence \[ (A B)' = B' A' \]"),
}


@pytest.mark.parametrize("document", FOLLOWS.values(), ids=FOLLOWS)
def test_follows(document):
    assert read_document(document_of(document))[-1].verdict == "follows"


@pytest.mark.parametrize("document", MISLEADING.values(), ids=MISLEADING)
def test_does_not_follow(document):
    assert read_document(document_of(document))[-1].verdict not in ("follows", "contradicts")


_TURN = r"\[ \mathbf R(t) = \begin{bmatrix} \cos t & -\sin t \\ \sin t & \cos t \end{bmatrix} \] Hence "


def test_a_function_that_is_transposed_or_inverted_before_its_argument_has_this_argument():
    turned = _TURN + r"\[ \mathbf R^T(t) = \mathbf R(-t) \] \[ \mathbf R^{-1}(t) = \mathbf R(-t) \]"
    assert [each.verdict for each in read_document(document_of(turned))[1:]] == ["follows", "follows"]
    force = r"\[ t = J^T(q) f \] \[ v = J(q) w \] Hence \[ v^T f = w^T t \]"
    assert read_document(document_of(force))[-1].verdict == "follows"


def test_a_function_that_is_inverted_has_another_value_than_one_over_it():
    inverse = r"\[ F(x) = 2 x \] Hence \[ F^{-1}(y) = \frac{1}{2 y} \]"
    assert read_document(document_of(inverse))[-1].verdict not in ("follows", "contradicts")
    product = read_document(document_of(r"\[ y = R(q) x \] \[ R^T (a - b) = R^T a - R^T b \] \[ z = R^T(q, s) x \]"))
    assert [each.read for each in product[1:]] == ["R.T*(a - b) = R.T*a - R.T*b", "z = R(q, s).T*x"]
    turned = _TURN + r"\[ \mathbf R^T(t) = \mathbf R(t) \]"
    assert read_document(document_of(turned))[-1].verdict not in ("follows", "contradicts")

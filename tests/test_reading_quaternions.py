r"""Quaternions that are multiplied in a circle: what holds of their matrices holds of them."""

import pytest
from cases import for_each

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

_TURNS = (
    r"Quaternions turn vectors. \[ \mathbf s = \mathbf q \otimes \mathbf p \] "
    r"\[ \mathbf r = \mathbf s \otimes \mathbf t \] So "
)
_ERROR = r"The error is a quaternion: \[ q = d \otimes \hat q \] Hence "
_UNIT = (
    r"Let $\mathbf q$ be a unit quaternion and $\mathbf q^*$ its conjugate. "
    r"\[ \mathbf s = \mathbf q \otimes \mathbf p \] So "
)


def last(latex):
    return read_document(document_of(latex))[-1].verdict


@for_each(
    "latex",
    [
        _TURNS + r"\[ \mathbf r = \mathbf q \otimes \mathbf p \otimes \mathbf t \]",
        _TURNS + r"\[ \mathbf r = \mathbf q \otimes (\mathbf p \otimes \mathbf t) \]",
        _TURNS + r"\[ \mathbf q^{-1} \otimes \mathbf r = \mathbf p \otimes \mathbf t \]",
        _TURNS + r"\[ 2 \mathbf r = (\mathbf q + \mathbf q) \otimes \mathbf p \otimes \mathbf t \]",
        _ERROR + r"\[ d = q \otimes \hat q^{-1} \]",
        _ERROR
        + r"\[ \begin{bmatrix} 0 \\ a + b \end{bmatrix} \otimes q - \begin{bmatrix} 0 \\ a \end{bmatrix} \otimes q"
        r" = \begin{bmatrix} 0 \\ b \end{bmatrix} \otimes d \otimes \hat q \]",
        _UNIT + r"\[ \mathbf q^* \otimes \mathbf s = \mathbf p \]",
        _UNIT + r"\[ \mathbf s^* = \mathbf p^* \otimes \mathbf q^* \]",
    ],
)
def test_a_product_of_quaternions_is_associative_and_linear(latex):
    assert last(latex) == "follows"


@for_each(
    "latex",
    [
        _TURNS + r"\[ \mathbf r = \mathbf p \otimes \mathbf q \otimes \mathbf t \]",
        _TURNS + r"\[ \mathbf r \otimes \mathbf q^{-1} = \mathbf p \otimes \mathbf t \]",
        _TURNS + r"\[ \mathbf s + \mathbf r = \mathbf q \otimes \mathbf p \otimes \mathbf t \]",
        _TURNS + r"\[ \mathbf q^T \mathbf s = \mathbf q^T \mathbf p \otimes \mathbf q \]",
        _TURNS + r"\[ A \mathbf s = (A \mathbf q) \otimes \mathbf p \]",
        _TURNS + r"\[ \|\mathbf s\| = \mathbf q \otimes \mathbf p \]",
        _ERROR + r"\[ d = \hat q^{-1} \otimes q \]",
        _UNIT + r"\[ \mathbf s \otimes \mathbf q^* = \mathbf p \]",
        _UNIT + r"\[ \mathbf s^* = \mathbf q^* \otimes \mathbf p^* \]",
        _UNIT.replace("a unit quaternion", "a quaternion") + r"\[ \mathbf q^* \otimes \mathbf s = \mathbf p \]",
        _UNIT.replace("its conjugate", "the optimal one") + r"\[ \mathbf s^* = \mathbf p^* \otimes \mathbf q^* \]",
        r"No quaternion is Kronecker's product. \[ A = B \otimes C \] So \[ A^{-1} C = B^{-1} \otimes C \]",
        r"The tensor product is \[ a = b \otimes c \] \[ d = a \otimes f \] So \[ d = c \otimes b \otimes f \]",
    ],
)
def test_it_is_not_commutative_and_nothing_else_is_taken_for_one(latex):
    assert last(latex) not in ("follows", "contradicts")


def test_the_reading_says_that_matrices_stand_for_quaternions():
    reading = read_document(document_of(_ERROR + r"\[ d = q \otimes \hat q^{-1} \]"))[-1]
    assert reading.links[0].reason.endswith(
        "with a matrix for each quaternion: Q_circ1 for d, Q_circ2 for q, Q_circ3 for q_hat"
    )
    assert reading.links[0].hypotheses[0] == "det(Q_circ3)"

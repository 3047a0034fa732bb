"""Equations that say of what space a letter is."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def verdicts(latex: str) -> list[str]:
    return [each.verdict for each in read_document(document_of(latex))]


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ \mathbf{x} = \begin{bmatrix} a \\ b \end{bmatrix} \in \mathbb{R}^2 \]",
        r"\[ \mathbf{x} = \begin{bmatrix} \mathbf{p} \\ \mathbf{v} \end{bmatrix} \in \mathbb{R}^{6} \]",
        r"\[ \mathbf{u} = \begin{bmatrix} a & b & c \end{bmatrix}^T \in {\rm I\! R}^3. \]",
        r"\[ J = B^T A B \in \mathbb{R}^{n\times n} \]",
        r"The step needs the Jacobian $J(x_k)$. It is "
        r"\[ J = \begin{bmatrix} a & b \end{bmatrix} \in \mathbb{R}^{1\times 2} \]",
    ],
)
def test_an_equation_with_the_space_of_its_letter_gives_the_letter(latex):
    assert verdicts(latex) == ["definition"]


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\[ J = B^T A B \in \mathbb{R}^{n\times n} \] \[ B^T A^T B = J \]", "independent"),
        (r"\[ J = B^T A B \in \mathbb{R}^{n\times n} \] \[ B^T A B = J \]", "follows"),
        (r"\[ A B = C \in \mathbb{R}^{2\times 2} \] \[ B A = C \]", "independent"),
        (r"Let $x, y \in \mathbb{R}^n$. \[ z = A x + A y \] \[ z = x A + A y \]", "not decided"),
        (r"Let $x, y \in \mathbb{R}^n$. \[ z = A x + A y \] \[ z = A (x + y) \]", "follows"),
        (r"\[ x = y z \in \mathbb{R}^{2\times 2} \] \[ x = z y \]", "not decided"),
        (r"\[ x = y z \in \mathbb{R}^{2\times 2} \] \[ 2 x = 2 y z \]", "follows"),
        (r"\[ a^T b > 0 \] \[ A = a b^T \] \[ A = b^T a \]", "independent"),
        (
            r"Let $x \in \mathbb{R}^n$ and $A \in \mathbb{R}^{n\times n}$. \[ s = x^T A x \] \[ s = x^T A^T x \]",
            "follows",
        ),
        (r"The vectors $x$ and $y$ are given. \[ s = x^T A y \] \[ s = y^T A^T x \]", "follows"),
        (r"Let $x_k \in \mathbb{R}^d$. \[ x_{k+1} = x_k - g \] \[ x_{k+1}^T g = g^T x_k - g^T g \]", "follows"),
        (r"The row vectors $x$ and $y$ are given. \[ s = x^T y \] \[ s = y^T x \]", "independent"),
        (r"The vectors $x$ and $y$ are rows. \[ s = x^T y \] \[ s = y^T x \]", "independent"),
        (r"$A$ is a matrix whose vectors are known. \[ S = A^T B \] \[ S = B^T A \]", "independent"),
        (r"Let $X, Y \in \mathbb{R}^{n \times m}$. \[ S = X^T Y \] \[ S = Y^T X \]", "independent"),
        (
            r"\[ u = \begin{pmatrix} a & b \end{pmatrix} \] \[ u^T = \begin{pmatrix} a & b \end{pmatrix} \]",
            "not decided",
        ),
        (r"\[ u = \begin{pmatrix} a & b \end{pmatrix} \] \[ u^T = \begin{pmatrix} a \\ b \end{pmatrix} \]", "follows"),
        (r"\[ a^T (b - c a) = 0 \] Hence \[ b = c a \]", "independent"),
        (r"\[ \mathbf e^\top \mathbf J = \mathbf J^\top \mathbf e \]", "not decided"),
        (r"\[ \mathbf e^\top \mathbf x = \mathbf x^\top \mathbf e \]", "follows"),
    ],
)
def test_what_is_of_a_space_is_no_number(latex, verdict):
    assert verdicts(latex)[-1] == verdict

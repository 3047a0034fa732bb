r"""How textbooks on estimation, cameras and motion print things."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def last(latex):
    return read_document(document_of(latex), seconds=5)[-1]


@pytest.mark.parametrize(
    "latex",
    [
        r"With depths $p$ and $q$, and vectors $x$ and $y$, \[ p y = q R x + t. \] Hence "
        r"\[ p [t]_\times y = q [t]_\times R x. \]",
        r"The matrix is \[ F = K_2^{-\top} E K_1^{-1}. \] Hence \[ K_2^\top F K_1 = E. \]",
        r"The filter has the vectors \begin{align} y_k &= z_k - H x_k^-, \\ s_k &= c y_k. \end{align} Hence "
        r"\[ s_k = c z_k - c H x_k^-. \]",
        r"We minimize \[ J(x) = \|A x - b\|^2. \] The gradient is \[ \nabla J(x) = 2 A^T (A x - b), \] the Hessian is "
        r"\[ \nabla^2 J(x) = 2 A^T A. \] Setting the gradient to zero gives \[ A^T A \hat x = A^T b. \]",
    ],
)
def test_what_textbooks_print_is_read(latex):
    assert last(latex).verdict == "follows"

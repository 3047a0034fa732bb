r"""Derivatives by a vector whose components are printed, as of a camera or of the state of a filter."""

import pytest
from cases import for_each

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

_POINT = r"\[ \mathbf p = \begin{bmatrix} X \\ Y \\ Z \end{bmatrix} \] "
_PIXEL = r"\[ \mathbf u = \begin{bmatrix} f X/Z + c \\ f Y/Z + d \end{bmatrix} \] Hence "
_POWER = _POINT + r"\[ s = X^2 Y \] So "
_STATE = r"\[ \mathbf x = (p, y, \theta)^T \] "
_MOVED = r"\begin{bmatrix} p + h \cos\theta \\ y + h \sin\theta \\ \theta + w \end{bmatrix} \] So "
_STEP = r"\[ \mathbf f(\mathbf x, \mathbf u) = " + _MOVED
_TURNED = r"= \begin{bmatrix} 1 & 0 & -h \sin\theta \\ 0 & 1 & h \cos\theta \\ 0 & 0 & 1 \end{bmatrix} \]"
_SEEN = r"= \begin{bmatrix} f/Z & 0 & -f X/Z^2 \\ 0 & f/Z & -f Y/Z^2 \end{bmatrix} \]"


def links(latex):
    return [link.verdict for each in read_document(document_of(latex)) for link in each.links]


@for_each(
    "latex",
    [
        _POINT + _PIXEL + r"\[ \frac{\partial\mathbf u}{\partial\mathbf p} " + _SEEN,
        _POINT + _PIXEL + r"\[ J = \frac{\partial\mathbf u}{\partial\mathbf p} " + _SEEN,
        _STATE + _STEP + r"\[ F = \frac{\partial\mathbf f(\mathbf x, \mathbf u)}{\partial\mathbf x} " + _TURNED,
        _STATE + _STEP + r"\[ F = \frac{\partial\mathbf f}{\partial\mathbf x} " + _TURNED,
        r"\[ u = f X/Z + c \] \[ v = f Y/Z + d \] So \[ \frac{\partial(u, v)}{\partial(X, Y, Z)} " + _SEEN,
        _POWER + r"\[ \frac{\partial s}{\partial\mathbf p} = (2 X Y, X^2, 0) \]",
        _POWER + r"\[ \frac{\partial s}{\partial\mathbf p} = \begin{pmatrix} 2 X Y \\ X^2 \\ 0 \end{pmatrix} \]",
    ],
)
def test_a_derivative_by_a_printed_vector_has_a_column_for_each_component(latex):
    assert links(latex)[-1] == "follows"


@for_each(
    "latex",
    [
        _POINT + _PIXEL + r"\[ \frac{\partial\mathbf u}{\partial\mathbf p} " + _SEEN.replace("-f Y", "f Y"),
        _POINT + _PIXEL + r"\[ \frac{\partial\mathbf u}{\partial\mathbf p} " + _SEEN.replace("-f X", "-f Y"),
        _STATE + _STEP + r"\[ F = \frac{\partial\mathbf f}{\partial\mathbf x} " + _TURNED.replace("-h", "h"),
        r"\[ u = f X/Z + c \] \[ v = f Y/Z + d \] So \[ \frac{\partial(v, u)}{\partial(X, Y, Z)} " + _SEEN,
        _POINT + r"\[ X^2 + Y^2 = 1 \] \[ s = X Y \] So \[ \frac{\partial s}{\partial\mathbf p} = (Y, X, 0) \]",
        _POINT + r"\[ X = c - Y \] \[ s = X Y \] So \[ \frac{\partial s}{\partial\mathbf p} = (Y, X, 0) \]",
        _POINT + r"\[ a = 2 X \] \[ s = X a \] So \[ \frac{\partial s}{\partial\mathbf p} = (4 X, 0, 0) \]",
        _POINT
        + r"\[ c = X + b \] \[ b = c - 2 Y \] \[ s = c \] So \[ \frac{\partial s}{\partial\mathbf p} = (1, 0, 0) \]",
    ],
)
def test_another_matrix_does_not_follow_nor_does_one_of_letters_that_depend_on_each_other(latex):
    assert links(latex)[-1] not in ("follows", "contradicts")


def test_it_rests_on_what_gives_the_function_and_on_what_gives_the_vector():
    latex = _POINT + "\n\n" + _PIXEL + r"\[ \frac{\partial\mathbf u}{\partial\mathbf p} " + _SEEN
    (link,) = read_document(document_of(latex))[-1].links
    assert link.rests_on == ("the derivative of line 3 and line 1",)


_THIN = r"\[ r = p - q + s v \] Hence "


def test_letters_are_vectors_if_a_derivative_is_a_multiple_of_an_identity_with_a_size():
    assert links(_THIN + r"\[ \frac{\partial r}{\partial v} = s I_{3 \times 3} \]")[-1] == "follows"
    both = r"\[ \frac{\partial r}{\partial q} = -I_3 \] \[ \frac{\partial r}{\partial p} = I_3 \]"
    assert links(_THIN + both)[-2:] == ["follows", "follows"]
    for wrong in (r"\frac{\partial r}{\partial q} = I_{3 \times 3}", r"\frac{\partial r}{\partial v} = I_{3 \times 3}"):
        assert links(_THIN + rf"\[ {wrong} \]")[-1] not in ("follows", "contradicts")

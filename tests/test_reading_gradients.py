"""Derivatives by a vector: gradients and Jacobians."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

_FORM = r"\[ f = \mathbf{x}^T \mathbf{A} \mathbf{x} + \mathbf{b}^T \mathbf{x} + c \] "
_LOSS = r"\[ L(\mathbf{w}) = (\mathbf{y} - \mathbf{X} \mathbf{w})^T (\mathbf{y} - \mathbf{X} \mathbf{w}) \] "
_BEHIND = r"\[ \mathbf{r} = \mathbf{y} - \mathbf{X} \mathbf{w} \] \[ L = \mathbf{r}^T \mathbf{r} \] "
_STEP = r"\[ \mathbf{x}_{k+1} = \mathbf{x}_k + h (\mathbf{A} \mathbf{x}_k + \mathbf{B} \mathbf{u}) \] "
_LENGTH = r"\[ c = \sqrt{\mathbf{r}^T \mathbf{r} + d^2} \] "
_UNIT = r"\[ \mathbf{n} = \frac{\mathbf{x}}{\|\mathbf{x}\|} \] \[ \frac{\partial\mathbf{n}}{\partial\mathbf{x}} = "
_VIEW = (
    r"\[ u = f \frac{X}{Z} \] \[ v = f \frac{Y}{Z} \] \[ \begin{bmatrix} \frac{\partial u}{\partial X} & "
    r"\frac{\partial u}{\partial Z} \\ \frac{\partial v}{\partial X} & \frac{\partial v}{\partial Z} \end{bmatrix} = "
)
_VIEWED = r"\begin{bmatrix} \frac{f}{Z} & -\frac{f X}{Z^2} \\ 0 & -\frac{f Y}{Z^2} \end{bmatrix} \]"


def last(latex: str):
    return read_document(document_of(latex))[-1]


@pytest.mark.parametrize(
    "latex",
    [
        _FORM + r"\[ \frac{\partial f}{\partial \mathbf{x}} = (\mathbf{A} + \mathbf{A}^T) \mathbf{x} + \mathbf{b} \]",
        _FORM + r"\[ \frac{d f}{d \mathbf{x}} = \mathbf{x}^T (\mathbf{A} + \mathbf{A}^T) + \mathbf{b}^T \]",
        _FORM + r"\[ \frac{\partial f}{\partial \mathbf{b}} = \mathbf{x} \]",
        _FORM + r"\[ 3 \nabla_{\mathbf{x}} f - \mathbf{b} = 3 (\mathbf{A} + \mathbf{A}^T) \mathbf{x} + 2 \mathbf{b} \]",
        _LOSS + r"\[ \nabla L(\mathbf{w}) = -2 \mathbf{X}^T (\mathbf{y} - \mathbf{X} \mathbf{w}) \]",
        _BEHIND + r"\[ \frac{\partial L}{\partial \mathbf{w}} = -2 \mathbf{X}^T \mathbf{r} \]",
        r"\[ f = ||\mathbf{x} - \mathbf{c}||^2 \] \[ \nabla_{\mathbf{x}} f = 2 (\mathbf{x} - \mathbf{c}) \]",
        r"\[ \frac{\partial}{\partial \mathbf{w}} (\mathbf{w}^T \mathbf{y}) = \mathbf{y} \]",
        _STEP + r"\[ \frac{\partial \mathbf{x}_{k+1}}{\partial \mathbf{u}} = h \mathbf{B} \]",
        _STEP + r"\[ \frac{\partial \mathbf{x}_{k+1}}{\partial \mathbf{x}_k} = \mathbf{I} + h \mathbf{A} \]",
        _LENGTH + r"\[ \frac{\partial c}{\partial \mathbf{r}} = \frac{\mathbf{r}}{c} \]",
        r"\[ n(\mathbf{x}) = \sqrt{\mathbf{x}^T \mathbf{x}} \] "
        r"\[ \frac{\partial n}{\partial \mathbf{x}} = \frac{\mathbf{x}^T}{n} \]",
        _UNIT + r"\frac{1}{\|\mathbf{x}\|} (\mathbf{I} - \mathbf{n} \mathbf{n}^T) \]",
        r"\[ f = \|\mathbf{A} \mathbf{x}\| \] "
        r"\[ \nabla_{\mathbf x} f = \frac{\mathbf{A}^T \mathbf{A} \mathbf{x}}{f} \]",
        r"\[ p = e^{\mathbf{x}^T \mathbf{b}} \] \[ \nabla_{\mathbf x} p = p \mathbf{b} \]",
        r"\[ f = \ln(\mathbf{x}^T \mathbf{x} + k) \] "
        r"\[ \nabla_{\mathbf x} f = \frac{2 \mathbf{x}}{\mathbf{x}^T \mathbf{x} + k} \]",
        r"\[ s = \mathbf{w}^T \mathbf{x} \] \[ y = \frac{1}{1 + e^{-s}} \] "
        r"\[ \frac{\partial y}{\partial \mathbf{w}} = y (1 - y) \mathbf{x} \]",
        _VIEW + _VIEWED,
    ],
)
def test_a_derivative_by_a_vector_is_one_along_every_direction(latex):
    assert last(latex).verdict == "follows"


def test_it_rests_on_what_gives_the_function():
    assert last(_FORM + r"\[ \nabla_{\mathbf{b}} f = \mathbf{x} \]").links[-1].rests_on == ("line 1",)


@pytest.mark.parametrize(
    "latex",
    [
        _LENGTH + r"\[ \frac{\partial c}{\partial \mathbf{r}} = \frac{2 \mathbf{r}}{c} \]",
        _UNIT + r"\frac{1}{\|\mathbf{x}\|} (\mathbf{I} + \mathbf{n} \mathbf{n}^T) \]",
        r"\[ q = 2 e \] \[ p = e^{\mathbf{x}^T \mathbf{b}} \] \[ \nabla_{\mathbf x} p = p \mathbf{b} \]",
        r"\[ p = k^{\mathbf{x}^T \mathbf{b}} \] \[ \nabla_{\mathbf x} p = p \mathbf{b} \]",
        r"The focal length $f$ is a function of $X$. " + _VIEW + _VIEWED,
        r"\[ Y = 2 X \] " + _VIEW + _VIEWED,
        r"\[ X^2 + Y^2 = 1 \] " + _VIEW + _VIEWED,
        _VIEW.replace(r"\partial", "d") + _VIEWED,
        r"\[ p = a T \] \[ s = p v + V \] \[ \frac{\partial p}{\partial V} = 0 \]",
        _FORM + r"\[ \frac{\partial f}{\partial \mathbf{x}} = 2 \mathbf{A} \mathbf{x} + \mathbf{b} \]",
        _FORM + r"\[ \frac{\partial f}{\partial \mathbf{x}} = (\mathbf{A} + \mathbf{A}^T) \mathbf{x} \]",
        _FORM + r"\[ \frac{\partial f}{\partial \mathbf{b}} = 2 \mathbf{x} \]",
        _FORM + r"\[ \frac{\partial f}{\partial \mathbf{y}} = \mathbf{0} \]",
        _FORM + r"\[ \nabla^2 f = \mathbf{A} + \mathbf{A}^T \]",
        _FORM + r"\[ \nabla \cdot \mathbf{x} = \mathbf{b} \]",
        _FORM + r"\[ \mathbf{b} = \mathbf{B} \mathbf{x} \] "
        r"\[ \frac{d f}{d \mathbf{x}} = (\mathbf{A} + \mathbf{A}^T) \mathbf{x} + \mathbf{b} \]",
        r"\[ f = \mathbf{b}^T \mathbf{p}(\mathbf{x}) + \mathbf{b}^T \mathbf{x} \] "
        r"\[ \frac{\partial f}{\partial \mathbf{x}} = \mathbf{b} \]",
        r"\[ f = \sin(\mathbf{b}^T \mathbf{x}) + \mathbf{b}^T \mathbf{x} \] "
        r"\[ \frac{\partial f}{\partial \mathbf{x}} = \mathbf{b} \]",
        r"\[ f = e^{\mathbf{b}^T \mathbf{x}} \] \[ \nabla_{\mathbf{x}} f = 0 \]",
        r"\[ f = (\mathbf{b}^T \mathbf{x})^n \] \[ \nabla_{\mathbf{x}} f = 0 \]",
        r"\[ \mathbf{y} = \mathbf{A} \dot{\mathbf{x}} + \mathbf{B} \mathbf{x} \] "
        r"\[ \frac{d \mathbf{y}}{d \mathbf{x}} = \mathbf{B} \]",
        r"\[ f = \sqrt{\mathbf{x}^T \mathbf{x}} + \mathbf{b}^T \mathbf{x} \] \[ \nabla_{\mathbf{x}} f = \mathbf{b} \]",
        r"\[ f = ||\mathbf{x}|| + \mathbf{b}^T \mathbf{x} \] \[ \nabla_{\mathbf{x}} f = \mathbf{b} \]",
        r"\[ f = ||\mathbf{x}||^3 + \mathbf{b}^T \mathbf{x} \] \[ \nabla_{\mathbf{x}} f = \mathbf{b} \]",
        r"\[ f = \sum_i \mathbf{x}^T \mathbf{a}_i + \mathbf{b}^T \mathbf{x} \] "
        r"\[ \nabla_{\mathbf{x}} f = \mathbf{b} \]",
        r"\[ \mathbf{r} = \mathbf{y} - \mathbf{w} \] \[ L = \mathbf{r}^T \mathbf{w} \] "
        r"\[ \frac{\partial L}{\partial \mathbf{w}} = \mathbf{y} - 2 \mathbf{w} \]",
        _LOSS + r"\[ \nabla L(\mathbf{w}) = 2 \mathbf{X}^T (\mathbf{y} - \mathbf{X} \mathbf{w}) \]",
        _LOSS + r"\[ \nabla L(\mathbf{v}) = -2 \mathbf{X}^T (\mathbf{y} - \mathbf{X} \mathbf{w}) \]",
        _BEHIND + r"\[ \nabla_{\mathbf{y}} L = -2 \mathbf{X}^T \mathbf{r} \]",
        _BEHIND + r"\[ \frac{\partial L}{\partial \mathbf{w}} = 2 \mathbf{X}^T \mathbf{r} \]",
        _STEP + r"\[ \frac{\partial \mathbf{x}_{k+1}}{\partial \mathbf{u}} = h \mathbf{B}^T \]",
        _STEP + r"\[ \frac{\partial \mathbf{x}_{k+1}}{\partial \mathbf{x}_k} = h \mathbf{A} \]",
        r"\[ \mathbf{z} = \mathbf{A} \mathbf{x} \] \[ \frac{\partial \mathbf{z}}{\partial \mathbf{x}} = \mathbf{x} \]",
    ],
)
def test_what_is_no_gradient_does_not_follow(latex):
    assert last(latex).verdict not in ("follows", "contradicts")


def test_an_empty_entry_is_no_derivative():
    given = r"\[ \mathbf{A} = \begin{bmatrix} 1 & \\ & 2 \end{bmatrix} \] "
    latex = given + r"\[ \frac{\partial f}{\partial\mathbf{x}} = \begin{bmatrix} & 1 \end{bmatrix} \mathbf{x} \]"
    assert read_document(document_of(latex))[-1].verdict == "not decided"
    function = r"\[ f = \mathbf{x}^T \begin{bmatrix} & 1 \end{bmatrix} \mathbf{x} \] "
    function += r"\[ \nabla_{\mathbf{x}} f = \mathbf{x} \]"
    assert read_document(document_of(function))[-1].verdict == "not decided"


def test_powers_of_powers_end_within_bounds():
    form = "(" * 18 + r"\mathbf{x}^T \mathbf{x}" + " + 1)^2" * 18
    assert last(rf"\[ f = {form} \] \[ \nabla_{{\mathbf{{x}}}} f = \mathbf{{b}} \]").verdict == "not decided"


def test_powers_of_letters_that_are_powers_end_within_bounds():
    first = r"\[ a_0 = \mathbf{x}^T \mathbf{x} \]"
    rest = "".join(rf"\[ a_{{{n}}} = a_{{{n - 1}}}^2 + 1 \]" for n in range(1, 22))
    assert last(rf"{first} {rest} \[ \nabla_{{\mathbf{{x}}}} a_{{21}} = \mathbf{{b}} \]").verdict == "not decided"
